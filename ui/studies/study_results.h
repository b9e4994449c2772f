// SPDX-License-Identifier: GPL-3.0-or-later
//
// Results of a study: its charts, and below them its findings and its tables. Before the first study a short
// introduction.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QTabBar>
#include <QTextBrowser>
#include <QToolButton>
#include <QWidget>

#include "core/studies/study/study.h"

namespace touchdown {

class StudyChartView;
class ResultPages;
class ResultTable;

class StudyResults : public QWidget {
    Q_OBJECT

public:
    explicit StudyResults(QWidget* parent = nullptr);

    /// A report, complete or of a study in progress.
    void setReport(const StudyReport& report, bool underWay);
    /// Shows the introduction, or that the study is in progress.
    void clear(bool underWay);
    /// The case or the text of the study has changed since.
    void setStale(bool stale);
    const std::optional<StudyReport>& report() const { return report_; }

    /// What a row of the first table opens, as the name of a command; "": nothing.
    void setOpening(std::function<QString(int row)> opening) { opening_ = std::move(opening); }

    bool isEmpty() const;

signals:
    /// The user wants to edit the case that the study found.
    void applyRequested();
    /// The user wants what a row of the first table opens.
    void openRequested(int row);
    /// The user wants to save the whole report.
    void saveRequested();
    void succeeded(const QString& message);

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    void showCharts();
    void showTables();
    void writeFindings();
    void fillSaveMenu();
    void chooseSaveTable();
    ResultTable* shownTable() const;
    void updateTools();

    std::optional<StudyReport> report_;
    bool underWay_ = false;
    std::vector<StudyChartView*> charts_;
    std::vector<ResultTable*> tables_;
    ResultPages* pages_;
    QTabBar *chartTabs_, *factTabs_;
    QStackedWidget *chartPages_, *factPages_;
    QTextBrowser* findings_;
    QLabel* staleMark_;
    QPushButton* apply_;
    QToolButton *open_, *copy_, *save_;
    std::function<QString(int row)> opening_{};
    int row_ = -1; // the chosen one of the first table; -1: none
};

} // namespace touchdown

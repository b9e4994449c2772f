// SPDX-License-Identifier: GPL-3.0-or-later
//
// Results of a study: its charts, and below them its findings and its tables. Before the first study a short
// introduction.
#pragma once

#include <optional>
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

    /// Whether each row of the first table, of which there are so many, is a case; zero: they are none.
    void setCases(std::size_t rows);

    bool isEmpty() const;

signals:
    /// The user wants to edit the case that the study found.
    void applyRequested();
    /// The user wants the case of a row of the first table.
    void caseRequested(int row);
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
    QToolButton *case_, *copy_, *save_;
    std::size_t cases_ = 0; // rows of the first table that are cases
    int row_ = -1;          // the chosen one of it; -1: none
};

} // namespace touchdown

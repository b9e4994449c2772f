// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parameters of the case, generated from the one description of the fields: groups, search, the
// sample case they started from, reset. Fields that the chosen model does not use are not shown.
#pragma once

#include "ui/case/case_edits.h"
#include "ui/case/field_editor.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QWidget>

#include <string>
#include <vector>

namespace touchdown {

class CasePanel : public QWidget {
    Q_OBJECT

public:
    /// `edits` must outlive the panel.
    explicit CasePanel(CaseEdits& edits, QWidget* parent = nullptr);
    ~CasePanel() override;

    /// The sample case that was opened, or an empty name for another one; edits turn it to "Custom".
    void setPreset(const QString& sampleName);

    /// nullptr for an unknown key.
    FieldEditor* editor(std::string_view key) const;
    QComboBox* preset() const { return preset_; }
    QLineEdit* search() const { return search_; }
    /// Brings the first field that keeps the case from running into view.
    void showFirstProblem();

signals:
    void presetChosen(const QString& sampleName);

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Group {
        std::string name;
        QToolButton* header = nullptr;
        QWidget* body = nullptr;
        bool open = true;
        std::vector<FieldEditor*> editors;
    };

    void buildPresets();
    void buildGroups(QWidget* page);
    void addGroup(const std::string& name, QWidget* page);
    void refresh();
    void refreshVisibility();
    void alignUnits();
    void colour();

    CaseEdits& edits_;
    QString presetName_;
    QComboBox* preset_;
    QLineEdit* search_;
    QToolButton* resetAll_;
    QScrollArea* scroll_;
    QLabel* legend_;
    std::vector<Group> groups_;
};

} // namespace touchdown

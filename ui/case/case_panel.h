// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parameters of the case, generated from their description in core/case/parameters.h: groups, search, the sample
// case that they started from, reset. Parameters that the chosen model does not use are not shown.
#pragma once

#include <set>
#include <string>
#include <vector>

#include <QScrollArea>

#include "ui/case/parameter_editor.h"

namespace touchdown {

class CasePanel : public QWidget {
    Q_OBJECT

public:
    /// `edits` must outlive the panel.
    explicit CasePanel(CaseEdits& edits, QWidget* parent = nullptr);
    ~CasePanel() override;

    /// The sample case that was opened, or an empty name for another one; edits turn it to "Custom". All of
    /// its parameters are shown: a search ends.
    void setPreset(const QString& sampleName);

    /// nullptr for an unknown key.
    ParameterEditor* editor(std::string_view key) const;
    QLineEdit* search() const { return search_; }
    /// What it says of a search, as rich text: that nothing matches, or how many more there are; else "".
    QString searchRemark() const { return found_->isHidden() ? QString() : found_->text(); }
    /// Shows the matches of a lower rank as well.
    void showEveryMatch();
    /// Brings the first parameter that prevents a run into view; false: none has a field here.
    bool showFirstProblem();
    /// Brings the field of a parameter into view, with the keyboard in it, and lets it flash; false: it has none here.
    bool showParameter(std::string_view key);

signals:
    void presetChosen(const QString& sampleName);
    /// All samples with their pictures, to choose from.
    void galleryWanted();
    /// A study that varies a number or a choice.
    void varyWanted(const QString& key);

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    struct Group {
        std::string name;
        QToolButton* header = nullptr;
        QWidget* body = nullptr;
        bool open = true;
    };

    void bringIntoView(ParameterEditor& editor);
    void buildPresets();
    void buildGroups(QWidget* page);
    std::vector<Group>::iterator addGroup(const std::string& name, QWidget* page);
    void refresh();
    void refreshVisibility();
    void alignUnits();
    void stackRows();

    CaseEdits& edits_;
    QString presetName_;
    QComboBox* preset_;
    QLineEdit* search_;
    QLabel* found_;                           // what a search does not show
    bool everyMatch_ = false;                 // of the search, in whatever place
    std::set<const ParameterEditor*> needed_; // by a choice that was made since the search began
    QToolButton* resetAll_;
    QScrollArea* scroll_;
    QLabel* legend_;
    std::vector<Group> groups_;
    std::vector<int> besideWidths_;         // of the rows with labels beside their values [px]
    std::vector<ParameterEditor*> editors_; // children of the bodies of the groups
};

} // namespace touchdown

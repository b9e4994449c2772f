// SPDX-License-Identifier: GPL-3.0-or-later
//
// One parameter as a row: label and symbol, editor, unit, marks for "assumed" and "changed", and the reason below when
// an entry cannot be taken, or a warning. Built from the description of the parameter alone.
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <QVariantAnimation>

namespace touchdown {

class CaseEdits;
struct Parameter;

/// Label includes the symbol; Help includes the names of choices. From the best match on.
enum class SearchMatch : std::uint8_t { Label, Key, Help, None };

class ParameterEditor : public QWidget {
    Q_OBJECT

public:
    /// `parameter` must outlive the editor, as those of `parameters()` do.
    explicit ParameterEditor(const Parameter& parameter, QWidget* parent = nullptr);
    /// Blocks the signals: an input loses its focus while it is destroyed.
    ~ParameterEditor() override { input()->disconnect(this); }

    const Parameter& parameter() const { return parameter_; }
    /// Shows the value of the case.
    void show(const CaseEdits& edits);
    /// Where all words of `search` are found, each at the start of a word. `heading`, of its group, counts as its
    /// label.
    SearchMatch match(const QString& search, const QString& heading) const;

    /// The widget that takes the entry.
    QWidget* input() const;
    QString reason() const { return reason_->isHidden() ? QString() : reason_->text(); }
    bool wrong() const { return wrong_; }
    int unitWidth() const;
    /// Its background has the colour of a selection for a moment.
    void flash();
    /// The label stands above the value: in a place that is too narrow for both beside each other.
    void setStacked(bool stacked);
    /// Lines up the columns of all rows.
    void setUnitWidth(int width);

signals:
    void entered(const QString& text);
    /// The entry that the case could not take is to be forgotten.
    void givenUp();
    /// Stands in its line and is not entered yet.
    void typed(const QString& text);
    void resetRequested();
    /// From the menu of a number or a choice.
    void varyRequested();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void buildInput();
    void buildMenu();
    void arrange(bool stacked);
    void fitChoice();
    void describe();
    void colour();
    QString meaning(int choice) const;
    int inputWidth() const;
    void commitLine();

    const Parameter& parameter_;
    QGridLayout* grid_;
    QLabel* label_;
    QLineEdit* line_ = nullptr;   // Number, Integer, List, Text
    QComboBox* choice_ = nullptr; // Choice
    QCheckBox* check_ = nullptr;  // Boolean
    QLabel* unit_;
    QLabel* assumed_;
    QToolButton* reset_;
    QLabel* reason_;
    QString shown_; // text last put into line_
    bool changed_ = false;
    bool refused_ = false; // what stands in line_ is no value of the case
    bool stacked_ = false;
    QVariantAnimation flash_; // from 1 to 0
    bool wrong_ = false;      // the entry cannot be taken; else `reason_` warns
};

} // namespace touchdown

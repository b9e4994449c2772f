// SPDX-License-Identifier: GPL-3.0-or-later
//
// One parameter as a row: label and symbol, editor, unit, marks for "assumed" and "changed", and the
// reason under it when an entry cannot be taken. Built from its description alone.
#pragma once

#include "core/case/fields.h"
#include "ui/case/case_edits.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <QWidget>

namespace touchdown {

class FieldEditor : public QWidget {
    Q_OBJECT

public:
    /// `field` must outlive the editor, as those of `fields()` do.
    explicit FieldEditor(const Field& field, QWidget* parent = nullptr);
    /// Blocks the signals: an input loses its focus while it is destroyed.
    ~FieldEditor() override { input()->disconnect(this); }

    const Field& field() const { return field_; }
    /// Shows what the case holds for this field.
    void show(const CaseEdits& edits);
    /// Whether all words of `search` occur in what the row says about its field.
    bool matches(const QString& search) const;

    /// The widget that takes the entry, for focus and tests.
    QWidget* input() const;
    QString reason() const { return reason_->isHidden() ? QString() : reason_->text(); }
    int unitWidth() const { return unit_->sizeHint().width(); }
    /// Lines up the columns of all rows.
    void setUnitWidth(int width);

signals:
    void entered(const QString& text);
    void resetRequested();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void buildInput();
    void describe();
    void colour();
    int inputWidth() const;
    void commitLine();

    const Field& field_;
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
};

} // namespace touchdown

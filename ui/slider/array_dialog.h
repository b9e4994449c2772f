// SPDX-License-Identifier: GPL-3.0-or-later
//
// Asks for the number of copies in a row and the step from one to the next, in µm or with a unit of one's own.
#pragma once

#include <QDialog>
#include <QLineEdit>
#include <QSpinBox>

#include "core/physics/slider/surface_edit.h"

namespace touchdown {

class ArrayDialog : public QDialog {
    Q_OBJECT

public:
    explicit ArrayDialog(QWidget* parent);

signals:
    void taken(int count, touchdown::SurfaceShift step);

private:
    /// Nothing where a text is no length, or the copies would lie on the rails.
    std::optional<SurfaceShift> step() const;

    QSpinBox* count_;
    QLineEdit *x_, *y_;
};

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The form of the drawing under the plan: its file, its place, how strongly it is shown. Each entry acts at once.
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>

#include "ui/slider/underlay.h"

namespace touchdown {

class UnderlayDialog : public QDialog {
    Q_OBJECT

public:
    /// The underlay must outlive this.
    UnderlayDialog(Underlay& underlay, QWidget* parent);

signals:
    void fileWanted();
    /// The closed outlines of the drawing are to become rails.
    void railsWanted();

private:
    void showPlace();
    void take();

    Underlay& underlay_;
    QLabel *file_, *remark_;
    QComboBox* unit_;
    QLineEdit *width_, *x_, *y_;
    QCheckBox* mirrored_;
    QSlider* opacity_;
    QPushButton *rails_, *remove_;
};

/// Asks for a picture or a drawing.
void askForUnderlay(QWidget* parent, const std::function<void(const QString& file)>& take);

} // namespace touchdown

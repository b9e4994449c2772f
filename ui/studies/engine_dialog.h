// SPDX-License-Identifier: GPL-3.0-or-later
//
// Asks how a study that is a list is given to a cluster: in which folder all stands, in how many parts.
#pragma once

#include <QDialog>
#include <QLineEdit>
#include <QSpinBox>

#include "core/studies/engine/engine.h"

namespace touchdown {

class EngineDialog : public QDialog {
    Q_OBJECT

public:
    /// `folder`: what is suggested; empty: one in the user's documents.
    EngineDialog(const QString& folder, QWidget* parent);

signals:
    void taken(const touchdown::EngineTask& task);

private:
    void chooseFolder();

    QLineEdit *folder_, *options_;
    QSpinBox *parts_, *threads_;
};

} // namespace touchdown

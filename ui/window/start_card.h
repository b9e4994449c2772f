// SPDX-License-Identifier: GPL-3.0-or-later
//
// The first minute: what moves on the screen, what to watch and what to try, and where to go from there.
#pragma once

#include <QCheckBox>
#include <QFrame>
#include <QLabel>
#include <QMenu>
#include <QPushButton>

namespace touchdown {

class StartCard : public QFrame {
    Q_OBJECT

public:
    /// Whether it is to be shown at the start: at the first one of a newcomer, and at each one if the user wants that.
    static bool wanted();

    /// `figures` are the sample cases to choose from; both menus must outlive the card.
    StartCard(QMenu* figures, QMenu* recent, QWidget* parent);

    /// Shown; the next start does without it, unless the user says otherwise.
    void open();
    void close();

    QPushButton* lesson() const { return lesson_; }
    QPushButton* openFile() const { return open_; }
    QCheckBox* again() const { return again_; }
    /// What it says, without its marks.
    QString text() const;

signals:
    void lessonRequested();
    void fileRequested();
    void closed();

protected:
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void write();

    QLabel *title_, *watch_, *tries_;
    QPushButton *lesson_, *figure_, *open_, *recent_;
    QCheckBox* again_;
};

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The first minute: what moves on the screen, what to watch and what to try, and where to go from there.
#pragma once

#include <QFrame>
#include <QLabel>
#include <QPushButton>

namespace touchdown {

class StartCard : public QFrame {
    Q_OBJECT

public:
    /// Whether this is the first start of a newcomer.
    static bool wanted();

    explicit StartCard(QWidget* parent);

    /// Shown; the next start does without it.
    void open();
    void close();

    QPushButton* lesson() const { return lesson_; }
    QPushButton* figures() const { return figure_; }
    QPushButton* openFile() const { return open_; }
    /// What it says, without its marks.
    QString text() const;

signals:
    void closed();

protected:
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void write();

    QLabel *title_, *watch_, *tries_;
    QPushButton *lesson_, *figure_, *open_;
};

} // namespace touchdown

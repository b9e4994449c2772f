// SPDX-License-Identifier: GPL-3.0-or-later
//
// Help inside the program: how to use it, the equations of the model, what the paper says
// and what is found, the terms, every parameter, the shortcuts, the licence.
#pragma once

#include <QListWidget>
#include <QString>
#include <QTextBrowser>
#include <QWidget>

namespace touchdown {

class HelpWindow : public QWidget {
    Q_OBJECT

public:
    /// `shortcuts` as rows of a table, in HTML.
    explicit HelpWindow(const QString& shortcuts, QWidget* parent = nullptr);

    enum class Page {
        Use,
        Equations,
        AirFilm,
        Contact,
        Results,
        Paper,
        Glossary,
        Parameters,
        Readings,
        Shortcuts,
        About
    };
    Q_ENUM(Page)
    void open(Page page);
    QString text() const { return browser_->toPlainText(); }

private:
    QString html(Page page) const;
    void placeOnScreen();

    QString shortcuts_;
    QListWidget* contents_;
    QTextBrowser* browser_;
};

} // namespace touchdown

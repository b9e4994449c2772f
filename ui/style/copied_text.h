// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tables as a rich text that can be selected, with a button that copies all of it for a spreadsheet. Written anew where
// palette or font change.
#pragma once

#include <QTextBrowser>
#include <QToolButton>
#include <QWidget>

namespace touchdown {

class CopiedText : public QWidget {
    Q_OBJECT

public:
    /// Accessible names: of the text, and of the button.
    CopiedText(const QString& textName, const QString& copyName, QWidget* parent);

public slots:
    /// All of it, tab-separated, on the clipboard.
    void copy() const;

protected:
    void changeEvent(QEvent* event) override;

    /// To be called by the constructor of the derived class, and where the content changed.
    void write();
    virtual QString html() const = 0;
    /// What `copy` copies; empty where there is nothing.
    virtual QString plainText() const = 0;
    QTextBrowser* text() const { return text_; }

private:
    QTextBrowser* text_;
    QToolButton* copy_;
};

} // namespace touchdown

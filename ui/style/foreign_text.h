// SPDX-License-Identifier: GPL-3.0-or-later
//
// Foreign text is shown as it is written. It is every text that the program did not make: of a case, a study or a
// results file, of a path, a note, the command line, the last session. Qt takes a text that looks like HTML for HTML,
// in labels, message boxes and tool tips. It then opens each file that the text names: <img src='/dev/zero'> takes all
// memory. A mark that turns the direction of writing makes a name read otherwise than it is. These rules keep foreign
// text plain:
// - labels, also those of message boxes and progress dialogs, and titles of windows: nothing to do.
//   showForeignTextPlainly() makes each label plain that does not ask for HTML by setTextFormat(Qt::RichText);
// - tool tips: plainTip(). tests/check_layers.cmake refuses others, except literals of the program;
// - texts of menus, tabs and buttons: onButton();
// - texts that a widget paints by itself: withoutTurns();
// - HTML of the program: escaped() for each foreign part; its documents are OwnDocument or OwnTextBrowser.
#pragma once

#include <QString>
#include <QTextBrowser>
#include <QTextDocument>

namespace touchdown {

/// For the whole program, from now on. Message boxes and dialogs need no call of their own.
void showForeignTextPlainly();

/// `text` for a widget that paints it by itself. A mark that turns the direction of writing would turn the program's
/// own words behind it, too.
QString withoutTurns(QString text);

/// HTML that shows `text` as it is written, with its lines.
QString escaped(const QString& text);

/// The same in a tool tip, where a line breaks only between words: a long word may break at a zero-width space.
QString escapedForTip(const QString& text);

/// Tool tip that shows `text` as it is written, in lines that fit the screen.
QString plainTip(const QString& text);

/// `text` for a menu, a tab or a button, which take & for the mark of a key.
QString onButton(QString text);

/// A name for a sentence: its beginning, in one line.
QString inOneLine(const QString& name);

/// HTML with no other pictures and style sheets than those that the program added to it: no file is ever read.
class OwnDocument : public QTextDocument {
public:
    using QTextDocument::QTextDocument;

protected:
    QVariant loadResource(int type, const QUrl& name) override;
};

/// The same for a text that is shown.
class OwnTextBrowser : public QTextBrowser {
public:
    using QTextBrowser::QTextBrowser;

protected:
    QVariant loadResource(int type, const QUrl& name) override;
};

} // namespace touchdown

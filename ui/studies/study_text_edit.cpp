// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/studies/study_text_edit.h"

#include <utility>

#include <QEvent>
#include <QFontDatabase>
#include <QTextBlock>

#include "ui/style/theme.h"

namespace touchdown {

/// Comments in grey, keys in the colour of a change.
class StudyTextEdit::Comments : public QSyntaxHighlighter {
public:
    Comments(QTextDocument* document, const QPalette& palette) : QSyntaxHighlighter(document) { take(palette); }

    void setColours(const QPalette& palette)
    {
        take(palette);
        rehighlight();
    }

protected:
    void highlightBlock(const QString& text) override
    {
        bool quoted = false;
        qsizetype comment = 0;
        while (comment < text.size() && (quoted || text[comment] != u'#')) {
            if (text[comment] == u'"') quoted = !quoted;
            ++comment;
        }
        const qsizetype key = text.left(comment).indexOf(u'=');
        if (key > 0) setFormat(0, static_cast<int>(key), key_);
        if (text.startsWith(u'[')) setFormat(0, static_cast<int>(comment), key_);
        setFormat(static_cast<int>(comment), static_cast<int>(text.size() - comment), comment_);
    }

private:
    void take(const QPalette& palette)
    {
        comment_.setForeground(meaningColours(palette).muted);
        key_.setForeground(meaningColours(palette).change);
    }

    QTextCharFormat comment_, key_;
};

StudyTextEdit::StudyTextEdit(QWidget* parent) : QPlainTextEdit(parent), comments_(new Comments(document(), palette()))
{
    setAccessibleName(tr("Text of the study"));
    setTabChangesFocus(true);
    setLineWrapMode(QPlainTextEdit::WidgetWidth);
    adaptFont();
}

void StudyTextEdit::adaptFont()
{
    QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    fixed.setPointSizeF(0.95 * (parentWidget() ? parentWidget()->font() : font()).pointSizeF());
    if (fixed != font()) setFont(fixed);
}

void StudyTextEdit::markLines(const std::vector<int>& lines)
{
    marked_ = lines;
    paintMarks();
}

void StudyTextEdit::paintMarks()
{
    QColor wash = meaningColours(palette()).failure;
    wash.setAlphaF(0.16F);
    QList<QTextEdit::ExtraSelection> selections;
    for (const int line : marked_) {
        const QTextBlock block = document()->findBlockByNumber(line - 1);
        if (!block.isValid()) continue;
        QTextEdit::ExtraSelection selection;
        selection.cursor = QTextCursor(block);
        selection.format.setBackground(wash);
        selection.format.setProperty(QTextFormat::FullWidthSelection, true);
        selections << selection;
    }
    setExtraSelections(selections);
}

void StudyTextEdit::goToLine(int line)
{
    const QTextBlock block = document()->findBlockByNumber(line - 1);
    if (!block.isValid()) return;
    setTextCursor(QTextCursor(block));
    centerCursor();
    setFocus();
}

void StudyTextEdit::changeEvent(QEvent* event)
{
    QPlainTextEdit::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        comments_->setColours(palette());
        paintMarks();
    }
    if (event->type() == QEvent::ApplicationFontChange) adaptFont();
}

} // namespace touchdown

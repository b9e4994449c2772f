// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/foreign_text.h"

#include <algorithm>
#include <utility>

#include <QApplication>
#include <QEvent>
#include <QImage>
#include <QLabel>
#include <QRegularExpression>
#include <QUrl>
#include <QVariant>

namespace touchdown {

namespace {

void makePlain(QObject* object)
{
    auto* label = qobject_cast<QLabel*>(object);
    if (label == nullptr || label->textFormat() != Qt::AutoText) return;
    const bool isTip = label->windowType() == Qt::ToolTip; // its text comes from plainTip()
    if (!isTip) label->setTextFormat(Qt::PlainText);
}

constexpr qsizetype lineOfTip = 80; // [characters]
constexpr qsizetype mostOfTip = 2000, mostLinesOfTip = 40;

/// A label is polished before it is measured or drawn for the first time, so before its HTML is read. Its text may
/// change afterwards; each text is drawn.
class PlainLabels final : public QObject {
public:
    using QObject::QObject;

    bool eventFilter(QObject* watched, QEvent* event) override
    {
        if (event->type() == QEvent::Polish) makePlain(watched);
        if (event->type() == QEvent::Paint)
            if (auto* label = qobject_cast<QLabel*>(watched)) label->setText(withoutTurns(label->text()));
        if (event->type() == QEvent::WindowTitleChange)
            if (auto* window = qobject_cast<QWidget*>(watched))
                if (const QString title = withoutTurns(window->windowTitle()); title != window->windowTitle())
                    window->setWindowTitle(title);
        return false;
    }
};

/// The beginning of a long text.
QString beginningOf(const QString& text)
{
    qsizetype end = 0;
    for (int line = 0; line < mostLinesOfTip && end >= 0; ++line) end = text.indexOf(u'\n', end + (line > 0 ? 1 : 0));
    const qsizetype most = end < 0 ? mostOfTip : std::min(end, mostOfTip);
    return text.size() <= most ? text : text.left(most) + QChar(0x2026);
}

QVariant noPicture()
{
    // Qt would look for the file by itself if this were empty.
    QImage nothing(1, 1, QImage::Format_ARGB32_Premultiplied);
    nothing.fill(Qt::transparent);
    return nothing;
}

} // namespace

void showForeignTextPlainly()
{
    static const QString name = QStringLiteral("plainLabels");
    if (qApp->findChild<QObject*>(name, Qt::FindDirectChildrenOnly) != nullptr) return;
    auto* filter = new PlainLabels(qApp);
    filter->setObjectName(name);
    qApp->installEventFilter(filter);
    for (QWidget* widget : QApplication::allWidgets()) makePlain(widget);
}

QString withoutTurns(QString text)
{
    static const QRegularExpression marks(QStringLiteral("[\\x{202a}-\\x{202e}\\x{2066}-\\x{2069}]"));
    return text.replace(marks, QString(QChar::ReplacementCharacter));
}

QString escaped(const QString& text)
{
    return withoutTurns(text).toHtmlEscaped().replace(u'\n', QLatin1String("<br>"));
}

QString escapedForTip(const QString& text)
{
    static const QRegularExpression longWord(QStringLiteral("(\\S{40})(?=\\S)"));
    return escaped(beginningOf(text).replace(longWord, QStringLiteral("\\1\u200B")));
}

QString plainTip(const QString& whole)
{
    const QString text = withoutTurns(beginningOf(whole));
    const auto tooLong = [](QStringView line) { return line.size() > lineOfTip; };
    const bool wrapped = std::ranges::any_of(QStringView(text).split(u'\n'), tooLong);
    if (wrapped) return QStringLiteral("<p style='margin:0; white-space:pre-wrap'>%1</p>").arg(escapedForTip(text));
    // Qt breaks the lines of all HTML, also short ones.
    return Qt::mightBeRichText(text) ? QStringLiteral("<p style='margin:0; white-space:pre'>%1</p>").arg(escaped(text))
                                     : text;
}

QString onButton(QString text) { return withoutTurns(std::move(text)).replace(u'&', QLatin1String("&&")); }

QString inOneLine(const QString& name)
{
    constexpr qsizetype most = 80; // [characters]
    const QString line = withoutTurns(name.left(2 * most)).simplified();
    return line.size() <= most ? line : line.left(most) + QChar(0x2026);
}

QVariant OwnDocument::loadResource(int, const QUrl&) { return noPicture(); }

QVariant OwnTextBrowser::loadResource(int, const QUrl&) { return noPicture(); }

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/foreign_text.h"

#include <algorithm>

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

/// A label is polished before it is measured or drawn for the first time, so before its HTML is read.
class PlainLabels final : public QObject {
public:
    using QObject::QObject;

    bool eventFilter(QObject* watched, QEvent* event) override
    {
        if (event->type() == QEvent::Polish) makePlain(watched);
        return false;
    }
};

constexpr qsizetype lineOfTip = 80; // [characters]
constexpr qsizetype mostOfTip = 2000;

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

QString escaped(const QString& text) { return text.toHtmlEscaped().replace(u'\n', QLatin1String("<br>")); }

QString escapedForTip(const QString& text)
{
    static const QRegularExpression longWord(QStringLiteral("(\\S{40})(?=\\S)"));
    QString broken = text.size() <= mostOfTip ? text : text.left(mostOfTip) + QChar(0x2026);
    return escaped(broken.replace(longWord, QStringLiteral("\\1\u200B")));
}

QString plainTip(const QString& text)
{
    const auto tooLong = [](QStringView line) { return line.size() > lineOfTip; };
    const bool wrapped = text.size() > mostOfTip || std::ranges::any_of(QStringView(text).split(u'\n'), tooLong);
    if (wrapped) return QStringLiteral("<p style='margin:0; white-space:pre-wrap'>%1</p>").arg(escapedForTip(text));
    // Qt breaks the lines of all HTML, also short ones.
    return Qt::mightBeRichText(text) ? QStringLiteral("<p style='margin:0; white-space:pre'>%1</p>").arg(escaped(text))
                                     : text;
}

QString onButton(QString text) { return text.replace(u'&', QLatin1String("&&")); }

QVariant OwnDocument::loadResource(int, const QUrl&) { return noPicture(); }

QVariant OwnTextBrowser::loadResource(int, const QUrl&) { return noPicture(); }

} // namespace touchdown

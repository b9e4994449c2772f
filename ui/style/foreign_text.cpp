// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/foreign_text.h"

#include <QApplication>
#include <QEvent>
#include <QImage>
#include <QLabel>
#include <QRegularExpression>
#include <QUrl>
#include <QVariant>

namespace touchdown {

namespace {

/// A label is polished before it is measured or drawn for the first time, so before its HTML is read.
class PlainLabels final : public QObject {
public:
    using QObject::QObject;

    bool eventFilter(QObject* watched, QEvent* event) override
    {
        if (event->type() != QEvent::Polish) return false;
        auto* label = qobject_cast<QLabel*>(watched);
        const bool isTip = label != nullptr && label->windowType() == Qt::ToolTip; // its text is of plainTip()
        if (label != nullptr && !isTip && label->textFormat() == Qt::AutoText) label->setTextFormat(Qt::PlainText);
        return false;
    }
};

constexpr qsizetype lineOfTip = 80; // characters

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
}

QString escaped(const QString& text) { return text.toHtmlEscaped().replace(u'\n', QLatin1String("<br>")); }

QString plainTip(const QString& text)
{
    if (text.size() <= lineOfTip && !Qt::mightBeRichText(text)) return text;
    // Qt breaks lines in HTML only, and only between words: a longer word may break at a zero-width space.
    static const QRegularExpression longWord(QStringLiteral("(\\S{40})(?=\\S)"));
    QString broken = text;
    broken.replace(longWord, QStringLiteral("\\1\u200B"));
    return QStringLiteral("<p style='margin:0; white-space:pre-wrap'>%1</p>").arg(escaped(broken));
}

QString onButton(QString text) { return text.replace(u'&', QLatin1String("&&")); }

QVariant OwnDocument::loadResource(int, const QUrl&) { return noPicture(); }

QVariant OwnTextBrowser::loadResource(int, const QUrl&) { return noPicture(); }

} // namespace touchdown

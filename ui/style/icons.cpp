// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/icons.h"

#include <array>

#include <QFile>
#include <QPainter>
#include <QPixmap>
#include <QSvgRenderer>

namespace touchdown {

namespace {

QPixmap drawn(const QByteArray& svg, const QColor& colour, int size)
{
    QByteArray coloured = svg;
    coloured.replace("currentColor", colour.name().toLatin1());
    QSvgRenderer renderer(coloured);
    QPixmap pixmap(size, size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    renderer.render(&painter);
    return pixmap;
}

} // namespace

QIcon icon(const QString& name, const QPalette& palette)
{
    QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
    if (!file.open(QIODevice::ReadOnly)) return {};
    const QByteArray svg = file.readAll();
    QIcon made;
    for (const int size : std::array{16, 20, 24, 32, 48, 64}) {
        made.addPixmap(drawn(svg, palette.color(QPalette::Active, QPalette::ButtonText), size), QIcon::Normal);
        made.addPixmap(drawn(svg, palette.color(QPalette::Disabled, QPalette::ButtonText), size), QIcon::Disabled);
    }
    return made;
}

QIcon programIcon()
{
    QFile file(QStringLiteral(":/icons/touchdown.svg"));
    QIcon made;
    if (!file.open(QIODevice::ReadOnly)) return made;
    const QByteArray svg = file.readAll();
    for (const int size : std::array{16, 32, 48, 64, 128, 256}) made.addPixmap(drawn(svg, Qt::black, size));
    return made;
}

} // namespace touchdown

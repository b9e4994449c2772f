// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_export.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <QBuffer>
#include <QClipboard>
#include <QDir>
#include <QFileInfo>
#include <QGuiApplication>
#include <QHash>
#include <QImage>
#include <QPageSize>
#include <QPdfWriter>
#include <QSvgGenerator>

#include "ui/plot/plot_widget.h"
#include "ui/style/foreign_text.h"
#include "ui/style/translate.h"
#include "ui/style/whole_file.h"

namespace touchdown {

namespace {

constexpr int paperResolution = 1200; // of PDF [dots per inch]
constexpr double finer = 2.0;         // the clipboard's picture against the screen
constexpr int svgFineness = 10;       // units of an SVG's size for a pixel
constexpr double inch = 0.0254;       // [m]
constexpr int mostPixels = 32767;     // that Qt draws on, in each direction

/// Null where it is too large for the memory, or for Qt to draw on.
QImage rastered(const Picture& picture, double scale)
{
    const QSize size = (picture.size * scale).toSize();
    QImage image;
    if (std::max(size.width(), size.height()) <= mostPixels) image = QImage(size, QImage::Format_RGB32);
    if (image.isNull()) return image;
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.scale(scale, scale);
    picture.paint(painter);
    return image;
}

void writePng(const Picture& picture, QIODevice& device)
{
    QImage image = rastered(picture, picture.dotsPerInch / picture.pixelsPerInch);
    if (image.isNull()) return;
    const auto perMetre = static_cast<int>(std::lround(picture.dotsPerInch / inch));
    image.setDotsPerMeterX(perMetre);
    image.setDotsPerMeterY(perMetre);
    image.save(&device, "PNG");
}

void writeSvg(const Picture& picture, QIODevice& device)
{
    QSvgGenerator generator;
    generator.setOutputDevice(&device);
    generator.setSize((picture.size * svgFineness).toSize());
    generator.setViewBox(QRectF(QPointF(), picture.size));
    generator.setResolution(static_cast<int>(std::lround(picture.pixelsPerInch * svgFineness)));
    generator.setTitle(escaped(picture.title)); // Qt writes it as it is
    QPainter painter(&generator);
    picture.paint(painter);
}

void writePdf(const Picture& picture, QIODevice& device)
{
    QPdfWriter writer(&device);
    writer.setResolution(paperResolution);
    writer.setPageSize(
        QPageSize(picture.size * 72.0 / picture.pixelsPerInch, QPageSize::Point, {}, QPageSize::ExactMatch));
    writer.setPageMargins({});
    writer.setTitle(picture.title);
    writer.setCreator(QStringLiteral("Touchdown"));
    QPainter painter(&writer);
    painter.setRenderHint(QPainter::LosslessImageRendering);
    painter.scale(paperResolution / picture.pixelsPerInch, paperResolution / picture.pixelsPerInch);
    picture.paint(painter);
}

Picture pictureOf(QWidget& shown, const PlotTheme& theme)
{
    auto* part = dynamic_cast<PagePart*>(&shown);
    return {shown.size(), part != nullptr ? part->title() : QString(), [&shown, part, theme](QPainter& painter) {
                if (part != nullptr) {
                    part->paintInto(painter, shown.rect(), theme);
                    return;
                }
                painter.fillRect(shown.rect(), theme.background);
                for (QWidget* widget : visibleParts(shown)) {
                    painter.save();
                    painter.setClipRect(partInView(*widget, shown).translated(widget->mapTo(&shown, QPoint())));
                    dynamic_cast<PagePart*>(widget)->paintInto(
                        painter, QRectF(widget->mapTo(&shown, QPoint()), widget->size()), theme);
                    painter.restore();
                }
            }};
}

/// Quoted where it would break the row.
QString columnTitle(const QString& name, const QString& unit)
{
    QString text = unit.isEmpty() ? name : QStringLiteral("%1 [%2]").arg(name, unit);
    if (!text.contains(u',') && !text.contains(u'"') && !text.contains(u'\n')) return text;
    return u'"' + text.replace(u'"', QLatin1String("\"\"")) + u'"';
}

/// The samples of one curve that are still to be written.
struct Column {
    const PlotCurve* curve;
    std::size_t next;
    std::size_t end;

    double time() const { return next < end ? curve->data->time(next) : std::numeric_limits<double>::infinity(); }
};

QByteArray number(std::optional<double> value, double factor)
{
    return value ? QByteArray::number(*value / factor, 'g', 15) : QByteArray();
}

} // namespace

QRect partInView(const QWidget& widget, const QWidget& page)
{
    QRect seen = widget.rect();
    for (const QWidget* around = &widget; around != &page;) {
        around = around->parentWidget();
        seen &= QRect(widget.mapFrom(around, QPoint()), around->size());
    }
    return seen;
}

std::vector<QWidget*> visibleParts(QWidget& page)
{
    std::vector<QWidget*> parts;
    for (QWidget* widget : page.findChildren<QWidget*>())
        if (dynamic_cast<PagePart*>(widget) != nullptr && widget->isVisibleTo(&page)) parts.push_back(widget);
    std::ranges::stable_sort(parts, {}, [&page](const QWidget* widget) {
        const QPoint at = widget->mapTo(&page, QPoint());
        return std::pair(at.y(), at.x());
    });
    return parts;
}

QString saveImage(const QImage& image, const QString& path)
{
    const QByteArray format = QFileInfo(path).suffix().toLatin1();
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    if (!image.save(&buffer, format.constData()))
        return tr("%1 does not end in the name of an image format.").arg(QDir::toNativeSeparators(path));
    return writeWholeFile(path, buffer.data());
}

std::optional<QByteArray> pictureBytes(const Picture& picture, const QString& path)
{
    using Write = void (*)(const Picture&, QIODevice&);
    static const QHash<QString, Write> formats{{"png", writePng}, {"svg", writeSvg}, {"pdf", writePdf}};
    const Write write = formats.value(QFileInfo(path).suffix().toLower());
    if (write == nullptr) return {};
    // Qt's generators do not report a device that fails, so they write into memory.
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    write(picture, buffer);
    return buffer.data();
}

QString savePicture(const Picture& picture, const QString& path)
{
    const std::optional<QByteArray> bytes = pictureBytes(picture, path);
    if (!bytes)
        return tr("%1 does not end in .png, .svg or .pdf, so its format is not known.")
            .arg(QDir::toNativeSeparators(path));
    if (bytes->isEmpty())
        return tr("%1 could not be written: the picture has too many pixels.").arg(QDir::toNativeSeparators(path));
    return writeWholeFile(path, *bytes);
}

QString savePicture(QWidget& shown, const QString& path)
{
    return savePicture(pictureOf(shown, lightPlotTheme()), path);
}

void copyPicture(QWidget& shown)
{
    QGuiApplication::clipboard()->setImage(rastered(pictureOf(shown, plotTheme(shown.palette())), finer));
}

void writeCsv(const PlotWidget& plot, QIODevice& device)
{
    const bool phase = plot.isPhasePortrait();
    const AxisLabel& x = plot.xAxis().label;
    const AxisLabel& y = plot.yAxis().label;
    std::vector<Column> columns;
    QStringList titles{phase ? tr("Time [s]") : columnTitle(x.title, x.unit)};
    for (const PlotCurve& curve : plot.curves()) {
        if (!curve.visible || curve.data == nullptr) continue;
        const auto [begin, end] = phase
                                      ? std::pair<std::size_t, std::size_t>{0, curve.data->size()}
                                      : curve.data->samplesWithin(plot.xAxis().range().low, plot.xAxis().range().high);
        columns.push_back({&curve, begin, end});
        if (phase) titles += columnTitle(x.title, x.unit);
        titles += columnTitle(curve.name.isEmpty() ? plot.title() : curve.name, y.unit);
    }
    device.write(titles.join(u',').toUtf8() + "\r\n");

    const auto earliest = [&] {
        double time = std::numeric_limits<double>::infinity();
        for (const Column& column : columns) time = std::min(time, column.time());
        return time;
    };
    for (double time = earliest(); time < std::numeric_limits<double>::infinity(); time = earliest()) {
        QByteArray row = number(time, phase ? 1.0 : x.factor);
        for (Column& column : columns) {
            const bool here = column.time() == time;
            const PlotCurve& curve = *column.curve;
            if (phase) row += ',' + (here ? number(curve.xData->valueAt(time), x.factor) : QByteArray());
            row += ',' + (here ? number(curve.data->value(column.next), y.factor) : QByteArray());
            column.next += here ? 1 : 0;
        }
        device.write(row + "\r\n");
    }
}

QString saveCsv(const PlotWidget& plot, const QString& path)
{
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    writeCsv(plot, buffer);
    return writeWholeFile(path, buffer.data());
}

} // namespace touchdown

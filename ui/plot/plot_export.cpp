// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_export.h"

#include <algorithm>
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
#include "ui/style/translate.h"
#include "ui/style/whole_file.h"

namespace touchdown {

namespace {

constexpr int screenResolution = 96; // [pixels per inch], that of a picture's size in SVG and PDF
constexpr int paperResolution = 1200;
constexpr double finer = 2.0; // PNG against the screen

QImage rastered(const Picture& picture, double scale)
{
    QImage image((picture.size * scale).toSize(), QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.scale(scale, scale);
    picture.paint(painter);
    return image;
}

void writePng(const Picture& picture, QIODevice& device) { rastered(picture, finer).save(&device, "PNG"); }

void writeSvg(const Picture& picture, QIODevice& device)
{
    QSvgGenerator generator;
    generator.setOutputDevice(&device);
    generator.setSize(picture.size.toSize());
    generator.setViewBox(QRectF(QPointF(), picture.size));
    generator.setResolution(screenResolution);
    generator.setTitle(picture.title);
    QPainter painter(&generator);
    picture.paint(painter);
}

void writePdf(const Picture& picture, QIODevice& device)
{
    QPdfWriter writer(&device);
    writer.setResolution(paperResolution);
    writer.setPageSize(QPageSize(picture.size * 72.0 / screenResolution, QPageSize::Point, {}, QPageSize::ExactMatch));
    writer.setPageMargins({});
    writer.setTitle(picture.title);
    writer.setCreator(QStringLiteral("Touchdown"));
    QPainter painter(&writer);
    painter.scale(1.0 * paperResolution / screenResolution, 1.0 * paperResolution / screenResolution);
    picture.paint(painter);
}

/// What `write` writes, as a file. Qt's generators do not report a device that fails, so they write into memory.
QString writeFile(const QString& path, const std::function<void(QIODevice&)>& write)
{
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    write(buffer);
    return writeWholeFile(path, buffer.data());
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
                for (QWidget* widget : shown.findChildren<QWidget*>())
                    if (auto* inner = dynamic_cast<PagePart*>(widget); inner != nullptr && widget->isVisibleTo(&shown))
                        inner->paintInto(painter, QRectF(widget->mapTo(&shown, QPoint()), widget->size()), theme);
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

QString saveImage(const QImage& image, const QString& path)
{
    const QByteArray format = QFileInfo(path).suffix().toLatin1();
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    if (!image.save(&buffer, format.constData()))
        return tr("%1 does not end in the name of an image format.").arg(QDir::toNativeSeparators(path));
    return writeWholeFile(path, buffer.data());
}

QString savePicture(const Picture& picture, const QString& path)
{
    using Write = void (*)(const Picture&, QIODevice&);
    static const QHash<QString, Write> formats{{"png", writePng}, {"svg", writeSvg}, {"pdf", writePdf}};
    const Write write = formats.value(QFileInfo(path).suffix().toLower());
    if (write == nullptr)
        return tr("%1 does not end in .png, .svg or .pdf, so its format is not known.")
            .arg(QDir::toNativeSeparators(path));
    return writeFile(path, [&](QIODevice& device) { write(picture, device); });
}

QString savePicture(QWidget& shown, const QString& path, bool dashes)
{
    PlotTheme theme = lightPlotTheme();
    theme.printDashes = dashes;
    return savePicture(pictureOf(shown, theme), path);
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
    return writeFile(path, [&](QIODevice& device) { writeCsv(plot, device); });
}

} // namespace touchdown

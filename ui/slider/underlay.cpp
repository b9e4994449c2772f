// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/underlay.h"

#include <algorithm>
#include <cmath>

#include <QCryptographicHash>
#include <QFileInfo>
#include <QImageReader>
#include <QSettings>

#include "core/formats/text_file.h"
#include "ui/slider/slider_plan.h"
#include "ui/style/foreign_text.h"

namespace touchdown {

namespace {

constexpr int mostPixels = 4096;      // along a side of a picture
constexpr double mostUnscaled = 50e6; // pixels of a picture with few colours, which is not made smaller on reading

/// The group of the settings for a case: a path may be long and hold any letter.
QString settingsOf(const QString& name)
{
    return QStringLiteral("drawings/") +
           QString::fromLatin1(QCryptographicHash::hash(name.toUtf8(), QCryptographicHash::Sha1).toHex());
}

/// Within what the form takes; also of settings that hold no numbers.
UnderlayPlace possible(UnderlayPlace place)
{
    const auto within = [](double value, double least, double most) {
        return std::isnan(value) ? least : std::clamp(value, least, most);
    };
    constexpr double far = 1.0; // [m]
    place.width = within(place.width, 1e-9, far);
    place.x = within(place.x, -far, far);
    place.y = within(place.y, -far, far);
    place.opacity = within(place.opacity, 0.05, 1.0);
    return place;
}

bool isDxf(const QString& file)
{
    return QFileInfo(file).suffix().compare(QLatin1String("dxf"), Qt::CaseInsensitive) == 0;
}

} // namespace

Underlay::Underlay(QObject* parent) : QObject(parent), tasks_(new TaskQueue(this)) {}

bool Underlay::canLoad(const QString& file)
{
    static const QStringList endings{QStringLiteral("png"), QStringLiteral("jpg"), QStringLiteral("jpeg")};
    return isDxf(file) || endings.contains(QFileInfo(file).suffix().toLower());
}

void Underlay::readPicture(const QString& file, Content& content)
{
    QImageReader reader(file);
    reader.setDecideFormatFromContent(true);
    const QByteArray format = reader.format();
    if (format != "png" && format != "jpeg") {
        content.problem = tr("is no PNG or JPEG picture");
        return;
    }
    const QSize size = reader.size();
    const bool fewColours =
        reader.imageFormat() == QImage::Format_Mono || reader.imageFormat() == QImage::Format_Indexed8;
    if (fewColours && 1.0 * size.width() * size.height() > mostUnscaled) {
        content.problem =
            tr("has too many pixels for a picture of few colours: %1 by %2").arg(size.width()).arg(size.height());
        return;
    }
    if (std::max(size.width(), size.height()) > mostPixels)
        reader.setScaledSize(size.scaled(mostPixels, mostPixels, Qt::KeepAspectRatio).expandedTo({1, 1}));
    content.picture = reader.read().convertToFormat(QImage::Format_ARGB32_Premultiplied);
    content.box = content.picture.rect();
    if (content.picture.isNull()) content.problem = tr("cannot be read as a picture: %1").arg(reader.errorString());
}

Underlay::Content Underlay::contentOf(const QString& file)
{
    Content content;
    const std::filesystem::path path = file.toStdString();
    if (const std::string problem = notRegularFile(path); !problem.empty()) {
        content.problem = QString::fromStdString(problem);
    } else if (!isDxf(file)) {
        readPicture(file, content);
    } else {
        content.drawing = readDxf(path);
        content.problem = QString::fromStdString(content.drawing.problem);
        double left = INFINITY, right = -INFINITY, low = INFINITY, high = -INFINITY;
        for (const DrawnPath& drawn : content.drawing.paths)
            for (const SurfacePoint& p : drawn.points) {
                left = std::min(left, p.x), right = std::max(right, p.x);
                low = std::min(low, p.y), high = std::max(high, p.y);
            }
        if (!content.drawing.paths.empty()) content.box = {left, low, right - left, high - low};
        if (content.problem.isEmpty() && content.box.isEmpty()) content.problem = tr("holds nothing but a line");
    }
    return content;
}

void Underlay::read(const QString& file, std::function<void()> placed, std::function<void()> then)
{
    const int asked = ++asked_;
    auto content = std::make_shared<Content>();
    tasks_->post(
        [content, file] {
            *content = contentOf(file);
            return QString();
        },
        [this, content, file, asked, placed = std::move(placed), then = std::move(then)](const QString& /*problem*/) {
            if (asked != asked_) return;
            if (!content->problem.isEmpty()) {
                emit failed(tr("The drawing under the plan is not shown: %1 %2.")
                                .arg(inOneLine(QFileInfo(file).fileName()), content->problem));
                return;
            }
            content_ = std::move(*content);
            file_ = file;
            placed();
            emit changed();
            emit fileShown();
            then();
        });
}

void Underlay::openCase(const QString& name)
{
    ++asked_; // nothing that is being read
    case_ = name;
    content_ = {};
    file_.clear();
    emit changed();
    if (name.isEmpty()) return;
    QSettings settings;
    settings.beginGroup(settingsOf(name));
    const QString file = settings.value(QStringLiteral("file")).toString();
    if (file.isEmpty()) return;
    const auto number = [&settings](const char* key) { return settings.value(QLatin1String(key)).toDouble(); };
    UnderlayPlace place;
    place.width = number("width");
    place.x = number("x");
    place.y = number("y");
    place.opacity = number("opacity");
    place.mirrored = settings.value(QStringLiteral("mirrored")).toBool();
    place.shown = settings.value(QStringLiteral("shown"), true).toBool();
    read(file, [this, place = possible(place)] { place_ = place; });
}

void Underlay::renameCase(const QString& name)
{
    if (name == case_) return;
    case_ = name;
    remember();
}

void Underlay::load(const QString& file, double length, double width, const std::function<void()>& then)
{
    const auto place = [this, length, width] {
        const QRectF& box = content_.box;
        place_ = {};
        place_.width = length;
        if (unit() > 0.0) {
            place_.width = box.width() * unit();
            const QRectF placed(box.topLeft() * unit(), box.size() * unit());
            if (placed.intersects({0.0, 0.0, length, width})) place_.x = placed.left(), place_.y = placed.top();
        }
        place_ = possible(place_);
        remember();
    };
    read(QFileInfo(file).absoluteFilePath(), place, then);
}

void Underlay::remove()
{
    ++asked_;
    content_ = {};
    file_.clear();
    QSettings().remove(settingsOf(case_));
    emit changed();
}

void Underlay::setPlace(const UnderlayPlace& place)
{
    if (!loaded() || place == place_) return;
    place_ = possible(place);
    remember();
    emit changed();
}

void Underlay::remember() const
{
    if (!loaded() || case_.isEmpty()) return;
    QSettings settings;
    settings.beginGroup(settingsOf(case_));
    settings.setValue(QStringLiteral("file"), file_);
    settings.setValue(QStringLiteral("width"), place_.width);
    settings.setValue(QStringLiteral("x"), place_.x);
    settings.setValue(QStringLiteral("y"), place_.y);
    settings.setValue(QStringLiteral("opacity"), place_.opacity);
    settings.setValue(QStringLiteral("mirrored"), place_.mirrored);
    settings.setValue(QStringLiteral("shown"), place_.shown);
}

/// `u` to the right and `v` upwards, in pixels or units of the drawing.
SurfacePoint Underlay::onSlider(double u, double v) const
{
    const QRectF& box = content_.box;
    const double scale = place_.width / box.width();
    return {place_.x + (u - box.left()) * scale,
            place_.y + (place_.mirrored ? box.bottom() - v : v - box.top()) * scale};
}

std::vector<DrawnPath> Underlay::paths() const
{
    std::vector<DrawnPath> paths = content_.drawing.paths;
    for (DrawnPath& path : paths)
        for (SurfacePoint& p : path.points) p = onSlider(p.x, p.y);
    return paths;
}

void Underlay::paint(QPainter& painter, const SliderPlan& plan, const PlotTheme& theme) const
{
    painter.save();
    painter.setOpacity(place_.opacity);
    if (isDrawing()) {
        painter.setRenderHint(QPainter::Antialiasing, false); // of many lines it takes most of the time
        painter.setPen(QPen(theme.curves.front(), 0.0));
        for (const DrawnPath& path : content_.drawing.paths) {
            QPolygonF line;
            for (const SurfacePoint& p : path.points) line << plan.toPixel(onSlider(p.x, p.y));
            if (path.closed) line << line.front();
            painter.drawPolyline(line);
        }
    } else {
        // The part of the picture that is seen: a place that is near has an enormous picture around it.
        const QRectF whole = content_.box;
        const double scale = place_.width / whole.width();
        const QRectF all(place_.x, place_.y, place_.width, whole.height() * scale);
        const QRectF seen = all.intersected(plan.view());
        if (!seen.isEmpty()) {
            const double low = (seen.top() - all.top()) / scale, height = seen.height() / scale;
            const QRectF source((seen.left() - all.left()) / scale, whole.height() - low - height, seen.width() / scale,
                                height);
            const QRectF target(plan.toPixel({seen.left(), seen.bottom()}), plan.toPixel({seen.right(), seen.top()}));
            painter.setRenderHint(QPainter::SmoothPixmapTransform);
            if (place_.mirrored) {
                painter.translate(0.0, target.top() + target.bottom());
                painter.scale(1.0, -1.0);
                painter.drawImage(target, content_.picture,
                                  QRectF(source.left(), low, source.width(), source.height()));
            } else {
                painter.drawImage(target, content_.picture, source);
            }
        }
    }
    painter.restore();
}

} // namespace touchdown

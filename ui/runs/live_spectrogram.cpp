// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/live_spectrogram.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>
#include <vector>

#include <QEvent>
#include <QImage>
#include <QTextStream>

#include "core/formats/units.h"
#include "ui/plot/colour_scale.h"
#include "ui/plot/plot_widget.h"
#include "ui/runs/run_record.h"
#include "ui/runs/runs_model.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

namespace {

constexpr double megahertz = 1e6;                         // [Hz]
constexpr double finestPixels = 3.0;                      // of a picture for a pixel of the screen
constexpr int refreshEach = 250;                          // [ms] while a run goes
constexpr double standsOut = 60.0;                        // below the largest density [dB]
constexpr double keyLength = 90.0;                        // of the colour bar [px]
constexpr std::size_t mostSamples = std::size_t(1) << 21; // above, the window would wait: some 60 ms
constexpr std::size_t windowsOfRun = 32;                  // of the default length, without their overlap

double decibels(double power) { return 10.0 * std::log10(power); }

/// Everything that the pictures of one spectrogram need; shared by the functions of the backdrop.
struct Shown {
    std::shared_ptr<const Spectrogram> data;
    double start = 0.0;   // time of the first sample [s]
    double factor = 1.0;  // of the display unit, squared
    double largest = 0.0; // [dB]
    QString unit;         // "dB re 1 nm²/Hz"
    // The picture that was painted last.
    QImage image;
    PlotRange x, y;
    ColourScale scale;

    double columnStart(std::size_t column) const
    {
        return start + data->firstCentre + (static_cast<double>(column) - 0.5) * data->step;
    }
};

/// [first, second) of `count` cells of width `step` from `origin` that meet [low, high].
std::pair<std::size_t, std::size_t> cellsWithin(double low, double high, double origin, double step, std::size_t count)
{
    const double last = static_cast<double>(count);
    const double first = std::clamp(std::floor((low - origin) / step), 0.0, last);
    const double end = std::clamp(std::ceil((high - origin) / step), 0.0, last);
    return {static_cast<std::size_t>(first), static_cast<std::size_t>(end)};
}

/// The mean density of the columns within each column of pixels, then of the frequencies within each row. The
/// logarithm comes last.
void drawImage(Shown& shown, const QSize& pixels, const PlotAxis& x, const PlotAxis& y)
{
    const Spectrogram& data = *shown.data;
    const std::size_t bins = data.frequency.size();
    const double binWidth = data.frequency[1] - data.frequency[0];
    shown.image = QImage(pixels, QImage::Format_ARGB32_Premultiplied);
    shown.image.fill(Qt::transparent);
    shown.x = x.range();
    shown.y = y.range();
    std::vector<double> mean(bins);
    for (int column = 0; column < pixels.width(); ++column) {
        const double left = x.valueAt(column / static_cast<double>(pixels.width()));
        const double right = x.valueAt((column + 1) / static_cast<double>(pixels.width()));
        const auto [first, end] = cellsWithin(left, right, shown.columnStart(0), data.step, data.columns);
        if (first >= end || right < shown.columnStart(0)) continue;
        std::ranges::fill(mean, 0.0);
        for (std::size_t c = first; c < end; ++c)
            for (std::size_t k = 0; k < bins; ++k) mean[k] += data.at(c, k) / static_cast<double>(end - first);
        for (int row = 0; row < pixels.height(); ++row) {
            const double high = y.valueAt(1.0 - row / static_cast<double>(pixels.height()));
            const double low = y.valueAt(1.0 - (row + 1) / static_cast<double>(pixels.height()));
            const auto [from, to] = cellsWithin(low, high, -0.5 * binWidth, binWidth, bins);
            if (from >= to || high < 0.0) continue;
            double power = 0.0;
            for (std::size_t k = from; k < to; ++k) power += mean[k] / static_cast<double>(to - from);
            const double shownPower = power / shown.factor;
            const double value = shownPower > 0.0 ? decibels(shownPower) : shown.scale.low();
            shown.image.setPixel(column, row, shown.scale.colour(value) | 0xff000000U);
        }
    }
}

/// None where the title has no room beside it.
double paintKeyOf(const Shown& shown, QPainter& painter, const QRectF& room, const QFont& font, const PlotTheme& theme)
{
    const QFontMetricsF metrics(font);
    const QString low = typeset(shown.scale.low(), 0), high = typeset(shown.scale.high(), 0);
    const QString after = high + QChar(0x2002) + shown.unit;
    const double gap = 6.0;
    const double width = metrics.horizontalAdvance(low) + metrics.horizontalAdvance(after) + keyLength + 2.0 * gap;
    if (width > 0.6 * room.width()) return 0.0;
    painter.setFont(font);
    painter.setPen(theme.mutedText);
    QRectF box(room.right() - width, room.top(), metrics.horizontalAdvance(low), room.height());
    painter.drawText(box, Qt::AlignCenter, low);
    const QRectF bar(box.right() + gap, room.center().y() - 4.0, keyLength, 8.0);
    for (int k = 0; k < static_cast<int>(keyLength); ++k)
        painter.fillRect(QRectF(bar.left() + k, bar.top(), 1.5, bar.height()),
                         QColor::fromRgb(shown.scale.colourAt(k / keyLength)));
    painter.drawText(QRectF(bar.right() + gap, room.top(), room.right() - bar.right() - gap, room.height()),
                     Qt::AlignLeft | Qt::AlignVCenter, after);
    return width + 2.0 * gap;
}

void writeDensities(const Shown& shown, QIODevice& device)
{
    const Spectrogram& data = *shown.data;
    QTextStream out(&device);
    out << "time [s]";
    for (const double frequency : data.frequency)
        out << ',' << QString::fromStdString(formatNumber(frequency)) << " Hz";
    out << " [" << shown.unit << "]\r\n";
    for (std::size_t c = 0; c < data.columns; ++c) {
        out << QString::fromStdString(formatNumber(shown.columnStart(c) + 0.5 * data.step));
        for (std::size_t k = 0; k < data.frequency.size(); ++k) {
            const double power = data.at(c, k) / shown.factor;
            out << ',' << (power > 0.0 ? QString::number(decibels(power), 'f', 2) : QString());
        }
        out << "\r\n";
    }
}

} // namespace

std::size_t spectrogramWindow(std::size_t samples)
{
    return std::clamp(std::bit_floor(std::max<std::size_t>(samples / windowsOfRun, 1)), std::size_t(64),
                      std::size_t(4096));
}

LiveSpectrogram::LiveSpectrogram(RunsModel& runs, PlotWidget& plot, QObject* parent)
    : QObject(parent), runs_(runs), plot_(plot)
{
    timer_.setSingleShot(true);
    plot_.installEventFilter(this);
    connect(&timer_, &QTimer::timeout, this, &LiveSpectrogram::updateNow);
    connect(&runs_, &RunsModel::aboutToRemove, this, [this](int number) {
        if (number != run_) return;
        run_ = -1;
        stale_ = true;
        update();
    });
}

/// What was missed while the plot was hidden.
bool LiveSpectrogram::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == &plot_ && event->type() == QEvent::Show) update();
    return false;
}

void LiveSpectrogram::setQuantity(const std::string& name)
{
    if (name == quantity_) return;
    quantity_ = name;
    stale_ = true;
    update();
}

void LiveSpectrogram::setWindow(std::size_t samples)
{
    if (samples == window_) return;
    window_ = samples;
    stale_ = true;
    update();
}

void LiveSpectrogram::update()
{
    if (plot_.isVisible() && !timer_.isActive()) timer_.start(stale_ ? 0 : refreshEach);
}

void LiveSpectrogram::updateNow()
{
    timer_.stop();
    const RunRecord* run = runs_.newestShown();
    const int number = run ? run->number : -1;
    const std::size_t samples = run ? run->sampleCount() : 0;
    if (!stale_ && number == run_ && samples == samples_) return;
    stale_ = false;
    run_ = number;
    samples_ = samples;
    show(run);
}

void LiveSpectrogram::show(const RunRecord* run)
{
    shown_.reset();
    const int index = run ? findQuantity(run->quantities, quantity_) : -1;
    const MinMaxPyramid* column = run ? run->pyramid(quantity_) : nullptr;
    const QString name =
        index < 0 ? QString() : QString::fromStdString(run->quantities[static_cast<std::size_t>(index)].longName);
    const auto titled = [&](const QString& remark) {
        plot_.setTitle(name.isEmpty() ? tr("Spectrogram") : tr("Spectrogram (%1): %2").arg(remark, name));
    };
    titled(tr("no samples yet"));
    plot_.setBackdrop({});
    if (!column || column->size() < 8) return;
    if (column->size() > mostSamples) {
        titled(tr("none above %L1 samples").arg(mostSamples));
        return;
    }
    // The last sample may come at the end of a run that broke off, at another interval.
    std::vector<double> signal;
    signal.reserve(column->size());
    for (std::size_t k = 0; k < column->size(); ++k) signal.push_back(column->value(k));
    const double interval = column->time(1) - column->time(0);
    const std::size_t length = window_ > 0 ? window_ : spectrogramWindow(signal.size());
    auto made = std::make_shared<const Spectrogram>(spectrogram(signal, interval, length, mostColumns));
    if (made->empty()) {
        titled(tr("none yet, its window has %1 samples").arg(length));
        return;
    }
    shown_ = made;

    const Quantity& quantity = run->quantities[static_cast<std::size_t>(index)];
    auto picture = std::make_shared<Shown>();
    picture->data = made;
    picture->start = column->firstTime();
    picture->factor = std::pow(unitFactor(quantity.displayUnit), 2);
    const double most = *std::ranges::max_element(made->density) / picture->factor;
    picture->largest = most > 0.0 ? decibels(most) : 0.0;
    const QString unit = unitText(quantity.displayUnit);
    const bool simple = std::ranges::all_of(unit, [](QChar letter) { return letter.isLetter(); });
    // Not "%1²": the digit would belong to the number of the place.
    picture->unit = tr("dB re 1 %1/Hz").arg((simple ? unit : QStringLiteral("(%1)").arg(unit)) + QStringLiteral("²"));
    picture->scale = ColourScale::linear(ColourMap::Viridis, picture->largest - shownDecibels, picture->largest);
    std::size_t last = 1;
    for (std::size_t i = 0; i < made->density.size(); ++i) {
        const double power = made->density[i] / picture->factor;
        if (power > 0.0 && decibels(power) > picture->largest - standsOut)
            last = std::max(last, i % made->frequency.size());
    }
    titled(tr("%1, %2").arg(timeText(made->timeResolution), frequencyText(made->frequencyResolution)));
    PlotBackdrop backdrop;
    const double end = picture->columnStart(made->columns);
    backdrop.x = {picture->start, std::max(end, column->lastTime())};
    backdrop.y = {0.0, made->frequency[std::min(last + last / 8 + 1, made->frequency.size() - 1)]};
    const char* shownUnit = backdrop.y.high >= megahertz ? "MHz" : "kHz";
    plot_.setYLabel({tr("Frequency"), QString::fromLatin1(shownUnit), unitFactor(shownUnit), AxisScale::Linear});
    backdrop.paint = [picture](QPainter& painter, const QRectF& area, const PlotAxis& x, const PlotAxis& y) {
        const double sharp = std::clamp(painter.deviceTransform().m11(), 1.0, finestPixels);
        const QSize pixels = (area.size() * sharp).toSize();
        if (picture->image.size() != pixels || picture->x != x.range() || picture->y != y.range())
            drawImage(*picture, pixels, x, y);
        painter.drawImage(area, picture->image);
    };
    backdrop.paintKey = [picture](QPainter& painter, const QRectF& room, const QFont& font, const PlotTheme& theme) {
        return paintKeyOf(*picture, painter, room, font, theme);
    };
    backdrop.writeData = [picture](QIODevice& device) { writeDensities(*picture, device); };
    plot_.setBackdrop(std::move(backdrop));
}

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/live_spectrogram.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>
#include <vector>

#include <QElapsedTimer>
#include <QEvent>
#include <QImage>
#include <QTextStream>

#include "core/formats/units.h"
#include "ui/plot/colour_scale.h"
#include "ui/plot/plot_widget.h"
#include "ui/runs/run_record.h"
#include "ui/runs/runs_model.h"
#include "ui/style/foreign_text.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

namespace {

constexpr double megahertz = 1e6;        // [Hz]
constexpr double finestPixels = 3.0;     // of a picture for a pixel of the screen
constexpr int refreshEach = 250;         // [ms] while a run goes
constexpr double standsOut = 60.0;       // below the largest density [dB]
constexpr double keyLength = 160.0;      // of the colour bar [px]
constexpr double leastKey = 24.0;        // [px]
constexpr std::size_t windowsOfRun = 32; // of the default length, without their overlap
constexpr qint64 restShare = 4;          // rest this many times as long as the last computation took
constexpr std::size_t leastSamples = 8;

double decibels(double power) { return 10.0 * std::log10(power); }

} // namespace

/// Everything that the pictures of one spectrogram need; shared by the functions of the backdrop.
struct LiveSpectrogram::Shown {
    std::shared_ptr<const Spectrogram> data;
    double start = 0.0;   // time of the first sample [s]
    double factor = 1.0;  // of the display unit, squared
    double largest = 0.0; // [dB]
    QString unit;         // "dB re 1 nm²/Hz"
    double top = 0.0;     // where the automatic range of frequencies ends [Hz]
    // The picture that was painted last.
    QImage image;
    PlotRange x, y;
    ColourScale scale;

    double columnStart(std::size_t column) const
    {
        return start + data->firstCentre + (static_cast<double>(column) - 0.5) * data->step;
    }
};

namespace {

/// Of the samples of a quantity; on another thread.
std::shared_ptr<LiveSpectrogram::Shown> shownOf(const MinMaxPyramid& column, std::size_t length, double factor,
                                                const std::stop_token& stop)
{
    const auto read = [&](std::size_t first, std::span<double> to) {
        for (std::size_t k = 0; k < to.size(); ++k) to[k] = column.value(first + k);
        return !stop.stop_requested();
    };
    const double interval = column.time(1) - column.time(0);
    auto made = std::make_shared<const Spectrogram>(
        spectrogram(evenSamples(column, column.size()), read, interval, length, LiveSpectrogram::mostColumns));
    if (made->empty()) return nullptr;
    auto shown = std::make_shared<LiveSpectrogram::Shown>();
    shown->data = made;
    shown->start = column.firstTime();
    shown->factor = factor;
    const double most = *std::ranges::max_element(made->density);
    shown->largest = most > 0.0 ? decibels(most / factor) : 0.0;
    shown->scale =
        ColourScale::linear(ColourMap::Viridis, shown->largest - LiveSpectrogram::shownDecibels, shown->largest);
    std::size_t last = 1;
    const double least = most * std::pow(10.0, -0.1 * standsOut);
    for (std::size_t i = 0; i < made->density.size(); ++i)
        if (made->density[i] > least) last = std::max(last, i % made->frequency.size());
    shown->top = made->frequency[std::min(last + last / 8 + 1, made->frequency.size() - 1)];
    return shown;
}

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
void drawImage(LiveSpectrogram::Shown& shown, const QSize& pixels, const PlotAxis& x, const PlotAxis& y)
{
    const Spectrogram& data = *shown.data;
    const std::size_t bins = data.frequency.size();
    const double binWidth = data.frequency[1] - data.frequency[0];
    shown.image = QImage(pixels, QImage::Format_ARGB32_Premultiplied);
    shown.image.fill(Qt::transparent);
    shown.x = x.range();
    shown.y = y.range();
    std::vector<std::pair<std::size_t, std::size_t>> rows; // the frequencies of each row
    for (int row = 0; row < pixels.height(); ++row) {
        const double high = y.valueAt(1.0 - row / static_cast<double>(pixels.height()));
        const double low = y.valueAt(1.0 - (row + 1) / static_cast<double>(pixels.height()));
        rows.push_back(cellsWithin(low, high, -0.5 * binWidth, binWidth, high < 0.0 ? 0 : bins));
    }
    std::vector<double> sum(bins);
    for (int column = 0; column < pixels.width(); ++column) {
        const double left = x.valueAt(column / static_cast<double>(pixels.width()));
        const double right = x.valueAt((column + 1) / static_cast<double>(pixels.width()));
        const auto [first, end] = cellsWithin(left, right, shown.columnStart(0), data.step, data.columns);
        if (first >= end || right < shown.columnStart(0)) continue;
        std::ranges::fill(sum, 0.0);
        for (std::size_t c = first; c < end; ++c)
            for (std::size_t k = 0; k < bins; ++k) sum[k] += data.at(c, k);
        for (int row = 0; row < pixels.height(); ++row) {
            const auto [from, to] = rows[static_cast<std::size_t>(row)];
            if (from >= to) continue;
            double power = 0.0;
            for (std::size_t k = from; k < to; ++k) power += sum[k];
            power /= shown.factor * static_cast<double>((to - from) * (end - first));
            const double value = power > 0.0 ? decibels(power) : shown.scale.low();
            reinterpret_cast<QRgb*>(shown.image.scanLine(row))[column] = shown.scale.colour(value) | 0xff000000U;
        }
    }
}

/// From the left; as long as its numbers leave it room.
void paintKeyOf(const LiveSpectrogram::Shown& shown, QPainter& painter, const QRectF& row, const QFont& font,
                const PlotTheme& theme)
{
    const QFontMetricsF metrics(font);
    const QString low = typeset(shown.scale.low(), 0), high = typeset(shown.scale.high(), 0);
    const QString after = high + QChar(0x2002) + shown.unit;
    const double gap = 6.0;
    const double numbers = metrics.horizontalAdvance(low) + metrics.horizontalAdvance(after) + 2.0 * gap;
    const double length = std::clamp(row.width() - numbers, leastKey, keyLength);
    painter.setFont(font);
    painter.setPen(theme.mutedText);
    const QRectF box(row.left(), row.top(), metrics.horizontalAdvance(low), row.height());
    painter.drawText(box, Qt::AlignCenter, low);
    const QRectF bar(box.right() + gap, row.center().y() - 4.0, length, 8.0);
    for (int k = 0; k < static_cast<int>(length); ++k)
        painter.fillRect(QRectF(bar.left() + k, bar.top(), 1.5, bar.height()),
                         QColor::fromRgb(shown.scale.colourAt(k / length)));
    painter.drawText(QPointF(bar.right() + gap, row.center().y() + (metrics.ascent() - metrics.descent()) / 2.0),
                     after);
}

void writeDensities(const LiveSpectrogram::Shown& shown, QIODevice& device)
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
        if (number != source_.run) return;
        forget();
        update();
    });
}

LiveSpectrogram::~LiveSpectrogram() { stop_.request_stop(); }

/// A hidden plot gives its picture back; shown again, it gets one.
bool LiveSpectrogram::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == &plot_ && event->type() == QEvent::Show) update();
    if (watched == &plot_ && event->type() == QEvent::Hide && !plot_.isVisible()) {
        timer_.stop();
        forget();
    }
    return false;
}

void LiveSpectrogram::setQuantity(const std::string& name)
{
    quantity_ = name;
    update();
}

void LiveSpectrogram::setWindow(std::size_t samples)
{
    window_ = samples;
    update();
}

LiveSpectrogram::Source LiveSpectrogram::wanted() const
{
    const RunRecord* run = runs_.newestShown();
    const MinMaxPyramid* column = run ? run->pyramid(quantity_) : nullptr;
    return {run ? run->number : -1, quantity_, window_, column ? column->size() : 0};
}

void LiveSpectrogram::update()
{
    if (!plot_.isVisible()) return;
    const Source now = wanted();
    // While a run goes, the picture follows; another one comes at once.
    const int rest = now.isMoreOf(source_) ? std::max(refreshEach, static_cast<int>(restShare * took_)) : 0;
    if (!timer_.isActive() || timer_.remainingTime() > rest) timer_.start(rest);
}

void LiveSpectrogram::forget()
{
    stop_.request_stop();
    computing_ = false;
    source_ = {};
    shown_.reset();
    plot_.setBackdrop({});
    plot_.setToolTip({});
}

/// It is not tried again before there are other samples.
void LiveSpectrogram::fail(const QString& problem)
{
    shown_.reset();
    plot_.setBackdrop({});
    setTitle(tr(", could not be computed: %1").arg(problem));
}

void LiveSpectrogram::updateNow()
{
    timer_.stop();
    const Source now = wanted();
    if (now == source_) return;
    if (now.isMoreOf(source_) && computing_) return; // what comes next asks again
    if (!now.isMoreOf(source_)) forget();
    source_ = now;
    const RunRecord* run = runs_.find(now.run);
    const MinMaxPyramid* column = run ? run->pyramid(quantity_) : nullptr;
    if (!column || column->size() < leastSamples) return setTitle(tr(", no samples yet"));
    const std::size_t length = window_ > 0 ? window_ : spectrogramWindow(column->size());
    if (column->size() < length) return setTitle(tr(", none yet, its window has %1 samples").arg(length));
    if (!shown_) setTitle(tr(", being computed"));
    compute(*column, length);
}

void LiveSpectrogram::setTitle(const QString& remark)
{
    const RunRecord* run = runs_.find(source_.run);
    const int index = run ? findQuantity(run->quantities, quantity_) : -1;
    const QString name =
        index < 0 ? QString() : QString::fromStdString(run->quantities[static_cast<std::size_t>(index)].longName);
    plot_.setTitle(name.isEmpty() ? tr("Spectrogram")
                                  : tr("Spectrogram of run %1: %2%3").arg(QString::number(source_.run), name, remark));
}

void LiveSpectrogram::compute(const MinMaxPyramid& column, std::size_t length)
{
    struct Result {
        std::shared_ptr<Shown> shown;
        qint64 took = 0; // [ms]
    };
    const RunRecord& run = *runs_.find(source_.run);
    const Quantity quantity = run.quantities[static_cast<std::size_t>(findQuantity(run.quantities, quantity_))];
    const double factor = std::pow(unitFactor(quantity.displayUnit), 2);
    auto result = std::make_shared<Result>();
    stop_ = {};
    computing_ = true;
    queue_.post(
        [result, samples = column.twin(), length, factor, stop = stop_.get_token()] {
            QElapsedTimer clock;
            clock.start();
            result->shown = shownOf(*samples, length, factor, stop);
            result->took = clock.elapsed();
            return QString();
        },
        [this, result, quantity, end = column.lastTime(), stop = stop_.get_token()](const QString& problem) {
            if (stop.stop_requested()) return;
            computing_ = false;
            took_ = result->took;
            if (!problem.isEmpty()) return fail(problem);
            if (!result->shown) return setTitle(tr(", none"));
            show(result->shown, quantity, end);
            update(); // there may be more samples
        });
}

void LiveSpectrogram::show(const std::shared_ptr<Shown>& picture, const Quantity& quantity, double end)
{
    shown_ = picture->data;
    const QString unit = unitText(quantity.displayUnit);
    const bool simple = std::ranges::all_of(unit, [](QChar letter) { return letter.isLetter(); });
    // Not "%1²": the digit would belong to the number of the place.
    picture->unit = tr("dB re 1 %1/Hz").arg((simple ? unit : QStringLiteral("(%1)").arg(unit)) + QStringLiteral("²"));
    setTitle({});
    plot_.setToolTip(plainTip(
        tr("Resolution: %1, %2").arg(timeText(shown_->timeResolution), frequencyText(shown_->frequencyResolution))));
    PlotBackdrop backdrop;
    backdrop.x = {picture->start, std::max(picture->columnStart(shown_->columns), end)};
    backdrop.y = {0.0, picture->top};
    const char* shownUnit = backdrop.y.high >= megahertz ? "MHz" : "kHz";
    plot_.setYLabel({tr("Frequency"), QString::fromLatin1(shownUnit), unitFactor(shownUnit), AxisScale::Linear});
    backdrop.paint = [picture](QPainter& painter, const QRectF& area, const PlotAxis& x, const PlotAxis& y) {
        const double sharp = std::clamp(painter.deviceTransform().m11(), 1.0, finestPixels);
        const QSize pixels = (area.size() * sharp).toSize();
        if (picture->image.size() != pixels || picture->x != x.range() || picture->y != y.range())
            drawImage(*picture, pixels, x, y);
        painter.drawImage(area, picture->image);
    };
    backdrop.paintKey = [picture](QPainter& painter, const QRectF& row, const QFont& font, const PlotTheme& theme) {
        paintKeyOf(*picture, painter, row, font, theme);
    };
    backdrop.writeData = [picture](QIODevice& device) { writeDensities(*picture, device); };
    plot_.setBackdrop(std::move(backdrop));
}

} // namespace touchdown

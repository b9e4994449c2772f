// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/side_view.h"

#include <algorithm>
#include <cmath>

#include <QContextMenuEvent>
#include <QMenu>
#include <QPainter>
#include <QTextStream>

#include "core/formats/units.h"
#include "core/physics/disk/disk_velocity.h"
#include "ui/plot/laid_out_as.h"
#include "ui/plot/picture_menu.h"
#include "ui/plot/plot_frame.h"
#include "ui/runs/disk_profile.h"
#include "ui/runs/run_record.h"
#include "ui/runs/runs_model.h"
#include "ui/slider/slider_profile.h"
#include "ui/style/quantity_format.h"
#include "ui/style/theme.h"

namespace touchdown {

namespace {

constexpr double headRoom = 1.25;     // above the highest pad
constexpr double sideOnPaper = 480.0; // width in which the texts have room [px]

} // namespace

SideView::SideView(RunsModel& runs, QWidget* parent) : QWidget(parent), runs_(runs), disk_(new DiskProfile(this))
{
    setAccessibleName(tr("Side view of slider and disk"));
    height_.label = {tr("Height"), QStringLiteral("nm"), unitFactor("nm"), AxisScale::Linear};
    connect(disk_, &DiskProfile::made, this, qOverload<>(&QWidget::update));
    connect(&runs_, &RunsModel::aboutToRemove, this, [this](int number) {
        removed_ = number;
        if (number == first_.number) showRun(-1);
        takeOther();
    });
    connect(&runs_, &RunsModel::added, this, &SideView::takeOther);
    connect(&runs_, &RunsModel::baselineChanged, this, &SideView::takeOther);
    connect(&runs_, &RunsModel::shownChanged, this, &SideView::takeOther);
    connect(&runs_, &RunsModel::namesChanged, this, qOverload<>(&QWidget::update));
}

void SideView::showRun(int number)
{
    time_.reset();
    first_ = seenOf(number);
    height_.setRange({0.0, 1e-9});
    takeOther();
}

void SideView::dataArrived(int number)
{
    if (number != first_.number || time_) return;
    takeState();
}

void SideView::showTime(const std::optional<double>& time)
{
    time_ = time;
    takeState();
}

SideView::Seen SideView::seenOf(int number) const
{
    Seen seen;
    seen.number = number;
    const RunRecord* run = runs_.find(number);
    if (run && run->value.model == ModelKind::Film) {
        const Case& c = run->value;
        seen.length = c.slider.length;
        seen.speed =
            diskVelocity(c.disk, c.slider.length, c.slider.width, 0.5 * c.slider.length, 0.5 * c.slider.width).x;
        seen.centre = 0.5 * seen.length;
        seen.profile = SliderProfile(c).fromSide({});
    } else if (run && run->value.model == ModelKind::Springs) {
        seen.springs.emplace(run->value);
        seen.length = seen.springs->length();
        seen.centre = seen.springs->centre();
        seen.profile.assign(SliderProfile::along + 1, 0.0);
    }
    return seen;
}

/// Which run stands beside the shown one; -1: none.
int SideView::wantedOther() const
{
    const RunRecord* first = runs_.find(first_.number);
    const auto fits = [&](const RunRecord& run) {
        return first && run.number != first->number && run.number != removed_ && run.value.model == first->value.model;
    };
    if (const RunRecord* baseline = runs_.find(runs_.baseline()); baseline && fits(*baseline)) return baseline->number;
    for (int row = runs_.count() - 1; row >= 0; --row)
        if (runs_.record(row).shown && fits(runs_.record(row))) return runs_.record(row).number;
    return -1;
}

/// A hidden view needs neither a second run nor the surface of the disk.
void SideView::takeOther()
{
    if (isVisible()) {
        if (const int wanted = wantedOther(); wanted != second_.number) second_ = seenOf(wanted);
        const RunRecord* run = runs_.find(first_.number);
        disk_->setCase(run && run->value.model == ModelKind::Film ? std::optional(run->value) : std::nullopt);
    } else {
        second_ = {};
    }
    takeState();
}

void SideView::takeState()
{
    first_.state = stateOf(first_, time_);
    second_.state = first_.state ? stateOf(second_, first_.state->time) : std::nullopt;
    if (second_.state && second_.state->time != first_.state->time) second_.state.reset(); // it has no sample there
    // One scale for both and for the whole run, so that movement is seen: it grows when it must.
    for (const Seen* seen : {&first_, &second_}) {
        if (!seen->state) continue;
        const double top = headRoom * std::max(seen->heightAt(0.0) - seen->profile.front(),
                                               seen->heightAt(1.0) - seen->profile.back());
        if (top > height_.range().high) height_.setRange({-ProfileDrawing::belowDisk * 1.2 * top, 1.2 * top});
    }
    update();
}

std::optional<SideView::State> SideView::stateOf(const Seen& seen, const std::optional<double>& time) const
{
    const RunRecord* run = runs_.find(seen.number);
    const MinMaxPyramid* height = run ? run->pyramid("height") : nullptr;
    if (seen.profile.empty() || !height || height->empty()) return std::nullopt;
    State state;
    state.time = std::clamp(time.value_or(height->lastTime()), height->time(0), height->lastTime());
    const auto at = [&](const char* quantity) {
        const MinMaxPyramid* column = run->pyramid(quantity);
        return column ? column->valueAt(state.time).value_or(0.0) : 0.0;
    };
    state.pitch = at("pitch");
    state.trailingHeight = at("height") - (seen.length - seen.centre) * state.pitch;
    state.separation = at("flying_height");
    state.spacing = at("minimum_spacing");
    state.contactForce = at("contact_force");
    state.disk = {at("front_disk_height"), at("rear_disk_height"), at("disk_height")};
    return state;
}

std::optional<PlotRange> SideView::span() const
{
    const RunRecord* run = runs_.find(first_.number);
    const MinMaxPyramid* height = run && !first_.profile.empty() ? run->pyramid("height") : nullptr;
    if (!height || height->empty()) return std::nullopt;
    return PlotRange{height->time(0), height->lastTime()};
}

double SideView::Seen::heightAt(double share) const
{
    const auto column = static_cast<std::size_t>(std::lround(share * SliderProfile::along));
    return state->trailingHeight + state->pitch * length * (1.0 - share) + profile[column];
}

std::vector<double> SideView::Seen::heights() const
{
    std::vector<double> heights;
    for (int i = 0; i <= SliderProfile::along; ++i)
        heights.push_back(heightAt(static_cast<double>(i) / SliderProfile::along));
    return heights;
}

QRectF SideView::plotArea() const
{
    const double line = fontMetrics().height();
    return QRectF(rect()).adjusted(5.0 * line, 2.7 * line, -1.5 * line, -2.6 * line);
}

ProfileDrawing SideView::drawing() const { return {plotArea(), first_.length, height_.range()}; }

double SideView::exaggeration() const { return drawing().exaggeration(); }

void SideView::contextMenuEvent(QContextMenuEvent* event)
{
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    addPictureActions(*menu, *this);
    menu->popup(event->globalPos());
}

void SideView::writeProfile(QIODevice& device) const
{
    QTextStream out(&device);
    const auto number = [](double value) { return QString::fromStdString(formatNumber(value)); };
    out << "x [m],height of the slider above the mean plane of the disk [m]\n";
    for (int i = 0; i <= SliderProfile::along; ++i) {
        const double share = static_cast<double>(i) / SliderProfile::along;
        out << number(share * first_.length) << ',' << number(heightAt(share)) << '\n';
    }
}

void SideView::paintInto(QPainter& painter, const QRectF& target, const PlotTheme& theme)
{
    painter.save();
    painter.translate(target.topLeft());
    painter.scale(target.width() / width(), target.height() / height());
    painter.setFont(plotTextFont(font()));
    paint(painter, theme);
    painter.restore();
}

void SideView::paintOnPaper(QPainter& painter, const QSizeF& size, const QFont& font, PaperColours colours)
{
    const double wider = widening(size.width(), sideOnPaper);
    const LaidOutAs laidOut(*this, wider * size, font);
    painter.save();
    painter.scale(1.0 / wider, 1.0 / wider);
    painter.setFont(font);
    paint(painter, paperTheme(colours));
    painter.restore();
}

double SideView::heightOnPaper(double width, const QFont& /*font*/) const { return 0.6 * width; }

std::function<void(QIODevice&)> SideView::dataWriter() const
{
    if (!first_.state) return {};
    return [this](QIODevice& device) { writeProfile(device); };
}

void SideView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    paint(painter, plotTheme(palette()));
}

void SideView::paint(QPainter& painter, const PlotTheme& theme) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), theme.background);
    if (!first_.state) {
        painter.setPen(theme.mutedText);
        painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap,
                         first_.number < 0 ? tr("There is nothing to show yet: run the case.")
                                           : tr("The first samples are not ready yet."));
        return;
    }
    painter.fillRect(plotArea(), theme.plotArea);
    painter.save();
    painter.setClipRect(plotArea());
    const State& state = *first_.state;
    if (disk_->empty())
        drawing().paintDisk(painter, theme);
    else
        drawing().paintDisk(painter, theme, disk_->at(state.time));
    if (!first_.springs) drawing().paintMotion(painter, theme, first_.speed * state.time);
    paintSlider(painter, theme);
    paintOther(painter, theme);
    if (first_.springs) {
        first_.springs->paintSprings(painter, theme, drawing(), heightAt(0.0), heightAt(1.0), state.disk);
        first_.springs->paintPad(painter, theme, plotArea(), state.separation, state.contactForce > 0.0);
    }
    painter.restore();
    paintAxes(painter, theme);
    paintReadings(painter, theme);
}

void SideView::paintSlider(QPainter& painter, const PlotTheme& theme) const
{
    const ProfileDrawing drawn = drawing();
    const std::vector<double> heights = first_.heights();
    drawn.paintSlider(painter, theme, heights);
    if (first_.springs) return; // their pad has a picture of its own

    const auto lowestAt = std::ranges::min_element(heights) - heights.begin();
    const double lowest = static_cast<double>(lowestAt) / SliderProfile::along;
    const QPointF tip = drawn.toPixel(lowest * first_.length, heightAt(lowest));
    const QPointF foot = drawn.toPixel(lowest * first_.length, 0.0);
    const QColor mark = first_.state->contactForce > 0.0 ? theme.curves[1] : theme.text;
    painter.setPen(QPen(mark, 2.0));
    painter.drawLine(tip, foot);
    painter.setBrush(mark);
    painter.drawEllipse(foot, 3.5, 3.5);
}

/// The second run, with its name and its spacing.
void SideView::paintOther(QPainter& painter, const PlotTheme& theme) const
{
    const RunRecord* run = runs_.find(second_.number);
    if (!run || !second_.state) return;
    const QColor colour = theme.paleColour(RunsModel::style(*run));
    drawing().paintOutline(painter, colour, second_.length, second_.heights());
    const double line = painter.fontMetrics().height();
    const QString text = tr("%1: minimum spacing %2")
                             .arg(run->label, readout(second_.state->spacing, "nm", 3))
                             .replace(QLatin1Char('-'), QChar(0x2212));
    const QRectF box(plotArea().topLeft() + QPointF(6.0, 6.0),
                     QSizeF(painter.fontMetrics().horizontalAdvance(text) + 30.0, line + 2.0));
    QColor paper = theme.plotArea;
    paper.setAlphaF(0.75F);
    painter.fillRect(box, paper);
    painter.drawLine(QPointF(box.left() + 2.0, box.center().y()), QPointF(box.left() + 20.0, box.center().y()));
    painter.setPen(theme.mutedText);
    painter.drawText(box.adjusted(26.0, 0.0, 0.0, 0.0), Qt::AlignLeft | Qt::AlignVCenter, text);
}

void SideView::paintAxes(QPainter& painter, const PlotTheme& theme) const
{
    const QRectF area = plotArea();
    const double line = fontMetrics().height();
    drawing().paintFrame(painter, theme, tr("Along the slider"),
                         first_.springs ? tr(", the leading edge at the left")
                                        : tr(", the disk moves from left to right"));
    painter.setPen(theme.text);
    for (const AxisTick& tick : height_.ticks(7)) {
        const double y = drawing().toPixel(0.0, tick.value).y();
        if (!tick.text.isEmpty())
            painter.drawText(QRectF(0.0, y - line / 2, area.left() - 6.0, line), Qt::AlignRight | Qt::AlignVCenter,
                             tick.text);
    }
    painter.drawText(QRectF(0.3 * line, area.top() - 1.4 * line, area.left() + 8.0 * line, line),
                     Qt::AlignLeft | Qt::AlignVCenter, height_.text());
}

void SideView::paintReadings(QPainter& painter, const PlotTheme& theme) const
{
    const QRectF area = plotArea();
    const State& state = *first_.state;
    const QStringList attitude{timeText(state.time), tr("minimum spacing %1").arg(readout(state.spacing, "nm", 3)),
                               tr("pitch %1").arg(readout(state.pitch, "urad", 2))};
    QStringList rest{tr("heights × %L1").arg(std::round(exaggeration()), 0, 'f', 0)};
    if (state.contactForce > 0.0) rest.prepend(tr("contact %1").arg(forceText(state.contactForce)));
    painter.setPen(theme.text);
    const double line = fontMetrics().height();
    double top = 0.2 * line;
    for (const QStringList& parts : {attitude, rest}) {
        painter.drawText(QRectF(0.0, top, area.right(), line), Qt::AlignRight | Qt::AlignVCenter,
                         parts.join(QStringLiteral("   ·   ")).replace(QLatin1Char('-'), QChar(0x2212)));
        top += line;
    }
}

void SideView::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    takeOther();
}

void SideView::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) update();
}

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/side_view.h"

#include <algorithm>
#include <cmath>

#include <QTextStream>

#include "core/formats/units.h"
#include "core/physics/disk/disk_velocity.h"
#include "ui/runs/disk_profile.h"
#include "ui/runs/run_record.h"
#include "ui/runs/runs_model.h"
#include "ui/slider/slider_profile.h"
#include "ui/style/quantity_format.h"
#include "ui/style/theme.h"

namespace touchdown {

namespace {

constexpr double headRoom = 1.25; // above the highest pad
constexpr double padShare = 0.3;  // of the width, for the pad near the disk

} // namespace

SideView::SideView(RunsModel& runs, QWidget* parent)
    : PictureWidget(parent, 480.0), runs_(runs), disk_(new DiskProfile(this))
{
    setAccessibleName(tr("Side view of slider and disk"));
    height_.label = {tr("Height"), QStringLiteral("nm"), unitFactor("nm"), AxisScale::Linear};
    connect(disk_, &DiskProfile::made, this, qOverload<>(&QWidget::update));
    connect(&runs_, &RunsModel::aboutToRemove, this, [this](int number) {
        if (number == first_.number) showRun(-1);
        takeOther(number);
    });
    for (const auto changed : {&RunsModel::added, &RunsModel::baselineChanged})
        connect(&runs_, changed, this, [this] { takeOther(); });
    connect(&runs_, &RunsModel::shownChanged, this, [this] { takeOther(); });
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

/// Which run stands beside the shown one; -1: none. `except`: a run that is about to go.
int SideView::wantedOther(int except) const
{
    const RunRecord* first = runs_.find(first_.number);
    const auto fits = [&](const RunRecord& run) {
        return first && run.number != first->number && run.number != except && run.value.model == first->value.model;
    };
    if (const RunRecord* baseline = runs_.find(runs_.baseline()); baseline && fits(*baseline)) return baseline->number;
    for (int row = runs_.count() - 1; row >= 0; --row)
        if (runs_.record(row).shown && fits(runs_.record(row))) return runs_.record(row).number;
    return -1;
}

/// A hidden view needs neither a second run nor the surface of the disk.
void SideView::takeOther(int except)
{
    if (isVisible()) {
        if (const int wanted = wantedOther(except); wanted != second_.number) second_ = seenOf(wanted);
        const RunRecord* run = runs_.find(first_.number);
        disk_->setCase(run && run->value.model == ModelKind::Film ? std::optional(run->value) : std::nullopt);
    } else {
        second_ = {};
        disk_->setCase(std::nullopt);
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
    state.aboveDisk = run->pyramid("minimum_gap") != nullptr;
    state.spacing = at(state.aboveDisk ? "minimum_gap" : "minimum_spacing");
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
    const QRectF whole = QRectF(rect()).adjusted(5.0 * line, 2.7 * line, -1.5 * line, -2.6 * line);
    const double pad = first_.springs && first_.springs->padReach() > 0.0 ? padShare * whole.width() + line : 0.0;
    return whole.adjusted(0.0, 0.0, -pad, 0.0);
}

/// Beside the slider, which it would hide.
QRectF SideView::padArea() const
{
    const double line = fontMetrics().height();
    const QRectF area = plotArea();
    return {area.right() + line, area.top(), width() - area.right() - 2.5 * line, area.height()};
}

ProfileDrawing SideView::drawing() const { return {plotArea(), first_.length, height_.range()}; }

double SideView::exaggeration() const { return drawing().exaggeration(); }

void SideView::writeProfile(QIODevice& device) const
{
    QTextStream out(&device);
    const auto number = [](double value) { return QString::fromStdString(formatNumber(value)); };
    const double time = first_.state->time;
    const bool disk = disk_->state() == DiskProfile::State::Uneven || disk_->state() == DiskProfile::State::Flat;
    // Heights above the mean plane of the disk. Under springs it has heights at three places only.
    out << "x at " << number(time) << " s [m],height of the slider of run " << first_.number << " [m]";
    if (!first_.springs) out << ",height of the disk [m]";
    if (second_.state) out << ",height of the slider of run " << second_.number << " [m]";
    out << '\n';
    for (int i = 0; i <= SliderProfile::along; ++i) {
        const double share = static_cast<double>(i) / SliderProfile::along;
        const double x = share * first_.length;
        out << number(x) << ',' << number(heightAt(share));
        if (!first_.springs) out << ',' << (disk ? number(disk_->heightAt(x, time)) : QString());
        if (second_.state)
            out << ',' << (x <= second_.length ? number(second_.heightAt(x / second_.length)) : QString());
        out << '\n';
    }
}

std::function<void(QIODevice&)> SideView::dataWriter() const
{
    if (!first_.state) return {};
    return [this](QIODevice& device) { writeProfile(device); };
}

void SideView::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    takeOther();
}

void SideView::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    takeOther();
}

} // namespace touchdown

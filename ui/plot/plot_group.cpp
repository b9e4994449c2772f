// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_group.h"

#include <algorithm>

#include <QMenu>

#include "ui/plot/picture_widget.h"
#include "ui/plot/plot_export.h"

namespace touchdown {

namespace {

constexpr std::size_t longestHistory = 200;

/// Steps of one wheel in one direction, of one drag, of one key held: one step back undoes them all.
bool isOneOfMany(PlotWidget::Gesture gesture)
{
    return gesture != PlotWidget::Gesture::Box && gesture != PlotWidget::Gesture::Fit;
}

void addCheckable(QMenu* menu, const QString& text, bool checked, PlotWidget* plot,
                  const std::function<void(bool)>& toggled, const QKeySequence& shortcut = {})
{
    QAction* action = menu->addAction(text);
    action->setCheckable(true);
    action->setChecked(checked);
    action->setShortcut(shortcut);
    QObject::connect(action, &QAction::toggled, plot, toggled);
}

void openMenu(PlotWidget* plot, PlotGroup* group, const QPoint& at)
{
    const auto tr = [](const char* text) { return PlotGroup::tr(text); };
    auto* menu = new QMenu(plot);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("&Fit all"), QKeySequence(Qt::Key_Home), group, &PlotGroup::fit);
    menu->addAction(tr("&Back"), QKeySequence(Qt::ALT | Qt::Key_Left), group, &PlotGroup::goBack)
        ->setEnabled(group->canGoBack());
    menu->addAction(tr("F&orward"), QKeySequence(Qt::ALT | Qt::Key_Right), group, &PlotGroup::goForward)
        ->setEnabled(group->canGoForward());
    menu->addSeparator();

    addCheckable(menu, tr("&Height follows the data"), !plot->view().y, plot, [plot](bool follows) {
        plot->setView({plot->view().x, follows ? std::nullopt : std::optional(plot->yAxis().range())});
    });
    addCheckable(
        menu, tr("&Logarithmic height"), plot->yAxis().logarithmic(), plot,
        [plot](bool on) { plot->setYScale(on ? AxisScale::Logarithmic : AxisScale::Linear); }, Qt::Key_L);
    if (plot->curves().size() > 1) {
        QMenu* curves = menu->addMenu(tr("C&urves"));
        for (const PlotCurve& curve : plot->curves())
            addCheckable(curves, curve.name.isEmpty() ? plot->title() : curve.name, curve.visible, plot,
                         [plot, id = curve.id](bool visible) { plot->setCurveVisible(id, visible); });
    }
    if (!plot->actions().isEmpty()) menu->addSeparator();
    menu->addActions(plot->actions());
    menu->addSeparator();

    addPictureActions(*menu, *plot);
    menu->popup(at);
}

} // namespace

PlotGroup::PlotGroup(QObject* parent, Across across) : QObject(parent), across_(across), history_{state()} {}

void PlotGroup::add(PlotWidget* plot)
{
    if (std::ranges::find(plots_, plot) != plots_.end()) return;
    plots_.push_back(plot);
    connect(plot, &QObject::destroyed, this, [this, plot] { std::erase(plots_, plot); });
    connect(plot, &PlotWidget::labelsChanged, this, &PlotGroup::shareLabelWidth);
    connect(plot, &PlotWidget::viewChanged, this,
            [this, plot](const PlotView& view, PlotWidget::Gesture gesture) { onViewChanged(plot, view, gesture); });
    connect(plot, &PlotWidget::historyRequested, this,
            [this](int direction) { direction < 0 ? goBack() : goForward(); });
    connect(plot, &PlotWidget::cursorMoved, this,
            [this](int which, bool valid, double x) { setCursor(which, valid ? std::optional(x) : std::nullopt); });
    connect(plot, &PlotWidget::cursorPinnedChanged, this, [this](bool pinned) {
        for (PlotWidget* other : plots_) other->setCursorPinned(pinned);
    });
    connect(plot, &PlotWidget::menuRequested, this, [this, plot](const QPoint& at) { openMenu(plot, this, at); });
    for (const int which : {0, 1}) plot->setPlotCursor(which, cursor(which));
    plot->setCursorPinned(plots_.front()->cursorPinned());
    plot->setCursorsSnap(across_ == Across::Frequency);
    plot->setEverything(everything_);
    if (follow_ == Follow::Frozen)
        showX(xRange_);
    else
        followData();
    // The present step now holds the new plot too, so that one step back also restores its height.
    history_[position_] = state();
    shareLabelWidth();
}

void PlotGroup::remove(PlotWidget* plot)
{
    if (std::erase(plots_, plot) == 0) return;
    plot->disconnect(this);
    plot->setLeastLabelWidth(0.0);
    shareLabelWidth();
}

void PlotGroup::shareLabelWidth()
{
    double widest = 0.0;
    for (const PlotWidget* plot : plots_)
        if (!plot->isPhasePortrait() && !plot->isHidden())
            widest = std::max(widest, plot->labelRoom(plot->font()).width);
    for (PlotWidget* plot : plots_) plot->setLeastLabelWidth(plot->isPhasePortrait() ? 0.0 : widest);
}

void PlotGroup::dataChanged()
{
    followData();
    for (PlotWidget* plot : plots_) plot->dataChanged();
}

void PlotGroup::followData()
{
    if (follow_ == Follow::Frozen) return;
    std::optional<PlotRange> range;
    for (const PlotWidget* plot : plots_) {
        const auto data = plot->isPhasePortrait() ? std::nullopt : plot->dataRangeX();
        if (!data) continue;
        range = range ? PlotRange{std::min(range->low, data->low), std::max(range->high, data->high)} : *data;
    }
    // Before the data reach the range that is wanted at first, all of them are shown.
    const bool reached = !range || range->high > (firstRange_ ? firstRange_->low : 0.0);
    if (firstRange_ && !everything_ && reached) range = firstRange_;
    if (!range || !(range->width() > 0.0)) {
        for (PlotWidget* plot : plots_) {
            if (plot->isPhasePortrait()) continue;
            plot->setView({std::nullopt, plot->view().y});
            xRange_ = plot->xAxis().range(); // what an empty plot shows, in case it is frozen now
        }
        return;
    }
    showX(*range);
}

void PlotGroup::showX(const PlotRange& range)
{
    xRange_ = range;
    for (PlotWidget* plot : plots_) {
        if (plot->isPhasePortrait())
            plot->setTimeWindow(range);
        else if (const PlotView view{range, plot->view().y}; view != plot->view())
            plot->setView(view);
    }
}

void PlotGroup::changeFollow(Follow follow)
{
    if (follow_ == follow) return;
    follow_ = follow;
    emit followChanged(follow);
}

void PlotGroup::setFollow(Follow follow)
{
    changeFollow(follow);
    followData();
    record(std::nullopt, nullptr);
}

void PlotGroup::fit()
{
    for (PlotWidget* plot : plots_)
        plot->setView({plot->isPhasePortrait() ? std::nullopt : plot->view().x, std::nullopt});
    changeFollow(Follow::WholeRun);
    showEverything(true);
    firstRange_.reset();
    followData();
    record(std::nullopt, nullptr);
}

void PlotGroup::followNewest()
{
    showEverything(false);
    followData();
    history_[position_] = state();
}

std::optional<PlotRange> PlotGroup::fixedRange() const
{
    if (follow_ == Follow::Frozen) return xRange_;
    return everything_ ? std::nullopt : firstRange_;
}

void PlotGroup::setFirstRange(std::optional<PlotRange> range)
{
    if (firstRange_ == range) return;
    firstRange_ = range;
    followData();
    history_[position_] = state();
}

void PlotGroup::showEverything(bool everything)
{
    everything_ = everything;
    for (PlotWidget* plot : plots_) plot->setEverything(everything);
}

void PlotGroup::onViewChanged(PlotWidget* plot, const PlotView& view, PlotWidget::Gesture gesture)
{
    if (!plot->isPhasePortrait()) {
        if (!view.x) {
            showEverything(true);
            firstRange_.reset();
            changeFollow(Follow::WholeRun);
            followData();
        } else if (*view.x != xRange_) {
            changeFollow(Follow::Frozen);
            showX(*view.x);
        }
    }
    record(gesture, plot);
}

PlotGroup::State PlotGroup::state() const
{
    State now{follow_, everything_, firstRange_, follow_ == Follow::Frozen ? std::optional(xRange_) : std::nullopt, {}};
    for (const PlotWidget* plot : plots_)
        now.views.emplace_back(plot, PlotView{plot->isPhasePortrait() ? plot->view().x : std::nullopt, plot->view().y});
    return now;
}

void PlotGroup::record(std::optional<PlotWidget::Gesture> gesture, const PlotWidget* plot)
{
    const State now = state();
    const bool continues =
        gesture && gesture == lastGesture_ && plot == lastPlot_ && isOneOfMany(*gesture) && position_ > 0;
    lastGesture_ = gesture;
    lastPlot_ = plot;
    if (now == history_[position_]) return;
    history_.resize(position_ + 1);
    if (continues) {
        history_[position_] = now;
    } else {
        history_.push_back(now);
        if (history_.size() > longestHistory) history_.erase(history_.begin());
        position_ = history_.size() - 1;
    }
    emit historyChanged();
}

void PlotGroup::show(const State& state)
{
    for (PlotWidget* plot : plots_) {
        const auto same = std::ranges::find(state.views, plot, &decltype(State::views)::value_type::first);
        if (same == state.views.end()) continue; // came later
        plot->setView({plot->isPhasePortrait() ? same->second.x : plot->view().x, same->second.y});
    }
    changeFollow(state.follow);
    showEverything(state.everything);
    firstRange_ = state.first;
    if (state.x)
        showX(*state.x);
    else
        followData();
}

void PlotGroup::step(std::size_t position)
{
    position_ = position;
    lastGesture_.reset();
    show(history_[position_]);
    emit historyChanged();
}

void PlotGroup::goBack()
{
    if (canGoBack()) step(position_ - 1);
}

void PlotGroup::goForward()
{
    if (canGoForward()) step(position_ + 1);
}

void PlotGroup::forgetHistory()
{
    history_ = {state()};
    position_ = 0;
    lastGesture_.reset();
    emit historyChanged();
}

void PlotGroup::setCursor(int which, std::optional<double> at)
{
    cursors_[static_cast<std::size_t>(which)] = at;
    for (PlotWidget* plot : plots_) plot->setPlotCursor(which, at);
    emit cursorMoved(which);
}

std::optional<double> PlotGroup::valueAt(const PlotCurve& curve, int which) const
{
    const auto at = cursor(which);
    const auto between = at ? curve.data->valueAt(*at) : std::nullopt;
    if (!between || across_ == Across::Time) return between;
    return curve.data->value(curve.data->nearest(*at));
}

std::vector<CursorReading> PlotGroup::readings() const
{
    std::vector<CursorReading> readings;
    for (const PlotWidget* plot : plots_) {
        if (plot->isPhasePortrait()) continue;
        std::vector<CursorReading> own;
        for (const PlotCurve& curve : plot->curves()) {
            if (!curve.visible || curve.data == nullptr) continue;
            CursorReading& reading = own.emplace_back();
            reading = {
                plot, curve.id, {}, {}, {}, curve.run, curve.style, curve.pale, valueAt(curve, 0), valueAt(curve, 1)};
            const QString& title = plot->title();
            const bool same = curve.name.isEmpty() || curve.name == title;
            const bool alone = title.isEmpty() || across_ == Across::Frequency;
            reading.name = same ? title : alone ? curve.name : tr("%1: %2").arg(title, curve.name);
            reading.entry = same ? title : curve.run > 0 ? curve.runName : curve.name;
            if (!same && !alone)
                reading.heading =
                    curve.run == 0 || curve.legend.isEmpty() ? title : tr("%1: %2").arg(title, curve.legend);
        }
        // The headings in the order of their first curves.
        while (!own.empty()) {
            const QString heading = own.front().heading;
            const auto rest = std::stable_partition(
                own.begin(), own.end(), [&heading](const CursorReading& each) { return each.heading == heading; });
            std::stable_sort(own.begin(), rest,
                             [](const CursorReading& a, const CursorReading& b) { return a.run > b.run; });
            readings.insert(readings.end(), own.begin(), rest);
            own.erase(own.begin(), rest);
        }
    }
    return readings;
}

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guides/small_motions_strip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <variant>

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "core/case/parameters.h"
#include "core/case_files/case_text.h"
#include "core/formats/units.h"
#include "core/simulation/static_state/static_solution.h"
#include "ui/case/case_edits.h"
#include "ui/case/case_files.h"
#include "ui/guides/live_runs.h"
#include "ui/guides/live_values.h"
#include "ui/runs/run_record.h"
#include "ui/runs/run_window.h"
#include "ui/style/foreign_text.h"
#include "ui/style/quantity_format.h"
#include "ui/workbench/workbench.h"

namespace touchdown {

namespace {

/// A value that is worth moving: how far, where its own value is smaller.
struct Movable {
    const char* key;
    double atLeast; // [unit of the parameter]
};
constexpr std::array movables{
    Movable{"initial.height_offset", 0.1e-9},
    Movable{"disk.surface.wave_amplitudes", 0.05e-9},
    Movable{"ono_yamane.meniscus_force", 1e-3},
    Movable{"ono_yamane.friction", 0.5},
    Movable{"asperity.friction", 0.5},
    Movable{"meniscus.surface_tension", 0.02},
    Movable{"adhesion.surface_energy", 0.02},
    Movable{"suspension.damping", 0.02},
    Movable{"slider.mass", 1e-7},
};
constexpr double times = 3.0;   // of its own value, to which it moves [-]
constexpr std::size_t most = 6; // sliders

/// The same slider, let go near its static state.
Case startedNearby(Case c)
{
    constexpr double near = 0.1e-9; // of the corners [m]
    InitialCase& start = c.initial;
    const bool far = start.state != InitialState::Static || std::abs(start.heightOffset) > near ||
                     std::abs(start.pitchOffset) * 0.5 * c.slider.length > near ||
                     std::abs(start.rollOffset) * 0.5 * c.slider.width > near || start.verticalVelocity != 0.0 ||
                     start.pitchVelocity != 0.0 || start.rollVelocity != 0.0;
    if (!far) return c;
    start.state = InitialState::Static;
    start.heightOffset = near;
    start.pitchOffset = start.rollOffset = 0.0;
    start.verticalVelocity = start.pitchVelocity = start.rollVelocity = 0.0;
    return c;
}

/// A list of several numbers has no slider.
bool isOneNumber(const Parameter& parameter, const Case& c)
{
    return parameter.kind != ParameterKind::List || std::get<std::vector<double>>(parameter.get(c)).size() == 1;
}

std::vector<std::string> keysOf(const std::vector<LiveValue>& values)
{
    std::vector<std::string> keys;
    for (const LiveValue& value : values) keys.push_back(value.keys.front());
    return keys;
}

} // namespace

std::vector<LiveValue> valuesOfSmallMotions(const Case& c)
{
    std::vector<LiveValue> values;
    for (const Movable& movable : movables) {
        const Parameter& parameter = *findParameter(movable.key);
        const double own = numberOf(parameter, c);
        if (!parameter.used(c) || !isOneNumber(parameter, c) || !(own >= 0.0) || values.size() == most) continue;
        LiveValue value{{movable.key}, 0.0, std::min(std::max(times * own, movable.atLeast), parameter.maximum)};
        Case least = c;
        setFromNumber(least, parameter, 0.0);
        if (numberOf(parameter, least) != 0.0 || !checkCombinations(least).empty()) value.from = own / times;
        if (value.until > value.from) values.push_back(std::move(value));
    }
    return values;
}

SmallMotionsStrip::SmallMotionsStrip(Workbench& bench, LiveRuns& live, QAction& action, const QWidget& guide)
    : QWidget(guide.parentWidget()),
      bench_(bench),
      live_(live),
      action_(action),
      guide_(guide),
      text_(new QLabel(this)),
      values_(new LiveValues(this, Qt::Horizontal)),
      full_(new QPushButton(tr("Repeat with the full film"), this))
{
    text_->setWordWrap(true);
    text_->setTextFormat(Qt::PlainText);
    text_->setAccessibleName(tr("Film, small motions"));
    full_->setToolTip(tr("Runs the same case with the film solved in each step; both runs are shown"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 8, 12, 8);
    auto* head = new QHBoxLayout;
    head->addWidget(text_, 1);
    head->addWidget(full_);
    column->addLayout(head);
    column->addWidget(values_);
    connect(values_, &LiveValues::moved, &live_, &LiveRuns::move);
    connect(values_, &LiveValues::settled, &live_, &LiveRuns::settle);
    connect(full_, &QPushButton::clicked, this, &SmallMotionsStrip::repeatInFull);
    connect(&live_, &LiveRuns::busyChanged, this, &SmallMotionsStrip::showState);
    connect(&action_, &QAction::triggered, this, &SmallMotionsStrip::makeLinear);
    connect(&live_, &LiveRuns::shown, this, &SmallMotionsStrip::showState);
    connect(&bench_.files(), &CaseFiles::opened, this, [this] {
        linear_ = false;
        takeCase();
    });
    connect(&bench_.edits(), &CaseEdits::edited, this, &SmallMotionsStrip::takeCase);
    connect(&bench_.runWindow(), &RunWindow::started, this, &SmallMotionsStrip::showState);
    connect(&bench_.runWindow(), &RunWindow::ended, this, &SmallMotionsStrip::showState);
    connect(&bench_.runWindow().runs(), &RunsModel::rowsRemoved, this, &SmallMotionsStrip::showState);
    takeCase();
}

void SmallMotionsStrip::makeLinear(bool on)
{
    CaseEdits& edits = bench_.edits();
    if (isLinearFilm(edits.value()) == on) return;
    Case changed = on ? startedNearby(edits.value()) : edits.value();
    changed.film.motion = on ? FilmMotion::Linear : FilmMotion::Full;
    edits.setAll(changed, on ? tr("film, small motions") : tr("full film"));
    if (!on) return;
    bench_.setPage(Workbench::Page::Run);
    if (edits.reasonNotToRun().isEmpty()) bench_.startRun(); // which finds the film's answer
}

/// New sliders where the case was opened, its film has become linear, or it uses other values: those that it has then
/// have the marks.
void SmallMotionsStrip::takeCase()
{
    const Case& c = bench_.edits().value();
    const bool was = std::exchange(linear_, isLinearFilm(c));
    if (linear_) {
        const std::vector<LiveValue> values = valuesOfSmallMotions(c);
        if (!was || keysOf(values) != keys_) {
            keys_ = keysOf(values);
            values_->setValues(values, c);
        }
    }
    values_->showCase(c);
    showState();
}

/// Of the case in the window, whatever values were moved.
const RunRecord* SmallMotionsStrip::newest() const
{
    const RunsModel& runs = bench_.runWindow().runs();
    const Case& now = bench_.edits().value();
    for (int row = runs.count() - 1; row >= 0; --row)
        if (const RunRecord& run = runs.record(row);
            run.finished() && isLinearFilm(run.value) && (run.value == now || sameFilmApart(run.value, now)))
            return &run;
    return nullptr;
}

void SmallMotionsStrip::showState()
{
    action_.setChecked(linear_);
    setVisible(linear_ && bench_.shownPage() == Workbench::Page::Run && guide_.isHidden());
    const RunRecord* run = newest();
    const auto figure = [&](std::string_view wanted) {
        if (run)
            for (const RunFigure& each : run->summary->figures)
                if (each.quantity.name == wanted) return QString::fromStdString(percent(each.value));
        return QString();
    };
    const QString ofMotion = figure("film_linearity_error"), ofFit = figure("film_fit_error");
    if (live_.finds())
        text_->setText(tr("Film, small motions: finding the static state of these values, and the film's answer…"));
    else if (ofMotion.isEmpty())
        text_->setText(tr("Film, small motions: the film is linear about the static state. The first run finds that "
                          "state and the film's answer, which takes some seconds; then the runs follow the sliders."));
    else if (run->summary->status != RunStatus::Completed)
        text_->setText(tr("Film, small motions: run %1 did not come to its end. Its message says why; the motion must "
                          "be small against the spacing.")
                           .arg(run->number));
    else if (!run->note.isEmpty() && run->ofGuide)
        text_->setText(tr("Film, small motions: a preview, with the film linear about the static state of other "
                          "values. Let go, and the state of these values is found."));
    else
        text_->setText(tr("Film, small motions: in run %1 the linear film errs by about %2 of the motion, its fit by "
                          "%3 of the film's answer.")
                           .arg(run->number)
                           .arg(ofMotion, ofFit));
    full_->setEnabled(run && !bench_.runWindow().runUnderWay());
}

void SmallMotionsStrip::repeatInFull()
{
    const RunRecord* run = newest();
    if (!run) return;
    Case full = run->value;
    full.film.motion = FilmMotion::Full;
    const std::string& text = run->caseText; // none while its value is moved
    bench_.runWindow().start({full, updateCaseText(text.empty() ? bench_.files().wholeText() : text, full), {}});
}

} // namespace touchdown

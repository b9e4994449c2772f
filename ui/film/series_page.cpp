// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/series_page.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include <QHeaderView>

#include "core/case/parameters.h"
#include "core/formats/units.h"
#include "core/simulation/static_state/static_solution.h"
#include "core/simulation/static_state/steady_quantities.h"
#include "ui/film/series_setup.h"
#include "ui/style/loss_question.h"
#include "ui/style/quantity_format.h"
#include "ui/style/window_words.h"

namespace touchdown {

namespace {

/// Name and decimals of the columns that show numbers of a state.
struct NumberColumn {
    const char* quantity; // of steadyQuantities
    const char* head;
    int decimals;
};
constexpr std::array numberColumns{
    NumberColumn{"minimum_spacing", QT_TRANSLATE_NOOP("SeriesPage", "Minimum spacing"), 3},
    NumberColumn{"minimum_spacing_error", QT_TRANSLATE_NOOP("SeriesPage", "±"), 3},
    NumberColumn{"nominal_trailing_edge_height", QT_TRANSLATE_NOOP("SeriesPage", "Nominal trailing edge height"), 3},
    NumberColumn{"pitch", QT_TRANSLATE_NOOP("SeriesPage", "Pitch"), 2},
    NumberColumn{"roll", QT_TRANSLATE_NOOP("SeriesPage", "Roll"), 2},
    NumberColumn{"net_force", QT_TRANSLATE_NOOP("SeriesPage", "Net force"), 4}};

bool isKnown(const SeriesState& state) { return state.result.status == SteadyStatus::Converged; }

const SteadyQuantity& called(const std::vector<SteadyQuantity>& all, const char* name)
{
    return *std::ranges::find(all, name, [](const SteadyQuantity& each) { return each.quantity.name; });
}

/// What sets the points apart, each with its short name for a column; the radius where nothing does.
std::vector<std::pair<Varied, QString>> variedColumns(const std::vector<SteadySeriesPoint>& points)
{
    std::vector<std::pair<Varied, QString>> columns;
    const std::array names{SeriesPage::tr("Radius"), SeriesPage::tr("Skew"), SeriesPage::tr("Speed"),
                           SeriesPage::tr("Altitude")}; // in the order of Varied
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto varied = static_cast<Varied>(i);
        const auto differs = [&](const SteadySeriesPoint& point) {
            return valueOf(point, varied) != valueOf(points.front(), varied);
        };
        if (std::ranges::any_of(points, differs)) columns.emplace_back(varied, names[i]);
    }
    if (columns.empty()) columns.emplace_back(Varied::Radius, names.front());
    return columns;
}

int decimalsOfPoint(const Quantity& quantity)
{
    return quantity.name == "speed" || quantity.name == "altitude" ? 0 : 2;
}

} // namespace

SeriesPage::SeriesPage(SteadyController::Solver solver, QWidget* parent)
    : ResultPage(parent), controller_(std::move(solver)), setup_(new SeriesSetup(this)), plots_(new SeriesPlots(this))
{
    build(controller_,
          {tr("series"), tr("series"), tr("Solving"), tr("Sol&ve the series"),
           tr("Solve the static state at each point of the series, or stop; what is solved remains"),
           tr("Series of static states"),
           tr("How the slider flies at other radii, skews, speeds or altitudes: choose above what varies, and press "
              "<i>Solve the series</i>."),
           tr("The first state is not ready yet.")},
          setup_, plots_, {520, 160});
    table()->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table()->horizontalHeader()->setStretchLastSection(true);
    connect(table(), &ResultTable::chosen, this, [this](int row) {
        if (row >= 0) plots_->point(states_[static_cast<std::size_t>(row)].point);
    });
    connect(&controller_, &SeriesController::solved, this, &SeriesPage::onSolved);
    connect(&controller_, &SeriesController::finished, this, [this](int, bool stopped) { onFinished(stopped); });
    showNotes();
}

void SeriesPage::setCase(const Case& c)
{
    case_ = c;
    setup_->setCase(c);
    showNotes();
}

void SeriesPage::open(const Case& c)
{
    controller_.stopAndWait();
    case_ = c;
    setup_->open(c);
    points_.clear();
    states_.clear();
    table()->setRows({}, {});
    plots_->setStates({}, {});
    showResult(false);
    showProblem({});
    emit changed();
}

bool SeriesPage::stale() const { return !states_.empty() && !sameFilm(case_, solved_); }

void SeriesPage::startOrStop()
{
    if (controller_.active()) return controller_.stop();
    QString problem = setup_->problem();
    if (const auto problems = checkCombinations(case_); problem.isEmpty() && !problems.empty())
        problem = sentence("the case contradicts itself: " + problems.front().key + " " + problems.front().message);
    showProblem(problem);
    if (!problem.isEmpty()) return;
    const auto start = [this] {
        begin(case_, setup_->points());
        controller_.start(solved_, points_);
    };
    if (unsaved() == 0) return start();
    askBeforeLoss(*window(),
                  {QStringLiteral("unsavedSeries"), tr("Replace the series"),
                   tr("The series of %1 static states is not saved.").arg(unsaved()),
                   tr("There is one series: the new one would take its place."), tr("&Replace")},
                  start);
}

void SeriesPage::begin(const Case& c, std::vector<SteadySeriesPoint> points)
{
    solved_ = c;
    points_ = std::move(points);
    states_.clear();
    forgetFile();
    table()->setRows(heads(), {});
    plots_->setHeld(solved_.steady.fixedAttitude);
    plots_->setStates(points_, {});
    plots_->fit();
    showResult(false);
}

StoredSeries SeriesPage::series() const
{
    StoredSeries series{listing(solved_, points_), {}, {}};
    for (const SeriesState& state : states_) series.results.push_back(state.result);
    return series;
}

void SeriesPage::restore(const StoredSeries& series)
{
    begin(series.value, seriesOf(series.value));
    for (std::size_t i = 0; i < series.results.size(); ++i) append(i, series.results[i]);
    plots_->fit();
    showNotes();
    emit changed();
}

void SeriesPage::showProblem(const QString& text)
{
    problem_ = text;
    showNotes();
}

ResultPage::Notes SeriesPage::notes() const { return {problem_, true, stale()}; }

void SeriesPage::append(std::size_t index, const SteadyResult& result)
{
    SteadyResult numbers = result;
    numbers.dropFields();
    states_.push_back({points_[index], std::move(numbers)});
    forgetFile();
    table()->append(rowOf(states_.back()));
    showResult(true);
    plots_->setStates(points_, states_);
}

void SeriesPage::onSolved(std::size_t index, const SteadyResult& result)
{
    append(index, result);
    emit changed();
    emit solved(caseAt(solved_, points_[index]), result);
}

void SeriesPage::onFinished(bool stopped)
{
    const auto missing = std::ranges::count_if(states_, std::not_fn(isKnown));
    double seconds = 0.0;
    for (const SeriesState& state : states_) seconds += state.result.wallSeconds;
    QStringList words{tr("%1 of %2 states").arg(states_.size()).arg(points_.size())};
    if (missing > 0) words << tr("%1 without a solution").arg(missing);
    words << timeText(seconds);
    if (missing > 0)
        showProblem(tr("The first state without a solution: %1.")
                        .arg(inWindowWords(std::ranges::find_if_not(states_, isKnown)->result.message)));
    progress().conclude(stopped ? "cancelled" : "completed", words.join(QStringLiteral(" · ")));
    showNotes();
}

TableRow SeriesPage::heads() const
{
    TableRow heads;
    const auto add = [&](const QString& text, const Quantity& quantity) {
        heads.push_back({QStringLiteral("%1 [%2]").arg(text, unitText(quantity.displayUnit))});
    };
    for (const auto& [varied, title] : variedColumns(points_)) add(title, quantityOf(varied));
    heads.push_back({tr("Status")});
    const std::vector<SteadyQuantity> all = steadyQuantities({});
    for (const NumberColumn& column : numberColumns) add(tr(column.head), called(all, column.quantity).quantity);
    heads.push_back({tr("Remark")});
    return heads;
}

TableRow SeriesPage::rowOf(const SeriesState& state) const
{
    TableRow row;
    const QString remark = sentence(state.result.message); // it may be cut off
    for (const auto& [varied, title] : variedColumns(points_)) {
        const Quantity quantity = quantityOf(varied);
        row.push_back(numberCell(
            typeset(valueOf(state.point, varied) / unitFactor(quantity.displayUnit), decimalsOfPoint(quantity))));
    }
    row.push_back({statusText(name(state.result.status)), Qt::AlignLeft, remark, {}, !isKnown(state)});
    const std::vector<SteadyQuantity> all = steadyQuantities(state.result);
    for (const NumberColumn& column : numberColumns) {
        const auto& [quantity, value] = called(all, column.quantity);
        row.push_back(numberCell(isKnown(state) && std::isfinite(value)
                                     ? typeset(value / unitFactor(quantity.displayUnit), column.decimals)
                                     : QString(QChar(0x2013))));
    }
    row.push_back({remark, Qt::AlignLeft, remark, {}, !isKnown(state)});
    return row;
}

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/series_page.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QShortcut>
#include <QVBoxLayout>

#include "core/case/parameters.h"
#include "core/formats/units.h"
#include "core/simulation/static_state/static_solution.h"
#include "core/simulation/static_state/steady_quantities.h"
#include "ui/calculation/progress_strip.h"
#include "ui/film/result_pages.h"
#include "ui/film/series_setup.h"
#include "ui/style/foreign_text.h"
#include "ui/style/loss_question.h"
#include "ui/style/quantity_format.h"
#include "ui/style/save_dialog.h"
#include "ui/style/theme.h"
#include "ui/style/whole_file.h"

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
    : QWidget(parent),
      controller_(std::move(solver)),
      start_(new QPushButton(this)),
      setup_(new SeriesSetup(this)),
      progress_(new ProgressStrip(controller_, tr("series"), tr("Solving"), this)),
      stale_(new QLabel(tr("The parameters have changed since this was solved."), this)),
      problem_(new QLabel(this)),
      empty_(new QLabel(this)),
      pages_(new QStackedWidget(this)),
      plots_(new SeriesPlots(this)),
      table_(new QTableWidget(this)),
      copy_(new QToolButton(this)),
      save_(new QToolButton(this))
{
    addResultPages(*pages_, *empty_, plots_, buildTable(), {520, 160});
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(buildHead());
    layout->addWidget(problem_);
    layout->addWidget(pages_, 1);

    connect(&controller_, &SeriesController::solved, this, &SeriesPage::onSolved);
    connect(&controller_, &SeriesController::finished, this, [this](int, bool stopped) { onFinished(stopped); });
    connect(&controller_, &SeriesController::stateChanged, this, &SeriesPage::showNotes);
    showNotes();
}

QWidget* SeriesPage::buildHead()
{
    auto* head = new QWidget(this);
    start_->setAutoDefault(false);
    start_->setToolTip(
        plainTip(tr("Solve the static state at each point of the series, or stop; what is solved remains")));
    connect(start_, &QPushButton::clicked, this, &SeriesPage::startOrStop);
    problem_->setContentsMargins(10, 2, 10, 4);
    empty_->setTextFormat(Qt::RichText);
    problem_->setWordWrap(true);
    problem_->hide();
    auto* choice = new QHBoxLayout;
    choice->setContentsMargins(8, 4, 8, 0);
    choice->addWidget(setup_);
    choice->addWidget(start_, 0, Qt::AlignTop);
    choice->addStretch(1);
    auto* state = new QHBoxLayout;
    state->setContentsMargins(0, 0, 8, 2);
    state->addWidget(progress_, 1);
    state->addWidget(stale_);
    auto* layout = new QVBoxLayout(head);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addLayout(choice);
    layout->addLayout(state);
    return head;
}

QWidget* SeriesPage::buildTable()
{
    auto* part = new QWidget(this);
    table_->setAccessibleName(tr("Table of the series"));
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setTabKeyNavigation(false);
    table_->horizontalHeader()->setHighlightSections(false); // bold heads would need wider columns
    table_->verticalHeader()->setDefaultSectionSize(static_cast<int>(1.6 * fontMetrics().height()));
    connect(table_, &QTableWidget::currentCellChanged, this, [this](int row) {
        if (row >= 0) plots_->point(states_[static_cast<std::size_t>(row)].point);
    });
    auto* shortcut = new QShortcut(QKeySequence::Copy, table_, nullptr, nullptr, Qt::WidgetShortcut);
    connect(shortcut, &QShortcut::activated, this, &SeriesPage::copy);
    copy_->setText(tr("Copy"));
    copy_->setToolTip(tr("Copy the table for a spreadsheet"));
    copy_->setAccessibleName(tr("Copy the table of the series"));
    connect(copy_, &QToolButton::clicked, this, &SeriesPage::copy);
    save_->setText(tr("Save…"));
    save_->setToolTip(tr("Save all numbers of the states as comma-separated values"));
    save_->setAccessibleName(tr("Save the numbers of the series"));
    connect(save_, &QToolButton::clicked, this, &SeriesPage::chooseSave);
    auto* tools = new QHBoxLayout;
    tools->setContentsMargins(6, 0, 6, 2);
    tools->addStretch(1);
    for (QToolButton* button : {copy_, save_}) {
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::TabFocus);
        tools->addWidget(button);
    }
    auto* layout = new QVBoxLayout(part);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(table_, 1);
    layout->addLayout(tools);
    return part;
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
    table_->setRowCount(0);
    plots_->setStates({}, {});
    pages_->setCurrentIndex(0);
    showProblem({});
    showNotes();
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
    saved_ = {};
    table_->setRowCount(0);
    makePlainTable(table_, tableHeads());
    table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    table_->horizontalHeader()->setStretchLastSection(true);
    plots_->setHeld(solved_.steady.fixedAttitude);
    plots_->setStates(points_, {});
    plots_->fit();
    pages_->setCurrentIndex(0);
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

QString SeriesPage::save(const QString& path)
{
    QString problem = writeWholeFile(path, csv());
    saved_ = problem.isEmpty() ? SavedFile(path) : SavedFile();
    return problem;
}

void SeriesPage::showProblem(const QString& text)
{
    problem_->setText(text);
    problem_->setVisible(!text.isEmpty());
}

void SeriesPage::append(std::size_t index, const SteadyResult& result)
{
    SteadyResult numbers = result;
    numbers.dropFields();
    states_.push_back({points_[index], std::move(numbers)});
    saved_ = {};
    addRow(states_.back());
    pages_->setCurrentIndex(1);
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
                        .arg(QString::fromStdString(std::ranges::find_if_not(states_, isKnown)->result.message)));
    progress_->conclude(stopped ? "cancelled" : "completed", words.join(QStringLiteral(" · ")));
    showNotes();
}

QStringList SeriesPage::tableHeads() const
{
    QStringList heads;
    const auto add = [&](const QString& text, const Quantity& quantity) {
        heads << QStringLiteral("%1 [%2]").arg(text, unitText(quantity.displayUnit));
    };
    for (const auto& [varied, title] : variedColumns(points_)) add(title, quantityOf(varied));
    heads << tr("Status");
    const std::vector<SteadyQuantity> all = steadyQuantities({});
    for (const NumberColumn& column : numberColumns) add(tr(column.head), called(all, column.quantity).quantity);
    return heads << tr("Remark");
}

QStringList SeriesPage::tableCells(const SeriesState& state) const
{
    QStringList cells;
    for (const auto& [varied, title] : variedColumns(points_)) {
        const Quantity quantity = quantityOf(varied);
        cells << typeset(valueOf(state.point, varied) / unitFactor(quantity.displayUnit), decimalsOfPoint(quantity));
    }
    cells << statusText(name(state.result.status));
    const std::vector<SteadyQuantity> all = steadyQuantities(state.result);
    for (const NumberColumn& column : numberColumns) {
        const auto& [quantity, value] = called(all, column.quantity);
        cells << (isKnown(state) && std::isfinite(value)
                      ? typeset(value / unitFactor(quantity.displayUnit), column.decimals)
                      : QString(QChar(0x2013)));
    }
    return cells << sentence(state.result.message);
}

void SeriesPage::addRow(const SeriesState& state)
{
    const int row = table_->rowCount();
    table_->insertRow(row);
    const QStringList cells = tableCells(state);
    const auto status = static_cast<qsizetype>(variedColumns(points_).size());
    for (qsizetype column = 0; column < cells.size(); ++column) {
        auto* item = new QTableWidgetItem(cells[column]);
        const bool words = column == status || column + 1 == cells.size();
        if (!words) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        if (words) item->setToolTip(plainTip(cells.back())); // it may be cut off
        table_->setItem(row, static_cast<int>(column), item);
        if (words) colourState(row, static_cast<int>(column));
    }
}

void SeriesPage::colourState(int row, int column)
{
    if (!isKnown(states_[static_cast<std::size_t>(row)]))
        table_->item(row, column)->setForeground(meaningColours(palette()).failure);
}

void SeriesPage::showNotes()
{
    const bool active = controller_.active();
    start_->setText(active ? tr("Stop") : tr("Sol&ve the series"));
    empty_->setText(QStringLiteral("<h2>%1</h2><p>%2</p>")
                        .arg(tr("Series of static states"),
                             active
                                 ? tr("The first state is not ready yet.")
                                 : tr("How the slider flies at other radii, skews, speeds or altitudes: choose above "
                                      "what varies, and press <i>Solve the series</i>.")));
    start_->setEnabled(controller_.state() != SeriesController::State::Stopping);
    setup_->setEnabled(!active);
    setTextColour(stale_, meaningColours(palette()).warning);
    setTextColour(problem_, meaningColours(palette()).failure);
    stale_->setVisible(stale());
    for (QToolButton* button : {copy_, save_}) button->setEnabled(!states_.empty());
}

void SeriesPage::copy() const { QGuiApplication::clipboard()->setText(tableText(*table_)); }

QByteArray SeriesPage::csv() const { return csvOf(states_); }

void SeriesPage::chooseSave()
{
    askAndSave(this, tr("Save the series"), {tr("Comma-separated values (*.csv)")}, QStringLiteral("series.csv"),
               [this](const QString& path) { return save(path); });
}

void SeriesPage::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() != QEvent::PaletteChange) return;
    showNotes();
    for (int row = 0; row < table_->rowCount(); ++row)
        for (const int column : {static_cast<int>(variedColumns(points_).size()), table_->columnCount() - 1})
            colourState(row, column);
}

} // namespace touchdown

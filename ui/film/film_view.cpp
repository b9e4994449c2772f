// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/film_view.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <QToolButton>
#include <QVBoxLayout>

#include "core/physics/slider/recess.h"
#include "core/simulation/static_state/field_difference.h"
#include "core/simulation/static_state/film_setup.h"
#include "ui/film/compare_page.h"
#include "ui/film/modes_page.h"
#include "ui/film/series_page.h"
#include "ui/film/solutions_model.h"
#include "ui/film/surface_page.h"
#include "ui/maps/field_map.h"
#include "ui/maps/fields_view.h"
#include "ui/maps/map_kinds.h"
#include "ui/slider/attitude_sections.h"
#include "ui/style/foreign_text.h"
#include "ui/style/theme.h"

namespace touchdown {

namespace {

/// The point of minimum spacing. It lies on the border of a rail in most cases, and there on the side of the rail: a
/// millionth of a cell inside, so that the sections pass through the rail's cells.
std::optional<SurfacePoint> nearestTheDisk(const SteadyResult& result)
{
    if (result.gap.empty()) return std::nullopt;
    constexpr double inside = 1e-6; // of the way to the centre of the cell
    const SurfacePoint at = result.minimumAt;
    const CellGrid& grid = result.grid;
    const auto touching = [](const std::vector<double>& lines, double place) {
        const int cell = std::max(cellIndex(lines, place), 0);
        std::vector<int> cells{cell};
        if (cell > 0 && place == lines[static_cast<std::size_t>(cell)]) cells.push_back(cell - 1);
        return cells;
    };
    double least = std::numeric_limits<double>::infinity();
    SurfacePoint chosen = at;
    for (const int j : touching(grid.y, at.y))
        for (const int i : touching(grid.x, at.x))
            if (const double gap = result.gap[static_cast<std::size_t>(j * grid.nx() + i)]; gap < least) {
                least = gap;
                chosen = {at.x + inside * (grid.centreX(i) - at.x), at.y + inside * (grid.centreY(j) - at.y)};
            }
    return chosen;
}

/// Gap and recess at each point, where the map has means over cells; in the order of the fields.
std::vector<FieldAtPoints> shownPoints(const Case& c, const SteadyResult& result)
{
    const Recess recess(c.surface, c.slider.length, c.slider.width);
    FieldAtPoints gap = gapAtPoints(c, recess, result.attitude, {result.minimumSpacing, result.minimumAt});
    if (const double error = result.discretisationError.minimumSpacing; error > 0.0) gap.error = error;
    return {{}, std::move(gap), {[recess](const SurfacePoint& p) { return recess.at(p.x, p.y); }}};
}

constexpr int fieldCount = 3;       // pressure, gap, recess
constexpr double smallGap = 0.1e-9; // a logarithm about zero shows a smaller difference as zero [m]

std::vector<std::vector<double>> shownFields(const Case& c, const SteadyResult& result)
{
    std::vector<double> pressure = result.pressure;
    for (double& value : pressure) value -= airOf(c.air).pressure;
    return {std::move(pressure), result.gap, result.recess};
}

bool sameSize(const Case& a, const Case& b)
{
    return a.slider.length == b.slider.length && a.slider.width == b.slider.width;
}

} // namespace

FilmView::FilmView(QAction* solve, QWidget* parent)
    : QWidget(parent),
      tabs_(new QTabBar(this)),
      row_(new QHBoxLayout),
      gridShown_(new QCheckBox(tr("&Grid"), this)),
      difference_(new QCheckBox(this)),
      note_(new QLabel(this)),
      pages_(new QStackedWidget(this)),
      shape_(new SurfacePage(this)),
      maps_(new FieldsView(this)),
      compare_(new ComparePage(this)),
      modes_(new ModesPage(touchdown::modes, this)),
      series_(new SeriesPage(steadyWithContact, this))
{
    for (const QString& name :
         {tr("Surface"), tr("Pressure"), tr("Gap"), tr("Recess"), tr("Compare"), tr("Modes"), tr("Series")})
        tabs_->addTab(name);
    using Colours = MapKind::Colours;
    using Logarithm = MapKind::Logarithm;
    maps_->setKinds(
        {{tr("Pressure above ambient"),
          {"kPa", "atm", "MPa"},
          Colours::Signed,
          Logarithm::Offered,
          nearAmbient,
          true,
          aboveAmbientSymbol()},
         {tr("Gap"), {"nm", "um"}, Colours::BrightLow, Logarithm::AtFirst},
         {tr("Recess"), {"nm", "um"}, Colours::Recess}, // on the pads it is zero: no logarithm
         {tr("Difference of pressures"), {"kPa", "atm", "MPa"}, Colours::Signed, Logarithm::Offered, nearAmbient, true},
         {tr("Difference of gaps"), {"nm", "um"}, Colours::Signed, Logarithm::AtFirst, smallGap, true},
         {tr("Difference of recesses"), {"nm", "um"}, Colours::Signed, Logarithm::None, 0.0, true}});
    tabs_->setAccessibleName(tr("Views of the film"));
    tabs_->setDrawBase(false);
    tabs_->setExpanding(false);
    tabs_->setFocusPolicy(Qt::StrongFocus);
    gridShown_->setToolTip(tr("Show the cells of the solver (G)"));
    note_->setContentsMargins(8, 0, 8, 4);
    note_->setMinimumWidth(1);
    note_->setWordWrap(true);
    pages_->addWidget(shape_);
    pages_->addWidget(maps_);
    pages_->addWidget(buildEmptyPage(solve));
    pages_->addWidget(compare_);
    difference_->setToolTip(tr("Subtract the fields of the baseline from those of this solution"));
    pages_->addWidget(modes_);
    pages_->addWidget(series_);

    row_->setContentsMargins(6, 4, 8, 4);
    row_->setSpacing(8);
    row_->addWidget(tabs_);
    row_->addStretch(1);
    row_->addWidget(maps_->controls());
    row_->addWidget(difference_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(row_);
    layout->addWidget(note_);
    layout->addWidget(pages_, 1);

    connect(tabs_, &QTabBar::currentChanged, this, &FilmView::showPage);
    connect(tabs_, &QTabBar::currentChanged, this, &FilmView::pageChanged);
    // Its letters choose tools at once; by keys the focus stays on the tabs.
    connect(tabs_, &QTabBar::tabBarClicked, this, [this](int page) {
        if (page == static_cast<int>(Page::Surface)) shape_->editor()->setFocus();
    });
    connect(difference_, &QCheckBox::toggled, this, [this] {
        showFields();
        showPage();
    });
    connect(gridShown_, &QCheckBox::toggled, surface(), &SurfaceView::setGridShown);
    connect(gridShown_, &QCheckBox::toggled, maps_->map(), &FieldMap::setGridShown);
    connect(&modes_->controller(), &ModesController::stateChanged, this, &FilmView::busyChanged);
    connect(&series_->controller(), &SeriesController::stateChanged, this, &FilmView::busyChanged);
    setSolving(false);
    showPage();
}

QWidget* FilmView::buildEmptyPage(QAction* solve)
{
    auto* page = new QWidget(this);
    page->setAutoFillBackground(true);
    page->setBackgroundRole(QPalette::Base); // as the plans and plots shown later
    emptyText_ = new QLabel(page);
    auto* button = new QToolButton(page);
    button->setDefaultAction(solve);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setFocusPolicy(Qt::StrongFocus);
    auto* layout = new QVBoxLayout(page);
    layout->addStretch(1);
    layout->addWidget(emptyText_, 0, Qt::AlignHCenter);
    layout->addWidget(button, 0, Qt::AlignHCenter);
    layout->addStretch(2);
    return page;
}

SurfaceView* FilmView::surface() const { return shape_->editor(); }

void FilmView::open(const Case& c)
{
    clearResult();
    modes_->clear();
    series_->open(c);
    setCase(c);
}

void FilmView::setCase(const Case& c)
{
    shape_->setCase(c);
    modes_->setCase(c);
    series_->setCase(c);
}

void FilmView::setResult(const Case& solved, const SteadyResult& result)
{
    if (result.pressure.empty()) {
        clearResult();
        emptyText_->setText(
            tr("The fields of this solution were given up to save memory; its numbers are in the table. "
               "Use and Solve bring them back."));
        return;
    }
    base_.reset(); // that of another solution
    state_ = {solved, result};
    stale_ = false;
    maps_->map()->setSlider(solved.slider.length, solved.slider.width);
    maps_->map()->setRails(solved.surface.rails);
    maps_->map()->setSkew(solved.disk.skew);
    maps_->proposeSectionPoint(nearestTheDisk(result));
    surface()->setGrid(result.grid);
    showFields();
    showPage();
}

void FilmView::clearResult()
{
    state_.reset();
    stale_ = false;
    setSolving(false);
    maps_->proposeSectionPoint(std::nullopt);
    surface()->setGrid({});
    showFields();
    showPage();
}

void FilmView::compare(const SolutionRecord* shown, const std::vector<const SolutionRecord*>& compared, int baseline)
{
    compare_->setSolutions(compared, baseline);
    base_.reset();
    QString base;
    const auto title = [](const SolutionRecord& each) {
        const QString state = notFoundText(each.result);
        return state.isEmpty() ? QString::number(each.number) : tr("%1 (%2)").arg(each.number).arg(state);
    };
    std::vector<FieldsView::OtherFields> others;
    for (const SolutionRecord* each : compared)
        if (each != shown && !each->result.pressure.empty())
            others.push_back({title(*each), RecordList::style(*each), each->result.grid,
                              shownFields(each->value, each->result), shownPoints(each->value, each->result)});
    maps_->setOthers(shown ? title(*shown) : QString(), shown ? RecordList::style(*shown) : CurveStyle{0, 0},
                     std::move(others));
    if (shown && shown->number != baseline)
        for (const SolutionRecord* each : compared)
            if (each->number == baseline && !each->result.pressure.empty() && sameSize(each->value, shown->value))
                base_ = {each->value, each->result}, base = title(*each);
    difference_->setText(base_ ? tr("&Minus %1").arg(onButton(base)) : tr("&Minus baseline"));
    showFields();
    showPage();
}

void FilmView::showFields()
{
    if (!state_) {
        maps_->setFields({}, {});
        shape_->setPressure({});
        return;
    }
    std::vector<std::vector<double>> fields = shownFields(state_->value, state_->result);
    shape_->setPressure(fields.front());
    if (base_ && difference_->isChecked()) {
        FieldDifference difference = fieldDifference(state_->value, state_->result, base_->value, base_->result);
        for (std::vector<double>* field : {&difference.pressure, &difference.gap, &difference.recess})
            fields.push_back(std::move(*field));
    }
    maps_->setFields(state_->result.grid, std::move(fields), {}, shownPoints(state_->value, state_->result));
}

void FilmView::setStale(bool stale)
{
    if (stale == stale_) return;
    stale_ = stale;
    showPage();
}

void FilmView::setSolving(bool solving)
{
    emptyText_->setText(solving ? tr("Solving…") : tr("There is no solution yet."));
}

bool FilmView::busy() const
{
    using State = CalculationController::State;
    return modes_->controller().state() == State::Running || series_->controller().state() == State::Running;
}

void FilmView::stop()
{
    modes_->controller().stop();
    series_->controller().stop();
}

void FilmView::stopAndWait()
{
    modes_->controller().stopAndWait();
    series_->controller().stopAndWait();
}

void FilmView::setPage(Page page) { tabs_->setCurrentIndex(static_cast<int>(page)); }

void FilmView::fit()
{
    surface()->fit();
    maps_->fit();
    series_->fit();
}

void FilmView::showPage()
{
    // In the order of the tabs, where the three maps share one page, or an empty one.
    const int map = tabs_->currentIndex() - 1;
    const bool mapped = map >= 0 && map < fieldCount;
    const bool subtracted = base_ && difference_->isChecked();
    if (mapped) maps_->setField(map + (subtracted ? fieldCount : 0)); // differences follow
    pages_->setCurrentIndex(page() == Page::Surface ? 0 : mapped ? (state_ ? 1 : 2) : 3 + map - fieldCount);
    maps_->controls()->setVisible(mapped && state_);
    difference_->setVisible(mapped && base_);
    if (page() == Page::Surface)
        shape_->addGridSwitch(*gridShown_);
    else
        row_->addWidget(gridShown_);
    gridShown_->setVisible(page() == Page::Surface || mapped);
    gridShown_->setEnabled(state_.has_value());
    QStringList notes;
    if (state_ && !notFoundText(state_->result).isEmpty())
        notes << tr("The search did not converge: these are the fields of its last step.");
    if (state_ && stale_)
        notes << tr("The parameters have changed since this was solved: Use, in the list of solutions, brings back "
                    "those of this solution.");
    setTextColour(note_, meaningColours(palette()).warning);
    note_->setText(notes.join(QLatin1Char(' ')));
    note_->setVisible(mapped && !notes.isEmpty());
    // Minimum spacing and pressure are those of the solved surface.
    shape_->setPressureStale(stale_);
    const bool known = state_ && !stale_ && state_->result.status == SteadyStatus::Converged;
    if (known)
        surface()->setMinimumSpacing(
            state_->result.minimumAt,
            roundedToError(state_->result.minimumSpacing, state_->result.discretisationError.minimumSpacing, "nm"));
    else
        surface()->setMinimumSpacing(std::nullopt);
}

} // namespace touchdown

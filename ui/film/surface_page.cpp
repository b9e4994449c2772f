// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/surface_page.h"

#include <algorithm>
#include <cmath>

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QVBoxLayout>

#include "core/formats/units.h"
#include "core/simulation/static_state/film_setup.h"
#include "ui/slider/attitude_sections.h"
#include "ui/slider/part_picking.h"
#include "ui/style/foreign_text.h"
#include "ui/style/quantity_format.h"
#include "ui/style/theme.h"
#include "ui/style/window_words.h"

namespace touchdown {

namespace {

constexpr int longestState = 88; // minimum spacing, pitch and roll with changes and errors [characters]

/// "min 8.75 nm  +0.31 (±0.16)": the change is left out where there is nothing to compare with, the error where it is
/// not known.
QString part(const QString& name, double value, std::optional<double> before, double error, std::string_view unit)
{
    const int decimals = decimalsWithError(value, error, unit);
    const double factor = unitFactor(unit);
    QString text = QStringLiteral("%1 <b>%2</b> %3").arg(name, typeset(value / factor, decimals), unitText(unit));
    if (before) text += QStringLiteral("  ") + changeText(value - *before, value, error, unit);
    if (std::isfinite(error) && error > 0.0) text += QStringLiteral(" (±%1)").arg(typeset(error / factor, decimals));
    return text;
}

} // namespace

SurfacePage::SurfacePage(QWidget* parent)
    : QWidget(parent),
      editor_(new SurfaceEditor(this)),
      panel_(new ShapePanel(this)),
      follow_(new QCheckBox(tr("Fol&low"), this)),
      influence_(new QCheckBox(tr("&Influence"), this)),
      pressure_(new QCheckBox(tr("Press&ure"), this)),
      drawing_(new QCheckBox(tr("&Drawing"), this)),
      flight_(new QLabel(this))
{
    follow_->setObjectName(QStringLiteral("follow"));
    follow_->setChecked(true);
    follow_->setToolTip(
        plainTip(tr("While you change the shape, solve how it flies: on a coarse grid during a drag, on the "
                    "case's own grid afterwards")));
    influence_->setObjectName(QStringLiteral("influence"));
    influence_->setToolTip(
        plainTip(tr("Show what a deeper recess of each rail and a shift of each edge would do to the minimum "
                    "spacing (I)")));
    pressure_->setObjectName(QStringLiteral("pressure"));
    pressure_->setEnabled(false);
    pressure_->setToolTip(plainTip(tr("Show the pressure of the solution under the outlines (U)")));
    drawing_->setObjectName(QStringLiteral("drawing"));
    drawing_->setToolTip(plainTip(tr("Show the drawing under the plan (D)")));
    drawing_->hide(); // until there is one
    // Each has the colours and the bar for itself.
    connect(pressure_, &QCheckBox::toggled, this, [this](bool on) {
        if (on) influence_->setChecked(false);
        editor_->showPressure(on, pressureStale_);
    });
    connect(influence_, &QCheckBox::toggled, this, [this](bool on) {
        if (on) pressure_->setChecked(false);
    });
    connect(drawing_, &QCheckBox::toggled, this, [this](bool on) {
        UnderlayPlace place = editor_->underlay().place();
        place.shown = on;
        editor_->underlay().setPlace(place);
    });
    connect(&editor_->underlay(), &Underlay::changed, this, [this] {
        drawing_->setChecked(editor_->underlay().shown());
        if (drawing_->isHidden() != editor_->underlay().loaded()) return;
        drawing_->setVisible(editor_->underlay().loaded());
        fit();
    });
    connect(this, &SurfacePage::influenceWanted, this, [this] {
        influencing_ = influencingParts();
        editor_->setInfluence({});
        editor_->setRestingReading(influence_->isChecked() ? tr("Finding what each rail does to the flying height…")
                                                           : QString());
    });
    connect(influence_, &QCheckBox::toggled, this, &SurfacePage::influenceWanted);
    connect(editor_, &SurfaceEditor::selectionChanged, this, [this] {
        if (influencingParts() != influencing_) emit influenceWanted();
    });
    flight_->setAccessibleName(tr("How the slider flies"));
    flight_->setContentsMargins(8, 2, 8, 2);
    flight_->setTextFormat(Qt::RichText);
    flight_->setMinimumWidth(1);
    flight_->setWordWrap(true);

    panel_->hide();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(toolRow_ = buildTools());
    layout->addWidget(flight_);
    layout->addWidget(editor_, 1);

    connect(editor_, &SurfaceEditor::selectionChanged, this, [this] { panel_->setSelection(editor_->selection()); });
    connect(panel_, &ShapePanel::selected, editor_, &SurfaceEditor::select);
    connect(editor_, &SurfaceEditor::previewed, this, &SurfacePage::previewed);
    connect(editor_, &SurfaceEditor::previewed, panel_, &ShapePanel::preview);
    connect(editor_, &SurfaceEditor::edited, this, &SurfacePage::edited);
    connect(panel_, &ShapePanel::edited, this, &SurfacePage::edited);
    connect(panel_, &ShapePanel::menuWanted, this,
            [this](const QPoint& globalPos) { editor_->popUpMenu(globalPos, std::nullopt); });
    for (const auto wanted : {&SurfaceEditor::coordinatesWanted, &SurfaceEditor::recessWanted})
        connect(editor_, wanted, this, &SurfacePage::panelWanted);
    connect(editor_, &SurfaceEditor::wallWanted, this, &SurfacePage::panelWanted);
    connect(editor_, &SurfaceEditor::coordinatesWanted, panel_, &ShapePanel::typeCoordinates);
    connect(editor_, &SurfaceEditor::recessWanted, panel_, &ShapePanel::typeRecess);
    connect(editor_, &SurfaceEditor::wallWanted, panel_,
            [this](int wall) { panel_->showWall(static_cast<std::size_t>(wall) - 1); });
    fit();
}

QWidget* SurfacePage::buildTools()
{
    auto* row = new QWidget(this);
    row->setMinimumWidth(1); // it does not widen the window
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(6, 2, 8, 2);
    auto* group = new QButtonGroup(this);
    const auto tool = [&](SurfaceEditor::Tool which, const QString& text, const QString& tip) {
        auto* button = new QToolButton(row);
        tools_.push_back(button);
        button->setText(text);
        button->setToolTip(plainTip(tip));
        button->setAccessibleName(tip);
        button->setCheckable(true);
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::StrongFocus);
        group->addButton(button, static_cast<int>(which));
        layout->addWidget(button);
        connect(button, &QToolButton::clicked, this, [this, which] {
            editor_->setTool(which);
            editor_->setFocus();
        });
    };
    tool(SurfaceEditor::Tool::Select, tr("Select"), tr("Select and drag rails, edges and corners (V)"));
    tool(SurfaceEditor::Tool::Rectangle, tr("Rectangle"), tr("Draw a rectangular rail (R)"));
    tool(SurfaceEditor::Tool::Polygon, tr("Polygon"), tr("Draw a rail corner by corner; Enter closes it (P)"));
    tool(SurfaceEditor::Tool::Measure, tr("Measure"), tr("Measure between two places; Esc removes the measure (M)"));
    group->button(0)->setChecked(true);
    connect(editor_, &SurfaceEditor::toolChanged, this,
            [this, group] { group->button(static_cast<int>(editor_->tool()))->setChecked(true); });
    const auto toggle = [&](const QString& text, const QString& tip, bool on, auto perform) {
        auto* box = new QCheckBox(text, row);
        box->setToolTip(plainTip(tip));
        box->setChecked(on);
        connect(box, &QCheckBox::toggled, editor_, perform);
        layout->addWidget(box);
        return box;
    };
    layout->addSpacing(10);
    snap_ = toggle(tr("S&nap"),
                   tr("Snap to corners of other rails, to the centre line, the border and 1 µm (S); Ctrl lets go"),
                   true, [this](bool on) { editor_->setSnapping(on); });
    pairs_ = toggle(tr("&Pairs"),
                    tr("Rails that are mirror images move together (Y); a click on the link of a pair breaks it (L)"),
                    false, [this](bool on) { editor_->setPairs(on); });
    layout->addWidget(follow_);
    layout->addWidget(influence_);
    layout->addWidget(pressure_);
    layout->addWidget(drawing_);
    setTabOrder(pairs_, follow_);
    setTabOrder(follow_, influence_);
    setTabOrder(influence_, pressure_);
    setTabOrder(pressure_, drawing_);
    layout->addStretch(1);
    return row;
}

void SurfacePage::addGridSwitch(QCheckBox& box)
{
    grid_ = &box;
    toolRow_->layout()->addWidget(&box);
    box.show(); // counts in the width of the row
    fit();
}

void SurfacePage::keyPressEvent(QKeyEvent* event)
{
    QCheckBox* box = event->key() == Qt::Key_S   ? snap_
                     : event->key() == Qt::Key_Y ? pairs_
                     : event->key() == Qt::Key_I ? influence_
                     : event->key() == Qt::Key_U ? pressure_
                     : event->key() == Qt::Key_D ? drawing_
                     : event->key() == Qt::Key_G ? grid_
                                                 : nullptr;
    if (box != nullptr && event->modifiers() == Qt::NoModifier)
        box->click();
    else
        QWidget::keyPressEvent(event);
}

/// The plan keeps its place whatever is said above it: rows have as many lines as their longest text needs in this
/// width and font.
void SurfacePage::fit()
{
    static const QStringList icons{QStringLiteral("select"), QStringLiteral("rectangle"), QStringLiteral("polygon"),
                                   QStringLiteral("measure")};
    for (std::size_t i = 0; i < tools_.size(); ++i) {
        tools_[i]->setIcon(icon(icons[static_cast<qsizetype>(i)], palette()));
        tools_[i]->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    }
    QLayout* row = toolRow_->layout();
    row->setSpacing(-1); // as the style has it
    row->invalidate();
    if (row->minimumSize().width() > width())
        for (QToolButton* button : tools_) button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    row->invalidate();
    if (row->minimumSize().width() > width()) row->setSpacing(1);
    const QFontMetrics metrics = flight_->fontMetrics();
    const int lines = width() < longestState * metrics.averageCharWidth() ? 2 : 1;
    const QMargins margins = flight_->contentsMargins();
    flight_->setFixedHeight(lines * metrics.lineSpacing() + margins.top() + margins.bottom());
    if (obstacle_) showObstacle(reason_);
}

void SurfacePage::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    fit();
}

void SurfacePage::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    const auto type = event->type();
    if (type == QEvent::FontChange || type == QEvent::PaletteChange || type == QEvent::StyleChange)
        QMetaObject::invokeMethod(this, &SurfacePage::fit, Qt::QueuedConnection); // when its parts have it, too
}

void SurfacePage::showInfluence(const std::vector<PartInfluence>& influence)
{
    if (!influence_->isChecked()) return;
    std::vector<std::pair<SurfacePart, double>> shown;
    for (const PartInfluence& each : influence) shown.emplace_back(each.part, each.per.minimumSpacing);
    editor_->setInfluence(shown);
    const QString words = editor_->influenceWords() + (manyEdges() ? tr(" (selected rails)") : QString()) +
                          (shown.size() < influencing_.size() ? tr(" · finding the others…") : QString());
    editor_->setRestingReading(editor_->committed().rails.empty() ? tr("There are no rails.")
                               : shown.empty()                    ? tr("There is no flying attitude to change.")
                                                                  : words);
}

void SurfacePage::setPressure(std::vector<double> pressure)
{
    pressure_->setEnabled(!pressure.empty());
    editor_->setPressure(std::move(pressure));
}

void SurfacePage::setPressureStale(bool stale)
{
    pressureStale_ = stale;
    editor_->showPressure(pressure_->isChecked(), stale);
}

bool SurfacePage::manyEdges() const
{
    constexpr std::size_t most = 60; // they are found in a few seconds, and arrows have room
    std::size_t edges = 0;
    for (const Rail& rail : editor_->committed().rails) edges += rail.points.size();
    return edges > most;
}

PartSelection SurfacePage::influencingParts() const
{
    const std::vector<Rail>& rails = editor_->committed().rails;
    PartSelection parts;
    for (std::size_t i = 0; i < rails.size(); ++i) parts.insert({PartKind::Rail, i});
    for (const SurfacePart& rail : manyEdges() ? railsOf(editor_->selection()) : PartSelection(parts))
        for (std::size_t k = 0; k < rails[rail.item].points.size(); ++k) parts.insert({PartKind::Edge, rail.item, k});
    return parts;
}

void SurfacePage::setCase(const Case& c)
{
    editor_->setGridOf([c](const AirBearingSurface& surface) {
        Case shaped = c;
        shaped.surface = surface;
        return unadaptedGrid(shaped, filmLevels(c.film).back());
    });
    editor_->setCase(c.surface, c.slider.length, c.slider.width);
    editor_->setSkew(c.disk.skew);
    panel_->setCase(c);
}

void SurfacePage::open(const Case& c)
{
    setCase(c);
    editor_->open();
    clearFlight();
}

void SurfacePage::showFlight(const SteadyResult& state, const std::optional<SteadyResult>& reference, bool preview)
{
    if (state.status != SteadyStatus::Converged) {
        showObstacle(tr("It does not fly so: %1").arg(inWindowWords(state.message)));
        return;
    }
    const bool compared = reference && reference->status == SteadyStatus::Converged;
    const auto before = [&](double SteadyResult::*member) {
        return compared ? std::optional((*reference).*member) : std::nullopt;
    };
    const auto angle = [&](double Attitude::*member) {
        return compared ? std::optional(reference->attitude.*member) : std::nullopt;
    };
    const DiscretisationError& error = state.discretisationError;
    shortPart_ =
        part(tr("min"), state.minimumSpacing, before(&SteadyResult::minimumSpacing), error.minimumSpacing, "nm");
    flightParts_ =
        shortPart_ + QStringLiteral(" &nbsp; ") +
        part(tr("pitch"), state.attitude.pitch, angle(&Attitude::pitch), error.pitch, "urad") +
        QStringLiteral(" &nbsp; ") + part(tr("roll"), state.attitude.roll, angle(&Attitude::roll), error.roll, "urad") +
        (preview ? tr(" &nbsp; preview, %1 × %2 cells").arg(state.grid.nx()).arg(state.grid.ny()) : QString());
    if (!preview) {
        confirmedParts_ = flightParts_;
        confirmedShort_ = shortPart_;
    }
    setTextColour(flight_, preview ? meaningColours(palette()).muted : QColor());
    say(flightParts_);
    flight_->setToolTip({});
    obstacle_ = false;
}

void SurfacePage::say(const QString& text, const QString& shown)
{
    said_ = text;
    flight_->setText(shown.isEmpty() ? text : shown);
}

void SurfacePage::showObstacle(const QString& reason)
{
    setTextColour(flight_, meaningColours(palette()).muted);
    // As much of it as there is room for beside the state before; the tool tip has all of it.
    constexpr int characters = 34; // of "before: min 8.75 nm  +0.31 (±0.16)"
    const QFontMetrics metrics = flight_->fontMetrics();
    constexpr int longestWord = 14; // at the end of a line its room stays free
    const int lines = flight_->height() / metrics.lineSpacing(), line = flight_->contentsRect().width(),
              spent = flightParts_.isEmpty() ? 2 : characters;
    const int room = lines * line - (spent + (lines - 1) * longestWord) * metrics.averageCharWidth();
    const QString shown = metrics.elidedText(reason, Qt::ElideRight, std::max(room, line / 2));
    const QString before = flightParts_.isEmpty() ? QString() : tr(" &nbsp; before: ") + shortPart_;
    const auto problem = [&](const QString& words) {
        return QStringLiteral("<span style='color:%1'>%2</span>")
                   .arg(meaningColours(palette()).failure.name(), escaped(words)) +
               before;
    };
    say(problem(reason), problem(shown));
    flight_->setToolTip(plainTip(reason));
    reason_ = reason;
    obstacle_ = true;
}

void SurfacePage::clearObstacle()
{
    if (!obstacle_) return;
    if (flightParts_.isEmpty())
        clearFlight();
    else
        say(flightParts_);
    flight_->setToolTip({});
    obstacle_ = false;
}

void SurfacePage::showConfirmed()
{
    if (confirmedParts_.isEmpty()) return clearFlight();
    flightParts_ = confirmedParts_;
    shortPart_ = confirmedShort_;
    setTextColour(flight_, meaningColours(palette()).muted);
    say(flightParts_);
    flight_->setToolTip({});
    obstacle_ = false;
}

void SurfacePage::setStale(bool stale)
{
    if (!flightParts_.isEmpty()) setTextColour(flight_, stale ? meaningColours(palette()).muted : QColor());
}

void SurfacePage::clearFlight()
{
    flightParts_.clear();
    confirmedParts_.clear();
    setTextColour(flight_, meaningColours(palette()).muted);
    say(tr("Not solved yet: F9 finds how it flies."));
    flight_->setToolTip({});
    obstacle_ = false;
}

} // namespace touchdown

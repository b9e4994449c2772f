// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/modes_page.h"

#include <array>
#include <cmath>
#include <utility>

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>

#include "core/case/parameters.h"
#include "core/simulation/static_state/static_solution.h"
#include "ui/film/mode_motion.h"
#include "ui/film/mode_picture.h"
#include "ui/style/quantity_format.h"
#include "ui/style/theme.h"

namespace touchdown {

namespace {

constexpr std::array periods{16.0, 8.0, 4.0, 2.0, 1.0, 0.5}; // of a cycle on the screen [s]
constexpr int usualPeriod = 3;
constexpr int turnsColumn = 4; // takes the free width

QString remarksOn(const Case& c, const ModesResult& result)
{
    QStringList sentences;
    if (!result.message.empty()) sentences << sentence(result.message);
    if (c.steady.fixedAttitude && !result.modes.empty())
        sentences << ModesPage::tr("The attitude is held: the forces need not balance there.");
    if (!result.modes.empty())
        sentences << (result.steady.contact.acts()
                          ? ModesPage::tr("Small motions on the film and the contact of the static state, over a disk "
                                          "that does not move up and down.")
                          : ModesPage::tr("Small motions on the film alone over a flat disk, without contact.")) +
                         QLatin1Char(' ') +
                         ModesPage::tr("Errors of the damping are those of the grid, estimated from coarser ones.");
    return sentences.join(QLatin1Char(' '));
}

} // namespace

ModesPage::ModesPage(ModesController::Solver solver, QWidget* parent)
    : ResultPage(parent),
      controller_(std::move(solver)),
      picture_(new ModePicture(this)),
      play_(new QToolButton(this)),
      speed_(new QSlider(Qt::Horizontal, this)),
      cycle_(new QLabel(this))
{
    build(controller_,
          {tr("modes"), tr("search for modes"), tr("Searching"), tr("&Find the modes"),
           tr("Find the modes of the case about its static state, or stop the search"), tr("Air bearing modes"),
           tr("A slider that is pushed out of its static state swings back in its modes, each with a frequency and a "
              "damping ratio of its own. Press <i>Find the modes</i> to see them."),
           tr("First the static state is solved, then the modes about it are sought.")},
          nullptr, buildPicture(), {460, 170});
    connect(table(), &ResultTable::chosen, this, &ModesPage::showMode);
    connect(&controller_, &ModesController::finished, this,
            [this](int, const ModesResult& result) { onFinished(result); });
    showNotes();
}

QWidget* ModesPage::buildPicture()
{
    auto* part = new QWidget(this);
    play_->setAutoRaise(true);
    play_->setFocusPolicy(Qt::StrongFocus);
    play_->setToolTip(tr("Play or pause the motion (Space in the picture)"));
    connect(play_, &QToolButton::clicked, this, [this] { picture_->setPlaying(!picture_->playing()); });
    connect(picture_, &ModePicture::playingChanged, this, &ModesPage::showPlaying);
    showPlaying();
    auto* speedLabel = new QLabel(tr("Spee&d:"), part);
    speedLabel->setBuddy(speed_);
    speed_->setRange(0, static_cast<int>(periods.size()) - 1);
    speed_->setPageStep(1);
    speed_->setFixedWidth(120);
    speed_->setAccessibleName(tr("Speed of the motion on the screen"));
    connect(speed_, &QSlider::valueChanged, this, &ModesPage::showSpeed);
    speed_->setValue(usualPeriod);
    auto* tools = new QHBoxLayout;
    tools->setContentsMargins(8, 2, 8, 2);
    tools->setSpacing(8);
    tools->addWidget(play_);
    tools->addWidget(speedLabel);
    tools->addWidget(speed_);
    tools->addWidget(cycle_, 1);
    auto* layout = new QVBoxLayout(part);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(picture_, 1);
    layout->addLayout(tools);
    return part;
}

void ModesPage::setCase(const Case& c)
{
    case_ = c;
    refusal_.clear();
    showNotes();
}

void ModesPage::clear()
{
    controller_.stopAndWait();
    result_.reset();
    table()->setRows({}, {});
    picture_->setMode(std::nullopt, {});
    showResult(false);
    showNotes();
    emit changed();
}

std::optional<FoundModes> ModesPage::known() const
{
    if (!result_ || result_->modes.empty()) return std::nullopt;
    return FoundModes{solved_, *result_};
}

void ModesPage::restore(const FoundModes& modes)
{
    take(modes.value, modes.result);
    showNotes();
}

bool ModesPage::stale() const { return result_ && !sameFilm(case_, solved_); }

void ModesPage::startOrStop()
{
    if (controller_.active()) return controller_.stop();
    if (const auto problems = checkCombinations(case_); !problems.empty()) {
        refusal_ = sentence("the case contradicts itself: " + problems.front().key + " " + problems.front().message);
        showNotes();
        return;
    }
    refusal_.clear();
    asked_ = case_;
    Case wanted = case_;
    wanted.steady.stiffness = wanted.steady.sensitivities = wanted.steady.allEquilibria = false;
    controller_.start(std::move(wanted));
}

void ModesPage::onFinished(const ModesResult& result)
{
    progress().conclude(name(result.status),
                        result.modes.empty()
                            ? QString()
                            : tr("%1 × %2 cells").arg(result.steady.grid.nx()).arg(result.steady.grid.ny()));
    // A search that was stopped does not replace what is known.
    if (result.status != SteadyStatus::Cancelled) take(asked_, result);
    showNotes();
}

void ModesPage::take(const Case& c, const ModesResult& result)
{
    result_ = result;
    solved_ = c;
    forgetFile();
    if (!result.modes.empty()) picture_->setState(solved_, result.steady.attitude);
    std::vector<TableRow> rows;
    for (std::size_t i = 0; i < result.modes.size(); ++i) rows.push_back(rowOf(i));
    table()->setRows({{tr("No.")},
                      {tr("Motion")},
                      {tr("Frequency [kHz]")},
                      {tr("Damping ratio [%]")},
                      {tr("Where it turns")},
                      {tr("Remark")}},
                     rows);
    table()->fitColumns();
    table()->horizontalHeader()->setSectionResizeMode(turnsColumn, QHeaderView::Stretch);
    table()->selectRow(0);
    showResult(!rows.empty());
    emit found(solved_, result);
    emit changed();
}

TableRow ModesPage::rowOf(std::size_t index) const
{
    const AirBearingMode& mode = result_->modes[index];
    const bool known = !std::isnan(mode.dampingError);
    return {{QString::number(index + 1)},
            {kindWord(mode)},
            {typeset(mode.frequency / 1e3, 1), Qt::AlignCenter},
            {typeset(100.0 * mode.dampingRatio, 2), Qt::AlignCenter},
            {motionWords(mode, solved_.slider)},
            {known ? tr("damping ± %1 %").arg(typeset(100.0 * mode.dampingError, 2)) : QString()}};
}

void ModesPage::showMode(int row)
{
    const bool known = result_ && row >= 0 && row < static_cast<int>(result_->modes.size());
    if (!known) return picture_->setMode(std::nullopt, {});
    const AirBearingMode& mode = result_->modes[static_cast<std::size_t>(row)];
    picture_->setMode(mode, tr("Mode %1: %2, %3, damping ratio %4 %, %5")
                                .arg(row + 1)
                                .arg(kindWord(mode).toLower(), frequencyText(mode.frequency),
                                     typeset(100.0 * mode.dampingRatio, 2), motionWords(mode, solved_.slider)));
    showSpeed();
}

void ModesPage::showSpeed()
{
    const double period = periods[static_cast<std::size_t>(speed_->value())];
    picture_->setPeriod(period);
    const auto& mode = picture_->mode();
    cycle_->setText(mode ? tr("One cycle: %1 here, %2 in reality. The motion is drawn large and without its decay; the "
                              "slider is drawn higher by as much.")
                               .arg(roundedText(period, "s", 2), timeText(1.0 / mode->frequency))
                         : QString());
    cycle_->setMinimumWidth(1);
    cycle_->setWordWrap(true);
}

ResultPage::Notes ModesPage::notes() const
{
    return {!refusal_.isEmpty() ? refusal_
            : result_           ? remarksOn(solved_, *result_)
                                : QString(),
            !refusal_.isEmpty() || (result_ && result_->modes.empty()), stale() && !controller_.active()};
}

void ModesPage::showPlaying()
{
    play_->setAccessibleName(picture_->playing() ? tr("Pause the motion") : tr("Play the motion"));
    play_->setIcon(icon(picture_->playing() ? QStringLiteral("pause") : QStringLiteral("run"), palette()));
}

void ModesPage::changeEvent(QEvent* event)
{
    ResultPage::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) showPlaying();
}

} // namespace touchdown

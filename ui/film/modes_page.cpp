// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/modes_page.h"

#include <array>
#include <cmath>
#include <utility>

#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QShortcut>
#include <QVBoxLayout>

#include "core/case/parameters.h"
#include "core/simulation/static_state/static_solution.h"
#include "ui/calculation/progress_strip.h"
#include "ui/film/mode_motion.h"
#include "ui/film/mode_picture.h"
#include "ui/film/result_pages.h"
#include "ui/style/quantity_format.h"
#include "ui/style/theme.h"
#include "ui/style/whole_file.h"

namespace touchdown {

namespace {

constexpr std::array periods{16.0, 8.0, 4.0, 2.0, 1.0, 0.5}; // of a cycle on the screen [s]
constexpr int usualPeriod = 3;
constexpr int columnGap = 16; // [px]

enum ModeColumn { Number, Motion, Frequency, Damping, Turns, Remark };

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
    : QWidget(parent),
      controller_(std::move(solver)),
      start_(new QPushButton(this)),
      progress_(new ProgressStrip(controller_, tr("search for modes"), tr("Searching"), this)),
      stale_(new QLabel(tr("The parameters have changed since this was solved."), this)),
      remarks_(new QLabel(this)),
      empty_(new QLabel(this)),
      cycle_(new QLabel(this)),
      pages_(new QStackedWidget(this)),
      picture_(new ModePicture(this)),
      play_(new QToolButton(this)),
      copy_(new QToolButton(this)),
      speed_(new QSlider(Qt::Horizontal, this)),
      table_(new QTableWidget(this))
{
    addResultPages(*pages_, *empty_, buildPicture(), buildTable(), {460, 170});
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(buildHead());
    layout->addWidget(remarks_);
    layout->addWidget(pages_, 1);

    connect(&controller_, &ModesController::finished, this,
            [this](int, const ModesResult& result) { onFinished(result); });
    connect(&controller_, &ModesController::stateChanged, this, &ModesPage::showNotes);
    showNotes();
}

QWidget* ModesPage::buildHead()
{
    auto* row = new QWidget(this);
    start_->setAutoDefault(false);
    start_->setToolTip(tr("Find the modes of the case about its static state, or stop the search"));
    connect(start_, &QPushButton::clicked, this, &ModesPage::startOrStop);
    empty_->setTextFormat(Qt::RichText);
    remarks_->setWordWrap(true);
    remarks_->setContentsMargins(10, 2, 10, 4);
    remarks_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    remarks_->setAccessibleName(tr("Remarks on the modes"));
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(8, 4, 8, 4);
    layout->addWidget(start_);
    layout->addWidget(progress_, 1);
    layout->addWidget(stale_);
    return row;
}

QWidget* ModesPage::buildPicture()
{
    auto* part = new QWidget(this);
    play_->setAutoRaise(true);
    play_->setFocusPolicy(Qt::StrongFocus);
    play_->setToolTip(tr("Play or pause the motion (Space in the picture)"));
    connect(play_, &QToolButton::clicked, this, [this] { picture_->setPlaying(!picture_->playing()); });
    connect(picture_, &ModePicture::playingChanged, this, &ModesPage::showNotes);
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

QWidget* ModesPage::buildTable()
{
    auto* part = new QWidget(this);
    table_->setAccessibleName(tr("Table of the modes"));
    makePlainTable(table_, {tr("No."), tr("Motion"), tr("Frequency [kHz]"), tr("Damping ratio [%]"),
                            tr("Where it turns"), tr("Remark")});
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Interactive);
    table_->horizontalHeader()->setSectionResizeMode(Turns, QHeaderView::Stretch);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setTabKeyNavigation(false);
    table_->horizontalHeader()->setHighlightSections(false); // bold heads would need wider columns
    table_->verticalHeader()->setDefaultSectionSize(static_cast<int>(1.6 * fontMetrics().height()));
    connect(table_, &QTableWidget::currentCellChanged, this, [this](int row) { showMode(row); });
    auto* shortcut = new QShortcut(QKeySequence::Copy, table_, nullptr, nullptr, Qt::WidgetShortcut);
    connect(shortcut, &QShortcut::activated, this, &ModesPage::copy);
    copy_->setText(tr("Copy"));
    copy_->setToolTip(tr("Copy the table for a spreadsheet"));
    copy_->setAccessibleName(tr("Copy the table of the modes"));
    copy_->setAutoRaise(true);
    copy_->setFocusPolicy(Qt::TabFocus);
    connect(copy_, &QToolButton::clicked, this, &ModesPage::copy);
    auto* tools = new QHBoxLayout;
    tools->setContentsMargins(6, 0, 6, 2);
    tools->addStretch(1);
    tools->addWidget(copy_);
    auto* layout = new QVBoxLayout(part);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(table_, 1);
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
    table_->setRowCount(0);
    picture_->setMode(std::nullopt, {});
    pages_->setCurrentIndex(0);
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

QString ModesPage::save(const QString& path)
{
    QString problem = writeWholeFile(path, csvOf(*result_));
    saved_ = problem.isEmpty() ? SavedFile(path) : SavedFile();
    return problem;
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
    progress_->conclude(name(result.status),
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
    saved_ = {};
    if (!result.modes.empty()) picture_->setState(solved_, result.steady.attitude);
    fillTable();
    pages_->setCurrentIndex(result.modes.empty() ? 0 : 1);
    emit found(solved_, result);
    emit changed();
}

void ModesPage::fillTable()
{
    const std::vector<AirBearingMode>& all = result_->modes;
    table_->setRowCount(0);
    table_->setRowCount(static_cast<int>(all.size()));
    for (int row = 0; row < table_->rowCount(); ++row) {
        const AirBearingMode& mode = all[static_cast<std::size_t>(row)];
        const bool known = !std::isnan(mode.dampingError);
        const QStringList cells{QString::number(row + 1),
                                kindWord(mode),
                                typeset(mode.frequency / 1e3, 1),
                                typeset(100.0 * mode.dampingRatio, 2),
                                motionWords(mode, solved_.slider),
                                known ? tr("damping ± %1 %").arg(typeset(100.0 * mode.dampingError, 2)) : QString()};
        for (int column = 0; column < cells.size(); ++column) {
            auto* item = new QTableWidgetItem(cells[column]);
            if (column == Frequency || column == Damping) item->setTextAlignment(Qt::AlignCenter);
            table_->setItem(row, column, item);
        }
    }
    table_->resizeColumnsToContents();
    for (int column = 0; column < table_->columnCount(); ++column)
        if (column != Turns) table_->setColumnWidth(column, table_->columnWidth(column) + columnGap);
    if (!all.empty()) table_->setCurrentCell(0, 0);
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

void ModesPage::showNotes()
{
    const bool active = controller_.active();
    start_->setText(active ? tr("Stop") : tr("&Find the modes"));
    empty_->setText(
        QStringLiteral("<h2>%1</h2><p>%2</p>")
            .arg(tr("Air bearing modes"),
                 active ? tr("First the static state is solved, then the modes about it are sought.")
                        : tr("A slider that is pushed out of its static state swings back in its modes, each with a "
                             "frequency and a damping ratio of its own. Press <i>Find the modes</i> to see them.")));
    start_->setEnabled(controller_.state() != ModesController::State::Stopping);
    setTextColour(stale_, meaningColours(palette()).warning);
    stale_->setVisible(stale() && !active);
    const bool failed = !refusal_.isEmpty() || (result_ && result_->modes.empty());
    setTextColour(remarks_, failed ? meaningColours(palette()).failure : meaningColours(palette()).muted);
    remarks_->setText(!refusal_.isEmpty() ? refusal_ : result_ ? remarksOn(solved_, *result_) : QString());
    remarks_->setVisible(!remarks_->text().isEmpty());
    play_->setAccessibleName(picture_->playing() ? tr("Pause the motion") : tr("Play the motion"));
    play_->setIcon(icon(picture_->playing() ? QStringLiteral("pause") : QStringLiteral("run"), palette()));
}

void ModesPage::copy() const { QGuiApplication::clipboard()->setText(tableText(*table_)); }

void ModesPage::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) showNotes();
}

} // namespace touchdown

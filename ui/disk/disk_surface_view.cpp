// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/disk/disk_surface_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>

#include <QHBoxLayout>
#include <QHeaderView>
#include <QSignalBlocker>
#include <QSplitter>
#include <QVBoxLayout>

#include "core/formats/units.h"
#include "core/physics/disk/disk_surface_check.h"
#include "ui/maps/field_map.h"
#include "ui/maps/fields_view.h"
#include "ui/plot/plot_group.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

namespace {

constexpr int quietTime = 250;    // without another request, before a surface is made [ms]
constexpr int stepsPerPiece = 8;  // of the slider
constexpr double faintest = 1e-9; // of the density that is shown, against its largest

/// Everything that the picture depends on.
bool sameSurface(const Case& a, const Case& b) { return a.diskSurface == b.diskSurface && a.folder == b.folder; }

} // namespace

DiskSurfaceController::DiskSurfaceController(Maker maker, QObject* parent)
    : CalculationController(parent), maker_(std::move(maker))
{
    pause_.setSingleShot(true);
    pause_.setInterval(quietTime);
    connect(&pause_, &QTimer::timeout, this, &DiskSurfaceController::make);
}

void DiskSurfaceController::request(const Case& c)
{
    wanted_ = c;
    busy_ = true;
    ++requested_;
    pause_.start();
}

void DiskSurfaceController::cancel()
{
    pause_.stop();
    busy_ = false;
    ++requested_;
}

void DiskSurfaceController::make()
{
    if (active()) return; // `deliver` calls again
    making_ = requested_;
    begin([this, c = wanted_](const std::stop_token&) {
        DiskSurfacePreview preview;
        try {
            preview = maker_(c);
        } catch (const std::exception& problem) { // a map that is too large for the memory
            preview = {};
            preview.problem = std::string("The surface cannot be made: ") + problem.what();
        }
        mailbox_.post([&](std::optional<DiskSurfacePreview>& mail) { mail = std::move(preview); });
    });
}

void DiskSurfaceController::deliver()
{
    std::optional<DiskSurfacePreview> ready = mailbox_.take();
    if (!ready) return;
    end();
    if (!busy_ || pause_.isActive()) return;
    if (making_ != requested_) {
        make();
        return;
    }
    busy_ = false;
    made_ = std::move(*ready);
    emit made();
}

DiskSurfaceView::DiskSurfaceView(QWidget* parent, DiskSurfaceController::Maker maker)
    : QWidget(parent),
      controller_(std::move(maker)),
      pages_(new QStackedWidget(this)),
      text_(new QLabel(this)),
      view_(new FieldsView(this)),
      place_(new QSlider(Qt::Horizontal, this)),
      placeText_(new QLabel(this)),
      spectrum_(new PlotWidget(this)),
      spectrumGroup_(new PlotGroup(this)),
      statistics_(new ResultTable(tr("Statistics of the surface"), this))
{
    build();
    connect(&controller_, &DiskSurfaceController::made, this, &DiskSurfaceView::onMade);
    connect(place_, &QSlider::valueChanged, this, &DiskSurfaceView::showPiece);
}

void DiskSurfaceView::build()
{
    view_->setKinds({{.title = tr("Height of the disk"),
                      .units = {"nm", "um"},
                      .colours = MapKind::Colours::Signed,
                      .aboutZero = true}});

    spectrumGroup_->add(spectrum_);
    spectrum_->setTitle(tr("Spectrum"));
    spectrum_->setXLabel({tr("Wave number"), tr("rad/µm"), 1e6, AxisScale::Logarithmic});
    spectrum_->setYLabel({tr("Density"), QStringLiteral("nm²·µm"), 1e-24, AxisScale::Logarithmic});

    statistics_->setMinimumWidth(270);

    place_->setAccessibleName(tr("Place along the track"));
    place_->setToolTip(tr("Move along the track (arrow keys, Home, End)"));
    auto* footRow = new QHBoxLayout;
    footRow->setContentsMargins(10, 2, 10, 4);
    footRow->setSpacing(12);
    footRow->addWidget(place_, 1);
    footRow->addWidget(placeText_);
    footRow->addWidget(view_->controls());

    auto* upper = new QWidget(this);
    auto* upperLayout = new QVBoxLayout(upper);
    upperLayout->setContentsMargins(0, 0, 0, 0);
    upperLayout->setSpacing(0);
    upperLayout->addWidget(view_, 1);
    upperLayout->addLayout(footRow);
    auto* lower = new QSplitter(Qt::Horizontal, this);
    lower->addWidget(spectrum_);
    lower->addWidget(statistics_);
    lower->setStretchFactor(0, 3);
    lower->setStretchFactor(1, 2);
    lower->setChildrenCollapsible(false);
    lower->setSizes({480, 320});
    auto* whole = new QSplitter(Qt::Vertical, this);
    whole->addWidget(upper);
    whole->addWidget(lower);
    whole->setStretchFactor(0, 3);
    whole->setStretchFactor(1, 2);
    whole->setSizes({520, 320});
    whole->setChildrenCollapsible(false);

    text_->setAlignment(Qt::AlignCenter);
    text_->setWordWrap(true);
    text_->setAutoFillBackground(true);
    text_->setBackgroundRole(QPalette::Base); // as the maps shown later
    pages_->addWidget(text_);
    pages_->addWidget(whole);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(pages_);
}

void DiskSurfaceView::setCase(const Case& c)
{
    if (wanted_ && sameSurface(c, case_)) return;
    if (!wanted_ && sameSurface(c, case_) && (!empty() || controller_.busy())) return;
    case_ = c;
    wanted_ = true;
    controller_.cancel();
    if (isVisible()) request();
}

void DiskSurfaceView::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    if (wanted_) request();
}

void DiskSurfaceView::request()
{
    wanted_ = false;
    if (case_.diskSurface.kind == DiskSurfaceKind::Flat) {
        controller_.cancel();
        return say(tr("The surface of the disk is flat."));
    }
    // The previous surface remains visible until the new one is ready.
    if (empty())
        say(tr("Making the surface…"));
    else
        placeText_->setText(tr("Making the surface…"));
    controller_.request(case_);
}

void DiskSurfaceView::say(const QString& sentence)
{
    text_->setText(sentence);
    pages_->setCurrentIndex(0);
}

void DiskSurfaceView::onMade()
{
    preview_ = controller_.take();
    if (!preview_.problem.empty()) return say(touchdown::sentence(preview_.problem));
    if (preview_.topography.flat()) return say(tr("The surface of the disk is flat."));
    const UniformGrid period = preview_.topography.period();
    const double length = pieceLength(preview_.topography);
    const double track = period.nx * period.dx;
    {
        const QSignalBlocker quiet(place_);
        place_->setRange(0, static_cast<int>(std::ceil((track - length) / length * stepsPerPiece - 1e-6)));
        place_->setPageStep(stepsPerPiece);
        // Bumps are few: the piece begins where the first one is in sight.
        const std::vector<double>& bumps = preview_.asked.bumpX;
        const double begin =
            hasBumps(preview_.asked) && !bumps.empty() ? bumps.front() - period.x0 - 0.5 * length : 0.0;
        place_->setValue(static_cast<int>(begin / length * stepsPerPiece));
    }
    place_->setEnabled(place_->maximum() > 0);
    pages_->setCurrentIndex(1);
    showPiece();
    showSpectrum();
    showStatistics();
    fit();
}

void DiskSurfaceView::showPiece()
{
    if (empty()) return;
    const UniformGrid period = preview_.topography.period();
    const double length = pieceLength(preview_.topography);
    const double last = std::max(0.0, period.nx * period.dx - length);
    const double x0 = period.x0 + std::min(last, place_->value() * length / stepsPerPiece);
    DiskSurfacePiece piece = pieceOf(preview_.topography, x0, length);
    const CellGrid& grid = piece.grid;
    view_->map()->setPiece(
        {grid.x.front(), grid.y.front(), grid.x.back() - grid.x.front(), grid.y.back() - grid.y.front()});
    if (!view_->pinned() || !view_->map()->onSlider(*view_->sectionPoint()))
        view_->setSectionPoint({grid.centreX(grid.nx() / 2), grid.centreY(grid.ny() / 2)}, false);
    const SurfaceStatistics& s = preview_.statistics;
    view_->setFields(grid, {std::move(piece.heights)}, {{s.minimum, s.maximum}});
    // The first point of the map lies at 0, in the middle of its cell.
    const double begin = x0 - period.x0;
    placeText_->setText(
        tr("x from %1 to %2 of %3").arg(trackText(begin), trackText(begin + length), trackText(period.nx * period.dx)));
}

void DiskSurfaceView::showSpectrum()
{
    spectrum_->clearCurves();
    const ProfilePsd& psd = preview_.psd;
    std::array<std::vector<double>, 4> values{{{}, {}, {}, psd.density}}; // upper curves cover lower ones
    for (const RequestedPsd& asked : preview_.requested) {
        values[0].push_back(asked.density);
        values[1].push_back(asked.low);
        values[2].push_back(asked.high);
    }
    const double least = psd.density.empty() ? 0.0 : faintest * *std::ranges::max_element(psd.density);
    const std::array<std::pair<QString, CurveStyle>, 4> looks{
        {{tr("Asked"), {6, 0}}, {tr("95 %"), {6, 2}}, {{}, {6, 2}}, {tr("Surface"), {0, 0}}}};
    curves_.clear();
    curves_.reserve(values.size()); // curves point to them
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (values[i].empty()) continue;
        std::vector<double> at, density;
        const auto seen = [&](std::size_t k) { return k < values[i].size() && values[i][k] > least; };
        const bool own = i + 1 == values.size();
        for (std::size_t k = 0; k < values[i].size(); ++k) {
            // Beside a wave that stands alone the line goes down: a single point is no line.
            if (!seen(k) && !(own && (seen(k - 1) || seen(k + 1)))) continue;
            at.push_back(psd.waveNumber[k]);
            density.push_back(std::max(values[i][k], least));
        }
        curves_.emplace_back().append(at, density);
        spectrum_->addCurve({QStringLiteral("psd %1").arg(i), looks[i].first, looks[i].second, &curves_.back()});
    }
    spectrumGroup_->dataChanged();
}

void DiskSurfaceView::showStatistics()
{
    std::vector<TableRow> rows;
    for (const QStringList& row : diskStatistics(preview_))
        rows.push_back({{row.value(0)}, numberCell(row.value(1)), numberCell(row.value(2))});
    statistics_->setRows({{tr("Quantity")}, {tr("Surface")}, {tr("Asked for")}}, rows);
    statistics_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    statistics_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
}

void DiskSurfaceView::fit()
{
    view_->fit();
    spectrumGroup_->fit();
}

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
//
// What lies under the outlines of the editor: the pressure of a solution, a drawing to trace.
#include <algorithm>
#include <cmath>
#include <iterator>

#include <QDropEvent>
#include <QMimeData>
#include <QUrl>

#include "core/case_files/surface_text.h"
#include "core/formats/dxf_surface.h"
#include "ui/slider/cell_painting.h"
#include "ui/slider/surface_editor.h"
#include "ui/slider/underlay_dialog.h"

namespace touchdown {

namespace {

constexpr double kilopascal = 1e3; // [Pa]

QString droppedDrawing(const QMimeData& data)
{
    for (const QUrl& url : data.urls())
        if (Underlay::canLoad(url.toLocalFile())) return url.toLocalFile();
    return {};
}

} // namespace

void SurfaceEditor::setPressure(std::vector<double> pressure)
{
    pressure_ = std::move(pressure);
    pressureKey_.height = -1;
    forgetLayout(); // the numbers of its bar may need another width
    if (isFitted()) fit();
    update();
}

void SurfaceEditor::showPressure(bool shown, bool pale)
{
    pressureShown_ = shown;
    pressurePale_ = pale;
    update();
}

bool SurfaceEditor::showsPressure() const
{
    return pressureShown_ && !pressure_.empty() &&
           pressure_.size() == static_cast<std::size_t>(grid().nx()) * static_cast<std::size_t>(grid().ny());
}

ColourScale SurfaceEditor::pressureScale(const PlotTheme& theme) const
{
    const bool dark = theme.background.lightness() < 128;
    const auto [low, high] = std::ranges::minmax(pressure_);
    return ColourScale::aboutZero(dark ? ColourMap::DivergingOnDark : ColourMap::DivergingOnLight, low, high);
}

std::vector<ScaleTick> SurfaceEditor::pressureTicks(const ColourScale& scale, double height) const
{
    return scale.ticks(kilopascal, colourBarRoom(font(), std::max(100.0, height)));
}

/// What is drawn in the place of the recess: pressure, influence, or nothing but outlines over a drawing to trace.
bool SurfaceEditor::paintTops(QPainter& painter, const PlotTheme& theme) const
{
    const bool influenced = !dragging() && influenceScale(influence_, theme).has_value();
    if (!showsPressure() && !influenced && !underlay_->shown()) return false;
    const QRectF slider(toPixel({area().left(), area().bottom()}), toPixel({area().right(), area().top()}));
    painter.fillRect(slider, theme.plotArea);
    if (showsPressure()) {
        constexpr double pale = 0.35;
        painter.setOpacity(pressurePale_ || gestures_.moving() ? pale : 1.0);
        paintCells(painter, *this, pressure_, pressureScale(theme));
        painter.setOpacity(1.0);
    } else if (influenced) {
        paintInfluenceTops(painter, *this, influence_, theme);
    }
    if (underlay_->shown()) underlay_->paint(painter, *this, theme);
    return true;
}

void SurfaceEditor::placeUnderlay()
{
    const auto ask = [this] { askForUnderlay(this, [this](const QString& file) { loadUnderlay(file); }); };
    if (!underlay_->loaded()) return ask();
    if (auto* open = findChild<UnderlayDialog*>()) return open->raise();
    auto* dialog = new UnderlayDialog(*underlay_, this);
    connect(dialog, &UnderlayDialog::fileWanted, this, ask);
    connect(dialog, &UnderlayDialog::railsWanted, this, &SurfaceEditor::takeRailsOfDrawing);
    dialog->show();
}

/// The form opens with the file.
void SurfaceEditor::loadUnderlay(const QString& file)
{
    underlay_->load(file, area().width(), area().height(), [this] { placeUnderlay(); });
}

void SurfaceEditor::takeRailsOfDrawing()
{
    constexpr std::size_t most = 300; // rails that a window draws while one is dragged
    const auto [rails, tooManyOpenLines] = railsOfDrawing(underlay_->paths(), area().width(), area().height());
    if (tooManyOpenLines && rails.empty())
        return emit underlay_->failed(tr("The drawing has more than 5000 open lines, too many to join to outlines."));
    if (rails.empty()) return emit underlay_->failed(tr("The drawing has no closed outline but that of the slider."));
    if (rails.size() > most)
        return emit underlay_->failed(
            tr("The drawing has %1 closed outlines; at most %2 are taken as rails.").arg(rails.size()).arg(most));
    // The checks of an edit compare each edge of a rail with all others, and a case file has its limits.
    constexpr std::size_t mostCorners = 2000; // of one rail
    AirBearingSurface surface = committed();
    std::size_t corners = 0, longest = 0;
    bool far = false;
    for (const Rail& rail : rails) {
        longest = std::max(longest, rail.points.size());
        const auto isFar = [](const RailPoint& p) { return !(std::abs(p.x) <= 1.0 && std::abs(p.y) <= 1.0); }; // [m]
        far = far || std::ranges::any_of(rail.points, isFar);
    }
    std::ranges::copy(rails, std::back_inserter(surface.rails));
    for (const Rail& rail : surface.rails) corners += rail.points.size();
    if (longest > mostCorners)
        return emit underlay_->failed(
            tr("An outline of the drawing has %1 corners; a rail taken from it has at most %2.")
                .arg(longest)
                .arg(mostCorners));
    if (far) return emit underlay_->failed(tr("An outline of the drawing is more than 1 m away from the slider."));
    if (surface.rails.size() > mostRails || corners > mostRailPoints)
        return emit underlay_->failed(
            tr("With the outlines of the drawing there would be %1 rails with %2 corners; a case "
               "has at most %3 and %4.")
                .arg(surface.rails.size())
                .arg(corners)
                .arg(mostRails)
                .arg(mostRailPoints));
    emit edited(surface, tr("take %1 rails of a drawing").arg(rails.size()), 0);
}

void SurfaceEditor::dragEnterEvent(QDragEnterEvent* event)
{
    if (!droppedDrawing(*event->mimeData()).isEmpty())
        event->acceptProposedAction();
    else
        event->ignore(); // the window may open it
}

void SurfaceEditor::dropEvent(QDropEvent* event)
{
    loadUnderlay(droppedDrawing(*event->mimeData()));
    event->acceptProposedAction();
}

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Quantities that are dragged into the plots.
#include "ui/runs/live_plots.h"

#include <algorithm>

#include <QDropEvent>

#include "ui/plot/plot_widget.h"
#include "ui/runs/drop_hint.h"
#include "ui/runs/quantity_list.h"

namespace touchdown {

/// What a drop at this place does.
LivePlots::Drop LivePlots::dropAt(const QPoint& at, const QMimeData& dragged) const
{
    const std::optional<std::string> name = draggedQuantity(dragged);
    const std::vector<Quantity> known = quantities();
    const int index = name ? findQuantity(known, *name) : -1;
    if (index < 0) return {};
    Drop drop{known[static_cast<std::size_t>(index)], {}, hint_->strip(), tr("A plot of its own"), {}};
    if (drop.target.contains(at)) return drop;
    for (std::size_t s = 0; s < entries_.size(); ++s) {
        const PlotWidget* plot = entries_[s].plot;
        if (!plot->isVisible() || !plot->geometry().contains(at)) continue;
        drop.plot = entries_[s].name;
        drop.target = plot->geometry();
        drop.text = tr("Add to \"%1\"").arg(specs_[s].title);
        drop.refusal = specs_[s].refusal(*drop.quantity);
    }
    return drop; // beside all plots: a plot of its own
}

void LivePlots::dragEnterEvent(QDragEnterEvent* event)
{
    if (draggedQuantity(*event->mimeData())) event->acceptProposedAction();
}

void LivePlots::dragMoveEvent(QDragMoveEvent* event)
{
    const Drop drop = dropAt(event->position().toPoint(), *event->mimeData());
    if (!drop.quantity) return event->ignore();
    hint_->show(drop.target, drop.refusal.isEmpty() ? drop.text : drop.refusal, !drop.refusal.isEmpty());
    event->acceptProposedAction(); // a refusal is said, too
}

void LivePlots::dragLeaveEvent(QDragLeaveEvent*) { hint_->hide(); }

void LivePlots::dropEvent(QDropEvent* event)
{
    hint_->hide();
    const Drop drop = dropAt(event->position().toPoint(), *event->mimeData());
    if (!drop.quantity) return event->ignore();
    event->acceptProposedAction();
    if (drop.plot.isEmpty())
        addPlot(*drop.quantity);
    else if (const QString refusal = addCurve(drop.plot, *drop.quantity); !refusal.isEmpty())
        emit refused(refusal);
}

} // namespace touchdown

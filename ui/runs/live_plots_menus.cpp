// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the user changes about the plots: the quantities on their axes.
#include "ui/runs/live_plots.h"

#include <algorithm>
#include <functional>

#include "core/simulation/recording/quantity.h"
#include "ui/plot/plot_group.h"
#include "ui/runs/run_record.h"
#include "ui/runs/runs_model.h"

namespace touchdown {

namespace {

/// A menu in the menu of `plot`, filled when it opens.
void addMenu(PlotWidget* plot, const QString& text, const std::function<void(QMenu&)>& fill)
{
    auto* menu = new QMenu(text, plot);
    QObject::connect(menu, &QMenu::aboutToShow, plot, [menu, fill] {
        menu->clear();
        fill(*menu);
    });
    plot->addAction(menu->menuAction());
}

void addChoice(QMenu& menu, const QString& text, bool chosen, PlotWidget* plot, const std::function<void()>& choose)
{
    QAction* action = menu.addAction(text);
    action->setCheckable(true);
    action->setChecked(chosen);
    QObject::connect(action, &QAction::triggered, plot, choose);
}

} // namespace

std::vector<Quantity> LivePlots::quantities() const
{
    std::vector<Quantity> all;
    const auto add = [&all](const std::vector<Quantity>& more) {
        for (const Quantity& quantity : more)
            if (findQuantity(all, quantity.name) < 0) all.push_back(quantity);
    };
    for (int row = runs_.count() - 1; row >= 0; --row)
        if (runs_.record(row).shown) add(runs_.record(row).quantities);
    add(ready_);
    return all;
}

void LivePlots::setAxes(const QString& name, const std::optional<Quantity>& across, const std::optional<Quantity>& up)
{
    const std::size_t s = indexOf(name);
    Q_ASSERT(specs_[s].choosable);
    noteHiddenCurves();
    entries_[s].plot->clearCurves();
    if (up) specs_[s].setUp(*up);
    specs_[s].setAcross(across);
    labelAxes(s);
    placePlot(s);
    rebuild();
    group_->forgetHistory(); // its steps are of other axes
}

void LivePlots::addMenus(const QString& name)
{
    PlotWidget* plot = this->plot(name);
    if (!spec(name).choosable) return;
    addMenu(plot, tr("&Across"), [this, name, plot](QMenu& menu) {
        const std::optional<Quantity> now = spec(name).across;
        addChoice(menu, tr("Time"), !now, plot, [this, name] { setAxes(name, std::nullopt, std::nullopt); });
        for (const Quantity& quantity : quantities())
            addChoice(menu, QString::fromStdString(quantity.longName), now && now->name == quantity.name, plot,
                      [this, name, quantity] { setAxes(name, quantity, std::nullopt); });
    });
    addMenu(plot, tr("&Up"), [this, name, plot](QMenu& menu) {
        for (const Quantity& quantity : quantities())
            addChoice(menu, QString::fromStdString(quantity.longName), spec(name).has(quantity.name), plot,
                      [this, name, quantity] { setAxes(name, spec(name).across, quantity); });
    });
}

} // namespace touchdown

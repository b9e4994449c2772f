// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the user changes about the plots: which there are, their curves, the quantities on their axes.
#include "ui/runs/live_plots.h"

#include <algorithm>
#include <functional>

#include "core/simulation/recording/quantity.h"
#include "ui/plot/plot_group.h"
#include "ui/runs/live_spectrogram.h"
#include "ui/runs/run_record.h"
#include "ui/runs/runs_model.h"
#include "ui/style/foreign_text.h"

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
    labelPlots();
    placePlot(s);
    rebuild();
    group_->forgetHistory(); // its steps are of other axes
}

QString LivePlots::addPlot(const Quantity& up)
{
    int number = 1;
    const auto name = [&number] { return QStringLiteral("own %1").arg(number); };
    while (std::ranges::find(entries_, name(), &Entry::name) != entries_.end()) ++number;
    specs_.push_back(ownPlot(name(), up, std::nullopt));
    makePlot(specs_.size() - 1);
    labelPlots();
    updateWanted();
    rebuild();
    emit plotsChanged();
    return name();
}

void LivePlots::removePlot(const QString& own)
{
    const std::size_t s = indexOf(own);
    Q_ASSERT(specs_[s].own);
    const auto place = static_cast<std::ptrdiff_t>(s);
    PlotWidget* plot = entries_[s].plot;
    group_->remove(plot);
    plot->hide();
    plot->deleteLater(); // its own menu may be asking
    entries_[s].wanted->deleteLater();
    entries_.erase(entries_.begin() + place);
    specs_.erase(specs_.begin() + place);
    labelPlots();
    std::erase_if(chosen_, [&own](const auto& item) { return item.first.second == own; });
    std::erase_if(wanted_,
                  [prefix = own.toStdString() + '/'](const auto& item) { return item.first.starts_with(prefix); });
    group_->forgetHistory();
    updateVisibility();
    emit plotsChanged();
    emit curvesChanged();
}

QString LivePlots::addCurve(const QString& name, const Quantity& quantity)
{
    const std::size_t s = indexOf(name);
    const QString refusal = specs_[s].refusal(quantity);
    if (!refusal.isEmpty()) return refusal;
    noteHiddenCurves();
    specs_[s].add(quantity);
    labelPlots();
    rebuild();
    return {};
}

void LivePlots::removeCurve(const QString& name, const std::string& quantity)
{
    const std::size_t s = indexOf(name);
    noteHiddenCurves();
    specs_[s].remove(quantity);
    labelPlots();
    rebuild();
}

void LivePlots::addMenus(const QString& name)
{
    PlotWidget* plot = this->plot(name);
    if (spec(name).spectrogram) return addSpectrogramMenus();
    addMenu(plot, tr("A&dd a curve"), [this, name, plot](QMenu& menu) {
        for (const Quantity& quantity : quantities())
            if (spec(name).refusal(quantity).isEmpty())
                menu.addAction(onButton(QString::fromStdString(quantity.longName)), plot,
                               [this, name, quantity] { addCurve(name, quantity); });
        if (menu.isEmpty()) menu.addAction(tr("No other quantity has this unit"))->setEnabled(false);
    });
    addMenu(plot, tr("Re&move a curve"), [this, name, plot](QMenu& menu) {
        for (const PlotSpec::Curve& curve : spec(name).curves)
            if (curve.added && spec(name).curves.size() > 1)
                menu.addAction(onButton(curve.name), plot,
                               [this, name, quantity = curve.quantity] { removeCurve(name, quantity); });
        if (menu.isEmpty()) menu.addAction(tr("None was added"))->setEnabled(false);
    });
    if (!spec(name).choosable) return;
    addMenu(plot, tr("&Across"), [this, name, plot](QMenu& menu) {
        const std::optional<Quantity> now = spec(name).across;
        addChoice(menu, tr("Time"), !now, plot, [this, name] { setAxes(name, std::nullopt, std::nullopt); });
        for (const Quantity& quantity : quantities())
            addChoice(menu, onButton(QString::fromStdString(quantity.longName)), now && now->name == quantity.name,
                      plot, [this, name, quantity] { setAxes(name, quantity, std::nullopt); });
    });
    addMenu(plot, tr("&Up"), [this, name, plot](QMenu& menu) {
        for (const Quantity& quantity : quantities())
            addChoice(menu, onButton(QString::fromStdString(quantity.longName)), spec(name).has(quantity.name), plot,
                      [this, name, quantity] { setAxes(name, spec(name).across, quantity); });
    });
    if (!spec(name).own) return;
    auto* remove = new QAction(tr("Remove this &plot"), plot);
    connect(remove, &QAction::triggered, this, [this, name] { removePlot(name); });
    plot->addAction(remove);
}

void LivePlots::addSpectrogramMenus()
{
    const QString name = QStringLiteral("spectrogram");
    PlotWidget* plot = this->plot(name);
    addMenu(plot, tr("&Quantity"), [this, name, plot](QMenu& menu) {
        for (const Quantity& quantity : quantities())
            addChoice(menu, onButton(QString::fromStdString(quantity.longName)), spec(name).has(quantity.name), plot,
                      [this, name, quantity] { setAxes(name, std::nullopt, quantity); });
    });
    addMenu(plot, tr("&Window"), [this, plot](QMenu& menu) {
        const std::size_t now = spectrogram_->window();
        addChoice(menu, tr("Automatic"), now == 0, plot, [this] { spectrogram_->setWindow(0); });
        for (std::size_t length = 64; length <= 16384; length *= 2)
            addChoice(menu, tr("%1 samples").arg(length), now == length, plot,
                      [this, length] { spectrogram_->setWindow(length); });
    });
}

QJsonObject LivePlots::arrangement() const
{
    QJsonArray chosen;
    for (const auto& [key, on] : chosen_)
        chosen.append(QJsonObject{{"model", static_cast<int>(key.first)}, {"plot", key.second}, {"shown", on}});
    return {{"plots", changedPlots(specs_)}, {"chosen", chosen}, {"window", static_cast<int>(spectrogram_->window())}};
}

void LivePlots::restore(const QJsonObject& arrangement)
{
    const std::vector<PlotSpec> specs = plotsWith(arrangement[QStringLiteral("plots")].toArray());
    for (std::size_t s = 0; s < specs.size(); ++s) {
        if (s < specs_.size()) {
            specs_[s] = specs[s];
            placePlot(s);
        } else {
            specs_.push_back(specs[s]);
            makePlot(s);
        }
    }
    labelPlots();
    for (const QJsonValue& each : arrangement[QStringLiteral("chosen")].toArray()) {
        const int model = each[QStringLiteral("model")].toInt(-1);
        if (model >= 0 && model <= static_cast<int>(ModelKind::Contact))
            chosen_[{static_cast<ModelKind>(model), each[QStringLiteral("plot")].toString()}] =
                each[QStringLiteral("shown")].toBool();
    }
    const int window = arrangement[QStringLiteral("window")].toInt();
    spectrogram_->setWindow(window >= 64 && window <= 16384 ? static_cast<std::size_t>(window) : 0);
    updateWanted();
    rebuild();
    emit plotsChanged();
}

} // namespace touchdown

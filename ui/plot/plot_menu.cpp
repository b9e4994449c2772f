// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_menu.h"

#include "ui/plot/plot_export.h"
#include "ui/style/save_dialog.h"

#include <QCoreApplication>
#include <QMenu>

namespace touchdown {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("touchdown::PlotMenu", text); }

void addCurveSwitches(QMenu* menu, PlotWidget* plot)
{
    if (plot->curves().size() < 2) return;
    QMenu* curves = menu->addMenu(tr("C&urves"));
    for (const PlotCurve& curve : plot->curves()) {
        QAction* action = curves->addAction(curve.name.isEmpty() ? plot->title() : curve.name);
        action->setCheckable(true);
        action->setChecked(curve.visible);
        QObject::connect(action, &QAction::toggled, plot,
                         [plot, id = curve.id](bool visible) { plot->setCurveVisible(id, visible); });
    }
}

void openMenu(PlotWidget* plot, PlotGroup* group, QWidget* page, const QPoint& at)
{
    auto* menu = new QMenu(plot);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("&Fit all"), QKeySequence(Qt::Key_Home), group, &PlotGroup::fit);
    menu->addAction(tr("&Back"), QKeySequence(Qt::ALT | Qt::Key_Left), group, &PlotGroup::goBack)
        ->setEnabled(group->canGoBack());
    menu->addAction(tr("F&orward"), QKeySequence(Qt::ALT | Qt::Key_Right), group, &PlotGroup::goForward)
        ->setEnabled(group->canGoForward());
    menu->addSeparator();

    QAction* height = menu->addAction(tr("&Height follows the data"));
    height->setCheckable(true);
    height->setChecked(!plot->view().y);
    QObject::connect(height, &QAction::toggled, plot, [plot](bool follows) {
        plot->setView({plot->view().x, follows ? std::nullopt : std::optional(plot->yAxis().range())});
    });
    QAction* logarithmic = menu->addAction(tr("&Logarithmic height"));
    logarithmic->setCheckable(true);
    logarithmic->setChecked(plot->yAxis().logarithmic());
    logarithmic->setShortcut(Qt::Key_L);
    QObject::connect(logarithmic, &QAction::toggled, plot,
                     [plot](bool on) { plot->setYScale(on ? AxisScale::Logarithmic : AxisScale::Linear); });
    addCurveSwitches(menu, plot);
    menu->addSeparator();

    menu->addAction(tr("&Copy picture"), plot, [plot] { copyPicture(*plot); });
    menu->addAction(tr("&Save picture\u2026"), plot, [plot] {
        askAndSave(plot, tr("Save picture"), pictureFilters(), QStringLiteral("pdf"),
                   [plot](const QString& path) { return savePicture(*plot, path); });
    });
    if (page != nullptr)
        menu->addAction(tr("Save &page\u2026"), plot, [plot, page] {
            askAndSave(plot, tr("Save page"), pictureFilters(), QStringLiteral("pdf"),
                       [page](const QString& path) { return savePicture(*page, path); });
        });
    menu->addAction(tr("Save visible &data\u2026"), plot, [plot] {
        askAndSave(plot, tr("Save visible data"), {tr("Comma-separated values (*.csv)")}, QStringLiteral("csv"),
                   [plot](const QString& path) { return saveCsv(*plot, path); });
    });
    menu->popup(at);
}

} // namespace

void installPlotMenu(PlotWidget* plot, PlotGroup* group, QWidget* page)
{
    QObject::connect(plot, &PlotWidget::menuRequested, group,
                     [plot, group, page](const QPoint& at) { openMenu(plot, group, page, at); });
}

} // namespace touchdown

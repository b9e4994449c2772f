// SPDX-License-Identifier: GPL-3.0-or-later
//
// Plots and curves that the user adds to the live plots, in menus and by dragging, and that the settings keep.
#include "ui/runs/live_plots.h"

#include <memory>
#include <set>

#include <QDropEvent>
#include <QSignalSpy>
#include <QTest>

#include "core/case_files/case_file.h"
#include "core/simulation/run.h"
#include "tests/support/test_program.h"
#include "ui/plot/plot_group.h"
#include "ui/runs/drop_hint.h"
#include "ui/runs/quantity_list.h"
#include "ui/runs/run_record.h"
#include "ui/runs/run_view.h"
#include "ui/runs/runs_model.h"
#include "ui/style/theme.h"

using namespace touchdown;

namespace test_own_plots {

class TestOwnPlots : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void aQuantityHasAPlotOfItsOwn();
    void aCurveIsAddedWhereTheUnitFits();
    void anotherUnitIsRefusedWithASentence();
    void aPlotOfItsOwnIsRemoved();
    void menusOfferWhatFits();
    void aDropAddsACurve();
    void aDropAtTheFootMakesAPlot();
    void aDropOfAnotherUnitSaysWhy();
    void otherDragsAreLeftAlone();
    void theSettingsKeepIt();
    void settingsThatCannotBeReadChangeNothing();
    void theListFollowsTheRuns();
    void noTwoPlotsHaveOneName();

private:
    Quantity quantity(const char* name) const
    {
        const std::vector<Quantity> all = plots_->quantities();
        return all[static_cast<std::size_t>(findQuantity(all, name))];
    }
    PlotWidget* plot(const QString& name) const { return plots_->plot(name); }
    bool visible(const QString& name) const { return plot(name)->isVisibleTo(plots_.get()); }
    /// Whether the drag was taken at this place of the plots.
    bool drag(QMimeData* data, const QPoint& at, bool drop = true);

    std::unique_ptr<RunsModel> runs_;
    std::unique_ptr<LivePlots> plots_;
};

std::unique_ptr<RunRecord> springRun(int number)
{
    const Case c = openCase("fig10a").value;
    auto run = std::make_unique<RunRecord>(number, c, "", recordedQuantities(c));
    SampleBatch batch;
    batch.time = {0.0, 1e-4, 2e-4};
    batch.columns.assign(recordedQuantities(c).size(), {1e-9, 2e-9, 1e-9});
    run->append(batch, {});
    return run;
}

bool TestOwnPlots::drag(QMimeData* data, const QPoint& at, bool drop)
{
    const std::unique_ptr<QMimeData> held(data);
    QDragEnterEvent enter(at, Qt::CopyAction, data, Qt::LeftButton, Qt::NoModifier);
    enter.ignore();
    QApplication::sendEvent(plots_.get(), &enter);
    if (!enter.isAccepted()) return false;
    QDragMoveEvent move(at, Qt::CopyAction, data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(plots_.get(), &move);
    if (!drop) return move.isAccepted();
    QDropEvent end(at, Qt::CopyAction, data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(plots_.get(), &end);
    return end.isAccepted();
}

void TestOwnPlots::initTestCase()
{
    QLocale::setDefault(QLocale::c());
    applyTheme(Theme::Light);
}

void TestOwnPlots::init()
{
    plots_.reset();
    runs_ = std::make_unique<RunsModel>();
    plots_ = std::make_unique<LivePlots>(*runs_);
    plots_->resize(800, 900);
    plots_->setCase(openCase("fig10a").value);
    runs_->add(springRun(1));
    plots_->show();
    QVERIFY(QTest::qWaitForWindowExposed(plots_.get()));
}

void TestOwnPlots::aQuantityHasAPlotOfItsOwn()
{
    const QSignalSpy changed(plots_.get(), &LivePlots::plotsChanged);
    const QString name = plots_->addPlot(quantity("friction_power"));
    QCOMPARE(changed.size(), 1);
    QVERIFY(visible(name));
    QCOMPARE(plot(name)->curves().size(), std::size_t(1));
    QVERIFY(plot(name)->curves()[0].data == runs_->record(0).pyramid("friction_power"));
    QCOMPARE(plot(name)->yAxis().label.unit, QStringLiteral("µW"));
    QCOMPARE(plots_->entry(name).wanted->text(),
             QStringLiteral("Power of the friction on the slider, by its moment about the mass centre"));
    // It shares the time axis and the cursors, and a later run stands in it, too.
    QCOMPARE(plot(name)->xAxis().range(), plot(QStringLiteral("spacing"))->xAxis().range());
    plots_->group()->setCursor(0, 1e-4);
    QCOMPARE(plot(name)->plotCursor(0), std::optional(1e-4));
    runs_->add(springRun(2));
    QCOMPARE(plot(name)->curves().size(), std::size_t(2));
    QVERIFY(plots_->addPlot(quantity("height")) != name);
}

void TestOwnPlots::aCurveIsAddedWhereTheUnitFits()
{
    const QString spacing = QStringLiteral("spacing");
    QCOMPARE(plots_->addCurve(spacing, quantity("front_spacing")), QString());
    QCOMPARE(plot(spacing)->curves().size(), std::size_t(2));
    QVERIFY(plot(spacing)->curves()[1].data == runs_->record(0).pyramid("front_spacing"));
    // Quantities now differ by colour.
    QVERIFY(plot(spacing)->curves()[0].style.colour != plot(spacing)->curves()[1].style.colour);
    QVERIFY(!plots_->addCurve(spacing, quantity("front_spacing")).isEmpty()); // it is there
    plots_->removeCurve(spacing, "front_spacing");
    QCOMPARE(plot(spacing)->curves().size(), std::size_t(1));
    plots_->removeCurve(spacing, "minimum_spacing"); // the plot's own stays
    QCOMPARE(plot(spacing)->curves().size(), std::size_t(1));
}

void TestOwnPlots::anotherUnitIsRefusedWithASentence()
{
    const QString reason = plots_->addCurve(QStringLiteral("spacing"), quantity("pitch"));
    QVERIFY2(reason.contains(QStringLiteral("µrad")) && reason.contains(QStringLiteral("nm")), qPrintable(reason));
    QCOMPARE(plot(QStringLiteral("spacing"))->curves().size(), std::size_t(1));
}

void TestOwnPlots::aPlotOfItsOwnIsRemoved()
{
    const QString name = plots_->addPlot(quantity("height"));
    const std::size_t count = plots_->plots().size();
    const std::size_t inGroup = plots_->group()->plots().size();
    QPointer<PlotWidget> gone = plot(name);
    gone->actions().back()->trigger(); // the last one of its menu
    QCOMPARE(plots_->plots().size(), count - 1);
    QCOMPARE(plots_->group()->plots().size(), inGroup - 1);
    QTRY_VERIFY(gone.isNull());
    runs_->add(springRun(2));
    // The plots of the program have no such entry.
    for (const QAction* action : plot(QStringLiteral("spacing"))->actions())
        QVERIFY(!action->text().contains(QStringLiteral("this")));
}

void TestOwnPlots::menusOfferWhatFits()
{
    const PlotWidget* spacing = plot(QStringLiteral("spacing"));
    QMenu* add = spacing->actions()[0]->menu();
    QMenu* remove = spacing->actions()[1]->menu();
    emit add->aboutToShow();
    QStringList offered;
    for (const QAction* action : add->actions()) offered << action->text();
    QCOMPARE(offered, (QStringList{QStringLiteral("Flying height at the contact pad above the disk"),
                                   QStringLiteral("Height of the mass centre"),
                                   QStringLiteral("Spacing at the front pressure centre"),
                                   QStringLiteral("Spacing at the rear pressure centre")}));
    add->actions()[1]->trigger();
    QCOMPARE(spacing->curves().size(), std::size_t(2));
    emit remove->aboutToShow();
    QCOMPARE(remove->actions().size(), 1);
    remove->actions()[0]->trigger();
    QCOMPARE(spacing->curves().size(), std::size_t(1));
}

void TestOwnPlots::aDropAddsACurve()
{
    const PlotWidget* spacing = plot(QStringLiteral("spacing"));
    QVERIFY(drag(quantityDrag("height"), spacing->geometry().center(), false));
    const auto* hint = plots_->findChild<DropHint*>();
    QVERIFY(hint->isVisible());
    QCOMPARE(hint->text(), QStringLiteral("Add to \"Minimum spacing\""));
    QVERIFY(drag(quantityDrag("height"), spacing->geometry().center()));
    QVERIFY(!hint->isVisible());
    QCOMPARE(spacing->curves().size(), std::size_t(2));
}

void TestOwnPlots::aDropAtTheFootMakesAPlot()
{
    const std::size_t count = plots_->plots().size();
    QVERIFY(drag(quantityDrag("height"), QPoint(400, plots_->height() - 3)));
    QCOMPARE(plots_->plots().size(), count + 1);
    QVERIFY(plots_->plots().back().plot->curves()[0].data == runs_->record(0).pyramid("height"));
}

void TestOwnPlots::aDropOfAnotherUnitSaysWhy()
{
    QSignalSpy refused(plots_.get(), &LivePlots::refused);
    QVERIFY(drag(quantityDrag("pitch"), plot(QStringLiteral("spacing"))->geometry().center()));
    QCOMPARE(refused.size(), 1);
    QVERIFY(refused[0][0].toString().contains(QStringLiteral("Pitch")));
    QCOMPARE(plot(QStringLiteral("spacing"))->curves().size(), std::size_t(1));
}

void TestOwnPlots::otherDragsAreLeftAlone()
{
    auto* file = new QMimeData; // the window opens files
    file->setUrls({QUrl::fromLocalFile(QStringLiteral("/tmp/a.toml"))});
    QVERIFY(!drag(file, QPoint(100, 100)));
    QVERIFY(drag(quantityDrag("of another version"), QPoint(100, 100)) == false);
    QVERIFY(!plots_->findChild<DropHint*>()->isVisible());
}

void TestOwnPlots::theSettingsKeepIt()
{
    const QString own = plots_->addPlot(quantity("height"));
    QCOMPARE(plots_->addCurve(own, quantity("front_spacing")), QString());
    QCOMPARE(plots_->addCurve(QStringLiteral("pitch"), quantity("pitch")).isEmpty(), false);
    QCOMPARE(plots_->addCurve(QStringLiteral("spacing"), quantity("rear_spacing")), QString());
    plots_->setAxes(QStringLiteral("phase"), quantity("pitch"), quantity("energy"));
    plots_->entry(QStringLiteral("phase")).wanted->trigger(); // on
    plots_->entry(QStringLiteral("pitch")).wanted->trigger(); // off
    const QJsonObject kept = plots_->arrangement();

    LivePlots other(*runs_);
    other.restore(kept);
    other.setCase(openCase("fig10a").value);
    QCOMPARE(other.plots().size(), plots_->plots().size());
    QCOMPARE(other.plot(own)->curves().size(), std::size_t(2));
    QCOMPARE(other.spec(own).title, plots_->spec(own).title);
    QVERIFY(other.plot(own)->isVisibleTo(&other));
    QCOMPARE(other.plot(QStringLiteral("spacing"))->curves().size(), std::size_t(2));
    const PlotCurve& phase = other.plot(QStringLiteral("phase"))->curves().at(0);
    QVERIFY(phase.data == runs_->record(0).pyramid("energy") && phase.xData == runs_->record(0).pyramid("pitch"));
    QVERIFY(other.plot(QStringLiteral("phase"))->isVisibleTo(&other));
    QVERIFY(!other.plot(QStringLiteral("pitch"))->isVisibleTo(&other));
    QCOMPARE(other.arrangement(), kept);
}

void TestOwnPlots::settingsThatCannotBeReadChangeNothing()
{
    const QJsonObject quantity{{"name", "height"}, {"unit", "m"}, {"display_unit", "parsec hour"}, {"long_name", "?"}};
    const QJsonArray added{quantity};
    plots_->restore({{"plots", QJsonArray{QJsonObject{{"plot", "own 1"}, {"own", true}, {"added", added}},
                                          QJsonObject{{"plot", "nowhere"}, {"added", added}}, 5}},
                     {"chosen", QJsonArray{QJsonObject{{"model", 77}, {"plot", "pitch"}, {"shown", false}}}}});
    QCOMPARE(plots_->plots().size(), standardPlots().size());
    QVERIFY(visible(QStringLiteral("pitch")));
    QCOMPARE(changedPlots(standardPlots()), QJsonArray());
}

void TestOwnPlots::theListFollowsTheRuns()
{
    RunView view(*runs_);
    view.setCase(openCase("fig10a").value);
    QVERIFY(view.quantities()->isHidden());
    view.quantitiesWanted()->trigger();
    QVERIFY(!view.quantities()->isHidden());
    QListWidget* list = view.quantities()->list();
    QCOMPARE(list->count(), static_cast<int>(runs_->record(0).quantities.size()));
    const std::size_t count = view.plots()->plots().size();
    emit list->itemActivated(list->item(3));
    QCOMPARE(view.plots()->plots().size(), count + 1);
    // The menu of the window has one entry for it.
    QMenu menu;
    view.fillPlotsMenu(menu);
    QVERIFY(menu.actions().contains(view.plots()->plots().back().wanted));
    runs_->remove(0);
    view.setCase(openCase("contact_hertz").value);
    QCOMPARE(list->count(), static_cast<int>(recordedQuantities(openCase("contact_hertz").value).size()));
}

void TestOwnPlots::noTwoPlotsHaveOneName()
{
    const QString first = plots_->addPlot(quantity("pitch"));
    const QString second = plots_->addPlot(quantity("pitch"));
    const QString third = plots_->addPlot(quantity("height"));
    QCOMPARE(plot(QStringLiteral("pitch"))->title(), QStringLiteral("Pitch"));
    QCOMPARE(plot(first)->title(), QStringLiteral("Pitch (2)"));
    QCOMPARE(plots_->entry(second).wanted->text(), QStringLiteral("Pitch (3)"));
    QVERIFY(!plot(third)->title().contains(QLatin1Char('(')));
    LivePlots other(*runs_);
    other.restore(plots_->arrangement());
    QCOMPARE(other.plot(second)->title(), QStringLiteral("Pitch (3)"));
    plots_->removePlot(first);
    QCOMPARE(plot(second)->title(), QStringLiteral("Pitch (2)"));
    plots_->setAxes(second, std::nullopt, quantity("height"));
    QCOMPARE(plot(second)->title(), plots_->spec(second).title);
    std::set<QString> titles;
    for (const LivePlots::Entry& entry : plots_->plots()) QVERIFY(titles.insert(entry.title).second);
}

TOUCHDOWN_TEST(TestOwnPlots)

} // namespace test_own_plots

#include "test_own_plots.moc"

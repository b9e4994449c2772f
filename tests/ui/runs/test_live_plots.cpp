// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which plots stand there for which runs, and the forces against the separation.
#include "ui/runs/live_plots.h"

#include <memory>
#include <numbers>

#include <QTest>

#include "core/case_files/case_file.h"
#include "core/simulation/run.h"
#include "tests/support/test_program.h"
#include "tests/ui/sample_contact.h"
#include "ui/plot/plot_group.h"
#include "ui/runs/run_record.h"
#include "ui/runs/runs_model.h"
#include "ui/style/theme.h"

using namespace touchdown;

namespace test_live_plots {

class TestLivePlots : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void standsReadyForTheCase();
    void showsForcesAgainstSeparation();
    void marksWhereThingsHappened();
    void pointsTheWayOfTime();
    void leavesOutANetForceThatIsTheContactForce();
    void dashesTheFittedCharacteristic();
    void offersForcesOfASliderOnSprings();
    void shadesWhatTakesAndWhatCreatesEnergy_data();
    void shadesWhatTakesAndWhatCreatesEnergy();
    void remembersWhatWasChosenForAModel();
    void aBaselineLeavesTheWayAsItIs();
    void aHiddenCurveStaysHiddenInItsPlotAlone();
    void showsVelocityAgainstHeight();
    void anyQuantityStandsAgainstAny();
    void aPortraitKeepsItsAxisBeforeTheFirstRun();

private:
    bool visible(const char* name) const { return plots_->plot(QString::fromLatin1(name))->isVisibleTo(plots_.get()); }
    PlotWidget* forces() const { return plots_->plot(QStringLiteral("force_separation")); }

    std::unique_ptr<RunsModel> runs_;
    std::unique_ptr<LivePlots> plots_;
};

void TestLivePlots::initTestCase()
{
    QLocale::setDefault(QLocale::c());
    applyTheme(Theme::Light);
}

void TestLivePlots::init()
{
    plots_.reset();
    runs_ = std::make_unique<RunsModel>();
    plots_ = std::make_unique<LivePlots>(*runs_);
    plots_->resize(800, 900);
}

void TestLivePlots::standsReadyForTheCase()
{
    plots_->setCase(openCase("fig10a").value);
    QVERIFY(visible("spacing") && visible("pitch") && visible("energy") && visible("forces"));
    QVERIFY(!visible("force_separation") && !visible("area") && !visible("roll"));
    plots_->setCase(openCase("contact_hertz").value);
    QVERIFY(visible("force_separation") && visible("spacing") && visible("area") && visible("pressure"));
    QVERIFY(!visible("pitch") && !visible("energy") && !visible("forces"));
}

void TestLivePlots::showsForcesAgainstSeparation()
{
    plots_->setCase(sampleContactCase());
    runs_->add(sampleContactRun(1));
    QVERIFY(forces()->isPhasePortrait());
    QCOMPARE(forces()->curves().size(), std::size_t(3));
    for (const PlotCurve& curve : forces()->curves()) {
        QVERIFY(curve.visible);
        QVERIFY(curve.xData == runs_->record(0).pyramid("minimum_spacing"));
    }
    // From 5 nm to -5 nm and back; contact up to 5 mN, the menisci with 0.5 mN.
    const auto range = forces()->dataRangeX();
    QVERIFY(range && std::abs(range->low + 5e-9) < 1e-15 && std::abs(range->high - 5e-9) < 1e-15);
    QVERIFY(forces()->xNumbersVisible());
    // Beside the plots over time it is the tallest.
    plots_->show();
    QVERIFY(QTest::qWaitForWindowExposed(plots_.get()));
    QVERIFY(forces()->height() > 2 * plots_->plot(QStringLiteral("spacing"))->height());
    QCOMPARE(forces()->y(), 0);
}

void TestLivePlots::marksWhereThingsHappened()
{
    runs_->add(sampleContactRun(1));
    const std::vector<PointMark>& marks = forces()->pointMarks();
    QCOMPARE(marks.size(), std::size_t(2));
    QCOMPARE(marks[0].label, QStringLiteral("snap-in"));
    // At 0.2 ms the pad is at 1 nm, at 0.9 ms at 3 nm.
    QVERIFY(std::abs(marks[0].x - 1e-9) < 1e-14);
    QVERIFY(std::abs(marks[1].x - 3e-9) < 1e-14);
    QVERIFY(marks[0].y <= 0.0);
    // A run with many bounces is marked once for each kind.
    std::vector<RunEvent> bounces;
    for (int i = 0; i < 100; ++i) bounces.push_back({0.91e-3 + 1e-7 * i, i % 2 == 0 ? "touch-down" : "take-off"});
    runs_->append(1, {}, bounces);
    plots_->runFinished(1);
    QCOMPARE(forces()->pointMarks().size(), std::size_t(4));
}

void TestLivePlots::pointsTheWayOfTime()
{
    runs_->add(sampleContactRun(1));
    plots_->setCase(sampleContactCase());
    plots_->show();
    QVERIFY(QTest::qWaitForWindowExposed(plots_.get()));
    forces()->refreshNow();
    QVERIFY(forces()->curves()[0].arrows);
    QCOMPARE(forces()->phasePaths().size(), std::size_t(3));
    // The first way leads to smaller separations, the second back.
    const std::vector<QPointF>& path = forces()->phasePaths()[0];
    QVERIFY(path[1].x() < path[0].x());
    QVERIFY(path.back().x() > path[path.size() - 2].x());
    // A cursor in time is a point on the way: its mark appears in the picture.
    const QImage before = forces()->grab().toImage();
    plots_->group()->setCursor(0, 0.35e-3);
    QVERIFY(forces()->grab().toImage() != before);
}

void TestLivePlots::leavesOutANetForceThatIsTheContactForce()
{
    runs_->add(sampleContactRun(1, contactSnapshots, false));
    QCOMPARE(forces()->curves().size(), std::size_t(2));
    QVERIFY(forces()->curves()[0].visible);
    QVERIFY(!forces()->curves()[1].visible);
}

void TestLivePlots::dashesTheFittedCharacteristic()
{
    std::vector<Quantity> quantities = sampleContactQuantities();
    quantities.push_back({"fitted_contact_force", "N", "mN", "Fitted"});
    auto run = std::make_unique<RunRecord>(1, sampleContactCase(), "", quantities);
    SampleBatch batch = sampleContactBatch(0.0, 1e-3);
    batch.columns.push_back(batch.columns[1]);
    run->append(batch, {});
    runs_->add(std::move(run));
    QCOMPARE(forces()->curves().size(), std::size_t(4));
    const PlotCurve& fitted = forces()->curves().back();
    QCOMPARE(fitted.style.dash, 1);
    QVERIFY(!fitted.arrows);
    QCOMPARE(forces()->curves()[0].style.dash, 0);
}

void TestLivePlots::offersForcesOfASliderOnSprings()
{
    const Case c = openCase("fig10a").value;
    plots_->setCase(c);
    runs_->add(std::make_unique<RunRecord>(1, c, "", recordedQuantities(c)));
    QVERIFY(!visible("force_separation"));
    plots_->entry(QStringLiteral("force_separation")).wanted->trigger();
    QVERIFY(visible("force_separation"));
    // Dropped from 250 nm, but nothing acts above d_e = 5 nm: the axis ends at 10 nm.
    SampleBatch batch;
    batch.columns.assign(recordedQuantities(c).size(), {0.0, 0.0});
    batch.time = {0.0, 1e-3};
    batch.columns[static_cast<std::size_t>(findQuantity(recordedQuantities(c), "minimum_spacing"))] = {250e-9, 1e-9};
    runs_->append(1, batch, {});
    forces()->refreshNow();
    QVERIFY(forces()->xAxis().range().high >= 10e-9 && forces()->xAxis().range().high < 20e-9);
}

void TestLivePlots::shadesWhatTakesAndWhatCreatesEnergy_data()
{
    QTest::addColumn<int>("shape");
    QTest::addColumn<double>("meniscusForce"); // [N]
    QTest::addColumn<double>("takeOff");       // [m]
    QTest::addColumn<int>("areas");
    // f_c0 5 mN, k_c 5e6 N/m: the contact ends 1 nm above d_s = 3 nm.
    QTest::newRow("the menisci are stronger") << 0 << 10.7e-3 << 5e-9 << 1;
    QTest::newRow("first the contact pushes") << 0 << 0.5e-3 << 5e-9 << 2;
    QTest::newRow("it never pulls") << 0 << 0.0 << 5e-9 << 2;
    QTest::newRow("menisci that weaken") << 1 << 2e-3 << 6e-9 << 2;
    QTest::newRow("both weaken") << 2 << 8e-3 << 6e-9 << 1;
    QTest::newRow("both weaken, the contact is stronger") << 2 << 1e-3 << 6e-9 << 2;
    QTest::newRow("d_e within the reach of the contact") << 0 << 3e-3 << 3.5e-9 << 2;
}

/// Below zero the area is what the law takes, above it what it creates: together they are W.
void TestLivePlots::shadesWhatTakesAndWhatCreatesEnergy()
{
    QFETCH(int, shape);
    QFETCH(double, meniscusForce);
    QFETCH(double, takeOff);
    QFETCH(int, areas);
    Case c = openCase("fig10a").value;
    c.onoYamane.takeOffShape = static_cast<TakeOffShape>(shape);
    c.onoYamane.meniscusForce = meniscusForce;
    c.onoYamane.takeOff = takeOff;
    runs_->add(std::make_unique<RunRecord>(1, c, "", recordedQuantities(c)));
    plots_->setCase(c);
    const std::vector<ShadedArea>& shaded = forces()->shadedAreas();
    QCOMPARE(shaded.size(), static_cast<std::size_t>(areas));
    double work = 0.0;
    for (const ShadedArea& area : shaded)
        for (std::size_t i = 1; i < area.outline.size(); ++i)
            work -= 0.5 * (area.outline[i].second + area.outline[i - 1].second) *
                    (area.outline[i].first - area.outline[i - 1].first);
    const double wanted = OnoYamaneLaw(c.onoYamane).cycleWork();
    QVERIFY2(std::abs(work - wanted) < 1e-9 * 1e-12 + 1e-9 * std::abs(wanted), qPrintable(QString::number(work)));
    QVERIFY(shaded[0].label.contains(QStringLiteral("W = ")));
    if (areas == 2) QVERIFY(shaded[1].label.startsWith(QStringLiteral("creates ")));
}

void TestLivePlots::remembersWhatWasChosenForAModel()
{
    plots_->setCase(sampleContactCase());
    plots_->entry(QStringLiteral("force_separation")).wanted->trigger(); // off
    plots_->entry(QStringLiteral("forces")).wanted->trigger();           // on
    plots_->setCase(openCase("fig10a").value);
    QVERIFY(!plots_->entry(QStringLiteral("force_separation")).wanted->isChecked());
    plots_->entry(QStringLiteral("pitch")).wanted->trigger();
    plots_->setCase(sampleContactCase());
    QVERIFY(!visible("force_separation") && visible("forces"));
    plots_->setCase(openCase("fig10a").value);
    QVERIFY(!visible("pitch") && visible("energy"));
}

void TestLivePlots::aBaselineLeavesTheWayAsItIs()
{
    runs_->add(sampleContactRun(1));
    runs_->add(sampleContactRun(2));
    runs_->finish(1, Summary{});
    runs_->finish(2, Summary{});
    runs_->setBaseline(1);
    QCOMPARE(forces()->title(), QStringLiteral("Force against separation"));
    QCOMPARE(forces()->curves().size(), std::size_t(6));
    QTRY_COMPARE(plots_->plot(QStringLiteral("spacing"))->title(), QStringLiteral("Minimum spacing minus run 1"));
}

void TestLivePlots::aHiddenCurveStaysHiddenInItsPlotAlone()
{
    runs_->add(sampleContactRun(1));
    forces()->setCurveVisible(forces()->curves()[2].id, false);
    runs_->add(sampleContactRun(2));
    QVERIFY(!forces()->curves()[5].visible);
    QVERIFY(plots_->plot(QStringLiteral("forces"))->curves()[5].visible);
}

/// Two runs of the case on springs: the height and the velocity of an oscillation about 100 nm, 10 us a period.
void addSwinging(RunsModel& runs, int number, double amplitude)
{
    const Case c = openCase("fig10a").value;
    const std::vector<Quantity> quantities = recordedQuantities(c);
    auto run = std::make_unique<RunRecord>(number, c, "", quantities);
    SampleBatch batch;
    batch.columns.assign(quantities.size(), std::vector<double>(201, 0.0));
    const auto column = [&](const char* name) -> std::vector<double>& {
        return batch.columns[static_cast<std::size_t>(findQuantity(quantities, name))];
    };
    for (std::size_t i = 0; i <= 200; ++i) {
        const double phase = 0.02 * std::numbers::pi * static_cast<double>(i);
        batch.time.push_back(1e-7 * static_cast<double>(i));
        column("height")[i] = 100e-9 + amplitude * std::cos(phase);
        column("vertical_velocity")[i] = -amplitude * 2e5 * std::numbers::pi * std::sin(phase);
    }
    run->append(batch, {});
    runs.add(std::move(run));
}

void TestLivePlots::showsVelocityAgainstHeight()
{
    plots_->setCase(openCase("fig10a").value);
    addSwinging(*runs_, 1, 10e-9);
    addSwinging(*runs_, 2, 20e-9);
    QVERIFY(!visible("phase"));
    plots_->entry(QStringLiteral("phase")).wanted->trigger();
    QVERIFY(visible("phase"));
    PlotWidget* phase = plots_->plot(QStringLiteral("phase"));
    QCOMPARE(phase->title(), QStringLiteral("Phase portrait"));
    QCOMPARE(phase->curves().size(), std::size_t(2));
    for (int row : {0, 1}) {
        const PlotCurve& curve = phase->curves()[static_cast<std::size_t>(row)];
        QVERIFY(curve.data == runs_->record(row).pyramid("vertical_velocity"));
        QVERIFY(curve.xData == runs_->record(row).pyramid("height"));
        QCOMPARE(curve.pale, row == 0); // the newest one is wide
    }
    QCOMPARE(phase->xAxis().label.unit, QStringLiteral("nm"));
    // The automatic range is that of the newest run: 80 to 120 nm, and beside the plots over time.
    const auto range = phase->dataRangeX();
    QVERIFY(range && std::abs(range->low - 80e-9) < 1e-13 && std::abs(range->high - 120e-9) < 1e-13);
    plots_->show();
    QVERIFY(QTest::qWaitForWindowExposed(plots_.get()));
    const PlotWidget* spacing = plots_->plot(QStringLiteral("spacing"));
    QVERIFY(phase->x() >= spacing->x() + spacing->width());

    // At 2.5 us, a quarter of a period, the dots are at 100 nm and the largest downward velocity of each run.
    phase->refreshNow();
    const QImage before = phase->grab().toImage();
    plots_->group()->setCursor(0, 2.5e-6);
    const QImage after = phase->grab().toImage();
    for (const double amplitude : {10e-9, 20e-9}) {
        const QPoint at = phase->toPixel(100e-9, -amplitude * 2e5 * std::numbers::pi).toPoint();
        QVERIFY(after.pixelColor(at - QPoint(0, 2)) != before.pixelColor(at - QPoint(0, 2)));
    }
}

void TestLivePlots::anyQuantityStandsAgainstAny()
{
    const QString name = QStringLiteral("phase");
    plots_->setCase(openCase("fig10a").value);
    addSwinging(*runs_, 1, 10e-9);
    plots_->entry(name).wanted->trigger();
    const std::vector<Quantity> quantities = plots_->quantities();
    const auto quantity = [&](const char* wanted) {
        return quantities[static_cast<std::size_t>(findQuantity(quantities, wanted))];
    };
    QCOMPARE(quantities.size(), recordedQuantities(runs_->record(0).value).size());
    plots_->setAxes(name, quantity("pitch"), quantity("energy"));
    const PlotWidget* plot = plots_->plot(name);
    QVERIFY(plot->curves()[0].data == runs_->record(0).pyramid("energy"));
    QVERIFY(plot->curves()[0].xData == runs_->record(0).pyramid("pitch"));
    QCOMPARE(plot->xAxis().label.title, QStringLiteral("Pitch"));
    QCOMPARE(plot->xAxis().label.factor, 1e-6);
    QCOMPARE(plot->yAxis().label.factor, 1e-12);
    QCOMPARE(plot->title(), QStringLiteral("Total energy without that of the contact against pitch"));
    QCOMPARE(plots_->entry(name).wanted->text(), plot->title());
    // The menu offers every quantity on both axes, with a mark at the present one.
    const auto offered = [&](qsizetype menu) {
        QMenu* axis = plot->actions()[menu]->menu();
        emit axis->aboutToShow();
        return axis->actions();
    };
    QCOMPARE(offered(2).size(), static_cast<qsizetype>(quantities.size()) + 1); // or the time
    QCOMPARE(offered(3).size(), static_cast<qsizetype>(quantities.size()));
    for (const QAction* action : offered(2)) QCOMPARE(action->isChecked(), action->text() == QStringLiteral("Pitch"));
    offered(2).front()->trigger();
    QVERIFY(!plot->isPhasePortrait() && plot->curves()[0].xData == nullptr);
    QCOMPARE(plot->xAxis().range(), plots_->plot(QStringLiteral("spacing"))->xAxis().range());
}

void TestLivePlots::aPortraitKeepsItsAxisBeforeTheFirstRun()
{
    plots_->setCase(openCase("fig10a").value);
    plots_->entry(QStringLiteral("phase")).wanted->trigger();
    plots_->group()->setFirstRange(PlotRange{0.0, 1e-5});
    addSwinging(*runs_, 1, 10e-9);
    PlotWidget* phase = plots_->plot(QStringLiteral("phase"));
    phase->refreshNow();
    QVERIFY(phase->xAxis().range().low > 80e-9 && phase->xAxis().range().high < 120e-9);
    QCOMPARE(phase->timeWindow(), std::optional(PlotRange{0.0, 1e-5}));
}

TOUCHDOWN_TEST(TestLivePlots)

} // namespace test_live_plots

#include "test_live_plots.moc"

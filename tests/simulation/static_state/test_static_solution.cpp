// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/static_state/static_solution.h"

#include <functional>

#include <QTest>

#include "core/case/contact_kind.h"
#include "tests/support/small_slider.h"
#include "tests/support/test_program.h"

using namespace touchdown;

using Change = std::function<void(Case&)>;
Q_DECLARE_METATYPE(Change)

namespace test_static_solution {

/// A state of the small slider that was found 3 nm below where its search began.
SteadyResult foundState(SteadyStatus status = SteadyStatus::Converged)
{
    SteadyResult state;
    state.status = status;
    state.attitude = {17e-9, 130e-6, 2e-6};
    state.pressure = {1e5};
    return state;
}

class TestStaticSolution : public QObject {
    Q_OBJECT

private slots:
    /// Runs use a static state in hand as long as the case differs in nothing that the state depends on.
    void knowsWhatAStateDependsOn_data()
    {
        QTest::addColumn<Change>("change");
        QTest::addColumn<bool>("same");
        const auto row = [](const char* name, bool same, Change change) { QTest::newRow(name) << change << same; };
        row("nothing", true, [](Case&) {});
        row("the run", true, [](Case& c) { c.run.duration *= 2.0, c.run.stepError *= 0.1; });
        row("the spectrum", true, [](Case& c) { c.spectrum.segment *= 2; });
        row("the disk's surface", true, [](Case& c) { c.diskSurface.kind = DiskSurfaceKind::Rough; });
        row("an offset from the state", true, [](Case& c) { c.initial.heightOffset = 3e-9; });
        row("a velocity", true, [](Case& c) { c.initial.verticalVelocity = 0.1; });
        row("a start from the state", true, [](Case& c) {
            c.initial.nominalTrailingEdgeHeight = 17e-9, c.initial.pitch = 130e-6, c.initial.roll = 2e-6;
        });
        row("what else is asked about it", true, [](Case& c) { c.steady.stiffness = !c.steady.stiffness; });
        row("another start of the search", false, [](Case& c) { c.initial.nominalTrailingEdgeHeight = 300e-9; });
        row("the preload", false, [](Case& c) { c.suspension.preload *= 1.0 + 1e-15; });
        row("a rail", false, [](Case& c) { c.surface.rails[0].points[0].x += 1e-12; });
        row("a wall that no edge has", true, [](Case& c) { c.surface.walls.push_back({{0.0, 1e-6}, {0.0, 1e-6}}); });
        row("the grid", false, [](Case& c) { c.film.nodes = {67, 65}; });
        row("the contact, which has a least gap", false, [](Case& c) { c.contact = ContactKind::OnoYamane; });
        row("the air", false, [](Case& c) { c.air.given.pressure *= 0.9; });
    }
    void knowsWhatAStateDependsOn()
    {
        QFETCH(Change, change);
        QFETCH(bool, same);
        const Case solved = test::smallSlider();
        Case c = solved;
        change(c);
        QCOMPARE(isRestOf(c, solved, foundState()), same);
    }
    /// A run seeks the balance, whatever attitude the case gives for its static state.
    void aGivenAttitudeIsNoBalance()
    {
        Case c = test::smallSlider();
        c.steady.fixedAttitude = true;
        QVERIFY(!isRestOf(c, c, foundState()));
        QVERIFY(isRestOf(c, test::smallSlider(), foundState()));
    }
    /// A search that found nothing would find nothing again from the same start; from where it gave up it may find a
    /// state.
    void aSearchThatFoundNothingIsOfItsStartAlone()
    {
        const Case solved = test::smallSlider();
        const SteadyResult none = foundState(SteadyStatus::NotConverged);
        QVERIFY(isRestOf(solved, solved, none));
        Case further = solved;
        further.initial.nominalTrailingEdgeHeight = none.attitude.height;
        further.initial.pitch = none.attitude.pitch;
        further.initial.roll = none.attitude.roll;
        QVERIFY(!isRestOf(further, solved, none));
        QVERIFY(!isRestOf(solved, solved, foundState(SteadyStatus::Cancelled)));
    }
    void withoutItsFieldsThereIsNothingToStartFrom()
    {
        const Case c = test::smallSlider();
        SteadyResult state = foundState();
        state.dropFields();
        QVERIFY(!isRestOf(c, c, state));
        QCOMPARE(state.attitude.height, foundState().attitude.height);
    }
};

TOUCHDOWN_TEST(TestStaticSolution)

} // namespace test_static_solution

#include "test_static_solution.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The energy balance of runs that bounce.
#include "core/simulation/flight/film_run.h"

#include <cmath>

#include "core/case/contact_kind.h"
#include "tests/support/film_flight.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_film_run_energy {

/// The plane slider of the sample case, held where it flies by its load of 8.2 gf at 0.73 of the length, and kicked
/// onto a contact that sets in 10 nm below its static trailing edge.
Case planeOverContact()
{
    Case c = fromRest("film_plane", 30e-6);
    c.contact = ContactKind::OnoYamane;
    c.degreesOfFreedom = 2;
    c.suspension.preload = 8.2e-3 * 9.80665;
    c.suspension.offsetX = 0.23 * c.slider.length;
    c.suspension.holdsAttitude = true; // a plane slider alone does not find its pitch
    c.suspension.pitchStiffness = 1.0;
    c.suspension.staticPitch = 200e-6;
    c.onoYamane.touchDown = 90e-9;
    c.onoYamane.takeOff = 91e-9;
    c.initial.verticalVelocity = -0.1;
    c.run.sampleInterval = 0.02e-6;
    return c;
}

std::size_t count(const Flight& flight, const char* event)
{
    return static_cast<std::size_t>(
        std::ranges::count_if(flight.events, [&](const RunEvent& e) { return e.name == event; }));
}

class TestFilmRunEnergy : public QObject {
    Q_OBJECT

private slots:
    void energyCloses_data()
    {
        QTest::addColumn<Case>("flown");
        QTest::newRow("a plane slider, whose cells no edge cuts") << planeOverContact();
        Case fine = openCase("fig05_fm_15mN").value;
        fine.run.fieldSnapshots = 0;
        fine.film.nodes = {193, 193};
        fine.run.duration = 12e-6;
        QTest::newRow("the slider of Fig. 5, on the grid of its case") << fine;
        Case rough = openCase("fig02_micro_pad_case_2_moving").value;
        rough.run.fieldSnapshots = 0;
        rough.run.duration = 12e-6;
        QTest::newRow("a micro pad on a rough disk that moves") << rough;
    }
    /// What the disk gave, less what air, dampers, friction and menisci took, is the change of the stored energy, to 1
    /// % of the largest change of a part. On coarse grids that holds where no edge of a rail cuts a cell: the load of
    /// those is found more closely than by their mean pressure, and the volumes are not.
    void energyCloses()
    {
        QFETCH(Case, flown);
        const Flight flight = fly(flown);
        QVERIFY_STATUS(flight, RunStatus::Completed);
        QVERIFY(count(flight, "touch-down") >= 1 || flown.contact == ContactKind::Elastic);
        QVERIFY2(flight.figure("energy_balance") < 0.01, qPrintable(QString::number(flight.figure("energy_balance"))));
    }
};

TOUCHDOWN_TEST(TestFilmRunEnergy)

} // namespace test_film_run_energy

#include "test_film_run_energy.moc"

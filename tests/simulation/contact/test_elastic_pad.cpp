// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/contact/elastic_pad.h"

#include <algorithm>
#include <cmath>

#include <QTest>

#include "core/case/parameters.h"
#include "core/physics/contact/adhesion_kind.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_elastic_pad {

Rail rail(double x0, double x1, double y0, double y1)
{
    return {RailKind::Step, {{x0, y0, 0}, {x1, y0, 0}, {x1, y1, 0}, {x0, y1, 0}}, {0.0}};
}

/// Two trailing pads, 0.46 mm apart, pressed 1 nm into a flat disk at a pitch of 100 urad.
Case twoPads()
{
    Case c = defaultsOf(ModelKind::Contact);
    c.pad.shape = PadShape::Slider;
    c.surface.rails = {rail(1.1e-3, 1.2e-3, 0.2e-3, 0.22e-3), rail(1.1e-3, 1.2e-3, 0.68e-3, 0.7e-3)};
    c.initial.pitch = 100e-6;
    c.approach.closest = -1e-9;
    c.elastic.cell = 0.5e-6;
    return c;
}

Case flatPad()
{
    Case c = defaultsOf(ModelKind::Contact);
    c.pad.length = c.pad.width = 4e-6;
    return c;
}

class TestElasticPad : public QObject {
    Q_OBJECT

private slots:
    /// Each of two pads that are alike carries what one of them alone carries.
    void padsCarryAlone()
    {
        const Case both = twoPads();
        Case one = both;
        one.surface.rails.pop_back();
        const ContactForces two = ElasticPad(both).move(-1e-9, 0.0);
        const ContactForces alone = ElasticPad(one).move(-1e-9, 0.0);
        QCOMPARE(two.problem, std::string());
        QVERIFY(alone.contact > 0.0);
        QVERIFY(std::abs(two.contact / alone.contact - 2.0) < 1e-6);
        QVERIFY(std::abs(two.peakPressure / alone.peakPressure - 1.0) < 1e-6);
    }
    /// 1 mN/(pi E* r) with E* = 84.81 GPa and r = 0.46 mm less a cell or two: 8.2 pm.
    void tellsWhatIsLeftOut()
    {
        const std::vector<std::string> remarks = ElasticPad(twoPads()).remarks();
        QCOMPARE(remarks.size(), std::size_t{1});
        QVERIFY2(remarks[0].starts_with("2 patches are solved as if each were alone"), remarks[0].c_str());
        QVERIFY2(remarks[0].find("0.0082 nm") != std::string::npos, remarks[0].c_str());
        QVERIFY(ElasticPad(flatPad()).remarks().empty());
    }
    /// The zone of a Lennard-Jones law is E* z0^2/(1.0264^2 dgamma), 8/3 (s^3 - s^9) <= 1.0264: at z0 = 0.3 nm, 50 mN/m
    /// and 84.81 GPa 0.1449 um.
    void tellsOfCoarseCells()
    {
        Case c = flatPad();
        c.adhesion.kind = AdhesionKind::LennardJones;
        const std::vector<std::string> remarks = ElasticPad(c).remarks();
        QCOMPARE(remarks.size(), std::size_t{1});
        QVERIFY2(remarks[0].find("over a zone of 0.1449 um") != std::string::npos, remarks[0].c_str());
        c.elastic.cell = 0.0625e-6;
        QVERIFY(ElasticPad(c).remarks().empty());
    }

    void tellsWhatCountsAsAdhesion()
    {
        Case c = flatPad();
        c.adhesion.kind = AdhesionKind::VanDerWaals;
        c.elastic.cell = 0.03125e-6;
        const std::vector<std::string> remarks = ElasticPad(c).remarks();
        QVERIFY(std::ranges::any_of(
            remarks, [](const std::string& r) { return r.starts_with("van-der-waals repels by itself"); }));
    }

    void nothingTouches()
    {
        ElasticPad pad(flatPad());
        const ContactForces& forces = pad.move(1e-9, 0.0);
        QCOMPARE(forces.contact, 0.0);
        QCOMPARE(forces.area, 0.0);
        QCOMPARE(forces.iterations, 0);
        QVERIFY(std::abs(forces.minimumGap - 1e-9) < 1e-24);
    }
    /// A bump of 2 nm under the pad lifts contact to a separation of 2 nm; moved away by the disk it leaves none.
    void bumpPasses()
    {
        Case c = flatPad();
        c.diskSurface.kind = DiskSurfaceKind::Bumps;
        c.diskSurface.bumpHeights = {2e-9};
        c.diskSurface.bumpLengths = {3e-6};
        c.diskSurface.bumpX = {2e-6};
        c.diskSurface.bumpY = {2e-6};
        c.diskSurface.track = c.diskSurface.trackWidth = 32e-6;
        c.disk.speed = 1.0 / c.disk.radius; // 1 m/s
        ElasticPad pad(c);
        QVERIFY(pad.move(1e-9, 0.0).contact > 0.0);
        QCOMPARE(pad.move(1e-9, 10e-6).contact, 0.0);
        QVERIFY(pad.move(1e-9, 32e-6).contact > 0.0);
        const double there = pad.move(1e-9, 32e-6).contact;
        QVERIFY(std::abs(pad.move(1e-9, 0.0).contact / there - 1.0) < 1e-6);
    }
    /// At contact the pressure of the maps is that of the forces.
    void observes()
    {
        ElasticPad pad(twoPads());
        const ContactForces forces = pad.move(-1e-9, 0.0);
        FieldSnapshot snapshot;
        pad.observe(snapshot);
        const RecordedFields fields = contactMaps(twoPads());
        QCOMPARE(snapshot.values.size(), fields.quantities.size());
        QCOMPARE(snapshot.values[1].size(), fields.grid.cells());
        // Of the first pad; the other one is like it.
        QVERIFY(std::abs(*std::ranges::max_element(snapshot.values[1]) / forces.peakPressure - 1.0) < 1e-6);
    }
    /// Recalled, the pad is where it was: the snap of an adhesive one is taken back.
    void remembers()
    {
        Case c = flatPad();
        c.adhesion.kind = AdhesionKind::LennardJones;
        c.elastic.tolerance = 1e-8;
        ElasticPad pad(c);
        const double far = pad.move(3e-9, 0.0).net();
        pad.remember();
        QVERIFY(pad.move(0.2e-9, 0.0).net() != far);
        pad.move(-0.5e-9, 0.0);
        pad.recall();
        QVERIFY(std::abs(pad.move(3e-9, 0.0).net() / far - 1.0) < 1e-6);
    }
    /// 16 cells across: influence coefficients at the distances 0 to 16 of the domain of 32.
    void isAskedWhileItIsMade()
    {
        int asked = 0;
        const ElasticPad pad(flatPad(), [&] { return ++asked > 0; });
        QVERIFY2(asked >= 17, qPrintable(QString::number(asked)));
    }
    /// A solution that is stopped says that it did not converge.
    void stops()
    {
        for (const AdhesionKind kind : {AdhesionKind::None, AdhesionKind::LennardJones}) {
            Case c = twoPads();
            c.adhesion.kind = kind;
            int asked = 0;
            ElasticPad pad(c, [&] { return ++asked < 3; });
            QVERIFY(!pad.move(-1e-9, 0.0).problem.empty());
            QVERIFY(asked >= 3 && asked < 20);
        }
    }
};

TOUCHDOWN_TEST(TestElasticPad)

} // namespace test_elastic_pad

#include "test_elastic_pad.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/contact/contact_figures.h"

#include <algorithm>
#include <cmath>

#include <QTest>

#include "core/case/parameters.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_contact_figures {

ContactForces forces(double separation, double contact, double adhesion, double area = 0.0)
{
    ContactForces f;
    f.separation = separation;
    f.contact = contact;
    f.adhesion = adhesion;
    f.area = area;
    return f;
}

double value(const std::vector<RunFigure>& list, const char* name)
{
    const auto found = std::ranges::find(list, name, [](const RunFigure& figure) { return figure.quantity.name; });
    return found == list.end() ? NAN : found->value;
}

class TestContactFigures : public QObject {
    Q_OBJECT

private slots:
    void curve()
    {
        const Case c = defaultsOf(ModelKind::Contact);
        ContactFigures figures(c);
        figures.add(forces(2e-9, 0.0, -3e-3), false); // a pull on the way in is no pull-off
        figures.add(forces(-1e-9, 5e-3, -1e-3, 2e-12), false);
        figures.add(forces(1e-9, 0.0, -2e-3), true);
        figures.add(forces(2e-9, 1e-3, -2e-3), true);
        const auto list = figures.figures({});
        QCOMPARE(value(list, "largest_contact_force"), 5e-3);
        QCOMPARE(value(list, "pull_off_force"), 2e-3);
        QCOMPARE(value(list, "pull_off_separation"), 1e-9);
        QCOMPARE(value(list, "closest_contact_area"), 2e-12);
        QVERIFY(std::isnan(value(list, "snap_in_separation")));
        QVERIFY(std::isnan(value(list, "surface_rms")));
    }
    /// The strongest pull may lie just before a jump, between two samples; the first jumps of each way are told.
    void jumps()
    {
        const Case c = defaultsOf(ModelKind::Contact);
        ContactFigures figures(c);
        figures.add(forces(1e-9, 0.0, -2e-3), true);
        figures.addJump({true, 2e-9, 1.9e-9, -1e-3, -2e-3});
        figures.addJump({true, 1.5e-9, 1.4e-9, -2e-3, -3e-3});
        figures.addJump({true, 3e-9, 3.1e-9, -4e-3, 0.0});
        figures.addJump({true, 4e-9, 4.1e-9, -1e-3, 0.0});
        const auto list = figures.figures({});
        QCOMPARE(value(list, "snap_in_separation"), 2e-9);
        QCOMPARE(value(list, "release_separation"), 3e-9);
        QCOMPARE(value(list, "pull_off_force"), 4e-3);
        QCOMPARE(value(list, "pull_off_separation"), 3e-9);
    }
    /// A jump releases energy; what is not work between its two separations is lost. A pull between two samples counts.
    void workOfTheLoop()
    {
        Case c = defaultsOf(ModelKind::Contact);
        c.diskSurface.kind = DiskSurfaceKind::Flat;
        ContactFigures figures(c);
        figures.addJump({true, 3e-9, 3e-9, 0.0, -1e-3, -0.1e-12, -0.5e-12});
        QVERIFY(std::isnan(value(figures.figures({}), "loop_work"))); // not yet a loop
        // 2 nm against a pull of 0.5 mN in the mean put 1 pJ into it, of which 0.4 pJ stay.
        figures.addJump({true, 4e-9, 6e-9, -1e-3, 0.0, -0.4e-12, 0.0});
        figures.addPull(3.5e-9, -1.5e-3);
        const auto list = figures.figures({});
        const double work = value(list, "loop_work");
        QVERIFY2(std::abs(work - (0.4e-12 + 0.6e-12)) < 1e-22, qPrintable(QString::number(work)));
        QCOMPARE(value(list, "pull_off_force"), 1.5e-3);
        QCOMPARE(value(list, "pull_off_separation"), 3.5e-9);
    }
    void surface()
    {
        Case c = defaultsOf(ModelKind::Contact);
        SurfaceStatistics statistics;
        statistics.rms = 0.2e-9;
        statistics.kurtosis = 3.1;
        const auto list = ContactFigures(c).figures(statistics);
        QCOMPARE(value(list, "surface_rms"), 0.2e-9);
        QCOMPARE(value(list, "surface_kurtosis"), 3.1);
        QVERIFY(std::isnan(value(list, "closest_contact_area")));
    }
};

TOUCHDOWN_TEST(TestContactFigures)

} // namespace test_contact_figures

#include "test_contact_figures.moc"

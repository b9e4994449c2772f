// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/contact/gap_contact.h"
#include "core/simulation/contact/pad_contact.h"

#include <cmath>
#include <random>

#include <QTest>

#include "core/case/contact_kind.h"
#include "core/case/disk_setup.h"
#include "core/case/parameters.h"
#include "core/physics/contact/adhesion_kind.h"
#include "core/physics/film/film_grid.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_gap_contact {

constexpr double length = 1.25e-3, width = 1.0e-3;
constexpr double padLength = 0.1e-3, padWidth = 0.04e-3, edge = 1.2e-3;

/// One pad of 0.1 x 0.04 mm near the trailing edge, in the middle, without crown and friction.
Case withPad()
{
    Case c = defaultsOf(ModelKind::Film);
    c.contact = ContactKind::Asperity;
    c.surface = {};
    c.surface.baseRecess = 2e-6;
    c.surface.rails = {
        {.points = {{edge - padLength, 0.48e-3}, {edge, 0.48e-3}, {edge, 0.52e-3}, {edge - padLength, 0.52e-3}}}};
    c.asperity.friction = 0.0;
    c.asperity.heightDeviation = 0.3e-9;
    return c;
}

struct Contact {
    explicit Contact(const Case& c, int cells = 48)
        : recess(c.surface, length, width),
          spacing(c.surface, recess),
          topography(diskTopography(c, {})),
          grid(gradedGrid(c.surface, length, width, cells, cells)),
          padded{grid.nx(), grid.ny()},
          law(c, *gapLawOf(c), spacing, topography, grid, padded, {})
    {}
    Recess recess;
    MinimumSpacing spacing;
    DiskTopography topography;
    CellGrid grid;
    PaddedGrid padded;
    GapContact law;
};

/// With the pad's trailing edge at `spacing` over the disk where the roll is zero.
Attitude at(double spacing, double pitch, double roll = 0.0)
{
    return {spacing - pitch * (length - edge), pitch, roll};
}

class TestGapContact : public QObject {
    Q_OBJECT

private slots:
    void parallelPadHasThePressureOfItsArea()
    {
        const Case c = withPad();
        Contact contact(c);
        const AsperityContact law(c.asperity, c.elastic.pair);
        for (const double d : {0.5e-9, 1.9e-9, 3e-9}) {
            const SliderContactForces& f = contact.law.at(at(d, 0.0), 0.0);
            const double expected = padLength * padWidth * law.pressure(d);
            QVERIFY2(std::abs(f.contact - expected) < 1e-9 * expected,
                     qPrintable(QString("%1: %2 %3").arg(d).arg(f.contact).arg(expected)));
            QVERIFY(std::abs(f.area - padLength * padWidth * law.contactArea(d)) < 1e-9 * f.area);
            QVERIFY(std::abs(f.pitchTorque + expected * (edge - 0.5 * padLength - 0.5 * length)) <
                    1e-9 * expected * length);
        }
    }

    /// Along a gap that rises with the pitch the force is w (W(d) - W(d + pitch l))/pitch, W the law's energy: its
    /// table holds to 1e-9 of W(0). Cells are 2 um to 30 um long, over which the gap changes by up to 20 deviations.
    void tiltedPadIsIntegratedWithinItsCells()
    {
        const Case c = withPad();
        const AsperityContact law(c.asperity, c.elastic.pair);
        for (const int cells : {16, 48}) {
            Contact contact(c, cells);
            for (const double pitch : {20e-6, 150e-6, 600e-6})
                for (const double d : {-1e-9, 1.5e-9, 2.8e-9}) {
                    const double expected = padWidth * (law.energy(d) - law.energy(d + pitch * padLength)) / pitch;
                    const double found = contact.law.at(at(d, pitch), 0.0).contact;
                    QVERIFY2(
                        std::abs(found - expected) < 1e-6 * expected,
                        qPrintable(
                            QString("%1 cells, %2, %3: %4 %5").arg(cells).arg(pitch).arg(d).arg(found).arg(expected)));
                }
        }
    }

    /// The same of summits and an attraction, by its energy. The rest of the slider, 2 um higher, adds 1e-6.
    void attractionIsIntegratedWithinItsCells()
    {
        Case c = withPad();
        for (const AdhesionKind kind : {AdhesionKind::LennardJones, AdhesionKind::VanDerWaals}) {
            c.adhesion.kind = kind;
            const GapLaw law(c.asperity, c.elastic.pair, c.adhesion);
            for (const int cells : {16, 48}) {
                Contact contact(c, cells);
                for (const double pitch : {20e-6, 150e-6})
                    for (const double d : {2.6e-9, 6e-9}) {
                        const double far = law.at(d + pitch * padLength).energy;
                        const double expected = padWidth * (law.at(d).energy - far) / pitch;
                        const SliderContactForces& f = contact.law.at(at(d, pitch), 0.0);
                        const double found = f.contact + f.adhesion;
                        QVERIFY2(std::abs(found - expected) < 1e-5 * std::abs(expected),
                                 qPrintable(QString("%1 cells, %2, %3: %4 %5")
                                                .arg(cells)
                                                .arg(pitch)
                                                .arg(d)
                                                .arg(found)
                                                .arg(expected)));
                    }
            }
        }
    }

    /// At attitudes drawn at random, with friction: central differences over 1e-13 m at the corners.
    void stiffnessIsTheForcesSlope()
    {
        Case c = withPad();
        c.asperity.friction = 0.4;
        c.adhesion.kind = AdhesionKind::LennardJones;
        Contact contact(c);
        std::mt19937 random(11);
        std::uniform_real_distribution<double> unit(-1.0, 1.0);
        const Vector3 scale(1.0, 1.0 / length, 1.0 / width);
        for (int n = 0; n < 20; ++n) {
            const Attitude place = at(2e-9 + 1e-9 * unit(random), 100e-6 + 90e-6 * unit(random), 10e-6 * unit(random));
            contact.law.at(place, 0.0);
            const Matrix3 stiffness = scale.asDiagonal() * contact.law.stiffness() * scale.asDiagonal();
            for (int m = 0; m < 3; ++m) {
                constexpr double step = 1e-13;
                Vector3 load[2];
                for (const int side : {0, 1}) {
                    const double by = (side == 0 ? step : -step) * scale[m];
                    Attitude moved = place;
                    // About the mass centre the trailing edge falls by half the length times the pitch.
                    if (m == 0) moved.height += by;
                    if (m == 1) moved.pitch += by, moved.height -= 0.5 * length * by;
                    if (m == 2) moved.roll += by;
                    load[side] = scale.cwiseProduct(contact.law.at(moved, 0.0).load());
                }
                const Vector3 slope = (load[1] - load[0]) / (2.0 * step);
                QVERIFY2(
                    (slope - stiffness.col(m)).norm() < 1e-5 * stiffness.norm(),
                    qPrintable(
                        QString("%1 %2: %3").arg(n).arg(m).arg((slope - stiffness.col(m)).norm() / stiffness.norm())));
            }
        }
    }

    /// A pad whose sides lie across the cells: its area, of which strips of an eighth of a cell miss the corners alone.
    void slantedEdgesKeepTheArea()
    {
        Case c = withPad();
        c.surface.rails = {
            {.points = {{1.10e-3, 0.47e-3}, {1.21e-3, 0.49e-3}, {1.19e-3, 0.56e-3}, {1.08e-3, 0.54e-3}}}};
        Contact contact(c);
        const AsperityContact law(c.asperity, c.elastic.pair);
        const double area = 0.5 * std::abs((1.19 - 1.10) * (0.54 - 0.49) - (0.56 - 0.47) * (1.08 - 1.21)) * 1e-6;
        const double expected = area * law.pressure(2e-9), found = contact.law.at({2e-9, 0.0, 0.0}, 0.0).contact;
        QVERIFY2(std::abs(found - expected) < 2e-3 * expected, qPrintable(QString("%1 %2").arg(found).arg(expected)));
    }

    /// Over a wave as long as the slider, which lifts the disk by 1 nm under the pad's cells.
    void seesTheDisk()
    {
        Case c = withPad();
        c.diskSurface.kind = DiskSurfaceKind::Waves;
        c.diskSurface.motion = SurfaceMotion::Still;
        c.diskSurface.waveLengths = {1.25e-3};
        c.diskSurface.waveAmplitudes = {1e-9};
        Contact over(c), flat(withPad());
        std::vector<double> heights(over.padded.size());
        DiskUnderFilm disk(c, over.topography, over.grid, over.padded);
        disk.at(0.0, heights);
        double lowest = 1.0, highest = -1.0;
        for (int j = 0; j < over.grid.ny(); ++j)
            for (int i = 0; i < over.grid.nx(); ++i) {
                const double x = over.grid.centreX(i), y = over.grid.centreY(j);
                if (x < edge - padLength || x > edge || y < 0.48e-3 || y > 0.52e-3) continue;
                lowest = std::min(lowest, heights[over.padded.at(i, j)]);
                highest = std::max(highest, heights[over.padded.at(i, j)]);
            }
        QVERIFY(highest > lowest);
        const double found = over.law.at(at(2e-9, 0.0), 0.0).contact;
        QVERIFY(found > flat.law.at(at(2e-9 - lowest, 0.0), 0.0).contact);
        QVERIFY(found < flat.law.at(at(2e-9 - highest, 0.0), 0.0).contact);
    }

    void nothingActsOutOfReach()
    {
        const Case c = withPad();
        Contact contact(c);
        const double reach = contact.law.reach();
        QVERIFY(contact.law.outOfReach(at(1.001 * reach, 100e-6)));
        QCOMPARE(contact.law.at(at(1.001 * reach, 100e-6), 0.0).contact, 0.0);
        QVERIFY(!contact.law.outOfReach(at(0.99 * reach, 100e-6)));
    }
};

TOUCHDOWN_TEST(TestGapContact)

} // namespace test_gap_contact

#include "test_gap_contact.moc"

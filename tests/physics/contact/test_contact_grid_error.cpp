// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/contact/contact_grid_error.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <QTest>

#include "core/physics/contact/contact_patch.h"
#include "core/physics/contact/elastic_contact.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_contact_grid_error {

constexpr double modulus = 85e9; // [Pa]

/// A pad pressed onto a half-space, solved on its grid.
struct Pressed {
    ElasticContact contact;
    SeparationOn separation;
    double force = 0.0; // [N]

    Pressed(const UniformGrid& grid, double e, const LengthAt& s, HalfSpaceEdges edges = HalfSpaceEdges::Free)
        : contact(HalfSpace(grid, e, edges)), separation([s](const UniformGrid& g, std::span<double> out) {
              for (int j = 0; j < g.ny; ++j)
                  for (int i = 0; i < g.nx; ++i) out[g.at(i, j)] = s(g.x(i), g.y(j));
          })
    {
        std::vector<double> values(grid.cells());
        separation(grid, values);
        if (!contact.solve(values).converged) qFatal("not converged");
        for (const double p : contact.pressure()) force += p * grid.cellArea();
    }
    ContactState state()
    {
        return {.grid = contact.space().grid(),
                .modulus = contact.space().modulus(),
                .edges = contact.space().edges(),
                .pressure = contact.pressure()};
    }
    ContactGridError error() { return contactGridError(state(), separation); }
};

/// A sphere's lowest point at (x, y), `depth` below the plane.
LengthAt sphere(double radius, double x, double y, double depth)
{
    return [=](double atX, double atY) {
        return ((atX - x) * (atX - x) + (atY - y) * (atY - y)) / (2.0 * radius) - depth;
    };
}

UniformGrid square(int cells, double cell) { return {cells, cells, cell, cell, 0.0, 0.0}; }

class TestContactGridError : public QObject {
    Q_OBJECT

private slots:
    void spheres_data()
    {
        QTest::addColumn<double>("least"); // contact radius in cells
        QTest::addColumn<double>("most");
        QTest::addColumn<double>("median"); // of stated over true error, at most
        QTest::newRow("far smaller than a cell") << 0.03 << 0.3 << 1.2;
        QTest::newRow("about a cell") << 0.3 << 1.0 << 1.5;
        QTest::newRow("a few cells") << 1.0 << 5.0 << 2.0;
        QTest::newRow("many cells") << 5.0 << 20.0 << 2.0;
    }
    /// Hertz: F = (4/3) E* sqrt(R d) d on the area pi R d. The true error is covered, and not by far more.
    void spheres()
    {
        QFETCH(double, least);
        QFETCH(double, most);
        QFETCH(double, median);
        std::mt19937 random(11);
        const auto draw = [&] { return static_cast<double>(random()) / 4294967296.0; };
        std::vector<double> ratios;
        for (int k = 0; k < 40; ++k) {
            const double e = std::pow(10.0, 8.0 + 3.5 * draw()), cell = std::pow(10.0, -8.0 + 2.0 * draw());
            const double radius = cell * std::pow(10.0, 1.0 + 4.0 * draw());
            const double contact = cell * least * std::pow(most / least, draw()), depth = contact * contact / radius;
            const int cells = std::max(8, static_cast<int>(2.6 * contact / cell) + 2 + static_cast<int>(3.0 * draw()));
            const double x = (0.5 * cells + draw() - 0.5) * cell, y = (0.5 * cells + draw() - 0.5) * cell;
            Pressed pressed(square(cells, cell), e, sphere(radius, x, y, depth));
            const ContactGridError error = pressed.error();
            QVERIFY(error.known);
            const double force = 4.0 / 3.0 * e * contact * depth;
            const double area = std::numbers::pi * contact * contact;
            QVERIFY2(error.force >= std::abs(pressed.force - force), qPrintable(QString::number(k)));
            QVERIFY2(error.area >= std::abs(pressed.contact.contactArea() - area), qPrintable(QString::number(k)));
            ratios.push_back(error.force / std::abs(pressed.force - force));
        }
        std::ranges::nth_element(ratios, ratios.begin() + 20);
        QVERIFY2(ratios[20] < median, qPrintable(QString::number(ratios[20])));
    }

    /// The pressure is infinite at the edges of a flat pad: its error falls in proportion to the cell. With 20, 40, 80
    /// and 160 cells F tends to the value extrapolated from the last two.
    void flatPad()
    {
        const LengthAt flat = [](double, double) { return -1e-9; };
        const double fine = Pressed(square(80, 0.05e-6), modulus, flat).force;
        const double finest = Pressed(square(160, 0.025e-6), modulus, flat).force;
        const double limit = 2.0 * finest - fine;
        for (const int cells : {20, 40}) {
            Pressed pressed(square(cells, 4e-6 / cells), modulus, flat);
            const double error = pressed.error().force, actual = std::abs(pressed.force - limit);
            QVERIFY2(error >= 0.97 * actual && error < 1.5 * actual, qPrintable(QString::number(error / actual)));
        }
    }
    /// A state of many cells is compared with larger cells, whose difference is three times the error or more.
    void manyCells()
    {
        const double radius = 1e-3, depth = 25e-9, contact = std::sqrt(radius * depth); // 5 um
        const UniformGrid grid = square(401, 0.03e-6);
        Pressed pressed(grid, modulus, sphere(radius, 200.5 * 0.03e-6, 200.5 * 0.03e-6, depth));
        const ContactGridError error = pressed.error();
        QVERIFY(error.known && error.cell > grid.dx);
        QVERIFY(error.force >= std::abs(pressed.force - 4.0 / 3.0 * modulus * contact * depth));
        QVERIFY(error.force < 1e-3 * pressed.force);
    }
    void periodic()
    {
        const auto waves = [](double x, double y) {
            return 2e-9 + 2e-9 * std::cos(x * std::numbers::pi / 2e-6) * std::cos(y * std::numbers::pi / 2e-6) - 1e-9;
        };
        Pressed coarse(square(16, 0.25e-6), modulus, waves, HalfSpaceEdges::Periodic);
        const double fine = Pressed(square(128, 0.03125e-6), modulus, waves, HalfSpaceEdges::Periodic).force;
        const ContactGridError error = coarse.error();
        QVERIFY(error.known && error.force >= std::abs(coarse.force - fine));
        QVERIFY(error.force < 0.1 * fine);
    }
    void nothingTouches()
    {
        Pressed pressed(square(8, 1e-6), modulus, [](double, double) { return 1e-9; });
        const ContactGridError error = pressed.error();
        QVERIFY(error.known);
        QCOMPARE(error.force, 0.0);
        QCOMPARE(error.cells, 0LL);
    }
    void stops()
    {
        Pressed pressed(square(16, 0.25e-6), modulus, sphere(1e-4, 2e-6, 2e-6, 5e-9));
        QVERIFY(!contactGridError(pressed.state(), pressed.separation, [] { return false; }).known);
    }

    /// Hertz' contact has the radius sqrt(R d) = 1 um.
    void cutOff()
    {
        const LengthAt wide = sphere(1e-4, 2e-6, 2e-6, 10e-9);
        Pressed whole(square(32, 0.125e-6), modulus, wide);
        QVERIFY(!isCutOff(whole.state(), whole.separation));
        UniformGrid part = square(16, 0.125e-6); // half of it lies beyond x = 2 um
        Pressed cut(part, modulus, wide);
        QVERIFY(isCutOff(cut.state(), cut.separation));
        // A pad that has ended there is not cut off.
        Pressed ends(part, modulus, [&](double x, double y) {
            return x > 0.0 && y > 0.0 && x < 2e-6 && y < 2e-6 ? wide(x, y) : beyondPad;
        });
        QVERIFY(!isCutOff(ends.state(), ends.separation));
    }
    void halfAsManyCells()
    {
        const UniformGrid grid = coarsened(UniformGrid{7, 8, 1e-6, 1e-6, 2e-6, 3e-6});
        QCOMPARE(grid.nx, 4);
        QCOMPARE(grid.ny, 4);
        QCOMPARE(grid.dx, 1.75e-6);
        QCOMPARE(grid.dy, 2e-6);
        QCOMPARE(grid.x0, 2e-6);
    }
};

TOUCHDOWN_TEST(TestContactGridError)

} // namespace test_contact_grid_error

#include "test_contact_grid_error.moc"

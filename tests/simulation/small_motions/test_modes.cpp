// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>

#include <complex>
#include <numbers>

#include "core/physics/film/film_oscillation.h"
#include "core/physics/film/slip_model.h"
#include "core/simulation/static_state/film_setup.h"
#include "core/simulation/static_state/steady.h"
#include "tests/support/small_slider.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_modes {

class TestModes : public QObject {
    Q_OBJECT

private slots:
    void aHeavySliderOscillatesOnTheStaticFilm();
    void threeModesAreFound();
    void noModeIsFoundTwiceOrLost_data();
    void noModeIsFoundTwiceOrLost();
    void aHeldRollHasNoMode();
    void saysWhereTheGridIsTooCoarse();
    void stiffAndSoftLimitsOfTheFilm();
    void aPlateOverADiskAtRestIsASqueezeFilm();
};

constexpr double twoPi = 2.0 * std::numbers::pi;

using Complex = std::complex<double>;

/// What is left of (s^2 M + s C + K + Z(s)) q at a mode, as a share of its parts' magnitudes, the greatest of its three
/// rows. For a film whose shear has no torques.
double imbalance(const Case& c, const SteadyResult& rest, const AirBearingMode& mode)
{
    const Recess recess(c.surface, c.slider.length, c.slider.width);
    const MinimumSpacing spacing(c.surface, recess);
    FilmLevel level(c, recess, spacing, rest.grid);
    level.gaps.pad.pad<double>(rest.pressure, level.pressure);
    level.film.setAttitude(rest.attitude);
    std::vector<double> residual(level.pressure.size());
    level.film.linearise(level.pressure, residual);
    FilmLoads::Derivatives forces;
    level.loads.derivatives(level.pressure, forces);
    std::array<std::vector<double>, 3> byPressure;
    Matrix3 byAttitude;
    for (std::size_t k = 0; k < 3; ++k) {
        byPressure[k] = forces.byPressure[k];
        for (std::size_t m = 0; m < 3; ++m) byAttitude(k, m) = forces.byAttitude[k][m];
    }
    // 2 pi f = |s| sqrt(1 - zeta^2).
    const double omega = twoPi * mode.frequency, zeta = mode.dampingRatio;
    const Complex s(-zeta * omega / std::sqrt(1.0 - zeta * zeta), omega);
    bool solved = true;
    const ComplexMatrix3 z = FilmOscillation(level.film, level.pressure).stiffness(s, byPressure, byAttitude, solved);
    if (!solved) return INFINITY;
    std::array<Complex, 3> q, film;
    for (std::size_t k = 0; k < 3; ++k) q[k] = film[k] = Complex(mode.shape[k][0], mode.shape[k][1]);
    // The film knows the height of the trailing edge, half a length behind the mass centre.
    film[0] -= 0.5 * c.slider.length * q[1];
    const std::array mass{c.slider.mass, c.slider.pitchInertia, c.slider.rollInertia};
    const SuspensionCase& arm = c.suspension;
    const std::array spring{arm.stiffness, arm.pitchStiffness, arm.rollStiffness};
    const std::array damper{arm.damping, arm.pitchDamping, arm.rollDamping};
    double worst = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Complex inertia = s * s * mass[k] * q[k], held = (spring[k] + s * damper[k]) * q[k];
        Complex sum = inertia + held;
        double size = std::abs(inertia) + std::abs(held);
        for (std::size_t m = 0; m < 3; ++m) {
            sum += z(k, m) * film[m];
            size += std::abs(z(k, m) * film[m]);
        }
        worst = std::max(worst, std::abs(sum) / size);
    }
    return worst;
}

void TestModes::aHeavySliderOscillatesOnTheStaticFilm()
{
    // So heavy that it oscillates far below the film's own rates: a single mass on the static stiffness. Pitch and roll
    // are kept away by huge inertias: K_zz about the centre is that of the height alone.
    Case c = test::smallSlider(49);
    c.slider.mass = 100.0;
    c.slider.pitchInertia = c.slider.rollInertia = 1e3;
    const ModesResult r = modes(c);
    QCOMPARE(r.status, SteadyStatus::Converged);
    const double expected = std::sqrt(((*r.steady.stiffness)(0, 0) + c.suspension.stiffness) / c.slider.mass) / twoPi;
    const auto vertical =
        std::find_if(r.modes.begin(), r.modes.end(), [](const auto& m) { return m.kind == "vertical"; });
    QVERIFY(vertical != r.modes.end());
    QVERIFY2(std::abs(vertical->frequency - expected) < 1e-4 * expected,
             qPrintable(QString("%1 Hz, expected %2 Hz").arg(vertical->frequency).arg(expected)));
}

void TestModes::threeModesAreFound()
{
    // Fine enough for the waves that the disk drags along at the highest mode, 31 um at 300 kHz: on a coarse grid their
    // phases under the rear pad are wrong, and the sign of its damping with them.
    const ModesResult r = modes(test::smallSlider(129));
    QCOMPARE(r.status, SteadyStatus::Converged);
    QCOMPARE(r.modes.size(), std::size_t(3));
    for (const AirBearingMode& mode : r.modes) {
        QVERIFY(mode.frequency > 1e4 && mode.frequency < 2e6);
        QVERIFY(mode.dampingRatio > 0.0 && mode.dampingRatio < 0.5);
        // Shapes are scaled so that the corner that moves most moves by one.
        double largest = 0.0;
        for (const double x : {-0.5e-3, 0.5e-3})
            for (const double y : {-0.4e-3, 0.4e-3}) {
                const auto corner = [&](std::size_t part) {
                    return mode.shape[0][part] - x * mode.shape[1][part] - y * mode.shape[2][part];
                };
                largest = std::max(largest, std::hypot(corner(0), corner(1)));
            }
        QVERIFY(std::abs(largest - 1.0) < 1e-12);
    }
    QVERIFY(r.modes[0].frequency <= r.modes[1].frequency && r.modes[1].frequency <= r.modes[2].frequency);
}

void TestModes::noModeIsFoundTwiceOrLost_data()
{
    QTest::addColumn<double>("height");
    QTest::addColumn<double>("pitch");
    QTest::newRow("far from the frequencies that the film's answer at 100 kHz leads to") << 4e-9 << 300e-6;
    QTest::newRow("two modes close together, far above the disk") << 60e-9 << 150e-6;
    QTest::newRow("one strongly damped as if the film answered as at 100 kHz") << 2e-9 << 80e-6;
}

void TestModes::noModeIsFoundTwiceOrLost()
{
    QFETCH(double, height);
    QFETCH(double, pitch);
    Case c = test::smallSlider(33);
    c.steady.fixedAttitude = true;
    c.steady.torqueSign = 0.0;
    c.initial.nominalTrailingEdgeHeight = height;
    c.initial.pitch = pitch;
    const ModesResult r = modes(c);
    QCOMPARE(r.status, SteadyStatus::Converged);
    QCOMPARE(r.modes.size(), std::size_t(3));
    for (std::size_t k = 0; k < 3; ++k) {
        if (k > 0) QVERIFY(r.modes[k].frequency > 1.001 * r.modes[k - 1].frequency);
        // s stays to 1e-9, and s^2 M is about as large as the film's part.
        const double left = imbalance(c, r.steady, r.modes[k]);
        QVERIFY2(left < 1e-7, qPrintable(QString("%1 at %2 Hz").arg(left).arg(r.modes[k].frequency)));
    }
}

void TestModes::aHeldRollHasNoMode()
{
    // Held at the roll that it would find, it moves as with a huge moment of inertia about that axis; to what the grids
    // differ by, which are adapted to coarser films of another roll.
    Case c = test::smallSlider(49);
    c.slider.rollInertia = 1e3;
    const ModesResult heavy = modes(c);
    c.degreesOfFreedom = 2;
    c.initial.roll = heavy.steady.attitude.roll;
    const ModesResult held = modes(c);
    QCOMPARE(held.status, SteadyStatus::Converged);
    QCOMPARE(held.modes.size(), std::size_t(2));
    QVERIFY(heavy.modes.size() >= 2); // its roll is too slow to count
    const std::size_t others = heavy.modes.size() - 2;
    for (std::size_t k = 0; k < 2; ++k) {
        QVERIFY(std::abs(held.modes[k].frequency / heavy.modes[others + k].frequency - 1.0) < 1e-4);
        QVERIFY(std::abs(held.modes[k].dampingRatio - heavy.modes[others + k].dampingRatio) < 1e-5);
        QVERIFY(std::hypot(held.modes[k].shape[2][0], held.modes[k].shape[2][1]) < 1e-9);
    }
}

/// Where the error that the cells leave reaches a damping ratio, or is not known.
void TestModes::saysWhereTheGridIsTooCoarse()
{
    const auto says = [](const ModesResult& r, const char* words) {
        return r.message.find(words) != std::string::npos;
    };
    // Three cells of an even grid carry the fastest wave; on finer grids its mode's damping ratio is nearly half.
    const ModesResult r = modes(test::smallSlider(97));
    QVERIFY(r.modes[2].dampingError > std::abs(r.modes[2].dampingRatio));
    for (std::size_t k : {0u, 1u}) QVERIFY(r.modes[k].dampingError < std::abs(r.modes[k].dampingRatio));
    QVERIFY(says(r, "1 mode has a damping ratio below the error that the grid leaves"));
    // Of 32 cells no half is used.
    const ModesResult single = modes(test::smallSlider(33));
    QVERIFY(std::isnan(single.modes.front().dampingError) && std::isnan(single.modes.front().frequencyError));
    QVERIFY(says(single, "not known"));
}

void TestModes::stiffAndSoftLimitsOfTheFilm()
{
    // Squeezed fast, the air cannot leave: p h is kept, the pressure rises by p dh/h, and the film is stiffer than at
    // rest in the limit by K = sum of p A/h. At 1 MHz the rear pad is there; the deep recess adds little.
    const ModesResult r = modes(test::smallSlider(65));
    double trapped = 0.0;
    const SteadyResult& s = r.steady;
    for (int j = 0; j < s.grid.ny(); ++j)
        for (int i = 0; i < s.grid.nx(); ++i) {
            const std::size_t k = static_cast<std::size_t>(j * s.grid.nx() + i);
            trapped += s.pressure[k] * s.grid.widthX(i) * s.grid.widthY(j) / s.gap[k];
        }
    const double fast = r.stiffness.back().stiffness(0, 0);
    QVERIFY(fast > (*s.stiffness)(0, 0));
    QVERIFY2(fast < trapped && fast > 0.5 * trapped, qPrintable(QString("%1 %2").arg(fast).arg(trapped)));
}

/// Blech 1983: K(s) of a level plate of sides L and W over a disk at rest, beta = W/L, x = 12 mu s W^2/(p0 h^2):
/// K = 64 p0 L W/(pi^4 h) sum of x/(x + pi^2 (m^2 + n^2 beta^2))/(m n)^2 over odd m, n.
Complex squeezeFilm(const Case& c, Complex s)
{
    const double h = c.initial.nominalTrailingEdgeHeight, width = c.slider.width, beta = width / c.slider.length,
                 pressure = c.air.given.pressure, pi = std::numbers::pi;
    const Complex x = 12.0 * c.air.given.viscosity * s * width * width / (pressure * h * h);
    Complex sum = 0.0;
    for (int m = 1; m < 200; m += 2)
        for (int n = 1; n < 200; n += 2)
            sum += x / (x + pi * pi * (m * m + n * n * beta * beta)) / (double(m) * m * double(n) * n);
    return 64.0 * pressure * c.slider.length * width / (std::pow(pi, 4) * h) * sum;
}

void TestModes::aPlateOverADiskAtRestIsASqueezeFilm()
{
    // Without a load every height is a static state. m s^2 + k + K(s) = 0, by Newton's method from the plate on its
    // suspension alone; the film's K takes the disk's shear and pitch no part in.
    Case c = test::smallSlider(81);
    c.surface = {};
    c.surface.baseRecess = 0.0;
    c.disk.speed = 0.0;
    c.suspension.preload = 0.0;
    c.suspension.stiffness = 3e3;
    c.air.slip.model = SlipModel::Continuum;
    c.initial.pitch = 0.0;
    for (const double height : {800e-9, 4e-6}) {
        c.initial.nominalTrailingEdgeHeight = height;
        const ModesResult r = modes(c);
        QCOMPARE(r.status, SteadyStatus::Converged);
        QCOMPARE(r.steady.attitude.height, height);
        QVERIFY(std::abs(r.steady.forces.net) < 1e-12);
        const auto balance = [&](Complex s) {
            return c.slider.mass * s * s + c.suspension.stiffness + c.suspension.damping * s + squeezeFilm(c, s);
        };
        const auto heave = std::ranges::find(r.modes, "vertical", &AirBearingMode::kind);
        QVERIFY(heave != r.modes.end());
        const double omega = twoPi * heave->frequency, zeta = heave->dampingRatio;
        const Complex found(-zeta * omega / std::sqrt(1.0 - zeta * zeta), omega);
        Complex s = found;
        for (int k = 0; k < 20; ++k) {
            const Complex step = 1e-4 * std::abs(s);
            s -= balance(s) * step / (balance(s + step) - balance(s));
        }
        QVERIFY2(std::abs(found - s) < 2e-3 * std::abs(s), qPrintable(QString("%1 + %2 i against %3 + %4 i")
                                                                          .arg(found.real())
                                                                          .arg(found.imag())
                                                                          .arg(s.real())
                                                                          .arg(s.imag())));
    }
}

TOUCHDOWN_TEST(TestModes)

} // namespace test_modes

#include "test_modes.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>

#include <numbers>

#include <Eigen/Dense>

#include "core/physics/film/film_grid.h"
#include "core/physics/film/film_loads.h"
#include "core/physics/film/film_newton.h"
#include "core/physics/film/film_oscillation.h"
#include "core/physics/film/gas_film.h"
#include "core/physics/film/slip_model.h"
#include "core/physics/slider/recess.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_film_oscillation {

class TestFilmOscillation : public QObject {
    Q_OBJECT

private slots:
    void squeezedPlatesAgreeWithBlech_data();
    void squeezedPlatesAgreeWithBlech();
    void wavesThatTheDiskDragsAlong_data();
    void wavesThatTheDiskDragsAlong();
    void shortWavesDoNotGrow_data();
    void shortWavesDoNotGrow();
    void slowMotionIsTheStaticStiffness();
};

constexpr double length = 1.0e-3, width = 0.5e-3, gap = 2e-6;

/// Plates over a disk, continuum air.
struct Plates {
    explicit Plates(int cells, double speed = 0.0, double pitch = 0.0, double height = gap)
        : recess(surface(), length, width),
          film(std::make_shared<const FilmGaps>(recess, uniformGrid(length, width, cells, cells)),
               {.air = {},
                .slip = {.model = SlipModel::Continuum},
                .disk = {.speed = speed / 25e-3, .radius = 25e-3, .field = VelocityField::Uniform}}),
          loads(film),
          pressure(film.pad().size(), film.ambient()),
          residual(pressure.size())
    {
        film.setAttitude({height, pitch, 0.0});
        film.linearise(pressure, residual);
        FilmLoads::Derivatives forces;
        loads.derivatives(pressure, forces);
        take(forces);
    }
    void take(const FilmLoads::Derivatives& forces)
    {
        for (std::size_t k = 0; k < 3; ++k) {
            byPressure[k] = forces.byPressure[k];
            for (std::size_t m = 0; m < 3; ++m) byAttitude(k, m) = forces.byAttitude[k][m];
        }
    }
    std::complex<double> heave(std::complex<double> s)
    {
        bool converged = true;
        const auto z = FilmOscillation(film, pressure).stiffness(s, byPressure, byAttitude, converged);
        return converged ? z(0, 0) : std::complex<double>(std::nan(""), 0.0);
    }
    static AirBearingSurface surface()
    {
        AirBearingSurface plane;
        plane.baseRecess = 0.0;
        return plane;
    }
    Recess recess;
    GasFilm film;
    FilmLoads loads;
    std::vector<double> pressure, residual;
    std::array<std::vector<double>, 3> byPressure;
    Matrix3 byAttitude = Matrix3::Zero();
};

/// Blech 1983, "On isothermal squeeze films", rectangular plates: spring and damping force per height, with the squeeze
/// number sigma = 12 mu omega W^2/(p0 h^2) and the side ratio beta = W/L.
std::complex<double> blech(double omega)
{
    const Air air;
    const double sigma = 12.0 * air.viscosity * omega * width * width / (air.pressure * gap * gap);
    const double beta = width / length, pi = std::numbers::pi, pi2 = pi * pi;
    double spring = 0.0, damping = 0.0;
    for (int m = 1; m < 400; m += 2)
        for (int n = 1; n < 400; n += 2) {
            const double side = m * m + n * n * beta * beta, product = double(m) * m * double(n) * n;
            const double denominator = product * (side * side + sigma * sigma / (pi2 * pi2));
            spring += 1.0 / denominator;
            damping += side / denominator;
        }
    const double scale = 64.0 * air.pressure * length * width / gap;
    return {scale * sigma * sigma / (pi2 * pi2 * pi2 * pi2) * spring, scale * sigma / (pi2 * pi2 * pi2) * damping};
}

void TestFilmOscillation::squeezedPlatesAgreeWithBlech_data()
{
    QTest::addColumn<double>("frequency"); // [Hz]
    // Squeeze numbers 0.08, 4.2 and 84: nearly incompressible, between, nearly trapped.
    QTest::newRow("slow: the air is pressed out") << 100.0;
    QTest::newRow("between") << 5e3;
    QTest::newRow("fast: the air is trapped") << 1e5;
}

void TestFilmOscillation::squeezedPlatesAgreeWithBlech()
{
    QFETCH(double, frequency);
    const double omega = 2.0 * std::numbers::pi * frequency;
    const std::complex<double> exact = blech(omega);
    const std::complex<double> coarse = Plates(80).heave({0.0, omega}), fine = Plates(160).heave({0.0, omega});
    const double errorCoarse = std::abs(coarse - exact), errorFine = std::abs(fine - exact);
    QVERIFY2(errorFine < 1e-3 * std::abs(exact), qPrintable(QString("%1 + %2 i against %3 + %4 i")
                                                                .arg(fine.real())
                                                                .arg(fine.imag())
                                                                .arg(exact.real())
                                                                .arg(exact.imag())));
    // Second order: halving the cells leaves a quarter, once they resolve the layer at the edges.
    const double order = std::log2(errorCoarse / errorFine);
    QVERIFY2(std::abs(order - 2.0) < (frequency > 5e4 ? 0.3 : 0.15), qPrintable(QString::number(order)));
}

/// Parallel plates of this gap over a moving disk, of small motion: a (p_xx + p_yy) - b p_x = s (h p + p0), a = p0
/// h^3/(12 mu), b = U h/2, p = 0 on the outline. With p = sum of P_n(x) sin(n pi y/W) each P_n is the sum of a constant
/// and two exponential functions.
std::complex<double> movingPlates(double height, double speed, std::complex<double> s)
{
    const Air air;
    const double a = air.pressure * height * height * height / (12.0 * air.viscosity), b = 0.5 * speed * height;
    std::complex<double> force = 0.0; // per height, upwards
    for (int n = 1; n < 4000; n += 2) {
        const double k = n * std::numbers::pi / width;
        const std::complex<double> q = a * k * k + s * height, root = std::sqrt(b * b + 4.0 * a * q);
        const std::complex<double> up = (b + root) / (2.0 * a), down = (b - root) / (2.0 * a);
        // 1 - A exp(up (x - L)) - B exp(down x)
        const std::complex<double> first = std::exp(-up * length), last = std::exp(down * length);
        const std::complex<double> B = (1.0 - first) / (1.0 - first * last), A = 1.0 - B * last;
        const std::complex<double> sum = length - A * (1.0 - first) / up - B * (last - 1.0) / down;
        force -= 8.0 * width / (n * std::numbers::pi * n * std::numbers::pi) * s * air.pressure / q * sum;
    }
    return -force;
}

void TestFilmOscillation::wavesThatTheDiskDragsAlong_data()
{
    QTest::addColumn<double>("waves"); // that the slider carries
    QTest::newRow("one") << 1.0;
    QTest::newRow("four") << 4.0;
}

/// Pressure waves of the length U/(2 f) under a slider that oscillates: 40 cells each and more give spring and damping
/// to half a per cent, with second order.
void TestFilmOscillation::wavesThatTheDiskDragsAlong()
{
    QFETCH(double, waves);
    constexpr double height = 0.4e-6, speed = 30.0;
    const std::complex<double> s(0.0, std::numbers::pi * waves * speed / length);
    const std::complex<double> exact = movingPlates(height, speed, s);
    const auto error = [&](int cells) {
        const std::complex<double> difference = Plates(cells, speed, 0.0, height).heave(s) - exact;
        return std::array{std::abs(difference.real() / exact.real()), std::abs(difference.imag() / exact.imag())};
    };
    const auto coarse = error(120), fine = error(240);
    for (std::size_t part = 0; part < 2; ++part) {
        const double order = std::log2(coarse[part] / fine[part]);
        const QString both = QString("%1: %2, order %3").arg(part).arg(fine[part]).arg(order);
        QVERIFY2(fine[part] < 5e-3, qPrintable(both));
        QVERIFY2(std::abs(order - 2.0) < 0.3, qPrintable(both));
    }
}

void TestFilmOscillation::shortWavesDoNotGrow_data()
{
    QTest::addColumn<double>("skew");
    QTest::addColumn<double>("cells"); // of a wave
    for (const double skew : {-0.8, -0.1, 0.0, 0.1, 0.4, 1.5})
        for (const double cells : {3.0, 4.0, 8.0}) QTest::addRow("%g rad, %g cells", skew, cells) << skew << cells;
}

/// A thin film that a disk carries along obliquely, one cell of which takes in air by turns: the answer is the largest
/// in that cell, however few cells a wave has. It grew sixtyfold along the crosswise waves of four cells where the
/// flows along each axis passed on the storage for themselves alone.
void TestFilmOscillation::shortWavesDoNotGrow()
{
    QFETCH(double, skew);
    QFETCH(double, cells);
    using Complex = std::complex<double>;
    constexpr int n = 24;
    constexpr double speed = 20.0, side = 0.8e-3;
    AirBearingSurface surface;
    surface.baseRecess = 0.0;
    const Recess recess(surface, side, side);
    FilmSetting setting;
    setting.disk = {.speed = speed / 25e-3, .radius = 25e-3, .skew = skew, .field = VelocityField::Uniform};
    GasFilm film(std::make_shared<const FilmGaps>(recess, uniformGrid(side, side, n, n)), setting);
    const PaddedGrid& pad = film.pad();
    film.setAttitude({20e-9, 0.0, 0.0});
    const std::vector<double> pressure(pad.size(), film.ambient());
    std::vector<double> residual(pad.size());
    film.linearise(pressure, residual);

    const Complex s(0.0, std::numbers::pi * speed / (cells * side / n));
    std::vector<Complex> v(pad.size()), image(pad.size());
    FaceFlows<Complex> work;
    work.resize(pad.size());
    Eigen::MatrixXcd matrix(n * n, n * n);
    for (int c = 0; c < n * n; ++c) {
        const std::size_t at = pad.at(c % n, c / n);
        v[at] = 1.0;
        film.applyJacobian<Complex>(v, image, work, s);
        v[at] = 0.0;
        for (int row = 0; row < n * n; ++row) matrix(row, c) = image[pad.at(row % n, row / n)];
    }
    const Eigen::PartialPivLU<Eigen::MatrixXcd> factors(matrix);
    for (const int cell : {3 * n + 3, (n - 4) * n + 3, n / 2 * n + n / 2}) {
        const Eigen::VectorXcd answer = factors.solve(Eigen::VectorXcd::Unit(n * n, cell));
        QCOMPARE(answer.cwiseAbs().maxCoeff(), std::abs(answer[cell]));
    }
}

void TestFilmOscillation::slowMotionIsTheStaticStiffness()
{
    // A running wedge, pressed so slowly that storage does not count: the change of its static load with the height.
    Plates plates(48, 15.0, 1e-3);
    FilmNewton newton(plates.film);
    QVERIFY(newton.solve(plates.pressure, {.tolerance = 1e-12}).converged);
    plates.film.linearise(plates.pressure, plates.residual);
    FilmLoads::Derivatives forces;
    plates.loads.derivatives(plates.pressure, forces);
    plates.take(forces);
    const std::complex<double> slow = plates.heave({0.0, 1e-3});
    constexpr double step = 1e-10; // [m]
    std::array<double, 2> load{};
    for (std::size_t side = 0; side < 2; ++side) {
        std::vector<double> p = plates.pressure;
        plates.film.setAttitude({gap + (side == 0 ? -step : step), 1e-3, 0.0});
        QVERIFY(newton.solve(p, {.tolerance = 1e-13}).residual < 1e-11);
        load[side] = plates.loads.load(p)[0];
    }
    const double expected = -(load[1] - load[0]) / (2.0 * step);
    QVERIFY2(std::abs(slow.real() - expected) < 1e-5 * expected,
             qPrintable(QString("%1 %2").arg(slow.real()).arg(expected)));
}

TOUCHDOWN_TEST(TestFilmOscillation)

} // namespace test_film_oscillation

#include "test_film_oscillation.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a film computes has the same bits on any number of threads.
#include <cmath>
#include <complex>
#include <cstring>
#include <vector>

#include <QTest>

#include "core/physics/film/film_energy.h"
#include "core/physics/film/film_oscillation.h"
#include "core/physics/film/film_step.h"
#include "core/work/team.h"
#include "core/work/team_trials.h"
#include "tests/support/allocation_count.h"
#include "tests/support/film_problem.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;
using Complex = std::complex<double>;

namespace test_film_threads {

constexpr double L = 0.8e-3, W = 0.6e-3;
constexpr Attitude rest{60e-9, 100e-6, 3e-6};

/// All that was computed, with the place of the first number that differs.
struct Found {
    std::vector<double> numbers;
    std::vector<std::pair<std::size_t, const char*>> names;

    void add(const char* name, const void* from, std::size_t count)
    {
        names.emplace_back(numbers.size(), name);
        numbers.resize(numbers.size() + count);
        std::memcpy(numbers.data() + names.back().first, from, count * sizeof(double));
    }
    void add(const char* name, const std::vector<double>& v) { add(name, v.data(), v.size()); }
    void add(const char* name, const std::vector<Complex>& v) { add(name, v.data(), 2 * v.size()); }

    QString differenceFrom(const Found& other) const
    {
        if (numbers.size() != other.numbers.size()) return QStringLiteral("other numbers");
        for (std::size_t k = 0; k < numbers.size(); ++k)
            if (std::memcmp(&numbers[k], &other.numbers[k], sizeof(double)) != 0) {
                std::size_t name = names.size() - 1;
                while (names[name].first > k) --name;
                return QString::asprintf("%s at %zu: %.17g, not %.17g", names[name].second, k - names[name].first,
                                         numbers[k], other.numbers[k]);
            }
        return {};
    }
};

FilmSetting moving(ConvectionScheme scheme)
{
    FilmSetting setting;
    setting.disk = uniformMotion(20.0, 0.15);
    setting.scheme = scheme;
    return setting;
}

template <typename T>
std::vector<T> someVector(const PaddedGrid& pad)
{
    std::vector<T> v(pad.size(), T{});
    for (int j = 0; j < pad.ny; ++j)
        for (int i = 0; i < pad.nx; ++i) {
            T& value = v[pad.at(i, j)];
            value = std::sin(1.0 + 0.37 * i) * std::cos(0.21 * j) * 1e3;
            if constexpr (!std::is_same_v<T, double>) value += Complex(0.0, 700.0 * std::sin(0.11 * i - 0.53 * j));
        }
    return v;
}

/// Everything about a steady film, and some steps of time.
Found film(int nx, int ny, ConvectionScheme scheme, bool rough, int threads)
{
    const TeamScope team(threads);
    Found found;
    FilmProblem film(steppedSurface(), L, W, uniformGrid(L, W, nx, ny), moving(scheme), rest);
    GasFilm& gas = film.film;
    const PaddedGrid& pad = gas.pad();
    std::vector<double> surface(pad.size(), 0.0);
    const auto setSurface = [&](double t) {
        for (int j = 0; j < pad.ny; ++j)
            for (int i = 0; i < pad.nx; ++i)
                surface[pad.at(i, j)] = 3e-9 * std::sin(0.7 * i - 2e6 * t) * std::cos(0.5 * j);
        if (rough) gas.setSurface(surface);
    };
    setSurface(0.0);
    gas.setAttitude(rest);
    const FilmSolution solution = film.solve({.tolerance = 1e-9});
    found.add("pressure", film.p);
    std::vector<double> out(pad.size(), 0.0);
    gas.residual(film.p, out);
    found.add("residual", out);
    const double massFlow = gas.massFlow();
    found.add("mass flow", &massFlow, 1);
    gas.linearise(film.p, out);
    found.add("residual of the linearisation", out);

    FaceFlows<double> work;
    work.resize(pad.size());
    gas.applyJacobian<double>(someVector<double>(pad), out, work);
    found.add("Jacobian", out);
    FaceFlows<Complex> complexWork;
    complexWork.resize(pad.size());
    std::vector<Complex> complexOut(pad.size());
    gas.applyJacobian<Complex>(someVector<Complex>(pad), complexOut, complexWork, Complex(1e4, 4e5));
    found.add("complex Jacobian", complexOut);
    FilmLinearSolver linear(gas);
    linear.prepare();
    linear.apply(someVector<double>(pad), out);
    found.add("stencil", out);
    linear.cycle(someVector<double>(pad), out);
    found.add("cycle", out);

    const auto loads = film.loads.loadAndShear(film.p);
    found.add("loads", loads.data(), loads.size());
    FilmLoads::Derivatives slopes;
    film.loads.derivatives(film.p, slopes);
    for (const auto& byPressure : slopes.byPressure) found.add("loads by pressure", byPressure);
    std::array<std::vector<double>, 3> columns;
    gas.attitudeColumns(film.p, columns, film.attitudeWork);
    for (const auto& column : columns) found.add("attitude's column", column);

    FilmOscillation oscillation(gas, film.p);
    bool converged = true;
    const std::array<std::vector<double>, 3> forces{slopes.byPressure[0], slopes.byPressure[1], slopes.byPressure[2]};
    const ComplexMatrix3 stiffness = oscillation.stiffness({1e4, 4e5}, forces, Matrix3::Zero(), converged);
    found.add("oscillation", stiffness.data(), 18);

    FilmStepper stepper(gas, {});
    stepper.start(film.p);
    FilmEnergy energy(gas);
    for (int k = 1; k <= 8; ++k) {
        const double t = 1e-6 * k;
        setSurface(t);
        Attitude moved = rest;
        moved.height *= 1.0 + 0.2 * std::pow(std::sin(1e5 * t), 2);
        stepper.step(1e-6, moved);
        if (!stepper.accept()) qFatal("a step did not converge");
        const FilmEnergyState state = energy.at(stepper.pressure());
        found.add("energy", &state.stored, 1);
        found.add("dissipation", &state.dissipation, 1);
    }
    found.add("pressure in time", stepper.pressure().data(), pad.size());
    const std::array<double, 3> error = stepper.timeErrorLoad();
    found.add("load of the time error", error.data(), 3);
    if (!solution.converged || !converged) qFatal("not solved");
    return found;
}

class TestFilmThreads : public QObject {
    Q_OBJECT

private slots:
    /// Every loop is shared, however busy the cores are.
    void initTestCase() { setTeamTrials(false); }
    void cleanupTestCase() { setTeamTrials(true); }

    /// Long in y: rows are shared by seven threads; long in x: columns are.
    void sameBits_data()
    {
        QTest::addColumn<int>("nx");
        QTest::addColumn<int>("ny");
        QTest::addColumn<int>("scheme");
        QTest::addColumn<bool>("rough");
        using enum ConvectionScheme;
        QTest::newRow("long in y") << 34 << 250 << int(CompleteFlux) << false;
        QTest::newRow("long in x") << 251 << 57 << int(CompleteFlux) << false;
        QTest::newRow("rough disk") << 97 << 101 << int(CompleteFlux) << true;
        QTest::newRow("power law") << 64 << 128 << int(PowerLaw) << false;
    }
    void sameBits()
    {
        QFETCH(int, nx);
        QFETCH(int, ny);
        QFETCH(int, scheme);
        QFETCH(bool, rough);
        const Found alone = film(nx, ny, ConvectionScheme(scheme), rough, 1);
        for (const int threads : {2, 3, 4, 7})
            QCOMPARE(film(nx, ny, ConvectionScheme(scheme), rough, threads).differenceFrom(alone), QString());
    }

    /// A film made by one thread works within a larger team, on one thread where it has work space for one.
    void filmOfASmallerTeam()
    {
        FilmProblem film(steppedSurface(), L, W, uniformGrid(L, W, 64, 128), moving(ConvectionScheme::CompleteFlux),
                         rest);
        film.solve();
        const std::vector<double> alone = film.p;
        std::ranges::fill(film.p, film.film.ambient());
        const TeamScope team(4);
        film.solve();
        QCOMPARE(film.p == alone, true);
    }

    /// Each thread's work space is there before the first step.
    void noAllocationInSteps()
    {
        const TeamScope team(3);
        FilmProblem film(steppedSurface(), L, W, uniformGrid(L, W, 64, 128), moving(ConvectionScheme::CompleteFlux),
                         rest);
        film.solve();
        FilmStepper stepper(film.film, {});
        stepper.start(film.p);
        const auto step = [&](int k) {
            Attitude moved = rest;
            moved.height *= 1.0 + 0.2 * std::pow(std::sin(0.1 * k), 2);
            stepper.step(1e-6, moved);
            film.loads.loadAndShear(stepper.pressure());
            return stepper.accept();
        };
        for (int k = 1; k <= 4; ++k) QVERIFY(step(k));
        const long long before = allocations;
        for (int k = 5; k <= 20; ++k) QVERIFY(step(k));
        QCOMPARE(allocations.load(), before);
    }
};

TOUCHDOWN_TEST(TestFilmThreads)

} // namespace test_film_threads

#include "test_film_threads.moc"

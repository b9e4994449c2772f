// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/film_line_multigrid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QTest>

#include "core/physics/film/film_grid.h"
#include "core/physics/slider/recess.h"
#include "tests/support/allocation_count.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_film_line_multigrid {

constexpr double length = 1.25e-3, width = 1.0e-3; // [m]

struct Slider {
    AirBearingSurface surface;
    Attitude attitude;
    FilmSetting setting;

    Recess recess() const { return {surface, length, width}; }
    CellGrid grid(int n) const { return gradedGrid(surface, length, width, n, n); }
};

Slider planeSlider()
{
    Slider slider;
    slider.attitude = {100e-9, 200e-6, 0.0};
    slider.surface.baseRecess = 0.0;
    slider.setting.air = {101325.0, 1.806e-5, 63.5e-9};
    slider.setting.disk = {.speed = 15.0 / 23e-3, .radius = 23e-3, .skew = 0.0, .field = VelocityField::Uniform};
    return slider;
}

Rail box(double x0, double x1, double y0, double y1, double recess, int wall)
{
    return {.kind = RailKind::Step,
            .points = {{x0, y0, wall}, {x1, y0, wall}, {x1, y1, wall}, {x0, y1, wall}},
            .recess = {recess}};
}

/// Two side rails on a shallow step, a trailing pad whose edges are walls, a slanted edge; skewed and rolled.
Slider railSlider()
{
    Slider slider;
    slider.attitude = {12e-9, 150e-6, 4e-6};
    AirBearingSurface& s = slider.surface;
    s.baseRecess = 1.5e-6;
    s.walls = {{.distance = {-2e-6, 0.0, 6e-6}, .recess = {0.0, 0.1e-6, 1.5e-6}}};
    s.rails = {box(0.05e-3, 0.80e-3, 0.05e-3, 0.30e-3, 0.2e-6, 0),
               box(0.05e-3, 0.80e-3, 0.70e-3, 0.95e-3, 0.2e-6, 0),
               box(0.25e-3, 0.70e-3, 0.07e-3, 0.22e-3, 0.0, 1),
               box(0.25e-3, 0.70e-3, 0.78e-3, 0.93e-3, 0.0, 1),
               {.kind = RailKind::Step,
                .points = {{0.95e-3, 0.40e-3, 1}, {1.20e-3, 0.44e-3, 1}, {1.20e-3, 0.56e-3, 1}, {0.95e-3, 0.60e-3, 1}},
                .recess = {0.0}}};
    s.crown = 10e-9;
    slider.setting.air = {101325.0, 1.806e-5, 63.5e-9};
    slider.setting.disk = {.speed = 5400.0 * 2.0 * std::numbers::pi / 60.0, .radius = 23e-3, .skew = 0.2};
    return slider;
}

FilmLineMultigrid multigridOf(const Slider& slider, int n)
{
    FilmLineMultigrid multigrid(slider.recess(), slider.grid(n), slider.setting);
    multigrid.setAttitude(slider.attitude);
    return multigrid;
}

std::vector<double> ambient(GasFilm& film) { return std::vector<double>(film.pad().size(), film.ambient()); }

double residualAt(GasFilm& film, const std::vector<double>& p)
{
    std::vector<double> residual(p.size());
    film.residual(p, residual);
    return residualNorm(film, residual);
}

bool soundPressures(const std::vector<double>& p)
{
    return std::all_of(p.begin(), p.end(), [](double value) { return std::isfinite(value) && value > 0.0; });
}

void eachSlider()
{
    QTest::addColumn<bool>("rails");
    QTest::addColumn<ConvectionScheme>("scheme");
    for (const bool rails : {false, true}) {
        const char* name = rails ? "rails" : "plane";
        QTest::addRow("%s, upwind", name) << rails << ConvectionScheme::Upwind;
        QTest::addRow("%s, hybrid", name) << rails << ConvectionScheme::Hybrid;
        QTest::addRow("%s, power law", name) << rails << ConvectionScheme::PowerLaw;
        QTest::addRow("%s, exponential", name) << rails << ConvectionScheme::Exponential;
        QTest::addRow("%s, complete flux", name) << rails << ConvectionScheme::CompleteFlux;
    }
}

class TestFilmLineMultigrid : public QObject {
    Q_OBJECT

private slots:
    /// One discrete equation has one solution: both methods must find it. Residuals of 1e-10 leave differences of the
    /// same order, but for cells behind narrow gaps, which a small flow fills: 1e-7 has room for them.
    void findsNewtonsSolution_data() { eachSlider(); }
    void findsNewtonsSolution()
    {
        QFETCH(bool, rails);
        QFETCH(ConvectionScheme, scheme);
        Slider slider = rails ? railSlider() : planeSlider();
        slider.setting.scheme = scheme;
        const FilmOptions options{.tolerance = 1e-10, .maximumIterations = 40};

        FilmLineMultigrid multigrid = multigridOf(slider, 50);
        GasFilm& film = multigrid.film();
        std::vector<double> p = ambient(film), newtons = p;
        const FilmSolution solution = multigrid.solve(p, options);
        QVERIFY2(solution.converged, qPrintable(QString::number(solution.residual)));
        QVERIFY(residualAt(film, p) <= 1e-10);
        QVERIFY(FilmNewton(film).solve(newtons, options).converged);
        double worst = 0.0;
        for (std::size_t at = 0; at < p.size(); ++at) worst = std::max(worst, std::abs(p[at] / newtons[at] - 1.0));
        QVERIFY2(worst < 1e-7, qPrintable(QString::number(worst)));
    }

    /// Work in proportion to the cells: as many cycles on 192 x 192 cells as on 24 x 24, within two; with rails, whose
    /// slanted channels coarse levels see only in part, at most 13. An odd number of cells has a coarse cell of one
    /// fine one at its end.
    void cyclesDoNotGrow_data() { eachSlider(); }
    void cyclesDoNotGrow()
    {
        QFETCH(bool, rails);
        QFETCH(ConvectionScheme, scheme);
        Slider slider = rails ? railSlider() : planeSlider();
        slider.setting.scheme = scheme;
        std::vector<int> cycles;
        for (const int n : {24, 48, 97, 192}) {
            FilmLineMultigrid multigrid = multigridOf(slider, n);
            std::vector<double> p = ambient(multigrid.film());
            const FilmSolution solution = multigrid.solve(p, {.tolerance = 1e-6, .maximumIterations = 40});
            QVERIFY2(solution.converged, qPrintable(QString("%1: %2").arg(n).arg(solution.residual)));
            cycles.push_back(solution.iterations);
        }
        QVERIFY2(rails || cycles.back() <= cycles.front() + 2,
                 qPrintable(QString("%1, then %2").arg(cycles[0]).arg(cycles[3])));
        QVERIFY2(*std::max_element(cycles.begin(), cycles.end()) <= (rails ? 13 : 10),
                 qPrintable(QString::number(cycles[3])));
    }

    /// A long slider with few cells across, and one whose disk runs backwards.
    void unusualFilms_data()
    {
        QTest::addColumn<int>("nx");
        QTest::addColumn<int>("ny");
        QTest::addColumn<double>("speed"); // [rad/s]
        QTest::newRow("160 x 10 cells") << 160 << 10 << 600.0;
        QTest::newRow("10 x 160 cells") << 10 << 160 << 600.0;
        QTest::newRow("3 x 3 cells") << 3 << 3 << 600.0;
        QTest::newRow("1 x 1 cell") << 1 << 1 << 600.0;
        QTest::newRow("backwards") << 40 << 40 << -600.0;
        QTest::newRow("a hundredth of the speed") << 40 << 40 << 6.0;
        QTest::newRow("a hundred times the speed") << 40 << 40 << 6e4;
    }
    void unusualFilms()
    {
        QFETCH(int, nx);
        QFETCH(int, ny);
        QFETCH(double, speed);
        Slider slider = railSlider();
        slider.setting.disk.speed = speed;
        FilmLineMultigrid multigrid(slider.recess(), uniformGrid(length, width, nx, ny), slider.setting);
        multigrid.setAttitude(slider.attitude);
        std::vector<double> p = ambient(multigrid.film());
        const FilmSolution solution = multigrid.solve(p, {.tolerance = 1e-8, .maximumIterations = 60});
        QVERIFY2(solution.converged, qPrintable(QString::number(solution.residual)));
        QVERIFY(soundPressures(p));
    }

    /// A film that has risen by a thousandth of its gap needs no coarse start: every cycle is one on the finest grid.
    void keepsGoodGuesses()
    {
        Slider slider = railSlider();
        FilmLineMultigrid multigrid = multigridOf(slider, 48);
        std::vector<double> p = ambient(multigrid.film());
        const FilmOptions options{.tolerance = 1e-7, .maximumIterations = 40};
        const FilmSolution first = multigrid.solve(p, options);
        QVERIFY(first.converged && first.solves > first.iterations);
        slider.attitude.height *= 1.001;
        multigrid.setAttitude(slider.attitude);
        const FilmSolution second = multigrid.solve(p, options);
        QVERIFY(second.converged && second.iterations > 0 && second.iterations < first.iterations);
        QCOMPARE(second.solves, second.iterations);
        const FilmSolution third = multigrid.solve(p, options);
        QVERIFY(third.converged);
        QCOMPARE(third.solves, 0);
    }

    void reports()
    {
        FilmLineMultigrid multigrid = multigridOf(railSlider(), 48);
        std::vector<double> p = ambient(multigrid.film());
        std::vector<int> numbers;
        std::vector<double> residuals;
        const FilmSolution solution = multigrid.solve(p, {.tolerance = 1e-7}, [&](int number, double residual) {
            numbers.push_back(number);
            residuals.push_back(residual);
            return true;
        });
        QCOMPARE(int(numbers.size()), solution.iterations + 1);
        QCOMPARE(numbers.back(), solution.iterations);
        QCOMPARE(residuals.back(), solution.residual);
        QVERIFY(residuals.front() > 1e-3 && residuals.back() <= 1e-7);
    }

    void stopsWhenTold()
    {
        FilmLineMultigrid multigrid = multigridOf(planeSlider(), 48);
        std::vector<double> p = ambient(multigrid.film());
        const double atFirst = residualAt(multigrid.film(), p);
        const FilmSolution solution =
            multigrid.solve(p, {.tolerance = 1e-12}, [](int number, double) { return number < 2; });
        QVERIFY(solution.cancelled && !solution.converged);
        QCOMPARE(solution.iterations, 2);
        QVERIFY(solution.residual < atFirst);
        QCOMPARE(residualAt(multigrid.film(), p), solution.residual);
    }

    void saysWhenItDoesNotConverge()
    {
        FilmLineMultigrid multigrid = multigridOf(railSlider(), 48);
        std::vector<double> p = ambient(multigrid.film());
        const FilmSolution solution = multigrid.solve(p, {.tolerance = 1e-12, .maximumIterations = 3});
        QVERIFY(!solution.converged && !solution.cancelled);
        QCOMPARE(solution.iterations, 3);
        QVERIFY(solution.residual > 1e-12);
        QCOMPARE(residualAt(multigrid.film(), p), solution.residual);
    }

    /// The whole trailing edge closed: the disk drags air into a wedge without an exit. Whatever comes of it, pressures
    /// are sound, no worse than at first, and the status tells the truth.
    void closedWedge_data()
    {
        QTest::addColumn<ConvectionScheme>("scheme");
        QTest::newRow("exponential") << ConvectionScheme::Exponential;
        QTest::newRow("complete flux") << ConvectionScheme::CompleteFlux;
    }
    void closedWedge()
    {
        QFETCH(ConvectionScheme, scheme);
        Slider slider = planeSlider();
        slider.setting.scheme = scheme;
        slider.attitude.height = -5e-9;
        FilmLineMultigrid multigrid = multigridOf(slider, 48);
        std::vector<double> p = ambient(multigrid.film());
        const double atFirst = residualAt(multigrid.film(), p);
        const FilmSolution solution = multigrid.solve(p, {.tolerance = 1e-7, .maximumIterations = 30});
        QVERIFY(soundPressures(p));
        QCOMPARE(residualAt(multigrid.film(), p), solution.residual);
        QCOMPARE(solution.converged, solution.residual <= 1e-7);
        QVERIFY(solution.residual <= 4.0 * atFirst);
    }

    void cyclesAllocateNothing()
    {
        FilmLineMultigrid multigrid = multigridOf(railSlider(), 24);
        std::vector<double> p = ambient(multigrid.film());
        const FilmOptions options{.tolerance = 1e-9, .maximumIterations = 40};
        const auto before = touchdown::test::allocations.load();
        const FilmSolution solution = multigrid.solve(p, options);
        const auto after = touchdown::test::allocations.load();
        QVERIFY(solution.converged && solution.iterations > 3);
        QCOMPARE(after - before, 0LL);
    }
};

TOUCHDOWN_TEST(TestFilmLineMultigrid)

} // namespace test_film_line_multigrid

#include "test_film_line_multigrid.moc"

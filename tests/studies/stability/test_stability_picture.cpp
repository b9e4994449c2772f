// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/stability/stability_picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QTest>

#include "core/case/integrator_kind.h"
#include "core/case_files/case_file.h"
#include "core/numerics/stability_region.h"
#include "core/studies/stability/stability_curves.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_stability_picture {

using Complex = std::complex<double>;

const StudyTable& tableOf(const StudyReport& picture, const std::string& name)
{
    return *std::ranges::find(picture.tables, name, &StudyTable::name);
}

/// The largest stable step of a method at a place; NaN where it has no limit.
double limitOf(const StudyReport& picture, const std::string& method, const std::string& where)
{
    for (const auto& row : tableOf(picture, "step_limits").rows)
        if (std::get<std::string>(row[0]) == method && std::get<std::string>(row[1]) == where)
            return std::holds_alternative<double>(row[2]) ? std::get<double>(row[2]) : std::nan("");
    qFatal("no such row");
    return 0.0;
}

StudyReport pictureOf(const Case& c)
{
    StudyReport picture;
    if (!makeLinearPicture(c, picture, [] { return true; })) qFatal("it was not stopped");
    return picture;
}

class TestStabilityPicture : public QObject {
    Q_OBJECT

private slots:
    /// Of rk4 on the imaginary axis sqrt 8/omega; what grows of itself has no limit and sets none.
    void largestStep()
    {
        const LocalMotion undamped{"", {{0.0, 2e6}, {0.0, 1e6}}}, growing{"", {{1e4, 2e6}}},
            both{"", {{1e4, 2e6}, {0.0, 1e6}}};
        QVERIFY(std::abs(largestStableStep(rk4Growth, undamped) * 2e6 - std::sqrt(8.0)) < 1e-8);
        QVERIFY(std::isinf(largestStableStep(rk4Growth, growing)));
        QVERIFY(std::abs(largestStableStep(rk4Growth, both) * 1e6 - std::sqrt(8.0)) < 1e-8);
        QVERIFY(std::isinf(largestStableStep([](Complex z) { return newmarkGrowth(0.25, 0.5, z); }, undamped)));
    }
    /// The textbook oscillator: one mass on one linear spring, so that the eigenvalues are its formula's and rk4's
    /// limit sqrt 8/omega, to the order of the damping.
    void textbookOscillator()
    {
        const Case c = openCase("textbook_oscillator").value;
        const StudyReport picture = pictureOf(c);
        const double omega = std::sqrt(c.suspension.stiffness / c.slider.mass),
                     turning = std::sqrt(c.suspension.pitchStiffness / c.slider.pitchInertia);
        std::vector<double> found;
        for (const auto& row : tableOf(picture, "eigenvalues").rows)
            if (std::get<std::string>(row[0]) == "in the static state")
                found.push_back(std::hypot(std::get<double>(row[1]), std::get<double>(row[2])));
        QCOMPARE(found.size(), std::size_t{2});
        QVERIFY(std::abs(found[0] / std::min(omega, turning) - 1.0) < 1e-9 &&
                std::abs(found[1] / std::max(omega, turning) - 1.0) < 1e-9);
        QVERIFY(std::isnan(limitOf(picture, "newmark", "in the static state")));
    }
    /// A surface that is equally high under all places: only the spacings above it count, so that the picture is that
    /// of a slider as much lower above a flat disk, but for the static state.
    void spacingsAboveTheDisk()
    {
        Case flat, raised;
        flat.run.duration = 50e-6;
        flat.suspension.stiffness = 0.0; // which alone knows the mean plane
        raised = flat;
        raised.diskSurface.kind = DiskSurfaceKind::Waves;
        raised.diskSurface.motion = SurfaceMotion::Still;
        raised.diskSurface.waveAmplitudes = {2e-9};
        raised.diskSurface.waveLengths = {1e-3};
        raised.diskSurface.waveAngles = {0.5 * std::numbers::pi}; // across
        raised.diskSurface.wavePhases = {-0.5 * std::numbers::pi};
        raised.initial.flyingHeight += 2e-9;
        const StudyReport below = pictureOf(flat), above = pictureOf(raised);
        for (const char* where : {"closest to the disk", "in contact"}) {
            const double a = limitOf(below, "rk4", where), b = limitOf(above, "rk4", where);
            QVERIFY2(std::abs(b / a - 1.0) < 1e-4, qPrintable(QString::number(b / a))); // of two bouncing runs
        }
    }
    /// The default drop: stiffer near the disk than at rest, stiffest in contact, where omega^2 is nearly that of k_c
    /// and the air springs. A run with a step beyond rk4's limit in contact is no longer right, one with half of it is.
    void theDefaultDrop()
    {
        Case c;
        c.run.integrator = IntegratorKind::Rk4Events;
        const StudyReport picture = pictureOf(c);
        const double rest = limitOf(picture, "rk4", "in the static state"),
                     near = limitOf(picture, "rk4", "closest to the disk"),
                     contact = limitOf(picture, "rk4", "in contact");
        QVERIFY2(rest > near && near > contact, qPrintable(QString("%1, %2, %3").arg(rest).arg(near).arg(contact)));
        QVERIFY(limitOf(picture, "dopri5", "in contact") < contact);
        QVERIFY(contact > 10.0 * c.run.step); // the paper's 10 ns are well within
        QCOMPARE(picture.charts.size(), std::size_t{2});
        const ChartPanel& regions = picture.charts[0].panels.front();
        QVERIFY(regions.equalScales);
        for (const ChartSeries& series : regions.series)
            for (const ChartPoint& point : series.points) QVERIFY(std::isfinite(point.x) && point.y >= 0.0);
        // The bounded regions whole: their lines end on the real axis, or where they begin, as that of dopri5's island
        // does.
        int islands = 0;
        for (const ChartSeries& series : regions.series) {
            if (series.name != "rk4" && series.name != "dopri5") continue;
            const ChartPoint &first = series.points.front(), &last = series.points.back();
            const bool closed = std::hypot(first.x - last.x, first.y - last.y) < 1e-6 && first.y > 0.1;
            QVERIFY2(closed || (first.y < 1e-6 && last.y < 1e-6), series.name.c_str());
            islands += closed;
        }
        QCOMPARE(islands, 1);
        QVERIFY(std::ranges::any_of(picture.findings, [](const std::string& f) {
            return f.find("this case takes steps of 10 ns") != std::string::npos;
        }));
    }
    /// The steps of an adaptive method are those that its own run takes.
    void adaptiveSteps()
    {
        const StudyReport picture = pictureOf(openCase("fig10a").value);
        const double step = std::get<double>(tableOf(picture, "step_limits").rows.front()[3]);
        QVERIFY2(step > 20e-9 && step < 2e-6, qPrintable(QString::number(step)));
    }
    /// On a coarse grid: each rule against the fastest mode, omega h = sqrt 6 for Fox and Goodwin's, about 2 for film
    /// and slider in turns, 2 zeta = s/omega for once in turns; the explicit step of the air is the shortest of all.
    void film()
    {
        Case c = openCase("film_pico").value;
        c.film.nodes = {65, 65}; // on 33^2 the fastest mode grows, which no step can change
        const StudyReport picture = pictureOf(c);
        QVERIFY2(picture.message.empty(), picture.message.c_str());
        const auto& eigenvalues = tableOf(picture, "eigenvalues").rows;
        QCOMPARE(eigenvalues.size(), std::size_t{3});
        const auto& fastest = eigenvalues.back();
        const std::string where = std::get<std::string>(fastest[0]);
        const double omega = std::hypot(std::get<double>(fastest[1]), std::get<double>(fastest[2]));
        for (const char* rule : {"Euler", "BDF2", "BDF2OPT", "fitted", "trapezoidal", "monolithic, trapezoidal"})
            QVERIFY(std::isnan(limitOf(picture, rule, where)));
        const double fox = omega * limitOf(picture, "Fox & Goodwin", where);
        QVERIFY2(std::abs(fox - std::sqrt(6.0)) < 0.02, qPrintable(QString::number(fox)));
        const double iterated = omega * limitOf(picture, "staggered, iterated", where);
        QVERIFY2(iterated > 1.9 && iterated < 2.2, qPrintable(QString::number(iterated)));
        QVERIFY(omega * limitOf(picture, "one-way", where) < 0.1);
        QVERIFY(limitOf(picture, "explicit", "air alone") < 0.1 * limitOf(picture, "Fox & Goodwin", where));
    }
    void stops()
    {
        StudyReport picture;
        QVERIFY(!makeLinearPicture(Case{}, picture, [] { return false; }));
        Case c = openCase("film_pico").value;
        c.film.nodes = {33, 33};
        QVERIFY(!makeLinearPicture(c, picture, [] { return false; }));
    }
};

TOUCHDOWN_TEST(TestStabilityPicture)

} // namespace test_stability_picture

#include "test_stability_picture.moc"

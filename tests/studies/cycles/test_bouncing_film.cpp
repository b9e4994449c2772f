// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cycles on a linear film: against runs in time, their own energies, and differences of their own.
#include "core/studies/cycles/bouncing_film.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <QtTest>

#include "core/case/contact_kind.h"
#include "core/simulation/static_state/steady.h"
#include "core/studies/cycles/bouncing_run.h"
#include "core/studies/study_plan.h"
#include "tests/support/film_flight.h"
#include "tests/support/study_cells.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;
using Eigen::VectorXd;

namespace test_bouncing_film {

/// Near the disk, under a law that creates energy: W = -0.2 fJ.
Case bouncing()
{
    Case c = fromRest("film_pico", 1e-6);
    c.film.motion = FilmMotion::Linear;
    c.film.linearLimit = 1.0;
    // So few cells leave one mode undamped.
    c.suspension.damping = 0.03;
    c.suspension.pitchDamping = c.suspension.rollDamping = 5e-9;
    static const double spacing = steady(c).minimumSpacing;
    c.contact = ContactKind::OnoYamane;
    c.onoYamane.touchDown = spacing - 0.03e-9;
    c.onoYamane.takeOff = spacing + 0.02e-9;
    c.onoYamane.contactStiffness = 5e5;
    c.onoYamane.initialContactForce = 2e-5;
    c.onoYamane.meniscusForce = 4e-6;
    c.onoYamane.friction = 0.0;
    c.initial.heightOffset = 0.1e-9;
    return c;
}

std::shared_ptr<const BouncingSlider> sliderOf(const Case& c)
{
    return filmsLike(bouncing())(c, 0, [] { return true; });
}

BouncingRun found(const Case& c) { return searchCycle(*sliderOf(c), 0.0, {.duration = 1e-3}); }

StudyReport performed(const Case& c, const std::string& text, int jobs = 2)
{
    const StudyPlan plan = parseStudy("cycles", text, "study", {}, &c);
    if (!plan.valid()) qFatal("%s", plan.problems.front().text().c_str());
    return plan.perform(jobs, {});
}

class TestBouncingFilm : public QObject {
    Q_OBJECT

private slots:
    void coordinatesOfAStateAreItsOwn()
    {
        const BouncingRun run = found(bouncing());
        QVERIFY2(run.cycle.has_value(), run.problem.c_str());
        const auto made = sliderOf(bouncing());
        const auto& slider = dynamic_cast<const BouncingFilm&>(*made);
        const VectorXd& x = run.cycle->x;
        QVERIFY((slider.coordinates(slider.state(x)) - x).norm() < 1e-14 * x.norm());
    }

    /// Drawn states on the section, one and two touch-downs later: dP/dx against differences.
    void derivativeIsThatOfTheWay()
    {
        const auto slider = sliderOf(bouncing());
        const BouncingRun run = found(bouncing());
        QVERIFY2(run.cycle.has_value(), run.problem.c_str());
        std::mt19937_64 random(5);
        std::uniform_real_distribution<double> share(-1.0, 1.0);
        std::vector<double> errors;
        std::size_t switches = 0;
        while (errors.size() < 20) {
            const ReturnRequest request{.crossings = errors.size() % 2 == 0 ? 1 : 2, .limit = 1e-3, .derivative = true};
            VectorXd x = run.cycle->x, way(x.size());
            for (double& each : x) each *= 1.0 + 0.2 * share(random);
            for (double& each : way) each = share(random);
            way *= 1e-7 * x.norm() / way.norm();
            const Return at = slider->apply(x, request);
            if (!at.returned) continue;
            switches += at.switches.size();
            const VectorXd difference = 0.5 * (slider->apply(x + way, request).x - slider->apply(x - way, request).x),
                           known = at.derivative * way;
            errors.push_back((difference - known).norm() / known.norm());
        }
        QVERIFY(switches >= 50);
        std::ranges::sort(errors);
        QVERIFY2(errors[errors.size() - 2] < 1e-4, qPrintable(QString::number(errors[errors.size() - 2])));
    }

    /// The cycle against the last tenth of a run in time, with and without friction; the energies of its parts.
    void longRunsEndOnTheCycle_data()
    {
        QTest::addColumn<double>("friction");
        QTest::addColumn<double>("meniscusForce");
        QTest::newRow("without friction") << 0.0 << 4e-6;
        QTest::newRow("no menisci") << 0.0 << 0.0;
        QTest::newRow("with friction") << 0.5 << 4e-6;
    }
    void longRunsEndOnTheCycle()
    {
        QFETCH(double, friction);
        QFETCH(double, meniscusForce);
        Case c = bouncing();
        c.onoYamane.friction = friction;
        c.onoYamane.meniscusForce = meniscusForce;
        const BouncingRun run = found(c);
        QVERIFY2(run.cycle.has_value(), run.problem.c_str());
        const LimitCycle& cycle = *run.cycle;
        QVERIFY(cycle.stable());
        QVERIFY2(cycle.residual() < 1e-7, qPrintable(QString::number(cycle.residual())));
        QVERIFY(std::abs(cycle.energies.contact / (-cycle.cycleWork * cycle.touchDowns) - 1.0) < 1e-7);
        QVERIFY(cycle.energies.suspension < 0.0);
        QCOMPARE(cycle.energies.friction != 0.0, friction > 0.0);
        QVERIFY(cycle.modelError > 0.0 && !cycle.tooFar);

        c.run.duration = 1e-3;
        c.run.sampleInterval = 50e-9;
        c.run.stepError = 1e-13;
        const Flight flight = fly(c);
        QVERIFY_STATUS(flight, RunStatus::Completed);
        const std::vector<double>& spacing = flight.of("minimum_spacing");
        const auto [least, most] = std::minmax_element(spacing.end() - 2000, spacing.end());
        QVERIFY2(std::abs(0.5 * (*most - *least) / cycle.amplitude() - 1.0) < 0.01,
                 qPrintable(QString("%1 %2").arg(*most - *least).arg(2.0 * cycle.amplitude())));
        QVERIFY(std::abs(*least - cycle.minimumSpacing.least) < 0.01 * cycle.amplitude());
        QVERIFY(std::abs(run.frequency / cycle.frequency() - 1.0) < 1e-3);
    }

    /// Another preload on the same film: where the slider flies, without contact, against its own static state.
    void anotherLoadMovesTheSlider()
    {
        Case c = bouncing();
        const double before = steady(bouncing()).minimumSpacing;
        c.suspension.preload *= 1.0005;
        c.onoYamane.touchDown -= 2e-9;
        c.onoYamane.takeOff -= 2e-9;
        c.initial.heightOffset = 0.0;
        const BouncingRun run = found(c);
        QVERIFY2(run.problem.empty(), run.problem.c_str());
        QCOMPARE(run.end, BouncingEnd::Flies);
        Case own = c;
        own.contact = noContact;
        const double moved = steady(own).minimumSpacing - before;
        QVERIFY(moved < -1e-12);
        const double found = 0.5 * (run.minimumSpacing.least + run.minimumSpacing.most) - before;
        QVERIFY2(std::abs(found / moved - 1.0) < 0.03, qPrintable(QString("%1 %2").arg(found).arg(moved)));
    }

    /// Other values on the same film, from starts in and out of contact, against runs of their own: where the slider is
    /// at the end.
    void otherCasesMoveAsTheirRuns_data()
    {
        QTest::addColumn<Case>("start"); // whose film it is
        QTest::addColumn<Case>("c");
        const Case base = bouncing();
        const auto row = [&](const char* name, const Case& start, const auto& change) {
            Case c = start;
            change(c);
            QTest::newRow(name) << start << c;
        };
        row("mass", base, [](Case& c) { c.slider.mass *= 1.3; });
        row("friction", base, [](Case& c) { c.onoYamane.friction = 0.8; });
        row("contact stiffness", base, [](Case& c) { c.onoYamane.contactStiffness *= 2.0; });
        row("linear menisci", base, [](Case& c) { c.onoYamane.takeOffShape = TakeOffShape::Linear; });
        row("no hysteresis", base, [](Case& c) { c.onoYamane.takeOff = c.onoYamane.touchDown; });
        Case held = base;
        held.degreesOfFreedom = 2;
        row("two degrees of freedom", held, [](Case&) {});
        // The static state is pressed, or held by the menisci.
        Case pressed = base;
        pressed.onoYamane.meniscusForce = 1e-3;
        pressed.onoYamane.touchDown += 0.05e-9;
        pressed.onoYamane.takeOff += 0.05e-9;
        pressed.initial.branch = ContactBranch::TakeOff;
        pressed.initial.heightOffset = 0.005e-9;
        Case bridged = base;
        bridged.initial.branch = ContactBranch::TakeOff;
        bridged.initial.heightOffset = -0.005e-9;
        row("held by menisci", bridged, [](Case&) {});
        row("pressed", pressed, [](Case&) {});
        row("pressed, lifted off", pressed, [](Case& c) { c.initial.heightOffset = 0.3e-9; });
    }
    void otherCasesMoveAsTheirRuns()
    {
        QFETCH(Case, start);
        QFETCH(Case, c);
        constexpr double duration = 30e-6; // [s]
        const BouncingRun run =
            searchCycle(*filmsLike(start)(c, 0, {}), 0.0, {.duration = duration, .mostCrossings = 0});
        QVERIFY2(run.problem.empty(), run.problem.c_str());
        c.run.duration = duration;
        c.run.sampleInterval = 2e-9;
        c.run.stepError = 1e-13;
        const Flight flight = fly(c);
        QVERIFY_STATUS(flight, RunStatus::Completed);
        const std::vector<double>& spacing = flight.of("minimum_spacing");
        const auto [least, most] =
            std::minmax_element(spacing.end() - std::ptrdiff_t(0.1 * double(spacing.size())), spacing.end());
        const double swing = *most - *least;
        qInfo("%g to %g nm, run %g to %g nm", run.minimumSpacing.least * 1e9, run.minimumSpacing.most * 1e9,
              *least * 1e9, *most * 1e9);
        QVERIFY(std::abs(run.minimumSpacing.least - *least) < 0.02 * swing);
        QVERIFY(std::abs(run.minimumSpacing.most - *most) < 0.02 * swing);
    }

    /// A cycle whose motion is above film.linear_limit is named and left out; a branch ends where that begins.
    void leavesOutWhatIsTooLarge()
    {
        Case c = bouncing();
        const double error = found(c).cycle.value().modelError;
        c.film.linearLimit = 0.5 * error;
        const BouncingRun run = searchCycle(*filmsLike(c)(c, 0, {}), 0.0, {.duration = 1e-3});
        QVERIFY(!run.cycle);
        QCOMPARE(run.end, BouncingEnd::Failed);
        QVERIFY(std::abs(run.modelError / error - 1.0) < 0.1);
        QVERIFY(run.problem.find("film.linear_limit") != std::string::npos);

        c.film.linearLimit = 1.05 * error;
        const std::string text = "from = \"0 mN\"\nto = \"0.006 mN\"\nvalues = 3\nstarts = 2\nduration = \"1 ms\"\n";
        const StudyReport report = performed(c, text);
        QCOMPARE(report.status, StudyStatus::Completed);
        const StudyTable &cycles = table(report, "cycles"), &special = table(report, "special_points");
        QVERIFY(cycles.rows.size() > 5);
        for (std::size_t i = 0; i < cycles.rows.size(); ++i) {
            QVERIFY(number(cycles, i, "linear_error") < 1.001 * c.film.linearLimit);
            QVERIFY(number(cycles, i, "residual") < 1e-6);
        }
        bool ends = false;
        for (std::size_t i = 0; i < special.rows.size(); ++i)
            ends = ends || word(special, i, "remark").find("film.linear_limit") != std::string::npos;
        QVERIFY(ends);
        for (const StudyTable& each : report.tables)
            for (const auto& row : each.rows) QCOMPARE(row.size(), each.columns.size());
        const StudyReport one = performed(c, text, 1);
        QCOMPARE(one.findings, report.findings);
        for (std::size_t i = 0; i < one.tables.size(); ++i) QVERIFY(one.tables[i].rows == report.tables[i].rows);
    }

    void aMapOfTheFilm()
    {
        const char* mapText = "starts = 1\nduration = \"1 ms\"\n[map]\nx = \"ono_yamane.meniscus_force\"\n"
                              "x_from = \"0 mN\"\nx_to = \"0.02 mN\"\nx_points = 2\n"
                              "y = \"ono_yamane.friction\"\ny_from = 0\ny_to = 0.1\ny_points = 2\n";
        const StudyReport report = performed(bouncing(), mapText);
        QCOMPARE(report.status, StudyStatus::Completed);
        const StudyTable& map = report.tables.front();
        QCOMPARE(map.rows.size(), std::size_t(4));
        QCOMPARE(number(map, 0, "bounces"), 1.0); // W < 0
        QCOMPARE(number(map, 1, "bounces"), 0.0); // W > 0
        // Too large for the linear film: the cell says so.
        Case strict = bouncing();
        strict.film.linearLimit = 1e-4;
        const StudyReport none = performed(strict, mapText);
        QCOMPARE(none.status, StudyStatus::Completed);
        QCOMPARE(number(none.tables.front(), 0, "bounces"), 0.0);
        QVERIFY(std::ranges::any_of(none.warnings, [](const std::string& each) {
            return each.find("film.linear_limit") != std::string::npos;
        }));
    }

    void saysWhatItCannotTake_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("key");
        QTest::newRow("another film") << "parameter = \"disk.speed\"\nfrom = \"5000 rpm\"\nto = \"6000 rpm\"\n"
                                      << "parameter";
        QTest::newRow("another film on a map")
            << "[map]\nx = \"disk.speed\"\nx_from = \"5000 rpm\"\nx_to = \"6000 rpm\"\n"
               "y = \"ono_yamane.friction\"\ny_from = 0\ny_to = 1\n"
            << "map.x";
    }
    void saysWhatItCannotTake()
    {
        QFETCH(QString, text);
        QFETCH(QString, key);
        const Case c = bouncing();
        const StudyPlan plan = parseStudy("cycles", text.toStdString(), "study", {}, &c);
        QCOMPARE(plan.problems.size(), std::size_t(1));
        QCOMPARE(QString::fromStdString(plan.problems.front().key), key);
        QVERIFY(plan.problems.front().message.find("film.motion") != std::string::npos);
    }

    /// No static state, and a search that is stopped.
    void saysWhyThereIsNone()
    {
        Case c = bouncing();
        c.film.maximumIterations = 1;
        const BouncingRun none = runOf(filmsLike(c), c, 0, 1.0, {});
        QCOMPARE(none.end, BouncingEnd::Failed);
        QVERIFY2(none.problem.find("static state") != std::string::npos, none.problem.c_str());
        QVERIFY(filmsLike(bouncing())(bouncing(), 0, [] { return false; }) == nullptr);
        // It is looked for once.
        int asked = 0;
        const SliderOf films = filmsLike(c);
        const GoOn counting = [&] { return ++asked > 0; };
        QVERIFY_EXCEPTION_THROWN(films(c, 0, counting), std::runtime_error);
        const int before = asked;
        QVERIFY_EXCEPTION_THROWN(films(c, 1, counting), std::runtime_error);
        QCOMPARE(asked, before);
    }
};

TOUCHDOWN_TEST(TestBouncingFilm)

} // namespace test_bouncing_film

#include "test_bouncing_film.moc"

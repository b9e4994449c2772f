// SPDX-License-Identifier: GPL-3.0-or-later
//
// Forced motion on a linear film: against small motions as linear algebra has them, against runs in time, and against
// differences of its own.
#include "core/studies/response/forced_film.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>

#include <QtTest>

#include "core/case/contact_kind.h"
#include "core/formats/decimal.h"
#include "core/formats/units.h"
#include "core/simulation/small_motions/linear_motion.h"
#include "core/simulation/small_motions/small_motions.h"
#include "core/simulation/static_state/steady.h"
#include "core/studies/response/forced_springs.h"
#include "core/studies/response/settled_motion.h"
#include "core/studies/study_plan.h"
#include "tests/support/film_flight.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_forced_film {

constexpr double wave = 0.02e-9; // [m]

Case flying()
{
    Case c = fromRest("film_pico", 1e-6);
    c.film.motion = FilmMotion::Linear;
    // So few cells leave one mode undamped.
    c.suspension.damping = 0.03;
    c.suspension.pitchDamping = c.suspension.rollDamping = 5e-9;
    return c;
}

/// A contact that begins a little below the flying slider, and ends a little above it.
Case touching()
{
    Case c = flying();
    const double spacing = steady(c).minimumSpacing;
    c.film.linearLimit = 1.0;
    c.contact = ContactKind::OnoYamane;
    c.onoYamane.touchDown = spacing - 0.03e-9;
    c.onoYamane.takeOff = spacing + 0.02e-9;
    c.onoYamane.contactStiffness = 5e5;
    c.onoYamane.initialContactForce = 2e-5;
    c.onoYamane.meniscusForce = 1e-5;
    c.onoYamane.friction = 0.4;
    return c;
}

std::shared_ptr<const FilmUnderWaves> filmOf(const Case& c, const char* quantity,
                                             const std::vector<double>& frequencies, double amplitude = wave)
{
    return FilmUnderWaves::make(c, quantity, amplitude, frequencies, 0.0, [](double) { return true; });
}

class TestForcedFilm : public QObject {
    Q_OBJECT

private slots:
    /// D(i omega)^-1 F(i omega) w without a fit: at frequencies below, between and above the modes.
    void smallMotionsAreThoseOfTheFilm()
    {
        const Case c = flying();
        for (const char* quantity : {"height", "pitch", "flying_height_above_disk"}) {
            const std::vector<double> frequencies{40e3, 75e3, 110e3, 250e3};
            const auto film = filmOf(c, quantity, frequencies);
            for (const double frequency : frequencies) {
                const ForcedFilm slider(film, frequency);
                const Case over = caseOverWave(c, wave, frequency, 0.0);
                const LinearMotion motion = linearMotion(over, {}, MotionParts::Waves);
                QCOMPARE(motion.status, SteadyStatus::Converged);
                // At two times a quarter of a period apart the motion by the waves alone.
                const DiskTopography disk(over.diskSurface);
                const SurfacePoint at = c.surface.pointsOfInterest.empty()
                                            ? SurfacePoint{c.slider.length, 0.5 * c.slider.width}
                                            : c.surface.pointsOfInterest.front();
                const auto value = [&](double time) {
                    const Attitude a = motion.at(time);
                    const double height = disk.height(at.x - speedAlong(c) * time, at.y);
                    if (std::string(quantity) == "height") return a.height + 0.5 * c.slider.length * a.pitch;
                    if (std::string(quantity) == "pitch") return a.pitch;
                    return a.height + a.pitch * (c.slider.length - at.x) - a.roll * (at.y - 0.5 * c.slider.width) -
                           height;
                };
                const double quarter = 0.25 / frequency;
                const double real = 0.5 * (value(0.0) - value(2.0 * quarter)),
                             imaginary = -0.5 * (value(quarter) - value(3.0 * quarter));
                const double amplitude = std::hypot(real, imaginary);
                const std::complex<double> q = slider.linear().value();
                QVERIFY2(
                    std::abs(std::abs(q) / amplitude - 1.0) < 2e-3,
                    qPrintable(
                        QString("%1 at %2 kHz: %3").arg(quantity).arg(frequency / 1e3).arg(std::abs(q) / amplitude)));
                // Against the disk under the point, which is a sin(omega t) here.
                const double there = std::arg(
                    std::complex<double>(disk.height(at.x, at.y), -disk.height(at.x - speedAlong(c) * quarter, at.y)));
                const double phase =
                    std::remainder(std::arg(q) + 0.5 * std::numbers::pi - (std::atan2(imaginary, real) - there),
                                   2.0 * std::numbers::pi);
                QVERIFY2(std::abs(phase) < 3e-3,
                         qPrintable(QString("%1 at %2: %3").arg(quantity).arg(frequency).arg(phase)));
            }
        }
    }

    /// A motion far from the law's switches settles into these small motions.
    void settlesIntoSmallMotions()
    {
        const Case c = flying();
        const auto film = filmOf(c, "flying_height", {90e3, 150e3});
        for (const double frequency : {90e3, 150e3}) {
            const ForcedFilm slider(film, frequency);
            const ForcedMotion motion = settledMotion(slider, slider.start(), {});
            QVERIFY2(motion.settled(), motion.problem.c_str());
            QCOMPARE(motion.period, 1);
            QVERIFY(motion.multiplier.value() < 1.0);
            const std::complex<double> q = slider.linear().value();
            QVERIFY2(std::abs(motion.harmonic - q) < 1e-6 * std::abs(q),
                     qPrintable(QString::number(std::abs(motion.harmonic - q) / std::abs(q))));
            QVERIFY(std::abs(0.5 * (motion.most - motion.least) / std::abs(q) - 1.0) < 2e-3);
            QCOMPARE(motion.contactShare, 0.0);
        }
    }

    /// The same wave in a run in time, long enough to settle: extremes of the spacing, with touch-downs.
    void agreesWithRunsInContact()
    {
        const Case c = touching();
        const double amplitude = 0.15e-9;
        int touched = 0;
        for (const double frequency : {85e3, 98e3, 240e3}) {
            const auto film = filmOf(c, "minimum_spacing", {frequency}, amplitude);
            const ForcedFilm slider(film, frequency);
            const ForcedMotion motion = settledMotion(slider, slider.start(), {});
            QVERIFY2(motion.valid(), motion.problem.c_str());
            touched += motion.touchDowns > 0.0;
            Case over = caseOverWave(c, amplitude, frequency, 0.0);
            over.run.duration = 1000e-6;
            over.run.sampleInterval = 0.1e-6;
            over.run.stepError = 1e-13;
            const Flight flight = fly(over);
            QVERIFY_STATUS(flight, RunStatus::Completed);
            const std::vector<double>& spacing = flight.of("minimum_spacing");
            const auto [least, most] = std::minmax_element(spacing.end() - 1000, spacing.end());
            const double swing = motion.most - motion.least;
            qInfo("%g kHz: swing %g nm, least %g nm; run %g and %g nm; contact %g, touch-downs %g, period %d",
                  frequency / 1e3, swing * 1e9, motion.least * 1e9, (*most - *least) * 1e9, *least * 1e9,
                  motion.contactShare, motion.touchDowns, motion.period);
            QVERIFY(std::abs((*most - *least) / swing - 1.0) < 0.01);
            QVERIFY(std::abs(*least - motion.least) < 0.01 * swing);
        }
        QVERIFY(touched > 0);
    }

    /// Drawn ways through switches of the contact, over one and over three periods: their derivative by differences.
    void derivativeIsThatOfTheWay()
    {
        const Case c = touching();
        const double frequency = 85e3;
        const auto film = filmOf(c, "minimum_spacing", {frequency});
        const ForcedFilm slider(film, frequency);
        std::mt19937_64 random(5);
        std::uniform_real_distribution<double> share(-1.0, 1.0);
        int touchDowns = 0;
        std::vector<double> errors;
        for (int k = 0; k < 20; ++k) {
            const int periods = k % 2 == 0 ? 1 : 3;
            Eigen::VectorXd direction(2 * slider.positions());
            for (double& each : direction) each = share(random);
            const ForcedState from = slider.moved(direction.normalized(), 0.2e-9);
            const ForcedPeriods way = slider.run(from, {.periods = periods, .derivative = true, .measurements = true});
            QVERIFY2(way.problem.empty(), way.problem.c_str());
            touchDowns += way.touchDowns;
            const Eigen::VectorXd units = slider.units(way.swing);
            Eigen::VectorXd change(from.y.size());
            for (double& each : change) each = share(random);
            change = units.cwiseProduct(change) * 1e-7;
            const auto end = [&](double sign) {
                return slider.run({from.y + sign * change, from.mode}, {.periods = periods}).end.y;
            };
            const Eigen::VectorXd difference = 0.5 * (end(1.0) - end(-1.0)), known = way.derivative * change;
            errors.push_back((difference - known).cwiseQuotient(units).norm() / known.cwiseQuotient(units).norm());
        }
        QVERIFY2(touchDowns >= 10, qPrintable(QString::number(touchDowns)));
        std::ranges::sort(errors);
        QVERIFY2(errors[errors.size() - 2] < 1e-4, qPrintable(QString::number(errors[errors.size() - 2])));
    }

    /// Between the nodes the film's force is interpolated: eight in a beat of the waves under the slider.
    void forcesBetweenNodes()
    {
        const Case c = flying();
        const double beat = std::abs(speedAlong(c)) / c.slider.length;
        std::vector<double> frequencies;
        for (int k = 0; k <= 8; ++k) frequencies.push_back(100e3 + 0.5 * k * beat);
        double least = 1.0, most = 0.0; // of the shares that are told
        const auto film = FilmUnderWaves::make(c, "height", wave, frequencies, beat, [&](double share) {
            least = std::min(least, share);
            most = std::max(most, share);
            return true;
        });
        QVERIFY(least == 0.0 && most > 0.9 && most <= 1.0);
        for (const double frequency : {frequencies[3] + 0.21 * beat, frequencies[5] + 0.43 * beat}) {
            const auto own = filmOf(c, "height", {frequency});
            const double error =
                (film->forceAt(frequency) - own->forceAt(frequency)).norm() / own->forceAt(frequency).norm();
            QVERIFY2(error < 5e-3, qPrintable(QString::number(error)));
        }
    }

    /// Of the modes, those that no frequency of the study comes near.
    void namesVibrationsOutsideTheRange()
    {
        const Case c = flying();
        const std::vector<double> modes = filmOf(c, "height", {90e3})->pieces().frequencies();
        // Those of the slider, no memory of the film.
        const ModesResult known = touchdown::modes(c);
        std::vector<double> slider;
        for (const AirBearingMode& mode : known.modes)
            if (mode.dampingRatio < 0.2 && mode.frequency > 0.0) slider.push_back(mode.frequency);
        std::ranges::sort(slider);
        QCOMPARE(modes.size(), slider.size());
        for (std::size_t k = 0; k < modes.size(); ++k) QVERIFY(std::abs(modes[k] / slider[k] - 1.0) < 5e-3);
        const auto warningOf = [&](double from, double to) {
            const std::string text = "from = \"" + decimalText(from) + " Hz\"\nto = \"" + decimalText(to) +
                                     " Hz\"\nsteps = 2\nperiods = 16\nstarts = 0\n";
            const StudyPlan plan = parseStudy("response", text, "study", {}, &c);
            if (!plan.valid()) qFatal("%s", plan.problems.front().text().c_str());
            for (const std::string& warning : plan.perform(2, {}).warnings)
                if (warning.find("outside the range") != std::string::npos) return warning;
            return std::string();
        };
        QVERIFY(warningOf(0.9 * modes.front(), 1.1 * modes.back()).empty());
        const std::string warning = warningOf(0.5 * (modes[0] + modes[1]), 1.1 * modes.back());
        QVERIFY2(warning.find(fewDigits(modes.front(), "kHz", 3)) != std::string::npos, warning.c_str());
        QVERIFY(warning.find(fewDigits(modes.back(), "kHz", 3)) == std::string::npos);
    }

    void saysWhatItCannotTake()
    {
        Case c = flying();
        QVERIFY(reasonAgainstForcedFilm(c).empty());
        c.film.motion = FilmMotion::Full;
        QVERIFY(reasonAgainstForcedFilm(c).find("film.motion") != std::string::npos);
        c = flying();
        c.contact = ContactKind::Asperity;
        QVERIFY(reasonAgainstForcedFilm(c).find("ono-yamane") != std::string::npos);
        // Too large a motion is none.
        c = flying();
        const auto film = filmOf(c, "height", {100e3}, 3e-9);
        const ForcedFilm slider(film, 100e3);
        const ForcedMotion motion = settledMotion(slider, slider.start(), {});
        QVERIFY(!motion.valid());
        QVERIFY2(motion.problem.find("linear film") != std::string::npos, motion.problem.c_str());
        c.suspension.preload = 0.5;
        QVERIFY_EXCEPTION_THROWN(filmOf(c, "height", {100e3}), std::runtime_error);
        QVERIFY(!FilmUnderWaves::make(flying(), "height", wave, std::vector{100e3}, 0.0, [](double) { return false; }));
    }
};

TOUCHDOWN_TEST(TestForcedFilm)

} // namespace test_forced_film

#include "test_forced_film.moc"

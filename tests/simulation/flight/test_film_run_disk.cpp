// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <QtTest>

#include "core/case/contact_kind.h"
#include "core/case_files/case_file.h"
#include "core/physics/disk/disk_velocity.h"
#include "core/simulation/flight/film_run.h"
#include "core/simulation/run.h"
#include "core/simulation/static_state/steady.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_film_run_disk {

class TestFilmRunDisk : public QObject {
    Q_OBJECT

private slots:
    void aDiskThatRisesIntoTheSliderIsTheCause_data();
    void aDiskThatRisesIntoTheSliderIsTheCause();
    void aSliderThatFallsToAFlatDiskReachesIt();
    void aBumpThatPassesWithinAStepIsSeen();
    void aLawOnTheMeanPlaneDoesNotSeeTheDisk();
    void theLeastGapIsThatOfItsSamples_data();
    void theLeastGapIsThatOfItsSamples();
    void withoutAStaticStateTheGridIsThatOfTheCase();
    void stepsFollowWavesUnderAHeldSlider();
    void recordsSpacingsAboveTheDisk();
    void warnsOfWavesThatCellsLose();
};

/// The pico slider from its static state, on a coarse grid.
Case pico(double duration)
{
    Case c = openCase("film_pico", OutsidePaths::Refused).value;
    c.film.nodes = {33, 33};
    c.initial.state = InitialState::Static;
    c.run.duration = duration;
    c.run.fieldSnapshots = 0;
    return c;
}

Case overWaves(Case c, double amplitude, double waveLength, double phase = 0.0)
{
    c.diskSurface.kind = DiskSurfaceKind::Waves;
    c.diskSurface.waveAmplitudes = {amplitude};
    c.diskSurface.waveLengths = {waveLength};
    c.diskSurface.wavePhases = {phase};
    c.diskSurface.track = 20e-3;
    return c;
}

Velocity velocityOf(const Case& c)
{
    return diskVelocity(c.disk, c.slider.length, c.slider.width, 0.5 * c.slider.length, 0.5 * c.slider.width);
}

struct Flight {
    Summary summary;
    std::map<std::string, std::vector<double>> columns;
    std::vector<double> time;
    double figure(const std::string& name) const
    {
        const auto of = [](const RunFigure& each) { return each.quantity.name; };
        const auto found = std::ranges::find(summary.figures, name, of);
        return found != summary.figures.end() ? found->value : std::numeric_limits<double>::quiet_NaN();
    }
    bool warns(const char* part) const
    {
        return std::ranges::any_of(summary.warnings,
                                   [&](const std::string& each) { return each.find(part) != std::string::npos; });
    }
};

Flight fly(const Case& c)
{
    Flight flight;
    const std::vector<Quantity> quantities = recordedQuantities(c);
    flight.summary = run(c, [&](const RunUpdate& update) {
        flight.time.insert(flight.time.end(), update.samples.time.begin(), update.samples.time.end());
        for (std::size_t k = 0; k < quantities.size(); ++k) {
            std::vector<double>& to = flight.columns[quantities[k].name];
            to.insert(to.end(), update.samples.columns[k].begin(), update.samples.columns[k].end());
        }
        return true;
    });
    return flight;
}

void TestFilmRunDisk::aDiskThatRisesIntoTheSliderIsTheCause_data()
{
    QTest::addColumn<double>("amplitude");  // [m]
    QTest::addColumn<double>("waveLength"); // [m]
    QTest::addColumn<double>("phase");      // [rad]
    QTest::addColumn<QString>("when");
    QTest::newRow("at the start") << 15e-9 << 400e-6 << 0.5 * std::numbers::pi << "at the start";
    // A trough under the lowest point, at x = 1.2245 mm, and a wave too short to be followed.
    const double phase = -2.0 * std::numbers::pi * std::fmod(1.2245e-3 / 100e-6, 1.0) - 0.5 * std::numbers::pi;
    QTest::newRow("later") << 13e-9 << 100e-6 << phase << " at x = ";
}

void TestFilmRunDisk::aDiskThatRisesIntoTheSliderIsTheCause()
{
    QFETCH(double, amplitude);
    QFETCH(double, waveLength);
    QFETCH(double, phase);
    QFETCH(QString, when);
    const Flight flight = fly(overWaves(pico(0.4e-3), amplitude, waveLength, phase));
    QVERIFY(flight.summary.status == RunStatus::Failed);
    const QString message = QString::fromStdString(flight.summary.message);
    QVERIFY2(message.contains(when) && message.contains("no law of contact acts"), qPrintable(message));
    QVERIFY2(message.contains("above its mean plane"), qPrintable(message));
    for (const auto& [name, values] : flight.columns)
        for (const double value : values) QVERIFY2(std::isfinite(value), name.c_str());
}

void TestFilmRunDisk::aSliderThatFallsToAFlatDiskReachesIt()
{
    Case c = pico(10e-6);
    c.initial.verticalVelocity = -0.1;
    const Flight flight = fly(c);
    QVERIFY(flight.summary.status == RunStatus::Failed);
    const QString message = QString::fromStdString(flight.summary.message);
    QVERIFY2(message.contains("reaches the mean plane of the disk at "), qPrintable(message));
    for (const double spacing : flight.columns.at("minimum_spacing")) QVERIFY(spacing > -1e-9);
}

/// A flat pad of 0.2 mm that cannot move, 20 nm above the disk at its trailing edge, without a static state.
Case heldPad()
{
    Case c;
    c.model = ModelKind::Film;
    c.contact = noContact;
    c.slider.length = c.slider.width = 0.2e-3;
    c.slider.mass = 1.0;
    c.slider.pitchInertia = c.slider.rollInertia = 1e-3;
    c.surface = {};
    c.surface.baseRecess = 0.0;
    c.suspension.preload = 1e-3;
    c.film.nodes = {33, 17};
    c.film.grid = GridKind::Uniform;
    c.initial.state = InitialState::Given;
    c.initial.nominalTrailingEdgeHeight = 20e-9;
    c.initial.pitch = 100e-6;
    c.run.fieldSnapshots = 0;
    return c;
}

void TestFilmRunDisk::aBumpThatPassesWithinAStepIsSeen()
{
    // Steps of a hundredth of the run, 2 us, in which the disk moves by 26 um under the pad. A bump of 4 um and 23 nm,
    // too short for the cells, comes to a pad 200 um long that is 30 nm high at its middle: it touches where the pad is
    // 23 nm high, 30 um before the trailing edge.
    Case c = heldPad();
    c.run.duration = 200e-6;
    c.run.sampleInterval = 50e-6;
    c.diskSurface.kind = DiskSurfaceKind::Bumps;
    c.diskSurface.bumpShape = BumpShape::Cosine;
    c.diskSurface.bumpHeights = {23e-9};
    c.diskSurface.bumpLengths = {4e-6};
    c.diskSurface.bumpWidths = {40e-6};
    c.diskSurface.bumpX = {-0.4e-3 + 20e-3};
    c.diskSurface.bumpY = {0.1e-3};
    c.diskSurface.track = 20e-3;
    c.diskSurface.trackWidth = 0.2e-3;
    const Flight flight = fly(c);
    QVERIFY(flight.summary.status == RunStatus::Failed);
    const QString message = QString::fromStdString(flight.summary.message);
    QVERIFY2(message.contains("the disk's surface reaches the slider at "), qPrintable(message));
    // 570 um at about 13 m/s; looked at each quarter of the bump, 1 um.
    const double expected = 570e-6 / velocityOf(c).x;
    const double said = message.section("slider at ", 1).section(" us", 0, 0).toDouble() * 1e-6;
    QVERIFY2(std::abs(said - expected) < 3e-6 / velocityOf(c).x, qPrintable(message));
    // The point where it was found belongs to the run.
    const auto extremes = std::ranges::find(flight.summary.extremes, std::string("minimum_gap"),
                                            [](const auto& each) { return each.first; });
    QVERIFY(extremes->second.least <= 0.0 && extremes->second.least > -4e-9);
}

void TestFilmRunDisk::theLeastGapIsThatOfItsSamples_data()
{
    QTest::addColumn<double>("interval"); // [s]
    for (const double interval : {20e-9, 0.1e-6, 0.33e-6}) QTest::addRow("%g ns", interval * 1e9) << interval;
}

void TestFilmRunDisk::theLeastGapIsThatOfItsSamples()
{
    // Between samples and ends of steps the gap changes by little: no point that is sought elsewhere may be far off.
    QFETCH(double, interval);
    Case c = pico(30e-6);
    c.run.sampleInterval = interval;
    c = overWaves(c, 2e-9, 300e-6);
    c.diskSurface.waveAmplitudes = {2e-9, 1.5e-9};
    c.diskSurface.waveLengths = {300e-6, 170e-6};
    c.diskSurface.waveAngles = {0.17, 0.87};
    c.diskSurface.wavePhases = {0.0, 0.0};
    const Flight flight = fly(c);
    QVERIFY2(flight.summary.status == RunStatus::Completed, flight.summary.message.c_str());
    const std::vector<double>& gaps = flight.columns.at("minimum_gap");
    const auto extremes = std::ranges::find(flight.summary.extremes, std::string("minimum_gap"),
                                            [](const auto& each) { return each.first; });
    double change = 0.0; // between samples, at most [m]
    for (std::size_t n = 1; n < gaps.size(); ++n) change = std::max(change, std::abs(gaps[n] - gaps[n - 1]));
    QVERIFY(extremes->second.least <= std::ranges::min(gaps) && extremes->second.most >= std::ranges::max(gaps));
    QVERIFY(extremes->second.least > std::ranges::min(gaps) - change);
    QVERIFY(extremes->second.most < std::ranges::max(gaps) + change);
}

void TestFilmRunDisk::withoutAStaticStateTheGridIsThatOfTheCase()
{
    // The force at the start is that of the static film at this attitude, on these cells. The preload has no static
    // state: the film's least force is above it.
    Case c = heldPad();
    c.run.duration = 0.1e-6;
    Case fixed = c;
    fixed.steady.fixedAttitude = true;
    for (const int nodes : {33, 49}) {
        c.film.nodes = fixed.film.nodes = {nodes, nodes};
        const Flight flight = fly(c);
        QVERIFY2(flight.warns("no static state was found"), flight.summary.message.c_str());
        const double expected = steady(fixed).forces.net;
        QVERIFY2(std::abs(flight.columns.at("air_bearing_force").front() - expected) < 1e-6 * expected,
                 qPrintable(QString::number(flight.columns.at("air_bearing_force").front() / expected)));
    }
}

void TestFilmRunDisk::aLawOnTheMeanPlaneDoesNotSeeTheDisk()
{
    Case c = overWaves(pico(2e-6), 14e-9, 400e-6, 0.5 * std::numbers::pi);
    c.contact = ContactKind::OnoYamane;
    QVERIFY(fly(c).warns("acts on the mean plane and does not see it"));
    c.diskSurface.waveAmplitudes = {1e-9};
    QVERIFY(!fly(c).warns("mean plane"));
}

void TestFilmRunDisk::stepsFollowWavesUnderAHeldSlider()
{
    // A slider that the disk cannot move has no error of its steps; waves of 200 um pass in 15 us at 13 m/s, and a
    // hundredth of the run is longer than a sixteenth of that.
    Case c = overWaves(pico(120e-6), 1e-9, 200e-6);
    c.slider.mass = 1.0;
    c.slider.pitchInertia = c.slider.rollInertia = 1e-3;
    const double longest = 200e-6 / 16.0 / velocityOf(c).x;
    const Flight flight = fly(c);
    QVERIFY(flight.summary.status == RunStatus::Completed);
    QVERIFY(flight.summary.steps >= static_cast<long long>(c.run.duration / longest));
    const std::vector<double>& steps = flight.columns.at("time_step");
    QVERIFY(std::ranges::max(steps) <= longest * (1.0 + 1e-9));
    QVERIFY(std::ranges::max(steps) > 0.5 * longest);
}

void TestFilmRunDisk::recordsSpacingsAboveTheDisk()
{
    // A wave of 20 mm passes in 1.5 ms: the slider follows it, so that its spacing above the disk hardly changes.
    // At the start a node lies under the trailing pad.
    const double phase = -2.0 * std::numbers::pi * 1.2245e-3 / 20e-3;
    Case c = overWaves(pico(0.4e-3), 5e-9, 20e-3, phase);
    const Flight flight = fly(c);
    QVERIFY2(flight.summary.status == RunStatus::Completed, flight.summary.message.c_str());
    const Velocity velocity = velocityOf(c);
    const SurfacePoint at = c.surface.pointsOfInterest.front(), second = c.surface.pointsOfInterest.back();
    double least = 1.0, most = 0.0, leastPlane = 1.0, mostPlane = 0.0;
    for (std::size_t n = 0; n < flight.time.size(); ++n) {
        const auto disk = [&](SurfacePoint point) {
            return 5e-9 * std::sin(2.0 * std::numbers::pi * (point.x - velocity.x * flight.time[n]) / 20e-3 + phase);
        };
        QVERIFY(std::abs(flight.columns.at("disk_height")[n] - disk(at)) < 1e-15);
        QVERIFY(std::abs(flight.columns.at("disk_height_2")[n] - disk(second)) < 1e-15);
        const double above = flight.columns.at("flying_height_above_disk")[n];
        QVERIFY(std::abs(above - (flight.columns.at("flying_height")[n] - disk(at))) < 1e-15);
        // The nearest point is one of the trailing pad, over which such a wave is level.
        QVERIFY(std::abs(flight.columns.at("minimum_gap")[n] -
                         (flight.columns.at("minimum_spacing")[n] - flight.columns.at("disk_height")[n])) < 0.1e-9);
        leastPlane = std::min(leastPlane, flight.columns.at("flying_height")[n]);
        mostPlane = std::max(mostPlane, flight.columns.at("flying_height")[n]);
        if (flight.time[n] < 0.9 * c.run.duration) continue;
        least = std::min(least, above);
        most = std::max(most, above);
    }
    // Peak to peak over the last tenth, between samples, too.
    QVERIFY(flight.figure("flying_height_modulation") >= most - least);
    QVERIFY(flight.figure("flying_height_modulation") < 1.02 * (most - least) + 1e-13);
    QVERIFY(flight.figure("flying_height_modulation_rms") < flight.figure("flying_height_modulation"));
    QVERIFY(most - least < 0.1 * (mostPlane - leastPlane));
}

void TestFilmRunDisk::warnsOfWavesThatCellsLose()
{
    QVERIFY(fly(overWaves(pico(1e-6), 0.5e-9, 20e-6)).warns("at least 6 are needed"));
    const Flight fine = fly(overWaves(pico(1e-6), 0.5e-9, 800e-6));
    QVERIFY(!fine.warns("at least 6") && !fine.warns("run.step"));
    Case fixed = overWaves(pico(8e-6), 0.5e-9, 800e-6);
    fixed.run.steps = StepControl::Fixed;
    fixed.run.step = 8e-6;
    QVERIFY(fly(fixed).warns("a sixteenth of the passage of waves of 800 um"));
}

TOUCHDOWN_TEST(TestFilmRunDisk)

} // namespace test_film_run_disk

#include "test_film_run_disk.moc"

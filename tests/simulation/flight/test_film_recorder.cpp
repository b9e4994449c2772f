// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/flight/film_recorder.h"

#include <cmath>
#include <map>

#include <QTest>

#include "core/case/contact_kind.h"
#include "core/case/parameters.h"
#include "core/physics/slider/minimum_spacing.h"
#include "core/simulation/flight/film_run.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_film_recorder {

constexpr double length = 1.25e-3, width = 1.0e-3;

Case plainSlider()
{
    Case c = defaultsOf(ModelKind::Film);
    c.contact = ContactKind::OnoYamane;
    c.slider.length = length;
    c.slider.width = width;
    c.surface.baseRecess = 1e-6;
    c.surface.rails = {{.points = {{1.1e-3, 0.4e-3}, {1.2e-3, 0.4e-3}, {1.2e-3, 0.6e-3}, {1.1e-3, 0.6e-3}}}};
    c.surface.pointsOfInterest = {{1.2e-3, 0.5e-3}};
    c.run.duration = 1e-6;
    c.run.sampleInterval = 0.1e-6;
    return c;
}

/// Of fifth degree in t/(1 us), another one for each coordinate; powers from the constant up.
constexpr std::array<std::array<double, 6>, 3> powers{{{9e-8, 2e-9, -3e-9, 1e-9, 4e-9, -2e-9},
                                                       {1.5e-4, -1e-6, 2e-6, 3e-6, -5e-6, 1e-6},
                                                       {1e-6, 3e-7, -1e-7, 0.0, 2e-7, 4e-7}}};
SliderMotion polynomial(double time)
{
    const double t = time / 1e-6;
    SliderMotion motion;
    for (std::size_t k = 0; k < 3; ++k)
        for (int n = 5; n >= 0; --n) {
            motion.a[k] = motion.a[k] * t + 2.0 * motion.v[k];
            motion.v[k] = motion.v[k] * t + motion.q[k];
            motion.q[k] = motion.q[k] * t + powers[k][std::size_t(n)];
        }
    for (std::size_t k = 0; k < 3; ++k) {
        motion.v[k] /= 1e-6;
        motion.a[k] /= 1e-12;
    }
    return motion;
}

FilmPoint pointAt(double time, double dt)
{
    FilmPoint point;
    point.time = time;
    point.motion = polynomial(time);
    point.filmForce[0] = 15e-3 + 2e3 * time; // [N], linear
    point.contact.contact = 4e3 * time;
    point.contact.adhesion = -1e-3;
    point.filmEnergy = 1e-6 * time;
    point.dt = dt;
    return point;
}

/// A recorder with what it told.
struct Recording {
    Case c;
    Recess recess;
    MinimumSpacing all;
    NearbySpacing spacing;
    SliderBody body;
    std::map<std::string, std::size_t> columnOf;
    std::vector<double> time;
    std::vector<std::vector<double>> columns;
    std::vector<RunEvent> events;
    std::size_t calls = 0, callsUntilStop = 0; // zero: never
    RunCallback callback;
    RunRecorder run;
    FilmRecorder recorder;

    explicit Recording(const Case& of)
        : c(of),
          recess(c.surface, length, width),
          all(c.surface, recess),
          spacing(all, 0.0),
          body(c, {1e-8, 1e-4, 0.0}),
          columns(filmQuantities(c).size()),
          callback([this](const RunUpdate& update) { return take(update); }),
          run(c, filmQuantities(c), callback),
          recorder(c, body, recess, spacing, nullptr, 1.0, run)
    {
        const std::vector<Quantity> quantities = filmQuantities(c);
        for (std::size_t i = 0; i < quantities.size(); ++i) columnOf[quantities[i].name] = i;
    }
    bool take(const RunUpdate& update)
    {
        time.insert(time.end(), update.samples.time.begin(), update.samples.time.end());
        for (std::size_t i = 0; i < columns.size(); ++i)
            columns[i].insert(columns[i].end(), update.samples.columns[i].begin(), update.samples.columns[i].end());
        events.insert(events.end(), update.events.begin(), update.events.end());
        return ++calls != callsUntilStop;
    }
    /// Steps that end at these times.
    void record(const std::vector<double>& ends)
    {
        recorder.begin(pointAt(0.0, 0.0));
        double last = 0.0;
        for (const double end : ends) {
            recorder.add(pointAt(end, end - last));
            last = end;
        }
    }
    double value(const char* quantity, std::size_t sample) const { return columns[columnOf.at(quantity)][sample]; }
};

class TestFilmRecorder : public QObject {
    Q_OBJECT

private slots:
    /// Six values determine a polynomial of fifth degree.
    void isExactForTheFifthDegree()
    {
        const FilmPoint from = pointAt(0.2e-6, 0.0), to = pointAt(0.9e-6, 0.0);
        for (int n = 0; n <= 10; ++n) {
            const SliderMotion found = between(from, to, 0.1 * n), expected = polynomial(0.2e-6 + 0.07e-6 * n);
            for (std::size_t k = 0; k < 3; ++k) {
                QVERIFY(std::abs(found.q[k] - expected.q[k]) < 1e-12 * std::abs(powers[k][0]));
                QVERIFY(std::abs(found.v[k] - expected.v[k]) < 1e-12 * std::abs(powers[k][0]) / 1e-6);
            }
        }
    }
    /// The height turns at two places within 1 us, between two samples: extremes against 10 000 points.
    void extremesBetweenSamples()
    {
        Case c = plainSlider();
        c.run.sampleInterval = 1e-6;
        Recording recording(c);
        std::vector<double> ends;
        for (int i = 1; i <= 10; ++i) ends.push_back(1e-7 * i);
        recording.record(ends);
        recording.run.send(1e-6);
        double least = 1.0, most = 0.0;
        for (int i = 0; i <= 10000; ++i) {
            const double value = polynomial(1e-10 * i).q[0];
            least = std::min(least, value);
            most = std::max(most, value);
        }
        const Summary summary = recording.recorder.summary({});
        bool found = false;
        for (const auto& [name, extremes] : summary.extremes) {
            if (name != "height") continue;
            found = true;
            QVERIFY(std::abs(extremes.least - least) < 1e-3 * (most - least));
            QVERIFY(std::abs(extremes.most - most) < 1e-3 * (most - least));
        }
        QVERIFY(found);
    }
    /// A step of no length is where it is.
    void stepWithoutLength()
    {
        const FilmPoint point = pointAt(0.2e-6, 0.0);
        QCOMPARE(between(point, point, 0.0).q[0], point.motion.q[0]);
        QCOMPARE(between(point, point, 0.0).v[0], point.motion.v[0]);
    }

    /// Ten intervals whatever the steps are, 0 and the duration included; the last step goes beyond it.
    void samplesAtEqualIntervals()
    {
        Recording r(plainSlider());
        r.record({0.03e-6, 0.04e-6, 0.35e-6, 0.4e-6, 0.95e-6, 1.2e-6});
        r.run.send(r.c.run.duration);
        QCOMPARE(r.time.size(), std::size_t(11));
        for (std::size_t n = 0; n < r.time.size(); ++n) {
            QVERIFY(std::abs(r.time[n] - 0.1e-6 * double(n)) < 1e-18);
            const SliderMotion m = polynomial(r.time[n]);
            QVERIFY(std::abs(r.value("height", n) - m.q[0]) < 1e-19);
            QVERIFY(std::abs(r.value("pitch", n) - m.q[1]) < 1e-15);
            QVERIFY(std::abs(r.value("roll", n) - m.q[2]) < 1e-17);
            QVERIFY(std::abs(r.value("vertical_velocity", n) - m.v[0]) < 1e-13);
            // Forces are linear between the ends of steps: these are linear everywhere.
            QVERIFY(std::abs(r.value("air_bearing_force", n) - (15e-3 + 2e3 * r.time[n])) < 1e-15);
            QVERIFY(std::abs(r.value("net_contact_force", n) - (4e3 * r.time[n] - 1e-3)) < 1e-15);
        }
        // Of the steps in which they lie: to 0.35, 0.4, 0.95 and 1.2 us.
        QVERIFY(std::abs(r.value("time_step", 1) - 0.31e-6) < 1e-18);
        QVERIFY(std::abs(r.value("time_step", 4) - 0.05e-6) < 1e-18);
        QVERIFY(std::abs(r.value("time_step", 5) - 0.55e-6) < 1e-18);
        QVERIFY(std::abs(r.value("time_step", 10) - 0.25e-6) < 1e-18);
    }
    /// At the start: mass centre 90 nm, pitch 150 urad, roll 1 urad. The point of interest, at 1.2 mm in the middle, is
    /// 90 nm + 150 urad (0.625 - 1.2) mm = 3.75 nm high; the pad's outer corner, 0.1 mm outside, 0.1 nm less.
    void heights()
    {
        Recording r(plainSlider());
        r.record({1e-6});
        r.run.send(r.c.run.duration);
        QVERIFY(std::abs(r.value("flying_height", 0) - 3.75e-9) < 1e-20);
        QVERIFY(std::abs(r.value("minimum_spacing", 0) - 3.65e-9) < 1e-13); // edges are taken 0.1 nm beside them
    }
    /// The final values are those at the duration, which the last step passes; the end's time is the duration.
    void finalValuesAtTheDuration()
    {
        Recording r(plainSlider());
        r.record({0.5e-6, 1.1e-6});
        r.run.send(r.c.run.duration);
        const Summary summary = r.recorder.summary({});
        QCOMPARE(summary.endTime, 1e-6);
        const auto height =
            std::ranges::find(summary.final, std::string("height"), &std::pair<std::string, double>::first);
        QVERIFY(height != summary.final.end());
        QVERIFY(std::abs(height->second - polynomial(1e-6).q[0]) < 1e-19);
    }
    /// Forces jump where a contact's law switches; the motion does not. A sample after it starts from the new force.
    void forcesJump()
    {
        Recording r(plainSlider());
        r.record({0.25e-6});
        FilmPoint after = pointAt(0.25e-6, 0.25e-6);
        after.contact.adhesion = -3e-3;
        r.recorder.jump(after);
        FilmPoint end = pointAt(0.45e-6, 0.2e-6);
        end.contact.adhesion = -3e-3;
        r.recorder.add(end);
        r.run.send(r.c.run.duration);
        QCOMPARE(r.time.size(), std::size_t(5));
        QVERIFY(std::abs(r.value("adhesion_force", 2) - -1e-3) < 1e-18);
        QVERIFY(std::abs(r.value("adhesion_force", 3) - -3e-3) < 1e-18);
        QVERIFY(std::abs(r.value("height", 3) - polynomial(0.3e-6).q[0]) < 1e-19);
    }
    /// The balance closes where the energy gained is the change of the energy; an imbalance counts against the part
    /// that changed most.
    void reportsTheEnergyImbalance()
    {
        Case c = plainSlider();
        c.suspension.stiffness = c.suspension.pitchStiffness = c.suspension.rollStiffness = 0.0;
        for (const double missing : {0.0, 0.02}) {
            Recording r(c);
            FilmPoint start, end;
            start.motion.q = end.motion.q = polynomial(0.0).q;
            end.time = 1e-6;
            end.filmEnergy = 1e-12;
            end.gained = (1.0 - missing) * 1e-12;
            r.recorder.begin(start);
            r.recorder.add(end);
            QVERIFY(std::abs(r.recorder.energyImbalance() - missing) < 1e-9);
        }
    }
    void tellsEventsOnce()
    {
        Recording r(plainSlider());
        r.record({0.5e-6});
        r.run.addEvent(0.5e-6, "touch-down");
        r.run.send(r.c.run.duration);
        r.run.send(r.c.run.duration);
        QCOMPARE(r.events.size(), std::size_t(1));
        QCOMPARE(r.events[0].name, std::string("touch-down"));
        QCOMPARE(r.time.size(), std::size_t(6));
        const Summary summary = r.recorder.summary({});
        QCOMPARE(summary.events.size(), std::size_t(1));
    }
    void stopsWhenAsked()
    {
        Recording r(plainSlider());
        r.callsUntilStop = 1;
        r.record({0.5e-6});
        QVERIFY(!r.run.stopped());
        r.run.send(r.c.run.duration);
        QVERIFY(r.run.stopped());
        QVERIFY(!r.run.lookAtClock(0.0));
    }
};

TOUCHDOWN_TEST(TestFilmRecorder)

} // namespace test_film_recorder

#include "test_film_recorder.moc"

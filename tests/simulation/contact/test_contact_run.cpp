// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/contact/contact_run.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QTest>

#include "core/case/parameters.h"
#include "core/case_files/case_file.h"
#include "core/formats/units.h"
#include "core/physics/contact/contact_bodies.h"
#include "core/simulation/contact/pad_way.h"
#include "core/simulation/run.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_contact_run {

Case sample(const char* name)
{
    const CaseDocument document = openCase(name);
    if (!document.valid()) qFatal("%s", document.problems.front().text().c_str());
    return document.value;
}

/// All that a run tells.
struct Trace {
    Summary summary;
    std::vector<Quantity> quantities;
    SampleBatch samples;
    std::vector<FieldSnapshot> fields;
    std::vector<RunEvent> events;
    bool finite = true;

    explicit Trace(const Case& c, std::size_t stopAfter = ~std::size_t{0}) : quantities(recordedQuantities(c))
    {
        samples.columns.resize(quantities.size());
        summary = run(c, [&](const RunUpdate& update) {
            samples.time.insert(samples.time.end(), update.samples.time.begin(), update.samples.time.end());
            for (std::size_t i = 0; i < quantities.size(); ++i)
                for (const double value : update.samples.columns[i]) {
                    samples.columns[i].push_back(value);
                    finite = finite && std::isfinite(value);
                }
            fields.insert(fields.end(), update.fields.begin(), update.fields.end());
            events.insert(events.end(), update.events.begin(), update.events.end());
            return samples.size() < stopAfter;
        });
    }
    const std::vector<double>& column(const char* name) const
    {
        return samples.columns[static_cast<std::size_t>(findQuantity(quantities, name))];
    }
};

double figure(const Summary& summary, const char* name)
{
    const auto found = std::ranges::find(summary.figures, name, [](const RunFigure& f) { return f.quantity.name; });
    return found == summary.figures.end() ? NAN : found->value;
}

/// A sphere on a small patch.
Case smallSphere()
{
    Case c = sample("contact_hertz");
    c.elastic.cell = 0.25e-6;
    c.run.sampleInterval = c.run.duration / 40.0;
    c.run.fieldSnapshots = 5;
    return c;
}

class TestContactRun : public QObject {
    Q_OBJECT

private slots:
    /// F = (4/3) E* sqrt(R d^3), a^2 = R d, p_0 = 3 F/(2 pi a^2) (Hertz), on cells of a/25.
    void hertz()
    {
        const Case c = sample("contact_hertz");
        const Trace trace(c);
        QCOMPARE(trace.summary.status, RunStatus::Completed);
        QVERIFY(trace.finite);
        QCOMPARE(trace.samples.size(), std::size_t{401});
        const double modulus = contactModulus(c.elastic.pair);
        const double depth = 10e-9, radius = c.pad.radius;
        const double force = 4.0 / 3.0 * modulus * std::sqrt(radius * depth) * depth;
        QVERIFY(std::abs(trace.column("contact_force")[200] / force - 1.0) < 1e-3);
        QVERIFY(
            std::abs(trace.column("peak_contact_pressure")[200] / (1.5 * force / (std::numbers::pi * radius * depth)) -
                     1.0) < 2e-3);
        QVERIFY(std::abs(trace.column("contact_area")[200] / (std::numbers::pi * radius * depth) - 1.0) < 0.02);
        QVERIFY(std::abs(trace.column("friction_force")[200] - 0.3 * trace.column("contact_force")[200]) < 1e-15);
        QCOMPARE(findQuantity(trace.quantities, "adhesion_force"), -1);
        QCOMPARE(figure(trace.summary, "largest_contact_force"), trace.column("contact_force")[200]);
        QVERIFY(std::isnan(figure(trace.summary, "pull_off_force")));
        // Nothing is kept: the way out is the way in. Gaps may be wrong by 1e-8 of 10 nm, and so the pressures by as
        // much times the stiffness E* pi/(2 cell) of the shortest waves, 110 Pa or 1e-6 of the mean pressure, either
        // way.
        for (std::size_t i = 0; i < 200; ++i)
            QVERIFY(std::abs(trace.column("contact_force")[i] - trace.column("contact_force")[400 - i]) < 2e-6 * force);
        QCOMPARE(trace.summary.tail.size(), std::size_t{2});
        QVERIFY(trace.summary.verdict.motion == Motion::NotJudged && trace.summary.peaks.empty());
        QCOMPARE(trace.summary.model, std::string("contact"));
    }

    void snapshots()
    {
        const Case c = smallSphere();
        QCOMPARE(recordedFields(c).size(), std::size_t{1});
        const RecordedFields fields = recordedFields(c).front();
        QCOMPARE(fields.group, std::string("fields"));
        QCOMPARE(fields.quantities.size(), std::size_t{2});
        QCOMPARE(fields.grid.nx(), 32);
        const Trace trace(c);
        // At 0, 0.5, 1, 1.5 and 2 ms, the closest approach among them.
        QCOMPARE(trace.fields.size(), std::size_t{5});
        QCOMPARE(trace.fields[2].time, 1e-3);
        for (const FieldSnapshot& snapshot : trace.fields) {
            QCOMPARE(snapshot.values.size(), fields.quantities.size());
            for (const auto& values : snapshot.values) QCOMPARE(values.size(), fields.grid.cells());
        }
        double force = 0.0;
        for (const double p : trace.fields[2].values[1]) force += p * 0.25e-6 * 0.25e-6;
        QVERIFY(std::abs(force / trace.column("contact_force")[20] - 1.0) < 1e-12);
    }
    /// Where no sample falls onto it, and though one snapshot alone is asked for.
    void closestIsAlwaysRecorded()
    {
        Case c = smallSphere();
        c.run.sampleInterval = c.run.duration / 7.0;
        c.run.fieldSnapshots = 1;
        const Trace trace(c);
        QCOMPARE(trace.samples.size(), std::size_t{8});
        QCOMPARE(trace.fields.size(), std::size_t{2});
        QCOMPARE(trace.fields.back().time, 1e-3);
        c.run.fieldSnapshots = 0;
        QVERIFY(Trace(c).fields.empty());
        QVERIFY(recordedFields(c).empty());
    }

    void saysWhereTheWayIsTooShort()
    {
        Case c = smallSphere();
        c.approach = {-1e-9, -2e-9};
        QCOMPARE(run(c).warnings, std::vector<std::string>{"the surfaces touch at approach.start already"});
        c = sample("contact_adhesion");
        c.approach.start = 2e-9; // it snaps in at 1.5 nm and holds to 2.6 nm
        c.run.sampleInterval = c.run.duration / 40.0;
        const Summary held = run(c);
        QCOMPARE(held.status, RunStatus::Completed);
        QCOMPARE(held.warnings.size(), std::size_t{1});
        QVERIFY2(held.warnings[0].starts_with("the surfaces still touch back at approach.start"),
                 held.warnings[0].c_str());
    }
    void nothingTouches()
    {
        Case c = smallSphere();
        c.approach.closest = 1e-9;
        const Trace trace(c);
        QCOMPARE(trace.summary.evaluations, 0LL);
        QCOMPARE(figure(trace.summary, "largest_contact_force"), 0.0);
    }

    /// Down through d_s = 3 nm and up through d_e = 5 nm, 6 nm -> 1 nm -> 6 nm in 2 ms: at 0.6 and at 1.8 ms.
    void characteristic()
    {
        const Case c = sample("contact_ono_yamane");
        const Trace trace(c);
        QCOMPARE(trace.events.size(), std::size_t{2});
        QCOMPARE(trace.events[0].name, std::string("touch-down"));
        QVERIFY(std::abs(trace.events[0].time - 0.6e-3) < 1e-15);
        QCOMPARE(trace.events[1].name, std::string("take-off"));
        QVERIFY(std::abs(trace.events[1].time - 1.8e-3) < 1e-15);
        // f_c0 + k_c 2 nm at 1 nm; at 4 nm nothing on the way in, the menisci alone on the way out.
        QVERIFY(std::abs(trace.column("contact_force")[200] - 15e-3) < 1e-12);
        QCOMPARE(trace.column("net_contact_force")[80], 0.0);
        QVERIFY(std::abs(trace.column("net_contact_force")[322] + 10e-3) < 1e-12);
        QVERIFY(trace.fields.empty());
        QVERIFY(std::abs(figure(trace.summary, "pull_off_force") - 10e-3) < 1e-12);
    }
    /// f_m = 10 mN, k_c = 5e6 N/m, f_c0 = 5 mN, d_s = 3 nm: F_cr ends at 4 nm, if the menisci do not break before. The
    /// strongest pull is there or at d_s or d_e, wherever the samples are.
    void pullOff_data()
    {
        QTest::addColumn<QString>("shape");
        QTest::addColumn<double>("takeOff"); // [nm]
        QTest::addColumn<double>("force");   // [mN]
        QTest::addColumn<double>("place");   // [nm]
        QTest::newRow("F_cr still presses at d_e") << "constant" << 3.31 << 10.0 - (5.0 - 5.0 * 0.31) << 3.31;
        QTest::newRow("both end at once") << "constant" << 3.0 << 10.0 - 5.0 << 3.0;
        QTest::newRow("menisci alone") << "constant" << 5.1 << 10.0 << 4.0;
        QTest::newRow("falling menisci") << "linear" << 5.5 << 10.0 * (5.5 - 4.0) / (5.5 - 3.0) << 4.0;
        QTest::newRow("both fall") << "both-linear" << 5.5 << 10.0 - 5.0 << 3.0;
    }
    void pullOff()
    {
        QFETCH(const QString, shape);
        QFETCH(const double, takeOff);
        QFETCH(const double, force);
        QFETCH(const double, place);
        Case c = sample("contact_ono_yamane");
        c.onoYamane.takeOff = takeOff * 1e-9;
        c.onoYamane.takeOffShape =
            TakeOffShape(std::ranges::find(takeOffShapeNames, shape.toStdString()) - takeOffShapeNames.begin());
        for (const double interval : {3e-6, 37e-6, 310e-6}) {
            c.run.sampleInterval = interval;
            const Summary summary = run(c);
            QVERIFY(std::abs(figure(summary, "pull_off_force") - force * 1e-3) < 1e-14);
            QVERIFY(std::abs(figure(summary, "pull_off_separation") - place * 1e-9) < 1e-20);
        }
    }
    /// As its own test has it: the fit belongs to the summary, and its curve lies beside the full one.
    void multiAsperity()
    {
        const Trace trace(sample("contact_ono_yamane_full"));
        QVERIFY(trace.summary.fit.has_value());
        QVERIFY(trace.summary.fit->describes);
        QVERIFY(trace.summary.warnings.empty());
        QCOMPARE(trace.events.size(), std::size_t{2});
        double worst = 0.0, largest = 0.0;
        for (std::size_t i = 0; i < trace.samples.size(); ++i) {
            worst =
                std::max(worst, std::abs(trace.column("contact_force")[i] - trace.column("fitted_contact_force")[i]));
            largest = std::max(largest, trace.column("contact_force")[i]);
        }
        QVERIFY(worst <= (trace.summary.fit->contact.worst + 1e-3) * largest);

        Case c = sample("contact_ono_yamane_full");
        c.asperity.heightDeviation = 1e-9;
        const Summary poor = run(c);
        QVERIFY(!poor.fit->describes);
        QCOMPARE(poor.warnings, std::vector{poor.fit->message});
    }
    void asperities()
    {
        const Trace trace(sample("contact_greenwood_williamson"));
        QCOMPARE(trace.summary.status, RunStatus::Completed);
        const auto& force = trace.column("contact_force");
        QVERIFY(std::ranges::is_sorted(force.begin(), force.begin() + 201));
        QVERIFY(force[200] > 0.0 && force[0] < 1e-3 * force[200]);
    }

    /// A wave of 4 um under a disk of 1 m/s: after 4 us it is where it was, after 2 us its crests are troughs.
    void surfaceMovesWithTheDisk()
    {
        Case c = sample("contact_waves");
        c.diskSurface.waveAmplitudes = {1e-9};
        c.diskSurface.waveLengths = {4e-6};
        c.diskSurface.waveAngles = {0.0};
        c.disk.speed = 1.0 / c.disk.radius;
        c.run.duration = 16e-6;
        c.run.sampleInterval = 2e-6;
        c.run.fieldSnapshots = 9;
        const Trace trace(c);
        const auto surface = [&](std::size_t k) { return trace.fields[k].values.back(); };
        for (std::size_t i = 0; i < surface(0).size(); ++i) {
            QVERIFY(std::abs(surface(2)[i] - surface(0)[i]) < 1e-18);
            QVERIFY(std::abs(surface(1)[i] + surface(0)[i]) < 1e-18);
        }
        c.diskSurface.motion = SurfaceMotion::Still;
        const Trace still(c);
        QCOMPARE(still.fields[1].values.back(), still.fields[0].values.back());
        QVERIFY(std::abs(figure(still.summary, "surface_rms") - 1e-9 / std::sqrt(2.0)) < 1e-14);
    }

    void stops()
    {
        const Case c = smallSphere();
        Case many = c;
        many.run.sampleInterval = c.run.duration / 5000.0;
        const Trace trace(many, 1);
        QCOMPARE(trace.summary.status, RunStatus::Cancelled);
        QVERIFY(trace.samples.size() < 5001);
        QVERIFY(trace.summary.message.starts_with("stopped at "));
        QVERIFY(trace.summary.endTime < many.run.duration);
    }

    /// One iteration is too few as soon as something touches; what came before stays.
    void noSolution()
    {
        Case c = smallSphere();
        c.elastic.maximumIterations = 1;
        const Trace trace(c);
        QCOMPARE(trace.summary.status, RunStatus::Failed);
        QVERIFY2(trace.summary.message.starts_with("no contact state was found at "), trace.summary.message.c_str());
        // From 5 nm at 15 nm/ms the first touch comes after a third of a millisecond.
        QCOMPARE(trace.samples.size(), std::size_t{7});
        QVERIFY(trace.finite);
        QCOMPARE(trace.summary.endTime, trace.samples.time.back());
        QVERIFY(trace.summary.message.find(" after " + fewDigitsOfTime(trace.summary.endTime, 4) + ":") !=
                std::string::npos);
        QVERIFY(trace.samples.time.back() < 1e-3);
    }

    /// The pull of an adhesive sphere lies between (3/2) pi R dgamma (Johnson, Kendall & Roberts) and 2 pi R dgamma
    /// (Derjaguin, Muller & Toporov); on the way in it snaps nearer than it lets go.
    void snapsInAndPullsOff()
    {
        Case c = sample("contact_pull_off");
        c.approach = {13e-9, 3e-9};
        c.run.sampleInterval = 50e-6;
        c.run.fieldSnapshots = 0;
        const Trace trace(c);
        QCOMPARE(trace.summary.status, RunStatus::Completed);
        const double unit = std::numbers::pi * c.pad.radius * c.adhesion.surfaceEnergy;
        const double pull = figure(trace.summary, "pull_off_force");
        QVERIFY2(pull > 1.45 * unit && pull < 2.0 * unit, std::to_string(pull / unit).c_str());
        const auto has = [&](const char* name) { return std::ranges::find(trace.events, name, &RunEvent::name); };
        QVERIFY(has("snap-in") != trace.events.end());
        QVERIFY(has("pull-off") != trace.events.end());
        QVERIFY(padSeparation(c, has("pull-off")->time) > padSeparation(c, has("snap-in")->time));
        QVERIFY(std::ranges::all_of(trace.column("adhesion_force"), [](double force) { return force <= 0.0; }));
        QVERIFY(trace.summary.warnings.empty());
    }
    /// Snap-in, pull-off and the strongest pull do not depend on where the samples lie: jumps are located to 1 pm, the
    /// flat maximum of the pull to some pm, its value to 1e-5 of itself, and the loop's work by the energies.
    void samplesDecideNothing()
    {
        const char* const names[] = {"pull_off_force", "pull_off_separation", "snap_in_separation",
                                     "release_separation", "loop_work"};
        std::vector<double> least(5, INFINITY), most(5, -INFINITY);
        for (const double interval : {10.0, 13.0, 17.0, 20.0, 25.0, 29.0, 30.0, 37.0, 43.0, 50.0}) {
            Case c = sample("contact_pull_off");
            c.pad.length = c.pad.width = 1.5e-6;
            c.approach = {13e-9, 3e-9};
            c.run.sampleInterval = 2.0 * interval * 1e-6;
            c.run.fieldSnapshots = 0;
            const Summary summary = run(c);
            for (std::size_t i = 0; i < 5; ++i) {
                const double value = figure(summary, names[i]);
                least[i] = std::min(least[i], value);
                most[i] = std::max(most[i], value);
            }
        }
        QVERIFY2(most[0] - least[0] < 1e-5 * most[0], qPrintable(QString::number(most[0] - least[0])));
        QVERIFY2(most[1] - least[1] < 10e-12, qPrintable(QString::number(most[1] - least[1])));
        QVERIFY2(most[2] - least[2] < 2e-12, qPrintable(QString::number(most[2] - least[2])));
        QVERIFY2(most[3] - least[3] < 2e-12, qPrintable(QString::number(most[3] - least[3])));
        QVERIFY2(most[4] - least[4] < 2e-3 * most[4], qPrintable(QString::number(most[4] - least[4])));
    }
    /// Elastic contact with adhesion loses energy in its jumps alone: the area of the loop, from the forces, is what
    /// the jumps lose, from the energies.
    void theLoopIsLostInJumps()
    {
        Case c = sample("contact_adhesion");
        c.run.sampleInterval = 2e-6;
        c.run.fieldSnapshots = 0;
        const Trace trace(c);
        const std::vector<double>&d = trace.column("minimum_spacing"), &force = trace.column("net_contact_force");
        double loop = 0.0; // by the trapezoidal rule through the samples
        for (std::size_t i = 1; i < d.size(); ++i) loop -= 0.5 * (force[i] + force[i - 1]) * (d[i] - d[i - 1]);
        QVERIFY(loop > 0.1e-12);
        QVERIFY2(std::abs(figure(trace.summary, "loop_work") / loop - 1.0) < 1e-2,
                 qPrintable(QString("%1 %2").arg(figure(trace.summary, "loop_work")).arg(loop)));
    }
    /// With a Tabor number of (R dgamma^2/(E*^2 z_0^3))^(1/3) = 0.22 the sphere keeps its shape: it neither snaps nor
    /// jumps, and its pull is near 2 pi R dgamma, less what it yields.
    void stiffSphereDoesNotSnap()
    {
        Case c = sample("contact_pull_off");
        c.pad.radius = 2e-6;
        c.pad.length = c.pad.width = 0.512e-6;
        c.elastic.cell = 8e-9;
        c.elastic.pair.diskModulus = 100e9;
        c.elastic.pair.diskPoissonRatio = 0.25;
        c.adhesion.equilibriumDistance = 0.4e-9;
        c.approach = {3e-9, -0.5e-9};
        const Trace trace(c);
        QCOMPARE(trace.summary.status, RunStatus::Completed);
        QVERIFY(trace.events.empty());
        const double limit = 2.0 * std::numbers::pi * c.pad.radius * c.adhesion.surfaceEnergy;
        QVERIFY(figure(trace.summary, "pull_off_force") > 0.93 * limit);
        QVERIFY(figure(trace.summary, "pull_off_force") < limit);
    }
};

TOUCHDOWN_TEST(TestContactRun)

} // namespace test_contact_run

#include "test_contact_run.moc"

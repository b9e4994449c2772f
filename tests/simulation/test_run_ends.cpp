// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every number of a case at both ends of its range: a run, a static state and modes end with numbers or with a cause.
#include "core/simulation/run.h"

#include <cmath>

#include <QTest>

#include "core/case/parameters.h"
#include "core/simulation/static_state/steady.h"
#include "tests/support/sample_case.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_run_ends {

/// The case with a number at an end of its range, the next number inside where the end itself is not allowed.
Case atEnd(Case c, const Parameter& parameter, bool upper)
{
    const double end = upper ? parameter.maximum : parameter.minimum,
                 inside = !upper && !parameter.minimumAllowed ? std::nextafter(end, parameter.maximum) : end;
    if (const auto problem = setFromNumber(c, parameter, inside))
        qFatal("%s: %s", parameter.key.c_str(), problem->c_str());
    return c;
}

/// Why the case is not run; empty when it is.
std::string refusal(const Case& c)
{
    const std::vector<CaseProblem> problems = checkCombinations(c);
    return problems.empty() ? reasonNotToRun(c) : problems.front().key + ": " + problems.front().message;
}

bool isFinite(const Summary& summary)
{
    bool finite = std::isfinite(summary.endTime);
    for (const auto& [quantity, value] : summary.final) finite = finite && std::isfinite(value);
    for (const auto& [quantity, part] : summary.tail)
        finite = finite && std::isfinite(part.mean) && std::isfinite(part.std) && std::isfinite(part.min) &&
                 std::isfinite(part.max);
    for (const RunFigure& figure : summary.figures) // an error may be not known
        finite = finite && (std::isfinite(figure.value) || figure.quantity.name.ends_with("_error"));
    return finite;
}

class TestRunEnds : public QObject {
    Q_OBJECT

private slots:
    void everyNumber_data()
    {
        QTest::addColumn<QString>("sample");
        QTest::addColumn<double>("duration"); // [s]; of a pad none
        QTest::addColumn<bool>("withModes");
        for (const char* name : {"fig10a", "textbook_bounce"}) QTest::newRow(name) << name << 2e-6 << false;
        for (const char* name : {"film_pico", "advise_waviness", "fig08_start_10nm"})
            QTest::newRow(name) << name << 0.03e-6 << (name == std::string("film_pico"));
        for (const char* name : {"contact_hertz", "contact_rough", "contact_greenwood_williamson", "contact_ono_yamane",
                                 "contact_ono_yamane_full"})
            QTest::newRow(name) << name << 0.0 << false;
    }
    void everyNumber()
    {
        QFETCH(QString, sample);
        QFETCH(double, duration);
        QFETCH(bool, withModes);
        Case base = touchdown::sample(sample.toStdString());
        if (duration > 0.0) base.run.duration = duration;
        base.run.sampleInterval = 0.25 * base.run.duration;
        if (base.pad.shape == PadShape::Sphere) base.elastic.cell = base.pad.length / 16;
        base.film.nodes = {17, 17};
        base.run.fieldSnapshots = 0;
        QVERIFY2(refusal(base).empty(), refusal(base).c_str());
        for (const Parameter& parameter : parameters()) {
            if (parameter.kind != ParameterKind::Number && parameter.kind != ParameterKind::Integer) continue;
            if (!parameter.used(base)) continue;
            for (const bool upper : {false, true}) {
                if (!std::isfinite(upper ? parameter.maximum : parameter.minimum)) continue;
                const Case c = atEnd(base, parameter, upper);
                if (!refusal(c).empty()) continue;
                const Summary summary = run(c);
                const std::string what = parameter.key + (upper ? ", upper end: " : ", lower end: ") + summary.message;
                QVERIFY2(summary.status == RunStatus::Completed || !summary.message.empty(), what.c_str());
                QVERIFY2(isFinite(summary), what.c_str());
                if (c.model != ModelKind::Film || !withModes) continue;
                const ModesResult found = modes(c);
                QVERIFY2(found.status == SteadyStatus::Converged || !found.message.empty(), what.c_str());
                QVERIFY2(std::isfinite(found.steady.attitude.height) || !found.message.empty(), what.c_str());
                for (const AirBearingMode& mode : found.modes)
                    QVERIFY2(std::isfinite(mode.frequency) && std::isfinite(mode.dampingRatio), what.c_str());
            }
        }
    }

    /// A disk so rough that its contact pushes with 10 kN.
    void noNumbersAtTheStart()
    {
        Case c = touchdown::sample("fig02_case_2_moving");
        c.film.nodes = {17, 17};
        c.diskSurface.rms = 1e-3;
        const Summary summary = run(c);
        QCOMPARE(summary.status, RunStatus::Failed);
        QVERIFY2(summary.message.starts_with("the forces at the start are no numbers"), summary.message.c_str());
        QVERIFY(isFinite(summary));
    }
};

TOUCHDOWN_TEST(TestRunEnds)

} // namespace test_run_ends

#include "test_run_ends.moc"

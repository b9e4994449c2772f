// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/runs/reading.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <QTest>

#include "core/numerics/moments.h"
#include "core/simulation/run.h"
#include "core/simulation/static_state/steady.h"
#include "tests/support/sample_case.h"
#include "tests/support/small_slider.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_reading {

Reading reading(Calculation calculation, const Case& c, const std::string& quantity, const std::string& at = "")
{
    const auto found = findReading(calculation, c, quantity, at);
    if (const auto* problem = std::get_if<std::string>(&found)) qFatal("%s", problem->c_str());
    return std::get<Reading>(found);
}

double number(const StudyValue& value)
{
    const double* number = std::get_if<double>(&value);
    return number == nullptr ? NAN : *number;
}

std::optional<CaseReadings> readingsOf(const Case& c, Calculation calculation, const std::vector<Reading>& readings,
                                       const GoOn& goOn = {})
{
    const ShareTeller tell;
    ItemCall call{goOn, tell};
    return readCase(c, calculation, readings, call);
}

class TestReading : public QObject {
    Q_OBJECT

private slots:
    /// Against the samples and the summary of the same run.
    void ofARun()
    {
        Case c = sample("fig13a");
        c.run.duration = 0.3e-3;
        std::vector<Reading> readings;
        for (const char* at : {"end", "tail", "swing", "rms", "mean", "least", "most"})
            readings.push_back(reading(Calculation::Run, c, "flying_height", at));
        for (const char* name : {"motion", "flies", "caught", "bounces", "steps", "touch_downs", "first_touch_down"})
            readings.push_back(reading(Calculation::Run, c, name));
        const auto found = readingsOf(c, Calculation::Run, readings);
        QVERIFY(found.has_value());
        QCOMPARE(found->problem, std::string());

        std::vector<double> heights, tail;
        const int column = findQuantity(recordedQuantities(c), "flying_height");
        c.run.stepCheck = false;
        c.run.fieldSnapshots = 0;
        const Summary summary = run(c, [&](const RunUpdate& update) {
            for (std::size_t i = 0; i < update.samples.size(); ++i) {
                heights.push_back(update.samples.columns[std::size_t(column)][i]);
                if (update.samples.time[i] >= 0.9 * c.run.duration) tail.push_back(heights.back());
            }
            return true;
        });
        QCOMPARE(number(found->values[0]), heights.back());
        QCOMPARE(number(found->values[1]), momentsOf(tail).mean);
        QCOMPARE(number(found->values[3]), momentsOf(tail).deviation);
        QCOMPARE(number(found->values[4]), momentsOf(heights).mean);
        const auto [least, most] = std::ranges::minmax(heights);
        QVERIFY(number(found->values[5]) <= least && number(found->values[6]) >= most);
        QVERIFY(number(found->values[2]) >= std::ranges::max(tail) - std::ranges::min(tail));
        QVERIFY(std::get<std::string>(found->values[7]) == name(summary.verdict.motion));
        QVERIFY(number(found->values[8]) + number(found->values[9]) + number(found->values[10]) <= 1.0);
        QCOMPARE(number(found->values[11]), double(summary.steps));
        QCOMPARE(number(found->values[12]),
                 double(std::ranges::count(summary.events, std::string("touch-down"), &RunEvent::name)));
        QVERIFY(number(found->values[13]) > 0.0);
    }

    void ofAStaticState()
    {
        const Case c = smallSlider(33);
        std::vector<Reading> readings{reading(Calculation::Steady, c, "minimum_spacing"),
                                      reading(Calculation::Steady, c, "pitch")};
        readings = withErrors(Calculation::Steady, c, readings);
        QCOMPARE(readings.size(), std::size_t(4));
        QVERIFY(readings[1].isError && readings[3].isError);
        const auto found = readingsOf(c, Calculation::Steady, readings);
        const SteadyResult state = steady(c);
        QCOMPARE(number(found->values[0]), state.minimumSpacing);
        QCOMPARE(number(found->values[1]), state.discretisationError.minimumSpacing);
        QCOMPARE(number(found->values[2]), state.attitude.pitch);
    }

    void ofModes()
    {
        const Case c = smallSlider(17);
        const std::vector<Reading> readings{
            reading(Calculation::Modes, c, "mode_1_frequency"), reading(Calculation::Modes, c, "mode_2_damping_ratio"),
            reading(Calculation::Modes, c, "mode_1_kind"), reading(Calculation::Modes, c, "roll")};
        const auto found = readingsOf(c, Calculation::Modes, readings);
        const ModesResult result = modes(c);
        QCOMPARE(number(found->values[0]), result.modes[0].frequency);
        QCOMPARE(number(found->values[1]), result.modes[1].dampingRatio);
        QCOMPARE(std::get<std::string>(found->values[2]), result.modes[0].kind);
        QCOMPARE(number(found->values[3]), result.steady.attitude.roll);
    }

    /// Everything that the table offers has a value or is known to have none, for each model.
    void allOfTheTable_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"fig13a", "springs_waviness", "contact_hertz", "contact_ono_yamane"})
            QTest::addRow("%s", name) << QString(name);
    }
    void allOfTheTable()
    {
        QFETCH(QString, name);
        Case c = sample(name.toStdString());
        if (c.model == ModelKind::Springs) c.run.duration = 0.1e-3;
        std::vector<Reading> readings;
        std::set<std::string> names;
        for (const ReadableQuantity& each : readableQuantities(Calculation::Run, c)) {
            QVERIFY2(names.insert(each.quantity.name).second, each.quantity.name.c_str());
            readings.push_back(reading(Calculation::Run, c, each.quantity.name));
            QVERIFY(!readings.back().column().longName.empty());
        }
        const auto found = readingsOf(c, Calculation::Run, readings);
        QCOMPARE(found->problem, std::string());
        QCOMPARE(found->values.size(), readings.size());
        for (std::size_t i = 0; i < readings.size(); ++i)
            if (const double* value = std::get_if<double>(&found->values[i])) QVERIFY(std::isfinite(*value));
        const auto known = std::ranges::count_if(
            found->values, [](const StudyValue& value) { return !std::holds_alternative<std::monostate>(value); });
        QVERIFY2(known > std::ptrdiff_t(readings.size()) / 2, qPrintable(QString::number(known)));
    }

    /// The reference has each name that a case has.
    void theReference()
    {
        // A name may be a value over time of a run and one number of a static state: pitch.
        std::set<std::pair<std::string, bool>> names;
        for (const ReadingRow& row : allReadings()) {
            QVERIFY(!row.where.empty());
            QVERIFY2(names.emplace(row.what.quantity.name, row.what.overTime).second, row.what.quantity.name.c_str());
        }
        QVERIFY(names.contains({"pitch", true}) && names.contains({"pitch", false}));
        for (const char* name : {"fig13a", "springs_waviness", "contact_hertz", "contact_ono_yamane", "film_femto",
                                 "contact_adhesion", "film_fig4_pico"}) {
            const Case c = sample(name);
            for (const Calculation calculation : {Calculation::Run, Calculation::Steady, Calculation::Modes}) {
                if (calculation != Calculation::Run && c.model != ModelKind::Film) continue;
                for (const ReadableQuantity& each : readableQuantities(calculation, c))
                    QVERIFY2(names.contains({each.quantity.name, each.overTime}), each.quantity.name.c_str());
            }
        }
    }

    void whatFailsIsAReason()
    {
        Case c = sample("fig10a");
        c.onoYamane.takeOff = 0.5 * c.onoYamane.touchDown;
        const std::vector<Reading> readings{reading(Calculation::Run, c, "flying_height", "end")};
        const auto refused = readingsOf(c, Calculation::Run, readings);
        QVERIFY2(refused->problem.starts_with("ono_yamane."), refused->problem.c_str());
        QVERIFY(std::holds_alternative<std::monostate>(refused->values[0]));
        QVERIFY(!readingsOf(sample("fig10a"), Calculation::Run, readings, [] { return false; }).has_value());
    }

    void wrongNamesAreHelped()
    {
        const Case c = sample("fig10a");
        const auto of = [&](const char* quantity, const char* at) {
            return std::get<std::string>(findReading(Calculation::Run, c, quantity, at));
        };
        const std::string unknown = of("flying_hight", "");
        QVERIFY2(unknown.find("did you mean flying_height?") != std::string::npos, unknown.c_str());
        QCOMPARE(of("pitch", "start"),
                 std::string("at = \"start\" is none of end, tail, swing, rms, mean, least, most"));
        QCOMPARE(of("motion", "end"), std::string("\"motion\" is one number, so that `at` has no meaning"));
    }
};

TOUCHDOWN_TEST(TestReading)

} // namespace test_reading

#include "test_reading.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/hysteresis/held_steps.h"

#include <cmath>

#include <QTest>

#include "core/studies/study/study_reader.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_held_steps {

Parameter keyOf(const Case& c, const char* key) { return std::get<Parameter>(numberKey(c, key)); }

HeldSteps heights(std::vector<double> values)
{
    HeldSteps steps;
    steps.parameter = keyOf(steps.start, "springs.flying_height");
    steps.values = std::move(values);
    return steps;
}

class TestHeldSteps : public QObject {
    Q_OBJECT

private slots:
    /// A run goes on where the one before ended: two holds of a value are one of twice the time, but for the tolerance.
    void oneRunInTwoParts()
    {
        HeldSteps steps;
        steps.start.contact = noContact;
        steps.start.initial.flyingHeight = 12e-9;
        steps.start.initial.pitch = 95e-6;
        steps.start.run.tolerance = 1e-11;
        steps.parameter = keyOf(steps.start, "springs.flying_height");
        steps.hold = 30e-6;
        std::vector<std::string> warnings;
        HeldEnd half, whole;
        holdValue(steps, 7e-9, half, warnings, {});
        holdValue(steps, 7e-9, half, warnings, {});
        steps.hold = 60e-6;
        holdValue(steps, 7e-9, whole, warnings, {});
        for (const char* name : {"flying_height", "pitch", "vertical_velocity", "pitch_velocity"}) {
            const auto value = [&](const HeldEnd& end) {
                for (const auto& [quantity, number] : end.summary.final)
                    if (quantity == name) return number;
                return std::nan("");
            };
            // It rings by nanometres and mm/s: parts in 1e7 of that.
            QVERIFY2(std::abs(value(half) - value(whole)) <= 1e-6 * std::abs(value(whole)), name);
        }
    }

    /// The place over the disk is kept where the pad itself is moved: z = d + d_h theta.
    void positionStays()
    {
        HeldEnd before;
        before.valid = true;
        before.summary.final = {
            {"height", 60e-9}, {"pitch", 90e-6}, {"vertical_velocity", 1e-3}, {"pitch_velocity", -2.0}};
        Case next;
        next.springs.padDistance = 0.5e-3;
        carryOver(next, before);
        QVERIFY(std::abs(next.initial.flyingHeight - 15e-9) < 1e-22);
        QCOMPARE(next.initial.verticalVelocity, 1e-3);
        QCOMPARE(next.initial.pitchVelocity, -2.0);

        next.model = ModelKind::Film;
        before.summary.final.emplace_back("roll", 1e-6);
        carryOver(next, before);
        // The trailing edge is half of 1.25 mm behind the mass centre.
        QVERIFY(std::abs(next.initial.nominalTrailingEdgeHeight - (60e-9 - 0.625e-3 * 90e-6)) < 1e-22);
        QCOMPARE(next.initial.state, InitialState::Given);
        QCOMPARE(next.initial.roll, 1e-6);
    }

    void branchIsKept_data()
    {
        QTest::addColumn<double>("adhesion");
        QTest::addColumn<QString>("event");
        QTest::addColumn<double>("start");
        QTest::addColumn<ContactBranch>("given");
        QTest::addColumn<ContactBranch>("expected");
        using enum ContactBranch;
        QTest::newRow("menisci pull") << -1e-3 << "" << 7e-9 << TouchDown << TakeOff;
        QTest::newRow("took off") << 0.0 << "take-off" << 4e-9 << TakeOff << TouchDown;
        QTest::newRow("menisci without force") << 0.0 << "held by menisci" << 7e-9 << TouchDown << TakeOff;
        QTest::newRow("a spring was caught") << 0.0 << "rear spring caught" << 4e-9 << TakeOff << TakeOff;
        QTest::newRow("began above d_e") << 0.0 << "" << 5e-9 << TakeOff << TouchDown;
        QTest::newRow("began below d_s") << 0.0 << "" << 3e-9 << TouchDown << TakeOff;
        QTest::newRow("began between") << 0.0 << "" << 4e-9 << TakeOff << TakeOff;
    }
    void branchIsKept()
    {
        QFETCH(double, adhesion);
        QFETCH(QString, event);
        QFETCH(double, start);
        QFETCH(ContactBranch, given);
        QFETCH(ContactBranch, expected);
        HeldEnd before; // d_s = 3 nm, d_e = 5 nm
        before.run.initial.branch = given;
        before.startSpacing = start;
        before.summary.final = {{"contact_force", 0.0}, {"adhesion_force", adhesion}};
        if (!event.isEmpty()) before.summary.events = {{1e-6, event.toStdString()}};
        Case next;
        carryOver(next, before);
        QCOMPARE(next.initial.branch, expected);
    }

    /// Without a characteristic there is no d_s and no d_e that could tell the branch.
    void otherLawsHaveNoBranches()
    {
        for (const double start : {2e-9, 7e-9})
            for (const ContactBranch given : {ContactBranch::TouchDown, ContactBranch::TakeOff}) {
                HeldEnd before;
                before.run.contact = noContact;
                before.run.initial.branch = given;
                before.startSpacing = start;
                Case next;
                carryOver(next, before);
                QCOMPARE(next.initial.branch, given);
            }
    }

    void endsOfARange_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<bool>("hasStandard");
        QTest::addColumn<double>("value"); // NaN: none, and a problem
        QTest::newRow("given") << "from = \"5 nm\"" << false << 5e-9;
        QTest::newRow("given over the standard") << "from = \"5 nm\"" << true << 5e-9;
        QTest::newRow("the standard") << "" << true << 8e-9;
        QTest::newRow("missing") << "" << false << std::nan("");
        QTest::newRow("no length") << "from = \"5 mN\"" << true << std::nan("");
        QTest::newRow("out of range") << "from = \"-1 m\"" << true << std::nan("");
    }
    void endsOfARange()
    {
        QFETCH(QString, text);
        QFETCH(bool, hasStandard);
        QFETCH(double, value);
        const Case c;
        const Parameter key = keyOf(c, "springs.flying_height");
        const TomlDocument toml = readToml(text.toStdString());
        std::vector<InputProblem> problems;
        StudyReader reader(toml, "study", c, problems);
        const auto found = readEnd(reader, "from", key, hasStandard ? std::optional(8e-9) : std::nullopt);
        QCOMPARE(found.has_value(), !std::isnan(value));
        if (found) QCOMPARE(*found, value);
        QCOMPARE(problems.size(), std::size_t(found ? 0 : 1));
        if (found) QCOMPARE(caseWith(c, key, *found).value().springs.flyingHeight, value);
        QVERIFY(!caseWith(c, key, 2.0 * key.maximum));
    }

    void thereAndBack()
    {
        // Down through d_s = 3 nm and up again: caught on the way back, since menisci reach to 5 nm. A step by 1 nm
        // swings by as much.
        HeldSteps steps = heights({6e-9, 5e-9, 2e-9});
        steps.start.initial.flyingHeight = 8e-9;
        steps.start.initial.pitch = 90e-6;
        std::vector<HeldStep> seen;
        std::vector<std::string> warnings;
        QVERIFY(holdAll(
            steps, {},
            [&](std::size_t i, HeldStep&& step) {
                QCOMPARE(i, seen.size());
                seen.push_back(std::move(step));
            },
            warnings));
        QCOMPARE(seen.size(), std::size_t(6));
        const EndKind f = EndKind::Flying, c = EndKind::Contact;
        const std::vector<EndKind> expected{f, f, c, c, c, c};
        for (std::size_t i = 0; i < 6; ++i) {
            QCOMPARE(seen[i].end.kind, expected[i]);
            QCOMPARE(seen[i].back, i >= 3);
            QCOMPARE(seen[i].value, steps.values[i < 3 ? i : 5 - i]);
        }
        QVERIFY(std::abs(seen[1].end.spacing - 5e-9) < 1e-14);
        QVERIFY(seen[0].anew && !seen[1].anew && !seen[3].anew);
    }

    void beginsAnewAfterAFailure()
    {
        // A static height below d_1 is no case; then the next value begins as the case says.
        HeldSteps steps = heights({-3e-9, 7e-9});
        std::vector<std::string> warnings;
        HeldEnd last;
        const HeldStep first = holdValue(steps, -3e-9, last, warnings, {});
        QVERIFY(!first.problem.empty());
        QCOMPARE(first.end.kind, EndKind::Failed);
        const HeldStep second = holdValue(steps, 7e-9, last, warnings, {});
        QVERIFY(second.anew);
        QCOMPARE(last.startSpacing, steps.start.initial.flyingHeight);
    }

    void stops()
    {
        std::vector<std::string> warnings;
        QVERIFY(!holdAll(
            heights({7e-9, 6e-9}), [] { return false; }, [](std::size_t, HeldStep&&) { QFAIL("held"); }, warnings));
    }
};

TOUCHDOWN_TEST(TestHeldSteps)

} // namespace test_held_steps

#include "test_held_steps.moc"

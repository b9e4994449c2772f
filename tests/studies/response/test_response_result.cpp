// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/response/response_result.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <random>

#include <QTest>

#include "core/studies/response/response_report.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_response_result {

using std::numbers::pi;

ResponsePoint pointOf(double frequency, double amplitude, bool down, int period = 1)
{
    ResponsePoint point;
    point.down = down;
    point.done = true;
    point.motion.frequency = frequency;
    point.motion.harmonic = amplitude;
    point.motion.period = period;
    return point;
}

/// Amplitudes on both ways, each by rising frequency; 0 stands for a motion that has not settled.
ResponseResult resultOf(const std::vector<double>& up, const std::vector<double>& down)
{
    ResponseResult result;
    for (std::size_t i = 0; i < up.size(); ++i)
        result.points.push_back(pointOf(double(i), up[i], false, up[i] > 0.0 ? 1 : 0));
    for (std::size_t i = down.size(); i-- > 0;)
        result.points.push_back(pointOf(double(i), down[i], true, down[i] > 0.0 ? 1 : 0));
    return result;
}

class TestResponseResult : public QObject {
    Q_OBJECT

private slots:
    void placesOfTwoStates()
    {
        using Ranges = std::vector<std::pair<std::size_t, std::size_t>>;
        QCOMPARE(twoStates(resultOf({1, 2, 3, 1}, {1, 2, 3, 1})), Ranges());
        QCOMPARE(twoStates(resultOf({1, 2, 3, 1}, {1, 4, 5, 1})), (Ranges{{1, 2}}));
        QCOMPARE(twoStates(resultOf({1, 2, 3, 1}, {3, 2, 3, 5})), (Ranges{{0, 0}, {3, 3}}));
        QCOMPARE(twoStates(resultOf({1, 0, 3, 1}, {1, 4, 4, 0})), (Ranges{{2, 2}})); // unsettled ones prove nothing
        QCOMPARE(twoStates(resultOf({1.0, 2.0}, {1.0, 2.0 * 1.0005})), Ranges());    // the same motion
    }

    /// A quantity may be the same in both, as a force of contact without contact.
    void aQuantityMayNotTellTwoMotionsApart()
    {
        ForcedMotion flying = pointOf(1.0, 0.0, false).motion, nearer = flying;
        flying.size = nearer.size = SpringModel::State::Constant(2e-9);
        flying.leastSpacing = 3e-9;
        nearer.leastSpacing = 1e-9;
        QVERIFY(sameMotion(flying, flying) && !sameMotion(flying, nearer));
        nearer.leastSpacing = 3e-9 + 1e-12; // to a thousandth of the size
        QVERIFY(sameMotion(flying, nearer));
        nearer.contactShare = 0.01;
        QVERIFY(!sameMotion(flying, nearer));
    }

    /// Of two jumps between two frequencies the last one leads to the motion at the second.
    void theLastJumpOfAWayEndsTwoStates()
    {
        ResponseTask task;
        task.frequencies = {10.0, 20.0, 30.0};
        ResponseResult result;
        for (const bool down : {false, true})
            for (const double at : {12.0, 18.0}) {
                ResponseJump jump;
                jump.down = down;
                jump.before.frequency = jump.beyond = at;
                result.jumps.push_back(jump);
            }
        QCOMPARE(jumpBetween(task, result, 0, 1, false)->frequency(), 18.0);
        QCOMPARE(jumpBetween(task, result, 1, 0, true)->frequency(), 12.0);
        QVERIFY(jumpBetween(task, result, 1, 2, false) == nullptr);
    }

    /// Two states from the lowest frequency on, and a jump downwards between them: the sentence about the two states
    /// says that they reach the lowest frequency, and nothing about jumps that are not there.
    void twoStatesUpToAnEnd()
    {
        ResponseTask task;
        task.frequencies = {10e3, 11e3, 12e3, 13e3, 14e3};
        task.quantity.displayUnit = "nm";
        const auto jump = [](bool down, double frequency, double before, double after) {
            ResponseJump found;
            found.down = down;
            found.beyond = frequency;
            found.before = pointOf(frequency, before, down).motion;
            found.after = pointOf(frequency, after, down).motion;
            return found;
        };
        ResponseResult result = resultOf({1e-9, 1e-9, 1e-9, 1e-9, 3e-9}, {2e-9, 2e-9, 3e-9, 3e-9, 3e-9});
        result.linear.resize(5);
        result.jumps = {jump(false, 13.5e3, 1e-9, 3e-9), jump(true, 11.5e3, 3e-9, 2e-9)};
        std::vector<std::string> findings = responseFindings(task, result);
        QCOMPARE(findings[0], std::string("Up: rises from 1 nm to 3 nm at 13.5 kHz: two states between 10 kHz, the "
                                          "lowest one, and 13.5 kHz."));
        QCOMPARE(findings[1], std::string("Down: falls from 3 nm to 2 nm at 11.5 kHz."));
        result.jumps.erase(result.jumps.begin());
        result.points[4] = pointOf(4, 1e-9, false);
        findings = responseFindings(task, result);
        QCOMPARE(findings[0], std::string("Two states between 10 kHz, the lowest one, and 14 kHz, the highest one."));
    }

    void pointsOfBothWays()
    {
        const ResponseResult result = resultOf({1, 2, 3}, {4, 5, 6});
        for (std::size_t i = 0; i < 3; ++i) {
            QCOMPARE(pointAt(result, i, false).motion.amplitude(), 1.0 + double(i));
            QCOMPARE(pointAt(result, i, true).motion.amplitude(), 4.0 + double(i));
            QCOMPARE(pointAt(result, i, true).motion.frequency, double(i));
        }
    }

    /// Phases on a drawn arc of less than a turn: in their turn they differ as on the arc, and none is at its other
    /// end.
    void phasesOfAnArcStayTogether()
    {
        std::mt19937 draw(1);
        std::uniform_real_distribution<double> share(0.0, 1.0);
        for (int set = 0; set < 200; ++set) {
            const double begin = 20.0 * (share(draw) - 0.5), length = 1.5 * pi * share(draw);
            ResponseResult result;
            std::vector<double> phases;
            for (int k = 0; k < 40; ++k) {
                phases.push_back(begin + length * k / 39.0);
                ResponsePoint point = pointOf(k, 1.0, k >= 20);
                point.motion.harmonic = std::polar(1.0, phases.back()) / std::complex<double>(0.0, 1.0);
                result.points.push_back(point);
            }
            const PhaseTurn turn = phaseTurnOf(result);
            const double offset = turn.of(result.points.front().motion.harmonic) - phases.front();
            QVERIFY(std::abs(std::remainder(offset, 2.0 * pi)) < 1e-9);
            for (std::size_t k = 0; k < phases.size(); ++k)
                QVERIFY(std::abs(turn.of(result.points[k].motion.harmonic) - phases[k] - offset) < 1e-9);
            const double middle = begin + 0.5 * length + offset;
            QVERIFY(middle > -1.5 * pi - 1e-9 && middle <= 0.5 * pi + 1e-9);
        }
    }
};

TOUCHDOWN_TEST(TestResponseResult)

} // namespace test_response_result

#include "test_response_result.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/work/team_gain.h"

#include <QTest>

#include "core/work/team_trials.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_team_gain {

/// Two kinds of loops whose times on one thread and on all are given, on a clock of its own.
struct Loops {
    double alone, all; // of each 100 us [s]
    double now = 0.0;
    TeamGain gain{0.0};

    /// Share of the time in which loops were shared.
    double sharedFor(double seconds)
    {
        double shared = 0.0;
        for (const double end = now + seconds; now < end;) {
            const double time = gain.together() ? all : alone;
            for (const std::uintptr_t kind : {1000, 2000}) {
                // The second kind takes ten times as long; which kind a half has more of does not count.
                const double took = kind == 2000 ? 10.0 * time : time;
                if (gain.measures()) gain.note(kind, took);
                now += took;
                if (gain.together()) shared += took;
            }
            gain.look(now);
        }
        return shared / seconds;
    }
};

class TestTeamGain : public QObject {
    Q_OBJECT

private slots:
    void threadsThatGain()
    {
        Loops loops{100e-6, 60e-6};
        QVERIFY(loops.gain.together());
        QVERIFY(loops.sharedFor(10.0) > 0.97);
        QVERIFY(std::abs(loops.gain.gain() - 100.0 / 60.0) < 1e-9);
    }

    /// The loss of trials stays small, too.
    void threadsThatDoNotGain()
    {
        Loops loops{100e-6, 110e-6};
        loops.sharedFor(1.0);
        QVERIFY(!loops.gain.together() || loops.gain.measures());
        QVERIFY(loops.sharedFor(20.0) < 0.02);
        QVERIFY(loops.gain.gain() < 1.0);
    }

    /// Other programs come and go.
    void followsTheMachine()
    {
        Loops loops{100e-6, 60e-6};
        loops.sharedFor(5.0);
        loops.all = 150e-6;
        loops.sharedFor(10.0);
        QVERIFY(loops.sharedFor(20.0) < 0.03);
        loops.all = 60e-6;
        loops.sharedFor(10.0);
        QVERIFY(loops.sharedFor(20.0) > 0.97);
    }

    /// A trial without a loop that both halves had decides nothing.
    /// More kinds of loops than it has places are forgotten when they no longer come, and the present ones decide.
    void forgetsLoopsThatAreGone()
    {
        Loops loops{100e-6, 60e-6};
        for (std::uintptr_t kind = 1; kind <= 400; ++kind) loops.gain.note(kind << 20, 1e-3);
        QVERIFY(loops.sharedFor(30.0) > 0.9);
        QVERIFY(std::abs(loops.gain.gain() - 100.0 / 60.0) < 1e-9);
    }

    void looksForNothingWithoutTrials()
    {
        setTeamTrials(false);
        Loops loops{100e-6, 300e-6};
        QCOMPARE(loops.sharedFor(3.0) > 0.999, true);
        QCOMPARE(loops.gain.gain(), 0.0);
        setTeamTrials(true);
        QVERIFY(loops.sharedFor(10.0) < 0.5);
    }

    void nothingToCompare()
    {
        TeamGain gain(0.0);
        double now = 0.0;
        for (std::uintptr_t kind = 1; now < 3.0; ++kind) {
            if (gain.measures()) gain.note(16 * kind, 1e-3);
            gain.look(now += 1e-3);
        }
        QCOMPARE(gain.gain(), 0.0);
        QVERIFY(gain.together() || gain.measures());
    }
};

TOUCHDOWN_TEST(TestTeamGain)

} // namespace test_team_gain

#include "test_team_gain.moc"

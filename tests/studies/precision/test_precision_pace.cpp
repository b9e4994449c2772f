// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/precision/precision_pace.h"

#include <cmath>

#include <QTest>

#include "core/studies/precision/precision_task.h"
#include "core/studies/runs/expected_cost.h"
#include "tests/support/sample_case.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_precision_pace {

PrecisionTask taskOf(const Case& c, int repeats)
{
    PrecisionTask task;
    task.start = c;
    task.repeats = repeats;
    return task;
}

class TestPrecisionPace : public QObject {
    Q_OBJECT

private slots:
    /// Before a run tells the pace, by the expected costs: each point once, then its repeats.
    void countsWhatIsToBeMade()
    {
        const Case c = sample("fig10a");
        PrecisionPace once(taskOf(c, 0), 2, {&c, &c}), often(taskOf(c, 5), 2, {&c, &c});
        const double single = expectedCost(c) * once.secondsPerCost();
        QVERIFY(single > 0.0);
        QVERIFY(std::abs(once.left() - 2.0 * single) < 1e-9);
        QVERIFY(std::abs(often.left() - 12.0 * single) < 1e-9);
    }

    /// The pace of the points that were run is that of the others.
    void aPointTellsThePace()
    {
        const Case c = sample("fig10a");
        PrecisionPace pace(taskOf(c, 0), 1, {&c, &c});
        const double before = pace.left();
        pace.beginPoint(0);
        pace.endPoint(); // took hardly any time
        QVERIFY(pace.secondsPerCost() > 0.0);
        QVERIFY2(pace.left() < 0.1 * before, qPrintable(QString::number(pace.left())));
    }

    /// A point that is not run any more has no repeats either.
    void pointsThatAreLeftOutTakeNoTime()
    {
        const Case c = sample("fig10a");
        PrecisionPace pace(taskOf(c, 5), 1, {&c, &c});
        pace.beginRepeats();
        QCOMPARE(pace.left(), 0.0);
    }
};

TOUCHDOWN_TEST(TestPrecisionPace)

} // namespace test_precision_pace

#include "test_precision_pace.moc"

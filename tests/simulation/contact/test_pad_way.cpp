// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/contact/pad_way.h"

#include <algorithm>
#include <cmath>

#include <QTest>

#include "core/case/parameters.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_pad_way {

class TestPadWay : public QObject {
    Q_OBJECT

private slots:
    /// From 5 nm to -10 nm and back within 2 ms.
    void separations()
    {
        Case c = defaultsOf(ModelKind::Contact);
        c.approach = {5e-9, -10e-9};
        c.run.duration = 2e-3;
        QCOMPARE(padSeparation(c, 0.0), 5e-9);
        QCOMPARE(padSeparation(c, 1e-3), -10e-9);
        QCOMPARE(padSeparation(c, 2e-3), 5e-9);
        QVERIFY(std::abs(padSeparation(c, 0.5e-3) + 2.5e-9) < 1e-22);
        QVERIFY(std::abs(approachTime(c, -2.5e-9) - 0.5e-3) < 1e-18);
        QVERIFY(std::abs(retractionTime(c, -2.5e-9) - 1.5e-3) < 1e-18);
    }

    /// Samples each 0.3 ms up to 1.8 ms, and one at the end, 2 ms: the closest approach at 1 ms is a station of its
    /// own, and no sample.
    void closestIsAStation()
    {
        Case c = defaultsOf(ModelKind::Contact);
        c.run.duration = 2e-3;
        c.run.sampleInterval = 0.3e-3;
        const std::vector<PadStation> stations = padStations(c);
        QCOMPARE(stations.size(), std::size_t{9});
        QCOMPARE(std::ranges::count(stations, true, &PadStation::sample), 8);
        QCOMPARE(stations.back().time, 2e-3);
        QCOMPARE(stations[4].time, 1e-3);
        QVERIFY(!stations[4].sample);
    }
};

TOUCHDOWN_TEST(TestPadWay)

} // namespace test_pad_way

#include "test_pad_way.moc"

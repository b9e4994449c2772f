// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/parameters.h"
#include "core/simulation/static_state/steady.h"

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_steady_series {

class TestSteadySeries : public QObject {
    Q_OBJECT

private slots:
    void aCaseWithoutListsIsOneState()
    {
        Case c = defaultsOf(ModelKind::Film);
        c.disk = {600.0, 20e-3, 0.1, VelocityField::Uniform};
        const auto series = seriesOf(c);
        QCOMPARE(series.size(), std::size_t{1});
        QCOMPARE(series[0].radius, 20e-3);
        QCOMPARE(series[0].skew, 0.1);
        QCOMPARE(series[0].speed, 600.0);
        QVERIFY(!series[0].altitude);
        const Case at = caseAt(c, series[0]);
        for (const Parameter& parameter : parameters())
            QVERIFY2(parameter.get(at) == parameter.get(c), parameter.key.c_str());
    }
    /// Altitudes outermost, then speeds, then radii, each radius with its skew.
    void allCombinationsInOrder()
    {
        Case c = defaultsOf(ModelKind::Film);
        c.steady.radii = {20e-3, 30e-3};
        c.steady.skews = {-0.1, 0.2};
        c.steady.speeds = {500.0, 600.0};
        c.steady.altitudes = {0.0, 3000.0};
        QStringList rows;
        for (const SteadySeriesPoint& point : seriesOf(c))
            rows
                << QString("%1 %2 %3 %4").arg(*point.altitude).arg(point.speed).arg(1e3 * point.radius).arg(point.skew);
        QCOMPARE(rows, (QStringList{"0 500 20 -0.1", "0 500 30 0.2", "0 600 20 -0.1", "0 600 30 0.2",
                                    "3000 500 20 -0.1", "3000 500 30 0.2", "3000 600 20 -0.1", "3000 600 30 0.2"}));
    }
    void oneSkewServesAllRadii()
    {
        Case c = defaultsOf(ModelKind::Film);
        c.disk.skew = 0.05;
        c.steady.radii = {20e-3, 30e-3, 40e-3};
        for (const SteadySeriesPoint& point : seriesOf(c)) QCOMPARE(point.skew, 0.05);
    }
    void theCaseOfAState()
    {
        Case c = defaultsOf(ModelKind::Film);
        c.steady.radii = {20e-3};
        c.steady.skews = {-0.1};
        c.steady.speeds = {500.0};
        c.steady.altitudes = {3000.0};
        c.air.temperature = 310.0;
        c.surface.crown = 20e-9;
        const auto series = seriesOf(c);
        QCOMPARE(series.size(), std::size_t{1});
        const Case at = caseAt(c, series[0]);
        QCOMPARE(at.disk.radius, 20e-3);
        QCOMPARE(at.disk.skew, -0.1);
        QCOMPARE(at.disk.speed, 500.0);
        QCOMPARE(at.air.source, AirSource::Atmosphere);
        QCOMPARE(at.air.altitude, 3000.0);
        QCOMPARE(at.air.temperature, 310.0);
        QVERIFY(at.surface == c.surface);
        // It is a state of its own: its series is itself.
        const auto again = seriesOf(at);
        QCOMPARE(again.size(), std::size_t{1});
        QVERIFY(!again[0].altitude);
        QCOMPARE(again[0].radius, 20e-3);
    }
    /// Without altitudes the air is as the case has it.
    void givenAirStays()
    {
        Case c = defaultsOf(ModelKind::Film);
        c.air.source = AirSource::EstablishedStandard;
        c.steady.speeds = {500.0, 600.0};
        for (const SteadySeriesPoint& point : seriesOf(c))
            QCOMPARE(caseAt(c, point).air.source, AirSource::EstablishedStandard);
    }
};

TOUCHDOWN_TEST(TestSteadySeries)

} // namespace test_steady_series

#include "test_steady_series.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/cvode.h"

#include <numbers>

#include <QTest>

#include "tests/support/piecewise_oscillator.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_cvode {

class TestCvode : public QObject {
    Q_OBJECT

private slots:
    /// Present exactly when the build found SUNDIALS.
    void isThereWhenBuilt()
    {
#ifdef TOUCHDOWN_HAVE_CVODE
        QVERIFY(haveCvode);
#else
        QVERIFY(!haveCvode);
#endif
    }

#ifdef TOUCHDOWN_HAVE_CVODE
    void errorFollowsTheTolerance()
    {
        const PiecewiseOscillator smooth = smoothOscillator({0.3, 1.0, 0.1});
        const auto exact = PiecewiseOscillator::exact(smooth.upper, {1.0, 0.0}, 20.0);
        std::array<double, 2> error{};
        for (std::size_t i = 0; i < 2; ++i) {
            Log log;
            const auto result =
                integrateCvode(smooth, Start<PiecewiseOscillator>{{1.0, 0.0}, PiecewiseOscillator::Mode::Upper}, 20.0,
                               {.tolerance = i == 0 ? 1e-6 : 1e-10}, log);
            QCOMPARE(result.end, IntegrationEnd::Reached);
            error[i] = (log.last() - exact).norm();
        }
        QVERIFY(error[0] < 1e-3 && error[1] < 1e-7 && error[1] < 1e-2 * error[0]);
    }
    /// As in test_adaptive: pi/2, then by turns pi/5 and pi.
    void switches()
    {
        const PiecewiseOscillator bilinear = switchedOscillator({0.0, 1.0, 0.0}, {0.0, 25.0, 0.0});
        Log log;
        const auto result =
            integrateCvode(bilinear, Start<PiecewiseOscillator>{{1.0, 0.0}, PiecewiseOscillator::Mode::Upper}, 40.0,
                           {.tolerance = 1e-10}, log);
        QCOMPARE(result.end, IntegrationEnd::Reached);
        QCOMPARE(log.events.size(), std::size_t{22});
        double expected = 0.5 * std::numbers::pi;
        for (const Log::Event& event : log.events) {
            QVERIFY2(std::abs(event.time - expected) < 1e-6, qPrintable(QString::number(event.time - expected)));
            expected += event.upper ? std::numbers::pi : 0.2 * std::numbers::pi;
        }
    }
    /// As in test_adaptive: not given up where round-off exceeds the error wanted.
    void aToleranceBelowRoundOffIsMetToRoundOff()
    {
        const PiecewiseOscillator oscillator = smoothOscillator({0.0, 1.0, 0.0});
        Log log;
        const auto result =
            integrateCvode(oscillator, Start<PiecewiseOscillator>{{1e6, 0.0}, PiecewiseOscillator::Mode::Upper}, 20.0,
                           {.tolerance = 1e-14}, log);
        QCOMPARE(result.end, IntegrationEnd::Reached);
        QVERIFY((log.last() - PiecewiseOscillator::exact(oscillator.upper, {1e6, 0.0}, 20.0)).norm() < 1e-7 * 1e6);
    }
    /// Pushed onto the boundary from both sides: a switch that turns back at once is not missed, so that the law is
    /// that of the side on which the state is, and the chattering is seen as by the other methods.
    void chatteringEnds()
    {
        const PiecewiseOscillator sliding = switchedOscillator({-1.0, 0.0, 2.0}, {1.0, 0.0, 2.0});
        Log log;
        const auto result =
            integrateCvode(sliding, Start<PiecewiseOscillator>{{0.1, 0.0}, PiecewiseOscillator::Mode::Upper}, 100.0,
                           {.tolerance = 1e-8}, log);
        QCOMPARE(result.end, IntegrationEnd::Chattering);
        QVERIFY(std::abs(log.last()[0]) < 1e-3);
    }
    void stopsWhenTold()
    {
        const PiecewiseOscillator smooth = smoothOscillator({0.3, 1.0, 0.1});
        Log log;
        log.stopAfter = 7;
        const auto result = integrateCvode(
            smooth, Start<PiecewiseOscillator>{{1.0, 0.0}, PiecewiseOscillator::Mode::Upper}, 1e6, {}, log);
        QCOMPARE(result.end, IntegrationEnd::Stopped);
        QCOMPARE(log.times.size(), std::size_t{7});
    }
#endif
};

TOUCHDOWN_TEST(TestCvode)

} // namespace test_cvode

#include "test_cvode.moc"

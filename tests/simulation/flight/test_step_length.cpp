// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/flight/step_length.h"

#include <cmath>
#include <random>

#include <QtTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_step_length {

constexpr double allowed = 5e-12; // [m]

class TestStepLength : public QObject {
    Q_OBJECT

private slots:
    /// Errors and limits at random, with no error so large that a step is repeated: each pair of steps is fitted.
    void staysWithinTheFit()
    {
        std::mt19937_64 random(3);
        std::uniform_real_distribution<double> power(-3.0, 0.2);
        StepLength length(2e-9, allowed);
        double last = 0.0;
        bool longer = false, shorter = false;
        for (int n = 0; n < 1000; ++n) {
            const double dt = length.next(last, 1e-7 * std::pow(10.0, power(random)));
            const double error = allowed * std::pow(10.0, power(random));
            QVERIFY(!length.isTooLong(error));
            QVERIFY2(last == 0.0 || (dt <= mostChangeForFit * last && last <= mostChangeForFit * dt),
                     qPrintable(QString("%1 after %2").arg(dt).arg(last)));
            longer = longer || (last > 0.0 && dt > 1.2 * last);
            shorter = shorter || dt < last / 1.2;
            length.accepted(dt, error);
            last = dt;
        }
        QVERIFY(longer && shorter);
    }
    /// An error of c dt^3: lengths grow from step to step and stay where the error is allowed, without a repetition.
    void settlesWhereTheErrorIsAllowed()
    {
        StepLength length(2e-9, allowed);
        const double best = 1e-7;
        double last = 0.0;
        for (int n = 0; n < 100; ++n) {
            const double dt = length.next(last, 1.0), error = allowed * std::pow(dt / best, 3);
            QVERIFY(dt >= last && !length.isTooLong(error));
            length.accepted(dt, error);
            last = dt;
        }
        QVERIFY2(last > best / 1.5 && last <= best, qPrintable(QString::number(last)));
    }
    void reachesALimit()
    {
        StepLength length(1e-7, allowed);
        double last = 0.0;
        for (int n = 0; n < 20; ++n) {
            last = length.next(last, 3e-8);
            length.accepted(last, 1e-3 * allowed);
        }
        QCOMPARE(last, 3e-8);
        QCOMPARE(length.next(last, 1e-9, true), 1e-9); // the forces have jumped
    }
    /// Short after a failure or an error that is too large; then a switch may end a step early.
    void shortensAtOnce()
    {
        StepLength length(1e-7, allowed);
        QVERIFY(length.isTooLong(8.0 * allowed));
        QVERIFY(std::abs(length.shortened(1e-7, 8.0 * allowed) - 0.45e-7) < 1e-12);
        QCOMPARE(length.halved(0.4e-7), 0.2e-7);
        QCOMPARE(length.next(1e-7, 1.0), 0.2e-7);
        QCOMPARE(length.next(1e-9, 1.0), 2e-9);
    }
    /// A step that was repeated with 0.45 of its length differs too much to be fitted: the next one makes up for it at
    /// once, as far as the error allows. From then on lengths change smoothly.
    void growsBackAtOnce()
    {
        StepLength length(1e-7, allowed);
        length.accepted(1e-7, 0.5 * allowed);
        const double shorter = length.shortened(1e-7, 8.0 * allowed);
        length.accepted(shorter, 1e-2 * allowed);
        const double next = length.next(shorter, 1.0);
        QCOMPARE(next, 2.0 * shorter);
        length.accepted(next, 1e-2 * allowed);
        QCOMPARE(length.next(next, 1.0), StepLength::smoothChange * next);
        length.shortened(next, 8.0 * allowed);
        length.accepted(shorter, 0.3 * allowed); // allows 0.9/cbrt 0.3 = 1.344
        QVERIFY(std::abs(length.next(shorter, 1.0) - 1.3444 * shorter) < 1e-3 * shorter);
    }
    void fixedStepsStay()
    {
        StepLength length(1e-7, 0.0);
        QVERIFY(length.fixed());
        for (const double error : {0.0, 1e-15, 1.0}) {
            QVERIFY(!length.isTooLong(error));
            length.accepted(1e-7, error);
            QCOMPARE(length.next(1e-7, 1e-9), 1e-7);
        }
        length.halved(1e-7);
        length.accepted(0.5e-7, 0.0);
        QCOMPARE(length.next(0.5e-7, 1e-9), 1e-7);
    }
};

TOUCHDOWN_TEST(TestStepLength)

} // namespace test_step_length

#include "test_step_length.moc"

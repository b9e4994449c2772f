// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/slider/tied_numbers.h"

#include <cmath>
#include <random>
#include <vector>

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_tied_numbers {

class TestTiedNumbers : public QObject {
    Q_OBJECT

private slots:
    /// b = a + 2, c = 10 - b; then a + c = 8 whatever a is, and c = a has the one solution a = 4.
    void byHand()
    {
        TiedNumbers numbers(3);
        QCOMPARE(numbers.tie(1, 1.0, 0, 2.0), 0.0);
        QCOMPARE(numbers.tie(2, -1.0, 1, 10.0), 0.0);
        QVERIFY(!numbers.value(0));
        QCOMPARE(std::abs(numbers.tie(2, -1.0, 0, 7.0)), 1.0);
        QCOMPARE(numbers.tie(2, -1.0, 0, 8.0), 0.0);
        QCOMPARE(numbers.tie(2, 1.0, 0, 0.0), 0.0);
        QCOMPARE(*numbers.value(0), 4.0);
        QCOMPARE(*numbers.value(1), 6.0);
        QCOMPARE(*numbers.value(2), 4.0);
        QCOMPARE(std::abs(numbers.fix(1, 9.0)), 3.0);
        QCOMPARE(*numbers.value(1), 6.0);
    }

    /// Equations of whole numbers that were drawn first: all are taken, and what has a value has that one.
    void findsWhatWasDrawn()
    {
        for (unsigned seed = 0; seed < 300; ++seed) {
            std::mt19937 engine(seed);
            std::vector<double> drawn(2 + engine() % 20);
            for (double& each : drawn) each = static_cast<double>(engine() % 100);
            TiedNumbers numbers(drawn.size());
            for (int i = 0; i < 40; ++i) {
                const std::size_t a = engine() % drawn.size(), b = engine() % drawn.size();
                const double sign = engine() % 2 == 0 ? 1.0 : -1.0;
                if (engine() % 8 == 0)
                    QCOMPARE(numbers.fix(a, drawn[a]), 0.0);
                else
                    QCOMPARE(numbers.tie(a, sign, b, drawn[a] - sign * drawn[b]), 0.0);
                const auto value = numbers.value(a);
                QVERIFY(!value || *value == drawn[a]);
                if (value) QVERIFY(numbers.fix(a, drawn[a] + 1.0) != 0.0);
            }
        }
    }
};

TOUCHDOWN_TEST(TestTiedNumbers)

} // namespace test_tied_numbers

#include "test_tied_numbers.moc"

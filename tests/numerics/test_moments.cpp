// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/moments.h"

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_moments {

class TestMoments : public QObject {
    Q_OBJECT

private slots:
    /// Of 1, 3 about 1e9: mean 2, deviation 1, whose square is below the round-off of 1e18.
    void aboutTheMean()
    {
        const std::vector<double> values{1e9 + 1.0, 1e9 + 3.0};
        const Moments moments = momentsOf(values);
        QCOMPARE(moments.mean, 1e9 + 2.0);
        QCOMPARE(moments.deviation, 1.0);
    }
    void medians()
    {
        QCOMPARE(medianOf({}), 0.0);
        QCOMPARE(medianOf({3.0, 1.0, 2.0}), 2.0);
        QCOMPARE(medianOf({4.0, 1.0, 2.0, 3.0}), 2.5);
    }
};

TOUCHDOWN_TEST(TestMoments)

} // namespace test_moments

#include "test_moments.moc"

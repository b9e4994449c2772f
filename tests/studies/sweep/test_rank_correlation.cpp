// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/sweep/rank_correlation.h"

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_rank_correlation {

class TestRankCorrelation : public QObject {
    Q_OBJECT

private slots:
    /// Only the order counts.
    void ofAnyRisingFunction()
    {
        QCOMPARE(rankCorrelation({1.0, 2.0, 3.0, 4.0}, {1.0, 8.0, 27.0, 1e9}), 1.0);
        QCOMPARE(rankCorrelation({1.0, 2.0, 3.0, 4.0}, {0.0, -1.0, -50.0, -51.0}), -1.0);
    }
    /// Values from scipy.stats.spearmanr (SciPy 1.10).
    void asSciPy()
    {
        const std::vector<double> x{0.3, 1.2, 0.7, 5.0, 2.2, 2.2, 4.1, 0.1}, y{1.0, 0.5, 2.0, 8.0, 3.0, 3.0, 3.0, 0.2};
        QVERIFY(std::abs(rankCorrelation(x, y) - 0.9081292832965596) < 1e-12);
    }
    void ofNothingThatChanges()
    {
        QCOMPARE(rankCorrelation({1.0, 2.0, 3.0}, {5.0, 5.0, 5.0}), 0.0);
        QCOMPARE(rankCorrelation({}, {}), 0.0);
    }
};

TOUCHDOWN_TEST(TestRankCorrelation)

} // namespace test_rank_correlation

#include "test_rank_correlation.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/runs/trajectory_error.h"

#include <cmath>

#include <QTest>

#include "core/studies/runs/measured_run.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_trajectory_error {

/// `count` samples of x(i).
template <class Function>
MeasuredRun runOf(std::size_t count, Function x)
{
    MeasuredRun run;
    run.columns.resize(1);
    for (std::size_t i = 0; i < count; ++i) {
        run.time.push_back(static_cast<double>(i));
        run.columns[0].push_back(x(static_cast<double>(i)));
    }
    return run;
}

class TestTrajectoryError : public QObject {
    Q_OBJECT

private slots:
    /// Errors 0, 3, -4, 0 of four samples: at the end 0, at worst 4, root mean square sqrt(25/4) = 2.5.
    void namedErrors()
    {
        const MeasuredRun reference = runOf(4, [](double) { return 7.0; });
        MeasuredRun run = reference;
        run.columns[0] = {7.0, 10.0, 3.0, 7.0};
        const TrajectoryError error = trajectoryError(run, reference, 0);
        QCOMPARE(*error.at(ErrorMeasure::Final), 0.0);
        QCOMPARE(*error.at(ErrorMeasure::Worst), 4.0);
        QCOMPARE(*error.at(ErrorMeasure::L2), 2.5);
        QVERIFY(!error.at(ErrorMeasure::PeakFrequency));
    }

    /// The last tenth of 20 samples is two of them: +-1 about 5 against +-3 about 4. Means differ by 1, deviations
    /// by 2.
    void tailStatistics()
    {
        const MeasuredRun reference = runOf(20, [](double t) { return 5.0 + (std::fmod(t, 2.0) < 1.0 ? 1.0 : -1.0); });
        const MeasuredRun run = runOf(20, [](double t) { return 4.0 + (std::fmod(t, 2.0) < 1.0 ? 3.0 : -3.0); });
        const TrajectoryError error = trajectoryError(run, reference, 0);
        QCOMPARE(*error.at(ErrorMeasure::Mean), 1.0);
        QCOMPARE(*error.at(ErrorMeasure::Deviation), 2.0);
    }

    void peaks()
    {
        MeasuredRun reference = runOf(4, [](double) { return 7.0; });
        MeasuredRun run = reference;
        reference.summary.peaks = {{100e3, 5e-9}, {200e3, 1e-9}};
        run.summary.peaks = {{101e3, 3e-9}};
        const TrajectoryError error = trajectoryError(run, reference, 0);
        QCOMPARE(*error.at(ErrorMeasure::PeakFrequency), 1e3);
        QCOMPARE(*error.at(ErrorMeasure::PeakAmplitude), 2e-9);
    }

    /// Two lines that part by 0.1 a sample: at sample 5 by 0.5. Before it, errors are 0 .. 0.4; the statistics of whole
    /// runs are not told.
    void beforeTheHorizon()
    {
        const MeasuredRun a = runOf(11, [](double t) { return t; });
        const MeasuredRun b = runOf(11, [](double t) { return 1.1 * t; });
        QCOMPARE(firstApart(a, b, 0.45), std::optional<std::size_t>(5));
        QVERIFY(!firstApart(a, b, 1.5));
        const TrajectoryError error = trajectoryError(a, b, 0, 5);
        QVERIFY(std::abs(*error.at(ErrorMeasure::Worst) - 0.4) < 1e-12);
        QVERIFY(!error.at(ErrorMeasure::Mean));
    }

    void nothingToCompare()
    {
        const MeasuredRun none = runOf(0, [](double t) { return t; });
        const MeasuredRun some = runOf(3, [](double t) { return t; });
        QVERIFY(!trajectoryError(none, some, 0).at(ErrorMeasure::Worst));
    }
};

TOUCHDOWN_TEST(TestTrajectoryError)

} // namespace test_trajectory_error

#include "test_trajectory_error.moc"

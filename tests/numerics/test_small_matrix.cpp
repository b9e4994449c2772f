// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/small_matrix.h"

#include <cmath>
#include <complex>

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_small_matrix {

/// Eigenvalues 3 and 1 +- 2 i.
Matrix3 turning()
{
    Matrix3 m;
    m << 1.0, -2.0, 0.0, 2.0, 1.0, 0.0, 0.0, 0.0, 3.0;
    return m;
}

class TestSmallMatrix : public QObject {
    Q_OBJECT

private slots:
    void eliminationsSolve()
    {
        const Vector3 x(1.0, -2.0, 0.5), b = turning() * x;
        QVERIFY((solvePartialPivoting(turning(), b) - x).norm() < 1e-15);
        QVERIFY((solveFullPivoting(turning(), b) - x).norm() < 1e-15);
    }
    void eigenvaluesOfATurn()
    {
        QVERIFY(std::abs(spectralRadius(turning()) - 3.0) < 1e-14);
        const Eigenpairs pairs = eigenpairsOf(turning());
        std::complex<double> product = 1.0;
        for (Eigen::Index k = 0; k < 3; ++k) {
            product *= pairs.values[k];
            QVERIFY((turning() * pairs.vectors.col(k) - pairs.values[k] * pairs.vectors.col(k)).norm() < 1e-14);
            QVERIFY(std::abs(pairs.values[k] - eigenvaluesOf(turning())[k]) < 1e-14);
        }
        QVERIFY(std::abs(product - 15.0) < 1e-13); // the determinant, 3 (1 + 4)
    }
    void adjugateInvertsAndFindsNullVectors()
    {
        const ComplexMatrix3 a = turning().cast<std::complex<double>>();
        QVERIFY((a * adjugate(a) - 15.0 * ComplexMatrix3::Identity()).norm() < 1e-13);
        const ComplexMatrix3 singular = a - std::complex<double>(1.0, 2.0) * ComplexMatrix3::Identity();
        QVERIFY(adjugate(singular).norm() > 1.0);
        QVERIFY((singular * adjugate(singular)).norm() < 1e-14);
        QVERIFY((adjugate(singular) * singular).norm() < 1e-14);
    }
};

TOUCHDOWN_TEST(TestSmallMatrix)

} // namespace test_small_matrix

#include "test_small_matrix.moc"

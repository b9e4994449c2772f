// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/small_matrix.h"

#include <cmath>
#include <complex>

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace {

/// Eigenvalues 3 and 1 +- 2 i.
Matrix3 turning()
{
    Matrix3 m;
    m << 1.0, -2.0, 0.0, 2.0, 1.0, 0.0, 0.0, 0.0, 3.0;
    return m;
}

} // namespace

class TestSmallMatrix : public QObject {
    Q_OBJECT

private slots:
    void eliminationsSolve()
    {
        const Vector3 x(1.0, -2.0, 0.5), b = turning() * x;
        QVERIFY((solvePartialPivoting(turning(), b) - x).norm() < 1e-15);
        QVERIFY((solveFullPivoting(turning(), b) - x).norm() < 1e-15);
        const std::complex<double> i(0.0, 1.0);
        const Eigen::MatrixXcd shifted = turning() + i * Matrix3::Identity();
        const Eigen::VectorXcd y = x.cast<std::complex<double>>();
        QVERIFY((solveComplex(shifted, shifted * y) - y).norm() < 1e-14);
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
    void nullVectorsOfASingularMatrix()
    {
        const std::complex<double> rate(1.0, 2.0);
        const Eigen::MatrixXcd singular = turning() - rate * Matrix3::Identity();
        const NullVectors vectors = nullVectorsOf(singular);
        QVERIFY((singular * vectors.right).norm() < 1e-14);
        QVERIFY((vectors.left * singular).norm() < 1e-14);
        QVERIFY(std::abs(vectors.right.norm() - 1.0) < 1e-14 && std::abs(vectors.left.norm() - 1.0) < 1e-14);
    }
};

TOUCHDOWN_TEST(TestSmallMatrix)
#include "test_small_matrix.moc"

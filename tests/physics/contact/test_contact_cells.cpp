// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>

#include <Eigen/Dense>

#include <cmath>

#include "core/physics/contact/contact_cells.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_contact_cells {

class TestContactCells : public QObject {
    Q_OBJECT

private slots:
    void sumsOverTheCellsAlone();
    void invertsWhatNeighboursSee_data();
    void invertsWhatNeighboursSee();
    void preconditionsAnyCells_data();
    void preconditionsAnyCells();
};

constexpr double modulus = 8e10;

Eigen::MatrixXd compliances(const UniformGrid& grid, const std::vector<std::size_t>& cells)
{
    HalfSpace space(grid, modulus);
    const auto count = static_cast<Eigen::Index>(cells.size());
    Eigen::MatrixXd matrix(count, count);
    for (Eigen::Index c = 0; c < count; ++c) {
        std::vector<double> column(grid.cells(), 0.0);
        column[cells[std::size_t(c)]] = 1.0;
        space.displace(column, column);
        for (Eigen::Index r = 0; r < count; ++r) matrix(r, c) = column[cells[std::size_t(r)]];
    }
    return matrix;
}

Eigen::MatrixXd preconditioner(const UniformGrid& grid, const std::vector<std::size_t>& cells)
{
    ContactCells contact{HalfSpace(grid, modulus)};
    for (const std::size_t cell : cells) contact.add(cell);
    const auto count = static_cast<Eigen::Index>(cells.size());
    Eigen::MatrixXd matrix(count, count);
    for (Eigen::Index c = 0; c < count; ++c) {
        std::vector<double> in(grid.cells() + 2 * contact.margin(), 0.0), out(grid.cells(), -1.0);
        in[contact.margin() + cells[std::size_t(c)]] = 1.0;
        contact.precondition(in.data() + contact.margin(), out.data());
        for (Eigen::Index r = 0; r < count; ++r) matrix(r, c) = out[cells[std::size_t(r)]];
    }
    return matrix;
}

void TestContactCells::sumsOverTheCellsAlone()
{
    ContactCells cells{HalfSpace({30, 2, 1e-6, 1e-6}, modulus)};
    std::vector<double> a(60, 100.0), b(60, 100.0);
    double expected = 0.0;
    for (std::size_t i = 0; i < 60; ++i) {
        if (i % 13 == 0 || i == 31) continue;
        a[i] = -static_cast<double>(i);
        b[i] = 2.0;
        expected += a[i] * b[i];
        cells.add(i);
    }
    QCOMPARE(cells.product(a.data(), b.data()), expected);
    QCOMPARE(cells.largest(a.data()), 59.0);
    cells.add(3.0, b.data(), a.data());
    cells.scaleAndAdd(0.5, b.data(), a.data());
    QCOMPARE(a[13], 100.0);
    QCOMPARE(a[14], 2.0 + 0.5 * (-14.0 + 6.0));
    cells.clear();
    QCOMPARE(cells.product(a.data(), b.data()), 0.0);
}

void TestContactCells::invertsWhatNeighboursSee_data()
{
    QTest::addColumn<std::vector<std::size_t>>("cells");
    QTest::newRow("one cell") << std::vector<std::size_t>{44};
    QTest::newRow("two side by side") << std::vector<std::size_t>{44, 45};
    QTest::newRow("a square of four") << std::vector<std::size_t>{44, 45, 54, 55};
    QTest::newRow("a hook") << std::vector<std::size_t>{44, 45, 46, 54, 64};
}

void TestContactCells::invertsWhatNeighboursSee()
{
    // Where all cells are among each other's twelve, the factorised inverse is the inverse.
    QFETCH(std::vector<std::size_t>, cells);
    const UniformGrid grid{10, 10, 1e-6, 1.5e-6};
    const Eigen::MatrixXd product = preconditioner(grid, cells) * compliances(grid, cells);
    QVERIFY((product - Eigen::MatrixXd::Identity(product.rows(), product.cols())).norm() < 1e-12);
}

void TestContactCells::preconditionsAnyCells_data()
{
    QTest::addColumn<UniformGrid>("grid");
    QTest::newRow("square") << UniformGrid{12, 12, 1e-6, 1e-6};
    QTest::newRow("one column") << UniformGrid{1, 60, 1e-6, 1e-6};
    QTest::newRow("two columns") << UniformGrid{2, 40, 1e-6, 1e-6};
    QTest::newRow("three columns") << UniformGrid{3, 40, 1e-6, 1e-6};
    QTest::newRow("four columns") << UniformGrid{4, 30, 1e-6, 1e-6};
    QTest::newRow("long cells") << UniformGrid{12, 12, 8e-6, 1e-6};
}

void TestContactCells::preconditionsAnyCells()
{
    // Symmetric, positive, and the eigenvalues of M A nearer together than those of A, on all cells and on some.
    QFETCH(UniformGrid, grid);
    for (const std::size_t left : {1000u, 3u}) {
        std::vector<std::size_t> cells;
        for (std::size_t i = 0; i < grid.cells(); ++i)
            if (i * i % 7 % left != left - 1) cells.push_back(i);
        const Eigen::MatrixXd a = compliances(grid, cells);
        const Eigen::MatrixXd m = preconditioner(grid, cells);
        QVERIFY((m - m.transpose()).norm() < 1e-12 * m.norm());
        const Eigen::VectorXd plain = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(a).eigenvalues();
        const Eigen::LLT<Eigen::MatrixXd> factor(m);
        QVERIFY(factor.info() == Eigen::Success);
        const Eigen::MatrixXd l = factor.matrixL();
        const Eigen::VectorXd better =
            Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(l.transpose() * a * l).eigenvalues();
        const double spread = better[better.size() - 1] / better[0];
        QVERIFY(spread < plain[plain.size() - 1] / plain[0]);
        QVERIFY(spread < 6.0);
    }
}

TOUCHDOWN_TEST(TestContactCells)

} // namespace test_contact_cells

#include "test_contact_cells.moc"

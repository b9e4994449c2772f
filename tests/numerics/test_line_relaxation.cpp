// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/line_relaxation.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_line_relaxation {

struct Flow {
    PaddedGrid pad;
    std::array<std::vector<double>, 2> effective, convection;

    Flow(int nx, int ny) : pad{nx, ny}
    {
        for (auto* pair : {&effective, &convection})
            for (auto& field : *pair) field.assign(pad.size(), 0.0);
    }
    template <typename Set>
    void forFaces(Set&& set)
    {
        for (std::size_t axis = 0; axis < 2; ++axis)
            for (int j = 0; j < pad.ny + (axis == 1); ++j)
                for (int i = 0; i < pad.nx + (axis == 0); ++i) {
                    const std::size_t at = pad.at(i, j);
                    set(axis, effective[axis][at], convection[axis][at]);
                }
    }
    LineRelaxation relaxation(double diagonal = 0.0) const
    {
        LineRelaxation lines(pad);
        const std::vector<double> weight(pad.size(), 1.0);
        lines.setOperator({MonotoneFaces{effective[0], convection[0]}, MonotoneFaces{effective[1], convection[1]}},
                          weight, diagonal);
        return lines;
    }
};

/// Conductances over six decades, convection up to the limit of monotony.
Flow randomFlow(int nx, int ny)
{
    Flow flow(nx, ny);
    std::mt19937 generator(7);
    std::uniform_real_distribution<double> share(-1.0, 1.0);
    flow.forFaces([&](std::size_t, double& effective, double& convection) {
        effective = std::pow(10.0, 3.0 * share(generator));
        convection = 2.0 * share(generator) * effective;
    });
    return flow;
}

std::vector<double> randomCells(const PaddedGrid& pad, unsigned seed)
{
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> value(-1.0, 1.0);
    std::vector<double> field(pad.size(), 0.0);
    for (int j = 0; j < pad.ny; ++j)
        for (int i = 0; i < pad.nx; ++i) field[pad.at(i, j)] = value(generator);
    return field;
}

double largest(const std::vector<double>& field)
{
    double result = 0.0;
    for (const double value : field) result = std::max(result, std::abs(value));
    return result;
}

class TestLineRelaxation : public QObject {
    Q_OBJECT

private slots:
    /// b - A v, with A v summed face by face: what a face passes leaves the cell below and enters the one above.
    void residualIsNetOutflow()
    {
        const Flow flow = randomFlow(7, 5);
        const PaddedGrid& pad = flow.pad;
        const std::vector<double> v = randomCells(pad, 1), b = randomCells(pad, 2);
        std::vector<double> expected = b, found(pad.size(), 0.0);
        for (std::size_t axis = 0; axis < 2; ++axis)
            for (int j = 0; j < pad.ny + (axis == 1); ++j)
                for (int i = 0; i < pad.nx + (axis == 0); ++i) {
                    const std::size_t at = pad.at(i, j), below = at - pad.step(static_cast<int>(axis));
                    const double passed = 0.5 * flow.convection[axis][at] * (v[below] + v[at]) -
                                          flow.effective[axis][at] * (v[at] - v[below]);
                    expected[below] -= passed;
                    expected[at] += passed;
                }
        for (std::size_t at = 0; at < v.size(); ++at) expected[at] -= 0.3 * v[at];
        flow.relaxation(0.3).residual(b, v, found);
        for (int j = 0; j < pad.ny; ++j)
            for (int i = 0; i < pad.nx; ++i) QVERIFY(std::abs(found[pad.at(i, j)] - expected[pad.at(i, j)]) < 1e-10);
    }

    /// Cells that only their lines connect, 1 from each other and from the zeros beyond the ends: -v'' = 1 has
    /// v_k = (k + 1)(n - k)/2, k from 0.
    void solvesLines_data()
    {
        QTest::addColumn<int>("axis");
        QTest::newRow("along x") << 0;
        QTest::newRow("along y") << 1;
    }
    void solvesLines()
    {
        QFETCH(int, axis);
        Flow flow(9, 8);
        flow.forFaces(
            [&](std::size_t across, double& effective, double&) { effective = int(across) == axis ? 1.0 : 0.0; });
        const PaddedGrid& pad = flow.pad;
        const std::vector<double> b(pad.size(), 1.0);
        std::vector<double> v(pad.size(), 0.0);
        flow.relaxation().sweep(b, v);
        const int n = axis == 0 ? pad.nx : pad.ny;
        for (int j = 0; j < pad.ny; ++j)
            for (int i = 0; i < pad.nx; ++i) {
                const int k = axis == 0 ? i : j;
                QVERIFY(std::abs(v[pad.at(i, j)] - 0.5 * (k + 1) * (n - k)) < 1e-12);
            }
    }

    void keepsTheSolution()
    {
        const Flow flow = randomFlow(11, 6);
        const LineRelaxation lines = flow.relaxation(0.1);
        const std::vector<double> zero(flow.pad.size(), 0.0), solution = randomCells(flow.pad, 3);
        std::vector<double> b(flow.pad.size(), 0.0), v = solution;
        lines.residual(zero, solution, b);
        for (double& value : b) value = -value;
        lines.sweep(b, v);
        for (std::size_t at = 0; at < v.size(); ++at) QVERIFY(std::abs(v[at] - solution[at]) < 1e-9);
    }

    /// E = 1, no convection, v = (-1)^(i+j), b = 0, far from the outline. Even rows get (4 + 2) v = -2 (-1)^i, so -1/3;
    /// odd ones then -1/9. With those, even columns: 4 e - 2 o = 2/3, 4 o - 2 e = 2/9 on even and odd rows, so 7/27 and
    /// 5/27; then odd columns, of the other sign: 4 e - 2 o = 14/27, 4 o - 2 e = 10/27, so 19/81 and 17/81.
    void sweepsLinesInOrder()
    {
        Flow flow(64, 64);
        flow.forFaces([](std::size_t, double& effective, double&) { effective = 1.0; });
        const PaddedGrid& pad = flow.pad;
        std::vector<double> v(pad.size(), 0.0);
        const std::vector<double> b(pad.size(), 0.0);
        for (int j = 0; j < pad.ny; ++j)
            for (int i = 0; i < pad.nx; ++i) v[pad.at(i, j)] = (i + j) % 2 == 0 ? 1.0 : -1.0;
        flow.relaxation().sweep(b, v);
        QVERIFY(std::abs(v[pad.at(32, 32)] - 7.0 / 27) < 1e-12);
        QVERIFY(std::abs(v[pad.at(32, 33)] - 5.0 / 27) < 1e-12);
        QVERIFY(std::abs(v[pad.at(33, 32)] - 19.0 / 81) < 1e-12);
        QVERIFY(std::abs(v[pad.at(33, 33)] - 17.0 / 81) < 1e-12);
    }

    /// Neither faces nor weight: the cell gets no correction, and its neighbours none from it.
    void leavesClosedCellsAlone()
    {
        Flow flow = randomFlow(6, 6);
        const PaddedGrid& pad = flow.pad;
        const std::size_t closed = pad.at(3, 2);
        for (auto* pair : {&flow.effective, &flow.convection}) {
            (*pair)[0][closed] = (*pair)[0][closed + 1] = 0.0;
            (*pair)[1][closed] = (*pair)[1][closed + pad.stride()] = 0.0;
        }
        std::vector<double> b = randomCells(pad, 4), v(pad.size(), 0.0);
        b[closed] = 0.0;
        flow.relaxation().sweep(b, v);
        QCOMPARE(v[closed], 0.0);
        QVERIFY(std::isfinite(largest(v)) && largest(v) > 0.0);
    }
};

TOUCHDOWN_TEST(TestLineRelaxation)

} // namespace test_line_relaxation

#include "test_line_relaxation.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/path_flow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_path_flow {

/// A piece of a path along the axis, from `start` to `end`, the face at zero; F = c p - D dp/dx in it.
struct Piece {
    double start, end, c, D;
};

/// A path of pieces, upstream first; `against`: the disk moves against the axis, c < 0.
template <typename Number = double>
PathFlow<Number> flowOf(std::vector<Piece> pieces, double width = 1.0, double share = 1.0)
{
    const bool against = pieces.front().c < 0.0;
    if (against) std::reverse(pieces.begin(), pieces.end());
    PathIntegral<Number> path;
    for (const Piece& piece : pieces) {
        const double length = piece.end - piece.start, r = length / piece.D;
        path.add(Number(r), Number(std::abs(piece.c) * r), against ? -piece.end : piece.start, length);
    }
    PathFlow<Number> flow;
    flow.add(path, width, share, against);
    return flow;
}

/// The pressure at the upstream end for a pressure p at the downstream end, by the classical Runge-Kutta method against
/// the stream, in which direction errors die out. The flow at x is `flow` plus a slope before and another after the
/// face.
double upstreamPressure(const std::vector<Piece>& pieces, double p, double flow, double slopeBelow, double slopeAbove,
                        int steps)
{
    const auto across = [&](const Piece& piece, double from, double to) {
        const double middle = 0.5 * (piece.start + piece.end), dx = (to - from) / steps;
        const double slope = middle < 0.0 ? slopeBelow : slopeAbove;
        const auto change = [&](double x, double value) { return (piece.c * value - flow - slope * x) / piece.D; };
        for (int i = 0; i < steps; ++i) {
            const double x = from + i * dx;
            const double k1 = change(x, p), k2 = change(x + 0.5 * dx, p + 0.5 * dx * k1);
            const double k3 = change(x + 0.5 * dx, p + 0.5 * dx * k2), k4 = change(x + dx, p + dx * k3);
            p += dx / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
        }
    };
    if (pieces.front().c < 0.0)
        for (const Piece& piece : pieces) across(piece, piece.start, piece.end);
    else
        for (auto piece = pieces.rbegin(); piece != pieces.rend(); ++piece) across(*piece, piece->end, piece->start);
    return p;
}

std::vector<Piece> reversed(std::vector<Piece> pieces)
{
    for (Piece& piece : pieces) piece.c = -piece.c;
    return pieces;
}

void addPaths()
{
    QTest::addColumn<std::vector<Piece>>("pieces");
    const auto row = [](const char* name, const std::vector<Piece>& pieces) {
        QTest::addRow("%s", name) << pieces;
        QTest::addRow("%s, against the axis", name) << reversed(pieces);
    };
    row("one gap", {{-0.4, 0.0, 1.0, 0.7}, {0.0, 0.6, 1.0, 0.7}});
    row("Peclet 0.01", {{-0.5, 0.0, 0.01, 1.0}, {0.0, 0.5, 0.01, 1.0}});
    row("Peclet 1000", {{-0.5, 0.0, 5.0, 0.005}, {0.0, 0.5, 5.0, 0.005}});
    row("a step up before the face", {{-0.5, -0.2, 1.0, 0.5}, {-0.2, 0.0, 10.0, 500.0}, {0.0, 0.5, 10.0, 500.0}});
    row("a step down after the face", {{-0.5, 0.0, 10.0, 500.0}, {0.0, 0.1, 10.0, 500.0}, {0.1, 0.5, 1.0, 0.5}});
    row("a groove, Peclet 200 beside it",
        {{-0.5, -0.3, 2.0, 0.01}, {-0.3, 0.0, 9.0, 30.0}, {0.0, 0.2, 9.0, 30.0}, {0.2, 0.5, 2.0, 0.01}});
}

class TestPathFlow : public QObject {
    Q_OBJECT

private slots:
    /// phi(q) = (1 - exp(-q))/q and chi(q) = (1 - phi)/q in long double, on both sides of the change to series.
    void functions()
    {
        for (double q = 1e-3; q < 1e5; q *= 1.21) {
            const PathFunctions<double> f(q);
            const long double exact = q, phi = -std::expm1(-exact) / exact;
            // 1 - phi loses digits as q falls: from the series sum (-q)^k/(k + 2)! where it matters.
            long double chi = (1.0L - phi) / exact;
            if (q < 0.5) {
                long double term = 0.5L;
                chi = term;
                for (int k = 1; k < 20; ++k) chi += term *= -exact / (k + 2);
            }
            QVERIFY2(std::abs(f.phi / phi - 1.0L) < 1e-13L, qPrintable(QString::number(q)));
            // The series leaves out q^5/5040, 6e-11 at its end; the formula loses 1e-16/(q/2).
            QVERIFY2(std::abs(f.chi / chi - 1.0L) < 2e-10L, qPrintable(QString::number(q)));
            QCOMPARE(f.decay, std::exp(-q));
        }
        const PathFunctions<double> none(0.0);
        QCOMPARE(none.phi, 1.0);
        QCOMPARE(none.chi, 0.5);
        QCOMPARE(none.decay, 1.0);
    }

    /// Against Simpson's rule, on either side of zero.
    void signedMoments()
    {
        for (const double q : {-30.0, -3.0, -0.2, -0.1, -1e-3, 0.0, 1e-3, 0.2, 3.0, 30.0}) {
            constexpr int parts = 4000;
            std::array<long double, 3> sums{};
            for (int i = 0; i <= parts; ++i) {
                const long double s = static_cast<long double>(i) / parts;
                const long double weight = i == 0 || i == parts ? 1.0L : i % 2 == 1 ? 4.0L : 2.0L;
                const long double value = weight / (3.0L * parts) * std::exp(-q * s);
                sums[0] += value;
                sums[1] += value * s;
                sums[2] += value * s * s;
            }
            const DecayMoments m = signedDecayMoments(q);
            const std::array found{m.e0, m.e1, m.e2};
            for (std::size_t k = 0; k < 3; ++k)
                QVERIFY2(std::abs(found[k] / sums[k] - 1.0L) < 1e-9L, qPrintable(QString("%1 %2").arg(q).arg(k)));
            QVERIFY(std::abs(m.decay / std::exp(-q) - 1.0) < 1e-13);
        }
    }

    /// One gap, constant flow: F = c (p1 e - p2)/(e - 1), e = exp(c L/D).
    void oneGapIsExponentialFitting()
    {
        const double c = 0.9, D = 0.4, length = 1.5, e = std::exp(c * length / D);
        const PathFlow<double> flow = flowOf({{-1.0, 0.0, c, D}, {0.0, 0.5, c, D}}, 2.0);
        QVERIFY(std::abs(flow.A - 2.0 * c * e / (e - 1.0)) < 1e-13);
        QVERIFY(std::abs(flow.B - 2.0 * c / (e - 1.0)) < 1e-13);
        QVERIFY(std::abs(flow.K - 2.0 * D / length) < 1e-13);
    }

    /// Without convection pieces are resistors in series and paths in parallel, whatever the moments.
    void resistorsWithoutConvection()
    {
        PathFlow<double> flow = flowOf({{-1.0, 0.0, 0.0, 2.0}, {0.0, 3.0, 0.0, 0.5}}, 0.7, 0.7);
        QVERIFY(std::abs(flow.A - 0.7 / 6.5) < 1e-15);
        QVERIFY(std::abs(flow.B - 0.7 / 6.5) < 1e-15);
        QVERIFY(std::abs(flow.K - 0.7 / 6.5) < 1e-15);
        // Moments of w = 1/D: -1/2 * 1/2 = -1/4 below, 9/2 * 2 = 9 above, over 6.5.
        QVERIFY(std::abs(flow.below + 0.7 * 0.25 / 6.5) < 1e-15);
        QVERIFY(std::abs(flow.above - 0.7 * 9.0 / 6.5) < 1e-15);
    }

    /// The scheme is exact where the flow is linear on either side of the face: with the flow f at the face and slopes
    /// s1 and s2 the pressures at the ends belong together, so A p1 - B p2 - s1 m1 - s2 m2 = f.
    void linearFlowAgainstRungeKutta_data() { addPaths(); }
    void linearFlowAgainstRungeKutta()
    {
        QFETCH(std::vector<Piece>, pieces);
        const PathFlow<double> flow = flowOf(pieces);
        struct Case {
            double p, f, below, above;
        };
        for (const Case& k : {Case{1.0, 0.3, 0.0, 0.0}, Case{2.0, -0.4, 0.7, 0.0}, Case{1.5, 0.9, 0.0, -1.3},
                              Case{1.2, 0.5, 2.0, -1.0}}) {
            const double far = upstreamPressure(pieces, k.p, k.f, k.below, k.above, 4000);
            const bool against = pieces.front().c < 0.0;
            const double p1 = against ? k.p : far, p2 = against ? far : k.p;
            const double result = flow.A * p1 - flow.B * p2 - k.below * flow.below - k.above * flow.above;
            // The method's error: (step/(D/c))^4, at worst (2.5/4 steps per 1/e)^4 ... 1e-9; rounding of A p1 - B p2.
            QVERIFY2(std::abs(result - k.f) < 1e-9 * (1.0 + flow.A * p1), qPrintable(QString::number(result - k.f)));
        }
    }

    /// At a Peclet number of 1e4 nothing of the downstream pressure is left: F = c p1, and the flow at the face is what
    /// the upstream half passes. There w/I is exp(-c x/D) c/D about the upstream end, first moment D/c - length before
    /// the face.
    void convectionAlone()
    {
        const double c = 3.0, D = 3e-4, before = 0.4;
        for (const bool against : {false, true}) {
            const PathFlow<double> flow = against ? flowOf({{-0.6, 0.0, -c, D}, {0.0, before, -c, D}})
                                                  : flowOf({{-before, 0.0, c, D}, {0.0, 0.6, c, D}});
            QVERIFY(std::abs((against ? flow.B : flow.A) - c) < 1e-14);
            QCOMPARE(against ? flow.A : flow.B, 0.0);
            const double upstream = against ? flow.above : flow.below, downstream = against ? flow.below : flow.above;
            QVERIFY(std::abs(upstream - (against ? before - D / c : D / c - before)) < 1e-14);
            QVERIFY(std::abs(downstream) < 1e-100);
        }
    }

    /// m1 and m2 are the integrals of x w/I by Simpson's rule, w = exp(-Q)/D written out.
    void momentsAgainstQuadrature_data() { addPaths(); }
    void momentsAgainstQuadrature()
    {
        QFETCH(std::vector<Piece>, pieces);
        const PathFlow<double> flow = flowOf(pieces, 5.0, 0.25);
        const bool against = pieces.front().c < 0.0;
        std::vector<Piece> order = pieces;
        if (against) std::reverse(order.begin(), order.end());
        double Q = 0.0, I = 0.0, below = 0.0, above = 0.0;
        for (const Piece& piece : order) {
            const double length = piece.end - piece.start, rate = std::abs(piece.c) / piece.D;
            constexpr int steps = 20000;
            for (int i = 0; i <= steps; ++i) {
                const double s = length * i / steps, x = against ? piece.end - s : piece.start + s;
                const double weight = (i == 0 || i == steps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) * length / steps / 3.0;
                const double w = std::exp(-Q - rate * s) / piece.D * weight;
                I += w;
                (0.5 * (piece.start + piece.end) < 0.0 ? below : above) += x * w;
            }
            Q += rate * length;
        }
        QVERIFY(std::abs(flow.below - 0.25 * below / I) < 1e-9);
        QVERIFY(std::abs(flow.above - 0.25 * above / I) < 1e-9);
        // Simpson: (1000 * 0.5/20000)^4/180 = 2e-9 at most.
        QVERIFY(std::abs((against ? flow.B : flow.A) * I / 5.0 - 1.0) < 4e-9);
    }

    /// Dividing a gap into pieces changes nothing.
    void piecesOfOneGap()
    {
        for (const double c : {0.0, 0.03, 3.0, -3.0, 400.0}) {
            const PathFlow<double> coarse = flowOf({{-1.0, 0.0, c, 0.8}, {0.0, 1.0, c, 0.8}});
            const PathFlow<double> fine = flowOf({{-1.0, -0.7, c, 0.8},
                                                  {-0.7, -0.1, c, 0.8},
                                                  {-0.1, 0.0, c, 0.8},
                                                  {0.0, 0.25, c, 0.8},
                                                  {0.25, 1.0, c, 0.8}});
            // chi is good to 2e-10 at its change to the series.
            QVERIFY(std::abs(coarse.A - fine.A) < 1e-10 * coarse.A);
            QVERIFY(std::abs(coarse.B - fine.B) < 1e-10 * (coarse.A + coarse.B));
            QVERIFY(std::abs(coarse.below - fine.below) < 1e-9);
            QVERIFY(std::abs(coarse.above - fine.above) < 1e-9);
        }
    }

    /// Dual numbers carry the derivatives by a common factor of the mobility.
    void derivatives()
    {
        const auto flow = [](auto factor) {
            using Number = decltype(factor);
            PathIntegral<Number> path;
            for (const auto& [r, c, start, length] : {std::array{2.0, 0.4, -0.5, 0.5}, std::array{0.01, 3.0, 0.0, 0.4}})
                path.add(Number(r) / factor, Number(c * r) / factor, start, length);
            PathFlow<Number> result;
            result.add(path, 0.3, 0.3, true);
            return result;
        };
        const PathFlow<Dual<1>> exact = flow(Dual<1>::variable(1.3, 0));
        const PathFlow<double> up = flow(1.3 + 1e-5), down = flow(1.3 - 1e-5);
        const auto agrees = [&](double PathFlow<double>::*member, const Dual<1>& number) {
            return std::abs((up.*member - down.*member) / 2e-5 - number.by[0]) < 1e-9;
        };
        QVERIFY(agrees(&PathFlow<double>::A, exact.A));
        QVERIFY(agrees(&PathFlow<double>::B, exact.B));
        QVERIFY(agrees(&PathFlow<double>::K, exact.K));
        QVERIFY(agrees(&PathFlow<double>::below, exact.below));
        QVERIFY(agrees(&PathFlow<double>::above, exact.above));
    }
};

TOUCHDOWN_TEST(TestPathFlow)

} // namespace test_path_flow

#include "test_path_flow.moc"

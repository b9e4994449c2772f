// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/film_stencil.h"

#include <cmath>
#include <numbers>

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_film_stencil {

class TestFilmStencil : public QObject {
    Q_OBJECT

private slots:
    /// Each number where it belongs: small whole numbers, so that nothing is rounded. Of v = 1 in cell (2, 1) alone the
    /// cells around have what they have from that side; it has itself the sum less the eight, and what it stores.
    void unitCell()
    {
        const PaddedGrid pad{5, 4};
        FilmStencil stencil(pad);
        std::vector<double> v(pad.size(), 0.0), out(pad.size(), 0.0), volume(pad.size(), 0.0);
        for (int j = 0; j < pad.ny; ++j)
            for (int i = 0; i < pad.nx; ++i) {
                const std::size_t at = pad.at(i, j);
                for (std::size_t k = 0; k < 8; ++k) stencil.beside[k][at] = static_cast<float>(k + 1);
                stencil.sum[at] = 100.0f;
                volume[at] = 3.0;
                for (std::size_t axis = 0; axis < 2; ++axis) {
                    stencil.storedBelow[axis][at] = axis == 0 ? 0.5f : 0.25f;
                    stencil.storedAbove[axis][at] = axis == 0 ? -0.125f : -0.0625f;
                }
            }
        const std::size_t cell = pad.at(2, 1), up = pad.stride();
        v[cell] = 1.0;
        stencil.apply(v, 0.0, volume, out);
        const std::array<std::size_t, 8> beside{cell - up - 1, cell - up,     cell - up + 1, cell - 1,
                                                cell + 1,      cell + up - 1, cell + up,     cell + up + 1};
        for (std::size_t k = 0; k < 8; ++k) QCOMPARE(out[beside[k]], 8.0 - static_cast<double>(k)); // from the far side
        QCOMPARE(out[cell], 100.0 - 36.0);
        QCOMPARE(out[pad.at(0, 1)], 0.0);

        // It stores 2 * 3. Through the faces after it leave 0.5 and 0.25 of that; through those before it come
        // -0.125 and -0.0625, which go from the cells before.
        stencil.apply(v, 2.0, volume, out);
        QCOMPARE(out[cell], 64.0 + 6.0 * (1.0 + 0.5 + 0.125 + 0.25 + 0.0625));
        QCOMPARE(out[cell + 1], 4.0 - 6.0 * 0.5);
        QCOMPARE(out[cell - 1], 5.0 - 6.0 * 0.125);
        QCOMPARE(out[cell + up], 2.0 - 6.0 * 0.25);
        QCOMPARE(out[cell - up], 7.0 - 6.0 * 0.0625);
    }

    /// A face across y passes on 2 * 3 * (1/4) of the cell below and 2 * 5 * (-1/16) of the one above: F = 1.5 v1 -
    /// 0.625 v2, besides E = 7 and c = 1, of which c (v1 + v2)/2 - E (v2 - v1) = 7.5 v1 - 6.5 v2.
    void passesOnWhatIsStored()
    {
        const PaddedGrid pad{3, 4};
        FilmStencil stencil(pad);
        std::vector<double> volume(pad.size(), 0.0), E(pad.size(), 7.0), c(pad.size(), 1.0), effective(pad.size()),
            convection(pad.size());
        const std::size_t face = pad.at(1, 2);
        volume[face - pad.stride()] = 3.0;
        volume[face] = 5.0;
        stencil.storedBelow[1][face] = 0.25f;
        stencil.storedAbove[1][face] = -0.0625f;
        stencil.addStored(1, 2.0, volume, {E, c}, effective, convection);
        QCOMPARE(0.5 * convection[face] + effective[face], 7.5 + 1.5);    // by v1
        QCOMPARE(0.5 * convection[face] - effective[face], -6.5 - 0.625); // by v2
        QCOMPARE(effective[face + 1], 7.0);
        QCOMPARE(convection[face + 1], 1.0);
    }

    /// Five cells with conductances of a third, which single precision rounds by up to 2^-24 of itself: the smoothest
    /// mode, v = sin(pi (i + 1)/(n + 1)) sin(pi (j + 1)/(n + 1)), has J v = lambda v with lambda = (8/3) sin^2(pi/(2 (n
    /// + 1))), 3e-4 of the largest. It is as exact as the conductances; numbers times v itself would be wrong by
    /// 2^-24/3e-4.
    void smoothMode()
    {
        const int n = 120;
        const PaddedGrid pad{n, n};
        FilmStencil stencil(pad);
        std::vector<double> v(pad.size(), 0.0), out(pad.size(), 0.0), volume(pad.size(), 0.0);
        const double phase = std::numbers::pi / (n + 1), lambda = 8.0 / 3.0 * std::pow(std::sin(0.5 * phase), 2);
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                const std::size_t at = pad.at(i, j);
                for (const std::size_t k : {1, 3, 4, 6}) stencil.beside[k][at] = -1.0f / 3.0f;
                v[at] = std::sin(phase * (i + 1)) * std::sin(phase * (j + 1));
            }
        stencil.apply(v, 0.0, volume, out);
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) QVERIFY(std::abs(out[pad.at(i, j)] - lambda * v[pad.at(i, j)]) < 1e-7 * lambda);
    }
};

TOUCHDOWN_TEST(TestFilmStencil)

} // namespace test_film_stencil

#include "test_film_stencil.moc"

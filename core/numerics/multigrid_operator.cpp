// SPDX-License-Identifier: GPL-3.0-or-later
//
// What multigrid makes of an operator: stencils and their factors on each level.
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

#include "core/numerics/convection.h"
#include "core/numerics/multigrid.h"
#include "core/numerics/vector_clones.h"
#include "core/work/team.h"

namespace touchdown {

namespace {

constexpr int leastOfBlock = 2048; // of a block that is worth a thread
int leastRowsOf(int length) { return std::max(4, leastOfBlock / std::max(1, length)); }

constexpr double leastPivot = 1e-12;  // of the centre
constexpr double leastCentre = 1e-30; // of the largest; a cell below that, as one without an open face, keeps its value

/// Eight of them side by side, so that they run on vectors.
template <typename T>
TOUCHDOWN_VECTOR_CLONES double largest(std::span<const T> x)
{
    std::array<double, 8> most{};
    const std::size_t whole = x.size() / 8 * 8;
    for (std::size_t i = 0; i < whole; i += 8)
        for (std::size_t k = 0; k < 8; ++k) most[k] = std::max(most[k], std::abs(x[i + k]));
    for (std::size_t i = whole; i < x.size(); ++i) most[0] = std::max(most[0], std::abs(x[i]));
    return *std::max_element(most.begin(), most.end());
}

template <typename T>
double largestOfAll(std::span<const T> x)
{
    Team& team = Team::mine();
    std::array<double, 64> most{};
    const int count = static_cast<int>(x.size()), blocks = std::min(64, team.blocksOf(count, 4 * leastOfBlock));
    team.run(blocks, [&](int b, int) {
        const Block own = Team::block(count, b, blocks, 64);
        most[static_cast<std::size_t>(b)] =
            largest<T>(x.subspan(static_cast<std::size_t>(own.first), static_cast<std::size_t>(own.end - own.first)));
    });
    return *std::max_element(most.begin(), most.end());
}

/// Faces across x and across y of a row of cells, from its first cell's lower ones.
struct FaceRow {
    const double *ex, *cx, *ey, *cy;
};
template <typename Real, typename Number>
struct StencilRow {
    Real *west, *east, *south, *north;
    Number* centre;
};

template <typename T, typename Real, typename Number>
TOUCHDOWN_VECTOR_CLONES void setStencilRow(std::size_t count, std::size_t up, double scale, FaceRow faces,
                                           const T* mass, StencilRow<Real, Number> out)
{
    const double *ex = faces.ex, *cx = faces.cx, *ey = faces.ey, *cy = faces.cy;
    Real *west = out.west, *east = out.east, *south = out.south, *north = out.north;
    Number* centre = out.centre;
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) {
        east[k] = static_cast<Real>(scale * (0.5 * cx[k + 1] - ex[k + 1]));
        west[k] = static_cast<Real>(scale * (-0.5 * cx[k] - ex[k]));
        north[k] = static_cast<Real>(scale * (0.5 * cy[k + up] - ey[k + up]));
        south[k] = static_cast<Real>(scale * (-0.5 * cy[k] - ey[k]));
        const double flow = (0.5 * cx[k + 1] + ex[k + 1]) + (ex[k] - 0.5 * cx[k]) + (0.5 * cy[k + up] + ey[k + up]) +
                            (ey[k] - 0.5 * cy[k]);
        const T whole = scale * (flow + mass[k]);
        centre[k] = std::abs(whole) > leastCentre ? static_cast<Number>(whole) : Number(1);
    }
}

/// 1/(centre - taken), or 1/centre where next to nothing is left: of a line whose cells have no way out.
template <typename T>
inline T inversePivot(T centre, T taken)
{
    const T own = centre - taken;
    return 1.0 / (std::abs(own) > leastPivot * std::abs(centre) ? own : centre);
}

/// Lines of the factors. D is what the cells store, or what flows out of them where that is more; then the lines have
/// as much less in their centres, in proportion to the flows along x and y.
template <typename T, typename Number>
TOUCHDOWN_VECTOR_CLONES void setFactorRow(std::size_t count, std::size_t up, double scale, FaceRow faces, FaceRow flows,
                                          const T* mass, Number* D, Number* alongX, Number* alongY)
{
    const double *ex = faces.ex, *cx = faces.cx, *ey = faces.ey, *cy = faces.cy;
    const double *fx = flows.ex, *gx = flows.cx, *fy = flows.ey, *gy = flows.cy;
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) {
        const double ownX = scale * ((0.5 * cx[k + 1] + ex[k + 1]) + (ex[k] - 0.5 * cx[k]));
        const double ownY = scale * ((0.5 * cy[k + up] + ey[k + up]) + (ey[k] - 0.5 * cy[k]));
        const double flowX = scale * ((0.5 * gx[k + 1] + fx[k + 1]) + (fx[k] - 0.5 * gx[k]));
        const double flowY = scale * ((0.5 * gy[k + up] + fy[k + up]) + (fy[k] - 0.5 * gy[k]));
        const T stored = scale * mass[k];
        const double flow = flowX + flowY, size = std::abs(stored);
        const T most = size > flow ? stored : T(flow), less = size > flow ? T{} : most - stored;
        const double share = flow > 0.0 ? flowX / flow : 0.0;
        const bool open = std::abs(most) > leastCentre;
        D[k] = open ? static_cast<Number>(most) : Number(1);
        alongX[k] = open ? static_cast<Number>(most + ownX - share * less) : Number(1);
        alongY[k] = open ? static_cast<Number>(most + ownY - (1.0 - share) * less) : Number(1);
    }
}

/// In double precision.
inline double widened(double x) { return x; }
inline std::complex<double> widened(std::complex<float> x) { return x; }

/// 1/pivots of lines along x, several at once.
template <typename T, int lines, typename Real, typename Number>
void factorLines(std::size_t first, std::size_t apart, std::size_t n, const Real* west, const Real* east,
                 const Number* centre, Number* pivot)
{
    std::array<T, lines> last{};
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 0; k < lines; ++k) {
            const std::size_t at = first + k * apart + i;
            const auto couple = i > 0 ? widened(west[at]) * widened(east[at - 1]) : widened(Real{});
            last[k] = inversePivot(static_cast<T>(centre[at]), couple * last[k]);
            pivot[at] = static_cast<Number>(last[k]);
        }
}

/// Of lines along y, a row; below the first one the ring holds zero.
template <typename T, typename Real, typename Number>
void factorRow(std::size_t count, std::size_t up, const Real* south, const Real* north, const Number* centre,
               Number* pivot)
{
    const Real* northBelow = north - up;
    const Number* below = pivot - up;
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k)
        pivot[k] = static_cast<Number>(inversePivot(
            static_cast<T>(centre[k]), widened(south[k]) * widened(northBelow[k]) * static_cast<T>(below[k])));
}

/// A row of coefficients, scaled.
template <typename Number>
TOUCHDOWN_VECTOR_CLONES void scaleRow(std::size_t count, double scale, const float* in, Number* out)
{
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) out[k] = static_cast<float>(scale * in[k]);
}
template <typename T, typename Number>
TOUCHDOWN_VECTOR_CLONES void addScaledRow(std::size_t count, T scale, const float* in, Number* out)
{
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) out[k] += static_cast<Number>(scale * static_cast<double>(in[k]));
}

/// Centres of a row: the sums less those beside, plus the diagonal.
TOUCHDOWN_VECTOR_CLONES void setOwnRow(std::size_t count, const std::array<const float*, 8> beside, const float* sum,
                                       double* own)
{
    const auto [c0, c1, c2, c3, c4, c5, c6, c7] = beside;
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k)
        own[k] = sum[k] - ((c0[k] + c1[k] + c2[k]) + (c3[k] + c4[k]) + (c5[k] + c6[k] + c7[k]));
}
template <typename T, typename Number>
TOUCHDOWN_VECTOR_CLONES void setCentreRow(std::size_t count, double scale, const double* own, const T* mass, T rate,
                                          const double* stored, Number* centre)
{
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) {
        const T whole = scale * (own[k] + mass[k] + rate * stored[k]);
        centre[k] = std::abs(whole) > leastCentre ? static_cast<Number>(whole) : Number(1);
    }
}

template <typename Real, typename Number>
void multiplyRow(std::size_t count, const Number* pivot, const Real* factor, Number* out)
{
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) out[k] = factor[k] * pivot[k];
}

} // namespace

template <typename T>
void Multigrid<T>::setOperator(const std::array<FaceOperator, 2>& faces, std::span<const T> diagonal)
{
    const double most = std::max({largestOfAll<double>(faces[0].effective), largestOfAll<double>(faces[1].effective),
                                  largestOfAll<T>(diagonal)});
    scale_ = most > 0.0 ? std::ldexp(1.0, -std::ilogb(most)) : 1.0;
    hasNine_ = hasFactors_ = false;
    Source source{faces, diagonal.empty() ? std::span<const T>(noMass_) : diagonal};
    for (std::size_t l = 0;; ++l) {
        Level& level = levels_[l];
        setStencil(level, source);
        factor(level.pad, level.west, level.east, level.south, level.north, {level.centre, level.centre}, level.pivot);
        if (l + 1 == levels_.size()) break;
        CoarseSource& coarse = sources_[l];
        coarsen(level.pad, source, levels_[l + 1].pad, coarse);
        for (std::size_t axis = 0; axis < 2; ++axis)
            source.faces[axis] = {coarse.diffusion[axis], coarse.effective[axis], coarse.convection[axis]};
        source.mass = coarse.mass;
    }
}

template <typename T>
void Multigrid<T>::setFactors(const std::array<FaceOperator, 2>& faces, const std::array<FaceOperator, 2>& flows,
                              std::span<const T> diagonal)
{
    const PaddedGrid& pad = levels_.front().pad;
    const std::size_t n = static_cast<std::size_t>(pad.nx), up = pad.stride();
    hasFactors_ = true;
    const Level& level = levels_.front();
    Factors& f = factors_;
    reserveFactors();
    const auto setRow = [&](int j) {
        const std::size_t at = pad.at(0, j);
        const auto row = [&](const std::array<FaceOperator, 2>& of) {
            return FaceRow{&of[0].effective[at], &of[0].convection[at], &of[1].effective[at], &of[1].convection[at]};
        };
        setFactorRow<T>(n, up, scale_, row(faces), row(flows), &diagonal[at], &f.centre[at], &f.pivot[0][at],
                        &f.pivot[1][at]);
    };
    Team::mine().items(pad.ny, leastRowsOf(pad.nx), 1, [&](int first, int end, int) {
        for (int j = first; j < end; ++j) setRow(j);
    });
    factor(pad, level.west, level.east, level.south, level.north, {f.pivot[0], f.pivot[1]}, f.pivot);
    const auto multiply = [&](int j) {
        const std::size_t at = pad.at(0, j);
        const Number* pivot = &f.pivot[1][at];
        onVectors<Number, multiplyRow<Number, Number>>(n, pivot, &f.centre[at], &f.centre[at]);
        onVectors<Number, multiplyRow<Real, Number>>(n, pivot, &level.south[at], &f.south[at]);
        onVectors<Number, multiplyRow<Real, Number>>(n, pivot, &level.north[at], &f.north[at]);
    };
    Team::mine().items(pad.ny, leastRowsOf(pad.nx), 1, [&](int first, int end, int) {
        for (int j = first; j < end; ++j) multiply(j);
    });
}

template <typename T>
void Multigrid<T>::reserveFactors()
{
    Factors& f = factors_;
    for (auto* field : {&f.south, &f.north, &f.centre, &f.pivot[0], &f.pivot[1]})
        field->resize(levels_.front().pad.size());
}

template <typename T>
void Multigrid<T>::reserveNine()
{
    const PaddedGrid& pad = levels_.front().pad;
    for (auto& field : nine_.beside) field.resize(pad.size());
    for (auto& row : nine_.own) row.resize(static_cast<std::size_t>(threads_) * pad.stride());
    for (auto* field : {&nine_.centre, &nine_.pivot[0], &nine_.pivot[1]}) field->resize(pad.size());
}

template <typename T>
void Multigrid<T>::setFinest(const NinePoints& points, std::span<const T> diagonal, bool transposed,
                             const NinePoints& stored, T rate)
{
    const bool stores = !stored.sum.empty();
    const PaddedGrid& pad = levels_.front().pad;
    const std::size_t n = static_cast<std::size_t>(pad.nx);
    const std::ptrdiff_t up = static_cast<std::ptrdiff_t>(pad.stride());
    const std::array<std::ptrdiff_t, 8> offset{-up - 1, -up, -up + 1, -1, 1, up - 1, up, up + 1};
    reserveNine();
    std::ranges::fill(nine_.own[1], 0.0);
    hasNine_ = true;
    const std::span<const T> mass = diagonal.empty() ? std::span<const T>(noMass_) : diagonal;
    const auto setRow = [&](int j, int thread) {
        const std::size_t at = pad.at(0, j), work = static_cast<std::size_t>(thread) * pad.stride();
        const auto own = [&](const NinePoints& from, double* out) {
            std::array<const float*, 8> beside;
            for (std::size_t k = 0; k < 8; ++k) beside[k] = &from.beside[k][at];
            setOwnRow(n, beside, &from.sum[at], out);
        };
        for (std::size_t k = 0; k < 8; ++k) {
            // Transposed: this cell's coefficient in that neighbour's row.
            const std::size_t from = transposed ? 7 - k : k;
            const std::size_t first = transposed ? at + static_cast<std::size_t>(offset[k]) : at;
            scaleRow(n, scale_, points.beside[from].data() + first, &nine_.beside[k][at]);
            if (stores) addScaledRow(n, scale_ * rate, stored.beside[from].data() + first, &nine_.beside[k][at]);
        }
        own(points, &nine_.own[0][work]);
        if (stores) own(stored, &nine_.own[1][work]);
        setCentreRow(n, scale_, &nine_.own[0][work], &mass[at], rate, &nine_.own[1][work], &nine_.centre[at]);
    };
    Team::mine().items(pad.ny, least(pad.ny, leastRowsOf(pad.nx)), 1, [&](int first, int end, int thread) {
        for (int j = first; j < end; ++j) setRow(j, thread);
    });
    factor(pad, nine_.beside[3], nine_.beside[4], nine_.beside[1], nine_.beside[6], {nine_.centre, nine_.centre},
           nine_.pivot);
}

template <typename T>
void Multigrid<T>::setStencil(Level& level, const Source& source)
{
    const FaceOperator &x = source.faces[0], &y = source.faces[1];
    const auto setRow = [&](int j) {
        const std::size_t at = level.pad.at(0, j);
        setStencilRow<T>(static_cast<std::size_t>(level.pad.nx), level.pad.stride(), scale_,
                         FaceRow{&x.effective[at], &x.convection[at], &y.effective[at], &y.convection[at]},
                         &source.mass[at],
                         StencilRow<Real, Number>{&level.west[at], &level.east[at], &level.south[at], &level.north[at],
                                                  &level.centre[at]});
    };
    Team::mine().items(level.pad.ny, leastRowsOf(level.pad.nx), 1, [&](int first, int end, int) {
        for (int j = first; j < end; ++j) setRow(j);
    });
    // The rings hold zero: what multiplies them is never needed.
}

template <typename T>
template <typename Beside>
void Multigrid<T>::factor(const PaddedGrid& pad, const std::vector<Beside>& west, const std::vector<Beside>& east,
                          const std::vector<Beside>& south, const std::vector<Beside>& north, const Centres& centre,
                          std::array<std::vector<Number>, 2>& pivot)
{
    const std::size_t up = pad.stride(), n = static_cast<std::size_t>(pad.nx);
    const auto factor = [&]<int lines>(int j) {
        factorLines<T, lines>(pad.at(0, j), up, n, west.data(), east.data(), centre[0].data(), pivot[0].data());
    };
    Team& team = Team::mine();
    team.items(pad.ny, leastRowsOf(pad.nx), 4, [&](int first, int end, int) {
        for (; first + 3 < end; first += 4) factor.template operator()<4>(first);
        for (; first < end; ++first) factor.template operator()<1>(first);
    });
    team.items(pad.nx, leastRowsOf(pad.ny), 16, [&](int first, int end, int) {
        for (int j = 0; j < pad.ny; ++j) {
            const std::size_t at = pad.at(first, j);
            onVectors<Number, factorRow<T, Beside, Number>>(static_cast<std::size_t>(end - first), up, &south[at],
                                                            &north[at], &centre[1][at], &pivot[1][at]);
        }
    });
}

template <typename T>
void Multigrid<T>::coarsen(const PaddedGrid& from, const Source& fine, const PaddedGrid& to, CoarseSource& coarse)
{
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const std::size_t step = from.step(static_cast<int>(axis)), across = from.step(axis == 0 ? 1 : 0);
        const int n = axis == 0 ? from.nx : from.ny, nAcross = axis == 0 ? from.ny : from.nx;
        const std::span<const double> K = fine.faces[axis].diffusion;
        const auto setRow = [&](int j) {
            for (int i = 0; i < to.nx + (axis == 0); ++i) {
                const int line = axis == 0 ? i : j, side = axis == 0 ? j : i;
                const int fineLine = std::min(2 * line, n);
                const std::size_t first = axis == 0 ? from.at(fineLine, 2 * side) : from.at(2 * side, fineLine);
                double diffusion = 0.0, convection = 0.0;
                for (int k = 0; k < 2 && 2 * side + k < nAcross; ++k) {
                    const std::size_t at = first + static_cast<std::size_t>(k) * across;
                    convection += fine.faces[axis].convection[at];
                    // Half a path inside the coarse cell below, the face itself, half a path inside the one above.
                    const bool open = K[at] > 0.0;
                    const double below = fineLine > 1 ? K[at - step] : 0.0;
                    const double above = fineLine < n - 1 ? K[at + step] : 0.0;
                    const bool pairBelow = fineLine > 1 && (fineLine % 2 == 0); // the coarse cell below has two cells
                    const bool pairAbove = fineLine < n - 1;
                    if (!open || (pairBelow && below <= 0.0) || (pairAbove && above <= 0.0)) continue;
                    diffusion +=
                        1.0 / (1.0 / K[at] + (pairBelow ? 0.5 / below : 0.0) + (pairAbove ? 0.5 / above : 0.0));
                }
                const std::size_t at = to.at(i, j);
                coarse.diffusion[axis][at] = diffusion;
                coarse.convection[axis][at] = convection;
                coarse.effective[axis][at] =
                    effectiveConductance<ConvectionScheme::Exponential>(diffusion, convection).value;
            }
        };
        Team::mine().items(to.ny + (axis == 1), std::max(4, leastRowsOf(to.nx) / 4), 1, [&](int first, int end, int) {
            for (int j = first; j < end; ++j) setRow(j);
        });
    }
    for (int j = 0; j < to.ny; ++j)
        for (int i = 0; i < to.nx; ++i) {
            T sum{};
            for (int b = 2 * j; b < std::min(2 * j + 2, from.ny); ++b)
                for (int a = 2 * i; a < std::min(2 * i + 2, from.nx); ++a) sum += fine.mass[from.at(a, b)];
            coarse.mass[to.at(i, j)] = sum;
        }
}

template void Multigrid<double>::setFinest(const NinePoints&, std::span<const double>, bool, const NinePoints&, double);
template void Multigrid<std::complex<double>>::setFinest(const NinePoints&, std::span<const std::complex<double>>, bool,
                                                         const NinePoints&, std::complex<double>);
template void Multigrid<double>::reserveNine();
template void Multigrid<double>::reserveFactors();
template void Multigrid<std::complex<double>>::reserveFactors();
template void Multigrid<double>::setFactors(const std::array<FaceOperator, 2>&, const std::array<FaceOperator, 2>&,
                                            std::span<const double>);
template void Multigrid<double>::setOperator(const std::array<FaceOperator, 2>&, std::span<const double>);
template void Multigrid<std::complex<double>>::setOperator(const std::array<FaceOperator, 2>&,
                                                           std::span<const std::complex<double>>);

} // namespace touchdown

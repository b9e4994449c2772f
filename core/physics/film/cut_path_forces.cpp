// SPDX-License-Identifier: GPL-3.0-or-later
//
// Excess of the pressure between two cell centres over the cells' own, and the shear of its gradient. Profile of a
// constant flow F (path_flow.h), from the downstream end with pressure p2: the pressure is a p2 + b F at the downstream
// end of a piece of length l,
//
//   a phi p2 + (b phi + r chi) F in the mean over it,   at its other end a <- a exp(-q), b <- b exp(-q) + r phi,
//
// and p1 at the upstream end, which gives F. The excess is the sum of l mean less that of the cells' pressures; the
// shear is -(h/2)(p2 - p1) times the width, h weighted by resistance.
#include <algorithm>

#include "core/numerics/vector_clones.h"
#include "core/physics/film/cut_paths.h"
#include "core/physics/film/flow_table.h"
#include "core/physics/film/gaps/film_gaps.h"
#include "core/physics/film/path_flow.h"

namespace touchdown {

namespace {

using ByEnd = Dual<4>; // mean pressure, attitude
using ByAll = Dual<5>; // pressure below, above, attitude

/// Sums along the paths of rows, from their downstream ends.
template <typename Number>
struct ForceLanes {
    Lanes<Number> a, b, byEnd, byFlow, R, weighted; // A, B: integral of the pressure, by p2 and by F

    ForceLanes(double* first, std::size_t rows)
        : a(first, rows),
          b(first + a.parts * rows, rows),
          byEnd(first + 2 * a.parts * rows, rows),
          byFlow(first + 3 * a.parts * rows, rows),
          R(first + 4 * a.parts * rows, rows),
          weighted(first + 5 * a.parts * rows, rows)
    {}
};

/// The same piece of many rows.
struct LoadLanes {
    const double *gap, *mobility, *byProduct, *byGap, *mean, *x, *y, *extent, *speed, *drift;
    double length, halfWidth; // of the slider [m]
    double least;             // gap [m]
};

template <bool layers, typename Number>
TOUCHDOWN_VECTOR_CLONES void addPieces(const ForceLanes<Number> path, const LoadLanes piece, double* open,
                                       std::size_t rows, double viscosity)
{
    const double *gap = piece.gap, *G = piece.mobility, *byProduct = piece.byProduct, *byGap = piece.byGap,
                 *mean = piece.mean;
    const double *x = piece.x, *y = piece.y, *extent = piece.extent, *speed = piece.speed, *drift = piece.drift;
    const double length = piece.length, halfWidth = piece.halfWidth;
#pragma GCC ivdep
    for (std::size_t k = 0; k < rows; ++k) {
        const bool passes = gap[k] > closedGap;
        Number h(passes ? gap[k] : 1.0), mobility(G[k]);
        if constexpr (derivatives<Number> == 4) {
            const double free = gap[k] > piece.least ? 1.0 : 0.0;
            h.by = {0.0, free, free * (length - x[k]), free * (halfWidth - y[k])};
            const double slope = byProduct[k] * mean[k] + byGap[k];
            mobility.by = {byProduct[k] * gap[k], slope * h.by[1], slope * h.by[2], slope * h.by[3]};
        }
        const Number r = (12.0 * viscosity * extent[k]) / (h * h * mobility), hr = h * r;
        if constexpr (layers) {
            const Number q = speed[k] * hr - drift[k] * r;
            const PathFunctions<Number> f(q, signedDecayMoments(valueOf(q)));
            const Number a = path.a.get(k), b = path.b.get(k), alongPiece = r * f.phi;
            path.byEnd.set(k, path.byEnd.get(k) + extent[k] * (a * f.phi));
            path.byFlow.set(k, path.byFlow.get(k) + extent[k] * (b * f.phi + r * f.chi));
            path.a.set(k, a * f.decay);
            path.b.set(k, b * f.decay + alongPiece);
        }
        path.R.set(k, path.R.get(k) + r);
        path.weighted.set(k, path.weighted.get(k) + hr);
        open[k] = passes ? open[k] : 0.0;
    }
}

/// The rows' ends, upstream and downstream.
struct RowLanes {
    const double *before, *beyond, *upstream, *downstream, *width, *direction; // [Pa], [m], [m], [-]
};

/// In place of the sums: the excess in `byEnd`, the drag in `R`, with their derivatives at constant end pressures; and
/// in the first parts of `a` and `b`, the excess's derivatives by the pressures upstream and downstream.
template <bool layers, typename Number>
TOUCHDOWN_VECTOR_CLONES void finish(const ForceLanes<Number> path, const RowLanes row, const double* open,
                                    std::size_t rows)
{
    const double *before = row.before, *beyond = row.beyond, *upstream = row.upstream, *downstream = row.downstream;
    const double *width = row.width, *direction = row.direction;
#pragma GCC ivdep
    for (std::size_t k = 0; k < rows; ++k) {
        const double share = open[k] * width[k];
        const Number perDrop = (0.5 * share * direction[k]) * (path.weighted.get(k) / path.R.get(k));
        path.R.set(k, (before[k] - beyond[k]) * perDrop);
        path.weighted.set(k, perDrop);
        if constexpr (layers) {
            const Number a = path.a.get(k), mean = path.byFlow.get(k) / path.b.get(k);
            const Number byBefore = mean, byBeyond = path.byEnd.get(k) - a * mean;
            path.byEnd.set(k, share * ((before[k] * byBefore + beyond[k] * byBeyond) -
                                       (before[k] * upstream[k] + beyond[k] * downstream[k])));
            path.a.part[0][k] = share * (valueOf(byBefore) - upstream[k]);
            path.b.part[0][k] = share * (valueOf(byBeyond) - downstream[k]);
        }
    }
}

} // namespace

template <typename Number>
void CutPaths::forces(bool layers, std::span<const double> p, const Attitude& attitude, std::span<const double> surface,
                      const FlowTable& table, double viscosity, std::span<Work> works,
                      std::vector<CutForces<Number>>& out) const
{
    constexpr bool plain = derivatives<Number> == 0;
    using Sum = std::conditional_t<plain, double, ByEnd>;
    const std::vector<CutPlace>& cut = gaps_->faces[axis_].cut;
    const std::size_t step = gaps_->pad.step(static_cast<int>(axis_));
    constexpr std::size_t parts = Lanes<Sum>::parts;
    std::vector<double>& paths = works[0].path_;
    if (paths.size() < 6 * parts * face_.size()) paths.resize(6 * parts * face_.size());
    const auto lanes = [&](const Group& group) {
        return ForceLanes<Sum>(paths.data() + 6 * parts * group.row, group.rows);
    };
    forGroups(works, [&](const Group& group, Work& work) {
        const std::size_t rows = group.rows;
        setMobilities(group, p, attitude, surface, table, work);
        if constexpr (!plain)
            for (std::size_t in = 0; in < rows * group.depth; ++in)
                work.byGap_[in] = table.gapDerivative(work.product_[in], work.gap_[in]);
        for (std::size_t k = 0; k < rows; ++k) {
            const std::size_t at = cut[face_[group.row + k]].at;
            const bool against = direction_[group.row + k] < 0.0;
            work.before_[k] = p[against ? at : at - step];
            work.beyond_[k] = p[against ? at - step : at];
        }
        const ForceLanes<Sum> path = lanes(group);
        std::fill_n(path.a.part[0], 6 * parts * rows, 0.0);
        std::fill_n(path.a.part[0], rows, 1.0);
        for (std::size_t n = group.depth; n-- > 0;) {
            const std::size_t in = n * rows, from = group.piece + in;
            const LoadLanes piece{&work.gap_[in],   &work.mobility_[in], &work.mobilityBy_[in],
                                  &work.byGap_[in], work.mean_.data(),   &x_[from],
                                  &y_[from],        &extent_[from],      &speed_[group.row],
                                  &drift_[from],    gaps_->length,       0.5 * gaps_->width,
                                  leastGap_};
            if (layers)
                addPieces<true, Sum>(path, piece, work.open_.data(), rows, viscosity);
            else
                addPieces<false, Sum>(path, piece, work.open_.data(), rows, viscosity);
        }
        const RowLanes row{work.before_.data(),     work.beyond_.data(), &upstream_[group.row],
                           &downstream_[group.row], &width_[group.row],  &direction_[group.row]};
        if (layers)
            finish<true, Sum>(path, row, work.open_.data(), rows);
        else
            finish<false, Sum>(path, row, work.open_.data(), rows);
    });
    sumByFace(out, [&](CutForces<Number>& force, const Group& group, std::size_t k, std::size_t row) {
        const ForceLanes<Sum> path = lanes(group);
        const Sum excess = path.byEnd.get(k), drag = path.R.get(k);
        if constexpr (plain) {
            force.excess += excess;
            force.drag += drag;
        } else {
            // The mean pressure is half of either.
            const bool against = direction_[row] < 0.0;
            const double upstream = path.a.part[0][k], downstream = path.b.part[0][k];
            const double perDrop = direction_[row] * path.weighted.part[0][k];
            const auto add = [&](ByAll& to, const Sum& from, double below, double above) {
                to.value += from.value;
                to.by[0] += 0.5 * from.by[0] + below;
                to.by[1] += 0.5 * from.by[0] + above;
                for (std::size_t m = 0; m < 3; ++m) to.by[m + 2] += from.by[m + 1];
            };
            if (layers) add(force.excess, excess, against ? downstream : upstream, against ? upstream : downstream);
            add(force.drag, drag, perDrop, -perDrop);
        }
    });
}

template void CutPaths::forces(bool, std::span<const double>, const Attitude&, std::span<const double>,
                               const FlowTable&, double, std::span<Work>, std::vector<CutForces<double>>&) const;
template void CutPaths::forces(bool, std::span<const double>, const Attitude&, std::span<const double>,
                               const FlowTable&, double, std::span<Work>, std::vector<CutForces<Dual<5>>>&) const;

} // namespace touchdown

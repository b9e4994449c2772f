// SPDX-License-Identifier: GPL-3.0-or-later
//
// The generalised Reynolds equation of a compressible, isothermal, rarefied film on cells (Fukui & Kaneko 1988):
//
//   div( Q p h^3 grad p/(12 mu) - p h U/2 ) = d(p h)/dt,   p = p0 on the slider's outline.
//
// Finite volumes: the net outflow of each cell is R(p) = 0. A face passes F = c pm - E (p2 - p1) + the correction below, with
// pm = (p1 + p2)/2, c = U/2 times the gap (times width), K the conductance h^2 G(p h)/(12 mu) of the path between the
// centres (gaps in series harmonically, rows side by side added), E(K, c) the scheme's effective conductance. The limited
// scheme takes back the numerical diffusion E - K where the pressure is smooth (van Albada's limiter), which makes it
// second order; at extrema and jumps it falls back to exponential fitting, which does not overshoot.
//
// No air where the gap is closed: such faces pass nothing, and a cell without an open face keeps its pressure.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/numerics/convection.h"
#include "core/physics/disk_velocity.h"
#include "core/physics/film_forces.h"
#include "core/physics/film_gaps.h"
#include "core/physics/flow_table.h"

namespace touchdown {

struct FilmSetting {
    Air air;
    Slip slip;
    DiskMotion disk;
    ConvectionScheme scheme = ConvectionScheme::Limited;
};

/// The linearised film: what a face's flow answers to the pressures beside it, and a monotone approximation of it that
/// multigrid can coarsen. Padded arrays, by face.
struct LinearisedFaces {
    std::vector<double> lower, upper, far; // dF/dp of the cells below and above, and of the next one upstream [m^3/s]
    std::vector<double> diffusion;  // K [m^3/s]
    std::vector<double> effective;  // E of the monotone part [m^3/s]
    std::vector<double> convection; // its convective part, dF/dp1 + dF/dp2 [m^3/s]
    std::vector<std::uint8_t> downward; // the flow runs from the upper cell to the lower
};

/// Pressures are absolute [Pa], in padded arrays whose rings hold p0; residuals are net outflows [Pa m^3/s].
class GasFilm {
public:
    GasFilm(const FilmGaps& gaps, const FilmSetting& setting);

    const FilmGaps& gaps() const { return gaps_; }
    const PaddedGrid& pad() const { return gaps_.pad; }
    double ambient() const { return setting_.air.pressure; }
    const Attitude& attitude() const { return attitude_; }
    /// Flow that sweeps through the film at ambient pressure: the scale of residuals [Pa m^3/s].
    double flowScale() const { return flowScale_; }

    void setAttitude(const Attitude& attitude);

    /// R(p) alone, and R(p) with the linearisation at p.
    void residual(std::span<const double> p, std::span<double> out);
    void linearise(std::span<const double> p, std::span<double> out);
    /// The linearisation of the last call.
    const std::array<LinearisedFaces, 2>& faces() const { return linear_; }
    /// out = dR/dp v, exactly (v zero in its rings).
    template <typename T>
    void applyJacobian(std::span<const T> v, std::span<T> out) const;
    /// out = (dR/dp)^T v.
    void applyTransposedJacobian(std::span<const double> v, std::span<double> out) const;
    /// dR/dheight [Pa m^2/s], dR/dpitch, dR/droll [Pa m^3/s per rad] at p, the pressure of the last linearisation.
    void attitudeColumns(std::span<const double> p, std::array<std::vector<double>, 3>& out) const;

    /// Volume of air under each cell, at least zero [m^3]; padded.
    const std::vector<double>& volumes() const { return volume_; }
    /// Area of each cell [m^2]; padded, zero in the rings.
    const std::vector<double>& areas() const { return area_; }
    /// Mean gap over each cell [m]; padded.
    double meanGap(int i, int j) const;

    FilmForces forces(std::span<const double> p) const;
    /// Shear on the slider and its derivatives, for balances that count it.
    struct Shear {
        std::array<double, 2> force{};                   // along x, y [N]
        std::array<std::array<double, 3>, 2> byAttitude{}; // by height [N/m], pitch and roll [N/rad]
    };
    /// With `byPressure`, also dforce/dp of each cell, padded [N/Pa].
    Shear shear(std::span<const double> p, std::array<std::vector<double>, 2>* byPressure = nullptr) const;

private:
    struct AxisState {
        std::vector<double> gap;        // at smooth faces; zero at cut ones [m]
        std::vector<double> speed;      // of the disk along the axis, halved [m/s]
        std::vector<double> width;      // of the face by cross index [m]
        std::vector<double> K, dK;      // conductance [m^3/s] and its derivative by pm
        std::vector<double> H, dH;      // gap times width [m^2], derivative by pm
    };
    struct PathFlow {
        double K, H;   // as above
        double dK, dH; // by pm
    };

    /// dK [m^2/s], dH [m] by height; [m^3/s], [m^2] by pitch and roll.
    struct AttitudeSlopes {
        std::array<double, 3> K{}, H{};
    };
    struct LimitedDifference {
        double value = 0.0;                      // limited p2 - p1 [Pa]
        double byUpstream = 0.0, byLocal = 0.0;  // by the difference upstream and by p2 - p1 [-]
    };

    std::array<double, 3> liftDirections(double x, double y) const
    {
        return {1.0, gaps_.length - x, 0.5 * gaps_.width - y};
    }
    LimitedDifference limitedDifference(std::size_t axis, std::size_t at, std::size_t line, std::span<const double> p,
                                        bool downward) const;
    void clearRings(std::span<double> field) const;
    AttitudeSlopes slopesAt(std::size_t axis, std::size_t at, int i, int j, double pm) const;
    AttitudeSlopes cutSlopes(const CutPlace& place, double pm) const;
    template <ConvectionScheme scheme>
    void addAttitudeFlow(std::size_t axis, std::size_t at, std::size_t line, const AttitudeSlopes& slopes,
                         std::span<const double> p, std::array<std::vector<double>, 3>& out) const;
    void setConductances(std::span<const double> p);
    PathFlow cutFlow(const CutPlace& place, double pm) const;
    template <ConvectionScheme scheme, bool linearise>
    void flows(int axis, std::span<const double> p, std::span<double> out);
    template <bool linearise>
    void flowsOfScheme(std::span<const double> p, std::span<double> out);

    static constexpr double closedGap = 1e-12; // a gap below this passes no air [m]

    const FilmGaps& gaps_;
    FilmSetting setting_;
    FlowTable table_;
    Attitude attitude_;
    double flowScale_ = 0.0;
    std::array<AxisState, 2> axes_;
    std::array<LinearisedFaces, 2> linear_;
    std::vector<double> volume_, area_;
};

// Inline: the innermost part of the flow through a face.
inline GasFilm::LimitedDifference GasFilm::limitedDifference(std::size_t axis, std::size_t at, std::size_t line,
                                                             std::span<const double> p, bool downward) const
{
    const std::vector<double>& lengths = gaps_.faces[axis].pathLength;
    const std::size_t step = gaps_.pad.step(static_cast<int>(axis));
    const std::size_t beyond = downward ? std::min(line + 1, lengths.size() - 1) : line - (line > 0);
    const double scale = lengths[line] / lengths[beyond];
    const double b = p[at] - p[at - step];
    const double a = scale * (downward ? p[at + step] - p[at] : p[at - step] - p[at - 2 * step]);
    if (!(a * b > 0.0)) return {};
    // van Albada et al. 1982
    const double sum = a * a + b * b;
    const double value = a * b * (a + b) / sum;
    return {value, scale * (2.0 * a * b + b * b - 2.0 * a * value) / sum,
            (a * a + 2.0 * a * b - 2.0 * b * value) / sum};
}

} // namespace touchdown

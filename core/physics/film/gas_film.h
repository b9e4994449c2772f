// SPDX-License-Identifier: GPL-3.0-or-later
//
// The generalised Reynolds equation of a compressible, isothermal, rarefied film on cells (Fukui & Kaneko 1988):
//
//   div( Q p h^3 grad p/(12 mu) - p h U/2 ) = d(p h)/dt,   p = p0 on the slider's outline.
//
// Finite volumes: the net outflow of each cell is R(p) = 0. A face passes what a path from one cell centre to the next
// does (core/physics/film/path_flow.h): a path that an edge or a wall crosses goes through its pieces; a smooth one has
// the gap at its middle. The scheme decides on smooth faces between upwind, hybrid, power law and exponential fitting
// (convection.h); the complete flux scheme adds what the flow across each path changes along it, and is second order.
// That correction d is limited to d/sqrt(1 + (d/F)^2), F the flow that the upstream cell alone would send: a change of
// third order where the pressure is smooth, and no cell is emptied below zero.
//
// In time, cells store R = V dp/dt + p dV/dt besides, by a formula alpha V p - history; the complete flux scheme counts
// it among what feeds and drains the flow along a path.
//
// No air where the gap is closed: such faces pass nothing, and a cell without an open face keeps its pressure.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/numerics/convection.h"
#include "core/numerics/dual.h"
#include "core/physics/disk/disk_velocity.h"
#include "core/physics/film/cut_paths.h"
#include "core/physics/film/film_forces.h"
#include "core/physics/film/film_gaps.h"
#include "core/physics/film/film_stencil.h"
#include "core/physics/film/flow_table.h"
#include "core/physics/film/path_flow.h"

namespace touchdown {

struct FilmSetting {
    Air air;
    Slip slip;
    DiskMotion disk;
    ConvectionScheme scheme = ConvectionScheme::CompleteFlux;
};

/// The flow through the faces across one axis, linearised. Padded arrays, by face.
struct FilmFaces {
    std::vector<double> flow;               // without what the flow across adds [Pa m^3/s]
    std::vector<double> inflow;             // what the upstream cell would send without the other one [Pa m^3/s]
    std::vector<double> lower, upper;       // the flow's derivatives by the pressures below and above [m^3/s]
    std::vector<double> share, inflowShare; // derivatives of the limited correction by the full one, by the inflow [-]
    std::vector<double> below, above; // moments times share: by the slopes; zero unless the scheme is complete flux [m]
    std::vector<double> ownLower, ownUpper; // what the correction's own change adds to `lower` and `upper` [m^3/s]
    std::vector<double> diffusion;          // K, for multigrid [m^3/s]
    std::vector<double> effective;          // E >= |convection|/2 [m^3/s]
    std::vector<double> convection;         // lower + upper [m^3/s]
};

/// What the flows through smooth faces across one axis, and the part of their corrections that the correction's own
/// change makes, answer to the gap in the middle of the path and to its rise along the path. Padded, by face.
struct GapSlopes {
    std::vector<double> flowByGap, flowByRise, ownByGap, ownByRise; // [Pa m^2/s]
};

/// What a row of faces needs besides until its flows are complete: the paths' moments and their derivatives by the mean
/// pressure [m], [m/Pa], and the inflow's by the pressures [m^3/s].
struct FaceMoments {
    std::vector<double> below, above, belowByMean, aboveByMean, inflowByLower, inflowByUpper;
};

/// Flows through the faces across x and across y, with each cell's slopes and what it stores: padded work space.
template <typename T>
struct FaceFlows {
    std::array<std::vector<T>, 2> flow, slope;
    std::vector<T> stored; // empty: nothing
    void resize(std::size_t size)
    {
        for (auto* pair : {&flow, &slope})
            for (auto& field : *pair) field.assign(size, T{});
        stored.reserve(size);
    }
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

    /// Of the air under the slider [m^3].
    double totalVolume() const { return totalVolume_; }

    /// The disk's surface under each cell: mean height above the mean plane, less what contact presses it down [m];
    /// padded, its rings are not read. Empty: flat. Taken by setAttitude, and must last unchanged until the next one. A
    /// smooth face has the mean of its two cells' heights, and their difference in the tilt of its gap; all pieces of a
    /// cut place have that of their face, or of their cell.
    void setSurface(std::span<const double> height) { surface_ = height; }
    void setAttitude(const Attitude& attitude);

    /// From now on each cell stores perTime V p - history [1/s], [Pa m^3/s], V its volume at the attitude; with perTime
    /// zero, nothing. The history (padded) is read at each residual and must last.
    void setStorage(double perTime, std::span<const double> history);
    double storagePerTime() const { return storagePerTime_; }
    std::span<const double> storageHistory() const { return history_; }

    /// R(p) alone, and R(p) with the linearisation at p.
    void residual(std::span<const double> p, std::span<double> out);
    void linearise(std::span<const double> p, std::span<double> out);
    /// The last linearisation; flow and inflow of the last residual.
    const std::array<FilmFaces, 2>& faces() const { return faces_; }
    /// Of the disk along an axis at the faces across it, halved; padded [m/s].
    std::span<const double> halfSpeeds(std::size_t axis) const { return axes_[axis].speed; }
    /// The linearisation without what the cells store, and what their faces pass on of that.
    void setStencil(FilmStencil& out) const;
    /// out = dR/dp v, exactly (v zero in its rings); the cells store perTime V v, perTime any number, or that of
    /// setStorage.
    template <typename T>
    void applyJacobian(std::span<const T> v, std::span<T> out, FaceFlows<T>& work, T perTime) const;
    template <typename T>
    void applyJacobian(std::span<const T> v, std::span<T> out, FaceFlows<T>& work) const
    {
        applyJacobian(v, out, work, T(storagePerTime_));
    }
    /// out = (dR/dp)^T v.
    void applyTransposedJacobian(std::span<const double> v, std::span<double> out, FaceFlows<double>& work) const;
    /// dR/dheight [Pa m^2/s], dR/dpitch, dR/droll [Pa m^3/s per rad] at p, the pressure of the last linearisation.
    void attitudeColumns(std::span<const double> p, std::array<std::vector<double>, 3>& out) const;
    /// What these have of storage, against its rate: d^2R/(da dperTime) [Pa m^2], [Pa m^3 per rad].
    void attitudeStorageColumns(std::span<const double> p, std::array<std::vector<double>, 3>& out) const;

    /// Volume of air under each cell, at least zero [m^3]; padded.
    const std::vector<double>& volumes() const { return volume_; }
    /// Area of each cell [m^2]; padded, zero in the rings.
    const std::vector<double>& areas() const { return area_; }
    /// Mean gap over each cell [m]; padded.
    double meanGap(int i, int j) const;

    /// What the pressure above ambient amounts to: force [N], pitch and roll torque about the slider's centre [N m]. A
    /// cell counts its pressure times its area; across a face that an edge or a wall meets, what a thin layer along the
    /// motion has above or below the two cells' pressures is added.
    std::array<double, 3> load(std::span<const double> p) const;
    /// Shear on the slider: Couette mu U/(h + 2 a lambda), a = (2 - alpha)/alpha, and Poiseuille -(h/2) dp/dx; along x,
    /// y [N].
    std::array<double, 2> shear(std::span<const double> p) const;
    /// Load and shear at less than the cost of both.
    std::array<double, 5> loadAndShear(std::span<const double> p) const;
    /// Load and shear with their derivatives.
    struct ForceDerivatives {
        std::array<double, 5> value{};                     // load, then shear
        std::array<std::vector<double>, 5> byPressure;     // padded [N/Pa], [N m/Pa]
        std::array<std::array<double, 3>, 5> byAttitude{}; // at constant pressure [N/m, N m/m], [N/rad, N m/rad]
    };
    void forceDerivatives(std::span<const double> p, ForceDerivatives& out) const;
    FilmForces forces(std::span<const double> p) const;

private:
    struct AxisState {
        std::vector<double> gap;        // at smooth faces; zero at cut ones [m]
        std::vector<double> tilt;       // change of the gap along the path against it, -1 to 1 [-]
        std::vector<double> speed;      // of the disk along the axis, halved [m/s]
        std::vector<double> width;      // of the face by cross index [m]
        std::vector<double> perWidth;   // 1/width of the cells by line along the axis [1/m]
        std::vector<double> cutSurface; // height of the disk under the cut faces, in their order [m]
        std::vector<std::array<double, 2>>
            cutArms; // of the cut faces' forces, for pitch and roll torque about the centre [m]
    };
    /// Sums over a cut cell's pieces, and what they lie within.
    struct CutCell {
        double area = 0.0, recess = 0.0, x = 0.0, y = 0.0; // [m^2], of area times recess, x, y [m^3]
        double lowest = 1e300, x0 = 1e300, x1 = -1e300, y0 = 1e300, y1 = -1e300; // of recess, x, y [m]
        bool open = false;                                                       // all of it
    };
    /// The pieces of all cut cells, each with its cell.
    struct CutPieces {
        std::vector<double> recess, x, y;           // [m]
        std::array<std::vector<double>, 2> couette; // viscosity times area times speed of the disk, along x, y [N m]
        std::vector<std::size_t> at;
    };
    using ByPressure = Dual<1>;
    using ByAttitude = Dual<3>;
    using ByAll = Dual<5>; // pressure below, above, attitude
    struct AttitudeWork {
        std::array<GapSlopes, 2> slopes;
        FaceFlows<double> flows;
        std::array<std::vector<PathFlow<ByAttitude>>, 2> cutFlows;
        void resize(std::size_t size);
    };

    std::array<double, 3> liftDirections(double x, double y) const
    {
        return {1.0, gaps_.length - x, 0.5 * gaps_.width - y};
    }
    /// Height of the disk under a cell [m].
    double surfaceAt(std::size_t at) const { return surface_.empty() ? 0.0 : surface_[at]; }
    /// Takes the disk's height off the recess of a row of faces, and its rise along their paths off that of the recess.
    /// On the outline, the height of the cell inside.
    void setRowOverSurface(std::size_t axis, int j);
    void setCutSurface(std::size_t axis);
    /// The gap of a piece above this height of the disk [m].
    double gapOf(const GapPiece& piece, double surface) const
    {
        return piece.recess - surface + gaps_.lift(attitude_, piece.x, piece.y);
    }

    void addCellLoads(std::span<const double> p, std::array<double, 5>& sum) const;
    /// Of cut faces, what layers make and the shear of the pressure gradient.
    void addCutForces(bool layers, bool drags, std::span<const double> p, std::array<double, 5>& sum) const;
    void addShear(std::span<const double> p, std::array<double, 5>& sum) const;
    void setCouettePlaces();
    /// 2 a lambda p [Pa m].
    double slipLength() const;
    /// Puts gaps and pressures of a row of cells into forceWork_, or of the pieces of cut cells from this one on, and
    /// how many.
    void setCellRow(int j, std::span<const double> p) const;
    std::size_t setCutPieces(std::size_t first, std::span<const double> p) const;
    void addCouetteSlopes(std::span<const double> p, ForceDerivatives& out) const;
    void addPoiseuilleSlopes(std::size_t axis, std::span<const double> p, ForceDerivatives& out) const;
    void addCutSlopes(std::size_t axis, std::span<const double> p, ForceDerivatives& out) const;

    struct FaceRow;
    /// A row of faces, with the mobilities of smooth ones.
    FaceRow smoothRow(std::size_t axis, int j, std::span<const double> p) const;
    /// Flows through a row of faces; those of cut ones are there.
    template <ConvectionScheme scheme, typename Number>
    void setFaceRow(std::size_t axis, int j, std::span<const double> p);
    template <typename Number>
    void setFaceRow(std::size_t axis, int j, std::span<const double> p);
    template <typename Number>
    void setCutFlows(std::span<const double> p);
    template <typename Number>
    void evaluate(std::span<const double> p, std::span<double> out);
    template <ConvectionScheme scheme>
    void setGapSlopes(std::size_t axis, std::span<const double> p, GapSlopes& out) const;
    void setGapSlopes(std::span<const double> p, std::array<GapSlopes, 2>& out) const;
    void addByAttitude(std::size_t axis, std::size_t k, const std::vector<double>& byGap,
                       const std::vector<double>& byRise, std::vector<double>& out) const;
    void addCutCorrections(std::size_t axis, std::size_t k, std::span<const double> p,
                           const std::vector<PathFlow<ByAttitude>>& cutFlows, std::vector<double>& out) const;
    void setAttitudeStorage(std::size_t k, std::span<const double> p, double perTime, std::vector<double>& out) const;
    /// What a row of cells stores; zeros where flows have none.
    const double* storedRow(const FaceFlows<double>& flows, int j) const
    {
        return flows.stored.empty() ? noStorage_.data() : &flows.stored[gaps_.pad.at(0, j)];
    }
    /// Slopes of the flow along each axis in a row of cells: what leaves the one way came the other, or out of what was
    /// stored.
    template <typename T>
    void setSlopes(int j, const T* flowX, const T* flowY, const T* flowYAbove, const T* stored, T* slopeX,
                   T* slopeY) const;
    void setSlopes(FaceFlows<double>& flows) const;
    /// What the limited corrections take off the flows, for small changes.
    void completeChanges(FaceFlows<double>& flows) const;
    template <typename T>
    void divergence(int j, const T* flowX, const T* flowY, const T* flowYAbove, const T* stored,
                    std::span<T> out) const;
    void divergence(const FaceFlows<double>& flows, std::span<double> out) const;
    void clearRings(std::span<double> field) const;
    bool complete() const { return setting_.scheme == ConvectionScheme::CompleteFlux; }

    const FilmGaps& gaps_;
    FilmSetting setting_;
    FlowTable table_;
    Attitude attitude_;
    double flowScale_ = 0.0, totalVolume_ = 0.0;
    double storagePerTime_ = 0.0;         // [1/s]
    std::span<const double> history_;     // [Pa m^3/s]
    std::span<const double> surface_;     // [m]
    std::array<double, 2> motionShare_{}; // square of the disk's direction along x, y under the centre [-]
    std::array<AxisState, 2> axes_;
    std::array<FilmFaces, 2> faces_;
    std::vector<double> volume_, area_;
    std::vector<double> noStorage_;                   // of a row
    std::vector<std::size_t> steppedRows_;            // the first stepped cell of each row, and the end
    std::array<std::vector<std::size_t>, 2> cutRows_; // the first cut face of each row, and the end
    std::vector<double> centreX_;                     // of the cells' columns [m]
    std::vector<CutCell> cutCells_;
    CutPieces cutPieces_;
    std::array<std::vector<double>, 2> couette_; // of the cells that are not cut, as of CutPieces; padded [N m]
    std::array<CutPaths, 2> cutPaths_;

    // Work space, also of const functions.
    mutable std::vector<double> mobility_, mobilityByProduct_; // of a row of faces [Pa m], [-]
    mutable std::vector<double> rowProduct_;                   // of mean pressure and gap [Pa m]
    mutable std::vector<double> rowWidth_, rowLength_,
        rowShare_;                            // of the paths of a row where all are alike [m], [m], [-]
    mutable std::vector<double> rowByGap_;    // the mobility's own derivative [Pa]
    mutable std::vector<double> stencilRows_; // slopes of four rows, by three cells each [m^2/s]
    std::vector<double> rowRecess_, rowRise_; // of a row over a disk that is not flat [m]
    mutable CutPaths::Work cutWork_;
    mutable std::vector<CutForces<double>> cutForces_;
    mutable std::vector<CutForces<ByAll>> cutForcesByAll_;
    mutable AttitudeWork attitudeWork_; // allocated when first used
    struct ForceWork {
        static constexpr std::size_t pieces = 512;
        std::vector<double> gap, pressure, byGap, byPressure;
    };
    mutable ForceWork forceWork_;
    std::array<std::vector<PathFlow<double>>, 2> cutFlows_;
    std::array<std::vector<PathFlow<ByPressure>>, 2> cutFlowsByPressure_;
    /// Of the last two rows, each between rings.
    struct RowWork {
        std::array<std::array<FaceMoments, 2>, 2> moments; // by axis
        std::array<std::vector<double>, 2> flow, slope;    // complete flows
        std::vector<double> stored;
    };
    RowWork rows_;
    std::array<std::vector<double>, 2>
        slope_;             // of the flows along each axis at the last linearisation; padded [Pa m^2/s]
    double massFlow_ = 0.0; // into the film at the last residual [Pa m^3/s]
};

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The generalised Reynolds equation of a compressible, isothermal, rarefied film on cells (Fukui & Kaneko 1988):
//
//   div( Q p h^3 grad p/(12 mu) - p h U/2 ) = d(p h)/dt,   p = p0 on the slider's outline.
//
// Finite volumes: the net outflow of each cell is R(p) = 0. The flow through a face is that along the path from one
// cell centre to the next (core/physics/film/path_flow.h): through the pieces of a path that an edge or a wall crosses,
// with the gap in the middle of a smooth one. The scheme selects, on smooth faces, upwind, hybrid, power law or
// exponential fitting (convection.h); the complete flux scheme adds the change of the flow along each path and is
// second order. Its correction d is limited to d/sqrt(1 + (d/F)^2), F the flow from the upstream cell alone: a change
// of third order where the pressure is smooth, and no cell is emptied below zero.
//
// In time, cells also store R = V dp/dt + p dV/dt, by a formula alpha V p - history; in the complete flux scheme
// storage is a source of the flow along a path. It is first spread along x (core/numerics/row_spread.h), which
// makes the speed of waves along x fourth order in thin films. It is then shared, first between a cell's faces across
// y, then the remainder between its faces across x: with a = 1 - exp(-i kx), b = 1 - exp(-i ky) of a wave, d = 2 - 2
// cos kx and flows A and B through thin films, cells store S = (1 - a/2)(1 - b/2)(1 + d/12), and as the net outflow is
// J = A a (1 - b/2) + B b (1 - a/2), -J/S = -(A a/(1 - a/2) + B b/(1 - b/2))/(1 + d/12) is imaginary: the disk carries
// each wave along, and none grows. Without the product in S oblique ones grow. The limiter does not change the sharing
// across y. A cell without an open face keeps its pressure.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "core/numerics/row_spread.h"
#include "core/physics/disk/disk_velocity.h"
#include "core/physics/film/film_faces.h"
#include "core/physics/film/film_geometry.h"
#include "core/physics/film/film_stencil.h"
#include "core/physics/film/flow_table.h"
#include "core/work/team.h"

namespace touchdown {

struct FilmSetting {
    Air air;
    Slip slip;
    DiskMotion disk;
    ConvectionScheme scheme = ConvectionScheme::CompleteFlux;
    /// Air flows through a smaller gap, or a closed one, as through this one, at least zero: so the equation has one
    /// solution, which does not jump where a gap closes. Zero: closed gaps pass nothing [m].
    double leastGap = 0.0;
};
/// Of a film whose slider may touch the disk: less than a molecule of air [m].
inline constexpr double moleculeGap = 0.3e-9;

/// Pressures are absolute [Pa], in padded arrays whose rings hold p0; residuals are net outflows [Pa m^3/s]. Constant
/// functions write nothing but their arguments: threads may share a film as long as all of them call only these. Films
/// that share their gaps may be at different attitudes, each on a thread of its own.
class GasFilm : public FilmGeometry {
public:
    GasFilm(std::shared_ptr<const FilmGaps> gaps, const FilmSetting& setting);

    const Air& air() const { return setting_.air; }
    double ambient() const { return setting_.air.pressure; }
    const Slip& slip() const { return setting_.slip; }
    const DiskMotion& disk() const { return setting_.disk; }
    const FlowTable& flowTable() const { return table_; }
    bool isComplete() const { return setting_.scheme == ConvectionScheme::CompleteFlux; }
    /// Flow through the film at ambient pressure: the scale of residuals [Pa m^3/s].
    double flowScale() const;
    /// How often the disk passes the slider [1/s].
    double passage() const;

    /// From now on each cell stores perTime V p - history [1/s], [Pa m^3/s], V its volume at the attitude; with perTime
    /// zero, nothing. The history (padded) is read at each residual and must last.
    void setStorage(double perTime, std::span<const double> history);
    /// From now on storage is spread as between cells with these pressures (padded) at the attitude, see RowSpread.
    void spreadAs(std::span<const double> p) { spread_.weigh(volumes(), p); }
    double storagePerTime() const { return storagePerTime_; }
    std::span<const double> storageHistory() const { return history_; }

    /// R(p) alone, and R(p) with the linearisation at p.
    void residual(std::span<const double> p, std::span<double> out);
    void linearise(std::span<const double> p, std::span<double> out);
    /// The last linearisation; flow and inflow of the last residual.
    const std::array<FilmFaces, 2>& faces() const { return faces_; }
    /// Flow into the film through its outline at the last residual [Pa m^3/s].
    double massFlow() const { return massFlow_; }
    /// The linearisation without storage, the shares of the storage that the faces pass on, and its spreading.
    void setStencil(FilmStencil& out) const;
    /// out = dR/dp v (v zero in its rings); the cells store perTime V v, by default that of setStorage. Exactly, but
    /// for how much more or less of the storage a face across y passes on, as for the attitude's columns.
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
    void attitudeColumns(std::span<const double> p, std::array<std::vector<double>, 3>& out, AttitudeWork& work) const;
    /// The derivatives of these by perTime, d^2R/(da dperTime) [Pa m^2], [Pa m^3 per rad].
    void attitudeStorageColumns(std::span<const double> p, std::array<std::vector<double>, 3>& out,
                                AttitudeWork& work) const;

private:
    using ByPressure = Dual<1>;
    using ByAttitude = Dual<3>;

    struct FaceRow;
    /// A row of faces, with the mobilities of smooth ones.
    FaceRow smoothRow(std::size_t axis, int j, std::span<const double> p, FaceWork& work) const;
    struct RowWork;
    /// Flows through a row of faces; those through cut faces are known already.
    template <ConvectionScheme scheme, typename Number>
    void setFaceRow(std::size_t axis, int j, std::span<const double> p, RowWork& work);
    template <typename Number>
    void setFaceRow(std::size_t axis, int j, std::span<const double> p, RowWork& work);
    template <typename Number>
    void setCutFlows(std::span<const double> p);
    template <typename Number>
    void evaluate(std::span<const double> p, std::span<double> out);
    /// Of a block of rows, the faces below it done; those across y on its border are finished by finishBorder().
    template <typename Number>
    void evaluateRows(std::span<const double> p, std::span<double> out, std::size_t block);
    template <typename Number>
    void finishBorder(std::span<double> out, std::size_t block);
    void setStencilRows(FilmStencil& out, Block block, std::size_t thread) const;
    template <typename T>
    void applyRows(std::span<const T> v, std::span<T> out, FaceFlows<T>& work, T perTime, Block block,
                   std::size_t thread) const;
    template <typename Number>
    double* slopeRow(std::size_t axis, int j, RowWork& work);
    template <typename Number>
    void finishRow(std::size_t axis, int j, const double* before, RowWork& work);
    template <ConvectionScheme scheme>
    void setGapSlopes(std::size_t axis, std::span<const double> p, AttitudeWork& work) const;
    void setGapSlopes(std::span<const double> p, AttitudeWork& work) const;
    void addByAttitude(std::size_t axis, std::size_t k, const std::vector<double>& byGap,
                       const std::vector<double>& byRise, std::vector<double>& out) const;
    void addCutCorrections(std::size_t axis, std::size_t k, std::span<const double> p,
                           const std::vector<PathFlow<ByAttitude>>& cutFlows, std::vector<double>& out) const;
    /// The storage of a row of cells; zeros where the flows have none.
    const double* storedRow(const FaceFlows<double>& flows, int j) const
    {
        return flows.stored.empty() ? noStorage_.data() : &flows.stored[pad().at(0, j)];
    }
    /// Slopes of the flow along each axis in a row of cells, by the cell's mass balance: change of the flow along x =
    /// -change of the flow along y, with what it passes on of the storage, - storage.
    template <typename T>
    void setSlopes(int j, const T* flowX, const T* flowY, const T* flowYAbove, const T* stored, T* slopeX,
                   T* slopeY) const;
    /// Zero in the cells of a row that have no slopes.
    template <typename T>
    void clearStepped(int j, T* slope) const;
    /// Storage per width along y of the cells of a row that pass some on; beyond the last row zeros.
    template <typename T>
    void setSource(int j, const T* stored, T* source) const;
    /// out = flow + what faces across y pass on of the storage below and above them.
    template <typename T>
    void addPassed(const double* below, const double* above, const T* sourceBelow, const T* sourceAbove, const T* flow,
                   T* out) const;
    /// Spreads what the cells store along x, where they store.
    void spreadStorage(FaceFlows<double>& flows) const;
    void setSlopes(FaceFlows<double>& flows) const;
    /// Subtracts the limited corrections from the flows, for small changes.
    void completeChanges(FaceFlows<double>& flows) const;
    template <typename T>
    void divergence(int j, const T* flowX, const T* flowY, const T* flowYAbove, const T* stored,
                    std::span<T> out) const;
    void divergence(const FaceFlows<double>& flows, std::span<double> out) const;

    FilmSetting setting_;
    FlowTable table_;
    RowSpread spread_;                                // complete flux scheme alone
    double storagePerTime_ = 0.0;                     // [1/s]
    std::span<const double> history_;                 // [Pa m^3/s]
    std::vector<double> noStorage_;                   // of a row
    std::vector<std::size_t> steppedRows_;            // the first stepped cell of each row, and the end
    std::array<std::vector<std::size_t>, 2> cutRows_; // the first cut face of each row, and the end

    std::array<FilmFaces, 2> faces_;
    std::array<std::vector<double>, 2> slope_; // of the flows along each axis at the last linearisation [Pa m^2/s]
    double massFlow_ = 0.0;

    // Work space of residual and linearisation.
    std::vector<CutPaths::Work> cutWork_; // by thread
    std::array<std::vector<PathFlow<double>>, 2> cutFlows_;
    std::array<std::vector<PathFlow<ByPressure>>, 2> cutFlowsByPressure_;
    /// Of a block of rows: of its first two and of the last two, each between rings.
    struct RowWork {
        explicit RowWork(const FilmGaps& gaps);
        /// Where a row lies among the four.
        std::size_t slot(int j) const
        {
            return static_cast<std::size_t>(j == first || j == first + 1 ? 2 + j - first : (j + 2) % 2);
        }
        double* row(std::vector<double>& rows, int j) const
        {
            return rows.data() + slot(j) * stride + PaddedGrid::rings;
        }

        int first = 0, end = 0; // rows of cells
        std::size_t stride;
        FaceWork face;
        std::array<std::array<FaceMoments, 4>, 2> moments; // by axis
        std::array<std::vector<double>, 2> flow, slope;    // complete flows
        std::vector<double> stored;                        // of the first row and the last three, without rings
        std::vector<double> source, crossing;              // see setSource, addPassed
        std::vector<double> spread;                        // flows of a row, see RowSpread
    };
    std::vector<RowWork> rows_;  // by block
    std::vector<double> inflow_; // into the film through the ends of each row of cells, by row [Pa m^3/s]
};

} // namespace touchdown

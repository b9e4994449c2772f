// SPDX-License-Identifier: GPL-3.0-or-later
//
// Forces and torques of a film on the slider, with their derivatives. Load: integral of the pressure above ambient. A
// cell counts its pressure times its area; across a face that an edge or a wall meets, the excess or lack of pressure
// in a thin layer along the motion is added. Shear: Couette mu U/(h + 2 a lambda), a = (2 - alpha)/alpha, and
// Poiseuille -(h/2) dp/dx. Torques are about the slider's centre.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/numerics/dual.h"
#include "core/physics/film/cut_paths.h"
#include "core/physics/film/film_forces.h"

namespace touchdown {

class GasFilm;

/// At given pressures (padded) [Pa] and the attitude and surface of the film, which must last. All functions share one
/// work space.
class FilmLoads {
public:
    explicit FilmLoads(const GasFilm& film);

    /// Force [N], pitch and roll torque [N m].
    std::array<double, 3> load(std::span<const double> p);
    /// Along x and y [N].
    std::array<double, 2> shear(std::span<const double> p);
    /// Load and shear at less than the cost of both.
    std::array<double, 5> loadAndShear(std::span<const double> p);
    struct Derivatives {
        std::array<double, 5> value{};                     // load, then shear
        std::array<std::vector<double>, 5> byPressure;     // padded [N/Pa], [N m/Pa]
        std::array<std::array<double, 3>, 5> byAttitude{}; // at constant pressure [N/m, N m/m], [N/rad, N m/rad]
    };
    void derivatives(std::span<const double> p, Derivatives& out);
    /// The mass flow is that of the film's last residual.
    FilmForces forces(std::span<const double> p);

private:
    using ByAll = Dual<5>; // pressure below, above, attitude
    using Pair = std::array<std::vector<double>, 2>;
    /// The pieces of all cut cells, each with its cell.
    struct CutPieces {
        std::vector<double> recess, x, y; // [m]
        Pair couette;                     // viscosity times area times speed of the disk, along x, y [N m]
        std::vector<std::size_t> at;
    };
    static constexpr std::size_t groupSize = 512; // pieces of cut cells that share a call

    void setCouetteWeights();
    void setCutArms();
    /// 2 a lambda p [Pa m].
    double slipLength() const;
    void addCellLoads(std::array<double, 5>& sum) const;
    /// What the rows of cells and of faces add, each for itself.
    void setRowForces(bool loads, bool shears, std::span<const double> p);
    /// Layers at cut faces, and the shear of the pressure gradient there.
    void addCutForces(bool layers, bool drags, std::span<const double> p, std::array<double, 5>& sum);
    void addShear(std::span<const double> p, std::array<double, 5>& sum);
    /// Copies gaps and pressures of a row of cells into the work space.
    void setCellRow(int j, std::span<const double> p);
    void setRowGaps(int j, double* gap) const;
    /// The same for the pieces of cut cells from `first` on; returns their number.
    std::size_t setCutPieces(std::size_t first, std::span<const double> p);
    void addCouetteSlopes(std::span<const double> p, Derivatives& out);
    void addPoiseuilleSlopes(std::size_t axis, std::span<const double> p, Derivatives& out) const;
    void addCutSlopes(std::size_t axis, std::span<const double> p, Derivatives& out);

    const GasFilm& film_;
    CutPieces cutPieces_;
    Pair couette_; // of the cells that are not cut, as in CutPieces; padded [N m]
    std::array<std::vector<std::array<double, 2>>, 2> cutArms_; // of the forces at cut faces about the centre [m]

    // Work space.
    std::vector<double> gap_, pressure_, byGap_, byPressure_; // of a row of cells or a group of pieces
    struct RowForces {
        std::array<double, 2> load{}, couette{}, drop{}; // see rowLoad(), couette(), rowDrop()
    };
    std::vector<RowForces> rowForces_;                   // by row, and the faces beyond the last
    std::vector<std::vector<double>> rowGap_, rowWidth_; // by thread [m]
    std::vector<CutPaths::Work> cutWork_;                // by thread
    std::vector<CutForces<double>> cutForces_;
    std::vector<CutForces<ByAll>> cutForcesByAll_;
};

} // namespace touchdown

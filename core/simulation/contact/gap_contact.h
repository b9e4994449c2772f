// SPDX-License-Identifier: GPL-3.0-or-later
//
// A pressure of the local gap (core/physics/contact/gap_law.h), integrated over the surface of a flying slider. The gap
// is that above the disk's surface, whose heights are the means over the film's cells, as for the film. Slider and disk
// are rigid; the law's summits give way.
//
// In a cell without an edge the recess is bilinear, and Gauss-Legendre quadrature takes so many points that the slope
// of the gap costs less than 1e-7 of the cell's force. A cell that an edge or a wall crosses is cut into strips along
// x, and each strip at its breaks, exactly where the recess jumps.
#pragma once

#include <array>
#include <vector>

#include "core/numerics/padded_grid.h"
#include "core/physics/contact/gap_law.h"
#include "core/physics/slider/minimum_spacing.h"
#include "core/physics/slider/recess.h"
#include "core/simulation/contact/contact_lever.h"
#include "core/simulation/contact/disk_under_film.h"
#include "core/simulation/contact/slider_contact.h"

namespace touchdown {

class GapContact final : public SliderContact {
public:
    /// Spacing, surface, grid and pad must last. Invalid where `goOn` returns false.
    GapContact(const Case& c, GapLaw law, const MinimumSpacing& spacing, const DiskTopography& surface,
               const CellGrid& grid, const PaddedGrid& padded, const std::function<bool()>& goOn);

    const SliderContactForces& at(const Attitude& attitude, double time) override;
    Matrix3 stiffness() const override { return stiffness_; }
    bool outOfReach(const Attitude& attitude) const override;
    double reach() const override { return highest_ + law_.reach(); }
    void accept() override {}

    double longestStep() const override { return longestStep_; }

private:
    /// A rectangle of the surface with a smooth recess, within one of the film's cells.
    struct Piece {
        double x, y, halfX, halfY;     // middle, half sides [m]
        double recess, slopeX, slopeY; // in the middle [m], [-]
        std::size_t cell;              // padded
        ContactLever::Rubbing rubbing; // in the middle
    };
    void addCell(const Recess& recess, const CellGrid& grid, int i, int j);
    void addPiece(const Recess& recess, double x0, double x1, double y0, double y1, std::size_t cell, bool strip);
    void integrate(const Piece& piece, double gap, double slopeX, double slopeY);

    GapLaw law_;
    const MinimumSpacing& spacing_;
    const PaddedGrid& padded_;
    double length_, width_; // of the slider [m]
    double highest_;        // of the disk [m]
    double longestStep_;    // [s]
    ContactLever lever_;
    DiskUnderFilm disk_;
    std::vector<double> diskHeight_; // padded [m]; empty: flat
    std::vector<Piece> pieces_;
    SliderContactForces forces_;
    Matrix3 stiffness_ = Matrix3::Zero();
};

} // namespace touchdown

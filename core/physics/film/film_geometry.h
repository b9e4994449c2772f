// SPDX-License-Identifier: GPL-3.0-or-later
//
// The space between slider and disk at an attitude, on cells: gaps at the faces, volumes of the cells, speeds of the
// disk. Arrays are padded (core/numerics/padded_grid.h).
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "core/physics/film/cut_paths.h"
#include "core/physics/film/gaps/film_gaps.h"

namespace touchdown {

struct DiskMotion;

class FilmGeometry {
public:
    /// Films at other attitudes may share the gaps; `leastGap` as in FilmSetting [m].
    FilmGeometry(std::shared_ptr<const FilmGaps> gaps, const DiskMotion& disk, double leastGap = 0.0);

    const FilmGaps& gaps() const { return *gaps_; }
    const std::shared_ptr<const FilmGaps>& sharedGaps() const { return gaps_; }
    const PaddedGrid& pad() const { return gaps_->pad; }
    const Attitude& attitude() const { return attitude_; }

    /// The disk's surface under each cell: mean height above the mean plane, less the deformation by contact [m];
    /// padded; its rings are not read. Empty: flat. setAttitude reads it; it must last unchanged until the next call. A
    /// smooth face has the mean of its two cells' heights, and their difference in its tilt; all pieces of a cut face
    /// have the height of their face.
    void setSurface(std::span<const double> height) { surface_ = height; }
    std::span<const double> surface() const { return surface_; }
    void setAttitude(const Attitude& attitude);

    /// The faces across one axis.
    struct Axis {
        std::vector<double> gap;        // at smooth faces, at least leastGap; zero at cut ones [m]
        std::vector<double> tilt;       // change of the gap along the path, divided by the gap; -1 to 1 [-]
        std::vector<double> speed;      // of the disk along the axis, halved [m/s]
        std::vector<double> width;      // of the face by cross index [m]
        std::vector<double> perWidth;   // 1/width of the cells by line along the axis [1/m]
        std::vector<double> cutSurface; // height of the disk under the cut faces, in their order [m]
        CutPaths cutPaths;
    };
    const std::array<Axis, 2>& axes() const { return axes_; }

    double leastGap() const { return leastGap_; }

    /// Volume of air under each cell, its area times the gap at its centre, at least zero [m^3]; padded.
    const std::vector<double>& volumes() const { return volume_; }
    /// Volume of the air under the slider [m^3].
    double totalVolume() const { return totalVolume_; }
    /// Area of each cell [m^2]; padded, zero in the rings.
    const std::vector<double>& areas() const { return area_; }
    /// Centres of the cells' columns [m].
    const std::vector<double>& centresX() const { return centreX_; }
    /// Mean gap over each cell [m].
    double meanGap(int i, int j) const;

    /// Speed of the disk under the slider's centre [m/s].
    double speed() const { return speed_; }
    /// Squares of the disk's direction along x and y under the slider's centre [-].
    const std::array<double, 2>& motionShare() const { return motionShare_; }

    /// Height of the disk under a cell [m].
    double surfaceAt(std::size_t at) const { return surface_.empty() ? 0.0 : surface_[at]; }
    /// d(volume)/d(height) [m^2], d/d(pitch), d/d(roll) [m^3/rad], times `factor` of each cell and `scale`; padded.
    void setVolumeSlopes(std::size_t k, double scale, std::span<const double> factor, std::vector<double>& out) const;

    /// Sets the rings of a padded array to zero.
    void clearRings(std::span<double> field) const;

private:
    /// Subtracts the disk's height and rise from those of a row of faces; on the outline, those of the cell inside.
    struct RowWork {
        std::vector<double> recess, rise, length; // of a row [m]
    };
    void setRowOverSurface(std::size_t axis, int j, RowWork& work);
    /// set(row, work space)
    template <typename Set>
    void forRows(int count, const Set& set);
    void setCutSurface(std::size_t axis);
    void setFaceGaps(std::size_t axis);
    void setVolumes();

    std::shared_ptr<const FilmGaps> gaps_;
    Attitude attitude_;
    double leastGap_ = 0.0;           // [m]
    std::span<const double> surface_; // [m]
    double speed_ = 0.0, totalVolume_ = 0.0;
    std::array<double, 2> motionShare_{};
    std::array<Axis, 2> axes_;
    std::vector<double> volume_, area_, centreX_;
    std::vector<RowWork> rowWork_; // by thread
};

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/contact/gap_contact.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/numerics/gauss_legendre.h"

namespace touchdown {

namespace {

constexpr int strips = 8;               // of a cell that an edge crosses
constexpr double deepestRecess = 1e-6;  // where nothing touches, above the lowest [m]
constexpr double pointsPerScale = 1.5;  // of a change of the gap, in the law's scale [-]
constexpr std::size_t fewestPoints = 3; // along a side
constexpr std::size_t mostPoints = 24;  // a longer way is divided

/// Points of [-1, 1] for every count up to the most.
struct Rules {
    struct Point {
        double at, weight; // [-]
    };
    std::array<std::vector<Point>, mostPoints + 1> points;

    Rules() { fill(std::make_index_sequence<mostPoints + 1>()); }

private:
    template <std::size_t... N>
    void fill(std::index_sequence<N...>)
    {
        (fillOne<N>(), ...);
    }
    template <std::size_t N>
    void fillOne()
    {
        if constexpr (N > 0)
            GaussLegendre<N>().sample(-1.0, 1.0, [&](double at, double weight) { points[N].push_back({at, weight}); });
    }
};

const Rules& rules()
{
    static const Rules all;
    return all;
}

} // namespace

GapContact::GapContact(const Case& c, GapLaw law, const MinimumSpacing& spacing, const DiskTopography& surface,
                       const CellGrid& grid, const PaddedGrid& padded, const std::function<bool()>& goOn)
    : law_(std::move(law)),
      spacing_(spacing),
      padded_(padded),
      length_(c.slider.length),
      width_(c.slider.width),
      highest_(surface.highest()),
      longestStep_(longestStepOver(c, surface, grid.widthX(grid.nx() - 1), goOn)),
      lever_(c),
      disk_(c, surface, grid, padded),
      diskHeight_(surface.flat() ? 0 : padded.size())
{
    const Recess recess(c.surface, length_, width_);
    for (int j = 0; j < grid.ny(); ++j) {
        if (goOn && !goOn()) return;
        for (int i = 0; i < grid.nx(); ++i) addCell(recess, grid, i, j);
    }
    double lowest = std::numeric_limits<double>::infinity();
    for (const Piece& piece : pieces_) lowest = std::min(lowest, piece.recess);
    std::erase_if(pieces_,
                  [&](const Piece& piece) { return piece.recess > lowest + std::max(deepestRecess, law_.reach()); });
}

void GapContact::addCell(const Recess& recess, const CellGrid& grid, int i, int j)
{
    const auto at = [](const std::vector<double>& lines, int k) { return lines[static_cast<std::size_t>(k)]; };
    const double x0 = at(grid.x, i), x1 = at(grid.x, i + 1), y0 = at(grid.y, j), y1 = at(grid.y, j + 1);
    const std::size_t cell = padded_.at(i, j);
    // An edge along the cell's border lies outside.
    const double insetX = 1e-6 * (x1 - x0), insetY = 1e-6 * (y1 - y0);
    if (recess.isSmooth(x0 + insetX, x1 - insetX, y0 + insetY, y1 - insetY)) {
        addPiece(recess, x0, x1, y0, y1, cell, false);
        return;
    }
    std::vector<double> breaks, borders{y0, y1};
    for (const double x : {x0 + insetX, 0.5 * (x0 + x1), x1 - insetX}) recess.breaksAlongY(x, y0, y1, borders);
    for (int k = 1; k < strips; ++k) borders.push_back(std::lerp(y0, y1, double(k) / strips));
    std::ranges::sort(borders);
    for (std::size_t k = 1; k < borders.size(); ++k) {
        const double from = borders[k - 1], to = borders[k];
        if (!(to > from)) continue;
        breaks.assign(1, x0);
        recess.breaksAlongX(0.5 * (from + to), x0, x1, breaks);
        breaks.push_back(x1);
        for (std::size_t n = 1; n < breaks.size(); ++n)
            if (breaks[n] > breaks[n - 1]) addPiece(recess, breaks[n - 1], breaks[n], from, to, cell, true);
    }
}

/// Slopes from points a quarter of the sides away from the middle: beside edges, not on them. A strip's are those of
/// its middle line.
void GapContact::addPiece(const Recess& recess, double x0, double x1, double y0, double y1, std::size_t cell,
                          bool strip)
{
    const double x = 0.5 * (x0 + x1), y = 0.5 * (y0 + y1), halfX = 0.5 * (x1 - x0), halfY = 0.5 * (y1 - y0);
    const double left = recess.at(x - 0.5 * halfX, y), right = recess.at(x + 0.5 * halfX, y);
    double slopeY = 0.0;
    if (!strip) slopeY = (recess.at(x, y + 0.5 * halfY) - recess.at(x, y - 0.5 * halfY)) / halfY;
    pieces_.push_back(
        {x, y, halfX, halfY, recess.at(x, y), (right - left) / halfX, slopeY, cell, lever_.rubbing(x, y)});
}

const SliderContactForces& GapContact::at(const Attitude& attitude, double time)
{
    forces_ = {};
    stiffness_.setZero();
    if (outOfReach(attitude)) return forces_;
    if (!diskHeight_.empty()) disk_.at(time, diskHeight_);
    for (const Piece& piece : pieces_) {
        const double lift =
            attitude.height + attitude.pitch * (length_ - piece.x) - attitude.roll * (piece.y - 0.5 * width_);
        const double gap = piece.recess + lift - (diskHeight_.empty() ? 0.0 : diskHeight_[piece.cell]);
        const double slopeX = piece.slopeX - attitude.pitch, slopeY = piece.slopeY - attitude.roll;
        const double least = gap - std::abs(slopeX) * piece.halfX - std::abs(slopeY) * piece.halfY;
        if (least < law_.reach()) integrate(piece, gap, slopeX, slopeY);
    }
    return forces_;
}

void GapContact::integrate(const Piece& piece, double gap, double slopeX, double slopeY)
{
    const double changeX = 2.0 * std::abs(slopeX) * piece.halfX, changeY = 2.0 * std::abs(slopeY) * piece.halfY;
    const double scale = law_.scale(gap - 0.5 * (changeX + changeY));
    struct Side {
        int parts;
        const std::vector<Rules::Point>& points;
    };
    const auto side = [&](double change) {
        const double wanted = static_cast<double>(fewestPoints) + pointsPerScale * change / scale;
        const int parts = static_cast<int>(wanted / mostPoints) + 1;
        const auto count = std::min(static_cast<std::size_t>(std::ceil(wanted / parts)), mostPoints);
        return Side{parts, rules().points[count]};
    };
    const Side alongX = side(changeX), alongY = side(changeY);
    GapForces sum;
    Vector3 load = Vector3::Zero(), contactSlopes = Vector3::Zero();
    Matrix3 stiffness = Matrix3::Zero();
    const auto add = [&](double u, double v, double weight) {
        const double dx = u * piece.halfX, dy = v * piece.halfY;
        const double here = gap + slopeX * dx + slopeY * dy;
        if (here >= law_.reach()) return;
        const GapForces at = law_.at(here);
        const Vector3 arms = lever_.arms(piece.x + dx, piece.y + dy);
        sum.contact += weight * at.contact;
        sum.adhesion += weight * at.adhesion;
        sum.area += weight * at.area;
        sum.energy += weight * at.energy;
        load += weight * at.total() * arms;
        contactSlopes -= weight * at.contactSlope * arms;
        stiffness -= weight * (at.contactSlope + at.adhesionSlope) * arms * arms.transpose();
        forces_.peakPressure = std::max(forces_.peakPressure, at.contact);
    };
    const double perPart = piece.halfX * piece.halfY / (alongX.parts * alongY.parts);
    for (int n = 0; n < alongY.parts; ++n)
        for (const auto& [v, weightY] : alongY.points)
            for (int m = 0; m < alongX.parts; ++m)
                for (const auto& [u, weightX] : alongX.points)
                    add((2.0 * m + 1.0 + u) / alongX.parts - 1.0, (2.0 * n + 1.0 + v) / alongY.parts - 1.0,
                        perPart * weightX * weightY);
    forces_.contact += sum.contact;
    forces_.adhesion += sum.adhesion;
    forces_.friction += piece.rubbing.force * sum.contact;
    forces_.pitchTorque += load[1] + piece.rubbing.pitchTorque * sum.contact;
    forces_.rollTorque += load[2] + piece.rubbing.rollTorque * sum.contact;
    forces_.area += sum.area;
    forces_.storedEnergy += sum.energy;
    stiffness_ += stiffness;
    stiffness_.row(1) += piece.rubbing.pitchTorque * contactSlopes.transpose();
    stiffness_.row(2) += piece.rubbing.rollTorque * contactSlopes.transpose();
}

bool GapContact::outOfReach(const Attitude& attitude) const
{
    return spacing_.at(attitude).spacing - highest_ >= law_.reach();
}

} // namespace touchdown

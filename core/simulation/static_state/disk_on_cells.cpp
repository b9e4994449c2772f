// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/static_state/disk_on_cells.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/case/case.h"
#include "core/formats/units.h"
#include "core/physics/disk/disk_passage.h"
#include "core/physics/disk/disk_surface_check.h"
#include "core/physics/disk/surface_statistics.h"
#include "core/simulation/contact/disk_under_film.h"

namespace touchdown {

namespace {

constexpr double cellsForWaves = 6.0;
constexpr double cellsToBeKnown = 2.0;  // below, the means keep less than 64 % of a wave
constexpr double nearestShare = 0.1;    // of the least gap, below which a gap counts no more
constexpr double thinnest = 1e-9;       // the least gap counts as at least this [m]
constexpr double worthSaying = 0.01;    // of a film's force; of the least gap, for the height of a wave
constexpr double large = 0.3;           // of it, beyond which its size is not known
constexpr double perSquare = 3.0;       // change of the force by (RMS height/gap)^2
constexpr int windows = 8;              // parts of a map that are looked at
constexpr int columns = 512, rows = 64; // of blocks or points at which a map is looked at, at most
constexpr double wavePerBlock = 2.26;   // a wave of so many blocks loses half of its variance in their means
constexpr double coarsening = 1.25;     // from one length of blocks to the next
constexpr int mostLengths = 24;

bool matters(double rms, double gap) { return perSquare * rms * rms > worthSaying * gap * gap; }

double sinc(double u) { return u != 0.0 ? std::sin(u) / u : 1.0; }

/// Sides of the cells, each with its weight.
struct WeightedCells {
    WeightedCells(const Recess& recess, const CellGrid& grid, const Attitude& a)
    {
        leastGap = std::numeric_limits<double>::infinity();
        for (int j = 0; j < grid.ny(); ++j)
            for (int i = 0; i < grid.nx(); ++i) {
                const double x = grid.centreX(i), y = grid.centreY(j);
                gaps_.push_back(recess.at(x, y) + a.height + a.pitch * (recess.length() - x) -
                                a.roll * (y - 0.5 * recess.width()));
                leastGap = std::min(leastGap, gaps_.back());
            }
        leastGap = std::max(leastGap, thinnest);
        grid_ = &grid;
        dx = mean([](double length, double) { return length; });
        dy = mean([](double, double width) { return width; });
    }
    /// The mean of f(side along x, side along y).
    template <class F>
    double mean(const F& f) const
    {
        double sum = 0.0, weights = 0.0;
        for (int j = 0, k = 0; j < grid_->ny(); ++j)
            for (int i = 0; i < grid_->nx(); ++i, ++k) {
                const double length = grid_->widthX(i), width = grid_->widthY(j),
                             gap = std::max(gaps_[static_cast<std::size_t>(k)], nearestShare * leastGap),
                             weight = length * width / (gap * gap);
                sum += weight * f(length, width);
                weights += weight;
            }
        return sum / weights;
    }
    double leastGap, dx, dy; // [m]

private:
    const CellGrid* grid_;
    std::vector<double> gaps_; // by cell, to the mean plane [m]
};

class Looker {
public:
    Looker(const DiskTopography& disk, const WeightedCells& cells, const Velocity& velocity, DiskOnCells& found)
        : disk_(disk), cells_(cells), velocity_(velocity), found_(found)
    {}

    /// A wave along a direction, or a bump along an axis.
    void look(bool isWave, double height, double length, double cosine, double sine)
    {
        if (!(std::abs(height) > worthSaying * found_.leastGap)) return;
        const double along = std::abs(cosine), across = std::abs(sine);
        const double count = length / cells_.mean([&](double x, double y) { return std::max(along * x, across * y); });
        const double k = 2.0 * std::numbers::pi / length;
        const double kept =
            cells_.mean([&](double x, double y) { return sinc(0.5 * k * along * x) * sinc(0.5 * k * across * y); });
        if (!found_.coarsest || count < found_.coarsest->cells)
            found_.coarsest = DiskOnCells::Feature{isWave, length, count, std::max(kept, 0.0)};
        if (count >= cellsToBeKnown)
            passes(length, std::abs(velocity_.x * cosine + velocity_.y * sine), isWave ? "waves" : "a bump");
    }

    void lookAtMap(const DiskSurface& surface)
    {
        const UniformGrid period = disk_.period();
        const OtherWaves others(surface, period);
        const double wholeLength = period.nx * period.dx, wholeWidth = period.ny * period.dy;
        length_ = std::min(wholeLength, columns * cells_.dx);
        width_ = std::min(wholeWidth, rows * cells_.dy);
        found_.hasMap = true;
        // That of its parts, spread over the whole map, which loses most.
        double originX = 0.0, originY = 0.0;
        for (int k = 0; k < windows; ++k) {
            x_ = (wholeLength - length_) * k / (windows - 1);
            y_ = (wholeWidth - width_) * (k * 3 % windows) / (windows - 1);
            const double all = varianceOfPoints(),
                         lost = std::sqrt(std::max(all - varianceOfMeans(0.5 * cellsForWaves), 0.0));
            if (k > 0 && lost <= found_.lost) continue;
            found_.rms = std::sqrt(varianceOfPoints(&others) + others.variance());
            found_.lost = lost;
            originX = x_, originY = y_;
        }
        x_ = originX, y_ = originY;
        found_.sixCells = cellsForWaves * std::max(cells_.dx, cells_.dy);
        const double speed = std::hypot(velocity_.x, velocity_.y);
        if (speed == 0.0) return;
        const double known = varianceOfMeans(1.0);
        double blocks = 1.0;
        for (int k = 0; k < mostLengths; ++k, blocks *= coarsening)
            if (matters(std::sqrt(std::max(known - varianceOfMeans(coarsening * blocks), 0.0)), found_.leastGap)) {
                passes(wavePerBlock * blocks * cells_.dx, speed, "waves");
                return;
            }
    }

private:
    void passes(double length, double speed, const char* what)
    {
        const double step = length / passageParts / speed;
        if (!(step < found_.longestStep)) return;
        found_.longestStep = step;
        found_.passing = std::string(what) + " of " + fewDigits(length, "um", 2);
    }

    static int clampedCount(double ratio, int most)
    {
        return static_cast<int>(std::clamp(std::round(ratio), 1.0, static_cast<double>(most)));
    }
    static double variance(const std::vector<double>& values)
    {
        double mean = 0.0, squares = 0.0;
        for (const double value : values) mean += value / static_cast<double>(values.size());
        for (const double value : values) squares += (value - mean) * (value - mean);
        return squares / static_cast<double>(values.size());
    }
    double varianceOfPoints(const OtherWaves* without = nullptr) const
    {
        const UniformGrid period = disk_.period();
        UniformGrid points{.nx = clampedCount(length_ / period.dx, 4 * columns),
                           .ny = clampedCount(width_ / period.dy, 4 * rows)};
        points.dx = length_ / points.nx;
        points.dy = width_ / points.ny;
        points.x0 = x_;
        points.y0 = y_;
        std::vector<double> heights(points.cells());
        disk_.heights(points, 0.0, 0.0, heights);
        if (without) without->heights(-1.0).addHeights(points, 0.0, 0.0, heights);
        return variance(heights);
    }
    /// Of the means over blocks of so many cells along each axis.
    double varianceOfMeans(double cells) const
    {
        CellGrid blocks;
        const auto divide = [](std::vector<double>& lines, double from, double length, int count) {
            for (int k = 0; k <= count; ++k) lines.push_back(from + length * k / count);
        };
        divide(blocks.x, x_, length_, clampedCount(length_ / (cells * cells_.dx), columns));
        divide(blocks.y, y_, width_, clampedCount(width_ / (cells * cells_.dy), rows));
        std::vector<double> means(blocks.cells());
        disk_.cellMeans(blocks, 0.0, 0.0, means);
        return variance(means);
    }

    const DiskTopography& disk_;
    const WeightedCells& cells_;
    Velocity velocity_;
    DiskOnCells& found_;
    double x_ = 0.0, y_ = 0.0, length_ = 0.0, width_ = 0.0; // of the part of a map that is looked at [m]
};

} // namespace

bool DiskOnCells::isResolved() const
{
    return !(coarsest && coarsest->cells < cellsForWaves) && !(hasMap && matters(lost, leastGap));
}

DiskOnCells diskOnCells(const Case& c, const DiskTopography& disk, const Recess& recess, const CellGrid& grid,
                        const Attitude& attitude)
{
    DiskOnCells found;
    if (disk.flat()) return found;
    const WeightedCells cells(recess, grid, attitude);
    found.leastGap = cells.leastGap;
    Looker looker(disk, cells, surfaceVelocity(c, disk), found);
    const DiskSurface& surface = c.diskSurface;
    if (hasWaves(surface))
        for (std::size_t k = 0; k < surface.waveLengths.size(); ++k) {
            const double angle = surface.waveAngles.empty() ? 0.0 : surface.waveAngles[k];
            looker.look(true, surface.waveAmplitudes[k], surface.waveLengths[k], std::cos(angle), std::sin(angle));
        }
    if (hasBumps(surface))
        for (std::size_t k = 0; k < surface.bumpLengths.size(); ++k) {
            const double height = surface.bumpHeights[k];
            looker.look(false, height, surface.bumpLengths[k], 1.0, 0.0);
            looker.look(false, height, surface.bumpWidths.empty() ? surface.bumpLengths[k] : surface.bumpWidths[k], 0.0,
                        1.0);
        }
    if (hasRoughness(surface) || hasFile(surface)) looker.lookAtMap(surface);
    return found;
}

std::vector<std::string> doubtsOnDisk(const DiskOnCells& disk, double step)
{
    constexpr auto cure = "; more film.nodes resolve them";
    std::vector<std::string> doubts;
    if (disk.coarsest && disk.coarsest->cells < cellsForWaves) {
        const DiskOnCells::Feature& feature = *disk.coarsest;
        doubts.push_back(std::string(feature.isWave ? "the waves of the disk, " : "a bump of the disk, ") +
                         fewDigits(feature.length, "um", 3) + (feature.isWave ? " long, span " : " wide, spans ") +
                         fewDigits(feature.cells, "", 2) +
                         " cells of the film where its gap is small; at least 6 are needed: " +
                         (feature.isWave ? "the means over the cells keep " + percent(feature.kept) +
                                               " of their height, and the film's force over them is not resolved"
                                         : std::string("the film's force over it is not resolved")) +
                         cure);
    }
    const double change = perSquare * disk.lost * disk.lost / (disk.leastGap * disk.leastGap);
    if (disk.hasMap && change > worthSaying)
        doubts.push_back("the cells of the film do not see " + fewDigits(disk.lost, "nm", 3) + " of the " +
                         fewDigits(disk.rms, "nm", 3) +
                         " RMS of the disk's surface, in waves shorter than six cells, " +
                         fewDigits(disk.sixCells, "um", 2) + ": under a gap of " + fewDigits(disk.leastGap, "nm", 3) +
                         " they would change the film's force by " +
                         (change < large ? "about " + percent(change, 1) : "more than " + percent(large)) + cure);
    if (step > disk.longestStep)
        doubts.push_back("steps of " + fewDigitsOfTime(step, 3) + " (run.step) are longer than " +
                         fewDigitsOfTime(disk.longestStep, 2) + ", a sixteenth of the passage of " + disk.passing +
                         " under the slider: the film's force does not follow the disk");
    return doubts;
}

} // namespace touchdown

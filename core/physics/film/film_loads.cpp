// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/film_loads.h"

#include <algorithm>

#include "core/numerics/vector_clones.h"
#include "core/physics/film/gas_film.h"
#include "core/work/team.h"

namespace touchdown {

namespace {

/// N sums over places, eight of each side by side, whatever the width of vectors.
template <std::size_t N, typename Terms>
std::array<double, N> sums(std::size_t count, const Terms& terms)
{
    constexpr std::size_t lanes = 8;
    std::array<std::array<double, lanes>, N> side{};
    const std::size_t whole = count / lanes * lanes;
    for (std::size_t i = 0; i < whole; i += lanes)
        for (std::size_t k = 0; k < lanes; ++k) {
            const std::array<double, N> term = terms(i + k);
            for (std::size_t n = 0; n < N; ++n) side[n][k] += term[n];
        }
    for (std::size_t i = whole; i < count; ++i) {
        const std::array<double, N> term = terms(i);
        for (std::size_t n = 0; n < N; ++n) side[n][0] += term[n];
    }
    std::array<double, N> result;
    for (std::size_t n = 0; n < N; ++n) {
        const std::array<double, lanes>& s = side[n];
        result[n] = ((s[0] + s[4]) + (s[2] + s[6])) + ((s[1] + s[5]) + (s[3] + s[7]));
    }
    return result;
}

/// Force of a row of cells per width across, and its moment about x = 0.
TOUCHDOWN_VECTOR_CLONES std::array<double, 2> rowLoad(std::size_t count, const double* p, double ambient,
                                                      const double* width, const double* x)
{
    return sums<2>(count, [=](std::size_t k) -> std::array<double, 2> {
        const double force = (p[k] - ambient) * width[k];
        return {force, force * x[k]};
    });
}

/// Sum of h w (p2 - p1) of a row of faces; nothing where the gap is closed.
TOUCHDOWN_VECTOR_CLONES double rowDrop(std::size_t count, const double* below, const double* above, const double* gap,
                                       const double* width)
{
    return sums<1>(count, [=](std::size_t k) -> std::array<double, 1> {
        const double h = gap[k] > closedGap ? gap[k] : 0.0;
        return {h * width[k] * (above[k] - below[k])};
    })[0];
}

/// Couette: the weights over h + s/p, s = 2 a lambda p; nothing where the gap is closed.
TOUCHDOWN_VECTOR_CLONES std::array<double, 2> couette(std::size_t count, const double* gap, const double* p,
                                                      const double* weightX, const double* weightY, double slip)
{
    return sums<2>(count, [=](std::size_t k) -> std::array<double, 2> {
        const bool open = gap[k] > closedGap;
        const double perGap = p[k] / ((open ? gap[k] : 1.0) * p[k] + slip), weight = open ? perGap : 0.0;
        return {weightX[k] * weight, weightY[k] * weight};
    });
}

TOUCHDOWN_VECTOR_CLONES void setGapsOfVolumes(std::size_t count, const double* volume, const double* perWidth,
                                              double perWidthAcross, double* gap)
{
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) gap[k] = volume[k] * (perWidth[k] * perWidthAcross);
}

} // namespace

FilmLoads::FilmLoads(const GasFilm& film) : film_(film)
{
    for (int k = 0; k < Team::mine().size(); ++k) {
        cutWork_.emplace_back(film.gaps());
        rowGap_.emplace_back(film.pad().stride(), 0.0);
        rowWidth_.emplace_back(film.pad().stride(), 0.0);
    }
    rowForces_.resize(static_cast<std::size_t>(film.pad().ny) + 1);
    for (auto* field : {&gap_, &pressure_, &byGap_, &byPressure_})
        field->assign(std::max(film.pad().stride(), groupSize), 0.0);
    setCouetteWeights();
    setCutArms();
}

void FilmLoads::setCutArms()
{
    const PaddedGrid& pad = film_.pad();
    const CellGrid& grid = film_.gaps().grid;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const FilmGaps::Faces& faces = film_.gaps().faces[axis];
        for (const CutPlace& place : faces.cut) {
            const int i = pad.column(place.at), j = pad.row(place.at);
            const double middle = faces.pathMid[static_cast<std::size_t>(axis == 0 ? i : j)];
            const double x = axis == 0 ? middle : grid.centreX(i), y = axis == 0 ? grid.centreY(j) : middle;
            cutArms_[axis].push_back({0.5 * film_.gaps().length - x, 0.5 * film_.gaps().width - y});
        }
    }
}

/// Couette's weights: viscosity times area times the disk's velocity under the cell's centre.
void FilmLoads::setCouetteWeights()
{
    const PaddedGrid& pad = film_.gaps().pad;
    const auto weights = [&](int i, int j) {
        const Velocity v = diskVelocity(film_.disk(), film_.gaps().length, film_.gaps().width,
                                        film_.gaps().grid.centreX(i), film_.gaps().grid.centreY(j));
        return std::array{film_.air().viscosity * v.x, film_.air().viscosity * v.y};
    };
    for (auto& field : couette_) field.assign(pad.size(), 0.0);
    for (int j = 0; j < pad.ny; ++j)
        for (int i = 0; i < pad.nx; ++i)
            for (std::size_t axis = 0; axis < 2; ++axis)
                couette_[axis][pad.at(i, j)] = weights(i, j)[axis] * film_.areas()[pad.at(i, j)];
    for (const CutPlace& place : film_.gaps().cutCells) {
        const std::array<double, 2> weight = weights(pad.column(place.at), pad.row(place.at));
        for (std::uint32_t k = film_.gaps().rows[place.rows].pieces; k < film_.gaps().rows[place.rows].pieceEnd; ++k) {
            const GapPiece& piece = film_.gaps().pieces[k];
            cutPieces_.recess.push_back(piece.recess);
            cutPieces_.x.push_back(piece.x);
            cutPieces_.y.push_back(piece.y);
            for (std::size_t axis = 0; axis < 2; ++axis)
                cutPieces_.couette[axis].push_back(weight[axis] * piece.extent);
            cutPieces_.at.push_back(place.at);
        }
        for (auto& field : couette_) field[place.at] = 0.0;
    }
}

double FilmLoads::slipLength() const
{
    return 2.0 * (2.0 - film_.slip().accommodation) / film_.slip().accommodation * film_.air().meanFreePath *
           film_.ambient();
}

void FilmLoads::setCellRow(int j, std::span<const double> p)
{
    setRowGaps(j, gap_.data());
    std::copy_n(&p[film_.gaps().pad.at(0, j)], film_.gaps().pad.nx, pressure_.begin());
}

void FilmLoads::setRowGaps(int j, double* gap) const
{
    setGapsOfVolumes(static_cast<std::size_t>(film_.gaps().pad.nx), &film_.volumes()[film_.gaps().pad.at(0, j)],
                     film_.axes()[0].perWidth.data(), film_.axes()[1].perWidth[static_cast<std::size_t>(j)], gap);
}

void FilmLoads::setRowForces(bool loads, bool shears, std::span<const double> p)
{
    const PaddedGrid& pad = film_.gaps().pad;
    const std::size_t nx = static_cast<std::size_t>(pad.nx), up = pad.stride();
    const double slip = slipLength();
    const auto set = [&](int j, std::vector<double>& gap, std::vector<double>& width) {
        RowForces& row = rowForces_[static_cast<std::size_t>(j)];
        const std::size_t at = pad.at(0, j);
        if (shears)
            row.drop[1] = rowDrop(nx, &p[at - up], &p[at], &film_.axes()[1].gap[at], film_.axes()[1].width.data());
        if (j == pad.ny) return;
        if (loads)
            row.load = rowLoad(nx, &p[at], film_.ambient(), film_.axes()[1].width.data(), film_.centresX().data());
        if (!shears) return;
        setRowGaps(j, gap.data());
        row.couette = couette(nx, gap.data(), &p[at], &couette_[0][at], &couette_[1][at], slip);
        std::fill(width.begin(), width.end(), film_.axes()[0].width[static_cast<std::size_t>(j)]);
        row.drop[0] = rowDrop(nx + 1, &p[at - 1], &p[at], &film_.axes()[0].gap[at], width.data());
    };
    Team& team = Team::mine();
    const bool alone = rowGap_.size() < static_cast<std::size_t>(team.size());
    team.items(pad.ny + 1, alone ? pad.ny + 1 : 24, 1, [&](int first, int end, int thread) {
        const std::size_t k = static_cast<std::size_t>(thread);
        for (int j = first; j < end; ++j) set(j, rowGap_[k], rowWidth_[k]);
    });
}

std::size_t FilmLoads::setCutPieces(std::size_t first, std::span<const double> p)
{
    const double base = film_.gaps().lift(film_.attitude(), 0.0, 0.0);
    const std::size_t count = std::min(groupSize, cutPieces_.at.size() - first);
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t n = first + k, at = cutPieces_.at[n];
        const double lift = base - film_.attitude().pitch * cutPieces_.x[n] - film_.attitude().roll * cutPieces_.y[n];
        gap_[k] = cutPieces_.recess[n] - film_.surfaceAt(at) + lift;
        pressure_[k] = p[at];
    }
    return count;
}

void FilmLoads::addCellLoads(std::array<double, 5>& sum) const
{
    for (int j = 0; j < film_.gaps().pad.ny; ++j) {
        const std::array<double, 2>& row = rowForces_[static_cast<std::size_t>(j)].load;
        const double width = film_.gaps().grid.widthY(j), force = width * row[0];
        sum[0] += force;
        sum[1] += 0.5 * film_.gaps().length * force - width * row[1];
        sum[2] += (0.5 * film_.gaps().width - film_.gaps().grid.centreY(j)) * force;
    }
}

/// A step across the motion's path makes a layer that may be thinner than a cell; where none is, kinks at edges and
/// bends between cells cancel in the sum of cells. So of the excess only the part along the motion counts.
void FilmLoads::addCutForces(bool layers, bool drags, std::span<const double> p, std::array<double, 5>& sum)
{
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const bool hasLayers = layers && film_.motionShare()[axis] > 0.0;
        if (!hasLayers && !drags) continue;
        film_.axes()[axis].cutPaths.forces(hasLayers, p, film_.attitude(), film_.axes()[axis].cutSurface,
                                           film_.flowTable(), film_.air().viscosity, cutWork_, cutForces_);
        double drag = 0.0;
        std::array<double, 3> load{};
        for (std::size_t n = 0; n < cutForces_.size(); ++n) {
            const std::array<double, 2>& arms = cutArms_[axis][n];
            load[0] += cutForces_[n].excess;
            load[1] += cutForces_[n].excess * arms[0];
            load[2] += cutForces_[n].excess * arms[1];
            drag += cutForces_[n].drag;
        }
        for (std::size_t k = 0; k < 3; ++k) sum[k] += film_.motionShare()[axis] * load[k];
        sum[3 + axis] += drag;
    }
}

void FilmLoads::addShear(std::span<const double> p, std::array<double, 5>& sum)
{
    const PaddedGrid& pad = film_.gaps().pad;
    const double slip = slipLength();
    const auto add = [&](const std::array<double, 2>& drag) {
        sum[3] += drag[0];
        sum[4] += drag[1];
    };
    for (int j = 0; j < pad.ny; ++j) add(rowForces_[static_cast<std::size_t>(j)].couette);
    for (std::size_t first = 0; first < cutPieces_.at.size(); first += groupSize) {
        const std::size_t count = setCutPieces(first, p);
        add(couette(count, gap_.data(), pressure_.data(), &cutPieces_.couette[0][first], &cutPieces_.couette[1][first],
                    slip));
    }
    for (std::size_t axis = 0; axis < 2; ++axis)
        for (int j = 0; j < pad.ny + (axis == 1); ++j)
            sum[3 + axis] -= 0.5 * rowForces_[static_cast<std::size_t>(j)].drop[axis];
}

std::array<double, 3> FilmLoads::load(std::span<const double> p)
{
    std::array<double, 5> sum{};
    setRowForces(true, false, p);
    addCellLoads(sum);
    addCutForces(true, false, p, sum);
    return {sum[0], sum[1], sum[2]};
}

std::array<double, 2> FilmLoads::shear(std::span<const double> p)
{
    std::array<double, 5> sum{};
    setRowForces(false, true, p);
    addShear(p, sum);
    addCutForces(false, true, p, sum);
    return {sum[3], sum[4]};
}

std::array<double, 5> FilmLoads::loadAndShear(std::span<const double> p)
{
    std::array<double, 5> sum{};
    setRowForces(true, true, p);
    addCellLoads(sum);
    addShear(p, sum);
    addCutForces(true, true, p, sum);
    return sum;
}

FilmForces FilmLoads::forces(std::span<const double> p)
{
    const PaddedGrid& pad = film_.gaps().pad;
    const CellGrid& grid = film_.gaps().grid;
    FilmForces result;
    std::array<double, 2> px{}, py{}; // moments of the positive and of the negative part
    result.maximumPressure = result.minimumPressure = p[pad.at(0, 0)];
    result.maximumAt = result.minimumAt = {grid.centreX(0), grid.centreY(0)};
    for (int j = 0; j < pad.ny; ++j)
        for (int i = 0; i < pad.nx; ++i) {
            const std::size_t at = pad.at(i, j);
            const double x = grid.centreX(i), y = grid.centreY(j),
                         force = (p[at] - film_.ambient()) * film_.areas()[at];
            (force > 0.0 ? result.positive : result.negative) += force;
            px[force > 0.0 ? 0 : 1] += force * x;
            py[force > 0.0 ? 0 : 1] += force * y;
            if (p[at] > result.maximumPressure) result.maximumPressure = p[at], result.maximumAt = {x, y};
            if (p[at] < result.minimumPressure) result.minimumPressure = p[at], result.minimumAt = {x, y};
        }
    if (result.positive > 0.0) result.centreOfPositive = {px[0] / result.positive, py[0] / result.positive};
    if (result.negative < 0.0) result.centreOfNegative = {px[1] / result.negative, py[1] / result.negative};
    const std::array<double, 5> total = loadAndShear(p);
    // The layers' force beyond the cells' pressure belongs to the rails: to the positive part.
    result.positive += total[0] - result.positive - result.negative;
    result.net = total[0];
    result.pitchTorque = total[1];
    result.rollTorque = total[2];
    result.shearX = total[3];
    result.shearY = total[4];
    result.massFlow = film_.massFlow();
    return result;
}

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/contact/adhesive_contact.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/physics/contact/contact_message.h"

namespace touchdown {
namespace {

constexpr double nearMinimum = 0.2; // error below which Newton's method is tried [-]
constexpr int longestPause = 8;

/// The grid, and as many cells beside it as a fast transform needs.
UniformGrid fastGrid(const UniformGrid& grid)
{
    // The padded size of half as many points.
    const auto fast = [](int n) { return paddedSize((n + 1) / 2); };
    return {fast(grid.nx), fast(grid.ny), grid.dx, grid.dy, grid.x0, grid.y0};
}

/// Largest displacement of a cell by pressures between -1 and 1 Pa [m/Pa]: the sum of |influence coefficients|.
double reachOf(HalfSpace& space)
{
    std::vector<double> field(space.grid().cells(), space.edges() == HalfSpaceEdges::Free ? 1.0 : 0.0);
    if (space.edges() == HalfSpaceEdges::Periodic) field[0] = 1.0;
    space.displace(field, field);
    double most = 0.0, sum = 0.0;
    for (const double u : field) {
        most = std::max(most, u);
        sum += std::abs(u);
    }
    // Free: none is negative, and the middle sees all of them.
    return space.edges() == HalfSpaceEdges::Free ? most : sum;
}

} // namespace

AdhesiveContact::AdhesiveContact(HalfSpace space, const Adhesion& adhesion, const ElasticContactOptions& options)
    : options_(options),
      cell_(AdhesionLaw(adhesion), space.ownCompliance(), options.hardness),
      reach_(reachOf(space)),
      freeScale_(adhesion.equilibriumDistance)
{
    const UniformGrid grid = space.grid();
    attraction_.assign(grid.cells(), 0.0);
    if (!adhesion.acts()) {
        elastic_.emplace(std::move(space), options);
        return;
    }
    periodic_.emplace(fastGrid(grid), space.modulus(), HalfSpaceEdges::Periodic);
    repeated_.assign(periodic_->grid().cells(), 0.0);
    space_.emplace(std::move(space));
    for (Solution* solution : {&now_, &kept_[0], &kept_[1], &before_, &lower_})
        for (auto* field : {&solution->separation, &solution->total, &solution->displacement})
            field->assign(grid.cells(), 0.0);
    for (auto* field : {&pressure_, &gap_, &present_, &offset_, &weight_, &residual_, &change_, &moved_, &direction_,
                        &shift_, &image_, &work_, &totalBefore_, &displacementBefore_, &displacementEarlier_})
        field->assign(grid.cells(), 0.0);
    softening_.assign(grid.cells(), 0.0);
    tangents_ = AdhesiveCell::Tangents(grid.cells());
    gmres_.emplace(grid.cells(), mostNewtonIterations);
}

void AdhesiveContact::reset()
{
    if (elastic_) return elastic_->reset();
    std::fill(now_.total.begin(), now_.total.end(), 0.0);
    std::fill(now_.displacement.begin(), now_.displacement.end(), 0.0);
    now_.exists = now_.adheres = false;
    now_.displaced = true;
}

std::optional<std::string> AdhesiveContact::objection(std::span<const double> separation) const
{
    double mean = 0.0;
    for (const double s : separation) mean += s;
    mean /= static_cast<double>(separation.size());
    if (!std::isfinite(mean)) return "The separation of the surfaces is not a finite number everywhere.";
    if (space_->edges() == HalfSpaceEdges::Periodic && options_.hardness <= 0.0 && mean <= 0.0)
        return overlapMessage(-mean);
    return std::nullopt;
}

AdhesiveContactSummary AdhesiveContact::solve(std::span<const double> separation)
{
    assert(separation.size() == attraction_.size());
    if (elastic_) return {elastic_->solve(separation)};
    AdhesiveContactSummary summary;
    if (auto problem = objection(separation)) {
        summary.message = std::move(*problem);
        return summary;
    }
    before_ = now_;
    iterations_ = 0;
    stopped_ = false;
    std::copy(separation.begin(), separation.end(), now_.separation.begin());
    if (solveFar(separation))
        summary.converged = true;
    else
        descendToMinimum(summary);
    summary.iterations = iterations_;
    if (!std::isfinite(summary.error)) {
        reset();
        for (auto* field : {&pressure_, &attraction_}) std::fill(field->begin(), field->end(), 0.0);
        std::copy(separation.begin(), separation.end(), gap_.begin());
        summary.message = "The numbers of the contact are too large or too small to compute with.";
        return summary;
    }
    finish(before_, summary);
    if (stopped_ && !summary.converged)
        summary.message = "The adhesive contact was stopped before it converged.";
    else if (!summary.converged)
        summary.message =
            sentence("The adhesive contact did not converge in %d iterations: the error is %.2g, %.2g was asked.",
                     iterations_, summary.error, options_.tolerance);
    return summary;
}

// The deformation changes a gap by no more than reach max|f|, and with it a pressure by max|df/dg| times that.
bool AdhesiveContact::solveFar(std::span<const double> separation)
{
    if (now_.exists && now_.adheres) return false;
    const AdhesionLaw& law = cell_.law();
    const double nearest = *std::min_element(separation.begin(), separation.end());
    if (!(nearest > law.peakGap())) return false;
    double largest = 0.0, steepest = 0.0;
    for (std::size_t i = 0; i < separation.size(); ++i) {
        const AdhesionLaw::Sample f = law.sample(separation[i]);
        largest = std::max(largest, std::abs(f.pressure));
        steepest = std::max(steepest, std::abs(f.derivative));
        image_[i] = f.pressure;
    }
    if (!(steepest * reach_ * largest <= options_.tolerance * law.peakAttraction())) return false;
    now_.total.swap(image_);
    std::fill(now_.displacement.begin(), now_.displacement.end(), 0.0);
    now_.displaced = false;
    for (std::size_t i = 0; i < separation.size(); ++i) {
        tangents_.state[i] = AdhesiveCell::State::Far;
        tangents_.gap[i] = separation[i];
        tangents_.pressure[i] = now_.total[i];
        tangents_.stiffness[i] = 0.0;
    }
    return true;
}

void AdhesiveContact::descendToMinimum(AdhesiveContactSummary& summary)
{
    constexpr double mostAhead = 4.0;
    if (!now_.exists) {
        std::fill(now_.total.begin(), now_.total.end(), 0.0);
        now_.displaced = false;
    }
    if (!now_.displaced) displace();
    ahead_ = 0.0;
    int untilNewton = 0,
        pause = 1; // descents before Newton's method is tried, more after each time that it does not help
    double movedBefore = 0.0;
    double least = INFINITY;
    bool first = before_.exists && before_.displaced; // nothing has moved yet
    for (;;) {
        setOffsets();
        summary.error = linearise();
        if (summary.error <= options_.tolerance) {
            summary.error = std::max(summary.error, imbalance());
            summary.converged = summary.error <= options_.tolerance;
        }
        if (summary.converged || spent() || !std::isfinite(summary.error)) return;
        if (summary.error < nearMinimum && --untilNewton <= 0 && !snaps()) {
            if (newtonStep(summary.error)) {
                ahead_ = movedBefore = 0.0;
                first = false;
                continue;
            }
            setOffsets();
            linearise();
            untilNewton = pause = std::min(2 * pause, longestPause);
        }
        const bool elsewhere = setTangents(first);
        first = false;
        const double moved = descend(elsewhere ? linearise() : summary.error);
        const bool wasAhead = ahead_ > 0.0;
        const double reached = wasAhead ? presentEnergy() : 0.0;
        if (wasAhead && reached > least) {
            std::swap(now_, lower_);
            ahead_ = movedBefore = 0.0;
            continue;
        }
        const bool goesOn = movedBefore > 0.0 && moved > 0.7 * movedBefore;
        ahead_ = goesOn ? std::min(2.0 * ahead_ + 1.0, mostAhead) : moved > 0.3 * movedBefore ? 0.5 * ahead_ : 0.0;
        movedBefore = moved;
        if (ahead_ > 0.0) {
            lower_ = now_;
            least = wasAhead ? reached : presentEnergy();
        }
    }
}

// Whether a cell softens by more than the half-space alone would hold it with all others at rest: no minimum is there.
bool AdhesiveContact::snaps() const
{
    for (std::size_t i = 0; i < present_.size(); ++i)
        if (tangents_.state[i] == AdhesiveCell::State::Far &&
            cell_.law().derivative(tangents_.gap[i]) >= space_->ownStiffness())
            return true;
    return false;
}

// With contact pressure times what is left of the gap where it should be closed: exact to second order in these gaps.
double AdhesiveContact::presentEnergy() const
{
    double sum = 0.0;
    for (std::size_t i = 0; i < now_.total.size(); ++i) {
        const double gap = gapAt(i), pressed = now_.total[i] - cell_.closedPressure();
        sum += 0.5 * now_.total[i] * now_.displacement[i] + cell_.energy(gap);
        if (tangents_.state[i] == AdhesiveCell::State::Contact) sum -= pressed * gap;
    }
    return sum * space_->grid().cellArea();
}

// The fields that are returned lie on the law exactly; the residual is in the balance of gaps.
void AdhesiveContact::finish(const Solution& before, AdhesiveContactSummary& summary)
{
    using enum AdhesiveCell::State;
    const double closed = cell_.closedPressure();
    double contact = 0.0, adhesion = 0.0;
    double work = 0.0, quadrature = 0.0; // by moving the surfaces; the change of pressure times that of separation
    double neglected = 0.0;              // of the energy of solutions far away
    for (std::size_t i = 0; i < now_.total.size(); ++i) {
        const double total = tangents_.pressure[i];
        const bool touches = tangents_.state[i] == Contact || tangents_.state[i] == Flowed;
        gap_[i] = tangents_.gap[i];
        attraction_[i] = touches ? closed : total;
        pressure_[i] = touches ? std::max(total - closed, 0.0) : 0.0;
        contact += pressure_[i];
        adhesion += attraction_[i];
        const double moved = now_.separation[i] - before.separation[i];
        work -= 0.5 * (now_.total[i] + before.total[i]) * moved;
        neglected += (now_.displaced ? 0.0 : now_.total[i] * now_.total[i]) +
                     (before.displaced ? 0.0 : before.total[i] * before.total[i]);
        quadrature += (now_.total[i] - before.total[i]) * moved;
    }
    const double area = space_->grid().cellArea();
    summary.load = contact * area;
    summary.adhesionForce = adhesion * area;
    now_.energy = presentEnergy();
    if (before.exists) {
        constexpr double rounding = 1e-12;
        summary.energyDrop = before.energy + work * area - now_.energy;
        const double doubt = rounding * (std::abs(before.energy) + std::abs(now_.energy) + std::abs(work * area)) +
                             0.5 * reach_ * neglected * area;
        summary.jumped = summary.energyDrop > 0.25 * std::abs(quadrature * area) + doubt;
    }
    now_.exists = true;
    now_.adheres = std::ranges::any_of(tangents_.state, [](AdhesiveCell::State state) { return state != Far; });
}

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/film_line_multigrid.h"

#include <algorithm>
#include <utility>

namespace touchdown {

namespace {

constexpr int coarsestAlong = 16;     // along the longer axis, or
constexpr int coarsestAcross = 4;     // along the shorter one
constexpr int coarsestSweeps = 16;    // there, which solve nearly exactly
constexpr int coarsestCycles = 4;     // there, to begin with
constexpr int sweeps = 2;             // of one relaxation
constexpr int deferrals = 4;          // of the complete flux scheme's correction, in one relaxation
constexpr double keptGuess = 0.1;     // residual of a guess that climbing the levels would spoil [-]
constexpr double enoughGain = 0.2;    // of a cycle, for operators to be kept [-]
constexpr double slowGain = 0.25;     // of a cycle, beyond which cycles are accelerated [-]
constexpr double forcing = 0.03;      // of an accelerated step, against its residual [-]
constexpr double toleratedLoss = 4.0; // against the best residual, for a cycle to be kept [-]

void copy(std::span<const double> from, std::span<double> to) { std::copy(from.begin(), from.end(), to.begin()); }

void add(std::span<const double> term, std::span<double> sum)
{
    for (std::size_t at = 0; at < sum.size(); ++at) sum[at] += term[at];
}

void negate(std::span<const double> from, std::span<double> to)
{
    for (std::size_t at = 0; at < to.size(); ++at) to[at] = -from[at];
}

} // namespace

FilmLineMultigrid::Level::Level(std::shared_ptr<const FilmGaps> gaps, const FilmSetting& setting)
    : film(std::move(gaps), setting),
      lines(film.pad()),
      toCoarser(film.gaps().grid),
      complete(setting.scheme == ConvectionScheme::CompleteFlux),
      pressure(film.pad().size(), setting.air.pressure)
{
    flows.resize(film.pad().size());
    for (auto* field : {&residual, &right, &correction, &change}) field->assign(film.pad().size(), 0.0);
}

FilmLineMultigrid::FilmLineMultigrid(const Recess& recess, std::shared_ptr<const FilmGaps> finest,
                                     const FilmSetting& setting)
    : gmres_(finest->pad.size()), newton_(finest->pad.size()), step_(finest->pad.size())
{
    CellGrid next = finest->grid;
    levels_.emplace_back(std::move(finest), setting);
    best_ = levels_.front().pressure;
    FilmSetting coarser = setting;
    if (setting.scheme == ConvectionScheme::CompleteFlux) coarser.scheme = ConvectionScheme::Exponential;
    while (std::max(next.nx(), next.ny()) > coarsestAlong && std::min(next.nx(), next.ny()) > coarsestAcross) {
        next = everySecondLine(next);
        levels_.emplace_back(std::make_shared<const FilmGaps>(recess, next), coarser);
    }
}

void FilmLineMultigrid::setAttitude(const Attitude& attitude)
{
    for (Level& level : levels_) level.film.setAttitude(attitude);
}

FilmSolution FilmLineMultigrid::solve(std::span<double> p, const FilmOptions& options, const FilmMonitor& monitor)
{
    Level& fine = levels_.front();
    FilmSolution result;
    start(p, result);
    double last = residualOf(fine), best = last, shift = 0.0;
    copy(fine.pressure, best_);
    bool stale = true, slow = false;
    while (true) {
        result.residual = best;
        result.cancelled = monitor && !monitor(result.iterations, best);
        result.converged = !result.cancelled && best <= options.tolerance;
        if (result.cancelled || result.converged || result.iterations >= options.maximumIterations) break;

        if (stale) linearise(shift);
        const int cycles = slow ? accelerate(options.maximumIterations - result.iterations) : 1;
        if (!slow) {
            negate(fine.residual, fine.right);
            cycle(0);
        }
        addBounded(fine.pressure, fine.correction);
        result.iterations += cycles;
        result.solves += cycles;
        const double now = residualOf(fine);
        if (now <= toleratedLoss * best) {
            stale = slow || shift > 0.0 || now > enoughGain * last;
            slow = slow || now > slowGain * last;
            shift = shorterShift(shift, now / last);
            last = now;
        } else {
            stale = slow = true;
            shift = shift == 0.0 ? 10.0 * fine.film.passage() : 8.0 * shift;
            copy(best_, fine.pressure);
            last = best;
        }
        if (last < best) {
            best = last;
            copy(fine.pressure, best_);
        }
    }
    copy(best_, p);
    return result;
}

void FilmLineMultigrid::start(std::span<const double> guess, FilmSolution& result)
{
    Level& fine = levels_.front();
    copy(guess, fine.pressure);
    const double residual = residualOf(fine);
    if (residual <= keptGuess) return;
    climb(result);
    if (!(residualOf(fine) <= toleratedLoss * residual)) copy(guess, fine.pressure);
}

void FilmLineMultigrid::climb(FilmSolution& result)
{
    for (std::size_t l = 0; l + 1 < levels_.size(); ++l)
        levels_[l].toCoarser.mean(levels_[l].pressure, levels_[l + 1].pressure);
    for (std::size_t l = levels_.size() - 1; l > 0; --l) {
        Level& level = levels_[l];
        const int cycles = l + 1 == levels_.size() ? coarsestCycles : 1;
        for (int k = 0; k < cycles; ++k) {
            level.linearise(0.0);
            negate(level.residual, level.right);
            cycle(l);
            addBounded(level.pressure, level.correction);
            ++result.solves;
        }
        // The finer level takes over how far its guess was wrong here.
        Level& finer = levels_[l - 1];
        copy(level.pressure, level.change); // the rings too, so that their difference is zero
        finer.toCoarser.mean(finer.pressure, level.change);
        for (std::size_t at = 0; at < level.change.size(); ++at)
            level.change[at] = level.pressure[at] - level.change[at];
        finer.toCoarser.interpolate(level.change, finer.change);
        addBounded(finer.pressure, finer.change);
    }
}

void FilmLineMultigrid::linearise(double shift)
{
    levels_.front().linearise(shift);
    for (std::size_t l = 1; l < levels_.size(); ++l) {
        levels_[l - 1].toCoarser.mean(levels_[l - 1].pressure, levels_[l].pressure);
        levels_[l].linearise(shift);
    }
}

void FilmLineMultigrid::Level::linearise(double newShift)
{
    shift = newShift;
    film.linearise(pressure, residual);
    const auto& [x, y] = film.faces();
    lines.setOperator({MonotoneFaces{x.effective, x.convection}, MonotoneFaces{y.effective, y.convection}},
                      film.volumes(), shift);
}

void FilmLineMultigrid::cycle(std::size_t index)
{
    Level& level = levels_[index];
    std::fill(level.correction.begin(), level.correction.end(), 0.0);
    if (index + 1 == levels_.size()) {
        level.relax(coarsestSweeps, true);
        return;
    }
    Level& coarser = levels_[index + 1];
    level.relax(sweeps, true);
    level.leave();
    level.toCoarser.sum(level.residual, coarser.right);
    cycle(index + 1);
    level.toCoarser.interpolate(coarser.correction, level.change);
    add(level.change, level.correction);
    level.relax(sweeps, false);
}

int FilmLineMultigrid::accelerate(int most)
{
    Level& fine = levels_.front();
    negate(fine.residual, newton_);
    std::fill(step_.begin(), step_.end(), 0.0);
    const auto apply = [&](std::span<const double> v, std::span<double> out) { fine.apply(v, out); };
    const auto precondition = [&](std::span<const double> v, std::span<double> out) {
        copy(v, fine.right);
        cycle(0);
        copy(fine.correction, out);
    };
    const GmresResult linear = gmres_.solve(apply, precondition, newton_, step_,
                                            {.tolerance = forcing, .maximumIterations = std::max(1, most)});
    copy(step_, fine.correction);
    return std::max(1, linear.iterations);
}

void FilmLineMultigrid::Level::relax(int count, bool fromZero)
{
    if (!complete) {
        for (int k = 0; k < count; ++k) lines.sweep(right, correction);
        return;
    }
    for (int d = 0; d < deferrals; ++d) {
        if (d == 0 && fromZero)
            copy(right, residual);
        else
            leave();
        std::fill(change.begin(), change.end(), 0.0);
        for (int k = 0; k < count; ++k) lines.sweep(residual, change);
        add(change, correction);
    }
}

void FilmLineMultigrid::Level::leave()
{
    if (!complete) {
        lines.residual(right, correction, residual);
        return;
    }
    apply(correction, residual);
    for (std::size_t at = 0; at < residual.size(); ++at) residual[at] = right[at] - residual[at];
}

void FilmLineMultigrid::Level::apply(std::span<const double> v, std::span<double> out)
{
    film.applyJacobian<double>(v, out, flows);
    const std::vector<double>& volumes = film.volumes();
    for (std::size_t at = 0; at < out.size(); ++at) out[at] += shift * volumes[at] * v[at];
}

double FilmLineMultigrid::residualOf(Level& level)
{
    level.film.residual(level.pressure, level.residual);
    return residualNorm(level.film, level.residual);
}

double FilmLineMultigrid::shorterShift(double shift, double gain) const
{
    const double next = shift * std::clamp(gain, 0.1, 0.7);
    return next < 0.01 * levels_.front().film.passage() ? 0.0 : next;
}

} // namespace touchdown

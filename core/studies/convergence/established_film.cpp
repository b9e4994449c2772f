// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/convergence/established_film.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "core/formats/units.h"
#include "core/physics/film/film_grid.h"
#include "core/physics/slider/minimum_spacing.h"
#include "core/simulation/static_state/film_setup.h"
#include "core/simulation/static_state/slider_body.h"
#include "core/simulation/static_state/steady.h"
#include "core/studies/convergence/node_film.h"
#include "core/work/wall_clock.h"

namespace touchdown {

namespace {

constexpr int startNodes = 97;         // of our own film, where a flight begins
constexpr double loadTolerance = 1e-5; // as SteadyCase::loadTolerance measures it [-]
constexpr int mostAttitudes = 40;
constexpr double longestStep = 0.3; // of a change of attitude, against the minimum spacing [-]

class EstablishedFilm {
public:
    EstablishedFilm(const Case& c, int nodes, const GoOn& goOn)
        : case_(c),
          goOn_(goOn),
          recess_(c.surface, c.slider.length, c.slider.width),
          spacing_(c.surface, recess_),
          film_(recess_, settingOf(c), uniformGrid(c.slider.length, c.slider.width, nodes - 1, nodes - 1),
                FaceGaps::TwoOfSamples)
    {}

    FilmState atInitialAttitude()
    {
        const Attitude attitude{case_.initial.nominalTrailingEdgeHeight, case_.initial.pitch, case_.initial.roll};
        const NodeFilmResult result = film_.solve(attitude, goOn_);
        return result.converged ? stateOf(attitude, result) : unsolved(result);
    }

    FilmState flying()
    {
        const SliderLoad load = sliderLoad(case_);
        Case own = attitudeCase(case_);
        own.film.nodes = {startNodes, startNodes};
        own.film.accuracy = 0.0;
        own.steady.stiffness = true;
        const SteadyResult start = steady(own, [this](const SteadyProgress&) { return !goOn_ || goOn_(); });
        if (start.status != SteadyStatus::Converged) return {.problem = "no start was found: " + start.message};
        Matrix3 stiffness = *start.stiffness;
        stiffness(1, 1) += load.pitchStiffness;
        stiffness(2, 2) += load.rollStiffness;
        if (load.holdsRoll) stiffness.row(2) = stiffness.col(2).transpose() = Vector3::UnitZ().transpose();

        Attitude attitude = start.attitude;
        Vector3 step = Vector3::Zero(), before = Vector3::Zero();
        for (int k = 0; k < mostAttitudes; ++k) {
            const NodeFilmResult result = film_.solve(attitude, goOn_);
            if (!result.converged) return unsolved(result);
            const Vector3 imbalance = imbalanceOf(load, start, attitude, result);
            const double error =
                (std::abs(imbalance[0]) + (std::abs(imbalance[1]) + std::abs(imbalance[2])) / case_.slider.length) /
                load.preload;
            if (error <= loadTolerance) return stateOf(attitude, result);
            if (k > 0) stiffness -= (imbalance - before + stiffness * step) * scaled(step).transpose();
            before = imbalance;
            step = limited(stiffness.partialPivLu().solve(imbalance), attitude);
            attitude = {attitude.height + step[0], attitude.pitch + step[1], attitude.roll + step[2]};
        }
        return {.problem = "no balance after " + std::to_string(mostAttitudes) + " attitudes"};
    }

private:
    static FilmSetting settingOf(const Case& c)
    {
        FilmSetting setting = filmSetting(c);
        setting.scheme = ConvectionScheme::PowerLaw;
        return setting;
    }

    FilmState stateOf(const Attitude& attitude, const NodeFilmResult& result) const
    {
        FilmState state;
        state.netForce = result.load;
        state.minimumSpacing = spacing_.at(attitude).spacing;
        state.pitch = attitude.pitch;
        state.roll = attitude.roll;
        return state;
    }

    static FilmState unsolved(const NodeFilmResult& result)
    {
        return {.problem = "film residual " + fewDigits(result.residual, "") + " remains"};
    }

    static Vector3 imbalanceOf(const SliderLoad& load, const SteadyResult& own, const Attitude& attitude,
                               const NodeFilmResult& result)
    {
        return {result.load - load.preload,
                result.pitchTorque + own.shearPitchTorque + load.pitchTorque -
                    load.pitchStiffness * (attitude.pitch - load.staticPitch),
                load.holdsRoll ? 0.0
                               : result.rollTorque + own.shearRollTorque + load.rollTorque -
                                     load.rollStiffness * (attitude.roll - load.staticRoll)};
    }

    /// Displacements at the ends of the slider, so that heights and angles count alike [m].
    Vector3 lengths() const { return {1.0, case_.slider.length, case_.slider.width}; }
    /// s with s . step = 1, along the step in these lengths.
    Vector3 scaled(const Vector3& step) const
    {
        const Vector3 inLengths = step.cwiseProduct(lengths());
        return inLengths.cwiseProduct(lengths()) / inLengths.squaredNorm();
    }
    Vector3 limited(const Vector3& step, const Attitude& attitude) const
    {
        const double change = step.cwiseProduct(lengths()).cwiseAbs().sum();
        const double most = longestStep * std::max(spacing_.at(attitude).spacing, 0.0);
        return change > most ? Vector3(step * (most / change)) : step;
    }

    const Case& case_;
    const GoOn& goOn_;
    Recess recess_;
    MinimumSpacing spacing_;
    NodeFilm film_;
};

} // namespace

FilmMethod establishedMethod()
{
    return {"established manner", [](const Case& slider, int nodes, const GoOn& goOn) {
                const double begin = wallClock();
                EstablishedFilm film(slider, nodes, goOn);
                FilmState state = slider.steady.fixedAttitude ? film.atInitialAttitude() : film.flying();
                state.seconds = wallClock() - begin;
                return state;
            }};
}

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/design/design.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/case/parameters.h"
#include "core/formats/units.h"
#include "core/numerics/bounded_step.h"
#include "core/simulation/static_state/steady_quantities.h"

namespace touchdown {

namespace {

/// Farthest step of one iteration, in shares of the parameters' ranges.
constexpr double farthestStep = 0.3;
/// Below it a step changes nothing that a static state resolves.
constexpr double shortestStep = 1e-8;
constexpr double firstDamping = 1e-3;
constexpr double largestDamping = 1e6;

/// The film may balance the load with rails below the mean plane of the disk: the attitude is known then.
bool isBalanced(const Case& c, const SteadyResult& state)
{
    if (state.status == SteadyStatus::Converged) return true;
    return state.status == SteadyStatus::Failed && state.minimumSpacing <= 0.0 && state.residual <= c.film.tolerance &&
           (c.steady.fixedAttitude || state.loadError <= c.steady.loadTolerance);
}

double largest(const std::vector<double>& values)
{
    double magnitude = 0.0;
    for (const double value : values) magnitude = std::max(magnitude, std::abs(value));
    return magnitude;
}

double squares(const std::vector<double>& values)
{
    return std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
}

class DesignSearch {
public:
    DesignSearch(const Case& c, const DesignTask& task, const DesignCallback& callback)
        : case_(c), task_(task), callback_(callback)
    {
        case_.steady.stiffness = false;
        case_.steady.sensitivities = false;
        case_.steady.allEquilibria = false;
    }

    DesignStudy search()
    {
        std::vector<double> u;
        for (const DesignParameter& p : task_.parameters) u.push_back((p.start - p.minimum) / (p.maximum - p.minimum));
        Trial best = evaluate(u);
        accept(best);
        double damping = firstDamping;
        while (!cancelled_ && best.known && !reached(best) && iteration_ < task_.maximumIterations) {
            ++iteration_;
            Slopes slopes;
            if (!differentiate(u, best, slopes)) break;
            if (!improve(u, best, slopes, damping)) break;
        }
        for (const int digits : {4, 6, 8}) {
            if (cancelled_ || iteration_ == 0 || !best.known || !reached(best)) break;
            Trial plain = evaluate(u, digits);
            if (std::exchange(cancelled_, false)) break; // what was found stands
            if (!plain.known || !reached(plain)) continue;
            study_.steps.pop_back(); // the same set, with few digits
            accept(best = std::move(plain));
            break;
        }
        return conclude(best);
    }

private:
    using Slopes = std::vector<std::vector<double>>; // J column by column, for the shares u

    struct Trial {
        bool known = false;          // there is a static state
        std::vector<double> misfits; // r
        DesignPoint point;
        SteadyResult state;
        Case tried;
    };

    bool reached(const Trial& trial) const { return trial.point.misfit <= 1.0; }

    /// The values of the shares u, rounded to so many digits; 0: as they are.
    Trial evaluate(const std::vector<double>& u, int digits = 0)
    {
        Trial trial;
        trial.point.iteration = iteration_;
        for (std::size_t i = 0; i < u.size(); ++i) {
            const DesignParameter& p = task_.parameters[i];
            const double value = std::lerp(p.minimum, p.maximum, u[i]);
            const bool rounds = digits > 0 && value != p.minimum && value != p.maximum;
            const double plain = rounds ? roundedIn(value, p.keys.front().displayUnit, digits) : value;
            trial.point.parameters.push_back(std::clamp(plain, p.minimum, p.maximum));
        }
        trial.tried = case_;
        trial.point.problem = applyParameters(trial.tried, task_.parameters, trial.point.parameters);
        if (!trial.point.problem.empty()) return trial;
        trial.state = steady(trial.tried, [this](const SteadyProgress&) {
            cancelled_ = callback_ && !callback_({iteration_, study_.solves, best_, std::exchange(better_, nullptr)});
            return !cancelled_;
        });
        ++study_.solves;
        trial.state.dropFields();
        if (!isBalanced(trial.tried, trial.state)) {
            trial.point.problem = trial.state.message;
            return trial;
        }
        const std::vector<SteadyQuantity> all = steadyQuantities(trial.state);
        trial.known = true;
        for (const DesignTarget& target : task_.targets) {
            const auto found =
                std::ranges::find(all, target.quantity.name, [](const auto& q) { return q.quantity.name; });
            trial.point.quantities.push_back(found->value);
            trial.misfits.push_back((found->value - target.value) / target.tolerance);
            trial.known = trial.known && std::isfinite(trial.misfits.back());
        }
        trial.point.misfit = largest(trial.misfits);
        if (!trial.known) trial.point.problem = "the static state has no finite value of a target";
        return trial;
    }

    void accept(const Trial& trial)
    {
        study_.steps.push_back(trial.point);
        study_.state = trial.state;
        study_.found = trial.tried;
        best_ = trial.point.misfit;
        better_ = &study_;
    }

    /// J by a difference of each parameter, away from the bound that is nearer; on the other side where there is no
    /// state.
    bool differentiate(const std::vector<double>& u, const Trial& best, Slopes& slopes)
    {
        for (std::size_t i = 0; i < u.size(); ++i) {
            const double inward = u[i] > 0.5 ? -task_.difference : task_.difference;
            for (const double step : {inward, -inward}) {
                std::vector<double> moved = u;
                moved[i] += step;
                if (slopes.size() > i || moved[i] < 0.0 || moved[i] > 1.0) continue;
                const Trial trial = evaluate(moved);
                if (cancelled_) return false;
                if (!trial.known) {
                    obstacle_ = trial.point.problem;
                    continue;
                }
                std::vector<double>& column = slopes.emplace_back();
                for (std::size_t k = 0; k < trial.misfits.size(); ++k)
                    column.push_back((trial.misfits[k] - best.misfits[k]) / step);
            }
            if (slopes.size() == i) return false;
        }
        return true;
    }

    /// Steps with more and more damping until one is better; false where none is.
    bool improve(std::vector<double>& u, Trial& best, const Slopes& slopes, double& damping)
    {
        while (damping < largestDamping) {
            const std::vector<double> step = stepFrom(u, slopes, best.misfits, damping);
            if (largest(step) < shortestStep) return false;
            std::vector<double> moved = u;
            for (std::size_t i = 0; i < u.size(); ++i) moved[i] = std::clamp(u[i] + step[i], 0.0, 1.0);
            Trial trial = evaluate(moved);
            if (cancelled_) return false;
            if (trial.known && (reached(trial) || squares(trial.misfits) < squares(best.misfits))) {
                u = moved;
                best = std::move(trial);
                accept(best);
                damping = std::max(0.1 * damping, 1e-12);
                return true;
            }
            if (!trial.known) obstacle_ = trial.point.problem;
            damping = std::max(8.0 * damping, firstDamping);
        }
        return false;
    }

    std::vector<double> stepFrom(const std::vector<double>& u, const Slopes& slopes, const std::vector<double>& r,
                                 double damping) const
    {
        std::vector<double> low, high;
        for (const double share : u) {
            low.push_back(std::max(-share, -farthestStep));
            high.push_back(std::min(1.0 - share, farthestStep));
        }
        return boundedStep(slopes, r, damping, low, high);
    }

    DesignStudy conclude(const Trial& best)
    {
        if (cancelled_) {
            study_.status = StudyStatus::Cancelled;
            study_.message = "stopped before the targets were reached";
        } else if (!best.known) {
            study_.message = "no static state to start from: " + best.point.problem;
        } else if (reached(best)) {
            study_.status = StudyStatus::Completed;
        } else {
            study_.message = "the targets are not reached within the bounds";
            if (iteration_ >= task_.maximumIterations)
                study_.message = "the targets are not reached in " + std::to_string(iteration_) +
                                 (iteration_ == 1 ? " iteration" : " iterations");
            if (const std::string bounds = boundsReached(best.point); !bounds.empty())
                study_.message += "; the best set lies on the bound of " + bounds;
            if (!obstacle_.empty()) study_.message += "; a set nearby has no static state: " + obstacle_;
        }
        study_.found.steady = given_;
        return std::move(study_);
    }

    std::string boundsReached(const DesignPoint& point) const
    {
        std::string names;
        for (std::size_t i = 0; i < task_.parameters.size(); ++i) {
            const DesignParameter& p = task_.parameters[i];
            if (point.parameters[i] != p.minimum && point.parameters[i] != p.maximum) continue;
            names += (names.empty() ? "" : " and of ") + p.keys.front().key;
        }
        return names;
    }

    Case case_;
    const DesignTask& task_;
    const DesignCallback& callback_;
    const SteadyCase given_ = case_.steady; // what the case asks for besides the attitude
    DesignStudy study_;
    int iteration_ = 0;
    double best_ = 0.0;
    const DesignStudy* better_ = nullptr; // not yet reported
    bool cancelled_ = false;
    std::string obstacle_; // why the last set without a static state has none
};

} // namespace

std::string reasonNotToDesign(const Case& c)
{
    if (c.model != ModelKind::Film)
        return "a design study takes a case of model \"film\", whose static state it looks for";
    if (seriesOf(c).size() > 1) return "lists a series of static states; a design study takes one";
    return {};
}

std::string applyParameters(Case& c, const std::vector<DesignParameter>& parameters, const std::vector<double>& values)
{
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const std::vector<Parameter>& keys = parameters[i].keys;
        const double change = values[i] - numberOf(keys.front(), c);
        for (std::size_t k = 0; k < keys.size(); ++k) {
            const double value = k == 0 ? values[i] : numberOf(keys[k], c) + change;
            if (const auto problem = setFromNumber(c, keys[k], value)) return keys[k].key + ": " + *problem;
        }
    }
    for (const CaseProblem& problem : checkCombinations(c)) return problem.key + ": " + problem.message;
    return {};
}

DesignStudy studyDesign(const Case& c, const DesignTask& task, const DesignCallback& callback)
{
    return DesignSearch(c, task, callback).search();
}

} // namespace touchdown

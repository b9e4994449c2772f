// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/cycles/bouncing_springs.h"

#include <algorithm>
#include <cmath>

#include "core/case/contact_law.h"
#include "core/case/parameters.h"
#include "core/formats/units.h"
#include "core/numerics/adaptive.h"
#include "core/numerics/gauss_legendre.h"

namespace touchdown {

namespace {

using CycleState = SpringModel::State;
using CycleMode = SpringModel::Mode;

constexpr int looksPerStep = 6; // at which the extreme spacings are sought

/// The normal of a guard in the space of states.
Eigen::RowVector4d normalOf(const SpringModel& model, int guard)
{
    Eigen::RowVector4d normal = Eigen::RowVector4d::Zero();
    for (int k = 0; k < 2; ++k) normal[k] = model.ratesOf(Eigen::Vector2d::Unit(k))[guard];
    return normal;
}

class ReturnRecorder {
public:
    ReturnRecorder(const BouncingSprings& map, const ReturnRequest& request, const CycleState& start, Return& result)
        : map_(map), model_(map.model()), request_(request), result_(result), y_(start)
    {}

    template <class At>
    bool step(double t, const CycleState& y, CycleMode mode, At&& at)
    {
        if (result_.returned) return false;
        if (request_.derivative) propagate(t, y, mode, at);
        if (request_.measurements) measure(t, mode, at);
        time_ = t;
        y_ = y;
        return true;
    }

    void event(double time, int guard, bool, CycleMode before, CycleMode after)
    {
        if (result_.returned) return;
        result_.switches.push_back({guard, before, after});
        const bool crossing = result_.switches.back().crosses();
        if (crossing) result_.passed.emplace_back(map_.coordinates(y_));
        const bool last = crossing && result_.passed.size() == static_cast<std::size_t>(request_.crossings);
        if (request_.derivative) switchTo(guard, before, after, last);
        if (!last) return;
        result_.returned = true;
        result_.time = time;
    }

    const Eigen::Matrix4d& fundamental() const { return phi_; }

private:
    Eigen::Matrix4d slopeOf(const CycleState& y, CycleMode mode) const
    {
        Eigen::Matrix4d a = Eigen::Matrix4d::Zero();
        a(0, 2) = a(1, 3) = 1.0;
        a.bottomRows<2>() = model_.jacobian(y, mode);
        return a;
    }

    /// Phi' = A Phi over a step, by Kutta's method of fourth order.
    template <class At>
    void propagate(double t, const CycleState& y, CycleMode mode, At& at)
    {
        const double h = t - time_;
        const Eigen::Matrix4d a0 = slopeOf(y_, mode), a1 = slopeOf(at(time_ + 0.5 * h), mode), a2 = slopeOf(y, mode);
        const Eigen::Matrix4d k1 = a0 * phi_, k2 = a1 * (phi_ + 0.5 * h * k1), k3 = a1 * (phi_ + 0.5 * h * k2),
                              k4 = a2 * (phi_ + h * k3);
        phi_ += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    }

    void switchTo(int guard, CycleMode before, CycleMode after, bool last)
    {
        const CycleState from = model_.derivative(y_, before);
        const Eigen::RowVector4d normal = normalOf(model_, guard);
        // At the section time is free: the deviation is projected along the motion.
        const CycleState jump = last ? CycleState(-from) : CycleState(model_.derivative(y_, after) - from);
        phi_ += jump * ((normal * phi_) / normal.dot(from));
    }

    template <class At>
    void measure(double t, CycleMode mode, At& at)
    {
        static const GaussLegendre<5> quadrature;
        quadrature.sample(time_, t, [&](double place, double weight) {
            const SpringModel::Powers powers = model_.powers(at(place), mode);
            result_.energies.air += weight * (powers.frontDashpot + powers.rearDashpot);
            result_.energies.suspension += weight * powers.suspension;
            result_.energies.contact += weight * powers.contact;
            result_.energies.friction += weight * powers.friction;
        });
        for (int k = 1; k <= looksPerStep; ++k) {
            const CycleState y = at(std::lerp(time_, t, double(k) / looksPerStep));
            const SpringModel::Guards spacings = model_.guards(y.head<2>());
            result_.separation.add(spacings[SpringModel::Pad]);
            result_.minimumSpacing.add(spacings.minCoeff());
        }
    }

    const BouncingSprings& map_;
    const SpringModel& model_;
    const ReturnRequest& request_;
    Return& result_;
    double time_ = 0.0;
    CycleState y_;
    Eigen::Matrix4d phi_ = Eigen::Matrix4d::Identity();
};

/// Tells a watch what the integrator tells a recorder.
class WatchedRun {
public:
    WatchedRun(const BouncingSprings& slider, const SpringModel::State& start, BouncingWatch& watch)
        : slider_(slider), last_(start), watch_(watch)
    {}

    template <class At>
    bool step(double t, const SpringModel::State& y, SpringModel::Mode, At&& at)
    {
        const SpringModel& model = slider_.model();
        const bool goesOn =
            watch_.step(t, [&](double time) { return model.guards(at(time).template head<2>()).minCoeff(); });
        last_ = y;
        return goesOn;
    }
    void event(double time, int guard, bool, SpringModel::Mode before, SpringModel::Mode after)
    {
        const CycleSwitch of{guard, before, after};
        const Eigen::VectorXd x = slider_.coordinates(last_);
        watch_.event(time, of, of.crosses() ? &x : nullptr);
    }

private:
    const BouncingSprings& slider_;
    SpringModel::State last_;
    BouncingWatch& watch_;
};

} // namespace

Case caseOfStart(const Case& c, int k)
{
    if (k == 0) return c;
    Case lower = c;
    const double takeOff = characteristic(c).value().takeOff;
    const double height = std::max(c.initial.flyingHeight, 2.0 * takeOff);
    lower.initial.flyingHeight = takeOff + (height - takeOff) * std::pow(10.0, -k);
    lower.initial.pitch = c.springs.pitch;
    lower.initial.verticalVelocity = lower.initial.pitchVelocity = 0.0;
    lower.initial.branch = ContactBranch::TouchDown;
    return checkCombinations(lower).empty() ? lower : c;
}

Vector3 sectionUnits(const Case& c) { return SpringModel(c).scale().tail<3>(); }

BouncingSprings::BouncingSprings(const Case& c, const Vector3& units)
    : model_(c),
      units_(units),
      startHeight_(c.initial.flyingHeight),
      cycleWork_(touchdown::cycleWork(c).value()),
      touchDown_(characteristic(c).value().touchDown),
      padDistance_(c.springs.padDistance),
      frontCutoff_(model_.interval(SpringModel::Front, {}).lower),
      rearCutoff_(model_.interval(SpringModel::Rear, {}).lower)
{}

Vector3 BouncingSprings::coordinates(const CycleState& y) const
{
    return Vector3(y[1], y[2] - padDistance_ * y[3], y[3]).cwiseQuotient(units_);
}

SpringModel::State BouncingSprings::state(const Vector3& x) const
{
    const Vector3 si = x.cwiseProduct(units_);
    return {touchDown_ + padDistance_ * si[0], si[0], si[1] + padDistance_ * si[2], si[2]};
}

SpringModel::Mode BouncingSprings::modeAt(const CycleState& y) const
{
    const SpringModel::Guards spacings = model_.guards(y.head<2>());
    return {spacings[SpringModel::Front] > frontCutoff_, spacings[SpringModel::Rear] > rearCutoff_,
            ContactRegion::Pressed};
}

Return BouncingSprings::apply(const Eigen::VectorXd& x, const ReturnRequest& request) const
{
    Return result;
    if (!x.allFinite() || !(x[1] < 0.0)) return result; // the section is crossed downwards
    const Start<SpringModel> begin = start(x);
    ReturnRecorder recorder(*this, request, begin.y, result);
    const AdaptiveOptions options{.tolerance = request.tolerance, .firstStep = 1e-3 * model_.shortestPeriod()};
    integrateAdaptive(model_, begin, request.limit, options, recorder);
    if (!result.returned) return result;
    result.x = result.passed.back();
    if (request.derivative) {
        result.derivative.resize(3, 3);
        Eigen::Matrix<double, 4, 3> embed;
        for (int k = 0; k < 3; ++k) embed.col(k) = state(Vector3::Unit(k)) - state(Vector3::Zero());
        const Eigen::Matrix<double, 4, 3> reached = recorder.fundamental() * embed;
        for (int k = 0; k < 3; ++k) result.derivative.col(k) = coordinates(reached.col(k));
    }
    return result;
}

LongMotion BouncingSprings::run(const std::optional<Eigen::VectorXd>& from, double duration, double tolerance,
                                BouncingWatch& watch) const
{
    const Start<SpringModel> begin =
        from ? start(*from) : Start<SpringModel>{model_.initialState(), model_.initialMode()};
    watch.begin(model_.guards(begin.y.head<2>()).minCoeff(), begin.mode.contact);
    WatchedRun recorder(*this, begin.y, watch);
    const AdaptiveOptions options{.tolerance = tolerance, .firstStep = 1e-3 * model_.shortestPeriod()};
    const IntegrationResult result = integrateAdaptive(model_, begin, duration, options, recorder);
    if (result.end == IntegrationEnd::Reached) return {};
    return {.problem = result.end == IntegrationEnd::Stopped ? "stopped"
                                                             : "the run ends at " + fewDigitsOfTime(result.time, 3)};
}

} // namespace touchdown

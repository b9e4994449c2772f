// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/equilibria/parametric_balance.h"

#include <algorithm>
#include <cmath>

#include "core/case/contact_law.h"
#include "core/simulation/equilibria/film_equilibria.h"
#include "core/simulation/small_motions/small_motions.h"
#include "core/simulation/static_state/film_setup.h"

namespace touchdown {

namespace {

using Vector = Eigen::VectorXd;

constexpr double parameterDifference = 1e-3; // of p, for dG/dp, in shares of its range
constexpr double unmoved = 1e-9;             // of x, for which the film is not solved again [-]
constexpr double far = 1e6;                  // an end that a law's interval does not have [-]
constexpr double shortest = 1e-9;            // unit of x [m]
constexpr double turning = 5.0;              // by which the leading edge moves more than the trailing one [-]

} // namespace

std::vector<ParametricBalance::Look> ParametricBalance::look(int looks, std::vector<std::string>& problems)
{
    std::vector<Look> found;
    double best = std::numeric_limits<double>::infinity();
    for (int k = 0; k < looks && goOn_(); ++k) {
        const double p = double(k) / (looks - 1);
        const std::optional<Case> c = caseAt_(parameter(p));
        const std::optional<OnoYamane> law = c ? characteristic(*c) : std::nullopt;
        if (!law) continue;
        SteadyResult rest = staticStateOf(*c, goOn_);
        if (rest.status == SteadyStatus::Cancelled) break;
        const bool converged = rest.status == SteadyStatus::Converged;
        if (!rest.balanced()) {
            if (std::ranges::find(problems, rest.message) == problems.end()) problems.push_back(rest.message);
            continue;
        }
        found.push_back({p, rest.attitude, converged && rest.minimumSpacing > law->touchDown});
        rests_.emplace_back(p, rest.attitude);
        const double distance = std::abs(p - 0.5) + (converged ? 0.0 : 1.0);
        if (distance >= best) continue;
        best = distance;
        length_ = std::max({rest.minimumSpacing, law->takeOff, shortest});
        slider_ = c->slider;
        preload_ = c->suspension.preload;
        grid_ = std::move(rest.grid);
        startPressure_ = std::move(rest.pressure);
        startAmbient_ = airOf(c->air).pressure;
    }
    return found;
}

Attitude ParametricBalance::restAt(double p) const
{
    const auto above = std::ranges::lower_bound(rests_, p, {}, &std::pair<double, Attitude>::first);
    if (above == rests_.begin()) return above->second;
    const auto& [lower, a] = *(above - 1);
    if (above == rests_.end()) return a;
    const Attitude& b = above->second;
    const double share = (p - lower) / (above->first - lower);
    return {std::lerp(a.height, b.height, share), std::lerp(a.pitch, b.pitch, share), std::lerp(a.roll, b.roll, share)};
}

void ParametricBalance::leave()
{
    last_.reset();
    known_.reset();
    near_.clear();
}

Vector ParametricBalance::toScaled(const Vector3& q, Eigen::Index n) const
{
    const double ends[] = {q[0] - 0.5 * slider_.length * q[1], slider_.length * q[1] / turning,
                           slider_.width * q[2] / turning};
    Vector x(n);
    for (Eigen::Index i = 0; i < n; ++i) x[i] = ends[i] / length_;
    return x;
}

/// A roll that is no unknown is held where it is.
Vector3 ParametricBalance::toPlace(const Vector& x) const
{
    const double pitch = length_ * turning * x[1] / slider_.length;
    return {length_ * x[0] + 0.5 * slider_.length * pitch, pitch,
            x.size() > 2 ? length_ * turning * x[2] / slider_.width : last_->body().rest()[2]};
}

Matrix3 ParametricBalance::placeSlope() const
{
    Matrix3 slope = Matrix3::Zero();
    slope(0, 0) = length_;
    slope(0, 1) = 0.5 * length_ * turning;
    slope(1, 1) = length_ * turning / slider_.length;
    slope(2, 2) = length_ * turning / slider_.width;
    return slope;
}

Vector ParametricBalance::scaledForce(const Vector3& g, Eigen::Index n) const
{
    return Vector3(g[0], g[1] / slider_.length, g[2] / slider_.width).head(n) / preload_;
}

bool ParametricBalance::takeSlider(const Case& c)
{
    const SliderCase& slider = c.slider;
    if (gaps_ && gaps_->length == slider.length && gaps_->width == slider.width && surface_ == c.surface) return true;
    const Recess recess(c.surface, slider.length, slider.width);
    gaps_ = std::make_shared<const FilmGaps>(recess, grid_, goOn_);
    if (!goOn_()) gaps_ = nullptr;
    spacing_.emplace(c.surface, recess);
    surface_ = c.surface;
    return gaps_ != nullptr;
}

std::unique_ptr<FilmBalance> ParametricBalance::balanceAt(double p)
{
    const std::optional<Case> c = caseAt_(parameter(p));
    if (!c) return nullptr;
    if (!takeSlider(*c)) return nullptr;
    auto balance = std::make_unique<FilmBalance>(*c, *spacing_, gaps_, restAt(p));
    if (last_) {
        balance->startFrom(*last_);
        return balance;
    }
    std::vector<double> pressure = startPressure_;
    for (double& each : pressure) each *= balance->level().film.ambient() / startAmbient_;
    balance->level().gaps.pad.pad<double>(pressure, balance->level().pressure);
    return balance;
}

/// The last balance becomes that at (x, p), its film steady there.
bool ParametricBalance::moveTo(const Vector& x, double p)
{
    if (last_ && p == lastP_ && (x - lastX_).norm() < unmoved) return true;
    if (!last_ || p != lastP_) {
        std::unique_ptr<FilmBalance> there = balanceAt(p);
        if (!there) return false;
        last_ = std::move(there);
    }
    const std::vector<double> before = last_->level().pressure;
    lastX_ = x;
    lastP_ = p;
    if (last_->solve(toPlace(x), goOn_)) return true;
    last_->level().pressure = before;
    lastP_ = std::numeric_limits<double>::quiet_NaN();
    return false;
}

bool ParametricBalance::linearise(const Vector& x, double p, ContactRegion region, ContinuationProblem::Linearised& at)
{
    if (known_ && known_->region == region && known_->p == p && (x - known_->x).norm() < unmoved) {
        at = known_->at;
        return true;
    }
    const double inside = std::clamp(p, 0.0, 1.0);
    if (!moveTo(x, inside)) return false;
    const Eigen::Index n = x.size();
    const Vector here = scaledForce(last_->force(region), n);
    const Matrix3 stiffness = last_->stiffness(region, goOn_) * placeSlope();
    const Vector3 perForce = Vector3(1.0, 1.0 / slider_.length, 1.0 / slider_.width) / preload_;
    at.byState = -(perForce.asDiagonal() * stiffness).topLeftCorner(n, n);
    const double aside = inside + (inside < 0.5 ? parameterDifference : -parameterDifference);
    const std::unique_ptr<FilmBalance> there = balanceAt(aside);
    if (!there || !there->solve(toPlace(x), goOn_)) return false;
    at.byParameter = (scaledForce(there->force(region), n) - here) / (aside - inside);
    at.residual = here + at.byParameter * (p - inside);
    if (!at.residual.allFinite() || !at.byState.allFinite() || !at.byParameter.allFinite() || !goOn_()) return false;
    known_ = {region, x, p, at};
    return true;
}

std::vector<double> ParametricBalance::distances(const Vector& x, double p, ContactRegion region)
{
    if (!moveTo(x, std::clamp(p, 0.0, 1.0))) return {-1.0, -1.0, -1.0};
    const double spacing = last_->spacing(toPlace(x));
    const Interval holds = last_->interval(region);
    return {std::isfinite(holds.lower) ? (spacing - holds.lower) / length_ : far,
            std::isfinite(holds.upper) ? (holds.upper - spacing) / length_ : far, spacing / length_};
}

Equilibrium ParametricBalance::describe(const Vector& x, double p, ContactRegion region)
{
    std::vector<double> key(x.begin(), x.end());
    key.push_back(p);
    key.push_back(static_cast<double>(region));
    if (const auto found = described_.find(key); found != described_.end()) return found->second;
    if (!moveTo(x, std::clamp(p, 0.0, 1.0))) return {.parameter = parameter(p)};
    Equilibrium point = describeEquilibrium(*last_, region, near_, goOn_);
    point.parameter = parameter(p);
    followRatesOf(point);
    described_.emplace(std::move(key), point);
    const double resolved = resolvedFrequency(last_->setup(), grid_);
    if (!(resolved_ > 0.0) || resolved < resolved_) resolved_ = resolved;
    return point;
}

std::optional<ParametricBalance::Crossing> ParametricBalance::cross(const Vector& x, double p, ContactRegion region,
                                                                    bool upper)
{
    if (!moveTo(x, std::clamp(p, 0.0, 1.0))) return {};
    return Crossing{last_->beyond(region, upper), last_->place()};
}

} // namespace touchdown

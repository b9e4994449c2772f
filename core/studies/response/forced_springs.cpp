// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/response/forced_springs.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/numerics/adaptive.h"
#include "core/numerics/gauss_legendre.h"
#include "core/physics/disk/disk_velocity.h"
#include "core/simulation/equilibria/spring_equilibria.h"
#include "core/simulation/recording/quantity.h"
#include "core/simulation/springs/springs_over_disk.h"

namespace touchdown {

namespace {

using Complex = std::complex<double>;

constexpr double waveShare = 1e-10; // of the wave's amplitude: local error of a step [-]
constexpr double roundOff = 4.0 * std::numeric_limits<double>::epsilon(); // of a step, in its height [-]
constexpr double smallMotion = 1e-4;                // of the wave, for derivatives of a quantity [-]
constexpr double firstStepShare = 1.0 / 64.0;       // of a period [-]
constexpr double fullTurn = 2.0 * std::numbers::pi; // [rad]
constexpr int mostEquilibriumSteps = 30;            // of Newton
constexpr double equilibriumFound = 1e-12;          // last change, in units of SpringModel::scale [-]

bool touchesDisk(SpringModel::Mode mode)
{
    return mode.contact == ContactRegion::Pressed || mode.contact == ContactRegion::Lifting;
}

std::string problemOf(const IntegrationResult& result)
{
    switch (result.end) {
    case IntegrationEnd::Reached:
    case IntegrationEnd::Stopped: return {};
    case IntegrationEnd::Chattering:
        return "the contact switches more than 64 times within one period of the fastest motion (d_e close to d_s)";
    case IntegrationEnd::Tunnelled: return "a step crossed the cutoff d_1 of an air spring with energy that it made";
    case IntegrationEnd::StepUnderflow: return "the step size fell below round-off";
    case IntegrationEnd::NewtonFailed:
    case IntegrationEnd::Diverged: break;
    }
    return "the motion diverged";
}

/// Takes the steps of one period after the other.
class ForcedRecorder {
public:
    /// All must last; `begin` is the time of the case at which the periods begin [s].
    ForcedRecorder(const SpringModel& model, const DiskUnderSprings& disk, const ForcedRequest& request, double begin,
                   double period, ForcedPeriods& result)
        : model_(model), disk_(disk), request_(request), result_(result), begin_(begin), omega_(fullTurn / period)
    {}

    std::size_t quantity = 0, minimumSpacing = 0;
    std::vector<double> values;
    bool frontLost = true, rearLost = true; // that spring carried at no time

    void start(const SpringsOverDisk::State& y)
    {
        time_ = 0.0;
        y_ = y;
    }

    template <class At>
    bool step(double t, const SpringsOverDisk::State& y, SpringModel::Mode mode, At&& at)
    {
        if (request_.derivative) propagate(t, y, mode, at);
        if (request_.measurements) measure(t, mode, at);
        time_ = t;
        y_ = y;
        mode_ = mode;
        lowest_ = lowest_.cwiseMin(y.head<2>());
        highest_ = highest_.cwiseMax(y.head<2>());
        return true;
    }

    void event(double, int guard, bool, SpringModel::Mode before, SpringModel::Mode after)
    {
        if (guard == SpringModel::Pad && before.contact == ContactRegion::Apart) ++result_.touchDowns;
        mode_ = after;
        if (!request_.derivative) return;
        const SpringModel::Under under = disk_.at(y_[2]);
        const SpringModel::State motion = SpringsOverDisk::motionOf(y_);
        const SpringModel::State from = model_.derivative(motion, before, under);
        const SpringModel::State jump = model_.derivative(motion, after, under) - from;
        Eigen::RowVector4d normal = Eigen::RowVector4d::Zero();
        for (int k = 0; k < 2; ++k) normal[k] = model_.ratesOf(Eigen::Vector2d::Unit(k))[guard];
        const double speed = model_.ratesOf(motion.tail<2>())[guard] - under.rate[guard];
        if (speed != 0.0) phi_ += jump * ((normal * phi_) / speed);
    }

    SpringModel::Mode mode() const { return mode_; }
    const SpringsOverDisk::State& last() const { return y_; }
    const Eigen::Matrix4d& fundamental() const { return phi_; }
    Eigen::Vector2d swing() const { return 0.5 * (highest_ - lowest_); }
    Complex integral() const { return sum_; }
    double contactTime() const { return contactTime_; }

private:
    Eigen::Matrix4d slopeOf(const SpringsOverDisk::State& y, SpringModel::Mode mode) const
    {
        const SpringModel::Guards at = model_.guards(y.head<2>(), disk_.at(y[2]).height);
        Eigen::Matrix4d a = Eigen::Matrix4d::Zero();
        a(0, 2) = a(1, 3) = 1.0;
        a.bottomRows<2>() = model_.jacobianAt(at, mode);
        return a;
    }

    /// Phi' = A Phi over a step, by Kutta's method of fourth order.
    template <class At>
    void propagate(double t, const SpringsOverDisk::State& y, SpringModel::Mode mode, At& at)
    {
        const double h = t - time_;
        const Eigen::Matrix4d a0 = slopeOf(y_, mode), a1 = slopeOf(at(time_ + 0.5 * h), mode), a2 = slopeOf(y, mode);
        const Eigen::Matrix4d k1 = a0 * phi_, k2 = a1 * (phi_ + 0.5 * h * k1), k3 = a1 * (phi_ + 0.5 * h * k2),
                              k4 = a2 * (phi_ + h * k3);
        phi_ += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    }

    template <class At>
    void measure(double t, SpringModel::Mode mode, At& at)
    {
        static const GaussLegendre<5> quadrature;
        const auto look = [&](const SpringsOverDisk::State& y) {
            model_.observe(SpringsOverDisk::motionOf(y), mode, disk_.at(y[2]), values.data());
            result_.least = std::min(result_.least, values[quantity]);
            result_.most = std::max(result_.most, values[quantity]);
            result_.leastSpacing = std::min(result_.leastSpacing, values[minimumSpacing]);
        };
        look(y_);
        quadrature.sample(time_, t, [&](double place, double weight) {
            const SpringsOverDisk::State y = at(place);
            look(y);
            sum_ += weight * values[quantity] * std::polar(1.0, -omega_ * (y[2] - begin_));
        });
        if (touchesDisk(mode)) contactTime_ += t - time_;
        frontLost = frontLost && !mode.frontSpring;
        rearLost = rearLost && !mode.rearSpring;
    }

    const SpringModel& model_;
    const DiskUnderSprings& disk_;
    const ForcedRequest& request_;
    ForcedPeriods& result_;
    double begin_, omega_; // [s], [rad/s]
    double time_ = 0.0;    // since the beginning of the period [s]
    SpringsOverDisk::State y_ = SpringsOverDisk::State::Zero();
    SpringModel::Mode mode_;
    Eigen::Matrix4d phi_ = Eigen::Matrix4d::Identity();
    Eigen::Vector2d lowest_ = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity()), highest_ = -lowest_;
    Complex sum_ = 0.0;        // int q exp(-i w t) dt
    double contactTime_ = 0.0; // [s]
};

/// The equilibrium above a flat disk that Newton's method reaches from the static state, in the mode of its spacings.
std::optional<ForcedState> equilibriumOf(const SpringModel& model)
{
    const SpringModel::Guards flat = SpringModel::Guards::Zero();
    ForcedState at{model.staticState(), {}};
    at.mode = model.naiveMode(at.y, {}, flat);
    for (int k = 0; k < mostEquilibriumSteps; ++k) {
        const Eigen::Vector2d push = model.derivative(at.y, at.mode).tail<2>();
        const Eigen::Matrix2d slope = model.jacobian(at.y, at.mode).leftCols<2>();
        const double determinant = slope(0, 0) * slope(1, 1) - slope(0, 1) * slope(1, 0);
        if (push.isZero(0.0)) return at;
        const Eigen::Vector2d change(slope(1, 1) * push[0] - slope(0, 1) * push[1],
                                     slope(0, 0) * push[1] - slope(1, 0) * push[0]);
        at.y.head<2>() -= change / determinant;
        if (!at.y.allFinite()) return {};
        const SpringModel::Mode mode = model.naiveMode(at.y, at.mode, flat);
        const bool same = mode == at.mode;
        at.mode = mode;
        const Eigen::Vector2d units = model.scale().head<2>();
        if (same && (change / determinant).cwiseQuotient(units).norm() <= equilibriumFound) return at;
    }
    return {};
}

} // namespace

ForcedSprings::ForcedSprings(const Case& c, const std::string& quantity)
    : disk_(c), model_(c), hasFront_(c.springs.frontStiffness > 0.0), hasRear_(c.springs.rearStiffness > 0.0)
{
    const std::vector<Quantity> all = SpringModel::quantities(c);
    quantities_ = all.size();
    quantity_ = static_cast<std::size_t>(findQuantity(all, quantity));
    minimumSpacing_ = static_cast<std::size_t>(findQuantity(all, "minimum_spacing"));
    const DiskSurface& surface = c.diskSurface;
    waveAmplitude_ = std::abs(surface.waveAmplitudes.front());
    period_ = surface.waveLengths.front() / std::abs(speedAlong(c));
    const double first = disk_.at(0.0).height[SpringModel::Pad], quarter = disk_.at(0.25 * period_).height[0];
    // w = Re W exp(i w t) with W = first - i quarter; at t = begin_ it is Re(-i a exp(i w (t - begin_))).
    const double turn = (-0.25 * fullTurn - std::arg(Complex(first, -quarter))) / fullTurn;
    begin_ = (turn - std::floor(turn)) * period_;
    tolerance_ = std::min(c.run.tolerance, waveShare * waveAmplitude_ / model_.scale()[0]);
}

double ForcedSprings::roundOffOfHeight(const SpringModel& model) { return roundOff * std::abs(model.staticState()[0]); }

/// The size of the motion [m], [rad], [m/s], [rad/s].
Eigen::VectorXd ForcedSprings::units(const Eigen::VectorXd& swing) const
{
    const SpringModel::State scale = model_.scale();
    const double arm = scale[0] / scale[1]; // [m]
    const double size = std::max({swing[0], arm * swing[1], leastSize * waveAmplitude_});
    const double rate = std::max(fullTurn * frequency(), scale[2] / scale[0]);
    return SpringModel::State(size, size / arm, size * rate, size / arm * rate);
}

ForcedState ForcedSprings::moved(const Eigen::VectorXd& direction, double size) const
{
    ForcedState at{model_.staticState(), {}};
    at.y += size / model_.scale()[0] * model_.scale().cwiseProduct(SpringModel::State(direction));
    return continued(at);
}

ForcedState ForcedSprings::lowered(double distance) const
{
    ForcedState at{model_.staticState(), {}};
    at.y[0] -= distance;
    return continued(at);
}

ForcedState ForcedSprings::start() const { return {model_.initialState(), model_.initialMode(underAt(0.0).height)}; }

ForcedState ForcedSprings::continued(const ForcedState& before) const
{
    return {before.y, model_.naiveMode(before.y, before.mode, underAt(0.0).height)};
}

ForcedPeriods ForcedSprings::run(const ForcedState& start, const ForcedRequest& request) const
{
    ForcedPeriods result;
    ForcedRecorder recorder(model_, disk_, request, begin_, period_, result);
    recorder.quantity = quantity_;
    recorder.minimumSpacing = minimumSpacing_;
    recorder.values.resize(quantities_);
    const SpringsOverDisk system(model_, disk_, period_);
    const AdaptiveOptions options{.tolerance = toleranceOf(request.rough), .firstStep = firstStepShare * period_};
    result.end = start;
    for (int k = 0; k < request.periods; ++k) {
        Start<SpringsOverDisk> from{SpringsOverDisk::State::Zero(), result.end.mode};
        from.y << result.end.y[0], result.end.y[1], begin_, result.end.y[2], result.end.y[3], 1.0;
        recorder.start(from.y);
        result.problem = problemOf(integrateAdaptive(system, from, period_, options, recorder));
        result.end = {SpringsOverDisk::motionOf(recorder.last()), recorder.mode()};
        if (result.problem.empty() && !result.end.y.allFinite()) result.problem = "the motion diverged";
        if (!result.problem.empty()) return result;
    }
    result.swing = recorder.swing();
    result.derivative = recorder.fundamental();
    const double time = request.periods * period_;
    result.harmonic = 2.0 / time * recorder.integral();
    result.contactShare = recorder.contactTime() / time;
    const bool frontLost = recorder.frontLost && hasFront_, rearLost = recorder.rearLost && hasRear_;
    if (request.measurements && (frontLost || rearLost))
        result.problem = std::string(frontLost ? "the front" : "the rear") +
                         " air spring is lost: its spacing stays below springs.cutoff";
    return result;
}

std::optional<Complex> ForcedSprings::linear() const
{
    const std::optional<ForcedState> found = equilibriumOf(model_);
    if (!found) return {};
    const SpringModel::State& y = found->y;
    const SpringModel::Mode mode = found->mode;
    if (stabilityOf(eigenvaluesAt(model_, y.head<2>(), mode)) != Stability::Stable) return {};
    const double omega = fullTurn / period_;
    const Complex i(0.0, 1.0);
    const SpringModel::Under now = underAt(0.0), later = underAt(0.25 * period_);
    const Eigen::Vector3cd wave = now.height.cast<Complex>() - i * later.height.cast<Complex>();

    // q'' = K q + D q' + sum_i (i w c_i - k_i) W_i, where K q has k_i times the spacing of the place i.
    const Eigen::Matrix<double, 2, 4> whole = model_.jacobian(y, mode);
    Eigen::Vector2cd force = Eigen::Vector2cd::Zero();
    for (int place = 0; place < SpringModel::guardCount; ++place) {
        SpringModel::Mode without = mode;
        if (place == SpringModel::Pad) without.contact = ContactRegion::Apart;
        if (place == SpringModel::Front) without.frontSpring = false;
        if (place == SpringModel::Rear) without.rearSpring = false;
        const Eigen::Vector2d stiffness = whole.col(0) - model_.jacobian(y, without).col(0);
        SpringModel::Under rising;
        rising.rate[place] = 1.0;
        const Eigen::Vector2d dashpot = (model_.derivative(y, mode, rising) - model_.derivative(y, mode)).tail<2>();
        force += (i * omega * dashpot - stiffness) * wave[place];
    }
    Eigen::Matrix2cd dynamic = -(whole.leftCols<2>() + i * omega * whole.rightCols<2>());
    dynamic.diagonal().array() -= omega * omega;
    const Complex determinant = dynamic(0, 0) * dynamic(1, 1) - dynamic(0, 1) * dynamic(1, 0);
    const Eigen::Vector2cd q((dynamic(1, 1) * force[0] - dynamic(0, 1) * force[1]) / determinant,
                             (dynamic(0, 0) * force[1] - dynamic(1, 0) * force[0]) / determinant);

    std::vector<double> values(quantities_);
    const auto valueAt = [&](Complex share) { // at the real part of that share of the motion
        SpringModel::State moved = y;
        moved.head<2>() += (share * q).real();
        moved.tail<2>() += (share * i * omega * q).real();
        SpringModel::Under under;
        under.height = (share * wave).real();
        under.rate = (share * i * omega * wave).real();
        model_.observe(moved, mode, under, values.data());
        return values[quantity_];
    };
    const Complex part = smallMotion;
    return Complex(valueAt(part) - valueAt(-part), valueAt(-i * part) - valueAt(i * part)) / (2.0 * smallMotion);
}

double speedAlong(const Case& c)
{
    return diskVelocity(c.disk, c.slider.length, c.slider.width, 0.5 * c.slider.length, 0.5 * c.slider.width).x;
}

Case caseOverWave(Case c, double amplitude, double frequency, double wavelength)
{
    const double speed = speedAlong(c);
    if (wavelength > 0.0) c.disk.speed *= frequency * wavelength / std::abs(speed);
    DiskSurface& surface = c.diskSurface;
    surface.kind = DiskSurfaceKind::Waves;
    surface.motion = SurfaceMotion::Moving;
    surface.waveAmplitudes = {amplitude};
    surface.waveLengths = {wavelength > 0.0 ? wavelength : std::abs(speed) / frequency};
    surface.waveAngles = {};
    surface.wavePhases = {};
    return c;
}

} // namespace touchdown

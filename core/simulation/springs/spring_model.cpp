// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/springs/spring_model.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/case/contact_law.h"
#include "core/simulation/contact/contact_lever.h"

namespace touchdown {

namespace {

/// A spring without stiffness never carries, wherever the slider is: it is not there.
AirSpring airSpring(const SpringsCase& springs, double stiffness, double staticSpacing)
{
    const double cutoff = stiffness > 0.0 ? springs.cutoff : std::numeric_limits<double>::infinity();
    return {.stiffness = stiffness, .staticSpacing = staticSpacing, .cutoff = cutoff};
}

double square(double x) { return x * x; }

} // namespace

SpringModel::SpringModel(const Case& c, const Guards& under)
    : case_(c),
      still_{under, Guards::Zero()},
      rows_(&rows(c)),
      pad_(makePadLaw(c)),
      affine_(pad_->affine()),
      friction_(frictionOf(c)),
      frontDistance_(c.springs.frontDistance),
      rearDistance_(c.springs.rearDistance),
      padDistance_(c.springs.padDistance),
      inverseMass_(1.0 / c.slider.mass),
      inverseInertia_(1.0 / c.slider.pitchInertia)
{
    const double mass = c.slider.mass;
    const double inertia = c.slider.pitchInertia;
    const SpringsCase& s = c.springs;
    const SuspensionCase& suspension = c.suspension;

    static_ << s.flyingHeight + padDistance_ * s.pitch, s.pitch, 0.0, 0.0;
    initial_ << c.initial.flyingHeight + padDistance_ * c.initial.pitch, c.initial.pitch, c.initial.verticalVelocity,
        c.initial.pitchVelocity;
    const Guards flying = guards(static_.head<2>(), Guards::Zero()); // above the mean plane
    front_ = airSpring(s, s.frontStiffness, flying[Front]);
    rear_ = airSpring(s, s.rearStiffness, flying[Rear]);

    frontDamping_ = 2.0 * s.frontDampingRatio * std::sqrt(mass * s.frontStiffness);
    rearDamping_ = 2.0 * s.rearDampingRatio * std::sqrt(mass * s.rearStiffness);
    damping_ = 2.0 * suspension.dampingRatio * std::sqrt(mass * suspension.stiffness);
    pitchDamping_ = 2.0 * suspension.pitchDampingRatio * std::sqrt(inertia * suspension.pitchStiffness);

    const double frontStrength = front_.stiffness * square(front_.staticSpacing);
    const double rearStrength = rear_.stiffness * square(rear_.staticSpacing);
    frontVertical_ = frontStrength * inverseMass_;
    rearVertical_ = rearStrength * inverseMass_;
    frontPitch_ = frontDistance_ * frontStrength * inverseInertia_;
    rearPitch_ = -rearDistance_ * rearStrength * inverseInertia_;

    const double coupling = frontDamping_ * frontDistance_ - rearDamping_ * rearDistance_;
    linear_.row(0) << -suspension.stiffness, 0.0, -(damping_ + frontDamping_ + rearDamping_), -coupling;
    linear_.row(1) << 0.0, -suspension.pitchStiffness, -coupling,
        -(pitchDamping_ + frontDamping_ * square(frontDistance_) + rearDamping_ * square(rearDistance_));
    linear_.row(0) *= inverseMass_;
    linear_.row(1) *= inverseInertia_;

    for (const ContactRegion region :
         {ContactRegion::Apart, ContactRegion::Pressed, ContactRegion::Lifting, ContactRegion::Bridged}) {
        ContactRow& row = contactRows_[static_cast<std::size_t>(region)];
        row.lower = pad_->interval(region).lower;
        row.upper = pad_->interval(region).upper;
        if (!affine_) continue;
        const PadForces line = pad_->at(region, 0.0);
        row.z0 = line.net() * inverseMass_;
        row.z1 = line.slope() * inverseMass_;
        row.theta0 = -turning(line.net(), line.contact) * inverseInertia_;
        row.theta1 = -turning(line.slope(), line.contactSlope) * inverseInertia_;
    }

    const double contactStiffness = pad_->stiffness();
    const double bearing = s.frontStiffness + s.rearStiffness + suspension.stiffness;
    const double pitching =
        s.frontStiffness * square(frontDistance_) + s.rearStiffness * square(rearDistance_) + suspension.pitchStiffness;
    const double omega = std::sqrt(std::max(bearing / mass, pitching / inertia)); // [rad/s]
    const double fastest = std::sqrt(
        std::max((bearing + contactStiffness) / mass, (pitching + contactStiffness * square(padDistance_)) / inertia));
    period_ = fastest > 0.0 ? 2.0 * std::numbers::pi / fastest : c.run.duration;

    const double spacing =
        std::max({std::abs(s.flyingHeight), 1e-3 * std::abs(c.initial.flyingHeight - s.flyingHeight), 1e-10}); // [m]
    const double arm = std::max({frontDistance_, rearDistance_, std::abs(padDistance_), 1e-6});                // [m]
    const double rate = omega > 0.0 ? omega : 1.0 / period_;                                                   // [1/s]
    scale_ << spacing, spacing / arm, spacing * rate, spacing / arm * rate;

    const double stored = frontStrength + rearStrength + suspension.stiffness * square(static_[0]) +
                          suspension.pitchStiffness * square(static_[1]) + contactEnergyBound();
    energyBound_ = 1e4 * (energy(initial_) + stored);
}

SpringModel::Mode SpringModel::initialMode(const Guards& under) const
{
    return lawOn(case_.initial.branch, guards(initial_.head<2>(), under));
}

SpringModel::Mode SpringModel::naiveMode(const State& y, Mode mode, const Guards& under) const
{
    const Guards at = guards(y.head<2>(), under);
    return holds(mode, at) ? mode : lawOn(pad_->nextBranch(branchOf(mode), at[Pad]), at);
}

Eigen::RowVector2d SpringModel::guardSizes(int guard) const
{
    const double arm = guard == Pad ? padDistance_ : guard == Front ? frontDistance_ : rearDistance_;
    return {1.0, std::abs(arm)};
}

Interval SpringModel::interval(int guard, Mode mode) const
{
    if (guard == Pad) return pad_->interval(mode.contact);
    const AirSpring& spring = guard == Front ? front_ : rear_;
    const bool carries = guard == Front ? mode.frontSpring : mode.rearSpring;
    return carries ? Interval{.lower = spring.cutoff} : Interval{.upper = spring.cutoff};
}

SpringModel::Mode SpringModel::beyond(Mode mode, int guard, bool upper) const
{
    if (guard == Pad)
        mode.contact = pad_->beyond(mode.contact, upper);
    else
        (guard == Front ? mode.frontSpring : mode.rearSpring) = upper;
    return mode;
}

double SpringModel::period(const Eigen::Matrix<double, 2, 4>& jacobian) const
{
    // The larger of the eigenvalues of a 2 x 2 matrix is at most (|trace| + sqrt|trace^2 - 4 determinant|)/2.
    const Eigen::Matrix2d stiffness = jacobian.leftCols<2>(); // [1/s^2] on the diagonal
    const double trace = std::abs(stiffness.trace());
    const double largest = 0.5 * (trace + std::sqrt(std::abs(square(trace) - 4.0 * stiffness.determinant())));
    return largest > 0.0 ? std::min(period_, 2.0 * std::numbers::pi / std::sqrt(largest)) : period_;
}

void SpringModel::press(State& rate, ContactRegion region, double d) const
{
    const PadForces forces = pad_->forces(region, d);
    rate[2] += forces.net() * inverseMass_;
    rate[3] -= turning(forces.net(), forces.contact) * inverseInertia_;
}

double SpringModel::contactEnergyBound() const
{
    const double start = std::abs(padForces(initialMode(), guards(initial_.head<2>())[Pad]).energy);
    const PadForces pressed = pad_->at(ContactRegion::Pressed, 0.0);
    const double force = pressed.contact - pressed.adhesion, stiffness = pad_->stiffness();
    // With nothing to push back, the meniscus pulls as long as the run lasts.
    const double deep =
        stiffness > 0.0 ? square(force) / stiffness
                        : square(force * case_.run.duration) * (inverseMass_ + square(padDistance_) * inverseInertia_);
    return start + std::abs(pressed.energy) + deep;
}

double SpringModel::kineticEnergy(const State& y) const
{
    return 0.5 * case_.slider.mass * square(y[2]) + 0.5 * case_.slider.pitchInertia * square(y[3]);
}

double SpringModel::suspensionEnergy(const State& y) const
{
    return 0.5 * case_.suspension.stiffness * square(y[0] - static_[0]) +
           0.5 * case_.suspension.pitchStiffness * square(y[1] - static_[1]);
}

double SpringModel::energy(const State& y, const Guards& under) const
{
    const Guards at = guards(y.head<2>(), under);
    const double air = front_.potential(at[Front]) + rear_.potential(at[Rear]);
    return kineticEnergy(y) + air + suspensionEnergy(y);
}

SpringModel::Powers SpringModel::powers(const State& y, Mode mode, const Under& under) const
{
    const Guards at = guards(y.head<2>(), under.height);
    const Guards rate = ratesOf(y.tail<2>()) - under.rate;
    Powers powers;
    powers.suspension = -(damping_ * square(y[2]) + pitchDamping_ * square(y[3]));
    powers.frontDashpot = -frontDamping_ * square(rate[Front]);
    powers.rearDashpot = -rearDamping_ * square(rate[Rear]);
    const double front = (mode.frontSpring ? front_.force(at[Front]) : 0.0) - frontDamping_ * rate[Front];
    const double rear = (mode.rearSpring ? rear_.force(at[Rear]) : 0.0) - rearDamping_ * rate[Rear];
    powers.disk = front * under.rate[Front] + rear * under.rate[Rear];
    const PadForces pad = padForces(mode, at[Pad]);
    powers.contact = pad.net() * rate[Pad];
    powers.friction = -friction_.noseDown() * pad.contact * y[3];
    powers.disk += pad.net() * under.rate[Pad];
    return powers;
}

Eigen::Matrix<double, 2, 4> SpringModel::jacobianAt(const Guards& at, Mode mode) const
{
    Eigen::Matrix<double, 2, 4> j = linear_;
    const double front = mode.frontSpring ? front_.tangent(at[Front]) : 0.0;
    const double rear = mode.rearSpring ? rear_.tangent(at[Rear]) : 0.0;
    ContactRow contact = contactRows_[static_cast<std::size_t>(mode.contact)];
    if (!affine_) {
        const PadForces pad = padForces(mode, at[Pad]);
        contact.z1 = pad.slope() * inverseMass_;
        contact.theta1 = -turning(pad.slope(), pad.contactSlope) * inverseInertia_;
    }
    j(0, 0) += (front + rear) * inverseMass_ + contact.z1;
    j(0, 1) += (front * frontDistance_ - rear * rearDistance_) * inverseMass_ - contact.z1 * padDistance_;
    j(1, 0) += (front * frontDistance_ - rear * rearDistance_) * inverseInertia_ + contact.theta1;
    j(1, 1) += (front * square(frontDistance_) + rear * square(rearDistance_)) * inverseInertia_ -
               contact.theta1 * padDistance_;
    return j;
}

std::string SpringModel::eventName(int guard, Mode before, Mode after) const
{
    if (guard == Front) return after.frontSpring ? "front spring caught" : "front spring lost";
    if (guard == Rear) return after.rearSpring ? "rear spring caught" : "rear spring lost";
    return switchName(before.contact, after.contact);
}

const std::vector<RecordedQuantity<SpringModel::Sample>>& SpringModel::rows(const Case& c)
{
    using S = const Sample&;
    using List = std::vector<RecordedQuantity<Sample>>;
    static const List free{
        {{"flying_height", "m", "nm", "Flying height at the contact pad above the disk"}, [](S s) { return s.d; }},
        {{"minimum_spacing", "m", "nm", "Minimum spacing of pad and pressure centres above the disk"},
         [](S s) {
             return std::min({s.d, s.zf, s.zr});
         }},
        {{"pitch", "rad", "urad", "Pitch"}, [](S s) { return s.y[1]; }},
        {{"height", "m", "nm", "Height of the mass centre"}, [](S s) { return s.y[0]; }},
        {{"front_spacing", "m", "nm", "Spacing at the front pressure centre"}, [](S s) { return s.zf; }},
        {{"rear_spacing", "m", "nm", "Spacing at the rear pressure centre"}, [](S s) { return s.zr; }},
        {{"vertical_velocity", "m/s", "mm/s", "Vertical velocity of the mass centre"}, [](S s) { return s.y[2]; }},
        {{"pitch_velocity", "rad/s", "rad/s", "Pitch velocity"}, [](S s) { return s.y[3]; }},
        {{"air_bearing_force", "N", "mN", "Air bearing force, from that of the static state"},
         [](S s) { return s.airForce; }},
        {{"kinetic_energy", "J", "pJ", "Kinetic energy"}, [](S s) { return s.kinetic; }},
        {{"air_spring_energy", "J", "pJ", "Energy of the air springs"}, [](S s) { return s.air; }},
        {{"suspension_energy", "J", "pJ", "Energy of the suspension"}, [](S s) { return s.suspension; }},
        {{"energy", "J", "pJ", "Total energy without that of the contact"},
         [](S s) { return s.kinetic + s.air + s.suspension; }},
    };
    static const List touching{
        {{"contact_force", "N", "mN", "Real contact force"}, [](S s) { return s.contact; }},
        {{"adhesion_force", "N", "mN", "Adhesion force"}, [](S s) { return s.adhesion; }},
        {{"net_contact_force", "N", "mN", "Net contact force"}, [](S s) { return s.contact + s.adhesion; }},
        {{"friction_force", "N", "mN", "Friction force"}, [](S s) { return s.friction; }},
        {{"friction_power", "W", "uW", "Power of the friction on the slider, by its moment about the mass centre"},
         [](S s) { return s.frictionPower; }},
        {{"contact_energy", "J", "pJ", "Elastic energy of the contact"}, [](S s) { return s.stored; }}};
    static const List uneven{
        {{"minimum_gap", "m", "nm", "Minimum gap above the disk"},
         [](S s) {
             return std::min({s.d, s.zf, s.zr});
         }},
        {{"flying_height_above_disk", "m", "nm", "Flying height above the disk"}, [](S s) { return s.d; }},
        {{"disk_height", "m", "nm", "Height of the disk under the contact pad"}, [](S s) { return s.under[Pad]; }},
        {{"front_disk_height", "m", "nm", "Height of the disk under the front pressure centre"},
         [](S s) { return s.under[Front]; }},
        {{"rear_disk_height", "m", "nm", "Height of the disk under the rear pressure centre"},
         [](S s) { return s.under[Rear]; }},
        {{"disk_power", "W", "uW", "Power of the moving surface of the disk on the slider"},
         [](S s) { return s.diskPower; }}};
    static const List summits{{{"contact_area", "m^2", "um^2", "Real area of contact"}, [](S s) { return s.area; }}};
    // By whether the pad touches, whether its law has an area, whether the disk is uneven.
    static const auto lists = [] {
        std::array<List, 8> all;
        for (std::size_t k = 0; k < all.size(); ++k) {
            all[k] = free;
            const auto add = [&](const List& more) { all[k].insert(all[k].end(), more.begin(), more.end()); };
            if (k & 1) add(touching);
            if (k & 2) add(summits);
            if (k & 4) add(uneven);
        }
        return all;
    }();
    const std::size_t touches = c.contact != noContact, hasArea = contactLaw(c).recordsArea,
                      isUneven = c.diskSurface.kind != DiskSurfaceKind::Flat;
    return lists[touches + 2 * hasArea + 4 * isUneven];
}

void SpringModel::observe(const State& y, Mode mode, const Under& under, double* values) const
{
    const PotentialBelowCutoff potential = case_.springs.potential;
    const Guards at = guards(y.head<2>(), under.height);
    const Guards rate = ratesOf(y.tail<2>()) - under.rate;
    Sample s{.y = y,
             .d = at[Pad],
             .zf = at[Front],
             .zr = at[Rear],
             .airForce = 0.0,
             .kinetic = kineticEnergy(y),
             .air = 0.0,
             .suspension = suspensionEnergy(y)};
    s.airForce = (mode.frontSpring ? front_.force(s.zf) : 0.0) + (mode.rearSpring ? rear_.force(s.zr) : 0.0) -
                 frontDamping_ * rate[Front] - rearDamping_ * rate[Rear];
    s.air = front_.potential(s.zf, potential) + rear_.potential(s.zr, potential);
    const PadForces pad = padForces(mode, s.d);
    s.contact = pad.contact;
    s.adhesion = pad.adhesion;
    s.friction = friction_.coefficient * pad.contact;
    s.frictionPower = 0.0 - friction_.noseDown() * pad.contact * y[3]; // it presses the nose down; 0 without contact
    s.stored = pad.energy;
    s.area = pad.area;
    if (case_.diskSurface.kind != DiskSurfaceKind::Flat) {
        s.under = under.height;
        s.diskPower = powers(y, mode, under).disk;
    }
    evaluate(*rows_, s, values);
}

} // namespace touchdown

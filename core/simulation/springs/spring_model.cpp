// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/springs/spring_model.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/case/contact_kind.h"
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
      contact_(characteristic(c).value_or(OnoYamane{})),
      friction_(frictionOf(c)),
      hasContact_(characteristic(c).has_value()),
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

    if (hasContact_) {
        const double arm = friction_.noseDown();
        for (const ContactRegion region :
             {ContactRegion::Apart, ContactRegion::Pressed, ContactRegion::Lifting, ContactRegion::Bridged}) {
            const AffineForce real = contact_.contactLaw(region);
            const AffineForce adhesion = contact_.adhesionLaw(region);
            ContactRow& row = contactRows_[static_cast<std::size_t>(region)];
            row.lower = contact_.interval(region).lower;
            row.upper = contact_.interval(region).upper;
            row.z0 = (real.constant + adhesion.constant) * inverseMass_;
            row.z1 = (real.slope + adhesion.slope) * inverseMass_;
            row.theta0 = -(padDistance_ * (real.constant + adhesion.constant) + arm * real.constant) * inverseInertia_;
            row.theta1 = -(padDistance_ * (real.slope + adhesion.slope) + arm * real.slope) * inverseInertia_;
        }
    }

    if (c.contact == ContactKind::Asperity) {
        gapLaw_ = std::make_shared<GapLaw>(c.asperity, c.elastic.pair, c.adhesion);
        padArea_ = c.pad.length * c.pad.width;
    }
    const double contactStiffness = hasContact_ ? characteristic(c)->contactStiffness
                                    : gapLaw_   ? std::abs(padForces(c.asperity.planeHeight).contactSlope)
                                                : 0.0;
    const double bearing = s.frontStiffness + s.rearStiffness + suspension.stiffness;
    const double turning =
        s.frontStiffness * square(frontDistance_) + s.rearStiffness * square(rearDistance_) + suspension.pitchStiffness;
    const double omega = std::sqrt(std::max(bearing / mass, turning / inertia)); // [rad/s]
    const double fastest = std::sqrt(
        std::max((bearing + contactStiffness) / mass, (turning + contactStiffness * square(padDistance_)) / inertia));
    period_ = fastest > 0.0 ? 2.0 * std::numbers::pi / fastest : c.run.duration;

    const double spacing =
        std::max({std::abs(s.flyingHeight), 1e-3 * std::abs(c.initial.flyingHeight - s.flyingHeight), 1e-10}); // [m]
    const double arm = std::max({frontDistance_, rearDistance_, std::abs(padDistance_), 1e-6});                // [m]
    const double rate = omega > 0.0 ? omega : 1.0 / period_;                                                   // [1/s]
    scale_ << spacing, spacing / arm, spacing * rate, spacing / arm * rate;

    double stored = frontStrength + rearStrength + suspension.stiffness * square(static_[0]) +
                    suspension.pitchStiffness * square(static_[1]);
    if (hasContact_) stored += contactEnergyBound();
    if (gapLaw_) stored += std::abs(gapEnergy(separation(initial_))) + std::abs(gapEnergy(c.asperity.planeHeight));
    energyBound_ = 1e4 * (energy(initial_) + stored);
}

SpringModel::Mode SpringModel::initialMode(const Guards& under) const
{
    const Guards at = guards(initial_.head<2>(), under);
    Mode mode;
    mode.frontSpring = at[Front] > front_.cutoff;
    mode.rearSpring = at[Rear] > rear_.cutoff;
    if (hasContact_) mode.contact = contact_.region(case_.initial.branch, at[Pad]);
    return mode;
}

SpringModel::Mode SpringModel::lawAt(Mode mode, double d, double zf, double zr) const
{
    return {zf > front_.cutoff, zr > rear_.cutoff,
            hasContact_ ? contact_.region(OnoYamaneLaw::branch(mode.contact), d) : ContactRegion::Apart};
}

SpringModel::Mode SpringModel::naiveMode(const State& y, Mode mode, const Guards& under) const
{
    const Guards at = guards(y.head<2>(), under);
    const double d = at[Pad], zf = at[Front], zr = at[Rear];
    if (holds(mode, d, zf, zr)) return mode;
    Mode next = lawAt(mode, d, zf, zr);
    if (hasContact_) next.contact = contact_.region(contact_.nextBranch(OnoYamaneLaw::branch(mode.contact), d), d);
    return next;
}

Eigen::RowVector2d SpringModel::guardSizes(int guard) const
{
    const double arm = guard == Pad ? padDistance_ : guard == Front ? frontDistance_ : rearDistance_;
    return {1.0, std::abs(arm)};
}

Interval SpringModel::interval(int guard, Mode mode) const
{
    if (guard == Pad) return hasContact_ ? contact_.interval(mode.contact) : Interval{};
    const AirSpring& spring = guard == Front ? front_ : rear_;
    const bool carries = guard == Front ? mode.frontSpring : mode.rearSpring;
    return carries ? Interval{.lower = spring.cutoff} : Interval{.upper = spring.cutoff};
}

SpringModel::Mode SpringModel::beyond(Mode mode, int guard, bool upper) const
{
    if (guard == Pad)
        mode.contact = contact_.beyond(mode.contact, upper);
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

GapForces SpringModel::padForces(double d) const
{
    GapForces forces = gapLaw_->at(d);
    for (double GapForces::*part : {&GapForces::contact, &GapForces::adhesion, &GapForces::contactSlope,
                                    &GapForces::adhesionSlope, &GapForces::area, &GapForces::energy})
        forces.*part *= padArea_;
    return forces;
}

SpringModel::State SpringModel::pressed(const State& rate, double d) const
{
    const GapForces pressures = gapLaw_->pressures(d);
    const double net = padArea_ * pressures.total(), rubbing = friction_.noseDown() * padArea_ * pressures.contact;
    return {rate[0], rate[1], rate[2] + net * inverseMass_, rate[3] - (padDistance_ * net + rubbing) * inverseInertia_};
}

double SpringModel::contactEnergyBound() const
{
    const OnoYamane p = *characteristic(case_);
    const double force = p.initialContactForce + p.meniscusForce;
    const double start = contact_.storedEnergy(initialMode().contact, separation(initial_));
    const double pressed = p.contactStiffness > 0.0 ? square(force) / p.contactStiffness : 0.0;
    // With nothing to push back, the meniscus pulls as long as the run lasts.
    const double fall = p.contactStiffness > 0.0 ? 0.0
                                                 : square(force * case_.run.duration) *
                                                       (inverseMass_ + square(padDistance_) * inverseInertia_);
    return start + pressed + fall + force * (p.takeOff - p.touchDown);
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
    if (hasContact_) {
        const double real = contact_.contactForce(mode.contact, at[Pad]);
        const double net = real + contact_.adhesionForce(mode.contact, at[Pad]);
        powers.contact = net * rate[Pad];
        powers.friction = -friction_.noseDown() * real * y[3];
        powers.disk += net * under.rate[Pad];
    }
    if (gapLaw_) {
        const GapForces forces = padForces(at[Pad]);
        powers.contact = forces.total() * rate[Pad];
        powers.friction = -friction_.noseDown() * forces.contact * y[3];
        powers.disk += forces.total() * under.rate[Pad];
    }
    return powers;
}

Eigen::Matrix<double, 2, 4> SpringModel::jacobianAt(const Guards& at, Mode mode) const
{
    Eigen::Matrix<double, 2, 4> j = linear_;
    const double front = mode.frontSpring ? front_.tangent(at[Front]) : 0.0;
    const double rear = mode.rearSpring ? rear_.tangent(at[Rear]) : 0.0;
    ContactRow contact = contactRows_[static_cast<std::size_t>(mode.contact)];
    if (gapLaw_) {
        const GapForces forces = padForces(at[Pad]);
        const double net = forces.contactSlope + forces.adhesionSlope;
        contact.z1 = net * inverseMass_;
        contact.theta1 = -(padDistance_ * net + friction_.noseDown() * forces.contactSlope) * inverseInertia_;
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
    const auto both = [](List list, const List& more) {
        list.insert(list.end(), more.begin(), more.end());
        return list;
    };
    static const List pressed = both(touching, summits);
    static const std::array<List, 6> lists{free,
                                           both(free, touching),
                                           both(free, pressed),
                                           both(free, uneven),
                                           both(both(free, touching), uneven),
                                           both(both(free, pressed), uneven)};
    const bool surface = c.diskSurface.kind != DiskSurfaceKind::Flat;
    const std::size_t law = c.contact == ContactKind::OnoYamane ? 1 : c.contact == ContactKind::Asperity ? 2 : 0;
    return lists[law + (surface ? 3 : 0)];
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
    if (hasContact_) {
        s.contact = contact_.contactForce(mode.contact, s.d);
        s.adhesion = contact_.adhesionForce(mode.contact, s.d);
        s.friction = friction_.coefficient * s.contact;
        s.frictionPower = 0.0 - friction_.noseDown() * s.contact * y[3]; // it presses the nose down; 0 without contact
        s.stored = contact_.storedEnergy(mode.contact, s.d);
    }
    if (gapLaw_) {
        const GapForces forces = padForces(s.d);
        s.contact = forces.contact;
        s.adhesion = forces.adhesion;
        s.friction = friction_.coefficient * s.contact;
        s.frictionPower = 0.0 - friction_.noseDown() * s.contact * y[3];
        s.stored = forces.energy;
        s.area = forces.area;
    }
    if (case_.diskSurface.kind != DiskSurfaceKind::Flat) {
        s.under = under.height;
        s.diskPower = powers(y, mode, under).disk;
    }
    evaluate(*rows_, s, values);
}

} // namespace touchdown

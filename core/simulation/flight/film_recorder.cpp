// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/flight/film_recorder.h"

#include <cmath>
#include <numeric>
#include <utility>

#include "core/simulation/flight/film_run.h"

namespace touchdown {

namespace {

constexpr double nearest = 0.6; // earlier point, in steps
bool touches(const Case& c) { return c.contact != ContactKind::None; }
bool hasSurfaces(const Case& c) { return c.contact == ContactKind::Elastic; }

} // namespace

std::vector<Quantity> filmQuantities(const Case& c)
{
    std::vector<Quantity> list{
        {"flying_height", "m", "nm",
         c.surface.pointsOfInterest.empty() ? "Flying height of the trailing edge's centre"
                                            : "Flying height at the first point of interest"},
        {"minimum_spacing", "m", "nm", "Minimum spacing of slider and mean disk plane"},
        {"pitch", "rad", "urad", "Pitch"},
        {"roll", "rad", "urad", "Roll"},
        {"height", "m", "nm", "Height of the mass centre"},
        {"vertical_velocity", "m/s", "mm/s", "Vertical velocity of the mass centre"},
        {"pitch_velocity", "rad/s", "rad/s", "Pitch velocity"},
        {"air_bearing_force", "N", "mN", "Air bearing force"},
        {"kinetic_energy", "J", "pJ", "Kinetic energy"},
        {"suspension_energy", "J", "pJ", "Energy of suspension and preload"},
        {"film_energy", "J", "pJ", "Energy stored by the air, from that of the static state"},
        {"energy", "J", "pJ", "Energy of slider, suspension, air and contact"},
        {"energy_gained", "J", "pJ", "What the disk gave to them, less what they dissipated, since the start"},
        {"time_step", "s", "ns", "Time step"},
    };
    if (c.degreesOfFreedom == 3) list.push_back({"roll_velocity", "rad/s", "rad/s", "Roll velocity"});
    if (touches(c))
        list.insert(list.end(), {
                                    {"contact_force", "N", "mN", "Real contact force"},
                                    {"adhesion_force", "N", "mN", "Adhesion force"},
                                    {"net_contact_force", "N", "mN", "Net contact force"},
                                    {"friction_force", "N", "mN", "Friction force"},
                                    {"contact_energy", "J", "pJ", "Elastic energy of the contact"},
                                });
    if (hasSurfaces(c))
        list.insert(list.end(), {
                                    {"contact_area", "m^2", "um^2", "Real area of contact"},
                                    {"peak_contact_pressure", "Pa", "MPa", "Peak contact pressure"},
                                });
    return list;
}

SliderMotion between(const FilmPoint& from, const FilmPoint& to, double share)
{
    const double h = to.time - from.time, s = share, s2 = s * s, s3 = s2 * s;
    SliderMotion at;
    for (std::size_t k = 0; k < 3; ++k) {
        const double v0 = h * from.motion.v[k], a0 = h * h * from.motion.a[k];
        // What is left for the upper three powers.
        const double q = to.motion.q[k] - from.motion.q[k] - v0 - 0.5 * a0;
        const double v = h * to.motion.v[k] - v0 - a0, a = h * h * to.motion.a[k] - a0;
        const double c3 = 10.0 * q - 4.0 * v + 0.5 * a, c4 = -15.0 * q + 7.0 * v - a, c5 = 6.0 * q - 3.0 * v + 0.5 * a;
        at.q[k] = from.motion.q[k] + s * v0 + 0.5 * s2 * a0 + s3 * (c3 + s * (c4 + s * c5));
        at.v[k] = h > 0.0 ? (v0 + s * a0 + s2 * (3.0 * c3 + s * (4.0 * c4 + s * 5.0 * c5))) / h : from.motion.v[k];
    }
    return at;
}

FilmRecorder::FilmRecorder(const Case& c, const SliderBody& body, const Recess& recess, const MinimumSpacing& spacing,
                           const RunCallback& callback)
    : case_(c),
      body_(body),
      spacing_(spacing),
      quantities_(filmQuantities(c)),
      statistics_(c, quantities_),
      updates_(quantities_.size(), c.run.duration, callback),
      values_(quantities_.size())
{
    headAt_ = {c.slider.length, 0.5 * c.slider.width};
    if (!c.surface.pointsOfInterest.empty()) {
        headAt_ = c.surface.pointsOfInterest.front();
        headRecess_ = recess.at(headAt_.x, headAt_.y);
    }
}

void FilmRecorder::begin(const FilmPoint& start)
{
    earlier_ = last_ = start;
    addToEnergy(start);
    record(start, start.time);
}

void FilmRecorder::add(const FilmPoint& point)
{
    const double interval = case_.run.sampleInterval;
    const double end = std::min(point.time, case_.run.duration) + 1e-9 * interval;
    for (double time; (time = static_cast<double>(samples_) * interval) <= end;) record(point, time);
    addToEnergy(point);
    earlier_ = last_;
    last_ = point;
}

void FilmRecorder::record(const FilmPoint& to, double time)
{
    ++samples_;
    evaluate(to, time);
    updates_.addSample(time, values_);
    if (updates_.full()) flush();
}

/// Forces and energies between two points as a parabola through them and an earlier one; straight where there is none,
/// where it was nearer, or where one of them is zero or the parabola changes sign, as where a contact begins or ends.
void FilmRecorder::evaluate(const FilmPoint& to, double time)
{
    const FilmPoint& from = last_;
    const double h = to.time - from.time, h0 = from.time - earlier_.time,
                 share = h > 0.0 ? std::min((time - from.time) / h, 1.0) : 0.0;
    const SliderMotion motion = between(from, to, share);
    const Attitude attitude = body_.attitude(motion.q);
    const auto along = [&](double earlier, double a, double b) {
        const double straight = a + share * (b - a);
        if (!(h > 0.0 && h0 > nearest * h) || earlier == 0.0 || a == 0.0 || b == 0.0) return straight;
        const double bent = straight - share * (1.0 - share) * h * h / (h + h0) * ((b - a) / h - (a - earlier) / h0);
        return bent * straight > 0.0 ? bent : straight;
    };
    const auto ofContact = [&](double SliderContactForces::*part) {
        return along(earlier_.contact.*part, from.contact.*part, to.contact.*part);
    };
    const double kinetic = body_.kineticEnergy(motion.v), suspension = body_.suspensionEnergy(motion.q);
    const double film = along(earlier_.filmEnergy, from.filmEnergy, to.filmEnergy),
                 stored = ofContact(&SliderContactForces::storedEnergy);

    double* out = values_.data();
    *out++ = attitude.height + attitude.pitch * (case_.slider.length - headAt_.x) -
             attitude.roll * (headAt_.y - 0.5 * case_.slider.width) + headRecess_;
    *out++ = spacing_.at(attitude).spacing;
    *out++ = attitude.pitch;
    *out++ = attitude.roll;
    *out++ = motion.q[0];
    *out++ = motion.v[0];
    *out++ = motion.v[1];
    *out++ = along(earlier_.filmForce[0], from.filmForce[0], to.filmForce[0]);
    *out++ = kinetic;
    *out++ = suspension;
    *out++ = film;
    *out++ = kinetic + suspension + film + stored;
    *out++ = along(earlier_.gained, from.gained, to.gained);
    *out++ = to.dt;
    if (case_.degreesOfFreedom == 3) *out++ = motion.v[2];
    if (touches(case_)) {
        *out++ = ofContact(&SliderContactForces::contact);
        *out++ = ofContact(&SliderContactForces::adhesion);
        *out++ = ofContact(&SliderContactForces::contact) + ofContact(&SliderContactForces::adhesion);
        *out++ = ofContact(&SliderContactForces::friction);
        *out++ = stored;
    }
    if (hasSurfaces(case_)) {
        *out++ = ofContact(&SliderContactForces::area);
        *out++ = ofContact(&SliderContactForces::peakPressure);
    }
}

void FilmRecorder::addToEnergy(const FilmPoint& point)
{
    const std::array<double, 4> parts{body_.kineticEnergy(point.motion.v), body_.suspensionEnergy(point.motion.q),
                                      point.filmEnergy, point.contact.storedEnergy};
    const double energy = std::accumulate(parts.begin(), parts.end(), 0.0);
    if (samples_ == 0) {
        firstEnergy_ = energy - point.gained;
        leastParts_ = mostParts_ = parts;
    }
    for (std::size_t k = 0; k < parts.size(); ++k) {
        leastParts_[k] = std::min(leastParts_[k], parts[k]);
        mostParts_[k] = std::max(mostParts_[k], parts[k]);
    }
    mostMissing_ = std::max(mostMissing_, std::abs(energy - firstEnergy_ - point.gained));
}

bool FilmRecorder::lookAtClock()
{
    if (updates_.silent()) flush();
    return !stopped_;
}

void FilmRecorder::flush()
{
    const double begin = wallClock();
    statistics_.add(updates_.samples());
    if (!updates_.send(std::min(last_.time, case_.run.duration), begin)) stopped_ = true;
}

double FilmRecorder::energyImbalance() const
{
    double range = 0.0;
    for (std::size_t k = 0; k < mostParts_.size(); ++k) range = std::max(range, mostParts_[k] - leastParts_[k]);
    return range > 0.0 ? mostMissing_ / range : 0.0;
}

void FilmRecorder::finish(Summary& summary)
{
    if (last_.time < case_.run.duration) evaluate(last_, last_.time);
    summary.endTime = std::min(last_.time, case_.run.duration);
    summary.events = updates_.events();
    if (samples_ > 0)
        for (std::size_t i = 0; i < quantities_.size(); ++i)
            summary.final.emplace_back(quantities_[i].name, values_[i]);
    statistics_.finish(summary);
}

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/flight/film_recorder.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "core/case/case.h"
#include "core/case/contact_law.h"
#include "core/physics/slider/disk_clearance.h"
#include "core/physics/slider/minimum_spacing.h"
#include "core/simulation/flight/film_run.h"

namespace touchdown {

namespace {

constexpr double nearest = 0.6; // earlier point, in steps
constexpr int pointsOfStep = 4;
constexpr int mostLooks = 256; // in a step

} // namespace

std::vector<FilmQuantity> filmRows(const Case& c)
{
    using S = const FilmSample&;
    std::vector<FilmQuantity> list{
        {{"flying_height", "m", "nm",
          c.surface.pointsOfInterest.empty() ? "Flying height of the trailing edge's centre above the mean plane"
                                             : "Flying height at the first point of interest above the mean plane"},
         [](S s) { return s.flyingHeight; }},
        {{"minimum_spacing", "m", "nm", "Minimum spacing above the disk's mean plane"}, [](S s) { return s.spacing; }},
        {{"pitch", "rad", "urad", "Pitch"}, [](S s) { return s.attitude.pitch; }},
        {{"roll", "rad", "urad", "Roll"}, [](S s) { return s.attitude.roll; }},
        {{"height", "m", "nm", "Height of the mass centre"}, [](S s) { return s.motion.q[0]; }},
        {{"vertical_velocity", "m/s", "mm/s", "Vertical velocity of the mass centre"},
         [](S s) { return s.motion.v[0]; }},
        {{"pitch_velocity", "rad/s", "rad/s", "Pitch velocity"}, [](S s) { return s.motion.v[1]; }},
        {{"air_bearing_force", "N", "mN", "Air bearing force"}, [](S s) { return s.airForce; }},
        {{"kinetic_energy", "J", "pJ", "Kinetic energy"}, [](S s) { return s.kinetic; }},
        {{"suspension_energy", "J", "pJ", "Energy of suspension and preload"}, [](S s) { return s.suspension; }},
        {{"film_energy", "J", "pJ", "Energy stored by the air, from that of the static state"},
         [](S s) { return s.film; }},
        {{"energy", "J", "pJ", "Energy of slider, suspension, air and contact"},
         [](S s) { return s.kinetic + s.suspension + s.film + s.stored; }},
        {{"energy_gained", "J", "pJ", "Energy input from the disk less dissipation, since the start"},
         [](S s) { return s.gained; }},
        {{"time_step", "s", "ns", "Time step"}, [](S s) { return s.dt; }},
    };
    if (c.diskSurface.kind != DiskSurfaceKind::Flat)
        list.insert(list.end(), {{{"minimum_gap", "m", "nm", "Minimum gap above the disk"}, [](S s) { return s.gap; }},
                                 {{"flying_height_above_disk", "m", "nm", "Flying height above the disk"},
                                  [](S s) { return s.flyingHeight - s.diskHeight; }},
                                 {{"disk_height", "m", "nm", "Height of the disk under the flying height"},
                                  [](S s) { return s.diskHeight; }}});
    if (c.degreesOfFreedom == 3)
        list.push_back({{"roll_velocity", "rad/s", "rad/s", "Roll velocity"}, [](S s) { return s.motion.v[2]; }});
    if (c.contact != noContact)
        list.insert(
            list.end(),
            {{{"contact_force", "N", "mN", "Real contact force"}, [](S s) { return s.contact; }},
             {{"adhesion_force", "N", "mN", "Adhesion force"}, [](S s) { return s.adhesion; }},
             {{"net_contact_force", "N", "mN", "Net contact force"}, [](S s) { return s.contact + s.adhesion; }},
             {{"friction_force", "N", "mN", "Friction force"}, [](S s) { return s.friction; }},
             {{"contact_energy", "J", "pJ", "Elastic energy of the contact"}, [](S s) { return s.stored; }}});
    if (contactLaw(c).recordsArea)
        list.push_back({{"contact_area", "m^2", "um^2", "Real area of contact"}, [](S s) { return s.area; }});
    if (contactLaw(c).recordsSurfaces)
        list.push_back(
            {{"peak_contact_pressure", "Pa", "MPa", "Peak contact pressure"}, [](S s) { return s.peakPressure; }});
    return list;
}

std::vector<Quantity> furtherPoints(const Case& c)
{
    std::vector<Quantity> list;
    if (c.diskSurface.kind == DiskSurfaceKind::Flat) return list;
    for (std::size_t k = 2; k <= c.surface.pointsOfInterest.size(); ++k) {
        const std::string number = std::to_string(k);
        list.push_back({"flying_height_above_disk_" + number, "m", "nm",
                        "Flying height above the disk at point of interest " + number});
        list.push_back({"disk_height_" + number, "m", "nm", "Height of the disk under point of interest " + number});
    }
    return list;
}

std::vector<Quantity> filmQuantities(const Case& c)
{
    std::vector<Quantity> list = quantitiesOf(filmRows(c));
    std::ranges::move(furtherPoints(c), std::back_inserter(list));
    return list;
}

FilmRecorder::FilmRecorder(const Case& c, const SliderBody& body, const Recess& recess, NearbySpacing& spacing,
                           DiskClearance* clearance, double lookInterval, RunRecorder& run)
    : case_(c),
      body_(body),
      spacing_(spacing),
      clearance_(c.diskSurface.kind != DiskSurfaceKind::Flat ? clearance : nullptr),
      lookInterval_(lookInterval),
      run_(run),
      rows_(filmRows(c)),
      values_(rows_.size() + furtherPoints(c).size())
{
    for (const SurfacePoint& at : c.surface.pointsOfInterest) points_.push_back({at, recess.at(at.x, at.y)});
    if (points_.empty()) points_.push_back({{c.slider.length, 0.5 * c.slider.width}, 0.0});
}

double FilmRecorder::heightOf(const Point& point, const Attitude& attitude) const
{
    return attitude.height + attitude.pitch * (case_.slider.length - point.at.x) -
           attitude.roll * (point.at.y - 0.5 * case_.slider.width) + point.recess;
}

void FilmRecorder::begin(const FilmPoint& start)
{
    earlier_ = last_ = start;
    addToEnergy(start);
    record(start, start.time);
}

void FilmRecorder::add(const FilmPoint& point)
{
    const double interval = case_.run.sampleInterval, slack = 1e-9 * interval;
    const double begin = last_.time, end = std::min(point.time, case_.run.duration);
    const auto spacing = [&](const FilmPoint& of) { return spacing_.at(body_.attitude(of.motion.q)); };
    const bool near = clearance_ && clearance_->mayReach(std::min(spacing(last_), spacing(point)));
    const int parts =
        near ? std::clamp(static_cast<int>(std::min((point.time - begin) / lookInterval_, 1.0 * mostLooks)) + 1,
                          pointsOfStep, mostLooks)
             : pointsOfStep;
    for (int k = 1; k <= parts; ++k) {
        const double until = begin + (point.time - begin) * k / parts;
        for (double time; (time = static_cast<double>(samples_) * interval) <= std::min(until, end) + slack;)
            record(point, time);
        if (until > end) break;
        evaluate(point, until, near || k == parts);
        run_.addPoint(until, values_);
    }
    if (point.time >= case_.run.duration) recordEnd(point);
    addToEnergy(point);
    earlier_ = last_;
    last_ = point;
}

void FilmRecorder::jump(const FilmPoint& point)
{
    earlier_ = last_ = point;
    evaluate(point, point.time);
    run_.addPoint(point.time, values_, false);
}

void FilmRecorder::record(const FilmPoint& to, double time)
{
    ++samples_;
    evaluate(to, time);
    run_.addSample(time, values_);
    if (run_.full()) run_.send(std::min(last_.time, case_.run.duration));
}

void FilmRecorder::recordEnd(const FilmPoint& to)
{
    const double time = std::min(to.time, case_.run.duration);
    evaluate(to, time);
    run_.addLastSample(time, values_);
}

/// Forces and energies between two points as a parabola through them and an earlier one; straight where there is none,
/// where it was nearer, or where one of them is zero or the parabola changes sign, as where a contact begins or ends.
void FilmRecorder::evaluate(const FilmPoint& to, double time, bool seek)
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
    FilmSample s{.attitude = attitude, .motion = motion};
    s.flyingHeight = heightOf(points_.front(), attitude);
    s.spacing = spacing_.at(attitude);
    s.airForce = along(earlier_.filmForce[0], from.filmForce[0], to.filmForce[0]);
    s.kinetic = body_.kineticEnergy(motion.v);
    s.suspension = body_.suspensionEnergy(motion.q);
    s.film = along(earlier_.filmEnergy, from.filmEnergy, to.filmEnergy);
    s.gained = along(earlier_.gained, from.gained, to.gained);
    s.dt = to.dt;
    s.contact = ofContact(&SliderContactForces::contact);
    s.adhesion = ofContact(&SliderContactForces::adhesion);
    s.friction = ofContact(&SliderContactForces::friction);
    s.stored = ofContact(&SliderContactForces::storedEnergy);
    s.area = ofContact(&SliderContactForces::area);
    s.peakPressure = ofContact(&SliderContactForces::peakPressure);
    if (clearance_) {
        s.gap = std::numeric_limits<double>::quiet_NaN();
        if (seek) {
            const DiskClearance::Place place = clearance_->at(attitude, time);
            s.gap = place.gap;
            if (!(place.gap > 0.0) && !reached_) reached_ = {place, time};
        }
        s.diskHeight = clearance_->diskHeight(points_.front().at, time);
        double* further = values_.data() + rows_.size();
        for (std::size_t k = 1; k < points_.size(); ++k) {
            const double disk = clearance_->diskHeight(points_[k].at, time);
            *further++ = heightOf(points_[k], attitude) - disk;
            *further++ = disk;
        }
    }
    touchdown::evaluate(rows_, s, values_.data());
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

double FilmRecorder::energyImbalance() const
{
    double range = 0.0;
    for (std::size_t k = 0; k < mostParts_.size(); ++k) range = std::max(range, mostParts_[k] - leastParts_[k]);
    return range > 0.0 ? mostMissing_ / range : 0.0;
}

Summary FilmRecorder::summary(const RunEnd& end) const
{
    return run_.summary(end, std::min(last_.time, case_.run.duration));
}

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/flight/film_on_cells.h"

#include <algorithm>

#include "core/work/state_stream.h"

namespace touchdown {

FilmOnCells::FilmOnCells(GasFilm& film, const SliderBody& body, SliderContact* contact, DiskUnderFilm* disk,
                         const FilmStepOptions& options, std::span<const double> start)
    : film_(film),
      loads_(film),
      body_(body),
      contact_(contact),
      disk_(disk),
      startPressure_(start),
      stepper_(film, options),
      response_(film, loads_, body),
      energy_(film)
{
    for (auto* field : {&change_, &surface_}) field->assign(film.pad().size(), 0.0);
    if (contact_ || isRough()) workPressure_ = workSurface_ = surface_;
}

double FilmOnCells::ambientForce() const { return film_.ambient() * film_.gaps().length * film_.gaps().width; }

void FilmOnCells::setDisk(double time, bool touched)
{
    if (isRough()) {
        if (!(surfaceTime_ == time) || deformed_) disk_->at(time, surface_);
    } else if (deformed_) {
        std::fill(surface_.begin(), surface_.end(), 0.0);
    }
    surfaceTime_ = time;
    deformed_ = touched && contact_->deform(surface_);
    film_.setSurface(isRough() || deformed_ ? std::span<const double>(surface_) : std::span<const double>());
}

void FilmOnCells::start(const SliderMotion& motion, double /*time*/)
{
    film_.setAttitude(body_.attitude(motion.q));
    stepper_.start(startPressure_);
    response_.forget();
    rememberWork();
}

FilmStepResult FilmOnCells::step(double dt, const SliderMotion& /*from*/, const Vector3& q, double rate)
{
    stepper_.setRate(rate);
    return stepper_.step(dt, body_.attitude(q));
}

Vector3 FilmOnCells::force()
{
    const std::array<double, 5> force = loads_.loadAndShear(stepper_.pressure());
    shear_ = {force[3], force[4]};
    return body_.filmForce(force);
}

int FilmOnCells::renewResponse(bool touched, const std::function<bool()>& goOn)
{
    return response_.renew(stepper_.pressure(), stepper_.linear(), touched ? contact_ : nullptr, goOn);
}

double FilmOnCells::follow(const Vector3& q, const Vector3& change)
{
    const double left = response_.follow(change, change_);
    stepper_.follow(body_.attitude(q), change_);
    return left;
}

bool FilmOnCells::accept(const SliderMotion& /*to*/)
{
    if (!stepper_.accept()) return false;
    response_.age();
    return true;
}

void FilmOnCells::rememberWork()
{
    if (workSurface_.empty()) return;
    std::ranges::copy(stepper_.pressure(), workPressure_.begin());
    std::ranges::copy(surface_, workSurface_.begin());
}

double FilmOnCells::surfaceWork()
{
    if (workSurface_.empty()) return 0.0;
    const double work = energy_.surfaceWork(workPressure_, stepper_.pressure(), workSurface_, surface_);
    rememberWork();
    return work;
}

void FilmOnCells::pass(StateStream& stream)
{
    stream(stepper_, response_, surfaceTime_, deformed_, shear_);
    for (auto* field : {&surface_, &workPressure_, &workSurface_}) stream.fixed(*field);
}

} // namespace touchdown

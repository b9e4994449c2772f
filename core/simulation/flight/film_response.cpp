// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/flight/film_response.h"

#include <cmath>

#include "core/physics/film/film_newton.h"
#include "core/physics/film/film_step_vectors.h"
#include "core/physics/film/gas_film.h"
#include "core/simulation/contact/slider_contact.h"

namespace touchdown {

namespace {

constexpr double sameRate = 0.5; // change of a step's rate for which a response is kept [-]
constexpr int mostSolverIterations = 40;

} // namespace

FilmResponse::FilmResponse(const GasFilm& film, FilmLoads& loads, const SliderBody& body)
    : film_(film), loads_(loads), body_(body), attitudeWork_(film.gaps())
{
    for (auto* fields : {&columns_, &responses_})
        for (auto& field : *fields) field.assign(film.pad().size(), 0.0);
    for (auto& field : forces_.byPressure) field.assign(film.pad().size(), 0.0);
}

void FilmResponse::forget()
{
    perTime_ = 0.0;
    stiffness_.setZero();
}

bool FilmResponse::isOld() const
{
    return std::abs(film_.storagePerTime() - perTime_) > sameRate * perTime_ || age_ > oldest;
}

int FilmResponse::renew(std::span<const double> p, FilmLinearSolver& linear, const SliderContact* contact,
                        const std::function<bool()>& goOn)
{
    bool goesOn = true;
    const auto ask = [&] { return goesOn = goesOn && (!goOn || goOn()); };
    forget();
    const double halfLength = 0.5 * film_.gaps().length;
    film_.attitudeColumns(p, columns_, attitudeWork_);
    // At a fixed height of the mass centre the trailing edge sinks by half the length times the pitch.
    for (std::size_t at = 0; at < columns_[1].size(); ++at) columns_[1][at] -= halfLength * columns_[0][at];
    for (std::vector<double>& column : columns_)
        if (contact) contact->clearTouching(column);
    loads_.derivatives(p, forces_);
    int iterations = 0;
    const std::size_t count = body_.holdsRoll() ? 2 : 3;
    for (std::size_t m = 0; m < count; ++m) {
        if (ask())
            iterations += linear
                              .solve(columns_[m], responses_[m],
                                     {.tolerance = tolerance, .maximumIterations = mostSolverIterations, .goOn = ask})
                              .iterations;
        if (!goesOn) return iterations;
        std::array<double, 5> slope{}; // d(load, shear)/dq
        for (std::size_t k = 0; k < 5; ++k) {
            double byPressure = 0.0;
            for (std::size_t at = 0; at < responses_[m].size(); ++at)
                byPressure += forces_.byPressure[k][at] * responses_[m][at];
            slope[k] = forces_.byAttitude[k][m] - byPressure;
            if (m == 1) slope[k] -= halfLength * forces_.byAttitude[k][0];
        }
        stiffness_.col(static_cast<Eigen::Index>(m)) = -body_.filmForce(slope);
    }
    perTime_ = film_.storagePerTime();
    age_ = 0;
    return iterations;
}

double FilmResponse::follow(const Vector3& dq, std::span<double> change) const
{
    setChange({responses_[0].data(), responses_[1].data(), responses_[2].data()}, {dq[0], dq[1], dq[2]}, change);
    const double squares = product(change, change);
    return tolerance * std::sqrt(squares / static_cast<double>(film_.pad().cells())) / film_.ambient();
}

} // namespace touchdown

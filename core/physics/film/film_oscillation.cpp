// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/film_oscillation.h"

#include "core/physics/film/film_slopes.h"
#include "core/physics/film/gas_film.h"

namespace touchdown {

using Complex = std::complex<double>;

namespace {

// GMRES restarted after 20 iterations loses the waves of fast oscillations that the disk carries along.
constexpr int restart = 50;

} // namespace

FilmOscillation::FilmOscillation(const GasFilm& film, std::span<const double> p, const FilmSlopes* slopes)
    : film_(film),
      stencil_(film.pad()),
      multigrid_(film.pad()),
      gmres_(film.pad().size(), restart),
      diagonal_(film.pad().size()),
      right_(film.pad().size())
{
    work_.resize(film.pad().size());
    if (film.isComplete()) {
        film.setStencil(stencil_);
        stencil_.setStorage(film.volumes());
    }
    if (slopes) {
        columns_ = slopes->flow;
        storage_ = slopes->storage;
    } else {
        AttitudeWork work(film.gaps());
        film.attitudeColumns(p, columns_, work);
        film.attitudeStorageColumns(p, storage_, work);
    }
    for (auto& response : response_) response.assign(film.pad().size(), Complex{});
}

void FilmOscillation::setRate(Complex s)
{
    for (std::size_t at = 0; at < diagonal_.size(); ++at) diagonal_[at] = s * film_.volumes()[at];
    const auto& faces = film_.faces();
    multigrid_.setOperator({FaceOperator{faces[0].diffusion, faces[0].effective, faces[0].convection},
                            FaceOperator{faces[1].diffusion, faces[1].effective, faces[1].convection}},
                           diagonal_);
    if (film_.isComplete()) multigrid_.setFinest(stencil_.points(), {}, false, stencil_.storagePoints(), s);
}

void FilmOscillation::solve(Complex s, std::vector<Complex>& response, bool& converged)
{
    const auto apply = [this, s](std::span<const Complex> v, std::span<Complex> out) {
        film_.applyJacobian(v, out, work_, s);
    };
    const auto precondition = [this](std::span<const Complex> v, std::span<Complex> out) {
        multigrid_.precondition(v, out);
    };
    const GmresOptions options{.tolerance = 1e-8, .maximumIterations = 200, .goOn = goOn_};
    converged = gmres_.solve(apply, precondition, right_, response, options).converged && converged;
}

ComplexMatrix3 FilmOscillation::stiffness(Complex s, const std::array<std::vector<double>, 3>& byPressure,
                                          const Matrix3& byAttitude, bool& converged, std::size_t columns)
{
    const std::size_t size = film_.pad().size();
    setRate(s);
    ComplexMatrix3 result = ComplexMatrix3::Zero();
    for (std::size_t m = 0; m < columns; ++m) {
        for (std::size_t at = 0; at < size; ++at) right_[at] = -(columns_[m][at] + s * storage_[m][at]);
        solve(s, response_[m], converged);
        for (std::size_t k = 0; k < 3; ++k) {
            Complex sum = byAttitude(k, m);
            for (std::size_t at = 0; at < size; ++at) sum += byPressure[k][at] * response_[m][at];
            result(k, m) = -sum;
        }
    }
    return result;
}

ComplexVector3 FilmOscillation::answer(Complex s, std::span<const Complex> source,
                                       const std::array<std::vector<double>, 3>& byPressure, bool& converged)
{
    setRate(s);
    for (std::size_t at = 0; at < right_.size(); ++at) right_[at] = -source[at];
    std::vector<Complex> response(right_.size());
    solve(s, response, converged);
    ComplexVector3 result = ComplexVector3::Zero();
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t at = 0; at < response.size(); ++at) result[k] += byPressure[k][at] * response[at];
    return result;
}

} // namespace touchdown

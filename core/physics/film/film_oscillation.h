// SPDX-License-Identifier: GPL-3.0-or-later
//
// A film about its steady state, linearised, for motions of the slider that grow or decay as exp(s t), s complex:
//
//   (J + s S) dp + (dR/da + s T) da = 0
//
// J the film's Jacobian, a the attitude. S and T are the derivatives of the residual by a rate of storage d(p V)/dt = s
// (V dp + p dV/da da) in the cells: the storage itself and, in the complete flux scheme, its part in the flow along
// each path. The dynamic stiffness is Z(s) = -(dF/dp dp/da + dF/da), F any forces that depend on pressure and attitude;
// Z(i omega) = K + i omega C.
#pragma once

#include <array>
#include <complex>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "core/numerics/gmres.h"
#include "core/numerics/multigrid.h"
#include "core/numerics/small_matrix.h"
#include "core/physics/film/film_stencil.h"

namespace touchdown {

class GasFilm;
struct FilmSlopes;

class FilmOscillation {
public:
    /// The film must be linearised at p (padded), its steady state, without storage. `slopes`: where the disk's surface
    /// follows the attitude.
    FilmOscillation(const GasFilm& film, std::span<const double> p, const FilmSlopes* slopes = nullptr);

    /// Z(s): rows by force, columns by height, pitch, roll. `byPressure` (padded) and `byAttitude` are the forces'
    /// derivatives. `converged` becomes false where a linear system was not solved. Only the first `columns` are
    /// computed, by one system each; the others are zero.
    ComplexMatrix3 stiffness(std::complex<double> s, const std::array<std::vector<double>, 3>& byPressure,
                             const Matrix3& byAttitude, bool& converged, std::size_t columns = 3);
    /// Response of the forces by the pressure, dF/dp dp, to a source in the cells: (J + s S) dp + source = 0.
    ComplexVector3 answer(std::complex<double> s, std::span<const std::complex<double>> source,
                          const std::array<std::vector<double>, 3>& byPressure, bool& converged);

    /// Asked at each iteration; if it returns false nothing converges.
    void ask(std::function<bool()> goOn) { goOn_ = std::move(goOn); }

private:
    void setRate(std::complex<double> s);
    /// dp for the right-hand side in right_, from the guess that it holds.
    void solve(std::complex<double> s, std::vector<std::complex<double>>& response, bool& converged);

    const GasFilm& film_;
    std::function<bool()> goOn_;
    std::array<std::vector<double>, 3> columns_, storage_; // dR/da and T
    FilmStencil stencil_;
    Multigrid<std::complex<double>> multigrid_;
    Gmres<std::complex<double>> gmres_;
    FaceFlows<std::complex<double>> work_;
    std::vector<std::complex<double>> diagonal_, right_;
    std::array<std::vector<std::complex<double>>, 3> response_; // of the last call, the next one's guess
};

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The balance of a slider on its film (core/simulation/static_state/film_balance.h) while one value p of its case
// changes, as a continuation needs it: G(x, p) and its derivatives, distances from the ends of a law of contact, and
// the description of an equilibrium. All are dimensionless:
//
//   p  0 at one end of its range, 1 at the other
//   x  height of the trailing edge, pitch and roll times a fifth of length and width, in units of a length near the
//      spacing
//   G  force and torques over length and width, as shares of the preload
//
// They are evaluated on one grid, each film started from the last one; films of the same slider share their gaps. The
// place where the suspension exerts its load is interpolated between the static states of the looks: an error of 1 nm
// causes 1e-8 N at 10 N/m.
#pragma once

#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/numerics/cell_grid.h"
#include "core/numerics/continuation.h"
#include "core/simulation/equilibria/equilibrium.h"
#include "core/simulation/static_state/film_balance.h"

namespace touchdown {

class ParametricBalance {
public:
    using GoOn = std::function<bool()>;

    /// `goOn` must last, and once it said false stay so.
    ParametricBalance(const CaseAt& caseAt, double from, double to, const GoOn& goOn)
        : caseAt_(caseAt), from_(from), to_(to), goOn_(goOn)
    {}

    struct Look {
        double p;
        Attitude rest; // the static state; its spacing may be negative
        bool flies;    // that lies above d_s
    };
    /// Static states at `looks` places of the range; empty if there is none. Grid and scales are those of the one
    /// nearest to the middle.
    std::vector<Look> look(int looks, std::vector<std::string>& problems);

    /// Forgets the last film and the rates of the last equilibrium.
    void leave();
    /// The case at p on the grid, with the last pressure for a start; null where it is not valid.
    std::unique_ptr<FilmBalance> balanceAt(double p);

    Eigen::VectorXd toScaled(const Vector3& q, Eigen::Index unknowns) const;
    double parameter(double p) const { return std::lerp(from_, to_, p); }
    double length() const { return length_; }              // unit of x [m]
    double sliderLength() const { return slider_.length; } // [m]

    /// False where the film is not solved. Beyond the ends of the range G continues along its slope.
    bool linearise(const Eigen::VectorXd& x, double p, ContactRegion region, ContinuationProblem::Linearised& at);
    /// From the lower and the upper end of the law's interval, and from the disk.
    std::vector<double> distances(const Eigen::VectorXd& x, double p, ContactRegion region);
    /// Its rates are followed from those of the last one.
    Equilibrium describe(const Eigen::VectorXd& x, double p, ContactRegion region);
    void followRatesOf(const Equilibrium& point) { near_ = point.eigenvalues; }
    struct Crossing {
        FilmBalance::Beyond beyond;
        Vector3 q;
    };
    std::optional<Crossing> cross(const Eigen::VectorXd& x, double p, ContactRegion region, bool upper);
    /// Least one of the equilibria described so far [Hz]; 0: none.
    double resolved() const { return resolved_; }

private:
    Attitude restAt(double p) const;
    /// Sets gaps and spacing to those of the case's slider; false where `goOn` ends the making.
    bool takeSlider(const Case& c);
    Vector3 toPlace(const Eigen::VectorXd& x) const;
    Matrix3 placeSlope() const;
    Eigen::VectorXd scaledForce(const Vector3& g, Eigen::Index unknowns) const;
    bool moveTo(const Eigen::VectorXd& x, double p);

    struct Known {
        ContactRegion region;
        Eigen::VectorXd x;
        double p;
        ContinuationProblem::Linearised at;
    };

    const CaseAt& caseAt_;
    double from_, to_;
    const GoOn& goOn_;
    std::vector<std::pair<double, Attitude>> rests_;           // by p
    double length_ = 1.0, preload_ = 1.0, startAmbient_ = 1.0; // [m], [N], [Pa]
    SliderCase slider_;
    CellGrid grid_;
    /// The last ones, of this surface and a slider of their size.
    std::shared_ptr<const FilmGaps> gaps_;
    std::optional<MinimumSpacing> spacing_;
    AirBearingSurface surface_;
    std::vector<double> startPressure_; // of the static state on the grid [Pa]
    std::unique_ptr<FilmBalance> last_; // solved at lastX_, lastP_
    Eigen::VectorXd lastX_;
    double lastP_ = 0.0;
    std::optional<Known> known_;
    std::vector<std::complex<double>> near_;
    std::map<std::vector<double>, Equilibrium> described_;
    double resolved_ = 0.0;
};

} // namespace touchdown

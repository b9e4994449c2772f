// SPDX-License-Identifier: GPL-3.0-or-later
//
// Elastic contact and adhesion as one pressure field. The total pressure q = p + f(g), contact p >= 0 and adhesion f,
// displaces the half-space: g = s + C q, with g >= 0, p g = 0, s the separation of the undeformed surfaces. It is a
// stationary point of
//
//   Pi(g) = 1/2 (g - s) K (g - s) + sum phi(g) dA,   K = C^-1, f = -dphi/dg, under g >= 0,
//
// which has many minima, as phi is concave beyond the largest attraction. Wanted is the minimum that a descent from the
// last solution reaches: cells snap in and off only when their minimum ceases to exist.
//
// Descent: the concave part of phi is replaced by its tangent at the present gaps (adhesive_cell.h), which lies above
// it, so that the minimum of the convex rest has less energy (concave-convex procedure, Yuille & Rangarajan 2003). That
// minimum is found in q, whose energy is convex with bounds, by Newton's method on the cells between their bounds. Each
// Newton step is solved by conjugate gradients, one convolution per iteration, preconditioned by the stiffness of a
// periodic half-space about as large as the grid, and is cut at the least energy along it. While the descent does not
// slow down, as when a crack runs, the tangents are taken ahead of the present gaps; where that raises the energy it is
// undone.
//
// Near the minimum the descent converges slowly because of cells that almost snap. There Newton's method on the law
// itself takes over. A step that does not halve the error is cut at the least energy along it. Where the energy rises
// along it, it leads to a saddle: the opposite step is taken, which leaves the saddle faster than the descent does.
// Where neither is worth it the descent continues.
//
// Without adhesion it is ElasticContact. Where nothing adheres, no gap is below that of the largest attraction f_max
// and the deformation by f(s) would change no pressure by more than tolerance f_max, the gap is the undeformed one
// ("far").
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/numerics/gmres.h"
#include "core/physics/contact/adhesive_cell.h"
#include "core/physics/contact/elastic_contact.h"
#include "core/physics/contact/half_space.h"

namespace touchdown {

struct AdhesiveContactSummary : ElasticContactSummary {
    double adhesionForce = 0.0; // of f [N]
    /// Energy released since the last solution beyond the work done on the way (trapezoidal rule) [J], as by a snap.
    double energyDrop = 0.0;
    /// The released energy exceeds a fourth of (change of pressure)(change of separation): more than on a smooth way. A
    /// constant stiffness releases none, the end of a branch a sixth.
    bool jumped = false;
};

/// Each solution starts from the last one, the first from the undeformed surfaces.
class AdhesiveContact {
public:
    AdhesiveContact(HalfSpace space, const Adhesion& adhesion, const ElasticContactOptions& options = {});

    /// At the given separation [m] of the undeformed surfaces, one value for each cell. Allocates nothing after the
    /// first call unless it fails. Invalid input leaves the last solution unchanged.
    AdhesiveContactSummary solve(std::span<const double> separation);

    std::span<const double> pressure() const { return elastic_ ? elastic_->pressure() : pressure_; } // p [Pa]
    std::span<const double> adhesion() const { return attraction_; }                                 // f(g) [Pa]
    std::span<const double> gap() const { return elastic_ ? elastic_->gap() : gap_; }                // g [m]
    /// Energy of the last solution with adhesion: of the half-space and of the surfaces' attraction, zero far away [J].
    double energy() const { return now_.energy; }
    const AdhesionLaw& law() const { return cell_.law(); }
    /// Otherwise it is purely elastic: `adhesion()` is zero, and no solution remembers another.
    bool adheres() const { return !elastic_; }
    HalfSpace& space() { return elastic_ ? elastic_->space() : *space_; }

    /// Forgets the last solution.
    void reset();
    /// Stores the last solution in one of two places; recall() returns to it, so that the next solve() starts there.
    void remember(std::size_t place = 0) { kept_[place] = now_; }
    void recall(std::size_t place = 0) { now_ = kept_[place]; }
    /// All that the next solution depends on, written or read.
    void pass(auto& stream)
    {
        if (elastic_) return stream(*elastic_);
        stream(now_, kept_);
        for (auto* field : {&pressure_, &attraction_, &gap_}) stream.fixed(*field);
    }

private:
    static constexpr int mostNewtonIterations = 40; // of a linear system; most where a cell is about to snap

    struct Solution {
        std::vector<double> separation, total, displacement; // s [m], q [Pa], C q [m]
        double energy = 0.0;                                 // Pi [J]
        bool exists = false;
        bool adheres = false;   // some gap is not beyond that of the largest attraction
        bool displaced = false; // whether `displacement` is that of `total`
        void pass(auto& stream)
        {
            for (auto* field : {&separation, &total, &displacement}) stream.fixed(*field);
            stream(energy, exists, adheres, displaced);
        }
    };

    std::optional<std::string> objection(std::span<const double> separation) const;
    bool solveFar(std::span<const double> separation);
    void descendToMinimum(AdhesiveContactSummary& summary);
    void finish(const Solution& before, AdhesiveContactSummary& summary);

    void displace();
    void countIteration();
    bool spent() const { return stopped_ || iterations_ >= options_.maximumIterations; }
    double gapAt(std::size_t i) const { return now_.separation[i] + now_.displacement[i]; }
    double presentEnergy() const;
    void setOffsets();
    double linearise();
    double imbalance();
    bool setTangents(bool first);
    double descend(double error);
    void minimiseConvex(double error);
    void solveTangents();
    void precondition(std::span<const double> in, std::span<double> out);
    bool cutStep();
    void shorten(double part);
    bool snaps() const;
    bool newtonStep(double error);
    bool leaveSaddle(double times);
    void stepBy(double times);
    void undo();
    double partOfLeastEnergy() const;

    std::optional<HalfSpace> space_;        // unless elastic_ has it
    std::optional<ElasticContact> elastic_; // without adhesion
    std::optional<HalfSpace> periodic_;     // preconditioner
    std::vector<double> repeated_;          // on its grid
    ElasticContactOptions options_;
    AdhesiveCell cell_;
    double reach_;     // the most that pressures up to 1 Pa displace [m/Pa]
    double freeScale_; // z0, the scale of changes of a gap [m]
    std::array<Solution, 2> kept_;
    Solution now_, before_, lower_; // lower_: the one of least energy on the descent
    std::vector<double> pressure_, attraction_, gap_;
    // Of the descent: the law's tangents at the present gaps s + C q, and the change that is made with them.
    AdhesiveCell::Tangents tangents_;
    std::vector<double> present_, offset_, weight_, residual_, change_, moved_, direction_, shift_, image_, work_,
        totalBefore_, displacementBefore_, displacementEarlier_;
    // Of Newton's method on the law: of the cells that soften, df/dg, else 0 [Pa/m].
    std::vector<double> softening_;
    std::optional<Gmres<double>> gmres_;
    double ahead_ = 0.0; // how far ahead of the gaps, in their last changes [-]
    int iterations_ = 0;
    bool stopped_ = false; // by goOn
};

} // namespace touchdown

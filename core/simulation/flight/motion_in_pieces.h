// SPDX-License-Identifier: GPL-3.0-or-later
//
// The motion of a slider on a film in pieces (film_in_pieces.h), over a flat disk or over one wave. Within a region of
// the contact
//
//   y' = A y + b + Re g e^(i omega t),   y = Re Y e^(i omega t) - A^-1 b + V e^(L t) c,   A V = V L
//
// is exact at any time. Switches are located on it. The derivative of the motion by its beginning is that of the modes,
// with S = I + (f+ - f-) g^T/(g . y'-) at a switch with the normal g.
#pragma once

#include <complex>
#include <span>

#include <Eigen/Core>

#include "core/simulation/flight/film_in_pieces.h"

namespace touchdown {

/// By one frequency.
struct Driving {
    double omega = 0.0;                          // [1/s]
    Eigen::VectorXcd force;                      // g; empty: none, also no answers
    std::span<const Eigen::VectorXcd> answers{}; // Y, by region
};

/// One who measures along it derives from it.
class MotionInPieces {
public:
    virtual ~MotionInPieces() = default;

protected:
    using Complex = std::complex<double>;

    /// From y in a region at time 0. `timeError`: to which a switch is located [s].
    MotionInPieces(const FilmInPieces& film, const Driving& driving, Eigen::VectorXd y, std::size_t region,
                   bool derivative, double step, double timeError);

    /// At time_, where the last piece has gone on by dt.
    virtual void measure(double dt) = 0;
    /// A piece ends at time_, after dt; e^(L dt).
    virtual void pieceEnds(double /*dt*/, const Eigen::VectorXcd& /*decay*/) {}
    /// The law switches to a region; y' before. What is added to the motion's deviation, by its rate across the switch.
    virtual Eigen::VectorXd switchTo(std::size_t region, const Eigen::VectorXd& before);

    /// A piece in the present region from y_ on.
    void begin();
    /// After dt; false where the law switches before.
    bool sample(double dt);
    /// The piece ends at time_.
    void end();

    const FilmInPieces::Region& region() const { return film_.regions()[region_]; }
    /// A reading along the present piece: sum of the modes, the answer to the wave, the rest.
    struct Row {
        Eigen::RowVectorXcd modes;
        Complex wave;
        double rest = 0.0;
    };
    /// `disk`: what the reading adds of the wave itself.
    Row rowOf(const FilmInPieces::Reading& reading, Complex disk = 0.0) const;
    double valueOf(const Row& row, const Eigen::VectorXcd& modes, double time) const
    {
        return (row.modes * modes)(0).real() + (row.wave * turned(time)).real() + row.rest;
    }
    double rateOf(const Row& row, const Eigen::VectorXcd& modes, double time) const
    {
        return (row.modes * region().rates.cwiseProduct(modes))(0).real() +
               (Complex(0.0, driving_.omega) * row.wave * turned(time)).real();
    }
    Eigen::VectorXcd modesAfter(double dt) const
    {
        return modes_.cwiseProduct((dt * region().rates).array().exp().matrix());
    }
    /// The first positions of the state at time_.
    Eigen::VectorXd positionsNow() const;
    /// y' at y_.
    Eigen::VectorXd slopeAt() const;
    /// Where a function of a time changes its sign; the right end where it does not.
    template <class Function>
    double rootOf(const Function& f, double left, double right) const;

    const FilmInPieces& film_;
    const Driving& driving_;
    std::size_t region_;
    Eigen::VectorXd y_;                         // where the present piece begins, or has ended
    Eigen::MatrixXd phi_;                       // empty: no derivative
    double step_, timeError_;                   // [s]
    double time_ = 0.0, begun_ = 0.0;           // [s]
    Eigen::VectorXcd atBegin_, modes_, factor_; // c; c e^(L t) at time_; e^(L step_)
    Row separation_;
    double spacing_ = 0.0, rate_ = 0.0; // at time_ [m], [m/s]

private:
    Complex turned(double time) const { return std::polar(1.0, driving_.omega * time); }
    /// Re Y e^(i omega t) at a time.
    Eigen::VectorXd answerAt(double time) const;
    void advance(Eigen::VectorXcd there, double time, double dt);
    void cross(bool upper, double dt);
};

template <class Function>
double MotionInPieces::rootOf(const Function& f, double left, double right) const
{
    constexpr int mostBisections = 80;
    double a = left, b = right, fa = f(a), fb = f(b);
    if (!(fa * fb < 0.0)) return fb == 0.0 || fa != 0.0 ? right : left;
    for (int k = 0; k < mostBisections && b - a > timeError_; ++k) {
        // Illinois: secants, of which none keeps an end for ever.
        double t = (a * fb - b * fa) / (fb - fa);
        if (!(t > a && t < b)) t = 0.5 * (a + b);
        const double ft = f(t);
        if (ft == 0.0) return t;
        if (ft * fb < 0.0) {
            a = b;
            fa = fb;
        } else {
            fa *= 0.5;
        }
        b = t;
        fb = ft;
        if (a > b) {
            std::swap(a, b);
            std::swap(fa, fb);
        }
    }
    return b;
}

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/response/forced_film.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/formats/units.h"
#include "core/simulation/flight/linear_film.h"

namespace touchdown {

using Complex = std::complex<double>;
using Eigen::Index, Eigen::MatrixXcd, Eigen::MatrixXd, Eigen::RowVectorXcd, Eigen::VectorXcd, Eigen::VectorXd;

namespace {

constexpr double samplesOfPeriod = 64.0, samplesOfOscillation = 20.0; // at least [-]
constexpr double mostSamples = 4096.0;                                // of a period
constexpr int mostSwitches = 64;                                      // in a period
constexpr int mostBisections = 80;
constexpr double stateRoundOff = 1e-11; // in amplitudes of the wave [-]
constexpr double farthest = 1.0;        // displacement of the corners, in minimum spacings of the static state [-]
constexpr double sameTime = 1e-15;      // of a period, to which a switch is located [-]

} // namespace

/// Takes a motion through its regions.
class ForcedFilm::Way {
public:
    Way(const ForcedFilm& slider, const ForcedState& from, const ForcedRequest& request, ForcedPeriods& result)
        : film_(*slider.film_),
          slider_(slider),
          request_(request),
          result_(result),
          omega_(2.0 * std::numbers::pi * slider.frequency_),
          region_(film_.placeOf(from.mode.contact)),
          y_(from.y),
          lowest_(VectorXd::Constant(film_.positions(), std::numeric_limits<double>::infinity())),
          highest_(-lowest_)
    {
        if (request.derivative) phi_ = MatrixXd::Identity(y_.size(), y_.size());
        const double period = 1.0 / slider.frequency_;
        step_ = period / std::clamp(samplesOfOscillation * film_.fastestRate() / omega_, samplesOfPeriod, mostSamples);
    }

    void go(double until)
    {
        int switches = 0;
        const int most = mostSwitches * request_.periods;
        begin();
        while (until - time_ > sameTime / slider_.frequency_ && result_.problem.empty()) {
            const bool last = until - time_ < 1.5 * step_;
            if (sample(last ? until - time_ : step_)) continue;
            if (++switches > most)
                result_.problem = "the contact switches more than 64 times within one period (d_e close to d_s)";
        }
        end();
        result_.end = {y_, {.contact = film_.regions()[region_].name}};
        result_.swing = 0.5 * (highest_ - lowest_);
        result_.derivative = phi_;
        result_.harmonic = 2.0 / until * sum_;
        result_.contactShare = contactTime_ / until;
        if (result_.problem.empty() && !y_.allFinite()) result_.problem = "the motion diverged";
        if (result_.problem.empty() && request_.measurements) lookAtSize();
    }

private:
    const FilmUnderWaves::Region& region() const { return film_.regions()[region_]; }
    const VectorXcd& answer() const { return slider_.answers_[region_]; }

    /// A reading along the present piece: sum of the modes, the answer to the wave, the rest.
    struct Row {
        RowVectorXcd modes;
        Complex wave;
        double rest = 0.0;
    };
    Row rowOf(const FilmUnderWaves::Reading& reading) const
    {
        const auto row = reading.row.cast<Complex>();
        return {row * region().vectors, (row * answer())(0) + film_.amplitude() * reading.disk,
                reading.row.dot(region().shift) + reading.constant};
    }
    double valueOf(const Row& row, const VectorXcd& modes, double time) const
    {
        return (row.modes * modes)(0).real() + (row.wave * std::polar(1.0, omega_ * time)).real() + row.rest;
    }
    double rateOf(const Row& row, const VectorXcd& modes, double time) const
    {
        return (row.modes * region().rates.cwiseProduct(modes))(0).real() +
               (Complex(0.0, omega_) * row.wave * std::polar(1.0, omega_ * time)).real();
    }
    VectorXcd modesAfter(double dt) const { return modes_.cwiseProduct((dt * region().rates).array().exp().matrix()); }
    VectorXd stateOf(const VectorXcd& modes, double time) const
    {
        return (region().vectors * modes + answer() * std::polar(1.0, omega_ * time)).real() + region().shift;
    }

    /// A piece in the present region from y_ on.
    void begin()
    {
        begun_ = time_;
        atBegin_ = modes_ = region().inverse *
                            (y_ - (answer() * std::polar(1.0, omega_ * time_)).real() - region().shift).cast<Complex>();
        separation_ = rowOf(film_.separation());
        quantity_ = rowOf(film_.quantity());
        factor_ = (step_ * region().rates).array().exp().matrix();
        spacing_ = valueOf(separation_, modes_, time_);
        rate_ = rateOf(separation_, modes_, time_);
        measure(modes_, time_, 0.0);
    }

    /// After dt; false where the law switches before.
    bool sample(double dt)
    {
        const double next = time_ + dt;
        const VectorXcd there = dt == step_ ? VectorXcd(modes_.cwiseProduct(factor_)) : modesAfter(dt);
        const double spacing = valueOf(separation_, there, next), rate = rateOf(separation_, there, next);
        const Interval& within = region().interval;
        // Between two times the separation may turn.
        const double reach = std::max(std::abs(rate_), std::abs(rate)) * dt;
        for (const bool upper : {false, true}) {
            const double sign = upper ? -1.0 : 1.0, border = sign * (upper ? within.upper : within.lower);
            if (!std::isfinite(border)) continue;
            const double first = sign * spacing_ - border, last = sign * spacing - border;
            const bool turns = sign * rate_ < 0.0 && sign * rate > 0.0;
            double left = 0.0, right = dt;
            if (last >= 0.0 && (!turns || std::min(first, last) > reach)) continue;
            if (turns) {
                const double turn =
                    rootOf([&](double t) { return rateOf(separation_, modesAfter(t), time_ + t); }, 0.0, dt);
                if (sign * valueOf(separation_, modesAfter(turn), time_ + turn) - border < 0.0)
                    right = turn;
                else if (last >= 0.0)
                    continue;
                else
                    left = turn;
            } else if (first <= 0.0 && sign * rate_ > 0.0) { // it has just come in, and goes out again
                left = rootOf([&](double t) { return rateOf(separation_, modesAfter(t), time_ + t); }, 0.0, dt);
            }
            cross(upper,
                  rootOf([&](double t) { return sign * valueOf(separation_, modesAfter(t), time_ + t) - border; }, left,
                         right));
            return false;
        }
        advance(there, next, dt);
        spacing_ = spacing;
        rate_ = rate;
        if (displacement_ > farthest * film_.gap())
            result_.problem = "the motion becomes larger than the spacing: a linear film ends there";
        return true;
    }

    /// Where a function changes its sign; the right end where it does not.
    template <class Function>
    double rootOf(const Function& f, double left, double right) const
    {
        double a = left, b = right, fa = f(a), fb = f(b);
        if (!(fa * fb < 0.0)) return fb == 0.0 || fa != 0.0 ? right : left;
        for (int k = 0; k < mostBisections && b - a > sameTime / slider_.frequency_; ++k) {
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

    void cross(bool upper, double dt)
    {
        advance(modesAfter(dt), time_ + dt, dt);
        end();
        const FilmUnderWaves::Region& before = region();
        const VectorXd push = slopeAt();
        const std::size_t next = upper ? before.above : before.below;
        if (before.name == ContactRegion::Apart && film_.regions()[next].name != ContactRegion::Apart)
            ++result_.touchDowns;
        region_ = next;
        const Eigen::RowVectorXd& normal = film_.separation().row;
        const double speed = normal.dot(push);
        if (request_.derivative && speed != 0.0) phi_ += ((slopeAt() - push) / speed) * (normal * phi_);
        begin();
    }

    /// y' at y_.
    VectorXd slopeAt() const
    {
        const FilmUnderWaves::Region& here = region();
        VectorXd slope = here.a * y_ + here.b;
        slope += (slider_.force_ * std::polar(1.0, omega_ * time_)).real();
        return slope;
    }

    void advance(VectorXcd there, double time, double dt)
    {
        modes_ = std::move(there);
        time_ = time;
        measure(modes_, time, dt);
    }

    void measure(const VectorXcd& modes, double time, double dt)
    {
        const VectorXd y = (region().vectors.topRows(film_.positions()) * modes +
                            answer().head(film_.positions()) * std::polar(1.0, omega_ * time))
                               .real() +
                           region().shift.head(film_.positions());
        lowest_ = lowest_.cwiseMin(y);
        highest_ = highest_.cwiseMax(y);
        displacement_ = y.cwiseAbs().sum();
        if (!request_.measurements) return;
        const double value = valueOf(quantity_, modes, time);
        result_.least = std::min(result_.least, value);
        result_.most = std::max(result_.most, value);
        result_.leastSpacing = std::min(result_.leastSpacing, valueOf(separation_, modes, time));
        const double size = displacement_ / film_.gap(),
                     waves = std::numbers::sqrt2 / 2.0 * film_.amplitude() / film_.gap();
        const double square = size * size + waves * waves;
        squares_ += dt * square;
        fourths_ += dt * square * square;
        if (region().presses) contactTime_ += dt;
    }

    /// The piece ends at time_.
    void end()
    {
        const double dt = time_ - begun_;
        y_ = stateOf(modes_, time_);
        if (dt == 0.0) return;
        const VectorXcd decay = (dt * region().rates).array().exp().matrix();
        if (request_.derivative) phi_ = (region().vectors * decay.asDiagonal() * region().inverse).real() * phi_;
        if (!request_.measurements) return;
        // int q exp(-i omega t) dt over the piece, each part by itself.
        const Complex i(0.0, 1.0), first = std::polar(1.0, -omega_ * begun_), last = std::polar(1.0, -omega_ * time_);
        Complex sum = 0.0;
        for (Index k = 0; k < decay.size(); ++k)
            sum += quantity_.modes[k] * atBegin_[k] * (decay[k] * last - first) / (region().rates[k] - i * omega_);
        sum += 0.5 * quantity_.wave * dt +
               0.5 * std::conj(quantity_.wave) * (last * last - first * first) / (-2.0 * i * omega_);
        sum += quantity_.rest * (last - first) / (-i * omega_);
        sum_ += sum;
    }

    void lookAtSize()
    {
        const double error = squares_ > 0.0 ? linearErrorPerSize * std::sqrt(fourths_ / squares_) : 0.0;
        if (error > film_.linearLimit())
            result_.problem = "motion and waves are too large for a linear film: its error is estimated as " +
                              percent(error) + " of them, above film.linear_limit = " + percent(film_.linearLimit());
    }

    const FilmUnderWaves& film_;
    const ForcedFilm& slider_;
    const ForcedRequest& request_;
    ForcedPeriods& result_;
    double omega_; // [1/s]
    std::size_t region_;
    VectorXd y_; // where the present piece begins
    MatrixXd phi_;
    double step_ = 0.0, time_ = 0.0, begun_ = 0.0; // [s]
    VectorXcd atBegin_, modes_, factor_;           // c; c e^(L t) at time_; e^(L step_)
    Row separation_, quantity_;
    double spacing_ = 0.0, rate_ = 0.0; // at time_ [m], [m/s]
    VectorXd lowest_, highest_;
    double displacement_ = 0.0; // of the corners at time_ [m]
    double squares_ = 0.0, fourths_ = 0.0, contactTime_ = 0.0;
    Complex sum_ = 0.0; // int q exp(-i omega t) dt
};

ForcedFilm::ForcedFilm(std::shared_ptr<const FilmUnderWaves> film, double frequency)
    : film_(std::move(film)), frequency_(frequency)
{
    const Index n = film_->positions();
    const Complex rate(0.0, 2.0 * std::numbers::pi * frequency);
    force_ = VectorXcd::Zero(film_->start().y.size());
    force_.segment(n, n) = film_->forceAt(frequency);
    for (const FilmUnderWaves::Region& region : film_->regions())
        answers_.emplace_back(region.vectors *
                              (region.inverse * force_).cwiseQuotient((rate - region.rates.array()).matrix()));
}

double ForcedFilm::stepError(bool /*rough*/) const { return stateRoundOff * waveAmplitude(); }

VectorXd ForcedFilm::units(const VectorXd& swing) const
{
    const Index n = positions(), film = force_.size() - 2 * n;
    const double size = std::max(swing.maxCoeff(), leastSize * waveAmplitude());
    VectorXd units(force_.size());
    units.head(n).setConstant(size);
    units.segment(n, n).setConstant(size * FilmUnderWaves::rateUnit *
                                    std::max(2.0 * std::numbers::pi * frequency_, film_->fastestRate()));
    // Together they count as much as the positions.
    units.tail(film).setConstant(size * std::sqrt(std::max(1.0, static_cast<double>(film) / static_cast<double>(n))));
    return units;
}

ForcedState ForcedFilm::moved(const VectorXd& direction, double size) const
{
    const Index n = positions();
    const double rate = std::max(2.0 * std::numbers::pi * frequency_, film_->fastestRate());
    return continued({film_->settledAt(size * direction.head(n), size * rate * direction.tail(n)),
                      {.contact = film_->regions()[film_->atRest()].name}});
}

ForcedState ForcedFilm::lowered(double distance) const
{
    const VectorXd none = VectorXd::Zero(positions());
    VectorXd lower = none;
    lower[0] = -distance;
    return continued({film_->settledAt(lower, none), {.contact = film_->regions()[film_->atRest()].name}});
}

ForcedState ForcedFilm::continued(const ForcedState& before) const
{
    constexpr int mostRegions = 4;
    const FilmUnderWaves::Reading& reading = film_->separation();
    const double separation = reading.row.dot(before.y) + reading.constant;
    std::size_t at = film_->placeOf(before.mode.contact);
    for (int k = 0; k < mostRegions; ++k) {
        const FilmUnderWaves::Region& region = film_->regions()[at];
        if (separation < region.interval.lower)
            at = region.below;
        else if (separation > region.interval.upper)
            at = region.above;
        else
            break;
    }
    return {before.y, {.contact = film_->regions()[at].name}};
}

ForcedPeriods ForcedFilm::run(const ForcedState& start, const ForcedRequest& request) const
{
    ForcedPeriods result;
    Way(*this, start, request, result).go(request.periods / frequency_);
    return result;
}

std::optional<Complex> ForcedFilm::linear() const
{
    const FilmUnderWaves::Region& region = film_->regions()[film_->atRest()];
    if (region.rates.real().maxCoeff() >= 0.0) return {};
    const FilmUnderWaves::Reading& quantity = film_->quantity();
    return (quantity.row.cast<Complex>() * answers_[film_->atRest()])(0) + film_->amplitude() * quantity.disk;
}

} // namespace touchdown

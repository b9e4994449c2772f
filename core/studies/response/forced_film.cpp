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
constexpr double stateRoundOff = 1e-11;                               // in amplitudes of the wave [-]
constexpr double farthest = 1.0;   // displacement of the corners, in minimum spacings of the static state [-]
constexpr double sameTime = 1e-15; // of a period, to which a switch is located [-]

} // namespace

/// Takes a motion through its regions.
class ForcedFilm::Way final : public MotionInPieces {
public:
    Way(const ForcedFilm& slider, const ForcedState& from, const ForcedRequest& request, ForcedPeriods& result)
        : MotionInPieces(slider.film_->pieces(), slider.driving_, from.y,
                         slider.film_->pieces().placeOf(from.mode.contact), request.derivative, stepOf(slider),
                         sameTime / slider.frequency_),
          waves_(*slider.film_),
          request_(request),
          result_(result),
          lowest_(VectorXd::Constant(film_.positions(), std::numeric_limits<double>::infinity())),
          highest_(-lowest_)
    {}

    void go(double until)
    {
        int switches = 0;
        const int most = mostSwitches * request_.periods;
        begin();
        while (until - time_ > timeError_ && result_.problem.empty()) {
            const bool last = until - time_ < 1.5 * step_;
            if (!sample(last ? until - time_ : step_)) {
                if (++switches > most)
                    result_.problem = "the contact switches more than 64 times within one period (d_e close to d_s)";
            } else if (displacement_ > farthest * film_.gap()) {
                result_.problem = "the motion becomes larger than the spacing: a linear film ends there";
            }
        }
        end();
        result_.end = {y_, {.contact = region().name}};
        result_.swing = 0.5 * (highest_ - lowest_);
        result_.derivative = phi_;
        result_.harmonic = 2.0 / until * sum_;
        result_.contactShare = contactTime_ / until;
        if (result_.problem.empty() && !y_.allFinite()) result_.problem = "the motion diverged";
        if (result_.problem.empty() && request_.measurements) lookAtSize();
    }

private:
    static double stepOf(const ForcedFilm& slider)
    {
        const double oscillations = slider.film_->pieces().fastestRate() / slider.driving_.omega;
        return 1.0 / slider.frequency_ / std::clamp(samplesOfOscillation * oscillations, samplesOfPeriod, mostSamples);
    }

    VectorXd switchTo(std::size_t next, const VectorXd& before) override
    {
        if (region().name == ContactRegion::Apart && film_.regions()[next].name != ContactRegion::Apart)
            ++result_.touchDowns;
        return MotionInPieces::switchTo(next, before);
    }

    void measure(double dt) override
    {
        const VectorXd y = positionsNow();
        lowest_ = lowest_.cwiseMin(y);
        highest_ = highest_.cwiseMax(y);
        displacement_ = y.cwiseAbs().sum();
        if (!request_.measurements) return;
        if (dt == 0.0) quantity_ = rowOf(waves_.quantity().film, waves_.amplitude() * waves_.quantity().disk);
        const double value = valueOf(quantity_, modes_, time_);
        result_.least = std::min(result_.least, value);
        result_.most = std::max(result_.most, value);
        result_.leastSpacing = std::min(result_.leastSpacing, valueOf(separation_, modes_, time_));
        const double size = displacement_ / film_.gap(),
                     waves = std::numbers::sqrt2 / 2.0 * waves_.amplitude() / film_.gap();
        const double square = size * size + waves * waves;
        squares_ += dt * square;
        fourths_ += dt * square * square;
        if (region().presses) contactTime_ += dt;
    }

    void pieceEnds(double dt, const VectorXcd& decay) override
    {
        if (!request_.measurements) return;
        // int q exp(-i omega t) dt over the piece, each part by itself.
        const double omega = driving_.omega;
        const Complex i(0.0, 1.0), first = std::polar(1.0, -omega * begun_), last = std::polar(1.0, -omega * time_);
        Complex sum = 0.0;
        for (Index k = 0; k < decay.size(); ++k)
            sum += quantity_.modes[k] * atBegin_[k] * (decay[k] * last - first) / (region().rates[k] - i * omega);
        sum += 0.5 * quantity_.wave * dt +
               0.5 * std::conj(quantity_.wave) * (last * last - first * first) / (-2.0 * i * omega);
        sum += quantity_.rest * (last - first) / (-i * omega);
        sum_ += sum;
    }

    void lookAtSize()
    {
        const double error = squares_ > 0.0 ? linearErrorPerSize * std::sqrt(fourths_ / squares_) : 0.0;
        if (error > waves_.linearLimit())
            result_.problem = "motion and waves are too large for a linear film: its error is estimated as " +
                              percent(error) + " of them, above film.linear_limit = " + percent(waves_.linearLimit());
    }

    const FilmUnderWaves& waves_;
    const ForcedRequest& request_;
    ForcedPeriods& result_;
    Row quantity_;
    VectorXd lowest_, highest_;
    double displacement_ = 0.0; // of the corners at time_ [m]
    double squares_ = 0.0, fourths_ = 0.0, contactTime_ = 0.0;
    Complex sum_ = 0.0; // int q exp(-i omega t) dt
};

ForcedFilm::ForcedFilm(std::shared_ptr<const FilmUnderWaves> film, double frequency)
    : film_(std::move(film)), frequency_(frequency)
{
    const FilmInPieces& pieces = film_->pieces();
    const Index n = pieces.positions();
    driving_.omega = 2.0 * std::numbers::pi * frequency;
    driving_.force = VectorXcd::Zero(pieces.size());
    driving_.force.segment(n, n) = film_->forceAt(frequency);
    const Complex rate(0.0, driving_.omega);
    for (const FilmInPieces::Region& region : pieces.regions())
        answers_.emplace_back(region.vectors *
                              (region.inverse * driving_.force).cwiseQuotient((rate - region.rates.array()).matrix()));
    driving_.answers = answers_;
}

double ForcedFilm::stepError(bool /*rough*/) const { return stateRoundOff * waveAmplitude(); }

VectorXd ForcedFilm::units(const VectorXd& swing) const
{
    const Index n = positions(), film = film_->pieces().size() - 2 * n;
    const double size = std::max(swing.maxCoeff(), leastSize * waveAmplitude());
    VectorXd units(film_->pieces().size());
    units.head(n).setConstant(size);
    units.segment(n, n).setConstant(size * FilmInPieces::rateUnit *
                                    std::max(2.0 * std::numbers::pi * frequency_, film_->pieces().fastestRate()));
    // Together they count as much as the positions.
    units.tail(film).setConstant(size * std::sqrt(std::max(1.0, static_cast<double>(film) / static_cast<double>(n))));
    return units;
}

ForcedState ForcedFilm::moved(const VectorXd& direction, double size) const
{
    const Index n = positions();
    const double rate = std::max(2.0 * std::numbers::pi * frequency_, film_->pieces().fastestRate());
    return continued({film_->pieces().settledAt(size * direction.head(n), size * rate * direction.tail(n)),
                      {.contact = film_->pieces().regions()[film_->pieces().atRest()].name}});
}

ForcedState ForcedFilm::lowered(double distance) const
{
    const VectorXd none = VectorXd::Zero(positions());
    VectorXd lower = none;
    lower[0] = -distance;
    return continued({film_->pieces().settledAt(lower, none),
                      {.contact = film_->pieces().regions()[film_->pieces().atRest()].name}});
}

ForcedState ForcedFilm::continued(const ForcedState& before) const
{
    const FilmInPieces& pieces = film_->pieces();
    const std::size_t region = pieces.regionFrom(pieces.placeOf(before.mode.contact), before.y);
    return {before.y, {.contact = pieces.regions()[region].name}};
}

ForcedPeriods ForcedFilm::run(const ForcedState& start, const ForcedRequest& request) const
{
    ForcedPeriods result;
    Way(*this, start, request, result).go(request.periods / frequency_);
    return result;
}

std::optional<Complex> ForcedFilm::linear() const
{
    const FilmInPieces::Region& region = film_->pieces().regions()[film_->pieces().atRest()];
    if (region.rates.real().maxCoeff() >= 0.0) return {};
    const FilmUnderWaves::Reading& quantity = film_->quantity();
    return (quantity.film.row.cast<Complex>() * answers_[film_->pieces().atRest()])(0) +
           film_->amplitude() * quantity.disk;
}

} // namespace touchdown

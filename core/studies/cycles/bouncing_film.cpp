// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/cycles/bouncing_film.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <mutex>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "core/case/contact_kind.h"
#include "core/case/contact_law.h"
#include "core/formats/units.h"
#include "core/simulation/flight/film_scene.h"
#include "core/simulation/flight/linear_film.h"
#include "core/simulation/static_state/film_setup.h"
#include "core/work/team.h"

namespace touchdown {

using Complex = std::complex<double>;
using Eigen::Index, Eigen::MatrixXcd, Eigen::MatrixXd, Eigen::VectorXcd, Eigen::VectorXd;

namespace {

constexpr double samplesOfOscillation = 20.0; // at least [-]
constexpr double sameTime = 1e-15;            // of the shortest period, to which a switch is located [-]
constexpr double farthest = 30.0;             // displacement of the corners, in minimum spacings of the state [-]
constexpr int mostSwitches = 64;              // in a shortest period
constexpr std::size_t keptFilms = 16;         // of different values
const Driving undriven{};

/// (e^z - 1)/z
Complex growth(Complex z)
{
    if (std::abs(z) > 1e-2) return (std::exp(z) - 1.0) / z;
    Complex sum = 1.0, term = 1.0;
    for (int k = 2; k < 9; ++k) sum += term *= z / double(k);
    return sum;
}

double valueAt(const FilmInPieces::Reading& reading, const VectorXd& y)
{
    return reading.row.dot(y) + reading.constant;
}

} // namespace

std::string reasonAgainstBouncingFilm(const Case& c)
{
    if (c.film.motion == FilmMotion::Linear) return {};
    return "has its film solved in each step: a study of cycles takes a linear film (film.motion = \"linear\")";
}

/// Takes a motion through its regions.
class BouncingFilm::Way final : public MotionInPieces {
public:
    Way(const BouncingFilm& slider, VectorXd y, std::size_t region, bool derivative)
        : MotionInPieces(*slider.film_, undriven, std::move(y), region, derivative,
                         slider.shortestPeriod_ / samplesOfOscillation, sameTime * slider.shortestPeriod_),
          slider_(slider),
          near_(film_.minimumSpacing(), film_.gap())
    {}

    void follow(const ReturnRequest& request, Return& result)
    {
        request_ = &request;
        result_ = &result;
        begin();
        while (!result.returned && time_ < request.limit && goesOn()) sample(step_);
        if (!result.returned) return;
        result.time = time_;
        if (phi_.size() > 0) result.derivative = phi_;
        result.modelError = linearError();
        if (tangent_ > 0.0) result.modelError += tangent_ / (0.5 * (result.separation.most - result.separation.least));
        result.tooFar = result.modelError > slider_.limit_;
    }

    LongMotion watch(double duration, BouncingWatch& watch)
    {
        watch_ = &watch;
        watch.begin(valueAt(film_.separation(), y_), region().name);
        begin();
        bool judged = false;
        while (time_ < duration && goesOn()) {
            sample(std::min(step_, duration - time_));
            if (judged || time_ < (1.0 - judgedShare) * duration) continue;
            judged = true;
            squares_ = fourths_ = 0.0;
        }
        if (!watched_) return {.problem = "stopped"};
        if (switches_ > mostSwitches)
            return {.problem = "the contact switches more than 64 times within one period (d_e close to d_s)"};
        if (!goesOn())
            return {.problem = "the motion becomes " + fewDigits(farthest, "") +
                               " times as large as the spacing, where no linear film is known"};
        return {.modelError = linearError(), .tooFar = linearError() > slider_.limit_};
    }

private:
    bool goesOn() const { return watched_ && size_ <= farthest && switches_ <= mostSwitches; }
    double linearError() const { return squares_ > 0.0 ? linearErrorPerSize * std::sqrt(fourths_ / squares_) : 0.0; }

    VectorXd switchTo(std::size_t next, const VectorXd& before) override
    {
        const CycleSwitch of{SpringModel::Pad, {.contact = region().name}, {.contact = film_.regions()[next].name}};
        if (time_ - counted_ > slider_.shortestPeriod_) {
            counted_ = time_;
            switches_ = 0;
        }
        ++switches_;
        const bool crosses = of.crosses();
        const VectorXd x = crosses ? slider_.coordinates(y_) : VectorXd();
        if (watch_) watch_->event(time_, of, crosses ? &x : nullptr);
        bool last = false;
        if (result_) {
            result_->switches.push_back(of);
            if (crosses) result_->passed.push_back(x);
            last = crosses && result_->passed.size() == static_cast<std::size_t>(request_->crossings);
            if (last) {
                result_->returned = true;
                result_->x = x;
            }
        }
        const VectorXd jump = MotionInPieces::switchTo(next, before);
        // At the section time is free: the deviation is projected along the motion.
        return last ? VectorXd(-before) : jump;
    }

    void measure(double dt) override
    {
        const VectorXd positions = positionsNow();
        size_ = positions.cwiseAbs().sum() / film_.gap();
        const double square = size_ * size_;
        squares_ += dt * square;
        fourths_ += dt * square * square;
        if (watch_ && dt > 0.0) {
            const double begun = time_ - dt;
            const VectorXcd before = modesAfter(-dt);
            watched_ = watch_->step(time_, [&](double time) {
                const VectorXcd there = before.cwiseProduct(((time - begun) * region().rates).array().exp().matrix());
                return valueOf(separation_, there, time);
            });
        }
        if (!result_ || !request_->measurements) return;
        const double rate = rateOf(separation_, modes_, time_);
        const double spacing = valueOf(separation_, modes_, time_);
        addSpacing(spacing);
        tangent_ = std::max(tangent_, std::abs(near_.at(film_.attitude(positions)) - spacing));
        if (dt > 0.0 && rateBefore_ * rate < 0.0) {
            const VectorXcd before = modesAfter(-dt);
            const auto at = [&](double t) { return before.cwiseProduct((t * region().rates).array().exp().matrix()); };
            const double turn = rootOf([&](double t) { return rateOf(separation_, at(t), 0.0); }, 0.0, dt);
            addSpacing(valueOf(separation_, at(turn), 0.0));
        }
        rateBefore_ = rate;
    }

    void addSpacing(double spacing)
    {
        result_->separation.add(spacing);
        result_->minimumSpacing.add(spacing);
    }

    void pieceEnds(double dt, const VectorXcd&) override
    {
        if (!result_ || !request_->measurements) return;
        const FilmInPieces::Region& now = region();
        const Index n = film_.positions(), size = atBegin_.size();
        // int c_i c_k e^((L_i + L_k) t) dt, int c_k e^(L_k t) dt
        VectorXcd single(size);
        MatrixXcd twice(size, size);
        for (Index k = 0; k < size; ++k) {
            single[k] = atBegin_[k] * dt * growth(now.rates[k] * dt);
            for (Index i = 0; i < size; ++i)
                twice(i, k) = atBegin_[i] * atBegin_[k] * dt * growth((now.rates[i] + now.rates[k]) * dt);
        }
        const MatrixXcd speeds = now.vectors.middleRows(n, n) / FilmInPieces::rateUnit;
        const auto work = [&](const MatrixXcd& byModes, const VectorXd& constant) {
            return (byModes.transpose() * speeds).cwiseProduct(twice).sum().real() +
                   (constant.cast<Complex>().transpose() * speeds * single)(0).real();
        };
        const auto byState = [&](const MatrixXd& rows) {
            return work(rows.cast<Complex>() * now.vectors, rows * now.shift);
        };
        const auto bySeparation = [&](const FilmInPieces::Force& force) {
            const Eigen::RowVectorXd& row = film_.separation().row;
            return work(force.slope.cast<Complex>() * (row.cast<Complex>() * now.vectors),
                        force.atRest + force.slope * row.dot(now.shift));
        };
        result_->energies.air += byState(film_.filmForce());
        result_->energies.suspension += byState(film_.suspensionForce());
        if (now.contact.slope.size() == 0) return;
        result_->energies.contact += bySeparation(now.contact);
        result_->energies.friction += bySeparation(now.friction);
    }

    const BouncingFilm& slider_;
    NearbySpacing near_;
    double tangent_ = 0.0; // largest error of the separation, as that of a tangent [m]
    const ReturnRequest* request_ = nullptr;
    Return* result_ = nullptr;
    BouncingWatch* watch_ = nullptr;
    bool watched_ = true;                  // false: the watch has ended the motion
    int switches_ = 0;                     // since counted_
    double counted_ = 0.0;                 // [s]
    double size_ = 0.0;                    // of the motion [-]
    double squares_ = 0.0, fourths_ = 0.0; // integrals of size^2, size^4 [s]
    double rateBefore_ = 0.0;              // of the separation [m/s]
};

VectorXd BouncingFilm::unitsOf(const FilmInPieces& film)
{
    const Index n = film.positions(), memory = film.size() - 2 * n;
    VectorXd units = VectorXd::Constant(film.size(), film.gap());
    units.segment(n, n) *= FilmInPieces::rateUnit * film.fastestRate();
    // Together they count as much as the positions.
    units.tail(memory) *= std::sqrt(std::max(1.0, static_cast<double>(memory) / static_cast<double>(n)));
    return units;
}

BouncingFilm::BouncingFilm(std::shared_ptr<const FilmInPieces> film, const Case& c, int start, VectorXd units)
    : film_(std::move(film)),
      units_(std::move(units)),
      touchDown_(characteristic(c).value().touchDown),
      limit_(c.film.linearLimit),
      cycleWork_(touchdown::cycleWork(c).value())
{
    const FilmInPieces& pieces = *film_;
    double fastest = 0.0;
    for (const FilmInPieces::Region& region : pieces.regions())
        for (const Complex rate : region.rates)
            if (std::abs(rate.imag()) > std::abs(rate.real())) fastest = std::max(fastest, std::abs(rate));
    shortestPeriod_ = 2.0 * std::numbers::pi / fastest;
    pieces.separation().row.head(pieces.positions()).cwiseAbs().maxCoeff(&held_);

    auto [u, w] = pieces.startOf(c);
    // Where the static state is in contact, a run starts on its branch.
    const bool touches = pieces.regions()[pieces.atRest()].name != ContactRegion::Apart;
    const bool takesOff =
        (touches && c.initial.state == InitialState::Static) || c.initial.branch == ContactBranch::TakeOff;
    std::size_t before = pieces.placeOf(takesOff ? ContactRegion::Pressed : ContactRegion::Apart);
    if (start > 0) {
        const double takeOff = characteristic(c).value().takeOff;
        const double first = valueAt(pieces.separation(), pieces.settledAt(u, w));
        const double height = takeOff + (std::max(first, 2.0 * takeOff) - takeOff) * std::pow(10.0, -start);
        u.setZero();
        w.setZero();
        u[0] = height - pieces.restSpacing(); // all corners
        before = pieces.placeOf(ContactRegion::Apart);
    }
    start_ = pieces.settledAt(u, w);
    startRegion_ = pieces.regionFrom(before, start_);
}

double BouncingFilm::startHeight() const { return valueAt(film_->flyingHeight(), start_); }

std::string BouncingFilm::nameOf(const CycleSwitch& of) const
{
    return switchName(of.before.contact, of.after.contact);
}

VectorXd BouncingFilm::coordinates(const VectorXd& y) const
{
    const VectorXd all = y.cwiseQuotient(units_);
    VectorXd x(all.size() - 1);
    x << all.head(held_), all.tail(all.size() - 1 - held_);
    return x;
}

VectorXd BouncingFilm::state(const VectorXd& x) const
{
    VectorXd y = VectorXd::Zero(units_.size());
    y.head(held_) = x.head(held_);
    y.tail(y.size() - 1 - held_) = x.tail(x.size() - held_);
    y = y.cwiseProduct(units_).eval();
    const FilmInPieces::Reading& reading = film_->separation();
    y[held_] = (touchDown_ - valueAt(reading, y)) / reading.row[held_];
    return y;
}

Return BouncingFilm::apply(const VectorXd& x, const ReturnRequest& request) const
{
    Return result;
    if (!x.allFinite()) return result;
    const VectorXd y = state(x);
    const std::size_t pressed = film_->placeOf(ContactRegion::Pressed);
    const FilmInPieces::Region& region = film_->regions()[pressed];
    if (!(film_->separation().row.dot(region.a * y + region.b) < 0.0)) return result; // crossed downwards
    Way(*this, y, pressed, request.derivative).follow(request, result);
    if (!result.returned || !request.derivative) return result;
    const Index n = x.size();
    MatrixXd embed(n + 1, n), reached(n, n);
    const VectorXd zero = state(VectorXd::Zero(n));
    for (Index k = 0; k < n; ++k) embed.col(k) = state(VectorXd::Unit(n, k)) - zero;
    const MatrixXd moved = result.derivative * embed;
    for (Index k = 0; k < n; ++k) reached.col(k) = coordinates(moved.col(k));
    result.derivative = reached;
    return result;
}

LongMotion BouncingFilm::run(const std::optional<VectorXd>& from, double duration, double /*tolerance*/,
                             BouncingWatch& watch) const
{
    const std::size_t region = from ? film_->placeOf(ContactRegion::Pressed) : startRegion_;
    return Way(*this, from ? state(*from) : start_, region, false).watch(duration, watch);
}

namespace {

/// The film of a study, and the pieces of the last few cases that were asked for.
class FilmsOfStudy {
public:
    explicit FilmsOfStudy(const Case& c) : still_(FilmInPieces::stillCase(c)) {}

    std::shared_ptr<const BouncingSlider> of(const Case& c, int start, const GoOn& goOn)
    {
        const std::shared_ptr<const FilmInPieces> film = piecesOf(FilmInPieces::stillCase(c), goOn);
        return film ? std::make_shared<const BouncingFilm>(film, c, start, units_) : nullptr;
    }

private:
    std::shared_ptr<const FilmInPieces> piecesOf(const Case& c, const GoOn& goOn)
    {
        const std::lock_guard lock(mutex_);
        if (!problem_.empty()) throw std::runtime_error(problem_);
        if (!first_ && !make(goOn)) return nullptr;
        if (c == still_) return first_;
        const auto known = std::ranges::find(kept_, c, &Kept::c);
        if (known != kept_.end()) return known->film;
        kept_.push_back({c, std::make_shared<const FilmInPieces>(*scene_, still_, c, first_.get())});
        if (kept_.size() > keptFilms) kept_.pop_front();
        return kept_.back().film;
    }

    /// False where it is stopped.
    bool make(const GoOn& goOn)
    {
        const TeamScope team(filmThreads(still_));
        scene_ = std::make_unique<FilmScene>(still_);
        switch (scene_->prepare([&] { return !goOn || goOn(); })) {
        case FilmScene::State::Stopped: return false;
        case FilmScene::State::Failed: throw std::runtime_error(problem_ = scene_->message);
        case FilmScene::State::Ready: break;
        }
        first_ = std::make_shared<const FilmInPieces>(*scene_, still_);
        units_ = BouncingFilm::unitsOf(*first_);
        return true;
    }

    struct Kept {
        Case c;
        std::shared_ptr<const FilmInPieces> film;
    };
    Case still_;
    std::mutex mutex_; // of all below
    std::unique_ptr<FilmScene> scene_;
    std::shared_ptr<const FilmInPieces> first_;
    std::string problem_; // why there is none
    VectorXd units_;
    std::deque<Kept> kept_;
};

} // namespace

SliderOf filmsLike(const Case& c)
{
    return [films = std::make_shared<FilmsOfStudy>(c)](const Case& at, int start, const GoOn& goOn) {
        return films->of(at, start, goOn);
    };
}

} // namespace touchdown

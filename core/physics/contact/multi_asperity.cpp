// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/contact/multi_asperity.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

namespace touchdown {

namespace {

/// Heights beyond this many deviations count as none, as in core/physics/contact/asperity_contact.h.
constexpr double farthest = 9.0;

/// Pieces of the way in the folding zone, in deviations; shallower folds are none.
constexpr double piece = 1.0 / 16.0;

double normal(double x)
{
    return std::abs(x) < farthest ? std::exp(-0.5 * x * x) / std::sqrt(2.0 * std::numbers::pi) : 0.0;
}

} // namespace

/// What happens while s moves one way from a state: d as a function of s alone.
struct MultiAsperity::Path {
    const MultiAsperity& model;
    MultiAsperityState from;
    PadMotion motion;

    double sign() const { return motion == PadMotion::Away ? 1.0 : -1.0; }
    /// What s drags zeta by.
    double lag() const { return motion == PadMotion::Away ? model.bridge_ : model.film_; }
    /// Where s begins to drag zeta.
    double bend() const { return from.wettedAbove + lag(); }
    bool drags(double s) const { return sign() * (s - bend()) >= 0.0; }
    double wettedAbove(double s) const { return drags(s) ? s - lag() : from.wettedAbove; }
    MultiAsperityState state(double s) const { return {s, wettedAbove(s)}; }
    double padSeparation(double s) const { return model.padSeparation(state(s)); }

    /// -F_cr'(s), and F_m'(s) on the side of s that lies ahead.
    double pressing(double s) const { return model.area_ * model.contact_.stiffness(s); }
    double gathering(double s) const
    {
        return drags(s) ? model.meniscusForce_ * normal((s - lag() - model.planeHeight_) / model.sigma_) / model.sigma_
                        : 0.0;
    }
    /// d'(s) = 1 - (F_cr' + F_m')/k_b.
    double slope(double s) const { return 1.0 + (pressing(s) - gathering(s)) / model.bulkStiffness_; }

    /// |zeta - y_s| <= this [m] where d'(s) may be negative: phi((zeta - y_s)/sigma_s) > sigma_s k_b/max |F_m|.
    double foldingHeight() const
    {
        const double peak =
            model.meniscusForce_ / (std::sqrt(2.0 * std::numbers::pi) * model.sigma_ * model.bulkStiffness_);
        return peak > 1.0 ? std::min(farthest, std::sqrt(2.0 * std::log(peak))) * model.sigma_ : 0.0;
    }

    /// Calls visit(a, b) with the pieces of the way ahead up to `end`, in order, until it returns true. Pieces end at
    /// the bend; in the folding zone they are so short that d'(s) has at most one zero, except in shallow folds.
    template <typename Visit>
    void walk(double end, Visit visit) const;

    /// Where d'(s) becomes negative between a and b: a minimum of d on the way in, a maximum on the way out.
    double fold(double a, double b) const
    {
        for (int i = 0; i < 200; ++i) {
            const double middle = 0.5 * (a + b);
            if (middle == a || middle == b) break;
            (slope(middle) >= 0.0 ? a : b) = middle;
        }
        return a;
    }

    /// s between a and b, where d passes `target`: Newton, halving where it leaves the bracket.
    double meet(double a, double b, double target) const;
    /// An s ahead by which d has come to `target`.
    double end(double target) const;
    bool reached(double s, double target) const { return sign() * (padSeparation(s) - target) >= 0.0; }
    /// The first s ahead where d has come to `target`.
    double firstMeeting(double target) const;
    /// Where s lands after a fold at the path's start: d turns back there and comes again.
    double landing() const;
};

template <typename Visit>
void MultiAsperity::Path::walk(double end, Visit visit) const
{
    const double zone = foldingHeight();
    // The zone's near and far end in s, beyond the bend.
    const double near = model.planeHeight_ + lag() - sign() * zone;
    const double far = model.planeHeight_ + lag() + sign() * zone;
    const double step = sign() * piece * model.sigma_;
    const auto ahead = [&](double x, double y) { return sign() * (x - y) > 0.0; };
    double s = from.separation;
    while (ahead(end, s)) {
        double next = end;
        const auto shorten = [&](double place) {
            if (ahead(place, s) && ahead(next, place)) next = place;
        };
        shorten(bend());
        shorten(near);
        shorten(far);
        if (drags(s) && !ahead(near, s) && ahead(far, s)) shorten(s + step);
        if (visit(s, next)) return;
        s = next;
    }
}

double MultiAsperity::Path::meet(double a, double b, double target) const
{
    double s = a + (target - padSeparation(a)) / std::max(slope(a), 1e-3);
    if (!((s - a) * (s - b) < 0.0)) s = b;
    for (int i = 0; i < 200; ++i) {
        const double excess = sign() * (padSeparation(s) - target);
        (excess < 0.0 ? a : b) = s;
        const double rate = slope(s);
        double next = s - sign() * excess / rate;
        if (!(rate > 0.0) || (next - a) * (next - b) >= 0.0) next = 0.5 * (a + b);
        const double moved = std::abs(next - s);
        s = next;
        if (moved <= 1e-15 * model.sigma_ || moved <= 2.0 * std::numeric_limits<double>::epsilon() * std::abs(s)) break;
    }
    return s;
}

double MultiAsperity::Path::end(double target) const
{
    // F_m never exceeds the largest adhesion; F_cr at any s > d is at most its value at s = d.
    const double margin = model.sigma_ + 1e-9 * std::abs(target); // against rounding
    return motion == PadMotion::Away
               ? target + model.area_ * model.contact_.pressure(target) / model.bulkStiffness_ + margin
               : target - model.meniscusForce_ / model.bulkStiffness_ - margin;
}

double MultiAsperity::Path::firstMeeting(double target) const
{
    double found = from.separation;
    walk(end(target), [&](double a, double b) {
        found = b;
        if (slope(a) > 0.0 && slope(b) < 0.0) {
            const double turn = fold(a, b);
            if (reached(turn, target)) {
                found = meet(a, turn, target);
                return true;
            }
        }
        if (!reached(b, target)) return false;
        found = meet(a, b, target);
        return true;
    });
    return found;
}

double MultiAsperity::Path::landing() const
{
    const double target = padSeparation(from.separation);
    double found = from.separation;
    walk(end(target), [&](double a, double b) {
        found = b;
        if (slope(b) < 0.0 || !reached(b, target)) return false;
        found = meet(a, b, target);
        return true;
    });
    return found;
}

MultiAsperity::MultiAsperity(const Asperities& asperities, const Meniscus& meniscus, const ElasticPair& pair,
                             double padArea)
    : contact_(asperities, pair),
      sigma_(asperities.heightDeviation),
      film_(meniscus.filmThickness),
      bridge_(meniscus.breakingLength),
      planeHeight_(asperities.planeHeight),
      area_(padArea),
      density_(asperities.density)
{
    assert(padArea > 0.0 && film_ >= 0.0 && bridge_ >= film_ && meniscus.surfaceTension >= 0.0);
    // Mean distance of the points of a unit square, inverted: 4 [ln(1 + sqrt 2) - (sqrt 2 - 1)/3]; u = p sqrt(A)/(pi
    // E*) times it (Love 1929; Johnson 1985, section 3.3). A circle is 1.2 % softer, 3 pi^(3/2)/16 = 1.0441 (Johnson,
    // equation 3.29).
    const double square = 4.0 * (std::log(1.0 + std::numbers::sqrt2) - (std::numbers::sqrt2 - 1.0) / 3.0);
    bulkStiffness_ = std::numbers::pi / square * contactModulus(pair) * std::sqrt(padArea);
    const double oneMeniscus =
        2.0 * std::numbers::pi * asperities.radius * meniscus.surfaceTension * (1.0 + std::cos(meniscus.contactAngle));
    meniscusForce_ = density_ * padArea * oneMeniscus;
}

double MultiAsperity::wettedShare(double wettedAbove) const
{
    // As many lie above a height as touch a pad there.
    return contact_.contactDensity(wettedAbove) / density_;
}

MultiAsperityForces MultiAsperity::forces(const MultiAsperityState& state) const
{
    MultiAsperityForces f;
    f.contact = area_ * contact_.pressure(state.separation);
    const double wetted = wettedShare(state.wettedAbove);
    f.adhesion = -meniscusForce_ * wetted;
    f.contactArea = area_ * contact_.contactArea(state.separation);
    f.contacts = area_ * contact_.contactDensity(state.separation);
    f.menisci = area_ * density_ * wetted;
    f.storedEnergy = area_ * contact_.energy(state.separation) + 0.5 * f.total() * f.total() / bulkStiffness_;
    return f;
}

double MultiAsperity::padSeparation(const MultiAsperityState& state) const
{
    const double adhesion = meniscusForce_ * wettedShare(state.wettedAbove);
    return state.separation - (area_ * contact_.pressure(state.separation) - adhesion) / bulkStiffness_;
}

MultiAsperitySlopes MultiAsperity::slopes(const MultiAsperityState& state, PadMotion motion) const
{
    const Path path{*this, state, motion};
    const double slope = path.slope(state.separation);
    return {-path.pressing(state.separation) / slope, path.gathering(state.separation) / slope};
}

double MultiAsperity::reach() const
{
    return planeHeight_ + bridge_ + farthest * sigma_ + meniscusForce_ / bulkStiffness_;
}

MultiAsperityState MultiAsperity::start(double padSeparation) const
{
    const double s = std::max(padSeparation, reach());
    return advance({s, s - film_}, padSeparation);
}

MultiAsperityState MultiAsperity::advance(const MultiAsperityState& state, double padSeparation) const
{
    const double now = this->padSeparation(state);
    if (padSeparation == now) return state;
    const Path path{*this, state, padSeparation > now ? PadMotion::Away : PadMotion::Towards};
    return path.state(path.firstMeeting(padSeparation));
}

std::optional<MultiAsperityJump> MultiAsperity::nextJump(const MultiAsperityState& state, PadMotion motion) const
{
    const Path path{*this, state, motion};
    const double zone = path.foldingHeight();
    if (zone == 0.0) return std::nullopt;
    std::optional<MultiAsperityJump> jump;
    path.walk(planeHeight_ + path.lag() + path.sign() * zone, [&](double a, double b) {
        if (!(path.slope(a) > 0.0 && path.slope(b) < 0.0)) return false;
        const MultiAsperityState turn = path.state(path.fold(a, b));
        const Path beyond{*this, turn, motion};
        const double landing = beyond.landing();
        if (std::abs(landing - turn.separation) < piece * sigma_) return false;
        jump = {path.padSeparation(turn.separation), turn, beyond.state(landing)};
        return true;
    });
    return jump;
}

double MultiAsperity::lostIn(const MultiAsperityJump& jump) const
{
    // Out of balance by F_c - k_b (s - d), which is k_b (d - d(s)). Midpoint rule.
    constexpr int pieces = 400;
    const double from = jump.from.separation;
    const double width = (jump.to.separation - from) / pieces;
    const Path path{*this, jump.from, width < 0.0 ? PadMotion::Towards : PadMotion::Away};
    double lost = 0.0;
    for (int i = 0; i < pieces; ++i)
        lost += bulkStiffness_ * (jump.padSeparation - path.padSeparation(from + (i + 0.5) * width)) * width;
    return lost;
}

MultiAsperityCurve multiAsperityCurve(const MultiAsperity& model, double start, double closest, int points)
{
    assert(start > closest && points > 1);
    MultiAsperityCurve curve;
    MultiAsperityState state = model.start(start);
    const auto follow = [&](double from, double to, std::vector<MultiAsperityPoint>& way,
                            std::vector<MultiAsperityJump>& jumps) {
        const PadMotion motion = to < from ? PadMotion::Towards : PadMotion::Away;
        const auto passed = [&](double place, double d) {
            return motion == PadMotion::Towards ? d < place : d > place;
        };
        const auto add = [&](double d) { way.push_back({d, state, model.forces(state)}); };
        auto jump = model.nextJump(state, motion);
        for (int i = 0; i < points; ++i) {
            const double d = i + 1 == points ? to : from + (to - from) * i / (points - 1);
            for (; jump && passed(jump->padSeparation, d); jump = model.nextJump(state, motion)) {
                state = jump->from;
                add(jump->padSeparation);
                state = jump->to;
                add(jump->padSeparation);
                jumps.push_back(*jump);
                curve.lostInJumps += model.lostIn(*jump);
            }
            state = model.advance(state, d);
            add(d);
        }
    };
    follow(start, closest, curve.towards, curve.touchDowns);
    follow(closest, start, curve.away, curve.takeOffs);

    for (const auto* way : {&curve.towards, &curve.away}) {
        for (std::size_t i = 1; i < way->size(); ++i) {
            const MultiAsperityPoint& a = (*way)[i - 1];
            const MultiAsperityPoint& b = (*way)[i];
            curve.work -= 0.5 * (a.forces.total() + b.forces.total()) * (b.padSeparation - a.padSeparation);
        }
    }
    return curve;
}

} // namespace touchdown

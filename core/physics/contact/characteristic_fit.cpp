// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/contact/characteristic_fit.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/physics/contact/contact_message.h"
#include "core/physics/contact/multi_asperity.h"

namespace touchdown {

namespace {

constexpr int samplesEachWay = 801;
constexpr double allowed = 0.1; // of the scale, see the header
constexpr double barely = 1e-3; // share of the summits, below which the pad has not been there

/// Largest |F_m| and F_cr on the way: what errors are measured against.
struct Scales {
    double contact = 0.0, adhesion = 0.0; // [N]
};

Scales scalesOf(const MultiAsperityCurve& curve)
{
    Scales scales;
    for (const auto* way : {&curve.towards, &curve.away}) {
        for (const MultiAsperityPoint& point : *way) {
            scales.contact = std::max(scales.contact, point.forces.contact);
            scales.adhesion = std::max(scales.adhesion, -point.forces.adhesion);
        }
    }
    return scales;
}

/// The jump with the largest change of F_m, or where |F_m| first passes half its largest value, or `otherwise`.
double turningPlace(const MultiAsperity& model, const std::vector<MultiAsperityJump>& jumps,
                    const std::vector<MultiAsperityPoint>& way, double largest, double otherwise)
{
    double place = otherwise, change = 0.0;
    for (const MultiAsperityJump& jump : jumps) {
        const double by = std::abs(model.forces(jump.to).adhesion - model.forces(jump.from).adhesion);
        if (by > change) {
            change = by;
            place = jump.padSeparation;
        }
    }
    if (change > 0.0) return place;
    for (std::size_t i = 1; i < way.size(); ++i) {
        const double a = -way[i - 1].forces.adhesion - 0.5 * largest;
        const double b = -way[i].forces.adhesion - 0.5 * largest;
        if (a * b > 0.0 || a == b) continue;
        return way[i - 1].padSeparation + (way[i].padSeparation - way[i - 1].padSeparation) * a / (a - b);
    }
    return place;
}

/// F_cr = f_c0 + k_c (d_s - d) by least squares over d <= d_s; neither is negative.
void fitContact(const MultiAsperityCurve& curve, OnoYamane& p)
{
    double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    const auto take = [&](const std::vector<MultiAsperityPoint>& way, std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const double depth = p.touchDown - way[i].padSeparation;
            n += 1.0;
            x += depth;
            y += way[i].forces.contact;
            xx += depth * depth;
            xy += depth * way[i].forces.contact;
        }
    };
    // On the way in what lies at d_s itself counts after its jump.
    std::size_t first = curve.towards.size();
    while (first > 0 && curve.towards[first - 1].padSeparation <= p.touchDown) --first;
    if (first + 1 < curve.towards.size() &&
        curve.towards[first].padSeparation == curve.towards[first + 1].padSeparation)
        ++first;
    std::size_t last = 0;
    while (last < curve.away.size() && curve.away[last].padSeparation <= p.touchDown) ++last;
    take(curve.towards, first, curve.towards.size());
    take(curve.away, 0, last);

    const double spread = n * xx - x * x;
    const double slope = spread > 0.0 ? (n * xy - x * y) / spread : 0.0;
    p.contactStiffness = std::max(0.0, slope);
    p.initialContactForce = n > 0.0 ? (y - p.contactStiffness * x) / n : 0.0;
    if (p.initialContactForce < 0.0) { // the best line through no force at d_s
        p.initialContactForce = 0.0;
        p.contactStiffness = xx > 0.0 ? std::max(0.0, xy / xx) : 0.0;
    }
}

/// Which way the law goes through its jump at a point that lies exactly on one: as the model does.
ContactRegion regionAt(const OnoYamaneLaw& law, const OnoYamane& p, bool inwards,
                       const std::vector<MultiAsperityPoint>& way, std::size_t i)
{
    const double d = way[i].padSeparation;
    const bool before = i + 1 < way.size() && way[i + 1].padSeparation == d;
    if (inwards) {
        if (before && d == p.touchDown) return ContactRegion::Apart;
        return law.region(ContactBranch::TouchDown, d);
    }
    if (before && d == p.takeOff) return law.region(ContactBranch::TakeOff, std::nextafter(d, -1.0));
    return law.region(ContactBranch::TakeOff, d);
}

struct Errors {
    CharacteristicError contact, adhesion;
    double meanSquare() const { return contact.rms * contact.rms + adhesion.rms * adhesion.rms; }
};

Errors compare(const MultiAsperityCurve& curve, const OnoYamane& p, const Scales& scales)
{
    const OnoYamaneLaw law(p);
    Errors errors;
    double count = 0.0;
    const auto add = [](CharacteristicError& error, double by, double d) {
        error.rms += by * by;
        if (std::abs(by) <= error.worst) return;
        error.worst = std::abs(by);
        error.at = d;
    };
    for (const bool inwards : {true, false}) {
        const auto& way = inwards ? curve.towards : curve.away;
        for (std::size_t i = 0; i < way.size(); ++i) {
            const double d = way[i].padSeparation;
            const ContactRegion region = regionAt(law, p, inwards, way, i);
            if (scales.contact > 0.0)
                add(errors.contact, (law.contactForce(region, d) - way[i].forces.contact) / scales.contact, d);
            if (scales.adhesion > 0.0)
                add(errors.adhesion, (law.adhesionForce(region, d) - way[i].forces.adhesion) / scales.adhesion, d);
            count += 1.0;
        }
    }
    errors.contact.rms = std::sqrt(errors.contact.rms / count);
    errors.adhesion.rms = std::sqrt(errors.adhesion.rms / count);
    return errors;
}

std::string nanometres(double length) { return sentence("%.3g nm", 1e9 * length); }
std::string percent(double share) { return sentence("%.1f %%", 100.0 * share); }

/// How far d goes while |F_m| goes from a tenth to nine tenths of its largest value [m].
double spreadOfAdhesion(const std::vector<MultiAsperityPoint>& way, double largest)
{
    double lower = way.front().padSeparation, upper = lower;
    bool begun = false;
    for (const MultiAsperityPoint& point : way) {
        const double share = -point.forces.adhesion / largest;
        if (share < 0.1 || share > 0.9) continue;
        if (!begun) lower = upper = point.padSeparation;
        begun = true;
        lower = std::min(lower, point.padSeparation);
        upper = std::max(upper, point.padSeparation);
    }
    return upper - lower;
}

/// What the five parameters cannot say.
std::vector<std::string> shortcomings(const CharacteristicFit& fit, const MultiAsperityCurve& curve,
                                      const Scales& scales)
{
    std::vector<std::string> found;
    if (fit.adhesion.worst > allowed) {
        if (curve.touchDowns.empty()) {
            found.push_back("menisci gather gradually, over " +
                            nanometres(spreadOfAdhesion(curve.towards, scales.adhesion)) +
                            ", without a jump at touch-down");
        }
        if (curve.takeOffs.empty()) {
            found.push_back("they break gradually, over " + nanometres(spreadOfAdhesion(curve.away, scales.adhesion)) +
                            ", without a jump at take-off");
        }
        found.push_back("F_m is off by " + percent(fit.adhesion.worst) + " of its largest value at " +
                        nanometres(fit.adhesion.at));
    }
    if (fit.contact.worst > allowed) {
        found.push_back("F_cr is no straight line: off by " + percent(fit.contact.worst) + " of its largest value at " +
                        nanometres(fit.contact.at));
    }
    return found;
}

/// Sets `describes` and `message`.
void judge(CharacteristicFit& fit, const MultiAsperity& model, const MultiAsperityCurve& curve, const Scales& scales)
{
    const double deepest = curve.away.front().padSeparation;
    const MultiAsperityForces& forces = curve.away.front().forces;
    const double summits = model.padArea() * model.summitDensity();
    const std::string nearest = "The pad comes no nearer than " + nanometres(deepest);
    if (std::max(forces.menisci, forces.contacts) < barely * summits) {
        fit.message = nearest + " and touches next to nothing: it must go deeper.";
        return;
    }
    if (const auto ahead = model.nextJump(curve.away.front().state, PadMotion::Towards)) {
        fit.message = nearest + ", but touches down at " + nanometres(ahead->padSeparation) + ": it must go deeper.";
        return;
    }
    if (model.largestAdhesion() == 0.0) {
        fit.message =
            "There is no adhesion, so no touch-down and no take-off: the five parameters do not describe the model.";
        return;
    }
    const std::vector<std::string> reasons = shortcomings(fit, curve, scales);
    fit.describes = reasons.empty();
    if (fit.describes) {
        fit.message = "The five parameters describe the model: F_cr within " + percent(fit.contact.worst) +
                      " of its largest value, F_m within " + percent(fit.adhesion.worst) + ".";
        return;
    }
    fit.message = "The five parameters do not describe the model: ";
    for (std::size_t i = 0; i < reasons.size(); ++i) fit.message += (i > 0 ? "; " : "") + reasons[i];
    fit.message += ".";
}

} // namespace

CharacteristicFit fitCharacteristic(const MultiAsperity& model, double start, double closest, const OnoYamane& rest)
{
    const MultiAsperityCurve curve = multiAsperityCurve(model, std::max(start, model.reach()), closest, samplesEachWay);
    const Scales scales = scalesOf(curve);

    CharacteristicFit fit;
    OnoYamane& p = fit.parameters;
    p = rest;
    p.meniscusForce = scales.adhesion;
    p.touchDown = turningPlace(model, curve.touchDowns, curve.towards, scales.adhesion, closest);
    p.takeOff = std::max(p.touchDown, turningPlace(model, curve.takeOffs, curve.away, scales.adhesion, closest));
    fitContact(curve, p);
    Errors best;
    const OnoYamane found = p;
    for (const TakeOffShape shape : {TakeOffShape::Constant, TakeOffShape::Linear, TakeOffShape::BothLinear}) {
        OnoYamane trial = found;
        trial.takeOffShape = shape;
        if (trial.takeOff > trial.touchDown) trial.meniscusForce = meniscusForceForWork(trial, curve.work);
        const Errors errors = compare(curve, trial, scales);
        if (shape == TakeOffShape::Constant || errors.meanSquare() < best.meanSquare()) {
            best = errors;
            p = trial;
        }
    }
    fit.cycleWork = curve.work;
    fit.lostInJumps = curve.lostInJumps;
    fit.contact = best.contact;
    fit.adhesion = best.adhesion;
    judge(fit, model, curve, scales);
    return fit;
}

} // namespace touchdown

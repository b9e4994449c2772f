// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/stability/stability_curves.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "core/formats/units.h"

namespace touchdown {

namespace {

using Complex = std::complex<double>;

constexpr double highestGrowth = 3.0;                 // that is drawn
constexpr double leastPhase = 0.01, mostPhase = 10.0; // omega h, at which it is drawn [-]
constexpr int pointsPerDecade = 60;

/// The least over all motions, and where it is found.
struct Limit {
    double step = std::numeric_limits<double>::infinity(); // [s]
    const LocalMotion* motion = nullptr;
};
Limit limitOf(const LinearMethod& method, const std::vector<LocalMotion>& motions)
{
    Limit limit;
    for (const LocalMotion& motion : motions)
        if (const double step = largestStableStep(method.growth, motion); step < limit.step) limit = {step, &motion};
    return limit;
}

Complex fastestRate(const LocalMotion& motion)
{
    return *std::ranges::max_element(motion.rates, {}, [](Complex rate) { return std::abs(rate); });
}

/// Of a line that goes from the upper half of the plane into the lower one.
std::span<const Complex> upperPart(const std::vector<Complex>& line)
{
    constexpr double axis = -1e-6;
    const auto end = std::ranges::find_if(line, [](Complex z) { return z.imag() < axis; });
    return {line.begin(), end};
}

/// All bounded regions, whatever their size up to a bound, and the eigenvalues; a little more.
PlaneWindow frameOf(const std::vector<LinearMethod>& methods, const std::vector<LocalMotion>& motions, double step)
{
    constexpr PlaneWindow wide{.left = -12.0, .right = 12.0, .height = 12.0, .columns = 480};
    constexpr double margin = 0.04;
    PlaneWindow frame{.left = 0.0, .right = 0.0, .height = 0.0};
    const auto include = [&](Complex z) {
        frame.left = std::min(frame.left, z.real());
        frame.right = std::max(frame.right, z.real());
        frame.height = std::max(frame.height, z.imag());
    };
    for (const LinearMethod& method : methods)
        for (const std::vector<Complex>& line : stabilityBoundary(method.growth, wide))
            if (std::abs(line.front() - line.back()) < 1e-6)
                for (const Complex z : line) include(z);
    for (const LocalMotion& motion : motions)
        for (const Complex rate : motion.rates) include(step * rate);
    const double size = margin * std::max(frame.right - frame.left, frame.height);
    frame.left -= size;
    frame.right += size;
    frame.height += size;
    return frame;
}

} // namespace

double LocalMotion::fastest() const
{
    double most = 0.0;
    for (const Complex rate : rates) most = std::max(most, std::abs(rate));
    return most;
}

double largestStableStep(const std::function<double(Complex)>& growth, const LocalMotion& motion)
{
    constexpr double shortest = 1e-4, longest = 1e4; // |lambda| h
    double least = std::numeric_limits<double>::infinity();
    for (const Complex rate : motion.rates) {
        const double size = std::abs(rate);
        if (size == 0.0 || rate.real() > 1e-9 * size) continue;
        const Complex direction(std::min(0.0, rate.real() / size), rate.imag() / size);
        const double z =
            largestStable([&](double h) { return growth(h * direction) <= stableGrowth; }, shortest, longest);
        if (z < longest) least = std::min(least, z / size);
    }
    return least;
}

double dampingRatio(const LocalMotion& motion)
{
    const Complex rate = fastestRate(motion);
    return std::abs(rate) > 0.0 ? -rate.real() / std::abs(rate) : 0.0;
}

ChartPanel regionPanel(const std::vector<LinearMethod>& methods, const std::vector<LocalMotion>& motions, double step)
{
    ChartPanel panel;
    panel.x = {.label = "Re lambda h"};
    panel.y = {.label = "Im lambda h"};
    panel.equalScales = true;
    const PlaneWindow window = frameOf(methods, motions, step);
    for (const LinearMethod& method : methods)
        for (const std::vector<Complex>& line : stabilityBoundary(method.growth, window)) {
            ChartSeries series{.name = method.name, .markers = false};
            for (const Complex z : upperPart(line))
                series.points.push_back({.x = z.real(), .y = std::max(0.0, z.imag())});
            if (!series.points.empty()) panel.series.push_back(std::move(series));
        }
    for (const LocalMotion& motion : motions) {
        ChartSeries& series = panel.series.emplace_back(ChartSeries{.name = motion.where, .line = ChartLine::None});
        for (const Complex rate : motion.rates)
            series.points.push_back({.x = step * rate.real(), .y = step * rate.imag()});
    }
    return panel;
}

void addGrowth(ChartPanel& panel, const std::string& name, const std::function<double(double)>& growth)
{
    ChartSeries& series = panel.series.emplace_back();
    series.name = name;
    series.markers = false;
    const int count = static_cast<int>(std::lround(pointsPerDecade * std::log10(mostPhase / leastPhase)));
    for (int k = 0; k <= count; ++k) {
        const double w = leastPhase * std::pow(mostPhase / leastPhase, double(k) / count), value = growth(w);
        if (value <= highestGrowth)
            series.points.push_back({.x = w, .y = value});
        else if (!series.points.empty())
            break; // what comes back further out is of no use to anybody
    }
}

ChartPanel growthPanel(const std::vector<LinearMethod>& methods, double damping,
                       const std::vector<LocalMotion>& motions, double step)
{
    ChartPanel panel;
    panel.x = {.label = "Angular frequency times step", .logarithmic = true};
    panel.y = {.label = "Growth in a step"};
    panel.bands.push_back({.alongX = false, .lower = 1.0, .upper = 1.0, .label = "stable up to here"});
    const Complex direction(-damping, std::sqrt(std::max(0.0, 1.0 - damping * damping)));
    for (const LinearMethod& method : methods)
        addGrowth(panel, method.name, [&](double w) { return method.growth(w * direction); });
    for (const LocalMotion& motion : motions)
        if (const double w = step * motion.fastest(); w > 0.0)
            panel.bands.push_back({.alongX = true, .lower = w, .upper = w, .label = motion.where});
    return panel;
}

StudyTable limitTable(const std::vector<LinearMethod>& methods, const std::vector<LocalMotion>& motions, double step)
{
    StudyTable table{"step_limits",
                     {{"method"},
                      {"where"},
                      {"largest_stable_step", "s", "ns", "Largest stable step"},
                      {"case_step", "s", "ns", "Step of the case"},
                      {"share", "", "", "Step of the case against the largest stable one"}}};
    for (const LinearMethod& method : methods)
        for (const LocalMotion& motion : motions) {
            const double limit = largestStableStep(method.growth, motion);
            const bool finite = std::isfinite(limit);
            table.rows.push_back({method.name, motion.where, known(finite, limit), step, known(finite, step / limit)});
        }
    return table;
}

StudyTable eigenvalueTable(const std::vector<LocalMotion>& motions)
{
    StudyTable table{"eigenvalues",
                     {{"where"},
                      {"real", "1/s", "1/us", "Real part"},
                      {"imaginary", "1/s", "1/us", "Imaginary part"},
                      {"frequency", "Hz", "kHz", "Frequency"},
                      {"damping_ratio", "", "", "Damping ratio"}}};
    for (const LocalMotion& motion : motions)
        for (const Complex rate : motion.rates) {
            const double size = std::abs(rate);
            table.rows.push_back({motion.where, rate.real(), rate.imag(), rate.imag() / (2.0 * std::numbers::pi),
                                  known(size > 0.0, -rate.real() / size)});
        }
    return table;
}

std::string limitSentence(const std::string& subject, double limit, const std::string& first)
{
    const std::string steps = "Steps of " + subject;
    return std::isfinite(limit) ? steps + " are stable up to " + fewDigitsOfTime(limit, 3) +
                                      "; the first unstable motion is the " + first
                                : steps + " are stable however long they are; accuracy alone limits them";
}

std::string motionText(const LocalMotion& motion)
{
    if (motion.isMode) return motion.where;
    return "motion " + motion.where + " (" + fewDigits(motion.fastest() / (2.0 * std::numbers::pi), "kHz", 3) + ")";
}

void tellLimits(const std::vector<LinearMethod>& methods, const std::vector<LocalMotion>& motions, const CaseStep& step,
                StudyReport& picture)
{
    std::string unlimited;
    for (const LinearMethod& method : methods) {
        const Limit limit = limitOf(method, motions);
        if (limit.motion == nullptr) {
            unlimited += (unlimited.empty() ? "" : ", ") + method.sentence;
            continue;
        }
        std::string sentence = limitSentence(method.sentence, limit.step, motionText(*limit.motion));
        if (method.isTheCases) {
            sentence += "; this case takes " + step.text;
            if (step.length > limit.step)
                sentence += step.adaptive ? ", shorter ones where it must" : ", which cannot be right";
        }
        picture.findings.push_back(sentence + ".");
    }
    if (!unlimited.empty())
        picture.findings.push_back(limitSentence(unlimited, std::numeric_limits<double>::infinity(), "") + ".");
    for (const LocalMotion& motion : motions)
        if (std::ranges::any_of(motion.rates, [](Complex rate) { return rate.real() > 1e-9 * std::abs(rate); }))
            picture.warnings.push_back("The " + motionText(motion) +
                                       " is unstable in the model itself: no step is short enough for a method to be "
                                       "stable.");
}

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "core/formats/units.h"
#include "core/formats/words.h"
#include "core/studies/cycles/cycles_report.h"

namespace touchdown {

namespace {

constexpr double oneEvent = 1e-4;         // distance of two marks that are one for the reader, of the range [-]
constexpr std::size_t mostThresholds = 4; // in sentences
constexpr double negligibleEnergy = 1e-6; // of the largest part [-]

std::string energyText(double energy) { return fewDigits(energy, "pJ", 3); }

/// "the air takes 3 pJ".
std::string partText(const std::string& what, double energy, double largest)
{
    if (std::abs(energy) <= negligibleEnergy * largest) return what + " neither gives nor takes energy";
    return what + (energy > 0.0 ? " gives " : " takes ") + energyText(std::abs(energy));
}

bool endsOnStableCycle(const BouncingRun& run) { return run.cycle && run.cycle->stable(); }

std::string rangeOf(double least, double most, const std::string& unit)
{
    const std::string first = fewDigits(least, unit, 3), last = fewDigits(most, unit, 3);
    return first == last ? first : first + " to " + last;
}

class CyclesFindings {
public:
    CyclesFindings(const CyclesTask& task, const CyclesResult& result) : task_(task), result_(result) {}

    std::vector<std::string> all()
    {
        const std::vector<ValueRange> ranges = stableRanges(result_.branches);
        if (!ranges.empty())
            addBouncing(ranges);
        else
            addNone();
        std::vector<CycleThreshold> thresholds = thresholdsOf(result_.branches);
        // An end is reported together with the loss of stability just before it.
        std::erase_if(thresholds, [&](const CycleThreshold& each) {
            return each.mark.ends &&
                   std::ranges::any_of(thresholdsOf(result_.branches), [&](const CycleThreshold& other) {
                       const MarkedCycle* end = other.mark.ends ? nullptr : endNear(other);
                       return end != nullptr && other.branch == each.branch && end->point == each.mark.point;
                   });
        });
        for (std::size_t k = 0; k < std::min(thresholds.size(), mostThresholds); ++k) addThreshold(thresholds[k]);
        if (thresholds.size() > mostThresholds)
            say("Stable cycles end at " + std::to_string(thresholds.size() - mostThresholds) +
                " further values; the table special_points lists them");
        addRuns();
        addBalance();
        addFilm();
        return std::move(findings_);
    }

private:
    void say(const std::string& sentence) { findings_.push_back(sentence + "."); }

    std::string wholeRange() const
    {
        return uncapitalized(task_.text.label) + " from " + task_.text.of(task_.from) + " to " +
               task_.text.of(task_.to);
    }

    std::size_t endsOf(BouncingEnd end) const
    {
        return static_cast<std::size_t>(std::ranges::count(result_.runs, end, &BouncingRun::end));
    }

    void addBouncing(const std::vector<ValueRange>& ranges)
    {
        SwingOf frequency, amplitude, work;
        bool friction = false;
        for (const CycleBranch& branch : result_.branches)
            for (const LimitCycle& point : branch.points) {
                if (!point.stable()) continue;
                frequency.add(point.frequency());
                amplitude.add(point.amplitude());
                work.add(point.cycleWork);
                friction = friction || point.energies.friction > negligibleEnergy * point.energies.largest();
            }
        say("Self-excited: for " + uncapitalized(task_.text.label) + " " + text(ranges, task_.text) +
            " the slider can bounce for ever over a flat disk, on a stable cycle of " +
            rangeOf(frequency.least, frequency.most, "kHz") + " and an amplitude of " +
            rangeOf(amplitude.least, amplitude.most, "nm") +
            (work.most < 0.0 ? "; there the contact law creates energy (W < 0), which no real contact does" : "") +
            (friction ? "; friction gives energy to the slider" : ""));
    }

    void addNone()
    {
        const std::size_t runs = result_.runs.size();
        const std::size_t bouncing = endsOf(BouncingEnd::Bounces);
        const std::string at = " for " + wholeRange();
        if (bouncing == 0) {
            say("No sustained bouncing found in " + counted(runs, "run") + at + ": " +
                std::to_string(endsOf(BouncingEnd::Flies)) + " end flying, " +
                std::to_string(endsOf(BouncingEnd::Caught)) + " caught in contact" +
                (endsOf(BouncingEnd::Unknown) > 0
                     ? ", " + std::to_string(endsOf(BouncingEnd::Unknown)) + " are too short to tell"
                     : "") +
                (endsOf(BouncingEnd::Failed) > 0 ? ", " + std::to_string(endsOf(BouncingEnd::Failed)) + " fail" : ""));
            return;
        }
        say("No stable cycle found from " + counted(runs, "start") + at + ", but " + counted(bouncing, "run") +
            (bouncing == 1 ? " still bounces" : " still bounce") +
            " at the end: the bouncing decays slowly or is irregular");
    }

    /// An end of the branch so near to a mark that both are one for the reader.
    const MarkedCycle* endNear(const CycleThreshold& threshold) const
    {
        for (const MarkedCycle& mark : result_.branches[threshold.branch].marks)
            if (mark.ends && mark.point != threshold.mark.point &&
                std::abs(mark.at.value - threshold.mark.at.value) <= oneEvent * std::abs(task_.to - task_.from))
                return &mark;
        return nullptr;
    }

    static std::string howOf(const MarkedCycle& mark)
    {
        switch (mark.kind) {
        case CycleMark::Fold: return "in a fold, where a stable and an unstable cycle meet";
        case CycleMark::PeriodDoubling: return "in a period doubling";
        case CycleMark::NeimarkSacker: return "in a Neimark-Sacker bifurcation";
        case CycleMark::Grazing:
            return "by grazing, where a switch along the cycle is lost or appears (" + mark.remark + ")";
        case CycleMark::End: break;
        }
        return "where it could not be followed: " + mark.remark;
    }

    void addThreshold(const CycleThreshold& threshold)
    {
        const LimitCycle& at = threshold.mark.at;
        const MarkedCycle* end = endNear(threshold);
        const bool vanishes = threshold.mark.ends || end != nullptr || threshold.mark.kind == CycleMark::Fold;
        const std::string how = end == nullptr
                                    ? howOf(threshold.mark)
                                    : howOf(*end) + ", just after it loses its stability " + howOf(threshold.mark);
        const CycleEnergies& given = at.energies;
        const double largest = given.largest();
        std::string sentence = std::string("The stable cycle ") + (vanishes ? "ends" : "loses its stability") + " at " +
                               task_.text.of(at.value) + " " + how + ": W = " + energyText(at.cycleWork) +
                               " there; in one cycle " + partText("the contact", given.contact, largest) + ", " +
                               partText("the air", given.air, largest) + ", " +
                               partText("the suspension", given.suspension, largest);
        if (std::abs(given.friction) > negligibleEnergy * largest)
            sentence += ", " + partText("friction", given.friction, largest);
        say(sentence);
    }

    /// "from 250 nm at 5 of 8 values": the runs of each start that end on a stable cycle.
    std::string reachedFrom() const
    {
        std::vector<std::string> parts;
        for (std::size_t k = 0; k < std::size_t(task_.starts); ++k) {
            SwingOf height;
            std::size_t reached = 0;
            for (std::size_t i = k; i < result_.runs.size(); i += std::size_t(task_.starts)) {
                height.add(result_.runs[i].height);
                reached += endsOnStableCycle(result_.runs[i]) ? 1 : 0;
            }
            parts.push_back(rangeOf(height.least, height.most, "nm") + " at " + std::to_string(reached) + " of " +
                            counted(task_.values.size(), "value"));
        }
        return "from a flying height of " + joined(parts);
    }

    /// The values within the stable ranges at which no run ends on a stable cycle.
    void addUnreached()
    {
        const std::vector<ValueRange> ranges = stableRanges(result_.branches);
        std::vector<double> unreached;
        for (std::size_t i = 0; i < task_.values.size(); ++i) {
            const auto first = result_.runs.begin() + std::ptrdiff_t(i) * task_.starts;
            const bool stable = std::ranges::any_of(ranges, [&](const ValueRange& range) {
                return task_.values[i] >= range.lower && task_.values[i] <= range.upper;
            });
            if (stable && std::none_of(first, first + task_.starts, endsOnStableCycle))
                unreached.push_back(task_.values[i]);
        }
        if (unreached.empty()) return;
        say(capitalized(text(rangesAmong(task_.values, unreached), task_.text)) +
            " no start of this study leads to the stable cycle; only starts near it do");
    }

    void addRuns()
    {
        const std::size_t runs = result_.runs.size();
        const CycleAgreement agreement = agreementOf(result_.runs);
        if (agreement.runs > 0)
            say(counted(agreement.runs, "run") + " of " + std::to_string(runs) +
                (agreement.runs == 1 ? " ends" : " end") + " on a stable cycle, " + reachedFrom() +
                "; largest difference in frequency " + percent(agreement.frequency) + ", in amplitude " +
                percent(agreement.amplitude));
        addUnreached();
        const auto lost = std::ranges::count_if(
            result_.runs, [](const BouncingRun& run) { return run.end == BouncingEnd::Bounces && !run.cycle; });
        if (lost > 0 && agreement.runs > 0)
            say(counted(std::size_t(lost), "run") + (lost == 1 ? " still bounces" : " still bounce") +
                " at the end, on no cycle that was found");
    }

    void addBalance()
    {
        double largest = 0.0;
        for (const CycleBranch& branch : result_.branches)
            for (const LimitCycle& point : branch.points) largest = std::max(largest, point.residual());
        if (!result_.branches.empty())
            say("The energies of each cycle add up to zero within " + fewDigits(std::max(largest, 1e-15), "", 1) +
                " of their largest part");
    }

    void addFilm()
    {
        if (task_.start.model != ModelKind::Film) return;
        SwingOf error, left; // of cycles, of those that are left out
        for (const CycleBranch& branch : result_.branches)
            for (const LimitCycle& point : branch.points) error.add(point.modelError);
        std::size_t runs = 0;
        for (const BouncingRun& run : result_.runs) {
            if (!(run.modelError > 0.0)) continue;
            ++runs;
            left.add(run.modelError);
        }
        say("The film is linear about the static state of the case, and the slider is nearest where it is there, at "
            "all values" +
            (result_.branches.empty() ? std::string()
                                      : "; its error is estimated as " + percent(error.least) + " to " +
                                            percent(error.most) + " of the motion along the cycles") +
            ". Starts far from that state are followed on it as well: which motion they lead to may be another on "
            "the film itself");
        if (runs > 0)
            say(counted(runs, "run") + (runs == 1 ? " ends" : " end") +
                " bouncing too far for a linear film, and no cycle is sought: its error is estimated as up to " +
                percent(left.most) + ", above film.linear_limit = " + percent(task_.start.film.linearLimit));
    }

    const CyclesTask& task_;
    const CyclesResult& result_;
    std::vector<std::string> findings_;
};

} // namespace

std::vector<std::string> cyclesFindings(const CyclesTask& task, const CyclesResult& result)
{
    return CyclesFindings(task, result).all();
}

} // namespace touchdown

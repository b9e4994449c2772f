// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/precision/ensemble_report.h"

#include <algorithm>
#include <cmath>

#include "core/case/fields.h"
#include "core/numerics/moments.h"
#include "core/studies/runs/swept_method.h"
#include "core/studies/study/few_digits.h"

namespace touchdown {

namespace {

constexpr std::size_t mostPanels = 3;
constexpr std::size_t mostEndsTold = 4;

std::string labelOf(const Ensemble& ensemble) { return nameOf(ensemble.method, ensemble.setting); }

double meanWork(const Ensemble& ensemble)
{
    double sum = 0.0;
    for (const EnsembleEnd& end : ensemble.ends) sum += end.work;
    return sum / static_cast<double>(ensemble.ends.size());
}

std::string percent(double share) { return fewDigits(std::round(1000.0 * share) / 10.0, "", 4) + " %"; }

/// "31.3 % (26.3 % to 36.8 %)"
std::string shareText(const Share& share)
{
    return percent(share.share) + " (" + percent(share.lower) + " to " + percent(share.upper) + ")";
}

/// What `take` tells of the starts.
template <class Take>
std::vector<double> valuesOf(const Ensemble& ensemble, Take take)
{
    std::vector<double> values;
    for (std::size_t s = 0; s < ensemble.ends.size(); ++s)
        if (const std::optional<double> value = take(s)) values.push_back(*value);
    return values;
}
StudyValue meanOf(const std::vector<double>& values)
{
    return values.empty() ? StudyValue() : StudyValue(momentsOf(values).mean);
}
StudyValue deviationOf(const std::vector<double>& values)
{
    return values.empty() ? StudyValue() : StudyValue(momentsOf(values).deviation);
}

class Teller {
public:
    explicit Teller(const EnsembleAccount& account)
        : account_(account), all_(account.all), ends_(classifyEnds(account.all))
    {}

    void tell(StudyReport& report) const
    {
        tellReference(report);
        for (std::size_t e = 1; e < all_.size(); ++e) tellOne(e, report);
        report.charts.push_back(chart());
        report.tables.push_back(shares());
        report.tables.push_back(ensembles());
    }

private:
    std::size_t starts() const { return all_.front().ends.size(); }
    Share shareIn(std::size_t ensemble, std::size_t end) const
    {
        return shareOf(static_cast<std::size_t>(std::ranges::count(ends_.of[ensemble], end)), starts());
    }
    ShareDifference differenceIn(std::size_t ensemble, std::size_t end) const
    {
        return shareDifference(ends_.of[ensemble], ends_.of[0], end);
    }

    void tellReference(StudyReport& report) const
    {
        std::string text;
        for (std::size_t k = 0, told = 0; k < ends_.classes.size(); ++k) {
            const Share share = shareIn(0, k);
            if (share.count == 0 || told++ >= mostEndsTold) continue;
            text += (text.empty() ? "" : "; ") + ends_.classes[k].name + ", " + shareText(share);
        }
        report.findings.push_back("The reference (" + all_[0].setting + ") of " + account_.what + " ends in: " + text +
                                  ". In brackets: 95 % intervals.");
    }

    void tellOne(std::size_t e, StudyReport& report) const
    {
        const std::size_t changed = otherwise(ends_.of[e], ends_.of[0]);
        std::string text = labelOf(all_[e]) + " leads " + std::to_string(changed) + " of " + std::to_string(starts()) +
                           " starts to another end than the reference";
        std::string differences;
        for (std::size_t k = 0; k < ends_.classes.size(); ++k) {
            const ShareDifference difference = differenceIn(e, k);
            if (!difference.significant) continue;
            differences += (differences.empty() ? "" : "; ") + ends_.classes[k].name + " " + shareText(shareIn(e, k)) +
                           " instead of " + percent(shareIn(0, k).share) + ", " +
                           fewDigits(std::abs(difference.difference) / difference.error, "") + " standard errors apart";
        }
        if (!differences.empty())
            text += ", and its shares differ by more than their uncertainty: " + differences;
        else if (changed > 0)
            text += ", but its shares are the same within their uncertainty";
        report.findings.push_back(text + ".");
    }

    StudyChart chart() const
    {
        StudyChart chart{
            "Where " + account_.what + " end",
            "Each point is one way to run the same starts; bars and the shaded band of the reference: 95 % intervals "
            "(Wilson). "
            "As the starts are the same, a difference can be certain although the bars overlap: see the table of "
            "shares. Each is tested for itself: of twenty, one exceeds its uncertainty by chance.",
            {}};
        for (std::size_t k = 0; k < std::min(mostPanels, ends_.classes.size()); ++k) chart.panels.push_back(panel(k));
        return chart;
    }

    ChartPanel panel(std::size_t end) const
    {
        ChartPanel panel{{"Share: " + ends_.classes[end].name, "", "", false},
                         {account_.workTitle + " per run", "", "", true},
                         {},
                         {},
                         {},
                         false};
        for (std::size_t e = 0; e < all_.size(); ++e) {
            const std::string name = e == 0 ? "reference: " + all_[0].setting : all_[e].method;
            auto series = std::ranges::find(panel.series, name, &ChartSeries::name);
            if (series == panel.series.end())
                series = panel.series.insert(series, {name, {}, ChartLine::None, true, false});
            const Share share = shareIn(e, end);
            if (!(meanWork(all_[e]) > 0.0)) continue;
            series->points.push_back({.x = share.share,
                                      .y = meanWork(all_[e]),
                                      .label = e == 0 ? std::string() : all_[e].setting,
                                      .xError = std::max(share.upper - share.share, share.share - share.lower)});
        }
        const Share reference = shareIn(0, end);
        panel.bands.push_back({true, reference.lower, reference.upper, "reference"});
        return panel;
    }

    StudyTable shares() const
    {
        StudyTable table{"shares",
                         {{.name = "method", .longName = "Method"},
                          {.name = "setting", .longName = "Setting"},
                          {.name = "end", .longName = "End"},
                          {.name = "count", .longName = "Starts"},
                          {.name = "share", .longName = "Share"},
                          {.name = "lower", .longName = "Lower end of its 95 % interval"},
                          {.name = "upper", .longName = "Upper end"},
                          {.name = "difference", .longName = "Share less that of the reference"},
                          {.name = "difference_error", .longName = "Its standard error, start by start"},
                          {.name = "differs", .longName = "Differs by more than chance"},
                          {"spacing", "m", "nm", "Mean spacing over the last tenth"},
                          {"spacing_deviation", "m", "nm", "Its deviation among starts"},
                          {"spread", "m", "nm", "Standard deviation over the last tenth, mean of the starts"}},
                         {}};
        for (std::size_t e = 0; e < all_.size(); ++e)
            for (std::size_t k = 0; k < ends_.classes.size(); ++k) table.rows.push_back(row(e, k));
        return table;
    }

    std::vector<StudyValue> row(std::size_t e, std::size_t k) const
    {
        const Share share = shareIn(e, k);
        const ShareDifference difference = differenceIn(e, k);
        const auto among = [&](double EndState::*member) {
            return valuesOf(all_[e], [&, member](std::size_t s) {
                const EndState& state = all_[e].ends[s].state;
                return ends_.of[e][s] == k && state.kind != EndKind::Failed ? std::optional(state.*member)
                                                                            : std::nullopt;
            });
        };
        const std::vector<double> spacing = among(&EndState::spacing);
        return {all_[e].method,
                all_[e].setting,
                ends_.classes[k].name,
                static_cast<double>(share.count),
                share.share,
                share.lower,
                share.upper,
                difference.difference,
                difference.error,
                std::string(e > 0 && difference.significant ? "yes" : ""),
                meanOf(spacing),
                deviationOf(spacing),
                meanOf(among(&EndState::spread))};
    }

    StudyTable ensembles() const
    {
        StudyTable table{"ensembles",
                         {{.name = "method", .longName = "Method"},
                          {.name = "setting", .longName = "Setting"},
                          {.name = "starts", .longName = "Starts"},
                          {.name = "otherwise", .longName = "Starts with another end than in the reference"},
                          {.name = "failed", .longName = "Without a valid end"},
                          {"spacing", "m", "nm", "Mean spacing over the last tenth, mean of the valid starts"},
                          {"spacing_deviation", "m", "nm", "Its deviation among starts"},
                          {.name = "work", .longName = account_.workTitle + " per run"}},
                         {}};
        for (std::size_t e = 0; e < all_.size(); ++e) {
            const std::vector<double> spacing = valuesOf(all_[e], [&](std::size_t s) {
                const EndState& state = all_[e].ends[s].state;
                return state.kind != EndKind::Failed ? std::optional(state.spacing) : std::nullopt;
            });
            table.rows.push_back({all_[e].method, all_[e].setting, static_cast<double>(starts()),
                                  static_cast<double>(otherwise(ends_.of[e], ends_.of[0])),
                                  static_cast<double>(starts() - spacing.size()), meanOf(spacing), deviationOf(spacing),
                                  meanWork(all_[e])});
        }
        return table;
    }

    const EnsembleAccount& account_;
    const std::vector<Ensemble>& all_;
    EndClasses ends_;
};

} // namespace

std::string describeStarts(const Case& c, const EnsembleTask& task)
{
    const Field& field = *findField(task.key);
    return std::to_string(task.starts) + " starts with " + field.label + " within " +
           fewDigits(task.spread, field.displayUnit, 6) + " of " + toText(c, field);
}

void reportEnsembles(const EnsembleAccount& account, StudyReport& report) { Teller(account).tell(report); }

} // namespace touchdown

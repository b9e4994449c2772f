// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/measured_run.h"

#include <algorithm>
#include <cmath>

#include "core/simulation/case_file.h"
#include "core/simulation/fields.h"

namespace touchdown {

namespace {

/// The last part of a run, by which its end is told [-].
constexpr double tail = 0.1;

/// How the pad stands at one sample. Ono & Yamane's menisci hold it where its asperities do not touch any more; adhesion of
/// surfaces reaches beyond contact.
class TouchColumns {
public:
    TouchColumns(const Case& c, const std::vector<Quantity>& quantities)
        : contact_(findQuantity(quantities, "contact_force")),
          adhesion_(c.contact == ContactKind::OnoYamane ? findQuantity(quantities, "adhesion_force") : -1)
    {}
    bool touches(const SampleBatch& batch, std::size_t i) const
    {
        const auto acts = [&](int column) { return column >= 0 && batch.columns[static_cast<std::size_t>(column)][i] != 0.0; };
        return acts(contact_) || acts(adhesion_);
    }

private:
    int contact_, adhesion_;
};

} // namespace

std::string_view name(EndKind kind)
{
    switch (kind) {
    case EndKind::Flying: return "flying";
    case EndKind::Contact: return "contact";
    case EndKind::Intermittent: return "in and out of contact";
    case EndKind::Failed: return "failed";
    }
    return {};
}

std::string_view spacingOf(const Case& c) { return c.model == ModelKind::Springs ? "flying_height" : "minimum_spacing"; }

MeasuredRun measureRun(const Case& c, const std::vector<std::string>& quantities, const GoOn& goOn, const RunOptions& options)
{
    const std::vector<Quantity> all = recordedQuantities(c);
    std::vector<int> columns;
    for (const std::string& quantity : quantities) columns.push_back(findQuantity(all, quantity));
    const TouchColumns touch(c, all);
    const int spacing = findQuantity(all, spacingOf(c));
    const double tailBegin = (1.0 - tail) * c.run.duration;

    MeasuredRun run;
    run.columns.resize(quantities.size());
    std::size_t touching = 0, apart = 0;
    double sum = 0.0, squares = 0.0, first = 0.0;
    run.summary = touchdown::run(c, [&](const RunUpdate& update) {
        const SampleBatch& batch = update.samples;
        run.time.insert(run.time.end(), batch.time.begin(), batch.time.end());
        for (std::size_t i = 0; i < columns.size(); ++i) {
            if (columns[i] < 0) continue;
            const std::vector<double>& values = batch.columns[static_cast<std::size_t>(columns[i])];
            run.columns[i].insert(run.columns[i].end(), values.begin(), values.end());
        }
        for (std::size_t i = 0; i < batch.size(); ++i) {
            if (batch.time[i] < tailBegin || spacing < 0) continue;
            const double value = batch.columns[static_cast<std::size_t>(spacing)][i];
            if (touching + apart == 0) first = value;
            sum += value - first;
            squares += (value - first) * (value - first);
            ++(touch.touches(batch, i) ? touching : apart);
        }
        return !goOn || goOn();
    }, options);
    const double count = static_cast<double>(touching + apart);
    if (!run.valid() || count == 0.0) return run;
    const double mean = sum / count;
    run.end.kind = touching == 0 ? EndKind::Flying : apart == 0 ? EndKind::Contact : EndKind::Intermittent;
    run.end.spacing = first + mean;
    run.end.spread = std::sqrt(std::max(0.0, squares / count - mean * mean));
    return run;
}

bool sameEnd(const EndState& a, const EndState& b, double distance)
{
    if (a.kind != b.kind) return false;
    if (a.kind == EndKind::Failed) return true;
    const double wider = std::max(a.spread, b.spread);
    return std::abs(a.spread - b.spread) <= std::max(distance, 0.5 * wider) && std::abs(a.spacing - b.spacing) <= std::max(distance, a.spread + b.spread);
}

std::string applySettings(Case& c, const std::vector<CaseSetting>& settings)
{
    Case changed = c;
    for (const CaseSetting& setting : settings) {
        const Field* field = findField(setting.key);
        if (field == nullptr) {
            const std::string near = nearestKey(setting.key);
            return setting.key + ": unknown key" + (near.empty() ? "" : "; did you mean " + near + "?");
        }
        if (const auto problem = setFromText(changed, *field, setting.value)) return setting.key + ": " + *problem;
    }
    for (const CaseProblem& problem : checkCombinations(changed)) return problem.key + ": " + problem.message;
    c = std::move(changed);
    return {};
}

} // namespace touchdown

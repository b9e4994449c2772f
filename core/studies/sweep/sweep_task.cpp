// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/sweep/sweep_task.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "core/case_files/outside_path.h"
#include "core/formats/quotation.h"
#include "core/formats/toml_document.h"
#include "core/formats/units.h"
#include "core/formats/words.h"
#include "core/studies/study/study_reader.h"
#include "core/studies/sweep/sweep_form.h"
#include "core/studies/sweep/sweep_surface.h"

namespace touchdown {

namespace {

constexpr std::size_t mostAxes = 16;
constexpr std::size_t mostReadings = 32;
constexpr double mostItems = 10e6;

class SweepReader {
public:
    explicit SweepReader(StudyReader& reader) : reader_(reader) { task_.start = reader.start(); }

    SweepTask read()
    {
        const std::string calculate = reader_.choice("calculate");
        for (const Calculation each : {Calculation::Run, Calculation::Steady, Calculation::Modes})
            if (calculate == name(each)) task_.calculate = each;
        if (task_.calculate != Calculation::Run && task_.start.model != ModelKind::Film)
            reader_.add("calculate", "is " + inQuotes(calculate) + ", which only a case of model \"film\" has");
        readSamples();
        task_.keepsRuns = reader_.choice("keep") == "all";
        if (task_.keepsRuns && task_.calculate != Calculation::Run)
            reader_.add("keep", "is \"all\", which is for calculate = \"run\": only runs have files of their own");
        if (task_.keepsRuns && task_.samples && task_.samples->bySurface)
            reader_.add("keep",
                        "is \"all\", and most samples of samples.by = \"surface\" have no run; write one of the two");
        const TomlDocument standard = readToml(standardSweepLists(task_.start));
        StudyReader standardReader(standard, reader_.name(), task_.start, standardProblems_);
        if (!reader_.has("axis") && !reader_.has("reading")) lists_ = &standardReader;
        const std::vector<std::string> axes = tables("axis", mostAxes), readings = tables("reading", mostReadings);
        for (const std::string& table : axes) readAxis(table);
        if (axes.empty()) reader_.add("axis", "is missing; write one [[axis]] or more");
        for (const std::string& table : readings) readReading(table);
        if (readings.empty()) reader_.add("reading", "is missing; write one [[reading]] or more");
        task_.readings = withErrors(task_.calculate, task_.start, task_.readings);
        for (const Reading& reading : task_.readings) task_.limits.push_back(limits_[reading.column().name]);
        if (task_.axes.size() == axes.size()) drawOrCount();
        return std::move(task_);
    }

private:
    std::vector<std::string> tables(const std::string& list, std::size_t most)
    {
        std::vector<std::string> all = lists_->tables(list);
        if (all.size() > most) {
            lists_->add(all[most], "is one too many: at most " + std::to_string(most) + " are possible");
            all.resize(most);
        }
        return all;
    }

    void readSamples()
    {
        const std::string method = reader_.choice("samples.method");
        const int count = reader_.integer("samples.count"), seed = reader_.integer("samples.seed");
        const std::string by = reader_.choice("samples.by");
        if (method == "grid") {
            for (const char* unused : {"samples.count", "samples.seed", "samples.by"})
                if (reader_.has(unused) && !reader_.has("samples.method"))
                    reader_.add(unused, "needs samples.method: random, latin-hypercube or sobol");
            return;
        }
        task_.samples = SweepSamples{.count = std::size_t(count), .seed = seed, .bySurface = by == "surface"};
        for (const SampleMethod each : {SampleMethod::Random, SampleMethod::LatinHypercube, SampleMethod::Sobol})
            if (method == name(each)) task_.samples->method = each;
    }

    std::vector<std::string> keysOf(const std::string& table)
    {
        const std::string one = table + ".key", several = table + ".keys";
        if (lists_->has(one) && lists_->has(several)) {
            lists_->add(one, "is one key, and keys are several; write one of the two");
            return {};
        }
        if (lists_->has(several)) return lists_->texts(several).value_or(std::vector<std::string>{});
        if (!lists_->has(one)) lists_->add(table, "has no key; a key of the case in quotation marks is needed");
        const auto key = lists_->text(one);
        return key ? std::vector{*key} : std::vector<std::string>{};
    }

    void readAxis(const std::string& table)
    {
        for (const char* leaf :
             {".from", ".to", ".values", ".count", ".spacing", ".distribution", ".mean", ".deviation", ".average"})
            lists_->has(table + leaf); // known, though nothing may be said about it
        const std::vector<std::string> keys = keysOf(table);
        if (keys.empty()) return;
        const std::string at = table + (lists_->has(table + ".keys") ? ".keys" : ".key");
        for (const std::string& key : keys)
            if (!named_.insert(key).second) return lists_->add(at, inQuotes(key) + " is changed by two axes");
        const auto joint = jointKey(keys, [&](std::string_view key) -> std::variant<Parameter, std::string> {
            auto found = caseKey(task_.start, key);
            if (const auto* parameter = std::get_if<Parameter>(&found)) {
                if (parameter->key == "model" || parameter->key == "title")
                    return std::string("cannot be varied: the readings depend on it");
                if (std::string unused = unusedMessage(task_.start, *parameter); !unused.empty()) return unused;
            }
            return found;
        });
        if (const auto* problem = std::get_if<std::string>(&joint)) return lists_->add(at, *problem);
        SweepAxis axis{std::get<JointKey>(joint).key, std::get<JointKey>(joint).text};
        axis.isNumber = axis.key.kind == ParameterKind::Number || axis.key.kind == ParameterKind::Integer;
        axis.average = lists_->boolean(table + ".average").value_or(false);
        if (axis.average && task_.samples)
            lists_->add(table + ".average", "has no meaning for samples, which are drawn over all axes at once");
        axis.logarithmic = lists_->choice(table + ".spacing", sweepSpacings) == "logarithmic";
        const bool good = lists_->has(table + ".values") ? readValues(table, axis) : readRange(table, axis);
        if (good) task_.axes.push_back(std::move(axis));
    }

    bool readValues(const std::string& table, SweepAxis& axis)
    {
        for (const char* leaf : {".from", ".to", ".count", ".spacing", ".distribution", ".mean", ".deviation"})
            if (lists_->has(table + leaf)) {
                lists_->add(table + leaf, "stands beside values, which are the whole list");
                return false;
            }
        const auto texts = lists_->texts(table + ".values");
        if (!texts) return false;
        std::set<std::string> seen;
        for (const std::string& text : *texts) {
            Case tried = task_.start;
            if (axis.key.kind == ParameterKind::Text && lists_->outsidePaths() == OutsidePaths::Refused &&
                leadsOutside(tried.folder, tried.folder / text)) {
                lists_->add(table + ".values", outsideProblem(text, "the study"));
                return false;
            }
            if (const auto problem = setFromText(tried, axis.key, text)) {
                lists_->add(table + ".values", inQuotes(text) + ": " + *problem);
                return false;
            }
            if (!seen.insert(toText(tried, axis.key)).second) {
                lists_->add(table + ".values", inQuotes(text) + " is twice in the list");
                return false;
            }
            const double place = double(axis.values.size() + 1);
            axis.values.push_back(axis.isNumber ? SweepValue{numberOf(axis.key, tried)}
                                                : SweepValue{place, toText(tried, axis.key)});
        }
        return true;
    }

    /// One end of the range [unit of the key]; a missing one is a problem, unless it has none.
    std::optional<double> readEnd(const std::string& key, const SweepAxis& axis, std::optional<double> otherwise = {})
    {
        if (!lists_->has(key)) {
            if (!otherwise) lists_->add(key, "is missing; write from and to, or values = [...]");
            return otherwise;
        }
        const auto value = lists_->number(key, axis.key.unit, axis.key.displayUnit, axis.key.minimum, axis.key.maximum);
        Case tried = task_.start;
        if (!value) return {};
        if (const auto problem = setFromNumber(tried, axis.key, *value)) {
            lists_->add(key, *problem);
            return {};
        }
        if (axis.logarithmic && !(*value > 0.0)) {
            lists_->add(key, "must be greater than 0 for a logarithmic spacing");
            return {};
        }
        return value;
    }

    bool readRange(const std::string& table, SweepAxis& axis)
    {
        if (!axis.isNumber) {
            lists_->add(table, "needs values = [...]: " + inQuotes(axis.key.key) + " is no number");
            return false;
        }
        const bool normal = lists_->choice(table + ".distribution", sweepDistributions) == "normal";
        if (normal && !task_.samples) {
            lists_->add(table + ".distribution", "is of samples; choose samples.method");
            return false;
        }
        if (normal && !readNormal(table, axis)) return false;
        if (!normal)
            for (const char* leaf : {".mean", ".deviation"})
                if (lists_->has(table + leaf)) lists_->add(table + leaf, "is of distribution = \"normal\"");
        const double far = 40.0 * axis.deviation;
        const auto from = readEnd(table + ".from", axis,
                                  normal ? std::optional(std::max(axis.mean - far, axis.key.minimum)) : std::nullopt),
                   to = readEnd(table + ".to", axis,
                                normal ? std::optional(std::min(axis.mean + far, axis.key.maximum)) : std::nullopt);
        const int count = lists_->integer(table + ".count", 1, mostSweepValues).value_or(standardSweepCount);
        if (!from || !to) return false;
        axis.from = *from;
        axis.to = *to;
        if (task_.samples) {
            if (lists_->has(table + ".count")) lists_->add(table + ".count", "has no effect on samples");
            if (*from < *to) return true;
            lists_->add(table + ".to", "must be greater than from");
            return false;
        }
        for (int i = 0; i < count; ++i) {
            const double share = count == 1 ? 0.0 : double(i) / (count - 1);
            double value = axis.logarithmic ? *from * std::pow(*to / *from, share) : std::lerp(*from, *to, share);
            if (i > 0 && i == count - 1) value = *to;
            if (axis.key.kind == ParameterKind::Integer) value = std::round(value);
            if (axis.values.empty() || axis.values.back().number != value) axis.values.push_back({value});
        }
        return true;
    }

    bool readNormal(const std::string& table, SweepAxis& axis)
    {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        if (axis.logarithmic) {
            lists_->add(table + ".spacing", "is logarithmic, and distribution = \"normal\"; write one of the two");
            return false;
        }
        for (const char* leaf : {".mean", ".deviation"})
            if (!lists_->has(table + leaf)) lists_->add(table + leaf, "is missing for distribution = \"normal\"");
        const auto mean = lists_->number(table + ".mean", axis.key.unit, axis.key.displayUnit, axis.key.minimum,
                                         axis.key.maximum),
                   deviation = lists_->number(table + ".deviation", axis.key.unit, axis.key.displayUnit, 0.0, infinity);
        if (!mean || !deviation) return false;
        if (!(*deviation > 0.0)) {
            lists_->add(table + ".deviation", "must be greater than 0");
            return false;
        }
        axis.mean = *mean;
        axis.deviation = *deviation;
        return true;
    }

    void readReading(const std::string& table)
    {
        const std::string quantity = lists_->text(table + ".quantity").value_or(""),
                          at = lists_->text(table + ".at").value_or("");
        if (quantity.empty()) {
            lists_->add(table, "has no quantity; a name such as \"minimum_spacing\" is needed");
            return;
        }
        auto found = findReading(task_.calculate, task_.start, quantity, at);
        if (const auto* problem = std::get_if<std::string>(&found)) {
            lists_->add(table + (problem->starts_with("at =") ? ".at" : ".quantity"), *problem);
            return;
        }
        Reading& reading = std::get<Reading>(found);
        for (const Reading& other : task_.readings)
            if (other.column().name == reading.column().name)
                return lists_->add(table + ".quantity", inQuotes(quantity) + " is read twice");
        readLimits(table, reading);
        task_.readings.push_back(std::move(reading));
    }

    void readLimits(const std::string& table, const Reading& reading)
    {
        SweepLimits limits;
        constexpr double endless = std::numeric_limits<double>::infinity();
        for (const auto& [leaf, limit] : {std::pair{".least", &limits.least}, std::pair{".most", &limits.most}}) {
            if (!lists_->has(table + leaf)) continue;
            if (reading.isText)
                lists_->add(table + leaf, "has no meaning for a text");
            else
                *limit = lists_->number(table + leaf, reading.quantity.unit, reading.quantity.displayUnit, -endless,
                                        endless);
        }
        if (limits.least && limits.most && *limits.least > *limits.most)
            lists_->add(table + ".most", "must not be below least");
        limits_[reading.column().name] = limits;
    }

    /// A surface of second order is one of numbers over numbers.
    bool suitsSurface()
    {
        const auto add = [&](const std::string& what) {
            reader_.add("samples.by", "is \"surface\", which " + what + "; samples.by = \"items\" has them");
            return false;
        };
        for (const SweepAxis& axis : task_.axes)
            if (!axis.values.empty() || axis.key.kind != ParameterKind::Number)
                return add("takes no list of values: " + inQuotes(axis.key.key));
        for (const Reading& reading : task_.readings)
            if (reading.isText) return add("has no texts: " + inQuotes(reading.quantity.name));
        return true;
    }

    void drawOrCount()
    {
        if (!task_.samples) {
            double count = 1.0;
            for (const SweepAxis& axis : task_.axes) count *= double(axis.values.size());
            if (count > mostItems)
                reader_.add("axis", "gives " + fewDigits(count, "", 3) + " items in all; at most " +
                                        fewDigits(mostItems, "", 3) + " are possible");
            if (!task_.axes.empty() && std::ranges::all_of(task_.axes, &SweepAxis::average))
                reader_.add("axis", "is averaged over, as are all others; at least one must not be");
            return;
        }
        if (task_.samples->bySurface) {
            if (!suitsSurface()) return;
            task_.design = surfaceDesign(task_.axes, task_.samples->seed);
        }
        task_.points = samplePoints(task_.samples->method, task_.axes.size(), task_.samples->count,
                                    std::uint64_t(task_.samples->seed));
    }

    StudyReader& reader_;
    StudyReader* lists_ = &reader_; // of axes and readings; another one where the file has neither
    std::vector<InputProblem> standardProblems_;
    SweepTask task_;
    std::set<std::string> named_;
    std::map<std::string, SweepLimits> limits_; // by column
};

} // namespace

std::size_t SweepTask::count() const
{
    if (!design.empty()) return design.size();
    if (samples) return points.size();
    std::size_t count = axes.empty() ? 0 : 1;
    for (const SweepAxis& axis : axes) count *= axis.values.size();
    return count;
}

std::vector<SweepValue> SweepTask::valuesOf(std::size_t item) const
{
    std::vector<SweepValue> values(axes.size());
    if (!design.empty()) {
        for (std::size_t d = 0; d < axes.size(); ++d) values[d] = {design[item][d]};
        return values;
    }
    if (samples) {
        for (std::size_t d = 0; d < axes.size(); ++d) values[d] = axes[d].at(points[item][d]);
        return values;
    }
    for (std::size_t d = axes.size(); d-- > 0;) {
        values[d] = axes[d].values[item % axes[d].values.size()];
        item /= axes[d].values.size();
    }
    return values;
}

Case SweepTask::caseOf(std::size_t item) const
{
    Case c = start;
    const std::vector<SweepValue> values = valuesOf(item);
    for (std::size_t d = 0; d < axes.size(); ++d) {
        const SweepAxis& axis = axes[d];
        // The ranges were checked when the axes were read.
        if (axis.isNumber)
            setFromNumber(c, axis.key, values[d].number);
        else
            setFromText(c, axis.key, values[d].text);
    }
    return c;
}

SweepTask readSweep(StudyReader& reader) { return SweepReader(reader).read(); }

} // namespace touchdown

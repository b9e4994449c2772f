// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/statements/statement_task.h"

#include <algorithm>
#include <cmath>

#include "core/case/case_document.h"
#include "core/case/parameters.h"
#include "core/formats/nearest_name.h"
#include "core/formats/quotation.h"
#include "core/formats/units.h"
#include "core/formats/words.h"
#include "core/simulation/run.h"
#include "core/studies/statements/statements.h"
#include "core/studies/study/study_head.h"
#include "core/studies/study/study_reader.h"

namespace touchdown {

namespace {

constexpr int mostStarts = 10000;

/// Ends of valid runs, then the reasons why a run fails.
std::vector<std::string> endNames()
{
    std::vector<std::string> names;
    for (const EndKind kind : {EndKind::Flying, EndKind::Contact, EndKind::Intermittent})
        names.emplace_back(name(kind));
    for (const RunFailure failure :
         {RunFailure::Diverged, RunFailure::NegativeEnergy, RunFailure::Chattering, RunFailure::FrontSpringLost,
          RunFailure::RearSpringLost, RunFailure::Tunnelled, RunFailure::NoStep, RunFailure::NotConverged})
        names.emplace_back(name(failure));
    return names;
}

std::vector<std::string> motionNames()
{
    std::vector<std::string> names;
    for (const Motion motion :
         {Motion::AtRest, Motion::Settles, Motion::Swings, Motion::Vibrates, Motion::Bounces, Motion::TooShort})
        names.emplace_back(name(motion));
    return names;
}

std::vector<std::string> takenNames()
{
    std::vector<std::string> names;
    for (std::size_t i = 0; i < takenCount; ++i) names.emplace_back(name(static_cast<Taken>(i)));
    return names;
}

/// As a shell takes it.
std::string commandOf(const std::string& caseName, const std::vector<CaseSetting>& settings)
{
    std::string command = "touchdown run " + caseName;
    for (const CaseSetting& each : settings) {
        const bool plain = each.value.find(' ') == std::string::npos;
        command += " --set " + (plain ? each.key + '=' + each.value : '"' + each.key + '=' + each.value + '"');
    }
    return command;
}

struct Candidate {
    std::string name;
    std::string table; // of its settings
    std::vector<CaseSetting> set;
};

class StatementsReader {
public:
    explicit StatementsReader(StudyReader& reader) : reader_(reader) {}

    StatementTask read()
    {
        starts_ = reader_.integer("starts");
        seed_ = reader_.integer("seed");
        contradict_ = reader_.flag("contradict");
        only_ = reader_.texts("only").value_or(std::vector<std::string>{});
        std::vector<Candidate> candidates;
        StatementTask task;
        for (const std::string& table : reader_.tables("candidate")) {
            candidates.push_back(
                {needed(table, "name").value_or(table), table + ".set", reader_.settings(table + ".set")});
            task.candidates.push_back(candidates.back().name);
        }
        if (candidates.empty()) candidates.emplace_back();
        const std::vector<std::string> tables = reader_.tables("statement");
        if (tables.empty()) reader_.add("statement", "is missing; write one [[statement]] or more");
        std::vector<Statement> all;
        for (const Candidate& candidate : candidates)
            for (const std::string& table : tables) all.push_back(readStatement(table, candidate));
        std::ranges::copy_if(all, std::back_inserter(task.statements),
                             [this](const Statement& each) { return isWanted(each); });
        if (task.statements.empty() && !tables.empty())
            reader_.add("only", "leaves no statement: none has a figure that begins so");
        return task;
    }

private:
    bool isWanted(const Statement& statement) const
    {
        return only_.empty() ||
               std::ranges::any_of(only_, [&](const std::string& text) { return statement.figure.starts_with(text); });
    }

    std::optional<std::string> needed(const std::string& table, const std::string& leaf)
    {
        const std::string key = table + '.' + leaf;
        if (!reader_.has(key)) reader_.add(table, "has no " + leaf);
        return reader_.text(key);
    }

    /// The case with the changes of candidate and statement.
    std::optional<Case> readCase(const std::string& table, const std::string& caseKey, const std::string& setKey,
                                 const Candidate& candidate)
    {
        Case c = reader_.start();
        std::vector<CaseSetting> changes = candidate.set;
        std::ranges::copy(reader_.settings(table + '.' + setKey), std::back_inserter(changes));
        if (const auto named = reader_.text(table + '.' + caseKey)) {
            const CaseDocument document = openFurtherCase(reader_, *named);
            for (const InputProblem& problem : document.problems) reader_.add(table + '.' + caseKey, problem.text());
            if (!document.valid()) return {};
            c = document.value;
        }
        if (!change(c, changes, table, {table + '.' + setKey, candidate.table})) return {};
        if (setKey != "set") return c;
        // Read without `contradict`, too, so that what is wrong in it is told.
        Case against = c;
        if (!change(against, reader_.settings(table + ".against"), table, {table + ".against"})) return {};
        return contradict_ ? against : c;
    }

    /// Returns whether the changed case can be run; else adds why not.
    bool change(Case& c, const std::vector<CaseSetting>& changes, const std::string& table,
                const std::vector<std::string>& keys)
    {
        std::optional<InputProblem> problem = changeCase(c, changes, reader_.outsidePaths());
        if (const std::string reason = problem ? "" : reasonNotToRun(c); !reason.empty())
            problem = InputProblem{"", 0, "", reason};
        if (problem) reader_.addOfSettings(table, keys, *problem);
        return !problem;
    }

    Statement readStatement(const std::string& table, const Candidate& candidate)
    {
        Statement statement;
        statement.figure = needed(table, "figure").value_or("");
        statement.quote = needed(table, "quote").value_or("");
        statement.remark = reader_.text(table + ".remark").value_or("");
        statement.candidate = candidate.name;
        const std::optional<Case> c = readCase(table, "case", "set", candidate);
        std::vector<CaseSetting> shown = candidate.set;
        std::ranges::copy(reader_.settings(table + ".set"), std::back_inserter(shown));
        const std::vector<CaseSetting> against = reader_.settings(table + ".against");
        if (contradict_) std::ranges::copy(against, std::back_inserter(shown));
        if (contradict_ && against.empty() && isWanted(statement))
            reader_.add(table, "has no against: changes with which it must not hold");
        statement.command =
            commandOf(reader_.text(table + ".case").value_or(reader_.text("case").value_or("CASE")), shown);
        if (c) statement.c = *c;
        const bool aboutEnd = readEnds(table, statement);
        if (!c) return statement;
        readLike(table, statement, candidate);
        if (!aboutEnd) readQuantity(table, statement);
        readEnsemble(table, statement);
        return statement;
    }

    /// What is said of the run's end; false where nothing is.
    bool readEnds(const std::string& table, Statement& statement)
    {
        const auto has = [&](const char* leaf) { return reader_.has(table + leaf); };
        const bool any = has(".end") || has(".motion") || has(".like_end");
        if (any && has(".quantity"))
            reader_.add(table, "has an end and a quantity; a statement is about one of the two");
        else if (!any && !has(".quantity"))
            reader_.add(table, "has neither an end nor a quantity, so that nothing would be checked");
        else if (any)
            for (const char* leaf : {".at", ".at_least", ".at_most", ".from", ".to"})
                if (has(leaf)) reader_.add(table + leaf, "belongs to a quantity, and this statement is about an end");
        statement.ends = readNames(table + ".end", endNames(), " is no end of a run");
        statement.motions = readNames(table + ".motion", motionNames(), " is no motion");
        if (const auto likeEnd = reader_.choice(table + ".like_end", {"same", "other"}))
            statement.sameAsLike = *likeEnd == "same";
        return any;
    }

    std::vector<std::string> readNames(const std::string& key, const std::vector<std::string>& names, const char* wrong)
    {
        if (!reader_.has(key)) return {};
        const std::vector<std::string> given = reader_.texts(key).value_or(std::vector<std::string>{});
        for (const std::string& each : given)
            if (std::ranges::find(names, each) == names.end())
                reader_.add(key, inQuotes(each) + wrong + didYouMean(nearestName(each, names)) +
                                     "; allowed: " + choiceText(names));
        return given;
    }

    /// The case that a statement compares with, where it does.
    void readLike(const std::string& table, Statement& statement, const Candidate& candidate)
    {
        const std::string at = reader_.text(table + ".at").value_or("end");
        const bool needed = at == "difference" || at == "distance" || at == "likeness" || statement.sameAsLike;
        const bool useful = needed || at == "end" || at == "swing" || at == "rms" || at == "mean";
        if (!reader_.has(table + ".like")) {
            const bool changes = !reader_.settings(table + ".like_set").empty();
            if (needed)
                reader_.add(table, "has no like: the case that it is compared with");
            else if (changes)
                reader_.add(table + ".like_set", "changes a case that is not given; name it with like");
            return;
        }
        const bool about = reader_.has(table + ".end") || reader_.has(table + ".motion");
        if (!useful || (about && !statement.sameAsLike)) {
            reader_.add(table, "has a like that it does not need");
            return;
        }
        statement.like = readCase(table, "like", "like_set", candidate);
        if (!statement.like) return;
        if ((at == "distance" || at == "likeness") && statement.like->run.duration != statement.c.run.duration)
            reader_.add(table + ".like", "must last as long as the case itself: their motions are compared over time");
        // The samples do not change the motion.
        statement.like->run.sampleInterval = statement.c.run.sampleInterval;
    }

    void readQuantity(const std::string& table, Statement& statement)
    {
        const std::vector<std::string> places = takenNames();
        const std::string at = reader_.choice(table + ".at", places).value_or(places.front());
        statement.taken = static_cast<Taken>(std::ranges::find(places, at) - places.begin());
        std::vector<Quantity> all =
            statement.taken == Taken::Case ? numbersOf(statement.c) : recordedQuantities(statement.c);
        std::vector<std::string> names;
        for (const Quantity& each : all) names.push_back(each.name);
        const auto chosen = reader_.choice(table + ".quantity", names);
        if (!chosen) {
            for (const char* leaf : {".at_least", ".at_most"}) reader_.has(table + leaf);
            return;
        }
        statement.quantity = all[static_cast<std::size_t>(findQuantity(all, *chosen))];
        if (statement.taken == Taken::Peak) {
            if (*chosen != "minimum_spacing" && *chosen != spacingOf(statement.c))
                reader_.add(table + ".quantity",
                            "has no peaks: the spectrum is that of " + inQuotes(spacingOf(statement.c)));
            statement.quantity = {"peak", "Hz", "kHz", "Frequency of a peak"};
        }
        // What is taken of their spectra has no unit; its name is still that of the samples.
        if (statement.taken == Taken::Peaks || statement.taken == Taken::Likeness)
            statement.quantity.unit = statement.quantity.displayUnit = "";
        readBand(table, statement);
        const Quantity& q = statement.quantity;
        const auto bound = [&](const char* leaf) {
            return reader_.number(table + leaf, q.unit, q.displayUnit, -INFINITY, INFINITY);
        };
        const std::optional<double> atLeast = bound(".at_least"), atMost = bound(".at_most");
        if (!reader_.has(table + ".at_least") && !reader_.has(table + ".at_most"))
            reader_.add(table, "has neither at_least nor at_most for its quantity");
        statement.atLeast = atLeast.value_or(statement.atLeast);
        statement.atMost = atMost.value_or(statement.atMost);
        if (statement.atLeast > statement.atMost) reader_.add(table, "has an at_least above its at_most");
        if (statement.like && findQuantity(recordedQuantities(*statement.like), *chosen) < 0)
            reader_.add(table + ".like", "does not record " + inQuotes(*chosen));
    }

    void readBand(const std::string& table, Statement& statement)
    {
        const auto frequency = [&](const char* leaf) {
            return reader_.number(table + leaf, "Hz", "kHz", 0.0, INFINITY);
        };
        for (const auto& [leaf, value] : {std::pair(".from", &statement.from), std::pair(".to", &statement.to)}) {
            if (!reader_.has(table + leaf)) continue;
            if (statement.taken != Taken::Peaks) reader_.add(table + leaf, "belongs to at = \"peaks\"");
            *value = frequency(leaf).value_or(*value);
        }
        if (!(statement.from < statement.to)) reader_.add(table + ".from", "must be below to");
    }

    /// The keys of a case that are numbers.
    static std::vector<Quantity> numbersOf(const Case& c)
    {
        std::vector<Quantity> list;
        for (const Parameter& each : parameters())
            if (std::holds_alternative<double>(each.get(c)))
                list.push_back({each.key, each.unit, each.displayUnit, each.label});
        return list;
    }

    void readEnsemble(const std::string& table, Statement& statement)
    {
        if (!reader_.has(table + ".spread")) return;
        EnsembleTask ensemble;
        ensemble.starts = starts_;
        ensemble.seed = seed_;
        ensemble.key = defaultEnsembleKey(statement.c);
        const Parameter& key = *findParameter(ensemble.key);
        const auto spread = reader_.number(table + ".spread", key.unit, key.displayUnit, 0.0, INFINITY);
        if (spread && *spread == 0.0)
            reader_.add(table + ".spread", "must be greater than 0: all starts would be the same");
        ensemble.spread = spread.value_or(0.0);
        if (starts_ < 2 || contradict_) return;
        // As `run` would check it.
        for (const double start : startsOf(statement.c, ensemble)) {
            Case edge = statement.c;
            auto problem = setFromNumber(edge, key, start);
            if (const auto wrong = checkCombinations(edge); !problem && !wrong.empty()) problem = wrong.front().message;
            if (!problem) continue;
            reader_.add(table + ".spread", "leads to starts at " + fewDigits(start, key.displayUnit, 3) + ", where " +
                                               ensemble.key + ' ' + *problem);
            return;
        }
        statement.ensemble = ensemble;
    }

    StudyReader& reader_;
    std::vector<std::string> only_;
    int starts_ = 0, seed_ = 0;
    bool contradict_ = false;
};

std::string bound(double value, const Quantity& quantity) { return fewDigits(value, quantity.displayUnit, 5); }

} // namespace

std::string expectedText(const Statement& statement)
{
    if (statement.aboutEnd()) {
        std::vector<std::string> parts;
        if (!statement.ends.empty()) parts.push_back(joined(statement.ends, " or "));
        if (!statement.motions.empty()) parts.push_back(joined(statement.motions, " or "));
        if (statement.sameAsLike) parts.emplace_back(*statement.sameAsLike ? "the same end" : "another end");
        return joined(parts, "; ");
    }
    const Quantity& q = statement.quantity;
    if (!std::isfinite(statement.atLeast)) return "at most " + bound(statement.atMost, q);
    if (!std::isfinite(statement.atMost)) return "at least " + bound(statement.atLeast, q);
    return bound(statement.atLeast, q) + " to " + bound(statement.atMost, q);
}

StatementTask readStatements(StudyReader& reader) { return StatementsReader(reader).read(); }

StudyForm statementsForm(const Case&)
{
    StudyForm form;
    form.keys = {
        integerKey("starts", 20, 1, mostStarts,
                   "random starts of each ensemble; 1: only the case itself, without ensembles"),
        integerKey("seed", 1, 0, mostSeed, "of the random starts"),
        onlyOffered(listKey("only", {}, "check only statements whose figure begins with one of these texts")),
        onlyOffered(booleanKey("contradict", false,
                               "run each statement's case with its changes `against`: then none may hold")),
    };
    const std::vector<StudyKey> lists{
        textKey("statement.figure", {}, "", "where the text says it"),
        textKey("statement.quote", {}, "", "what it says"),
        textKey("statement.case", {}, "", "the case that is run; default: that of the study"),
        settingsKey("statement.set", "changes of the case"),
        listKey("statement.end", {},
                "how the run must end, one of these: flying, contact, in and out of contact, or why it fails"),
        listKey("statement.motion", {}, "how its motion must end, one of these: " + joined(motionNames())),
        textKey("statement.like_end", {}, "", "same or other: whether it must end as the case `like` does"),
        textKey("statement.quantity", {}, "", "or a quantity that the run records; at = \"case\": a key of the case"),
        choiceKey("statement.at", "end", takenNames(), "where the quantity is taken"),
        textKey("statement.at_least", {}, "", "its least value, with a unit"),
        textKey("statement.at_most", {}, "", "its greatest value, with a unit"),
        textKey("statement.from", {}, "", "of peaks: the lowest frequency, with a unit"),
        textKey("statement.to", {}, "", "of peaks: the highest frequency, with a unit"),
        textKey("statement.like", {}, "", "the case that it is compared with"),
        settingsKey("statement.like_set", "changes of that case"),
        textKey("statement.spread", {}, "", "half of the range of starts of an ensemble, with a unit"),
        settingsKey("statement.against", "changes of the case with which the statement must not hold"),
        textKey("statement.remark", {}, "", "why it does not hold, or what to know"),
        textKey("candidate.name", {}, "", "a set of changes that all statements are checked with"),
        settingsKey("candidate.set", "its changes"),
    };
    for (const StudyKey& key : lists) form.keys.push_back(inList(key));
    form.lists = "\n[[statement]]\nfigure = \"1\"\nquote = \"The run ends without contact.\"\nend = [\"flying\"]\n";
    return form;
}

} // namespace touchdown

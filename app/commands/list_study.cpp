// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/list_study.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>

#include "app/commands/command_arguments.h"
#include "app/terminal/console.h"
#include "core/formats/words.h"
#include "core/studies/engine/engine.h"
#include "core/studies/study/study_file_reader.h"
#include "core/studies/study_plan.h"
#include "core/work/team.h"

namespace touchdown {

namespace {

constexpr std::size_t mostParts = 1000000000;

/// "3/20"; nothing for anything else.
std::optional<ItemPart> readPart(const std::string& text)
{
    ItemPart part;
    const char* const end = text.data() + text.size();
    const auto first = std::from_chars(text.data(), end, part.part);
    if (first.ec != std::errc() || first.ptr == end || *first.ptr != '/') return {};
    const auto second = std::from_chars(first.ptr + 1, end, part.of);
    const bool good =
        second.ec == std::errc() && second.ptr == end && part.part >= 1 && part.part <= part.of && part.of <= mostParts;
    return good ? std::optional(part) : std::nullopt;
}

std::optional<EngineKind> engineOf(const std::string& name)
{
    if (name == "local") return EngineKind::Local;
    if (name == "slurm") return EngineKind::Slurm;
    if (name == "command") return EngineKind::Command;
    return {};
}

} // namespace

void ListStudy::check(const StudyPlan& plan, const CommandArguments& arguments, std::vector<InputProblem>& problems)
{
    const auto refuse = [&](const char* option, std::string message) {
        problems.push_back({"", 0, option, std::move(message)});
    };
    for (const auto& [option, given] :
         {std::pair("--part", !arguments.part.empty()), std::pair("--join", !arguments.join.empty()),
          std::pair("--resume", arguments.resume)}) {
        if (!given) continue;
        if (plan.valid() && !plan.performList)
            refuse(option, "is for a study that is a list of items, as a sweep or a map of cycles is");
        else if (arguments.out.empty())
            refuse(option, "needs --out FILE.h5");
    }
    if (plan.keepsFiles && arguments.out.empty())
        refuse("--out", "is needed: the study keeps the results of its runs in a folder beside that file");
    else if (plan.keepsFiles)
        options_.files = std::filesystem::path(arguments.out).parent_path() / "runs";
    if (!arguments.part.empty()) {
        if (const auto part = readPart(arguments.part))
            options_.part = *part;
        else
            refuse("--part", "must be K/N, such as 3/20: two whole numbers, K from 1 to N");
    }
    if (!arguments.join.empty() && (arguments.resume || !arguments.part.empty()))
        refuse("--join", "stands alone: it takes whole parts");
    checkEngine(plan, arguments, problems);
    if (!problems.empty() || !plan.performList) return;
    for (const std::string& file : arguments.join) take(file, "--join", problems);
    if (arguments.resume && std::filesystem::exists(arguments.out)) take(arguments.out, "--resume", problems);
    options_.onlyKept = !arguments.join.empty();
    if (arguments.resume || !arguments.engine.empty() || !std::filesystem::exists(arguments.out)) return;
    const StoredStudy there = readStudy(arguments.out);
    if (there.problem.empty() && there.report.status != StudyStatus::Completed && !there.report.items.empty())
        refuse("--out", arguments.out + " holds " + counted(there.report.items.size(), "row") +
                            " of a study that ended early; go on with --resume, or remove that file");
}

std::string ListStudy::open(const CommandArguments& arguments)
{
    if (arguments.out.empty() || options_.onlyKept || !arguments.engine.empty()) return {};
    options_.keep = [this](const std::string& key, const ItemRow& row) { return journal_.keep(key, row); };
    KeptRows inJournal;
    std::string problem = journal_.open(arguments.out, arguments.resume, inJournal);
    // The study's file is replaced while the study goes on: its rows stand in the journal from now on.
    for (auto row = kept_.begin(); row != kept_.end() && problem.empty(); ++row)
        if (!inJournal.contains(row->first)) problem = journal_.keep(row->first, row->second);
    kept_.merge(inJournal);
    return problem;
}

void ListStudy::checkEngine(const StudyPlan& plan, const CommandArguments& arguments,
                            std::vector<InputProblem>& problems)
{
    const auto refuse = [&](const char* option, std::string message) {
        problems.push_back({"", 0, option, std::move(message)});
    };
    if (arguments.engine.empty()) {
        for (const auto& [option, given] :
             {std::pair("--parts", arguments.parts > 0), std::pair("--sbatch", !arguments.sbatch.empty()),
              std::pair("--submit", !arguments.submit.empty())})
            if (given) refuse(option, "needs --engine slurm or --engine command");
        return;
    }
    const auto kind = engineOf(arguments.engine);
    if (!kind) return refuse("--engine", "must be one of local, slurm, command");
    if (plan.valid() && !plan.performList)
        refuse("--engine", "is for a study that is a list of items, as a sweep or a map of cycles is");
    if (arguments.out.empty()) refuse("--engine", "needs --out FOLDER");
    if (arguments.parts == 0) refuse("--engine", "needs --parts N; each part should take minutes");
    if (!arguments.part.empty() || !arguments.join.empty() || arguments.resume)
        refuse("--engine", "makes, continues and joins the parts itself: --part, --join and --resume have no place");
    if (*kind == EngineKind::Command && arguments.submit.empty())
        refuse("--engine", "command needs --submit, such as --submit \"parallel -j8\"");
    if (*kind != EngineKind::Command && !arguments.submit.empty()) refuse("--submit", "is of --engine command");
    if (*kind != EngineKind::Slurm && !arguments.sbatch.empty()) refuse("--sbatch", "is of --engine slurm");
    if (std::string reason = reasonAgainst(*kind); !reason.empty()) refuse("--engine", std::move(reason));
}

StudyReport ListStudy::perform(const StudyPlan& plan, const CommandArguments& arguments, const StudyCallback& callback)
{
    const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    if (const auto kind = engineOf(arguments.engine)) {
        std::error_code error;
        const EngineTask task{.kind = *kind,
                              .folder = std::filesystem::path(arguments.out).parent_path(),
                              .program = std::filesystem::canonical("/proc/self/exe", error),
                              .parts = std::size_t(arguments.parts),
                              .jobs = arguments.jobs > 0           ? arguments.jobs
                                      : *kind == EngineKind::Local ? cores
                                                                   : 1,
                              .options = arguments.sbatch,
                              .submit = arguments.submit};
        return performByEngine(plan, task, callback, [](const std::string& text) { complain(text); });
    }
    options_.jobs = arguments.jobs > 0 ? arguments.jobs : cores;
    // Beside a part, other parts may run on the same machine.
    if (!arguments.part.empty()) setThreadShare(options_.jobs, options_.jobs);
    options_.kept = &kept_;
    options_.taken = &taken_;
    return plan.performList(options_, callback);
}

std::string ListStudy::takenText(const StudyPlan& plan) const
{
    return std::to_string(taken_) + " of " + counted(options_.part.size(plan.items), "item") + " were there already";
}

void ListStudy::take(const std::string& file, const char* option, std::vector<InputProblem>& problems)
{
    StoredStudy stored = readStudy(file);
    if (!stored.problem.empty()) {
        problems.push_back({"", 0, option, stored.problem});
        return;
    }
    for (StudyItem& item : stored.report.items) kept_.emplace(std::move(item.key), std::move(item.row));
}

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/engine/engine.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <memory>
#include <set>
#include <sstream>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "core/case_files/case_text.h"
#include "core/formats/text_file.h"
#include "core/formats/words.h"
#include "core/studies/engine/shell.h"
#include "core/studies/study/item_journal.h"
#include "core/studies/study/study_file.h"
#include "core/studies/study/study_file_reader.h"
#include "core/studies/study_plan.h"
#include "core/work/wall_clock.h"

namespace touchdown {

namespace {

namespace fs = std::filesystem;

constexpr double betweenLooks = 2.0;   // at files and queue [s]
constexpr double latencyOfFiles = 6.0; // after which a file that another computer wrote must be there [s]
constexpr std::size_t lastOfLog = 300; // characters of a part's log in a message

/// A part as its files tell it.
struct Part {
    std::size_t number = 1;
    std::size_t items = 0; // that it has in all
    std::size_t rows = 0;  // that are solved
    bool done = false;
    bool alive = false; // waits or runs
    bool submitted = false;
    double endedAt = 0.0;       // wall clock at which it was first seen without a job [s]; 0: it has one
    std::size_t rowsBefore = 0; // when it was submitted last
    int tries = 0;              // in a row without a new row
    std::string problem{};      // of its file
};

std::string replaced(std::string text, const std::string& what, const std::string& by)
{
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
        text.replace(at, what.size(), by);
    return text;
}

/// "1-5,8" of rising numbers: a command has a limited length.
std::string rangesOf(const std::vector<std::size_t>& numbers)
{
    std::string text;
    for (std::size_t first = 0; first < numbers.size();) {
        std::size_t last = first;
        while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
        text += (text.empty() ? "" : ",") + std::to_string(numbers[first]);
        if (last > first) text += "-" + std::to_string(numbers[last]);
        first = last + 1;
    }
    return text;
}

std::size_t linesIn(const fs::path& file)
{
    std::ifstream in(file, std::ios::binary);
    std::size_t lines = 0;
    std::vector<char> block(1 << 16);
    while (in.read(block.data(), std::streamsize(block.size())), in.gcount() > 0)
        lines += std::size_t(std::count(block.begin(), block.begin() + in.gcount(), '\n'));
    return lines;
}

class Engine {
public:
    Engine(const StudyPlan& plan, const EngineTask& task, const StudyCallback& callback,
           const std::function<void(const std::string&)>& tell)
        : plan_(plan), task_(task), callback_(callback), tell_(tell), folder_(fs::absolute(task.folder))
    {
        for (std::size_t k = 1; k <= task.parts; ++k) {
            parts_.emplace_back().number = k;
            parts_.back().items = ItemPart{k, task.parts}.size(plan.items);
        }
    }

    StudyReport perform()
    {
        if (std::string problem = prepare(); !problem.empty()) return failed(problem);
        while (true) {
            if (std::string problem = look(); !problem.empty()) return failed(problem);
            if (std::ranges::all_of(parts_, &Part::done)) return join();
            if (std::string problem = submitWhatIsNotDone(); !problem.empty()) return failed(problem);
            if (!wait()) return left();
        }
    }

private:
    fs::path fileOf(const Part& part) const { return folder_ / ("part_" + std::to_string(part.number) + ".h5"); }
    fs::path logOf(const Part& part) const { return folder_ / "log" / (std::to_string(part.number) + ".txt"); }
    fs::path script() const { return folder_ / "part.sh"; }

    static StudyReport failed(std::string reason)
    {
        StudyReport report;
        report.status = StudyStatus::Failed;
        report.message = std::move(reason);
        return report;
    }

    StudyReport left() const
    {
        StudyReport report;
        report.status = StudyStatus::Cancelled;
        report.message =
            task_.kind == EngineKind::Slurm && !jobs_.empty()
                ? "the jobs go on; the same study with the same folder follows them again and joins their parts"
                : "stopped; the same study with the same folder goes on with what is solved";
        return report;
    }

    /// The folder with the study and the script. Returns the problem, or "".
    std::string prepare()
    {
        std::error_code error;
        fs::create_directories(folder_ / "log", error);
        if (error) return "cannot make the folder " + folder_.string() + ": " + error.message();
        const fs::path study = folder_ / "study.h5";
        const Case& c = plan_.start.value;
        const std::string caseText = updateCaseText(plan_.start.text, c);
        if (fs::exists(study)) {
            const StoredStudy stored = readStudy(study);
            if (!stored.problem.empty()) return stored.problem;
            if (stored.caseText != caseText || stored.studyText != plan_.text || stored.options != plan_.options)
                return folder_.string() +
                       " holds another study, or this one before it was changed; name another folder";
        } else {
            StudyReport empty;
            empty.kind = plan_.kind;
            empty.title = plan_.title;
            StudyWriter writer;
            std::string problem = writer.open(study, {plan_.kind, plan_.title, c, caseText, plan_.text, plan_.options});
            if (problem.empty()) problem = writer.finish(interruptedReport(empty));
            if (!problem.empty()) return problem;
        }
        if (std::string problem = copySurface(c); !problem.empty()) return problem;
        // Another number of parts would leave files of the first ones.
        if (fs::exists(script())) {
            const auto text = readTextFile(script(), 1 << 20);
            const auto* before = std::get_if<std::string>(&text);
            if (before != nullptr && before->find("parts=" + std::to_string(task_.parts) + "\n") == std::string::npos)
                return folder_.string() + " was made for another number of parts (part.sh)";
            if (before != nullptr && *before != scriptText())
                tell_(script().string() + " is used as it is; this command would write another one");
        } else if (std::string problem = writeTextFile(script(), scriptText()); !problem.empty()) {
            return script().string() + ": " + problem;
        }
        fs::permissions(script(), fs::perms::owner_exec, fs::perm_options::add, error);
        readJobs();
        return {};
    }

    /// The file of a measured surface stands where the case names it, beside the study. Returns the problem, or "".
    std::string copySurface(const Case& c) const
    {
        const fs::path file = c.diskSurface.file;
        if (file.empty()) return {};
        const fs::path name = file.lexically_normal();
        if (name.is_absolute()) return {};
        if (*name.begin() == "..")
            return "the case names " + file.string() + ", outside its folder; put it beside the case for an engine";
        std::error_code error;
        fs::create_directories((folder_ / name).parent_path(), error);
        fs::copy_file(c.folder / name, folder_ / name, fs::copy_options::update_existing, error);
        return error ? "cannot copy " + file.string() + " to " + folder_.string() + ": " + error.message() : "";
    }

    std::string scriptText() const
    {
        std::string text = "#!/bin/bash\n";
        if (task_.kind == EngineKind::Slurm)
            text += "#SBATCH --job-name=touchdown\n#SBATCH --output=log/%a.txt\n#SBATCH --open-mode=append\n#SBATCH "
                    "--cpus-per-task=" +
                    std::to_string(task_.jobs) + "\n";
        return text +
               "# Solves one part of the study: part $1, or the one that Slurm names.\n"
               "# What its file holds already is not solved again.\n"
               "parts=" +
               std::to_string(task_.parts) +
               "\n"
               "part=${1:-$SLURM_ARRAY_TASK_ID}\n"
               "cd " +
               shellWord(folder_.string()) + " || exit 1\n" + (task_.kind == EngineKind::Slurm ? "exec " : "") +
               shellWord(task_.program.string()) + " study " + plan_.kind +
               " study.h5 --part \"$part/$parts\" --out \"part_$part.h5\" --resume --jobs " +
               std::to_string(task_.jobs) +
               (task_.kind == EngineKind::Slurm ? " > /dev/null\n" : " > /dev/null 2>> \"log/$part.txt\"\n");
    }

    void readJobs()
    {
        std::ifstream in(folder_ / "jobs.txt");
        for (std::string job; in >> job;) jobs_.push_back(job);
    }

    /// What is done, by the files; what waits or runs, by the queue. Returns the problem, or "".
    std::string look()
    {
        for (Part& part : parts_) {
            if (part.done) continue;
            const fs::path journal = ItemJournal::besides(fileOf(part));
            std::error_code error;
            if (fs::exists(journal, error)) {
                const std::size_t lines = linesIn(journal);
                part.rows = std::max(part.rows, std::min(lines > 0 ? lines - 1 : 0, part.items));
            } else if (fs::exists(fileOf(part), error)) {
                const StoredStudy stored = readStudy(fileOf(part));
                part.rows = stored.report.items.size();
                part.problem = stored.problem;
                part.done = stored.problem.empty() && part.rows >= part.items;
            }
            part.done = part.done || part.items == 0;
        }
        if (task_.kind == EngineKind::Slurm) return lookAtQueue();
        const bool runs = process_ && !process_->ended();
        for (Part& part : parts_) part.alive = runs && part.submitted;
        if (process_ && !runs) process_.reset();
        return {};
    }

    std::string lookAtQueue()
    {
        std::set<std::size_t> alive;
        std::erase_if(jobs_, [&](const std::string& job) {
            const ShellAnswer answer = askShell("squeue -h -r -j " + shellWord(job) + " -o %K");
            if (answer.code != 0) {
                // A job that ended some minutes ago is not known any more; anything else may pass.
                if (answer.output.find("Invalid job id") != std::string::npos) return true;
                queueKnown_ = false;
                return false;
            }
            std::istringstream lines(answer.output);
            bool any = false, said = false;
            for (std::string line; std::getline(lines, line);) { // beside numbers, there may be warnings
                const std::string word(trimmed(line));
                if (word.empty()) continue;
                said = true;
                if (word.find_first_not_of("0123456789") != std::string::npos || word.size() > 9) continue;
                alive.insert(std::stoul(word));
                any = true;
            }
            queueKnown_ = queueKnown_ && (any || !said);
            return !said;
        });
        if (!std::exchange(queueKnown_, true)) {
            if (silentSince_ == 0.0) {
                silentSince_ = wallClock();
                tell_("the queue of Slurm does not answer; looking again");
            }
            return {};
        }
        silentSince_ = 0.0;
        for (Part& part : parts_) {
            part.alive = alive.contains(part.number);
            part.submitted = part.submitted || part.alive;
        }
        return {};
    }

    /// Returns the problem, or "".
    std::string submitWhatIsNotDone()
    {
        if (silentSince_ > 0.0 || process_) return {};
        std::vector<std::size_t> numbers;
        std::vector<Part*> submitted;
        for (Part& part : parts_) {
            if (part.done || part.alive) {
                part.endedAt = 0.0;
                continue;
            }
            if (part.submitted) {
                if (part.endedAt == 0.0) part.endedAt = wallClock();
                // What failed at once, such as a full disk, may pass.
                const double pause = task_.kind == EngineKind::Slurm ? latencyOfFiles
                                     : part.rows > part.rowsBefore   ? 0.0
                                                                     : betweenLooks;
                if (wallClock() - part.endedAt < pause) continue;
                part.tries = part.rows > part.rowsBefore ? 0 : part.tries + 1;
                if (part.tries >= task_.tries)
                    return "part " + std::to_string(part.number) + " ended " + std::to_string(part.tries) +
                           " times without solving an item" +
                           (part.problem.empty() ? lastWords(part) : ": " + part.problem);
                tell_("part " + std::to_string(part.number) + " ended with " + std::to_string(part.rows) + " of " +
                      counted(part.items, "item") + "; submitted again");
            }
            numbers.push_back(part.number);
            submitted.push_back(&part);
        }
        if (numbers.empty()) return {};
        if (std::string problem = submit(numbers); !problem.empty()) return problem;
        for (Part* part : submitted) {
            part->submitted = part->alive = true;
            part->rowsBefore = part->rows;
            part->endedAt = 0.0;
        }
        return {};
    }

    std::string submit(const std::vector<std::size_t>& numbers)
    {
        if (task_.kind != EngineKind::Slurm) {
            std::string command =
                task_.kind == EngineKind::Local ? "for part in {parts}; do {script} $part; done" : task_.submit;
            if (command.find("{script}") == std::string::npos && command.find("{parts}") == std::string::npos)
                command += " {script} ::: {parts}";
            command = replaced(std::move(command), "{script}", "./part.sh");
            std::string list;
            for (const std::size_t number : numbers) list += (list.empty() ? "" : " ") + std::to_string(number);
            command = replaced(std::move(command), "{parts}", list);
            process_ = std::make_unique<ShellProcess>("cd " + shellWord(folder_.string()) + " && { " + command +
                                                      "\n} >> log/launcher.txt 2>&1");
            return {};
        }
        const ShellAnswer answer =
            askShell("cd " + shellWord(folder_.string()) + " && sbatch --parsable --array=" + rangesOf(numbers) + " " +
                     task_.options + " " + shellWord(script().string()));
        if (answer.code != 0) return "sbatch refused the jobs: " + std::string(trimmed(answer.output));
        std::istringstream lines(answer.output);
        std::string job, line;
        while (std::getline(lines, line)) // a plugin may write lines of its own before
            if (!line.empty() && line.find_first_not_of("0123456789;abcdefghijklmnopqrstuvwxyz_-") == std::string::npos)
                job = line.substr(0, line.find(';'));
        if (job.empty()) return "sbatch gave no number of a job: " + std::string(trimmed(answer.output));
        jobs_.push_back(job);
        std::ofstream(folder_ / "jobs.txt", std::ios::app) << job << '\n';
        return {};
    }

    std::string lastWords(const Part& part) const
    {
        for (const fs::path& file : {logOf(part), folder_ / "log" / "launcher.txt"}) {
            const auto text = readTextFile(file, 1 << 24, FileContent::Any);
            const auto* log = std::get_if<std::string>(&text);
            if (log == nullptr || trimmed(*log).empty()) continue;
            const std::string_view all = trimmed(*log);
            const std::string_view last = all.substr(all.rfind('\n') + 1); // of no line end: from the beginning
            return ": " + std::string(last.substr(0, lastOfLog));
        }
        return {};
    }

    /// Tells the progress until the next look; false to stop.
    bool wait()
    {
        std::size_t rows = 0, done = 0, alive = 0;
        for (const Part& part : parts_) {
            rows += part.done ? part.items : part.rows;
            done += part.done ? 1 : 0;
            alive += part.alive ? 1 : 0;
        }
        const std::string doing = std::to_string(rows) + " of " + counted(plan_.items, "item") + ", " +
                                  std::to_string(done) + " of " + counted(parts_.size(), "part") + " done, " +
                                  std::to_string(alive) + " under way";
        const double until = wallClock() + betweenLooks;
        do {
            if (callback_ && !callback_({double(rows) / double(std::max<std::size_t>(plan_.items, 1)), doing, nullptr}))
                return false;
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
            if (process_ && process_->ended()) return true;
        } while (wallClock() < until);
        return true;
    }

    StudyReport join()
    {
        KeptRows kept;
        for (const Part& part : parts_) {
            if (part.items == 0) continue;
            StoredStudy stored = readStudy(fileOf(part));
            for (StudyItem& item : stored.report.items) kept.emplace(std::move(item.key), std::move(item.row));
        }
        const StudyCallback joining = [&](const StudyProgress& progress) {
            return !callback_ || callback_({1.0, "joining the parts", progress.soFar});
        };
        StudyReport report = plan_.performList({.jobs = task_.jobs, .kept = &kept, .onlyKept = true}, joining);
        if (report.status == StudyStatus::Failed && report.items.size() < plan_.items)
            report.message +=
                "; a file of a part has rows of another study or version: remove it, and the same command "
                "solves its part again";
        return report;
    }

    const StudyPlan& plan_;
    const EngineTask& task_;
    const StudyCallback& callback_;
    const std::function<void(const std::string&)>& tell_;
    fs::path folder_;
    std::vector<Part> parts_;
    std::vector<std::string> jobs_; // of Slurm, that may be in its queue
    bool queueKnown_ = true;
    double silentSince_ = 0.0; // wall clock since which the queue does not answer [s]; 0: it does
    std::unique_ptr<ShellProcess> process_;
};

} // namespace

std::string reasonAgainst(EngineKind kind)
{
    if (kind != EngineKind::Slurm) return {};
    for (const char* program : {"sbatch", "squeue"})
        if (askShell(std::string("command -v ") + program).code != 0)
            return std::string("there is no ") + program + " on this computer: Slurm is not installed, or not in PATH";
    return {};
}

StudyReport performByEngine(const StudyPlan& plan, const EngineTask& task, const StudyCallback& callback,
                            const std::function<void(const std::string&)>& tell)
{
    return Engine(plan, task, callback, tell).perform();
}

} // namespace touchdown

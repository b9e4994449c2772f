// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/terminal/refusal.h"

#include <algorithm>
#include <span>

#include "app/terminal/console.h"
#include "core/formats/words.h"

namespace touchdown {

Json problemsJson(const std::vector<InputProblem>& problems)
{
    Json list = Json::array();
    for (const InputProblem& problem : problems)
        list.push_back({{"file", problem.file},
                        {"line", problem.line > 0 ? Json(problem.line) : Json(nullptr)},
                        {"key", problem.key},
                        {"message", problem.message}});
    return list;
}

std::string refusalJson(const std::vector<InputProblem>& problems)
{
    std::string message = problems.front().text();
    if (problems.size() > 1) message += "; and " + counted(problems.size() - 1, "further problem");
    return jsonText({{"status", "wrong input"}, {"message", message}, {"problems", problemsJson(problems)}});
}

void complainOf(const std::vector<InputProblem>& problems, const std::string& prefix)
{
    constexpr std::size_t most = 20;
    const std::size_t shown = std::min(problems.size(), most);
    for (const InputProblem& problem : std::span(problems).first(shown)) complain(prefix + problem.text());
    if (problems.size() > shown) complain(prefix + "and " + counted(problems.size() - shown, "further problem"));
}

int refuse(const std::vector<InputProblem>& problems, bool json)
{
    complainOf(problems);
    if (json) print(refusalJson(problems));
    return exitWrongInput;
}

int fail(const std::string& message, bool json)
{
    complain("failed: " + message);
    if (json) print(jsonText({{"status", "failed"}, {"message", message}}));
    return exitNoAnswer;
}

std::string outOfMemory(const std::string& name)
{
    return "the memory does not suffice for " + name +
           "; fewer nodes (film.nodes), larger cells (elastic.cell), longer intervals (run.sample_interval), fewer "
           "maps "
           "(run.field_snapshots) or fewer --jobs need less";
}

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/terminal/refusal.h"

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

int refuse(const std::vector<InputProblem>& problems, bool json)
{
    for (const InputProblem& problem : problems) complain(problem.text());
    if (json) print(refusalJson(problems));
    return exitWrongInput;
}

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/describe_study.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <vector>

#include "app/terminal/aligned_table.h"
#include "app/terminal/console.h"
#include "app/terminal/json_text.h"
#include "app/terminal/wrapped_text.h"
#include "core/formats/nearest_name.h"
#include "core/studies/study_plan.h"

namespace touchdown {

namespace {

/// "5; film: 3".
std::string standardText(const DescribedKey& key)
{
    std::string text;
    for (const auto& [model, value] : key.standards) {
        if (text.empty())
            text = value;
        else if (value != key.standards.front().second)
            text += "; " + model + ": " + value;
    }
    return text;
}

std::string keyText(const DescribedKey& key, std::size_t width)
{
    const std::string standard = standardText(key);
    const std::string allowed = wrapped(key.allowed + (key.varies ? ", by the case" : ""), width + 2).substr(width + 2);
    std::string more = key.key.help;
    if (!more.empty())
        more = static_cast<char>(std::toupper(static_cast<unsigned char>(more.front()))) + more.substr(1) + ". ";
    if (!standard.empty()) more += "Default: " + standard + ".";
    return padded(key.key.key, width) + allowed + (more.empty() ? "" : wrapped(more, 6));
}

std::string keysText(const std::vector<DescribedKey>& keys)
{
    std::size_t width = 3;
    for (const DescribedKey& each : keys) width = std::max(width, each.key.key.size());
    std::string text = padded("KEY", width) + "ALLOWED\n", table;
    for (const DescribedKey& each : keys) {
        const std::string& key = each.key.key;
        const auto dot = key.find('.');
        const std::string its = dot == std::string::npos ? "" : key.substr(0, dot);
        if (its != table) text += each.key.inList ? "\n[[" + its + "]], any number of them\n" : "\n[" + its + "]\n";
        table = its;
        text += keyText(each, width);
    }
    return text;
}

Json keysJson(const std::vector<DescribedKey>& keys)
{
    Json all = Json::array();
    for (const DescribedKey& each : keys) {
        Json standards = Json::object();
        for (const auto& [model, value] : each.standards) standards[model] = value;
        all.push_back({{"key", each.key.key},
                       {"allowed", each.allowed},
                       {"varies", each.varies},
                       {"unit", each.key.unit},
                       {"display_unit", each.key.displayUnit},
                       {"default", standards},
                       {"help", each.key.help}});
    }
    return all;
}

int describeKinds(bool json)
{
    Json all = Json::array();
    std::vector<std::vector<std::string>> rows;
    for (const StudyKind& kind : studyKinds()) {
        all.push_back({{"name", kind.name}, {"title", kind.title}, {"help", kind.help}});
        rows.push_back({kind.name, kind.title});
    }
    print(json ? jsonText({{"kinds", all}})
               : alignedTable(rows, {true, true}) + "\n`touchdown describe study.KIND` lists the keys of one.\n");
    return exitDone;
}

int describeKind(const StudyKind& kind, const std::string& wanted, bool json)
{
    std::vector<DescribedKey> keys = studyKeys(kind.name);
    std::vector<std::string> names;
    for (const DescribedKey& each : keys) names.push_back(each.key.key);
    if (!wanted.empty())
        std::erase_if(keys, [&](const DescribedKey& each) {
            return each.key.key != wanted && !each.key.key.starts_with(wanted + '.');
        });
    if (keys.empty()) {
        complain(wanted + ": unknown key of a study of kind " + kind.name + didYouMean(nearestName(wanted, names)));
        return exitWrongInput;
    }
    if (json) {
        print(jsonText({{"kind", kind.name}, {"keys", keysJson(keys)}}));
        return exitDone;
    }
    const std::string command = kind.name == "advise" ? "advise" : "study " + kind.name;
    print(wrapped(kind.title + ". " + kind.help + ". The keys of its file, and of --option; `touchdown " + command +
                      " CASE --template` prints a file to begin with.",
                  0) +
          "\n" + keysText(keys));
    return exitDone;
}

} // namespace

std::optional<int> describeStudy(const std::string& key, bool json)
{
    constexpr std::string_view prefix = "study.";
    if (key == "study") return describeKinds(json);
    const std::string name = key.starts_with(prefix) ? key.substr(prefix.size()) : key;
    std::vector<std::string> kinds;
    std::string list;
    for (const StudyKind& kind : studyKinds()) {
        kinds.push_back(kind.name);
        list += (list.empty() ? "" : ", ") + kind.name;
        if (name == kind.name) return describeKind(kind, {}, json);
        if (name.starts_with(kind.name + '.')) return describeKind(kind, name.substr(kind.name.size() + 1), json);
    }
    if (!key.starts_with(prefix)) return {};
    complain(key + ": unknown kind of study: allowed is one of " + list + didYouMean(nearestName(name, kinds)));
    return exitWrongInput;
}

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/study_keys.h"

#include <algorithm>
#include <string_view>

#include "core/case/fields.h"
#include "core/studies/study/key_path.h"
#include "core/studies/study_plan.h"

namespace touchdown {

namespace {

bool isOffer(std::string_view line)
{
    if (!line.starts_with("# ")) return false;
    line.remove_prefix(2);
    if (line.starts_with('[')) return line.find(']') != std::string_view::npos;
    const auto end = line.find_first_not_of("abcdefghijklmnopqrstuvwxyz_");
    return end != 0 && line.substr(std::min(end, line.size())).starts_with(" = ");
}

/// With all that the template offers.
std::string withOffers(const std::string& text)
{
    std::string all;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string_view line = std::string_view(text).substr(at, end - at);
        all += std::string(isOffer(line) ? line.substr(2) : line) + '\n';
        at = end + 1;
    }
    return all;
}

/// What stands behind a value in its line.
std::string commentOf(const std::string& text, const TomlEntry& entry)
{
    const std::string line = text.substr(entry.end, text.find('\n', entry.end) - entry.end);
    const auto mark = line.find("# ");
    return mark == std::string::npos ? std::string() : line.substr(mark + 2);
}

std::string valueOf(const std::string& text, const TomlEntry& entry)
{
    if (const auto* bare = std::get_if<std::string>(&entry.value)) return *bare;
    return text.substr(entry.begin, entry.end - entry.begin);
}

/// Adds the keys that a study asks for of this case.
void addKeys(std::vector<StudyKey>& keys, const std::string& kind, const Case& c)
{
    const std::string text = withOffers(studyTemplate(kind, c));
    const StudyPlan plan = parseStudy(kind, text, kind, {}, &c);
    if (std::ranges::find(plan.problems, "case", &InputProblem::key) != plan.problems.end())
        return; // it cannot be made of this model
    const TomlDocument toml = readToml(text);
    for (const StudyQuestion& question : plan.questions) {
        auto key = std::ranges::find(keys, question.key, &StudyKey::key);
        if (key == keys.end())
            key = keys.insert(key, {question.key, question.answer, question.unit, question.displayUnit, {}, {}});
        key->varies = key->varies || key->allowed != question.answer;
        const auto entry = std::ranges::find(toml.entries, question.key,
                                             [](const TomlEntry& each) { return withoutNumbers(each.key); });
        if (entry == toml.entries.end()) continue;
        key->inList = entry->key.find('[') != std::string::npos;
        if (key->help.empty()) key->help = commentOf(text, *entry);
        if (!key->inList) key->standards.emplace_back(toText(c, *findField("model")), valueOf(text, *entry));
    }
}

} // namespace

std::vector<StudyKey> studyKeys(const std::string& kind)
{
    std::vector<StudyKey> keys;
    for (const ModelKind model : {ModelKind::Springs, ModelKind::Film, ModelKind::Contact})
        addKeys(keys, kind, defaultsOf(model));
    return keys;
}

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/terminal/mistaken_words.h"

#include <algorithm>
#include <filesystem>

#include "core/case_files/case_file.h"
#include "core/formats/nearest_name.h"
#include "core/formats/quotation.h"
#include "core/formats/words.h"
#include "core/studies/study_plan.h"

namespace touchdown {

namespace {

using Words = std::vector<std::string>;

bool contains(const Words& words, const std::string& word) { return std::ranges::find(words, word) != words.end(); }

bool isWord(const std::string& argument)
{
    return !argument.starts_with('-') && argument.find('=') == std::string::npos;
}

bool isCase(const std::string& name)
{
    std::error_code error;
    return std::filesystem::exists(name, error) ||
           std::ranges::any_of(sampleCases(), [&](const SampleCase& sample) { return sample.name == name; });
}

/// Takes the first word that is one of `names` out of the arguments; "" if there is none.
std::string take(Words& arguments, const Words& names)
{
    const auto found =
        std::ranges::find_if(arguments, [&](const std::string& each) { return isWord(each) && contains(names, each); });
    if (found == arguments.end()) return {};
    std::string word = *found;
    arguments.erase(found);
    return word;
}

/// The same for a word that is similar to one of them.
std::string takeNear(Words& arguments, const Words& names)
{
    for (auto each = arguments.begin(); each != arguments.end(); ++each) {
        if (!isWord(*each) || isCase(*each)) continue;
        std::string near = nearestName(*each, names);
        if (near.empty()) continue;
        arguments.erase(each);
        return near;
    }
    return {};
}

/// The kind of the study that one of the arguments names.
std::string kindNamed(const Words& arguments, const Words& kinds)
{
    for (const std::string& each : arguments)
        if (const auto source = findStudySource(each); source && contains(kinds, source->kind)) return source->kind;
    return {};
}

/// The arguments that were probably meant; none if there is no suggestion.
Words likelyMeant(Words rest, const CommandWords& known)
{
    Words meant;
    std::string command = take(rest, known.commands);
    std::string kind = command.empty() || command == "study" ? take(rest, known.kinds) : std::string();
    const bool isStudy = command == "study" || !kind.empty();
    if (command.empty() && !isStudy) command = takeNear(rest, known.commands);
    if (kind.empty() && (isStudy || command.empty())) kind = takeNear(rest, known.kinds);
    if (kind.empty() && (isStudy || command.empty())) kind = kindNamed(rest, known.kinds);
    if (command.empty() && !kind.empty()) command = "study";
    if (command.empty() && std::ranges::any_of(rest, isCase)) command = "run";
    if (command.empty() || (command == "study" && kind.empty())) return {};
    meant.push_back(command);
    if (!kind.empty()) meant.push_back(kind);
    meant.insert(meant.end(), rest.begin(), rest.end());
    return meant;
}

std::string asTyped(const Words& arguments)
{
    std::string line = "`touchdown";
    for (const std::string& each : arguments)
        line += ' ' + (each.find(' ') == std::string::npos ? each : inQuotes(each));
    return line + '`';
}

} // namespace

std::string mistakenWord(const Words& arguments, const CommandWords& known)
{
    if (arguments.empty() || arguments.front().starts_with('-')) return {};
    const bool isStudy = arguments.front() == "study";
    const std::size_t at = isStudy ? 1 : 0;
    if (at >= arguments.size() || arguments[at].starts_with('-') ||
        contains(isStudy ? known.kinds : known.commands, arguments[at]))
        return {};
    const std::string sentence = inQuotes(arguments[at]) + (isStudy ? " is no kind of study" : " is no command");
    const Words meant = likelyMeant(arguments, known);
    if (meant.empty()) return isStudy ? sentence + ": allowed is one of " + joined(known.kinds, ", ") : sentence;
    Words inPlace = arguments;
    inPlace[at] = meant[at];
    return sentence + didYouMean(inPlace == meant ? meant[at] : asTyped(meant));
}

std::string notTaken(const std::string& command, const Words& left, const Words& options)
{
    for (const std::string& each : left) {
        if (!each.starts_with("--") || contains(options, each)) continue;
        const std::string name = each.substr(0, each.find('='));
        return command + ": " + name + " is no option" + didYouMean(nearestName(name, options));
    }
    Words quoted;
    for (const std::string& each : left) quoted.push_back(inQuotes(each));
    return command + ": " + joined(quoted) + (left.size() > 1 ? " were" : " was") + " not expected";
}

} // namespace touchdown

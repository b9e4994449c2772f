// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/study/sample_study.h"

#include <algorithm>

#include "core/formats/toml_document.h"
#include "core/studies/study/study_head.h"

namespace touchdown {

namespace {

std::string rootText(const TomlDocument& toml, std::string_view key)
{
    const auto entry = std::ranges::find(toml.entries, key, &TomlEntry::key);
    const auto* text = entry == toml.entries.end() ? nullptr : std::get_if<std::string>(&entry->value);
    return text == nullptr ? std::string() : *text;
}

std::vector<SampleStudy> readSamples()
{
    std::vector<SampleStudy> studies;
    for (const SampleStudyText& each : sampleStudyTexts()) {
        const TomlDocument toml = readStudyText(each.text);
        studies.push_back({each.name, rootText(toml, "kind"), rootText(toml, "title"), each.text});
    }
    std::ranges::stable_sort(studies, {}, &SampleStudy::kind);
    return studies;
}

} // namespace

const std::vector<SampleStudy>& sampleStudies()
{
    static const std::vector<SampleStudy> studies = readSamples();
    return studies;
}

const SampleStudy* findSampleStudy(std::string_view kind, std::string_view name)
{
    for (const SampleStudy& each : sampleStudies())
        if (each.kind == kind && each.name == name) return &each;
    return nullptr;
}

std::vector<std::string> sampleStudyNames(std::string_view kind)
{
    std::vector<std::string> names;
    for (const SampleStudy& each : sampleStudies())
        if (each.kind == kind) names.push_back(each.name);
    return names;
}

} // namespace touchdown

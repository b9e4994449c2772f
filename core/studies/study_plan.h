// SPDX-License-Identifier: GPL-3.0-or-later
//
// The studies by name, each as something that can be performed. A study's file is TOML:
//
//   kind = "work-precision"        # may be left out
//   title = "..."                  # may be left out
//   case = "../fig10a.toml"        # beside the study, or the name of a sample case
//   set = { "run.duration" = "1 ms" }   # changes of the case, may be left out
//   ...                            # keys of the study itself: see its header
//
// Where a case is given instead of a study's file, the study takes its defaults for that case.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/case/case_document.h"
#include "core/case_files/outside_path.h"
#include "core/studies/study/item_study.h"
#include "core/studies/study/study.h"
#include "core/studies/study/study_key.h"

namespace touchdown {

class StudyReader;
struct StoredStudy;

struct StudyKind {
    std::string name;                            // "work-precision"
    std::string title;                           // "Accuracy against speed"
    std::string help;                            // a sentence
    std::function<StudyWork(StudyReader&)> plan; // reads the keys; their problems are the reader's
    StudyForm (*form)(const Case&);              // its keys with their defaults for a case
    bool findsCase = false;                      // its report may hold a case, which --apply writes
    std::string openEnd{};                       // why its duration cannot be predicted; "" where it can
};
/// In the order in which they are offered.
std::span<const StudyKind> studyKinds();

struct StudyPlan {
    std::string kind;
    std::string name; // of the file, for problems
    std::string title;
    std::string text;                          // the study's file; "" where a case was given
    std::vector<std::string> options;          // "key=value", over those of the text
    CaseDocument start;                        // the case that is studied
    std::vector<InputProblem> problems;        // all of them, those of the case among them
    std::string openEnd;                       // of the kind
    std::vector<std::filesystem::path> inputs; // all files that were read: the study, its cases and their files
    StudyPerformance perform;                  // set where there is no problem
    std::size_t items = 0;                     // of a study that is a list
    bool keepsFiles = false;                   // whole results of its items, in ItemOptions::files
    std::function<Case(std::size_t)> caseOf;   // of a row of its first table; not set where rows are no cases
    /// The same of such a study, also of a part of it; else not set.
    std::function<StudyReport(const ItemOptions&, const StudyCallback&)> performList;
    bool valid() const { return problems.empty(); }
};

/// What a study's file or a sample study is, by the name that openStudy takes.
struct StudySource {
    std::string kind; // that it names; "" where it names none
    int kindLine = 0;
    std::string text;
};
/// Nothing where the name is that of a case, or of nothing.
std::optional<StudySource> findStudySource(const std::string& fileOrName);
/// The kind of the study that a file or a sample names, also a file that a study wrote; "" for none.
std::string studyKindIn(const std::string& fileOrName);

/// `fileOrName`: a study's file, a case file, a folder of the established program, or the name of a sample study of
/// this kind or of a sample case. The settings are those of --set, on the case; the options are those of --option:
/// "key=value" with a key of the study and a value as TOML or as bare text, over those of its file. `outside`: whether
/// study and case may name files outside their folders (core/case_files/outside_path.h).
StudyPlan openStudy(const std::string& kind, const std::string& fileOrName,
                    const std::vector<std::string>& settings = {}, const std::vector<std::string>& options = {},
                    OutsidePaths outside = OutsidePaths::Refused);
/// The study of a file that the program wrote, as it was performed.
StudyPlan reopenStudy(const StoredStudy& stored);
/// A study's text that stands in `folder`. `given` is the case where the text names none.
StudyPlan parseStudy(const std::string& kind, const std::string& text, const std::string& name,
                     const std::filesystem::path& folder, const Case* given = nullptr,
                     const std::vector<std::string>& settings = {}, const std::vector<std::string>& options = {});
/// All keys of a study of this case, those of the head first; none for an unknown kind.
StudyForm studyForm(const std::string& kind, const Case& c);
/// The text of a study of this case: its kind and its defaults, with a comment for each key.
std::string studyTemplate(const std::string& kind, const Case& c);
/// The text of a sweep of this case over one of its keys, a number or a choice.
std::string sweepTemplate(const Case& c, const std::string& key);

/// A key of a kind of study over all models of a case, for `touchdown describe study.KIND`.
struct DescribedKey {
    StudyKey key;                                               // of the first model that the study takes
    std::string allowed;                                        // "a whole number from 1 to 1000"
    std::vector<std::pair<std::string, std::string>> standards; // the default of each model: {"springs", "5"}
    bool varies = false;                                        // `allowed` depends on the case
};

/// In the order of the study's file; none for an unknown kind.
std::vector<DescribedKey> studyKeys(const std::string& kind);

} // namespace touchdown

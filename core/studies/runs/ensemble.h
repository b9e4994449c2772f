// SPDX-License-Identifier: GPL-3.0-or-later
//
// Many runs of a case from starts close to each other. Where two end states lie close by, or a bounce is chaotic, one
// trajectory depends on the last digit of everything, and its error means nothing; the share of starts that ends in
// each state does mean something, and has an uncertainty.
//
// Starts are drawn at random, evenly over [x0 - s, x0 + s]; the same seed draws the same ones. So the share of the
// whole range lies, with a probability of 95 %, in Wilson's interval of n starts out of N with an end, p = n/N
// (z = 1.96; Wilson, J. Am. Stat. Assoc. 22, 1927):
//
//   (p + z^2/2N -+ z sqrt(p (1 - p)/N + z^2/4N^2)) / (1 + z^2/N)
//
// Two ways to run the same starts are compared start by start (McNemar, Psychometrika 12, 1947): with b starts that
// only the first one ends so, and c that only the second one does, the shares differ by (b - c)/N. Were they the same,
// that would be 0 with the standard error sqrt(b + c)/N. Where |b - c| - 1 > 2 sqrt(b + c) (the 1 for small numbers:
// Edwards, Psychometrika 13, 1948), the difference is not by chance.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/case/case.h"
#include "core/studies/runs/measured_run.h"

namespace touchdown {

struct StudyReport;

struct EnsembleTask {
    std::string key = "initial.flying_height"; // of a number
    int starts = 300;
    double spread = 0.5e-9; // s [unit of the key]
    int seed = 1;           // 0 to mostSeed
};
inline constexpr int mostSeed = 2147483647;

/// The key of a case's start that an ensemble draws: a height.
std::string defaultEnsembleKey(const Case& c);

/// Where one start led.
struct EnsembleEnd {
    EndState state;
    RunFailure failure = RunFailure::None;
    double work = 0.0; // right-hand sides, or film solves
};

/// One way to run all starts.
struct Ensemble {
    std::string method, setting;
    Case c;
    std::vector<EnsembleEnd> ends; // as many as starts
};

/// Right-hand sides of springs, films solved otherwise.
double workOf(const Case& c, const Summary& summary);

/// The values of the key, in rising order.
std::vector<double> startsOf(const Case& c, const EnsembleTask& task);

/// Runs all starts of all ensembles on up to `jobs` threads; the outcome does not depend on their number. `poll`
/// receives how many runs are done and the share of the work, and stops all by returning false. Returns whether all
/// ended.
bool runEnsembles(std::vector<Ensemble>& ensembles, const EnsembleTask& task, int jobs,
                  const std::function<bool(std::size_t done, double share)>& poll);

/// An end that several starts share: of one kind, the spacings of neighbours no more than 0.1 nm apart; or the same
/// failure.
struct EndClass {
    std::string name; // "flying at 7 nm"
    EndKind kind = EndKind::Failed;
};
struct EndClasses {
    std::vector<EndClass> classes;            // by how often they occur
    std::vector<std::vector<std::size_t>> of; // [ensemble][start]
};
EndClasses classifyEnds(const std::vector<Ensemble>& ensembles);

struct Share {
    std::size_t count = 0;
    double share = 0.0, lower = 0.0, upper = 0.0;
};
Share shareOf(std::size_t count, std::size_t total);

struct ShareDifference {
    double difference = 0.0; // of the first from the second
    double error = 0.0;      // standard error
    bool significant = false;
};
ShareDifference shareDifference(const std::vector<std::size_t>& first, const std::vector<std::size_t>& second,
                                std::size_t end);
/// Starts that end in another class.
std::size_t otherwise(const std::vector<std::size_t>& first, const std::vector<std::size_t>& second);

/// `all`: the first one is the reference. Adds findings, a chart, and the tables "shares" (a row for each end of each
/// ensemble) and "ensembles" (a row for each).
void reportEnsembles(const Case& c, const EnsembleTask& task, const std::vector<Ensemble>& all, StudyReport& report);

} // namespace touchdown

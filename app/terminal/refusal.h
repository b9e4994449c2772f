// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a command refuses wrong input or arguments, and how it fails without a result.
#pragma once

#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/terminal/json_text.h"
#include "core/formats/input_problem.h"

namespace touchdown {

/// A line on standard error for each of the first ones, after `prefix`, and one with the number of the rest.
void complainOf(const std::vector<InputProblem>& problems, const std::string& prefix = "");

/// "problems" of an object: file, line (null where there is none), key and message of each.
Json problemsJson(const std::vector<InputProblem>& problems);

/// One object: "status" ("wrong input"), "message" and "problems". There is one problem or more.
std::string refusalJson(const std::vector<InputProblem>& problems);

/// Writes each problem as a line on standard error and, with `json`, the object on standard output. Returns
/// exitWrongInput. There is one problem or more.
int refuse(const std::vector<InputProblem>& problems, bool json);

/// Writes the line "failed: ..." on standard error and, with `json`, an object with "status" ("failed") and "message"
/// on standard output. Returns exitNoAnswer.
int fail(const std::string& message, bool json);

/// Calls the work. False when the memory did not suffice for it.
template <typename Work>
bool fitsInMemory(Work work)
{
    try {
        work();
        return true;
    } catch (const std::bad_alloc&) {
    } catch (const std::length_error&) { // of a vector with more elements than there can be
    }
    return false;
}
/// The message about a case or study for which it did not.
std::string outOfMemory(const std::string& name);

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <mutex>
#include <string>

namespace touchdown {

struct Case;

/// All that a case says: its text, and what the file of its measured surface held when it was asked for first since the
/// beginning or since forget(). On any thread.
class CaseContent {
public:
    std::string of(const Case& c);
    void forget();

private:
    std::mutex mutex_;
    std::map<std::string, std::string> files_{}; // by name
};

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
//
// What readers of the tables of [abs] share: numbered tables such as [[abs.rail]], lengths, problems.
#pragma once

#include "core/formats/input_problem.h"
#include "core/formats/toml_document.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchdown {

/// "abs.rail[12].recess" of the kind "abs.rail" is 12 and "recess"; nothing when the key is not of this kind.
struct TablePlace {
    std::size_t number; // from 1
    std::string_view leaf;
};
std::optional<TablePlace> tablePlace(std::string_view key, std::string_view kind);

class SurfaceTables {
protected:
    explicit SurfaceTables(const TomlDocument& toml) : toml_(toml) {}

    void add(int line, std::string_view key, std::string message);
    std::vector<InputProblem> takeProblems() { return std::move(problems_); }

    /// Makes room for as many as there are tables; false when they are not to be looked at.
    template <typename Item>
    bool readTables(std::string_view kind, std::string_view name, std::size_t most, std::vector<Item>& items)
    {
        bool mentioned = false;
        const auto count = countTables(kind, name, most, mentioned);
        if (count && mentioned) items.assign(*count, {});
        return count.has_value();
    }
    void unknown(const TomlEntry& entry, const TablePlace& place, const std::vector<std::string>& names);
    std::optional<double> length(const TomlValue& value, int line, const std::string& key, const char* unit);

    static std::string numbered(std::string_view kind, std::size_t number);
    /// False for items that came from elsewhere.
    bool mentions(std::string_view kind, std::size_t number) const { return tableOf(kind, number) != nullptr; }
    int lineOf(std::string_view kind, std::size_t number) const { return tableOf(kind, number)->line; }
    bool wrong(std::string_view key) const;
    bool anyProblem() const { return !problems_.empty(); }

    const TomlDocument& toml_;

private:
    std::optional<std::size_t> countTables(std::string_view kind, std::string_view name, std::size_t most,
                                           bool& mentioned);
    const TomlTable* tableOf(std::string_view kind, std::size_t number) const;

    std::vector<InputProblem> problems_;
};

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/describe_readings.h"

#include <string>
#include <utility>
#include <vector>

#include "app/terminal/console.h"
#include "app/terminal/json_text.h"
#include "app/terminal/report_text.h"
#include "app/terminal/text_table.h"
#include "core/formats/words.h"
#include "core/studies/runs/reading.h"

namespace touchdown {

int describeReadings(bool json)
{
    Json all = Json::array(), places = Json::object();
    std::vector<std::vector<std::string>> single, overTime;
    for (const ReadingRow& row : allReadings()) {
        const Quantity& quantity = row.what.quantity;
        all.push_back({{"quantity", quantity.name},
                       {"unit", quantity.unit},
                       {"display_unit", quantity.displayUnit},
                       {"long_name", quantity.longName},
                       {"over_time", row.what.overTime},
                       {"text", row.what.isText},
                       {"where", row.where}});
        const std::string unit = row.what.isText ? "text" : quantity.displayUnit == "1" ? "-" : quantity.displayUnit;
        (row.what.overTime ? overTime : single).push_back({quantity.name, unit, joined(row.where), quantity.longName});
    }
    std::vector<std::vector<std::string>> at;
    for (std::size_t i = 1; i < readAtCount; ++i) {
        const auto taken = static_cast<ReadAt>(i);
        at.push_back({std::string(name(taken)), std::string(meaning(taken))});
        places[std::string(name(taken))] = meaning(taken);
    }
    if (json) {
        print(jsonText({{"readings", all}, {"at", places}}));
        return exitDone;
    }
    const std::vector<bool> texts{true, true, true, true};
    print(wrapped("What a [[reading]] of a sweep may name as its quantity, with the unit in which tables show it.", 0) +
          "\nOne number or text each:\n" + alignedTable(single, texts) +
          "\nWith a value at each time of a run; `at` tells where it is taken:\n" + alignedTable(overTime, texts) +
          "\nValues of `at`:\n" + alignedTable(at, {true, true}));
    return exitDone;
}

} // namespace touchdown

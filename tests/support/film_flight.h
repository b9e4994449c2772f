// SPDX-License-Identifier: GPL-3.0-or-later
//
// A run of a film case with all that it told.
#pragma once

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "core/simulation/flight/film_run.h"
#include "tests/support/flying_slider.h"

namespace touchdown::test {

/// What a run told, and its summary.
struct Flight {
    std::vector<double> time;
    std::map<std::string, std::vector<double>> columns;
    std::vector<RunEvent> events;
    int calls = 0;
    Summary summary;

    const std::vector<double>& of(const char* quantity) const { return columns.at(quantity); }
    double largestDistance(const char* quantity, double from) const
    {
        double largest = 0.0;
        for (const double value : of(quantity)) largest = std::max(largest, std::abs(value - from));
        return largest;
    }
    double figure(const char* name) const
    {
        for (const RunFigure& f : summary.figures)
            if (f.quantity.name == name) return f.value;
        return std::nan("");
    }
    double final(const char* name) const
    {
        for (const auto& [quantity, value] : summary.final)
            if (quantity == name) return value;
        return std::nan("");
    }
};

/// Stops after so many calls in which samples have come; never: 0.
inline Flight fly(const Case& c, int callsWithSamples = 0, const RunOptions& options = {})
{
    Flight flight;
    const std::vector<Quantity> quantities = filmQuantities(c);
    int withSamples = 0;
    flight.summary = runFilm(
        c,
        [&](const RunUpdate& update) {
            ++flight.calls;
            flight.time.insert(flight.time.end(), update.samples.time.begin(), update.samples.time.end());
            for (std::size_t i = 0; i < quantities.size(); ++i) {
                const std::vector<double>& values = update.samples.columns[i];
                std::vector<double>& column = flight.columns[quantities[i].name];
                column.insert(column.end(), values.begin(), values.end());
            }
            flight.events.insert(flight.events.end(), update.events.begin(), update.events.end());
            if (update.samples.size() > 0) ++withSamples;
            return callsWithSamples == 0 || withSamples < callsWithSamples;
        },
        options);
    return flight;
}

/// From the static state, without contact.
inline Case fromRest(const std::string& name, double duration)
{
    Case c = coarseFlight(name);
    c.initial.state = InitialState::Static;
    c.run.duration = duration;
    c.run.sampleInterval = 0.1e-6;
    return c;
}

inline std::string statusText(const Flight& flight)
{
    return std::string(name(flight.summary.status)) + ": " + flight.summary.message;
}

} // namespace touchdown::test

#define QVERIFY_STATUS(flight, expected) QVERIFY2((flight).summary.status == (expected), statusText(flight).c_str())

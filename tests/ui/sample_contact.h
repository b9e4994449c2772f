// SPDX-License-Identifier: GPL-3.0-or-later
//
// A contact run of our own for the tests of the window: a parabola of forces against the separation, and fields that
// are formulas.
#pragma once

#include <cmath>

#include "core/case/contact_kind.h"
#include "ui/runs/run_record.h"

namespace touchdown {

constexpr int contactSnapshots = 11;

/// Separation 5 nm to -5 nm and back in 1 ms.
inline double sampleSeparation(double time) { return -5e-9 + 10e-9 * std::abs(time - 0.5e-3) / 0.5e-3; }

inline Case sampleContactCase()
{
    Case c;
    c.title = "A pad of our own";
    c.model = ModelKind::Contact;
    c.contact = ContactKind::Elastic;
    c.run.duration = 1e-3;
    c.run.sampleInterval = 1e-5;
    return c;
}

inline std::vector<Quantity> sampleContactQuantities(bool adhesion = true)
{
    std::vector<Quantity> list{{"minimum_spacing", "m", "nm", "Separation"},
                               {"contact_force", "N", "mN", "Real contact force"}};
    if (adhesion) list.push_back({"adhesion_force", "N", "mN", "Adhesion force"});
    list.push_back({"net_contact_force", "N", "mN", "Net contact force"});
    return list;
}

/// 8 x 4 cells of 1 um.
inline RecordedFields sampleContactFields()
{
    RecordedFields fields;
    for (int i = 0; i <= 8; ++i) fields.grid.x.push_back(i * 1e-6);
    for (int j = 0; j <= 4; ++j) fields.grid.y.push_back(j * 1e-6);
    fields.quantities = {{"gap", "m", "nm", "Gap of the deformed surfaces"},
                         {"contact_pressure", "Pa", "MPa", "Contact pressure"}};
    return fields;
}

/// The pressure of cell k is k MPa for each nm below 0; the gap is what lies above.
inline FieldSnapshot sampleSnapshot(double time)
{
    const double d = sampleSeparation(time);
    FieldSnapshot snapshot{time, 0, {std::vector<double>(32), std::vector<double>(32)}};
    for (std::size_t k = 0; k < 32; ++k) {
        snapshot.values[0][k] = std::max(d, 0.0) + 1e-11 * static_cast<double>(k);
        snapshot.values[1][k] = std::max(-d, 0.0) * 1e15 * static_cast<double>(k);
    }
    return snapshot;
}

/// Samples and snapshots from `from` on, up to the end of the part.
inline SampleBatch sampleContactBatch(double from, double to, bool adhesion = true)
{
    SampleBatch batch;
    batch.columns.resize(adhesion ? 4 : 3);
    for (double t = from; t < to + 1e-9; t += 1e-5) {
        const double d = sampleSeparation(t);
        const double contact = d < 0.0 ? -d * 1e6 : 0.0; // 1 mN for each nm
        const double pull = adhesion && d < (t < 0.5e-3 ? 1e-9 : 3e-9) ? -0.5e-3 : 0.0;
        batch.time.push_back(t);
        std::size_t column = 0;
        batch.columns[column++].push_back(d);
        batch.columns[column++].push_back(contact);
        if (adhesion) batch.columns[column++].push_back(pull);
        batch.columns[column].push_back(contact + pull);
    }
    return batch;
}

/// The first `snapshots` of the times, the samples up to there, and the events.
inline std::unique_ptr<RunRecord> sampleContactRun(int number, int snapshots = contactSnapshots, bool adhesion = true)
{
    auto run = std::make_unique<RunRecord>(number, sampleContactCase(), "", sampleContactQuantities(adhesion),
                                           std::vector{sampleContactFields()});
    const double until = 1e-3 * (snapshots - 1) / (contactSnapshots - 1);
    std::vector<FieldSnapshot> fields;
    for (int i = 0; i < snapshots; ++i) fields.push_back(sampleSnapshot(1e-3 * i / (contactSnapshots - 1)));
    run->append(sampleContactBatch(0.0, until, adhesion), {{0.2e-3, "snap-in"}, {0.9e-3, "pull-off"}}, fields);
    return run;
}

} // namespace touchdown

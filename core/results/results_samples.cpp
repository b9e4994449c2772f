// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/results/results_samples.h"

#include <algorithm>

namespace touchdown {
namespace {

constexpr const char* series = "timeseries";

Hdf5Dataset createTime(const Hdf5Group& group, const std::string& longName)
{
    Hdf5Dataset time = group.growing("time", "s", longName);
    time.makeScale("time");
    return time;
}

Hdf5Dataset createQuantity(const Hdf5Group& group, const Quantity& quantity, const Hdf5Dataset& time,
                           const std::vector<hsize_t>& entry)
{
    Hdf5Dataset dataset = group.growing(quantity.name, quantity.unit, quantity.longName, entry);
    dataset.set("display_unit", quantity.displayUnit);
    dataset.attachScale(time, 0);
    return dataset;
}

Quantity quantityOf(const std::string& name, const Hdf5Dataset& dataset)
{
    Quantity quantity{name, dataset.attribute("unit"), dataset.attribute("display_unit"),
                      dataset.attribute("long_name")};
    if (quantity.unit == "1") quantity.unit.clear();
    return quantity;
}

Hdf5Dataset putAxis(const Hdf5Group& group, const std::string& name, const std::vector<double>& lines,
                    const std::string& longName)
{
    std::vector<double> centres;
    for (std::size_t i = 0; i + 1 < lines.size(); ++i) centres.push_back(0.5 * (lines[i] + lines[i + 1]));
    Hdf5Dataset axis = group.put(name, centres, "m", longName);
    axis.makeScale(name);
    group.put(name + "_lines", lines, "m", longName + ", the lines between the cells");
    return axis;
}

void createSet(const Hdf5Group& file, const RecordedFields& set)
{
    const Hdf5Group group = file.create(set.group);
    const Hdf5Dataset time = createTime(group, "Time of the snapshots");
    const Hdf5Dataset x = putAxis(group, "x", set.grid.x, "Along the motion");
    const Hdf5Dataset y = putAxis(group, "y", set.grid.y, "Across the motion");
    for (const Quantity& quantity : set.quantities) {
        const Hdf5Dataset field = createQuantity(
            group, quantity, time, {static_cast<hsize_t>(set.grid.ny()), static_cast<hsize_t>(set.grid.nx())});
        field.attachScale(y, 1);
        field.attachScale(x, 2);
    }
}

void readTimeSeries(const Hdf5Group& file, StoredSamples& stored)
{
    const Hdf5Group group = file.group(series);
    stored.samples.time = group.get("time").column();
    checkFinite(stored.samples.time, "time");
    if (!std::ranges::is_sorted(stored.samples.time)) throw Hdf5Error("its times do not rise");
    for (const std::string& name : group.names()) {
        if (name == "time") continue;
        const Hdf5Dataset dataset = group.get(name);
        std::vector<double> column = dataset.column();
        if (column.size() != stored.samples.size()) throw Hdf5Error(name + " and time differ in length");
        stored.quantities.push_back(quantityOf(name, dataset));
        stored.samples.columns.push_back(std::move(column));
    }
}

void readSet(const Hdf5Group& file, const std::string& name, StoredSamples& stored)
{
    const Hdf5Group group = file.group(name);
    const std::vector<double> times = group.get("time").column();
    checkFinite(times, "time");
    RecordedFields set;
    set.group = name;
    set.grid = {group.get("x_lines").column(), group.get("y_lines").column()};
    if (set.grid.x.size() < 2 || set.grid.y.size() < 2) throw Hdf5Error("the grid of " + name + " has no cells");
    const std::vector<hsize_t> wanted{times.size(), static_cast<hsize_t>(set.grid.ny()),
                                      static_cast<hsize_t>(set.grid.nx())};
    const std::size_t first = stored.snapshots.size();
    for (const double time : times) stored.snapshots.push_back({time, stored.sets.size(), {}});
    for (const std::string& member : group.names()) {
        if (member == "time" || member == "x" || member == "y" || member.ends_with("_lines")) continue;
        const Hdf5Dataset dataset = group.get(member);
        if (dataset.shape() != wanted) throw Hdf5Error(member + " does not fit the grid of " + name);
        set.quantities.push_back(quantityOf(member, dataset));
        for (std::size_t k = 0; k < times.size(); ++k) {
            stored.snapshots[first + k].values.push_back(dataset.entry(k));
            checkFinite(stored.snapshots[first + k].values.back(), member);
        }
    }
    stored.sets.push_back(std::move(set));
}

} // namespace

void createSamples(const Hdf5Group& file, const std::vector<Quantity>& quantities,
                   const std::vector<RecordedFields>& sets)
{
    const Hdf5Group group = file.create(series);
    const Hdf5Dataset time = createTime(group, "Time");
    for (const Quantity& quantity : quantities) createQuantity(group, quantity, time, {});
    for (const RecordedFields& set : sets) createSet(file, set);
}

std::vector<std::string> growingArrays(const std::vector<Quantity>& quantities, const std::vector<RecordedFields>& sets)
{
    std::vector<std::string> paths;
    const auto add = [&](const std::string& group, const std::vector<Quantity>& members) {
        paths.push_back(group + "/time");
        for (const Quantity& quantity : members) paths.push_back(group + '/' + quantity.name);
    };
    add(series, quantities);
    for (const RecordedFields& set : sets) add(set.group, set.quantities);
    return paths;
}

void appendSamples(const Hdf5Group& file, const std::vector<Quantity>& quantities, const SampleBatch& batch)
{
    if (batch.size() == 0) return;
    const Hdf5Group group = file.group(series);
    group.get("time").append(batch.time);
    for (std::size_t i = 0; i < quantities.size(); ++i) group.get(quantities[i].name).append(batch.columns[i]);
}

void appendSnapshots(const Hdf5Group& file, const std::vector<RecordedFields>& sets,
                     std::span<const FieldSnapshot> snapshots)
{
    for (const FieldSnapshot& snapshot : snapshots) {
        const RecordedFields& set = sets[snapshot.set];
        const Hdf5Group group = file.group(set.group);
        group.get("time").append({&snapshot.time, 1});
        for (std::size_t i = 0; i < set.quantities.size(); ++i)
            group.get(set.quantities[i].name).append(snapshot.values[i]);
    }
}

StoredSamples readSamples(const Hdf5Group& file)
{
    StoredSamples stored;
    readTimeSeries(file, stored);
    for (const std::string& name : file.names())
        if (name == "fields" || name.ends_with("_fields")) readSet(file, name, stored);
    std::ranges::stable_sort(stored.snapshots, {}, &FieldSnapshot::time);
    return stored;
}

} // namespace touchdown

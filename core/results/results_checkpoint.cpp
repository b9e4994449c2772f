// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/results/results_checkpoint.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include <gnu/libc-version.h>

namespace touchdown {
namespace {

constexpr const char* checkpointGroup = "checkpoint";
constexpr std::array<const char*, 2> slots{"newest", "extends"};

/// That of a set with a name.
std::string countOf(const RecordedFields& set) { return "snapshots_" + set.group; }

void write(const Hdf5Group& at, const char* name, const std::vector<RecordedFields>& sets,
           const StoredCheckpoint* checkpoint)
{
    const bool exists = at.has(name);
    if (exists && checkpoint && at.get(name).numberAttribute("time") == checkpoint->at.time) return;
    if (exists) at.remove(name);
    if (!checkpoint) return;
    const std::string& state = checkpoint->at.state;
    std::vector<std::int64_t> numbers((state.size() + sizeof(std::int64_t) - 1) / sizeof(std::int64_t));
    std::memcpy(numbers.data(), state.data(), state.size());
    const Hdf5Dataset dataset = at.put(name, numbers);
    dataset.set("time", checkpoint->at.time);
    dataset.set("time_unit", "s");
    dataset.set("bytes", static_cast<std::int64_t>(state.size()));
    dataset.set("layout", std::int64_t{checkpoint->layout});
    dataset.set("extends", std::int64_t{checkpoint->at.extends});
    dataset.set("version", checkpoint->version);
    dataset.set("machine", checkpoint->machine);
    dataset.set("samples", static_cast<std::int64_t>(checkpoint->samples));
    for (std::size_t k = 0; k < sets.size(); ++k)
        dataset.set(countOf(sets[k]), static_cast<std::int64_t>(checkpoint->snapshots[k]));
}

std::size_t count(const Hdf5Dataset& dataset, const std::string& name)
{
    const double number = dataset.numberAttribute(name);
    return number >= 0.0 && number < 1e15 ? static_cast<std::size_t>(number) : 0;
}

StoredCheckpoint read(const Hdf5Dataset& dataset, const std::vector<RecordedFields>& sets)
{
    const std::vector<std::int64_t> numbers = dataset.integers();
    const std::size_t bytes = count(dataset, "bytes");
    if (bytes > numbers.size() * sizeof(std::int64_t)) throw Hdf5Error("a checkpoint is cut short");
    StoredCheckpoint checkpoint;
    checkpoint.at.time = dataset.numberAttribute("time");
    checkpoint.at.state.resize(bytes);
    std::memcpy(checkpoint.at.state.data(), numbers.data(), bytes);
    checkpoint.layout = static_cast<int>(count(dataset, "layout"));
    checkpoint.at.extends = count(dataset, "extends") == 1;
    checkpoint.version = dataset.attribute("version");
    checkpoint.machine = dataset.attribute("machine");
    checkpoint.samples = count(dataset, "samples");
    for (const RecordedFields& set : sets) checkpoint.snapshots.push_back(count(dataset, countOf(set)));
    return checkpoint;
}

} // namespace

std::string thisMachine()
{
    std::string name = "x86-64";
#ifdef __x86_64__
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx")) name += " avx";
    if (__builtin_cpu_supports("avx2")) name += " avx2";
    if (__builtin_cpu_supports("fma")) name += " fma";
    if (__builtin_cpu_supports("avx512f")) name += " avx512f";
#else
    name = "another processor";
#endif
    return name + ", compiler " __VERSION__ ", glibc " + gnu_get_libc_version();
}

void ResultsCheckpoints::add(std::shared_ptr<const StoredCheckpoint> checkpoint)
{
    if (checkpoint->at.extends) extends = checkpoint;
    newest = std::move(checkpoint);
}

void ResultsCheckpoints::add(const ResultsCheckpoints& later)
{
    if (later.extends) extends = later.extends;
    if (later.newest) newest = later.newest;
}

void ResultsCheckpoints::leave(RunStatus status)
{
    // A run that has completed can only become longer; one that failed does not continue.
    if (status != RunStatus::Cancelled) newest.reset();
    if (status == RunStatus::Failed || status == RunStatus::Diverged) extends.reset();
}

std::vector<std::shared_ptr<const StoredCheckpoint>> ResultsCheckpoints::all() const
{
    std::vector<std::shared_ptr<const StoredCheckpoint>> list;
    for (const auto& each : {newest, extends})
        if (each) list.push_back(each);
    return list;
}

void writeCheckpoints(const Hdf5Group& file, const std::vector<RecordedFields>& sets,
                      const ResultsCheckpoints& checkpoints)
{
    const bool any = checkpoints.newest || checkpoints.extends;
    if (!any && !file.has(checkpointGroup)) return;
    const Hdf5Group at = file.has(checkpointGroup) ? file.group(checkpointGroup) : file.create(checkpointGroup);
    write(at, slots[0], sets, checkpoints.newest == checkpoints.extends ? nullptr : checkpoints.newest.get());
    write(at, slots[1], sets, checkpoints.extends.get());
}

hsize_t storedBytesOfCheckpoints(const Hdf5Group& file)
{
    hsize_t bytes = 0;
    if (!file.has(checkpointGroup)) return bytes;
    const Hdf5Group at = file.group(checkpointGroup);
    for (const char* name : slots)
        if (at.has(name)) bytes += at.get(name).storedBytes();
    return bytes;
}

std::vector<StoredCheckpoint> readCheckpoints(const Hdf5Group& file, const std::vector<RecordedFields>& sets)
{
    std::vector<StoredCheckpoint> list;
    if (!file.has(checkpointGroup)) return list;
    const Hdf5Group at = file.group(checkpointGroup);
    for (const char* name : slots)
        if (at.has(name)) list.push_back(read(at.get(name), sets));
    return list;
}

} // namespace touchdown

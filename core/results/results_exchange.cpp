// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/results/results_exchange.h"

#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/formats/hdf5_file.h"
#include "core/results/results_samples.h"
#include "core/results/results_summary.h"

namespace touchdown {
namespace {

// Space that rewritten chunks leave unused in a file before it is built anew [byte].
constexpr hsize_t tolerableWaste = 4 << 20;

} // namespace

HeldFile::HeldFile(const std::filesystem::path& path) : descriptor_(::open(path.c_str(), O_PATH | O_CLOEXEC)) {}

HeldFile::~HeldFile()
{
    if (descriptor_ >= 0) ::close(descriptor_);
}

HeldFile::HeldFile(HeldFile&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

HeldFile& HeldFile::operator=(HeldFile&& other) noexcept
{
    std::swap(descriptor_, other.descriptor_);
    return *this;
}

bool HeldFile::standsAt(const std::filesystem::path& path) const
{
    struct stat held {};
    struct stat found {};
    if (::fstat(descriptor_, &held) != 0 || ::stat(path.c_str(), &found) != 0) return false;
    return held.st_dev == found.st_dev && held.st_ino == found.st_ino;
}

ResultsExchange::ResultsExchange(const std::filesystem::path& file, ResultsHeader header, FirstSeen seen)
    : part_(file, PartName::Own),
      header_(std::move(header)),
      arrays_(growingArrays(header_.quantities, header_.fields)),
      seen_(seen)
{
    publish({});
}

void ResultsExchange::publish(const SampleBatch& samples, std::span<const FieldSnapshot> fields,
                              const std::vector<ResultsSpectrum>& spectra, const Summary* summary)
{
    const Hdf5Access access;
    // The user may move the file away, and what stands in its place is not this run's.
    if (shown_ && !shown_.standsAt(part_.target())) throw Hdf5Error("someone removed or replaced it");
    try {
        Hdf5Group part = openPart();
        if (shown_) {
            const Hdf5Group shown = openHdf5File(part_.target());
            for (const std::string& array : arrays_) part.get(array).copyMissing(shown.get(array));
        }
        appendSamples(part, header_.quantities, samples);
        if (samples.size() > 0) reached_ = samples.time.back();
        appendSnapshots(part, header_.fields, fields);
        for (const ResultsSpectrum& spectrum : spectra) writeSpectrum(part, spectrum);
        if (summary) {
            writeSummary(part, header_.quantities, *summary);
            checkpoints_.leave(summary->status);
        }
        writeCheckpoints(part, header_.fields, checkpoints_);
        part.close();
        if (isToBeSeen(summary)) show();
    } catch (...) {
        removePart();
        throw;
    }
}

bool ResultsExchange::isToBeSeen(const Summary* summary) const
{
    if (shown_) return true;
    switch (seen_.when) {
    case FirstSeen::When::AtOnce: return true;
    case FirstSeen::When::FromTime:
        return (reached_ >= seen_.time && (checkpoints_.newest || checkpoints_.extends)) ||
               (summary && summary->status == RunStatus::Completed);
    case FirstSeen::When::AtEnd: break;
    }
    return summary != nullptr;
}

Hdf5Group ResultsExchange::openPart()
{
    if (!hasPart_) return createPart();
    try {
        Hdf5Group part = openHdf5File(part_.path(), H5F_ACC_RDWR);
        if (!shown_) return part;
        hsize_t size = 0;
        checkHdf5(H5Fget_filesize(part, &size));
        hsize_t used = storedBytesOfCheckpoints(part);
        for (const std::string& array : arrays_) used += part.get(array).storedBytes();
        if (size < used + used / 4 + tolerableWaste) return part;
    } catch (const Hdf5Error&) {
        // A reader who opened it under the file's name still holds its lock.
        if (!shown_) throw;
    }
    removePart();
    return createPart();
}

Hdf5Group ResultsExchange::createPart()
{
    hasPart_ = true;
    Hdf5Group part = createResultsFile(part_.path(), header_);
    part_.takeMode();
    return part;
}

void ResultsExchange::removePart()
{
    std::error_code ignored;
    if (std::exchange(hasPart_, false)) std::filesystem::remove(part_.path(), ignored);
}

void ResultsExchange::show()
{
    HeldFile next(part_.path());
    if (shown_ && ::renameat2(AT_FDCWD, part_.path().c_str(), AT_FDCWD, part_.target().c_str(), RENAME_EXCHANGE) == 0) {
        shown_ = std::move(next);
        return;
    }
    // The first time, or on a file system that cannot exchange names: there each flush copies all earlier samples.
    part_.show();
    hasPart_ = false;
    shown_ = std::move(next);
}

} // namespace touchdown

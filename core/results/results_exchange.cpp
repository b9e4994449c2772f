// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/results/results_exchange.h"

#include <cstdio>
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

ResultsExchange::ResultsExchange(const std::filesystem::path& file, ResultsHeader header)
    : file_(file),
      part_(file.string() + ".part"),
      header_(std::move(header)),
      arrays_(growingArrays(header_.quantities, header_.fields))
{
    const Hdf5Access access;
    // A part that a killed run left is removed, not overwritten, since it may be open in a reader.
    std::error_code ignored;
    std::filesystem::remove(part_, ignored);
    try {
        createPart().close();
    } catch (...) {
        removePart();
        throw;
    }
}

ResultsExchange::~ResultsExchange() { removePart(); }

void ResultsExchange::publish(const SampleBatch& samples, std::span<const FieldSnapshot> fields,
                              const std::vector<ResultsSpectrum>& spectra, const Summary* summary)
{
    const Hdf5Access access;
    checkOwned();
    try {
        Hdf5Group part = openPart();
        if (shown_) {
            const Hdf5Group shown = openHdf5File(file_);
            for (const std::string& array : arrays_) part.get(array).copyMissing(shown.get(array));
        }
        appendSamples(part, header_.quantities, samples);
        appendSnapshots(part, header_.fields, fields);
        for (const ResultsSpectrum& spectrum : spectra) writeSpectrum(part, spectrum);
        if (summary) writeSummary(part, header_.quantities, *summary);
        part.close();
        show();
    } catch (...) {
        removePart();
        throw;
    }
}

// Samples of two runs that write to one name must not mix; the user may move the file away.
void ResultsExchange::checkOwned() const
{
    if (shown_ && !shown_.standsAt(file_)) throw Hdf5Error("someone removed or replaced it");
    if (next_ && !next_.standsAt(part_)) throw Hdf5Error("another run writes to it");
}

Hdf5Group ResultsExchange::openPart()
{
    if (!next_) return createPart();
    try {
        Hdf5Group part = openHdf5File(part_, H5F_ACC_RDWR);
        hsize_t size = 0;
        checkHdf5(H5Fget_filesize(part, &size));
        hsize_t used = 0;
        for (const std::string& array : arrays_) used += part.get(array).storedBytes();
        if (size < used + used / 4 + tolerableWaste) return part;
    } catch (const Hdf5Error&) {
        // A reader who opened it under the file's name still holds its lock.
    }
    removePart();
    return createPart();
}

Hdf5Group ResultsExchange::createPart()
{
    try {
        Hdf5Group part = createResultsFile(part_, header_);
        next_ = HeldFile(part_);
        return part;
    } catch (...) {
        std::error_code ignored;
        std::filesystem::remove(part_, ignored);
        throw;
    }
}

void ResultsExchange::removePart()
{
    if (!next_ || !next_.standsAt(part_)) return;
    std::error_code ignored;
    std::filesystem::remove(part_, ignored);
    next_ = {};
}

void ResultsExchange::show()
{
    if (shown_ && ::renameat2(AT_FDCWD, part_.c_str(), AT_FDCWD, file_.c_str(), RENAME_EXCHANGE) == 0) {
        std::swap(shown_, next_);
        return;
    }
    // The first time, or on a file system that cannot exchange names: there each flush copies all earlier samples.
    std::error_code error;
    std::filesystem::rename(part_, file_, error);
    if (error) throw Hdf5Error(error.message());
    shown_ = std::exchange(next_, {});
}

} // namespace touchdown

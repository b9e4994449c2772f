// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/results/results_exchange.h"

#include <cstdio>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/results/results_fields.h"

namespace touchdown {
namespace {

// Space that rewritten chunks leave unused in a file before it is built anew [byte].
constexpr hsize_t tolerableWaste = 4 << 20;

Hdf5Handle openFile(const std::filesystem::path& path, unsigned flags)
{
    return {H5Fopen(path.c_str(), flags, hdf5FileAccess()), H5Fclose};
}

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
    : file_(file), part_(file.string() + ".part"), header_(std::move(header))
{
    const Hdf5Access access;
    // What a killed run may have left here; removed, not overwritten, since someone may be reading it.
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
        Hdf5Handle part = openPart();
        if (shown_) {
            const Hdf5Handle shown = openFile(file_, H5F_ACC_RDONLY);
            copyMissingSamples(shown, part, header_.quantities);
            copyMissingFields(shown, part, header_.fields);
        }
        appendSamples(part, header_.quantities, samples);
        appendFields(part, header_.fields, fields);
        for (const ResultsSpectrum& spectrum : spectra) writeSpectrum(part, spectrum);
        if (summary) writeSummary(part, header_.quantities, *summary);
        part.close();
        show();
    } catch (...) {
        removePart();
        throw;
    }
}

// Two runs that write to one name, or a person who moves the file away: their samples must not mix.
void ResultsExchange::checkOwned() const
{
    if (shown_ && !shown_.standsAt(file_)) throw Hdf5Error("someone removed or replaced it");
    if (next_ && !next_.standsAt(part_)) throw Hdf5Error("another run writes to it");
}

Hdf5Handle ResultsExchange::openPart()
{
    if (!next_) return createPart();
    try {
        Hdf5Handle part = openFile(part_, H5F_ACC_RDWR);
        hsize_t size = 0;
        checkHdf5(H5Fget_filesize(part, &size));
        const hsize_t used = storedBytes(part, header_.quantities) + storedFieldBytes(part, header_.fields);
        if (size < used + used / 4 + tolerableWaste) return part;
    } catch (const Hdf5Error&) {
        // A reader who opened it under the file's name still holds its lock: leave it to him.
    }
    removePart();
    return createPart();
}

Hdf5Handle ResultsExchange::createPart()
{
    try {
        Hdf5Handle part = createResultsFile(part_, header_);
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
    // The first time; or on a file system that cannot exchange, where each flush then copies all that went before.
    std::error_code error;
    std::filesystem::rename(part_, file_, error);
    if (error) throw Hdf5Error(error.message());
    shown_ = std::exchange(next_, {});
}

} // namespace touchdown

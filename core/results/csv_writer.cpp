// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/results/csv_writer.h"

#include <cerrno>
#include <charconv>
#include <chrono>
#include <optional>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include "core/formats/csv_cell.h"
#include "core/formats/output_file.h"

namespace touchdown {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t bufferSize = std::size_t{1} << 18; // [byte]
constexpr std::size_t longestNumber = 32;                // [byte], "-1.2345678901234567e-308" and a comma
constexpr int pause = 50;                                // between tries, of a pipe that takes nothing [ms]
constexpr int mostPauses = 20;                           // after the run was asked to stop

} // namespace

struct CsvWriter::File {
    std::filesystem::path path;
    std::optional<PartFile> part; // of a regular file; none for a device or a pipe
    int descriptor = -1;
    std::vector<char> buffer = std::vector<char>(bufferSize);
    std::size_t used = 0;
    Clock::time_point written = Clock::now();
    std::string problem;
    std::function<bool()> goOn;
    int pauses = 0; // since the run was asked to stop, without a reader

    ~File()
    {
        if (!part) write();
        if (descriptor >= 0) ::close(descriptor);
    }

    void add(double value, char separator)
    {
        if (used + longestNumber > buffer.size()) write();
        // The shortest text that reads back as the same number.
        const auto end = std::to_chars(buffer.data() + used, buffer.data() + buffer.size(), value).ptr;
        *end = separator;
        used = static_cast<std::size_t>(end - buffer.data()) + 1;
    }
    void add(const std::string& text)
    {
        for (char c : text) {
            if (used == buffer.size()) write();
            buffer[used++] = c;
        }
    }
    void fail(const std::string& reason)
    {
        if (problem.empty()) problem = "cannot write to " + path.string() + ": " + reason;
    }
    void fail(int code) { fail(std::generic_category().message(code)); }
    /// A system call that waits for the reader of a pipe would not notice a signal.
    void waitForReader()
    {
        pollfd room{descriptor, POLLOUT, 0};
        ::poll(&room, 1, pause);
        if (goOn && !goOn() && ++pauses > mostPauses) fail("no program reads it");
    }
    void openStream()
    {
        const bool pipe = std::filesystem::is_fifo(path);
        while (descriptor < 0 && problem.empty()) {
            descriptor = ::open(path.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
            if (descriptor >= 0) break;
            if (pipe && errno == ENXIO)
                waitForReader();
            else
                fail(errno);
        }
    }
    void write()
    {
        std::size_t done = 0;
        while (done < used && problem.empty()) {
            const ssize_t n = ::write(descriptor, buffer.data() + done, used - done);
            if (n >= 0)
                done += static_cast<std::size_t>(n), pauses = 0;
            else if (errno == EAGAIN)
                waitForReader();
            else if (errno != EINTR)
                fail(errno);
        }
        used = 0;
        written = Clock::now();
    }
};

CsvWriter::CsvWriter() = default;
CsvWriter::~CsvWriter() = default;
CsvWriter::CsvWriter(CsvWriter&&) noexcept = default;
CsvWriter& CsvWriter::operator=(CsvWriter&&) noexcept = default;

std::string CsvWriter::open(const std::filesystem::path& path, const std::vector<Quantity>& quantities,
                            const std::function<bool()>& goOn)
{
    auto file = std::make_unique<File>();
    file->path = path;
    file->goOn = goOn;
    std::error_code none;
    const std::filesystem::file_status status = std::filesystem::status(path, none);
    try {
        if (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status)) file->part.emplace(path);
        if (!file->part)
            file->openStream();
        else if (file->descriptor = file->part->create(); file->descriptor < 0)
            file->fail(errno);
    } catch (const std::exception& failure) {
        file->fail(failure.what());
    }
    if (!file->problem.empty()) return file->problem;
    file->add("time [s]");
    for (const Quantity& quantity : quantities)
        file->add("," + csvCell(quantity.name + " [" + (quantity.unit.empty() ? "1" : quantity.unit) + "]"));
    file->add("\r\n");
    file->write();
    file_ = std::move(file);
    return file_->problem;
}

std::string CsvWriter::append(const SampleBatch& batch)
{
    if (!file_) return "no CSV file is open";
    for (std::size_t k = 0; k < batch.size(); ++k) {
        file_->add(batch.time[k], batch.columns.empty() ? '\r' : ',');
        for (std::size_t i = 0; i < batch.columns.size(); ++i)
            file_->add(batch.columns[i][k], i + 1 < batch.columns.size() ? ',' : '\r');
        file_->add("\n");
    }
    if (Clock::now() - file_->written > std::chrono::milliseconds(700)) file_->write();
    return file_->problem;
}

std::string CsvWriter::close()
{
    if (!file_) return "no CSV file is open";
    file_->write();
    // Some file systems report a failure only here.
    if (file_->part && ::fsync(file_->descriptor) != 0) file_->fail(errno);
    const int descriptor = std::exchange(file_->descriptor, -1);
    if (::close(descriptor) != 0 && errno != EINTR) file_->fail(errno);
    if (file_->part && file_->problem.empty()) {
        try {
            file_->part->show();
        } catch (const std::system_error& failure) {
            file_->fail(failure.what());
        }
    }
    const std::string problem = file_->problem;
    file_.reset();
    return problem;
}

} // namespace touchdown

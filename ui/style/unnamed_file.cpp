// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/unnamed_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <cstring>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <QDir>
#include <QFile>

#include "ui/style/translate.h"

namespace touchdown {

namespace {

struct Descriptor {
    int number = -1;
    ~Descriptor()
    {
        if (number >= 0) ::close(number);
    }
};

bool writeAll(int file, std::span<const double> part)
{
    const auto bytes = std::as_bytes(part);
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t written = ::write(file, bytes.data() + done, bytes.size() - done);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        done += static_cast<std::size_t>(written);
    }
    return true;
}

struct Pages {
    void* start = nullptr;
    std::size_t bytes = 0;
};

/// All pages with some of the numbers.
Pages pagesOf(std::span<const double> numbers)
{
    static const auto page = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
    const auto begin = reinterpret_cast<std::uintptr_t>(numbers.data()) / page * page;
    const auto end = reinterpret_cast<std::uintptr_t>(numbers.data() + numbers.size());
    return {reinterpret_cast<void*>(begin), end - begin};
}

} // namespace

std::shared_ptr<const double[]> toUnnamedFile(const QString& folder, const std::vector<std::span<const double>>& parts,
                                              QString& problem)
{
    const auto failed = [&](int reason) {
        problem = tr("Nothing can be written to %1: %2.")
                      .arg(QDir::toNativeSeparators(folder), QString::fromLocal8Bit(std::strerror(reason)));
        return nullptr;
    };
    errno = 0;
    if (!QDir().mkpath(folder)) return failed(errno != 0 ? errno : EACCES);
    QByteArray name = QFile::encodeName(folder + QStringLiteral("/samplesXXXXXX"));
    const Descriptor file{::mkostemp(name.data(), O_CLOEXEC)};
    if (file.number < 0) return failed(errno);
    ::unlink(name.constData());
    std::size_t bytes = 0;
    for (const std::span<const double> part : parts) {
        if (!writeAll(file.number, part)) return failed(errno != 0 ? errno : ENOSPC);
        bytes += part.size_bytes();
    }
    if (bytes == 0) return failed(EINVAL);
    if (::fdatasync(file.number) != 0) return failed(errno);
    void* mapped = ::mmap(nullptr, bytes, PROT_READ, MAP_SHARED, file.number, 0);
    if (mapped == MAP_FAILED) return failed(errno);
    return {static_cast<const double*>(mapped),
            [bytes](const double* start) { ::munmap(const_cast<double*>(start), bytes); }};
}

bool atHand(std::span<const double> mapped)
{
    if (mapped.empty()) return true;
    const Pages pages = pagesOf(mapped);
    static const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
    std::vector<unsigned char> present((pages.bytes + page - 1) / page);
    if (::mincore(pages.start, pages.bytes, present.data()) != 0) return true; // not known
    if (std::ranges::all_of(present, [](unsigned char each) { return (each & 1U) != 0; })) return true;
    // The system reads no more at once than its read-ahead, from where it is asked to begin.
    constexpr std::size_t atOnce = 128 * 1024; // [byte]
    for (std::size_t at = 0; at < pages.bytes; at += atOnce)
        ::madvise(static_cast<char*>(pages.start) + at, std::min(atOnce, pages.bytes - at), MADV_WILLNEED);
    return false;
}

void letGo(std::span<const double> mapped)
{
    if (mapped.empty()) return;
    const Pages pages = pagesOf(mapped);
    ::madvise(pages.start, pages.bytes, MADV_DONTNEED);
}

} // namespace touchdown

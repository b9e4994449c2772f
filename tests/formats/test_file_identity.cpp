// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/file_identity.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <random>
#include <set>

#include <QTemporaryDir>
#include <QTest>

#include "core/formats/text_file.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_file_identity {

/// Sets a time as `touch` does; it also renews the time that the identity keeps.
void touch(const std::filesystem::path& file)
{
    const std::array<timespec, 2> times{{{1'000'000'000, 0}, {1'000'000'000, 0}}};
    ::utimensat(AT_FDCWD, file.c_str(), times.data(), 0);
}

class TestFileIdentity : public QObject {
    Q_OBJECT

private slots:
    void init() { QVERIFY(folder_.isValid()); }

    void theSameBytesAreTheSameFile_data()
    {
        QTest::addColumn<std::size_t>("size");
        QTest::newRow("empty") << std::size_t(0);
        QTest::newRow("small") << std::size_t(100);
        QTest::newRow("large") << (std::size_t(5) << 20) + 3;
    }
    void theSameBytesAreTheSameFile()
    {
        QFETCH(const std::size_t, size);
        const auto file = path("same");
        const std::string text(size, 'a');
        QCOMPARE(writeTextFile(file, text), std::string());
        const auto identity = identityOf(file);
        QVERIFY(identity.has_value());
        QCOMPARE(fileNow(file, *identity), FileNow::Same);
        touch(file);
        QCOMPARE(fileNow(file, *identity), FileNow::Same);
        QCOMPARE(writeTextFile(file, text), std::string()); // a rename over it: another inode
        QCOMPARE(fileNow(file, *identity), FileNow::Same);
        QCOMPARE(fileNow(file, identityOfBytes(text)), FileNow::Same);
    }
    /// In place and at once, so that size, inode and perhaps the time stay.
    void aChangeOfOneByteIsAnotherFile()
    {
        for (const std::size_t size : {std::size_t(9), std::size_t(200'000), (std::size_t(5) << 20) + 1}) {
            const auto file = path("changed");
            QCOMPARE(writeTextFile(file, std::string(size, 'a')), std::string());
            const auto identity = identityOf(file);
            for (const std::size_t place : {std::size_t(0), size / 2, size - 1}) {
                const int descriptor = ::open(file.c_str(), O_WRONLY | O_CLOEXEC);
                QCOMPARE(::pwrite(descriptor, "b", 1, static_cast<off_t>(place)), ssize_t(1));
                touch(file);
                QCOMPARE(fileNow(file, *identity), FileNow::Other);
                QCOMPARE(::pwrite(descriptor, "a", 1, static_cast<off_t>(place)), ssize_t(1));
                ::close(descriptor);
                touch(file);
                QCOMPARE(fileNow(file, *identity), FileNow::Same);
            }
        }
    }
    /// Two numbers with another sign differ in the highest bit of two words.
    void twoChangesDoNotCancel()
    {
        std::mt19937_64 random(1);
        std::set<std::uint64_t> hashes;
        constexpr std::size_t count = 64;
        std::array<std::uint64_t, count> words{};
        for (std::uint64_t& word : words) word = random();
        const auto add = [&] {
            hashes.insert(
                identityOfBytes({reinterpret_cast<const char*>(words.data()), count * sizeof(std::uint64_t)}).hash);
        };
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t j = 0; j <= i; ++j) {
                words[i] ^= std::uint64_t(1) << 63;
                if (j < i) words[j] ^= std::uint64_t(1) << 63;
                add();
                words[i] ^= std::uint64_t(1) << 63;
                if (j < i) words[j] ^= std::uint64_t(1) << 63;
            }
        QCOMPARE(hashes.size(), count * (count + 1) / 2);
    }
    void whatIsNoFileIsNamed()
    {
        const auto file = path("file");
        QCOMPARE(writeTextFile(file, "a"), std::string());
        const FileIdentity identity = *identityOf(file);
        std::filesystem::remove(file);
        QCOMPARE(fileNow(file, identity), FileNow::Gone);
        QVERIFY(!identityOf(file));
        std::filesystem::create_directory(file);
        QCOMPARE(fileNow(file, identity), FileNow::Unreadable);
        std::filesystem::remove(file);
        QCOMPARE(::mkfifo(file.c_str(), 0600), 0);
        QCOMPARE(fileNow(file, identity), FileNow::Unreadable);
        QVERIFY(!identityOf(file));
        QCOMPARE(fileNow("/dev/zero", identity), FileNow::Unreadable);
        QCOMPARE(fileNow(path("no/where"), identity), FileNow::Gone);
    }
    /// A terabyte that takes no room on the disk: it would never be read in time.
    void aHugeFileIsKnownByItsMarks()
    {
        const auto file = path("huge");
        QCOMPARE(writeTextFile(file, "x"), std::string());
        std::filesystem::resize_file(file, std::uintmax_t(1) << 40);
        const auto identity = identityOf(file);
        QCOMPARE(fileNow(file, *identity), FileNow::Same);
        std::filesystem::resize_file(file, (std::uintmax_t(1) << 40) - 1);
        QCOMPARE(fileNow(file, *identity), FileNow::Other);
    }
    void isKeptAsText()
    {
        const auto file = path("kept");
        QCOMPARE(writeTextFile(file, "abc"), std::string());
        const FileIdentity identity = *identityOf(file);
        QVERIFY(identityFromText(identity.text()) == identity);
        QVERIFY(identityFromText(FileIdentity{}.text()) == FileIdentity{});
        for (const char* text : {"", "x", "1:2:3:4", "1:2:3:4:5 ", "1:2:3:4:g", "-1:2:3:4:5", "1:2:3:4:5:6"})
            QVERIFY2(!identityFromText(text), text);
    }

private:
    std::filesystem::path path(const char* name) const
    {
        return std::filesystem::path(folder_.path().toStdString()) / name;
    }
    QTemporaryDir folder_;
};

TOUCHDOWN_TEST(TestFileIdentity)

} // namespace test_file_identity

#include "test_file_identity.moc"

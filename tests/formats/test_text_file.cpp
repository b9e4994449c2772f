// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/text_file.h"

#include <QTemporaryDir>
#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_text_file {

QString problemOf(const std::filesystem::path& file, std::uintmax_t largest = 1024)
{
    const auto result = readTextFile(file, largest);
    const auto* problem = std::get_if<FileProblem>(&result);
    return problem == nullptr ? QString() : QString::fromStdString(problem->message);
}

class TestTextFile : public QObject {
    Q_OBJECT

private slots:
    void init() { QVERIFY(folder_.isValid()); }

    void writesAndReadsBack()
    {
        const auto file = path("case.toml");
        const std::string text("a = 1\r\n# µ\0\n", 13);
        QCOMPARE(writeTextFile(file, text), std::string());
        QCOMPARE(std::get<std::string>(readTextFile(file, 1024)), text);
    }
    void readsUpToTheLimit()
    {
        const auto file = path("limit");
        QCOMPARE(writeTextFile(file, std::string(1024, 'a')), std::string());
        QCOMPARE(problemOf(file), QString());
        QCOMPARE(writeTextFile(file, std::string(1025, 'a')), std::string());
        QCOMPARE(problemOf(file), QString("is larger than 1 KiB, so it is not a case file"));
    }
    /// A terabyte that takes no room on the disk: it would never be read in time.
    void aHugeFileIsNotRead()
    {
        const auto file = path("huge");
        QCOMPARE(writeTextFile(file, "x"), std::string());
        std::filesystem::resize_file(file, std::uintmax_t(1) << 40);
        QCOMPARE(problemOf(file), QString("is larger than 1 KiB, so it is not a case file"));
    }
    void whatIsNoFileIsNamed()
    {
        QCOMPARE(problemOf(path("nowhere")), QString("does not exist"));
        QCOMPARE(problemOf(path("no/where")), QString("does not exist"));
        QCOMPARE(problemOf(path("")), QString("is a directory, not a file"));
        QCOMPARE(problemOf("/dev/null"), QString("is not a regular file"));
    }
    /// Files that the system makes up look like regular ones of size 0; some never end, some hold secrets.
    void filesOfTheSystemAreNotRead()
    {
        for (const char* file : {"/proc/self/mem", "/proc/self/environ", "/proc/self/maps"})
            QCOMPARE(problemOf(file), QString("is not a regular file"));
        std::filesystem::create_symlink("/proc/self/environ", path("link"));
        QCOMPARE(problemOf(path("link")), QString("is not a regular file"));
    }
    /// A text is refused where it holds no text, before the rest is read.
    void textAlone()
    {
        const auto isText = [&](const std::string& text) {
            if (!writeTextFile(path("text"), text).empty()) return false;
            return std::holds_alternative<std::string>(readTextFile(path("text"), 1 << 20, FileContent::Text));
        };
        const std::string zero(1, '\0');
        QVERIFY(isText("a = 1\n"));
        QVERIFY(!isText("a = 1" + zero));
        QVERIFY(!isText(std::string(200'000, 'a') + zero));
        QVERIFY(isText("\xff\xfe"
                       "a" +
                       zero + "\n" + zero));
        QVERIFY(!isText("\xff\xfe"
                        "a" +
                        zero + zero + zero));
        QVERIFY(!isText("\xfe\xff" + std::string(200'000, 'a') + zero + zero));
    }

    void aFailedWriteLeavesNothing()
    {
        const auto nowhere = path("missing folder/case.toml");
        QCOMPARE(writeTextFile(nowhere, "x"), std::string("cannot be written: No such file or directory"));
        QVERIFY(!std::filesystem::exists(nowhere.parent_path()));
        QCOMPARE(writeTextFile(path(""), "x"), std::string("is a directory, not a file"));
    }
    void replacingKeepsModeAndLink()
    {
        const auto file = path("kept.toml");
        const auto link = path("link.toml");
        QCOMPARE(writeTextFile(file, "old"), std::string());
        std::filesystem::permissions(file, std::filesystem::perms(0640));
        std::filesystem::create_symlink(file, link);
        QCOMPARE(writeTextFile(link, "new"), std::string());
        QVERIFY(std::filesystem::is_symlink(link));
        QCOMPARE(std::get<std::string>(readTextFile(file, 1024)), std::string("new"));
        QCOMPARE(std::filesystem::status(file).permissions(), std::filesystem::perms(0640));
    }
    void noTemporaryFileStays()
    {
        QTemporaryDir folder;
        const std::filesystem::path place = folder.path().toStdString();
        QCOMPARE(writeTextFile(place / "a", "1"), std::string());
        QCOMPARE(writeTextFile(place / "a", "2"), std::string());
        QCOMPARE(std::distance(std::filesystem::directory_iterator(place), std::filesystem::directory_iterator()), 1);
    }

private:
    std::filesystem::path path(const char* name) const
    {
        return std::filesystem::path(folder_.path().toStdString()) / name;
    }
    QTemporaryDir folder_;
};

TOUCHDOWN_TEST(TestTextFile)

} // namespace test_text_file

#include "test_text_file.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case_files/cml/cml_archive.h"

#include <QTest>

#include <random>

#include "core/formats/cml_text.h"
#include "tests/support/cml_sample.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_cml_archive {

std::string packed(const std::vector<CmlMember>& members) { return std::get<std::string>(formatCmlArchive(members)); }

std::string problemOf(const std::string& bytes)
{
    const auto archive = readCmlArchive(bytes);
    const auto* problem = std::get_if<FileProblem>(&archive);
    return problem == nullptr ? std::string() : problem->message;
}

/// Replaces bytes everywhere, as in the local header and in the directory.
std::string withBytes(std::string bytes, std::string_view what, std::string_view by)
{
    for (auto at = bytes.find(what); at != std::string::npos; at = bytes.find(what, at + by.size()))
        bytes.replace(at, what.size(), by);
    return bytes;
}

class TestCmlArchive : public QObject {
    Q_OBJECT

private slots:
    void roundTrip()
    {
        const std::vector<CmlMember> members{{"rail.dat", cmlRailText()}, {"run.dat", cmlRunText()}};
        const auto archive = readCmlArchive(packed(members));
        const auto* content = std::get_if<CmlArchive>(&archive);
        QVERIFY(content != nullptr);
        QVERIFY(content->warnings.empty());
        QCOMPARE(content->members.size(), std::size_t(2));
        for (std::size_t i = 0; i < 2; ++i) {
            QCOMPARE(content->members[i].name, members[i].name);
            QCOMPARE(content->members[i].text, members[i].text);
        }
    }
    void namesInFoldersAndCapitals()
    {
        const auto archive = readCmlArchive(packed({{"slider/Rail.DAT", "a"},
                                                    {"slider/RUN.dat", "b"},
                                                    {"slider/results/run.dat", "older"},
                                                    {"slider/result.dat", "c"},
                                                    {"slider/old/rail.dat", "older"}}));
        const auto* content = std::get_if<CmlArchive>(&archive);
        QVERIFY(content != nullptr);
        QCOMPARE(content->members.size(), std::size_t(2));
        QCOMPARE(content->members[0].name, std::string("rail.dat"));
        QCOMPARE(content->members[0].text, std::string("a"));
        QCOMPARE(content->members[1].text, std::string("b"));
    }
    void pathsThatLeadOutside_data()
    {
        QTest::addColumn<QByteArray>("name");
        for (const char* name : {"../run.dat", "a/../../run.dat", "/etc/run.dat", "..\\run.dat", "C:\\run.dat"})
            QTest::newRow(name) << QByteArray(name);
    }
    void pathsThatLeadOutside()
    {
        QFETCH(QByteArray, name);
        const auto archive = readCmlArchive(packed({{"rail.dat", "a"}, {name.toStdString(), "b"}}));
        const auto* content = std::get_if<CmlArchive>(&archive);
        QVERIFY(content != nullptr);
        QCOMPARE(content->members.size(), std::size_t(1));
        QCOMPARE(content->warnings.size(), std::size_t(1));
        QCOMPARE(content->warnings[0],
                 "\"" + name.toStdString() + "\" names a place outside the archive, and is not read");
    }

    void refused_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QByteArray>("problem");
        const auto row = [](const char* name, const std::string& bytes, const char* problem) {
            QTest::newRow(name) << QByteArray::fromStdString(bytes) << QByteArray(problem);
        };
        const std::string good = packed({{"rail.dat", cmlRailText()}, {"run.dat", cmlRunText()}});
        row("empty", "", "is empty");
        row("binary of an early version", std::string("\x01\0CML 4.0\0", 10),
            "is not an archive of version 7 or 8; the binary files of earlier versions are not read, but the "
            "established "
            "program "
            "can save them anew");
        row("a text file", cmlRailText(), "is not an archive of version 7 or 8");
        row("two letters", "PK", "is a damaged archive: ");
        row("noise behind the mark", "PK\x03\x04" + std::string(5000, '\x55'), "is a damaged archive: ");
        row("cut at a half", good.substr(0, good.size() / 2), "is a damaged archive: ");
        row("cut in the directory", good.substr(0, good.size() - 30), "is a damaged archive: ");
        row("an empty archive", std::string("PK\x05\x06", 4) + std::string(18, '\0'), "holds no rail.dat");
        row("no rails", packed({{"run.dat", "x"}, {"notes.txt", "y"}}), "holds no rail.dat");
        row("rails outside alone", packed({{"../rail.dat", "x"}}), "holds no rail.dat");
        row("two sliders", packed({{"a/rail.dat", "x"}, {"b/rail.dat", "y"}}),
            "holds both \"a/rail.dat\" and \"b/rail.dat\"; which one is meant is not clear");
        row("runs twice", packed({{"rail.dat", "x"}, {"run.dat", "y"}, {"RUN.DAT", "z"}}), "holds \"run.dat\" twice");
        row(
            "damaged content",
            [&] {
                std::string bytes = good;
                for (std::size_t i = 60; i < 100; ++i) bytes[i] = static_cast<char>(~bytes[i]);
                return bytes;
            }(),
            "\"rail.dat\" cannot be read: ");
        // 17 MiB of blanks are 17 kB in an archive.
        row("a member that swells", packed({{"rail.dat", std::string(maximumCmlFileSize + 1, ' ')}}),
            "\"rail.dat\" is larger than 16 MiB");
        row(
            "a member that swells and lies",
            [] {
                const std::string_view size("\x01\x00\x00\x01", 4); // 16 MiB + 1, as stated in both places
                return withBytes(packed({{"rail.dat", std::string(maximumCmlFileSize + 1, ' ')}}), size,
                                 std::string_view("\x40\x00\x00\x00", 4));
            }(),
            "\"rail.dat\" ");
        row(
            "a method that nobody knows",
            [&] {
                // The method, 8 = deflate, stands 8 bytes into the local header and 10 into that of the directory.
                std::string bytes = packed({{"rail.dat", cmlRailText()}});
                bytes[8] = 77;
                bytes[bytes.find("PK\x01\x02") + 10] = 77;
                return bytes;
            }(),
            "\"rail.dat\" cannot be read: ");
        row(
            "encrypted",
            [&] {
                std::string bytes = packed({{"rail.dat", cmlRailText()}});
                bytes[6] = static_cast<char>(bytes[6] | 1); // bit 0 of the flags
                const auto entry = bytes.find("PK\x01\x02");
                bytes[entry + 8] = static_cast<char>(bytes[entry + 8] | 1);
                return bytes;
            }(),
            "\"rail.dat\" is encrypted");
    }
    void refused()
    {
        QFETCH(QByteArray, bytes);
        QFETCH(QByteArray, problem);
        const std::string message = problemOf(bytes.toStdString());
        QVERIFY2(message.starts_with(problem.toStdString()), message.c_str());
    }
    void damagedArchivesDoNoHarm()
    {
        std::mt19937 generator(17);
        const std::string good = packed({{"rail.dat", cmlRailText()}, {"run.dat", cmlRunText()}});
        std::uniform_int_distribution<std::size_t> place(0, good.size() - 1);
        std::uniform_int_distribution<int> byte(0, 255);
        int refused = 0;
        for (int round = 0; round < 3000; ++round) {
            std::string bytes = good;
            for (int i = 0; i < 4; ++i) bytes[place(generator)] = static_cast<char>(byte(generator));
            const auto archive = readCmlArchive(bytes);
            if (std::holds_alternative<FileProblem>(archive)) {
                ++refused;
                continue;
            }
            // What was read passed its checksum.
            for (const CmlMember& member : std::get<CmlArchive>(archive).members)
                QVERIFY(member.text == cmlRailText() || member.text == cmlRunText());
        }
        QVERIFY(refused > 1000);
    }
};

TOUCHDOWN_TEST(TestCmlArchive)

} // namespace test_cml_archive

#include "test_cml_archive.moc"

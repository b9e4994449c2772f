// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/disk_setup.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include <sys/stat.h>
#include <time.h>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "core/case/contact_kind.h"
#include "core/case/parameters.h"
#include "core/case_files/case_file.h"
#include "core/case_files/case_settings.h"
#include "core/simulation/run.h"
#include "tests/support/open_count.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_disk_setup {

const QByteArray caseText = R"(title = "a measured disk"
model = "contact"

[approach]
start = "5 nm"
closest = "3 nm"

[disk.surface]
kind = "file"
motion = "still"
file = "measured/track.txt"
)";

/// x [um], height [nm].
const QByteArray profile = "# x [um]  h [nm]\n0 0\n1 1\n2 0\n3 -1\n4 0\n5 1\n6 0\n7 -1\n";

class TestDiskSetup : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        folder_ = std::make_unique<QTemporaryDir>();
        QVERIFY(QDir(folder_->path()).mkdir("measured"));
        put("case.toml", caseText);
        put("measured/track.txt", profile);
    }

    /// The file is looked for in the folder of the case, not in the working one.
    void fileBesideTheCase()
    {
        const CaseDocument document = readCaseFile(path("case.toml"));
        QVERIFY2(document.valid(), document.valid() ? "" : document.problems.front().text().c_str());
        const DiskTopography surface = diskTopography(document.value);
        QVERIFY(!surface.flat());
        // Above its mean plane, wherever that is; the same across.
        QVERIFY(std::abs(surface.height(1e-6, 0.0) - surface.height(3e-6, 5e-6) - 2e-9) < 1e-15);
        QCOMPARE(reasonNotToRun(document.value), std::string());
        QCOMPARE(run(document.value).status, RunStatus::Completed);
    }
    void settingsLookThereToo()
    {
        put("case.toml", QByteArray(caseText).replace("\"measured/track.txt\"", "\"other.txt\""));
        CaseDocument document = readCaseFile(path("case.toml"));
        QVERIFY(!document.valid());
        applySettings(document, {"disk.surface.file=measured/track.txt"});
        QVERIFY(document.valid());
    }
    /// One of the whole file stands at the line that names it; one of its lines tells that line. A setting has none.
    void aProblemNamesTheCaseThatNamesTheFile()
    {
        const std::string name = path("case.toml").string();
        QVERIFY(QFile::remove(folder_->filePath("measured/track.txt")));
        CaseDocument document = readCaseFile(path("case.toml"));
        QCOMPARE(document.problems.size(), std::size_t{1});
        QCOMPARE(document.problems.front().text(),
                 name + ":11: disk.surface.file: \"measured/track.txt\" does not exist");
        applySettings(document, {"run.duration=1 ms"});
        QCOMPARE(document.problems.front().line, 11);
        applySettings(document, {"disk.surface.file=other.txt"});
        QCOMPARE(document.problems.front().text(),
                 std::string("--set: disk.surface.file: \"other.txt\" does not exist"));
        put("measured/track.txt", "0 0\n1 x\n");
        document = readCaseFile(path("case.toml"));
        QCOMPARE(document.problems.front().file, std::string("measured/track.txt"));
        QVERIFY(document.problems.front().line > 0);
        QVERIFY2(document.problems.front().message.ends_with("; " + name + ":11 names this file"),
                 document.problems.front().message.c_str());
    }
    void problems_data()
    {
        QTest::addColumn<QByteArray>("file");
        QTest::addColumn<QString>("says");
        QTest::newRow("no number") << QByteArray("0 0\n1 x\n2 0\n") << "track.txt";
        QTest::newRow("uneven steps") << QByteArray("0 0\n1 1\n3 0\n") << "track.txt";
        QTest::newRow("empty") << QByteArray() << "track.txt";
    }
    void problems()
    {
        QFETCH(QByteArray, file);
        QFETCH(QString, says);
        put("measured/track.txt", file);
        const CaseDocument document = readCaseFile(path("case.toml"));
        QCOMPARE(document.problems.size(), std::size_t{1});
        QVERIFY2(QString::fromStdString(document.problems.front().text()).contains(says),
                 document.problems.front().text().c_str());
    }
    void unitsOfTheCase()
    {
        put("measured/track.txt", "0 0\n1 1\n2 0\n3 -1\n4 0\n");
        CaseDocument document = readCaseFile(path("case.toml"));
        QCOMPARE(document.problems.size(), std::size_t{1});
        QVERIFY(document.problems.front().message.find("disk.surface.unit") != std::string::npos);
        applySettings(document, {"disk.surface.unit=um, nm"});
        QVERIFY(document.valid());
        const DiskTopography surface = diskTopography(document.value);
        QVERIFY(std::abs(surface.height(1e-6, 0.0) - surface.height(3e-6, 0.0) - 2e-9) < 1e-15);
        applySettings(document, {"disk.surface.unit=um, V"});
        QCOMPARE(document.problems.size(), std::size_t{1});
        QCOMPARE(document.problems.front().key, std::string("disk.surface.unit"));
    }
    /// Of rms and of steps, when the case is read, changed and run.
    void roughnessOfAnotherUnitIsAWarning()
    {
        put("measured/track.txt", "# x [mm]  h [um]\n0 90\n0.5 1\n1 0\n1.5 -1\n2 0\n2.5 1\n3 0\n3.5 -1\n");
        CaseDocument document = readCaseFile(path("case.toml"));
        QVERIFY(document.valid());
        QCOMPARE(document.warnings.size(), std::size_t{1});
        QCOMPARE(document.warnings.front().key, std::string("disk.surface.file"));
        put("measured/track.txt", QByteArray(profile).replace("[um]", "[m]"));
        applySettings(document, {});
        QCOMPARE(document.warnings.size(), std::size_t{1});
        QVERIFY(document.warnings.front().message.find("apart") != std::string::npos);
        const Summary summary = run(document.value);
        QVERIFY(!summary.warnings.empty() && summary.warnings.back().find("apart") != std::string::npos);
        put("measured/track.txt", profile);
        applySettings(document, {});
        QVERIFY(document.warnings.empty());
    }
    /// A problem and a warning, of the whole file and of one of its lines.
    void whatIsSaidOfTheFileNamesItsCase()
    {
        const auto namesCase = [this](const QByteArray& file, const std::vector<std::string>& settings = {}) {
            put("measured/track.txt", file);
            CaseDocument document = readCaseFile(path("case.toml"));
            if (!settings.empty()) applySettings(document, settings);
            const auto& said = document.valid() ? document.warnings : document.problems;
            return said.size() == 1 && said.front().text().find("case.toml:") != std::string::npos &&
                   said.front().text().find("track.txt") != std::string::npos;
        };
        const std::vector<std::string> setting{"approach.closest=4 nm"};
        for (const auto& settings : {std::vector<std::string>{}, setting}) {
            QVERIFY(namesCase(QByteArray(profile).replace("[um]", "[m]"), settings));          // points far apart
            QVERIFY(namesCase(QByteArray(profile).replace("h [nm]", "depth [nm]"), settings)); // turned, line 1
            QVERIFY(namesCase(QByteArray(profile).replace("\n1 1\n", "\n1 one\n"), settings));
            QVERIFY(namesCase("0 0\n1 1\n2 0\n3 -1\n4 0\n", settings)); // no unit
        }
    }
    /// The command that runs a case with a setting reads it, sets, asks whether it can run, runs it and lists its
    /// warnings.
    void anUnchangedFileIsReadOnce()
    {
        makeOlder("measured/track.txt");
        test::OpenCount opened(path("measured/track.txt"));
        CaseDocument document = readCaseFile(path("case.toml"));
        applySettings(document, {"approach.closest=4 nm"});
        QCOMPARE(reasonNotToRun(document.value), std::string());
        QCOMPARE(run(document.value).status, RunStatus::Completed);
        QVERIFY(checkDiskFile(document.value).warnings.empty());
        QCOMPARE(opened.taken(), 1);
    }
    /// By its content, its name or its unit; also twice within a step of the clock of file times.
    void aChangedFileIsReadAnew()
    {
        const auto rise = [this](const CaseDocument& document) { // from 1 to 3 um [m]
            const DiskTopography surface = diskTopography(document.value);
            return surface.height(1e-6, 0.0) - surface.height(3e-6, 0.0);
        };
        makeOlder("measured/track.txt");
        CaseDocument document = readCaseFile(path("case.toml"));
        QVERIFY(std::abs(rise(document) - 2e-9) < 1e-15);
        for (int height = 2; height < 7; ++height) {
            QByteArray other = profile;
            put("measured/track.txt", other.replace("\n1 1\n", "\n1 " + QByteArray::number(height) + "\n"));
            QVERIFY(std::abs(rise(document) - (height + 1) * 1e-9) < 1e-15);
        }
        put("measured/track.txt", "0 0\n1 1\n2 0\n3 -1\n4 0\n5 1\n6 0\n7 -1\n");
        makeOlder("measured/track.txt");
        QVERIFY(!checkDiskFile(document.value).problems.empty()); // has no unit
        applySettings(document, {"disk.surface.unit=um, nm"});
        QVERIFY(std::abs(rise(document) - 2e-9) < 1e-15);
        applySettings(document, {"disk.surface.unit=um, pm"});
        QVERIFY(std::abs(rise(document) - 2e-12) < 1e-17);
        put("measured/other.txt", "0 0\n1 2\n2 0\n3 -2\n4 0\n5 2\n6 0\n7 -2\n");
        applySettings(document, {"disk.surface.file=measured/other.txt"});
        QVERIFY(std::abs(rise(document) - 4e-12) < 1e-17);
        QVERIFY(QFile::remove(folder_->filePath("measured/other.txt")));
        QVERIFY(!checkDiskFile(document.value).problems.empty());
    }
    /// A slope above 1 is a problem; one above 0.1, and a surface that was turned, are warnings.
    void slopesAndSigns()
    {
        put("measured/track.txt", QByteArray(profile).replace("[um]", "[nm]").replace("h [nm]", "h [um]"));
        CaseDocument document = readCaseFile(path("case.toml"));
        QCOMPARE(document.problems.size(), std::size_t{1});
        QVERIFY(document.problems.front().message.find("slope") != std::string::npos);
        put("measured/track.txt", "# x [nm]  h [A]\n0 0\n1 5\n2 0\n3 -5\n4 0\n5 5\n6 0\n7 -5\n"); // 0.5
        applySettings(document, {});
        QVERIFY(document.valid());
        QCOMPARE(document.warnings.size(), std::size_t{1});
        put("measured/track.txt", QByteArray(profile).replace("h [nm]", "depth [nm]"));
        applySettings(document, {});
        QVERIFY(document.valid());
        QCOMPARE(document.warnings.size(), std::size_t{1});
        QCOMPARE(document.warnings.front().line, 1);
        const DiskTopography surface = diskTopography(document.value);
        QVERIFY(std::abs(surface.height(3e-6, 0.0) - surface.height(1e-6, 0.0) - 2e-9) < 1e-15);
        const Summary summary = run(document.value);
        QVERIFY(std::ranges::any_of(summary.warnings,
                                    [](const std::string& each) { return each.find("turned") != std::string::npos; }));
    }
    void missing()
    {
        QVERIFY(QFile::remove(folder_->filePath("measured/track.txt")));
        const CaseDocument document = readCaseFile(path("case.toml"));
        QVERIFY(!document.valid());
        QVERIFY(!reasonNotToRun(document.value).empty());
        const Summary summary = run(document.value);
        QCOMPARE(summary.status, RunStatus::Failed);
        QVERIFY(!summary.message.empty());
    }
    /// What does not use the file does not look for it.
    void unusedFile()
    {
        CaseDocument document = readCaseFile(path("case.toml"));
        document.value.diskSurface.file = "missing.txt";
        document.value.diskSurface.kind = DiskSurfaceKind::Flat;
        QVERIFY(checkDiskFile(document.value).problems.empty());
        QVERIFY(diskTopography(document.value).flat());
        document.value.diskSurface.kind = DiskSurfaceKind::File;
        document.value.contact = ContactKind::Asperity;
        QVERIFY(checkDiskFile(document.value).problems.empty());
    }

private:
    std::filesystem::path path(const char* name) const { return folder_->filePath(name).toStdString(); }
    void put(const QString& name, const QByteArray& text) const
    {
        QFile file(folder_->filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(text), text.size());
    }
    /// Waits until a change of the file would get another time than its last one.
    void makeOlder(const char* name) const
    {
        struct stat status {};
        QCOMPARE(::stat(path(name).c_str(), &status), 0);
        const auto isLater = [&status] {
            timespec now{};
            ::clock_gettime(CLOCK_REALTIME_COARSE, &now);
            return std::pair(now.tv_sec, now.tv_nsec) > std::pair(status.st_ctim.tv_sec, status.st_ctim.tv_nsec);
        };
        QTRY_VERIFY(isLater());
    }
    std::unique_ptr<QTemporaryDir> folder_;
};

TOUCHDOWN_TEST(TestDiskSetup)

} // namespace test_disk_setup

#include "test_disk_setup.moc"

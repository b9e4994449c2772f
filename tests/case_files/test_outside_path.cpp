// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case_files/outside_path.h"

#include <QTemporaryDir>
#include <QTest>

#include "core/case/parameters.h"
#include "core/case_files/case_file.h"
#include "core/case_files/case_reader.h"
#include "core/case_files/case_settings.h"
#include "core/case_files/cml_case.h"
#include "core/formats/text_file.h"
#include "tests/support/cml_sample.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_outside_path {

namespace fs = std::filesystem;

const std::string surfaceCase = "model = \"contact\"\n[disk.surface]\nkind = \"file\"\nmotion = \"still\"\nfile = ";
const std::string profile = "# x [um]  h [nm]\n0 0\n1 1\n2 0\n3 -1\n";
const std::string secret = "the secret words of somebody else\n";

std::string allText(const CaseDocument& document)
{
    std::string all;
    for (const auto* list : {&document.problems, &document.warnings})
        for (const InputProblem& each : *list) all += each.text() + '\n';
    return all;
}

class TestOutsidePath : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    fs::path path(const std::string& name) const { return fs::path(folder_.path().toStdString()) / name; }
    void put(const std::string& name, const std::string& text) const
    {
        fs::create_directories(path(name).parent_path());
        QCOMPARE(writeTextFile(path(name), text), std::string());
    }
    CaseDocument caseNaming(const std::string& file, OutsidePaths outside = OutsidePaths::Refused) const
    {
        return parseCase(surfaceCase + '"' + file + "\"\n", "a.toml", path("case"), outside);
    }

private slots:
    void initTestCase()
    {
        put("case/track.txt", profile);
        put("case/sub/track.txt", profile);
        put("case2/track.txt", profile);
        put("track.txt", profile);
        put("secret.txt", secret);
        fs::create_symlink("../secret.txt", path("case/innocent.txt"));
        fs::create_symlink("sub/track.txt", path("case/link.txt"));
        fs::create_directory_symlink("..", path("case/up"));
        fs::create_directory_symlink("case", path("alias"));
    }

    void leads_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<bool>("outside");
        const auto row = [](const QString& name, bool outside) { QTest::newRow(qPrintable(name)) << name << outside; };
        row("track.txt", false);
        row("sub/track.txt", false);
        row("sub/../track.txt", false);
        row("nowhere/../track.txt", false);
        row("link.txt", false);
        row("../case/track.txt", false);
        row(QString::fromStdString(path("case/track.txt").string()), false);
        row("../track.txt", true);
        row("../case2/track.txt", true);
        row("sub/../../track.txt", true);
        row("innocent.txt", true);
        row("up/track.txt", true);
        row("/etc/hostname", true);
        row("/nowhere", true);
    }
    void leads()
    {
        QFETCH(QString, name);
        QFETCH(bool, outside);
        for (const char* folder : {"case", "case/", "alias", "alias/"})
            QCOMPARE(leadsOutside(path(folder), name.toStdString()), outside);
    }
    /// A case without a folder stands in the working one.
    void withoutAFolder()
    {
        QVERIFY(!leadsOutside({}, "track.txt"));
        QVERIFY(leadsOutside({}, "../track.txt"));
    }

    /// What a study sets in a sample case, which has no folder; a person may.
    void settingsOfASampleCase()
    {
        CaseDocument fromFile = openCase("contact_rough"), fromPerson = fromFile;
        const fs::path before = fs::current_path();
        fs::current_path(path("case"));
        applySettings(fromFile, {"disk.surface.kind=file", "disk.surface.file=track.txt"}, OutsidePaths::Refused);
        applySettings(fromPerson, {"disk.surface.kind=file", "disk.surface.file=track.txt"}, OutsidePaths::Allowed);
        fs::current_path(before);
        QVERIFY(allText(fromFile).find("lies outside the folder") != std::string::npos);
        QVERIFY(allText(fromPerson).find("lies outside the folder") == std::string::npos);
    }

    void aSurfaceIsRefusedByKeyAndLine()
    {
        QVERIFY(caseNaming("track.txt").valid());
        for (const std::string& file : {std::string("../track.txt"), path("secret.txt").string(),
                                        std::string("innocent.txt"), std::string("/dev/zero")}) {
            const CaseDocument document = caseNaming(file);
            QCOMPARE(document.problems.size(), std::size_t{1});
            QVERIFY(document.problems.front().text().starts_with("a.toml:5: disk.surface.file: names \""));
            QVERIFY(document.problems.front().text().find("--allow-paths") != std::string::npos);
            QCOMPARE(document.outsideFiles, std::vector<std::string>{file});
            QCOMPARE(document.value.diskSurface.file, std::string());
            QVERIFY(allText(document).find("secret words") == std::string::npos);
        }
        QVERIFY(caseNaming("../track.txt", OutsidePaths::Allowed).valid());
        QVERIFY(allText(caseNaming("../secret.txt", OutsidePaths::Allowed)).find("outside") == std::string::npos);
    }

    void railsAreRefused()
    {
        put("rail.dat", touchdown::test::cmlRailText());
        const auto read = [&](OutsidePaths outside) {
            return parseCase("model = \"film\"\nabs.rails = \"../rail.dat\"\n", "a.toml", path("case"), outside);
        };
        const CaseDocument document = read(OutsidePaths::Refused);
        QCOMPARE(document.problems.size(), std::size_t{1});
        QVERIFY(document.problems.front().text().starts_with("a.toml:2: abs.rails: names \"../rail.dat\""));
        QVERIFY(read(OutsidePaths::Allowed).valid());
    }

    /// What a person types takes the place of what the case may not name; what a file says does not.
    void settings()
    {
        const std::string elsewhere = path("track.txt").string();
        CaseDocument typed = caseNaming("../secret.txt");
        applySettings(typed, {"disk.surface.file=" + elsewhere});
        QVERIFY2(typed.valid(), allText(typed).c_str());
        QCOMPARE(typed.value.diskSurface.file, elsewhere);

        CaseDocument other = caseNaming("../secret.txt");
        applySettings(other, {"disk.surface.motion=moving"});
        QCOMPARE(other.problems.size(), std::size_t{1});

        CaseDocument written = caseNaming("track.txt");
        applySettings(written, {"disk.surface.file=" + path("secret.txt").string()}, OutsidePaths::Refused);
        QCOMPARE(written.problems.size(), std::size_t{1});
        QVERIFY(allText(written).find("outside the folder") != std::string::npos);
        QVERIFY(allText(written).find("secret words") == std::string::npos);

        Case c = caseNaming("track.txt").value;
        const Case before = c;
        const auto problem = changeCase(c, {{"disk.surface.file", elsewhere}});
        QVERIFY(problem && problem->key == "disk.surface.file" && problem->message.starts_with("names \""));
        QVERIFY(c == before);
        QVERIFY(!changeCase(c, {{"disk.surface.file", "sub/track.txt"}}));
    }

    /// Files of the established program: links out of their folder, and a path in the comments of run.dat.
    void filesOfTheEstablishedProgram()
    {
        put("cml/rail.dat", touchdown::test::cmlRailText());
        fs::create_symlink("../secret.txt", path("cml/run.dat"));
        const CaseDocument linked = readCmlCase(path("cml"));
        QCOMPARE(linked.problems.size(), std::size_t{1});
        QVERIFY(allText(linked).find("outside the folder") != std::string::npos);
        QVERIFY(allText(linked).find("secret words") == std::string::npos);
        QVERIFY(readCmlCase(path("cml"), OutsidePaths::Allowed).outsideFiles.empty());

        fs::remove(path("cml/run.dat"));
        Case c = defaultsOf(ModelKind::Film);
        c.diskSurface.file = path("secret.txt").string();
        const CmlOutput output = formatCmlCase(c);
        QCOMPARE(output.problem, std::string());
        for (const CmlMember& member : output.members) put("kept/" + member.name, member.text);
        const CaseDocument document = readCmlCase(path("kept"));
        QCOMPARE(document.outsideFiles, std::vector<std::string>{path("secret.txt").string()});
        QCOMPARE(document.problems.front().key, std::string("disk.surface.file"));
        QCOMPARE(document.value.diskSurface.file, std::string());
        QVERIFY(readCmlCase(path("kept"), OutsidePaths::Allowed).valid());
    }

    /// The file that a person opens may itself be a link, and the folder, too.
    void whatAPersonOpens()
    {
        put("case/mine.toml", surfaceCase + "\"track.txt\"\n");
        QVERIFY(openCase(path("alias/mine.toml").string()).valid());
    }
};

TOUCHDOWN_TEST(TestOutsidePath)

} // namespace test_outside_path

#include "test_outside_path.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the program writes takes the place of nothing but an older file of that name: no input, no file that another run
// writes, and nothing that stands beside it.
#include <QtTest>
#include <csignal>
#include <memory>

#include <unistd.h>

#include "core/results/results_reader.h"
#include "tests/support/cml_sample.h"
#include "tests/support/command_process.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_output_target {

const QByteArray precious = "precious";

class TestOutputTarget : public QObject {
    Q_OBJECT

private slots:
    void init() { folder_ = std::make_unique<CommandFolder>(); }

    void ofAnotherRun_data()
    {
        QTest::addColumn<QStringList>("arguments");
        const auto row = [](const char* name, const QStringList& arguments) { QTest::newRow(name) << arguments; };
        row("results of a run", {"run", "fig12a", "--set", "run.duration=10 us", "--out", "two.h5"});
        row("results by a link", {"run", "fig12a", "--set", "run.duration=10 us", "--out", "link.h5"});
        row("time series", {"run", "fig12a", "--set", "run.duration=10 us", "--csv", "two.csv"});
        row("results beside a free time series",
            {"run", "fig12a", "--set", "run.duration=10 us", "--out", "two.h5", "--csv", "free.csv"});
        row("static state", {"steady", "film_plane", "--out", "two.h5"});
        row("study", {"study", "hysteresis", "fig10a", "--out", "two.h5"});
        row("table of a study", {"study", "hysteresis", "fig10a", "--csv", "two.csv"});
    }
    void ofAnotherRun()
    {
        QFETCH(const QStringList, arguments);
        QVERIFY(QFile::link("two.h5", folder_->path("link.h5")));
        QProcess first;
        first.setWorkingDirectory(folder_->path());
        first.start(TOUCHDOWN_COMMAND, {"run", "fig10a", "--set", "run.duration=9 s", "--set",
                                        "run.sample_interval=1 us", "--out", "two.h5", "--csv", "two.csv"});
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(folder_->path("two.h5")), 20000);
        const Outcome second = folder_->touchdown(arguments);
        QCOMPARE(second.code, 2);
        QVERIFY2(second.err.contains("another run writes to it"), second.err);
        QVERIFY2(second.err.contains(arguments.last().toUtf8()) || second.err.contains("two.h5"), second.err);
        QCOMPARE(second.errorLines().size(), 1);
        const std::string file = folder_->path("two.h5").toStdString();
        QTRY_VERIFY_WITH_TIMEOUT(readResults(file).samples.size() > 1000, 20000);
        first.terminate();
        QCOMPARE(outcome(first).code, 1);
        QCOMPARE(readResults(file).status, std::string("cancelled"));
        QCOMPARE(readResults(file).title, openCase("fig10a").value.title);
        QCOMPARE(folder_->files(), QStringList({"link.h5", "two.csv", "two.h5"}));
    }

    /// Its lock went with it, its part is removed by the next run.
    void ofAKilledRun()
    {
        QProcess first;
        first.setWorkingDirectory(folder_->path());
        first.start(TOUCHDOWN_COMMAND,
                    {"run", "fig10a", "--set", "run.duration=9 s", "--out", "a.h5", "--csv", "a.csv"});
        const std::string file = folder_->path("a.h5").toStdString();
        QTRY_VERIFY_WITH_TIMEOUT(readResults(file).samples.size() > 0, 20000);
        first.kill();
        QVERIFY(first.waitForFinished(20000));
        QCOMPARE(readResults(file).status, std::string("interrupted"));
        QVERIFY(!folder_->files().contains("a.csv"));
        const Outcome second = folder_->touchdown({"run", "fig10a", "--out", "a.h5", "--csv", "a.csv"});
        QCOMPARE(second.code, 0);
        QCOMPARE(readResults(file).status, std::string("completed"));
        QCOMPARE(folder_->files(), QStringList({"a.csv", "a.h5"}));
    }

    void overAnInput_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("input");
        const auto row = [](const char* name, const QStringList& arguments, const char* input) {
            QTest::newRow(name) << arguments << QString::fromLatin1(input);
        };
        row("measured surface", {"run", "pad.toml", "--out", "profile.txt"}, "profile.txt");
        row("measured surface, by --set",
            {"run", "contact_rough", "--set", "disk.surface.kind=file", "disk.surface.file=profile.txt", "--csv",
             "profile.txt"},
            "profile.txt");
        row("rails", {"steady", "film.toml", "--out", "r.dat"}, "r.dat");
        row("rails, by a symbolic link", {"steady", "film.toml", "--out", "soft"}, "r.dat");
        row("rails, by a hard link", {"steady", "film.toml", "--out", "hard"}, "r.dat");
        row("file of a CML folder", {"steady", "cml", "--out", "cml/rail.dat"}, "cml/rail.dat");
        row("case of a study", {"study", "hysteresis", "study.toml", "--out", "mine.toml"}, "mine.toml");
        row("table over the case of a study", {"study", "hysteresis", "study.toml", "--csv", "mine.toml"}, "mine.toml");
        row("found case over the case of a study", {"advise", "advice.toml", "--apply", "film.toml"}, "film.toml");
        row("further case of a study", {"study", "convergence", "grids.toml", "--csv", "mine.toml"}, "mine.toml");
        row("conversion to its source", {"convert", "film.toml", "film.toml"}, "film.toml");
        row("conversion to its rails", {"convert", "film.toml", "."}, "rail.dat");
        row("conversion of a folder to itself", {"convert", "cml", "cml", "--force"}, "cml/rail.dat");
        row("conversion of a folder to a link of its file", {"convert", "cml", "soft.toml"}, "cml/run.dat");
    }
    void overAnInput()
    {
        QFETCH(const QStringList, arguments);
        QFETCH(const QString, input);
        QVERIFY(QDir(folder_->path()).mkdir("cml"));
        folder_->put("cml/rail.dat", QByteArray::fromStdString(test::cmlRailText()));
        folder_->put("cml/run.dat", QByteArray::fromStdString(test::cmlRunText()));
        folder_->put("r.dat", QByteArray::fromStdString(test::cmlRailText()));
        QVERIFY(QFile::link("r.dat", folder_->path("soft")));
        QVERIFY(QFile::link("cml/run.dat", folder_->path("soft.toml")));
        QCOMPARE(::link(folder_->path("r.dat").toUtf8(), folder_->path("hard").toUtf8()), 0);
        QCOMPARE(::link(folder_->path("r.dat").toUtf8(), folder_->path("rail.dat").toUtf8()), 0);
        folder_->put("film.toml", "model = \"film\"\n[abs]\nrails = \"r.dat\"\n");
        QByteArray profile = "x [um] h [nm]\n";
        for (int i = 0; i < 400; ++i) profile += QByteArray::number(i) + (i % 2 == 0 ? " 0\n" : " 0.1\n");
        folder_->put("profile.txt", profile);
        folder_->put("pad.toml", "model = \"contact\"\ncontact = \"elastic\"\n[disk.surface]\nkind = \"file\"\n"
                                 "file = \"profile.txt\"\n");
        folder_->put("mine.toml", defaultCase());
        folder_->put("study.toml", "kind = \"hysteresis\"\ncase = \"mine.toml\"\n");
        folder_->put("advice.toml", "kind = \"advise\"\ncase = \"film.toml\"\n");
        folder_->put("grids.toml", "kind = \"convergence\"\ncase = \"film_pico\"\ncases = [\"mine.toml\"]\n");
        if (arguments.contains("grids.toml"))
            folder_->put("mine.toml", QByteArray::fromStdString(openCase("film_femto").text));
        const QStringList before = folder_->files();
        const QByteArray text = content(input);
        const Outcome o = folder_->touchdown(arguments);
        QCOMPARE(o.code, 2);
        QVERIFY2(o.err.contains("is read by this command") || o.err.contains("is what is converted"), o.err);
        QCOMPARE(content(input), text);
        QCOMPARE(folder_->files(), before);
    }

    void killedCommandsLeaveNoLitter_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QStringList>("left");
        const auto row = [](const char* name, const QStringList& arguments, const QStringList& left) {
            QTest::newRow(name) << arguments << left;
        };
        row("run", {"run", "fig10a", "--set", "run.duration=9 s", "--out", "a.h5", "--csv", "a.csv"}, {"a.h5"});
        row("steady", {"steady", "film_pico", "--set", "film.nodes=705,705", "film.tolerance=1e-13", "--out", "a.h5"},
            {});
        row("study",
            {"study", "hysteresis", "fig10a", "--option", "steps=400", "hold=10 s", "--out", "a.h5", "--csv", "a.csv"},
            {});
    }
    /// kill -9: what is not shown goes with the program, or with the next one that writes into the folder.
    void killedCommandsLeaveNoLitter()
    {
        QFETCH(const QStringList, arguments);
        QFETCH(const QStringList, left);
        QProcess process;
        process.setWorkingDirectory(folder_->path());
        process.start(TOUCHDOWN_COMMAND, arguments + QStringList{"--progress"});
        process.setReadChannel(QProcess::StandardError);
        QVERIFY(process.waitForReadyRead(60000)); // it is under way
        process.kill();
        QVERIFY(process.waitForFinished(20000));
        QCOMPARE(process.exitStatus(), QProcess::CrashExit);
        for (const QString& file : folder_->files())
            QVERIFY2(left.contains(file) || file.startsWith("a.h5.touchdown.") || file == "a.csv.touchdown.lock",
                     qPrintable(file));
        QCOMPARE(folder_->touchdown({"convert", "fig10a", "b.toml"}).code, 0);
        QCOMPARE(folder_->files(), left + QStringList{"b.toml"});
    }

    void plantedFilesStay_data()
    {
        QTest::addColumn<QStringList>("arguments");
        const auto row = [](const char* name, const QStringList& arguments) { QTest::newRow(name) << arguments; };
        row("run", {"run", "fig10a", "--out", "a.h5", "--csv", "a.csv"});
        row("steady", {"steady", "film_plane", "--out", "a.h5"});
        row("study", {"study", "hysteresis", "fig10a", "--option", "steps=3", "--out", "a.h5", "--csv", "a.csv"});
        row("convert", {"convert", "film_pico", "a.toml"});
    }
    /// A file of the person's own, and a link to one, with the name of a part of other programs.
    void plantedFilesStay()
    {
        QFETCH(const QStringList, arguments);
        folder_->put("own", precious);
        for (const char* part : {"a.h5.part", "a.csv.part", "a.toml.part"})
            QVERIFY(QFile::link("own", folder_->path(part)));
        folder_->put("a.h5.touchdown.mine.part", precious);
        const Outcome o = folder_->touchdown(arguments);
        QCOMPARE(o.code, 0);
        QCOMPARE(content("own"), precious);
        QCOMPARE(content("a.h5.touchdown.mine.part"), precious);
        for (const char* part : {"a.h5.part", "a.csv.part", "a.toml.part"})
            QCOMPARE(QFileInfo(folder_->path(part)).symLinkTarget(), folder_->path("own"));
        QVERIFY(!QFileInfo(folder_->path("a.h5")).isSymLink());
    }

    void aLockIsNotFollowed_data() { plantedFilesStay_data(); }
    void aLockIsNotFollowed()
    {
        QFETCH(const QStringList, arguments);
        folder_->put("own", precious);
        for (const char* lock : {"a.h5.touchdown.lock", "a.csv.touchdown.lock", "a.toml.touchdown.lock"})
            QVERIFY(QFile::link("own", folder_->path(lock)));
        const QStringList before = folder_->files();
        const Outcome o = folder_->touchdown(arguments);
        QCOMPARE(o.code, 2);
        QVERIFY2(o.err.contains("is in the way"), o.err);
        QCOMPARE(content("own"), precious);
        QCOMPARE(folder_->files(), before);
    }

    void modesAreKept_data() { plantedFilesStay_data(); }
    void modesAreKept()
    {
        QFETCH(const QStringList, arguments);
        for (const char* name : {"a.h5", "a.csv", "a.toml"}) {
            folder_->put(name, "old");
            QVERIFY(QFile::setPermissions(folder_->path(name), mode_));
        }
        QCOMPARE(folder_->touchdown(arguments).code, 0);
        for (const char* name : {"a.h5", "a.csv", "a.toml"}) {
            QCOMPARE(QFile::permissions(folder_->path(name)) & ~userBits_, mode_ & ~userBits_);
            QCOMPARE(content(name) == "old", !arguments.contains(QString::fromLatin1(name)));
        }
    }

    void existingFilesOfCmlNeedForce_data()
    {
        QTest::addColumn<QString>("target");
        QTest::addColumn<QString>("file");
        QTest::newRow("folder") << "folder"
                                << "folder/rail.dat";
        QTest::newRow("folder, another spelling") << "folder"
                                                  << "folder/RUN.DAT";
        QTest::newRow("archive") << "a.cml"
                                 << "a.cml";
    }
    void existingFilesOfCmlNeedForce()
    {
        QFETCH(const QString, target);
        QFETCH(const QString, file);
        if (target != file) QVERIFY(QDir(folder_->path()).mkdir(target));
        folder_->put(file, precious);
        const QStringList arguments{"convert", "film_pico", target};
        const Outcome o = folder_->touchdown(arguments);
        QCOMPARE(o.code, 2);
        QVERIFY2(o.err.contains(file.toUtf8()) && o.err.contains("--force"), o.err);
        QCOMPARE(content(file), precious);
        QCOMPARE(folder_->touchdown(arguments + QStringList{"--force"}).code, 0);
        QVERIFY(openCase(folder_->path(target).toStdString()).valid());
    }

private:
    QByteArray content(const QString& name) const
    {
        QFile file(folder_->path(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    const QFile::Permissions mode_ = QFile::ReadOwner | QFile::WriteOwner | QFile::ReadGroup;
    const QFile::Permissions userBits_ = QFile::ReadUser | QFile::WriteUser | QFile::ExeUser; // of who asks
    std::unique_ptr<CommandFolder> folder_;
};

TOUCHDOWN_TEST(TestOutputTarget)

} // namespace test_output_target

#include "test_output_target.moc"

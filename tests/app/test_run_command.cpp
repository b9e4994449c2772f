// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <random>

#include <QtTest>

#include "core/case_files/case_reader.h"
#include "core/results/results_reader.h"
#include "tests/support/command_process.h"
#include "tests/support/open_count.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_run_command {

class TestRunCommand : public QObject {
    Q_OBJECT

private slots:
    void init() { folder_ = std::make_unique<CommandFolder>(); }
    void runForPeople();
    void runAsJson();
    void stepCheckAsJson();
    void resultFiles();
    void contactCase();
    void errorsNotKnown();
    void fittedParameters();
    void everySampleCaseRuns_data();
    void everySampleCaseRuns();
    void filmCase();
    void aMeasuredDiskIsReadOnce();
    void failedRun();
    void badInput_data();
    void badInput();
    void unreadableInput_data();
    void unreadableInput();
    void everyProblemIsListed();
    void badTargets_data();
    void badTargets();
    void fullDisk_data();
    void fullDisk();
    void signalEndsARunInOrder_data();
    void signalEndsARunInOrder();
    void aFailureHasOneTime();
    void progressIsSilentUnlessAskedFor();

private:
    std::unique_ptr<CommandFolder> folder_;
};

void TestRunCommand::runForPeople()
{
    const Outcome o = folder_->touchdown({"run", "fig10a"});
    QCOMPARE(o.code, 0);
    QCOMPARE(o.err, QByteArray());
    for (const char* part : {"Fig. 10 (a)", "completed at 2 ms", "7.0000 nm", "90.600 urad", "minimum spacing",
                             "motion", "at rest: ", "kHz", "events", "steps", "dopri5", "solver time"})
        QVERIFY2(o.out.contains(part), part);
}

// Fig. 10 (a) is damped to the static state, 7 nm and 90.6 urad, within 0.001 nm and 0.01 urad.
void TestRunCommand::runAsJson()
{
    const Outcome o = folder_->touchdown({"run", "fig10a", "--json"});
    QCOMPARE(o.code, 0);
    QCOMPARE(o.err, QByteArray());
    const QJsonObject json = o.json();
    QCOMPARE(json["status"].toString(), "completed");
    QCOMPARE(json["end_time"].toDouble(), 2e-3);
    QCOMPARE(json["model"].toString(), "springs");
    QCOMPARE(json["integrator"].toString(), "dopri5");
    for (const char* key : {"steps", "rejected_steps", "evaluations", "wall_seconds", "solver_seconds"})
        QVERIFY2(json[key].toDouble(-1.0) >= 0.0, key);
    const QJsonObject final = json["final"].toObject();
    QVERIFY(std::abs(final["flying_height"].toDouble() - 7e-9) < 0.001e-9);
    QVERIFY(std::abs(final["pitch"].toDouble() - 90.6e-6) < 0.01e-6);
    QVERIFY(final["roll"].isNull());
    QVERIFY(json["message"].toString().contains("roll"));
    for (const char* key : {"minimum_spacing", "height", "contact_force", "adhesion_force", "friction_force",
                            "air_bearing_force", "energy"})
        QVERIFY2(final[key].isDouble(), key);
    const QJsonObject tail = json["tail"].toObject();
    QVERIFY(tail["roll"].isNull());
    for (const char* key : {"flying_height", "minimum_spacing", "pitch", "contact_force"})
        for (const char* statistic : {"mean", "std", "min", "max"})
            QVERIFY2(tail[key].toObject()[statistic].isDouble(), key);
    QVERIFY(json["bouncing"].isBool() && !json["bouncing"].toBool());
    QCOMPARE(json["motion"].toString(), "at rest");
    QVERIFY(!json["bouncing_rule"].toString().isEmpty());
    const QJsonArray peaks = json["spectrum"].toObject()["peaks"].toArray();
    QVERIFY(!peaks.isEmpty());
    QVERIFY(peaks[0].toObject()["frequency"].toDouble() > 0.0 && peaks[0].toObject()["amplitude"].toDouble() > 0.0);
    QVERIFY(json["step_check"].isNull());
    QVERIFY(json["warnings"].isArray());
    QVERIFY(json["events"].toArray().size() > 0);
    QVERIFY(json["events"].toArray()[0].toObject()["time"].toDouble() > 0.0);
}

void TestRunCommand::stepCheckAsJson()
{
    const Outcome o = folder_->touchdown({"run", "fig10a", "--set", "run.integrator=rk4", "run.step=10 ns", "--json"});
    const QJsonObject check = o.json()["step_check"].toObject();
    QCOMPARE(check["step"].toDouble(), 5e-9);
    QVERIFY(check["same_end_state"].isBool());
    QVERIFY(check["flying_height"].isDouble() && check["pitch"].isDouble());
    QVERIFY(!check["message"].toString().isEmpty());
}

void TestRunCommand::resultFiles()
{
    folder_->put("mine.toml", defaultCase());
    const Outcome o = folder_->touchdown({"run", "mine.toml", "--out", "a.h5", "--csv", "a.csv", "--json"});
    QCOMPARE(o.code, 0);
    QCOMPARE(folder_->files(), QStringList({"a.csv", "a.h5", "mine.toml"}));

    const StoredRun run = readResults(folder_->path("a.h5").toStdString());
    QCOMPARE(run.problem, std::string());
    QCOMPARE(run.status, std::string("completed"));
    QCOMPARE(QByteArray::fromStdString(run.caseText), defaultCase());
    // A sample every 0.1 us from 0 to 2 ms, both included.
    QCOMPARE(run.samples.size(), std::size_t{20001});
    const auto column = static_cast<std::size_t>(findQuantity(run.quantities, "flying_height"));
    QCOMPARE(run.samples.columns[column].back(), o.json()["final"].toObject()["flying_height"].toDouble());

    QFile csv(folder_->path("a.csv"));
    QVERIFY(csv.open(QIODevice::ReadOnly));
    const QList<QByteArray> lines = csv.readAll().split('\n');
    QCOMPARE(lines.size(), 20003);
    QVERIFY(lines[0].startsWith("time [s],flying_height [m],"));
    QCOMPARE(lines[20001].split(',')[1].toDouble(), run.samples.columns[column].back());
}

// Cells of 0.0625 um against a zone of adhesion of 0.01 um: null with its reason, for people "not known".
void TestRunCommand::errorsNotKnown()
{
    const QStringList arguments{"run",   "contact_pull_off",          "--set", "adhesion.equilibrium_distance=1 nm",
                                "--set", "run.sample_interval=100 us"};
    const Outcome o = folder_->touchdown(arguments + QStringList{"--json"});
    QCOMPARE(o.code, 0);
    const QJsonObject json = o.json(), figures = json["figures"].toObject();
    QVERIFY(figures["pull_off_force"].isDouble());
    QVERIFY(figures.contains("pull_off_force_error") && figures["pull_off_force_error"].isNull());
    QVERIFY(json["message"].toString().contains("pull_off_force_error"));
    const QString text = folder_->touchdown(arguments).out;
    QVERIFY2(text.contains("pull off force error  not known"), qPrintable(text));
}

// Figures in JSON and for people, fields in the file; what a pad alone does not have is null.
void TestRunCommand::contactCase()
{
    const Outcome o = folder_->touchdown({"run", "contact_rough", "--out", "a.h5", "--csv", "a.csv", "--json"});
    QCOMPARE(o.code, 0);
    const QJsonObject json = o.json();
    QVERIFY(json["final"].toObject()["flying_height"].isNull());
    QVERIFY(json["final"].toObject()["contact_force"].isDouble());
    QVERIFY(json["fit"].isNull());
    const QJsonObject figures = json["figures"].toObject();
    QVERIFY(figures["largest_contact_force"].toDouble() > 0.0);
    QVERIFY(std::abs(figures["surface_rms"].toDouble() - 0.2e-9) < 1e-15);

    const StoredRun run = readResults(folder_->path("a.h5").toStdString());
    QCOMPARE(run.problem, std::string());
    QCOMPARE(run.samples.size(), std::size_t{201});
    QCOMPARE(run.recorded.size(), std::size_t{1});
    QCOMPARE(run.recorded.front().quantities.size(), std::size_t{3}); // gap, contact pressure, disk surface
    QCOMPARE(run.fields.size(), std::size_t{41});                     // 40, and the closest approach

    const Outcome text = folder_->touchdown({"run", "contact_ono_yamane"});
    QCOMPARE(text.code, 0);
    for (const char* part : {"pull off force", "touch-down            at 3 nm, on the way in",
                             "take-off              at 5 nm, on the way out", "assumed"})
        QVERIFY2(text.out.contains(part), part);
}

void TestRunCommand::fittedParameters()
{
    const QJsonObject fit = folder_->touchdown({"run", "contact_ono_yamane_full", "--json"}).json()["fit"].toObject();
    QVERIFY(fit["describes"].toBool());
    for (const char* key : {"meniscus_force", "contact_stiffness", "initial_contact_force", "touch_down", "take_off"})
        QVERIFY2(fit[key].toDouble() > 0.0, key);
    QVERIFY(fit["message"].toString().startsWith("The five parameters describe the model"));
    const Outcome poor =
        folder_->touchdown({"run", "contact_ono_yamane_full", "--set", "asperity.height_deviation=1 nm"});
    QCOMPARE(poor.code, 0);
    QVERIFY(poor.out.contains("warning               The five parameters do not describe the model"));
}

void TestRunCommand::everySampleCaseRuns_data()
{
    QTest::addColumn<QString>("name");
    for (const SampleCase& sample : sampleCases())
        if (parseCase(sample.text, sample.name).value.model != ModelKind::Film)
            QTest::newRow(sample.name.c_str()) << QString::fromStdString(sample.name);
}

// Only Fig. 12 (b) is outside the model.
void TestRunCommand::everySampleCaseRuns()
{
    QFETCH(QString, name);
    const Outcome o = folder_->touchdown({"run", name, "--json"});
    const bool fails = name == "fig12b";
    QCOMPARE(o.code, fails ? 1 : 0);
    QCOMPARE(o.json()["status"].toString(), fails ? "failed" : "completed");
}

// A film case runs as the others do, here on a coarse grid: from 1 nm above its static state, in 5 us by 51 samples.
void TestRunCommand::filmCase()
{
    const QStringList settings{"--set",
                               "film.nodes=33,33",
                               "degrees_of_freedom=2",
                               "contact=ono-yamane",
                               "initial.state=static",
                               "initial.height_offset=1 nm",
                               "run.duration=5 us",
                               "run.field_snapshots=3"};
    const Outcome o = folder_->touchdown(
        QStringList{"run", "film_pico", "--json", "--progress", "--out", "a.h5", "--csv", "a.csv"} + settings);
    QCOMPARE(o.code, 0);
    QVERIFY2(o.err.contains("100 %") && o.err.contains("minimum spacing"), o.err);
    const QJsonObject json = o.json();
    QCOMPARE(json["status"].toString(), "completed");
    QCOMPARE(json["model"].toString(), "film");
    for (const char* key : {"flying_height", "minimum_spacing", "pitch", "roll", "height", "contact_force",
                            "adhesion_force", "friction_force", "air_bearing_force", "energy"})
        QVERIFY2(json["final"].toObject()[key].isDouble(), key);
    const StoredRun run = readResults(folder_->path("a.h5").toStdString());
    QCOMPARE(run.problem, std::string());
    QCOMPARE(run.samples.size(), std::size_t{51});
    QCOMPARE(run.recorded.size(), std::size_t{1}); // of the film
    const auto height = static_cast<std::size_t>(findQuantity(run.quantities, "minimum_spacing"));
    QCOMPARE(run.samples.columns[height].back(), json["final"].toObject()["minimum_spacing"].toDouble());

    const Outcome text = folder_->touchdown(QStringList{"run", "film_pico"} + settings);
    for (const char* part : {"completed at 0.005 ms", "final bearing force", "final net contact", "steps"})
        QVERIFY2(text.out.contains(part), text.out);
}

/// `validate` checks the file; a run with a setting needs it at six places.
void TestRunCommand::aMeasuredDiskIsReadOnce()
{
    folder_->put("case.toml", "model = \"contact\"\n[approach]\nstart = \"5 nm\"\nclosest = \"3 nm\"\n"
                              "[disk.surface]\nkind = \"file\"\nmotion = \"still\"\nfile = \"track.txt\"\n");
    folder_->put("track.txt", "# x [um]  h [nm]\n0 0\n1 1\n2 0\n3 -1\n4 0\n5 1\n6 0\n7 -1\n");
    const std::filesystem::path track = folder_->path("track.txt").toStdString();
    std::filesystem::last_write_time(track, std::filesystem::file_time_type::clock::now() - std::chrono::hours(1));
    test::OpenCount opened(track);
    QCOMPARE(folder_->touchdown({"validate", "case.toml"}).code, 0);
    QCOMPARE(opened.taken(), 1);
    QCOMPARE(folder_->touchdown({"run", "case.toml", "--set", "approach.closest=4 nm"}).code, 0);
    QCOMPARE(opened.taken(), 1);
}

void TestRunCommand::failedRun()
{
    const Outcome o = folder_->touchdown({"run", "fig12b", "--json", "--out", "a.h5"});
    QCOMPARE(o.code, 1);
    QCOMPARE(o.errorLines().size(), 1);
    QVERIFY2(o.err.startsWith("failed: ") && o.err.contains("spring is lost"), o.err);
    QVERIFY(o.json()["message"].toString().contains("spring is lost"));
    const StoredRun run = readResults(folder_->path("a.h5").toStdString());
    QCOMPARE(run.status, std::string("failed"));
    QVERIFY(run.message.find("spring is lost") != std::string::npos);
}

void TestRunCommand::badInput_data()
{
    QTest::addColumn<QByteArray>("key");
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<QList<QByteArray>>("says");
    using Words = QList<QByteArray>;
    QTest::newRow("unknown key") << QByteArray("cutoff") << QByteArray("cutof = \"3 nm\"")
                                 << Words{"springs.cutof", "unknown key", "springs.cutoff"};
    QTest::newRow("missing unit") << QByteArray("mass") << QByteArray("mass = \"1.6\"") << Words{"slider.mass", "unit"};
    QTest::newRow("wrong unit") << QByteArray("mass") << QByteArray("mass = \"1.6 nm\"") << Words{"slider.mass", "nm"};
    QTest::newRow("negative mass") << QByteArray("mass") << QByteArray("mass = \"-1.6 mg\"")
                                   << Words{"slider.mass", "-1.6 mg", "at least 1e-6 mg"};
    QTest::newRow("d_e < d_s") << QByteArray("take_off =") << QByteArray("take_off = \"2 nm\"")
                               << Words{"ono_yamane.take_off", "touch_down"};
    QTest::newRow("no TOML") << QByteArray("mass") << QByteArray("mass = = 3") << Words{};
    QTest::newRow("twice the same key") << QByteArray("mass") << QByteArray("mass = 1e-6\nmass = 1e-6") << Words{};
    QTest::newRow("not a number") << QByteArray("mass") << QByteArray("mass = nan") << Words{"slider.mass"};
    QTest::newRow("unknown name") << QByteArray("integrator") << QByteArray("integrator = \"euler\"")
                                  << Words{"run.integrator", "euler", "dopri5"};
}

// What is wrong is told with file, line and key; what stands under the names of the results stays.
void TestRunCommand::badInput()
{
    QFETCH(QByteArray, key);
    QFETCH(QByteArray, line);
    QFETCH(QList<QByteArray>, says);
    int number = 0;
    folder_->put("bad.toml", changedCase(key, line, number));
    folder_->put("old.csv", "older results");
    const Outcome o = folder_->touchdown({"run", "bad.toml", "--out", "a.h5", "--csv", "old.csv", "--json"});
    QCOMPARE(o.code, 2);
    QVERIFY2(isRefusal(o, {"--json"}), o.out);
    QCOMPARE(o.errorLines().size(), 1);
    // A second key is on the line below the first.
    const bool placed = o.err.startsWith("bad.toml:" + QByteArray::number(number) + ": ") ||
                        o.err.startsWith("bad.toml:" + QByteArray::number(number + 1) + ": ");
    QVERIFY2(placed, o.err);
    for (const QByteArray& word : says) QVERIFY2(o.err.contains(word), o.err);
    QCOMPARE(folder_->files(), QStringList({"bad.toml", "old.csv"}));
    QCOMPARE(QFileInfo(folder_->path("old.csv")).size(), 13);
}

void TestRunCommand::unreadableInput_data()
{
    QTest::addColumn<QString>("file");
    QTest::newRow("missing") << "missing.toml";
    QTest::newRow("a directory") << "folder";
    QTest::newRow("empty") << "empty.toml";
    QTest::newRow("blank") << "blank.toml";
    QTest::newRow("noise") << "noise.toml";
    QTest::newRow("100 MB of noise") << "large.toml";
    QTest::newRow("a device") << "/dev/zero";
    QTest::newRow("a file whose reading fails") << "/proc/self/mem";
    QTest::newRow("nearly a sample case") << "fig10";
}

void TestRunCommand::unreadableInput()
{
    QFETCH(QString, file);
    QVERIFY(QDir(folder_->path()).mkdir("folder"));
    folder_->put("empty.toml", "");
    folder_->put("blank.toml", " \n\t\n");
    std::mt19937 random(3);
    QByteArray noise(1 << 20, '\0');
    for (char& c : noise) c = static_cast<char>(random());
    folder_->put("noise.toml", noise.first(10000));
    if (file == "large.toml") {
        QFile large(folder_->path(file));
        QVERIFY(large.open(QIODevice::WriteOnly));
        for (int i = 0; i < 100; ++i) QCOMPARE(large.write(noise), noise.size());
    }
    const QStringList before = folder_->files();
    for (const char* command : {"run", "validate"}) {
        QStringList arguments{command, file};
        if (QByteArray(command) == "run") arguments += {"--out", "a.h5", "--csv", "a.csv"};
        const Outcome o = folder_->touchdown(arguments);
        QCOMPARE(o.code, 2);
        QCOMPARE(o.out, QByteArray());
        QCOMPARE(o.errorLines().size(), 1);
        QVERIFY2(o.err.startsWith(file.toUtf8() + ":"), o.err);
        QVERIFY2(o.err.size() < 400, o.err);
    }
    QCOMPARE(folder_->files(), before);
}

void TestRunCommand::everyProblemIsListed()
{
    int number = 0;
    folder_->put("bad.toml", changedCase("mass", "mass = \"-1 mg\"\nwings = 2", number));
    const Outcome o = folder_->touchdown(
        {"run", "bad.toml", "--set", "springs.cutof=1e-9", "nonsense=1", "--out", ".", "--csv", "none/a.csv"});
    QCOMPARE(o.code, 2);
    QCOMPARE(o.errorLines().size(), 6);
    for (const char* word : {"slider.mass", "slider.wings", "springs.cutof", "nonsense", "--out: ", "--csv: "})
        QVERIFY2(o.err.contains(word), word);
}

void TestRunCommand::badTargets_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QByteArray>("says");
    QTest::newRow("HDF5 into a directory") << QStringList{"--out", "folder"} << QByteArray("is a directory");
    QTest::newRow("CSV into a directory") << QStringList{"--csv", "folder"} << QByteArray("is a directory");
    QTest::newRow("HDF5 in no directory") << QStringList{"--out", "none/a.h5"} << QByteArray("there is no directory");
    QTest::newRow("CSV in no directory") << QStringList{"--csv", "none/a.csv"} << QByteArray("there is no directory");
    QTest::newRow("HDF5 in a file") << QStringList{"--out", "mine.toml/a.h5"} << QByteArray("there is no directory");
    QTest::newRow("HDF5 over the case") << QStringList{"--out", "mine.toml"} << QByteArray("is read by this command");
    QTest::newRow("CSV over the case, by a detour")
        << QStringList{"--csv", "folder/../mine.toml"} << QByteArray("is read by this command");
    QTest::newRow("both the same") << QStringList{"--csv", "a", "--out", "./a"} << QByteArray("both name");
    QTest::newRow("HDF5 into a device") << QStringList{"--out", "/dev/null"} << QByteArray("no regular file");
}

void TestRunCommand::badTargets()
{
    QFETCH(QStringList, arguments);
    QFETCH(QByteArray, says);
    QVERIFY(QDir(folder_->path()).mkdir("folder"));
    folder_->put("mine.toml", defaultCase());
    const Outcome o = folder_->touchdown(QStringList{"run", "mine.toml"} + arguments);
    QCOMPARE(o.code, 2);
    QCOMPARE(o.out, QByteArray());
    QCOMPARE(o.errorLines().size(), 1);
    QVERIFY2(o.err.contains(says) && o.err.startsWith("--"), o.err);
    QCOMPARE(folder_->files(), QStringList({"folder", "mine.toml"}));
    QCOMPARE(QFileInfo(folder_->path("mine.toml")).size(), defaultCase().size());
}

void TestRunCommand::fullDisk_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("output");
    QTest::newRow("CSV") << QStringList{"run", "fig10a", "--csv", "/dev/full"} << QProcess::nullDevice();
    QTest::newRow("standard output of run") << QStringList{"run", "fig10a", "--json"} << "/dev/full";
    QTest::newRow("standard output of list") << QStringList{"list"} << "/dev/full";
}

void TestRunCommand::fullDisk()
{
    QFETCH(QStringList, arguments);
    QFETCH(QString, output);
    QProcess process;
    process.setStandardOutputFile(output);
    process.start(TOUCHDOWN_COMMAND, arguments);
    const Outcome o = outcome(process);
    // What cannot even be begun is wrong input.
    QVERIFY(o.code == 1 || o.code == 2);
    QCOMPARE(o.errorLines().size(), 1);
    QVERIFY2(o.err.contains("No space left on device"), o.err);
}

void TestRunCommand::signalEndsARunInOrder_data()
{
    QTest::addColumn<int>("signal");
    QTest::newRow("SIGINT") << SIGINT;
    QTest::newRow("SIGTERM") << SIGTERM;
    QTest::newRow("SIGHUP, as of a terminal that is closed") << SIGHUP;
}

void TestRunCommand::signalEndsARunInOrder()
{
    QFETCH(int, signal);
    QProcess process;
    process.setWorkingDirectory(folder_->path());
    process.start(TOUCHDOWN_COMMAND, {"run", "fig10a", "--set", "run.duration=5 s", "--out", "a.h5", "--csv", "a.csv",
                                      "--json", "--progress"});
    process.setReadChannel(QProcess::StandardError);
    QVERIFY(process.waitForReadyRead(20000));
    QCOMPARE(::kill(static_cast<pid_t>(process.processId()), signal), 0);
    const Outcome o = outcome(process);
    QCOMPARE(o.code, 1);
    QCOMPARE(o.json()["status"].toString(), "cancelled");
    QVERIFY(o.errorLines().last().startsWith("cancelled"));
    const StoredRun run = readResults(folder_->path("a.h5").toStdString());
    QCOMPARE(run.problem, std::string());
    QCOMPARE(run.status, std::string("cancelled"));
    QVERIFY(run.samples.size() > 0);
    QFile csv(folder_->path("a.csv"));
    QVERIFY(csv.open(QIODevice::ReadOnly));
    QCOMPARE(static_cast<std::size_t>(csv.readAll().count('\n')), run.samples.size() + 1);
    QCOMPARE(folder_->files(), QStringList({"a.csv", "a.h5"}));
}

/// Report, message and object name one time.
void TestRunCommand::aFailureHasOneTime()
{
    const QStringList arguments{"run", "fig12b", "--set", "springs.potential=as-printed"};
    const Outcome o = folder_->touchdown(arguments);
    QCOMPARE(o.code, 1);
    QVERIFY2(o.out.contains("failed at 25.3 us\n"), o.out);
    QVERIFY2(o.err.contains(" at 25.3 us:"), o.err);
    QCOMPARE(folder_->touchdown(arguments + QStringList{"--json"}).json()["end_time"].toDouble(), 25.3e-6);
}

void TestRunCommand::progressIsSilentUnlessAskedFor()
{
    QCOMPARE(folder_->touchdown({"run", "fig10a"}).err, QByteArray());
    const Outcome o = folder_->touchdown({"run", "fig10a", "--progress", "--json"});
    QVERIFY2(o.err.contains("100 %, time 2 ms of 2 ms") && o.err.contains("minimum spacing"), o.err);
    QVERIFY(!o.json().isEmpty());
}

TOUCHDOWN_TEST(TestRunCommand)

} // namespace test_run_command

#include "test_run_command.moc"

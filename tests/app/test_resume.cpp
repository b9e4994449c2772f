// SPDX-License-Identifier: GPL-3.0-or-later
//
// `touchdown run FILE.h5` repeats the run of a results file, with --resume it continues it, also after kill -9.
// TOUCHDOWN_KILLS sets the number of kills of each case.
#include <csignal>
#include <map>
#include <memory>
#include <random>

#include <QtTest>

#include "core/formats/hdf5_file.h"
#include "core/formats/hdf5_group.h"
#include "core/results/results_reader.h"
#include "tests/support/command_process.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_resume {

/// What two equal runs have in common, as bytes: all numbers and texts but the case, times of the clock and states.
using Content = std::map<std::string, QByteArray>;

void addContent(const Hdf5Group& group, const std::string& path, Content& content)
{
    for (const std::string& name : group.names()) {
        const std::string whole = path + '/' + name;
        if (whole == "/case" || whole == "/checkpoint" || name.ends_with("_seconds")) continue;
        // Of the clock, in these cases.
        if (whole.starts_with("/summary/figures/") && (name.ends_with("_time") || name == "contact_saved")) continue;
        const Hdf5Group member(H5Oopen(group, name.c_str(), H5P_DEFAULT), H5Oclose);
        if (H5Iget_type(member) == H5I_GROUP) {
            addContent(member, whole, content);
            continue;
        }
        const Hdf5Dataset dataset = group.get(name);
        QByteArray& bytes = content[whole];
        if (dataset.holdsTexts()) {
            for (const std::string& text : dataset.shape().empty() ? std::vector{dataset.text()} : dataset.texts())
                bytes += QByteArray::fromStdString(text) + '\n';
        } else {
            const std::vector<double> numbers = dataset.numbers();
            bytes = {reinterpret_cast<const char*>(numbers.data()),
                     static_cast<qsizetype>(numbers.size() * sizeof(double))};
        }
    }
}

Content contentOf(const QString& file)
{
    const Hdf5Access access;
    Content content;
    const Hdf5Group root = openHdf5File(file.toStdString());
    addContent(root, "", content);
    content["status"] = QByteArray::fromStdString(root.attribute("status"));
    return content;
}

QString difference(const Content& a, const Content& b)
{
    for (const auto& [path, bytes] : a)
        if (!b.contains(path)) return QString::fromStdString(path) + " is missing";
    for (const auto& [path, bytes] : b)
        if (!a.contains(path) || a.at(path) != bytes) return QString::fromStdString(path);
    return {};
}

class TestResume : public QObject {
    Q_OBJECT

private slots:
    void init() { folder_ = std::make_unique<CommandFolder>(); }

    void killedRunsContinue_data()
    {
        QTest::addColumn<QStringList>("arguments");
        const auto add = [](const char* name, QStringList arguments) { QTest::newRow(name) << arguments; };
        const auto set = [](const char* name, std::initializer_list<const char*> values) {
            QStringList arguments{name};
            for (const char* value : values) arguments << "--set" << value;
            return arguments;
        };
        add("springs", set("fig10a", {"run.duration=40 ms"}));
        add("pad", set("contact_pull_off", {}));
        add("film", set("film_pico", {"film.nodes=[33, 33]", "run.duration=0.1 ms", "steady.stiffness=false"}));
        add("linear film over waves",
            set("advise_waviness", {"film.motion=linear", "film.linear_limit=10", "film.nodes=[33, 33]",
                                    "run.duration=8 ms", "steady.stiffness=false"}));
        add("elastic film on a rough disk",
            set("fig02_case_2_moving", {"film.nodes=[33, 33]", "run.duration=4 us", "steady.stiffness=false"}));
    }
    void killedRunsContinue()
    {
        QFETCH(QStringList, arguments);
        arguments << "--checkpoint"
                  << "0.02";
        QElapsedTimer timer;
        timer.start();
        QCOMPARE(folder_->touchdown(QStringList{"run"} + arguments + QStringList{"--out", "whole.h5"}).code, 0);
        const auto took = static_cast<int>(timer.elapsed());
        const Content whole = contentOf(folder_->path("whole.h5"));
        const int kills = std::max(1, qEnvironmentVariableIntValue("TOUCHDOWN_KILLS"));
        std::mt19937 draw(60);
        std::uniform_int_distribution<int> moment(took / 5, took);
        int continued = 0;
        constexpr int most = 20;
        for (int k = 0; k < kills || (continued == 0 && k < most); ++k) {
            kill(QStringList{"run"} + arguments + QStringList{"--out", "a.h5"}, moment(draw));
            if (k % 2 == 0 && QFile::exists(folder_->path("a.h5"))) kill({"run", "a.h5", "--resume"}, moment(draw) / 2);
            if (!QFile::exists(folder_->path("a.h5"))) continue;
            if (readResults(folder_->path("a.h5").toStdString()).status != "completed") {
                const Outcome o = folder_->touchdown({"run", "a.h5", "--resume"});
                QVERIFY2(o.code == 0, o.err);
                continued += !o.err.contains("starts again");
            }
            QCOMPARE(difference(whole, contentOf(folder_->path("a.h5"))), QString());
        }
        QVERIFY(continued > 0);
    }

    void aSignalLeavesWhatContinues()
    {
        QProcess process;
        process.setWorkingDirectory(folder_->path());
        process.start(TOUCHDOWN_COMMAND,
                      {"run", "contact_pull_off", "--out", "a.h5", "--csv", "a.csv", "--checkpoint", "0"});
        QTRY_VERIFY(!readResults(folder_->path("a.h5").toStdString()).checkpoints.empty());
        QCOMPARE(::kill(static_cast<pid_t>(process.processId()), SIGTERM), 0);
        QCOMPARE(outcome(process).code, 1);
        const Outcome o = folder_->touchdown({"run", "a.h5", "--resume", "--csv", "a.csv"});
        QVERIFY2(o.code == 0 && o.err.isEmpty(), o.err);
        QCOMPARE(folder_->touchdown({"run", "contact_pull_off", "--out", "b.h5", "--csv", "b.csv"}).code, 0);
        QCOMPARE(difference(contentOf(folder_->path("b.h5")), contentOf(folder_->path("a.h5"))), QString());
        QCOMPARE(bytesOf("a.csv"), bytesOf("b.csv"));
    }

    void aRunIsRepeated()
    {
        QCOMPARE(folder_->touchdown({"run", "fig10a", "--set", "run.duration=1 ms", "--out", "a.h5"}).code, 0);
        const Outcome o = folder_->touchdown({"run", "a.h5", "--out", "b.h5"});
        QVERIFY2(o.code == 0 && o.err.isEmpty(), o.err);
        QCOMPARE(difference(contentOf(folder_->path("a.h5")), contentOf(folder_->path("b.h5"))), QString());
        const Outcome onItself = folder_->touchdown({"run", "a.h5", "--out", "a.h5"});
        QCOMPARE(onItself.code, 2);
        const Outcome other = folder_->touchdown({"run", "a.h5", "--set", "run.duration=0.5 ms", "--json"});
        QCOMPARE(other.json()["end_time"].toDouble(), 0.5e-3);
    }

    void aRunBecomesLonger()
    {
        QCOMPARE(folder_->touchdown({"run", "fig10a", "--set", "run.duration=1 ms", "--out", "a.h5"}).code, 0);
        const Outcome o = folder_->touchdown({"run", "a.h5", "--resume", "--set", "run.duration=2 ms"});
        QVERIFY2(o.code == 0 && o.err.isEmpty(), o.err);
        QCOMPARE(folder_->touchdown({"run", "fig10a", "--out", "b.h5"}).code, 0);
        QCOMPARE(difference(contentOf(folder_->path("b.h5")), contentOf(folder_->path("a.h5"))), QString());
    }

    /// Also from a run that was continued before.
    void aRunBecomesLongerAgain()
    {
        QCOMPARE(folder_->touchdown({"run", "fig10a", "--set", "run.duration=1 ms", "--out", "a.hdf5"}).code, 0);
        for (const char* duration : {"run.duration=1.5 ms", "run.duration=2 ms"}) {
            const Outcome o = folder_->touchdown({"run", "a.hdf5", "--resume", "--set", duration});
            QVERIFY2(o.code == 0 && o.err.isEmpty(), o.err);
        }
        QCOMPARE(folder_->touchdown({"run", "fig10a", "--out", "b.h5"}).code, 0);
        QCOMPARE(difference(contentOf(folder_->path("b.h5")), contentOf(folder_->path("a.hdf5"))), QString());
    }

    /// Until the new run has come as far as the old one the file stays as it was.
    void aLongerRunThatIsKilledLosesNothing()
    {
        QCOMPARE(folder_->touchdown({"run", "fig10a", "--set", "run.duration=20 ms", "--out", "a.h5"}).code, 0);
        const QByteArray before = bytesOf("a.h5");
        for (const int after : {20, 60, 120}) {
            kill({"run", "a.h5", "--resume", "--set", "run.duration=5 s"}, after);
            const StoredRun run = readResults(folder_->path("a.h5").toStdString());
            QCOMPARE(run.problem, std::string());
            QVERIFY(bytesOf("a.h5") == before || run.samples.time.back() >= 20e-3);
        }
        // Stopped in order before it has come anywhere.
        QVERIFY(bytesOf("a.h5") == before || readResults(folder_->path("a.h5").toStdString()).status == "interrupted");
    }

    void whatHasNoStateStartsAgain()
    {
        QCOMPARE(folder_->touchdown({"run", "contact_pull_off", "--out", "a.h5"}).code, 0);
        const QByteArray before = bytesOf("a.h5");
        const QStringList longer{"--set", "run.duration=4 ms"};
        kill(QStringList{"run", "a.h5", "--resume"} + longer, 300);
        QCOMPARE(bytesOf("a.h5"), before);
        const Outcome o = folder_->touchdown(QStringList{"run", "a.h5", "--resume"} + longer);
        QCOMPARE(o.code, 0);
        QVERIFY2(o.err.contains("starts again, as the way of a pad fills its duration"), o.err);
        QCOMPARE(folder_->touchdown(QStringList{"run", "contact_pull_off", "--out", "b.h5"} + longer).code, 0);
        QCOMPARE(difference(contentOf(folder_->path("b.h5")), contentOf(folder_->path("a.h5"))), QString());
    }

    void refusals_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("words");
        const auto add = [](const char* name, QStringList arguments, const char* words) {
            QTest::newRow(name) << arguments << QString(words);
        };
        add("a state each", {"fig10a", "--checkpoint", "1"}, "--checkpoint: needs --out FILE.h5");
        add("a state before", {"fig10a", "--checkpoint", "-1", "--out", "b.h5"}, "--checkpoint: must be from 0 to 1e6");
        add("completed", {"a.h5", "--resume"}, "the run has completed");
        add("shorter", {"a.h5", "--resume", "--set", "run.duration=0.4 ms"}, "run.duration is shorter");
        add("another key", {"a.h5", "--resume", "--set", "run.duration=2 ms", "--set", "slider.mass=2 mg"},
            "slider.mass is not that of the run");
        add("a case", {"fig10a", "--resume"}, "is no results file");
        add("another word", {"a.h5", "--resume=maybe"}, "maybe");
        add("no file", {"b.h5", "--resume"}, "b.h5");
        add("failed", {"failed.h5", "--resume"}, "the run has ended by itself");
        add("the series over the file",
            {"a.h5", "--resume", "--out", "b.h5", "--csv", "a.h5", "--set", "run.duration=2 ms"}, "a.h5");
    }
    void refusals()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, words);
        QCOMPARE(folder_->touchdown({"run", "fig10a", "--set", "run.duration=1 ms", "--out", "a.h5"}).code, 0);
        QCOMPARE(
            folder_->touchdown({"run", "fig12b", "--set", "springs.potential=as-printed", "--out", "failed.h5"}).code,
            1);
        const QByteArray before = bytesOf("a.h5");
        const Outcome o = folder_->touchdown(QStringList{"run"} + arguments);
        QCOMPARE(o.code, 2);
        QVERIFY2(o.err.contains(words.toUtf8()), o.err);
        QCOMPARE(bytesOf("a.h5"), before);
    }

    void anotherMachineIsRefusedByName()
    {
        QCOMPARE(folder_->touchdown({"run", "fig10a", "--set", "run.duration=1 ms", "--out", "a.h5"}).code, 0);
        changeState("machine", "a machine of others");
        const QStringList arguments{"run", "a.h5", "--set", "run.duration=2 ms"};
        const Outcome refused = folder_->touchdown(arguments + QStringList{"--resume"});
        QCOMPARE(refused.code, 2);
        QVERIFY2(refused.err.contains("a machine of others") && refused.err.contains("--resume=anyway"), refused.err);
        const Outcome allowed = folder_->touchdown(arguments + QStringList{"--resume=anyway"});
        QCOMPARE(allowed.code, 0);
        QVERIFY2(allowed.out.contains("a machine of others"), allowed.out);
        // The mark stays.
        const Outcome longer = folder_->touchdown({"run", "a.h5", "--set", "run.duration=3 ms", "--resume"});
        QVERIFY2(longer.code == 0 && longer.out.contains("a machine of others"), longer.err);
        const Hdf5Access access;
        const std::string mark = openHdf5File(folder_->path("a.h5").toStdString()).attribute("continued");
        QVERIFY2(mark.find("a machine of others") != std::string::npos, mark.c_str());
    }

    void aStateOfAnotherLayoutIsNeverRead()
    {
        QCOMPARE(folder_->touchdown({"run", "fig10a", "--set", "run.duration=1 ms", "--out", "a.h5"}).code, 0);
        changeState("layout", std::int64_t{1});
        const QByteArray before = bytesOf("a.h5");
        for (const char* resume : {"--resume", "--resume=anyway"}) {
            const Outcome o = folder_->touchdown({"run", "a.h5", resume, "--set", "run.duration=2 ms"});
            QCOMPARE(o.code, 2);
            QVERIFY2(o.err.contains("cannot read its state"), o.err);
            QCOMPARE(bytesOf("a.h5"), before);
        }
    }

    void aDamagedStateIsRefused()
    {
        QCOMPARE(folder_->touchdown({"run", "fig10a", "--set", "run.duration=1 ms", "--out", "a.h5"}).code, 0);
        changeState("bytes", std::int64_t{64});
        const QByteArray before = bytesOf("a.h5");
        const Outcome o = folder_->touchdown({"run", "a.h5", "--resume", "--set", "run.duration=2 ms"});
        QCOMPARE(o.code, 1);
        QCOMPARE(bytesOf("a.h5"), before);
        QVERIFY2(o.err.contains("cannot be continued from its checkpoint"), o.err);
    }

private:
    /// An attribute of the state in a.h5.
    template <class Value>
    void changeState(const char* attribute, Value value)
    {
        const Hdf5Access access;
        const Hdf5Group root = openHdf5File(folder_->path("a.h5").toStdString(), H5F_ACC_RDWR);
        root.get("checkpoint/extends").set(attribute, value);
    }

    /// Starts the program and ends it with kill -9 after so many ms.
    void kill(const QStringList& arguments, int after)
    {
        QProcess process;
        process.setWorkingDirectory(folder_->path());
        process.start(TOUCHDOWN_COMMAND, arguments);
        if (!process.waitForFinished(after)) process.kill();
        process.waitForFinished(20000);
    }

    QByteArray bytesOf(const QString& name) const
    {
        QFile file(folder_->path(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    std::unique_ptr<CommandFolder> folder_;
};

} // namespace test_resume

using test_resume::TestResume;
TOUCHDOWN_TEST(TestResume)
#include "test_resume.moc"

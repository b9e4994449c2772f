// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>

#include "core/case/parameters.h"
#include "core/formats/dxf_drawing.h"
#include "tests/support/cml_sample.h"
#include "tests/support/command_process.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_convert_command {

class TestConvertCommand : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        folder_ = std::make_unique<CommandFolder>();
        QVERIFY(QDir(folder_->path()).mkdir("slider"));
        folder_->put("slider/rail.dat", QByteArray::fromStdString(cmlRailText()));
        folder_->put("slider/run.dat", QByteArray::fromStdString(cmlRunText()));
    }

    void thereAndBackAgain()
    {
        for (const QStringList& step : {QStringList{"slider", "a.toml"}, QStringList{"a.toml", "b.cml"},
                                        QStringList{"b.cml", "c"}, QStringList{"c", "d.toml"}}) {
            const Outcome o = folder_->touchdown(QStringList{"convert"} + step);
            QCOMPARE(o.code, 0);
            QCOMPARE(o.out, QByteArray());
            if (step.front() != QStringLiteral("a.toml")) QVERIFY(o.err.contains("no file gives the slider's mass"));
            QVERIFY(o.err.count('\n') <= 1);
        }
        QCOMPARE(folder_->files(), (QStringList{"a.toml", "b.cml", "c", "d.toml", "slider"}));
        const CaseDocument first = openCase(folder_->path("slider").toStdString());
        const CaseDocument last = readCaseFile(folder_->path("d.toml").toStdString());
        QVERIFY(last.valid());
        for (const Parameter& parameter : parameters())
            QVERIFY2(parameter.get(first.value) == parameter.get(last.value), parameter.key.c_str());
        QVERIFY(first.value.surface == last.value.surface);
        QCOMPARE(folder_->touchdown({"validate", "b.cml"}).out, QByteArray("b.cml: valid\n"));
    }
    void drawsTheSurface()
    {
        QCOMPARE(folder_->touchdown({"convert", "slider", "a.dxf"}).code, 0);
        const Drawing drawing = readDxf(folder_->path("a.dxf").toStdString());
        QCOMPARE(drawing.problem, std::string());
        QCOMPARE(drawing.paths.size(), cmlSurface().rails.size() + 1); // and the border
        const Outcome springs = folder_->touchdown({"convert", "fig10a", "b.dxf"});
        QCOMPARE(springs.code, 2);
        QVERIFY(springs.err.contains("no slider with rails"));
        QVERIFY(!QFileInfo::exists(folder_->path("b.dxf")));
    }
    void commentsOfACaseFileStay()
    {
        folder_->put("mine.toml", "# my notes\ntitle = \"x\"\nmodel = \"film\"\n");
        QCOMPARE(folder_->touchdown({"convert", "mine.toml", "copy.toml"}).code, 0);
        QFile copy(folder_->path("copy.toml"));
        QVERIFY(copy.open(QIODevice::ReadOnly));
        QCOMPARE(copy.readAll(), QByteArray("# my notes\ntitle = \"x\"\nmodel = \"film\"\n"));
    }
    void replacesTheFileThatItNames()
    {
        QVERIFY(QDir(folder_->path()).mkdir("out"));
        folder_->put("out/RAIL.DAT", QByteArray::fromStdString(cmlRailText()));
        QCOMPARE(folder_->touchdown({"convert", "film_plane", "out"}).code, 2);
        QCOMPARE(folder_->touchdown({"convert", "film_plane", "out", "--force"}).code, 0);
        QCOMPARE(QDir(folder_->path("out")).entryList(QDir::Files, QDir::Name), (QStringList{"RAIL.DAT", "run.dat"}));
        QVERIFY(openCase(folder_->path("out").toStdString()).valid());
    }
    /// The surface of the disk stands beside the case that is read, wherever the new one stands.
    void surfacesAreNamedFromTheNewPlace()
    {
        QVERIFY(QDir(folder_->path()).mkpath("a/deeper") && QDir(folder_->path()).mkdir("b"));
        folder_->put("a/deeper/track.txt", "# x [um]  h [nm]\n0 0\n1 1\n2 0\n3 -1\n");
        folder_->put("a/deeper/c.toml", "model = \"film\"\n[disk.surface]\nkind = \"file\"\nfile = \"track.txt\"\n");
        const auto surfaceOf = [&](const char* file) {
            const CaseDocument document = openCase(folder_->path(file).toStdString(), OutsidePaths::Allowed);
            return document.valid() ? QString::fromStdString(document.value.diskSurface.file) : QString("not valid");
        };
        QCOMPARE(folder_->touchdown({"convert", "a/deeper/c.toml", "a/up.toml"}).code, 0);
        QCOMPARE(surfaceOf("a/up.toml"), QStringLiteral("deeper/track.txt"));
        const Outcome outside = folder_->touchdown({"convert", "a/deeper/c.toml", "b/c.toml"});
        QCOMPARE(outside.code, 0);
        QVERIFY2(outside.err.startsWith("warning: b/c.toml: disk.surface.file: names "), outside.err);
        QCOMPARE(surfaceOf("b/c.toml"), QFileInfo(folder_->path("a/deeper/track.txt")).canonicalFilePath());
        QCOMPARE(folder_->touchdown({"convert", "a/deeper/c.toml", "a/cml"}).code, 0);
        QCOMPARE(surfaceOf("a/cml"), QFileInfo(folder_->path("a/deeper/track.txt")).canonicalFilePath());
        QCOMPARE(folder_->touchdown({"validate", "a/cml"}).code, 2);
        QCOMPARE(folder_->touchdown({"validate", "a/cml", "--allow-paths"}).code, 0);
    }
    void warningsGoToStandardError()
    {
        folder_->put("slider/run.dat",
                     QByteArray::fromStdString(cmlRunText()).replace("  0              40.0", "  1              40.0"));
        const Outcome read = folder_->touchdown({"convert", "slider", "a.toml"});
        QCOMPARE(read.code, 0);
        QVERIFY(read.err.startsWith("warning: slider/run.dat:77: Additional Parameters: not modelled: humidity\n"));
        folder_->put(
            "b.toml",
            "model = \"film\"\n[film]\nscheme = \"exponential\"\ngrid = \"uniform\"\n[steady]\nshear_arm = 1\n");
        const Outcome written = folder_->touchdown({"convert", "b.toml", "b"});
        QCOMPARE(written.code, 0);
        QCOMPARE(written.err,
                 QByteArray("warning: b: kept in the comments of run.dat, where the established program does not "
                            "see them: slider.mass, slider.pitch_inertia, slider.roll_inertia, film.scheme\n"));
    }
    void wrong_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("says");
        QTest::newRow("no target") << QStringList{"slider"} << QByteArray("TO");
        QTest::newRow("nothing") << QStringList{} << QByteArray("FROM");
        QTest::newRow("no such case") << QStringList{"nothing", "a.toml"}
                                      << QByteArray("nothing: is neither a file nor a sample case");
        QTest::newRow("springs") << QStringList{"fig10a", "out"} << QByteArray("fig10a: model is springs");
        QTest::newRow("a file in the way")
            << QStringList{"slider", "slider/run.dat/x"} << QByteArray("slider/run.dat/x: cannot be made");
        QTest::newRow("no folder") << QStringList{"slider", "none/a.toml"}
                                   << QByteArray("none/a.toml: cannot be written");
    }
    void wrong()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QByteArray, says);
        const Outcome o = folder_->touchdown(QStringList{"convert"} + arguments);
        QCOMPARE(o.code, 2);
        QVERIFY2(o.err.contains(says), o.err);
        QCOMPARE(o.out, QByteArray());
        QCOMPARE(folder_->files(), QStringList{"slider"});
    }
    void warningsOfValidate()
    {
        folder_->put("slider/run.dat",
                     QByteArray::fromStdString(cmlRunText()).replace("  0              40.0", "  1              40.0"));
        const Outcome o = folder_->touchdown({"validate", "slider", "--json"});
        QCOMPARE(o.code, 0);
        QVERIFY(o.json()["valid"].toBool());
        const QJsonObject warning = o.json()["warnings"].toArray().at(0).toObject();
        QCOMPARE(warning["file"].toString(), "slider/run.dat");
        QCOMPARE(warning["line"].toInt(), 77);
        QCOMPARE(warning["message"].toString(), "Additional Parameters: not modelled: humidity");
    }
    void problemsNameTheirLines()
    {
        folder_->put("slider/rail.dat", QByteArray::fromStdString(withLine(cmlRailText(), 3, "long")));
        const Outcome o = folder_->touchdown({"convert", "slider", "a.toml"});
        QCOMPARE(o.code, 2);
        QCOMPARE(o.err, QByteArray("slider/rail.dat:3: the slider's length must be a number, not \"long\"\n"));
    }

private:
    std::unique_ptr<CommandFolder> folder_;
};

TOUCHDOWN_TEST(TestConvertCommand)

} // namespace test_convert_command

#include "test_convert_command.moc"

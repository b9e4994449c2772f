// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cases and surfaces of another person at the command line: exit code 2 and one sentence, never a crash.
#include <QtTest>

#include "core/formats/hdf5_file.h"
#include "tests/support/command_process.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_hostile_input {

const QByteArray surfaceCase = "model = \"contact\"\n[approach]\nstart = \"5 nm\"\nclosest = \"3 nm\"\n"
                               "[disk.surface]\nkind = \"file\"\nmotion = \"still\"\nfile = ";
const QByteArray profile = "# x [um]  h [nm]\n0 0\n1 1\n2 0\n3 -1\n";

class TestHostileInput : public QObject {
    Q_OBJECT

    std::unique_ptr<CommandFolder> folder_;

private slots:
    void init()
    {
        folder_ = std::make_unique<CommandFolder>();
        QVERIFY(QDir(folder_->path()).mkdir("mine"));
        folder_->put("track.txt", profile);
        folder_->put("mine/a.toml", surfaceCase + "\"../track.txt\"\n");
    }

    void aPathOutOfTheFolder()
    {
        for (const char* command : {"validate", "run"}) {
            const Outcome o = folder_->touchdown({command, "mine/a.toml"});
            QCOMPARE(o.code, 2);
            QVERIFY2(o.err.startsWith("mine/a.toml:8: disk.surface.file: names \"../track.txt\""), o.err.constData());
            QCOMPARE(o.err.count('\n'), 1);
            QCOMPARE(folder_->touchdown({command, "mine/a.toml", "--allow-paths"}).code, 0);
        }
        // A path that the person types is asked for.
        QCOMPARE(folder_->touchdown({"validate", "mine/a.toml", "--set", "disk.surface.file=../track.txt"}).code, 0);
        folder_->put("mine/study.toml", "case = \"" + folder_->path("track.txt").toUtf8() + "\"\n");
        const Outcome study = folder_->touchdown({"study", "stability", "mine/study.toml"});
        QCOMPARE(study.code, 2);
        QVERIFY2(study.err.startsWith("mine/study.toml:1: case: names "), study.err.constData());
    }

    void convertNamesWhatStaysOutside()
    {
        QCOMPARE(folder_->touchdown({"convert", "mine/a.toml", "mine/b.toml"}).code, 2);
        const Outcome o = folder_->touchdown({"convert", "mine/a.toml", "mine/b.toml", "--allow-paths"});
        QCOMPARE(o.code, 0);
        QVERIFY2(o.err.startsWith("warning: mine/b.toml: disk.surface.file: names "), o.err.constData());
        QCOMPARE(folder_->touchdown({"validate", "mine/b.toml", "--allow-paths"}).code, 0);
    }

    // The length of a text of an attribute: the HDF5 library reads outside its memory.
    void aDamagedMap()
    {
        const QString file = folder_->path("mine/map.h5");
        {
            const Hdf5Access access;
            const Hdf5Group map = createHdf5File(file.toStdString());
            map.put("x", std::vector<double>{0, 1, 2, 3}).set("unit", "um");
            map.put("height", std::vector<double>{0, 1, 0, -1}).set("unit", "nm");
        }
        folder_->put("mine/a.toml", surfaceCase + "\"map.h5\"\n");
        const Outcome good = folder_->touchdown({"validate", "mine/a.toml"});
        QVERIFY2(good.code == 0, good.err.constData());
        QFile read(file);
        QVERIFY(read.open(QIODevice::ReadOnly));
        QByteArray bytes = read.readAll();
        // An attribute holds the length of its text, then the place of its heap; the length is now 2 GB.
        const QByteArray place = [heap = bytes.indexOf("GCOL")] {
            QByteArray eight;
            for (int k = 0; k < 8; ++k) eight.append(static_cast<char>(heap >> (8 * k)));
            return eight;
        }();
        const qsizetype attribute = bytes.lastIndexOf(place);
        QVERIFY(attribute > 0);
        bytes[attribute - 1] = 127;
        folder_->put("mine/map.h5", bytes);
        const Outcome o = folder_->touchdown({"run", "mine/a.toml", "--json"});
        QCOMPARE(o.code, 2);
        QVERIFY(isRefusal(o, {"--json"}));
        QVERIFY2(o.err.startsWith("mine/a.toml:8: disk.surface.file: \"map.h5\" "), o.err.constData());
        QCOMPARE(o.err.count('\n'), 1);
    }
};

TOUCHDOWN_TEST(TestHostileInput)

} // namespace test_hostile_input

#include "test_hostile_input.moc"

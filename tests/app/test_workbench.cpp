// SPDX-License-Identifier: GPL-3.0-or-later
//
// The program `touchdown-workbench` as scripts meet it: without a screen.
#include <sys/stat.h>

#include <QSize>
#include <QtEndian>
#include <QtTest>

#include "tests/support/test_program.h"

namespace test_workbench {

struct Outcome {
    int code = -1;
    QByteArray out;
    QByteArray err;
};

/// `platform` is Qt's; none at all when empty, as on a machine without a display. `settings`: their folder, if not the
/// usual one.
Outcome workbench(const QStringList& arguments, const QString& platform, const QString& settings = {})
{
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.remove(QStringLiteral("DISPLAY"));
    environment.remove(QStringLiteral("WAYLAND_DISPLAY"));
    environment.insert(QStringLiteral("QT_QPA_PLATFORM"), platform);
    if (!settings.isEmpty()) environment.insert(QStringLiteral("XDG_CONFIG_HOME"), settings);
    QProcess process;
    process.setProcessEnvironment(environment);
    process.start(QStringLiteral(TOUCHDOWN_WORKBENCH), arguments);
    if (!process.waitForFinished(60'000) || process.exitStatus() != QProcess::NormalExit) return {};
    return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
}

/// From the header of a PNG file (ISO/IEC 15948: signature, then IHDR with width and height); invalid for anything
/// else.
QSize pngSize(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) return {};
    const QByteArray head = file.read(24);
    if (head.size() < 24 || !head.startsWith("\x89PNG\r\n\x1a\n") || head.mid(12, 4) != "IHDR") return {};
    return {qFromBigEndian<qint32>(head.constData() + 16), qFromBigEndian<qint32>(head.constData() + 20)};
}

class TestWorkbench : public QObject {
    Q_OBJECT

private slots:
    void answersWithoutADisplay_data();
    void answersWithoutADisplay();
    void refusesBadInput_data();
    void refusesBadInput();
    void exportsPlots();
    void exportsWhatThereIsOfAFailedRun();
    void exportsTheStaticStateOfAFilm();
    void takesAPictureOfTheWindow();
    void startsWhereTheSettingsAreNoFile();
    void saysWhatCannotBeWritten();
    void readsOutsideFilesWhenAllowed();

private:
    QTemporaryDir folder_;
};

void TestWorkbench::answersWithoutADisplay_data()
{
    QTest::addColumn<QString>("argument");
    QTest::addColumn<QByteArray>("part");
    QTest::newRow("help") << "--help" << QByteArray("--export");
    QTest::newRow("version") << "--version" << QByteArray("touchdown-workbench " TOUCHDOWN_VERSION);
}

void TestWorkbench::answersWithoutADisplay()
{
    QFETCH(const QString, argument);
    QFETCH(const QByteArray, part);
    const Outcome o = workbench({argument}, QStringLiteral("xcb"));
    QCOMPARE(o.code, 0);
    QVERIFY2(o.out.contains(part), o.out.constData());
    QCOMPARE(o.err, QByteArray());
}

void TestWorkbench::refusesBadInput_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QByteArray>("part");
    QTest::newRow("no such case") << QStringList{"nonsuch", "--export", "pictures"} << QByteArray("nonsuch");
    QTest::newRow("unknown key") << QStringList{folder_.filePath("bad.toml"), "--export", "pictures"}
                                 << QByteArray("slider.mas");
    QTest::newRow("pictures of a saved run")
        << QStringList{"run.h5", "--export", "pictures"} << QByteArray("saved run");
    QTest::newRow("two cases") << QStringList{"fig10a", "fig10b"} << QByteArray("more than one case");
    QTest::newRow("unknown option") << QStringList{"--fast"} << QByteArray("fast");
    QTest::newRow("study without pictures")
        << QStringList{"--study", "work-precision", "fig10a"} << QByteArray("--pictures");
    QTest::newRow("unknown study") << QStringList{"--study", "speed", "--pictures", folder_.filePath("s"), "fig10a"}
                                   << QByteArray("speed");
    QTest::newRow("a folder without a name")
        << QStringList{"fig10a", "--export", ""} << QByteArray("the value of --export is empty");
    QTest::newRow("unknown theme") << QStringList{"--theme", "pink"} << QByteArray("pink");
}

void TestWorkbench::refusesBadInput()
{
    QFETCH(const QStringList, arguments);
    QFETCH(const QByteArray, part);
    QFile bad(folder_.filePath("bad.toml"));
    QVERIFY(bad.open(QIODevice::WriteOnly));
    bad.write("[slider]\nmas = \"1 mg\"\n");
    bad.close();
    // Before anything that needs a display.
    const Outcome o = workbench(arguments, QStringLiteral("xcb"));
    QCOMPARE(o.code, 2);
    QCOMPARE(o.out, QByteArray());
    QVERIFY2(o.err.contains(part), o.err.constData());
}

void TestWorkbench::exportsPlots()
{
    const QString target = folder_.filePath("fig10a");
    const Outcome o = workbench({"fig10a", "--export", target}, QStringLiteral("offscreen"));
    QCOMPARE(o.code, 0);
    const QList<QByteArray> paths = o.out.trimmed().split('\n');
    QCOMPARE(paths.size(), 7); // the page, four plots over time (no roll), the side view, the spectrum
    for (const QByteArray& path : paths) {
        const QSize size = pngSize(QString::fromLocal8Bit(path));
        QVERIFY2(size.width() > 400 && size.height() > 150, path.constData());
    }
}

void TestWorkbench::exportsWhatThereIsOfAFailedRun()
{
    const QString target = folder_.filePath("fig12b");
    const Outcome o = workbench({"fig12b", "--export", target}, QStringLiteral("offscreen"));
    QCOMPARE(o.code, 1);
    QVERIFY2(o.err.contains("rear air spring is lost"), o.err.constData());
    QVERIFY(QFile::exists(target + "/spacing.png"));
}

void TestWorkbench::exportsTheStaticStateOfAFilm()
{
    const QString target = folder_.filePath("film_plane");
    const Outcome o = workbench({"film_plane", "--static", "--export", target}, QStringLiteral("offscreen"));
    QCOMPARE(o.code, 0);
    for (const char* page : {"surface", "pressure", "gap", "recess"})
        QVERIFY2(pngSize(target + QLatin1Char('/') + QLatin1String(page) + QStringLiteral(".png")).isValid(), page);
}

void TestWorkbench::takesAPictureOfTheWindow()
{
    const QString file = folder_.filePath("window.png");
    const Outcome o = workbench({"fig10a", "--screenshot", file, "--size", "1300x820"}, QStringLiteral("offscreen"));
    QCOMPARE(o.code, 0);
    QCOMPARE(o.out.trimmed(), file.toLocal8Bit());
    QCOMPARE(pngSize(file), QSize(1300, 820));
}

void TestWorkbench::startsWhereTheSettingsAreNoFile()
{
    const QString settings = folder_.filePath("settings"), file = settings + "/touchdown/touchdown-workbench.conf";
    QVERIFY(QDir().mkpath(settings + "/touchdown"));
    QCOMPARE(::mkfifo(qPrintable(file), 0600), 0);
    const Outcome o = workbench({"fig10a", "--screenshot", folder_.filePath("w.png")}, "offscreen", settings);
    QCOMPARE(o.code, 0);
    QVERIFY2(o.err.contains(file.toUtf8()), o.err.constData());
}

void TestWorkbench::saysWhatCannotBeWritten()
{
    const QString file = folder_.filePath("missing/window.png");
    const Outcome o = workbench({"fig10a", "--screenshot", file}, QStringLiteral("offscreen"));
    QCOMPARE(o.code, 2);
    QCOMPARE(o.out, QByteArray());
    QVERIFY2(o.err.contains(file.toLocal8Bit()), o.err.constData());
}

void TestWorkbench::readsOutsideFilesWhenAllowed()
{
    QVERIFY(QDir(folder_.path()).mkdir("case"));
    for (const auto& [name, text] :
         {std::pair("track.txt", "# x [um]  h [nm]\n0 0\n1 1\n2 0\n3 -1\n"),
          std::pair("case/outside.toml", "model = \"contact\"\n[disk.surface]\nkind = \"file\"\n"
                                         "motion = \"still\"\nfile = \"../track.txt\"\n")}) {
        QFile file(folder_.filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(text);
    }
    // The wrong size ends it when the case has been read.
    QStringList arguments{folder_.filePath("case/outside.toml"), "--export", folder_.filePath("o"), "--size", "small"};
    Outcome o = workbench(arguments, QStringLiteral("offscreen"));
    QCOMPARE(o.code, 2);
    QVERIFY2(o.err.contains("--allow-paths"), o.err.constData());
    o = workbench(arguments << "--allow-paths", QStringLiteral("offscreen"));
    QVERIFY2(o.err.contains("--size is written as"), o.err.constData());
}

TOUCHDOWN_TEST(TestWorkbench)

} // namespace test_workbench

#include "test_workbench.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Import and export of the established program's cases; the rest of CaseFiles is tested with the window.
#include "core/case_files/case_text.h"
#include "ui/case/case_files.h"

#include <memory>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

#include "core/case_files/case_file.h"
#include "core/case_files/case_reader.h"
#include "core/case_files/cml_case.h"
#include "core/formats/dxf_drawing.h"
#include "core/formats/dxf_surface.h"
#include "tests/support/test_program.h"
#include "tests/ui/sample_slider.h"

using namespace touchdown;

namespace test_case_files {

class TestCaseFiles : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void importsWhatItExported_data();
    void importsWhatItExported();
    void drawsTheSurface();
    void savingNeverWritesOverAnImport();
    void tellsWhatIsNotModelled();
    void namesAnImport_data();
    void namesAnImport();
    void saysWhyAnExportFails();
    void knowsWhatCanBeDropped_data();
    void knowsWhatCanBeDropped();
    void asksBeforeItReadsElsewhere();
    void givesATextThatNeedsNoRailFile();

private:
    QString path(const QString& name) const { return folder_->filePath(name); }
    QMessageBox* problems() const { return window_->findChild<QMessageBox*>(QStringLiteral("problems")); }

    std::unique_ptr<QTemporaryDir> folder_;
    std::unique_ptr<QWidget> window_;
    std::unique_ptr<CaseEdits> edits_;
    CaseFiles* files_ = nullptr;
};

void TestCaseFiles::initTestCase()
{
    QCoreApplication::setOrganizationName(QStringLiteral("touchdown"));
    QCoreApplication::setApplicationName(QStringLiteral("test_case_files"));
}

void TestCaseFiles::init()
{
    QSettings().clear();
    folder_ = std::make_unique<QTemporaryDir>();
    window_ = std::make_unique<QWidget>();
    edits_ = std::make_unique<CaseEdits>();
    files_ = new CaseFiles(*edits_, *window_);
    edits_->open(sampleFilmCase());
}

void TestCaseFiles::importsWhatItExported_data()
{
    QTest::addColumn<QString>("name");
    QTest::newRow("folder") << "slider";
    QTest::newRow("archive") << "slider.cml";
}

void TestCaseFiles::importsWhatItExported()
{
    QFETCH(const QString, name);
    QSignalSpy exported(files_, &CaseFiles::exported);
    files_->exportTo(path(name));
    QCOMPARE(exported.count(), 1);
    QVERIFY(QFileInfo::exists(path(name)));

    QSignalSpy imported(files_, &CaseFiles::imported);
    QVERIFY(files_->openNow(path(name)));
    QCOMPARE(imported.count(), 1);
    const Case& read = edits_->value();
    QCOMPARE(read.model, ModelKind::Film);
    QCOMPARE(read.surface, sampleSurface());
    QCOMPARE(read.slider.length, 0.85e-3);
    QVERIFY(!files_->modified());
    QVERIFY(files_->file().isEmpty());
    QCOMPARE(files_->shortName(), QStringLiteral("slider"));
}

void TestCaseFiles::drawsTheSurface()
{
    QSignalSpy exported(files_, &CaseFiles::exported);
    QCOMPARE(files_->exportDrawing(path(QStringLiteral("a.dxf"))), QString());
    QCOMPARE(exported.count(), 1);
    QCOMPARE(exported[0][1].toString().isEmpty(), lostInDrawing(sampleSurface()).empty());
    QCOMPARE(lostInDrawing(AirBearingSurface{}), std::string());
    AirBearingSurface formed;
    formed.crown = 5e-9;
    formed.symmetries = {{0, 0}};
    QCOMPARE(lostInDrawing(formed),
             std::string("a drawing has no crown, camber and twist and no kept distances and symmetries"));
    const Drawing drawing = readDxf(path(QStringLiteral("a.dxf")).toStdString());
    QCOMPARE(drawing.paths.size(), sampleSurface().rails.size() + 1); // and the border
    QVERIFY(!files_->exportDrawing(path(QStringLiteral("no/such/folder/a.dxf"))).isEmpty());
    QCOMPARE(exported.count(), 1);
}

void TestCaseFiles::savingNeverWritesOverAnImport()
{
    files_->exportTo(path(QStringLiteral("slider")));
    const QString rail = path(QStringLiteral("slider/rail.dat"));
    QFile file(rail);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray before = file.readAll();
    file.close();
    QVERIFY(files_->openNow(rail));
    files_->save(); // asks for a name
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll(), before);
    QVERIFY(files_->file().isEmpty());
    QVERIFY(files_->recent().contains(rail));
    QCOMPARE(files_->origin(), rail);
}

void TestCaseFiles::tellsWhatIsNotModelled()
{
    CaseDocument document;
    document.value = sampleFilmCase();
    document.text = formatCase(document.value);
    document.warnings = {{"run.dat", 12, "", "the established program's sensitivity increments are not used"}};
    files_->exportTo(path(QStringLiteral("slider.cml")));
    QSignalSpy imported(files_, &CaseFiles::imported);
    files_->take(document, path(QStringLiteral("slider.cml")));
    QCOMPARE(imported[0][1].toStringList().size(), 1);
    QVERIFY(imported[0][1].toStringList().front().startsWith(QStringLiteral("run.dat:12")));

    QSignalSpy warned(files_, &CaseFiles::warned);
    files_->take(document, path(QStringLiteral("slider.toml")));
    QCOMPARE(imported.count(), 1);
    QCOMPARE(warned.count(), 1);
    QCOMPARE(warned[0][0], imported[0][1]);
}

void TestCaseFiles::namesAnImport_data()
{
    QTest::addColumn<QString>("opened");
    QTest::newRow("folder") << "femto";
    QTest::newRow("file in it") << "femto/run.dat";
}

void TestCaseFiles::namesAnImport()
{
    QFETCH(const QString, opened);
    files_->exportTo(path(QStringLiteral("femto")));
    QVERIFY(files_->openNow(path(opened)));
    QCOMPARE(files_->shortName(), QStringLiteral("femto"));
}

void TestCaseFiles::saysWhyAnExportFails()
{
    QSignalSpy exported(files_, &CaseFiles::exported);
    files_->exportTo(path(QStringLiteral("no/such/folder/slider.cml")));
    QCOMPARE(exported.count(), 0);
    QVERIFY(problems());
    QVERIFY(!problems()->informativeText().isEmpty());
}

void TestCaseFiles::knowsWhatCanBeDropped_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<bool>("accepted");
    QTest::newRow("case file") << "a.toml" << true;
    QTest::newRow("results") << "run.h5" << true;
    QTest::newRow("archive") << "slider.cml" << true;
    QTest::newRow("folder with a rail.dat") << "slider" << true;
    QTest::newRow("the rails") << "slider/rail.dat" << true;
    QTest::newRow("folder without") << "." << false;
    QTest::newRow("something else") << "picture.png" << false;
}

void TestCaseFiles::knowsWhatCanBeDropped()
{
    QFETCH(const QString, name);
    QFETCH(const bool, accepted);
    files_->exportTo(path(QStringLiteral("slider")));
    QCOMPARE(CaseFiles::canOpen(QDir::cleanPath(path(name))), accepted);
}

// The person's answer holds until the program ends; no is the default.
void TestCaseFiles::asksBeforeItReadsElsewhere()
{
    const QString surface = path(QStringLiteral("track.txt")), file = path(QStringLiteral("case/mine.toml"));
    QVERIFY(QDir(folder_->path()).mkdir(QStringLiteral("case")));
    QCOMPARE(writeCaseFile(surface.toStdString(), "# x [um]  h [nm]\n0 0\n1 1\n2 0\n3 -1\n"), std::string());
    QCOMPARE(writeCaseFile(file.toStdString(), "model = \"contact\"\n[disk.surface]\nkind = \"file\"\n"
                                               "motion = \"still\"\nfile = \"../track.txt\"\n"),
             std::string());
    const auto question = [&] {
        QPointer<QMessageBox> box = window_->findChild<QMessageBox*>(QStringLiteral("outsideFiles"));
        return box;
    };
    const auto answer = [&](QMessageBox::StandardButton button) {
        QPointer<QMessageBox> box = question();
        box->button(button)->click();
        QCoreApplication::sendPostedEvents(box, QEvent::DeferredDelete);
    };
    QSignalSpy opened(files_, &CaseFiles::opened);
    QVERIFY(!files_->openNow(file));
    QVERIFY(question() && question()->text().contains(QStringLiteral("../track.txt")));
    QCOMPARE(question()->defaultButton(), question()->button(QMessageBox::No));
    answer(QMessageBox::No);
    QCOMPARE(opened.count(), 0);
    QVERIFY(!files_->openNow(file));
    answer(QMessageBox::Yes);
    QCOMPARE(opened.count(), 1);
    QCOMPARE(files_->file(), file);
    QCOMPARE(edits_->value().diskSurface.file, std::string("../track.txt"));
    QVERIFY(files_->openNow(file)); // asked once
    QVERIFY(!question());
    // What is saved over it still names the file.
    files_->save();
    QVERIFY(files_->text().find("../track.txt") != std::string::npos);
    // The answer is for this file, not for others that the case may name by now.
    QVERIFY(QFile::copy(surface, path(QStringLiteral("secret.txt"))));
    std::string other = files_->text();
    other.replace(other.find("track.txt"), 9, "secret.txt");
    QCOMPARE(writeCaseFile(file.toStdString(), other), std::string());
    files_->reload();
    QVERIFY(question() && question()->text().contains(QStringLiteral("../secret.txt")));
    QCOMPARE(edits_->value().diskSurface.file, std::string("../track.txt"));
    answer(QMessageBox::Yes);
    QCOMPARE(edits_->value().diskSurface.file, std::string("../secret.txt"));
}

/// As a results file needs it, which may be opened anywhere.
void TestCaseFiles::givesATextThatNeedsNoRailFile()
{
    files_->exportTo(path(QStringLiteral("slider")));
    const QString file = path(QStringLiteral("mine.toml"));
    QCOMPARE(writeCaseFile(file.toStdString(), "model = \"film\"\n[abs]\nrails = \"slider/rail.dat\"\n"),
             std::string());
    QVERIFY(files_->openNow(file));
    QCOMPARE(edits_->value().surface, sampleSurface());
    QVERIFY(files_->text().find("rail.dat") != std::string::npos);
    const CaseDocument alone = parseCase(files_->wholeText(), "");
    QVERIFY(alone.valid());
    QCOMPARE(alone.value.surface, sampleSurface());
    QCOMPARE(alone.value.slider.length, edits_->value().slider.length);
}

TOUCHDOWN_TEST(TestCaseFiles)

} // namespace test_case_files

#include "test_case_files.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every kind of change of a case, applied as a study applies what it found: the window asks before it loses the change,
// and a run and its results file hold the case that ran.
#include <functional>

#include <QAction>
#include <QMessageBox>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

#include "core/case_files/case_file.h"
#include "core/case_files/case_reader.h"
#include "core/case_files/case_text.h"
#include "core/results/results_reader.h"
#include "tests/support/test_program.h"
#include "tests/ui/question.h"
#include "tests/ui/sample_slider.h"
#include "tests/ui/window_fixture.h"
#include "ui/case/case_edits.h"
#include "ui/case/case_files.h"
#include "ui/runs/run_controller.h"
#include "ui/runs/run_record.h"
#include "ui/runs/runs_model.h"
#include "ui/studies/study_window.h"
#include "ui/window/main_window.h"
#include "ui/window/window_actions.h"

using namespace touchdown;

namespace test_case_changes {

using Change = std::function<void(Case&)>;

/// A run on springs takes no time; the text keeps the surface, which the springs do not use.
Case shortCase()
{
    Case c;
    c.title = "A slider of our own";
    c.surface = sampleSurface();
    c.run.duration = 0.02e-3;
    c.spectrum.segment = 0.01e-3;
    return c;
}

struct Fixture : test::WindowFixture {
    Fixture()
    {
        CaseDocument document;
        document.text = "# notes\n" + formatCase(shortCase());
        document.value = parseCase(document.text, "").value;
        window.files().take(document, folder.filePath(QStringLiteral("mine.toml")));
    }
    void apply(const Change& change)
    {
        Case found = window.edits().value();
        change(found);
        if (!window.files().isOpen(found)) return window.edits().setAll(found, QStringLiteral("another title"));
        emit window.studies().applyRequested(found, QStringLiteral("a study"));
        const QMessageBox* box = question(window, "applyQuestion");
        if (!box) qFatal("nobody asks");
        for (QAbstractButton* button : box->buttons())
            if (box->buttonRole(button) == QMessageBox::AcceptRole) return button->click();
    }
    QTemporaryDir folder;
};

class TestCaseChanges : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init() { QSettings().clear(); }
    void isModified_data() { addChanges(); }
    void isModified();
    void runsWhatItStores_data() { addChanges(); }
    void runsWhatItStores();
    void anUnchangedCaseIsNotModified();

private:
    static void addChanges();
};

void TestCaseChanges::initTestCase()
{
    QCoreApplication::setOrganizationName(QStringLiteral("touchdown"));
    QCoreApplication::setApplicationName(QStringLiteral("test_case_changes"));
}

void TestCaseChanges::addChanges()
{
    QTest::addColumn<Change>("change");
    const auto row = [](const char* name, const Change& change) { QTest::newRow(name) << change; };
    row("parameter", [](Case& c) { c.springs.flyingHeight = 6e-9; });
    row("title", [](Case& c) { c.title = "other"; });
    row("rail added", [](Case& c) { c.surface.rails.push_back(c.surface.rails[1]); });
    row("rail removed", [](Case& c) { c.surface.rails.erase(c.surface.rails.begin() + 1); });
    row("recess", [](Case& c) { c.surface.rails[0].recess[0] = 200e-9; });
    row("corner moved", [](Case& c) { c.surface.rails[0].points[2].x += 1e-6; });
    row("corner added", [](Case& c) { c.surface.rails[3].points.push_back({0.71e-3, 0.32e-3, 2}); });
    row("wall of an edge", [](Case& c) { c.surface.rails[0].points[1].wall = 0; });
    row("order of rails", [](Case& c) { std::swap(c.surface.rails[0], c.surface.rails[2]); });
    row("wall profile", [](Case& c) { c.surface.walls[0].recess[1] = 310e-9; });
    row("wall added", [](Case& c) { c.surface.walls.push_back(c.surface.walls[0]); });
    row("point of interest", [](Case& c) { c.surface.pointsOfInterest[1].y = 0.25e-3; });
    row("point of interest removed", [](Case& c) { c.surface.pointsOfInterest.pop_back(); });
}

void TestCaseChanges::isModified()
{
    QFETCH(Change, change);
    Fixture f;
    QVERIFY(!f.window.files().modified());
    f.apply(change);
    QVERIFY(f.window.files().modified());
    QVERIFY(f.window.isWindowModified());
    QVERIFY(f.window.edits().anyChanged());
    QVERIFY(f.window.actions().resetAll->isEnabled());

    f.window.close();
    QVERIFY(f.window.isVisible());
    answer(f.window, "closing", QStringLiteral("Go on working"));

    f.window.actions().undo->trigger();
    QVERIFY(!f.window.files().modified());
    QVERIFY(!f.window.edits().anyChanged());

    // Saved, the file holds the change and its comments.
    f.window.actions().redo->trigger();
    const Case wanted = f.window.edits().value();
    f.window.files().save();
    QVERIFY(!f.window.files().modified());
    const CaseDocument written = readCaseFile(f.window.files().file().toStdString());
    QVERIFY(written.valid());
    QVERIFY(written.value.surface == wanted.surface);
    QVERIFY(written.text.starts_with("# notes\n"));
}

void TestCaseChanges::runsWhatItStores()
{
    QFETCH(Change, change);
    Fixture f;
    f.apply(change);
    const RunRecord& record = f.runToEnd();
    const QString file = f.folder.filePath(QStringLiteral("run.h5"));
    QCOMPARE(saveHdf5(record, file), QString());
    const StoredRun stored = readResults(file.toStdString());
    QCOMPARE(stored.problem, std::string());
    Case ran = record.value;
    ran.folder.clear();
    QVERIFY(ran == parseCase(stored.caseText, "").value);
}

void TestCaseChanges::anUnchangedCaseIsNotModified()
{
    Fixture f;
    f.apply([](Case& c) { c.surface.rails[0].recess[0] = 200e-9; });
    f.apply([](Case& c) { c.surface.rails[0].recess[0] = 150e-9; });
    QVERIFY(!f.window.files().modified());
    f.window.close();
    QVERIFY(!question(f.window, "closing"));
    QTRY_VERIFY(!f.window.isVisible());
}

TOUCHDOWN_TEST(TestCaseChanges)

} // namespace test_case_changes

#include "test_case_changes.moc"

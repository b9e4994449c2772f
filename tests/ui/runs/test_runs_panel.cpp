// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAbstractItemModelTester>
#include <QLineEdit>
#include <QListView>
#include <QSignalSpy>
#include <QStyleOptionViewItem>
#include <QTemporaryDir>
#include <QtTest>

#include "core/case/parameters.h"
#include "core/case_files/case_file.h"
#include "core/case_files/case_text.h"
#include "core/results/results_reader.h"
#include "core/simulation/run.h"
#include "tests/support/test_program.h"
#include "tests/ui/question.h"
#include "ui/case/parameter_text.h"
#include "ui/guides/lesson_stages.h"
#include "ui/lists/record_delegate.h"
#include "ui/lists/record_panel.h"
#include "ui/runs/about_case_pane.h"
#include "ui/runs/run_record.h"
#include "ui/runs/runs_model.h"
#include "ui/style/quantity_format.h"

using namespace touchdown;

namespace test_runs_panel {

/// A record of a run of the default case, with `change` applied, whole.
std::unique_ptr<RunRecord> ranRecord(int number, const std::function<void(Case&)>& change = {})
{
    CaseDocument document = openCase("fig10a");
    document.value.run.duration = 0.1e-3;
    document.value.spectrum.segment = 0.05e-3;
    if (change) change(document.value);
    auto record = std::make_unique<RunRecord>(number, document.value, formatCase(document.value),
                                              recordedQuantities(document.value));
    record->finish(run(document.value, [&record](const RunUpdate& update) {
        record->append(update.samples, update.events);
        return true;
    }));
    return record;
}

class TestRunsPanel : public QObject {
    Q_OBJECT

private slots:
    void isAProperModel();
    void saysWhatChanged();
    void aNameShowsNoMarksOfDirection();
    void namesRunsByWhatChanged();
    void namesWhatChangedSinceTheCaseWasOpened();
    void namesCasesOfOneFigureApart();
    void theNewestSpeaksUnlessOneIsRaised();
    void overlayActsAtOnce();
    void theRowUnderThePointerIsTold();
    void showsTheHeightOfTheCard();
    void endsOfMotions_data();
    void endsOfMotions();
    void showsResults_data();
    void showsResults();
    void togglesOverlayByMouseAndKey();
    void editsNotes();
    void removesRuns();
    void keepsTheRunUnderWay();
    void takesABaseline();
    void savesAndReopensRuns();
    void aRunIsNotSavedFromAnotherFile();
    void aRunThatLostItsFileIsNotSavedInPart();
    void saysWhyAFileCannotBeOpened();
    void savesALongRunWhole();
};

void TestRunsPanel::isAProperModel()
{
    RunsModel model;
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    model.add(ranRecord(model.nextNumber()));
    model.add(ranRecord(model.nextNumber()));
    model.add(ranRecord(model.nextNumber()));
    model.setData(model.index(1), Qt::Unchecked, Qt::CheckStateRole);
    model.setBaseline(2);
    model.remove(1);
    model.remove(0);
    QCOMPARE(model.rowCount(), 1);
    // A number is not given twice, so that a colour stays with its run.
    QCOMPARE(model.nextNumber(), 4);
}

void TestRunsPanel::saysWhatChanged()
{
    RunsModel model;
    model.add(ranRecord(1));
    model.add(ranRecord(2, [](Case& c) { c.onoYamane.takeOff = 8e-9; }));
    model.add(ranRecord(3, [](Case& c) { c.onoYamane.takeOff = 8e-9; }));
    model.add(ranRecord(4, [](Case& c) { c.contact = noContact; }));
    const auto changes = [&model](int row) { return model.index(row).data(RunsModel::ChangesRole).toString(); };
    QCOMPARE(changes(1), QStringLiteral("take-off height 5\u00a0nm → 8\u00a0nm"));
    QCOMPARE(changes(2), QStringLiteral("same parameters as run 2"));
    // d_e is used by run 3 only, and still differs.
    QVERIFY2(changes(3).startsWith(QStringLiteral("contact Ono & Yamane → none")), qPrintable(changes(3)));
    // What neither run uses is no change.
    Case before, after;
    after.run.step = 1e-9; // of fixed-step methods; both use dopri5
    QVERIFY(caseDifference(before, after).isEmpty());
    // The surface of a film.
    before = defaultsOf(ModelKind::Film);
    before.surface.rails = {{RailKind::Step, {{0.0, 0.0}, {1e-3, 0.0}, {1e-3, 1e-3}}, {}}};
    after = before;
    after.surface.rails[0].recess[0] = 0.2e-6;
    after.surface.rails.push_back(after.surface.rails[0]);
    after.surface.rails[1].points[0].x = 0.1e-3;
    const QStringList expected{QStringLiteral("rail 1: recess 0\u00a0µm → 0.2\u00a0µm"),
                               QStringLiteral("rail 2 added")};
    QCOMPARE(caseDifference(before, after), expected);
    // No more digits than tell the two apart.
    after = before;
    before.disk.radius = 20e-3;
    after.disk.radius = 28.125000000000004e-3;
    QVERIFY2(caseDifference(before, after).front().endsWith(QStringLiteral("20\u00a0mm → 28.125\u00a0mm")),
             qPrintable(caseDifference(before, after).front()));
    before.disk.radius = 28.125001e-3;
    QVERIFY2(caseDifference(before, after).front().endsWith(QStringLiteral("28.125001\u00a0mm → 28.125\u00a0mm")),
             qPrintable(caseDifference(before, after).front()));
    before.disk.radius = after.disk.radius;
    // Also in a unit that is no power of ten of the SI unit.
    after = before;
    before.suspension.preload = 1.5000000025e-3 * 9.80665;
    after.suspension.preload = 1.6000000367e-3 * 9.80665;
    QVERIFY2(caseDifference(before, after).front().endsWith(QStringLiteral("1.5\u00a0gf → 1.6\u00a0gf")),
             qPrintable(caseDifference(before, after).front()));
    before.suspension.preload = after.suspension.preload;
    // Points that were moved together are one change.
    after = before;
    for (RailPoint& point : after.surface.rails[0].points) point.x += 2e-6;
    QCOMPARE(caseDifference(before, after), QStringList{QStringLiteral("rail 1 moved by 2, 0\u00a0µm")});
    after.surface.rails[0].points[0].y -= 0.5e-6;
    QCOMPARE(caseDifference(before, after),
             (QStringList{QStringLiteral("rail 1, corner 1 moved by 2, \u22120.5\u00a0µm"),
                          QStringLiteral("rail 1, corners 2, 3 moved by 2, 0\u00a0µm")}));
    // So are the ends of an edge, which slide along the edges beside it, and a mirrored rail.
    after = before;
    after.surface.rails[0].points = {{1e-6, 1e-6}, {1e-3, 1e-6}, {1e-3, 1e-3}}; // the first edge, 1 µm up
    QCOMPARE(caseDifference(before, after), QStringList{QStringLiteral("rail 1, edge 1 moved by 0, 1\u00a0µm")});
    after = before;
    for (RailPoint& point : after.surface.rails[0].points) point.y = 2e-3 - point.y;
    QCOMPARE(caseDifference(before, after), QStringList{QStringLiteral("rail 1 mirrored")});
    before.surface.rails[0].points = {{0.0, 0.0}, {1e-3, 0.5e-3}, {0.0, 1e-3}}; // its own mirror image
    after = before;
    for (RailPoint& point : after.surface.rails[0].points) point.y = 1e-3 - point.y;
    QCOMPARE(caseDifference(before, after), QStringList{QStringLiteral("rail 1 mirrored")});
}

/// A title of another person.
void TestRunsPanel::aNameShowsNoMarksOfDirection()
{
    RunsModel model;
    model.add(ranRecord(1, [](Case& c) { c.title = "mine \u202Etxt.exe"; }));
    const QString name = model.index(0).data(Qt::DisplayRole).toString();
    QVERIFY2(name.contains(QStringLiteral("mine \uFFFDtxt.exe")), qPrintable(name));
}

void TestRunsPanel::namesRunsByWhatChanged()
{
    RunsModel model;
    const auto name = [&model](int row) { return model.index(row).data(Qt::DisplayRole).toString(); };
    model.add(ranRecord(1));
    model.add(ranRecord(2, [](Case& c) { c.initial.flyingHeight = 20e-9; }));
    model.add(ranRecord(3, [](Case& c) { c.initial.flyingHeight = 30e-9; }));
    model.add(ranRecord(4, [](Case& c) { c.onoYamane.meniscusForce = 1e-3; }));
    model.add(ranRecord(5));
    model.add(ranRecord(6, [](Case& c) {
        c.onoYamane.meniscusForce = 1e-3;
        c.onoYamane.takeOff = 8e-9;
        c.springs.flyingHeight = 4e-9;
    }));
    QCOMPARE(name(0), QStringLiteral("1  Fig. 10 (a)"));
    QCOMPARE(name(1), QStringLiteral("2  FH(0) 20\u00a0nm"));
    QCOMPARE(name(2), QStringLiteral("3  FH(0) 30\u00a0nm"));
    QCOMPARE(name(3), QStringLiteral("4  fₘ 1\u00a0mN"));
    QCOMPARE(name(4), QStringLiteral("5  Fig. 10 (a), run 5"));
    QVERIFY2(name(5).endsWith(QStringLiteral(" +1")), qPrintable(name(5)));
    QVERIFY2(!name(5).contains(QStringLiteral("fₘ")), qPrintable(name(5))); // which run 4 has, too
    // The tool tip has the whole title, with its characters of print.
    QVERIFY(model.index(1).data(Qt::ToolTipRole).toString().contains(QStringLiteral("dropped from 250 nm, d₁")));
    // A baseline is what runs are compared with.
    model.setBaseline(2);
    QCOMPARE(name(0), QStringLiteral("1  FH(0) 250\u00a0nm"));
    QCOMPARE(name(1), QStringLiteral("2  FH(0) 20\u00a0nm"));
    QCOMPARE(name(2), QStringLiteral("3  FH(0) 30\u00a0nm"));
    model.setBaseline(-1);
    // Beside another case each run has the name of its own.
    model.add(ranRecord(7, [](Case& c) { c.title = "Fig. 14 (a): damping ratios 0.001"; }));
    QCOMPARE(name(1), QStringLiteral("2  Fig. 10 (a), FH(0) 20\u00a0nm"));
    QCOMPARE(name(6), QStringLiteral("7  Fig. 14 (a)"));
    model.remove(6);
    QCOMPARE(name(1), QStringLiteral("2  FH(0) 20\u00a0nm"));
}

/// A case of the user's own that was changed before its first run.
void TestRunsPanel::namesWhatChangedSinceTheCaseWasOpened()
{
    RunsModel model;
    Case opened = ranRecord(1)->value;
    opened.title = "ftd1";
    model.setOpened(opened);
    const auto text = [&model](int row, int role) { return model.index(row).data(role).toString(); };
    model.add(ranRecord(1, [](Case& c) {
        c.title = "ftd1";
        c.onoYamane.takeOff = 8e-9;
    }));
    QCOMPARE(text(0, Qt::DisplayRole), QStringLiteral("1  ftd1, dₑ 8\u00a0nm"));
    QCOMPARE(text(0, RunsModel::ChangesRole), QStringLiteral("take-off height 5\u00a0nm → 8\u00a0nm"));
    model.add(ranRecord(2, [](Case& c) { c.title = "ftd1"; }));
    QCOMPARE(text(0, Qt::DisplayRole), QStringLiteral("1  dₑ 8\u00a0nm"));
    QCOMPARE(text(1, Qt::DisplayRole), QStringLiteral("2  dₑ 5\u00a0nm")); // as it was opened
    // Opened again with other values, as it was saved: the runs of the list keep their names.
    opened.onoYamane.takeOff = 8e-9;
    model.setOpened(opened);
    model.add(ranRecord(3, [](Case& c) {
        c.title = "ftd1";
        c.springs.flyingHeight = 20e-9;
    }));
    QCOMPARE(text(0, Qt::DisplayRole), QStringLiteral("1  dₑ 8\u00a0nm"));
    QCOMPARE(text(1, Qt::DisplayRole), QStringLiteral("2  ftd1"));
}

/// The cases of one figure have the same beginning of their titles.
void TestRunsPanel::namesCasesOfOneFigureApart()
{
    RunsModel model;
    for (int number = 1; number <= 3; ++number)
        model.add(ranRecord(number, [&](Case& c) { c.title = "Fig. 99: f_m = " + std::to_string(number) + " mN"; }));
    const auto name = [&model](int row) { return model.index(row).data(Qt::DisplayRole).toString(); };
    QVERIFY2(name(0).startsWith(QStringLiteral("1  Fig. 99: fₘ = 1")), qPrintable(name(0)));
    QVERIFY2(name(1).startsWith(QStringLiteral("2  Fig. 99: fₘ = 2")), qPrintable(name(1)));
    QVERIFY2(name(2).startsWith(QStringLiteral("3  Fig. 99: fₘ = 3")), qPrintable(name(2)));
}

void TestRunsPanel::theNewestSpeaksUnlessOneIsRaised()
{
    RunsModel model;
    const QSignalSpy changed(&model, &RunsModel::speakerChanged);
    const auto speaks = [&model](int row) { return model.index(row).data(RunsModel::SpeaksRole).toBool(); };
    for (int number = 1; number <= 3; ++number) model.add(ranRecord(number));
    QCOMPARE(model.speaker(), 3);
    QVERIFY(speaks(2) && !speaks(0));
    model.raise(1);
    QCOMPARE(model.speaker(), 1);
    QVERIFY(speaks(0) && !speaks(2));
    QCOMPARE(changed.count(), 1);
    model.setData(model.index(0), Qt::Unchecked, Qt::CheckStateRole); // not one that is hidden
    QCOMPARE(model.speaker(), 3);
    model.raise(-1);
    QCOMPARE(changed.count(), 1);
    model.setData(model.index(2), Qt::Unchecked, Qt::CheckStateRole);
    QCOMPARE(model.speaker(), 2);
}

void TestRunsPanel::overlayActsAtOnce()
{
    RunsModel model;
    RecordPanel panel(model, RecordPanel::wordsOfRuns());
    const auto shown = [&model] {
        QList<int> numbers;
        for (int row = 0; row < model.count(); ++row)
            if (model.record(row).shown) numbers << model.record(row).number;
        return numbers;
    };
    for (int number = 1; number <= 3; ++number) model.add(ranRecord(number));
    model.setData(model.index(0), Qt::Unchecked, Qt::CheckStateRole); // by hand: not the business of the box
    panel.setOverlay(false);
    QCOMPARE(shown(), QList<int>{3});
    model.add(ranRecord(4)); // as one that is opened
    QCOMPARE(shown(), QList<int>{4});
    panel.setOverlay(true);
    QCOMPARE(shown(), (QList<int>{2, 3, 4}));
}

void TestRunsPanel::theRowUnderThePointerIsTold()
{
    RunsModel model;
    RecordPanel panel(model, RecordPanel::wordsOfRuns());
    for (int number = 1; number <= 3; ++number) model.add(ranRecord(number));
    panel.resize(320, 300);
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel));
    const QSignalSpy hovered(&panel, &RecordPanel::recordHovered);
    QTest::mouseMove(panel.list()->viewport(), panel.list()->visualRect(model.index(0)).center());
    QTRY_COMPARE(hovered.count(), 1);
    QCOMPARE(hovered.last()[0].toInt(), 1);
    QTest::mouseMove(panel.list()->viewport(), panel.list()->visualRect(model.index(1)).center());
    QTRY_COMPARE(hovered.last()[0].toInt(), 2);
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(panel.list()->viewport(), &leave);
    QCOMPARE(hovered.last()[0].toInt(), -1);
}

/// A film's card and message name its minimum spacing, not its flying height.
void TestRunsPanel::showsTheHeightOfTheCard()
{
    RunsModel model;
    Case film = defaultsOf(ModelKind::Film);
    auto record = std::make_unique<RunRecord>(1, film, std::string(),
                                              std::vector<Quantity>{{"flying_height", "m", "nm", "Flying height"},
                                                                    {"minimum_spacing", "m", "nm", "Minimum spacing"}});
    record->append({{0.0, 1e-6}, {{7e-9, -0.511e-9}, {7e-9, -0.522e-9}}}, {});
    model.add(std::move(record));
    Summary summary;
    summary.status = RunStatus::Completed;
    summary.endTime = 1e-6;
    model.finish(1, summary);
    const QString height = readout(-0.522e-9, "nm");
    QVERIFY2(resultText(model.record(0)).contains(QStringLiteral("minimum spacing ") + height),
             qPrintable(resultText(model.record(0))));
    QCOMPARE(model.index(0).data(RunsModel::ResultRole).toString(), QStringLiteral("ends at ") + height);
}

/// "Ends at" is for a motion that ends: list, message and the pane of the lesson share one sentence. A motion that
/// lasts swings from 0.9 to 8.98 nm, by 8.08 nm; its last sample is anywhere. A run that is too short may be of either
/// kind.
void TestRunsPanel::endsOfMotions_data()
{
    QTest::addColumn<int>("motion");
    QTest::addColumn<QString>("text");
    const QString swings = QStringLiteral("swings by 8.08\u00a0nm");
    QTest::newRow("at rest") << static_cast<int>(Motion::AtRest) << "ends at 3.200\u00a0nm";
    QTest::newRow("settles") << static_cast<int>(Motion::Settles) << "ends at 3.200\u00a0nm";
    QTest::newRow("swings") << static_cast<int>(Motion::Swings) << swings;
    QTest::newRow("vibrates") << static_cast<int>(Motion::Vibrates) << swings;
    QTest::newRow("bounces") << static_cast<int>(Motion::Bounces) << swings;
    QTest::newRow("too short") << static_cast<int>(Motion::TooShort) << "at 3.200\u00a0nm";
}

void TestRunsPanel::endsOfMotions()
{
    QFETCH(const int, motion);
    QFETCH(const QString, text);
    RunsModel model;
    auto record = std::make_unique<RunRecord>(1, Case{}, std::string(),
                                              std::vector<Quantity>{{"flying_height", "m", "nm", "Flying height"},
                                                                    {"minimum_spacing", "m", "nm", "Minimum spacing"}});
    record->append({{0.0, 1e-6}, {{7e-9, 3.2e-9}, {7e-9, 3e-9}}}, {});
    model.add(std::move(record));
    Summary summary;
    summary.endTime = 1e-6;
    summary.verdict.motion = static_cast<Motion>(motion);
    summary.tail = {{"minimum_spacing", {.mean = 4e-9, .std = 2e-9, .min = 0.9e-9, .max = 8.98e-9}}};
    model.finish(1, summary);
    const RunRecord& run = model.record(0);
    QCOMPARE(endText(run), text);
    QCOMPARE(model.index(0).data(RunsModel::ResultRole).toString(), text);
    const QString tip = model.index(0).data(Qt::ToolTipRole).toString();
    QCOMPARE(tip.contains(QStringLiteral("3.200")), !lasts(summary.verdict.motion));
    QVERIFY2(tip.contains(text.mid(1)), qPrintable(tip)); // it begins a sentence
    const bool lasting = lasts(summary.verdict.motion);
    QCOMPARE(resultText(run).contains(QStringLiteral("3.200")), !lasting);
    QCOMPARE(resultText(run).contains(QStringLiteral("8.08")), lasting);
    QCOMPARE(resultText(run).startsWith(QStringLiteral("Ends at ")), !lasting);
    QVERIFY(lessonResult(run, 0.0).startsWith(text));
    QCOMPARE(lessonResult(run, 0.0).count(QStringLiteral("8.08")), 1);

    // A run that is read from its file ends in the same words.
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("run.h5"));
    QCOMPARE(saveHdf5(run, file), QString());
    QString problem;
    const std::unique_ptr<RunRecord> read = recordFromFile(2, file, problem);
    QVERIFY2(read, qPrintable(problem));
    QCOMPARE(endText(*read), text);
}

void TestRunsPanel::showsResults_data()
{
    QTest::addColumn<int>("status");
    QTest::addColumn<QString>("result");
    QTest::addColumn<bool>("failed");
    QTest::newRow("completed") << static_cast<int>(RunStatus::Completed) << "ends at 3.200\u00a0nm" << false;
    QTest::newRow("stopped") << static_cast<int>(RunStatus::Cancelled) << "stopped" << false;
    QTest::newRow("diverged") << static_cast<int>(RunStatus::Diverged) << "diverged" << true;
    QTest::newRow("failed") << static_cast<int>(RunStatus::Failed) << "failed" << true;
}

void TestRunsPanel::showsResults()
{
    QFETCH(const int, status);
    QFETCH(const QString, result);
    QFETCH(const bool, failed);
    RunsModel model;
    auto record = std::make_unique<RunRecord>(1, Case{}, std::string(),
                                              std::vector<Quantity>{{"flying_height", "m", "nm", "Flying height"}});
    record->append({{0.0, 1e-6}, {{7e-9, 3.2e-9}}}, {});
    model.add(std::move(record));
    QCOMPARE(model.index(0).data(RunsModel::ResultRole).toString(), QStringLiteral("running"));
    Summary summary;
    summary.status = static_cast<RunStatus>(status);
    model.finish(1, summary);
    QCOMPARE(model.index(0).data(RunsModel::ResultRole).toString(), result);
    QCOMPARE(model.index(0).data(RunsModel::FailedRole).toBool(), failed);
}

void TestRunsPanel::togglesOverlayByMouseAndKey()
{
    RunsModel model;
    RecordPanel panel(model, RecordPanel::wordsOfRuns());
    const QSignalSpy shown(&model, &RunsModel::shownChanged);
    model.add(ranRecord(1));
    panel.resize(320, 300);
    panel.show();
    QStyleOptionViewItem option;
    option.widget = panel.list();
    option.fontMetrics = panel.list()->fontMetrics();
    option.rect = panel.list()->visualRect(model.index(0));
    const QPoint box = RecordDelegate::checkRect(option).center();
    QTest::mouseClick(panel.list()->viewport(), Qt::LeftButton, {}, box);
    QCOMPARE(shown.count(), 1);
    QVERIFY(!model.record(0).shown);
    // A click on the name chooses the run and changes nothing.
    QTest::mouseClick(panel.list()->viewport(), Qt::LeftButton, {}, box + QPoint(120, 0));
    QCOMPARE(shown.count(), 1);
    QTest::keyClick(panel.list(), Qt::Key_Space);
    QVERIFY(model.record(0).shown);
}

void TestRunsPanel::editsNotes()
{
    RunsModel model;
    RecordPanel panel(model, RecordPanel::wordsOfRuns());
    model.add(ranRecord(1));
    panel.resize(320, 300);
    panel.show();
    const int height = panel.list()->visualRect(model.index(0)).height();
    QTest::keyClick(panel.list(), Qt::Key_F2);
    auto* editor = panel.list()->viewport()->findChild<QLineEdit*>();
    QVERIFY(editor);
    QTest::keyClicks(editor, QStringLiteral("bounces twice"));
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_COMPARE(model.record(0).note, QStringLiteral("bounces twice"));
    // The row makes room for it.
    QTRY_VERIFY(panel.list()->visualRect(model.index(0)).height() > height);
}

void TestRunsPanel::removesRuns()
{
    RunsModel model;
    RecordPanel panel(model, RecordPanel::wordsOfRuns());
    const QSignalSpy removed(&model, &RunsModel::aboutToRemove);
    model.add(ranRecord(1));
    model.add(ranRecord(2));
    QCOMPARE(panel.chosen(), 2);
    for (QToolButton* button : panel.findChildren<QToolButton*>())
        if (button->text() == QStringLiteral("Delete")) button->click();
    answer(panel, "unsavedRecord", QStringLiteral("Delete"));
    QCOMPARE(removed.count(), 1);
    QCOMPARE(removed[0][0].toInt(), 2);
    QCOMPARE(model.count(), 1);
    QCOMPARE(panel.chosen(), 1);
}

void TestRunsPanel::keepsTheRunUnderWay()
{
    RunsModel model;
    RecordPanel panel(model, RecordPanel::wordsOfRuns());
    model.add(ranRecord(1));
    panel.setActive(1);
    for (QToolButton* button : panel.findChildren<QToolButton*>())
        if (button->text() == QStringLiteral("Delete")) QVERIFY(!button->isEnabled());
    panel.setActive(-1);
    for (QToolButton* button : panel.findChildren<QToolButton*>())
        if (button->text() == QStringLiteral("Delete")) QVERIFY(button->isEnabled());
}

void TestRunsPanel::takesABaseline()
{
    RunsModel model;
    RecordPanel panel(model, RecordPanel::wordsOfRuns());
    model.add(ranRecord(1));
    model.add(ranRecord(2));
    for (QToolButton* button : panel.findChildren<QToolButton*>())
        if (button->text() == QStringLiteral("Baseline")) button->click();
    QCOMPARE(model.baseline(), 2);
    QVERIFY(model.index(1).data(RunsModel::BaselineRole).toBool());
    model.remove(1);
    QCOMPARE(model.baseline(), -1);
}

void TestRunsPanel::savesAndReopensRuns()
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("run.h5"));
    const std::unique_ptr<RunRecord> record = ranRecord(1, [](Case& c) { c.springs.flyingHeight = 4e-9; });
    QCOMPARE(saveHdf5(*record, file), QString());
    QString problem;
    const std::unique_ptr<RunRecord> again = recordFromFile(5, file, problem);
    QCOMPARE(problem, QString());
    QCOMPARE(again->number, 5);
    QCOMPARE(again->value.springs.flyingHeight, 4e-9);
    QCOMPARE(again->sampleCount(), record->sampleCount());
    QCOMPARE(again->samples(0).time, record->samples(0).time);
    QCOMPARE(again->samples(0).columns, record->samples(0).columns);
    QCOMPARE(again->summary->status, RunStatus::Completed);

    const QString table = folder.filePath(QStringLiteral("run.csv"));
    QCOMPARE(saveTimeSeries(*record, table), QString());
    QFile csv(table);
    QVERIFY(csv.open(QIODevice::ReadOnly | QIODevice::Text));
    const QList<QByteArray> lines = csv.readAll().trimmed().split('\n');
    QVERIFY(lines.front().startsWith("time [s],flying_height [m]"));
    QCOMPARE(lines.size(), static_cast<qsizetype>(record->sampleCount()) + 1);
}

/// A saved copy holds the run that the window shows, whatever lies at the path of its file by now.
void TestRunsPanel::aRunIsNotSavedFromAnotherFile()
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("run.h5")), aside = folder.filePath(QStringLiteral("aside.h5")),
                  copy = folder.filePath(QStringLiteral("copy.h5"));
    QCOMPARE(saveHdf5(*ranRecord(1), file), QString());
    QString problem;
    const std::unique_ptr<RunRecord> read = recordFromFile(1, file, problem);
    QCOMPARE(problem, QString());
    const auto refused = [&] {
        const QString reason = saveHdf5(*read, copy);
        return reason.contains(QStringLiteral("run.h5")) && !QFile::exists(copy);
    };
    QVERIFY(QFile::copy(file, aside));
    QCOMPARE(saveHdf5(*ranRecord(2, [](Case& c) { c.springs.flyingHeight = 4e-9; }), file), QString());
    QVERIFY(refused());
    QVERIFY(QFile::remove(file));
    QVERIFY(refused());
    QVERIFY(QDir().mkdir(file));
    QVERIFY(refused());
    QVERIFY(QDir().rmdir(file));
    QVERIFY(QFile::rename(aside, file)); // the same bytes
    QCOMPARE(saveHdf5(*read, copy), QString());
    const std::unique_ptr<RunRecord> again = recordFromFile(2, copy, problem);
    QCOMPARE(again->caseText, read->caseText);
    QCOMPARE(saveTimeSeries(*read, folder.filePath(QStringLiteral("run.csv"))), QString());
}

/// A run that is written over the file of an opened one takes this file from it.
void TestRunsPanel::aRunThatLostItsFileIsNotSavedInPart()
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("run.h5")), copy = folder.filePath(QStringLiteral("copy.h5"));
    QCOMPARE(saveHdf5(*ranRecord(1), file), QString());
    RunsModel model;
    QString problem;
    model.add(recordFromFile(1, file, problem));
    model.add(ranRecord(2, [](Case& c) { c.springs.flyingHeight = 4e-9; }));
    QCOMPARE(saveHdf5(model.record(1), file), QString());
    model.setFile(2, file);
    QVERIFY(model.record(1).identity.has_value());
    QVERIFY(!saveHdf5(model.record(0), copy).isEmpty());
    QVERIFY(!QFile::exists(copy));
}

void TestRunsPanel::saysWhyAFileCannotBeOpened()
{
    const QTemporaryDir folder;
    QString problem;
    QVERIFY(!recordFromFile(1, folder.filePath(QStringLiteral("missing.h5")), problem));
    QVERIFY2(problem.contains(QStringLiteral("missing.h5")), qPrintable(problem));
    QFile noise(folder.filePath(QStringLiteral("noise.h5")));
    QVERIFY(noise.open(QIODevice::WriteOnly));
    noise.write("not HDF5");
    noise.close();
    problem.clear();
    QVERIFY(!recordFromFile(1, noise.fileName(), problem));
    QVERIFY2(problem.contains(QStringLiteral("noise.h5")), qPrintable(problem));
}

void TestRunsPanel::savesALongRunWhole()
{
    RunRecord record(1, Case{}, {}, {{"flying_height", "m", "nm", "Flying height"}});
    constexpr std::size_t count = 3 * SampleColumn::pieceSize + 11; // several parts
    SampleBatch batch;
    batch.columns.resize(1);
    for (std::size_t k = 0; k < count; ++k) {
        batch.time.push_back(static_cast<double>(k) * 1e-9);
        batch.columns[0].push_back(std::sin(static_cast<double>(k)));
    }
    record.append(batch, {});
    record.finish({});
    QCOMPARE(record.sampleCount(), count);
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("run.h5")), table = folder.filePath(QStringLiteral("run.csv"));
    QCOMPARE(saveHdf5(record, file), QString());
    const StoredRun stored = readResults(file.toStdString());
    QCOMPARE(stored.samples.time, batch.time);
    QCOMPARE(stored.samples.columns, batch.columns);
    QCOMPARE(saveTimeSeries(record, table), QString());
    QFile read(table);
    QVERIFY(read.open(QIODevice::ReadOnly));
    QCOMPARE(read.readAll().count('\n'), static_cast<qsizetype>(count + 1));
}

TOUCHDOWN_TEST(TestRunsPanel)

} // namespace test_runs_panel

#include "test_runs_panel.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page of studies in the window, with studies that are made up.
#include <atomic>
#include <functional>
#include <stdexcept>
#include <thread>

#include <QDockWidget>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTextBrowser>
#include <QtTest>

#include "core/case_files/case_file.h"
#include "core/case_files/case_text.h"
#include "core/simulation/run.h"
#include "tests/support/test_program.h"
#include "tests/ui/question.h"
#include "tests/ui/sample_study.h"
#include "tests/ui/window_fixture.h"
#include "ui/calculation/progress_strip.h"
#include "ui/case/case_edits.h"
#include "ui/case/case_files.h"
#include "ui/case/case_panel.h"
#include "ui/plot/plot_export.h"
#include "ui/plot/plot_group.h"
#include "ui/runs/run_view.h"
#include "ui/runs/run_window.h"
#include "ui/studies/study_chart_view.h"
#include "ui/studies/study_editor.h"
#include "ui/studies/study_pilot.h"
#include "ui/studies/study_results.h"
#include "ui/studies/study_table.h"
#include "ui/studies/study_window.h"
#include "ui/style/message_strip.h"
#include "ui/style/theme.h"
#include "ui/window/main_window.h"
#include "ui/window/window_actions.h"

using namespace touchdown;

namespace test_study_page {

using Page = MainWindow::Page;
using State = StudyController::State;

/// Until it is stopped: a report with its first chart so far.
StudyReport endless(const StudyCallback& callback)
{
    StudyReport report = sampleReport();
    report.charts.resize(1);
    const StudyReport* show = &report;
    while (callback({0.25, "rk4, 10 ns", std::exchange(show, nullptr)})) std::this_thread::yield();
    report.status = StudyStatus::Cancelled;
    return report;
}

/// The text decides: "endless" goes on, "broken" ends with an error, "wrong" on a line is a problem of it.
StudyPlan planned(const std::string& kind, const std::string& text, const std::string& name,
                  const std::filesystem::path&, const Case& c)
{
    StudyPlan plan;
    plan.kind = kind;
    plan.name = name;
    plan.text = text;
    plan.start.value = c;
    plan.start.text = formatCase(c);
    int line = 1;
    for (const char letter : text.substr(0, text.find("wrong"))) line += letter == '\n';
    if (text.find("wrong") != std::string::npos)
        plan.problems.push_back({name, line, "steps", "is wrong"});
    else if (text.find("endless") != std::string::npos)
        plan.perform = [](int, const StudyCallback& callback) { return endless(callback); };
    else if (text.find("broken") != std::string::npos)
        plan.perform = [](int, const StudyCallback&) -> StudyReport { throw std::runtime_error("broken"); };
    else
        plan.perform = [kind, c](int, const StudyCallback& callback) {
            callback({1.0, "all", nullptr});
            StudyReport report = sampleReport();
            report.kind = kind;
            if (kind == "advise") {
                report.found = c;
                report.found->springs.flyingHeight = 5e-9;
            }
            return report;
        };
    return plan;
}

StudyCatalogue madeUp()
{
    return {{{"work-precision", "Accuracy against speed", "charts errors against times", nullptr, nullptr},
             {"advise", "No more model than needed", "finds the cheapest", nullptr, nullptr}},
            {{"drop", "work-precision", "A drop", "# of the sample\n"}},
            [](const std::string& kind, const Case& c) { return "kind = \"" + kind + "\"\n# " + c.title + "\n"; },
            planned};
}

struct Fixture : test::WindowFixture {
    Fixture() : WindowFixture("fig10a", madeUp()) { window.setPage(Page::Studies); }
    StudyEditor& editor() { return *window.studies().editor(); }
    StudyResults& results() { return *window.studies().results(); }
    QString findings() { return results().findChild<QTextBrowser*>()->toPlainText(); }
    QPushButton* apply() { return results().findChild<QPushButton*>(); }
    qsizetype charts() { return results().findChildren<StudyChartView*>().size(); }
    void perform()
    {
        toEnd([this] {
            window.performStudy();
            if (question(window, "unsavedReport")) answer(window, "unsavedReport", QStringLiteral("Replace"));
        });
    }
};

class TestStudyPage : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init() { QSettings().clear(); }
    void beginsWithAWordAndTheDefaults();
    void showsAReport();
    void showsWhatThereIsWhileUnderWay();
    void saysHowLongAStudyTakes();
    void estimatesNothingBesideACalculation();
    void saysNothingOfAStudyThatFails();
    void saysWhatIsUnderWayAfterPerformAgain();
    void saysWhereThatCannotBeTold();
    void asksBeforeAnUnsavedReportIsReplaced();
    void asksBeforeAStudyUnderWayBeginsAgain();
    void asksBeforeAnotherStudyStopsTheOneUnderWay();
    void stops();
    void saysWhatIsWrongWhileItIsWritten();
    void keepsTheTextAndTheReportOfEachKind();
    void anUntouchedTextFollowsTheCase();
    void saysWhenTheCaseHasChanged();
    void appliesWhatWasFound();
    void opensAndSavesTexts();
    void exportsTheCharts();
    void hasItsPane();
    void namesEveryControl();
    void fitsASmallScreen();
    void offersTheStudiesOfTheCore();
};

void TestStudyPage::initTestCase()
{
    QCoreApplication::setOrganizationName(QStringLiteral("touchdown"));
    QCoreApplication::setApplicationName(QStringLiteral("test_study_page"));
    QLocale::setDefault(QLocale::c());
    applyTheme(Theme::Light);
}

void TestStudyPage::beginsWithAWordAndTheDefaults()
{
    Fixture f;
    QVERIFY(f.results().isEmpty() && f.results().isVisible());
    QTRY_VERIFY(f.editor().toText().startsWith(QStringLiteral("kind = \"work-precision\"")));
    QVERIFY(f.editor().toText().contains(QString::fromStdString(f.window.edits().value().title)));
    QVERIFY(f.editor().run()->isEnabled() && !f.editor().stop()->isEnabled());
}

void TestStudyPage::showsAReport()
{
    Fixture f;
    f.perform();
    QVERIFY(!f.results().isEmpty());
    QCOMPARE(f.charts(), 3);
    QCOMPARE(f.results().findChildren<ResultTable*>().size(), 1);
    const QList<QTabBar*> tabs = f.results().findChildren<QTabBar*>();
    const auto ofFacts = std::ranges::find(tabs, QStringLiteral("Findings and tables"), &QTabBar::accessibleName);
    const auto ofCharts = std::ranges::find(tabs, QStringLiteral("Charts of the study"), &QTabBar::accessibleName);
    QVERIFY(ofFacts != tabs.end() && ofCharts != tabs.end());
    QCOMPARE((*ofCharts)->count(), 3);
    QCOMPARE((*ofFacts)->tabText(1), QStringLiteral("Runs"));
    QVERIFY(f.findings().contains(QStringLiteral("40 times faster")));
    QVERIFY(f.findings().contains(QStringLiteral("⚠")));
    QVERIFY(!f.apply()->isVisible());
    QCOMPARE(f.window.messages().kind(), MessageStrip::Kind::Warning); // the report has one
    QVERIFY(f.window.studies().progress()->text().contains(QStringLiteral("1.500\u00a0s")));
}

void TestStudyPage::showsWhatThereIsWhileUnderWay()
{
    Fixture f;
    f.editor().setText(QStringLiteral("endless"));
    f.window.actions().study->trigger();
    QTRY_COMPARE(f.charts(), 1);
    QTRY_VERIFY(f.window.studies().progress()->text().startsWith(QStringLiteral("25 % · rk4, 10 ns")));
    QVERIFY(f.window.actions().stop->isEnabled() && f.editor().stop()->isEnabled());
    f.editor().setKind(QStringLiteral("advise")); // nothing is known of that one
    QVERIFY(f.results().isEmpty());
    f.editor().setKind(QStringLiteral("work-precision"));
    QVERIFY(!f.results().isEmpty());
    f.window.actions().stop->trigger();
    QTRY_COMPARE(f.window.studies().controller().state(), State::Idle);
}

/// A clock that goes on by a quarter of a second whenever it is read.
std::function<double()> quarters()
{
    return [now = 0.0]() mutable { return now += 0.25; };
}

/// The endless one is at a quarter at once: after the first reading beyond a second, five are expected.
void TestStudyPage::saysHowLongAStudyTakes()
{
    Fixture f;
    f.window.studies().pilot().setClock(quarters());
    QTRY_COMPARE(f.editor().duration(), QStringLiteral("Takes less than 1 s."));
    f.editor().setText(QStringLiteral("wrong"));
    QTRY_COMPARE(f.editor().duration(), QString());
    f.editor().setText(QStringLiteral("endless"));
    QTRY_COMPARE(f.editor().duration(), QStringLiteral("Takes about 5 s."));
    QCOMPARE(f.charts(), 0); // nothing of the pilot is shown
    f.window.actions().study->trigger();
    QCOMPARE(f.editor().duration(), QString());
    f.window.actions().stop->trigger();
    QTRY_COMPARE(f.editor().duration(), QStringLiteral("Takes about 5 s.")); // still known
    f.editor().setText(QStringLiteral("another"));
    f.perform();
    QCOMPARE(f.editor().duration(), QStringLiteral("Took 1.500\u00a0s.")); // as its report says
}

/// Nor does it run where nobody looks.
void TestStudyPage::estimatesNothingBesideACalculation()
{
    Fixture f;
    StudyPilot& pilot = f.window.studies().pilot();
    pilot.setClock([] { return 0.0; }); // never enough
    const QString estimating = QStringLiteral("Estimating the time…");
    f.editor().setText(QStringLiteral("endless"));
    QTRY_COMPARE(f.editor().duration(), estimating);
    QVERIFY(pilot.active());
    f.window.setPage(Page::Run);
    QTRY_VERIFY(!pilot.active());
    f.window.setPage(Page::Studies);
    QTRY_COMPARE(f.editor().duration(), estimating);
    f.window.studies().setOthersBusy(true);
    QTRY_VERIFY(!pilot.active());
    QCOMPARE(f.editor().duration(), QString());
    f.window.studies().setOthersBusy(false);
    QTRY_COMPARE(f.editor().duration(), estimating);
    f.window.startRun();
    QVERIFY(pilot.state() != State::Running);
}

/// An error of the study is said by the study.
void TestStudyPage::saysNothingOfAStudyThatFails()
{
    Fixture f;
    const QSignalSpy failed(&f.window.studies().pilot(), &StudyPilot::failed);
    f.editor().setText(QStringLiteral("broken"));
    QTRY_COMPARE(failed.count(), 1);
    QCOMPARE(f.editor().duration(), QString());
}

void TestStudyPage::saysWhatIsUnderWayAfterPerformAgain()
{
    Fixture f;
    f.editor().setText(QStringLiteral("endless"));
    f.window.performStudy();
    QCOMPARE(f.editor().run()->text(), QStringLiteral("Perform again"));
    f.editor().setKind(QStringLiteral("advise"));
    QCOMPARE(f.editor().run()->text(), QStringLiteral("Perform"));
    QVERIFY(f.editor().stop()->isEnabled());
    f.editor().setKind(QStringLiteral("work-precision"));
    QCOMPARE(f.editor().run()->text(), QStringLiteral("Perform again"));
    f.window.performStudy();
    QCOMPARE(f.window.studies().controller().state(), State::Running);
    QCOMPARE(f.window.messages().text(), QString()); // not that the first one was stopped
    f.editor().setText(QStringLiteral("wrong"));
    f.window.performStudy();
    QCOMPARE(f.window.studies().controller().state(), State::Running); // goes on beside the errors
}

void TestStudyPage::saysWhereThatCannotBeTold()
{
    StudyCatalogue catalogue = madeUp();
    catalogue.plan = [](const std::string& kind, const std::string& text, const std::string& name,
                        const std::filesystem::path& folder, const Case& c) {
        StudyPlan plan = planned(kind, text, name, folder, c);
        plan.openEnd = "the search ends when its targets are reached";
        return plan;
    };
    MainWindow window(std::move(catalogue));
    window.show();
    window.files().openNow(QStringLiteral("fig10a"));
    window.setPage(Page::Studies);
    QTRY_COMPARE(window.studies().editor()->duration(),
                 QStringLiteral("How long it takes cannot be told: the search ends when its targets are reached."));
}

void TestStudyPage::asksBeforeAnUnsavedReportIsReplaced()
{
    const QTemporaryDir folder;
    Fixture f;
    const auto number = [&f] { return f.window.studies().outcome("work-precision")->number; };
    f.perform();
    const int former = number();
    f.window.performStudy();
    QVERIFY(question(f.window, "unsavedReport"));
    answer(f.window, "unsavedReport", QStringLiteral("Cancel"));
    QVERIFY(!f.window.studies().controller().active());
    QCOMPARE(number(), former);
    QVERIFY(f.findings().contains(QStringLiteral("40 times faster")));
    // A report that is in a file may be replaced, and one of another kind stays.
    QCOMPARE(f.window.studies().save("work-precision", folder.filePath(QStringLiteral("mine.h5"))), QString());
    f.window.performStudy();
    QVERIFY(!question(f.window, "unsavedReport"));
    QTRY_VERIFY(!f.window.studies().controller().active());
    f.editor().setKind(QStringLiteral("advise"));
    f.window.performStudy();
    QVERIFY(!question(f.window, "unsavedReport"));
    QTRY_VERIFY(!f.window.studies().controller().active());
    QVERIFY(f.window.studies().unsaved("work-precision"));
}

void TestStudyPage::asksBeforeAStudyUnderWayBeginsAgain()
{
    Fixture f;
    f.editor().setText(QStringLiteral("endless"));
    f.window.performStudy();
    QTRY_COMPARE(f.charts(), 1);
    f.window.performStudy();
    QVERIFY(question(f.window, "unsavedReport"));
    answer(f.window, "unsavedReport", QStringLiteral("Cancel"));
    QCOMPARE(f.window.studies().outcome("work-precision")->number, 1);
    QCOMPARE(f.window.studies().controller().state(), State::Running);
}

void TestStudyPage::asksBeforeAnotherStudyStopsTheOneUnderWay()
{
    Fixture f;
    f.editor().setText(QStringLiteral("endless"));
    f.window.performStudy();
    QTRY_COMPARE(f.charts(), 1);
    f.editor().setKind(QStringLiteral("advise"));
    f.window.performStudy();
    f.window.performStudy(); // one question, however often it is asked for
    int open = 0;
    for (const QMessageBox* box : f.window.findChildren<QMessageBox*>()) open += box->isVisible() ? 1 : 0;
    QCOMPARE(open, 1);
    answer(f.window, "studyUnderWay", QStringLiteral("Cancel"));
    QCOMPARE(f.window.studies().kindUnderWay(), QStringLiteral("work-precision"));
    f.window.performStudy();
    answer(f.window, "studyUnderWay", QStringLiteral("Stop it"));
    QTRY_VERIFY(f.window.studies().outcome("advise"));
    QVERIFY(!f.window.studies().underWay("work-precision"));
}

void TestStudyPage::stops()
{
    Fixture f;
    f.editor().setText(QStringLiteral("endless"));
    const QSignalSpy ended(&f.window, &MainWindow::calculationEnded);
    f.window.performStudy();
    QTRY_COMPARE(f.window.studies().controller().state(), State::Running);
    QTest::mouseClick(f.editor().stop(), Qt::LeftButton);
    QTRY_COMPARE(ended.count(), 1);
    QCOMPARE(ended[0][0].toBool(), false);
    QCOMPARE(f.window.messages().kind(), MessageStrip::Kind::Information);
    QVERIFY(f.findings().contains(QStringLiteral("Stopped")));
}

void TestStudyPage::saysWhatIsWrongWhileItIsWritten()
{
    Fixture f;
    f.editor().setText(QStringLiteral("a = 1\nb = 2\nwrong\n"));
    QTRY_VERIFY(f.editor().problems().contains(QStringLiteral("line 3")));
    QVERIFY(!f.editor().run()->isEnabled());
    QCOMPARE(f.editor().findChild<QPlainTextEdit*>()->extraSelections().size(), 1);
    f.window.performStudy();
    QCOMPARE(f.window.studies().controller().state(), State::Idle);
    QCOMPARE(f.window.messages().kind(), MessageStrip::Kind::Failure);
    f.editor().setText(QStringLiteral("a = 1\n"));
    QTRY_VERIFY(f.editor().run()->isEnabled() && f.editor().problems().isEmpty());
}

void TestStudyPage::keepsTheTextAndTheReportOfEachKind()
{
    Fixture f;
    f.editor().setText(QStringLiteral("# mine\n"));
    f.perform();
    f.editor().setKind(QStringLiteral("advise"));
    QVERIFY(f.editor().toText().contains(QStringLiteral("advise")) && f.results().isEmpty());
    f.editor().setKind(QStringLiteral("work-precision"));
    QCOMPARE(f.editor().toText(), QStringLiteral("# mine\n"));
    QVERIFY(!f.results().isEmpty());
}

void TestStudyPage::anUntouchedTextFollowsTheCase()
{
    Fixture f;
    f.window.files().openNow(QStringLiteral("fig10b"));
    QVERIFY(f.results().isVisible()); // still the page of studies
    const QString title = QString::fromStdString(f.window.edits().value().title);
    QTRY_VERIFY(f.editor().toText().contains(title));
    f.editor().setText(f.editor().toText() + QStringLiteral("# mine\n"));
    f.window.files().openNow(QStringLiteral("fig10a"));
    f.editor().plan();
    QVERIFY(f.editor().toText().contains(title));
}

void TestStudyPage::saysWhenTheCaseHasChanged()
{
    Fixture f;
    const auto* mark = f.results().findChild<QLabel*>(QStringLiteral("stale"));
    f.perform();
    QVERIFY(mark && !mark->isVisible());
    f.window.edits().enter(*findParameter("springs.flying_height"), QStringLiteral("6"));
    QTRY_VERIFY(mark->isVisible());
    f.window.actions().undo->trigger();
    QTRY_VERIFY(!mark->isVisible());
}

void TestStudyPage::appliesWhatWasFound()
{
    Fixture f;
    f.editor().setKind(QStringLiteral("advise"));
    f.perform();
    QVERIFY(f.apply()->isVisible());
    QTest::mouseClick(f.apply(), Qt::LeftButton);
    QCOMPARE(f.window.edits().value().springs.flyingHeight, 7e-9); // asks first, and says what will change
    auto* box = f.window.findChild<QMessageBox*>(QStringLiteral("applyQuestion"));
    QVERIFY(box != nullptr && box->isVisible());
    QVERIFY2(box->informativeText().contains(QStringLiteral("7\u00A0nm → 5\u00A0nm")),
             qPrintable(box->informativeText()));
    QTest::mouseClick(box->defaultButton(), Qt::LeftButton);
    QCOMPARE(f.window.edits().value().springs.flyingHeight, 5e-9);
    f.window.actions().undo->trigger();
    QCOMPARE(f.window.edits().value().springs.flyingHeight, 7e-9);
}

void TestStudyPage::opensAndSavesTexts()
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("mine.toml"));
    Fixture f;
    f.editor().setKind(QStringLiteral("advise"));
    f.editor().setText(QStringLiteral("kind = \"advise\"\n# mine\n"));
    QCOMPARE(f.editor().save(file), QString());
    f.editor().setKind(QStringLiteral("work-precision"));
    QCOMPARE(f.editor().open(file), QString());
    QCOMPARE(f.editor().kind(), QStringLiteral("advise")); // as the file says
    QCOMPARE(f.editor().toText(), QStringLiteral("kind = \"advise\"\n# mine\n"));
    QCOMPARE(QString::fromStdString(f.editor().plan().name), QStringLiteral("mine.toml"));
    QVERIFY(f.editor().open(folder.filePath(QStringLiteral("none.toml"))).contains(QStringLiteral("none.toml")));
}

void TestStudyPage::exportsTheCharts()
{
    const QTemporaryDir folder;
    Fixture f;
    f.perform();
    for (const char* ending : {"png", "svg", "pdf"}) {
        const QString file = folder.filePath(QStringLiteral("page.%1").arg(QLatin1String(ending)));
        QCOMPARE(savePicture(*f.window.page(), file), QString());
        QVERIFY(QFileInfo(file).size() > 1000);
    }
}

void TestStudyPage::hasItsPane()
{
    Fixture f;
    QVERIFY(f.dock("study")->isVisible() && !f.dock("runs")->isVisible() && !f.dock("about")->isVisible());
    f.dock("study")->close();
    f.window.setPage(Page::Run);
    QVERIFY(!f.dock("study")->isVisible() && f.dock("runs")->isVisible() && f.dock("about")->isVisible());
    f.window.setPage(Page::Studies);
    QVERIFY(!f.dock("study")->isVisible()); // it was closed
    f.dock("study")->toggleViewAction()->trigger();
    QVERIFY(f.dock("study")->isVisible());
    f.window.startRun(); // its curves are to be seen
    QTRY_VERIFY(f.window.runView().isVisible());
}

void TestStudyPage::namesEveryControl()
{
    Fixture f;
    f.perform();
    for (const QWidget* part : {static_cast<QWidget*>(&f.results()), static_cast<QWidget*>(&f.editor())})
        for (const QWidget* widget : part->findChildren<QWidget*>()) {
            if (!widget->isVisibleTo(&f.window) || !(widget->focusPolicy() & Qt::TabFocus) ||
                widget->inherits("QScrollBar") || widget->objectName().startsWith(QLatin1String("qt_")))
                continue;
            QVERIFY2(!widget->accessibleName().isEmpty(), widget->metaObject()->className());
        }
}

void TestStudyPage::fitsASmallScreen()
{
    Fixture f;
    f.perform();
    QVERIFY2(f.window.minimumSizeHint().width() <= 1280,
             qPrintable(QString::number(f.window.minimumSizeHint().width())));
    QVERIFY2(f.window.minimumSizeHint().height() <= 800,
             qPrintable(QString::number(f.window.minimumSizeHint().height())));
}

void TestStudyPage::offersTheStudiesOfTheCore()
{
    MainWindow window;
    window.files().openNow(QStringLiteral("fig10a"));
    const QComboBox* kinds = window.studies().editor()->kinds();
    QCOMPARE(static_cast<std::size_t>(kinds->count()), studyKinds().size());
    for (const StudyKind& kind : studyKinds()) QVERIFY(kinds->findData(QString::fromStdString(kind.name)) >= 0);
}

TOUCHDOWN_TEST(TestStudyPage)

} // namespace test_study_page

#include "test_study_page.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guides/guides.h"

#include <memory>

#include <QMessageBox>
#include <QSettings>
#include <QSignalSpy>
#include <QtTest>

#include "tests/support/test_program.h"
#include "tests/ui/fake_workbench.h"
#include "tests/ui/named_widget.h"
#include "tests/ui/question.h"
#include "ui/guides/live_runs.h"
#include "ui/guides/live_values.h"
#include "ui/guides/marked_slider.h"

using namespace touchdown;

namespace test_guides {

constexpr int longest = 60000; // for what takes some milliseconds on an idle machine [ms]
const LessonRun caught{"Menisci up to 8 nm, and 4 nm.", "fig13a", "", {{"springs.flying_height", "4 nm"}}};

/// Without a window: what the guides ask of a workbench.
class TestGuides : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QCoreApplication::setOrganizationName(QStringLiteral("touchdown"));
        QCoreApplication::setApplicationName(QStringLiteral("test_guides"));
    }
    void init()
    {
        QSettings().clear();
        bench_ = std::make_unique<test::FakeWorkbench>();
        guides_ = std::make_unique<Guides>(*bench_, bench_->window());
    }
    void cleanup()
    {
        guides_.reset();
        bench_.reset();
    }

    /// One pane is wanted at a time, and the page of runs.
    void opensOnePane()
    {
        const QSignalSpy wanted(guides_.get(), &Guides::paneWanted), left(guides_.get(), &Guides::paneLeft);
        bench_->setPage(Workbench::Page::Studies);
        guides_->open(LessonPane::Kind::Lesson);
        QCOMPARE(wanted.count(), 1);
        QCOMPARE(wanted[0][1].toString(), QStringLiteral("lesson"));
        QCOMPARE(bench_->shownPage(), Workbench::Page::Run);
        QVERIFY(guides_->staged() && left.isEmpty());
        guides_->open(LessonPane::Kind::Demonstrations);
        QCOMPARE(wanted[1][1].toString(), QStringLiteral("demonstrations"));
        QCOMPARE(left.count(), 1);
        QCOMPARE(left[0][0].value<QWidget*>(), guides_->pane(LessonPane::Kind::Lesson));
        QCOMPARE(guides_->shown(), guides_->pane(LessonPane::Kind::Demonstrations));
    }

    /// A demonstration on springs is there at once, and follows its slider.
    void aDemonstrationFollowsItsSlider()
    {
        QSettings().setValue("demonstrations/step", 5); // Fig. 10
        const QSignalSpy ended(&bench_->runWindow(), &RunWindow::ended);
        RunsModel& runs = bench_->runs();
        guides_->open(LessonPane::Kind::Demonstrations);
        QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, longest);
        QCOMPARE(bench_->files().sample(), QString("fig10a"));
        QCOMPARE(runs.count(), 1);
        LessonPane* pane = guides_->pane(LessonPane::Kind::Demonstrations);
        auto* slider = static_cast<MarkedSlider*>(pane->live().inputs().at(0));
        QTest::keyClick(slider, Qt::Key_Right);
        QTRY_COMPARE_WITH_TIMEOUT(runs.count(), 2, longest); // the run of the figure stays
        QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 2, longest);
        QCOMPARE(runs.record(1).value.initial.flyingHeight, bench_->edits().value().initial.flyingHeight);
        QVERIFY(bench_->edits().value().initial.flyingHeight > 250e-9);
        QVERIFY(runs.record(0).shown && runs.record(1).shown);
        // The next figure owns its stage, and asks nothing.
        namedWidget<QPushButton>(*pane, "Next")->click();
        QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 3, longest);
        QCOMPARE(bench_->files().sample(), QString("fig11a"));
        QVERIFY(!runs.record(0).shown && runs.record(2).shown);
        // Back: its case and its runs are there again, and nothing runs.
        namedWidget<QPushButton>(*pane, "Back")->click();
        QCOMPARE(bench_->files().sample(), QString("fig10a"));
        QVERIFY(runs.record(0).shown && runs.record(1).shown && !runs.record(2).shown);
        QVERIFY(!bench_->controller().active());
        // The values stand where they were moved to, as the run does that speaks.
        QVERIFY(bench_->edits().value() == runs.record(1).value);
        QVERIFY(bench_->edits().value().initial.flyingHeight > 250e-9);
        QCOMPARE(runs.speaker(), runs.record(1).number);
        // A case of the reader's own has no values of the figure.
        bench_->files().openNow("fig13a");
        QVERIFY(!pane->live().inputs()[0]->isEnabled());
        namedWidget<QPushButton>(*pane, "Next")->click();
        QVERIFY(pane->live().inputs()[0]->isEnabled());
        // The lesson takes its place.
        guides_->open(LessonPane::Kind::Lesson);
        QVERIFY(bench_->runView().stage());
        QVERIFY(!runs.record(2).shown);
    }

    /// Undo takes the slider back, and the plots follow: to a run that is there, else to a new one of the last value.
    /// A case that is opened then runs nothing.
    void undoIsFollowed()
    {
        QSettings().setValue("demonstrations/step", 5); // Fig. 10
        const QSignalSpy ended(&bench_->runWindow(), &RunWindow::ended);
        RunsModel& runs = bench_->runs();
        guides_->open(LessonPane::Kind::Demonstrations);
        auto* slider = static_cast<MarkedSlider*>(guides_->pane(LessonPane::Kind::Demonstrations)->live().inputs()[0]);
        QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, longest);
        std::vector<double> heights{250e-9};
        for (int i = 2; i <= 4; ++i) {
            QTest::keyClick(slider, Qt::Key_Right);
            QTRY_COMPARE_WITH_TIMEOUT(ended.count(), i, longest);
            heights.push_back(bench_->edits().value().initial.flyingHeight);
        }
        const auto heightOf = [&runs](int number) { return runs.find(number)->value.initial.flyingHeight; };
        QCOMPARE(heightOf(runs.speaker()), heights[3]);
        bench_->edits().undoStack().undo();
        QCOMPARE(heightOf(runs.speaker()), heights[2]);
        bench_->edits().undoStack().redo();
        QCOMPARE(heightOf(runs.speaker()), heights[3]);
        runs.remove(2);
        runs.remove(1);
        bench_->edits().undoStack().undo(); // as by a key that is held
        bench_->edits().undoStack().undo();
        QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 5, longest);
        QCOMPARE(runs.count(), 3);
        QCOMPARE(heightOf(runs.speaker()), heights[1]);
        QCOMPARE(bench_->edits().value().initial.flyingHeight, heights[1]);
        bench_->files().openNow("fig13a");
        QCoreApplication::processEvents();
        QVERIFY(!bench_->controller().active() && !guides_->live().busy());
        QCOMPARE(runs.count(), 3);
    }

    /// Before the reader lets go: the value that was undone is not run.
    void undoEndsAMovement()
    {
        QSettings().setValue("demonstrations/step", 5); // Fig. 10
        const QSignalSpy ended(&bench_->runWindow(), &RunWindow::ended);
        RunsModel& runs = bench_->runs();
        guides_->open(LessonPane::Kind::Demonstrations);
        QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, longest);
        const LiveValues& values = guides_->pane(LessonPane::Kind::Demonstrations)->live();
        guides_->live().move(guides_->shown()->shown().live.front(), "300 nm");
        bench_->edits().undoStack().undo();
        QCOMPARE(bench_->edits().value().initial.flyingHeight, 250e-9);
        guides_->live().settle();
        QTRY_VERIFY_WITH_TIMEOUT(!guides_->live().busy(), longest);
        QCoreApplication::processEvents();
        QCOMPARE(runs.record(runs.count() - 1).value.initial.flyingHeight, 250e-9);
        QVERIFY(values.isEnabled());
    }

    /// The reader keeps an own case: page and plots stay as they are, and the values of the figure cannot be moved.
    void aCaseThatIsKeptChangesNothing()
    {
        QSettings().setValue("demonstrations/step", 5); // Fig. 10
        bench_->window().show();
        bench_->setPage(Workbench::Page::Studies);
        bench_->edits().enter(*findParameter("springs.flying_height"), QStringLiteral("5"));
        guides_->open(LessonPane::Kind::Demonstrations);
        QVERIFY(question(bench_->window(), "unsavedChanges"));
        const auto unchanged = [this] {
            LessonPane* pane = guides_->pane(LessonPane::Kind::Demonstrations);
            return bench_->shownPage() == Workbench::Page::Studies && !guides_->staged() &&
                   !bench_->runView().stage() && !pane->live().isEnabled() &&
                   bench_->edits().value().springs.flyingHeight == 5e-9;
        };
        QVERIFY(unchanged());
        answer(bench_->window(), "unsavedChanges", QStringLiteral("Cancel"));
        QVERIFY(unchanged());
        guides_->open(LessonPane::Kind::Demonstrations); // asks again
        answer(bench_->window(), "unsavedChanges", QStringLiteral("Discard"));
        QCOMPARE(bench_->shownPage(), Workbench::Page::Run);
        QVERIFY(guides_->staged() && bench_->runView().stage());
        QVERIFY(guides_->pane(LessonPane::Kind::Demonstrations)->live().isEnabled());
    }

    /// A film does not start by itself: it takes its time.
    void aFilmWaitsForItsButton()
    {
        QSettings().setValue("demonstrations/step", 1); // Fig. 5
        guides_->open(LessonPane::Kind::Demonstrations);
        QVERIFY(!bench_->controller().active());
        QCOMPARE(bench_->files().sample(), QString("fig05_fm_3_62mN"));
        const LessonPane* pane = guides_->shown();
        QVERIFY(pane && !pane->shown().live.empty());
    }

    void runsACaseWithItsSettings()
    {
        const QSignalSpy ended(&bench_->runWindow(), &RunWindow::ended);
        guides_->perform(caught);
        QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, longest);
        QCOMPARE(bench_->files().sample(), QStringLiteral("fig13a"));
        QCOMPARE(bench_->runs().record(0).value.springs.flyingHeight, 4e-9);
        QVERIFY(bench_->edits().anyChanged()); // marked
        QVERIFY(!bench_->files().modified());  // nothing to save
        QVERIFY(bench_->files().text().find("flying_height = \"4 nm\"") != std::string::npos);
        // The next one does not ask about the settings of the last one.
        guides_->perform({"", "fig10a", "", {}});
        QVERIFY(!question(bench_->window(), "unsavedChanges"));
        QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 2, longest);
        QCOMPARE(bench_->files().sample(), QStringLiteral("fig10a"));
    }

    void asksAboutUnsavedChanges()
    {
        const QSignalSpy ended(&bench_->runWindow(), &RunWindow::ended);
        bench_->window().show();
        bench_->edits().enter(*findParameter("springs.flying_height"), QStringLiteral("5"));
        guides_->perform(caught);
        QVERIFY(question(bench_->window(), "unsavedChanges"));
        QVERIFY(!bench_->controller().active());
        QCOMPARE(bench_->files().sample(), QStringLiteral("fig10a"));
        answer(bench_->window(), "unsavedChanges", QStringLiteral("Discard"));
        QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, longest);
        QCOMPARE(bench_->files().sample(), QStringLiteral("fig13a"));
    }

    void performsAStudy()
    {
        guides_->perform({"A study.", "hysteresis_flying_height", "hysteresis", {}});
        QVERIFY(bench_->studies().controller().active());
        QCOMPARE(bench_->studies().editor()->kind(), QStringLiteral("hysteresis"));
        QVERIFY(bench_->studies().editor()->toText().contains(QStringLiteral("springs.flying_height")));
        bench_->studies().controller().stopAndWait();
    }

private:
    std::unique_ptr<test::FakeWorkbench> bench_;
    std::unique_ptr<Guides> guides_;
};

TOUCHDOWN_TEST(TestGuides)

} // namespace test_guides

#include "test_guides.moc"

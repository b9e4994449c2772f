// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guides/guide_strip.h"

#include <memory>

#include <QComboBox>
#include <QSettings>
#include <QSignalSpy>
#include <QtTest>

#include "tests/support/test_program.h"
#include "tests/ui/named_widget.h"
#include "ui/case/case_edits.h"
#include "ui/case/case_files.h"
#include "ui/guides/guides.h"
#include "ui/guides/lesson_pane.h"
#include "ui/guides/live_values.h"
#include "ui/guides/marked_slider.h"
#include "ui/plot/plot_widget.h"
#include "ui/runs/live_plots.h"
#include "ui/runs/run_controller.h"
#include "ui/runs/run_view.h"
#include "ui/runs/runs_model.h"
#include "ui/style/message_strip.h"
#include "ui/window/main_window.h"
#include "ui/window/presenter.h"
#include "ui/window/window_actions.h"

using namespace touchdown;

namespace test_guide_strip {

/// In a lecture.
class TestGuideStrip : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QCoreApplication::setOrganizationName(QStringLiteral("touchdown"));
        QCoreApplication::setApplicationName(QStringLiteral("test_guide_strip"));
    }
    void init()
    {
        QSettings().clear();
        window_ = std::make_unique<MainWindow>();
        window_->resize(1280, 720);
        window_->show();
        QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    }
    void cleanup() { window_.reset(); }

    void isThereInALectureOnly()
    {
        window_->actions().lesson->trigger();
        QVERIFY(!strip().isVisible());
        window_->actions().presenter->trigger();
        QVERIFY(strip().isVisible());
        const auto* window = namedWidget<QComboBox>(window_->runView(), "Window");
        QVERIFY(window && window->parentWidget()->isHidden()); // the choices of the spectrum
        window_->actions().presenter->trigger();
        QVERIFY(!strip().isVisible() && !window->parentWidget()->isHidden());
        // A guide that opens in a lecture is there, too.
        window_ = std::make_unique<MainWindow>();
        window_->show();
        window_->actions().presenter->trigger();
        QVERIFY(!strip().isVisible());
        window_->actions().lesson->trigger();
        QVERIFY(strip().isVisible());
    }

    void asksRunsAndAnswersByKeys()
    {
        window_->actions().lesson->trigger();
        const LessonPane& pane = *window_->guides().pane(LessonPane::Kind::Lesson);
        window_->actions().presenter->trigger();
        QCOMPARE(text("Question or answer"), pane.questionText());
        QCOMPARE(strip().runs().size(), pane.shown().runs.size());
        QVERIFY(strip().runs().size() >= 3);
        QVERIFY(!pane.questionText().isEmpty() && pane.questionText() != pane.answerText());
        press(Qt::Key_A);
        QTRY_COMPARE(text("Question or answer"), pane.answerText());
        press(Qt::Key_A);
        QTRY_COMPARE(text("Question or answer"), pane.questionText());

        QSignalSpy ended(window_.get(), &MainWindow::calculationEnded);
        press(Qt::Key_3);
        QTRY_COMPARE_WITH_TIMEOUT(ended.size(), 1, 30000);
        QCOMPARE(window_->edits().value(), caseOf(pane.shown().runs[2]));
        QCOMPARE(text("What the run shows"), pane.runText(2));
        QVERIFY2(text("What the run shows").contains("ends at"), qPrintable(text("What the run shows")));

        QVERIFY(!window_->messages().isVisible()); // it would say the same again

        // The words of the run stand at its curve, in this step alone.
        PlotWidget* spacing = window_->runView().plots()->plot("spacing");
        QCOMPARE(spacing->pointMarks().size(), std::size_t(1));
        QCOMPARE(spacing->pointMarks()[0].label, QStringLiteral("thrown up to 1.11 µm"));
        QVERIFY(std::abs(spacing->pointMarks()[0].y - 1.1078e-6) < 1e-10);

        // The next step has its own, without the answer.
        press(Qt::Key_A);
        QTRY_COMPARE(text("Question or answer"), pane.answerText());
        press(Qt::Key_PageDown);
        QCOMPARE(pane.step(), std::size_t(1));
        QCOMPARE(text("Question or answer"), pane.questionText());
        QCOMPARE(strip().runs().size(), pane.shown().runs.size());
        QCOMPARE(text("What the run shows"), pane.runText(0));
        QVERIFY(spacing->pointMarks().empty());
        press(Qt::Key_PageUp);
        QCOMPARE(spacing->pointMarks().size(), std::size_t(1));
        window_->files().leaveUnsaved();
        window_->files().openNow("fig12a");
        QVERIFY(spacing->pointMarks().empty());
    }

    /// The run that was chosen last need not have a counterpart in the next step.
    void goesToAStepWithFewerRuns()
    {
        window_->actions().lesson->trigger();
        LessonPane& pane = *window_->guides().pane(LessonPane::Kind::Lesson);
        pane.go(4);
        window_->actions().presenter->trigger();
        const std::size_t last = pane.shown().runs.size() - 1;
        QVERIFY(last >= lessonSteps().at(5).runs.size());
        strip().runs().at(last - 3)->click(); // a case, not a study
        press(Qt::Key_PageDown);
        QCOMPARE(pane.step(), std::size_t(5));
        QCOMPARE(text("What the run shows"), pane.runText(0));
        press(Qt::Key_PageUp);
        QCOMPARE(text("What the run shows"), pane.runText(0));
    }

    void movesTheValuesOfADemonstration()
    {
        QSettings().setValue("demonstrations/step", 5); // Fig. 10
        window_->actions().demonstrations->trigger();
        window_->actions().presenter->trigger();
        LessonPane& pane = *window_->guides().pane(LessonPane::Kind::Demonstrations);
        const LiveValue& value = pane.shown().live.front();
        const Parameter& parameter = *findParameter(value.keys.front());
        QTRY_VERIFY_WITH_TIMEOUT(!window_->controller().active(), 30000);
        QCOMPARE(strip().live().inputs().size(), pane.shown().live.size());
        auto* slider = static_cast<MarkedSlider*>(strip().live().inputs().front());
        QTRY_VERIFY(slider->isVisible() && slider->isEnabled());
        QCOMPARE(slider->share(), static_cast<MarkedSlider*>(pane.live().inputs().front())->share());

        const int before = window_->runs().count();
        slider->setSliderDown(true);
        slider->setSliderPosition(slider->maximum());
        QVERIFY(std::abs(numberOf(parameter, window_->edits().value()) - value.until) <= 1e-3 * value.until);
        QTRY_COMPARE_WITH_TIMEOUT(window_->runs().count(), before + 1, 30000);
        slider->setSliderDown(false);
        // Both stand where the case is.
        QCOMPARE(slider->share(), static_cast<MarkedSlider*>(pane.live().inputs().front())->share());
        // Values of a case of the reader's own are not moved.
        window_->files().leaveUnsaved();
        window_->files().openNow("fig12a");
        QVERIFY(!slider->isEnabled());
    }

    /// Each step, at the least size of a screen.
    void fits()
    {
        window_->actions().lesson->trigger();
        window_->actions().presenter->trigger();
        LessonPane& pane = *window_->guides().pane(LessonPane::Kind::Lesson);
        for (std::size_t step = 0; step < pane.count(); ++step) {
            pane.go(step);
            QCoreApplication::processEvents();
            QVERIFY(strip().minimumSizeHint().width() <= window_->screen()->availableSize().width());
            QVERIFY2(strip().height() <= window_->height() * 2 / 5, qPrintable(QString::number(strip().height())));
        }
    }

private:
    GuideStrip& strip() { return *window_->guides().strip(); }
    void press(Qt::Key key) { QTest::keyClick(window_.get(), key); }
    QString text(const char* name) { return namedWidget<QLabel>(strip(), QString::fromUtf8(name))->text(); }

    std::unique_ptr<MainWindow> window_;
};

TOUCHDOWN_TEST(TestGuideStrip)

} // namespace test_guide_strip

#include "test_guide_strip.moc"

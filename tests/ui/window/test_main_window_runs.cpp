// SPDX-License-Identifier: GPL-3.0-or-later
#include <QComboBox>
#include <QSettings>
#include <QSignalSpy>
#include <QtTest>

#include "core/case_files/case_file.h"
#include "core/simulation/run.h"
#include "tests/support/test_program.h"
#include "tests/ui/named_widget.h"
#include "tests/ui/window_fixture.h"
#include "ui/calculation/progress_strip.h"
#include "ui/case/case_edits.h"
#include "ui/case/case_files.h"
#include "ui/case/case_panel.h"
#include "ui/lists/record_panel.h"
#include "ui/plot/plot_group.h"
#include "ui/plot/spectrum_view.h"
#include "ui/runs/about_case_pane.h"
#include "ui/runs/live_plots.h"
#include "ui/runs/live_spectrum.h"
#include "ui/runs/run_record.h"
#include "ui/runs/run_view.h"
#include "ui/runs/run_window.h"
#include "ui/style/message_strip.h"
#include "ui/window/main_window.h"
#include "ui/window/window_actions.h"

using namespace touchdown;

namespace test_main_window_runs {

using State = RunController::State;

using Fixture = test::WindowFixture;

class TestMainWindowRuns : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init() { QSettings().clear(); }
    void runsTheDefaultCase();
    void runsEverySampleCase_data();
    void runsEverySampleCase();
    void overlaysASecondRun();
    void hidesEarlierRunsWithoutOverlay();
    void keepsTheLastStateOfAFailedRun();
    void stopsASlowRun();
    void pausesAndSteps();
    void runsAgainWhileRunning();
    void warnsWhenTheStepChangesTheEnd();
    void subtractsABaseline();
    void theResultLeavesWithItsCase();
    void takesParametersOfARunBack();
    void deletesARun();
    void showsTheSpectrum();
    void marksReferenceLinesAndEvents();
};

void TestMainWindowRuns::initTestCase()
{
    QCoreApplication::setOrganizationName(QStringLiteral("touchdown"));
    QCoreApplication::setApplicationName(QStringLiteral("test_main_window_runs"));
}

void TestMainWindowRuns::runsTheDefaultCase()
{
    Fixture f;
    const RunRecord& run = f.runToEnd();
    QCOMPARE(run.summary->status, RunStatus::Completed);
    // Every 0.1 us of 2 ms, and the start.
    QCOMPARE(run.sampleCount(), std::size_t(20'001));
    // The static state of the case: 7 nm, 90.6 urad.
    QVERIFY(std::abs(*run.last("flying_height") - 7e-9) < 0.001e-9);
    QVERIFY(std::abs(*run.last("pitch") - 90.6e-6) < 0.01e-6);
    QCOMPARE(f.window.runs().index(0).data(RunsModel::ResultRole).toString(), QStringLiteral("ends at 7.000\u00a0nm"));
    QVERIFY(f.window.messages().text().contains(QStringLiteral("flying height 7.000\u00a0nm")));
    QCOMPARE(f.window.messages().kind(), MessageStrip::Kind::Success);
    QVERIFY(f.window.aboutCase().toPlainText().contains(QStringLiteral("90.60 µrad")));
    QCOMPARE(f.window.runView().plots()->plot(QStringLiteral("spacing"))->curves().size(), std::size_t(1));
    QCOMPARE(f.window.runView().plots()->plot(QStringLiteral("energy"))->curves().size(), std::size_t(5));
    QVERIFY(f.window.runView().plots()->plot(QStringLiteral("roll"))->isHidden()); // the model has none
}

void TestMainWindowRuns::runsEverySampleCase_data()
{
    QTest::addColumn<QString>("name");
    for (const SampleCase& sample : sampleCases())
        if (openCase(sample.name).value.model == ModelKind::Springs)
            QTest::newRow(sample.name.c_str()) << QString::fromStdString(sample.name);
}

void TestMainWindowRuns::runsEverySampleCase()
{
    QFETCH(const QString, name);
    Fixture f(name.toLatin1().constData());
    QCOMPARE(namedWidget<QComboBox>(f.window.casePanel(), QStringLiteral("Sample case"))->currentData().toString(),
             name);
    const RunRecord& record = f.runToEnd();
    // What the window shows is what the core says.
    const Summary alone = run(openCase(name.toStdString()).value);
    QCOMPARE(record.summary->status, alone.status);
    QCOMPARE(record.summary->final, alone.final);
    QCOMPARE(record.events.size(), alone.events.size());
}

void TestMainWindowRuns::overlaysASecondRun()
{
    Fixture f;
    f.runToEnd();
    f.edit("ono_yamane.take_off", QStringLiteral("8"));
    f.runToEnd();
    QCOMPARE(f.window.runs().index(1).data(RunsModel::ChangesRole).toString(),
             QStringLiteral("take-off height 5\u00a0nm → 8\u00a0nm"));
    const std::vector<PlotCurve>& curves = f.window.runView().plots()->plot(QStringLiteral("spacing"))->curves();
    QCOMPARE(curves.size(), std::size_t(2));
    QVERIFY(curves[0].visible && curves[1].visible);
    QVERIFY(curves[0].style.colour != curves[1].style.colour);
    QCOMPARE(curves[1].style.dash, 0);
    QVERIFY(curves[0].pale && !curves[1].pale);
    QCOMPARE(curves[1].name, QStringLiteral("dₑ 8\u00a0nm"));
    f.window.runs().raise(1);
    QVERIFY(!curves[0].pale && curves[1].pale);
    f.window.runs().raise(-1);
    QVERIFY(curves[0].data != curves[1].data);
    f.window.runs().setData(f.window.runs().index(0), Qt::Unchecked, Qt::CheckStateRole);
    QVERIFY(!f.window.runView().plots()->plot(QStringLiteral("spacing"))->curves()[0].visible);
    QVERIFY(f.window.runView().plots()->plot(QStringLiteral("spacing"))->curves()[1].visible);
}

void TestMainWindowRuns::hidesEarlierRunsWithoutOverlay()
{
    Fixture f;
    f.runToEnd();
    f.window.runWindow().panel()->setOverlay(false);
    f.runToEnd();
    QVERIFY(!f.window.runs().record(0).shown);
    QVERIFY(f.window.runs().record(1).shown);
}

void TestMainWindowRuns::keepsTheLastStateOfAFailedRun()
{
    Fixture f("fig12b");
    const RunRecord& run = f.runToEnd();
    QCOMPARE(run.summary->status, RunStatus::Failed);
    QCOMPARE(f.window.messages().kind(), MessageStrip::Kind::Failure);
    QVERIFY2(f.window.messages().text().contains(QStringLiteral("rear air spring is lost")),
             qPrintable(f.window.messages().text()));
    QVERIFY(run.sampleCount() > 1);
    QVERIFY(f.window.runView().plots()->plot(QStringLiteral("spacing"))->curves()[0].data->size() > 1);
    QCOMPARE(f.window.runs().index(0).data(RunsModel::ResultRole).toString(), QStringLiteral("failed"));
    QVERIFY(f.window.actions().run->isEnabled());
}

void TestMainWindowRuns::stopsASlowRun()
{
    Fixture f;
    f.choosePace(1e-5); // 200 s for this run
    f.window.startRun();
    QTRY_VERIFY(f.window.runs().record(0).sampleCount() > 1);
    QVERIFY(f.window.runWindow().progress()->text().contains(QStringLiteral("of 2.000\u00a0ms")));
    QVERIFY(f.window.actions().stop->isEnabled());
    f.window.actions().stop->trigger();
    QTRY_COMPARE(f.window.controller().state(), State::Idle);
    QCOMPARE(f.window.runs().index(0).data(RunsModel::ResultRole).toString(), QStringLiteral("stopped"));
    QVERIFY(!f.window.actions().stop->isEnabled());
}

void TestMainWindowRuns::pausesAndSteps()
{
    Fixture f;
    f.choosePace(1e-5);
    f.window.startRun();
    QVERIFY(!f.window.actions().step->isEnabled());
    f.window.actions().pause->trigger();
    QCOMPARE(f.window.controller().state(), State::Paused);
    QVERIFY(f.window.actions().pause->isChecked());
    QVERIFY(f.window.actions().step->isEnabled());
    f.choosePace(RunController::fullSpeed);
    f.window.actions().step->trigger();
    // 1/200 of 2 ms, every 0.1 us.
    QTRY_VERIFY(f.window.runs().record(0).sampleCount() >= 100);
    QVERIFY(f.window.runs().record(0).sampleCount() < 2000);
    f.window.actions().pause->trigger();
    QTRY_COMPARE(f.window.controller().state(), State::Idle);
    QCOMPARE(f.window.runs().record(0).sampleCount(), std::size_t(20'001));
}

void TestMainWindowRuns::runsAgainWhileRunning()
{
    Fixture f;
    f.choosePace(1e-5);
    f.window.startRun();
    QTRY_VERIFY(f.window.runs().record(0).sampleCount() > 0);
    f.choosePace(RunController::fullSpeed);
    f.choosePace(1e-5);
    f.window.startRun();
    QCOMPARE(f.window.runs().count(), 2);
    QVERIFY(f.window.runs().record(0).finished());
    QVERIFY(!f.window.runs().record(1).finished());
    f.choosePace(RunController::fullSpeed);
    QTRY_VERIFY(f.window.runs().record(1).finished());
    QCOMPARE(f.window.runs().record(1).sampleCount(), std::size_t(20'001));
}

void TestMainWindowRuns::warnsWhenTheStepChangesTheEnd()
{
    Fixture f;
    // The paper's way: a switch is seen once per step. With 0.1 us a step goes far through the contact.
    f.edit("run.integrator", QStringLiteral("rk4"));
    f.edit("run.step", QStringLiteral("100 ns"));
    f.edit("ono_yamane.take_off", QStringLiteral("8"));
    const RunRecord& run = f.runToEnd();
    QVERIFY(run.summary->stepCheck.has_value() || run.summary->status != RunStatus::Completed);
    if (run.summary->stepCheck)
        QVERIFY2(f.window.messages().text().contains(QString::fromStdString(run.summary->stepCheck->message).mid(1)),
                 qPrintable(f.window.messages().text()));
    QVERIFY(f.window.messages().kind() != MessageStrip::Kind::Information);
}

void TestMainWindowRuns::subtractsABaseline()
{
    Fixture f;
    f.runToEnd();
    f.runToEnd();
    f.window.runs().setBaseline(1);
    const std::vector<PlotCurve>& curves = f.window.runView().plots()->plot(QStringLiteral("pitch"))->curves();
    // The baseline itself is no curve; the same run minus itself is zero everywhere.
    QTRY_COMPARE(curves.size(), std::size_t(1));
    const std::optional<PlotRange> extremes = curves[0].data->extremes(0.0, 1.0);
    QVERIFY(extremes);
    QCOMPARE(extremes->low, 0.0);
    QCOMPARE(extremes->high, 0.0);
    QCOMPARE(f.window.runView().plots()->plot(QStringLiteral("pitch"))->title(), QStringLiteral("Pitch minus run 1"));
    f.window.runs().setBaseline(-1);
    QCOMPARE(f.window.runView().plots()->plot(QStringLiteral("pitch"))->title(), QStringLiteral("Pitch"));
    QCOMPARE(f.window.runView().plots()->plot(QStringLiteral("pitch"))->curves().size(), std::size_t(2));
}

/// The results of a case are not those of its next edit.
void TestMainWindowRuns::theResultLeavesWithItsCase()
{
    Fixture f;
    f.runToEnd();
    const auto shown = [&f] { return f.window.aboutCase().toPlainText().contains(QStringLiteral("90.60 µrad")); };
    QVERIFY(shown());
    f.edit("springs.flying_height", QStringLiteral("4"));
    QVERIFY(!shown());
    f.window.actions().undo->trigger();
    QVERIFY(shown());
    f.window.files().openNow(QStringLiteral("fig12a"));
    QVERIFY(!shown());
}

void TestMainWindowRuns::takesParametersOfARunBack()
{
    Fixture f;
    f.runToEnd();
    f.edit("springs.flying_height", QStringLiteral("4"));
    emit f.window.runWindow().panel()->parametersRequested(1);
    QCOMPARE(f.window.edits().value().springs.flyingHeight, 7e-9);
    f.window.actions().undo->trigger();
    QCOMPARE(f.window.edits().value().springs.flyingHeight, 4e-9);
}

void TestMainWindowRuns::deletesARun()
{
    Fixture f;
    f.runToEnd();
    f.runToEnd();
    f.window.runs().remove(0);
    QCOMPARE(f.window.runView().plots()->plot(QStringLiteral("energy"))->curves().size(), std::size_t(5));
    f.window.runs().remove(0);
    QCOMPARE(f.window.runView().plots()->plot(QStringLiteral("energy"))->curves().size(), std::size_t(0));
    QVERIFY(!f.window.actions().saveResults->isEnabled());
}

void TestMainWindowRuns::showsTheSpectrum()
{
    Fixture f;
    const RunRecord& record = f.runToEnd();
    SpectrumView* view = f.window.runView().spectrum()->view();
    QCOMPARE(view->quantity(), QStringLiteral("minimum_spacing"));
    QTRY_COMPARE(view->plot()->curves().size(), std::size_t(1));
    // 0.2 ms of samples every 0.1 us, as the case asks for.
    QCOMPARE(view->options().segment, std::size_t(2000));
    const Spectrum expected = spectrumOf(record, "minimum_spacing", view->options(), 0.0);
    QCOMPARE(expected.segment, std::size_t(2000));
    QCOMPARE(expected.frequency.back(), 5e6); // half the sampling rate
    view->setQuantity(QStringLiteral("pitch"));
    emit view->requested(QStringLiteral("pitch"), view->options());
    QCOMPARE(view->plot()->curves().size(), std::size_t(1));
}

void TestMainWindowRuns::marksReferenceLinesAndEvents()
{
    Fixture f;
    const RunRecord& run = f.runToEnd();
    const PlotWidget* plot = f.window.runView().plots()->plot(QStringLiteral("spacing"));
    QCOMPARE(plot->referenceLines().size(), std::size_t(3)); // d_1, d_s, d_e
    QCOMPARE(plot->referenceLines()[1].value, 3e-9);
    QVERIFY(!run.events.empty());
    QCOMPARE(plot->eventMarks().size(), run.events.size());
}

TOUCHDOWN_TEST(TestMainWindowRuns)

} // namespace test_main_window_runs

#include "test_main_window_runs.moc"

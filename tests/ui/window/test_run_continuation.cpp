// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QSettings>
#include <QtTest>

#include "core/simulation/run.h"
#include "tests/support/test_program.h"
#include "tests/ui/window_fixture.h"
#include "ui/lists/record_panel.h"
#include "ui/runs/run_record.h"
#include "ui/runs/run_window.h"
#include "ui/style/message_strip.h"
#include "ui/window/main_window.h"
#include "ui/window/run_continuation.h"
#include "ui/window/window_actions.h"

using namespace touchdown;

namespace test_run_continuation {

using Fixture = test::WindowFixture;

/// Of all quantities, in the order of time.
std::vector<std::vector<double>> numbersOf(const RunRecord& run)
{
    std::vector<std::vector<double>> all(run.quantities.size() + 1);
    for (std::size_t part = 0; part < run.parts(); ++part) {
        const SampleBatch samples = run.samples(part);
        all[0].insert(all[0].end(), samples.time.begin(), samples.time.end());
        for (std::size_t i = 0; i < samples.columns.size(); ++i)
            all[i + 1].insert(all[i + 1].end(), samples.columns[i].begin(), samples.columns[i].end());
    }
    return all;
}

class TestRunContinuation : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QCoreApplication::setOrganizationName(QStringLiteral("touchdown"));
        QCoreApplication::setApplicationName(QStringLiteral("test_run_continuation"));
    }
    void init() { QSettings().clear(); }

    void aRunBecomesLonger()
    {
        Fixture f;
        f.edit("run.duration", QStringLiteral("1"));
        const int first = f.runToEnd().number;
        f.edit("run.duration", QStringLiteral("2"));
        const RunRecord& whole = f.runToEnd();
        f.window.runWindow().panel()->choose(first);
        QVERIFY(f.window.actions().continueRun->isEnabled());
        f.window.actions().continueRun->trigger();
        QTRY_VERIFY(!f.window.controller().active());
        const RunRecord& continued = f.window.runs().record(f.window.runs().count() - 1);
        QVERIFY(continued.number > whole.number);
        QVERIFY(numbersOf(continued) == numbersOf(whole));
        QCOMPARE(continued.summary->final, whole.summary->final);
        QCOMPARE(continued.events.size(), whole.events.size());
        QCOMPARE(f.window.messages().kind(), MessageStrip::Kind::Success);
    }

    void aCompletedRunSaysWhatItWants()
    {
        Fixture f;
        const int number = f.runToEnd().number;
        f.window.runWindow().panel()->choose(number);
        f.window.actions().continueRun->trigger();
        QCOMPARE(f.window.messages().kind(), MessageStrip::Kind::Failure);
        QVERIFY2(f.window.messages().text().contains(QStringLiteral("longer duration")),
                 qPrintable(f.window.messages().text()));
        QCOMPARE(f.window.runs().count(), 1);
    }

    /// From its file, as after the program was killed.
    void aRunOfAFileContinues()
    {
        Fixture f;
        f.edit("run.duration", QStringLiteral("1"));
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("a.h5"));
        QCOMPARE(saveHdf5(f.runToEnd(), file), QString());
        Case longer = f.window.runs().record(0).value;
        longer.run.duration = 2e-3;
        QString problem;
        const auto read = recordFromFile(7, file, problem);
        QVERIFY2(read, qPrintable(problem));
        const RunContinuation next = continuationOf(*read, longer);
        QCOMPARE(next.problem, QString());
        QVERIFY(next.request.earlier);
        QCOMPARE(next.request.value.run.duration, 2e-3);
        const auto lasts = next.request.earlier->states.back()->at.time;
        QVERIFY(lasts > 0.4e-3 && lasts < 0.9e-3);
        std::size_t samples = 0;
        for (const SampleBatch& part : next.request.earlier->samples) samples += part.size();
        QCOMPARE(samples, next.request.earlier->states.back()->samples);
    }

    void theMenuOffersItOnlyForARun()
    {
        Fixture f;
        QVERIFY(!f.window.actions().continueRun->isEnabled());
        f.runToEnd();
        QVERIFY(f.window.actions().continueRun->isEnabled());
    }
};

} // namespace test_run_continuation

using test_run_continuation::TestRunContinuation;
TOUCHDOWN_TEST(TestRunContinuation)
#include "test_run_continuation.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/about_case_pane.h"

#include <cmath>

#include <QLocale>
#include <QtTest>

#include "core/simulation/recording/run_summary.h"
#include "tests/support/test_program.h"
#include "ui/runs/run_record.h"

using namespace touchdown;

namespace test_about_case_pane {

Summary sampleSummary()
{
    Summary summary;
    summary.figures = {{{"touch_downs", "1", "1", "Touch-downs"}, 6.0, true},
                       {{"cycle_work", "J", "pJ", "Work of a cycle"}, 97.5e-12},
                       {{"surface_skewness", "", "", "Skewness"}, 0.25},
                       {{"linearisations", "1", "1", "Linearisations of the film"}, 640.0, true, true},
                       {{"film_time", "s", "s", "Wall time of the film's steps"}, 0.0125, false, true},
                       {{"force_balance", "1", "1", "Imbalance of the forces"}, 3.25e-9, false, true},
                       {{"position_left", "m", "m", "Distance from the solution"}, 1.5e-13, false, true},
                       {{"pull_off_force_error", "N", "mN", "Error of the pull-off force"}, std::nan("")}};
    return summary;
}

bool always(const Case&) { return true; }

class TestAboutCasePane : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void figures_data()
    {
        QTest::addColumn<int>("index");
        QTest::addColumn<QString>("text");
        const QStringList texts{"6",
                                QStringLiteral("97.500\u00a0pJ"),
                                "0.250",
                                "640",
                                QStringLiteral("12.50\u00a0ms"),
                                QStringLiteral("3.25e\u221209"),
                                QStringLiteral("1.5e\u221213\u00a0m"),
                                "not known"};
        for (int i = 0; i < texts.size(); ++i)
            QTest::newRow(sampleSummary().figures[std::size_t(i)].quantity.name.c_str()) << i << texts[i];
    }
    void figures()
    {
        QFETCH(int, index);
        QFETCH(QString, text);
        QCOMPARE(figureText(sampleSummary().figures[std::size_t(index)]), text);
    }

    /// Swing and standard deviation of one sentence are those of the last tenth.
    void aForcedMotionIsToldOfOneSpan()
    {
        RunRecord run(1, Case{}, "", {}, {});
        Summary summary;
        summary.verdict.motion = Motion::Swings;
        summary.verdict.forced = true;
        summary.verdict.rms = 4e-9;
        summary.tail = {{"minimum_spacing", {.mean = 10e-9, .std = 2e-9, .min = 6e-9, .max = 11e-9}}};
        run.finish(summary);
        QVERIFY(resultText(run).contains(QStringLiteral("Swings by 5.00")));
        QVERIFY(resultText(run).contains(QStringLiteral("vibrate without contact: 2")));
        QVERIFY(!resultText(run).contains(QStringLiteral("kHz")));
        summary.verdict.frequency = 1e5;
        run.finish(summary);
        QVERIFY(resultText(run).contains(QStringLiteral("vibrate without contact: 100")));
    }

    void solverIsFoldedAway()
    {
        const Summary summary = sampleSummary();
        AboutCasePane pane;
        pane.resize(500, 500);
        pane.show();
        pane.setResult(always, QStringLiteral("Ends."), {}, figuresText(summary), solverText(summary));
        QVERIFY(pane.toPlainText().contains(QStringLiteral("Touch-downs: 6\n")));
        QVERIFY(!pane.toPlainText().contains(QStringLiteral("Linearisations")));
        QVERIFY(pane.toPlainText().contains(QStringLiteral("Details of the solver")));

        // By the keyboard, as every link.
        pane.setFocus();
        QTest::keyClick(&pane, Qt::Key_Tab);
        QTest::keyClick(&pane, Qt::Key_Return);
        QVERIFY2(pane.toPlainText().contains(QStringLiteral("Linearisations of the film: 640")),
                 qPrintable(pane.toPlainText()));
        pane.showDetails(false);
        QVERIFY(!pane.toPlainText().contains(QStringLiteral("Linearisations")));
    }

    /// Also in the session's next case, and back by undo.
    void aResultIsShownForItsCaseAlone()
    {
        Case made, other;
        made.title = "Mine";
        other = made;
        other.springs.flyingHeight = 5e-9;
        AboutCasePane pane;
        pane.setCase(made);
        pane.setResult([made](const Case& c) { return c == made; }, QStringLiteral("Ends."), QStringLiteral("At rest"),
                       QStringLiteral("Touch-downs: 6"), QStringLiteral("Steps: 7"));
        for (const QString& text : {QStringLiteral("Ends."), QStringLiteral("At rest"), QStringLiteral("Touch-downs"),
                                    QStringLiteral("Details")}) {
            QVERIFY2(pane.toPlainText().contains(text), qPrintable(text));
            pane.setCase(other);
            QVERIFY2(!pane.toPlainText().contains(text), qPrintable(text));
            pane.setCase(made);
        }
        QVERIFY(pane.toPlainText().contains(QStringLiteral("Ends.")));
    }

    void withoutDetailsThereIsNoLink()
    {
        AboutCasePane pane;
        pane.setResult(always, QStringLiteral("Ends."), {}, QStringLiteral("Touch-downs: 6"));
        QVERIFY(!pane.toPlainText().contains(QStringLiteral("Details")));
    }
};

TOUCHDOWN_TEST(TestAboutCasePane)

} // namespace test_about_case_pane

#include "test_about_case_pane.moc"

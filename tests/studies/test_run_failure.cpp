// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/run_failure.h"

#include <QTest>

using namespace touchdown;

class TestRunFailure : public QObject {
    Q_OBJECT

private slots:
    void whatWithoutWhen_data()
    {
        QTest::addColumn<QString>("message");
        QTest::addColumn<QString>("failure");
        QTest::newRow("lost spring") << "the rear air spring is lost for good since 40.096 us; the slider ends at 2 nm" << "the rear air spring is lost for good";
        QTest::newRow("diverged") << "the motion diverged at 12 us: the state outgrew all bounds" << "the motion diverged";
        QTest::newRow("left the disk") << "the slider left the disk: at 3 us it is 120 um above it" << "the slider left the disk";
        QTest::newRow("no step") << "no step is short enough at 1.5 us: the film does not converge" << "no step is short enough";
        QTest::newRow("no message") << "" << "failed";
    }
    void whatWithoutWhen()
    {
        QFETCH(QString, message);
        QFETCH(QString, failure);
        Summary summary;
        summary.status = RunStatus::Failed;
        summary.message = message.toStdString();
        QCOMPARE(QString::fromStdString(failureOf(summary)), failure);
    }

    void completedRunHasNone() { QCOMPARE(failureOf({}), std::string()); }
};

QTEST_GUILESS_MAIN(TestRunFailure)
#include "test_run_failure.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/recording.h"

#include <QFile>
#include <QFileDialog>
#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

#include "tests/support/test_program.h"
#include "tests/ui/question.h"
#include "ui/case/case_edits.h"
#include "ui/case/case_files.h"
#include "ui/runs/run_controller.h"
#include "ui/runs/runs_model.h"
#include "ui/window/main_window.h"
#include "ui/window/window_actions.h"

using namespace touchdown;

namespace test_recording {

class TestRecording : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QCoreApplication::setOrganizationName(QStringLiteral("touchdown"));
        QCoreApplication::setApplicationName(QStringLiteral("test_recording"));
    }
    /// Each run takes the place of the one before it, but not of what another program wrote there.
    void anotherFileIsNotRecordedOver()
    {
        QSettings().clear();
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("run.h5"));
        MainWindow window;
        window.files().openNow(QStringLiteral("fig10a"));
        window.edits().enter(*findParameter("run.duration"), QStringLiteral("10 µs"));
        window.show();
        window.actions().record->trigger();
        auto* dialog = window.findChild<QFileDialog*>();
        QVERIFY(dialog != nullptr);
        emit dialog->fileSelected(file);
        static_cast<QDialog*>(dialog)->done(QDialog::Accepted);
        for (int runs = 1; runs <= 2; ++runs) {
            window.startRun();
            QCOMPARE(window.runs().count(), runs);
            QTRY_VERIFY(!window.controller().active());
            QVERIFY(QFile::exists(file));
        }
        const QByteArray theirs("of another program");
        QFile other(file);
        QVERIFY(other.open(QIODevice::WriteOnly));
        other.write(theirs);
        other.close();
        for (const QString& choice : {QStringLiteral("Cancel"), QStringLiteral("Write over it")}) {
            window.startRun();
            QCOMPARE(window.runs().count(), 2);
            QVERIFY(other.open(QIODevice::ReadOnly));
            QCOMPARE(other.readAll(), theirs);
            other.close();
            answer(window, "recordingChanged", choice);
            QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        }
        QTRY_VERIFY(!window.controller().active());
        QCOMPARE(window.runs().count(), 3);
        QVERIFY(other.open(QIODevice::ReadOnly));
        QVERIFY(other.readAll() != theirs);
    }
};

TOUCHDOWN_TEST(TestRecording)

} // namespace test_recording

#include "test_recording.moc"

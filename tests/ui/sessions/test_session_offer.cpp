// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sessions/session_offer.h"

#include <QFileInfo>
#include <QTemporaryDir>
#include <QtTest>

#include "tests/support/sample_steady.h"
#include "tests/support/test_program.h"
#include "ui/sessions/session_state.h"
#include "ui/style/whole_file.h"

using namespace touchdown;

namespace test_session_offer {

FoundModes modesAt(double frequency)
{
    FoundModes modes;
    modes.value = test::sampleFilmCase();
    AirBearingMode mode;
    mode.frequency = frequency;
    modes.result.modes = {mode};
    return modes;
}

class TestSessionOffer : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QCoreApplication::setOrganizationName(QStringLiteral("touchdown"));
        QCoreApplication::setApplicationName(QStringLiteral("test_session_offer"));
        qputenv("XDG_DATA_HOME", data_.path().toLocal8Bit());
    }
    void cleanupTestCase() { qunsetenv("XDG_DATA_HOME"); }

    /// A window was killed while it restored a session, of which it had taken the modes, or had others.
    void whatAKilledWindowDidNotTakeStays_data()
    {
        QTest::addColumn<double>("frequency");
        QTest::addColumn<bool>("stays");
        QTest::newRow("taken") << 91e3 << false;
        QTest::newRow("others") << 50e3 << true;
    }
    void whatAKilledWindowDidNotTakeStays()
    {
        QFETCH(const double, frequency);
        QFETCH(const bool, stays);
        SessionState state;
        state.modes = modesAt(91e3);
        const QString left = leave(state);
        state.modes = modesAt(frequency);
        state.restoring = QFileInfo(left).fileName();
        finishRestoring(*SessionFolder::take(leave(state)));
        QCOMPARE(QFileInfo::exists(left), stays);
        if (stays) QCOMPARE(readSession(left).modes->result.modes.front().frequency, 91e3);
    }

    /// A state may name any folder; only those of sessions are ever taken.
    void aFolderThatIsNoSessionIsNotTaken_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"..", ".", "", "other", "/", "../sessions"}) QTest::newRow(name) << QString(name);
    }
    void aFolderThatIsNoSessionIsNotTaken()
    {
        QFETCH(const QString, name);
        SessionState state;
        state.restoring = name;
        const QString folder = leave(state), parent = QFileInfo(folder).path();
        for (const QString& other : {QFileInfo(parent).path(), parent}) {
            QVERIFY(QDir().mkpath(other + QStringLiteral("/other")));
            for (const QString& file : {QStringLiteral("/run1.h5"), QStringLiteral("/other/run1.h5")})
                QCOMPARE(writeWholeFile(other + file, "mine"), QString());
        }
        finishRestoring(*SessionFolder::take(folder));
        for (const QString& other : {QFileInfo(parent).path(), parent})
            for (const QString& file : {QStringLiteral("/run1.h5"), QStringLiteral("/other/run1.h5")})
                QVERIFY(QFileInfo::exists(other + file));
        QVERIFY(!QFileInfo::exists(parent + QStringLiteral("/lock")));
    }

private:
    static QString leave(const SessionState& state)
    {
        QString problem;
        const std::unique_ptr<SessionFolder> folder = SessionFolder::create(problem);
        if (!folder || !writeWholeFile(folder->stateFile(), toJson(state)).isEmpty()) qFatal("no folder");
        return folder->path();
    }

    QTemporaryDir data_;
};

TOUCHDOWN_TEST(TestSessionOffer)

} // namespace test_session_offer

#include "test_session_offer.moc"

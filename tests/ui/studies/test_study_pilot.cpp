// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/studies/study_pilot.h"

#include <atomic>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>

#include <QEvent>
#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_study_pilot {

std::atomic<double> now; // of the clock of the pilot [s]

/// A study that takes `seconds` of that clock and tells the share that has passed.
StudyPerformance steadyStudy(double seconds)
{
    return [seconds](int, const StudyCallback& callback) {
        StudyReport report;
        for (const double begin = now; now - begin < seconds; now = now + 0.125)
            if (!callback({(now - begin) / seconds, "steady", nullptr})) {
                report.status = StudyStatus::Cancelled;
                return report;
            }
        return report;
    };
}

/// Goes on until it is stopped.
StudyReport endless(const StudyCallback& callback)
{
    while (callback({0.0, "waiting", nullptr})) std::this_thread::yield();
    StudyReport report;
    report.status = StudyStatus::Cancelled;
    return report;
}

struct ClockedPilot : StudyPilot {
    ClockedPilot()
    {
        setClock([] { return now.load(); });
    }
};

struct Heard {
    explicit Heard(StudyPilot& pilot)
    {
        QObject::connect(&pilot, &StudyPilot::estimated, &pilot, [this](std::optional<double> estimate) {
            ++count;
            seconds = estimate;
        });
        QObject::connect(&pilot, &StudyPilot::failed, &pilot, [this] { ++failures; });
    }
    int count = 0, failures = 0;
    std::optional<double> seconds;
};

/// Stops the pilot when its mail is there, before it is handled.
struct StopAtMail : QObject {
    explicit StopAtMail(StudyPilot& p) : pilot(p) { p.installEventFilter(this); }
    bool eventFilter(QObject*, QEvent* event) override
    {
        if (event->type() == QEvent::User) {
            stopped = true;
            pilot.stop();
        }
        return false;
    }
    StudyPilot& pilot;
    bool stopped = false;
};

class TestStudyPilot : public QObject {
    Q_OBJECT

private slots:
    void theShareOfTheFirstSecondsGivesTheWhole_data()
    {
        QTest::addColumn<double>("seconds");
        for (const double seconds : {6.0, 100.0, 4000.0}) QTest::newRow(std::to_string(seconds).c_str()) << seconds;
    }
    void theShareOfTheFirstSecondsGivesTheWhole()
    {
        QFETCH(double, seconds);
        ClockedPilot pilot;
        Heard heard(pilot);
        pilot.start(steadyStudy(seconds), 1);
        QTRY_COMPARE(heard.count, 1);
        QVERIFY(heard.seconds && std::abs(*heard.seconds - seconds) < 1e-9 * seconds);
        QCOMPARE(pilot.state(), StudyPilot::State::Idle);
    }
    void aStudyThatEndsIsTimed()
    {
        ClockedPilot pilot;
        Heard heard(pilot);
        pilot.start(steadyStudy(0.75), 1);
        QTRY_COMPARE(heard.count, 1);
        QCOMPARE(heard.seconds, 0.75);
    }
    void nothingDoneTellsNothing()
    {
        ClockedPilot pilot;
        Heard heard(pilot);
        pilot.start(
            [](int, const StudyCallback& callback) {
                return endless([&](const StudyProgress& progress) {
                    now = now + 1.0;
                    return callback(progress);
                });
            },
            1);
        QTRY_COMPARE(heard.count, 1);
        QVERIFY(!heard.seconds);
    }
    void anErrorTellsNothing()
    {
        StudyPilot pilot;
        Heard heard(pilot);
        pilot.start([](int, const StudyCallback&) -> StudyReport { throw std::runtime_error("broken"); }, 1);
        QTRY_COMPARE(heard.failures, 1);
        pilot.start(
            [](int, const StudyCallback&) {
                StudyReport report;
                report.status = StudyStatus::Failed;
                return report;
            },
            1);
        QTRY_COMPARE(heard.failures, 2);
        QCOMPARE(heard.count, 0);
    }
    void aPilotThatIsStoppedSaysNothing()
    {
        StudyPilot pilot;
        Heard heard(pilot);
        pilot.start([](int, const StudyCallback& callback) { return endless(callback); }, 1);
        pilot.stop();
        QTRY_COMPARE(pilot.state(), StudyPilot::State::Idle);
        QCOMPARE(heard.count, 0);
    }
    /// It has posted its estimate, which nobody has read.
    void aPilotThatIsStoppedLateSaysNothing()
    {
        ClockedPilot pilot;
        Heard heard(pilot);
        StopAtMail stop(pilot);
        pilot.start(steadyStudy(0.75), 1);
        QTRY_COMPARE(pilot.state(), StudyPilot::State::Idle);
        QVERIFY(stop.stopped);
        QCOMPARE(heard.count, 0);
    }
    void roughTimes_data()
    {
        QTest::addColumn<double>("seconds");
        QTest::addColumn<QString>("text");
        QTest::newRow("short") << 0.4 << "less than 1 s";
        QTest::newRow("1.46 s") << 1.46 << "about 1.5 s";
        QTest::newRow("23 s") << 23.0 << "about 20 s";
        QTest::newRow("89 s") << 89.0 << "about 90 s";
        QTest::newRow("100 s") << 100.0 << "about 1.7 min";
        QTest::newRow("13 min") << 13.2 * 60.0 << "about 13 min";
        QTest::newRow("2 h") << 7400.0 << "about 2 h";
    }
    void roughTimes()
    {
        QFETCH(double, seconds);
        QTEST(roughTime(seconds), "text");
    }
};

TOUCHDOWN_TEST(TestStudyPilot)

} // namespace test_study_pilot

#include "test_study_pilot.moc"

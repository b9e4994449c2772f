// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/studies/study_pilot.h"

#include <cmath>
#include <optional>
#include <stdexcept>
#include <thread>

#include <QTest>

#include "core/numerics/wall_clock.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_study_pilot {

/// A study that takes `seconds` and tells the share that has passed.
StudyPerformance steadyStudy(double seconds)
{
    return [seconds](int, const StudyCallback& callback) {
        StudyReport report;
        const double begin = wallClock();
        for (double share = 0.0; share < 1.0; share = (wallClock() - begin) / seconds) {
            if (!callback({share, "steady", nullptr})) {
                report.status = StudyStatus::Cancelled;
                return report;
            }
            std::this_thread::yield();
        }
        return report;
    };
}

struct Heard {
    explicit Heard(StudyPilot& pilot)
    {
        QObject::connect(&pilot, &StudyPilot::estimated, &pilot, [this](std::optional<double> estimate) {
            ++count;
            seconds = estimate;
        });
    }
    int count = 0;
    std::optional<double> seconds;
};

class TestStudyPilot : public QObject {
    Q_OBJECT

private slots:
    /// Share and clock are read one after the other, so that the estimate is nearly exact.
    void theShareOfTheFirstSecondsGivesTheWhole()
    {
        StudyPilot pilot;
        Heard heard(pilot);
        pilot.start(steadyStudy(6.0), 1);
        QTRY_COMPARE_WITH_TIMEOUT(heard.count, 1, 20'000);
        QVERIFY(heard.seconds && std::abs(*heard.seconds - 6.0) < 0.1);
        QCOMPARE(pilot.state(), StudyPilot::State::Idle);
    }
    void aStudyThatEndsIsTimed()
    {
        StudyPilot pilot;
        Heard heard(pilot);
        pilot.start([](int, const StudyCallback&) { return StudyReport(); }, 1);
        QTRY_COMPARE(heard.count, 1);
        QVERIFY(heard.seconds && *heard.seconds < 5.0);
    }
    void nothingDoneTellsNothing()
    {
        StudyPilot pilot;
        Heard heard(pilot);
        pilot.start(
            [](int, const StudyCallback& callback) {
                while (callback({0.0, "waiting", nullptr})) std::this_thread::yield();
                StudyReport report;
                report.status = StudyStatus::Cancelled;
                return report;
            },
            1);
        QTRY_COMPARE_WITH_TIMEOUT(heard.count, 1, 20'000);
        QVERIFY(!heard.seconds);
    }
    void anErrorTellsNothing()
    {
        StudyPilot pilot;
        Heard heard(pilot);
        pilot.start([](int, const StudyCallback&) -> StudyReport { throw std::runtime_error("broken"); }, 1);
        QTRY_COMPARE(heard.count, 1);
        QVERIFY(!heard.seconds);
    }
    void aPilotThatIsStoppedSaysNothing()
    {
        StudyPilot pilot;
        Heard heard(pilot);
        pilot.start(steadyStudy(60.0), 1);
        pilot.stop();
        QTRY_COMPARE(pilot.state(), StudyPilot::State::Idle);
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/static_state/search_watch.h"

#include <QtTest>

#include <limits>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_search_watch {

using State = SearchWatch::State;

constexpr double startCorner = 1e-6; // [m]

State flying(double loadError, double spacing = 10e-9)
{
    return {.spacing = spacing, .corner = 1e-6, .residual = 1e-9, .loadError = loadError, .solved = true};
}

class TestSearchWatch : public QObject {
    Q_OBJECT

private slots:
    void depth_data()
    {
        QTest::addColumn<bool>("throughDisk");
        QTest::addColumn<double>("spacing");
        QTest::addColumn<int>("expected");
        const auto row = [](const char* title, bool through, double spacing, NoBalance expected) {
            QTest::newRow(title) << through << spacing << static_cast<int>(expected);
        };
        row("above", false, 2e-12, NoBalance::None);
        row("at the disk", false, 0.5e-12, NoBalance::AtDisk);
        row("at the disk on the way through", true, 0.5e-12, NoBalance::None);
        row("99 nm below", true, -99e-9, NoBalance::None);
        row("101 nm below", true, -101e-9, NoBalance::BelowDisk);
    }
    void depth()
    {
        QFETCH(bool, throughDisk);
        QFETCH(double, spacing);
        SearchWatch watch(startCorner, 10, throughDisk);
        QTEST(static_cast<int>(watch.look({}, flying(1.0, spacing), {})), "expected");
    }
    /// 50 um, or twice the corner of a start above 25 um.
    void height()
    {
        for (const auto& [start, limit] : {std::pair{1e-6, 50e-6}, std::pair{40e-6, 80e-6}})
            for (const double share : {0.99, 1.01}) {
                SearchWatch watch(start, 10, true);
                State state = flying(1.0);
                state.corner = share * limit;
                QCOMPARE(watch.look({}, state, {}), share < 1.0 ? NoBalance::None : NoBalance::FarAway);
            }
    }
    /// A load error that falls by 11 % counts as improvement, one that falls by 9 % does not.
    void patience()
    {
        SearchWatch improving(startCorner, 3, true), stalling(startCorner, 3, true);
        double error = 1.0;
        for (int k = 0; k < 50; ++k) QCOMPARE(improving.look({}, flying(error *= 0.89), {}), NoBalance::None);
        for (int k = 0; k < 4; ++k) QCOMPARE(stalling.look({}, flying(k == 0 ? 1.0 : 0.91), {}), NoBalance::None);
        QCOMPARE(stalling.look({}, flying(0.91), {}), NoBalance::Stalled);
        // A load error that is no number never counts as improvement.
        SearchWatch lost(startCorner, 3, true);
        for (int k = 0; k < 4; ++k) lost.look({}, flying(k == 0 ? 1.0 : std::numeric_limits<double>::infinity()), {});
        QCOMPARE(lost.look({}, flying(std::numeric_limits<double>::quiet_NaN()), {}), NoBalance::Stalled);
    }
    void unsolvedFilms()
    {
        SearchWatch watch(startCorner, 10, true);
        for (int k = 1; k < SearchWatch::mostUnsolved; ++k) QCOMPARE(watch.unsolved(0.11e-9), NoBalance::None);
        QCOMPARE(watch.unsolved(0.11e-9), NoBalance::FilmUnsolved);
        SearchWatch low(startCorner, 10, true);
        QCOMPARE(low.unsolved(0.09e-9), NoBalance::None);
        QCOMPARE(low.unsolved(-1e-9), NoBalance::AtDisk);
    }
    void theLastSaneState()
    {
        SearchWatch watch(startCorner, 10, true);
        QVERIFY(!watch.lastSane());
        QCOMPARE(watch.leastSaneError(), 1.0);
        const std::vector<double> first{1.0, 2.0}, second{3.0, 4.0};
        watch.look({5e-9, 1e-4, 0.0}, flying(0.3), first);
        watch.look({4e-9, 2e-4, 1e-6}, flying(0.4, 0.11e-9), second);
        watch.look({3e-9, 1e-4, 0.0}, flying(0.2, 0.09e-9), first); // too near the disk
        State unsolved = flying(0.1);
        unsolved.solved = false;
        watch.look({2e-9, 1e-4, 0.0}, unsolved, first);
        QVERIFY(watch.lastSane().has_value());
        QCOMPARE(watch.lastSane()->attitude.height, 4e-9);
        QCOMPARE(watch.lastSane()->state.loadError, 0.4);
        QCOMPARE(watch.sanePressure(), second);
        QCOMPARE(watch.leastSaneError(), 0.3);
    }
    void reasonsAreWords()
    {
        for (const NoBalance why :
             {NoBalance::AtDisk, NoBalance::BelowDisk, NoBalance::FarAway, NoBalance::Stalled, NoBalance::FilmUnsolved})
            QVERIFY(reason(why).size() > 10);
        QVERIFY(reason(NoBalance::None).empty());
    }
};

TOUCHDOWN_TEST(TestSearchWatch)

} // namespace test_search_watch

#include "test_search_watch.moc"

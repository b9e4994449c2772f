// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/maps/field_history.h"

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_field_history {

class TestFieldHistory : public QObject {
    Q_OBJECT

private slots:
    /// 20 snapshots from 0 to 1; two of them, a landing, reach to 54.
    void aShortPeak()
    {
        FieldHistory history = of(20, [](int i) { return i == 3 || i == 4 ? 54.0 : 1.0; });
        QCOMPARE(history.ranges[0].high, 54.0);
        QCOMPARE(history.usualRange(0).high, 1.0);
        QCOMPARE(history.usualRange(0).low, 0.0);
    }
    /// What reaches further for more than a tenth of the time belongs to the range.
    void aLongPeak()
    {
        const FieldHistory history = of(20, [](int i) { return i < 5 ? 54.0 : 1.0; });
        QCOMPARE(history.usualRange(0).high, 54.0);
    }
    /// A little more is no reason to cut anything off.
    void aLittleMore()
    {
        const FieldHistory history = of(20, [](int i) { return i == 3 ? 1.9 : 1.0; });
        QCOMPARE(history.usualRange(0).high, 1.9);
    }
    /// Zero but for one impact, as a contact pressure: the impact is all that there is to see.
    void mostlyNothing()
    {
        const FieldHistory history = of(20, [](int i) { return i == 3 ? 54.0 : 0.0; });
        QCOMPARE(history.usualRange(0).high, 54.0);
    }
    void fewSnapshots()
    {
        const FieldHistory history = of(9, [](int i) { return i == 3 ? 54.0 : 1.0; });
        QCOMPARE(history.usualRange(0).high, 54.0);
    }
    /// With every second snapshot its extremes go.
    void whenSnapshotsGo()
    {
        FieldHistory history{.fields = {}, .capacity = 2 * 16, .snapshots = {}, .ranges = {}};
        for (int i = 0; i < 40; ++i) history.add({1e-6 * i, 0, {{0.0, i == 5 ? 54.0 : 1.0}}});
        QVERIFY(history.stride > 1);
        QCOMPARE(history.extremes.size(), history.snapshots.size());
        for (std::size_t i = 0; i < history.snapshots.size(); ++i)
            QCOMPARE(history.extremes[i][0].high, history.snapshots[i].values[0][1]);
        QCOMPARE(history.ranges[0].high, 54.0); // of all that came
    }

private:
    template <typename Peak>
    static FieldHistory of(int count, const Peak& peak)
    {
        FieldHistory history{.fields = {}, .capacity = 1000, .snapshots = {}, .ranges = {}};
        for (int i = 0; i < count; ++i) history.add({1e-6 * i, 0, {{0.0, peak(i)}}});
        return history;
    }
};

TOUCHDOWN_TEST(TestFieldHistory)

} // namespace test_field_history

#include "test_field_history.moc"

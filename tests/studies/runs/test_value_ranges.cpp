// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/runs/value_ranges.h"

#include <QTest>

#include "core/studies/hysteresis/hysteresis_result.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_value_ranges {

StudiedEquilibrium at(double value, Stability stability, bool edge = false)
{
    return {value, 5e-9, 90e-6, stability, {{stability == Stability::Flutter ? 1e4 : -1e4, 1e6}}, 0, edge};
}

bool same(const std::vector<ValueRange>& a, const std::vector<ValueRange>& b)
{
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (a[i].lower != b[i].lower || a[i].upper != b[i].upper) return false;
    return true;
}

bool flutters(const StudiedEquilibrium& point) { return point.stability == Stability::Flutter; }

const ParameterText nanometres{"Height", "m", "nm"};

class TestValueRanges : public QObject {
    Q_OBJECT

private slots:
    void neighboursAmongAllAreOneRange()
    {
        // There and back, so that each value comes twice.
        QVERIFY(same(rangesAmong({1.0, 2.0, 3.0, 4.0, 4.0, 3.0, 2.0, 1.0}, {4.0, 1.0, 2.0}), {{1.0, 2.0}, {4.0, 4.0}}));
        QVERIFY(rangesAmong({1.0, 2.0}, {}).empty());
    }

    void rangesThatMeetAreOne()
    {
        QVERIFY(same(merged({{3.0, 4.0}, {0.0, 1.0}, {1.0, 2.0}}), {{0.0, 2.0}, {3.0, 4.0}}));
    }

    /// The Hopf point is where growth begins, whatever rounding says of its own.
    void reachToAHopfPoint()
    {
        using enum Stability;
        for (const Stability rounded : {Stable, Flutter}) {
            const std::vector<EquilibriumLine> lines{
                {true,
                 false,
                 {at(0.0, Stable), at(1.0, rounded, true), at(2.0, Flutter), at(3.0, Flutter), at(4.0, Stable)}}};
            QVERIFY(same(rangesAlong(lines, flutters), {{1.0, 3.0}}));
        }
        const std::vector<EquilibriumLine> outside{{true, true, {at(0.0, Flutter)}}};
        QVERIFY(rangesAlong(outside, flutters).empty());
    }

    /// Stable to the Hopf point at 2 on one line, everywhere on the other, which begins at 1.
    void coexistenceEndsAtAHopfPoint()
    {
        using enum Stability;
        const std::vector<EquilibriumLine> lines{
            {true, false, {at(0.0, Stable), at(2.0, Stable, true), at(4.0, Flutter)}},
            {false, false, {at(1.0, Stable), at(4.0, Stable)}}};
        QVERIFY(same(coexistence(lines), {{1.0, 2.0}}));
    }

    void asASentenceTellsThem()
    {
        QCOMPARE(text({{3e-9, 3e-9}}, nanometres), std::string("at 3 nm"));
        QCOMPARE(text({{3e-9, 5e-9}, {8e-9, 8e-9}}, nanometres), std::string("from 3 nm to 5 nm and at 8 nm"));
        QCOMPARE(text({{1e-9, 2e-9}, {3e-9, 3e-9}, {5e-9, 6e-9}}, nanometres),
                 std::string("from 1 nm to 2 nm, at 3 nm and from 5 nm to 6 nm"));
        QCOMPARE(text({{1e-9, 1e-9}, {3e-9, 3e-9}, {5e-9, 5e-9}, {7e-9, 7e-9}}, nanometres),
                 std::string("in 4 places from 1 nm to 7 nm"));
        QVERIFY(text({}, nanometres).empty());
    }
};

TOUCHDOWN_TEST(TestValueRanges)

} // namespace test_value_ranges

#include "test_value_ranges.moc"

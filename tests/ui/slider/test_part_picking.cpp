// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/part_picking.h"

#include <QTest>

#include "tests/support/test_program.h"
#include "tests/ui/sample_slider.h"

using namespace touchdown;

namespace test_part_picking {

class TestPartPicking : public QObject {
    Q_OBJECT

private slots:
    void words()
    {
        QCOMPARE(snapText(SnapTarget::Corner, {PartKind::Corner, 2, 1}), QStringLiteral("corner 2 of rail 3"));
        QCOMPARE(snapText(SnapTarget::Centre, {}), QStringLiteral("centre line"));
        QCOMPARE(snapText(SnapTarget::Border, {}), QStringLiteral("border"));
        QVERIFY(snapText(SnapTarget::Raster, {}).isEmpty() && snapText(SnapTarget::None, {}).isEmpty());
        QCOMPARE(selectionText({{PartKind::Edge, 2, 1}}), QStringLiteral("edge 2 of rail 3"));
    }
    void railsOfASelection()
    {
        QCOMPARE(
            railsOf({{PartKind::Corner, 2, 1}, {PartKind::Edge, 2, 0}, {PartKind::Rail, 0}, {PartKind::Interest, 1}}),
            (PartSelection{{PartKind::Rail, 0}, {PartKind::Rail, 2}}));
    }
    /// A rail is found again after another one was removed, after a new order, after it was moved; not after it was
    /// removed itself.
    void theSameRails()
    {
        const AirBearingSurface before = sampleSurface();
        QCOMPARE(sameRails(before, without(before, {{PartKind::Rail, 0}}), {1, 3}), (std::set<std::size_t>{0, 2}));
        QCOMPARE(sameRails(before, reordered(before, 3, 0), {1, 3}), (std::set<std::size_t>{0, 2}));
        QCOMPARE(sameRails(before, moved(before, {{PartKind::Rail, 1}}, {1e-6, 0.0}), {1, 3}),
                 (std::set<std::size_t>{1, 3}));
        QCOMPARE(sameRails(before, without(before, {{PartKind::Rail, 1}}), {1}), std::set<std::size_t>{});
        QCOMPARE(sameRails(before, before, {7}), std::set<std::size_t>{});
    }
};

TOUCHDOWN_TEST(TestPartPicking)

} // namespace test_part_picking

#include "test_part_picking.moc"

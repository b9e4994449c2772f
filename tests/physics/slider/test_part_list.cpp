// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/slider/part_list.h"

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_part_list {

class TestPartList : public QObject {
    Q_OBJECT

private slots:
    void numbersCountFromOne()
    {
        QCOMPARE(partList("edge", {0}), std::string("edge 1"));
        QCOMPARE(partList("edge", {0, 3}), std::string("edges 1 and 4"));
        QCOMPARE(partList("point", {0, 1, 2, 3, 4}), std::string("points 1, 2, 3, 4 and 5"));
        QCOMPARE(partList("point", {0, 1, 2, 3, 4, 5}), std::string("points 1, 2, 3, 4 and 2 more"));
    }
};

TOUCHDOWN_TEST(TestPartList)

} // namespace test_part_list

#include "test_part_list.moc"

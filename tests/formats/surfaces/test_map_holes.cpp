// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/surfaces/map_holes.h"

#include <QTest>

#include <vector>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_map_holes {

using Heights = std::vector<double>;

class TestMapHoles : public QObject {
    Q_OBJECT

private slots:
    void marksAreFound_data()
    {
        QTest::addColumn<Heights>("heights");
        QTest::addColumn<int>("place"); // -1: none
        const auto row = [](const char* name, const Heights& heights, int place) {
            QTest::newRow(name) << heights << place;
        };
        row("nothing", {}, -1);
        row("heights", {1, 2, 3, 2}, -1);
        row("a flat surface", {1, 1, 1}, -1);
        row("one bump", {0, 0, 5, 0}, -1);
        row("a spike of 300 times the range", {0, 1, 300, 0.5}, -1);
        row("a known mark", {1, 2, -9999, 3}, 2);
        row("known marks on a flat surface", {1, 1, -9999, -9999}, 2);
        row("two known marks", {1, 32767, 2, -32768}, 1);
        row("a known mark among such heights", {-9000, -9999, -12000, -11000}, -1);
        row("-32768 among numbers of a converter", {-32768, 12000, 32767, 500, -30000}, -1);
        row("an unknown mark", {0, 1, 5000, 0.5}, 2);
        row("unknown marks on both sides", {0, 1, 5000, 0.5, -5000}, 4);
        row("beyond all heights", {1e30, 1e30, 1e30}, 0);
        row("the end of single precision", {1, 2, -3.4028235e38}, 2);
    }
    void marksAreFound()
    {
        QFETCH(Heights, heights);
        QFETCH(int, place);
        const auto found = findHole(heights);
        QCOMPARE(found ? static_cast<int>(*found) : -1, place);
    }
    void theTextNamesIt() { QVERIFY(holeText(-9999).find("-9999") != std::string::npos); }
};

TOUCHDOWN_TEST(TestMapHoles)

} // namespace test_map_holes

#include "test_map_holes.moc"

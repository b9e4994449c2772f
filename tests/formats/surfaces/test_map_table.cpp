// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/surfaces/map_table.h"

#include <QTest>

#include "core/formats/cml_text.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_map_table {

using Numbers = std::vector<double>;

class TestMapTable : public QObject {
    Q_OBJECT

private slots:
    void numbersAreRead_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<int>("columns");
        QTest::addColumn<Numbers>("numbers");
        const auto row = [](const char* text, int columns, const Numbers& numbers) {
            QTest::newRow(text) << QByteArray(text) << columns << numbers;
        };
        row("0 1\n2\t3\n", 2, {0, 1, 2, 3});
        row("0,1\n2,3\n", 2, {0, 1, 2, 3});
        row("0, 1\n2, 3\n", 2, {0, 1, 2, 3});
        row("0;1;\n2;3;\n", 2, {0, 1, 2, 3});
        row("0,5\t1,25\n2\t3,5\n", 2, {0.5, 1.25, 2, 3.5});
        row("0,5;1\n2;-3,5e-2\n", 2, {0.5, 1, 2, -0.035});
        row(",5\t1\n-,5\t2\n", 2, {0.5, 1, -0.5, 2});
        row("\"0,5\",\"1\"\n", 2, {0.5, 1});
        row("\"0.5\",\"1\"\n", 2, {0.5, 1});
        row("0,250 1,000\n", 2, {0.25, 1});
        row("-1,2,-3,4\n", 4, {-1, 2, -3, 4});
        row("1, 2, 3, 4\n", 4, {1, 2, 3, 4});
        row("0 \xE2\x88\x92"
            "1\n\xE2\x88\x92"
            "2.5 3\n",
            2, {0, -1, -2.5, 3}); // the minus sign of typography
        row("nano 1 2\n2024-01-05\n1 2\n", 2, {1, 2});
    }
    void numbersAreRead()
    {
        QFETCH(QByteArray, text);
        QFETCH(int, columns);
        QFETCH(Numbers, numbers);
        if (text.startsWith("-1,2,-3")) { // in pairs only where each second number has no sign
            QVERIFY_EXCEPTION_THROWN(readMapTable(text.toStdString()), CmlError);
            text.replace(",4", ",-4");
            numbers.back() = -4;
        }
        const MapTable table = readMapTable(text.toStdString());
        QCOMPARE(table.columns, static_cast<std::size_t>(columns));
        QCOMPARE(table.numbers, numbers);
    }
    // What is no table is refused before it fills the memory, and a line of a million blanks is read once.
    void sizesAreLimited()
    {
        const auto problem = [](const std::string& text) -> std::string {
            try {
                readMapTable(text);
            } catch (const CmlError& error) {
                return error.what();
            }
            return {};
        };
        QCOMPARE(problem("0 1\n" + std::string(17 << 20, '1') + " 2\n"),
                 std::string("is longer than 16 MiB, the most of a line"));
        std::string comments;
        const std::string line = "#" + std::string(1 << 20, ' ') + "\n";
        for (int i = 0; i < 64; ++i) comments += line;
        QCOMPARE(problem(comments + "0 1\n"),
                 std::string("more than 64 MiB of headings, comments and empty lines are here or before"));
        QCOMPARE(problem("1" + std::string(1'000'000, ' ') + ";2\n"), std::string());
    }
    void theRestIsKept()
    {
        const MapTable table = readMapTable("# a\nb c\n0 1\n\n# d\n2 3\n4\n");
        QCOMPARE(table.headings.size(), std::size_t{2});
        QVERIFY(table.headings[0].comment && !table.headings[1].comment);
        QCOMPARE(table.headings[1].line, 2);
        QCOMPARE(table.lines, (std::vector<int>{3, 6}));
        QCOMPARE(table.breaks.size(), std::size_t{2});
        QCOMPARE(table.breaks[1].row, std::size_t{1});
        QCOMPARE(table.shortLine, 7);
        QVERIFY_EXCEPTION_THROWN(refuseShortRow(table), CmlError);
    }
    void refused_data()
    {
        QTest::addColumn<int>("line");
        for (const char* text : {"a\n1,5,2,5\n", "a\n1,5, 2,5\n", "a\n1,234.5;2\n", "a\n1,234;2,345\n",
                                 "a\n1;2,5;3.5\n", "a\n1;;2\n", "a\n1,,2\n", "a\n1'000 2\n", "a\nnan 1\n",
                                 "a\nnan nan\n", "a\nvoid 1 2 3\n", "a\n1 ,5\n", "a\n\"1.234,5\";2\n"})
            QTest::newRow(text) << 2;
        QTest::newRow("0 1\nx y\n2 3\n") << 2;
        QTest::newRow("words") << 0;
    }
    void refused()
    {
        QFETCH(int, line);
        try {
            readMapTable(QTest::currentDataTag());
            QFAIL("it was read");
        } catch (const CmlError& error) {
            QCOMPARE(error.line(), line);
        }
    }
    void thousands()
    {
        QVERIFY(mayCountThousands("1,234") && mayCountThousands("-123,456"));
        QVERIFY(!mayCountThousands("0,234") && !mayCountThousands("1,23") && !mayCountThousands("1234,567"));
    }
};

TOUCHDOWN_TEST(TestMapTable)

} // namespace test_map_table

#include "test_map_table.moc"

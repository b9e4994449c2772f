// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/result_table.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QSignalSpy>
#include <QTest>

#include "tests/support/test_program.h"
#include "ui/style/theme.h"

using namespace touchdown;

namespace test_result_table {

namespace {

TableRow row(const QString& words, double number)
{
    return {{words}, {QString::number(number).replace(u'-', QChar(0x2212)), Qt::AlignRight, {}, number}};
}

QString shown(const ResultTable& table, int column)
{
    QStringList list;
    for (int i = 0; i < table.rowCount(); ++i) list << table.text(i, column);
    return list.join(QLatin1Char(' '));
}

} // namespace

class TestResultTable : public QObject {
    Q_OBJECT

private slots:
    void showsRowsUnderTheirHeads();
    void sortsByNumber();
    void keepsTheOrderOfTheSameHeads();
    void copiesAllOrWhatIsSelected();
    void tellsWhichRowIsChosen();
    void failuresFollowTheTheme();
};

void TestResultTable::showsRowsUnderTheirHeads()
{
    ResultTable table(QStringLiteral("Table"));
    table.setRows({{"name"}, {"value"}}, {});
    QCOMPARE(table.rowCount(), 0);
    table.append(row("a", 1.0));
    QCOMPARE(table.text(0, 1), QStringLiteral("1"));
    QCOMPARE(table.head(1), QStringLiteral("value"));
    QCOMPARE(table.model()->headerData(1, Qt::Horizontal, Qt::TextAlignmentRole).toInt(),
             static_cast<int>(Qt::AlignRight | Qt::AlignVCenter)); // as its numbers
    table.setRows({{"other"}}, {{{"b"}}});
    QCOMPARE(table.columnCount(), 1);
    QCOMPARE(table.rowCount(), 1);
}

/// 9 before 10, and what is not known last in both directions.
void TestResultTable::sortsByNumber()
{
    ResultTable table(QStringLiteral("Table"));
    table.setSortable();
    table.setRows({{"name"}, {"value"}}, {row("a", 10.0), {{"b"}, {"–"}}, row("c", 9.0)});
    QCOMPARE(shown(table, 1), QStringLiteral("10 – 9")); // as they are given
    table.sortByColumn(1, Qt::AscendingOrder);
    QCOMPARE(shown(table, 1), QStringLiteral("9 10 –"));
    table.sortByColumn(1, Qt::DescendingOrder);
    QCOMPARE(shown(table, 1), QStringLiteral("10 9 –"));
}

void TestResultTable::keepsTheOrderOfTheSameHeads()
{
    ResultTable table(QStringLiteral("Table"));
    table.setSortable();
    table.setRows({{"name"}, {"value"}}, {row("a", 2.0), row("b", 1.0)});
    table.sortByColumn(1, Qt::AscendingOrder);
    table.setRows({{"name"}, {"value"}}, {row("a", 3.0), row("b", 2.0), row("c", 1.0)});
    QCOMPARE(shown(table, 0), QStringLiteral("c b a"));
    table.setRows({{"name"}, {"other"}}, {row("a", 3.0), row("b", 2.0), row("c", 1.0)});
    QCOMPARE(shown(table, 0), QStringLiteral("a b c"));
}

void TestResultTable::copiesAllOrWhatIsSelected()
{
    const auto copied = [] { return QGuiApplication::clipboard()->text(); };
    ResultTable table(QStringLiteral("Table"));
    table.setRows({{"name"}, {"value"}}, {row("a", 2.0), row("b", -1.0)});
    table.selectRow(1);
    QTest::keyClick(&table, Qt::Key_C, Qt::ControlModifier);
    QCOMPARE(copied(), QStringLiteral("name\tvalue\na\t2\nb\t-1\n")); // spreadsheets read a hyphen as the sign
    table.setSortable();
    table.copy();
    QCOMPARE(copied(), QStringLiteral("name\tvalue\nb\t-1\n"));
    table.clearSelection();
    table.copy();
    QCOMPARE(copied().count(QLatin1Char('\n')), 3);
}

void TestResultTable::tellsWhichRowIsChosen()
{
    ResultTable table(QStringLiteral("Table"));
    table.setRows({{"name"}, {"value"}}, {row("a", 2.0), row("b", 1.0)});
    QSignalSpy chosen(&table, &ResultTable::chosen);
    table.selectRow(1);
    QCOMPARE(chosen.takeLast().front().toInt(), 1);
    QTest::keyClick(&table, Qt::Key_Up);
    QCOMPARE(chosen.takeLast().front().toInt(), 0);
    table.setRows({{"name"}, {"value"}}, {row("a", 2.0)});
    table.selectRow(0);
    QCOMPARE(chosen.takeLast().front().toInt(), 0);
}

void TestResultTable::failuresFollowTheTheme()
{
    ResultTable table(QStringLiteral("Table"));
    const auto colour = [&] { return table.model()->index(0, 0).data(Qt::ForegroundRole).value<QBrush>().color(); };
    applyTheme(Theme::Light);
    table.show();
    table.setRows({{"state"}}, {{{"failed", Qt::AlignLeft, {}, {}, true}}});
    const QColor light = colour();
    QCOMPARE(light, meaningColours(table.palette()).failure);
    applyTheme(Theme::Dark);
    QTRY_VERIFY(colour() != light);
    QCOMPARE(colour(), meaningColours(table.palette()).failure);
    applyTheme(Theme::Light);
}

TOUCHDOWN_TEST(TestResultTable)

} // namespace test_result_table

#include "test_result_table.moc"

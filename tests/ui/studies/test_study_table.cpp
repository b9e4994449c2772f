// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/studies/study_table.h"

#include <QAbstractItemModelTester>
#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLocale>
#include <QTest>

#include "tests/support/test_program.h"
#include "tests/ui/sample_study.h"

using namespace touchdown;

namespace test_study_table {

class TestStudyTable : public QObject {
    Q_OBJECT

private slots:
    void init() { QLocale::setDefault(QLocale::c()); }
    void isAProperModel();
    void showsDisplayUnits();
    void showsReadableChoices();
    void writesNumbers_data();
    void writesNumbers();
    void writesADecimalComma();
    void sortsByNumber();
    void copiesWhatIsSelected();
};

void TestStudyTable::isAProperModel()
{
    StudyTableModel model;
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    model.setTable(sampleReport().tables[0]);
    QCOMPARE(model.rowCount(), 3);
    QCOMPARE(model.columnCount(), 4);
    model.setTable({});
    QCOMPARE(model.rowCount(), 0);
}

void TestStudyTable::showsDisplayUnits()
{
    StudyTableModel model;
    model.setTable(sampleReport().tables[0]);
    QCOMPARE(model.headerData(1, Qt::Horizontal).toString(), QStringLiteral("Step [ns]"));
    QCOMPARE(model.headerData(0, Qt::Horizontal).toString(), QStringLiteral("Method"));
    QCOMPARE(model.index(0, 1).data().toString(), QStringLiteral("100"));
    QCOMPARE(model.index(1, 2).data().toString(), QStringLiteral("0.03"));
    QCOMPARE(model.index(2, 2).data().toString(), QStringLiteral("–"));
    QVERIFY(!model.index(2, 2).data(StudyTableModel::SortRole).isValid());
}

/// Where the column says of which key its texts are values.
void TestStudyTable::showsReadableChoices()
{
    StudyTable table{"references", {{"parameter", "", "", "contact"}, {"method", "", "", "Method"}}, {}};
    table.rows = {{"ono-yamane", "ono-yamane"}, {"1 nm", "rk4"}};
    StudyTableModel model;
    model.setTable(table);
    QCOMPARE(model.index(0, 0).data().toString(), QStringLiteral("Ono & Yamane"));
    QCOMPARE(model.index(0, 1).data().toString(), QStringLiteral("ono-yamane"));
    QCOMPARE(model.index(1, 0).data().toString(), QStringLiteral("1 nm"));
}

void TestStudyTable::writesNumbers_data()
{
    QTest::addColumn<double>("number");
    QTest::addColumn<QString>("text");
    QTest::newRow("zero") << 0.0 << QStringLiteral("0");
    QTest::newRow("whole") << 800000.0 << QStringLiteral("800000");
    QTest::newRow("negative") << -1.5 << QStringLiteral("−1.5");
    QTest::newRow("five digits") << 0.0123456789 << QStringLiteral("0.012346");
    QTest::newRow("small") << 1.2e-7 << QStringLiteral("1.2·10⁻⁷");
    QTest::newRow("large") << 2.5e12 << QStringLiteral("2.5·10¹²");
}

void TestStudyTable::writesNumbers()
{
    QFETCH(const double, number);
    QFETCH(const QString, text);
    StudyTableModel model;
    model.setTable({"t", {{"n"}}, {{number}}});
    QCOMPARE(model.index(0, 0).data().toString(), text);
}

void TestStudyTable::writesADecimalComma()
{
    QLocale::setDefault(QLocale(QLocale::German));
    StudyTableModel model;
    model.setTable({"t", {{"n"}}, {{1234.5}}});
    QCOMPARE(model.index(0, 0).data().toString(), QStringLiteral("1234,5"));
}

/// 9 before 10, and what is not known last in both directions.
void TestStudyTable::sortsByNumber()
{
    StudyTableView view;
    view.setTable({"t", {{"n"}}, {{10.0}, {std::monostate{}}, {9.0}}});
    const auto shown = [&view] {
        QStringList list;
        for (int row = 0; row < 3; ++row) list << view.model()->index(row, 0).data().toString();
        return list.join(QLatin1Char(' '));
    };
    QCOMPARE(shown(), QStringLiteral("10 – 9")); // as the study gives them
    view.sortByColumn(0, Qt::AscendingOrder);
    QCOMPARE(shown(), QStringLiteral("9 10 –"));
    view.sortByColumn(0, Qt::DescendingOrder);
    QCOMPARE(shown(), QStringLiteral("10 9 –"));
}

void TestStudyTable::copiesWhatIsSelected()
{
    StudyTableView view;
    view.setTable(sampleReport().tables[0]);
    QCOMPARE(view.toText().count(QLatin1Char('\n')), 4);
    view.selectRow(1);
    view.copy();
    QCOMPARE(QGuiApplication::clipboard()->text(),
             QStringLiteral("Method\tStep [ns]\tLargest error [nm]\tEvaluations\nrk4\t10\t0.03\t800000\n"));
}

TOUCHDOWN_TEST(TestStudyTable)

} // namespace test_study_table

#include "test_study_table.moc"

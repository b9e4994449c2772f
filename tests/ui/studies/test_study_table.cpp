// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/studies/study_table.h"

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
    void showsDisplayUnits();
    void showsReadableChoices();
    void writesNumbers_data();
    void writesNumbers();
    void writesADecimalComma();
};

void TestStudyTable::showsDisplayUnits()
{
    const StudyTable table = sampleReport().tables[0];
    const TableRow heads = headsOf(table);
    const std::vector<TableRow> rows = rowsOf(table);
    QCOMPARE(heads.size(), std::size_t{4});
    QCOMPARE(rows.size(), std::size_t{3});
    QCOMPARE(heads[1].text, QStringLiteral("Step [ns]"));
    QCOMPARE(heads[0].text, QStringLiteral("Method"));
    QCOMPARE(rows[0][1].text, QStringLiteral("100"));
    QCOMPARE(rows[1][2].text, QStringLiteral("0.03"));
    QCOMPARE(rows[1][2].key.toDouble(), 0.03e-9); // rows are sorted by numbers in SI
    QCOMPARE(rows[2][2].text, QStringLiteral("–"));
    QVERIFY(!rows[2][2].key.isValid());
}

/// Where the column says of which key its texts are values.
void TestStudyTable::showsReadableChoices()
{
    StudyTable table{"references", {{"parameter", "", "", "contact"}, {"method", "", "", "Method"}}, {}};
    table.rows = {{"ono-yamane", "ono-yamane"}, {"1 nm", "rk4"}};
    const std::vector<TableRow> rows = rowsOf(table);
    QCOMPARE(rows[0][0].text, QStringLiteral("Ono & Yamane"));
    QCOMPARE(rows[0][1].text, QStringLiteral("ono-yamane"));
    QCOMPARE(rows[1][0].text, QStringLiteral("1 nm"));
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
    const std::vector<TableRow> rows = rowsOf({"t", {{"n"}}, {{number}}});
    QCOMPARE(rows[0][0].text, text);
}

void TestStudyTable::writesADecimalComma()
{
    QLocale::setDefault(QLocale(QLocale::German));
    const std::vector<TableRow> rows = rowsOf({"t", {{"n"}}, {{1234.5}}});
    QCOMPARE(rows[0][0].text, QStringLiteral("1234,5"));
}

TOUCHDOWN_TEST(TestStudyTable)

} // namespace test_study_table

#include "test_study_table.moc"

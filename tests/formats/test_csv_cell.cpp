// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/csv_cell.h"

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_csv_cell {

class TestCsvCell : public QObject {
    Q_OBJECT

private slots:
    void readsWhatIsWritten()
    {
        const std::vector<std::vector<std::string>> rows{
            {"a", "1.6 nm, 94.2 urad", ""}, {"says \"no\"", "two\nlines", "\"\""}, {"", "", "last"}};
        std::string text;
        for (const auto& row : rows) {
            for (const std::string& cell : row) text += (&cell == &row.front() ? "" : ",") + csvCell(cell);
            text += "\r\n";
        }
        QCOMPARE(csvRows(text), rows);
        QVERIFY(csvRows("").empty());
        QCOMPARE(csvRows("a,\"never closed"), (std::vector<std::vector<std::string>>{{"a", "never closed"}}));
    }
};

TOUCHDOWN_TEST(TestCsvCell)

} // namespace test_csv_cell

#include "test_csv_cell.moc"

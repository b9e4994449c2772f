// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/toml_quantity.h"

#include <QTest>

#include <cmath>
#include <limits>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_toml_quantity {

class TestTomlQuantity : public QObject {
    Q_OBJECT

private slots:
    void reads()
    {
        QCOMPARE(std::get<double>(tomlQuantity(TomlValue(std::int64_t{2}), "m", "mm")), 2.0);
        QCOMPARE(std::get<double>(tomlQuantity(TomlValue(7e-9), "m", "mm")), 7e-9);
        QCOMPARE(std::get<double>(tomlQuantity(TomlValue(std::string("7 nm")), "m", "mm")), 7e-9);
        QVERIFY(!std::signbit(std::get<double>(tomlQuantity(TomlValue(-0.0), "m", "mm"))));
    }
    void refuses_data()
    {
        QTest::addColumn<QString>("toml");
        QTest::addColumn<QString>("says");
        QTest::newRow("a boolean") << "true"
                                   << "has the wrong type; a number or \"1 mm\" is needed";
        QTest::newRow("a list") << "[1]"
                                << "has the wrong type; a number or \"1 mm\" is needed";
        QTest::newRow("a date") << "1970-01-01"
                                << "has the wrong type; a number or \"1 mm\" is needed";
        QTest::newRow("not a number") << "nan"
                                      << "is not a finite number";
        QTest::newRow("infinity") << "-inf"
                                  << "is not a finite number";
        QTest::newRow("another unit") << "'1 kg'"
                                      << "\"1 kg\" has the wrong unit; a length such as nm, um or mm is needed";
    }
    void refuses()
    {
        QFETCH(QString, toml);
        QFETCH(QString, says);
        const TomlDocument document = readToml("a = " + toml.toStdString());
        const auto number = tomlQuantity(document.entries.at(0).value, "m", "mm");
        QCOMPARE(QString::fromStdString(std::get<UnitProblem>(number).message), says);
    }
    void aPlainNumberNamesNoUnit()
    {
        QCOMPARE(std::get<UnitProblem>(tomlQuantity(TomlValue(true), "", "")).message,
                 std::string("has the wrong type; a number is needed"));
    }
    void writes()
    {
        QCOMPARE(formatTomlQuantity(7e-9, "nm"), std::string("\"7 nm\""));
        QCOMPARE(formatTomlQuantity(0.25, ""), std::string("0.25"));
    }
};

TOUCHDOWN_TEST(TestTomlQuantity)

} // namespace test_toml_quantity

#include "test_toml_quantity.moc"

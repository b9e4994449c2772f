// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/units.h"

#include <QTest>

#include <algorithm>
#include <clocale>
#include <cmath>
#include <random>
#include <thread>
#include <vector>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_units {

QString problemOf(const char* text, const char* unit)
{
    const auto result = parseQuantity(text, unit);
    const auto* problem = std::get_if<UnitProblem>(&result);
    return problem == nullptr ? QString() : QString::fromStdString(problem->message);
}

double valueOf(std::string_view text, std::string_view unit)
{
    const auto result = parseQuantity(text, unit);
    return std::holds_alternative<double>(result) ? std::get<double>(result) : std::numeric_limits<double>::quiet_NaN();
}

class TestUnits : public QObject {
    Q_OBJECT

private slots:
    void reads_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("unit");
        QTest::addColumn<double>("expected");

        QTest::newRow("nanometres") << "7 nm"
                                    << "m" << 7e-9;
        QTest::newRow("without a space") << "7nm"
                                         << "m" << 7e-9;
        QTest::newRow("with spaces around") << "  7   nm "
                                            << "m" << 7e-9;
        QTest::newRow("with an exponent") << "1.5e3um"
                                          << "m" << 1.5e-3;
        QTest::newRow("with a plus") << "+5 um"
                                     << "m" << 5e-6;
        QTest::newRow("negative") << "-94.2 urad"
                                  << "rad" << -94.2e-6;
        QTest::newRow("micro sign") << "5 µm"
                                    << "m" << 5e-6;
        QTest::newRow("Greek mu") << "5 μm"
                                  << "m" << 5e-6;
        QTest::newRow("gram-force is 9.80665 mN") << "2 gf"
                                                  << "N" << 2 * 9.80665e-3;
        QTest::newRow("revolutions per minute") << "60 rpm"
                                                << "rad/s" << 2 * 3.14159265358979323846;
        QTest::newRow("turns per second") << "1 turn/s"
                                          << "rad/s" << 2 * 3.14159265358979323846;
        QTest::newRow("degrees") << "180 deg"
                                 << "rad" << 3.14159265358979323846;
        QTest::newRow("a ratio of lengths is an angle") << "90 um/m"
                                                        << "rad" << 90e-6;
        QTest::newRow("a compound unit") << "2.2e-13 kg m^2"
                                         << "kg m^2" << 2.2e-13;
        QTest::newRow("a compound unit, SI typography") << "2.2e-13 kg·m²"
                                                        << "kg m^2" << 2.2e-13;
        QTest::newRow("a quotient") << "1 mN/nm"
                                    << "N/m" << 1e6;
        QTest::newRow("angular stiffness without the radian") << "1.5e-4 N m"
                                                              << "N m/rad" << 1.5e-4;
        QTest::newRow("bare and dimensionless") << "0.3"
                                                << "" << 0.3;
        QTest::newRow("per cent") << "30 %"
                                  << "" << 0.3;
        QTest::newRow("temperatures have an origin") << "0 degC"
                                                     << "K" << 273.15;
    }
    /// Exactly: by a power of ten the exponent is shifted, so "7 nm" is the number that 7e-9 is.
    void reads()
    {
        QFETCH(QString, text);
        QFETCH(QString, unit);
        QFETCH(double, expected);
        const double value = valueOf(text.toStdString(), unit.toStdString());
        if (!text.contains("gf") && !text.contains("rpm") && !text.contains("deg") && !text.contains("turn"))
            QVERIFY(value == expected);
        QCOMPARE(value, expected);
    }

    void refuses_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("unit");
        QTest::addColumn<QString>("says");

        QTest::newRow("missing unit") << "7"
                                      << "m"
                                      << "\"7\" has no unit; a length such as nm, um or mm is needed";
        for (const char* turning : {"90 Hz", "5400 1/min", "90 becquerel", "90 1/s"})
            QTest::newRow(turning) << turning << "rad/s"
                                   << QString("\"%1\" has the wrong unit; an angular velocity such as rad/s, deg/s or "
                                              "rpm is needed")
                                          .arg(turning);
        for (const char* angular : {"90 rad/s", "5400 rpm"})
            QTest::newRow(angular) << angular << "Hz"
                                   << QString("\"%1\" has the wrong unit; a unit such as Hz is needed").arg(angular);
        QTest::newRow("wrong unit") << "7 kg"
                                    << "m"
                                    << "\"7 kg\" has the wrong unit; a length such as nm, um or mm is needed";
        QTest::newRow("unknown unit") << "7 bananas"
                                      << "kg"
                                      << "\"7 bananas\" has an unknown unit; a mass such as mg, g or kg is needed";
        QTest::newRow("a frequency is no time")
            << "1 MHz"
            << "s"
            << "\"1 MHz\" has the wrong unit; a time such as ns, us or ms is needed";
        QTest::newRow("a unit on a plain number") << "0.3 rad"
                                                  << ""
                                                  << "\"0.3 rad\" has a unit; a plain number or % is needed";
        QTest::newRow("decimal comma") << "1,5 nm"
                                       << "m"
                                       << "\"1,5 nm\" has a comma; write decimals with a point";
        QTest::newRow("empty") << ""
                               << "m"
                               << "is empty; a number is needed";
        QTest::newRow("no number") << "nm"
                                   << "m"
                                   << "\"nm\" is not a number";
        QTest::newRow("not a number") << "nan nm"
                                      << "m"
                                      << "\"nan nm\" is not a finite number";
        QTest::newRow("infinity") << "-inf m"
                                  << "m"
                                  << "\"-inf m\" is not a finite number";
        QTest::newRow("overflow of the number") << "1e999 m"
                                                << "m"
                                                << "\"1e999 m\" is beyond the range of numbers";
        QTest::newRow("overflow by the unit") << "1e307 km"
                                              << "m"
                                              << "\"1e307 km\" is beyond the range of numbers";
        QTest::newRow("a factor in the unit")
            << "7 2 m"
            << "m"
            << "\"7 2 m\" has an unknown unit; a length such as nm, um or mm is needed";
        QTest::newRow("a factor behind the unit")
            << "7 m 2"
            << "m"
            << "\"7 m 2\" has an unknown unit; a length such as nm, um or mm is needed";
        QTest::newRow("hexadecimal") << "0x7 m"
                                     << "m"
                                     << "\"0x7 m\" has an unknown unit; a length such as nm, um or mm is needed";
        QTest::newRow("an origin") << "7 m @ 5"
                                   << "m"
                                   << "\"7 m @ 5\" has an unknown unit; a length such as nm, um or mm is needed";
        QTest::newRow("a date")
            << "7 s since 1970-01-01"
            << "s"
            << "\"7 s since 1970-01-01\" has an unknown unit; a time such as ns, us or ms is needed";
        QTest::newRow("a logarithm") << "7 lg(re m)"
                                     << "m"
                                     << "\"7 lg(re m)\" has an unknown unit; a length such as nm, um or mm is needed";
        QTest::newRow("a control character")
            << "7\tn\x01m"
            << "m"
            << "\"7?n?m\" has an unknown unit; a length such as nm, um or mm is needed";
    }
    void refuses()
    {
        QFETCH(QString, text);
        QFETCH(QString, unit);
        QFETCH(QString, says);
        QCOMPARE(problemOf(text.toUtf8().constData(), unit.toUtf8().constData()), says);
    }

    void hostileUnitsAreRefused()
    {
        const std::vector<std::string> hostile{"1 " + std::string(100000, '('), "1 " + std::string(100000, 'm'),
                                               std::string("1 m\0m", 5),        "1 m^" + std::string(40, '9'),
                                               std::string("1 \xff\xfe"),       "1 m^-99999 m^99999"};
        for (const std::string& text : hostile) QVERIFY(std::holds_alternative<UnitProblem>(parseQuantity(text, "m")));
    }

    void factors_data()
    {
        QTest::addColumn<QString>("unit");
        QTest::addColumn<double>("factor");
        QTest::newRow("nm") << "nm" << 1e-9;
        QTest::newRow("urad") << "urad" << 1e-6;
        QTest::newRow("mg") << "mg" << 1e-6;
        QTest::newRow("kg m^2") << "kg m^2" << 1.0;
        QTest::newRow("N m/rad") << "N m/rad" << 1.0;
        QTest::newRow("kHz") << "kHz" << 1e3;
        QTest::newRow("dimensionless") << "" << 1.0;
    }
    void factors()
    {
        QFETCH(QString, unit);
        QFETCH(double, factor);
        QVERIFY(unitFactor(unit.toStdString()) == factor);
    }

    void formats_data()
    {
        QTest::addColumn<double>("value");
        QTest::addColumn<QString>("unit");
        QTest::addColumn<QString>("expected");
        QTest::newRow("nanometres") << 7e-9 << "nm"
                                    << "7 nm";
        QTest::newRow("a fraction") << 94.2e-6 << "urad"
                                    << "94.2 urad";
        QTest::newRow("below one") << 0.05e-9 << "nm"
                                   << "0.05 nm";
        QTest::newRow("zero") << 0.0 << "nm"
                              << "0 nm";
        QTest::newRow("negative") << -5.607e-9 << "nm"
                                  << "-5.607 nm";
        QTest::newRow("hundreds of thousands in full") << 5e5 << "N/m"
                                                       << "500000 N/m";
        QTest::newRow("millions with an exponent") << 1.35e6 << "N/m"
                                                   << "1.35e6 N/m";
        QTest::newRow("small with an exponent") << 2.2e-13 << "kg m^2"
                                                << "2.2e-13 kg m^2";
        QTest::newRow("dimensionless") << 0.01 << ""
                                       << "0.01";
        QTest::newRow("not by a power of ten") << 1.5 * 9.80665e-3 << "gf"
                                               << "1.5 gf";
    }
    void formats()
    {
        QFETCH(double, value);
        QFETCH(QString, unit);
        QFETCH(QString, expected);
        QCOMPARE(QString::fromStdString(formatQuantity(value, unit.toStdString())), expected);
        QCOMPARE(QString::fromStdString(formatNumber(value, unit.toStdString())), expected.section(' ', 0, 0));
    }

    void roundTrips_data()
    {
        QTest::addColumn<QString>("displayUnit");
        QTest::addColumn<QString>("unit");
        QTest::newRow("power of ten") << "nm"
                                      << "m";
        QTest::newRow("compound") << "mN/nm"
                                  << "N/m";
        QTest::newRow("gram-force") << "gf"
                                    << "N";
        QTest::newRow("rpm") << "rpm"
                             << "rad/s";
        QTest::newRow("degrees") << "deg"
                                 << "rad";
    }
    /// Any double, bit for bit; where no number in the unit gives it, as a bare SI number.
    void roundTrips()
    {
        QFETCH(QString, displayUnit);
        QFETCH(QString, unit);
        std::mt19937_64 generator(1);
        for (int i = 0; i < 2000; ++i) {
            const double mantissa = std::uniform_real_distribution<double>(-10.0, 10.0)(generator);
            const double value = mantissa * std::pow(10.0, std::uniform_int_distribution<int>(-30, 30)(generator));
            const std::string text = formatQuantity(value, displayUnit.toStdString());
            const bool withUnit = text.find(' ') != std::string::npos;
            QVERIFY2(valueOf(text, withUnit ? unit.toStdString() : std::string()) == value, text.c_str());
            // Five digits of it always have a number in the unit.
            const double rounded = roundedIn(value, displayUnit.toStdString(), 5);
            const std::string few = formatQuantity(rounded, displayUnit.toStdString());
            QVERIFY2(few.find(' ') != std::string::npos && valueOf(few, unit.toStdString()) == rounded, few.c_str());
            const std::string number = few.substr(0, std::min(few.find('e'), few.find(' ')));
            const auto first = number.find_first_of("123456789"), last = number.find_last_of("123456789");
            const std::string known = number.substr(first, last + 1 - first);
            QVERIFY2(std::ssize(known) - std::ranges::count(known, '.') <= 5, few.c_str());
            QVERIFY(std::abs(rounded - value) <= 0.5001e-4 * std::abs(value));
        }
    }

    void localeDoesNotMatter_data()
    {
        QTest::addColumn<QByteArray>("locale");
        QTest::newRow("C") << QByteArray("C");
        // Where the machine has them.
        for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "ru_RU.UTF-8"})
            if (std::setlocale(LC_ALL, name) != nullptr) QTest::newRow(name) << QByteArray(name);
        std::setlocale(LC_ALL, "C");
    }
    void localeDoesNotMatter()
    {
        QFETCH(QByteArray, locale);
        QVERIFY(std::setlocale(LC_ALL, locale.constData()) != nullptr);
        const double value = valueOf("1.5 gf", "N");
        const std::string text = formatQuantity(0.25e-9, "nm");
        std::setlocale(LC_ALL, "C");
        QCOMPARE(value, 1.5 * 9.80665e-3);
        QCOMPARE(text, std::string("0.25 nm"));
    }

    void threadsShareTheUnits()
    {
        std::vector<std::thread> threads;
        std::vector<int> right(4, 0);
        for (std::size_t k = 0; k < right.size(); ++k)
            threads.emplace_back([&right, k] {
                for (int i = 0; i < 500; ++i)
                    if (valueOf(std::to_string(i) + " nm", "m") == valueOf(std::to_string(i) + "e-9 m", "m") &&
                        unitFactor("us") == 1e-6)
                        ++right[k];
            });
        for (std::thread& thread : threads) thread.join();
        QCOMPARE(right, std::vector<int>(4, 500));
    }
};

TOUCHDOWN_TEST(TestUnits)

} // namespace test_units

#include "test_units.moc"

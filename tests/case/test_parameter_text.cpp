// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/parameters.h"

#include "tests/support/random_case.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace touchdown;

namespace test_parameter_text {

class TestParameterText : public QObject {
    Q_OBJECT

private slots:
    void accepts_data()
    {
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("written");
        QTest::newRow("a length") << "springs.flying_height"
                                  << "7 nm"
                                  << "7 nm";
        QTest::newRow("another unit") << "springs.flying_height"
                                      << "0.0032 um"
                                      << "3.2 nm";
        QTest::newRow("a bare number is SI") << "slider.mass"
                                             << "1.6e-6"
                                             << "1.6 mg";
        QTest::newRow("a plain number") << "ono_yamane.friction"
                                        << "2.0"
                                        << "2";
        QTest::newRow("per cent") << "springs.front_damping_ratio"
                                  << "0.2 %"
                                  << "0.002";
        QTest::newRow("a kilogram, for a textbook") << "slider.mass"
                                                    << "1 kg"
                                                    << "1e6 mg";
        QTest::newRow("no stiffness") << "suspension.stiffness"
                                      << "0 N/m"
                                      << "0 N/m";
        QTest::newRow("the lowest tolerance") << "run.tolerance"
                                              << "1e-14"
                                              << "1e-14";
        QTest::newRow("a fast start") << "initial.vertical_velocity"
                                      << "-1 km/s"
                                      << "-1e6 mm/s";
        QTest::newRow("an integer") << "degrees_of_freedom"
                                    << "2"
                                    << "2";
        QTest::newRow("a choice") << "run.integrator"
                                  << " rk4-events "
                                  << "rk4-events";
        QTest::newRow("a boolean") << "run.step_check"
                                   << "false"
                                   << "false";
        QTest::newRow("a text") << "title"
                                << " A µ \"title\" "
                                << " A µ \"title\" ";
        QTest::newRow("a list") << "steady.radii"
                                << "20 mm, 0.03 m,4 cm"
                                << "20 mm, 30 mm, 40 mm";
        QTest::newRow("a list as in a case file") << "steady.skews"
                                                  << "[\"-5 deg\", '3 deg', ]"
                                                  << "-5 deg, 3 deg";
        QTest::newRow("bare numbers of a list are SI") << "steady.radii"
                                                       << "0.02; 0.03"
                                                       << "20 mm, 30 mm";
        QTest::newRow("an empty list") << "steady.radii"
                                       << " "
                                       << "";
        QTest::newRow("a list in brackets, empty") << "steady.radii"
                                                   << "[]"
                                                   << "";
        QTest::newRow("whole numbers of a list") << "film.nodes"
                                                 << "97,2049"
                                                 << "97, 2049";
        QTest::newRow("a speed") << "disk.speed"
                                 << "5400 rpm"
                                 << "5400 rpm";
        QTest::newRow("a preload") << "suspension.preload"
                                   << "1.5 gf"
                                   << "1.5 gf";
        QTest::newRow("minus zero is zero") << "initial.pitch"
                                            << "-0 urad"
                                            << "0 urad";
    }
    void accepts()
    {
        QFETCH(QString, key);
        QFETCH(QString, text);
        QFETCH(QString, written);
        const Parameter& parameter = *findParameter(key.toStdString());
        Case c;
        QCOMPARE(QString::fromStdString(setFromText(c, parameter, text.toStdString()).value_or("")), QString());
        QCOMPARE(QString::fromStdString(toText(c, parameter)), written);
    }

    void refuses_data()
    {
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("says");
        QTest::newRow("a negative mass") << "slider.mass"
                                         << "-1.6 mg"
                                         << "-1.6 mg is out of range: allowed is at least 1e-6 mg, at most 10 kg";
        QTest::newRow("no mass") << "slider.mass"
                                 << "0 mg"
                                 << "0 mg is out of range: allowed is at least 1e-6 mg, at most 10 kg";
        QTest::newRow("a mass in tonnes") << "slider.mass"
                                          << "20 kg"
                                          << "20 kg is out of range: allowed is at least 1e-6 mg, at most 10 kg";
        QTest::newRow("a wrong unit") << "slider.mass"
                                      << "7 nm"
                                      << "\"7 nm\" has the wrong unit; a mass such as mg, g or kg is needed";
        QTest::newRow("nanometres without their unit") << "springs.flying_height"
                                                       << "7"
                                                       << "7 m is out of range: allowed is at least -1 m, at most 1 m";
        QTest::newRow("a loose tolerance") << "run.tolerance"
                                           << "0.1"
                                           << "0.1 is out of range: allowed is at least 1e-14, at most 0.01";
        QTest::newRow("not a number") << "run.tolerance"
                                      << "nan"
                                      << "\"nan\" is not a finite number";
        QTest::newRow("an infinite velocity") << "initial.vertical_velocity"
                                              << "inf m/s"
                                              << "\"inf m/s\" is not a finite number";
        QTest::newRow("four degrees of freedom") << "degrees_of_freedom"
                                                 << "4"
                                                 << "4 is out of range: allowed is at least 2, at most 3";
        QTest::newRow("half a degree of freedom") << "degrees_of_freedom"
                                                  << "1.5"
                                                  << "1.5 is not a whole number";
        QTest::newRow("an endless integer") << "degrees_of_freedom"
                                            << "1e30"
                                            << "1e30 is out of range: allowed is at least 2, at most 3";
        QTest::newRow("an unknown choice") << "initial.branch"
                                           << "plastic"
                                           << "\"plastic\" is not known: allowed is one of touch-down, take-off";
        QTest::newRow("no such model") << "model"
                                       << "foil"
                                       << "\"foil\" is not known: allowed is one of springs, film, contact";
        const char* nodes = "2 numbers, each 17, 33, 49 and so on to 2049";
        QTest::newRow("one number of nodes") << "film.nodes"
                                             << "97" << QString("has 1 number: allowed is %1").arg(nodes);
        QTest::newRow("three numbers of nodes")
            << "film.nodes"
            << "97, 97, 97" << QString("has too many numbers: allowed is %1").arg(nodes);
        QTest::newRow("a hundred nodes") << "film.nodes"
                                         << "97, 100" << QString("100 is not possible: allowed is %1").arg(nodes);
        QTest::newRow("half a node") << "film.nodes"
                                     << "97, 97.5" << QString("97.5 is not possible: allowed is %1").arg(nodes);
        QTest::newRow("too few nodes") << "film.nodes"
                                       << "1, 97" << QString("1 is out of range: allowed is %1").arg(nodes);
        QTest::newRow("too many nodes") << "film.nodes"
                                        << "97, 2065" << QString("2065 is out of range: allowed is %1").arg(nodes);
        QTest::newRow("a hole in a list") << "steady.radii"
                                          << "20 mm,, 30 mm"
                                          << "is empty; a number is needed";
        QTest::newRow("a wrong unit in a list")
            << "steady.radii"
            << "20 mm, 30 mg"
            << "\"30 mg\" has the wrong unit; a length such as nm, um or mm is needed";
        QTest::newRow("a word in a list") << "steady.radii"
                                          << "20 mm, nan"
                                          << "\"nan\" is not a finite number";
        QTest::newRow("an endless list")
            << "steady.speeds" << QString("1,").repeated(101)
            << "has too many numbers: allowed is at most 100 numbers, each at least 0 rpm, "
               "at most 100000 rad/s";
        QTest::newRow("yes") << "run.step_check"
                             << "yes"
                             << "\"yes\" is neither true nor false";
        QTest::newRow("a control character") << "title"
                                             << "a\x07"
                                             << "\"a?\" holds control characters";
        QTest::newRow("an endless text") << "title" << QString(5000, 'a') << "is longer than 4000 bytes";
        QTest::newRow("nothing") << "slider.mass"
                                 << ""
                                 << "is empty; a number is needed";
    }
    /// Says why, and leaves the case alone.
    void refuses()
    {
        QFETCH(QString, key);
        QFETCH(QString, text);
        QFETCH(QString, says);
        Case c;
        QCOMPARE(QString::fromStdString(
                     setFromText(c, *findParameter(key.toStdString()), text.toStdString()).value_or("accepted")),
                 says);
        QCOMPARE(test::firstDifference(c, Case{}), std::string());
    }

    void numbersAreCheckedToo()
    {
        Case c;
        QVERIFY(!setFromNumber(c, *findParameter("slider.mass"), 2e-6).has_value());
        QVERIFY(c.slider.mass == 2e-6);
        QVERIFY(setFromNumber(c, *findParameter("slider.mass"), -1.0).has_value());
        QVERIFY(setFromNumber(c, *findParameter("slider.mass"), std::numeric_limits<double>::quiet_NaN()).has_value());
        QCOMPARE(setFromNumber(c, *findParameter("initial.branch"), 1.0).value_or(""),
                 std::string("is a number; allowed is one of touch-down, take-off"));
        QVERIFY(!setFromNumber(c, *findParameter("steady.radii"), 0.02).has_value());
        QCOMPARE(c.steady.radii, std::vector<double>{0.02});
        QCOMPARE(setFromNumbers(c, *findParameter("slider.mass"), {1.0}).value_or(""),
                 std::string("is a list; allowed is at least 1e-6 mg, at most 10 kg"));
        QCOMPARE(setFromNumber(c, *findParameter("title"), 1.0).value_or(""),
                 std::string("is a number; text is needed"));
        QVERIFY(c.slider.mass == 2e-6);
    }

    void ranges_data()
    {
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("range");
        QTest::newRow("an open lower end") << "slider.length"
                                           << "greater than 0 mm, at most 0.1 m";
        QTest::newRow("a closed lower end") << "springs.front_damping_ratio"
                                            << "at least 0, at most 10";
        QTest::newRow("no ends") << "initial.pitch_velocity"
                                 << "any finite number";
        QTest::newRow("two values") << "degrees_of_freedom"
                                    << "at least 2, at most 3";
        QTest::newRow("a list") << "steady.radii"
                                << "at most 100 numbers, each greater than 0 mm, at most 1 m";
        QTest::newRow("a list of steps") << "film.nodes"
                                         << "2 numbers, each 17, 33, 49 and so on to 2049";
        QTest::newRow("choices") << "initial.branch"
                                 << "one of touch-down, take-off";
        QTest::newRow("models") << "model"
                                << "one of springs, film, contact";
        QTest::newRow("a boolean") << "run.step_check"
                                   << "true or false";
    }
    void ranges()
    {
        QFETCH(QString, key);
        QFETCH(QString, range);
        QCOMPARE(QString::fromStdString(allowedRange(*findParameter(key.toStdString()))), range);
    }

    /// Bit for bit, for any value in range.
    void textReadsBack()
    {
        test::RandomCase random(7);
        for (int i = 0; i < 200; ++i) {
            Case c;
            random.change(c, 1.0);
            Case back;
            for (const Parameter& parameter : parameters())
                QCOMPARE(setFromText(back, parameter, toText(c, parameter)).value_or(""), std::string());
            QCOMPARE(test::firstDifference(back, c), std::string());
        }
    }
};

TOUCHDOWN_TEST(TestParameterText)

} // namespace test_parameter_text

#include "test_parameter_text.moc"

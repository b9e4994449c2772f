// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/attitude_sections.h"

#include <algorithm>

#include <limits>

#include <QTest>

#include "tests/support/test_program.h"
#include "tests/ui/sample_slider.h"

using namespace touchdown;

namespace test_attitude_sections {

const QString nbsp(QChar(0x00A0));
const QString minus(QChar(0x2212));

/// The cells after the name; empty when there is no such row.
QStringList row(const std::vector<AttitudeSection>& sections, const QString& title, const QString& name)
{
    for (const AttitudeSection& section : sections)
        if (section.title == title)
            for (const QStringList& cells : section.rows)
                if (cells.front() == name) return cells.mid(1);
    return {};
}

bool has(const std::vector<AttitudeSection>& sections, const QString& title)
{
    return std::ranges::any_of(sections, [&title](const AttitudeSection& s) { return s.title == title; });
}

class TestAttitudeSections : public QObject {
    Q_OBJECT

private slots:
    void digitsEndWhereTheErrorBegins_data();
    void digitsEndWhereTheErrorBegins();
    void printsTheAttitudeWithItsErrors();
    void printsForcesWithTheirPlaces();
    void scalesTheStiffness();
    void scalesSensitivitiesToTheUnitsOfTheFields();
    void leavesOutWhatThereIsNot();
    void listsOtherEquilibria();
    void listsContactAndOtherStates();
    void keepsTheOutcomeOfAFailure();
    void copiesAsATable();
    void saysTheOutcomeInASentence_data();
    void saysTheOutcomeInASentence();
    void usesTheDecimalComma();
};

void TestAttitudeSections::digitsEndWhereTheErrorBegins_data()
{
    QTest::addColumn<double>("value"); // [nm]
    QTest::addColumn<double>("error"); // [nm]
    QTest::addColumn<QString>("text");
    const QString pm = nbsp + QStringLiteral("±") + nbsp;
    const QString nm = nbsp + QStringLiteral("nm");
    QTest::newRow("a hundredth") << 7.0312 << 0.02 << QStringLiteral("7.03") + pm + QStringLiteral("0.02") + nm;
    QTest::newRow("two digits of an error that begins with 1")
        << 7.0312 << 0.0134 << QStringLiteral("7.031") + pm + QStringLiteral("0.013") + nm;
    QTest::newRow("an error above one") << 123.4 << 6.0 << QStringLiteral("123") + pm + QStringLiteral("6") + nm;
    QTest::newRow("a tiny error") << 5.5 << 3e-5 << QStringLiteral("5.50000") + pm + QStringLiteral("0.00003") + nm;
    QTest::newRow("no estimate: four digits") << 7.0312 << 0.0 << QStringLiteral("7.031") + nm;
    QTest::newRow("no estimate of a large one") << 12345.6 << 0.0 << QStringLiteral("12346") + nm;
    QTest::newRow("negative") << -1.25 << 0.03 << minus + QStringLiteral("1.25") + pm + QStringLiteral("0.03") + nm;
    QTest::newRow("zero") << -1e-9 << 0.0 << QStringLiteral("0.000") + nm;
}

void TestAttitudeSections::digitsEndWhereTheErrorBegins()
{
    QFETCH(const double, value);
    QFETCH(const double, error);
    QFETCH(const QString, text);
    QCOMPARE(withError(value * 1e-9, error * 1e-9, "nm", QLocale::c()), text);
}

void TestAttitudeSections::printsTheAttitudeWithItsErrors()
{
    const Case c = sampleFilmCase();
    const auto sections = attitudeSections(c, sampleResult(c), QLocale::c());
    QCOMPARE(row(sections, "Attitude", "Nominal trailing edge height"), QStringList{"10.00" + nbsp + "nm"});
    QCOMPARE(row(sections, "Attitude", "Pitch"), QStringList{"100.0" + nbsp + "±" + nbsp + "0.3" + nbsp + "µrad"});
    QCOMPARE(row(sections, "Points of interest", "P2"), (QStringList{"12.50" + nbsp + "nm", "0.840, 0.220"}));
}

void TestAttitudeSections::printsForcesWithTheirPlaces()
{
    const Case c = sampleFilmCase();
    const auto sections = attitudeSections(c, sampleResult(c), QLocale::c());
    // 14.7 mN / 9.80665 mN = 1.49898 gf.
    QCOMPARE(row(sections, "Air bearing", "Net force"),
             (QStringList{"14.70" + nbsp + "±" + nbsp + "0.05" + nbsp + "mN", "1.499" + nbsp + "gf"}));
    QCOMPARE(row(sections, "Air bearing", "Below ambient"),
             (QStringList{minus + "3.500" + nbsp + "mN", "0.500, 0.350"}));
    // Above ambient, as on the map: 900 kPa and -75 kPa.
    QCOMPARE(row(sections, "Air bearing", "Peak pressure above ambient"),
             (QStringList{"900.0" + nbsp + "kPa", "0.800, 0.350"}));
    QCOMPARE(row(sections, "Air bearing", "Smallest pressure above ambient").front(), minus + "75.00" + nbsp + "kPa");
}

// 2.5e6 N/m = 2.5 mN/nm; 1200 N/rad = 1.2 mN/urad; -300 N m/m = -0.3 uN m/nm; 0.08 N m/rad = 0.08 uN m/urad.
void TestAttitudeSections::scalesTheStiffness()
{
    const Case c = sampleFilmCase();
    const auto sections = attitudeSections(c, sampleResult(c), QLocale::c());
    QCOMPARE(row(sections, "Stiffness of the film", "Force [mN]"), (QStringList{"2.500", "1.200", "0.003000"}));
    QCOMPARE(row(sections, "Stiffness of the film", "Pitch [µN·m]").front(), minus + "0.3000");
    QCOMPARE(row(sections, "Stiffness of the film", "Roll [µN·m]").back(), QStringLiteral("0.08000"));
}

void TestAttitudeSections::scalesSensitivitiesToTheUnitsOfTheFields()
{
    const Case c = sampleFilmCase();
    SteadyResult result = sampleResult(c);
    // 0.25 m of height per m of crown is 0.25 nm per nm; 2000 rad/m is 2 urad per nm.
    result.sensitivities = {{"abs.crown", "m", 0.25, 2000.0, -40.0, 0.2}};
    const auto sections = attitudeSections(c, result, QLocale::c());
    QVERIFY(has(sections, "Sensitivities"));
    QCOMPARE(row(sections, "Sensitivities", "crown, per nm"),
             (QStringList{"0.2500", "2.000", minus + "0.04000", "0.2000"}));
}

void TestAttitudeSections::leavesOutWhatThereIsNot()
{
    const Case c = sampleFilmCase();
    SteadyResult result = sampleResult(c);
    result.stiffness.reset();
    result.interestSpacing.clear();
    const auto sections = attitudeSections(c, result, QLocale::c());
    for (const char* title : {"Stiffness of the film", "Points of interest", "Sensitivities", "Other equilibria"})
        QVERIFY2(!has(sections, title), title);
    for (const char* title : {"Attitude", "Air bearing", "Solution"}) QVERIFY2(has(sections, title), title);
}

void TestAttitudeSections::listsOtherEquilibria()
{
    const Case c = sampleFilmCase();
    SteadyResult result = sampleResult(c);
    result.otherEquilibria = {{250e-9, 40e-6, 0.0}};
    QCOMPARE(row(attitudeSections(c, result, QLocale::c()), "Other equilibria", "2"),
             (QStringList{"250.0" + nbsp + "nm", "40.00" + nbsp + "µrad", "0.000" + nbsp + "µrad"}));
}

void TestAttitudeSections::listsContactAndOtherStates()
{
    const Case c = sampleFilmCase();
    SteadyResult result = sampleResult(c);
    QVERIFY(!has(attitudeSections(c, result, QLocale::c()), "Contact"));
    result.contact = {.state = "held by menisci", .contact = 1e-3, .adhesion = -4e-3, .area = 2e-12};
    result.contactStates = {{{}, 7e-9, {.state = "flying", .diverges = true}}};
    const auto sections = attitudeSections(c, result, QLocale::c());
    QCOMPARE(row(sections, "Contact", "State"), QStringList{"held by menisci"});
    QCOMPARE(row(sections, "Contact", "Adhesion force"), QStringList{QStringLiteral("−4.000") + nbsp + "mN"});
    QCOMPARE(row(sections, "Other states", "flying, unstable"),
             (QStringList{"7.000" + nbsp + "nm", "0.000" + nbsp + "mN"}));
    QVERIFY(steadyText(result, QLocale::c()).contains("The slider is held by menisci: contact force 1.000"));
}

void TestAttitudeSections::keepsTheOutcomeOfAFailure()
{
    SteadyResult result;
    const auto sections = attitudeSections(sampleFilmCase(), result, QLocale::c());
    QCOMPARE(sections.size(), std::size_t(1));
    QCOMPARE(row(sections, "Solution", "Status"), QStringList{"failed"});
}

void TestAttitudeSections::copiesAsATable()
{
    const QString text = sectionsAsText({{"A", {"x", "y"}, {{"one", "1", "2"}}}, {"B", {}, {{"two", "3"}}}});
    QCOMPARE(text, QStringLiteral("A\tx\ty\none\t1\t2\n\nB\ntwo\t3\n"));
}

void TestAttitudeSections::saysTheOutcomeInASentence_data()
{
    QTest::addColumn<SteadyStatus>("status");
    QTest::addColumn<QString>("message");
    QTest::addColumn<QString>("begins");
    QTest::addColumn<bool>("withState");
    QTest::newRow("converged") << SteadyStatus::Converged << ""
                               << "Minimum spacing " << true;
    QTest::newRow("not converged") << SteadyStatus::NotConverged << "the residual stays at 1e-3"
                                   << "The residual stays at 1e-3. " << true;
    QTest::newRow("stopped") << SteadyStatus::Cancelled << ""
                             << "Stopped." << false;
    QTest::newRow("failed") << SteadyStatus::Failed << "the slider does not fly"
                            << "The slider does not fly." << false;
}

void TestAttitudeSections::saysTheOutcomeInASentence()
{
    QFETCH(const SteadyStatus, status);
    QFETCH(const QString, message);
    QFETCH(const QString, begins);
    QFETCH(const bool, withState);
    SteadyResult result = sampleResult(sampleFilmCase());
    result.status = status;
    result.message = message.toStdString();
    const QString text = steadyText(result, QLocale::c());
    QVERIFY2(text.startsWith(begins), qPrintable(text));
    QCOMPARE(text.contains("100.0" + nbsp + "±" + nbsp + "0.3" + nbsp + "µrad"), withState);
}

void TestAttitudeSections::usesTheDecimalComma()
{
    const QLocale german(QLocale::German, QLocale::Germany);
    QCOMPARE(withError(std::numeric_limits<double>::quiet_NaN(), 0.0, "mN", german), QStringLiteral("not known"));
    QCOMPARE(withError(7.0312e-9, 0.02e-9, "nm", german), "7,03" + nbsp + "±" + nbsp + "0,02" + nbsp + "nm");
    QCOMPARE(withError(12345.6e-9, 0.0, "nm", german), "12346" + nbsp + "nm"); // no dots that look like decimals
    const Case c = sampleFilmCase();
    QCOMPARE(row(attitudeSections(c, sampleResult(c), german), "Points of interest", "P2").back(),
             QStringLiteral("0,840; 0,220"));
}

TOUCHDOWN_TEST(TestAttitudeSections)

} // namespace test_attitude_sections

#include "test_attitude_sections.moc"

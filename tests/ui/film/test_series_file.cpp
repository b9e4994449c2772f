// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/series_file.h"

#include <QTemporaryDir>
#include <QtTest>

#include "core/results/steady_reader.h"
#include "tests/support/sample_steady.h"
#include "tests/support/test_program.h"
#include "ui/film/series_points.h"

using namespace touchdown;

namespace test_series_file {

class TestSeriesFile : public QObject {
    Q_OBJECT

private slots:
    void listsThePointsOfEachChoice_data();
    void listsThePointsOfEachChoice();
    void keepsWhatIsSolvedSoFar();
    void refusesAnotherFile();
};

void TestSeriesFile::listsThePointsOfEachChoice_data()
{
    QTest::addColumn<int>("varied");
    QTest::newRow("radius") << static_cast<int>(Varied::Radius);
    QTest::newRow("skew") << static_cast<int>(Varied::Skew);
    QTest::newRow("speed") << static_cast<int>(Varied::Speed);
    QTest::newRow("altitude") << static_cast<int>(Varied::Altitude);
    QTest::newRow("lists of the case") << static_cast<int>(Varied::Lists);
}

/// The case that is written lists the points that were solved.
void TestSeriesFile::listsThePointsOfEachChoice()
{
    QFETCH(const int, varied);
    Case c = test::sampleFilmCase();
    if (static_cast<Varied>(varied) == Varied::Lists) {
        c.steady.radii = {20e-3, 25e-3};
        c.steady.speeds = {500.0, 600.0, 700.0};
    }
    SeriesChoice choice = usualChoice(c, static_cast<Varied>(varied));
    choice.skewTo = choice.skewFrom + 0.1; // between the first and the last radius
    const std::vector<SteadySeriesPoint> points = pointsOf(c, choice);
    QVERIFY(points.size() > 1);
    const std::vector<SteadySeriesPoint> listed = seriesOf(listing(c, points));
    QCOMPARE(listed.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        QCOMPARE(listed[i].radius, points[i].radius);
        QCOMPARE(listed[i].skew, points[i].skew);
        QCOMPARE(listed[i].speed, points[i].speed);
        QCOMPARE(listed[i].altitude, points[i].altitude);
    }
}

void TestSeriesFile::keepsWhatIsSolvedSoFar()
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("series.h5"));
    Case c = test::sampleFilmCase();
    c.steady.radii = {20e-3, 25e-3, 30e-3};
    SteadyResult numbers = test::sampleSteady(), none;
    numbers.pressure = numbers.gap = numbers.recess = {};
    none.message = "the slider does not fly";
    QCOMPARE(writeSeries(file, {c, {numbers, none}, {}}), QString());
    const StoredSeries back = readSeries(file);
    QCOMPARE(back.problem, QString());
    QCOMPARE(back.value.steady.radii, c.steady.radii);
    QCOMPARE(back.results.size(), std::size_t(2));
    QCOMPARE(back.results[0].minimumSpacing, numbers.minimumSpacing);
    QCOMPARE(back.results[1].status, SteadyStatus::Failed);
    QCOMPARE(back.results[1].message, none.message);
    // What was read can be written again.
    QCOMPARE(writeSeries(file, back), QString());
    QCOMPARE(readSeries(file).results[0].minimumSpacing, numbers.minimumSpacing);
    // `touchdown` reads the file as one of its own.
    QCOMPARE(readSteady(file.toStdString()).problem, std::string());
}

void TestSeriesFile::refusesAnotherFile()
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("series.h5"));
    QVERIFY(!readSeries(file).problem.isEmpty());
    QFile text(file);
    QVERIFY(text.open(QIODevice::WriteOnly) && text.write("no results") > 0);
    text.close();
    QVERIFY2(readSeries(file).problem.contains(file), qPrintable(readSeries(file).problem));
}

TOUCHDOWN_TEST(TestSeriesFile)

} // namespace test_series_file

#include "test_series_file.moc"

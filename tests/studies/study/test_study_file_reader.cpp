// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/study/study_file_reader.h"

#include <filesystem>
#include <limits>

#include <QTemporaryDir>
#include <QtTest>

#include "core/case_files/case_text.h"
#include "core/formats/hdf5_file.h"
#include "core/studies/study/study_file.h"
#include "tests/support/test_program.h"
#include "tests/ui/sample_study.h"

using namespace touchdown;

namespace test_study_file_reader {

class TestStudyFileReader : public QObject {
    Q_OBJECT

private slots:
    void readsWhatWasWritten();
    void readsUnknownValues();
    void readsAFoundCase();
    void refusesOtherFiles();
    void refusesADamagedFile_data();
    void refusesADamagedFile();

private:
    std::string path() const { return folder_.filePath(QStringLiteral("study.h5")).toStdString(); }
    std::string write(const StudyReport& report) { return writeStudy(path(), report, Case{}, "# case", "# study"); }

    QTemporaryDir folder_;
};

/// Written again, a report that was read makes the same tables and charts: compared number by number.
void TestStudyFileReader::readsWhatWasWritten()
{
    const StudyReport report = sampleReport();
    QCOMPARE(write(report), std::string());
    const StoredStudy stored = readStudy(path());
    QCOMPARE(stored.problem, std::string());
    QCOMPARE(stored.caseText, std::string("# case"));
    QCOMPARE(stored.studyText, std::string("# study"));
    QCOMPARE(stored.report.kind, report.kind);
    QCOMPARE(stored.report.title, report.title);
    QCOMPARE(stored.report.status, StudyStatus::Completed);
    QCOMPARE(stored.report.findings, report.findings);
    QCOMPARE(stored.report.warnings, report.warnings);
    QCOMPARE(stored.report.wallSeconds, 1.5);
    QVERIFY(!stored.report.found);
    QCOMPARE(stored.report.tables.size(), std::size_t(1));
    const StudyTable &table = stored.report.tables[0], &before = report.tables[0];
    QCOMPARE(table.name, before.name);
    QCOMPARE(table.rows, before.rows);
    for (std::size_t i = 0; i < before.columns.size(); ++i) {
        QCOMPARE(table.columns[i].name, before.columns[i].name);
        QCOMPARE(table.columns[i].unit, before.columns[i].unit);
        QCOMPARE(table.columns[i].displayUnit, before.columns[i].displayUnit);
        QCOMPARE(table.columns[i].longName, before.columns[i].longName);
    }
    QCOMPARE(stored.report.charts.size(), report.charts.size());
    for (std::size_t i = 0; i < report.charts.size(); ++i) {
        QCOMPARE(stored.report.charts[i].title, report.charts[i].title);
        QCOMPARE(stored.report.charts[i].caption, report.charts[i].caption);
        QCOMPARE(stored.report.charts[i].panels.size(), report.charts[i].panels.size());
        for (std::size_t j = 0; j < report.charts[i].panels.size(); ++j) {
            const ChartPanel &now = stored.report.charts[i].panels[j], &then = report.charts[i].panels[j];
            QCOMPARE(now.x.label, then.x.label);
            QCOMPARE(now.y.unit, then.y.unit);
            QCOMPARE(now.y.displayUnit, then.y.displayUnit);
            QCOMPARE(now.x.logarithmic, then.x.logarithmic);
            QCOMPARE(now.equalScales, then.equalScales);
            QCOMPARE(now.series.size(), then.series.size());
            for (std::size_t k = 0; k < then.series.size(); ++k) {
                QCOMPARE(now.series[k].name, then.series[k].name);
                QCOMPARE(now.series[k].line, then.series[k].line);
                QCOMPARE(now.series[k].markers, then.series[k].markers);
                QCOMPARE(now.series[k].quiet, then.series[k].quiet);
                QCOMPARE(now.series[k].points.size(), then.series[k].points.size());
                for (std::size_t n = 0; n < then.series[k].points.size(); ++n) {
                    const ChartPoint &p = now.series[k].points[n], &q = then.series[k].points[n];
                    QVERIFY(p.x == q.x && p.y == q.y && p.label == q.label && p.kind == q.kind);
                    QVERIFY(p.chosen == q.chosen && p.xError == q.xError && p.yError == q.yError);
                }
            }
            QCOMPARE(now.bands.size(), then.bands.size());
            for (std::size_t k = 0; k < then.bands.size(); ++k) {
                QVERIFY(now.bands[k].alongX == then.bands[k].alongX && now.bands[k].label == then.bands[k].label);
                QVERIFY(now.bands[k].lower == then.bands[k].lower && now.bands[k].upper == then.bands[k].upper);
            }
            QCOMPARE(now.map.has_value(), then.map.has_value());
            if (!then.map) continue;
            QVERIFY(now.map->x == then.map->x && now.map->y == then.map->y && now.map->cells == then.map->cells);
            QVERIFY(now.map->details == then.map->details);
            QCOMPARE(now.map->classes.back().name, then.map->classes.back().name);
            QCOMPARE(now.map->classes.back().severity, then.map->classes.back().severity);
        }
    }
}

void TestStudyFileReader::readsUnknownValues()
{
    StudyReport report;
    report.status = StudyStatus::Failed;
    report.message = "It failed.";
    report.kind = "sweep";
    report.tables = {{"t", {{"name"}, {"all_known", "m"}, {"some", "s"}}, {}}};
    report.tables[0].rows = {{"a", 1.0, std::monostate{}}, {std::monostate{}, 2.0, 0.0}};
    QCOMPARE(write(report), std::string());
    const StoredStudy stored = readStudy(path());
    QCOMPARE(stored.problem, std::string());
    QCOMPARE(stored.report.status, StudyStatus::Failed);
    QCOMPARE(stored.report.message, report.message);
    QCOMPARE(stored.report.tables[0].rows, report.tables[0].rows);
}

void TestStudyFileReader::readsAFoundCase()
{
    StudyReport report = sampleReport();
    report.found.emplace();
    report.found->springs.flyingHeight = 4e-9;
    QCOMPARE(write(report), std::string());
    const StoredStudy stored = readStudy(path());
    QVERIFY(stored.report.found);
    QCOMPARE(stored.report.found->springs.flyingHeight, 4e-9);
}

void TestStudyFileReader::refusesOtherFiles()
{
    QVERIFY(!readStudy(folder_.filePath(QStringLiteral("none.h5")).toStdString()).problem.empty());
    {
        const Hdf5Access access;
        std::filesystem::remove(path());
        createHdf5File(path()).set("format", "touchdown-run");
    }
    QVERIFY(readStudy(path()).problem.find("not the report of a study") != std::string::npos);
}

void TestStudyFileReader::refusesADamagedFile_data()
{
    QTest::addColumn<QString>("array");
    QTest::newRow("a series") << "charts/1/panels/1/series/1/y";
    QTest::newRow("a table") << "tables/runs/step";
    QTest::newRow("cells of a map") << "charts/2/panels/1/map/cells";
}

/// An array that is shorter than its neighbours.
void TestStudyFileReader::refusesADamagedFile()
{
    QFETCH(const QString, array);
    QCOMPARE(write(sampleReport()), std::string());
    {
        const Hdf5Access access;
        const Hdf5Group file = openHdf5File(path(), H5F_ACC_RDWR);
        file.remove(array.toStdString());
        file.put(array.toStdString(), std::vector<double>{1.0});
    }
    const StoredStudy stored = readStudy(path());
    QVERIFY2(stored.problem.find("damaged") != std::string::npos, stored.problem.c_str());
    QVERIFY(stored.report.charts.empty());
}

TOUCHDOWN_TEST(TestStudyFileReader)

} // namespace test_study_file_reader

#include "test_study_file_reader.moc"

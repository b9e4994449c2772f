// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/study/study_file.h"

#include <chrono>
#include <limits>

#include <QtTest>

#include "core/formats/hdf5_file.h"
#include "core/studies/study/study_file_reader.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace std::chrono_literals;

namespace test_study_file {

namespace fs = std::filesystem;

constexpr double infinity = std::numeric_limits<double>::infinity();

StudyReport someReport()
{
    StudyReport report;
    report.kind = "work-precision";
    report.title = "Some study";
    report.findings = {"rk4 is slow.", "dopri5 is not."};
    report.warnings = {"The reference is uncertain."};
    report.wallSeconds = 1.5;
    StudyTable table{"runs", {{"method"}, {"error", "m", "nm", "Largest error"}, {"steps"}, {"note"}}, {}};
    table.rows = {{std::string("rk4"), 1e-9, 10.0, std::string("1,000 \"steps\"\nor so")},
                  {std::string("dopri5"), std::monostate{}, 20.0, std::monostate{}}};
    report.tables = {table, {"empty", {{"nothing"}}, {}}};

    ChartSeries series{"rk4", {}, ChartLine::Dashed, true, false};
    ChartPoint good{1e-3, 2e-9, "10 ns"}, failed{2e-3, 3e-9, "", PointKind::Failed};
    good.chosen = true;
    good.yError = 1e-10;
    series.points = {good, failed};
    ChartPanel panel;
    panel.x = {"Time", "s", "ms", true};
    panel.y = {"Error", "m", "nm", true};
    panel.series = {series};
    panel.bands = {{false, -infinity, 1e-12, "the reference"}};
    ChartMap map{{1.0, 2.0}, {5.0}, {{"agrees", 0}, {"diverged", 3}}, {1, -1}, {"far away", ""}};
    ChartPanel second;
    second.map = map;
    second.equalScales = true;
    report.charts = {{"A chart", "How to read it", {panel, second}}};
    return report;
}

class TestStudyFile : public QObject {
    Q_OBJECT

private slots:
    void head()
    {
        QCOMPARE(write(someReport()), std::string());
        const Hdf5Access access;
        const Hdf5Group file = open();
        QCOMPARE(file.attribute("format"), std::string("touchdown-study"));
        QCOMPARE(file.attribute("format_version"), std::string("1.2"));
        QCOMPARE(file.attribute("kind"), std::string("work-precision"));
        QCOMPARE(file.attribute("status"), std::string("completed"));
        QCOMPARE(file.attribute("title"), std::string("Some study"));
        QCOMPARE(file.get("case/text").text(), std::string("# the case"));
        QCOMPARE(file.get("study/text").text(), std::string("# the study"));
        QCOMPARE(texts(file, "findings"), (std::vector<std::string>{"rk4 is slow.", "dopri5 is not."}));
        QCOMPARE(texts(file, "warnings").size(), std::size_t{1});
        QVERIFY(!file.has("found"));
    }
    void tables()
    {
        QCOMPARE(write(someReport()), std::string());
        const Hdf5Access access;
        const Hdf5Group file = open();
        QCOMPARE(texts(file, "tables/runs/method"), (std::vector<std::string>{"rk4", "dopri5"}));
        QCOMPARE(numbers(file, "tables/runs/error"), (std::vector{1e-9, 0.0}));
        QCOMPARE(numbers(file, "tables/runs/error_known"), (std::vector{1.0, 0.0}));
        QCOMPARE(numbers(file, "tables/runs/steps"), (std::vector{10.0, 20.0}));
        QVERIFY(!file.has("tables/runs/steps_known"));
        QCOMPARE(texts(file, "tables/runs/note")[1], std::string());
        QCOMPARE(file.get("tables/runs/error").attribute("unit"), std::string("m"));
        QCOMPARE(file.get("tables/runs/error").attribute("display_unit"), std::string("nm"));
        QCOMPARE(file.group("tables").names(), (std::vector<std::string>{"runs", "empty"}));
        QVERIFY(numbers(file, "tables/empty/nothing").empty());
    }
    void charts()
    {
        QCOMPARE(write(someReport()), std::string());
        const Hdf5Access access;
        const Hdf5Group file = open();
        QCOMPARE(file.group("charts/1").attribute("caption"), std::string("How to read it"));
        const Hdf5Group panel = file.group("charts/1/panels/1");
        QCOMPARE(panel.attribute("x_display_unit"), std::string("ms"));
        const Hdf5Group series = panel.group("series/1");
        QCOMPARE(series.attribute("line"), std::string("dashed"));
        QCOMPARE(numbers(series, "x"), (std::vector{1e-3, 2e-3}));
        QCOMPARE(numbers(series, "y_error"), (std::vector{1e-10, 0.0}));
        QCOMPARE(numbers(series, "chosen"), (std::vector{1.0, 0.0}));
        QCOMPARE(texts(series, "kind"), (std::vector<std::string>{"good", "failed"}));
        QCOMPARE(texts(series, "label"), (std::vector<std::string>{"10 ns", ""}));
        const Hdf5Group band = panel.group("bands/1");
        QCOMPARE(band.attribute("along"), std::string("y"));
        QVERIFY(H5Aexists(band, "lower") == 0);
        QVERIFY(H5Aexists(band, "upper") > 0);
        const Hdf5Group map = file.group("charts/1/panels/2/map");
        QCOMPARE(numbers(map, "cells"), (std::vector{1.0, -1.0}));
        QCOMPARE(texts(map, "class_name"), (std::vector<std::string>{"agrees", "diverged"}));
        QCOMPARE(numbers(map, "class_severity"), (std::vector{0.0, 3.0}));
        QCOMPARE(texts(map, "details"), (std::vector<std::string>{"far away", ""}));
    }
    /// What no study should give: it does not reach the file as a number.
    void neverNotANumber()
    {
        StudyReport report = someReport();
        report.tables[0].rows[0][1] = infinity;
        report.charts[0].panels[0].series[0].points[0].y = std::numeric_limits<double>::quiet_NaN();
        QCOMPARE(write(report), std::string());
        const Hdf5Access access;
        const Hdf5Group file = open();
        QCOMPARE(numbers(file, "tables/runs/error_known"), (std::vector{0.0, 0.0}));
        QCOMPARE(numbers(file, "charts/1/panels/1/series/1/x"), std::vector{2e-3});
    }
    void endedEarly()
    {
        StudyReport report;
        report.status = StudyStatus::Cancelled;
        report.message = "stopped";
        report.found.emplace().title = "Advised";
        QCOMPARE(write(report), std::string());
        const Hdf5Access access;
        const Hdf5Group file = open();
        QCOMPARE(file.attribute("status"), std::string("cancelled"));
        QVERIFY(file.get("found/text").text().find("Advised") != std::string::npos);
        QVERIFY(texts(file, "findings").empty());
    }
    /// After each part that was found; until the first, the earlier report stays.
    void aStudyUnderWayCanBeRead()
    {
        StudyWriter writer(0ms);
        QCOMPARE(writer.open(path("way.h5"), {"work-precision", "Some title", Case{}, "# the case", "# the study"}),
                 std::string());
        QCOMPARE(writer.update(nullptr), std::string());
        QVERIFY(!QFile::exists(QString::fromStdString(path("way.h5").string())));
        StudyReport part = someReport();
        part.kind.clear();
        QCOMPARE(writer.update(&part), std::string());
        const StoredStudy stored = readStudy(path("way.h5"));
        QCOMPARE(stored.problem, std::string());
        QCOMPARE(stored.report.status, StudyStatus::Interrupted);
        QVERIFY(stored.report.findings.empty()); // of all values alone
        QCOMPARE(stored.report.kind, std::string("work-precision"));
        QCOMPARE(stored.report.tables.front().rows.size(), std::size_t{2});
        QCOMPARE(stored.studyText, std::string("# the study"));
        QVERIFY(!writeStudy(path("way.h5"), part, Case{}, "", "").empty()); // another writer is refused
        QCOMPARE(writer.finish(someReport()), std::string());
        QCOMPARE(readStudy(path("way.h5")).report.status, StudyStatus::Completed);
        QVERIFY(!writer.update(&part).empty());
    }
    void aStudyUnderWayIsWrittenOnceInAWhile()
    {
        StudyWriter writer(std::chrono::hours(1));
        QCOMPARE(writer.open(path("b.h5"), {"work-precision", "", Case{}, "", ""}), std::string());
        StudyReport part = someReport();
        QCOMPARE(writer.update(&part), std::string());
        part.tables.clear();
        QCOMPARE(writer.update(&part), std::string());
        QVERIFY(!readStudy(path("b.h5")).report.tables.empty());
        QCOMPARE(writer.finish(part), std::string());
        QVERIFY(readStudy(path("b.h5")).report.tables.empty());
    }
    void csv()
    {
        QCOMPARE(writeStudyCsv(path("a.csv"), someReport()), std::string());
        QFile file(QString::fromStdString(path("a.csv").string()));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(
            file.readAll(),
            QByteArray("method,error [m],steps,note\r\nrk4,1e-9,10,\"1,000 \"\"steps\"\"\nor so\"\r\ndopri5,,20,\r\n"));
    }
    void nothingHalfWritten()
    {
        QDir folder(folder_.path());
        for (const char* target : {"no/such.h5", "."}) {
            const std::string problem = writeStudy(path(target), someReport(), Case{}, "", "");
            QVERIFY2(problem.starts_with("cannot write to "), problem.c_str());
        }
        QVERIFY(!writeStudyCsv(path("no/such.csv"), someReport()).empty());
        QVERIFY(writeStudyCsv(path("b.csv"), StudyReport{}).ends_with("the study has no table to write"));
        QVERIFY(!folder.exists("b.csv"));
        QVERIFY(folder.entryList({"*.touchdown.*"}, QDir::Files).isEmpty());
    }

private:
    fs::path path(const char* name) const { return fs::path(folder_.path().toStdString()) / name; }
    std::string write(const StudyReport& report) const
    {
        return writeStudy(path("a.h5"), report, Case{}, "# the case", "# the study");
    }
    Hdf5Group open() const { return openHdf5File(path("a.h5")); }
    static std::vector<double> numbers(const Hdf5Group& at, const std::string& name) { return at.get(name).column(); }
    static std::vector<std::string> texts(const Hdf5Group& at, const std::string& name)
    {
        const Hdf5Dataset array = at.get(name);
        const Hdf5Handle space(H5Dget_space(array), H5Sclose);
        std::vector<char*> read(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
        if (!read.empty()) checkHdf5(H5Dread(array, hdf5TextType(), H5S_ALL, H5S_ALL, H5P_DEFAULT, read.data()));
        std::vector<std::string> list(read.begin(), read.end());
        if (!read.empty()) checkHdf5(H5Dvlen_reclaim(hdf5TextType(), space, H5P_DEFAULT, read.data()));
        return list;
    }
    QTemporaryDir folder_;
};

TOUCHDOWN_TEST(TestStudyFile)

} // namespace test_study_file

#include "test_study_file.moc"

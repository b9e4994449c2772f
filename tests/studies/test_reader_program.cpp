// SPDX-License-Identifier: GPL-3.0-or-later
//
// HDF5 files that are damaged or made to harm: each ends in an answer or in one sentence, and this program lives.
#include "core/studies/reader_program.h"

#include <sys/resource.h>
#include <sys/stat.h>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <functional>
#include <random>

#include "core/formats/hdf5_file.h"
#include "core/formats/reader_process.h"
#include "core/formats/surfaces/height_map_file.h"
#include "core/formats/surfaces/height_map_hdf5.h"
#include "core/results/file_header.h"
#include "core/results/results_reader.h"
#include "core/results/steady_reader.h"
#include "core/results/steady_writer.h"
#include "core/studies/study/study_file.h"
#include "core/studies/study/study_file_reader.h"
#include "tests/support/sample_results.h"
#include "tests/support/sample_steady.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_reader_program {

using Fill = std::function<void(const Hdf5Group&)>;

constexpr hsize_t nx = 24, ny = 16;

std::vector<double> places(hsize_t count)
{
    std::vector<double> all;
    for (hsize_t i = 0; i < count; ++i) all.push_back(static_cast<double>(i));
    return all;
}

std::vector<double> heights()
{
    std::vector<double> all;
    for (hsize_t k = 0; k < nx * ny; ++k) all.push_back(std::sin(0.3 * static_cast<double>(k)));
    return all;
}

void writePlaces(const Hdf5Group& file)
{
    file.put("x", places(nx)).set("unit", "um");
    file.put("y", places(ny)).set("unit", "um");
}

/// A dataset "height" of this shape and these properties, without numbers.
Hdf5Dataset emptyHeight(const Hdf5Group& file, hsize_t rows, hsize_t columns, const Hdf5Handle& list)
{
    const hsize_t size[] = {rows, columns};
    const Hdf5Handle space(H5Screate_simple(2, size, nullptr), H5Sclose);
    Hdf5Dataset dataset(H5Dcreate2(file, "height", H5T_IEEE_F64LE, space, H5P_DEFAULT, list, H5P_DEFAULT), H5Dclose);
    dataset.set("unit", "nm");
    return dataset;
}

Hdf5Handle creation() { return {H5Pcreate(H5P_DATASET_CREATE), H5Pclose}; }

void writeAll(const Hdf5Dataset& dataset)
{
    checkHdf5(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, heights().data()));
}

bool isSentence(const std::string& text)
{
    return !text.empty() && text.size() < 1000 && text.find('\n') == std::string::npos;
}

/// Largest memory of all second processes so far [MiB].
long readerMemory()
{
    rusage used{};
    getrusage(RUSAGE_CHILDREN, &used);
    return used.ru_maxrss / 1024;
}

class TestReaderProgram : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    QByteArray map_; // a good one

    std::filesystem::path path(const char* name = "map.h5") const { return folder_.filePath(name).toStdString(); }

    std::filesystem::path written(const Fill& fill) const
    {
        const Hdf5Access access;
        std::filesystem::remove(path());
        fill(createHdf5File(path()));
        return path();
    }

    static void put(const std::filesystem::path& file, const QByteArray& bytes)
    {
        QFile target(QString::fromStdString(file.string()));
        QVERIFY(target.open(QIODevice::WriteOnly));
        target.write(bytes);
    }

    static QByteArray bytesOf(const std::filesystem::path& file)
    {
        QFile source(QString::fromStdString(file.string()));
        return source.open(QIODevice::ReadOnly) ? source.readAll() : QByteArray();
    }

    void tryMap(const QByteArray& bytes) const
    {
        put(path(), bytes);
        const HeightMapDocument document = readHeightMap(path(), "map.h5");
        if (document.valid()) {
            QCOMPARE(document.map.heights.size(), static_cast<std::size_t>(document.map.nx * document.map.ny));
            for (const double height : document.map.heights) QVERIFY(std::isfinite(height));
        } else {
            QCOMPARE(document.problems.size(), std::size_t{1});
            QVERIFY(isSentence(document.problems.front().text()));
        }
    }

    /// One byte changed, at `count` places.
    static std::vector<QByteArray> damaged(const QByteArray& good, int count)
    {
        std::mt19937 random(20261126);
        std::vector<QByteArray> all;
        for (int i = 0; i < count; ++i) {
            QByteArray bytes = good;
            bytes[static_cast<qsizetype>(random() % static_cast<unsigned>(good.size()))] = static_cast<char>(random());
            all.push_back(bytes);
        }
        return all;
    }

private slots:
    void initTestCase()
    {
        map_ = bytesOf(written([](const Hdf5Group& file) {
            writePlaces(file);
            file.table("height", ny, nx, heights().data(), "nm", "Height");
        }));
        QVERIFY(map_.size() > 2000);
    }

    void aGoodMapIsThatOfThisProcess()
    {
        put(path(), map_);
        const HeightMapDocument document = readHeightMap(path(), "map.h5");
        QVERIFY(document.valid());
        QVERIFY(document.map == readHeightMapHdf5(path()));
        QCOMPARE(document.map.heights.size(), std::size_t{nx * ny});
        // The units of the case reach the second process.
        const HeightMapDocument other = readHeightMap(path(), "map.h5", "mm");
        QVERIFY(other.problems.front().message.find("another unit") != std::string::npos);
    }

    void oneWrongByte()
    {
        for (const QByteArray& bytes : damaged(map_, 150)) tryMap(bytes);
        QVERIFY2(readerMemory() < 200, qPrintable(QString::number(readerMemory())));
    }

    // Texts of attributes lie in a heap whose lengths the library believes: it reads outside its memory, or for ever.
    void wrongLengthsInTheHeap()
    {
        const qsizetype heap = map_.indexOf("GCOL");
        QVERIFY(heap > 0);
        for (qsizetype at = heap + 8; at < heap + 72; ++at) {
            QByteArray bytes = map_;
            bytes[at] = static_cast<char>(at % 2 == 0 ? 127 : 255);
            tryMap(bytes);
        }
        // The free space at the end of the heap, with every small length.
        for (int length = 0; length < 40; length += 8) {
            QByteArray bytes = map_;
            qsizetype at = heap + 16;
            const auto number = [&](qsizetype place, int count) {
                quint64 value = 0;
                for (int k = count; k-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[place + k]);
                return value;
            };
            while (number(at, 2) != 0) at += 16 + static_cast<qsizetype>((number(at + 8, 8) + 7) / 8 * 8);
            bytes[at + 8] = static_cast<char>(length);
            bytes[at + 9] = 0;
            tryMap(bytes);
        }
        QVERIFY2(readerMemory() < 200, qPrintable(QString::number(readerMemory())));
    }

    void filesMadeToHarm_data()
    {
        QTest::addColumn<Fill>("fill");
        QTest::addColumn<QByteArray>("says");
        const std::string other = folder_.filePath("private.bin").toStdString();
        const std::string source = folder_.filePath("source.h5").toStdString();
        put(other, QByteArray(nx * ny * sizeof(double), '\1'));
        {
            const Hdf5Access access;
            const Hdf5Group file = createHdf5File(source);
            writeAll(emptyHeight(file, ny, nx, creation()));
        }
        const auto row = [](const char* name, const Fill& fill, const char* says) {
            QTest::newRow(name) << fill << QByteArray(says);
        };
        row(
            "external storage",
            [other](const Hdf5Group& file) {
                writePlaces(file);
                const Hdf5Handle list = creation();
                checkHdf5(H5Pset_external(list, other.c_str(), 0, nx * ny * sizeof(double)));
                emptyHeight(file, ny, nx, list);
            },
            "in another file, which is not read");
        row(
            "external link",
            [source](const Hdf5Group& file) {
                writePlaces(file);
                checkHdf5(H5Lcreate_external(source.c_str(), "/height", file, "height", H5P_DEFAULT, H5P_DEFAULT));
            },
            "is a link to another place or file");
        row(
            "soft link through an external one",
            [source](const Hdf5Group& file) {
                writePlaces(file);
                checkHdf5(H5Lcreate_external(source.c_str(), "/", file, "other", H5P_DEFAULT, H5P_DEFAULT));
                checkHdf5(H5Lcreate_soft("/other/height", file, "height", H5P_DEFAULT, H5P_DEFAULT));
            },
            "is a link to another place or file");
        row(
            "virtual dataset",
            [source](const Hdf5Group& file) {
                writePlaces(file);
                const hsize_t size[] = {ny, nx};
                const Hdf5Handle space(H5Screate_simple(2, size, nullptr), H5Sclose);
                const Hdf5Handle list = creation();
                checkHdf5(H5Pset_virtual(list, space, source.c_str(), "/height", space));
                emptyHeight(file, ny, nx, list);
            },
            "is virtual: its numbers lie in other files");
        row(
            "pieces of 4 GB",
            [](const Hdf5Group& file) {
                writePlaces(file);
                const hsize_t chunk[] = {20000, 25000}, most[] = {H5S_UNLIMITED, H5S_UNLIMITED}, size[] = {ny, nx};
                const Hdf5Handle list = creation();
                checkHdf5(H5Pset_chunk(list, 2, chunk));
                checkHdf5(H5Pset_deflate(list, 6));
                const Hdf5Handle space(H5Screate_simple(2, size, most), H5Sclose);
                const Hdf5Dataset dataset(
                    H5Dcreate2(file, "height", H5T_IEEE_F64LE, space, H5P_DEFAULT, list, H5P_DEFAULT), H5Dclose);
                dataset.set("unit", "nm");
                const hsize_t first[] = {0, 0};
                const std::vector<char> packed(100'000);
                checkHdf5(H5Dwrite_chunk(dataset, H5P_DEFAULT, 0, first, packed.size(), packed.data()));
            },
            "is stored in pieces that are larger than the array itself");
        row(
            "another filter",
            [](const Hdf5Group& file) {
                writePlaces(file);
                const hsize_t chunk[] = {ny, nx};
                const Hdf5Handle list = creation();
                checkHdf5(H5Pset_chunk(list, 2, chunk));
                checkHdf5(H5Pset_scaleoffset(list, H5Z_SO_FLOAT_DSCALE, 3));
                writeAll(emptyHeight(file, ny, nx, list));
            },
            "is stored with the filter 6");
        row(
            "never written",
            [](const Hdf5Group& file) {
                file.put("x", places(8000)).set("unit", "um");
                file.put("y", places(8000)).set("unit", "um");
                const hsize_t chunk[] = {100, 100};
                const Hdf5Handle list = creation();
                checkHdf5(H5Pset_chunk(list, 2, chunk));
                emptyHeight(file, 8000, 8000, list);
            },
            "fewer numbers than it says");
        row(
            "too many points",
            [](const Hdf5Group& file) {
                writePlaces(file);
                emptyHeight(file, 1'000'000, 1'000'000, creation());
            },
            "x and y ask for 16 x 24 points");
        row(
            "an attribute of a million numbers",
            [](const Hdf5Group& file) {
                writePlaces(file);
                const Hdf5Dataset dataset = emptyHeight(file, ny, nx, creation());
                writeAll(dataset);
                const hsize_t count = 8000;
                const Hdf5Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose);
                const Hdf5Handle attribute(
                    H5Acreate2(dataset, "_FillValue", H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
                checkHdf5(H5Awrite(attribute, H5T_NATIVE_DOUBLE, places(count).data()));
            },
            "the attribute \"_FillValue\" is too long");
    }
    void filesMadeToHarm()
    {
        QFETCH(Fill, fill);
        QFETCH(QByteArray, says);
        const HeightMapDocument document = readHeightMap(written(fill), "map.h5");
        QCOMPARE(document.problems.size(), std::size_t{1});
        const std::string text = document.problems.front().text();
        QVERIFY2(isSentence(text) && text.find(says.toStdString()) != std::string::npos, text.c_str());
        QVERIFY2(readerMemory() < 200, qPrintable(QString::number(readerMemory())));
    }

    void whatIsNoFile()
    {
        QVERIFY(mkfifo(path("fifo.h5").c_str(), 0600) == 0);
        std::filesystem::create_directory(path("folder.h5"));
        std::filesystem::create_symlink("/dev/zero", path("device.h5"));
        std::filesystem::create_symlink("/proc/self/environ", path("system.h5"));
        const auto problem = [](const std::filesystem::path& file) {
            const HeightMapDocument document = readHeightMap(file, "a.h5");
            return document.valid() ? std::string() : document.problems.front().message;
        };
        QCOMPARE(problem(path("fifo.h5")), std::string("is not a regular file"));
        QCOMPARE(problem(path("device.h5")), std::string("is not a regular file"));
        QCOMPARE(problem(path("system.h5")), std::string("is not a regular file"));
        QCOMPARE(problem(path("folder.h5")), std::string("is a directory, not a file"));
        for (const char* name : {"fifo.h5", "device.h5", "system.h5"}) {
            QVERIFY(readResults(path(name)).problem.find("no regular file") != std::string::npos);
            QVERIFY(readSteady(path(name)).problem.find("no regular file") != std::string::npos);
            QCOMPARE(formatOf(path(name)), std::string());
        }
    }

    void damagedResults()
    {
        ResultsWriter writer;
        QCOMPARE(writer.open(path("run.h5"), sampleCase(), sampleCaseText, sampleQuantities), std::string());
        QCOMPARE(writer.append(sampleBatch(0, 500)), std::string());
        QCOMPARE(writer.finish(sampleSummary()), std::string());
        const StoredRun here = readResultsDirectly(path("run.h5")), there = readResults(path("run.h5"));
        QCOMPARE(there.problem, std::string());
        QCOMPARE(there.caseText, here.caseText);
        QCOMPARE(there.quantities.size(), here.quantities.size());
        QCOMPARE(there.quantities.back().longName, here.quantities.back().longName);
        QVERIFY(there.samples.time == here.samples.time && there.samples.columns == here.samples.columns);
        for (const QByteArray& bytes : damaged(bytesOf(path("run.h5")), 60)) {
            put(path("bad.h5"), bytes);
            formatOf(path("bad.h5"));
            const StoredRun run = readResults(path("bad.h5"));
            if (run.problem.empty())
                QCOMPARE(run.samples.columns.size(), run.quantities.size());
            else
                QVERIFY(isSentence(run.problem));
        }
    }

    void damagedStaticStates()
    {
        SteadyWriter writer;
        QCOMPARE(writer.open(path("steady.h5"), test::sampleFilmCase(), "model = \"film\"\n"), std::string());
        QCOMPARE(writer.add({23e-3, 0.1, 565.0, {}}, test::sampleSteady()), std::string());
        QCOMPARE(writer.finish(SteadyStatus::Converged, ""), std::string());
        QCOMPARE(readSteady(path("steady.h5")).problem, std::string());
        QCOMPARE(readSteady(path("steady.h5")).states.front().pressure, test::sampleSteady().pressure);
        for (const QByteArray& bytes : damaged(bytesOf(path("steady.h5")), 40)) {
            put(path("bad.h5"), bytes);
            const StoredSteady stored = readSteady(path("bad.h5"));
            QVERIFY(stored.problem.empty() ? stored.states.size() < 2 : isSentence(stored.problem));
        }
    }

    void damagedReports()
    {
        StudyReport report;
        report.kind = "hysteresis";
        report.findings = {"One.", "Two."};
        ChartPanel panel;
        panel.series = {{"up", {{1.0, 2.0, "a"}, {2.0, 3.0}}}};
        panel.map = ChartMap{{1.0, 2.0}, {1.0}, {{"good", 0}}, {0, -1}, {"first", "second"}};
        report.charts = {{"Chart", "Caption.", {panel}}};
        report.tables = {{"runs", {{"a", "m", "nm", "A"}, {"b"}}, {{1.0, "x"}, {{}, "y"}}}};
        report.found = sampleCase();
        QCOMPARE(writeStudy(path("study.h5"), report, sampleCase(), sampleCaseText, ""), std::string());
        const StoredStudy there = readStudy(path("study.h5"));
        QCOMPARE(there.problem, std::string());
        QCOMPARE(there.caseText, sampleCaseText);
        QVERIFY(there.report.tables[0].rows == report.tables[0].rows);
        QVERIFY(there.report.found && there.report.found->springs.cutoff == sampleCase().springs.cutoff);
        QCOMPARE(there.report.charts[0].panels[0].map->cells, panel.map->cells);
        for (const QByteArray& bytes : damaged(bytesOf(path("study.h5")), 40)) {
            put(path("bad.h5"), bytes);
            const StoredStudy study = readStudy(path("bad.h5"));
            QVERIFY(study.problem.empty() || isSentence(study.problem));
        }
    }

    // A results file has no links: they would lead elsewhere.
    void resultsWithALink()
    {
        ResultsWriter writer;
        QCOMPARE(writer.open(path("run.h5"), sampleCase(), sampleCaseText, sampleQuantities), std::string());
        QCOMPARE(writer.finish(sampleSummary()), std::string());
        QCOMPARE(writeStudy(path("study.h5"), {}, sampleCase(), sampleCaseText, ""), std::string());
        for (const auto& [name, link] : {std::pair{"run.h5", "timeseries/other"}, {"study.h5", "tables/other"}}) {
            const Hdf5Access access;
            const Hdf5Group file = openHdf5File(path(name), H5F_ACC_RDWR);
            checkHdf5(H5Lcreate_external("other.h5", "/height", file, link, H5P_DEFAULT, H5P_DEFAULT));
        }
        QVERIFY(readResults(path("run.h5")).problem.find("is a link to another place or file") != std::string::npos);
        QVERIFY(readStudy(path("study.h5")).problem.find("is a link to another place or file") != std::string::npos);
    }

    // A file of one second of computing time is small; the limits grow with the file.
    void limitsGrowWithTheFile()
    {
        const ReaderLimits small = readerLimits(std::uintmax_t{10'000}), large = readerLimits(std::uintmax_t{1} << 30);
        QCOMPARE(small.seconds, 1u);
        QVERIFY(small.memory < std::uintmax_t{160} << 20);
        QVERIFY(large.seconds > 100 && large.memory > std::uintmax_t{16} << 30);
        QVERIFY(readerLimits(std::uintmax_t{1} << 62).memory > large.memory);
    }
};

TOUCHDOWN_TEST(TestReaderProgram)

} // namespace test_reader_program

#include "test_reader_program.moc"

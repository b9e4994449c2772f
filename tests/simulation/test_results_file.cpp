// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/results_file.h"

#include <cmath>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <random>

#include <QtTest>
#include <sys/resource.h>

#include "core/simulation/results_layout.h"

using namespace touchdown;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

const std::vector<Quantity> quantities{{"minimum_spacing", "m", "nm", "Minimum spacing"},
                                       {"pitch", "rad", "urad", "Pitch"}};

// Sample k of a column, so that every stored number can be foretold.
double sample(std::size_t column, std::size_t k)
{
    const auto x = static_cast<double>(k);
    return column == 0 ? x * 1e-7 : std::sin(x * 0.01 * static_cast<double>(column)) * 1e-9 + x * 1e-17;
}

SampleBatch batch(std::size_t first, std::size_t count)
{
    SampleBatch b;
    b.columns.resize(quantities.size());
    for (std::size_t k = first; k < first + count; ++k) {
        b.time.push_back(sample(0, k));
        for (std::size_t i = 0; i < b.columns.size(); ++i) b.columns[i].push_back(sample(i + 1, k));
    }
    return b;
}

// "" if the samples are the first ones of the series, each number exact.
QString wrongSample(const SampleBatch& samples)
{
    if (samples.columns.size() != quantities.size()) return "number of columns";
    for (std::size_t k = 0; k < samples.size(); ++k)
        for (std::size_t i = 0; i <= quantities.size(); ++i)
            if ((i == 0 ? samples.time[k] : samples.columns[i - 1][k]) != sample(i, k))
                return QString("column %1, sample %2").arg(i).arg(k);
    return {};
}

std::string bytes(const fs::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

void put(const fs::path& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }

Case testCase()
{
    Case c;
    c.title = "Ein Läufer über der Platte";
    c.springs.cutoff = 0.4e-9;
    return c;
}

const std::string caseText = "# µ and θ are fine here\ntitle = \"Ein Läufer über der Platte\"\n\n";

Summary summary()
{
    Summary s;
    s.status = RunStatus::Failed;
    s.message = "the rear air spring is lost";
    s.endTime = 2e-3;
    s.steps = 123;
    s.final = {{"minimum_spacing", 7e-9}, {"pitch", 90e-6}};
    s.tail = {{"pitch", {90e-6, 1e-9, 89e-6, 91e-6}}};
    s.events = {{1e-6, "touch-down"}, {2e-6, "rear spring lost"}};
    s.peaks = {{8e5, 1e-10}};
    s.warnings = {"a warning"};
    return s;
}

// The program that is killed: writes without end, and tells of each batch.
int writeUntilKilled(const char* file)
{
    ResultsWriter writer(1ms);
    std::string problem = writer.open(file, testCase(), caseText, quantities);
    for (std::size_t k = 0; problem.empty(); k += 700) {
        problem = writer.append(batch(k, 700));
        if (fs::exists(file)) {
            std::putchar('.');
            std::fflush(stdout);
        }
    }
    std::fprintf(stderr, "%s\n", problem.c_str());
    return 1;
}

} // namespace

class TestResultsFile : public QObject {
    Q_OBJECT

private slots:
    void init();
    void roundTrip_data();
    void roundTrip();
    void layout();
    void spectra_data();
    void spectra();
    void statusIsInterruptedWithoutFinish();
    void killedWritersLeaveWholeFiles();
    void oldFileStaysUntilTheNewOneIsWhole();
    void readersDuringARunDisturbNothing();
    void symbolicLinkStaysALink();
    void secondWriterToOneName();
    void fileRemovedDuringARun();
    void fullDisk();
    void refusedTargets_data();
    void refusedTargets();
    void unreadableFiles_data();
    void unreadableFiles();
    void samplesThatDoNotFit();
    void csvReadsBackExactly();
    void csvProblems_data();
    void csvProblems();

private:
    fs::path path(const char* name = "run.h5") const { return fs::path(folder_->path().toStdString()) / name; }
    std::unique_ptr<QTemporaryDir> folder_;
};

void TestResultsFile::init()
{
    folder_ = std::make_unique<QTemporaryDir>();
    QVERIFY(folder_->isValid());
}

// A chunk has 8192 samples; flushes come wherever they come.
void TestResultsFile::roundTrip_data()
{
    QTest::addColumn<int>("samples");
    QTest::addColumn<int>("step");
    QTest::addColumn<int>("interval");
    QTest::newRow("no samples") << 0 << 1 << 700;
    QTest::newRow("one sample") << 1 << 1 << 700;
    QTest::newRow("one less than a chunk") << 8191 << 8191 << 700;
    QTest::newRow("a chunk") << 8192 << 1000 << 700;
    QTest::newRow("one more than a chunk, one flush") << 8193 << 777 << 700;
    QTest::newRow("many chunks, many flushes") << 100003 << 997 << 0;
    QTest::newRow("early flush, more than may wait") << 3000000 << 300000 << 3600000;
}

void TestResultsFile::roundTrip()
{
    QFETCH(int, samples);
    QFETCH(int, step);
    QFETCH(int, interval);
    const auto n = static_cast<std::size_t>(samples);
    ResultsWriter writer{std::chrono::milliseconds(interval)};
    QCOMPARE(writer.open(path(), testCase(), caseText, quantities), std::string());
    for (std::size_t k = 0; k < n; k += static_cast<std::size_t>(step)) {
        QCOMPARE(writer.append(batch(k, std::min(static_cast<std::size_t>(step), n - k))), std::string());
        QCOMPARE(writer.append({}), std::string());
    }
    QCOMPARE(writer.finish(summary()), std::string());

    const StoredRun run = readResults(path());
    QCOMPARE(run.problem, std::string());
    QCOMPARE(run.title, testCase().title);
    QCOMPARE(run.caseText, caseText);
    QCOMPARE(run.status, std::string("failed"));
    QCOMPARE(run.message, summary().message);
    QCOMPARE(run.softwareVersion, std::string(TOUCHDOWN_VERSION));
    QVERIFY(QDateTime::fromString(QString::fromStdString(run.date), Qt::ISODate).isValid());
    QVERIFY(run.date.ends_with('Z'));
    QCOMPARE(run.quantities.size(), quantities.size());
    for (std::size_t i = 0; i < quantities.size(); ++i) {
        QCOMPARE(run.quantities[i].name, quantities[i].name);
        QCOMPARE(run.quantities[i].unit, quantities[i].unit);
        QCOMPARE(run.quantities[i].displayUnit, quantities[i].displayUnit);
        QCOMPARE(run.quantities[i].longName, quantities[i].longName);
    }
    QCOMPARE(run.samples.size(), n);
    QCOMPARE(wrongSample(run.samples), QString());
    QVERIFY(!fs::exists(path("run.h5.part")));
}

void TestResultsFile::layout()
{
    ResultsWriter writer;
    QCOMPARE(writer.open(path(), testCase(), caseText, quantities), std::string());
    QCOMPARE(writer.append(batch(0, 10000)), std::string());
    QCOMPARE(writer.finish(summary()), std::string());

    const Hdf5Access access;
    const Hdf5Handle file(H5Fopen(path().c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    QCOMPARE(readHdf5Attribute(file, "format"), std::string("touchdown-run"));
    QCOMPARE(readHdf5Attribute(file, "format_version"), std::string("1.0"));
    const auto number = [&](const char* name) {
        double value = NAN;
        const Hdf5Handle dataset = openHdf5Dataset(file, name);
        checkHdf5(H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, &value));
        return value;
    };
    const auto unit = [&](const char* name) { return readHdf5Attribute(openHdf5Dataset(file, name), "unit"); };
    QCOMPARE(number("case/parameters/springs.cutoff"), 0.4e-9);
    QCOMPARE(unit("case/parameters/springs.cutoff"), std::string("m"));
    QCOMPARE(unit("case/parameters/ono_yamane.friction"), std::string("1"));
    QCOMPARE(readHdf5Text(file, "case/parameters/run.integrator"), std::string("dopri5"));
    QCOMPARE(number("summary/final/pitch"), 90e-6);
    QCOMPARE(unit("summary/final/pitch"), std::string("rad"));
    QCOMPARE(number("summary/tail/pitch/std"), 1e-9);
    QCOMPARE(number("summary/steps"), 123.0);
    QCOMPARE(number("summary/peaks/frequency"), 8e5);
    QCOMPARE(unit("events/time"), std::string("s"));
    QCOMPARE(H5Lexists(file, "events/name", H5P_DEFAULT), 1);

    const Hdf5Handle time = openHdf5Dataset(file, "timeseries/time");
    const Hdf5Handle pitch = openHdf5Dataset(file, "timeseries/pitch");
    QCOMPARE(readHdf5Attribute(pitch, "long_name"), std::string("Pitch"));
    QCOMPARE(readHdf5Attribute(time, "CLASS"), std::string("DIMENSION_SCALE"));
    QVERIFY(H5Aexists(pitch, "DIMENSION_LIST") > 0);
    const Hdf5Handle list(H5Dget_create_plist(pitch), H5Pclose);
    QCOMPARE(H5Pget_layout(list), H5D_CHUNKED);
    QCOMPARE(H5Pget_nfilters(list), 2);
    const Hdf5Handle space(H5Dget_space(pitch), H5Sclose);
    hsize_t most = 0;
    H5Sget_simple_extent_dims(space, nullptr, &most);
    QCOMPARE(most, H5S_UNLIMITED);
}

void TestResultsFile::spectra_data()
{
    QTest::addColumn<bool>("density");
    QTest::addColumn<QString>("dataset");
    QTest::addColumn<QString>("unit");
    QTest::newRow("density") << true << "density"
                             << "(m)^2/Hz";
    QTest::newRow("amplitude") << false << "power"
                               << "(m)^2";
}

void TestResultsFile::spectra()
{
    QFETCH(bool, density);
    QFETCH(QString, dataset);
    QFETCH(QString, unit);
    SpectrumCase options;
    options.scaling = density ? SpectrumScaling::Density : SpectrumScaling::Amplitude;
    Spectrum spectrum;
    spectrum.frequency = {0.0, 5e3, 10e3, 15e3};
    spectrum.power = {1e-20, 3e-20, 2e-20, 0.0};
    spectrum.segment = 6;
    spectrum.segments = 4;
    ResultsWriter writer;
    QCOMPARE(writer.open(path(), testCase(), caseText, quantities), std::string());
    QCOMPARE(writer.addSpectrum(quantities[0], spectrum, options), std::string());
    QCOMPARE(writer.addSpectrum(quantities[0], spectrum, options), std::string());
    QCOMPARE(writer.addSpectrum(quantities[1], {}, options), std::string());
    QCOMPARE(writer.finish(summary()), std::string());

    const Hdf5Access access;
    const Hdf5Handle file(H5Fopen(path().c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    QCOMPARE(H5Lexists(file, "spectra/pitch", H5P_DEFAULT), 0);
    const Hdf5Handle group = openHdf5Group(file, "spectra/minimum_spacing");
    QCOMPARE(readHdf5Attribute(group, "window"), std::string("hann"));
    QCOMPARE(readHdf5Attribute(group, "scaling"), std::string(density ? "density" : "amplitude"));
    for (const char* name : {"segment_length", "segment_samples", "segments", "overlap"})
        QVERIFY2(H5Aexists(group, name) > 0, name);
    const Hdf5Handle power = openHdf5Dataset(group, dataset.toStdString());
    QCOMPARE(QString::fromStdString(readHdf5Attribute(power, "unit")), unit);
    std::vector<double> values(4);
    checkHdf5(H5Dread(power, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
    QCOMPARE(values, spectrum.power);
    QCOMPARE(readHdf5Attribute(openHdf5Dataset(group, "frequency"), "unit"), std::string("Hz"));
}

void TestResultsFile::statusIsInterruptedWithoutFinish()
{
    {
        ResultsWriter writer;
        QCOMPARE(writer.open(path(), testCase(), caseText, quantities), std::string());
        QCOMPARE(writer.append(batch(0, 1234)), std::string());
    }
    const StoredRun run = readResults(path());
    QCOMPARE(run.problem, std::string());
    QCOMPARE(run.status, std::string("interrupted"));
    QCOMPARE(run.samples.size(), std::size_t{1234});
    QCOMPARE(wrongSample(run.samples), QString());
    QVERIFY(!fs::exists(path("run.h5.part")));
}

// The writer flushes without pause, so that nearly every kill falls into a flush; when it dies is decided
// by how much it has told of, and by what the machine does meanwhile.
void TestResultsFile::killedWritersLeaveWholeFiles()
{
    std::mt19937 random(7);
    std::uniform_int_distribution<qint64> patience(1, 120);
    for (int round = 0; round < 60; ++round) {
        QProcess writer;
        writer.start(QCoreApplication::applicationFilePath(), {"--write-until-killed", path().c_str()});
        const qint64 wanted = patience(random);
        while (writer.bytesAvailable() < wanted && writer.state() != QProcess::NotRunning)
            writer.waitForReadyRead(5000);
        QVERIFY2(writer.state() == QProcess::Running, writer.readAllStandardError().constData());
        writer.kill();
        QVERIFY(writer.waitForFinished());

        const StoredRun run = readResults(path());
        QVERIFY2(run.problem.empty(), run.problem.c_str());
        QCOMPARE(run.status, std::string("interrupted"));
        QCOMPARE(run.caseText, caseText);
        QVERIFY(run.samples.size() > 0);
        QCOMPARE(wrongSample(run.samples), QString());
        fs::remove(path());
    }
    // What the killed left beside the file hinders nobody.
    ResultsWriter writer;
    QCOMPARE(writer.open(path(), testCase(), caseText, quantities), std::string());
    QCOMPARE(writer.finish(summary()), std::string());
    QVERIFY(!fs::exists(path("run.h5.part")));
}

void TestResultsFile::oldFileStaysUntilTheNewOneIsWhole()
{
    put(path(), "older results");
    ResultsWriter writer(std::chrono::hours(1));
    QCOMPARE(writer.open(path(), testCase(), caseText, quantities), std::string());
    QCOMPARE(writer.append(batch(0, 10)), std::string());
    QCOMPARE(bytes(path()), std::string("older results"));
    QCOMPARE(writer.finish(summary()), std::string());
    QCOMPARE(readResults(path()).samples.size(), std::size_t{10});
}

void TestResultsFile::readersDuringARunDisturbNothing()
{
    ResultsWriter writer(0ms);
    QCOMPARE(writer.open(path(), testCase(), caseText, quantities), std::string());
    std::size_t k = 0;
    const auto append = [&] {
        const std::string problem = writer.append(batch(k, 500));
        k += 500;
        return problem;
    };
    QCOMPARE(append(), std::string());
    QTRY_VERIFY(fs::exists(path()));
    hid_t reader = H5I_INVALID_HID;
    hsize_t seen = 0;
    {
        const Hdf5Access access;
        reader = H5Fopen(path().c_str(), H5F_ACC_RDONLY, hdf5FileAccess());
        seen = storedSamples(reader);
    }
    for (int i = 0; i < 40; ++i) {
        QCOMPARE(append(), std::string());
        QTRY_COMPARE(readResults(path()).samples.size(), k);
        const Hdf5Access access;
        QCOMPARE(storedSamples(reader), seen);
    }
    {
        const Hdf5Access access;
        H5Fclose(reader);
    }
    QCOMPARE(writer.finish(summary()), std::string());
    QCOMPARE(wrongSample(readResults(path()).samples), QString());
}

void TestResultsFile::symbolicLinkStaysALink()
{
    put(path("target.h5"), "older results");
    fs::create_symlink("target.h5", path());
    ResultsWriter writer;
    QCOMPARE(writer.open(path(), testCase(), caseText, quantities), std::string());
    QCOMPARE(writer.finish(summary()), std::string());
    QVERIFY(fs::is_symlink(path()));
    QCOMPARE(readResults(path("target.h5")).problem, std::string());
}

void TestResultsFile::secondWriterToOneName()
{
    ResultsWriter first(std::chrono::hours(1));
    ResultsWriter second(std::chrono::hours(1));
    QCOMPARE(first.open(path(), testCase(), caseText, quantities), std::string());
    QCOMPARE(second.open(path(), testCase(), caseText, quantities), std::string());
    QVERIFY(first.finish(summary()).find("another run writes to it") != std::string::npos);
    QCOMPARE(second.append(batch(0, 5)), std::string());
    QCOMPARE(second.finish(summary()), std::string());
    QCOMPARE(readResults(path()).samples.size(), std::size_t{5});
}

void TestResultsFile::fileRemovedDuringARun()
{
    ResultsWriter writer(0ms);
    QCOMPARE(writer.open(path(), testCase(), caseText, quantities), std::string());
    QCOMPARE(writer.append(batch(0, 5)), std::string());
    QTRY_VERIFY(fs::exists(path()));
    fs::remove(path());
    QCOMPARE(writer.append(batch(5, 5)).find('\n'), std::string::npos);
    QVERIFY(writer.finish(summary()).find("removed or replaced") != std::string::npos);
    QVERIFY(fs::is_empty(path().parent_path()));
}

// A limit on the size of files stands in for a full disk: it fails in the same calls, and needs no rights.
void TestResultsFile::fullDisk()
{
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    rlimit small = before;
    small.rlim_cur = 400000;

    ResultsWriter writer(0ms);
    QCOMPARE(writer.open(path(), testCase(), caseText, quantities), std::string());
    QCOMPARE(writer.append(batch(0, 1000)), std::string());
    QTRY_VERIFY(fs::exists(path()));
    setrlimit(RLIMIT_FSIZE, &small);
    std::string problem;
    std::size_t k = 1000;
    for (; problem.empty() && k < 400000; k += 1000) problem = writer.append(batch(k, 1000));
    if (problem.empty()) problem = writer.finish(summary());

    ResultsWriter none;
    rlimit tiny = small;
    tiny.rlim_cur = 1000;
    setrlimit(RLIMIT_FSIZE, &tiny);
    const std::string atOnce = none.open(path("other.h5"), testCase(), caseText, quantities);
    setrlimit(RLIMIT_FSIZE, &before);

    QVERIFY2(problem.find("File too large") != std::string::npos, problem.c_str());
    QVERIFY2(problem.find("run.h5") != std::string::npos, problem.c_str());
    QVERIFY2(atOnce.find("File too large") != std::string::npos, atOnce.c_str());
    QVERIFY(!fs::exists(path("other.h5")) && !fs::exists(path("other.h5.part")));
    // The last state that fitted is whole.
    const StoredRun run = readResults(path());
    QCOMPARE(run.problem, std::string());
    QCOMPARE(run.status, std::string("interrupted"));
    QVERIFY(run.samples.size() >= 1000);
    QCOMPARE(wrongSample(run.samples), QString());
}

void TestResultsFile::refusedTargets_data()
{
    QTest::addColumn<QString>("target"); // in the folder, unless absolute
    QTest::addColumn<QString>("says");
    QTest::newRow("a directory") << "sub"
                                 << "is a directory";
    QTest::newRow("a directory with a slash") << "sub/"
                                              << "names no file";
    QTest::newRow("in no directory") << "none/run.h5"
                                     << "there is no directory";
    QTest::newRow("in a file") << "file/run.h5"
                               << "there is no directory";
    QTest::newRow("a device") << "/dev/full"
                              << "is no regular file";
    QTest::newRow("no name") << ""
                             << "names no file";
}

void TestResultsFile::refusedTargets()
{
    QFETCH(QString, target);
    QFETCH(QString, says);
    fs::create_directory(path("sub"));
    put(path("file"), "text");
    const fs::path file = target.isEmpty() ? fs::path() : path(qPrintable(target));
    ResultsWriter writer;
    const std::string problem = writer.open(file, testCase(), caseText, quantities);
    QVERIFY2(problem.find(says.toStdString()) != std::string::npos, problem.c_str());
    QCOMPARE(checkResultsTarget(file), problem);
    QVERIFY(!writer.append(batch(0, 1)).empty());
    QVERIFY(!writer.finish(summary()).empty());
    QCOMPARE(bytes(path("file")), std::string("text"));
}

void TestResultsFile::unreadableFiles_data()
{
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QString>("says");
    QTest::newRow("missing") << "missing"
                             << "there is no such file";
    QTest::newRow("a directory") << "directory"
                                 << "is a directory";
    QTest::newRow("empty") << "empty"
                           << "is not an HDF5 file";
    QTest::newRow("text") << "text"
                          << "is not an HDF5 file";
    QTest::newRow("cut in half") << "half"
                                 << "damaged or cut short";
    QTest::newRow("cut by a byte") << "byte"
                                   << "damaged or cut short";
    QTest::newRow("other HDF5") << "other"
                                << "not the results of a run";
    QTest::newRow("higher major version") << "2.0"
                                          << "has format version 2.0, written by Touchdown";
    QTest::newRow("version that is none") << "x"
                                          << "does not say the version";
    QTest::newRow("columns of different length") << "ragged"
                                                 << "differ in length";
    QTest::newRow("a column that claims too much") << "claim"
                                                   << "fewer samples than it says";
}

void TestResultsFile::unreadableFiles()
{
    QFETCH(QString, kind);
    QFETCH(QString, says);
    ResultsWriter writer;
    QCOMPARE(writer.open(path(), testCase(), caseText, quantities), std::string());
    QCOMPARE(writer.append(batch(0, 5000)), std::string());
    QCOMPARE(writer.finish(summary()), std::string());
    const std::string whole = bytes(path());
    {
        const Hdf5Access access;
        const Hdf5Handle file(H5Fopen(path().c_str(), H5F_ACC_RDWR, hdf5FileAccess()), H5Fclose);
        const Hdf5Handle pitch = openHdf5Dataset(file, "timeseries/pitch");
        const hsize_t more = 5001;
        const hsize_t far = hsize_t{1} << 40;
        if (kind == "2.0" || kind == "x") writeHdf5Attribute(file, "format_version", kind.toStdString());
        if (kind == "ragged") checkHdf5(H5Dset_extent(pitch, &more));
        if (kind == "claim") checkHdf5(H5Dset_extent(pitch, &far));
    }
    if (kind == "missing") fs::remove(path());
    if (kind == "empty") put(path(), "");
    if (kind == "text") put(path(), "time [s],pitch [rad]\n");
    if (kind == "half") put(path(), whole.substr(0, whole.size() / 2));
    if (kind == "byte") put(path(), whole.substr(0, whole.size() - 1));
    if (kind == "directory" || kind == "other") fs::remove(path());
    if (kind == "directory") fs::create_directory(path());
    if (kind == "other") {
        const Hdf5Access access;
        const Hdf5Handle file(H5Fcreate(path().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
    }
    const StoredRun run = readResults(path());
    QVERIFY2(run.problem.find(says.toStdString()) != std::string::npos, run.problem.c_str());
    QVERIFY(run.problem.find("run.h5") != std::string::npos);
    QCOMPARE(run.problem.find('\n'), std::string::npos);
    QVERIFY(run.samples.time.empty() && run.quantities.empty() && run.title.empty());
}

void TestResultsFile::samplesThatDoNotFit()
{
    ResultsWriter writer;
    QCOMPARE(writer.open(path(), testCase(), caseText, quantities), std::string());
    SampleBatch narrow = batch(0, 3);
    narrow.columns.pop_back();
    QVERIFY(writer.append(narrow).find("do not fit") != std::string::npos);
    SampleBatch ragged = batch(0, 3);
    ragged.columns[1].pop_back();
    QVERIFY(writer.append(ragged).find("do not fit") != std::string::npos);
    QCOMPARE(writer.append(batch(0, 3)), std::string());
    QCOMPARE(writer.finish(summary()), std::string());
    QCOMPARE(readResults(path()).samples.size(), std::size_t{3});
}

void TestResultsFile::csvReadsBackExactly()
{
    CsvWriter writer;
    std::vector<Quantity> columns = quantities;
    columns[1].name = "pitch, of the \"slider\"";
    QCOMPARE(writer.open(path("run.csv"), columns), std::string());
    const std::size_t n = 30000;
    for (std::size_t k = 0; k < n; k += 1000) QCOMPARE(writer.append(batch(k, 1000)), std::string());
    QCOMPARE(writer.close(), std::string());

    const QList<QByteArray> lines = QByteArray::fromStdString(bytes(path("run.csv"))).split('\n');
    QCOMPARE(lines.size(), static_cast<qsizetype>(n) + 2);
    QCOMPARE(lines.front(), QByteArray("time [s],minimum_spacing [m],\"pitch, of the \"\"slider\"\" [rad]\"\r"));
    QCOMPARE(lines.back(), QByteArray());
    for (std::size_t k = 0; k < n; ++k) {
        const QList<QByteArray> fields = lines[static_cast<qsizetype>(k) + 1].chopped(1).split(',');
        QCOMPARE(fields.size(), 3);
        for (std::size_t i = 0; i < 3; ++i)
            QCOMPARE(fields[static_cast<qsizetype>(i)].toDouble() == sample(i, k), true);
    }
}

void TestResultsFile::csvProblems_data()
{
    QTest::addColumn<QString>("target");
    QTest::addColumn<QString>("says");
    QTest::newRow("a directory") << "sub"
                                 << "Is a directory";
    QTest::newRow("in no directory") << "none/run.csv"
                                     << "No such file or directory";
    QTest::newRow("full disk") << "/dev/full"
                               << "No space left on device";
}

void TestResultsFile::csvProblems()
{
    QFETCH(QString, target);
    QFETCH(QString, says);
    fs::create_directory(path("sub"));
    CsvWriter writer;
    std::string problem = writer.open(path(qPrintable(target)), quantities);
    if (problem.empty()) problem = writer.append(batch(0, 100000));
    if (problem.empty()) problem = writer.close();
    QVERIFY2(problem.find(says.toStdString()) != std::string::npos, problem.c_str());
    QVERIFY(problem.find(target.toStdString()) != std::string::npos);
}

int main(int argc, char** argv)
{
    if (argc == 3 && std::string_view(argv[1]) == "--write-until-killed") return writeUntilKilled(argv[2]);
    QCoreApplication application(argc, argv);
    TestResultsFile test;
    return QTest::qExec(&test, argc, argv);
}

#include "test_results_file.moc"

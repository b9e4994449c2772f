// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/results/steady_reader.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <memory>

#include "core/formats/hdf5_file.h"
#include "core/results/file_header.h"
#include "core/results/steady_writer.h"
#include "core/simulation/static_state/steady_quantities.h"
#include "tests/support/sample_results.h"
#include "tests/support/sample_steady.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_steady_reader {

using test::sampleFilmCase;
using test::sampleSteady;

const SteadySeriesPoint onePoint{23e-3, 0.1, 565.0, {}};

class TestSteadyReader : public QObject {
    Q_OBJECT

private slots:
    void init() { folder_ = std::make_unique<QTemporaryDir>(); }

    void whatWasWritten()
    {
        SteadyResult failed;
        failed.message = "no attitude";
        write({sampleSteady(), failed});
        const StoredSteady stored = readSteady(path());
        QCOMPARE(stored.problem, std::string());
        QCOMPARE(stored.title, std::string("A plane"));
        QCOMPARE(stored.caseText, std::string("model = \"film\"\n"));
        QCOMPARE(stored.states.size(), std::size_t{2});
        const SteadyResult expected = sampleSteady();
        const SteadyResult& state = stored.states.front();
        QCOMPARE(state.status, SteadyStatus::Converged);
        QCOMPARE(state.iterations, 7);
        QCOMPARE(state.wallSeconds, 0.25);
        QCOMPARE(state.residual, 1e-9);
        QCOMPARE(state.loadError, 2e-8);
        const auto numbers = steadyQuantities(state), numbersExpected = steadyQuantities(expected);
        for (std::size_t i = 0; i < numbers.size(); ++i) QCOMPARE(numbers[i].value, numbersExpected[i].value);
        QCOMPARE(state.minimumAt, expected.minimumAt);
        QCOMPARE(state.forces.centreOfPositive, expected.forces.centreOfPositive);
        QCOMPARE(state.forces.centreOfNegative, expected.forces.centreOfNegative);
        QCOMPARE(state.forces.maximumAt, expected.forces.maximumAt);
        QCOMPARE(state.forces.minimumAt, expected.forces.minimumAt);
        QVERIFY(*state.stiffness == *expected.stiffness);
        QCOMPARE(state.sensitivities.size(), std::size_t{1});
        QCOMPARE(state.sensitivities[0].parameter, std::string("abs.crown"));
        QCOMPARE(state.sensitivities[0].unit, std::string("m"));
        QCOMPARE(state.sensitivities[0].minimumSpacing, 0.4);
        QCOMPARE(state.contact.state, expected.contact.state);
        QCOMPARE(state.contact.region, expected.contact.region);
        QCOMPARE(state.contact.branch, expected.contact.branch);
        QVERIFY(*state.contactStiffness == *expected.contactStiffness);
        QCOMPARE(state.suspensionRest->pitch, 151e-6);
        QCOMPARE(state.suspensionRest->height, 13e-9);
        QCOMPARE(state.contactStates.size(), std::size_t{1});
        QCOMPARE(state.contactStates[0].attitude.pitch, 149e-6);
        QCOMPARE(state.contactStates[0].minimumSpacing, 10e-9);
        QCOMPARE(state.contactStates[0].contact.state, std::string("flying"));
        QVERIFY(state.contactStates[0].contact.diverges);
        QCOMPARE(state.interestSpacing, expected.interestSpacing);
        QCOMPARE(state.grid.x, expected.grid.x);
        QCOMPARE(state.grid.y, expected.grid.y);
        QCOMPARE(state.pressure, expected.pressure);
        QCOMPARE(state.gap, expected.gap);
        QCOMPARE(state.recess, expected.recess);

        QCOMPARE(stored.states[1].status, SteadyStatus::Failed);
        QCOMPARE(stored.states[1].message, std::string("no attitude"));
        QVERIFY(stored.states[1].pressure.empty());
    }

    void eachStatusComesBack()
    {
        std::vector<SteadyResult> states;
        for (const SteadyStatus status :
             {SteadyStatus::Converged, SteadyStatus::NotConverged, SteadyStatus::Cancelled, SteadyStatus::Failed}) {
            states.push_back(sampleSteady());
            states.back().status = status;
        }
        write(states);
        const StoredSteady stored = readSteady(path());
        QCOMPARE(stored.states.size(), states.size());
        for (std::size_t i = 0; i < states.size(); ++i) QCOMPARE(stored.states[i].status, states[i].status);
    }

    void otherFilesAreRefused_data()
    {
        QTest::addColumn<QString>("says");
        QTest::newRow("missing") << "there is no such file";
        QTest::newRow("a run") << "not static states of Touchdown";
        QTest::newRow("cut in half") << "damaged or cut short";
        QTest::newRow("a field of another size") << "pressure has 2 numbers instead of 6";
        QTest::newRow("no gap") << "gap";
        QTest::newRow("a pressure that is none") << "holds something that is not a number";
        QTest::newRow("points that claim too much") << "fewer numbers than it says";
        QTest::newRow("lines that do not increase") << "x_lines does not hold at least two increasing numbers";
    }

    void otherFilesAreRefused()
    {
        QFETCH(QString, says);
        const QString kind = QTest::currentDataTag();
        if (kind != "missing") write({sampleSteady()});
        if (kind == "a run") {
            ResultsWriter run;
            QCOMPARE(run.open(path(), sampleCase(), sampleCaseText, sampleQuantities), std::string());
            QCOMPARE(run.finish(sampleSummary()), std::string());
        }
        if (kind == "cut in half") {
            QFile file(path().c_str());
            QVERIFY(file.resize(file.size() / 2));
        }
        if (kind == "a field of another size") replace("pressure", {1e5, 1e5});
        if (kind == "no gap") replace("gap", {});
        if (kind == "a pressure that is none") replace("pressure", {1e5, 1e5, NAN, 1e5, 1e5, 1e5});
        if (kind == "points that claim too much") claimPoints();
        if (kind == "lines that do not increase") replace("x_lines", {0.0, 1e-3, 1e-3, 2e-3});
        const StoredSteady stored = readSteady(path());
        QVERIFY2(stored.problem.find(says.toStdString()) != std::string::npos, stored.problem.c_str());
        QVERIFY(stored.states.empty());
    }

    void theFormatTellsFilesApart()
    {
        QCOMPARE(formatOf(path()), std::string());
        write({sampleSteady()});
        QCOMPARE(formatOf(path()), std::string("touchdown-steady"));
    }

private:
    std::filesystem::path path() const { return std::filesystem::path(folder_->path().toStdString()) / "a.h5"; }
    void write(const std::vector<SteadyResult>& states) const
    {
        SteadyWriter writer;
        QCOMPARE(writer.open(path(), sampleFilmCase(), "model = \"film\"\n"), std::string());
        for (const SteadyResult& state : states) QCOMPARE(writer.add(onePoint, state), std::string());
        QCOMPARE(writer.finish(SteadyStatus::Converged, ""), std::string());
    }
    void replace(const std::string& field, const std::vector<double>& values) const
    {
        const Hdf5Access access;
        const Hdf5Group file = openHdf5File(path(), H5F_ACC_RDWR);
        const Hdf5Group fields = file.group("states/1/fields");
        fields.remove(field);
        if (!values.empty()) fields.put(field, values);
    }
    /// Points of interest of which nothing is stored.
    void claimPoints() const
    {
        const Hdf5Access access;
        const Hdf5Group file = openHdf5File(path(), H5F_ACC_RDWR);
        const Hdf5Group state = file.group("states/1");
        state.remove("points_of_interest");
        const hsize_t count = hsize_t{1} << 61, chunk = 1024;
        const Hdf5Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose);
        const Hdf5Handle chunked(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
        checkHdf5(H5Pset_chunk(chunked, 1, &chunk));
        const Hdf5Handle made(
            H5Dcreate2(state, "points_of_interest", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, chunked, H5P_DEFAULT),
            H5Dclose);
    }
    std::unique_ptr<QTemporaryDir> folder_;
};

TOUCHDOWN_TEST(TestSteadyReader)

} // namespace test_steady_reader

#include "test_steady_reader.moc"

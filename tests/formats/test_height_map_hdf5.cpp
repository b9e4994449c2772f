// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/height_map_hdf5.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <functional>
#include <limits>

#include "core/formats/cml_text.h"
#include "core/formats/hdf5_file.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_height_map_hdf5 {

using Writer = std::function<void(const Hdf5Group&)>;

const std::vector<double> x{0.0, 1.0, 2.0, 3.0};
const std::vector<double> y{0.0, 2.0};
const std::vector<double> profile{1.0, 2.0, 3.0, 5.0};

void writeList(const Hdf5Group& file, const std::string& name, const std::vector<double>& values,
               const std::string& unit = {})
{
    const Hdf5Dataset dataset = file.put(name, values);
    if (!unit.empty()) dataset.set("unit", unit);
}

void writeMatrix(const Hdf5Group& file, const std::string& name, hsize_t rows, hsize_t columns,
                 const std::vector<double>& values, const std::string& unit = {})
{
    const hsize_t shape[] = {rows, columns};
    const Hdf5Handle space(H5Screate_simple(2, shape, nullptr), H5Sclose);
    const Hdf5Dataset dataset(
        H5Dcreate2(file, name.c_str(), H5T_IEEE_F32LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose);
    checkHdf5(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
    if (!unit.empty()) dataset.set("unit", unit);
}

class TestHeightMapHdf5 : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    std::filesystem::path written(const Writer& write)
    {
        const std::filesystem::path path = folder_.filePath("map.h5").toStdString();
        const Hdf5Access access;
        write(createHdf5File(path));
        return path;
    }

    static std::string refusal(const std::filesystem::path& path)
    {
        try {
            readHeightMapHdf5(path);
        } catch (const CmlError& error) {
            return error.what();
        }
        return {};
    }

private slots:
    void aProfile()
    {
        const HeightMap map = readHeightMapHdf5(written([](const Hdf5Group& file) {
            writeList(file, "x", x, "um");
            writeList(file, "height", profile, "nm");
        }));
        QCOMPARE(map.nx, 4);
        QCOMPARE(map.ny, 1);
        QVERIFY(std::abs(map.dx - 1e-6) < 1e-18);
        for (std::size_t i = 0; i < 4; ++i) QVERIFY(std::abs(map.heights[i] - profile[i] * 1e-9) < 1e-20);
    }

    void withoutUnitsItIsInMetres()
    {
        const HeightMap map = readHeightMapHdf5(written([](const Hdf5Group& file) {
            writeList(file, "x", x);
            writeList(file, "height", profile);
        }));
        QCOMPARE(map.dx, 1.0);
        QCOMPARE(map.heights, profile);
    }

    void aMapOfAnyNumberType()
    {
        const std::vector<double> heights{1, 2, 3, 4, 5, 6, 7, 8};
        const HeightMap map = readHeightMapHdf5(written([&](const Hdf5Group& file) {
            writeList(file, "x", x);
            writeList(file, "y", y);
            writeMatrix(file, "height", 2, 4, heights);
        }));
        QCOMPARE(map.nx, 4);
        QCOMPARE(map.ny, 2);
        QCOMPARE(map.dy, 2.0);
        QCOMPARE(map.heights, heights);
    }

    void whatIsNoSurfaceIsRefused_data()
    {
        QTest::addColumn<Writer>("write");
        QTest::addColumn<QByteArray>("problem");
        const auto row = [](const char* name, Writer write, const char* problem) {
            QTest::newRow(name) << write << QByteArray(problem);
        };
        row(
            "nothing", [](const Hdf5Group&) {},
            "has no dataset \"height\"; a profile needs x and height, a map x, y and height");
        row(
            "no x", [](const Hdf5Group& f) { writeList(f, "height", profile); },
            "has no dataset \"x\"; a profile needs x and height, a map x, y and height");
        row(
            "a map without y",
            [](const Hdf5Group& f) {
                writeList(f, "x", x);
                writeMatrix(f, "height", 2, 4, std::vector<double>(8));
            },
            "has no dataset \"y\"; a profile needs x and height, a map x, y and height");
        row(
            "x before y",
            [](const Hdf5Group& f) {
                writeList(f, "x", x);
                writeList(f, "y", y);
                writeMatrix(f, "height", 4, 2, std::vector<double>(8));
            },
            "dataset \"height\" is 4 x 2; x and y ask for 2 x 4 points (y before x)");
        row(
            "a shorter profile",
            [](const Hdf5Group& f) {
                writeList(f, "x", x);
                writeList(f, "height", {1.0, 2.0});
            },
            "dataset \"height\" is 2; x and y ask for 4 points (y before x)");
        row(
            "a hole",
            [](const Hdf5Group& f) {
                writeList(f, "x", x);
                writeList(f, "height", {1.0, 2.0, std::numeric_limits<double>::quiet_NaN(), 4.0});
            },
            "dataset \"height\" holds no number at entry 3; a map has no holes: all must be finite");
        row(
            "x that jumps",
            [](const Hdf5Group& f) {
                writeList(f, "x", {0.0, 1.0, 2.0, 4.0});
                writeList(f, "height", profile);
            },
            "x must ascend in equal steps, without gaps: 4 m stands where 3 m is needed");
        row(
            "a unit of time",
            [](const Hdf5Group& f) {
                writeList(f, "x", x, "s");
                writeList(f, "height", profile);
            },
            "the unit of dataset \"x\" must be a length, as \"nm\", not \"s\"");
        row(
            "words",
            [](const Hdf5Group& f) {
                writeList(f, "x", x);
                f.put("height", std::vector<std::string>{"a", "b", "c", "d"});
            },
            "dataset \"height\" must hold numbers");
        row(
            "x of two dimensions",
            [](const Hdf5Group& f) {
                writeMatrix(f, "x", 2, 4, std::vector<double>(8));
                writeList(f, "height", profile);
            },
            "dataset \"x\" must be a list, not 2 x 4");
    }
    void whatIsNoSurfaceIsRefused()
    {
        QFETCH(Writer, write);
        QFETCH(QByteArray, problem);
        QCOMPARE(refusal(written(write)), problem.toStdString());
    }

    void noSuchFile() { QCOMPARE(refusal(folder_.filePath("none.h5").toStdString()), std::string("does not exist")); }
};

TOUCHDOWN_TEST(TestHeightMapHdf5)

} // namespace test_height_map_hdf5

#include "test_height_map_hdf5.moc"

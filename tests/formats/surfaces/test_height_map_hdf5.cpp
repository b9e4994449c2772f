// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/surfaces/height_map_hdf5.h"

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
        std::filesystem::remove(path);
        write(createHdf5File(path));
        return path;
    }

    static std::string refusal(const std::filesystem::path& path, const ColumnUnits& key = {})
    {
        try {
            readHeightMapHdf5(path, key);
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

    void unitsOfTheCase()
    {
        const auto path = written([](const Hdf5Group& file) {
            writeList(file, "x", x);
            writeList(file, "height", profile, "nm");
        });
        const HeightMap map = readHeightMapHdf5(path, {1e-6, 1e-9});
        QVERIFY(std::abs(map.dx - 1e-6) < 1e-18);
        QVERIFY(std::abs(map.heights[3] - 5e-9) < 1e-20);
        QVERIFY(refusal(path).starts_with("dataset \"x\" has no unit"));
        QVERIFY(refusal(path).find("disk.surface.unit") != std::string::npos);
        QVERIFY(refusal(path, {1e-6, 1e-6}).starts_with("dataset \"height\" has another unit than disk.surface.unit"));
    }

    void aMapOfAnyNumberType()
    {
        const std::vector<double> heights{1, 2, 3, 4, 5, 6, 7, 8};
        const HeightMap map = readHeightMapHdf5(written([&](const Hdf5Group& file) {
                                                    writeList(file, "x", x);
                                                    writeList(file, "y", y);
                                                    writeMatrix(file, "height", 2, 4, heights);
                                                }),
                                                {1.0});
        QCOMPARE(map.nx, 4);
        QCOMPARE(map.ny, 2);
        QCOMPARE(map.dy, 2.0);
        QCOMPARE(map.heights, heights);
    }

    // x from the right, y from the top.
    void aMapFromItsLastPoint()
    {
        const HeightMap map = readHeightMapHdf5(written([&](const Hdf5Group& file) {
                                                    writeList(file, "x", {3, 2, 1, 0});
                                                    writeList(file, "y", {2, 0});
                                                    writeMatrix(file, "height", 2, 4, {8, 7, 6, 5, 4, 3, 2, 1});
                                                }),
                                                {1.0});
        QCOMPARE(map.heights, (std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8}));
    }

    // netCDF and xarray write "units"; packed numbers have a scale and an offset.
    void attributesOfNetCdf()
    {
        const HeightMap map = readHeightMapHdf5(written([](const Hdf5Group& file) {
            file.put("x", x).set("units", "micrometer");
            const Hdf5Dataset height = file.put("height", profile);
            height.set("units", "nanometers");
            height.set("unit", "nm");
            height.set("scale_factor", 0.5);
            height.set("add_offset", 10.0);
            height.set("_FillValue", -1.0);
        }));
        QVERIFY(std::abs(map.dx - 1e-6) < 1e-18);
        for (std::size_t i = 0; i < 4; ++i)
            QVERIFY(std::abs(map.heights[i] - (0.5 * profile[i] + 10.0) * 1e-9) < 1e-20);
    }
    void marksAndContradictionsAreRefused_data()
    {
        QTest::addColumn<Writer>("write");
        QTest::addColumn<QByteArray>("says");
        const auto row = [](const char* name, const std::vector<double>& heights, const Writer& more,
                            const char* says) {
            QTest::newRow(name) << Writer([heights, more](const Hdf5Group& file) {
                writeList(file, "x", x, "um");
                writeList(file, "height", heights, "nm");
                more(file);
            }) << QByteArray(says);
        };
        const auto set = [](const char* name, auto value) {
            return Writer([=](const Hdf5Group& file) { file.get("height").set(name, value); });
        };
        row("another unit", profile, set("units", "um"), "different units");
        row("counts", profile, set("units", "counts"), "must be a length");
        row("depths", profile, set("positive", "down"), "counts downwards");
        row("depths by name", profile, set("long_name", "depth of the track"), "counts downwards");
        row("another quantity", profile, set("long_name", "height error"), "no height");
        row("a fill value", profile, set("_FillValue", 3.0), "entry 3: a surface has no holes: 3 is its _FillValue");
        row("a missing value", profile, set("missing_value", std::int64_t{5}),
            "entry 4: a surface has no holes: 5 is its miss");
        row(
            "a mark", {1.0, -32768.0, 2.0, 1.5}, [](const Hdf5Group&) {},
            "entry 2: a surface has no holes: -32768 is far");
    }
    void marksAndContradictionsAreRefused()
    {
        QFETCH(Writer, write);
        QFETCH(QByteArray, says);
        const std::string problem = refusal(written(write));
        QVERIFY2(QByteArray::fromStdString(problem).contains(says), problem.c_str());
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
            "dataset \"height\" holds no number at entry 3; a surface has no holes: all must be finite");
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
        QCOMPARE(refusal(written(write), {1.0}), problem.toStdString());
    }

    void noSuchFile() { QCOMPARE(refusal(folder_.filePath("none.h5").toStdString()), std::string("does not exist")); }
};

TOUCHDOWN_TEST(TestHeightMapHdf5)

} // namespace test_height_map_hdf5

#include "test_height_map_hdf5.moc"

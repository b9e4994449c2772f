// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/surfaces/surface_fields.h"

#include <QTemporaryDir>
#include <QTest>

#include <bit>
#include <cmath>

#include "core/formats/surfaces/height_map_file.h"
#include "core/formats/text_file.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_surface_fields {

/// 4 x 2 points, 2 um and 3 um apart; the heights 1 to 8 nm.
std::string simpleField(const std::string& more = "", float last = 8e-9F)
{
    std::string bytes =
        "Gwyddion Simple Field 1.0\nXRes = 4\nYRes = 2\nXReal = 8e-6\nYReal = 6e-6\nXYUnits = m\nZUnits = m\n" + more;
    bytes.append(4 - bytes.size() % 4, '\0');
    for (int k = 1; k <= 8; ++k) {
        const auto bits = std::bit_cast<std::uint32_t>(k < 8 ? static_cast<float>(k) * 1e-9F : last);
        for (int byte = 0; byte < 4; ++byte) bytes += static_cast<char>(bits >> (8 * byte) & 0xFF);
    }
    return bytes;
}
std::string sdf(const std::string& heights)
{
    return "aBCR-1.0\nManufacID = none\nNumPoints = 4\nNumProfiles = 2\nXscale = 2e-6\nYscale = 3e-6\nZscale = 1e-10\n"
           "Zresolution = -1\nCompression = 0\nDataType = 6\nCheckType = 0\n*\n" +
           heights;
}

bool isTheMap(const HeightMapDocument& document)
{
    const HeightMap& map = document.map;
    bool same = document.valid() && map.nx == 4 && map.ny == 2 && std::abs(map.dx - 2e-6) < 1e-15 &&
                std::abs(map.dy - 3e-6) < 1e-15;
    for (std::size_t k = 0; same && k < 8; ++k)
        same = std::abs(map.heights[k] - 1e-9 * static_cast<double>(k + 1)) < 1e-15;
    return same;
}

class TestSurfaceFields : public QObject {
    Q_OBJECT

private slots:
    // The zero bytes end at a multiple of four, whatever the length of the lines.
    void aSimpleField()
    {
        for (const char* more : {"", "Title = a\n", "Title = ab\n", "Title = abc\n"})
            QVERIFY2(isTheMap(readHeightMapText(simpleField(more), "a.gsf")), more);
        QTemporaryDir folder;
        const std::filesystem::path file = folder.filePath("a.gsf").toStdString();
        QCOMPARE(writeTextFile(file, simpleField()), std::string());
        QVERIFY(isTheMap(readHeightMap(file, "a.gsf")));
    }
    void aTextOfSdf()
    {
        QVERIFY(isTheMap(readHeightMapText(sdf("10 20 30 40\n50 60 70 80\n*\nend\n"), "a.sdf")));
        QVERIFY(isTheMap(readHeightMapText(sdf("10 20 30\n40 50 60\n70 80\n"), "a.sdf"))); // lines as they come
    }
    void damagedFieldsAreRefused()
    {
        const auto refused = [](const std::string& text) { return !readHeightMapText(text, "a").valid(); };
        QVERIFY(refused(simpleField("", std::nanf(""))));
        QVERIFY(refused(simpleField() + "x"));
        QVERIFY(refused(simpleField().substr(0, simpleField().size() - 4)));
        QVERIFY(refused("Gwyddion Simple Field 1.0\nXRes = 4\n"));
        QVERIFY(refused("Gwyddion Simple Field 1.0\nXRes = 1e9\nYRes = 1e9\n" + std::string(4, '\0')));
        std::string volts = simpleField();
        volts.replace(volts.find("ZUnits = m"), 10, "ZUnits = V");
        QVERIFY(refused(volts));
        QVERIFY(refused(sdf("10 20 30 BAD\n50 60 70 80\n*\n")));
        QVERIFY(refused(sdf("10 20 30 40\n*\n")));
        QVERIFY(refused(sdf("10 20 30 40\n50 60 70 80\n90\n*\n")));
    }
};

TOUCHDOWN_TEST(TestSurfaceFields)

} // namespace test_surface_fields

#include "test_surface_fields.moc"

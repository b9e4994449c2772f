// SPDX-License-Identifier: GPL-3.0-or-later
//
// One profile under headings that are drawn from a seed, with the right answer known: heights, heights that count
// downwards, quantities that are no height, and prose. What is read is right to 1e-4; the rest is refused.
#include "core/formats/surfaces/height_map_file.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>
#include <string>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_drawn_spellings {

enum class Truth { Heights, Depths, NoHeights, Prose };

struct Unit {
    const char* text;
    double metres;
};

constexpr int points = 60;
constexpr double step = 0.5e-6; // [m]

double height(int i)
{
    return 1e-9 * (std::sin(2.0 * std::numbers::pi * i / 17.0) + 0.4 * std::cos(2.0 * std::numbers::pi * i / 5.3));
}

class Draws {
public:
    explicit Draws(unsigned seed) : random_(seed) {}

    template <typename T, std::size_t n>
    const T& of(const T (&all)[n])
    {
        return all[random_() % n];
    }

private:
    std::mt19937 random_;
};

struct Drawn {
    std::string text; // of the file
    std::string heading;
};

std::string cell(const std::string& name, const Unit& unit, int style)
{
    std::string joined = name;
    std::ranges::replace(joined, ' ', '_');
    switch (style) {
    case 0: return name + " [" + unit.text + "]";
    case 1: return name + " (" + unit.text + ")";
    case 2: return name + " in " + unit.text;
    case 3: return name + "/" + unit.text;
    case 4: return joined + "_" + unit.text;
    case 5: return name + ": " + unit.text;
    default: return name + " " + unit.text;
    }
}

Drawn drawn(Draws& draw, Truth truth)
{
    constexpr Unit lateral[] = {{"um", 1e-6}, {"\xC2\xB5m", 1e-6}, {"mm", 1e-3}, {"nm", 1e-9}, {"microns", 1e-6}};
    constexpr Unit vertical[] = {{"nm", 1e-9}, {"nanometers", 1e-9}, {"pm", 1e-12}, {"um", 1e-6}};
    constexpr const char* places[] = {"x",      "Distance", "track position", "lateral position",
                                      "X axis", "Position", "scan distance",  "xPos"};
    constexpr const char* heights[] = {"z",          "Height",        "surface height", "raw height",
                                       "Topography", "Height Sensor", "z axis",         "elevation"};
    constexpr const char* depths[] = {"depth",           "-z",       "inverted z", "depth below surface",
                                      "negative height", "z flipped"};
    constexpr const char* others[] = {"gap",     "log10 z", "z^2",       "std of z", "slope",     "PSD",
                                      "counts",  "z error", "rms",       "|z|",      "dz/dx",     "film thickness",
                                      "z_std",   "logz",    "1/z",       "phase",    "max z",     "flying height",
                                      "delta z", "10 z",    "z squared", "residual", "clearance", "amplitude"};
    constexpr const char* prose[] = {"Height data, in nanometers, versus distance in micrometers",
                                     "Roughness height (nm) as a function of track position (um)",
                                     "# spot size (mm), wavelength (um)",
                                     "# tip height (um), tip radius (nm)",
                                     "# heights in nm, drawn over um",
                                     "# resolution (nm), range (um)",
                                     "# cutoff (mm), filter (um)",
                                     "x micro m, z nano m",
                                     "x [um], z [nm] x10",
                                     "x [um], z (x10) [nm]",
                                     "x [um], z e-3 [um]",
                                     "x [um], z [nm/div]",
                                     "# z multiplier: 0.1\nx [um], z [nm]",
                                     "# unit: nm"};
    constexpr const char* separators[] = {",", ";", "\t", ", "};
    constexpr const char* before[] = {"",
                                      "",
                                      "# measured on 2024-03-05\n",
                                      "Disk A\n",
                                      "# scan rate: 1.0 Hz\n",
                                      "# tip radius (nm), speed (um/s)\n",
                                      "# spot size (mm), wavelength (um)\n"};
    constexpr const char* marks[] = {"", "# ", "% "};
    constexpr int styles[] = {0, 0, 1, 1, 2, 3, 4, 5, 6};

    const std::string separator = draw.of(separators);
    const Unit along = draw.of(lateral), up = draw.of(vertical);
    const std::string name = truth == Truth::Heights  ? draw.of(heights)
                             : truth == Truth::Depths ? draw.of(depths)
                                                      : draw.of(others);
    const int style = draw.of(styles);
    Drawn file;
    if (truth == Truth::Prose)
        file.heading = draw.of(prose);
    else
        file.heading = draw.of(before) + std::string(draw.of(marks)) + cell(draw.of(places), along, style) + separator +
                       cell(name, up, style);
    file.text = file.heading + "\n";
    for (int i = 0; i < points; ++i) {
        char row[80];
        const double x = truth == Truth::Prose ? 1e6 * step * i : step * i / along.metres;
        const double h = truth == Truth::Prose ? 1e9 * height(i) : height(i) / up.metres;
        std::snprintf(row, sizeof row, "%.9g%s%.9g\n", x, separator.c_str(), h);
        file.text += row;
    }
    return file;
}

class TestDrawnSpellings : public QObject {
    Q_OBJECT

private slots:
    void readRightOrRefused_data()
    {
        QTest::addColumn<int>("truth");
        QTest::addColumn<QByteArray>("text");
        Draws draw(20241127);
        constexpr Truth kinds[] = {Truth::Heights, Truth::Heights, Truth::Depths, Truth::NoHeights, Truth::Prose};
        for (int k = 0; k < 150; ++k) {
            const Truth truth = kinds[k % 5];
            const Drawn file = drawn(draw, truth);
            QTest::newRow((std::to_string(k) + ' ' + file.heading).c_str())
                << static_cast<int>(truth) << QByteArray::fromStdString(file.text);
        }
    }
    void readRightOrRefused()
    {
        QFETCH(int, truth);
        QFETCH(QByteArray, text);
        const HeightMapDocument document = readHeightMapText(text.toStdString(), "a.csv");
        if (truth == static_cast<int>(Truth::NoHeights) || truth == static_cast<int>(Truth::Prose)) {
            QVERIFY2(!document.valid(), "it was read");
            return;
        }
        QVERIFY2(document.valid(), document.valid() ? "" : document.problems.front().text().c_str());
        const bool turned = truth == static_cast<int>(Truth::Depths);
        QCOMPARE(document.warnings.empty(), !turned);
        QCOMPARE(document.map.nx, points);
        QVERIFY(std::abs(document.map.dx / step - 1.0) < 1e-4);
        double sum = 0.0, error = 0.0; // squares
        for (int i = 0; i < points; ++i) {
            const double right = turned ? -height(i) : height(i);
            const double off = document.map.heights[static_cast<std::size_t>(i)] - right;
            sum += right * right;
            error += off * off;
        }
        QVERIFY(std::sqrt(error / sum) < 1e-4);
    }
};

TOUCHDOWN_TEST(TestDrawnSpellings)

} // namespace test_drawn_spellings

#include "test_drawn_spellings.moc"

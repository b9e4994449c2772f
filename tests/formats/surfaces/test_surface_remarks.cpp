// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/surfaces/surface_remarks.h"

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_surface_remarks {

/// The lines of the doubtful remarks of a profile in um and nm, 4 points that are 1 um apart and 3 nm high.
std::vector<int> doubtfulLines(const std::string& remarks)
{
    const MapTable table = readMapTable(remarks + "\n0 1\n1 2\n2 .5\n3 -1\n");
    std::vector<int> lines;
    for (const HeadingLine& each : unusedRemarks(table, HeaderValues(table), {1e-6, 1e-9}, {}, false))
        lines.push_back(each.line);
    return lines;
}

class TestSurfaceRemarks : public QObject {
    Q_OBJECT

private slots:
    void doubtful_data()
    {
        QTest::addColumn<QByteArray>("remark");
        for (const char* remark :
             {// direction and sign
              "# positive values are pits", "# H\xC3\xB6hen nach unten positiv", "# z axis points into the disk",
              "# inverted: yes", "# depth profile", "# height is negated", "# signs were flipped, values down",
              "# z increases downwards", "# recess counts positive", "Profondeur positive",
              // factor and function
              "# multiply heights by 10", "# z sensitivity: 10 nm/V", "# heights x10", "# height times 3",
              "# vertical exaggeration 100", "# standard deviation over 64 tracks",
              "# The second column is the standard deviation.", "# z is the logarithm of the height in nm",
              "# type: gap", "# Werte: Varianz", "# heights are scaled", "# peaks are negative", "# z = -h",
              "# amplification 20x", "# vertical magnification 5000x", "# data: phase",
              // unit
              "# heights in counts, 1 count = 0.1 nm", "# heights in waves (633 nm)", "# z sensor signal in V",
              "# heights above are in pm", "# Units: m", "# height unit: um", "# height unit is 10 nm",
              "# heights in %", "# column 2 [pm]", "# heights in um", "# unit of z is 0.1 nm",
              "# heights in units of 2 nm", "# values in mV", "# z [pm]",
              // count and size
              "# 32 x 16 points", "# Points: 128", "# Number of points = 5", "# nx: 5", "# Anzahl Punkte: 96",
              "# Spacing: 0.5 um", "# Spacing: 1 um, after decimation 4: 4 um", "# Z Amplitude: 350 nm",
              // the name of a column
              "# x etching"})
            QTest::newRow(remark) << QByteArray(remark);
    }
    void doubtful()
    {
        QFETCH(QByteArray, remark);
        QCOMPARE(doubtfulLines("# Disk A\n" + remark.toStdString()), (std::vector<int>{2}));
    }

    // Dates, people, instruments and conditions of the measurement, and figures of the surface.
    void harmless_data()
    {
        QTest::addColumn<QByteArray>("remark");
        for (const char* remark : {"# measured on 2024-03-05",
                                   "# Date: 05/03/2024 12:30",
                                   "# operator: Ann",
                                   "# Zygo NewView 7300, objective 20x",
                                   "# direction: down",
                                   "# mode: phase",
                                   "# scan rate: 1 Hz",
                                   "# scan size: 10 um x 10 um, speed 5 um/s",
                                   "# tip radius (nm), speed (um/s)",
                                   "# Tip radius: 8 nm",
                                   "# filtered: cutoff 0.8 mm, lambda_s 2.5 um",
                                   "# Rq = 1.17 nm",
                                   "Ra 0.9 nm  Rq 1.2 nm",
                                   "# RMS roughness: 1.08 nm",
                                   "# max height 3.2 nm",
                                   "# Profile of disk 7 (radius 23 mm, speed 13 m/s)",
                                   "# heights in nm over positions in um",
                                   "# Height profile, track 3",
                                   "# trace: heights from 12 nm to 3 um",
                                   "# pit depth: 3 nm",
                                   "# bit depth: 16",
                                   "# H\xC3\xB6he \xC3\xBC"
                                   "ber dem Mittel",
                                   "# heights above the mean plane",
                                   "# levelled, mean removed",
                                   "# AFM height image of disk A",
                                   "# temperature 21 C, humidity 40 %",
                                   "# averaged over 16 lines",
                                   "# scan width: 30 um",
                                   "# height: 12.5 um",
                                   "# Points: 4",
                                   "# 4 points",
                                   "# Spacing: 1 um",
                                   "# Units: nm",
                                   "# Z Amplitude: 3.5 nm",
                                   "# file created by Tool 2.1",
                                   "# log file: a.txt",
                                   "# quality factor: 200",
                                   "# ISO standard 25178",
                                   "# magnification 50x",
                                   "# moving average of 5 points",
                                   "# serial 123-456"})
            QTest::newRow(remark) << QByteArray(remark);
    }
    void harmless()
    {
        QFETCH(QByteArray, remark);
        QCOMPARE(doubtfulLines("# Disk A\n" + remark.toStdString() + "\n# end"), std::vector<int>());
    }

    // 3 columns of 512 lines are 32 x 16 points, a matrix of 16 lines of 32 too.
    void countsOfMaps()
    {
        std::string points, matrix;
        for (int j = 0; j < 16; ++j, matrix += "\n")
            for (int i = 0; i < 32; ++i, matrix += "1 ") points += std::to_string(i) + " " + std::to_string(j) + " 1\n";
        const auto doubts = [](const std::string& text, const ColumnUnits& units, bool isMatrix) {
            const MapTable table = readMapTable(text);
            return unusedRemarks(table, HeaderValues(table), units, {}, isMatrix).size();
        };
        const ColumnUnits three = {1e-6, 1e-6, 1e-9};
        QCOMPARE(doubts("# 32 x 16 points\n" + points, three, false), std::size_t{0});
        QCOMPARE(doubts("# 32 x 18 points\n" + points, three, false), std::size_t{1});
        QCOMPARE(doubts("# 32 x 16 points\n" + matrix, {1e-9}, true), std::size_t{0});
        QCOMPARE(doubts("# 64 x 16 points\n" + matrix, {1e-9}, true), std::size_t{1});
    }

    void linesThatWereUsedAreNoRemarks()
    {
        const MapTable table = readMapTable("x [um],depth [nm]\n0,1\n1,2\n# depth\n");
        const auto remarks = unusedRemarks(table, HeaderValues(table), {1e-6, 1e-9}, {1}, false);
        QCOMPARE(remarks.size(), std::size_t{1});
        QCOMPARE(remarks.front().line, 4);
        const MapTable behind =
            readMapTable("0,1\n1,2\n# factor 10 for heights\n"); // values are read before the numbers
        QCOMPARE(unusedRemarks(behind, HeaderValues(behind), {1e-6, 1e-9}, {}, false).size(), std::size_t{1});
    }
};

TOUCHDOWN_TEST(TestSurfaceRemarks)

} // namespace test_surface_remarks

#include "test_surface_remarks.moc"

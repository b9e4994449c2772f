// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/dxf_drawing.h"

#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>

#include <fstream>
#include <numbers>
#include <random>

#include "core/formats/dxf_surface.h"
#include "tests/support/dxf_sample.h"
#include "tests/support/random_surface.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_dxf_drawing {

constexpr double mm = 1e-3; // [m]

class TestDxfDrawing : public QObject {
    Q_OBJECT

private slots:
    void readsWhatAnotherProgramWrote()
    {
        const Drawing drawing = read(test::dxfSample());
        QCOMPARE(drawing.problem, std::string());
        QCOMPARE(drawing.unit, 0.0);
        QCOMPARE(drawing.remark, std::string("1 text is not shown."));
        QCOMPARE(drawing.paths.size(), std::size_t{7});
        const DrawnPath& pad = drawing.paths[0];
        QVERIFY(pad.closed);
        QCOMPARE(pad.layer, std::string("PAD"));
        QVERIFY((pad.points == std::vector<SurfacePoint>{{0.1, 0.1}, {0.3, 0.1}, {0.3, 0.2}, {0.1, 0.2}}));
        // A bulge of 1 is half a circle, about (0.7, 0.15) with radius 0.05, and to the right of its chord.
        const std::vector<SurfacePoint>& round = drawing.paths[1].points;
        QCOMPARE(round.size(), std::size_t{4 + 44});
        double farthest = 0.0;
        for (std::size_t i = 2; i + 2 < round.size(); ++i) {
            QVERIFY(std::abs(std::hypot(round[i].x - 0.7, round[i].y - 0.15) - 0.05) < 1e-12);
            farthest = std::max(farthest, round[i].x);
        }
        QVERIFY(std::abs(farthest - 0.75) < 0.05 * 0.0007);
        // The area of a regular polygon with 90 corners: n/2 r^2 sin(2 pi/n).
        const DrawnPath& circle = drawing.paths[6];
        QVERIFY(circle.closed);
        QVERIFY(std::abs(area(circle.points) - 45.0 * 0.0025 * std::sin(2.0 * std::numbers::pi / 90.0)) < 1e-15);
    }

    void outlinesBecomeRails()
    {
        Drawing drawing = read(test::dxfSample());
        for (DrawnPath& path : drawing.paths)
            for (SurfacePoint& p : path.points) p = {p.x * mm, p.y * mm};
        const std::vector<Rail> rails = railsOfDrawing(drawing.paths, 1.25 * mm, 1.0 * mm).rails;
        QCOMPARE(rails.size(), std::size_t{4}); // with the outline of lines and an arc
        std::vector<SurfacePoint> joined;
        for (const RailPoint& p : rails[3].points) joined.push_back({p.x, p.y});
        QCOMPARE(joined.size(), std::size_t{4 + 44});
        // The rectangle of 100 by 100 um and half of a regular polygon with 90 corners.
        const double half = 22.5 * 0.0025 * std::sin(2.0 * std::numbers::pi / 90.0);
        QVERIFY(std::abs(std::abs(area(joined)) - (0.01 + half) * mm * mm) < 1e-18);
    }

    void unitsOfTheHeader_data()
    {
        QTest::addColumn<QByteArray>("number");
        QTest::addColumn<double>("unit");
        QTest::newRow("none") << QByteArray("0") << 0.0;
        QTest::newRow("inches") << QByteArray("1") << 25.4e-3;
        QTest::newRow("millimetres") << QByteArray("4") << 1e-3;
        QTest::newRow("nanometres") << QByteArray("12") << 1e-9;
        QTest::newRow("micrometres") << QByteArray("13") << 1e-6;
        QTest::newRow("light years") << QByteArray("19") << 0.0;
        QTest::newRow("no number") << QByteArray("x") << 0.0;
    }
    void unitsOfTheHeader()
    {
        QFETCH(const QByteArray, number);
        const std::string header = "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n" + number.toStdString() + "\n0\nENDSEC\n";
        QTEST(read(header + test::dxfSample()).unit, "unit");
    }

    void partsOfBlocksAreNotShownTwice()
    {
        const std::string blocks = "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nA\n0\nLINE\n8\n0\n10\n0\n20\n0\n11\n1\n21\n1\n"
                                   "0\nENDBLK\n0\nENDSEC\n";
        const std::string inserts = "0\nSECTION\n2\nENTITIES\n0\nINSERT\n2\nA\n0\nINSERT\n2\nA\n";
        std::string text = test::dxfSample();
        text.replace(0, text.find("ENTITIES\n") + 9, blocks + inserts);
        const Drawing drawing = read(text);
        QCOMPARE(drawing.paths.size(), std::size_t{7});
        QCOMPARE(drawing.remark, std::string("2 blocks and 1 text are not shown."));
    }

    /// Seen from below, x runs to the left; lines and polylines in space are not seen so.
    void whatIsDrawnFromBelow()
    {
        const std::string below = "8\n0\n210\n0\n220\n0\n230\n-1\n";
        const std::string corners = "0\nVERTEX\n8\n0\n10\n1\n20\n2\n0\nVERTEX\n8\n0\n10\n3\n20\n4\n0\nSEQEND\n";
        const Drawing drawing =
            read("0\nSECTION\n2\nENTITIES\n"
                 "0\nLINE\n10\n1\n20\n2\n11\n3\n21\n4\n" +
                 below + "0\nPOLYLINE\n66\n1\n70\n8\n" + below + corners + "0\nPOLYLINE\n66\n1\n70\n0\n" + below +
                 corners + "0\nARC\n10\n1\n20\n2\n40\n1\n50\n0\n51\n90\n" + below + "0\nENDSEC\n0\nEOF\n");
        QCOMPARE(drawing.problem, std::string());
        QCOMPARE(drawing.paths.size(), std::size_t{4});
        const std::vector<SurfacePoint> seen{{1.0, 2.0}, {3.0, 4.0}}, mirrored{{-1.0, 2.0}, {-3.0, 4.0}};
        QVERIFY(drawing.paths[0].points == seen);
        QVERIFY(drawing.paths[1].points == seen);
        QVERIFY(drawing.paths[2].points == mirrored);
        QCOMPARE(drawing.paths[3].points.front().x, -2.0);
    }

    void whatIsNoDrawing_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("problem");
        const auto row = [](const char* name, const std::string& text, const char* problem) {
            QTest::newRow(name) << QByteArray::fromStdString(text) << QByteArray(problem);
        };
        const std::string good = test::dxfSample();
        row("empty", "", "empty");
        row("blank", " \n\n", "empty");
        row("a letter", "Dear Sir,\nplease find the drawing enclosed.\n", "not a DXF");
        row("binary", std::string("AutoCAD Binary DXF\r\n\x1a\0\0\0", 24), "binary");
        row("cut off", good.substr(0, good.size() / 2), "cut off");
        row("UTF-16", "\xff\xfe" + std::string("S\0E\0C\0", 6), "not a DXF");
        row("nothing drawn", "0\nSECTION\n2\nENTITIES\n0\nTEXT\n1\nx\n0\nENDSEC\n0\nEOF\n", "1 text is not shown");
        row("a hatch", "0\nSECTION\n2\nENTITIES\n0\nHATCH\n2\nSOLID\n70\n1\n0\nENDSEC\n0\nEOF\n",
            "1 hatch is not shown");
        const std::string mesh = "0\nPOLYLINE\n66\n1\n70\n16\n0\nSEQEND\n";
        row("a mesh", "0\nSECTION\n2\nENTITIES\n" + mesh + "0\nENDSEC\n0\nEOF\n", "1 mesh is not shown");
        row("meshes", "0\nSECTION\n2\nENTITIES\n" + mesh + mesh + "0\nENDSEC\n0\nEOF\n", "2 meshes are not shown");
        row("far away", "0\nSECTION\n2\nENTITIES\n0\nLINE\n10\n0\n20\n0\n11\n1e300\n21\n1\n0\nENDSEC\n0\nEOF\n",
            "1 impossible line is not shown");
        std::string many = "0\nSECTION\n2\nENTITIES\n";
        for (int i = 0; i < 1'000'000; ++i) many += "0\nLINE\n8\n0\n10\n0\n20\n0\n11\n1\n21\n1\n";
        row("a million lines", many + "0\nENDSEC\n0\nEOF\n", "50,000 lines");
        std::string corners = "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n90\n2000000000\n70\n1\n";
        for (int i = 0; i < 1'000'000; ++i) corners += "10\n0\n20\n" + std::to_string(i) + "\n";
        row("a million corners", corners + "0\nENDSEC\n0\nEOF\n", "");
    }
    void whatIsNoDrawing()
    {
        QFETCH(const QByteArray, text);
        QFETCH(const QByteArray, problem);
        const std::string said = read(text.toStdString()).problem;
        QVERIFY2(!said.empty() && said.find('\n') == std::string::npos, said.c_str());
        QVERIFY2(said.find(problem.toStdString()) != std::string::npos, said.c_str());
    }

    void damagedFiles()
    {
        std::mt19937 random(3);
        const std::string good = dxfText(test::RandomSurface(5).draw(), 0.85e-3, 0.7e-3);
        for (int i = 0; i < 20; ++i) {
            std::string text = good;
            for (int k = 0; k < 5; ++k) text[random() % text.size()] = static_cast<char>(random());
            const Drawing drawing = read(text);
            QVERIFY(drawing.problem.find('\n') == std::string::npos);
            QVERIFY(!drawing.problem.empty() || !drawing.paths.empty());
            for (const DrawnPath& path : drawing.paths)
                for (const SurfacePoint& p : path.points) QVERIFY(std::isfinite(p.x) && std::isfinite(p.y));
        }
    }

    void filesThatAreNone()
    {
        QCOMPARE(readDxf("/no/such/file.dxf").problem, std::string("does not exist"));
        QVERIFY(readDxf("/dev/zero").problem.find("not a regular file") != std::string::npos);
        QVERIFY(readDxf(folder_.path().toStdString()).problem.find("directory") != std::string::npos);
    }

private:
    Drawing read(const std::string& text)
    {
        const std::string path = folder_.filePath("a.dxf").toStdString();
        std::ofstream(path, std::ios::binary) << text;
        return readDxf(path);
    }
    static double area(const std::vector<SurfacePoint>& points)
    {
        double twice = 0.0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const SurfacePoint &a = points[i], &b = points[(i + 1) % points.size()];
            twice += a.x * b.y - b.x * a.y;
        }
        return 0.5 * twice;
    }

    QTemporaryDir folder_;
};

TOUCHDOWN_TEST(TestDxfDrawing)

} // namespace test_dxf_drawing

#include "test_dxf_drawing.moc"

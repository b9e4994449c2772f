// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/dxf_surface.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <fstream>

#include "tests/support/random_surface.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_dxf_surface {

constexpr double length = test::RandomSurface::length, width = test::RandomSurface::width; // [m]

class TestDxfSurface : public QObject {
    Q_OBJECT

private slots:
    /// A drawing has places and recesses; walls are lost.
    void drawnSurfacesAreReadBack()
    {
        for (unsigned seed = 1; seed <= 100; ++seed) {
            const AirBearingSurface surface = test::RandomSurface(seed).draw();
            const Drawing drawing = readBack(dxfText(surface, length, width));
            QCOMPARE(drawing.problem, std::string());
            QCOMPARE(drawing.remark, std::string());
            QCOMPARE(drawing.unit, 1e-3);
            const std::vector<Rail> rails = railsOfDrawing(inMetres(drawing), length, width).rails;
            QCOMPARE(rails.size(), surface.rails.size());
            for (std::size_t i = 0; i < rails.size(); ++i) {
                const Rail &rail = rails[i], &drawn = surface.rails[i];
                QCOMPARE(rail.kind, drawn.kind);
                for (std::size_t k = 0; k < (rail.kind == RailKind::Ramp ? 3U : 1U); ++k)
                    QVERIFY(std::abs(rail.recess[k] - drawn.recess[k]) < 1e-12);
                QCOMPARE(rail.points.size(), drawn.points.size());
                for (std::size_t k = 0; k < rail.points.size(); ++k) {
                    QVERIFY(std::abs(rail.points[k].x - drawn.points[k].x) < 1e-12);
                    QVERIFY(std::abs(rail.points[k].y - drawn.points[k].y) < 1e-12);
                }
            }
        }
    }

    void layersTellTheRecess()
    {
        AirBearingSurface surface;
        surface.baseRecess = 2.5e-6;
        const std::vector<RailPoint> corners{{0.0, 0.0}, {1e-4, 0.0}, {1e-4, 1e-4}};
        surface.rails = {{RailKind::Step, corners, {-20e-9}}, {RailKind::Ramp, corners, {0.0, 1.5e-6, 0.25e-9}}};
        const Drawing drawing = readBack(dxfText(surface, length, width));
        QCOMPARE(drawing.paths.size(), std::size_t{3});
        QCOMPARE(drawing.paths[0].layer, std::string("slider base 2500 nm"));
        QCOMPARE(drawing.paths[1].layer, std::string("rail 1 recess -20 nm"));
        QCOMPARE(drawing.paths[2].layer, std::string("rail 2 ramp 0 1500 0.25 nm"));
    }

    void theBorderIsNoRail()
    {
        const std::vector<SurfacePoint> border{{0.0, 0.0}, {0.0, width}, {length, width}, {length, 0.0}};
        std::vector<SurfacePoint> smaller = border;
        for (SurfacePoint& p : smaller) p.x = 0.5 * p.x;
        const std::vector<Rail> rails =
            railsOfDrawing({{"0", true, border}, {"0", true, smaller}}, length, width).rails;
        QCOMPARE(rails.size(), std::size_t{1});
        QCOMPARE(rails[0].points[2].x, 0.5 * length);
    }

    void aRailMayCoverTheSlider()
    {
        AirBearingSurface surface;
        const std::vector<RailPoint> whole{{0.0, 0.0}, {length, 0.0}, {length, width}, {0.0, width}};
        surface.rails = {{RailKind::Step, whole, {0.0}}};
        const Drawing drawing = readBack(dxfText(surface, length, width));
        QCOMPARE(drawing.paths.size(), std::size_t{2});
        QCOMPARE(railsOfDrawing(inMetres(drawing), length, width).rails.size(), std::size_t{1});
    }

    void impossibleRecessesAreZero_data()
    {
        QTest::addColumn<QByteArray>("layer");
        QTest::addColumn<double>("first");
        QTest::addColumn<double>("second");
        QTest::newRow("a step") << QByteArray("rail 1 recess 20 nm") << 20e-9 << 0.0;
        QTest::newRow("no number") << QByteArray("rail 1 recess nan nm") << 0.0 << 0.0;
        QTest::newRow("infinite") << QByteArray("rail 1 recess -inf nm") << 0.0 << 0.0;
        QTest::newRow("huge") << QByteArray("rail 1 recess 1e300 nm") << 0.0 << 0.0;
        QTest::newRow("a kilometre") << QByteArray("rail 1 recess 1e12 nm") << 0.0 << 0.0;
        QTest::newRow("a ramp") << QByteArray("rail 1 ramp nan 1500 1e12 nm") << 0.0 << 1.5e-6;
    }
    void impossibleRecessesAreZero()
    {
        QFETCH(const QByteArray, layer);
        QFETCH(const double, first);
        QFETCH(const double, second);
        const std::vector<SurfacePoint> corners{{0.0, 0.0}, {1e-4, 0.0}, {1e-4, 1e-4}};
        const std::vector<Rail> rails = railsOfDrawing({{layer.toStdString(), true, corners}}, length, width).rails;
        QCOMPARE(rails.size(), std::size_t{1});
        // Not with QCOMPARE: to it, NaN is equal to NaN.
        QVERIFY(std::abs(rails[0].recess[0] - first) < 1e-15);
        QVERIFY(std::abs(rails[0].recess[1] - second) < 1e-15);
        QVERIFY(std::abs(rails[0].recess[2]) < 1e-15);
    }

    void tooManyOpenLinesAreNotJoined()
    {
        const std::vector<SurfacePoint> corners{{0.0, 0.0}, {1e-4, 0.0}, {1e-4, 1e-4}};
        std::vector<DrawnPath> paths{{"0", true, corners}};
        for (int i = 0; i < 5000; ++i) paths.push_back({"0", false, {{i * 1e-7, 2e-4}, {i * 1e-7, 3e-4}}});
        QVERIFY(!railsOfDrawing(paths, length, width).tooManyOpenLines);
        paths.push_back({"0", false, {{0.0, 4e-4}, {1e-4, 4e-4}}});
        const DrawnRails drawn = railsOfDrawing(paths, length, width);
        QVERIFY(drawn.tooManyOpenLines);
        QCOMPARE(drawn.rails.size(), std::size_t{1}); // the closed one
    }

private:
    Drawing readBack(const std::string& text)
    {
        const std::string path = folder_.filePath("a.dxf").toStdString();
        std::ofstream(path, std::ios::binary) << text;
        return readDxf(path);
    }
    static std::vector<DrawnPath> inMetres(const Drawing& drawing)
    {
        std::vector<DrawnPath> paths = drawing.paths;
        for (DrawnPath& path : paths)
            for (SurfacePoint& p : path.points) p = {p.x * drawing.unit, p.y * drawing.unit};
        return paths;
    }

    QTemporaryDir folder_;
};

TOUCHDOWN_TEST(TestDxfSurface)

} // namespace test_dxf_surface

#include "test_dxf_surface.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/maps/field_map.h"

#include <cmath>
#include <map>
#include <memory>

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QMenu>
#include <QTest>

#include "tests/support/test_program.h"
#include "tests/ui/sample_slider.h"
#include "ui/style/theme.h"

using namespace touchdown;

namespace test_field_map {

class TestFieldMap : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void findsTheCell_data();
    void findsTheCell();
    void aCellHasOneColour();
    void bordersStandWhereTheLinesAre();
    void knowsItsExtremes();
    void readsTheCellUnderThePointer();
    void printsNumbersWithFourDigits_data();
    void printsNumbersWithFourDigits();
    void drawsWithoutAField();
    void outlinesTheRails();
    void offersPictureAndNumbers();

private:
    QColor at(const SurfacePoint& point) const
    {
        return map_->grab().toImage().pixelColor(map_->toPixel(point).toPoint());
    }

    std::unique_ptr<FieldMap> map_;
    CellGrid grid_;
};

void TestFieldMap::initTestCase()
{
    QLocale::setDefault(QLocale::c());
    applyTheme(Theme::Light);
}

/// Three columns of 0.1, 0.3 and 0.6 mm, two rows of 0.2 and 0.3 mm; 0 to 5 kPa.
void TestFieldMap::init()
{
    grid_ = {{0.0, 0.1e-3, 0.4e-3, 1.0e-3}, {0.0, 0.2e-3, 0.5e-3}};
    map_ = std::make_unique<FieldMap>();
    map_->resize(800, 520);
    map_->setSlider(1.0e-3, 0.5e-3);
    map_->setLook(
        {QStringLiteral("Pressure"), QStringLiteral("kPa"), 1e3, ColourScale::linear(ColourMap::Viridis, 0.0, 5e3)});
    map_->setField(grid_, {0.0, 1e3, 2e3, 3e3, 4e3, 5e3});
    map_->show();
    QVERIFY(QTest::qWaitForWindowExposed(map_.get()));
}

void TestFieldMap::outlinesTheRails()
{
    const SurfacePoint onTheEdge{0.6e-3, 0.3e-3}, beside{0.7e-3, 0.35e-3};
    const QColor before = at(onTheEdge), inside = at(beside);
    Rail rail;
    rail.points = {{0.6e-3, 0.1e-3}, {0.9e-3, 0.1e-3}, {0.9e-3, 0.45e-3}, {0.6e-3, 0.45e-3}};
    map_->setRails({rail});
    QVERIFY(at(onTheEdge) != before);
    QCOMPARE(at(beside), inside);
    map_->setRails({});
    QCOMPARE(at(onTheEdge), before);
}

void TestFieldMap::offersPictureAndNumbers()
{
    const auto actions = [this] {
        const QPoint middle = map_->rect().center();
        QContextMenuEvent event(QContextMenuEvent::Mouse, middle, map_->mapToGlobal(middle));
        QApplication::sendEvent(map_.get(), &event);
        QMenu* menu = map_->findChildren<QMenu*>().back();
        std::map<QString, QAction*> named;
        for (QAction* action : menu->actions()) named[QString(action->text()).remove(QLatin1Char('&'))] = action;
        return named;
    };
    auto offered = actions();
    QVERIFY(offered.contains(QStringLiteral("Copy picture")) && offered.contains(QStringLiteral("Save picture…")) &&
            offered.contains(QStringLiteral("Save data…")));
    offered.at(QStringLiteral("Copy data"))->trigger();
    const QStringList lines = QGuiApplication::clipboard()->text().split(QLatin1Char('\n'), Qt::SkipEmptyParts);
    QCOMPARE(lines.size(), 7);
    QCOMPARE(lines[0], QStringLiteral("x [m],y [m],\"Pressure [kPa]\""));
    QCOMPARE(lines[2], QStringLiteral("0.00025,0.0001,1"));
    offered.at(QStringLiteral("Copy picture"))->trigger();
    QCOMPARE(QGuiApplication::clipboard()->image().isNull(), false);
    map_->setField({}, {});
    offered = actions();
    QVERIFY(offered.contains(QStringLiteral("Copy picture")) && !offered.contains(QStringLiteral("Copy data")));
}

void TestFieldMap::findsTheCell_data()
{
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<int>("cell"); // -1: none
    QTest::newRow("first") << 0.05e-3 << 0.1e-3 << 0;
    QTest::newRow("second column") << 0.2e-3 << 0.1e-3 << 1;
    QTest::newRow("second row") << 0.05e-3 << 0.3e-3 << 3;
    QTest::newRow("on a line: the cell after it") << 0.4e-3 << 0.2e-3 << 5;
    QTest::newRow("trailing outer corner") << 1.0e-3 << 0.5e-3 << 5;
    QTest::newRow("leading inner corner") << 0.0 << 0.0 << 0;
    QTest::newRow("beyond") << 1.01e-3 << 0.1e-3 << -1;
    QTest::newRow("before") << -1e-9 << 0.1e-3 << -1;
    QTest::newRow("nowhere") << std::nan("") << 0.1e-3 << -1;
}

void TestFieldMap::findsTheCell()
{
    QFETCH(const double, x);
    QFETCH(const double, y);
    QFETCH(const int, cell);
    const auto found = map_->cellAt({x, y});
    QCOMPARE(found ? static_cast<int>(*found) : -1, cell);
}

void TestFieldMap::aCellHasOneColour()
{
    const QRgb expected = map_->look().scale.colour(2e3);
    for (const double x : {0.41e-3, 0.55e-3, 0.8e-3, 0.99e-3})
        for (const double y : {0.02e-3, 0.1e-3, 0.14e-3}) QCOMPARE(at({x, y}).rgb(), expected);
}

void TestFieldMap::bordersStandWhereTheLinesAre()
{
    // Four pixels on either side of the line at 0.4 mm are of the one and the other cell, at any zoom.
    for (const double factor : {1.0, 40.0}) {
        map_->zoom(factor, map_->toPixel({0.4e-3, 0.1e-3}));
        const QImage image = map_->grab().toImage();
        const QPoint line = map_->toPixel({0.4e-3, 0.1e-3}).toPoint();
        QCOMPARE(image.pixel(line - QPoint(4, 0)), map_->look().scale.colour(1e3));
        QCOMPARE(image.pixel(line + QPoint(4, 0)), map_->look().scale.colour(2e3));
    }
}

void TestFieldMap::knowsItsExtremes()
{
    map_->setField(grid_, {3.0, -2.0, 1.0, 9.0, 4.0, 0.0});
    // A triangle above the smallest value and one below the largest.
    const QImage image = map_->grab().toImage();
    const auto marked = [&](std::size_t cell, int below) {
        const QPoint at = map_->toPixel(map_->centre(cell)).toPoint() + QPoint(0, below);
        return image.pixelColor(at) == lightPlotTheme().curves[1];
    };
    QVERIFY(marked(1, -6));
    QVERIFY(marked(3, 6));
    QVERIFY(!marked(5, -6) && !marked(5, 6));
    QVERIFY(std::abs(map_->centre(3).x - 0.05e-3) < 1e-12);
    QVERIFY(std::abs(map_->centre(3).y - 0.35e-3) < 1e-12);
}

void TestFieldMap::readsTheCellUnderThePointer()
{
    emit map_->pointed(SurfacePoint{0.7e-3, 0.4e-3});
    QVERIFY2(map_->reading().endsWith(QStringLiteral("5.000\u00a0kPa")), qPrintable(map_->reading()));
    emit map_->pointed(std::nullopt);
    QVERIFY(map_->reading().isEmpty());
}

void TestFieldMap::printsNumbersWithFourDigits_data()
{
    QTest::addColumn<double>("value");
    QTest::addColumn<QString>("text");
    QTest::newRow("units") << 5.0e3 << QStringLiteral("5.000\u00a0kPa");
    QTest::newRow("hundreds") << 898.46e3 << QStringLiteral("898.5\u00a0kPa");
    QTest::newRow("thousands") << 20.4561e6 << QStringLiteral("20456\u00a0kPa");
    QTest::newRow("negative") << -74.684e3 << QStringLiteral("\u221274.68\u00a0kPa");
    QTest::newRow("small") << 0.1234 << QStringLiteral("0.000\u00a0kPa");
    QTest::newRow("zero") << 0.0 << QStringLiteral("0\u00a0kPa");
}

void TestFieldMap::printsNumbersWithFourDigits()
{
    QFETCH(const double, value);
    QFETCH(const QString, text);
    QCOMPARE(fieldText(value, map_->look()), text);
}

void TestFieldMap::drawsWithoutAField()
{
    map_->setField({}, {});
    QVERIFY(map_->empty());
    QCOMPARE(at({0.7e-3, 0.3e-3}).rgb(), lightPlotTheme().background.rgb());
    QVERIFY(!map_->cellAt({0.7e-3, 0.3e-3}));
}

TOUCHDOWN_TEST(TestFieldMap)

} // namespace test_field_map

#include "test_field_map.moc"

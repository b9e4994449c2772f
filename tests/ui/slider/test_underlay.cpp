// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/underlay.h"

#include <fstream>

#include <QDropEvent>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

#include "core/formats/dxf_surface.h"
#include "tests/support/dxf_sample.h"
#include "tests/support/test_program.h"
#include "tests/ui/slider/editor_under_test.h"
#include "ui/slider/part_picking.h"
#include "ui/slider/underlay_dialog.h"

using namespace touchdown;

namespace test_underlay {

constexpr double length = 0.85e-3, width = 0.7e-3; // of sampleFilmCase() [m]

class TestUnderlay : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QCoreApplication::setOrganizationName(QStringLiteral("touchdown"));
        QCoreApplication::setApplicationName(QStringLiteral("test_underlay"));
    }
    void init() { QSettings().clear(); }

    /// A green picture whose lower left quarter is red: where its corners are put, there they are seen.
    void aPictureIsWhereItsNumbersSay()
    {
        QImage image(100, 50, QImage::Format_RGB32);
        image.fill(Qt::green);
        for (int y = 25; y < 50; ++y)
            for (int x = 0; x < 50; ++x) image.setPixel(x, y, qRgb(255, 0, 0));
        QVERIFY(image.save(path("a.png")));
        EditorUnderTest t(sampleFilmCase());
        Underlay& underlay = t.editor->underlay();
        underlay.load(path("a.png"), length, width);
        QTRY_VERIFY(underlay.loaded());
        QCOMPARE(underlay.place().width, length);
        UnderlayPlace place = underlay.place();
        place.width = 0.4e-3; // 0.2 mm high
        place.x = 0.30e-3;
        place.y = 0.25e-3;
        place.opacity = 1.0;
        underlay.setPlace(place);
        const auto colourAt = [&](double x, double y) { return t.editor->grab().toImage().pixelColor(t.pixel(x, y)); };
        const double aside = 3.0 / t.metre(); // [m]
        const QColor red(255, 0, 0), green(0, 255, 0);
        QCOMPARE(colourAt(0.30e-3 + aside, 0.25e-3 + aside), red);
        QCOMPARE(colourAt(0.50e-3 - aside, 0.35e-3 - aside), red);
        QCOMPARE(colourAt(0.50e-3 + aside, 0.35e-3 + aside), green);
        QVERIFY(colourAt(0.30e-3 - aside, 0.25e-3 - aside) != red);
        place.mirrored = true;
        underlay.setPlace(place);
        QCOMPARE(colourAt(0.30e-3 + aside, 0.25e-3 + aside), green);
        QCOMPARE(colourAt(0.30e-3 + aside, 0.45e-3 - aside), red);
        // Also in a view that shows a piece of the picture.
        t.editor->zoom(3.0, t.pixel(0.30e-3, 0.45e-3));
        QCOMPARE(colourAt(0.30e-3 + aside, 0.45e-3 - aside), red);
        place.shown = false;
        underlay.setPlace(place);
        QVERIFY(colourAt(0.30e-3 + aside, 0.45e-3 - aside) != red);
    }

    void aDrawingWithAUnitIsWhereItsCoordinatesAre()
    {
        write("a.dxf", dxfText(sampleFilmCase().surface, length, width));
        Underlay underlay(this);
        underlay.load(path("a.dxf"), length, width);
        QTRY_VERIFY(underlay.loaded());
        const std::vector<RailPoint> corners = sampleFilmCase().surface.rails[0].points;
        const DrawnPath drawn = underlay.paths()[1]; // after the border
        QCOMPARE(drawn.points.size(), corners.size());
        for (std::size_t i = 0; i < corners.size(); ++i)
            QVERIFY(std::hypot(drawn.points[i].x - corners[i].x, drawn.points[i].y - corners[i].y) < 1e-12);
        UnderlayPlace place = underlay.place();
        place.mirrored = true; // between 0 and the width of the slider
        underlay.setPlace(place);
        QVERIFY(std::abs(underlay.paths()[1].points[0].y - (width - corners[0].y)) < 1e-12);
    }

    void cornersOfADrawingHoldAPlace()
    {
        const AirBearingSurface surface = sampleFilmCase().surface;
        const SnapGrid grid{length, width, 5e-6, 1e-6};
        const std::vector<SurfacePoint> places{{0.4003e-3, 0.5007e-3}, {0.402e-3, 0.5e-3}};
        const SnappedPlace held = snappedTo(places, surface, {}, {0.401e-3, 0.501e-3}, grid);
        QCOMPARE(held.at, places[0]);
        QVERIFY(snappedTo(places, surface, {}, {0.42e-3, 0.52e-3}, grid).at != places[1]);
        QVERIFY(snappedTo({}, surface, {}, {0.401e-3, 0.501e-3}, grid).at != places[0]);
    }

    /// Dropped on the plan; its closed outlines become rails.
    void outlinesOfADroppedDrawingBecomeRails()
    {
        write("a.dxf", test::dxfSample());
        EditorUnderTest t(sampleFilmCase());
        const std::size_t before = t.surface().rails.size();
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(path("a.dxf"))});
        QDragEnterEvent enter(QPoint(300, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(t.editor.get(), &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent drop(QPointF(300, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(t.editor.get(), &drop);
        QTRY_VERIFY(t.editor->findChild<UnderlayDialog*>() != nullptr);
        auto* dialog = t.editor->findChild<UnderlayDialog*>();
        // The file has no unit: it is asked for.
        auto* unit = dialog->findChild<QComboBox*>();
        QVERIFY(unit->isEnabled());
        unit->setCurrentIndex(0);
        emit unit->activated(0);
        QVERIFY(std::abs(t.editor->underlay().place().width - 0.7e-3) < 1e-7); // 0.05 ... 0.75 mm, arcs in pieces
        emit dialog->railsWanted();
        QCOMPARE(t.surface().rails.size(), before + 4);
        // The pad begins 0.05 mm from the left end of the drawing and at its lower end.
        QVERIFY(std::abs(t.point(before, 0).x - 0.05e-3) < 1e-7);
        QVERIFY(std::abs(t.point(before, 0).y) < 1e-9);
        t.edits->undoStack().undo();
        QCOMPARE(t.surface().rails.size(), before);
    }

    void eachCaseHasItsOwn()
    {
        QVERIFY(QImage(20, 10, QImage::Format_RGB32).save(path("a.png")));
        Underlay underlay(this);
        underlay.openCase(QStringLiteral("/a.toml"));
        underlay.load(path("a.png"), length, width);
        QTRY_VERIFY(underlay.loaded());
        UnderlayPlace place{0.5e-3, 1e-6, 2e-6, true, 0.5, true};
        underlay.setPlace(place);
        underlay.openCase(QStringLiteral("/b.toml"));
        QVERIFY(!underlay.loaded());
        underlay.openCase(QStringLiteral("/a.toml"));
        QTRY_VERIFY(underlay.loaded());
        QCOMPARE(underlay.place(), place);
        underlay.renameCase(QStringLiteral("/c.toml"));
        Underlay another(this);
        another.openCase(QStringLiteral("/c.toml"));
        QTRY_VERIFY(another.loaded());
        another.remove();
        another.openCase(QStringLiteral("/c.toml"));
        QVERIFY(!another.loaded());
        // A file that has gone is told once, and is not forgotten.
        QVERIFY(QFile::remove(path("a.png")));
        QSignalSpy failed(&another, &Underlay::failed);
        another.openCase(QStringLiteral("/a.toml"));
        QTRY_COMPARE(failed.count(), 1);
        QVERIFY(failed[0][0].toString().contains(QStringLiteral("a.png does not exist")));
        QVERIFY(QImage(20, 10, QImage::Format_RGB32).save(path("a.png")));
        another.openCase(QStringLiteral("/a.toml"));
        QTRY_VERIFY(another.loaded());
    }

    void filesThatCannotBeShown_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("a text") << "a.png" << QByteArray("Dear Sir");
        QTest::newRow("nothing") << "a.jpg" << QByteArray();
        QTest::newRow("half a picture") << "a.png" << QByteArray("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0", 18);
        QTest::newRow("a drawing cut off") << "a.dxf" << QByteArray("0\nSECTION\n2\nENTITIES\n0\nLINE\n");
        QTest::newRow("one upright line") << "a.dxf"
                                          << QByteArray("0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n10\n0\n20\n0\n11\n0\n"
                                                        "21\n1\n0\nENDSEC\n0\nEOF\n");
    }
    void filesThatCannotBeShown()
    {
        QFETCH(const QString, name);
        QFETCH(const QByteArray, bytes);
        write(name, bytes.toStdString());
        Underlay underlay(this);
        QSignalSpy failed(&underlay, &Underlay::failed);
        underlay.load(path(name), length, width);
        QTRY_COMPARE(failed.count(), 1);
        QVERIFY(!failed[0][0].toString().contains(QLatin1Char('\n')));
        QVERIFY(!underlay.loaded());
    }

    void anEnormousPictureIsMadeSmallerOrRefused()
    {
        QVERIFY(QImage(6000, 60, QImage::Format_Grayscale8).save(path("a.png")));
        Underlay underlay(this);
        underlay.load(path("a.png"), length, width);
        QTRY_VERIFY(underlay.loaded());
        QCOMPARE(underlay.drawnWidth(), 4096.0);
        // A bit for a pixel: 50 MB, of which making it smaller would take 1.6 GB.
        QImage image(20000, 20000, QImage::Format_Mono);
        image.fill(1);
        QVERIFY(image.save(path("b.png")));
        QSignalSpy failed(&underlay, &Underlay::failed);
        underlay.load(path("b.png"), length, width);
        QTRY_COMPARE(failed.count(), 1);
        QVERIFY(failed[0][0].toString().contains(QStringLiteral("20000 by 20000")));
        QCOMPARE(underlay.drawnWidth(), 4096.0); // the one before stays
    }

private:
    QString path(const QString& name) const { return folder_.filePath(name); }
    void write(const QString& name, const std::string& text) const
    {
        std::ofstream(path(name).toStdString(), std::ios::binary) << text;
    }

    QTemporaryDir folder_;
};

TOUCHDOWN_TEST(TestUnderlay)

} // namespace test_underlay

#include "test_underlay.moc"

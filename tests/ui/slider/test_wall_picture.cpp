// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/wall_picture.h"

#include <cmath>
#include <memory>

#include <QSignalSpy>
#include <QTest>

#include "tests/support/test_program.h"
#include "ui/style/theme.h"

using namespace touchdown;

namespace test_wall_picture {

const WallProfile profile{{-5e-6, 0.0, 20e-6}, {0.15e-6, 0.3e-6, 1.5e-6}};

class TestWallPicture : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { applyTheme(Theme::Light); }
    void init()
    {
        picture_ = std::make_unique<WallPicture>();
        picture_->resize(280, 190);
        picture_->setWall(profile);
        connect(picture_.get(), &WallPicture::edited, picture_.get(),
                [this](const WallProfile& wall) { picture_->setWall(wall); });
        picture_->show();
        QVERIFY(QTest::qWaitForWindowExposed(picture_.get()));
    }
    void cleanup() { picture_.reset(); }

    void dragsAPoint()
    {
        QSignalSpy edited(picture_.get(), &WallPicture::edited);
        const QPoint from = picture_->pixel(1).toPoint(), to = from + QPoint(20, 15);
        QTest::mousePress(picture_.get(), Qt::LeftButton, {}, from);
        QCOMPARE(picture_->point(), std::optional<std::size_t>(1));
        move(to);
        QCOMPARE(edited.count(), 0);
        QTest::mouseRelease(picture_.get(), Qt::LeftButton, {}, to);
        QCOMPARE(edited.count(), 1);
        // One pixel is 25 um over the width from the first to the last point, 1.35 um over the height.
        QCOMPARE(picture_->wall().distance.size(), std::size_t(3));
        QVERIFY(picture_->wall().distance[1] > 1.5e-6 && picture_->wall().distance[1] < 2.5e-6);
        QVERIFY(picture_->wall().recess[1] > 0.4e-6 && picture_->wall().recess[1] < 0.6e-6);
        QVERIFY(picture_->wall().distance[0] == profile.distance[0]);
        // Not past a neighbour.
        const QPoint now = picture_->pixel(1).toPoint();
        QTest::mousePress(picture_.get(), Qt::LeftButton, {}, now);
        move(now - QPoint(150, 0));
        QTest::mouseRelease(picture_.get(), Qt::LeftButton, {}, now);
        QCOMPARE(picture_->wall().distance[1], -5e-6);
    }
    void escapeGivesADragBack()
    {
        QSignalSpy edited(picture_.get(), &WallPicture::edited);
        QTest::mousePress(picture_.get(), Qt::LeftButton, {}, picture_->pixel(1).toPoint());
        move(picture_->pixel(1).toPoint() + QPoint(20, 15));
        QVERIFY(picture_->wall() != profile);
        QTest::keyClick(picture_.get(), Qt::Key_Escape);
        QVERIFY(picture_->wall() == profile);
        QTest::mouseRelease(picture_.get(), Qt::LeftButton, {}, {});
        QCOMPARE(edited.count(), 0);
    }
    void keys()
    {
        QSignalSpy chosen(picture_.get(), &WallPicture::pointChosen);
        picture_->setPoint(0);
        QTest::keyClick(picture_.get(), Qt::Key_B);
        QCOMPARE(chosen.back().front().toInt(), 2);
        QTest::keyClick(picture_.get(), Qt::Key_Right, Qt::ShiftModifier);
        QVERIFY(std::abs(picture_->wall().distance[2] - 21e-6) < 1e-15);
        QTest::keyClick(picture_.get(), Qt::Key_Up);
        QVERIFY(std::abs(picture_->wall().recess[2] - 1.49e-6) < 1e-15);
        QTest::keyClick(picture_.get(), Qt::Key_Insert);
        QCOMPARE(picture_->wall().distance.size(), std::size_t(4));
        QVERIFY(std::abs(picture_->wall().distance[3] - 42e-6) < 1e-15);
        QCOMPARE(picture_->point(), std::optional<std::size_t>(3));
        QTest::keyClick(picture_.get(), Qt::Key_Delete);
        QCOMPARE(picture_->wall().distance.size(), std::size_t(3));
        picture_->setPoint(0);
        for (int i = 0; i < 4; ++i) QTest::keyClick(picture_.get(), Qt::Key_Delete);
        QCOMPARE(picture_->wall().distance.size(), std::size_t(2));
    }
    void aDoubleClickAddsAPoint()
    {
        const QPointF between = 0.5 * (picture_->pixel(1) + picture_->pixel(2));
        QTest::mouseDClick(picture_.get(), Qt::LeftButton, {}, between.toPoint());
        QCOMPARE(picture_->wall().distance.size(), std::size_t(4));
        QVERIFY(std::abs(picture_->wall().distance[2] - 10e-6) < 0.2e-6);
        QVERIFY(std::abs(picture_->wall().recess[2] - 0.9e-6) < 0.02e-6);
    }
    /// A profile of which the file has no values is drawn empty, without a fault.
    void withoutPoints()
    {
        picture_->setWall({});
        QTest::keyClick(picture_.get(), Qt::Key_N);
        QTest::keyClick(picture_.get(), Qt::Key_Insert);
        picture_->grab();
        QVERIFY(picture_->wall() == WallProfile{});
    }
    /// Small pictures have ink in the colour of the text, without a profile too.
    void pixmaps()
    {
        for (const WallProfile& wall : {profile, WallProfile{}}) {
            const QImage image = wallPixmap(wall, {32, 16}, picture_->palette(), 1.0).toImage();
            int ink = 0;
            for (int y = 0; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x) ink += qAlpha(image.pixel(x, y)) > 128;
            QVERIFY(ink > 20 && ink < 200);
        }
    }

private:
    void move(const QPoint& to)
    {
        QMouseEvent event(QEvent::MouseMove, to, picture_->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
        QCoreApplication::sendEvent(picture_.get(), &event);
    }
    std::unique_ptr<WallPicture> picture_;
};

TOUCHDOWN_TEST(TestWallPicture)

} // namespace test_wall_picture

#include "test_wall_picture.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/mode_picture.h"

#include <algorithm>
#include <numbers>

#include <QClipboard>
#include <QGuiApplication>
#include <QSignalSpy>
#include <QTest>

#include "tests/support/test_program.h"
#include "tests/ui/film/sample_modes.h"
#include "ui/film/mode_motion.h"
#include "ui/style/theme.h"

using namespace touchdown;

namespace test_mode_picture {

class TestModePicture : public QObject {
    Q_OBJECT

private slots:
    void init();
    void drawsByTheAmplitudes();
    void staysAboveTheDisk();
    void bothViewsHaveOneScale();
    void movesOnlyWhileItIsSeen();
    void keysTurnAndPause();
    void paintsBothThemes();
    void marksWhereItTurns();
    void copiesItself();

private:
    Case case_ = sampleFilmCase();
    ModesResult modes_ = sampleModes(case_);
    std::unique_ptr<ModePicture> picture_;
};

void TestModePicture::init()
{
    QLocale::setDefault(QLocale::c());
    applyTheme(Theme::Light);
    picture_ = std::make_unique<ModePicture>();
    picture_->resize(800, 400);
    picture_->setPlaying(false);
    picture_->setState(case_, modes_.steady.attitude);
}

/// The drawn attitude is the static one, raised, plus the mode's part at the phase times the largest motion.
void TestModePicture::drawsByTheAmplitudes()
{
    const Attitude still = picture_->shownAttitude();
    QCOMPARE(still.height, modes_.steady.attitude.height + picture_->lift());
    for (const AirBearingMode& mode : modes_.modes) {
        picture_->setMode(mode, {});
        for (const double phase : {0.0, 1.0, std::numbers::pi, 5.0}) {
            picture_->setPhase(phase);
            const Attitude change = changeAt(mode, case_.slider, phase);
            const Attitude shown = picture_->shownAttitude();
            QCOMPARE(shown.height, still.height + picture_->amplitude() * change.height);
            QCOMPARE(shown.pitch, still.pitch + picture_->amplitude() * change.pitch);
            QCOMPARE(shown.roll, still.roll + picture_->amplitude() * change.roll);
        }
    }
    // At phase 0 the corner that moves most is the largest motion higher: the inner edge of the roll.
    picture_->setMode(modes_.modes.front(), {});
    picture_->setPhase(0.0);
    const Attitude shown = picture_->shownAttitude();
    const double inner = (shown.roll - still.roll) * 0.5 * case_.slider.width;
    QVERIFY(std::abs(inner - picture_->amplitude()) < 1e-9 * picture_->amplitude());
}

void TestModePicture::staysAboveTheDisk()
{
    const SliderProfile profile(case_);
    for (const AirBearingMode& mode : modes_.modes) {
        picture_->setMode(mode, {});
        for (int i = 0; i < 24; ++i) {
            picture_->setPhase(i * std::numbers::pi / 12.0);
            const std::vector<double> heights = profile.fromSide(picture_->shownAttitude());
            QVERIFY(*std::ranges::min_element(heights) > 0.0);
        }
    }
}

void TestModePicture::bothViewsHaveOneScale()
{
    const ProfileDrawing side = picture_->side(), rear = picture_->rear();
    QVERIFY(std::abs(side.exaggeration() - rear.exaggeration()) < 1e-6 * side.exaggeration());
    QVERIFY(side.area.right() < rear.area.left());
    QVERIFY(rear.area.right() < picture_->width());
}

void TestModePicture::movesOnlyWhileItIsSeen()
{
    picture_->setPlaying(true);
    QVERIFY(!picture_->moving()); // no mode, not seen
    picture_->setMode(modes_.modes.front(), {});
    QVERIFY(!picture_->moving());
    picture_->show();
    QVERIFY(QTest::qWaitForWindowExposed(picture_.get()));
    QVERIFY(picture_->moving());
    const double before = picture_->phase();
    QTRY_VERIFY(picture_->phase() != before);
    picture_->hide();
    QVERIFY(!picture_->moving());
    picture_->show();
    QVERIFY(picture_->moving());
    picture_->setMode(std::nullopt, {});
    QVERIFY(!picture_->moving());
}

void TestModePicture::keysTurnAndPause()
{
    picture_->setMode(modes_.modes.front(), {});
    picture_->setPhase(0.0);
    QTest::keyClick(picture_.get(), Qt::Key_Right);
    QCOMPARE(picture_->phase(), std::numbers::pi / 12.0);
    QTest::keyClick(picture_.get(), Qt::Key_Left);
    QTest::keyClick(picture_.get(), Qt::Key_Left);
    QVERIFY(std::abs(picture_->phase() - 23.0 * std::numbers::pi / 12.0) < 1e-12);
    QSignalSpy changed(picture_.get(), &ModePicture::playingChanged);
    QTest::keyClick(picture_.get(), Qt::Key_Space);
    QVERIFY(picture_->playing());
    QCOMPARE(changed.count(), 1);
}

void TestModePicture::paintsBothThemes()
{
    picture_->setMode(modes_.modes.back(), QStringLiteral("Mode 2"));
    picture_->show();
    QVERIFY(QTest::qWaitForWindowExposed(picture_.get()));
    const QImage light = picture_->grab().toImage();
    applyTheme(Theme::Dark);
    QTRY_VERIFY(picture_->grab().toImage().pixelColor(1, 1).lightness() < 128);
    const QImage dark = picture_->grab().toImage();
    QVERIFY(light.pixelColor(1, 1).lightness() > 200);
    picture_->setPhase(2.0);
    QVERIFY(picture_->grab().toImage() != dark);
}

/// The line where the pitch turns, at 0.75 L, has the colour of the second curve.
void TestModePicture::marksWhereItTurns()
{
    picture_->setMode(modes_.modes.back(), {});
    const QImage image = picture_->grab().toImage();
    const QColor mark = lightPlotTheme().curves[1];
    const auto column = static_cast<int>(picture_->side().toPixel(0.75 * case_.slider.length, 0.0).x());
    int found = 0;
    for (int x = 0; x < image.width(); ++x)
        for (int y = 0; y < image.height(); ++y)
            if (image.pixelColor(x, y) == mark) {
                ++found;
                QVERIFY(std::abs(x - column) <= 5);
            }
    QVERIFY(found > 10);
}

/// As large as on the screen, with the mode in it.
void TestModePicture::copiesItself()
{
    picture_->setMode(modes_.modes.back(), {});
    copyPicture(*picture_);
    const QImage copied = QGuiApplication::clipboard()->image();
    QVERIFY(copied.width() >= picture_->width());
    int body = 0;
    for (int x = 0; x < copied.width(); x += 4)
        for (int y = 0; y < copied.height(); y += 4) body += copied.pixelColor(x, y).saturation() > 60;
    QVERIFY(body > 100);
}

TOUCHDOWN_TEST(TestModePicture)

} // namespace test_mode_picture

#include "test_mode_picture.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/mode_motion.h"

#include <cmath>
#include <numbers>

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_mode_motion {

constexpr SliderCase slider{.length = 1e-3, .width = 0.8e-3};

AirBearingMode mode(std::complex<double> height, std::complex<double> pitch, std::complex<double> roll,
                    const char* kind)
{
    AirBearingMode made;
    made.kind = kind;
    made.shape = {{{height.real(), height.imag()}, {pitch.real(), pitch.imag()}, {roll.real(), roll.imag()}}};
    return made;
}

class TestModeMotion : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void turnsAboutTheMiddle();
    void turnsBesideTheSlider();
    void outOfPhaseNothingRests();
    void movesAsAWhole();
    void rollsAboutALineAlong();
    void changesAsTheAmplitudesSay();
    void namesKinds();
};

// Pitch alone, 2/L: 1 at the leading, -1 at the trailing edge, 0 in the middle.
void TestModeMotion::turnsAboutTheMiddle()
{
    const AirBearingMode pitch = mode(0.0, 2e3, 0.0, "pitch");
    QCOMPARE(motionAt(pitch, slider, 0.0, 0.4e-3).real(), 1.0);
    QCOMPARE(motionAt(pitch, slider, 1e-3, 0.1e-3).real(), -1.0);
    QCOMPARE(leastMotion(pitch, slider)->at, 0.5e-3);
    QCOMPARE(leastMotion(pitch, slider)->motion, 0.0);
    QCOMPARE(motionWords(pitch, slider), QStringLiteral("turns about x = 0.50 mm"));
}

// height + pitch (L/2 - x) = 0 at x = L/2 + height/pitch: 0.4/0.5e3 = 0.8 mm behind the middle, and as far ahead.
void TestModeMotion::turnsBesideTheSlider()
{
    const AirBearingMode behind = mode(0.4, 0.5e3, 0.0, "vertical");
    QVERIFY(std::abs(leastMotion(behind, slider)->at - 1.3e-3) < 1e-15);
    QCOMPARE(motionWords(behind, slider), QStringLiteral("turns about x = 1.30 mm, behind the slider"));
    const AirBearingMode ahead = mode(0.4, -0.5e3, 0.0, "vertical");
    QVERIFY(std::abs(leastMotion(ahead, slider)->at + 0.3e-3) < 1e-15);
    QVERIFY(motionWords(ahead, slider).endsWith(QStringLiteral(", ahead of the slider")));
}

// Height i/2 beside pitch 2/L (a quarter of a cycle apart): the middle moves by 0.5, every other place by more.
void TestModeMotion::outOfPhaseNothingRests()
{
    const AirBearingMode turning = mode({0.0, 0.5}, 2e3, 0.0, "pitch");
    const auto least = leastMotion(turning, slider);
    QCOMPARE(least->at, 0.5e-3);
    QCOMPARE(least->motion, 0.5);
    for (const double x : {0.0, 0.3e-3, 0.7e-3, 1e-3})
        QVERIFY(std::abs(motionAt(turning, slider, x, 0.4e-3)) > least->motion);
    QCOMPARE(motionWords(turning, slider), QStringLiteral("moves least at x = 0.50 mm, by 50 % of the most"));
}

void TestModeMotion::movesAsAWhole()
{
    QVERIFY(!leastMotion(mode(1.0, 0.0, 0.0, "vertical"), slider));
    // 1/50 per mm: the line is 50 lengths away.
    QVERIFY(!leastMotion(mode(1.0, 20.0, 0.0, "vertical"), slider));
    QCOMPARE(motionWords(mode(1.0, 20.0, 0.0, "vertical"), slider), QStringLiteral("moves up and down as a whole"));
}

// height - roll (y - W/2) = 0 at y = W/2 + height/roll: 0.2/2e3 = 0.1 mm beyond the middle.
void TestModeMotion::rollsAboutALineAlong()
{
    const AirBearingMode roll = mode(0.2, 0.0, 2e3, "roll");
    QVERIFY(std::abs(leastMotion(roll, slider)->at - 0.5e-3) < 1e-15);
    QCOMPARE(motionWords(roll, slider), QStringLiteral("turns about y = 0.50 mm"));
    QVERIFY(std::abs(motionAt(roll, slider, 0.2e-3, 0.5e-3)) < 1e-15);
}

// The gap changes by Re(u e^(i phase)) at every place, with height + pitch (L - x) - roll (y - W/2) of the change.
void TestModeMotion::changesAsTheAmplitudesSay()
{
    const AirBearingMode any = mode({0.3, -0.1}, {800.0, 350.0}, {-200.0, 90.0}, "pitch");
    for (const double phase : {0.0, 0.7, std::numbers::pi / 2.0, 4.0}) {
        const Attitude change = changeAt(any, slider, phase);
        for (const double x : {0.0, 0.4e-3, 1e-3})
            for (const double y : {0.0, 0.4e-3, 0.8e-3}) {
                const double gap = change.height + change.pitch * (1e-3 - x) - change.roll * (y - 0.4e-3);
                const double expected = (motionAt(any, slider, x, y) * std::polar(1.0, phase)).real();
                QVERIFY(std::abs(gap - expected) < 1e-14);
            }
    }
}

void TestModeMotion::namesKinds()
{
    QCOMPARE(kindWord(mode(1.0, 0.0, 0.0, "vertical")), QStringLiteral("Vertical"));
    QCOMPARE(kindWord(mode(1.0, 0.0, 0.0, "pitch")), QStringLiteral("Pitch"));
    QCOMPARE(kindWord(mode(1.0, 0.0, 0.0, "roll")), QStringLiteral("Roll"));
}

TOUCHDOWN_TEST(TestModeMotion)

} // namespace test_mode_motion

#include "test_mode_motion.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/slider_profile.h"

#include <algorithm>
#include <cmath>

#include <QTest>

#include "tests/support/small_slider.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_slider_profile {

/// A plane of 1 mm x 0.8 mm with a pad from x = 0.5 mm to 0.75 mm, y = 0.2 mm to 0.4 mm; the rest 1 um higher.
Case onePad()
{
    Case c = test::smallSlider();
    c.surface.baseRecess = 1e-6;
    c.surface.crown = c.surface.camber = 0.0;
    c.surface.rails = {test::rectangle(0.5e-3, 0.2e-3, 0.75e-3, 0.4e-3, 0.0)};
    return c;
}

class TestSliderProfile : public QObject {
    Q_OBJECT

private slots:
    void nothingAtFirst() { QVERIFY(SliderProfile().empty()); }
    void fromTheSide();
    void fromTheRear();
};

// In the middle of the pad, x = 0.6 mm: h + p (L - x) - r (y - W/2) is least at the pad's edge y = 0.4 mm = W/2 for a
// positive roll, where the roll adds nothing, and at y = 0.2 mm for a negative one. Steps across are 0.8 mm / 120.
void TestSliderProfile::fromTheSide()
{
    const SliderProfile profile(onePad());
    QCOMPARE(profile.length(), 1e-3);
    for (const double roll : {10e-6, -10e-6}) {
        const std::vector<double> heights = profile.fromSide({20e-9, 100e-6, roll});
        QCOMPARE(heights.size(), std::size_t(SliderProfile::along + 1));
        const double edge = roll > 0.0 ? 0.4e-3 : 0.2e-3;
        const double expected = 20e-9 + 100e-6 * 0.4e-3 - roll * (edge - 0.4e-3);
        const double step = std::abs(roll) * 0.8e-3 / SliderProfile::across;
        QVERIFY(std::abs(heights[240] - expected) < 1.01 * step); // 240/400 of the length
        // Ahead of the pad the base, lowest at an edge of the slider.
        QVERIFY(std::abs(heights[0] - (1e-6 + 20e-9 + 100e-6 * 1e-3 - 10e-6 * 0.4e-3)) < 1e-15);
    }
}

// Beside the pad the base at the trailing edge, on it the pad's rear edge: h + p (L - 0.75 mm) - r (y - W/2).
void TestSliderProfile::fromTheRear()
{
    const SliderProfile profile(onePad());
    const std::vector<double> heights = profile.fromRear({20e-9, 100e-6, 10e-6});
    QCOMPARE(heights.size(), std::size_t(SliderProfile::across + 1));
    const double step = 100e-6 * 1e-3 / SliderProfile::along;
    QVERIFY(std::abs(heights[45] - (20e-9 + 100e-6 * 0.25e-3 - 10e-6 * (0.3e-3 - 0.4e-3))) < 1.01 * step);
    QVERIFY(std::abs(heights[120] - (1e-6 + 20e-9 - 10e-6 * 0.4e-3)) < 1e-15);
}

TOUCHDOWN_TEST(TestSliderProfile)

} // namespace test_slider_profile

#include "test_slider_profile.moc"

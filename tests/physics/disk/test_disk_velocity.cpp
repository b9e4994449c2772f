// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/disk/disk_velocity.h"

#include <cmath>
#include <numbers>

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_disk_velocity {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double length = 0.85e-3, width = 0.70e-3; // [m]

/// omega x r in vectors. Disk frame: the spindle at 0, the slider's centre at (R, 0, 0), the disk turns about +z, so
/// that it moves along (0, 1, 0) under the centre. A skew turns the slider's axes, at zero skew x along the motion and
/// y outwards, so that the velocity at the centre is omega R (cos phi, -sin phi) in them.
Velocity crossProduct(const DiskMotion& disk, double x, double y)
{
    const double c = std::cos(disk.skew), s = std::sin(disk.skew);
    const double axisX[3] = {s, c, 0.0}, axisY[3] = {c, -s, 0.0}, omega[3] = {0.0, 0.0, disk.speed};
    double r[3], v[3];
    for (int i = 0; i < 3; ++i)
        r[i] = (i == 0 ? disk.radius : 0.0) + (x - 0.5 * length) * axisX[i] + (y - 0.5 * width) * axisY[i];
    for (int i = 0; i < 3; ++i) v[i] = omega[(i + 1) % 3] * r[(i + 2) % 3] - omega[(i + 2) % 3] * r[(i + 1) % 3];
    return {v[0] * axisX[0] + v[1] * axisX[1], v[0] * axisY[0] + v[1] * axisY[1]};
}

bool agree(Velocity a, Velocity b) { return std::hypot(a.x - b.x, a.y - b.y) < 1e-13 * std::hypot(b.x, b.y); }

class TestDiskVelocity : public QObject {
    Q_OBJECT

private slots:
    void rotating_data()
    {
        QTest::addColumn<double>("skew");
        QTest::addColumn<double>("radius");
        for (const double skew : {0.0, 15.0, -18.0, 89.0})
            for (const double radius : {15e-3, 30e-3})
                QTest::addRow("skew %g deg, radius %g mm", skew, radius * 1e3) << skew * degree << radius;
    }
    void rotating()
    {
        QFETCH(double, skew);
        QFETCH(double, radius);
        const DiskMotion disk{.speed = 565.0, .radius = radius, .skew = skew};
        for (const double x : {0.0, 0.3e-3, length})
            for (const double y : {0.0, 0.5e-3, width}) {
                const Velocity v = diskVelocity(disk, length, width, x, y);
                QVERIFY(agree(v, crossProduct(disk, x, y)));
                // As the header writes it: size and local skew.
                const double fromX = 0.5 * length - x, fromY = 0.5 * width - y;
                const double a = radius - fromY * std::cos(skew) - fromX * std::sin(skew);
                const double b = fromX * std::cos(skew) - fromY * std::sin(skew);
                const double size = 565.0 * std::hypot(a, b), psi = skew - std::atan(b / a);
                QVERIFY(agree(v, {size * std::cos(psi), -size * std::sin(psi)}));
            }
    }

    /// Half a width outwards of the centre the radius is larger by as much; half a length towards the leading edge the
    /// disk moves outwards at omega L/2: by hand at 500 rad/s, 20 mm.
    void signsAtZeroSkew()
    {
        const DiskMotion disk{.speed = 500.0, .radius = 20e-3, .skew = 0.0};
        QVERIFY(agree(diskVelocity(disk, length, width, 0.5 * length, width), {500.0 * 20.35e-3, 0.0}));
        QVERIFY(agree(diskVelocity(disk, length, width, 0.0, 0.5 * width), {10.0, 500.0 * 0.425e-3}));
    }

    /// Positive skew: the air flows from the outer leading to the inner trailing edge.
    void positiveSkewBlowsInwards()
    {
        const DiskMotion disk{.speed = 500.0, .radius = 20e-3, .skew = 30.0 * degree};
        QVERIFY(agree(diskVelocity(disk, length, width, 0.5 * length, 0.5 * width), {10.0 * std::sqrt(0.75), -5.0}));
    }

    void uniformIsThatOfTheCentre()
    {
        const DiskMotion disk{.speed = 500.0, .radius = 20e-3, .skew = -12.0 * degree, .field = VelocityField::Uniform};
        for (const double x : {0.0, length})
            for (const double y : {0.0, width})
                QVERIFY(agree(diskVelocity(disk, length, width, x, y),
                              {10.0 * std::cos(12.0 * degree), 10.0 * std::sin(12.0 * degree)}));
    }
};

TOUCHDOWN_TEST(TestDiskVelocity)

} // namespace test_disk_velocity

#include "test_disk_velocity.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/air.h"

#include <cmath>

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_air {

class TestAir : public QObject {
    Q_OBJECT

private slots:
    /// Pressures of the US Standard Atmosphere 1976 at geopotential altitudes (its constants differ in the fifth
    /// digit). Viscosity at 300 K: 1.458e-6 * 5196.1524/410.4. Mean free path at 300 K and p0: k = 1.380649e-23 J/K,
    /// 1.380649e-23 * 300/(4.4428829 * 1.33225e-19 * 101325) = 69.062 nm.
    void atmosphere_data()
    {
        QTest::addColumn<double>("altitude");
        QTest::addColumn<double>("temperature");
        QTest::addColumn<double>("pressure");
        QTest::addColumn<double>("viscosity");
        QTest::addColumn<double>("meanFreePath");
        QTest::newRow("sea level, 300 K") << 0.0 << 300.0 << 101325.0 << 1.845993e-5 << 69.0619e-9;
        QTest::newRow("1000 m below, 300 K")
            << -1000.0 << 300.0 << 113929.0 << 1.845993e-5 << 69.0619e-9 * 101325.0 / 113929.0;
        QTest::newRow("10 000 ft, 300 K")
            << 3048.0 << 300.0 << 69681.7 << 1.845993e-5 << 69.0619e-9 * 101325.0 / 69681.7;
        // 1.458e-6 * 4124.3181/367.55; mean free path in proportion to the temperature.
        QTest::newRow("10 000 m, 257.15 K")
            << 10000.0 << 257.15 << 26436.3 << 1.635758e-5 << 69.0619e-9 * 257.15 / 300.0 * 101325.0 / 26436.3;
    }
    void atmosphere()
    {
        QFETCH(double, altitude);
        QFETCH(double, temperature);
        QFETCH(double, pressure);
        QFETCH(double, viscosity);
        QFETCH(double, meanFreePath);
        const Air air = airAt(altitude, temperature);
        QVERIFY2(std::abs(air.pressure / pressure - 1.0) < 2e-4, qPrintable(QString::number(air.pressure)));
        QVERIFY2(std::abs(air.viscosity / viscosity - 1.0) < 1e-4, qPrintable(QString::number(air.viscosity)));
        QVERIFY2(std::abs(air.meanFreePath / meanFreePath - 1.0) < 2e-4, qPrintable(QString::number(air.meanFreePath)));
    }

    /// The standard pressure at sea level, and in the air of the same temperature above 11 km, where the U.S. Standard
    /// Atmosphere of 1976 has 12045 Pa at 15 km and 5474.9 Pa at 20 km.
    void pressureLaw()
    {
        QCOMPARE(airAt(0.0, 250.0).pressure, 101325.0);
        QVERIFY(std::abs(airAt(15000.0, 250.0).pressure / 12045.0 - 1.0) < 3e-4);
        QVERIFY(std::abs(airAt(20000.0, 250.0).pressure / 5474.9 - 1.0) < 3e-4);
        QVERIFY(std::abs(airAt(11000.0 + 1e-6, 250.0).pressure / airAt(11000.0, 250.0).pressure - 1.0) < 1e-9);
    }

    /// What the established program calls standard air is this atmosphere at sea level and 25 C, in the digits that it
    /// gives.
    void establishedStandardAirIsThatOf25C()
    {
        const Air air = airAt(0.0, 298.15);
        QCOMPARE(air.pressure, establishedStandardAir.pressure);
        QVERIFY(std::abs(air.viscosity - establishedStandardAir.viscosity) < 0.00005e-5);
        QVERIFY(std::abs(air.meanFreePath - establishedStandardAir.meanFreePath) < 0.05e-9);
    }
};

TOUCHDOWN_TEST(TestAir)

} // namespace test_air

#include "test_air.moc"

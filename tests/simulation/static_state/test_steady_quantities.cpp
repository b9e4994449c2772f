// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/static_state/steady_quantities.h"

#include "core/formats/units.h"
#include "tests/support/sample_steady.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <set>

using namespace touchdown;

namespace test_steady_quantities {

class TestSteadyQuantities : public QObject {
    Q_OBJECT

private slots:
    /// The sample's numbers are all different, so that none can stand in another's place.
    void eachNumberHasItsName()
    {
        const QMap<QString, double> expected{{"nominal_trailing_edge_height", 12e-9},
                                             {"pitch", 150e-6},
                                             {"roll", -3e-6},
                                             {"minimum_spacing", 9.5e-9},
                                             {"net_force", 14.7e-3},
                                             {"positive_force", 20e-3},
                                             {"negative_force", -5.3e-3},
                                             {"pitch_torque", 1e-7},
                                             {"roll_torque", 2e-8},
                                             {"shear_force_x", 3e-4},
                                             {"shear_force_y", -4e-5},
                                             {"shear_pitch_torque", -5e-8},
                                             {"shear_roll_torque", 6e-9},
                                             {"maximum_pressure", 9e5},
                                             {"minimum_pressure", 4e4},
                                             {"mass_flow", 1.5e-9},
                                             {"minimum_spacing_error", 1e-11},
                                             {"pitch_error", 1e-8},
                                             {"roll_error", 2e-8},
                                             {"load_error", 1e-5},
                                             {"contact_force", 1e-3},
                                             {"intermolecular_force", -2e-3},
                                             {"friction_force", 3e-4},
                                             {"contact_pitch_torque", 4e-8},
                                             {"contact_roll_torque", 5e-9},
                                             {"contact_area", 6e-12},
                                             {"peak_contact_pressure", 7e8},
                                             {"unresolved_ridges", 7.0}};
        QMap<QString, double> told;
        for (const auto& [quantity, value] : steadyQuantities(test::sampleSteady()))
            told[QString::fromStdString(quantity.name)] = value;
        QCOMPARE(told, expected);
    }
    void displayUnitsMeasureTheSame()
    {
        for (const auto& numbers :
             {steadyQuantities(test::sampleSteady()), seriesQuantities({0.02, 0.1, 500.0, 1000.0})})
            for (const auto& [quantity, value] : numbers)
                QVERIFY2(quantity.unit == "1" ||
                             std::holds_alternative<double>(parseQuantity("1 " + quantity.displayUnit, quantity.unit)),
                         quantity.name.c_str());
    }
    void aSeriesIsSetApart()
    {
        const auto names = [](const SteadySeriesPoint& point) {
            QStringList list;
            for (const auto& [quantity, value] : seriesQuantities(point))
                list << QString("%1=%2").arg(quantity.name.c_str()).arg(value);
            return list;
        };
        QCOMPARE(names({0.02, 0.1, 500.0, {}}), (QStringList{"radius=0.02", "skew=0.1", "speed=500"}));
        QCOMPARE(names({0.02, 0.1, 500.0, 0.0}), (QStringList{"radius=0.02", "skew=0.1", "speed=500", "altitude=0"}));
    }
};

TOUCHDOWN_TEST(TestSteadyQuantities)

} // namespace test_steady_quantities

#include "test_steady_quantities.moc"

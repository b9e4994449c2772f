// SPDX-License-Identifier: GPL-3.0-or-later
//
// The laws without surfaces; those with them: test_elastic_pad.cpp.
#include "core/simulation/contact/contact_model.h"

#include <algorithm>
#include <cmath>

#include <QTest>

#include "core/case/contact_kind.h"
#include "core/case/contact_law.h"
#include "core/case/parameters.h"
#include "core/physics/contact/adhesion_kind.h"
#include "core/physics/contact/asperity_contact.h"
#include "core/physics/contact/multi_asperity.h"
#include "core/simulation/contact/contact_lever.h"
#include "tests/support/sample_case.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_contact_model {

Case contactCase(ContactKind kind)
{
    Case c = defaultsOf(ModelKind::Contact);
    c.contact = kind;
    c.approach = {6e-9, 1e-9};
    return c;
}

class TestContactModel : public QObject {
    Q_OBJECT

private slots:
    void valuesFitTheirQuantities_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<int>("count");
        QTest::newRow("ono-yamane") << int(ContactKind::OnoYamane) << 6;
        QTest::newRow("elastic") << int(ContactKind::Elastic) << 8;
        QTest::newRow("asperity") << int(ContactKind::Asperity) << 6;
        QTest::newRow("multi-asperity") << int(ContactKind::MultiAsperity) << 9;
    }
    void valuesFitTheirQuantities()
    {
        QFETCH(int, kind);
        QFETCH(int, count);
        Case c = contactCase(static_cast<ContactKind>(kind));
        const std::vector<Quantity> quantities = contactQuantities(c);
        QCOMPARE(quantities.size(), static_cast<std::size_t>(count));
        ContactForces forces;
        forces.separation = 1.0;
        forces.contact = 2.0;
        forces.adhesion = -0.5;
        c.disk.skew = 0.5;
        QCOMPARE(c.disk.field, VelocityField::Rotating); // elsewhere the disk moves at another angle
        c.slider.thickness = 0.2;
        const double mu = frictionOf(c).coefficient;
        QVERIFY(mu > 0.0);
        std::vector<double> values(quantities.size() + 1, NAN);
        contactValues(c, contactRows(c), forces, values.data());
        const auto at = [&](const char* name) {
            return values[static_cast<std::size_t>(findQuantity(quantities, name))];
        };
        QCOMPARE(at("minimum_spacing"), 1.0);
        QCOMPARE(at("contact_force"), 2.0);
        QCOMPARE(at("net_contact_force"), 1.5);
        // mu N against the disk's speed of metres a second, half the thickness below the mass centre, its part along
        // the slider.
        QCOMPARE(at("friction_force"), 2.0 * mu);
        QVERIFY(std::abs(at("friction_torque") + 0.1 * 2.0 * mu * std::cos(0.5)) < 1e-12);
        QVERIFY(!std::isnan(values[quantities.size() - 1]));
        QVERIFY(std::isnan(values.back()));
        const bool adhered = contactLaw(c).adheres(c);
        c.adhesion.kind = AdhesionKind::LennardJones;
        QCOMPARE(contactQuantities(c).size(), quantities.size() + (contactLaw(c).adheres(c) && !adhered ? 1 : 0));
    }

    /// Between d_s = 3 nm and d_e = 5 nm the way decides.
    void characteristicRemembers()
    {
        const auto model = makeContactModel(contactCase(ContactKind::OnoYamane));
        const auto passed = [&](double separation) {
            model->move(separation, 0.0);
            return model->way().switches;
        };
        QCOMPARE(model->move(4e-9, 0.0).net(), 0.0);
        QVERIFY(model->way().switches.empty());
        QVERIFY(passed(3.5e-9).empty());
        const std::vector<ContactSwitch> in = passed(2e-9);
        QCOMPARE(in.size(), std::size_t{1});
        QCOMPARE(in.front().name, std::string("touch-down"));
        QCOMPARE(in.front().separation, 3e-9);
        QVERIFY(passed(1e-9).empty());
        QVERIFY(std::abs(model->move(4.5e-9, 0.0).net() + 10.7e-3) < 1e-15);
        const std::vector<ContactSwitch> out = passed(5.5e-9);
        QCOMPARE(out.size(), std::size_t{1});
        QCOMPARE(out.front().name, std::string("take-off"));
        QCOMPARE(out.front().separation, 5e-9);
        QCOMPARE(model->move(5.5e-9, 0.0).net(), 0.0);
        QVERIFY(passed(4e-9).empty());
    }
    /// On straight lines the strongest pull is at the end of one: here where F_cr has fallen to zero, or at d_s.
    void pullsOfTheCharacteristic()
    {
        Case c = contactCase(ContactKind::OnoYamane);
        const auto strongest = [&](std::initializer_list<double> stops) {
            const auto model = makeContactModel(c);
            model->move(1e-9, 0.0);
            PullPoint found{0.0, 0.0};
            for (const double stop : stops) {
                model->move(stop, 0.0);
                for (const PullPoint& pull : model->way().pulls)
                    if (pull.force < found.force) found = pull;
            }
            return found;
        };
        for (const auto& stops : {std::initializer_list<double>{8e-9}, {3.2e-9, 4.4e-9, 8e-9}}) {
            c.onoYamane.takeOffShape = TakeOffShape::Constant;
            QVERIFY(std::abs(strongest(stops).force + 10.7e-3) < 1e-15);
            QVERIFY(strongest(stops).separation >= 4e-9 * (1.0 - 1e-12)); // d_s + f_c0/k_c
            // Contact and menisci fall together to zero at d_e: f_c0 - f_m at d_s is the most.
            c.onoYamane.takeOffShape = TakeOffShape::BothLinear;
            QVERIFY(std::abs(strongest(stops).force + 5.7e-3) < 1e-15);
            QCOMPARE(strongest(stops).separation, 3e-9);
        }
    }
    /// The pad's area times the law's pressure.
    void asperities()
    {
        Case c = contactCase(ContactKind::Asperity);
        c.pad.length = 10e-6;
        c.pad.width = 30e-6;
        const auto model = makeContactModel(c);
        const AsperityContact law(c.asperity, c.elastic.pair);
        const ContactForces& forces = model->move(2e-9, 0.0);
        QVERIFY(forces.contact > 0.0);
        QCOMPARE(forces.contact, 300e-12 * law.pressure(2e-9));
        QCOMPARE(forces.area, 300e-12 * law.contactArea(2e-9));
        QVERIFY(!model->canJump());
    }
    /// A pad that stays far away meets none of the stronger attraction nearer to the disk: its strongest pull is that
    /// at the closest approach.
    void pullsOfAsperitiesAreThoseOfTheWay()
    {
        Case c = contactCase(ContactKind::Asperity);
        c.adhesion.kind = AdhesionKind::LennardJones;
        c.approach = {8e-9, 5e-9};
        const auto model = makeContactModel(c);
        model->move(8e-9, 0.0);
        QVERIFY(model->way().pulls.empty());
        const double closest = model->move(5e-9, 0.0).net();
        QVERIFY(closest < 0.0);
        QVERIFY(model->way().pulls.empty());
        model->move(8e-9, 0.0);
        const PullPoint strongest = *std::ranges::min_element(model->way().pulls, {}, &PullPoint::force);
        QCOMPARE(strongest.separation, 5e-9);
        QCOMPARE(strongest.force, closest);
    }
    void multiAsperity()
    {
        Case c = contactCase(ContactKind::MultiAsperity);
        c.pad.length = c.pad.width = 62e-6;
        const auto model = makeContactModel(c);
        QVERIFY(model->fit() && model->fit()->describes);
        QCOMPARE(model->move(6e-9, 0.0).net(), 0.0);
        model->move(1e-9, 0.0);
        const std::vector<ContactSwitch> in = model->way().switches;
        QVERIFY(!in.empty());
        QCOMPARE(in.front().name, std::string("touch-down"));
        QCOMPARE(model->move(6e-9, 0.0).adhesion, 0.0);
        const std::vector<ContactSwitch> out = model->way().switches;
        QVERIFY(!out.empty());
        QCOMPARE(out.front().name, std::string("take-off"));
        QVERIFY(out.front().separation > in.front().separation);
        // Short of the jump nothing has switched, beyond it menisci pull.
        model->move(in.front().separation + 1e-12, 0.0);
        QVERIFY(model->way().switches.empty());
        QVERIFY(model->move(in.front().separation - 1e-12, 0.0).adhesion < -1e-3);
        QCOMPARE(model->way().switches.size(), std::size_t{1});
    }
    void lawsWithoutSurfacesHaveNoMaps()
    {
        for (const ContactKind kind : {ContactKind::OnoYamane, ContactKind::Asperity, ContactKind::MultiAsperity})
            QVERIFY(contactMaps(contactCase(kind)).empty());
        QVERIFY(!contactMaps(contactCase(ContactKind::Elastic)).empty());
    }

    /// Many asperities with menisci: the way out in 10,001 points, with the two ends of each jump, has a strongest
    /// pull. One move out finds the same, and so do three; on the way in there is none.
    void pullsOfManyAsperities()
    {
        Case c = sample("contact_ono_yamane_full");
        for (const double deviation : {0.2e-9, 1e-9}) {
            c.asperity.heightDeviation = deviation;
            const MultiAsperity law(c.asperity, c.meniscus, c.elastic.pair, c.pad.length * c.pad.width);
            double strongest = 0.0; // [N]
            for (const MultiAsperityPoint& point : multiAsperityCurve(law, 6e-9, 1e-9, 10001).away)
                strongest = std::min(strongest, point.forces.total());
            QVERIFY(strongest < -1e-3);
            for (const std::vector<double>& stops : {std::vector{6e-9}, std::vector{2.71e-9, 3.14e-9, 6e-9}}) {
                const auto model = makeContactModel(c);
                model->move(1e-9, 0.0);
                QVERIFY(model->way().pulls.empty());
                double found = 0.0;
                for (const double stop : stops) {
                    model->move(stop, 0.0);
                    for (const PullPoint& pull : model->way().pulls) found = std::min(found, pull.force);
                }
                QVERIFY2(std::abs(found / strongest - 1.0) < 1e-6,
                         qPrintable(QString::number(found / strongest, 'g', 12)));
            }
        }
    }
};

TOUCHDOWN_TEST(TestContactModel)

} // namespace test_contact_model

#include "test_contact_model.moc"

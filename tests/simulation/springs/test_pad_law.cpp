// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/springs/pad_law.h"

#include <cmath>
#include <random>

#include <QTest>

#include "core/case/contact_kind.h"
#include "core/case/contact_law.h"
#include "core/numerics/gauss_legendre.h"
#include "core/physics/contact/adhesion_kind.h"
#include "core/physics/contact/separation_law.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_pad_law {

/// A linear spring of 1e6 N/m that catches the pad at 3 nm and pulls it until it breaks at 5 nm: k (4 nm - d).
class Catch final : public SeparationLaw {
public:
    bool acts() const override { return caught_; }
    SeparationForces at(double d) const override
    {
        if (!caught_) return {};
        const AffineForce force{stiffness * length, -stiffness};
        const AffineForce none{};
        return {.contact = d < length ? force : none, .adhesion = d < length ? none : force};
    }
    Interval interval() const override { return caught_ ? Interval{.upper = 5e-9} : Interval{.lower = 3e-9}; }
    std::string cross(bool) override
    {
        caught_ = !caught_;
        return caught_ ? "touch-down" : "take-off";
    }
    void begin(ContactBranch branch, double d) override
    {
        caught_ = d <= 3e-9 || (branch == ContactBranch::TakeOff && d < 5e-9);
    }
    bool outOfReach(double d) const override { return !caught_ && d > 5e-9; }
    double reach() const override { return 5e-9; }

    static constexpr double stiffness = 1e6, length = 4e-9; // [N/m], [m]

private:
    bool caught_ = false;
};

class TestPadLaw : public QObject {
    Q_OBJECT

private slots:
    /// A law of the separation that the springs do not know by name.
    void anyLawOfTheSeparationActs()
    {
        const auto law = makePadLaw(std::make_unique<Catch>(), std::make_unique<Catch>());
        using enum ContactRegion;
        using enum ContactBranch;
        QCOMPARE(law->region(TouchDown, 4e-9), Apart);
        QCOMPARE(law->region(TouchDown, 2e-9), Pressed);
        QCOMPARE(law->region(TakeOff, 4e-9), Pressed);
        QCOMPARE(law->region(TakeOff, 6e-9), Apart);
        QCOMPARE(law->nextBranch(TakeOff, 4e-9), TakeOff);
        QCOMPARE(law->nextBranch(TakeOff, 6e-9), TouchDown);
        QCOMPARE(law->beyond(Apart, false), Pressed);
        QCOMPARE(law->beyond(Pressed, true), Apart);
        QCOMPARE(law->interval(Apart).lower, 3e-9);
        QCOMPARE(law->interval(Pressed).upper, 5e-9);
        QCOMPARE(law->at(Apart, 3.5e-9).net(), 0.0);
        QCOMPARE(law->at(Pressed, 1e-9).contact, 3e-3); // 1e6 N/m 3 nm
        QCOMPARE(law->at(Pressed, 1e-9).slope(), -1e6);
        QCOMPARE(law->at(Pressed, 5e-9).adhesion, -1e-3);
        QCOMPARE(law->work(Pressed, 1e-9, 3e-9), 4e-12); // mean 2 mN over 2 nm
    }

    /// Where F_cr ends beyond d_e, the five parameters are such a law of two branches: the same by either way.
    void characteristicIsALawOfTheSeparation()
    {
        Case c;
        c.onoYamane.initialContactForce = 20e-3; // ends 4 nm above d_s
        const auto own = makePadLaw(c), other = makePadLaw(std::make_unique<CharacteristicLaw>(c.onoYamane),
                                                           std::make_unique<CharacteristicLaw>(c.onoYamane));
        std::mt19937 random(3);
        std::uniform_real_distribution<double> separation(-2e-9, 8e-9);
        for (int i = 0; i < 100; ++i) {
            const double d = separation(random), from = std::min(d, c.onoYamane.touchDown);
            for (const ContactBranch branch : {ContactBranch::TouchDown, ContactBranch::TakeOff}) {
                const ContactRegion region = own->region(branch, d), same = other->region(branch, d);
                QCOMPARE(same == ContactRegion::Apart, region == ContactRegion::Apart);
                QCOMPARE(other->nextBranch(branch, d), own->nextBranch(branch, d));
                QCOMPARE(other->at(same, d).contact, own->at(region, d).contact);
                QCOMPARE(other->at(same, d).adhesion, own->at(region, d).adhesion);
                QCOMPARE(other->at(same, d).slope(), own->at(region, d).slope());
            }
            using enum ContactRegion;
            QVERIFY(std::abs(other->work(Pressed, from, 0.0) - own->work(Pressed, from, 0.0)) < 1e-24);
        }
    }

    /// Its work is the integral of its force, over the summits and the attraction.
    void workOfAPressureIsTheIntegralOfItsForce()
    {
        Case c;
        c.contact = ContactKind::Asperity;
        c.asperity = {
            .radius = 2e-6, .density = 5e12, .heightDeviation = 0.5e-9, .planeHeight = 7.5e-9, .friction = 0.4};
        c.adhesion.kind = AdhesionKind::LennardJones;
        const auto law = makePadLaw(c);
        double integral = 0.0;
        constexpr int parts = 200;
        for (int i = 0; i < parts; ++i)
            GaussLegendre<5>().sample(6e-9 + 4e-9 * i / parts, 6e-9 + 4e-9 * (i + 1) / parts,
                                      [&](double d, double weight) { integral += weight * law->forces({}, d).net(); });
        const double work = law->work({}, 6e-9, 10e-9);
        QVERIFY2(std::abs(work - integral) < 1e-6 * std::abs(work),
                 qPrintable(QString("%1 %2").arg(work).arg(integral)));
    }

    void everyLawThatActsUnderSpringsPushes()
    {
        for (std::size_t i = 0; i < contactLaws().size(); ++i) {
            Case c;
            c.contact = static_cast<ContactKind>(i);
            const auto law = makePadLaw(c);
            const bool acts = c.contact != noContact && contactLaw(c).whyNot(ModelKind::Springs).empty();
            const double pressed = law->at(law->region(ContactBranch::TakeOff, 0.0), 0.0).contact;
            QVERIFY2((pressed > 0.0) == acts, contactLaw(c).name.data());
            QCOMPARE(law->stiffness() > 0.0, acts);
        }
    }
};

TOUCHDOWN_TEST(TestPadLaw)

} // namespace test_pad_law

#include "test_pad_law.moc"

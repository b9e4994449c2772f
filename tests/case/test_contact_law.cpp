// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/contact_law.h"

#include <set>

#include <QTest>

#include "core/case/contact_kind.h"
#include "core/case/parameters.h"
#include "core/physics/contact/adhesion_kind.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_contact_law {

constexpr std::array models{ModelKind::Springs, ModelKind::Film, ModelKind::Contact};

class TestContactLaw : public QObject {
    Q_OBJECT

private slots:
    void everyRowIsWhole()
    {
        std::set<std::string_view> names, labels;
        for (const ContactLaw& law : contactLaws()) {
            const std::string name(law.name);
            QVERIFY2(names.insert(law.name).second && labels.insert(law.label).second, name.c_str());
            QVERIFY2(law.meaning.ends_with('.'), name.c_str());
            QVERIFY2(law.friction && law.adheres && law.reach, name.c_str());
            // A law that acts nowhere could not be chosen.
            QVERIFY2(std::ranges::any_of(models, [&](ModelKind model) { return law.whyNot(model).empty(); }),
                     name.c_str());
        }
    }
    void theKeyTakesTheLawsInTheirOrder()
    {
        const Parameter& contact = *findParameter("contact");
        QCOMPARE(contact.choices.size(), contactLaws().size());
        for (std::size_t i = 0; i < contactLaws().size(); ++i) {
            const ContactLaw& law = contactLaws()[i];
            QCOMPARE(&contactLaw(static_cast<ContactKind>(i)), &law);
            QCOMPARE(contact.choices[i], std::string(law.name));
            QVERIFY(contact.help.find(law.meaning) != std::string::npos);
        }
    }
    /// A case is refused at "contact" exactly where its law says why it cannot act, and told a law that can.
    void refusesWhatCannotAct()
    {
        for (const ModelKind model : models)
            for (std::size_t i = 0; i < contactLaws().size(); ++i) {
                Case c = defaultsOf(model);
                c.contact = static_cast<ContactKind>(i);
                const std::string why(contactLaw(c).whyNot(model));
                const auto problems = checkCombinations(c);
                const auto found = std::ranges::find(problems, "contact", &CaseProblem::key);
                QCOMPARE(found != problems.end(), !why.empty());
                QCOMPARE(contactRefusal(c).has_value(), !why.empty());
                if (!why.empty()) QVERIFY2(found->message.find(why) != std::string::npos, found->message.c_str());
            }
    }
    /// Only under their own law are there five parameters.
    void onlyOneLawHasACharacteristic()
    {
        for (std::size_t i = 0; i < contactLaws().size(); ++i) {
            Case c;
            c.contact = static_cast<ContactKind>(i);
            c.onoYamane.takeOff = 6e-9;
            const auto law = characteristic(c);
            QCOMPARE(law.has_value(), c.contact == ContactKind::OnoYamane);
            if (law) QCOMPARE(law->takeOff, 6e-9);
        }
    }
    /// People know the laws of one summit by their own names. They are read, and written as "asperity" and its model.
    void lawsOfOneSummitAreReadByTheirNames()
    {
        const Parameter &contact = *findParameter("contact"), &model = *findParameter("asperity.model");
        for (const std::string& name : model.choices) {
            Case c;
            c.contact = noContact;
            QCOMPARE(setFromText(c, contact, name).value_or(""), std::string());
            QVERIFY(c.contact == ContactKind::Asperity);
            QCOMPARE(toText(c, contact), std::string("asperity"));
            QCOMPARE(toText(c, model), name);
            QVERIFY(contact.help.find(name) != std::string::npos);
        }
        Case c;
        QVERIFY(setFromText(c, contact, "greenwood").has_value());
        QVERIFY(c == Case());
    }
    void frictionIsThatOfTheLaw()
    {
        Case c;
        c.onoYamane.friction = 0.1, c.elastic.friction = 0.2, c.asperity.friction = 0.4;
        const auto friction = [&](ContactKind kind) { return contactLaw(kind).friction(c); };
        QCOMPARE(friction(ContactKind::None), 0.0);
        QCOMPARE(friction(ContactKind::OnoYamane), 0.1);
        QCOMPARE(friction(ContactKind::Elastic), 0.2);
        QCOMPARE(friction(ContactKind::Asperity), 0.4);
        QCOMPARE(friction(ContactKind::MultiAsperity), 0.4);
    }
    void actsUpToItsReach()
    {
        Case c;
        c.onoYamane.takeOff = 6e-9;
        c.asperity.planeHeight = 2e-9, c.asperity.heightDeviation = 0.25e-9, c.meniscus.breakingLength = 1.5e-9;
        const auto reach = [&](ContactKind kind) { return contactLaw(kind).reach(c); };
        QCOMPARE(reach(ContactKind::OnoYamane), 6e-9);
        QCOMPARE(reach(ContactKind::Asperity), 3e-9); // four deviations above the plane
        QCOMPARE(reach(ContactKind::MultiAsperity), 4.5e-9);
        QCOMPARE(reach(ContactKind::None), 0.0);
    }
    void elasticSurfacesPullWithAdhesionOnly()
    {
        Case c;
        c.contact = ContactKind::Elastic;
        QVERIFY(!contactLaw(c).adheres(c));
        c.adhesion.kind = AdhesionKind::LennardJones;
        QVERIFY(contactLaw(c).adheres(c));
    }
};

TOUCHDOWN_TEST(TestContactLaw)

} // namespace test_contact_law

#include "test_contact_law.moc"

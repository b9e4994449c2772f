// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/fields.h"

#include "core/simulation/units.h"

#include <QTest>

#include <set>

using namespace touchdown;

namespace {

void addFieldRows()
{
    QTest::addColumn<QString>("key");
    for (const Field& field : fields()) QTest::newRow(field.key.c_str()) << QString::fromStdString(field.key);
}

/// A value other than the default; nothing where there is none.
std::optional<FieldValue> another(const Field& field, const Case& c)
{
    const FieldValue old = field.get(c);
    switch (field.kind) {
    case FieldKind::Number: return std::get<double>(old) == 0.5 ? 0.25 : 0.5;
    case FieldKind::Boolean: return !std::get<bool>(old);
    case FieldKind::Text: return std::string("other");
    case FieldKind::Choice:
        for (const std::string& name : field.choices)
            if (FieldValue(name) != old) return name;
        break;
    case FieldKind::Integer: break;
    }
    return {};
}

} // namespace

class TestFields : public QObject {
    Q_OBJECT

private slots:
    void isDescribed_data() { addFieldRows(); }
    void isDescribed()
    {
        QFETCH(QString, key);
        const Field& field = *findField(key.toStdString());
        QVERIFY(!field.label.empty());
        QVERIFY(field.help.ends_with('.'));
        if (field.kind == FieldKind::Number) {
            QVERIFY(!field.source.empty());
            QCOMPARE(field.unit.empty(), field.displayUnit.empty());
            // The display unit measures what the SI unit does, and the SI unit is one.
            QVERIFY(std::holds_alternative<double>(
                parseQuantity("1 " + (field.unit.empty() ? "%" : field.displayUnit), field.unit)));
            QVERIFY(unitFactor(field.unit) == 1.0);
        }
        if (field.kind == FieldKind::Choice) QVERIFY(!field.choices.empty());
    }

    void defaultIsAllowed_data() { addFieldRows(); }
    void defaultIsAllowed()
    {
        QFETCH(QString, key);
        const Field& field = *findField(key.toStdString());
        Case c;
        QCOMPARE(setFromText(c, field, toText(c, field)).value_or(""), std::string());
        QVERIFY(field.get(c) == field.get(Case{}));
    }

    void setReachesOneMemberAlone_data() { addFieldRows(); }
    void setReachesOneMemberAlone()
    {
        QFETCH(QString, key);
        const Field& field = *findField(key.toStdString());
        Case c;
        const auto value = another(field, c);
        if (!value) return; // one choice alone
        field.set(c, *value);
        for (const Field& other : fields()) QCOMPARE(other.get(c) == other.get(Case{}), other.key != field.key);
        QVERIFY(field.get(c) == *value);
    }

    void keysAreUnique()
    {
        std::set<std::string> keys;
        for (const Field& field : fields()) QVERIFY2(keys.insert(field.key).second, field.key.c_str());
    }
    /// A case file writes each table once.
    void groupsAreContiguous()
    {
        std::set<std::string> done;
        std::string group;
        for (const Field& field : fields()) {
            if (field.group() == group) continue;
            group = field.group();
            QVERIFY2(done.insert(group).second, group.c_str());
        }
        QCOMPARE(done, (std::set<std::string>{"about", "slider", "springs", "suspension", "ono_yamane", "initial",
                                              "run", "spectrum"}));
    }
    void choicesFollowTheEnumerators()
    {
        Case c;
        findField("run.integrator")->set(c, std::string("rk4-events"));
        QCOMPARE(c.run.integrator, IntegratorKind::Rk4Events);
        findField("run.integrator")->set(c, std::string("cvode"));
        QCOMPARE(c.run.integrator, IntegratorKind::Cvode);
        findField("spectrum.window")->set(c, std::string("flat-top"));
        QCOMPARE(c.spectrum.window, SpectrumWindow::FlatTop);
        findField("springs.potential")->set(c, std::string("as-printed"));
        QCOMPARE(c.springs.potential, PotentialBelowCutoff::AsPrinted);
        findField("initial.branch")->set(c, std::string("take-off"));
        QCOMPARE(c.initial.branch, ContactBranch::TakeOff);
        findField("contact")->set(c, std::string("none"));
        QCOMPARE(c.contact, ContactKind::None);
    }

    void used_data()
    {
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("choice"); // key=value
        QTest::addColumn<bool>("used");
        QTest::newRow("friction without contact") << "ono_yamane.friction"
                                                  << "contact=none" << false;
        QTest::newRow("friction with contact") << "ono_yamane.friction"
                                               << "contact=ono-yamane" << true;
        QTest::newRow("branch without contact") << "initial.branch"
                                                << "contact=none" << false;
        QTest::newRow("thickness without contact") << "slider.thickness"
                                                   << "contact=none" << false;
        QTest::newRow("pad distance without contact, where FH is measured") << "ono_yamane.pad_distance"
                                                                            << "contact=none" << true;
        QTest::newRow("step of dopri5") << "run.step"
                                        << "run.integrator=dopri5" << false;
        QTest::newRow("step of cvode") << "run.step"
                                       << "run.integrator=cvode" << false;
        QTest::newRow("step of rk4-events") << "run.step"
                                            << "run.integrator=rk4-events" << true;
        QTest::newRow("tolerance of rk4") << "run.tolerance"
                                          << "run.integrator=rk4" << false;
        QTest::newRow("tolerance of cvode") << "run.tolerance"
                                            << "run.integrator=cvode" << true;
        QTest::newRow("step check of newmark") << "run.step_check"
                                               << "run.integrator=newmark" << true;
        QTest::newRow("step check of dopri5") << "run.step_check"
                                              << "run.integrator=dopri5" << false;
        QTest::newRow("beta of newmark") << "run.newmark_beta"
                                         << "run.integrator=newmark" << true;
        QTest::newRow("beta of rk4") << "run.newmark_beta"
                                     << "run.integrator=rk4" << false;
    }
    void used()
    {
        QFETCH(QString, key);
        QFETCH(QString, choice);
        QFETCH(bool, used);
        Case c;
        findField(choice.section('=', 0, 0).toStdString())->set(c, choice.section('=', 1).toStdString());
        QCOMPARE(findField(key.toStdString())->used(c), used);
    }

    void nearest_data()
    {
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("nearest");
        QTest::newRow("a slip") << "springs.cutof"
                                << "springs.cutoff";
        QTest::newRow("a slip in the table") << "spring.cutoff"
                                             << "springs.cutoff";
        QTest::newRow("the wrong table") << "slider.friction"
                                         << "ono_yamane.friction";
        QTest::newRow("no table") << "friction"
                                  << "ono_yamane.friction";
        QTest::newRow("nothing like it") << "film.nodes"
                                         << "";
        QTest::newRow("empty") << ""
                               << "";
    }
    void nearest()
    {
        QFETCH(QString, key);
        QFETCH(QString, nearest);
        QCOMPARE(QString::fromStdString(nearestKey(key.toStdString())), nearest);
    }
    void unknownKeysAreNotFound() { QVERIFY(findField("springs.cutof") == nullptr); }
};

QTEST_GUILESS_MAIN(TestFields)
#include "test_fields.moc"

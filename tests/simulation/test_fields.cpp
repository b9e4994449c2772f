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
    case FieldKind::Integer: return static_cast<int>(field.maximum);
    case FieldKind::List:
        return std::vector<double>(std::max<std::size_t>(field.minimumCount, 1), field.stride > 0 ? field.maximum : 0.25);
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
        if (field.kind == FieldKind::Number || field.kind == FieldKind::List) {
            QVERIFY(!field.source.empty());
            QCOMPARE(field.unit.empty(), field.displayUnit.empty());
            // The display unit measures what the SI unit does, and the SI unit is one.
            QVERIFY(std::holds_alternative<double>(
                parseQuantity("1 " + (field.unit.empty() ? "%" : field.displayUnit), field.unit)));
            QVERIFY(unitFactor(field.unit) == 1.0);
        }
        if (field.kind == FieldKind::Choice) QVERIFY(!field.choices.empty());
        if (field.kind == FieldKind::List) QVERIFY(field.maximumCount > 0 && field.maximumCount >= field.minimumCount);
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
        QVERIFY(value.has_value());
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
        QCOMPARE(done, (std::set<std::string>{"about", "slider", "springs", "suspension", "ono_yamane", "abs", "air",
                                              "disk", "film", "steady", "initial", "run", "spectrum"}));
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
        findField("model")->set(c, std::string("film"));
        QCOMPARE(c.model, ModelKind::Film);
        findField("air.source")->set(c, std::string("established-standard"));
        QCOMPARE(c.air.source, AirSource::EstablishedStandard);
        for (const auto& [name, model] :
             {std::pair{"continuum", SlipModel::Continuum}, std::pair{"first-order", SlipModel::FirstOrder},
              std::pair{"second-order", SlipModel::SecondOrder}, std::pair{"1.5-order", SlipModel::OnePointFiveOrder},
              std::pair{"fukui-kaneko", SlipModel::FukuiKaneko}, std::pair{"fukui-kaneko-fit", SlipModel::FukuiKanekoFit},
              std::pair{"new-first-order", SlipModel::NewFirstOrder},
              std::pair{"new-second-order", SlipModel::NewSecondOrder}, std::pair{"combination", SlipModel::Combination}}) {
            findField("air.slip")->set(c, std::string(name));
            QCOMPARE(c.air.slip.model, model);
        }
        findField("disk.velocity_field")->set(c, std::string("uniform"));
        QCOMPARE(c.disk.field, VelocityField::Uniform);
        findField("film.grid")->set(c, std::string("graded"));
        QCOMPARE(c.film.grid, GridKind::Graded);
        for (const auto& [name, scheme] :
             {std::pair{"upwind", ConvectionScheme::Upwind}, std::pair{"hybrid", ConvectionScheme::Hybrid},
              std::pair{"power-law", ConvectionScheme::PowerLaw}, std::pair{"exponential", ConvectionScheme::Exponential},
              std::pair{"complete-flux", ConvectionScheme::CompleteFlux}}) {
            findField("film.scheme")->set(c, std::string(name));
            QCOMPARE(c.film.scheme, scheme);
        }
        findField("film.solver")->set(c, std::string("line-multigrid"));
        QCOMPARE(c.film.solver, FilmSolver::LineMultigrid);
    }
    /// What a case has where nobody says otherwise.
    void defaultsOfTheModels()
    {
        QCOMPARE(defaultsOf(ModelKind::Springs).contact, ContactKind::OnoYamane);
        QCOMPARE(defaultsOf(ModelKind::Springs).degreesOfFreedom, 2);
        QCOMPARE(defaultsOf(ModelKind::Film).contact, ContactKind::None);
        QCOMPARE(defaultsOf(ModelKind::Film).degreesOfFreedom, 3);
        QVERIFY(checkCombinations(defaultsOf(ModelKind::Film)).empty());
        for (const Field& field : fields()) {
            const bool differs = field.get(defaultsOf(ModelKind::Film)) != field.get(Case{});
            QCOMPARE(differs, field.key == "model" || field.key == "contact" || field.key == "degrees_of_freedom");
        }
    }
    void listsFillArraysAndVectors()
    {
        Case c;
        findField("film.nodes")->set(c, std::vector<double>{33, 65});
        QCOMPARE(c.film.nodes, (std::array<int, 2>{33, 65}));
        findField("steady.radii")->set(c, std::vector<double>{0.02, 0.03, 0.04});
        QCOMPARE(c.steady.radii, (std::vector<double>{0.02, 0.03, 0.04}));
        findField("steady.radii")->set(c, std::vector<double>{});
        QVERIFY(c.steady.radii.empty());
    }

    void used_data()
    {
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("choice"); // key=value, and more behind blanks
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
        const auto ofFilm = [](const char* name, const char* key, const char* choice, bool used) {
            QTest::newRow(name) << key << (QString("model=film contact=none degrees_of_freedom=3 ") + choice).trimmed()
                                << used;
        };
        ofFilm("springs of a film case", "springs.cutoff", "", false);
        ofFilm("damping ratio of a film case", "suspension.damping_ratio", "", false);
        ofFilm("flying height of a film case", "initial.flying_height", "", false);
        ofFilm("pad distance of a film case", "ono_yamane.pad_distance", "", false);
        ofFilm("step of a film case", "run.step", "run.integrator=rk4", false);
        ofFilm("duration of a film case", "run.duration", "", false);
        ofFilm("spectrum of a film case", "spectrum.window", "", false);
        ofFilm("pitch of a film case", "initial.pitch", "", true);
        ofFilm("thickness of a film case", "slider.thickness", "", true);
        ofFilm("stiffness of a film case", "suspension.stiffness", "", true);
        ofFilm("roll stiffness with three degrees of freedom", "suspension.roll_stiffness", "", true);
        ofFilm("roll stiffness with roll held", "suspension.roll_stiffness", "degrees_of_freedom=2", false);
        ofFilm("torque of a suspension", "suspension.pitch_torque", "", true);
        ofFilm("torque of a suspension that holds an attitude", "suspension.pitch_torque",
               "suspension.holds_attitude=true", false);
        ofFilm("attitude of a suspension that holds one", "suspension.static_pitch", "suspension.holds_attitude=true",
               true);
        ofFilm("static attitude of torques", "suspension.static_pitch", "", false);
        ofFilm("static roll with roll held", "suspension.static_roll",
               "suspension.holds_attitude=true degrees_of_freedom=2", false);
        ofFilm("given pressure", "air.pressure", "", true);
        ofFilm("pressure of the atmosphere", "air.pressure", "air.source=atmosphere", false);
        ofFilm("altitude of given air", "air.altitude", "", false);
        ofFilm("altitude of the atmosphere", "air.altitude", "air.source=atmosphere", true);
        ofFilm("temperature of given air", "air.temperature", "", false);
        ofFilm("temperature of a series of altitudes", "air.temperature", "steady.altitudes=[0,3000]", true);
        ofFilm("accommodation without slip", "air.accommodation", "air.slip=continuum", false);
        ofFilm("switch of another slip model", "air.switch_gap", "", false);
        ofFilm("switch of the combination", "air.switch_gap", "air.slip=combination", true);
        ofFilm("load tolerance of a fixed attitude", "steady.load_tolerance", "steady.fixed_attitude=true", false);
        for (const char* key : {"abs.crown", "air.slip", "disk.speed", "film.nodes", "steady.radii", "slider.length",
                                "suspension.preload", "initial.roll", "initial.nominal_trailing_edge_height"})
            QTest::addRow("%s of springs", key) << key << "model=springs" << false;
    }
    void used()
    {
        QFETCH(QString, key);
        QFETCH(QString, choice);
        QFETCH(bool, used);
        Case c;
        for (const QString& each : choice.split(' '))
            QCOMPARE(setFromText(c, *findField(each.section('=', 0, 0).toStdString()), each.section('=', 1).toStdString())
                         .value_or(""),
                     std::string());
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
        QTest::newRow("nothing like it") << "banana.split"
                                         << "";
        QTest::newRow("a slip in a list") << "film.node"
                                          << "film.nodes";
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

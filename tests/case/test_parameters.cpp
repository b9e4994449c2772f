// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/parameters.h"

#include "core/case/contact_kind.h"
#include "core/case/integrator_kind.h"
#include "core/formats/units.h"

#include <QTest>

#include <set>

#include "core/physics/contact/adhesion_kind.h"
#include "core/physics/contact/asperity_model.h"
#include "core/physics/film/slip_model.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_parameters {

void addParameterRows()
{
    QTest::addColumn<QString>("key");
    for (const Parameter& parameter : parameters())
        QTest::newRow(parameter.key.c_str()) << QString::fromStdString(parameter.key);
}

/// A value other than the default; nothing where there is none.
std::optional<ParameterValue> another(const Parameter& parameter, const Case& c)
{
    const ParameterValue old = parameter.get(c);
    switch (parameter.kind) {
    case ParameterKind::Number: return std::get<double>(old) == 0.5 ? 0.25 : 0.5;
    case ParameterKind::Boolean: return !std::get<bool>(old);
    case ParameterKind::Text: return std::string("other");
    case ParameterKind::Choice:
        for (const std::string& name : parameter.choices)
            if (ParameterValue(name) != old) return name;
        break;
    case ParameterKind::Integer: return static_cast<int>(parameter.maximum);
    case ParameterKind::List:
        return std::vector<double>(std::max<std::size_t>(parameter.minimumCount, 1),
                                   parameter.stride > 0 ? parameter.maximum : 0.25);
    }
    return {};
}

class TestParameters : public QObject {
    Q_OBJECT

private slots:
    /// `describe ono_yamane` has the formula of W of each shape; tests/physics/contact/test_ono_yamane.cpp checks them.
    void theWorkOfACycleIsDescribed()
    {
        const std::string& help = findParameter("ono_yamane.take_off_shape")->help;
        for (const char* part :
             {"constant: W = f_m (d_e - d_s) - f_c0^2/(2 k_c)", "d_e < d_s + f_c0/k_c", "W < 0",
              "both-linear: W = (f_m - f_c0) (d_e - d_s)/2", " linear: W = f_m (d_e - d_s)/2 - f_c0^2/(2 k_c)"})
            QVERIFY2(help.find(part) != std::string::npos, part);
    }

    void isDescribed_data() { addParameterRows(); }
    void isDescribed()
    {
        QFETCH(QString, key);
        const Parameter& parameter = *findParameter(key.toStdString());
        QVERIFY(!parameter.label.empty());
        QVERIFY(parameter.help.ends_with('.'));
        if (parameter.kind == ParameterKind::Number || parameter.kind == ParameterKind::List) {
            QVERIFY(!parameter.source.empty());
            QCOMPARE(parameter.unit.empty(), parameter.displayUnit.empty());
            // The display unit measures what the SI unit does, and the SI unit is one.
            QVERIFY(std::holds_alternative<double>(
                parseQuantity("1 " + (parameter.unit.empty() ? "%" : parameter.displayUnit), parameter.unit)));
            QVERIFY(unitFactor(parameter.unit) == 1.0);
        }
        if (parameter.kind == ParameterKind::Choice) QVERIFY(!parameter.choices.empty());
        if (parameter.kind == ParameterKind::List)
            QVERIFY(parameter.maximumCount > 0 && parameter.maximumCount >= parameter.minimumCount);
    }

    void defaultIsAllowed_data() { addParameterRows(); }
    void defaultIsAllowed()
    {
        QFETCH(QString, key);
        const Parameter& parameter = *findParameter(key.toStdString());
        Case c;
        QCOMPARE(setFromText(c, parameter, toText(c, parameter)).value_or(""), std::string());
        QVERIFY(parameter.get(c) == parameter.get(Case{}));
    }

    void setReachesOneMemberAlone_data() { addParameterRows(); }
    void setReachesOneMemberAlone()
    {
        QFETCH(QString, key);
        const Parameter& parameter = *findParameter(key.toStdString());
        Case c;
        const auto value = another(parameter, c);
        QVERIFY(value.has_value());
        parameter.set(c, *value);
        for (const Parameter& other : parameters())
            QCOMPARE(other.get(c) == other.get(Case{}), other.key != parameter.key);
        QVERIFY(parameter.get(c) == *value);
    }

    void keysAreUnique()
    {
        std::set<std::string> keys;
        for (const Parameter& parameter : parameters())
            QVERIFY2(keys.insert(parameter.key).second, parameter.key.c_str());
    }
    /// A case file writes each table once.
    void groupsAreContiguous()
    {
        std::set<std::string> done;
        std::string group;
        for (const Parameter& parameter : parameters()) {
            if (parameter.group() == group) continue;
            group = parameter.group();
            QVERIFY2(done.insert(group).second, group.c_str());
        }
        QCOMPARE(done, (std::set<std::string>{"about",    "slider",     "springs", "suspension", "pad",
                                              "approach", "ono_yamane", "elastic", "adhesion",   "asperity",
                                              "meniscus", "abs",        "air",     "disk",       "disk.surface",
                                              "film",     "steady",     "initial", "run",        "spectrum"}));
    }
    void choicesFollowTheEnumerators()
    {
        Case c;
        findParameter("run.integrator")->set(c, std::string("rk4-events"));
        QCOMPARE(c.run.integrator, IntegratorKind::Rk4Events);
        findParameter("run.integrator")->set(c, std::string("cvode"));
        QCOMPARE(c.run.integrator, IntegratorKind::Cvode);
        findParameter("spectrum.window")->set(c, std::string("flat-top"));
        QCOMPARE(c.spectrum.window, SpectrumWindow::FlatTop);
        findParameter("springs.potential")->set(c, std::string("as-printed"));
        QCOMPARE(c.springs.potential, PotentialBelowCutoff::AsPrinted);
        findParameter("initial.branch")->set(c, std::string("take-off"));
        QCOMPARE(c.initial.branch, ContactBranch::TakeOff);
        findParameter("contact")->set(c, std::string("none"));
        QCOMPARE(c.contact, ContactKind::None);
        findParameter("model")->set(c, std::string("film"));
        QCOMPARE(c.model, ModelKind::Film);
        findParameter("air.source")->set(c, std::string("established-standard"));
        QCOMPARE(c.air.source, AirSource::EstablishedStandard);
        for (const auto& [name, model] :
             {std::pair{"continuum", SlipModel::Continuum}, std::pair{"first-order", SlipModel::FirstOrder},
              std::pair{"second-order", SlipModel::SecondOrder}, std::pair{"1.5-order", SlipModel::OnePointFiveOrder},
              std::pair{"fukui-kaneko", SlipModel::FukuiKaneko},
              std::pair{"fukui-kaneko-fit", SlipModel::FukuiKanekoFit},
              std::pair{"new-first-order", SlipModel::NewFirstOrder},
              std::pair{"new-second-order", SlipModel::NewSecondOrder},
              std::pair{"combination", SlipModel::Combination}}) {
            findParameter("air.slip")->set(c, std::string(name));
            QCOMPARE(c.air.slip.model, model);
        }
        for (const auto& [name, contact] :
             {std::pair{"none", ContactKind::None}, std::pair{"ono-yamane", ContactKind::OnoYamane},
              std::pair{"elastic", ContactKind::Elastic}, std::pair{"asperity", ContactKind::Asperity},
              std::pair{"multi-asperity", ContactKind::MultiAsperity}}) {
            findParameter("contact")->set(c, std::string(name));
            QCOMPARE(c.contact, contact);
        }
        findParameter("model")->set(c, std::string("contact"));
        QCOMPARE(c.model, ModelKind::Contact);
        findParameter("pad.shape")->set(c, std::string("slider"));
        QCOMPARE(c.pad.shape, PadShape::Slider);
        findParameter("adhesion.kind")->set(c, std::string("van-der-waals"));
        QCOMPARE(c.adhesion.kind, AdhesionKind::VanDerWaals);
        findParameter("asperity.model")->set(c, std::string("elastic-plastic"));
        QCOMPARE(c.asperity.model, AsperityModel::ElasticPlastic);
        for (const auto& [name, kind] :
             {std::pair{"flat", DiskSurfaceKind::Flat}, std::pair{"waves", DiskSurfaceKind::Waves},
              std::pair{"rough", DiskSurfaceKind::Rough}, std::pair{"file", DiskSurfaceKind::File},
              std::pair{"bumps", DiskSurfaceKind::Bumps}, std::pair{"combined", DiskSurfaceKind::Combined}}) {
            findParameter("disk.surface.kind")->set(c, std::string(name));
            QCOMPARE(c.diskSurface.kind, kind);
        }
        findParameter("disk.surface.motion")->set(c, std::string("still"));
        QCOMPARE(c.diskSurface.motion, SurfaceMotion::Still);
        findParameter("disk.surface.spectrum")->set(c, std::string("self-affine"));
        QCOMPARE(c.diskSurface.spectrum, RoughnessSpectrum::SelfAffine);
        findParameter("disk.surface.bump_shape")->set(c, std::string("cosine"));
        QCOMPARE(c.diskSurface.bumpShape, BumpShape::Cosine);
        findParameter("disk.velocity_field")->set(c, std::string("uniform"));
        QCOMPARE(c.disk.field, VelocityField::Uniform);
        findParameter("film.grid")->set(c, std::string("graded"));
        QCOMPARE(c.film.grid, GridKind::Graded);
        for (const auto& [name, scheme] :
             {std::pair{"upwind", ConvectionScheme::Upwind}, std::pair{"hybrid", ConvectionScheme::Hybrid},
              std::pair{"power-law", ConvectionScheme::PowerLaw},
              std::pair{"exponential", ConvectionScheme::Exponential},
              std::pair{"complete-flux", ConvectionScheme::CompleteFlux}}) {
            findParameter("film.scheme")->set(c, std::string(name));
            QCOMPARE(c.film.scheme, scheme);
        }
        findParameter("film.solver")->set(c, std::string("line-multigrid"));
        QCOMPARE(c.film.solver, FilmSolver::LineMultigrid);
        findParameter("film.coupling")->set(c, std::string("staggered"));
        QCOMPARE(c.film.coupling, FilmCoupling::Staggered);
        findParameter("run.steps")->set(c, std::string("fixed"));
        QCOMPARE(c.run.steps, StepControl::Fixed);
        findParameter("initial.state")->set(c, std::string("static"));
        QCOMPARE(c.initial.state, InitialState::Static);
    }
    /// What a case has where nobody says otherwise.
    void defaultsOfTheModels()
    {
        QCOMPARE(defaultsOf(ModelKind::Springs).contact, ContactKind::OnoYamane);
        QCOMPARE(defaultsOf(ModelKind::Springs).degreesOfFreedom, 2);
        QCOMPARE(defaultsOf(ModelKind::Film).contact, ContactKind::None);
        QCOMPARE(defaultsOf(ModelKind::Film).degreesOfFreedom, 3);
        QVERIFY(checkCombinations(defaultsOf(ModelKind::Film)).empty());
        for (const Parameter& parameter : parameters()) {
            const bool differs = parameter.get(defaultsOf(ModelKind::Film)) != parameter.get(Case{});
            QCOMPARE(differs, parameter.key == "model" || parameter.key == "contact" ||
                                  parameter.key == "degrees_of_freedom" || parameter.key == "run.duration");
        }
        QCOMPARE(defaultsOf(ModelKind::Contact).contact, ContactKind::Elastic);
        QVERIFY(checkCombinations(defaultsOf(ModelKind::Contact)).empty());
        for (const Parameter& parameter : parameters()) {
            const bool differs = parameter.get(defaultsOf(ModelKind::Contact)) != parameter.get(Case{});
            QCOMPARE(differs,
                     parameter.key == "model" || parameter.key == "contact" || parameter.key == "run.sample_interval");
        }
    }
    void listsFillArraysAndVectors()
    {
        Case c;
        findParameter("film.nodes")->set(c, std::vector<double>{33, 65});
        QCOMPARE(c.film.nodes, (std::array<int, 2>{33, 65}));
        findParameter("steady.radii")->set(c, std::vector<double>{0.02, 0.03, 0.04});
        QCOMPARE(c.steady.radii, (std::vector<double>{0.02, 0.03, 0.04}));
        findParameter("steady.radii")->set(c, std::vector<double>{});
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
        const auto ofSprings = [](const char* key, const char* contact, bool used) {
            QTest::addRow("%s of springs with contact %s", key, contact)
                << key << "contact=" + QString(contact) << used;
        };
        for (const char* key : {"asperity.density", "asperity.friction", "elastic.slider_modulus", "pad.length",
                                "pad.width", "slider.thickness"}) {
            ofSprings(key, "asperity", true);
            ofSprings(key, "none", false);
            ofSprings(key, "multi-asperity", false); // refused
        }
        ofSprings("meniscus.film_thickness", "asperity", false);
        ofSprings("initial.branch", "asperity", false);
        ofSprings("elastic.cell", "elastic", false); // refused
        const auto ofFilm = [](const char* name, const char* key, const char* choice, bool used) {
            QTest::newRow(name) << key << (QString("model=film contact=none degrees_of_freedom=3 ") + choice).trimmed()
                                << used;
        };
        ofFilm("springs of a film case", "springs.cutoff", "", false);
        ofFilm("damping ratio of a film case", "suspension.damping_ratio", "", false);
        ofFilm("flying height of a film case", "initial.flying_height", "", false);
        ofFilm("pad distance of a film case", "ono_yamane.pad_distance", "", false);
        ofFilm("integrator of a film case", "run.integrator", "", false);
        ofFilm("step of adaptive steps", "run.step", "run.integrator=rk4", false);
        ofFilm("step of fixed steps", "run.step", "run.steps=fixed", true);
        ofFilm("error of adaptive steps", "run.step_error", "", true);
        ofFilm("error of fixed steps", "run.step_error", "run.steps=fixed", true);
        ofFilm("tolerance of a film case", "run.tolerance", "", false);
        ofFilm("step check of a film case", "run.step_check", "run.integrator=rk4 run.steps=fixed", false);
        ofFilm("coupling of a film case", "film.coupling", "", true);
        ofFilm("duration of a film case", "run.duration", "", true);
        ofFilm("samples of a film case", "run.sample_interval", "", true);
        ofFilm("snapshots of a film case", "run.field_snapshots", "", true);
        ofFilm("threads of a film case", "run.threads", "", true);
        ofFilm("spectrum of a film case", "spectrum.window", "", true);
        ofFilm("vertical velocity of a film case", "initial.vertical_velocity", "", true);
        ofFilm("roll velocity of a film case", "initial.roll_velocity", "", true);
        ofFilm("roll velocity with roll held", "initial.roll_velocity", "degrees_of_freedom=2", false);
        ofFilm("initial state of a film case", "initial.state", "", true);
        ofFilm("offset from a given attitude", "initial.height_offset", "", false);
        ofFilm("offset from the static attitude", "initial.pitch_offset", "initial.state=static", true);
        ofFilm("roll offset from the static attitude", "initial.roll_offset", "initial.state=static", true);
        ofFilm("roll offset with roll held", "initial.roll_offset", "initial.state=static degrees_of_freedom=2", false);
        ofFilm("attitude from which the static one is sought", "initial.nominal_trailing_edge_height",
               "initial.state=static", true);
        ofFilm("branch without contact", "initial.branch", "", false);
        ofFilm("branch of a characteristic", "initial.branch", "contact=ono-yamane", true);
        ofFilm("characteristic", "ono_yamane.meniscus_force", "contact=ono-yamane", true);
        ofFilm("pad distance of a characteristic", "ono_yamane.pad_distance", "contact=ono-yamane", false);
        ofFilm("elasticity", "elastic.modulus", "contact=elastic", true);
        ofFilm("summits", "asperity.density", "contact=asperity", true);
        ofFilm("elasticity of summits", "elastic.modulus", "contact=asperity", true);
        ofFilm("a pad, where summits are everywhere", "pad.length", "contact=asperity", false);
        ofFilm("a pad of summits with menisci", "pad.width", "contact=multi-asperity", true);
        ofFilm("its menisci", "meniscus.surface_tension", "contact=multi-asperity", true);
        ofFilm("its shape", "pad.shape", "contact=multi-asperity", false);
        ofFilm("its way", "approach.start", "contact=multi-asperity", false);
        ofFilm("adhesion", "adhesion.hamaker_a", "contact=elastic adhesion.kind=van-der-waals", true);
        ofFilm("search of patches", "elastic.patch_reach", "contact=elastic", true);
        ofFilm("search of patches without surfaces", "elastic.patch_pitch", "contact=ono-yamane", false);
        ofFilm("patches of a slider, which do not repeat", "elastic.periodic", "contact=elastic", false);
        ofFilm("pad of a slider", "pad.shape", "contact=elastic", false);
        ofFilm("way of a slider", "approach.start", "contact=elastic", false);
        ofFilm("roughness of a disk that nothing touches", "disk.surface.rms", "disk.surface.kind=rough", true);
        ofFilm("motion of a flat disk", "disk.surface.motion", "", false);
        ofFilm("motion of a wavy disk", "disk.surface.motion", "disk.surface.kind=waves contact=elastic", true);
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
        const auto ofContact = [](const char* key, const char* choice, bool used) {
            const QString settings = (QString("model=contact contact=elastic ") + choice).trimmed();
            QTest::addRow("%s with %s", key, choice) << key << settings << used;
        };
        ofContact("slider.mass", "", false);
        ofContact("suspension.stiffness", "", false);
        ofContact("degrees_of_freedom", "", false);
        ofContact("run.integrator", "", false);
        ofContact("spectrum.window", "", false);
        ofContact("initial.pitch", "", false);
        ofContact("ono_yamane.touch_down", "", false);
        ofContact("ono_yamane.pad_distance", "contact=ono-yamane", false);
        ofContact("run.duration", "", true);
        ofContact("run.sample_interval", "contact=asperity", true);
        ofContact("run.field_snapshots", "", true);
        ofContact("run.field_snapshots", "contact=asperity", false);
        ofContact("approach.start", "contact=ono-yamane", true);
        ofContact("pad.length", "contact=ono-yamane", false);
        ofContact("pad.length", "contact=asperity", true);
        ofContact("pad.length", "pad.shape=slider", false);
        ofContact("pad.radius", "pad.shape=flat", false);
        ofContact("pad.radius", "pad.shape=sphere", true);
        ofContact("slider.length", "pad.shape=slider", true);
        ofContact("abs.crown", "pad.shape=slider", true);
        ofContact("abs.crown", "pad.shape=sphere", false);
        ofContact("initial.roll", "pad.shape=slider", true);
        ofContact("initial.nominal_trailing_edge_height", "pad.shape=slider", false);
        ofContact("elastic.modulus", "contact=multi-asperity", true);
        ofContact("elastic.modulus", "contact=ono-yamane", false);
        ofContact("elastic.cell", "contact=asperity", false);
        ofContact("adhesion.kind", "", true);
        ofContact("adhesion.kind", "contact=asperity", true);
        ofContact("adhesion.kind", "contact=multi-asperity", false);
        ofFilm("attraction beside summits", "adhesion.voltage", "contact=asperity", true);
        ofContact("adhesion.surface_energy", "", false);
        ofContact("adhesion.surface_energy", "adhesion.kind=lennard-jones", true);
        ofContact("adhesion.equilibrium_distance", "", false);
        ofContact("adhesion.equilibrium_distance", "adhesion.kind=van-der-waals", false);
        ofContact("adhesion.equilibrium_distance", "adhesion.voltage=1", true);
        ofContact("adhesion.hamaker_a", "adhesion.kind=van-der-waals", true);
        ofContact("asperity.radius", "", false);
        ofContact("asperity.radius", "contact=asperity", true);
        ofContact("asperity.yield_strength", "contact=asperity", false);
        ofContact("asperity.yield_strength", "contact=asperity asperity.model=elastic-plastic", true);
        ofContact("meniscus.surface_tension", "contact=asperity", false);
        ofContact("meniscus.surface_tension", "contact=multi-asperity", true);
        ofContact("disk.surface.motion", "", false);
        ofContact("disk.surface.motion", "disk.surface.kind=waves", true);
        ofContact("disk.speed", "", false);
        ofContact("disk.speed", "disk.surface.kind=waves", true);
        ofContact("disk.speed", "disk.surface.kind=waves disk.surface.motion=still", false);
        ofContact("disk.velocity_field", "disk.surface.kind=waves", false);
        ofContact("disk.surface.wave_lengths", "disk.surface.kind=rough", false);
        ofContact("disk.surface.wave_lengths", "disk.surface.kind=combined", true);
        ofContact("disk.surface.rms", "disk.surface.kind=rough", true);
        ofContact("disk.surface.rms", "disk.surface.kind=waves", false);
        ofContact("disk.surface.hurst", "disk.surface.kind=rough", false);
        ofContact("disk.surface.hurst", "disk.surface.kind=rough disk.surface.spectrum=self-affine", true);
        ofContact("disk.surface.correlation_length", "disk.surface.kind=rough disk.surface.spectrum=self-affine",
                  false);
        ofContact("disk.surface.file", "disk.surface.kind=file", true);
        ofContact("disk.surface.unit", "disk.surface.kind=file", true);
        ofContact("disk.surface.track", "disk.surface.kind=file", false);
        ofContact("disk.surface.bump_heights", "disk.surface.kind=bumps", true);
        ofContact("disk.surface.kind", "contact=asperity", false);
        ofContact("elastic.patch_reach", "pad.shape=slider", false);
        ofFilm("disk surface of a film case", "disk.surface.kind", "", true);
        ofFilm("elasticity of a film case", "elastic.modulus", "", false);
        for (const char* key :
             {"pad.shape", "approach.start", "elastic.modulus", "adhesion.kind", "asperity.radius",
              "meniscus.surface_tension", "disk.surface.motion", "run.field_snapshots", "film.coupling", "run.steps",
              "run.threads", "run.step_error", "initial.state", "initial.roll_velocity"})
            QTest::addRow("%s of springs", key) << key << "model=springs" << false;
        for (const char* key : {"abs.crown", "air.slip", "disk.speed", "film.nodes", "steady.radii", "slider.length",
                                "suspension.preload", "initial.roll", "initial.nominal_trailing_edge_height"})
            QTest::addRow("%s of springs", key) << key << "model=springs" << false;
        const char* over = "model=springs disk.surface.kind=waves";
        QTest::newRow("a surface under springs") << "disk.surface.kind"
                                                 << "model=springs" << true;
        for (const char* key : {"disk.surface.motion", "disk.surface.wave_lengths", "disk.speed", "disk.radius",
                                "disk.skew", "slider.length", "slider.width"})
            QTest::addRow("%s of springs over waves", key) << key << over << true;
        for (const char* key : {"disk.velocity_field", "abs.crown", "initial.roll"})
            QTest::addRow("%s of springs over waves", key) << key << over << false;
        QTest::newRow("a speed under springs over still waves")
            << "disk.speed"
            << "model=springs disk.surface.kind=waves disk.surface.motion=still" << false;
    }
    void used()
    {
        QFETCH(QString, key);
        QFETCH(QString, choice);
        QFETCH(bool, used);
        Case c;
        for (const QString& each : choice.split(' '))
            QCOMPARE(setFromText(c, *findParameter(each.section('=', 0, 0).toStdString()),
                                 each.section('=', 1).toStdString())
                         .value_or(""),
                     std::string());
        QCOMPARE(findParameter(key.toStdString())->used(c), used);
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
        QTest::newRow("a slip would be another") << "nodes"
                                                 << "film.nodes";
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
    void unknownKeysAreNotFound() { QVERIFY(findParameter("springs.cutof") == nullptr); }
};

TOUCHDOWN_TEST(TestParameters)

} // namespace test_parameters

#include "test_parameters.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/design/design.h"

#include <cmath>

#include <QTest>

#include "core/case_files/case_file.h"
#include "core/formats/units.h"
#include "core/simulation/static_state/steady_quantities.h"
#include "tests/support/small_slider.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_design {

Case slider()
{
    Case c = test::smallSlider(33);
    c.film.grid = GridKind::Uniform;
    c.degreesOfFreedom = 2;
    return c;
}

DesignParameter parameter(const Case& c, const std::vector<const char*>& names, double minimum, double maximum)
{
    DesignParameter result;
    for (const char* name : names) result.keys.push_back(std::get<Parameter>(numberKey(c, name)));
    result.start = numberOf(result.keys.front(), c);
    result.minimum = minimum;
    result.maximum = maximum;
    return result;
}

DesignTarget target(const char* name, double value, double tolerance)
{
    for (const SteadyQuantity& each : steadyQuantities({}))
        if (each.quantity.name == name) return {each.quantity, value, tolerance};
    qFatal("%s", name);
}

/// 1.25 mm x 1 mm, one plane; the air's shear has no arm.
Case plane()
{
    Case c = openCase("film_plane").value;
    c.steady.fixedAttitude = false;
    c.steady.torqueSign = 0.0;
    c.degreesOfFreedom = 2;
    c.film.nodes = {65, 65};
    c.film.tolerance = 1e-10;
    c.steady.loadTolerance = 1e-9;
    c.suspension.preload = 7.0 * 9.80665e-3;
    c.suspension.offsetX = 0.288e-3;
    return c;
}

/// All of the plane moves away from the disk.
DesignParameter recessOfAll(const Case& c, double minimum, double maximum)
{
    return parameter(c, {"abs.rail[1].recess", "abs.base_recess"}, minimum, maximum);
}

class TestDesign : public QObject {
    Q_OBJECT

private slots:
    /// The plane slider at a pitch of 200 urad carries 8.2148 gf at a trailing gap of 100 nm: an independent solution
    /// by exponential fitting, extrapolated. Its load goes down with the gap by 0.06 gf/nm, and a grid of 97 x 97 errs
    /// by less than 2e-3 gf.
    void gapOfThePlane()
    {
        Case c = plane();
        c.film.nodes = {97, 97};
        c.steady.fixedAttitude = true;
        DesignTask task;
        task.parameters = {parameter(c, {"initial.nominal_trailing_edge_height"}, 50e-9, 200e-9)};
        task.parameters.front().start = 180e-9;
        task.targets = {target("net_force", 8.2148 * 9.80665e-3, 1e-8)};
        const DesignStudy study = studyDesign(c, task);
        QVERIFY2(study.status == StudyStatus::Completed, study.message.c_str());
        const double gap = study.found.initial.nominalTrailingEdgeHeight;
        QVERIFY2(std::abs(gap - 100e-9) < 0.04e-9, qPrintable(QString::number(gap, 'g', 8)));
    }
    /// With the whole plane 5 nm farther away its zero flies 5 nm lower, and nothing else changes.
    void wholeSurface()
    {
        const Case c = plane();
        const SteadyResult before = steady(c);
        QCOMPARE(before.status, SteadyStatus::Converged);
        DesignTask task;
        task.parameters = {recessOfAll(c, -10e-9, 20e-9)};
        task.targets = {target("nominal_trailing_edge_height", before.attitude.height - 5e-9, 1e-13)};
        const DesignStudy study = studyDesign(c, task);
        QVERIFY2(study.status == StudyStatus::Completed, study.message.c_str());
        QVERIFY(std::abs(study.found.surface.rails[0].recess[0] - 5e-9) < 1e-12);
        QVERIFY(std::abs(study.found.surface.baseRecess - 5e-9) < 1e-12);
        QVERIFY(std::abs(study.state.minimumSpacing - before.minimumSpacing) < 1e-12);
        QCOMPARE(study.state.pressure.size(), std::size_t{0});
        QCOMPARE(study.steps.front().iteration, 0);
        QVERIFY(study.steps.size() <= 4);
    }
    /// What the slider does with the load 30 um farther back and 10 % more of it is found again by its height and
    /// pitch.
    void loadFromAttitude()
    {
        const Case c = slider();
        Case known = c;
        known.suspension.offsetX += 30e-6;
        known.suspension.preload *= 1.1;
        const SteadyResult wanted = steady(known);
        DesignTask task;
        task.parameters = {parameter(c, {"suspension.offset_x"}, -0.1e-3, 0.1e-3),
                           parameter(c, {"suspension.preload"}, 5e-3, 20e-3)};
        task.targets = {target("minimum_spacing", wanted.minimumSpacing, 1e-13),
                        target("pitch", wanted.attitude.pitch, 1e-10)};
        const DesignStudy study = studyDesign(c, task);
        QCOMPARE(study.status, StudyStatus::Completed);
        QVERIFY(std::abs(study.found.suspension.offsetX - known.suspension.offsetX) < 1e-9);
        QVERIFY(std::abs(study.found.suspension.preload / known.suspension.preload - 1.0) < 1e-4);
        for (const std::string& text : {formatQuantity(study.found.suspension.offsetX, "um"),
                                        formatQuantity(study.found.suspension.preload, "gf")})
            QVERIFY2(text.size() <= 13, text.c_str()); // eight digits
        // What the case asks for besides the attitude is not lost.
        QCOMPARE(study.found.steady.stiffness, c.steady.stiffness);
        // Once more, with the same numbers.
        const DesignStudy again = studyDesign(c, task);
        QCOMPARE(again.steps.size(), study.steps.size());
        for (std::size_t i = 0; i < study.steps.size(); ++i) {
            QCOMPARE(again.steps[i].parameters, study.steps[i].parameters);
            QCOMPARE(again.steps[i].quantities, study.steps[i].quantities);
        }
    }
    /// 5 nm can be had of the 50 nm that are wanted.
    void outOfReach()
    {
        const Case c = plane();
        const SteadyResult before = steady(c);
        DesignTask task;
        task.parameters = {recessOfAll(c, -5e-9, 5e-9)};
        task.targets = {target("nominal_trailing_edge_height", before.attitude.height - 50e-9, 1e-12)};
        const DesignStudy study = studyDesign(c, task);
        QCOMPARE(study.status, StudyStatus::Failed);
        QCOMPARE(study.message,
                 std::string("the targets are not reached within the bounds; the best set lies on the bound of "
                             "abs.rail[1].recess"));
        QCOMPARE(study.steps.back().parameters[0], 5e-9);
        QVERIFY(std::abs(study.steps.back().misfit - 45e3) < 1.0);
    }
    void tooFewIterations()
    {
        const Case c = slider();
        DesignTask task;
        task.parameters = {parameter(c, {"suspension.preload"}, 5e-3, 20e-3)};
        task.targets = {target("minimum_spacing", steady(c).minimumSpacing - 5e-9, 1e-15)};
        task.maximumIterations = 1;
        const DesignStudy study = studyDesign(c, task);
        QCOMPARE(study.status, StudyStatus::Failed);
        QCOMPARE(study.message, std::string("the targets are not reached in 1 iteration"));
        QCOMPARE(study.steps.size(), std::size_t{2});
    }
    /// A small pad that stands out from the surface: `touchdown steady` fails there, and the attitude is known all the
    /// same.
    void belowTheDisk()
    {
        Case c = slider();
        c.surface.rails.push_back(test::rectangle(0.98e-3, 0.399e-3, 0.984e-3, 0.401e-3, 0.0));
        DesignTask task;
        task.parameters = {parameter(c, {"abs.rail[6].recess"}, -0.1e-6, 0.1e-6)};
        task.targets = {target("minimum_spacing", -1e-9, 0.05e-9)};
        const DesignStudy study = studyDesign(c, task);
        QVERIFY2(study.status == StudyStatus::Completed, study.message.c_str());
        QCOMPARE(study.state.status, SteadyStatus::Failed);
        QVERIFY(std::abs(study.state.minimumSpacing + 1e-9) < 0.05e-9);
    }
    void noStart()
    {
        Case c = slider();
        c.film.maximumIterations = 1;
        DesignTask task;
        task.parameters = {parameter(c, {"suspension.preload"}, 5e-3, 20e-3)};
        task.targets = {target("minimum_spacing", 5e-9, 1e-10)};
        const DesignStudy study = studyDesign(c, task);
        QCOMPARE(study.status, StudyStatus::Failed);
        QVERIFY2(study.message.starts_with("no static state to start from: no flying attitude was found"),
                 study.message.c_str());
        QCOMPARE(study.solves, 1);
    }
    void stops()
    {
        const Case c = slider();
        DesignTask task;
        task.parameters = {parameter(c, {"suspension.preload"}, 5e-3, 20e-3)};
        task.targets = {target("minimum_spacing", 5e-9, 1e-10)};
        const DesignStudy study =
            studyDesign(c, task, [](const DesignProgress& progress) { return progress.solves < 2; });
        QCOMPARE(study.status, StudyStatus::Cancelled);
        QCOMPARE(study.solves, 3);
        QVERIFY(!study.message.empty());
    }

    void refuses()
    {
        QVERIFY(reasonNotToDesign(slider()).empty());
        QVERIFY(reasonNotToDesign(Case{}).find("model \"film\"") != std::string::npos);
        Case series = slider();
        series.steady.radii = {20e-3, 30e-3};
        QVERIFY(reasonNotToDesign(series).find("series") != std::string::npos);
    }
};

TOUCHDOWN_TEST(TestDesign)

} // namespace test_design

#include "test_design.moc"

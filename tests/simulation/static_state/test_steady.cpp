// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>

#include <algorithm>
#include <random>
#include <set>
#include <string_view>

#include "core/case/contact_kind.h"
#include "core/case_files/case_file.h"
#include "core/case_files/case_reader.h"
#include "core/physics/slider/lift_area.h"
#include "core/simulation/run.h"
#include "core/simulation/static_state/steady.h"
#include "tests/support/small_slider.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_steady {

constexpr std::string_view withoutRails = "femto_without_rails";

class TestSteady : public QObject {
    Q_OBJECT

private slots:
    void forcesBalanceTheLoad();
    void theSlidersToBeginWithFly_data();
    void theSlidersToBeginWithFly();
    void railsDrawnOnTheEmptySliderFly();
    void aFixedAttitudeIsKept();
    void aHeldRollCarriesAnyTorque();
    void reportsWhereItIsNearest();
    void theErrorEstimateCoversTheFinerGrid();
    void anAccuracyPicksTheGrid();
    void sensitivitiesAgreeWithDifferences_data();
    void sensitivitiesAgreeWithDifferences();
    void mirroredSlidersRollTheOtherWay();
    void progressNamesTheGrids();
    void cancelling();
    void notConverging();
    void aLoadThatOnlyContactCarries();
    void railsInsideTheDisk();
    void aDiskAtRest();
    void noPreload();
    void theErrorOfASingleGridIsUnknown();
};

void TestSteady::forcesBalanceTheLoad()
{
    const Case c = test::smallSlider();
    const SteadyResult r = steady(c);
    QCOMPARE(r.status, SteadyStatus::Converged);
    const double preload = c.suspension.preload, length = c.slider.length;
    QVERIFY(std::abs(r.forces.net - preload) < 1e-8 * preload);
    QVERIFY(std::abs(r.forces.pitchTorque + preload * c.suspension.offsetX + r.shearPitchTorque) <
            1e-8 * preload * length);
    QVERIFY(std::abs(r.forces.rollTorque + r.shearRollTorque) < 1e-8 * preload * length);
    QVERIFY(std::abs(r.forces.positive + r.forces.negative - r.forces.net) < 1e-12 * preload);
    QVERIFY(r.forces.shearX > 0.0); // the disk drags the slider along
    QCOMPARE(r.grid.nx(), 64);
    QCOMPARE(r.pressure.size(), r.grid.cells());
    QVERIFY(*std::min_element(r.pressure.begin(), r.pressure.end()) > 0.0);
}

void TestSteady::theSlidersToBeginWithFly_data()
{
    QTest::addColumn<int>("index");
    for (std::size_t i = 0; i < sliderTemplates().size(); ++i)
        if (sliderTemplates()[i].name != withoutRails)
            QTest::newRow(sliderTemplates()[i].name.c_str()) << static_cast<int>(i);
}

/// Whoever begins a design with one sees it fly: clear of the disk, nose up, level but for the speed that grows
/// outwards, with three degrees of freedom.
void TestSteady::theSlidersToBeginWithFly()
{
    QFETCH(const int, index);
    const SampleCase& slider = sliderTemplates()[static_cast<std::size_t>(index)];
    const CaseDocument document = parseCase(slider.text, slider.name);
    QVERIFY(document.valid());
    QVERIFY(document.warnings.empty() && document.unused.empty());
    Case c = document.value;
    QCOMPARE(c.degreesOfFreedom, 3);
    QVERIFY(railsSurround(c.surface, {0.5 * c.slider.length, 0.5 * c.slider.width}));
    c.film.nodes = {65, 65};
    const SteadyResult r = steady(c);
    QCOMPARE(r.status, SteadyStatus::Converged);
    QVERIFY2(r.minimumSpacing > 3e-9 && r.minimumSpacing < 1e-6, qPrintable(QString::number(r.minimumSpacing)));
    QVERIFY(r.attitude.pitch > 20e-6 && r.attitude.pitch < 500e-6);
    QVERIFY(std::abs(r.attitude.roll) < 20e-6);
    // A run begins beside this state, and shows how the slider swings about it.
    QVERIFY(c.initial.state == InitialState::Static);
    c.run.duration = 5e-6;
    QVERIFY(run(c).status == RunStatus::Completed);
}

/// Two rails drawn by hand on the slider that has none, nearly alike and along its sides, fly as they are drawn.
void TestSteady::railsDrawnOnTheEmptySliderFly()
{
    const auto& all = sliderTemplates();
    const auto empty = std::ranges::find(all, withoutRails, &SampleCase::name);
    QVERIFY(empty != all.end());
    Case c = parseCase(empty->text, empty->name).value;
    QVERIFY(c.surface.rails.empty());
    c.film.nodes = {65, 65};
    std::mt19937 random(1);
    const auto between = [&](double least, double most) { return std::uniform_real_distribution(least, most)(random); };
    for (int i = 0; i < 12; ++i) {
        const double front = between(0.0, 0.12), back = between(0.7, 0.85), side = between(0.0, 0.08);
        const double width = between(0.08, 0.22);
        const auto rail = [&](double y) {
            const auto hand = [&] { return between(0.0, 0.01); };
            const double x1 = 1e-3 * (front + hand()), x2 = 1e-3 * (back - hand()), y1 = 1e-3 * y,
                         y2 = 1e-3 * (y + width - hand());
            return Rail{RailKind::Step, {{x1, y1}, {x2, y1}, {x2, y2}, {x1, y2}}, {}};
        };
        c.surface.rails = {rail(side), rail(0.7 - side - width)};
        const SteadyResult r = steady(c);
        QVERIFY2(r.status == SteadyStatus::Converged && r.minimumSpacing > 3e-9 && r.minimumSpacing < 300e-9,
                 qPrintable(QStringLiteral("%1: %2").arg(i).arg(r.minimumSpacing)));
    }
}

void TestSteady::aFixedAttitudeIsKept()
{
    Case c = test::smallSlider();
    c.steady.fixedAttitude = true;
    c.initial.roll = 3e-6;
    const SteadyResult r = steady(c);
    QCOMPARE(r.status, SteadyStatus::Converged);
    QCOMPARE(r.attitude.height, c.initial.nominalTrailingEdgeHeight);
    QCOMPARE(r.attitude.pitch, c.initial.pitch);
    QCOMPARE(r.attitude.roll, c.initial.roll);
    QVERIFY(r.discretisationError.load > 0.0);
    QCOMPARE(r.discretisationError.minimumSpacing, 0.0);
}

void TestSteady::aHeldRollCarriesAnyTorque()
{
    // With two degrees of freedom the roll stays the initial one; what presses on one side changes nothing.
    Case c = test::smallSlider();
    c.degreesOfFreedom = 2;
    c.initial.roll = 4e-6;
    c.steady.sensitivities = true;
    const SteadyResult r = steady(c);
    c.suspension.offsetY = 0.05e-3;
    const SteadyResult pressed = steady(c);
    for (const SteadyResult* result : {&r, &pressed}) {
        QCOMPARE(result->status, SteadyStatus::Converged);
        QVERIFY(std::abs(result->attitude.roll - 4e-6) < 1e-15);
        QVERIFY(std::abs(result->forces.net - c.suspension.preload) < 1e-8 * c.suspension.preload);
    }
    QVERIFY(std::abs(pressed.attitude.height / r.attitude.height - 1.0) < 1e-7);
    QVERIFY(std::abs(pressed.attitude.pitch / r.attitude.pitch - 1.0) < 1e-7);
    QVERIFY(!r.sensitivities.empty());
    for (const Sensitivity& s : r.sensitivities) QCOMPARE(s.roll, 0.0);
}

void TestSteady::reportsWhereItIsNearest()
{
    Case c = test::smallSlider();
    c.surface.pointsOfInterest = {{0.97e-3, 0.4e-3}, {0.5e-3, 0.4e-3}};
    const SteadyResult r = steady(c);
    QCOMPARE(r.interestSpacing.size(), std::size_t(2));
    // In the middle of the slider's length the base recess, 10 nm of crown off, and half the pitch times the length.
    const double expected = 1.5e-6 - 10e-9 - 3e-9 + r.attitude.height + 0.5e-3 * r.attitude.pitch;
    QVERIFY(std::abs(r.interestSpacing[1] - expected) < 1e-15);
    QVERIFY(r.minimumSpacing <= r.interestSpacing[0] + 2e-14); // edges are sampled 1e-10 m beside them
    QVERIFY(std::abs(r.minimumAt.x - 0.97e-3) < 1e-9);
}

void TestSteady::theErrorEstimateCoversTheFinerGrid()
{
    const SteadyResult coarse = steady(test::smallSlider(97)), fine = steady(test::smallSlider(193));
    QCOMPARE(fine.status, SteadyStatus::Converged);
    const double change = std::abs(fine.minimumSpacing - coarse.minimumSpacing);
    QVERIFY2(
        change < 3.0 * coarse.discretisationError.minimumSpacing + 1e-12,
        qPrintable(
            QString("%1 nm, estimate %2 nm").arg(change * 1e9).arg(coarse.discretisationError.minimumSpacing * 1e9)));
    QVERIFY(change > 0.03 * coarse.discretisationError.minimumSpacing);
}

void TestSteady::anAccuracyPicksTheGrid()
{
    // Two thirds of the error that one grid states need a finer one, at a flying attitude and at a fixed one.
    for (const bool fixedAttitude : {false, true}) {
        Case c = openCase("film_femto").value;
        c.steady.fixedAttitude = fixedAttitude;
        const auto share = [&](const SteadyResult& r) {
            return fixedAttitude ? r.discretisationError.load / std::abs(r.forces.net)
                                 : r.discretisationError.minimumSpacing / r.minimumSpacing;
        };
        c.film.accuracy = 0.1;
        const SteadyResult loose = steady(c);
        QVERIFY2(loose.status == SteadyStatus::Converged && loose.message.empty(), loose.message.c_str());
        QVERIFY(share(loose) <= 0.1);
        QCOMPARE(loose.grid.nx(), 192);
        c.film.accuracy = share(loose) / 1.5;
        const SteadyResult tight = steady(c);
        QVERIFY2(tight.status == SteadyStatus::Converged && tight.message.empty(), tight.message.c_str());
        QVERIFY(share(tight) <= c.film.accuracy);
        QVERIFY(tight.grid.nx() == 384 || tight.grid.nx() == 768);
    }
}

struct Change {
    const char* parameter;
    double step;
    void (*add)(Case&, double);
};

const std::vector<Change>& changes()
{
    static const std::vector<Change> list{
        {"abs.crown", 2e-11, [](Case& c, double d) { c.surface.crown += d; }},
        {"abs.camber", 2e-11, [](Case& c, double d) { c.surface.camber += d; }},
        {"abs.twist", 2e-11, [](Case& c, double d) { c.surface.twist += d; }},
        {"abs.base_recess", 1e-10, [](Case& c, double d) { c.surface.baseRecess += d; }},
        {"abs.rail[4].recess", 2e-11, [](Case& c, double d) { c.surface.rails[3].recess[0] += d; }},
        {"suspension.preload", 1e-6, [](Case& c, double d) { c.suspension.preload += d; }},
        {"suspension.pitch_torque", 1e-10, [](Case& c, double d) { c.suspension.pitchTorque += d; }},
        {"suspension.offset_y", 1e-8, [](Case& c, double d) { c.suspension.offsetY += d; }},
        {"air.viscosity", 1e-9, [](Case& c, double d) { c.air.given.viscosity += d; }},
        {"air.pressure", 5.0, [](Case& c, double d) { c.air.given.pressure += d; }},
        {"disk.speed", 0.05, [](Case& c, double d) { c.disk.speed += d; }},
        {"disk.skew", 1e-5, [](Case& c, double d) { c.disk.skew += d; }},
    };
    return list;
}

/// On a grid that does not move with the case.
Case onUniformGrid()
{
    Case c = test::smallSlider(49);
    c.film.grid = GridKind::Uniform;
    c.steady.stiffness = false;
    c.film.tolerance = 1e-12;
    c.steady.loadTolerance = 1e-12;
    return c;
}

void TestSteady::sensitivitiesAgreeWithDifferences_data()
{
    QTest::addColumn<int>("index");
    for (std::size_t k = 0; k < changes().size(); ++k) QTest::newRow(changes()[k].parameter) << static_cast<int>(k);
}

void TestSteady::sensitivitiesAgreeWithDifferences()
{
    QFETCH(int, index);
    const Change& change = changes()[static_cast<std::size_t>(index)];
    static const SteadyResult reference = [] {
        Case c = onUniformGrid();
        c.steady.sensitivities = true;
        return steady(c);
    }();
    QCOMPARE(reference.status, SteadyStatus::Converged);
    const auto found = std::find_if(reference.sensitivities.begin(), reference.sensitivities.end(),
                                    [&](const Sensitivity& s) { return s.parameter == change.parameter; });
    QVERIFY(found != reference.sensitivities.end());
    std::array<SteadyResult, 2> sides;
    for (int side = 0; side < 2; ++side) {
        Case c = onUniformGrid();
        c.initial = {.nominalTrailingEdgeHeight = reference.attitude.height, .roll = reference.attitude.roll};
        c.initial.pitch = reference.attitude.pitch;
        change.add(c, side == 0 ? -change.step : change.step);
        sides[static_cast<std::size_t>(side)] = steady(c);
        QCOMPARE(sides[static_cast<std::size_t>(side)].status, SteadyStatus::Converged);
    }
    const auto difference = [&](auto get) { return (get(sides[1]) - get(sides[0])) / (2.0 * change.step); };
    const double height = difference([](const SteadyResult& r) { return r.attitude.height; });
    const double pitch = difference([](const SteadyResult& r) { return r.attitude.pitch; });
    const double roll = difference([](const SteadyResult& r) { return r.attitude.roll; });
    const double nearest = difference([](const SteadyResult& r) { return r.minimumSpacing; });
    // Against the size of the answer in heights over the slider.
    const double length = test::smallSlider().slider.length;
    const double size = std::abs(height) + length * (std::abs(pitch) + std::abs(roll));
    QVERIFY2(std::abs(found->height - height) < 1e-5 * size,
             qPrintable(QString("%1 %2").arg(found->height).arg(height)));
    QVERIFY2(length * std::abs(found->pitch - pitch) < 1e-5 * size,
             qPrintable(QString("%1 %2").arg(found->pitch).arg(pitch)));
    QVERIFY2(length * std::abs(found->roll - roll) < 1e-5 * size,
             qPrintable(QString("%1 %2").arg(found->roll).arg(roll)));
    QVERIFY2(std::abs(found->minimumSpacing - nearest) < 1e-4 * (size + std::abs(nearest)),
             qPrintable(QString("%1 %2").arg(found->minimumSpacing).arg(nearest)));
}

void TestSteady::mirroredSlidersRollTheOtherWay()
{
    // The rails are symmetric; with a uniform disk velocity, the other skew mirrors the whole problem.
    Case c = test::smallSlider();
    c.film.grid = GridKind::Uniform;   // the others may sort lines a little differently from the other side
    for (Rail& rail : c.surface.rails) // off the grid's lines: an edge on a line belongs to one side
        for (RailPoint& point : rail.points) point.y += point.y < 0.4e-3 ? 1.3e-6 : -1.3e-6;
    c.disk.field = VelocityField::Uniform;
    c.disk.skew = 0.1;
    const SteadyResult one = steady(c);
    c.disk.skew = -0.1;
    const SteadyResult other = steady(c);
    QVERIFY(std::abs(one.attitude.roll) > 1e-8);
    QVERIFY2(std::abs(one.attitude.roll + other.attitude.roll) < 1e-6 * std::abs(one.attitude.roll),
             qPrintable(QString("%1 and %2 rad").arg(one.attitude.roll).arg(other.attitude.roll)));
    QVERIFY(std::abs(one.attitude.pitch - other.attitude.pitch) < 1e-8 * one.attitude.pitch);
    QVERIFY(std::abs(one.minimumSpacing - other.minimumSpacing) < 1e-7 * one.minimumSpacing);
}

void TestSteady::progressNamesTheGrids()
{
    std::set<std::string> stages;
    steady(test::smallSlider(97), [&](const SteadyProgress& p) {
        stages.insert(p.stage);
        return true;
    });
    QCOMPARE(stages, (std::set<std::string>{"grid 49 x 49", "grid 97 x 97"}));
}

void TestSteady::cancelling()
{
    int calls = 0;
    const SteadyResult r = steady(test::smallSlider(), [&](const SteadyProgress&) { return ++calls < 4; });
    QCOMPARE(r.status, SteadyStatus::Cancelled);
    QVERIFY(!r.message.empty());
    QCOMPARE(calls, 4);
}

void TestSteady::notConverging()
{
    Case c = test::smallSlider(49);
    c.film.maximumIterations = 3;
    c.suspension.preload = 100.0; // no air bearing of this size carries that
    const SteadyResult r = steady(c);
    QCOMPARE(r.status, SteadyStatus::NotConverged);
    QVERIFY(QString::fromStdString(r.message).startsWith("no flying attitude was found: the film's pressure"));
    QVERIFY(std::isfinite(r.minimumSpacing) && std::isfinite(r.forces.net));
    Case fixed = test::smallSlider(49);
    fixed.steady.fixedAttitude = true;
    fixed.film.maximumIterations = 1;
    const SteadyResult film = steady(fixed);
    QCOMPARE(film.status, SteadyStatus::NotConverged);
    QVERIFY(QString::fromStdString(film.message).contains("remain after 1 iterations"));
}

void TestSteady::aLoadThatOnlyContactCarries()
{
    Case c = test::smallSlider(33);
    c.film.grid = GridKind::Uniform;
    c.suspension.preload = 30.0;
    const SteadyResult r = steady(c);
    QCOMPARE(r.status, SteadyStatus::NotConverged);
    const QString message = QString::fromStdString(r.message);
    QVERIFY2(message.startsWith("no flying attitude was found: ") &&
                 message.contains("the last attitude with rails above the disk was: "),
             qPrintable(message));
    // The state is that of the words: above the disk, with its own pressure, and the film carries far too little.
    QVERIFY(r.minimumSpacing >= 0.1e-9 && r.minimumSpacing < 20e-9);
    QVERIFY(r.forces.net > 0.0 && r.forces.net < 0.5 * c.suspension.preload);
    QVERIFY(!r.pressure.empty() && !r.stiffness);
    Case there = c;
    there.steady.fixedAttitude = true;
    there.initial = {.nominalTrailingEdgeHeight = r.attitude.height, .roll = r.attitude.roll};
    there.initial.pitch = r.attitude.pitch;
    there.film.nodes = {r.grid.nx() + 1, r.grid.ny() + 1};
    const SteadyResult again = steady(there);
    QCOMPARE(again.status, SteadyStatus::Converged);
    // A coarse grid's film is solved to 1e-4.
    QVERIFY2(std::abs(again.forces.net - r.forces.net) < 1e-2 * r.forces.net,
             qPrintable(QString("%1 and %2 N").arg(again.forces.net).arg(r.forces.net)));
}

void TestSteady::railsInsideTheDisk()
{
    Case c = test::smallSlider(33);
    c.steady.fixedAttitude = true;
    // The form dips below the corners' plane: 10 nm of crown, 3 nm of camber; the pad ends 0.03 mm before the edge.
    c.initial.nominalTrailingEdgeHeight = -10e-9;
    const SteadyResult refused = steady(c);
    QCOMPARE(refused.status, SteadyStatus::Failed);
    QVERIFY(refused.pressure.empty() && refused.grid.x.empty() && !refused.balanced());
    QVERIFY(refused.minimumSpacing < 0.0);
    QVERIFY(QString::fromStdString(refused.message).contains("inside the disk"));
    // Just above, it is a film like others.
    c.initial.nominalTrailingEdgeHeight -= refused.minimumSpacing - 1e-9;
    const SteadyResult above = steady(c);
    QCOMPARE(above.status, SteadyStatus::Converged);
    QVERIFY(above.message.empty() && std::abs(above.minimumSpacing - 1e-9) < 1e-15);
    // With a contact law the film around the closed gap is solved.
    c.contact = ContactKind::OnoYamane;
    c.initial.nominalTrailingEdgeHeight -= 1.2e-9;
    const SteadyResult closed = steady(c);
    QVERIFY(!closed.pressure.empty());
    QVERIFY(QString::fromStdString(closed.message).contains("0.2 nm below"));
}

void TestSteady::aDiskAtRest()
{
    Case c = test::smallSlider(33);
    c.disk.speed = 0.0;
    const SteadyResult r = steady(c);
    QCOMPARE(r.status, SteadyStatus::Failed);
    QCOMPARE(r.solves, 0);
    QVERIFY(QString::fromStdString(r.message).contains("disk at rest"));
}

void TestSteady::noPreload()
{
    // Suction in the cavity balances the pads' pressure: a slider of this kind flies without a preload, too.
    Case c = test::smallSlider();
    const SteadyResult loaded = steady(c);
    c.suspension.preload = 0.0;
    const SteadyResult r = steady(c);
    QCOMPARE(r.status, SteadyStatus::Converged);
    QVERIFY(r.forces.positive > 1e-3);
    QVERIFY(std::abs(r.forces.net) < 1e-6 * r.forces.positive);
    QVERIFY(r.minimumSpacing > loaded.minimumSpacing);
}

void TestSteady::theErrorOfASingleGridIsUnknown()
{
    const SteadyResult one = steady(test::smallSlider(34)); // 33 cells have no half
    QCOMPARE(one.status, SteadyStatus::Converged);
    const DiscretisationError& error = one.discretisationError;
    for (const double each : {error.minimumSpacing, error.pitch, error.roll, error.load}) QVERIFY(std::isnan(each));
    const DiscretisationError two = steady(test::smallSlider(33)).discretisationError;
    for (const double each : {two.minimumSpacing, two.pitch, two.roll, two.load}) QVERIFY(std::isfinite(each));
}

TOUCHDOWN_TEST(TestSteady)

} // namespace test_steady

#include "test_steady.moc"

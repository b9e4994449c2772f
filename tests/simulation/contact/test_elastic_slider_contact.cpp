// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/contact/elastic_slider_contact.h"

#include <cmath>
#include <numeric>

#include <QTest>

#include "core/case/contact_kind.h"
#include "core/case/parameters.h"
#include "core/physics/contact/adhesion_kind.h"
#include "core/simulation/contact/elastic_pad.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_elastic_slider_contact {

constexpr double length = 1.25e-3, width = 1.0e-3;
constexpr double pitch = 150e-6;

Rail rail(double x0, double x1, double y0, double y1)
{
    return {RailKind::Step, {{x0, y0, 0}, {x1, y0, 0}, {x1, y1, 0}, {x0, y1, 0}}, {0.0}};
}

/// A trailing pad of 12 x 8 um, away from the middle; the rest is 1 um higher.
Case withPad()
{
    Case c = defaultsOf(ModelKind::Film);
    c.contact = ContactKind::Elastic;
    c.surface.baseRecess = 1e-6;
    c.surface.rails = {rail(1.200e-3, 1.212e-3, 0.300e-3, 0.308e-3)};
    c.elastic.cell = 0.5e-6;
    c.elastic.patchPitch = pitch;
    c.elastic.patchReach = 5e-9;
    c.elastic.tolerance = 1e-13; // under the slider 1e-9
    return c;
}

/// Rough along and across; its map repeats after 64 um.
Case withRoughDisk(bool adhesion)
{
    Case c = withPad();
    c.diskSurface.kind = DiskSurfaceKind::Rough;
    c.diskSurface.cell = 0.5e-6;
    c.diskSurface.correlationLength = 3e-6;
    c.diskSurface.track = 64e-6;
    if (adhesion) c.adhesion.kind = AdhesionKind::LennardJones;
    return c;
}

CellGrid filmGrid()
{
    return {{0.0, 1.0e-3, 1.203e-3, 1.2091e-3, 1.22e-3, length}, {0.0, 0.29e-3, 0.3035e-3, 0.31e-3, width}};
}

/// All that a contact on a slider looks at.
struct Scene {
    explicit Scene(const Case& c)
        : recess(c.surface, length, width),
          spacing(c.surface, recess),
          surface(c.diskSurface),
          grid(filmGrid()),
          contact(c, spacing, surface, grid, pad, {})
    {}
    Recess recess;
    MinimumSpacing spacing;
    DiskTopography surface;
    CellGrid grid;
    PaddedGrid pad{5, 4};
    ElasticSliderContact contact;
};

/// The pad's trailing edge at `spacing`.
Attitude at(double spacing, double roll = 0.0)
{
    return {spacing - pitch * (length - 1.212e-3) + roll * (0.304e-3 - 0.5 * width), pitch, roll};
}

bool near(double a, double b, double tolerance)
{
    return std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b));
}

class TestElasticSliderContact : public QObject {
    Q_OBJECT

private slots:
    /// The model "contact" holds the same pad at the same separation of its lowest point, which it takes 1e-10 m beside
    /// the edge: at 150 urad 1.5e-14 m deeper, where a stiffness of some 5e5 N/m makes of it 1e-8 N.
    void carriesWhatThePadAloneCarries_data()
    {
        QTest::addColumn<bool>("adhesion");
        QTest::newRow("contact alone") << false;
        QTest::newRow("with adhesion") << true;
    }
    void carriesWhatThePadAloneCarries()
    {
        QFETCH(bool, adhesion);
        Case c = withRoughDisk(adhesion);
        c.diskSurface.motion = SurfaceMotion::Still;
        Scene scene(c);
        Case pad = c;
        pad.model = ModelKind::Contact;
        pad.pad.shape = PadShape::Slider;
        pad.initial.pitch = pitch;
        pad.elastic.tolerance = 1e-9;
        pad.approach = {.start = 5e-9, .closest = -1e-9};
        const ContactForces alone = ElasticPad(pad).move(-0.5e-9, 0.0);
        const SliderContactForces& under = scene.contact.at(at(-0.5e-9), 0.0);
        QCOMPARE(alone.problem, std::string());
        QCOMPARE(under.problem, std::string());
        QVERIFY(under.contact > 1e-6);
        QVERIFY(std::abs(under.contact - alone.contact) < 1e-8);
        QVERIFY(near(under.area, alone.area, 1e-9));
        QVERIFY(near(under.peakPressure, alone.peakPressure, 1e-4));
        QVERIFY(std::abs(under.adhesion - alone.adhesion) < 1e-8);
        QCOMPARE(under.adhesion < 0.0, adhesion);
    }
    /// The torques are those of the pressures that the fields show, and of friction at the patch.
    void torquesAreThoseOfThePressures()
    {
        Scene scene(withRoughDisk(true));
        const SliderContactForces& f = scene.contact.at(at(-0.3e-9, 20e-6), 1e-6);
        FieldSnapshot snapshot;
        scene.contact.observe(snapshot);
        const RecordedFields fields = sliderContactFields(withRoughDisk(true));
        QCOMPARE(snapshot.values.size(), fields.quantities.size());
        double pitchTorque = 0.0, rollTorque = 0.0, net = 0.0;
        std::size_t cell = 0;
        for (int j = 0; j < fields.grid.ny(); ++j)
            for (int i = 0; i < fields.grid.nx(); ++i, ++cell) {
                const double force = (snapshot.values[1][cell] + snapshot.values[2][cell]) * fields.grid.widthX(i) *
                                     fields.grid.widthY(j);
                net += force;
                pitchTorque += force * (0.5 * length - fields.grid.centreX(i));
                rollTorque += force * (0.5 * width - fields.grid.centreY(j));
            }
        QVERIFY(f.contact > 0.0 && f.friction > 0.0);
        QVERIFY(near(net, f.contact + f.adhesion, 1e-9));
        QVERIFY(near(f.friction, 0.3 * f.contact, 1e-9));
        // The disk runs nearly along x: to 1 - cos(1/40) and 1/40.
        QVERIFY(near(f.pitchTorque - pitchTorque, -0.15e-3 * f.friction, 1e-3));
        QVERIFY(near(f.rollTorque - rollTorque, 0.15e-3 * f.friction * (1.206e-3 - 0.5 * length) / (23e-3 - 0.196e-3),
                     0.02));
    }
    /// Whatever was tried in between, a state goes on from the one that was accepted.
    void triesLeaveNoTrace_data() { carriesWhatThePadAloneCarries_data(); }
    void triesLeaveNoTrace()
    {
        QFETCH(bool, adhesion);
        Scene straight(withRoughDisk(adhesion)), tried(withRoughDisk(adhesion));
        for (Scene* scene : {&straight, &tried}) {
            scene->contact.at(at(1.0e-9), 0.0);
            scene->contact.accept();
        }
        tried.contact.at(at(-2e-9), 20e-9); // pressed in, where adhesion would hold more than it does from above
        tried.contact.at(at(0.7e-9), 30e-9);
        const SliderContactForces a = straight.contact.at(at(0.9e-9), 40e-9), b = tried.contact.at(at(0.9e-9), 40e-9);
        QCOMPARE(a.problem, std::string());
        QVERIFY(near(a.load()[0], b.load()[0], 1e-6));
        QVERIFY(near(a.pitchTorque, b.pitchTorque, 1e-6));
        QCOMPARE(a.area, b.area);
    }
    /// After a whole track the same surface lies under the slider.
    void theSurfaceReturns()
    {
        Case c = withRoughDisk(false);
        Scene scene(c);
        const double speed = c.disk.speed * c.disk.radius;
        const SliderContactForces first = scene.contact.at(at(-0.5e-9), 0.0);
        const SliderContactForces half = scene.contact.at(at(-0.5e-9), 0.5 * c.diskSurface.track / speed);
        const SliderContactForces whole = scene.contact.at(at(-0.5e-9), c.diskSurface.track / speed);
        QVERIFY(near(first.contact, whole.contact, 1e-6));
        QVERIFY(!near(first.contact, half.contact, 1e-2));
    }
    /// Where it says that nothing acts, nothing does: the attraction left out is below 1e-5 of the preload.
    void isOutOfReachOnlyWhereNothingActs_data() { carriesWhatThePadAloneCarries_data(); }
    void isOutOfReachOnlyWhereNothingActs()
    {
        QFETCH(bool, adhesion);
        const Case c = withRoughDisk(adhesion);
        Scene scene(c);
        int far = 0, near = 0;
        for (double spacing = 0.0; spacing < 60e-9; spacing += 0.25e-9) {
            const bool out = scene.contact.outOfReach(at(spacing));
            const SliderContactForces& f = scene.contact.at(at(spacing), 0.0);
            (out ? far : near) += 1;
            if (out)
                QVERIFY(f.contact == 0.0 && f.adhesion == 0.0 && f.pitchTorque == 0.0);
            else if (adhesion && spacing > 20e-9)
                QVERIFY(-f.adhesion < 1e-4 * c.suspension.preload);
        }
        QVERIFY(far > 0 && near > 0);
    }
    /// What the contact presses out of the disk is taken off under the film: their volumes agree.
    void takesTheVolumeOffTheFilmsDisk()
    {
        Scene scene(withRoughDisk(true));
        scene.contact.at(at(-0.5e-9), 0.0);
        std::vector<double> height(scene.pad.size(), 0.0);
        QVERIFY(scene.contact.deform(height));
        double volume = 0.0;
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 5; ++i)
                volume -= height[scene.pad.at(i, j)] * scene.grid.widthX(i) * scene.grid.widthY(j);
        FieldSnapshot snapshot;
        scene.contact.observe(snapshot);
        const RecordedFields fields = sliderContactFields(withRoughDisk(true));
        const Attitude attitude = at(-0.5e-9);
        double pressed = 0.0;
        std::size_t cell = 0;
        for (int j = 0; j < fields.grid.ny(); ++j)
            for (int i = 0; i < fields.grid.nx(); ++i, ++cell) {
                const double x = fields.grid.centreX(i), y = fields.grid.centreY(j);
                const double separation =
                    attitude.height + attitude.pitch * (length - x) + scene.recess.at(x, y) - snapshot.values[3][cell];
                pressed += (snapshot.values[0][cell] - separation) * fields.grid.widthX(i) * fields.grid.widthY(j);
            }
        QVERIFY(pressed != 0.0);
        QVERIFY(near(volume, pressed, 1e-9));
        scene.contact.at(at(200e-9), 0.0);
        QVERIFY(!scene.contact.deform(height));
    }
    /// Film cells that hold a touching cell of the patch, and no others.
    void knowsWhereItTouches()
    {
        const Case c = withRoughDisk(false);
        Scene scene(c);
        scene.contact.at(at(-0.5e-9), 0.0);
        std::vector<double> field(scene.pad.size(), 1.0), expected(scene.pad.size(), 1.0);
        scene.contact.clearTouching(field);
        FieldSnapshot snapshot;
        scene.contact.observe(snapshot);
        const RecordedFields fields = sliderContactFields(c);
        std::size_t cell = 0;
        int touching = 0;
        for (int j = 0; j < fields.grid.ny(); ++j)
            for (int i = 0; i < fields.grid.nx(); ++i, ++cell) {
                if (!(snapshot.values[1][cell] > 0.0)) continue;
                ++touching;
                for (int l = 0; l < 4; ++l)
                    for (int k = 0; k < 5; ++k)
                        if (scene.grid.x[std::size_t(k)] < fields.grid.x[std::size_t(i) + 1] &&
                            scene.grid.x[std::size_t(k) + 1] > fields.grid.x[std::size_t(i)] &&
                            scene.grid.y[std::size_t(l)] < fields.grid.y[std::size_t(j) + 1] &&
                            scene.grid.y[std::size_t(l) + 1] > fields.grid.y[std::size_t(j)])
                            expected[scene.pad.at(k, l)] = 0.0;
            }
        QVERIFY(touching > 0);
        QVERIFY(std::ranges::count(expected, 1.0) > 0);
        QCOMPARE(field, expected);
    }
    void namesWhereNothingIsModelled()
    {
        Case c = withPad();
        c.surface.rails.push_back(rail(0.1e-3, 0.2e-3, 0.4e-3, 0.6e-3)); // a leading pad
        Scene scene(c);
        QCOMPARE(scene.contact.problemAt(at(-1e-9)), std::string());
        QCOMPARE(scene.contact.problemAt({100e-9, -200e-6, 0.0}).substr(0, 16), std::string("The slider came "));
        const std::string problem = scene.contact.problemAt({100e-9, -200e-6, 0.0});
        QVERIFY(problem.find("x = 100") != std::string::npos &&
                problem.find("elastic.patch_pitch") != std::string::npos);
    }
    /// Neither side is a whole number of cells of 0.7 um, so the patch ends before the slider's far edges.
    void modelsAPadAtACornerOfTheSlider()
    {
        for (const bool leading : {true, false})
            for (const bool inner : {true, false}) {
                Case c = withPad();
                const double x = leading ? 0.0 : length - 12e-6, y = inner ? 0.0 : width - 8e-6;
                c.surface.rails = {rail(x, x + 12e-6, y, y + 8e-6)};
                c.elastic.cell = 0.7e-6;
                c.elastic.patchPitch = leading ? -pitch : pitch;
                const Scene scene(c);
                Attitude attitude{0.0, c.elastic.patchPitch, inner ? -1e-6 : 1e-6};
                attitude.height = -1e-9 - scene.spacing.at(attitude).spacing;
                QCOMPARE(scene.contact.problemAt(attitude), std::string());
            }
    }
    /// A wave of 20 um at 13.006 m/s changes by as much as its RMS height over 20 um/(2 pi) = 3.183 um; twice that
    /// takes 489.5 ns.
    void followsAMovingSurface()
    {
        Case c = withPad();
        QVERIFY(!std::isfinite(Scene(c).contact.longestStep()));
        c.diskSurface.kind = DiskSurfaceKind::Waves;
        c.diskSurface.waveAmplitudes = {1e-9};
        c.diskSurface.waveLengths = {20e-6};
        QVERIFY(near(Scene(c).contact.longestStep(), 489.5e-9, 0.01));
        c.diskSurface.motion = SurfaceMotion::Still;
        QVERIFY(!std::isfinite(Scene(c).contact.longestStep()));
    }
    /// With the default tolerance, over a hundred steps in and out of contact, each accepted, as with one ten thousand
    /// times tighter.
    void aLooseToleranceFollowsTheSameWay()
    {
        Case c = withRoughDisk(true);
        Scene tight(c);
        c.elastic.tolerance = ElasticCase{}.tolerance;
        Scene loose(c);
        int pressed = 0;
        for (int k = 0; k < 100; ++k) {
            const Attitude attitude = at(2e-9 + 2.5e-9 * std::cos(0.15 * k));
            const double time = k * 20e-9;
            const SliderContactForces &a = tight.contact.at(attitude, time), &b = loose.contact.at(attitude, time);
            QCOMPARE(b.problem, std::string());
            // 1e-4 of the largest attraction, 0.17 GPa, over the patch of some 170 um^2 is 3 uN.
            QVERIFY2(std::abs(a.load()[0] - b.load()[0]) < 3e-6,
                     qPrintable(QString("step %1: %2 and %3 N").arg(k).arg(a.load()[0]).arg(b.load()[0])));
            pressed += a.contact > 0.0;
            tight.contact.accept();
            loose.contact.accept();
        }
        QVERIFY(pressed > 20 && pressed < 90);
    }
    void doubts_data() { carriesWhatThePadAloneCarries_data(); }
    /// The accepted state of the largest force counts; its stated error covers what half of the cells changes.
    void doubts()
    {
        QFETCH(bool, adhesion);
        Case c = withRoughDisk(adhesion);
        c.diskSurface.motion = SurfaceMotion::Still;
        Scene scene(c);
        QVERIFY(!scene.contact.doubts({}).of.grid);
        const Attitude hardest = at(-0.5e-9);
        const double force = scene.contact.at(hardest, 0.0).contact;
        scene.contact.at(at(-2e-9), 0.0); // a try that is not accepted
        scene.contact.at(hardest, 0.0);
        scene.contact.accept();
        scene.contact.at(at(0.2e-9), 0.0);
        scene.contact.accept();
        const SliderContact::Doubts doubts = scene.contact.doubts({});
        QVERIFY(doubts.of.grid && doubts.of.grid->known);
        QVERIFY(!doubts.of.cutOff);
        QVERIFY(near(doubts.contact, force, 1e-3));
        c.elastic.cell *= 0.5;
        Scene finer(c);
        const double change = std::abs(finer.contact.at(hardest, 0.0).contact - force);
        QVERIFY2(doubts.of.grid->force >= change && doubts.of.grid->force < 0.5 * force,
                 qPrintable(QString("%1 %2 %3").arg(doubts.of.grid->force).arg(change).arg(force)));
    }
    /// A pitch at which the pad touches with its leading edge, not within reach at elastic.patch_pitch, cuts the patch.
    void cutOff()
    {
        Case c = withPad();
        c.elastic.patchReach = 0.5e-9; // 3 um of the pad
        Scene scene(c);
        Attitude flat = at(0.0);
        flat.pitch = 0.0;
        flat.height = -1e-9;
        scene.contact.at(flat, 0.0);
        scene.contact.accept();
        QVERIFY(scene.contact.doubts({}).of.cutOff);
    }
    /// A pressed pad is about as stiff as the change of its force over a tenth of a nanometre.
    void stiffnessLeads()
    {
        Scene scene(withPad());
        const double force = scene.contact.at(at(-2e-9), 0.0).contact;
        const double stiffness = scene.contact.stiffness()(0, 0);
        const double deeper = scene.contact.at(at(-2.1e-9), 0.0).contact;
        QVERIFY(near(stiffness, (deeper - force) / 0.1e-9, 0.5));
    }
};

TOUCHDOWN_TEST(TestElasticSliderContact)

} // namespace test_elastic_slider_contact

#include "test_elastic_slider_contact.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/springs/spring_model.h"

#include <cmath>
#include <numbers>
#include <random>

#include <QTest>

#include "core/numerics/adaptive.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_spring_model {

using State = SpringModel::State;
using Mode = SpringModel::Mode;

/// Equations (1)-(4) with the signs of the pad and friction moments, written down a second time without any
/// rearrangement.
State secondOpinion(const Case& c, const State& y, bool front, bool rear, double contact, double adhesion)
{
    const double z0 = c.springs.flyingHeight + c.springs.padDistance * c.springs.pitch;
    const auto spring = [&](double k0, double spacing0, double spacing, bool carries) {
        return carries ? k0 * spacing0 * spacing0 / (spacing * spacing) * (spacing0 - spacing) : 0.0;
    };
    const double df = c.springs.frontDistance;
    const double dr = c.springs.rearDistance;
    const double dh = c.springs.padDistance;
    const double cf = 2 * c.springs.frontDampingRatio * std::sqrt(c.slider.mass * c.springs.frontStiffness);
    const double cr = 2 * c.springs.rearDampingRatio * std::sqrt(c.slider.mass * c.springs.rearStiffness);
    const double cz = 2 * c.suspension.dampingRatio * std::sqrt(c.slider.mass * c.suspension.stiffness);
    const double ct =
        2 * c.suspension.pitchDampingRatio * std::sqrt(c.slider.pitchInertia * c.suspension.pitchStiffness);
    const double ff =
        spring(c.springs.frontStiffness, z0 + df * c.springs.pitch, y[0] + df * y[1], front) - cf * (y[2] + df * y[3]);
    const double fr =
        spring(c.springs.rearStiffness, z0 - dr * c.springs.pitch, y[0] - dr * y[1], rear) - cr * (y[2] - dr * y[3]);
    const double force = ff + fr + contact + adhesion - c.suspension.stiffness * (y[0] - z0) - cz * y[2];
    const double moment = df * ff - dr * fr - dh * (contact + adhesion) -
                          0.5 * c.slider.thickness * c.onoYamane.friction * contact -
                          c.suspension.pitchStiffness * (y[1] - c.springs.pitch) - ct * y[3];
    return {y[2], y[3], force / c.slider.mass, moment / c.slider.pitchInertia};
}

/// To round-off of the largest terms: accelerations in contact are of the order of 1e4 m/s^2 and 1e8 rad/s^2.
bool agree(const State& a, const State& b)
{
    const State allowed = 1e-11 * (b.cwiseAbs() + State(0.0, 0.0, 1e4, 1e8));
    return ((a - b).cwiseAbs().array() <= allowed.array()).all();
}

/// States all over the range that a run sees.
State randomState(std::mt19937& random)
{
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    return {100e-9 + 80e-9 * unit(random), 100e-6 + 60e-6 * unit(random), 0.1 * unit(random), 200.0 * unit(random)};
}

/// The work that an integrator's steps see.
struct Ledger {
    const SpringModel& model;
    double work = 0.0;
    double begin = 0.0;
    State last;
    template <class At>
    bool step(double t, const State& y, Mode mode, At&& at)
    {
        const State before = begin == t ? y : at(begin);
        work += (t - begin) / 6.0 *
                (model.power(before, mode) + 4.0 * model.power(at(0.5 * (begin + t)), mode) + model.power(y, mode));
        begin = t;
        last = y;
        return true;
    }
    void event(double, int, bool, Mode, Mode) { ++events; }
    int events = 0;
};

constexpr std::array<ContactRegion, 4> allRegions{ContactRegion::Apart, ContactRegion::Pressed, ContactRegion::Lifting,
                                                  ContactRegion::Bridged};

class TestSpringModel : public QObject {
    Q_OBJECT

private slots:
    void equationsOfMotion()
    {
        Case c;
        c.onoYamane.friction = 0.7;
        c.onoYamane.takeOffShape = TakeOffShape::Linear;
        const SpringModel model(c);
        const OnoYamaneLaw law(c.onoYamane);
        std::mt19937 random(1);
        for (int i = 0; i < 200; ++i) {
            const State y = randomState(random);
            for (const ContactRegion region : allRegions) {
                const Mode mode{i % 2 == 0, i % 3 != 0, region};
                const double d = y[0] - c.springs.padDistance * y[1];
                const State expected = secondOpinion(c, y, mode.frontSpring, mode.rearSpring,
                                                     law.contactForce(region, d), law.adhesionForce(region, d));
                const State got = model.derivative(y, mode);
                QVERIFY(agree(got, expected));
            }
        }
    }

    void staticStateIsAnEquilibrium()
    {
        const SpringModel model{Case{}};
        const State rate = model.derivative(model.staticState(), Mode{});
        QCOMPARE(rate[2], 0.0);
        QCOMPARE(rate[3], 0.0);
        QCOMPARE(model.energy(model.staticState()), 0.0);
        QCOMPARE(model.guards(model.staticState().head<2>())[SpringModel::Pad], 7e-9);
        // z_f0 = 7 + (0.575 + 0.550) 90.6 nm = 108.925 nm, z_r0 = 7 + (0.575 - 0.545) 90.6 nm = 9.718 nm
        QVERIFY(std::abs(model.guards(model.staticState().head<2>())[SpringModel::Front] - 108.925e-9) < 1e-22);
        QVERIFY(std::abs(model.guards(model.staticState().head<2>())[SpringModel::Rear] - 9.718e-9) < 1e-22);
    }

    void jacobianFollowsDifferences()
    {
        const SpringModel model{Case{}};
        std::mt19937 random(2);
        for (int i = 0; i < 50; ++i) {
            const State y = randomState(random);
            const Mode mode{true, i % 3 != 0, allRegions[std::size_t(i) % 4]};
            const auto jacobian = model.jacobian(y, mode);
            for (int k = 0; k < 4; ++k) {
                State step = State::Zero();
                step[k] = 1e-5 * model.scale()[k];
                const Eigen::Vector2d difference =
                    (model.derivative(y + step, mode) - model.derivative(y - step, mode)).tail<2>() / (2.0 * step[k]);
                for (int row = 0; row < 2; ++row) {
                    const double size =
                        jacobian.row(row).cwiseAbs().cwiseProduct(model.scale().transpose()).maxCoeff() /
                        model.scale()[k];
                    QVERIFY(std::abs(jacobian(row, k) - difference[row]) < 1e-6 * size);
                }
            }
        }
    }

    /// dE/dt along the motion equals the power of dashpots, contact and friction, at any state and in any mode.
    void energyBalanceAtAPoint()
    {
        Case c;
        c.onoYamane.friction = 2.0;
        const SpringModel model(c);
        std::mt19937 random(3);
        for (int i = 0; i < 200; ++i) {
            const State y = randomState(random);
            const Mode mode{true, true, allRegions[std::size_t(i) % 4]};
            if (model.guards(y.head<2>())[SpringModel::Rear] < 1e-9) continue;
            const State rate = model.derivative(y, mode);
            const double step = 1e-12;
            const double change = (model.energy(y + step * rate) - model.energy(y - step * rate)) / (2.0 * step);
            const double power = model.power(y, mode);
            QVERIFY2(std::abs(change - power) <
                         1e-6 * (std::abs(power) + std::abs(rate[2] * y[2]) * c.slider.mass + 1e-6),
                     qPrintable(QStringLiteral("%1 %2").arg(change).arg(power)));
        }
    }

    /// Over a whole bouncing run: E(end) - E(0) = work of dashpots, contact and friction, by Simpson's rule along the
    /// dense output.
    void energyBalanceOverARun()
    {
        Case c;
        c.onoYamane.takeOff = 8e-9; // ends in contact, after more than a hundred switches
        const SpringModel model(c);
        Ledger ledger{.model = model, .work = 0.0, .begin = 0.0, .last = model.initialState(), .events = 0};
        const auto result = integrateAdaptive(model, Start<SpringModel>{model.initialState(), model.initialMode()},
                                              0.5e-3, {.tolerance = 1e-10, .firstStep = 1e-9}, ledger);
        QCOMPARE(result.end, IntegrationEnd::Reached);
        QVERIFY(ledger.events > 20);
        const double start = model.energy(model.initialState());
        QVERIFY2(std::abs(model.energy(ledger.last) - start - ledger.work) < 1e-8 * start,
                 qPrintable(QString::number((model.energy(ledger.last) - start - ledger.work) / start)));
    }

    void modesAndGuards()
    {
        const SpringModel model{Case{}};
        const Mode free = model.initialMode();
        QCOMPARE(free, (Mode{true, true, ContactRegion::Apart}));
        QCOMPARE(model.beyond(free, SpringModel::Pad, false).contact, ContactRegion::Pressed);
        QCOMPARE(model.beyond(free, SpringModel::Rear, false), (Mode{true, false, ContactRegion::Apart}));
        QCOMPARE(model.interval(SpringModel::Rear, free).lower, 0.3e-9);
        QCOMPARE(model.interval(SpringModel::Rear, Mode{true, false, ContactRegion::Apart}).upper, 0.3e-9);
        QCOMPARE(model.eventName(SpringModel::Pad, free, Mode{true, true, ContactRegion::Pressed}),
                 std::string("touch-down"));
        QCOMPARE(model.eventName(SpringModel::Rear, free, Mode{true, false, ContactRegion::Apart}),
                 std::string("rear spring lost"));
        QCOMPARE(model.eventName(SpringModel::Pad, Mode{true, true, ContactRegion::Bridged}, free),
                 std::string("take-off"));
    }

    /// Several guards may go in one step of the naive method: each has its own name.
    void eachGuardNamesItsOwnSwitch()
    {
        const SpringModel model{Case{}};
        const Mode after{false, false, ContactRegion::Pressed};
        QCOMPARE(model.eventName(SpringModel::Pad, Mode{}, after), std::string("touch-down"));
        QCOMPARE(model.eventName(SpringModel::Front, Mode{}, after), std::string("front spring lost"));
        QCOMPARE(model.eventName(SpringModel::Rear, Mode{}, after), std::string("rear spring lost"));
    }

    /// The size of a pitch is that of its effect at the farthest place, on whichever side that is.
    void scaleKnowsAPadInFront()
    {
        Case c;
        c.springs.padDistance = 0.8e-3;
        const double behind = SpringModel(c).scale()[1];
        c.springs.padDistance = -0.8e-3;
        QCOMPARE(SpringModel(c).scale()[1], behind);
        QVERIFY(std::abs(behind - 7e-9 / 0.8e-3) < 1e-18);
    }

    /// Near the wall an air spring is far stiffer than at rest: -dF/dz = k_0 z_0^2 (2 z_0 - z)/z^3.
    void periodNearTheWall()
    {
        Case c;
        c.contact = noContact;
        c.springs.frontStiffness = 0.0;
        c.springs.rearDistance = c.springs.padDistance = 0.0;
        c.springs.flyingHeight = 100e-9;
        c.suspension.stiffness = c.suspension.pitchStiffness = 0.0;
        const SpringModel model(c);
        const double k = 1.48e6;
        const double atRest = 2.0 * std::numbers::pi * std::sqrt(1.6e-6 / k);
        QVERIFY(std::abs(model.shortestPeriod() / atRest - 1.0) < 1e-12);
        const State near{1e-9, c.springs.pitch, 0.0, 0.0};
        const double stiffness = k * 100e-9 * 100e-9 * 199e-9 / 1e-27;
        QVERIFY(std::abs(model.period(near, model.initialMode()) /
                             (2.0 * std::numbers::pi * std::sqrt(1.6e-6 / stiffness)) -
                         1.0) < 1e-12);
        QVERIFY(std::abs(model.period(State{1e-6, c.springs.pitch, 0.0, 0.0}, model.initialMode()) / atRest - 1.0) <
                1e-12);
    }

    void initialBranchIsTheUsersChoice()
    {
        Case c;
        c.initial.flyingHeight = 4.5e-9;
        c.initial.pitch = c.springs.pitch;
        QCOMPARE(SpringModel(c).initialMode().contact, ContactRegion::Apart);
        c.initial.branch = ContactBranch::TakeOff;
        QCOMPARE(SpringModel(c).initialMode().contact, ContactRegion::Bridged);
        c.initial.flyingHeight = 2e-9;
        c.initial.branch = ContactBranch::TouchDown;
        QCOMPARE(SpringModel(c).initialMode().contact, ContactRegion::Pressed);
        c.initial.flyingHeight = 6e-9;
        c.initial.branch = ContactBranch::TakeOff;
        QCOMPARE(SpringModel(c).initialMode().contact, ContactRegion::Apart);
    }

    /// The paper's way of switching chooses every law by the spacings, and keeps only the branch.
    void naiveLawsFollowTheSpacings()
    {
        const SpringModel model{Case{}};
        State y = model.staticState();
        y[0] -= 5e-9; // d = 2 nm, z_r = 4.25 nm
        QCOMPARE(model.naiveDerivative(y, Mode{}), model.derivative(y, Mode{true, true, ContactRegion::Pressed}));
        QCOMPARE(model.naiveMode(y, Mode{}), (Mode{true, true, ContactRegion::Pressed}));
        y[0] += 1.5e-9; // d = 3.5 nm
        QCOMPARE(model.naiveMode(y, Mode{}), Mode{});
        QCOMPARE(model.naiveMode(y, Mode{true, true, ContactRegion::Pressed}),
                 (Mode{true, true, ContactRegion::Lifting}));
        y[0] -= 10e-9; // z_r = -4.25 nm
        QVERIFY(!model.naiveMode(y, Mode{}).rearSpring);
    }

    void withoutContactThereIsNone()
    {
        Case c;
        c.contact = noContact;
        const SpringModel model(c);
        QVERIFY(std::isinf(model.interval(SpringModel::Pad, Mode{}).lower));
        State y = model.staticState();
        y[0] -= 6.5e-9;
        QVERIFY(agree(model.derivative(y, Mode{}), secondOpinion(c, y, true, true, 0.0, 0.0)));
        QCOMPARE(findQuantity(SpringModel::quantities(c), "contact_force"), -1);
    }

    void observedQuantitiesAreConsistent()
    {
        const Case c;
        const SpringModel model(c);
        const std::vector<Quantity> quantities = SpringModel::quantities(c);
        std::vector<double> values(quantities.size(), NAN);
        State y = model.staticState();
        y[0] -= 5e-9;
        y[2] = 0.02;
        const Mode mode{true, true, ContactRegion::Pressed};
        model.observe(y, mode, {}, values.data());
        const auto at = [&](const char* name) { return values[std::size_t(findQuantity(quantities, name))]; };
        for (const double value : values) QVERIFY(std::isfinite(value));
        QVERIFY(std::abs(at("flying_height") - 2e-9) < 1e-22);
        QVERIFY(std::abs(at("contact_force") - 10e-3) < 1e-14); // 5 mN + 5e6 N/m * 1 nm
        QCOMPARE(at("adhesion_force"), -10.7e-3);
        QCOMPARE(at("net_contact_force"), at("contact_force") + at("adhesion_force"));
        QCOMPARE(at("friction_force"), 0.8 * at("contact_force"));
        QCOMPARE(at("kinetic_energy"), 0.5 * 1.6e-6 * 0.02 * 0.02);
        QCOMPARE(at("energy"), at("kinetic_energy") + at("air_spring_energy") + at("suspension_energy"));
        QVERIFY(std::abs(at("energy") / model.energy(y) - 1.0) < 1e-14);
        // M z'' = air bearing + net contact - suspension
        const double force =
            at("air_bearing_force") + at("net_contact_force") + 6.0 * 5e-9 - 2 * 0.01 * std::sqrt(1.6e-6 * 6.0) * 0.02;
        QVERIFY(std::abs(force / (1.6e-6 * model.derivative(y, mode)[2]) - 1.0) < 1e-12);
    }
};

TOUCHDOWN_TEST(TestSpringModel)

} // namespace test_spring_model

#include "test_spring_model.moc"

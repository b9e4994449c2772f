// SPDX-License-Identifier: GPL-3.0-or-later
//
// The modes of a slider against its free decay in time: film and rigid body, step by step, with all their nonlinearity.
#include <QtTest>

#include <Eigen/Dense>

#include <cmath>
#include <complex>
#include <numbers>

#include "core/case_files/case_file.h"
#include "core/physics/film/film_step.h"
#include "core/simulation/static_state/film_setup.h"
#include "core/simulation/static_state/steady.h"
#include "tests/simulation/matrix_pencil.h"
#include "tests/support/free_oscillation.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_modes_decay {

using Complex = std::complex<double>;

constexpr int stepsPerPeriod = 24, ledSteps = 2 * stepsPerPeriod, freeSteps = 4 * stepsPerPeriod;

/// Motions are of the mass centre about rest: height [m], pitch, roll [rad].
class MovingSlider {
public:
    /// The film's stiffness is about the mass centre.
    MovingSlider(const Case& c, const SteadyResult& rest, const Matrix3& stiffness, double dt)
        : case_(c),
          rest_(rest.attitude),
          dt_(dt),
          recess_(c.surface, c.slider.length, c.slider.width),
          spacing_(c.surface, recess_),
          level_(c, recess_, spacing_, rest.grid),
          stepper_(level_.film,
                   {.method = FilmTimeMethod::Bdf2, .tolerance = 1e-10, .share = 0.02, .maximumIterations = 40}),
          stiffness_(stiffness)
    {
        level_.gaps.pad.pad<double>(rest.pressure, level_.pressure);
        level_.film.setAttitude(rest_);
        stepper_.start(level_.pressure);
        held_ = forces();
        inertia_ = {c.slider.mass, c.slider.pitchInertia, c.slider.rollInertia};
        spring_ = {c.suspension.stiffness, c.suspension.pitchStiffness, c.suspension.rollStiffness};
        damper_ = {c.suspension.damping, c.suspension.pitchDamping, c.suspension.rollDamping};
    }

    /// The slider is led along a motion; the film follows.
    bool lead(const Vector3& motion, const Vector3& velocity)
    {
        const bool converged = stepFilm(motion);
        accept(motion, velocity);
        return converged;
    }

    /// One step of BDF2 for film and slider together: (3 y - 4 y1 + y2)/(2 dt) = y'. The film's stiffness leads to the
    /// motion at which the forces balance.
    bool fly()
    {
        const double h = 2.0 / 3.0 * dt_;
        const Vector3 before = (4.0 * motion_[0] - motion_[1]) / 3.0;
        const Vector3 velocityBefore = (4.0 * velocity_[0] - velocity_[1]) / 3.0;
        const Matrix3 slopes = (inertia_ / (h * h) + damper_ / h + spring_).asDiagonal().toDenseMatrix() + stiffness_;
        Vector3 motion = 3.0 * motion_[0] - 3.0 * motion_[1] + motion_[2];
        for (int pass = 0; pass < 12; ++pass) {
            if (!stepFilm(motion)) return false;
            const Vector3 velocity = (motion - before) / h, acceleration = (velocity - velocityBefore) / h;
            const Vector3 imbalance = forces() - held_ - spring_.cwiseProduct(motion) - damper_.cwiseProduct(velocity) -
                                      inertia_.cwiseProduct(acceleration);
            const Vector3 change = slopes.partialPivLu().solve(imbalance);
            if (scaled(change).norm() < 1e-7 * scaled(motion).norm()) {
                accept(motion, velocity);
                return true;
            }
            motion += change;
        }
        return false;
    }

    /// As lengths: of the centre, of the leading edge, of a side [m].
    Vector3 scaled(const Vector3& motion) const
    {
        return motion.cwiseProduct(Vector3(1.0, 0.5 * case_.slider.length, 0.5 * case_.slider.width));
    }
    const Vector3& motion() const { return motion_[0]; }

private:
    Vector3 forces()
    {
        const std::array<double, 3> load = level_.loads.load(stepper_.pressure());
        const std::array<double, 2> shear = level_.loads.shear(stepper_.pressure());
        const double arm = sliderLoad(case_).shearArm;
        return {load[0], load[1] - arm * shear[0], load[2] - arm * shear[1]};
    }
    bool stepFilm(const Vector3& motion)
    {
        return stepper_
            .step(dt_, {rest_.height + motion[0] - 0.5 * case_.slider.length * motion[1], rest_.pitch + motion[1],
                        rest_.roll + motion[2]})
            .converged;
    }
    void accept(const Vector3& motion, const Vector3& velocity)
    {
        if (!stepper_.accept()) qFatal("a step that did not converge cannot be gone on from");
        motion_ = {motion, motion_[0], motion_[1]};
        velocity_ = {velocity, velocity_[0]};
    }

    const Case& case_;
    Attitude rest_;
    double dt_;
    Recess recess_;
    MinimumSpacing spacing_;
    FilmLevel level_;
    FilmStepper stepper_;
    Matrix3 stiffness_;
    Vector3 held_, inertia_, spring_, damper_;
    std::array<Vector3, 3> motion_{Vector3::Zero(), Vector3::Zero(), Vector3::Zero()};
    std::array<Vector3, 2> velocity_{Vector3::Zero(), Vector3::Zero()};
};

/// s of the free motion that follows when the slider has been led along a mode.
Complex freeDecay(const Case& c, const ModesResult& modes, const AirBearingMode& mode, double amplitude)
{
    const Complex s = rateOf(mode);
    ComplexVector3 shape;
    for (int k = 0; k < 3; ++k) shape[k] = {mode.shape[std::size_t(k)][0], mode.shape[std::size_t(k)][1]};
    shape *= amplitude;

    const double dt = 1.0 / (stepsPerPeriod * mode.frequency);
    MovingSlider slider(c, modes.steady, modes.stiffness[4].stiffness, dt); // at 100 kHz
    // Faded in smoothly, so that the film moves as in the mode when the slider is let go.
    for (int n = 1; n <= ledSteps; ++n) {
        const double share = std::min(1.0, double(n) / (ledSteps - 4));
        const double weight = share * share * share * (10.0 + share * (6.0 * share - 15.0));
        const ComplexVector3 motion = weight * std::exp(s * (dt * (n - ledSteps))) * shape;
        if (!slider.lead(motion.real(), (s * motion).real())) return std::nan("");
    }
    std::vector<Vector3> samples;
    for (int n = 0; n < freeSteps; ++n) {
        if (!slider.fly()) return std::nan("");
        samples.push_back(slider.scaled(slider.motion()));
    }
    // Where a linear system moves as exp(s t), BDF2 makes z^n of it with this s: its own error is taken out.
    const Complex z = leadingFactor(samples, stepsPerPeriod);
    return (3.0 - 4.0 / z + 1.0 / (z * z)) / (2.0 * dt);
}

Case coarse(const std::string& name)
{
    Case c = openCase(name).value;
    c.film.nodes = {49, 49};
    c.film.tolerance = 1e-11;
    c.steady.loadTolerance = 1e-10;
    return c;
}

class TestModesDecay : public QObject {
    Q_OBJECT

private slots:
    void freeDecay_data()
    {
        QTest::addColumn<QString>("slider");
        QTest::addColumn<double>("amplitude"); // of the corner that moves most, against the minimum spacing
        QTest::newRow("femto") << "film_femto" << 2e-3;
        QTest::newRow("femto, half as far: the motion is small enough") << "film_femto" << 1e-3;
        QTest::newRow("pico") << "film_pico" << 2e-3;
    }

    /// Both know the same cells, so they agree however coarse these are: here the waves that the disk drags along at
    /// the highest mode, 25 um long, are lost, and its damping comes out negative.
    void freeDecay()
    {
        QFETCH(QString, slider);
        QFETCH(double, amplitude);
        const Case c = coarse(slider.toStdString());
        const ModesResult r = modes(c);
        QCOMPARE(r.status, SteadyStatus::Converged);
        QCOMPARE(r.modes.size(), std::size_t(3));
        for (const AirBearingMode& mode : r.modes) {
            const Complex s = test_modes_decay::freeDecay(c, r, mode, amplitude * r.steady.minimumSpacing);
            const double frequency = s.imag() / (2.0 * std::numbers::pi), damping = -s.real() / std::abs(s);
            const QString found = QString("%1 mode: %2 Hz with damping ratio %3, in time %4 Hz with %5")
                                      .arg(mode.kind.c_str())
                                      .arg(mode.frequency)
                                      .arg(mode.dampingRatio)
                                      .arg(frequency)
                                      .arg(damping);
            QVERIFY2(std::abs(frequency / mode.frequency - 1.0) < 1e-5, qPrintable(found));
            QVERIFY2(std::abs(damping / mode.dampingRatio - 1.0) < 1e-3, qPrintable(found));
        }
    }
};

TOUCHDOWN_TEST(TestModesDecay)

} // namespace test_modes_decay

#include "test_modes_decay.moc"

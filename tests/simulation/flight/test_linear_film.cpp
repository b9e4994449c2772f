// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/flight/linear_film.h"

#include <cmath>
#include <complex>
#include <random>

#include <QtTest>

#include "core/work/state_stream.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_linear_film {

using Complex = std::complex<double>;

Matrix3 drawnMatrix(std::mt19937_64& random, double size)
{
    std::uniform_real_distribution<double> entry(-size, size);
    Matrix3 matrix;
    for (Eigen::Index k = 0; k < 9; ++k) matrix(k) = entry(random);
    return matrix;
}

LinearFilmModel drawnFilm(int seed)
{
    std::mt19937_64 random(static_cast<unsigned>(seed));
    LinearFilmModel film;
    film.place = film.rest = {3.0, -2.0, 1.0};
    film.force = {5.0, 0.2, -0.3};
    film.fit.constant = drawnMatrix(random, 4.0) + 6.0 * Matrix3::Identity();
    for (const Complex rate : {Complex(-0.4, 1.7), Complex(-2.5, 0.0), Complex(-0.05, 0.3), Complex(-9.0, 30.0)})
        film.fit.poles.push_back(
            {rate, rate.imag() == 0.0
                       ? ComplexMatrix3(drawnMatrix(random, 1.0).cast<Complex>())
                       : ComplexMatrix3(drawnMatrix(random, 1.0) + Complex(0.0, 1.0) * drawnMatrix(random, 1.0))});
    return film;
}

/// A cubic in time, about a place.
struct Cubic {
    Vector3 place, a, b, c, d; // place + a + b t + c t^2 + d t^3
    SliderMotion at(double t) const
    {
        SliderMotion motion;
        motion.q = place + a + t * (b + t * (c + t * d));
        motion.v = b + t * (2.0 * c + 3.0 * t * d);
        motion.a = 2.0 * c + 6.0 * t * d;
        return motion;
    }
};

Cubic drawnCubic(const LinearFilmModel& film, int seed)
{
    std::mt19937_64 random(static_cast<unsigned>(seed));
    std::uniform_real_distribution<double> entry(-1.0, 1.0);
    Cubic cubic{.place = film.place, .a = {}, .b = {}, .c = {}, .d = {}};
    for (Vector3* part : {&cubic.a, &cubic.b, &cubic.c, &cubic.d})
        *part = Vector3(entry(random), entry(random), entry(random));
    return cubic;
}

/// The force at t: the states by Simpson's rule, from those of a slider that had stood at the beginning.
Vector3 forceBy(const LinearFilmModel& film, const Cubic& motion, double t)
{
    const auto u = [&](double at) { return Vector3(motion.at(at).q - film.place); };
    Vector3 force = film.force - film.fit.constant * u(t);
    for (const FilmFit::Pole& pole : film.fit.poles) {
        const int parts = 20000;
        ComplexVector3 sum = ComplexVector3::Zero();
        for (int k = 0; k <= parts; ++k) {
            const double at = t * k / parts, weight = k == 0 || k == parts ? 1.0 : k % 2 == 1 ? 4.0 : 2.0;
            sum += weight * std::exp(pole.rate * (t - at)) * u(at);
        }
        const ComplexVector3 state = -std::exp(pole.rate * t) * u(0.0) / pole.rate + t / (3.0 * parts) * sum;
        force -= (pole.rate.imag() == 0.0 ? 1.0 : 2.0) * (pole.residue * state).real();
    }
    return force;
}

class TestLinearFilm : public QObject {
    Q_OBJECT
private slots:
    // Steps of any lengths are exact for a cubic, at rates for which the step is long and for which it is short.
    void stepsAreExactForCubics()
    {
        for (int seed = 0; seed < 6; ++seed) {
            const LinearFilmModel model = drawnFilm(seed);
            const Cubic motion = drawnCubic(model, seed);
            LinearFilm film(model);
            film.setDisk(0.0, false);
            film.start(motion.at(0.0), 0.0);
            double time = 0.0;
            for (const double dt : {0.02, 0.02, 0.3, 0.001, 0.9, 0.2}) {
                film.setDisk(time + dt, false);
                QVERIFY(film.step(dt, motion.at(time), motion.at(time + dt).q, 0.0).converged);
                time += dt;
                const Vector3 force = film.force();
                QVERIFY(film.accept(motion.at(time)));
                const Vector3 exact = forceBy(model, motion, time);
                QVERIFY2((force - exact).norm() < 1e-9 * exact.norm(),
                         qPrintable(QString("%1 at %2: %3").arg(seed).arg(time).arg((force - exact).norm())));
            }
        }
    }

    // A step that is tried at several positions ends at the last one; its stiffness is what a change of it changes.
    void followsChangesOfTheStep()
    {
        const LinearFilmModel model = drawnFilm(9);
        const Cubic motion = drawnCubic(model, 9);
        LinearFilm film(model), once(model);
        for (LinearFilm* each : {&film, &once}) each->start(motion.at(0.0), 0.0);
        film.step(0.7, motion.at(0.0), motion.at(0.7).q, 0.0);
        film.step(0.4, motion.at(0.0), motion.at(0.1).q, 0.0);
        const Vector3 before = film.force(), change = motion.at(0.4).q - motion.at(0.1).q;
        QCOMPARE(film.follow(motion.at(0.4).q, change), 0.0);
        once.step(0.4, motion.at(0.0), motion.at(0.4).q, 0.0);
        QVERIFY((film.force() - once.force()).norm() < 1e-13 * before.norm());
        QVERIFY((before - film.stiffness() * change - film.force()).norm() < 1e-13 * before.norm());
        for (LinearFilm* each : {&film, &once}) QVERIFY(each->accept(motion.at(0.4)));
        for (LinearFilm* each : {&film, &once}) each->step(0.2, motion.at(0.4), motion.at(0.6).q, 0.0);
        QVERIFY((film.force() - once.force()).norm() < 1e-12 * before.norm());
    }

    // A slider that stands still keeps its force; so long as nothing moves, nothing is gained.
    void standsStill()
    {
        const LinearFilmModel model = drawnFilm(3);
        SliderMotion still;
        still.q = model.place + Vector3(0.1, 0.2, -0.1);
        LinearFilm film(model);
        film.start(still, 0.0);
        const Vector3 expected = model.force - model.fit.at(0.0).real() * (still.q - model.place);
        for (const double dt : {0.1, 2.0, 0.01, 50.0}) {
            film.step(dt, still, still.q, 0.0);
            QVERIFY((film.force() - expected).norm() < 1e-12 * expected.norm());
            QVERIFY(film.accept(still));
            QCOMPARE(film.energy().input, 0.0);
        }
    }

    // Around a slow loop the energy that the film stores comes back, and the force is its slope.
    void storesTheEnergyOfItsStaticAnswer()
    {
        LinearFilmModel model = drawnFilm(4);
        model.force = {2.0, 1.0, 0.5};
        const Matrix3 k = model.fit.at(0.0).real(), symmetric = 0.5 * (k + k.transpose());
        LinearFilm film(model);
        const auto stored = [&](const Vector3& u) {
            SliderMotion at;
            at.q = model.place + u;
            film.start(at, 0.0);
            return film.energy().stored;
        };
        QCOMPARE(stored(Vector3::Zero()), 0.0);
        const Vector3 u(0.3, -0.2, 0.4);
        const double step = 1e-4;
        for (Eigen::Index m = 0; m < 3; ++m) {
            const double slope =
                (stored(u + step * Vector3::Unit(m)) - stored(u - step * Vector3::Unit(m))) / (2.0 * step);
            QVERIFY(std::abs(slope - (symmetric * u - model.force)[m]) < 1e-8);
        }
    }

    // The force of waves: what lasts, and what fades with the film's poles.
    void addsTheForceOfWaves()
    {
        LinearFilmModel model = drawnFilm(5);
        model.waves = {{3.0, ComplexVector3(Complex(1.0, 2.0), 0.5, Complex(0.0, -1.0))}};
        model.transient.assign(model.fit.poles.size(), ComplexVector3::Zero());
        model.transient[0] = ComplexVector3(Complex(0.2, 0.1), 0.0, 0.3);
        model.transient[1] = ComplexVector3(0.7, 0.0, 0.0);
        SliderMotion still;
        still.q = model.place;
        LinearFilm film(model);
        film.setDisk(0.0, false);
        film.start(still, 0.0);
        QVERIFY((film.force() - model.force - Vector3(1.0 + 2.0 * 0.2 + 0.7, 0.5, 2.0 * 0.3)).norm() < 1e-13);
        for (const double time : {0.4, 1.3, 200.0}) {
            film.setDisk(time, false);
            film.step(0.1, still, still.q, 0.0);
            Vector3 expected = model.force + (std::exp(Complex(0.0, 3.0 * time)) * model.waves[0].force).real();
            expected += 2.0 * (std::exp(model.fit.poles[0].rate * time) * model.transient[0]).real();
            expected += (std::exp(model.fit.poles[1].rate * time) * model.transient[1]).real();
            QVERIFY((film.force() - expected).norm() < 1e-12);
        }
    }

    // The stated error is that of the integrals: of a motion of one size, that size; in proportion to it.
    void statesAnErrorInProportionToTheMotion()
    {
        LinearFilmModel model = drawnFilm(6);
        model.spacing = 4.0;
        model.arms = {1.0, 0.0, 0.0};
        const auto stated = [&](double size, double rest) {
            LinearFilm film(model);
            SliderMotion at;
            at.q = model.place + Vector3(size, 7.0, -3.0);
            film.start(at, 0.0);
            film.step(1.0, at, at.q, 0.0);
            (void)film.accept(at);
            at.q = model.place;
            film.step(rest, at, at.q, 0.0);
            (void)film.accept(at);
            return film.linearityError();
        };
        QVERIFY(stated(0.01, 1.0) > 0.0);
        QVERIFY(std::abs(stated(0.05, 1.0) / stated(0.01, 1.0) - 5.0) < 1e-9);
        QVERIFY(std::abs(stated(0.05, 1.0) / stated(0.05, 100.0) - 1.0) < 1e-9); // the motion itself is smaller, too
        QCOMPARE(stated(0.0, 1.0), 0.0);
    }

    // Its state goes on in another film.
    void goesOnFromItsState()
    {
        const LinearFilmModel model = drawnFilm(7);
        const Cubic motion = drawnCubic(model, 7);
        LinearFilm film(model), other(model);
        film.start(motion.at(0.0), 0.0);
        film.step(0.3, motion.at(0.0), motion.at(0.3).q, 0.0);
        QVERIFY(film.accept(motion.at(0.3)));
        StateStream writing;
        film.pass(writing);
        const std::string bytes = writing.take();
        StateStream reading(bytes);
        other.pass(reading);
        reading.end();
        for (LinearFilm* each : {&film, &other}) each->step(0.2, motion.at(0.3), motion.at(0.5).q, 0.0);
        QCOMPARE(other.force(), film.force());
        QCOMPARE(other.linearityError(), film.linearityError());
    }
};

TOUCHDOWN_TEST(TestLinearFilm)

} // namespace test_linear_film

#include "test_linear_film.moc"

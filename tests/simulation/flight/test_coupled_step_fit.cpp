// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where steps are fitted to the slider's fastest rate, and what they gain.
#include <algorithm>
#include <cmath>

#include "core/simulation/flight/coupled_step.h"
#include "tests/support/flying_slider.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_coupled_step_fit {

constexpr double length = 1.25e-3; // of the slider [m]

/// Springs under the mass centre, a stiffer one below a height.
class TwoSprings final : public SliderContact {
public:
    TwoSprings(double above, double below, double top) : above_(above), below_(below), top_(top) {}
    const SliderContactForces& at(const Attitude& attitude, double) override
    {
        const double depth = top_ - attitude.height - 0.5 * length * attitude.pitch;
        stiffness_ = depth > 0.0 ? below_ : above_;
        forces_.contact = stiffness_ * depth;
        return forces_;
    }
    Matrix3 stiffness() const override
    {
        Matrix3 result = Matrix3::Zero();
        result(0, 0) = stiffness_;
        return result;
    }
    bool outOfReach(const Attitude&) const override { return false; }
    void accept() override {}

private:
    double above_, below_, top_, stiffness_ = 0.0; // [N/m], [N/m], [m], [N/m]
    SliderContactForces forces_;
};

double restingCentre() { return picoAtRest().attitude.height + 0.5 * length * picoAtRest().attitude.pitch; }

class TestCoupledStepFit : public QObject {
    Q_OBJECT

private slots:
    /// As soon as there are three alike steps, whose omega dt is small enough.
    void inFreeFlight()
    {
        FlyingSlider slider(pico(), picoAtRest(), {}, {1e-10, 0.0, 0.0});
        int unfitted = 0;
        for (int n = 0; n < 12; ++n) {
            QVERIFY(slider.take(2e-7).converged());
            unfitted += !slider.film.isFitted();
            QCOMPARE(slider.film.isFitted(), n >= unfitted);
        }
        QVERIFY2(unfitted >= 2 && unfitted <= 5, qPrintable(QString::number(unfitted)));
        QVERIFY(slider.take(0.7e-7).converged());
        QVERIFY(!slider.film.isFitted());
        for (int n = 0; n < 4; ++n) QVERIFY(slider.take(0.7e-7).converged());
        QVERIFY(slider.film.isFitted());
        const double rate = slider.stepper.fastestRate();
        for (int n = 0; n < 5; ++n) QVERIFY(slider.take(1.35 / rate).converged());
        QVERIFY(!slider.film.isFitted());
    }
    void notStaggered()
    {
        CoupledStepOptions options;
        options.coupling = FilmCoupling::Staggered;
        FlyingSlider slider(pico(), picoAtRest(), options, {1e-10, 0.0, 0.0});
        QVERIFY(slider.takeAll(2e-6, 20));
        QVERIFY(!slider.film.isFitted());
    }
    /// On a spring that stays as it is, and where a stiffer one is met in between.
    void onSprings()
    {
        TwoSprings soft(1e5, 1e5, restingCentre()), stiff(1e5, 3e6, restingCentre() - 0.1e-9);
        for (TwoSprings* springs : {&soft, &stiff}) {
            FlyingSlider slider(pico(), picoAtRest(), {}, {1e-9, 0.0, 0.0}, springs);
            QVERIFY(slider.takeAll(4e-7, 8));
            QVERIFY(slider.film.isFitted());
            int sinceMet = -1;
            for (int n = 0; n < 200 && sinceMet < 3; ++n) {
                QVERIFY(slider.take(5e-8).converged());
                if (sinceMet >= 0 || slider.q()[0] < restingCentre() - 0.1e-9) ++sinceMet;
                QVERIFY(slider.film.isFitted());
            }
            QCOMPARE(sinceMet, 3);
        }
    }
    /// A dozen steps a period keep the decay on a spring: what differs from ten times shorter steps after ten periods
    /// is a tenth of what BDF2OPT changes.
    void decaysOnASpring()
    {
        TwoSprings springs(4e5, 4e5, restingCentre());
        const auto end = [&](FilmTimeMethod method, int perStep) {
            CoupledStepOptions options;
            options.film = {.method = method, .tolerance = 1e-11, .share = 0.02, .maximumIterations = 30};
            FlyingSlider slider(pico(), picoAtRest(), options, {2e-11, 0.0, 0.0}, &springs);
            double highest = -1.0, lowest = 1.0;
            const double dt = 2.6e-7 / perStep;
            for (int n = 0; n < 120 * perStep; ++n) {
                if (!slider.take(dt).converged()) return std::nan("");
                if (n < 105 * perStep) continue;
                highest = std::max(highest, slider.q()[0]);
                lowest = std::min(lowest, slider.q()[0]);
            }
            return highest - lowest;
        };
        const double exact = end(FilmTimeMethod::Fitted, 10), fitted = end(FilmTimeMethod::Fitted, 1),
                     usual = end(FilmTimeMethod::Bdf2Opt, 1);
        const QString found = QString("%1 %2 %3").arg(exact).arg(fitted).arg(usual);
        QVERIFY2(std::abs(fitted - exact) < 0.05 * exact, qPrintable(found));
        QVERIFY2(std::abs(fitted - exact) < 0.2 * std::abs(usual - exact), qPrintable(found));
    }
};

TOUCHDOWN_TEST(TestCoupledStepFit)

} // namespace test_coupled_step_fit

#include "test_coupled_step_fit.moc"

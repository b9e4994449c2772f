// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/small_motions/film_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QtTest>

#include "core/simulation/small_motions/small_motions.h"
#include "core/simulation/static_state/film_balance.h"
#include "tests/support/flying_slider.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_film_fit {

using Complex = std::complex<double>;

class TestFilmFit : public QObject {
    Q_OBJECT
private slots:
    void fitsTheFilm_data()
    {
        QTest::addColumn<QString>("name");
        QTest::newRow("three degrees of freedom") << "film_pico";
        QTest::newRow("a held roll") << "film_fig4_pico";
    }
    // At rest, between its values and at the slider's own rates, with the modes over the film itself.
    void fitsTheFilm()
    {
        QFETCH(QString, name);
        Case c = coarseFlight(name.toStdString());
        c.contact = noContact;
        const SteadyResult rest = steady(c);
        QCOMPARE(rest.status, SteadyStatus::Converged);
        const std::unique_ptr<FilmBalance> slider = FilmBalance::at(c, rest);
        SmallMotions motions(slider->level(), slider->body());
        bool solved = true;
        const FilmFit fit = fitFilm(motions, solved);
        QVERIFY(solved && fit.isFinite() && fit.error < 1e-3);
        const auto missed = [&](Complex s, const ComplexMatrix3& fitted) {
            const SmallMotions::Film film = motions.film(s.imag() > 0.0 ? s : Complex(0.0, 10.0));
            const ComplexMatrix3 z = motions.scale().asDiagonal() *
                                     (film.stiffness + s * film.damping - fitted).eval() * motions.scale().asDiagonal();
            const Matrix3 all = motions.scale().asDiagonal() * film.stiffness * motions.scale().asDiagonal();
            return z.cwiseAbs().maxCoeff() / all.cwiseAbs().maxCoeff();
        };
        QVERIFY(missed(0.0, fit.at(0.0)) < 1e-3);
        for (double frequency = 2.3e3; frequency < 3e6; frequency *= 2.1) {
            const Complex s(0.0, 2.0 * std::numbers::pi * frequency);
            QVERIFY2(missed(s, fit.at(s)) < 5e-3,
                     qPrintable(QString("%1 Hz: %2").arg(frequency).arg(missed(s, fit.at(s)))));
        }
        const std::vector<Complex> rates = ratesOver(fit, motions);
        for (const SmallMotions::Mode& mode : motions.find(1e-9)) {
            double nearest = 1.0;
            for (const Complex rate : rates) nearest = std::min(nearest, std::abs(rate - mode.rate) / std::abs(rate));
            QVERIFY2(nearest < 3e-4, qPrintable(QString::number(nearest)));
        }
    }

    void endsWhereItIsAsked()
    {
        const Case c = pico();
        const std::unique_ptr<FilmBalance> slider = FilmBalance::at(c, picoAtRest());
        SmallMotions motions(slider->level(), slider->body());
        bool solved = true;
        int asked = 0;
        fitFilm(motions, solved, [&] { return ++asked < 5; });
        QVERIFY(asked < 30);
    }
};

TOUCHDOWN_TEST(TestFilmFit)

} // namespace test_film_fit

#include "test_film_fit.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/equilibria/film_equilibria.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QTest>

#include "core/case/contact_kind.h"
#include "core/simulation/contact/pad_contact.h"
#include "core/simulation/run.h"
#include "core/simulation/static_state/contact_rest.h"
#include "core/simulation/static_state/slider_body.h"
#include "core/simulation/static_state/steady.h"
#include "tests/support/sample_case.h"
#include "tests/support/small_slider.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_film_equilibria {

/// The small slider with menisci that reach from 2 nm below its static spacing to 3 nm above.
Case withMenisci(int degreesOfFreedom)
{
    Case c = test::smallSlider(33);
    c.degreesOfFreedom = degreesOfFreedom;
    c.film.grid = GridKind::Graded; // the same at every attitude
    c.steady.stiffness = false;
    const double spacing = steady(c).minimumSpacing;
    c.contact = ContactKind::OnoYamane;
    c.onoYamane = {.meniscusForce = 1e-3,
                   .contactStiffness = 5e6,
                   .initialContactForce = 5e-3,
                   .touchDown = spacing - 2e-9,
                   .takeOff = spacing + 3e-9,
                   .friction = 0.3};
    return c;
}

const Equilibrium* touchingOne(const FilmEquilibria& all)
{
    const Equilibrium* found = nullptr;
    for (const Equilibrium& at : all.found)
        if (at.touching) found = &at;
    return found;
}

class TestFilmEquilibria : public QObject {
    Q_OBJECT

    static void sameStates(const Case& c)
    {
        const FilmEquilibria all = filmEquilibria(c, [] { return true; });
        const SteadyResult state = steadyWithContact(c);
        std::vector<double> spacings;
        if (state.status == SteadyStatus::Converged) spacings.push_back(state.minimumSpacing);
        for (const RestingState& other : state.contactStates) spacings.push_back(other.minimumSpacing);
        QCOMPARE(spacings.size(), all.found.size());
        for (const Equilibrium& at : all.found)
            QVERIFY2(std::ranges::any_of(spacings, [&](double d) { return std::abs(d - at.spacing) < 1e-6 * d; }),
                     qPrintable(QString::number(at.spacing)));
    }

private slots:
    void flyingHasTheModesOfTheStaticState()
    {
        const Case c = withMenisci(3);
        const FilmEquilibria all = filmEquilibria(c, [] { return true; });
        QVERIFY2(all.problem.empty(), all.problem.c_str());
        const ModesResult expected = modes(c);
        QCOMPARE(expected.modes.size(), std::size_t(3));
        QVERIFY(!all.found.front().touching);
        QCOMPARE(all.found.front().eigenvalues.size(), std::size_t(3));
        QCOMPARE(all.found.front().lost, 0);
        for (const std::complex<double> s : all.found.front().eigenvalues) {
            bool known = false;
            for (const AirBearingMode& mode : expected.modes) {
                // s to 1e-5, the film at it to 1e-8
                known =
                    known || (std::abs(s.imag() / (2.0 * std::numbers::pi) - mode.frequency) < 1e-4 * mode.frequency &&
                              std::abs(-s.real() / std::abs(s) - mode.dampingRatio) < 1e-4);
            }
            QVERIFY(known);
        }
    }

    void contactBalances_data()
    {
        QTest::addColumn<int>("degreesOfFreedom");
        QTest::newRow("height and pitch") << 2;
        QTest::newRow("height, pitch and roll") << 3;
    }
    /// What contact, friction and the suspension's springs do at the equilibrium, put into the load instead: without
    /// contact the static state must be there.
    void contactBalances()
    {
        QFETCH(int, degreesOfFreedom);
        const Case c = withMenisci(degreesOfFreedom);
        const FilmEquilibria all = filmEquilibria(c, [] { return true; });
        const Equilibrium* at = touchingOne(all);
        QVERIFY(at != nullptr);
        QVERIFY(at->spacing > c.onoYamane.touchDown && at->spacing < c.onoYamane.takeOff);
        QVERIFY(at->netContactForce < 0.0);

        Case free = c;
        free.contact = noContact;
        const SliderBody body(c, steady(free).attitude);
        const Recess recess(c.surface, c.slider.length, c.slider.width);
        const MinimumSpacing spacing(c.surface, recess);
        Case held = c;
        held.initial.branch = ContactBranch::TakeOff;
        const Vector3 touch = PadContact(held, makeSeparationLaw(held), spacing).at(body.attitude(at->q), 0.0).load();
        const Vector3 springs = body.suspension(at->q, Vector3::Zero());
        free.suspension.offsetX = free.suspension.offsetY = 0.0;
        free.suspension.preload = -(springs[0] + touch[0]);
        free.suspension.pitchTorque = springs[1] + touch[1];
        free.suspension.rollTorque = springs[2] + touch[2];
        const SteadyResult expected = steady(free);
        QCOMPARE(expected.status, SteadyStatus::Converged);
        // Loads to 1e-9 of the preload, over the film's stiffness of some 1e5 N/m.
        QVERIFY2(std::abs(expected.minimumSpacing - at->spacing) < 1e-12,
                 qPrintable(QString::number(expected.minimumSpacing - at->spacing)));
        QVERIFY2(std::abs(expected.attitude.pitch - at->q[1]) < 1e-9,
                 qPrintable(QString::number(expected.attitude.pitch - at->q[1])));
        QVERIFY(std::abs(expected.attitude.roll - at->q[2]) < 1e-9);
    }

    /// Every state in contact of one search is one of the other, at the same place.
    void steadyFindsTheSameStates()
    {
        for (const int degreesOfFreedom : {2, 3}) sameStates(withMenisci(degreesOfFreedom));
    }

    void samplesHaveTheSameStates_data()
    {
        QTest::addColumn<QString>("name");
        for (const SampleCase& each : sampleCases())
            if (reasonForNoFilmEquilibria(sample(each.name)).empty())
                QTest::newRow(each.name.c_str()) << QString::fromStdString(each.name);
    }
    /// So that all know the states to a millionth, the balance is solved to a billionth. A run that begins in the state
    /// rests there.
    void samplesHaveTheSameStates()
    {
        QFETCH(QString, name);
        Case setup = sample(name.toStdString());
        setup.film.nodes = {49, 49};
        setup.film.tolerance = setup.steady.loadTolerance = 1e-9;
        sameStates(setup);
        setup.initial = {.branch = setup.initial.branch, .state = InitialState::Static};
        setup.run.duration = 1e-6;
        setup.run.sampleInterval = 0.1e-6;
        const SteadyResult state = steadyWithContact(setup);
        const Summary summary = run(setup);
        QCOMPARE(summary.status, RunStatus::Completed);
        const auto spacing =
            std::ranges::find(summary.extremes, "minimum_spacing", [](auto& each) { return each.first; });
        QVERIFY(spacing != summary.extremes.end());
        for (const double d : {spacing->second.least, spacing->second.most})
            QVERIFY2(std::abs(d - state.minimumSpacing) < 1e-6 * state.minimumSpacing,
                     qPrintable(QString::number((d - state.minimumSpacing) / state.minimumSpacing)));
    }

    void saysWhereThereAreNone()
    {
        Case c = test::smallSlider(33);
        QVERIFY(!reasonForNoFilmEquilibria(c).empty());
        c.contact = ContactKind::OnoYamane;
        QVERIFY(reasonForNoFilmEquilibria(c).empty());
    }

    void stopsWhenAsked()
    {
        const Case c = withMenisci(2);
        int left = 60;
        QVERIFY(filmEquilibria(c, [&] { return left-- > 0; }).stopped);
    }
};

TOUCHDOWN_TEST(TestFilmEquilibria)

} // namespace test_film_equilibria

#include "test_film_equilibria.moc"

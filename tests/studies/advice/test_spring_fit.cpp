// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include <QtTest>

#include "core/case/contact_kind.h"
#include "core/case/parameters.h"
#include "core/simulation/static_state/steady.h"
#include "core/studies/advice/pilot_run.h"
#include "core/studies/advice/spring_fit.h"
#include "core/studies/runs/measured_run.h"
#include "tests/support/taper_flat.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_spring_fit {

class TestSpringFit : public QObject {
    Q_OBJECT

private slots:
    void ringsAsTheFilmDoes();
    void restsInTheStaticState();
    void beginsWhereTheFilmBegins();
    void takesTheCharacteristicOver();
    void followsTheDiskAsTheFilmDoes();
    void saysWhereThereAreNone();
};

Case taperFlat()
{
    Case c = test::taperFlat();
    c.run.duration = 0.2e-3;
    return c;
}

// The springs have the symmetric part of the film's matrix at a frequency between both modes: of two long rails it is
// symmetric but for some thousandths, and changes as little with frequency; modes go as its root. For both damping
// ratios one dashpot would have to push: with the other one alone two ratios are met by one number, each to the fifth
// by which they ask for different ones.
void TestSpringFit::ringsAsTheFilmDoes()
{
    const SpringFit fit = fitSprings(taperFlat());
    QVERIFY2(fit.problem.empty(), fit.problem.c_str());
    QVERIFY(fit.stiffnessLeft < 0.01);
    for (std::size_t k = 0; k < 2; ++k) {
        QVERIFY(std::abs(fit.springFrequency[k] / fit.filmFrequency[k] - 1.0) < 0.005);
        QVERIFY(std::abs(fit.springDamping[k] / fit.filmDamping[k] - 1.0) < 0.2);
    }
    QVERIFY(fit.springs.springs.frontStiffness > 0.0 && fit.springs.springs.rearStiffness > 0.0);
    QVERIFY(checkCombinations(fit.springs).empty());
}

void TestSpringFit::restsInTheStaticState()
{
    Case c = taperFlat();
    c.initial.state = InitialState::Static;
    const SpringFit fit = fitSprings(c);
    QVERIFY2(fit.problem.empty(), fit.problem.c_str());
    const double static_ = steady(c).minimumSpacing;
    const MeasuredRun run = measureRun(fit.springs, {});
    QVERIFY(run.valid());
    QVERIFY(std::abs(run.end.spacing - static_) < 1e-9 * static_);
    QCOMPARE(run.end.kind, EndKind::Flying);
}

// Moved from the static state as the film's slider is: the mass centre by 2 nm, the pitch by 3 urad, which sets the pad
// at d_h down.
void TestSpringFit::beginsWhereTheFilmBegins()
{
    Case c = taperFlat();
    c.initial.state = InitialState::Static;
    c.initial.heightOffset = 2e-9;
    c.initial.pitchOffset = 3e-6;
    c.initial.verticalVelocity = 1e-4;
    const SpringFit fit = fitSprings(c);
    QVERIFY2(fit.problem.empty(), fit.problem.c_str());
    const double arm = fit.springs.springs.padDistance;
    QVERIFY(std::abs(fit.springs.initial.flyingHeight - fit.springs.springs.flyingHeight - (2e-9 - 3e-6 * arm)) <
            1e-15);
    QVERIFY(std::abs(fit.springs.initial.pitch - fit.springs.springs.pitch - 3e-6) < 1e-15);
    QCOMPARE(fit.springs.initial.verticalVelocity, 1e-4);
}

void TestSpringFit::takesTheCharacteristicOver()
{
    Case c = taperFlat();
    c.contact = ContactKind::OnoYamane;
    c.onoYamane.meniscusForce = 12e-3;
    const SpringFit fit = fitSprings(c);
    QVERIFY2(fit.problem.empty(), fit.problem.c_str());
    QCOMPARE(fit.springs.contact, ContactKind::OnoYamane);
    QCOMPARE(fit.springs.onoYamane.meniscusForce, 12e-3);
}

/// A wave of 20 mm, sixteen sliders long, passes in 1.4 ms: slider and film follow it, so that the minimum spacing
/// above the mean plane is that of the static state and the height of the disk under it. Of the fitted springs it is
/// the same, but for what a moving slope does to the film: half of the disk's speed carries its pressure, so that it
/// leads by a part of a slider's length, 1.26 nm/mm 0.35 mm.
void TestSpringFit::followsTheDiskAsTheFilmDoes()
{
    Case c = taperFlat();
    c.initial.state = InitialState::Static;
    c.diskSurface.kind = DiskSurfaceKind::Waves;
    c.diskSurface.waveAmplitudes = {4e-9};
    c.diskSurface.waveLengths = {20e-3};
    c.diskSurface.wavePhases = {-std::numbers::pi / 16.0}; // a node under the middle of the slider at the start
    c.diskSurface.track = 20e-3;
    const SpringFit fit = fitSprings(c);
    QVERIFY2(fit.problem.empty(), fit.problem.c_str());
    QVERIFY(fit.springs.diskSurface == c.diskSurface);
    QVERIFY(checkCombinations(fit.springs).empty());
    const PilotRun film = pilotRun(c, {}, {}), springs = pilotRun(fit.springs, {}, {});
    QVERIFY2(film.problem.empty() && springs.problem.empty(), (film.problem + springs.problem).c_str());
    QCOMPARE(film.samples.spacing.size(), springs.samples.spacing.size());
    double apart = 0.0, low = 1.0, high = 0.0;
    for (std::size_t k = film.samples.spacing.size() / 2; k < film.samples.spacing.size(); ++k) {
        apart = std::max(apart, std::abs(film.samples.spacing[k] - springs.samples.spacing[k]));
        low = std::min(low, film.samples.spacing[k]);
        high = std::max(high, film.samples.spacing[k]);
    }
    QVERIFY(high - low > 0.5e-9);
    QVERIFY2(apart < 0.44e-9, qPrintable(QStringLiteral("%1 of %2 nm").arg(apart * 1e9).arg((high - low) * 1e9)));
    c.diskSurface.kind = DiskSurfaceKind::Bumps;
    c.diskSurface.bumpHeights = {1e-9};
    c.diskSurface.bumpLengths = {100e-6};
    c.diskSurface.bumpX = c.diskSurface.bumpY = {0.0};
    QVERIFY(!springsKnowDisk(c)); // vertical sides
    c.diskSurface.bumpShape = BumpShape::Cosine;
    QVERIFY(springsKnowDisk(c));
}

void TestSpringFit::saysWhereThereAreNone()
{
    Case c = taperFlat();
    c.contact = ContactKind::Elastic;
    QVERIFY(!fitSprings(c).problem.empty());
    c = taperFlat();
    QCOMPARE(fitSprings(c, [] { return false; }).problem.empty(), false);
}

TOUCHDOWN_TEST(TestSpringFit)

} // namespace test_spring_fit

#include "test_spring_fit.moc"

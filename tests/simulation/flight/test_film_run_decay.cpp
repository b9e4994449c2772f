// SPDX-License-Identifier: GPL-3.0-or-later
//
// The free decay of a run in time against the modes about the static state.
#include <complex>
#include <numbers>

#include "core/simulation/flight/film_run.h"
#include "tests/simulation/matrix_pencil.h"
#include "tests/support/exponential_fit.h"
#include "tests/support/flying_slider.h"
#include "tests/support/free_oscillation.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_film_run_decay {

using Complex = std::complex<double>;

constexpr int samplesPerPeriod = 24;

Case released(const Case& c, const AirBearingMode& mode, double amplitude, double periods)
{
    Case free = test::released(c, mode, amplitude);
    free.run.sampleInterval = 1.0 / (samplesPerPeriod * mode.frequency);
    free.run.duration = periods / mode.frequency;
    return free;
}

/// Motions from rest, as lengths, without those of the first samples; none where the run fails.
std::vector<Eigen::Vector3d> motions(const Case& c, const SteadyResult& rest, std::size_t without)
{
    const SliderBody body(c, rest.attitude);
    std::vector<Eigen::Vector3d> samples;
    std::array<std::size_t, 3> columns{};
    const std::vector<Quantity> quantities = filmQuantities(c);
    for (std::size_t i = 0; i < quantities.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
            if (quantities[i].name == std::array{"height", "pitch", "roll"}[k]) columns[k] = i;
    std::size_t count = 0;
    const Summary summary = runFilm(c, [&](const RunUpdate& update) {
        for (std::size_t n = 0; n < update.samples.size(); ++n) {
            if (count++ < without) continue;
            Eigen::Vector3d motion;
            for (std::size_t k = 0; k < 3; ++k)
                motion[Eigen::Index(k)] = update.samples.columns[columns[k]][n] - body.rest()[k];
            samples.push_back(motion.cwiseProduct(Eigen::Vector3d(1.0, 0.5 * c.slider.length, 0.5 * c.slider.width)));
        }
        return true;
    });
    if (summary.status != RunStatus::Completed) samples.clear();
    return samples;
}

/// s of the free motion with fixed steps.
Complex decay(Case c, const SteadyResult& rest, const AirBearingMode& mode, double amplitude, int stepsPerSample)
{
    c = released(c, mode, amplitude, 5.0);
    c.run.steps = StepControl::Fixed;
    c.run.step = c.run.sampleInterval / stepsPerSample;
    c.run.stepError = 1e-14; // for what is left of a step
    const std::vector<Eigen::Vector3d> samples = motions(c, rest, samplesPerPeriod);
    if (samples.empty()) return std::nan("");
    return std::log(leadingFactor(samples, samplesPerPeriod, 1e-6)) / c.run.sampleInterval;
}

class TestFilmRunDecay : public QObject {
    Q_OBJECT

private slots:
    void decaysAsItsModes_data()
    {
        QTest::addColumn<QString>("slider");
        QTest::addColumn<int>("coupling");
        QTest::newRow("femto, monolithic") << "film_femto" << int(FilmCoupling::Monolithic);
        QTest::newRow("pico, monolithic") << "film_pico" << int(FilmCoupling::Monolithic);
        QTest::newRow("pico, staggered") << "film_pico" << int(FilmCoupling::Staggered);
    }
    /// Of second order, so that s with two lengths of step, h and h/2, gives (4 s(h/2) - s(h))/3 with an error far
    /// below; the staggered coupling has an error of third order in h besides and takes steps half as long. Amplitudes
    /// of 2e-3 of the spacing: nonlinearity changes frequencies by their square.
    void decaysAsItsModes()
    {
        QFETCH(QString, slider);
        QFETCH(int, coupling);
        Case c = coarseFlight(slider.toStdString());
        c.film.coupling = FilmCoupling(coupling);
        const int steps = c.film.coupling == FilmCoupling::Staggered ? 4 : 2; // per sample
        const ModesResult known = modes(c);
        QCOMPARE(known.status, SteadyStatus::Converged);
        QCOMPARE(known.modes.size(), std::size_t(3));
        for (const AirBearingMode& mode : known.modes) {
            const double amplitude = 2e-3 * known.steady.minimumSpacing;
            const Complex coarse = decay(c, known.steady, mode, amplitude, steps),
                          fine = decay(c, known.steady, mode, amplitude, 2 * steps);
            const Complex s = (4.0 * fine - coarse) / 3.0;
            const double frequency = s.imag() / (2.0 * std::numbers::pi), damping = -s.real() / std::abs(s);
            const QString found = QString("%1 mode: %2 Hz with damping ratio %3, in time %4 Hz with %5")
                                      .arg(mode.kind.c_str())
                                      .arg(mode.frequency)
                                      .arg(mode.dampingRatio)
                                      .arg(frequency)
                                      .arg(damping);
            QVERIFY2(std::abs(frequency / mode.frequency - 1.0) < 1e-3, qPrintable(found));
            // Coarse grids leave some modes with next to no damping.
            const double scale = std::max(std::abs(mode.dampingRatio), 1e-3);
            QVERIFY2(std::abs(damping - mode.dampingRatio) < 1e-2 * scale, qPrintable(found));
        }
    }

    void keepsTheDampingAtItsOwnSteps_data()
    {
        QTest::addColumn<QString>("slider");
        QTest::addColumn<int>("nodes"); // along each side
        QTest::newRow("femto") << "film_femto" << 65;
        QTest::newRow("pico") << "film_pico" << 65;
        QTest::newRow("pico of Fig. 4") << "film_fig4_pico" << 97;
    }
    /// About a dozen steps a period of the fastest mode: its damping ratio to 5 % or 5e-5.
    void keepsTheDampingAtItsOwnSteps()
    {
        QFETCH(QString, slider);
        QFETCH(int, nodes);
        const Case c = coarseFlight(slider.toStdString(), nodes);
        const ModesResult known = modes(c);
        const AirBearingMode& mode = known.modes.back();
        const Case free = released(c, mode, 0.02 * known.steady.minimumSpacing, 24.0);
        const std::vector<Eigen::Vector3d> samples = motions(free, known.steady, 2 * samplesPerPeriod);
        QVERIFY(!samples.empty());
        Eigen::VectorXd time(Eigen::Index(samples.size()));
        Eigen::MatrixXd lengths(time.size(), 3);
        for (Eigen::Index n = 0; n < time.size(); ++n) {
            time[n] = double(n) * free.run.sampleInterval;
            lengths.row(n) = samples[std::size_t(n)];
        }
        std::vector<Complex> rates;
        for (const AirBearingMode& each : known.modes) rates.push_back(rateOf(each));
        const Complex s = ExponentialFit(time, lengths).rates(rates).back();
        const double frequency = s.imag() / (2.0 * std::numbers::pi), damping = -s.real() / std::abs(s);
        const QString found = QString("%1 Hz with damping ratio %2, in time %3 Hz with %4")
                                  .arg(mode.frequency)
                                  .arg(mode.dampingRatio)
                                  .arg(frequency)
                                  .arg(damping);
        QVERIFY2(std::abs(frequency / mode.frequency - 1.0) < 2e-3, qPrintable(found));
        QVERIFY2(std::abs(damping - mode.dampingRatio) < std::max(5e-5, 0.05 * std::abs(mode.dampingRatio)),
                 qPrintable(found));
    }
};

TOUCHDOWN_TEST(TestFilmRunDecay)

} // namespace test_film_run_decay

#include "test_film_run_decay.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/recording/run_spectra.h"

#include <cmath>
#include <numbers>

#include <QtTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_run_spectra {

const std::vector<Quantity> quantities{{"energy", "J", "pJ", "Energy"},
                                       {"minimum_spacing", "m", "nm", "Minimum spacing"},
                                       {"pitch", "rad", "urad", "Pitch"}};
constexpr double interval = 0.1e-6; // [s]

Case testCase()
{
    Case c;
    c.run.sampleInterval = interval;
    c.spectrum.segment = 100e-6; // 1000 samples, so that bins are 10 kHz apart
    c.spectrum.scaling = SpectrumScaling::Amplitude;
    c.spectrum.window = SpectrumWindow::Hann;
    return c;
}

// Minimum spacing: 2 nm at 250 kHz; pitch: 3 urad at 500 kHz; before `start` both are ten times as large.
void feed(RunSpectra& spectra, std::size_t samples, double start)
{
    for (std::size_t first = 0; first < samples; first += 777) {
        SampleBatch batch;
        batch.columns.resize(3);
        for (std::size_t k = first; k < std::min(first + 777, samples); ++k) {
            const double t = static_cast<double>(k) * interval;
            const double size = t < start ? 10.0 : 1.0;
            batch.time.push_back(t);
            batch.columns[0].push_back(1.0);
            batch.columns[1].push_back(size * 2e-9 * std::sin(2.0 * std::numbers::pi * 250e3 * t));
            batch.columns[2].push_back(size * 3e-6 * std::sin(2.0 * std::numbers::pi * 500e3 * t));
        }
        spectra.add(batch);
    }
}

class TestRunSpectra : public QObject {
    Q_OBJECT

private slots:
    void powerOfTheMotion_data();
    void powerOfTheMotion();
    void tooFewSamples();
};

void TestRunSpectra::powerOfTheMotion_data()
{
    QTest::addColumn<double>("start");
    QTest::newRow("all") << 0.0;
    QTest::newRow("without the beginning") << 0.5e-3;
}

// A sine of amplitude A on a bin shows A^2/2 there.
void TestRunSpectra::powerOfTheMotion()
{
    QFETCH(double, start);
    Case c = testCase();
    c.spectrum.start = start;
    RunSpectra recorder(c, quantities);
    feed(recorder, 10000, start);
    const auto spectra = recorder.spectra();
    QCOMPARE(spectra.size(), std::size_t{2});
    QCOMPARE(spectra[0].first.name, std::string("minimum_spacing"));
    QCOMPARE(spectra[1].first.name, std::string("pitch"));
    QCOMPARE(spectra[0].second.segment, std::size_t{1000});
    QVERIFY(std::abs(spectra[0].second.frequency[25] - 250e3) < 1e-6);
    QVERIFY(std::abs(spectra[0].second.power[25] / (2e-9 * 2e-9 / 2.0) - 1.0) < 1e-9);
    QVERIFY(std::abs(spectra[1].second.power[50] / (3e-6 * 3e-6 / 2.0) - 1.0) < 1e-9);
}

void TestRunSpectra::tooFewSamples()
{
    RunSpectra recorder(testCase(), quantities);
    feed(recorder, 7, 0.0);
    QVERIFY(recorder.spectra().empty());
}

TOUCHDOWN_TEST(TestRunSpectra)

} // namespace test_run_spectra

#include "test_run_spectra.moc"

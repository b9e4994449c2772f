// SPDX-License-Identifier: GPL-3.0-or-later
//
// Spectra of finished runs are computed once; one run speaks.
#include "ui/runs/live_spectrum.h"

#include <cmath>
#include <memory>
#include <numbers>

#include <QTest>

#include "core/simulation/static_state/steady.h"
#include "tests/support/test_program.h"
#include "ui/plot/spectrum_view.h"
#include "ui/runs/run_record.h"
#include "ui/runs/runs_model.h"

using namespace touchdown;

namespace test_live_spectrum {

class TestLiveSpectrum : public QObject {
    Q_OBJECT

private slots:
    void init();
    void cleanup() { spectrum_.reset(), runs_.reset(); }

    void computesAFinishedRunOnce();
    void computesOnceForEachQuantity();
    void theEndBetweenSamplesIsLeftOut();
    void aLongRunIsComputedOnAnotherThread();
    void aLiveSpectrumComesFourTimesASecond();
    void theNewestSpeaks();
    void offersTheLinesOfTheNewestCase();
    void offersModesOfTheSameFilm();

private:
    void add(int number, double frequency, bool finished = true, Case c = {}, int samples = 4000);
    const PlotCurve& curve(int number) const;

    std::unique_ptr<RunsModel> runs_;
    std::unique_ptr<LiveSpectrum> spectrum_;
};

/// A sine of the frequency [Hz], sampled every 1 us.
void TestLiveSpectrum::add(int number, double frequency, bool finished, Case c, int samples)
{
    c.title = "A sine";
    c.run.duration = 1e-6 * samples;
    c.run.sampleInterval = 1e-6;
    auto run = std::make_unique<RunRecord>(
        number, c, "",
        std::vector<Quantity>{{"minimum_spacing", "m", "nm", "Minimum spacing"}, {"pitch", "rad", "urad", "Pitch"}});
    SampleBatch batch;
    batch.columns.resize(2);
    for (int k = 0; k < samples; ++k) {
        batch.time.push_back(1e-6 * k);
        for (std::vector<double>& column : batch.columns)
            column.push_back(1e-9 * std::sin(2.0 * std::numbers::pi * frequency * 1e-6 * k));
    }
    run->append(batch, {});
    runs_->add(std::move(run));
    if (!finished) return;
    runs_->finish(number, Summary{});
    spectrum_->runFinished(number);
}

const PlotCurve& TestLiveSpectrum::curve(int number) const
{
    for (const PlotCurve& each : spectrum_->view()->plot()->curves())
        if (each.id == QStringLiteral("run %1").arg(number)) return each;
    qFatal("no spectrum of run %d", number);
}

void TestLiveSpectrum::init()
{
    runs_ = std::make_unique<RunsModel>();
    spectrum_ = std::make_unique<LiveSpectrum>(*runs_);
    spectrum_->resize(700, 300);
    spectrum_->show();
    QVERIFY(QTest::qWaitForWindowExposed(spectrum_.get()));
}

void TestLiveSpectrum::computesAFinishedRunOnce()
{
    for (int number = 1; number <= 3; ++number) add(number, 50e3 * number);
    QTRY_COMPARE(spectrum_->view()->plot()->curves().size(), std::size_t(3));
    const long long before = spectrum_->computed();
    QCOMPARE(before, 3);
    runs_->setData(runs_->index(0), Qt::Unchecked, Qt::CheckStateRole);
    QVERIFY(!curve(1).visible);
    runs_->setData(runs_->index(0), Qt::Checked, Qt::CheckStateRole);
    QVERIFY(curve(1).visible);
    spectrum_->hide();
    spectrum_->show();
    QCOMPARE(spectrum_->computed(), before);
}

void TestLiveSpectrum::computesOnceForEachQuantity()
{
    add(1, 50e3);
    add(2, 100e3);
    QTRY_COMPARE(spectrum_->computed(), 2);
    for (const QString& quantity :
         {QStringLiteral("pitch"), QStringLiteral("minimum_spacing"), QStringLiteral("pitch")}) {
        spectrum_->view()->setQuantity(quantity);
        emit spectrum_->view()->requested(quantity, spectrum_->view()->options());
    }
    QCOMPARE(spectrum_->computed(), 4);
    QCOMPARE(spectrum_->view()->plot()->curves().size(), std::size_t(2));
}

void TestLiveSpectrum::aLiveSpectrumComesFourTimesASecond()
{
    QElapsedTimer clock;
    clock.start(); // before the run: its spectrum is due a while after it was added
    add(1, 50e3, false);
    for (int count = 1; count <= 3; ++count) {
        QVERIFY(QTest::qWaitFor([&] {
            spectrum_->dataArrived(1); // more often than it is drawn
            return spectrum_->computed() >= count;
        }));
        QCOMPARE(spectrum_->computed(), count);
        QVERIFY(clock.elapsed() >= 235 * count); // a coarse timer of 250 ms may be 5 % early
    }
}

void TestLiveSpectrum::theNewestSpeaks()
{
    add(1, 50e3);
    add(2, 100e3);
    QTRY_COMPARE(spectrum_->view()->plot()->curves().size(), std::size_t(2));
    QVERIFY(curve(1).pale && !curve(2).pale && curve(2).leads);
    // Its peak, 100 kHz, is marked and ends the axis: 125 kHz, rounded up.
    QCOMPARE(spectrum_->view()->plot()->pointMarks().size(), std::size_t(1));
    QCOMPARE(spectrum_->view()->plot()->xAxis().range().high, 150e3);
    runs_->raise(1);
    QVERIFY(!curve(1).pale && curve(2).pale);
    QVERIFY(curve(2).leads); // the ranges stay
    runs_->raise(-1);
    QVERIFY(curve(1).pale);
    // Until the next run has a spectrum, this one leads.
    add(3, 150e3, false);
    QVERIFY(curve(2).leads);
}

/// The default case has springs and a contact: two modes and one frequency of contact.
void TestLiveSpectrum::offersTheLinesOfTheNewestCase()
{
    SpectrumView* view = spectrum_->view();
    QVERIFY(view->plot()->actions().isEmpty());
    add(1, 50e3);
    QTRY_COMPARE(view->plot()->actions().size(), 2);
    view->linesWanted(FrequencyKind::Mode)->trigger();
    view->linesWanted(FrequencyKind::Contact)->trigger();
    QCOMPARE(view->plot()->referenceLines().size(), std::size_t(3));
    runs_->remove(0);
    QTRY_VERIFY(view->plot()->actions().isEmpty());
    QVERIFY(view->plot()->referenceLines().empty());
}

/// Not with another skew; with the same film again, whatever the run.
void TestLiveSpectrum::offersModesOfTheSameFilm()
{
    Case film;
    film.model = ModelKind::Film;
    film.contact = noContact;
    const auto* lines = spectrum_->view()->linesWanted(FrequencyKind::Mode);
    const PlotWidget* plot = spectrum_->view()->plot();
    add(1, 50e3, true, film);
    QTRY_COMPARE(plot->curves().size(), std::size_t(1));
    QVERIFY(plot->actions().isEmpty());
    ModesResult result;
    result.modes.resize(2);
    result.modes[0].frequency = 98.3e3;
    result.modes[0].kind = "pitch";
    result.modes[1].frequency = 201e3;
    result.modes[1].kind = "vertical";
    Case other = film;
    other.disk.skew = 0.1;
    spectrum_->setFilmModes(other, result);
    QVERIFY(plot->actions().isEmpty());
    Case longer = film;
    longer.run.duration = 1.0;
    spectrum_->setFilmModes(longer, result);
    QVERIFY(plot->actions().contains(lines));
    spectrum_->view()->linesWanted(FrequencyKind::Mode)->trigger();
    QCOMPARE(plot->referenceLines().size(), std::size_t(2));
    QVERIFY(plot->referenceLines()[1].label.startsWith("vertical mode 201.0"));
    add(2, 50e3, true, other);
    QTRY_VERIFY(plot->referenceLines().empty());
}

/// The end of a run between two samples; what it is has no effect.
void TestLiveSpectrum::theEndBetweenSamplesIsLeftOut()
{
    add(1, 50e3, true, {}, 4000);
    const RunRecord& run = *runs_->find(1);
    const auto spectrum = [&] { return spectrumOf(run, "minimum_spacing", spectrum_->view()->options(), 0.0); };
    const Spectrum before = spectrum();
    const MinMaxPyramid& column = *run.pyramid("minimum_spacing");
    const double interval = column.time(1) - column.time(0);
    SampleBatch end;
    end.time = {column.lastTime() + 0.3 * interval};
    end.columns.assign(run.quantities.size(), {1e-6});
    runs_->append(1, end, {});
    QVERIFY(!before.empty());
    QVERIFY(spectrum().power == before.power);
}

/// The window does not wait for it; the spectrum is that of the whole run, not only of its newest part.
void TestLiveSpectrum::aLongRunIsComputedOnAnotherThread()
{
    constexpr int samples = 300'000;
    add(1, 50e3, true, {}, samples);
    QVERIFY(spectrum_->view()->plot()->curves().empty());
    QTRY_COMPARE(spectrum_->view()->plot()->curves().size(), std::size_t(1));
    const RunRecord& run = *runs_->find(1);
    const Spectrum whole = spectrumOf(run, "minimum_spacing", spectrum_->view()->options(), 0.0);
    QCOMPARE(curve(1).data->valueAt(whole.frequency[100]), std::optional(whole.power[100]));
    QCOMPARE(spectrum_->computed(), 1);
    spectrum_->runFinished(1);
    QTRY_VERIFY(spectrum_->complete()); // nothing more is on its way
    QCOMPARE(spectrum_->computed(), 1);
    // What is no longer wanted when it is ready is not shown.
    add(2, 60e3, true, {}, samples);
    runs_->remove(runs_->rowOf(2));
    QTRY_COMPARE(spectrum_->computed(), 2);
    QCOMPARE(spectrum_->view()->plot()->curves().size(), std::size_t(1));
}

TOUCHDOWN_TEST(TestLiveSpectrum)

} // namespace test_live_spectrum

#include "test_live_spectrum.moc"

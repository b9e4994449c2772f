// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/recording/last_sample.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <QtTest>

#include "core/case/contact_kind.h"
#include "core/case/integrator_kind.h"
#include "core/results/csv_writer.h"
#include "core/results/results_reader.h"
#include "core/results/results_writer.h"
#include "core/simulation/recording/run_spectra.h"
#include "core/simulation/recording/run_statistics.h"
#include "core/simulation/run.h"
#include "tests/support/sample_case.h"
#include "tests/support/sample_results.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_last_sample {

namespace fs = std::filesystem;

/// The last line of a CSV file: time and values.
std::vector<double> lastRow(const fs::path& file)
{
    std::string text = bytes(file);
    while (text.ends_with('\n') || text.ends_with('\r')) text.pop_back();
    std::vector<double> row;
    for (const QString& cell : QString::fromStdString(text.substr(text.rfind('\n') + 1)).split(','))
        row.push_back(cell.toDouble());
    return row;
}

double finalOf(const Summary& summary, const std::string& name)
{
    for (const auto& [quantity, value] : summary.final)
        if (quantity == name) return value;
    return std::numeric_limits<double>::quiet_NaN();
}

class TestLastSample : public QObject {
    Q_OBJECT

private slots:
    /// All models; the intervals do not divide the duration, and the longest is nearly the whole of it.
    void finalValuesAreTheLastRowOfTheFiles_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<double>("duration"); // [s]
        for (const char* name : {"fig10a", "springs_waviness", "textbook_bounce"}) QTest::newRow(name) << name << 3e-5;
        for (const char* name : {"film_pico", "fig08_start_10nm", "advise_waviness", "advise_rough_contact"})
            QTest::newRow(name) << name << 1e-6;
        for (const char* name : {"contact_hertz", "contact_greenwood_williamson", "contact_ono_yamane"})
            QTest::newRow(name) << name << 2e-3;
    }
    void finalValuesAreTheLastRowOfTheFiles()
    {
        QFETCH(QString, name);
        QFETCH(double, duration);
        Case c = sample(name.toStdString());
        c.run.duration = duration;
        c.run.stepCheck = false;
        c.film.nodes = {17, 17};
        c.run.fieldSnapshots = 0;
        if (c.model == ModelKind::Contact && c.contact == ContactKind::Elastic) c.elastic.cell = c.pad.length / 16;
        std::mt19937 random(20261128);
        std::uniform_real_distribution<double> share(std::log(1.05), std::log(40.0));
        for (int k = 0; k < 5; ++k) {
            c.run.sampleInterval = duration / std::exp(share(random));
            QVERIFY(isBetweenSamples(duration, c.run.sampleInterval));
            const std::vector<Quantity> quantities = recordedQuantities(c);
            QTemporaryDir folder;
            const fs::path file = fs::path(folder.path().toStdString()) / "run.h5";
            const fs::path table = file.parent_path() / "run.csv";
            ResultsWriter results;
            CsvWriter csv;
            QCOMPARE(results.open(file, c, "", quantities), std::string());
            QCOMPARE(csv.open(table, quantities), std::string());
            const Summary summary = run(c, [&](const RunUpdate& update) {
                return results.append(update.samples).empty() && csv.append(update.samples).empty();
            });
            QVERIFY2(summary.status == RunStatus::Completed, summary.message.c_str());
            QCOMPARE(results.finish(summary), std::string());
            QCOMPARE(csv.close(), std::string());
            const StoredRun stored = readResults(file);
            QCOMPARE(stored.samples.time.back(), summary.endTime);
            QCOMPARE(summary.endTime, duration);
            const std::vector<double> row = lastRow(table);
            QCOMPARE(row.size(), quantities.size() + 1);
            QVERIFY(row[0] == duration);
            for (std::size_t i = 0; i < quantities.size(); ++i) {
                const double value = finalOf(summary, quantities[i].name);
                QVERIFY2(stored.samples.columns[i].back() == value, quantities[i].name.c_str());
                QVERIFY2(row[i + 1] == value, quantities[i].name.c_str());
            }
            QVERIFY(!summary.tail.empty());
            for (const auto& [quantity, tail] : summary.tail) {
                const double value = finalOf(summary, quantity);
                QVERIFY2(tail.min <= value && value <= tail.max, quantity.c_str());
                // No other sample is in the last tenth.
                const std::vector<double>& time = stored.samples.time;
                if (time.size() > 1 && time[time.size() - 2] < 0.9 * duration) QCOMPARE(tail.mean, value);
            }
        }
    }
    void theLastSampleOfAStoppedRunIsWhereItStopped_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"fig10a", "film_pico", "contact_greenwood_williamson"}) QTest::newRow(name) << name;
    }
    void theLastSampleOfAStoppedRunIsWhereItStopped()
    {
        QFETCH(QString, name);
        Case c = sample(name.toStdString());
        c.film.nodes = {17, 17};
        c.run.duration = 1.0;
        c.run.sampleInterval = c.model == ModelKind::Contact ? 0.7e-3 : 0.3e-6;
        if (c.model == ModelKind::Contact) c.approach.closest *= 0.5;
        SampleBatch last;
        double time = 0.0;
        const Summary summary = run(c, [&](const RunUpdate& update) {
            if (update.samples.size() > 0) {
                last.columns.clear();
                for (const std::vector<double>& column : update.samples.columns)
                    last.columns.push_back({column.back()});
                time = update.samples.time.back();
            }
            return time < 1e-6;
        });
        QCOMPARE(summary.status, RunStatus::Cancelled);
        QCOMPARE(time, summary.endTime);
        const std::vector<Quantity> quantities = recordedQuantities(c);
        for (std::size_t i = 0; i < quantities.size(); ++i)
            QVERIFY2(last.columns[i].back() == finalOf(summary, quantities[i].name), quantities[i].name.c_str());
    }
    /// The state at which a run was found to diverge is none of its samples.
    void theLastSampleOfADivergedRunIsSane()
    {
        Case c = sample("fig10a");
        c.run.integrator = IntegratorKind::Rk4;
        c.run.step = 2e-6;
        c.run.sampleInterval = 3e-6;
        double time = 0.0, height = 0.0;
        const auto column = std::size_t(findQuantity(recordedQuantities(c), "flying_height"));
        const Summary summary = run(c, [&](const RunUpdate& update) {
            if (update.samples.size() == 0) return true;
            time = update.samples.time.back();
            height = update.samples.columns[column].back();
            return true;
        });
        QVERIFY(summary.status == RunStatus::Diverged || summary.status == RunStatus::Failed);
        QVERIFY(std::isfinite(height));
        QVERIFY(time <= summary.endTime);
        QCOMPARE(finalOf(summary, "flying_height"), height);
    }

    /// A sine of 100 kHz, sampled each 0.1 us over 2 ms; a last sample 0.03 us after the others has any value.
    void spectraAndVerdictsLeaveTheLastSampleOut()
    {
        Case c;
        c.run.duration = 2e-3 + 0.03e-6;
        c.run.sampleInterval = 0.1e-6;
        const std::vector<Quantity> quantities = recordedQuantities(c);
        RunStatistics even(c, quantities), between(c, quantities);
        RunSpectra evenSpectra(c, quantities), betweenSpectra(c, quantities);
        const auto add = [&](double time, double value, RunStatistics& statistics, RunSpectra& spectra) {
            const std::vector<double> values(quantities.size(), value);
            statistics.addSample(time, values, values, values);
            spectra.add({{time}, std::vector<std::vector<double>>(quantities.size(), {value})});
        };
        for (int k = 0; k <= 20000; ++k) {
            const double time = k * c.run.sampleInterval, value = 7e-9 + 1e-9 * std::sin(2e5 * std::numbers::pi * time);
            add(time, value, even, evenSpectra);
            add(time, value, between, betweenSpectra);
        }
        add(c.run.duration, 7e-9 + 50e-9, between, betweenSpectra);
        Summary expected, found;
        even.finish(expected);
        between.finish(found);
        QCOMPARE(found.verdict.motion, expected.verdict.motion);
        QVERIFY(lasts(found.verdict.motion));
        QCOMPARE(found.verdict.rule, expected.verdict.rule);
        QCOMPARE(found.peaks.size(), expected.peaks.size());
        QCOMPARE(found.peaks.front().amplitude, expected.peaks.front().amplitude);
        for (std::size_t i = 0; i < evenSpectra.spectra().size(); ++i)
            QCOMPARE(betweenSpectra.spectra()[i].second.power, evenSpectra.spectra()[i].second.power);
        QCOMPARE(found.tail.front().second.max, 57e-9);
    }
    /// Samples of 1 at 0, 1, ... 7 intervals, one of 2 at 7.25. From 0.97 of this time on (7.03 intervals) there is the
    /// last one alone; from 0.5 on (3.6) those at 4 to 7, and the last one with the weight 0.25.
    void theLastSampleWeighsByItsInterval()
    {
        BlockStatistics blocks;
        for (int k = 0; k < 8; ++k) blocks.add(1.0);
        blocks.add(2.0, 2.0, 2.0, 0.25);
        QCOMPARE(blocks.over(0.97, 1.0).mean, 2.0);
        QCOMPARE(blocks.over(0.5, 1.0).mean, (4.0 + 0.5) / 4.25);
    }
};

TOUCHDOWN_TEST(TestLastSample)

} // namespace test_last_sample

#include "test_last_sample.moc"

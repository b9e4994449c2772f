// SPDX-License-Identifier: GPL-3.0-or-later
//
// The progress of each kind of study moves with its work: not at the end of runs alone, and not all at once.
#include <algorithm>
#include <vector>

#include <QTest>

#include "core/studies/study_plan.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_study_progress {

using Texts = std::vector<std::string>;

constexpr const char* twoDrops = R"(
kind = "statements"
case = "fig10a"
set = { "run.duration" = "100 ms" }
[[statement]]
figure = "Fig. 10"
quote = "It flies."
end = ["flying"]
[[statement]]
figure = "Fig. 12"
quote = "It ends in contact."
case = "fig12a"
end = ["contact"]
)";

class TestStudyProgress : public QObject {
    Q_OBJECT

private slots:
    void sharesFollowTheWork_data()
    {
        QTest::addColumn<StudyPlan>("plan");
        const auto add = [](const char* kind, const char* name, const Texts& settings = {}, const Texts& options = {}) {
            QTest::newRow(kind) << openStudy(kind, name, settings, options);
        };
        // The budget is of wall time: this one is not spent on a busy machine, either.
        add("work-precision", "precision_springs", {}, {"budget=600 s", "repeats=1"});
        add("stability", "stability_start_height", {"run.duration=0.3 ms"});
        add("hysteresis", "hysteresis_take_off");
        add("cycles", "cycles_meniscus_force");
        add("response", "response_waviness");
        add("convergence", "convergence_film_femto", {}, {"grids=[33, 49, 65, 97]", "reference=129"});
        add("advise", "advise_quiet", {"film.nodes=[49, 33]"}, {"models=[\"static\", \"parts\"]"});
        QTest::newRow("statements") << parseStudy("statements", twoDrops, "text", {});
        // Moves before the first value has been held.
        QTest::newRow("hysteresis of a film")
            << openStudy("hysteresis", "hysteresis_disk_speed", {"film.nodes=[49, 33]"},
                         {"steps=1", "hold=20 us", "equilibria=false"});
    }
    void sharesFollowTheWork()
    {
        QFETCH(StudyPlan, plan);
        QVERIFY2(plan.valid(), plan.valid() ? "" : plan.problems.front().text().c_str());
        std::vector<double> shares;
        const StudyReport report = plan.perform(2, [&](const StudyProgress& progress) {
            if (shares.empty() || progress.share != shares.back()) shares.push_back(progress.share);
            return true;
        });
        QVERIFY2(report.status == StudyStatus::Completed, report.message.c_str());
        QVERIFY2(std::ranges::is_sorted(shares), "the bar jumps back");
        std::erase_if(shares, [](double share) { return share <= 0.02 || share >= 0.98; });
        QVERIFY2(shares.size() >= 4, std::to_string(shares.size()).c_str());
        shares.insert(shares.begin(), 0.0);
        shares.push_back(1.0);
        double gap = 0.0; // the largest jump of the bar
        for (std::size_t i = 1; i < shares.size(); ++i) gap = std::max(gap, shares[i] - shares[i - 1]);
        QVERIFY2(gap < 0.5, std::to_string(gap).c_str());
    }
    /// Of a search nobody knows when its targets are reached, and it says so.
    void aSearchHasAnOpenEnd()
    {
        QVERIFY(!openStudy("design", "film_fig4_pico").openEnd.empty());
        QVERIFY(openStudy("cycles", "cycles_meniscus_force").openEnd.empty());
    }
};

TOUCHDOWN_TEST(TestStudyProgress)

} // namespace test_study_progress

#include "test_study_progress.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/stability/closing_gap.h"

#include <algorithm>

#include <QTest>

#include "core/case_files/case_file.h"
#include "core/physics/film/slip_model.h"
#include "core/studies/stability/stability_curves.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_closing_gap {

StudyReport pictureOf(SlipModel model, double blendWidth = 0.0)
{
    Case c = openCase("film_pico").value;
    c.air.slip.model = model;
    c.air.slip.blendWidth = blendWidth;
    StudyReport picture;
    addClosingGap(c, picture);
    return picture;
}
bool says(const std::vector<std::string>& sentences, const std::string& what)
{
    return std::ranges::any_of(sentences,
                               [&](const std::string& each) { return each.find(what) != std::string::npos; });
}

class TestClosingGap : public QObject {
    Q_OBJECT

private slots:
    /// Models without a second-order term grow by more than half a decade, those with one by less, at the speed and in
    /// the air of a case.
    void eachModel()
    {
        const StudyReport picture = pictureOf(SlipModel::FukuiKaneko);
        QCOMPARE(picture.charts.size(), std::size_t{1});
        const StudyTable& table = picture.tables.front();
        QCOMPARE(table.rows.size(), slipLaws().size());
        for (const auto& row : table.rows) {
            const std::string slip = std::get<std::string>(row[0]);
            const auto law = std::ranges::find(slipLaws(), slip, &SlipLaw::name);
            const double growth = std::get<double>(row[4]);
            const bool second = law->second > 0.0 || slip == "combination";
            QVERIFY2(growth >= 1.0 && (growth < 1.5) == second,
                     qPrintable(QString("%1: %2").arg(slip.c_str()).arg(growth)));
        }
        for (const ChartSeries& series : picture.charts[0].panels[0].series)
            for (const ChartPoint& point : series.points) QVERIFY(point.x > 0.0 && point.y > 0.0);
    }
    void saysWhatTheCasesOwnModelDoes()
    {
        QVERIFY(says(pictureOf(SlipModel::FukuiKaneko).findings, "fukui-kaneko, lets the pressure grow without bound"));
        QVERIFY(says(pictureOf(SlipModel::NewSecondOrder).findings, "keeps the pressure bounded"));
    }
    /// Q of Fukui-Kaneko over that of the new second order at 0.3 nm: 6 Q_P(D)/D with D = sqrt(pi)/2/Kn, by 1 + 4 Kn +
    /// 3 Kn^2. At ten times ambient Kn = 63.5/3 = 21: D = 0.042, Q_P = 2.38, Q = 341 by 1430.
    void theHardSwitch()
    {
        const StudyReport hard = pictureOf(SlipModel::Combination);
        QVERIFY(says(hard.warnings, "hard switch of slip at 0.3 nm") && says(hard.warnings, "0.24 at ten times"));
        QVERIFY(!says(pictureOf(SlipModel::Combination, 0.1e-9).warnings, "hard switch"));
    }
};

TOUCHDOWN_TEST(TestClosingGap)

} // namespace test_closing_gap

#include "test_closing_gap.moc"

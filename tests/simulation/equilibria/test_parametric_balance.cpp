// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/equilibria/parametric_balance.h"

#include <functional>

#include <QTest>

#include "tests/support/menisci_slider.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

using ChangeTo = std::function<void(Case&, double)>;
Q_DECLARE_METATYPE(ChangeTo)

namespace test_parametric_balance {

class TestParametricBalance : public QObject {
    Q_OBJECT

private slots:
    void valuesShareTheGapsOfTheirSlider_data()
    {
        QTest::addColumn<ChangeTo>("change");
        QTest::addColumn<bool>("shared");
        const auto row = [](const char* name, bool shared, ChangeTo change) {
            QTest::newRow(name) << change << shared;
        };
        row("preload", true, [](Case& c, double p) { c.suspension.preload *= p; });
        row("speed of the disk", true, [](Case& c, double p) { c.disk.speed *= p; });
        row("ambient pressure", true, [](Case& c, double p) { c.air.given.pressure *= p; });
        row("crown", false, [](Case& c, double p) { c.surface.crown *= p; });
        row("a recess", false, [](Case& c, double p) { c.surface.rails[0].recess[0] *= p; });
    }
    /// Gaps are made once where the surface does not change with the value. Where it does, each value has its own: as
    /// those of the case itself.
    void valuesShareTheGapsOfTheirSlider()
    {
        QFETCH(ChangeTo, change);
        QFETCH(bool, shared);
        const CaseAt at = [&](double value) {
            Case c = smallCase();
            change(c, value);
            return c;
        };
        std::vector<std::string> problems;
        ParametricBalance balance(at, 0.98, 1.02, always);
        QCOMPARE(balance.look(2, problems).size(), std::size_t(2));
        const auto first = balance.balanceAt(0.0), second = balance.balanceAt(1.0);
        QCOMPARE(first->level().film.sharedGaps() == second->level().film.sharedGaps(), shared);
        for (const auto& [each, p] : {std::pair(&first, 0.0), std::pair(&second, 1.0)}) {
            const Case c = *at(balance.parameter(p));
            const FilmGaps own(Recess(c.surface, c.slider.length, c.slider.width), (*each)->level().gaps.grid);
            QVERIFY((*each)->level().gaps.centreRecess == own.centreRecess);
        }
    }
    /// Two values stand beside each other at attitudes of their own.
    void valuesHaveFilmsOfTheirOwn()
    {
        const CaseAt at = [](double preload) {
            Case c = smallCase();
            c.suspension.preload = preload;
            return c;
        };
        std::vector<std::string> problems;
        ParametricBalance balance(at, 8e-3, 12e-3, always);
        const std::vector<ParametricBalance::Look> looks = balance.look(2, problems);
        QCOMPARE(looks.size(), std::size_t(2));
        const auto solved = [&](double p, const Attitude& rest) {
            auto here = balance.balanceAt(p);
            const Vector3 q = here->body().coordinates(rest);
            return here->solve(q, always) ? std::move(here) : nullptr;
        };
        const auto light = solved(0.0, looks[0].rest), heavy = solved(1.0, looks[1].rest);
        QVERIFY(light && heavy);
        // Each is a static state, which the grid in the middle of the range changes by less than a thousandth.
        QVERIFY(light->error(light->force(ContactRegion::Apart)) < 1e-3);
        QVERIFY(heavy->error(heavy->force(ContactRegion::Apart)) < 1e-3);
        QVERIFY(light->spacing(light->place()) > heavy->spacing(heavy->place()) + 1e-9);
    }
};

TOUCHDOWN_TEST(TestParametricBalance)

} // namespace test_parametric_balance

#include "test_parametric_balance.moc"

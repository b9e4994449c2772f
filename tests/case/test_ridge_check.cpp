// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/ridge_check.h"

#include <QTest>

#include "core/case/parameters.h"
#include "tests/support/small_slider.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_ridge_check {

/// The rear step of the small slider, 120 nm deep, with walls that begin at recess 0 on three of its edges.
Case ridgedSlider()
{
    Case c = test::smallSlider();
    c.surface.walls = {{.distance = {0.0, 2e-6}, .recess = {0.0, c.surface.baseRecess}}};
    for (const std::size_t point : {0u, 2u, 3u}) c.surface.rails[3].points[point].wall = 1;
    return c;
}

/// The numbers of edges that the warnings name; empty without such a warning.
QStringList edges(const Case& c)
{
    QStringList result;
    for (const CaseProblem& warning : caseWarnings(c))
        if (warning.key == "film.nodes") result << QString::fromStdString(warning.message).section(' ', 0, 1);
    return result;
}

class TestRidgeCheck : public QObject {
    Q_OBJECT

private slots:
    void warns()
    {
        Case c = ridgedSlider();
        QCOMPARE(edges(c), QStringList{"3 edges"});
        c.film.grid = GridKind::Uniform;
        QCOMPARE(edges(c), QStringList{"3 edges"});
        c.surface.rails[3].points[0].wall = c.surface.rails[3].points[3].wall = 0;
        QCOMPARE(edges(c), QStringList{"1 edge"});
    }
    void staysSilent()
    {
        QCOMPARE(edges(test::smallSlider()), QStringList());
        Case c = ridgedSlider();
        c.film.accuracy = 0.01; // the grid is not known
        QCOMPARE(edges(c), QStringList());
        c = ridgedSlider();
        c.model = ModelKind::Springs; // no film
        QCOMPARE(edges(c), QStringList());
        c = ridgedSlider();
        c.surface.walls.clear(); // the surface has problems
        QCOMPARE(edges(c), QStringList());
        c = ridgedSlider();
        c.surface.walls[0].recess[0] = c.surface.rails[3].recess[0]; // the walls begin at their rail's recess
        QCOMPARE(edges(c), QStringList());
    }
    void words()
    {
        QCOMPARE(ridgeWords(0), std::string());
        QVERIFY(ridgeWords(1).starts_with("1 edge has") && ridgeWords(7).starts_with("7 edges have"));
    }
};

TOUCHDOWN_TEST(TestRidgeCheck)

} // namespace test_ridge_check

#include "test_ridge_check.moc"

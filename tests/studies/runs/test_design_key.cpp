// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/runs/design_key.h"

#include <QTest>

#include "tests/support/small_slider.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_design_key {

DesignKey key(const Case& c, const char* name)
{
    auto found = designKey(c, name);
    if (const auto* problem = std::get_if<std::string>(&found)) qFatal("%s %s", name, problem->c_str());
    return std::get<DesignKey>(std::move(found));
}

bool near(double a, double b) { return std::abs(a - b) < 1e-15; } // [m]

class TestDesignKey : public QObject {
    Q_OBJECT

private slots:
    void field()
    {
        Case c = test::smallSlider();
        const DesignKey offset = key(c, "suspension.offset_x");
        QCOMPARE(offset.unit, std::string("m"));
        QCOMPARE(offset.get(c), 0.02e-3);
        QVERIFY(!offset.set(c, -0.01e-3));
        QCOMPARE(c.suspension.offsetX, -0.01e-3);
        const DesignKey preload = key(c, "suspension.preload");
        const double before = c.suspension.preload;
        QVERIFY(preload.set(c, 1e9).has_value());
        QCOMPARE(c.suspension.preload, before);
    }
    /// The rear pad reaches from x = 0.88 to 0.97 mm and from y = 0.33 to 0.47 mm.
    void railIsMoved()
    {
        Case c = test::smallSlider();
        const DesignKey x = key(c, "abs.rail[5].x");
        QVERIFY(near(x.get(c), 0.925e-3));
        QVERIFY(!x.set(c, 0.915e-3));
        QVERIFY(near(c.surface.rails[4].points[0].x, 0.87e-3) && near(c.surface.rails[4].points[1].x, 0.96e-3));
        QVERIFY(!key(c, "abs.rail[5].y").set(c, 0.41e-3));
        QVERIFY(near(c.surface.rails[4].points[0].y, 0.34e-3) && near(c.surface.rails[4].points[2].y, 0.48e-3));
    }
    void railIsStretched()
    {
        Case c = test::smallSlider();
        const DesignKey width = key(c, "abs.rail[5].width");
        QVERIFY(near(width.get(c), 0.14e-3));
        QVERIFY(!width.set(c, 0.07e-3));
        QVERIFY(near(c.surface.rails[4].points[0].y, 0.365e-3) && near(c.surface.rails[4].points[2].y, 0.435e-3));
        QVERIFY(!key(c, "abs.rail[5].length").set(c, 0.18e-3));
        QVERIFY(near(c.surface.rails[4].points[0].x, 0.835e-3) && near(c.surface.rails[4].points[1].x, 1.015e-3));
        QVERIFY(width.set(c, 0.0).has_value());
        QVERIFY(near(width.get(c), 0.07e-3));
    }
    void recess()
    {
        Case c = test::smallSlider();
        QVERIFY(!key(c, "abs.rail[4].recess").set(c, 90e-9));
        QVERIFY(c.surface.rails[3].recess == (std::array{90e-9, 0.0, 0.0}));
    }
    /// A ramp from 300 to 50 nm, moved by 10 nm.
    void ramp()
    {
        Case c = test::smallSlider();
        c.surface.rails[0].kind = RailKind::Ramp;
        c.surface.rails[0].recess = {300e-9, 50e-9, 50e-9};
        QVERIFY(!key(c, "abs.rail[1].recess").set(c, 310e-9));
        QVERIFY(near(c.surface.rails[0].recess[1], 60e-9) && near(c.surface.rails[0].recess[2], 60e-9));
    }

    void refuses_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("says");
        QTest::newRow("a slip of the pen") << "suspension.ofset_x"
                                           << "is no key of a case; did you mean suspension.offset_x?";
        QTest::newRow("a choice") << "film.grid"
                                  << "is no number with a range to search";
        QTest::newRow("of another model") << "springs.cutoff"
                                          << "has no part in this case";
        QTest::newRow("a rail that is not there") << "abs.rail[6].x"
                                                  << "there is no rail 6; the case has 5";
        QTest::newRow("rail 0") << "abs.rail[0].x"
                                << "there is no rail 0; the case has 5";
        QTest::newRow("no number") << "abs.rail[a].x"
                                   << "is no key of a rail, such as abs.rail[1].width";
        QTest::newRow("an open bracket") << "abs.rail[1"
                                         << "is no key of a rail, such as abs.rail[1].width";
        QTest::newRow("points") << "abs.rail[1].points"
                                << "a study changes recess, x, y, length or width of a rail";
    }
    void refuses()
    {
        QFETCH(QString, name);
        QFETCH(QString, says);
        const auto found = designKey(test::smallSlider(), name.toStdString());
        QVERIFY(std::holds_alternative<std::string>(found));
        QCOMPARE(QString::fromStdString(std::get<std::string>(found)), says);
    }
};

TOUCHDOWN_TEST(TestDesignKey)

} // namespace test_design_key

#include "test_design_key.moc"

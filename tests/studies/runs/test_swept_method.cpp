// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/runs/swept_method.h"

#include <QTest>

#include "tests/support/sample_case.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_swept_method {

std::vector<std::string> labelsOf(const SweptMethod& method)
{
    std::vector<std::string> labels;
    for (const MethodSetting& setting : method.settings) labels.push_back(setting.label);
    return labels;
}

class TestSweptMethod : public QObject {
    Q_OBJECT

private slots:
    void goesFromCoarseToFine_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("key");
        QTest::addColumn<QStringList>("values");
        QTest::addColumn<QStringList>("order");
        QTest::newRow("steps, in several units")
            << "fig10b_naive_switching"
            << "run.step" << QStringList{"1 ns", "1 us", "20 ns"} << QStringList{"1 us", "20 ns", "1 ns"};
        QTest::newRow("tolerances") << "fig10a"
                                    << "run.tolerance" << QStringList{"1e-9", "1e-4", "1e-12"}
                                    << QStringList{"1e-4", "1e-9", "1e-12"};
        QTest::newRow("nodes") << "film_plane"
                               << "film.nodes" << QStringList{"97", "33", "65, 33"}
                               << QStringList{"33", "65, 33", "97"};
        QTest::newRow("schemes have no order") << "film_plane"
                                               << "film.scheme" << QStringList{"upwind", "complete-flux", "hybrid"}
                                               << QStringList{"upwind", "complete-flux", "hybrid"};
        QTest::newRow("nor has what is not the solution's")
            << "fig10a"
            << "springs.cutoff" << QStringList{"2 nm", "1 nm", "3 nm"} << QStringList{"2 nm", "1 nm", "3 nm"};
    }
    void goesFromCoarseToFine()
    {
        QFETCH(QString, name);
        QFETCH(QString, key);
        QFETCH(QStringList, values);
        QFETCH(QStringList, order);
        MethodSpec spec{.name = "m", .set = {}, .key = key.toStdString()};
        for (const QString& value : values) spec.values.push_back(value.toStdString());
        SweptMethod method;
        QVERIFY(!makeMethod(sample(name.toStdString()), spec, method, false));
        std::vector<std::string> expected;
        for (const QString& label : order) expected.push_back(label.toStdString());
        QCOMPARE(labelsOf(method), expected);
        QCOMPARE(method.ordered, key.startsWith("run.") || key.endsWith("nodes"));
    }

    /// The case's own value stands among the others, with no more figures than it is worth.
    void addsTheCasesOwn()
    {
        Case c = sample("fig10a");
        c.run.tolerance = 0.1 * 3e-7; // 2.9999999999999997e-8
        SweptMethod method;
        QVERIFY(!makeMethod(c, {"dopri5", {}, "run.tolerance", {"1e-6", "1e-10"}}, method));
        QCOMPARE(labelsOf(method), (std::vector<std::string>{"1e-6", "3e-8", "1e-10"}));
        QVERIFY(method.settings[1].chosen && !method.settings[0].chosen);
        QCOMPARE(method.settings[1].c.run.tolerance, c.run.tolerance);
    }

    void namesItself()
    {
        QCOMPARE(nameOf("rk4", "10 ns"), std::string("rk4 (10 ns)"));
        QCOMPARE(nameOf("rk4", ""), std::string("rk4"));
    }
};

TOUCHDOWN_TEST(TestSweptMethod)

} // namespace test_swept_method

#include "test_swept_method.moc"

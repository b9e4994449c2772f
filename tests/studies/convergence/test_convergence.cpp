// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/convergence/convergence.h"

#include <cmath>

#include <QTest>

#include "core/physics/contact/contact_bodies.h"
#include "tests/support/sample_case.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_convergence {

ConvergenceStudy solved(const Case& c, int levels, int jobs = 1)
{
    const StudyReport report = performItems(convergenceItems(c, levels), {.jobs = jobs}, {});
    ItemRows rows;
    for (const StudyItem& item : report.items) rows.emplace_back(item.row);
    return convergenceOf(c, levels, rows);
}

class TestConvergence : public QObject {
    Q_OBJECT

private slots:
    /// f = 1 + h^p with h = 4, 2, 1.
    void orders_data()
    {
        QTest::addColumn<double>("order");
        QTest::newRow("first") << 1.0;
        QTest::newRow("second") << 2.0;
        QTest::newRow("one and a half") << 1.5;
    }
    void orders()
    {
        QFETCH(double, order);
        const auto f = [&](double h) { return 1.0 + std::pow(h, order); };
        const ObservedOrder observed = observedOrder(f(4.0), f(2.0), f(1.0));
        QVERIFY(observed.order && std::abs(*observed.order - order) < 1e-12);
        QVERIFY(std::abs(observed.limit - 1.0) < 1e-12);
        QVERIFY(std::abs(observed.error - 1.0) < 1e-12);
    }
    void noOrder()
    {
        const ObservedOrder wavering = observedOrder(1.0, 3.0, 2.0); // +2, -1
        QVERIFY(!wavering.order);
        QCOMPARE(wavering.limit, 2.0);
        QCOMPARE(wavering.error, 2.0);
        QVERIFY(!observedOrder(1.0, 2.0, 4.0).order);        // growing
        QVERIFY(!observedOrder(0.0, 1.0, 1.0 + 1e-3).order); // by chance
        const ObservedOrder exact = observedOrder(1.0, 2.0, 2.0);
        QVERIFY(!exact.order);
        QCOMPARE(exact.error, 0.0);
    }

    /// Hertz, F = (4/3) E* sqrt(R d^3): the limit is nearer to it than the finest level, and as near as its error says.
    void hertz()
    {
        const Case c = sample("contact_hertz");
        const ConvergenceStudy study = solved(c, 4, 2);
        QCOMPARE(study.status, StudyStatus::Completed);
        QCOMPARE(study.levels.size(), std::size_t{4});
        QCOMPARE(study.levels[2].cell, c.elastic.cell);
        QCOMPARE(study.levels[0].cell, 4.0 * c.elastic.cell);
        QCOMPARE(study.levels[3].cells, 128LL * 128LL);
        const double force = 4.0 / 3.0 * contactModulus(c.elastic.pair) * std::sqrt(c.pad.radius * 1e-8) * 1e-8;
        QCOMPARE(study.quantities[0].name, std::string("contact_force"));
        QVERIFY(study.observed[0].order.has_value());
        QVERIFY(std::abs(study.observed[0].limit / force - 1.0) < 1e-4);
        QVERIFY(std::abs(study.observed[0].limit - force) < std::abs(study.levels[3].values[0] - force));
    }
    void doesNotDependOnJobs()
    {
        const Case c = sample("contact_rough");
        const ConvergenceStudy one = solved(c, 3, 1);
        const ConvergenceStudy three = solved(c, 3, 3);
        for (std::size_t i = 0; i < one.levels.size(); ++i) QCOMPARE(one.levels[i].values, three.levels[i].values);
    }
    void stops()
    {
        const StudyReport report =
            performItems(convergenceItems(sample("contact_hertz"), 5), {}, [](const StudyProgress&) { return false; });
        QCOMPARE(report.status, StudyStatus::Cancelled);
        QCOMPARE(report.tables.size(), std::size_t{1}); // no orders
        QVERIFY2(report.message.starts_with("stopped after "), report.message.c_str());
    }
    void noSolution()
    {
        Case c = sample("contact_hertz");
        c.elastic.maximumIterations = 1;
        const ConvergenceStudy study = solved(c, 3);
        QCOMPARE(study.status, StudyStatus::Failed);
        QVERIFY2(study.message.starts_with("cells of "), study.message.c_str());
    }

    void refuses_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("says");
        QTest::newRow("springs") << "fig10a"
                                 << "no grid";
        QTest::newRow("a characteristic") << "contact_ono_yamane"
                                          << "without a grid";
        QTest::newRow("a statistical surface") << "contact_greenwood_williamson"
                                               << "without a grid";
        QTest::newRow("an elastic contact") << "contact_hertz"
                                            << "";
    }
    void refuses()
    {
        QFETCH(QString, name);
        QFETCH(QString, says);
        const std::string reason = reasonNotToConverge(sample(name.toLatin1().constData()), standardLevels);
        QCOMPARE(reason.empty(), says.isEmpty());
        QVERIFY2(QString::fromStdString(reason).contains(says), reason.c_str());
    }
    /// A pad of 9 um is not a whole number of cells of 4 x 0.5 um.
    void refusesCellsThatDoNotFit()
    {
        Case c = sample("contact_rough");
        c.elastic.cell = 0.5e-6;
        c.pad.length = 9e-6;
        const std::string reason = reasonNotToConverge(c, 4);
        QVERIFY2(reason.starts_with("pad.length: 9 um with elastic.cell = 2 um is not a whole number"), reason.c_str());
        QCOMPARE(reasonNotToConverge(c, 3), std::string());
    }
};

TOUCHDOWN_TEST(TestConvergence)

} // namespace test_convergence

#include "test_convergence.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/command_process.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_convergence_command {

class TestConvergenceCommand : public QObject {
    Q_OBJECT

private slots:
    void init() { folder_ = std::make_unique<CommandFolder>(); }

    void levels()
    {
        const Outcome o = folder_->touchdown({"study", "convergence", "contact_hertz", "--json", "--levels", "3",
                                              "--jobs", "2", "--out", "a.h5", "--csv", "a.csv"});
        QCOMPARE(o.code, 0);
        QCOMPARE(o.err, QByteArray());
        const QJsonObject study = o.json();
        QCOMPARE(study["status"].toString(), QString("completed"));
        QVERIFY2(o.out.contains("separation -10 nm"), o.out);
        const QJsonArray tables = study["tables"].toArray();
        const QJsonArray levels = tables[0].toObject()["rows"].toArray();
        QCOMPARE(levels.size(), 3);
        QCOMPARE(levels.last().toObject()["cells"].toInt(), 128 * 128);
        const QJsonObject observed = tables[1].toObject()["rows"].toArray()[0].toObject();
        QCOMPARE(observed["quantity"].toString(), QString("contact_force"));
        QVERIFY(observed["limit"].toDouble() > 3.57e-3 && observed["limit"].toDouble() < 3.58e-3);
        QCOMPARE(folder_->files(), (QStringList{"a.csv", "a.h5"}));
    }
    void table()
    {
        const Outcome o = folder_->touchdown({"study", "convergence", "contact_hertz", "--levels", "3"});
        QCOMPARE(o.code, 0);
        for (const char* part : {"contact_force", "observed order", "limit", "error", "0.0625"})
            QVERIFY2(o.out.contains(part), part);
    }
    void film()
    {
        const Outcome o = folder_->touchdown({"study", "convergence", "film_femto", "--json", "--option", "grids=33,49",
                                              "--option", "reference=65", "--jobs", "2", "--csv", "a.csv"});
        QCOMPARE(o.code, 0);
        const QJsonArray runs = o.json()["tables"].toArray()[0].toObject()["rows"].toArray();
        QCOMPARE(runs.size(), 6); // two grids by three methods
        const QJsonObject coarse = runs[0].toObject();
        QCOMPARE(coarse["nodes"].toInt(), 33);
        const double ratio = coarse["stated_error"].toDouble() / coarse["error"].toDouble();
        QVERIFY(ratio > 0.0 && std::abs(coarse["ratio"].toDouble() / ratio - 1.0) < 1e-12);
        QCOMPARE(o.json()["charts"].toArray().size(), 2);
        QCOMPARE(folder_->files(), QStringList{"a.csv"});
    }
    void refuses_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("says");
        QTest::newRow("no case") << QStringList{"convergence"} << "convergence: FILE";
        QTest::newRow("springs") << QStringList{"convergence", "fig10a"} << "no grid";
        QTest::newRow("levels of a film") << QStringList{"convergence", "film_femto", "--levels", "4"} << "levels";
        QTest::newRow("one level") << QStringList{"convergence", "contact_hertz", "--levels", "1"} << "levels";
        QTest::newRow("a bad setting") << QStringList{"convergence", "contact_hertz", "--set", "pad.radius=0"}
                                       << "pad.radius";
        QTest::newRow("a bad target") << QStringList{"convergence", "contact_hertz", "--out", "no/such.h5"}
                                      << "no/such.h5";
        QTest::newRow("one file for two")
            << QStringList{"convergence", "contact_hertz", "--out", "a", "--csv", "a"} << "both name";
    }
    void refuses()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, says);
        const Outcome o = folder_->touchdown(QStringList{"study"} + arguments);
        QCOMPARE(o.code, 2);
        QCOMPARE(o.out, QByteArray());
        QVERIFY2(o.err.contains(says.toUtf8()), o.err);
        QCOMPARE(folder_->files(), QStringList());
    }
    void noAnswer()
    {
        const Outcome o = folder_->touchdown(
            {"study", "convergence", "contact_hertz", "--json", "--set", "elastic.maximum_iterations=1"});
        QCOMPARE(o.code, 1);
        QCOMPARE(o.json()["status"].toString(), QString("failed"));
        QVERIFY(o.err.startsWith("failed: cells of "));
    }

private:
    std::unique_ptr<CommandFolder> folder_;
};

TOUCHDOWN_TEST(TestConvergenceCommand)

} // namespace test_convergence_command

#include "test_convergence_command.moc"

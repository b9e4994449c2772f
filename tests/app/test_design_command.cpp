// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/command_process.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_design_command {

class TestDesignCommand : public QObject {
    Q_OBJECT

private slots:
    void init() { folder_ = std::make_unique<CommandFolder>(); }

    /// The plane slider at its attitude: a load that it carries somewhat lower than at 100 nm.
    void found()
    {
        folder_->put("a.toml", planeStudy("0.085"));
        const Outcome o = folder_->touchdown({"study", "design", "a.toml", "--json", "--apply", "found.toml", "--csv",
                                              "a.csv", "--set", "film.nodes=33, 33"});
        QCOMPARE(o.err, QByteArray());
        QCOMPARE(o.code, 0);
        const QJsonObject study = o.json();
        QCOMPARE(study["status"].toString(), QString("completed"));
        const QJsonArray steps = study["tables"].toArray()[0].toObject()["rows"].toArray();
        const QJsonObject best = steps.last().toObject();
        const double height = best["initial.nominal_trailing_edge_height"].toDouble();
        QVERIFY(height > 80e-9 && height < 100e-9);
        QVERIFY(std::abs(best["net_force"].toDouble() - 0.085) <= 1e-5);
        QCOMPARE(steps.first().toObject()["iteration"].toInt(), 0);
        QCOMPARE(folder_->files(), (QStringList{"a.csv", "a.toml", "found.toml"}));
        const CaseDocument found = readCaseFile(folder_->path("found.toml").toStdString());
        QVERIFY(found.valid());
        QCOMPARE(found.value.initial.nominalTrailingEdgeHeight, height);
        QVERIFY(found.text.find("# The whole of the slider.") != std::string::npos);
        QVERIFY(study["found"].toString().contains("initial"));
        const Outcome text =
            folder_->touchdown({"study", "design", "a.toml", "--set", "film.nodes=33, 33", "--progress"});
        QCOMPARE(text.code, 0);
        QVERIFY2(text.out.contains("wanted 8.6676 gf within 0.00102 gf"), text.out);
        QVERIFY2(text.err.contains("100 %"), text.err);
    }
    void outOfReach()
    {
        folder_->put("a.toml", planeStudy("0.5"));
        const Outcome o =
            folder_->touchdown({"study", "design", "a.toml", "--apply", "found.toml", "--set", "film.nodes=33, 33"});
        QCOMPARE(o.code, 1);
        QVERIFY2(
            o.err.startsWith("failed: the targets are not reached within the bounds; the best set lies on the bound of "
                             "initial.nominal_trailing_edge_height"),
            o.err);
        QVERIFY2(o.out.contains("80 nm, from 100 nm"), o.out);
        QCOMPARE(folder_->files(), QStringList{"a.toml"});
    }
    void refuses_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("says");
        QTest::newRow("no file") << QStringList{} << "FILE";
        QTest::newRow("a file that is not there") << QStringList{"b.toml"} << "b.toml: ";
        QTest::newRow("a sample that is not there") << QStringList{"film_fig4_pic"} << "did you mean film_fig4_pico?";
        QTest::newRow("a bad setting") << QStringList{"a.toml", "--set", "film.nodes=7"} << "film.nodes";
        QTest::newRow("a bad target") << QStringList{"a.toml", "--apply", "no/such.toml"} << "no/such.toml";
        QTest::newRow("the case as a report")
            << QStringList{"a.toml", "--out", "found.toml"} << "write the case that was found with --apply found.toml";
        QTest::newRow("the study itself") << QStringList{"a.toml", "--csv", "a.toml"} << "a.toml";
        QTest::newRow("one file for two") << QStringList{"a.toml", "--out", "b", "--csv", "b"} << "both name";
    }
    void refuses()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, says);
        folder_->put("a.toml", planeStudy("0.085"));
        const Outcome o = folder_->touchdown(QStringList{"study", "design"} + arguments);
        QCOMPARE(o.code, 2);
        QCOMPARE(o.out, QByteArray());
        QVERIFY2(o.err.contains(says.toUtf8()), o.err);
        QCOMPARE(folder_->files(), QStringList{"a.toml"});
    }

private:
    static QByteArray planeStudy(const QByteArray& force)
    {
        return R"(case = "film_plane"
[[parameter]]
key = "initial.nominal_trailing_edge_height"
minimum = "80 nm"
maximum = "150 nm"
[[target]]
quantity = "net_force"
tolerance = 1e-5
value = )" + force +
               "\n";
    }
    std::unique_ptr<CommandFolder> folder_;
};

TOUCHDOWN_TEST(TestDesignCommand)

} // namespace test_design_command

#include "test_design_command.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/convergence/convergence_file.h"

#include <QtTest>

#include "core/case/fields.h"
#include "core/formats/hdf5_file.h"
#include "tests/support/test_program.h"

using namespace touchdown;
namespace fs = std::filesystem;

namespace {

ConvergenceStudy someStudy()
{
    ConvergenceStudy study;
    study.separation = -1e-9;
    study.quantities = {{"contact_force", "N", "mN", "Real contact force"}, {"contact_area", "m^2", "um^2", "Area"}};
    for (int i = 0; i < 3; ++i) study.levels.push_back({1e-6 / (i + 1), 100 << i, {1e-3 + i, 1e-12 * i}, 7, 0.25, ""});
    study.observed = {{2.0, 3e-3, 1e-5}, {{}, 2e-12, 1e-12}};
    return study;
}

} // namespace

class TestConvergenceFile : public QObject {
    Q_OBJECT

private slots:
    void hdf5()
    {
        const Case c = defaultsOf(ModelKind::Contact);
        QCOMPARE(writeConvergence(path("a.h5"), c, "# text", someStudy()), std::string());
        const Hdf5Access access;
        const Hdf5Group file = openHdf5File(path("a.h5"));
        QCOMPARE(file.attribute("format"), std::string("touchdown-convergence"));
        QCOMPARE(file.attribute("status"), std::string("completed"));
        QCOMPARE(file.get("case/text").text(), std::string("# text"));
        QCOMPARE(file.get("levels/contact_force").column(), (std::vector{1e-3, 1.001, 2.001}));
        QCOMPARE(file.get("levels/cells").column(), (std::vector{100.0, 200.0, 400.0}));
        QCOMPARE(file.get("observed/order").column(), (std::vector{2.0, 0.0}));
        QCOMPARE(file.get("levels/contact_area").attribute("unit"), std::string("m^2"));
    }
    void csv()
    {
        QCOMPARE(writeConvergenceCsv(path("a.csv"), someStudy()), std::string());
        QFile file(QString::fromStdString(path("a.csv").string()));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QList<QByteArray> lines = file.readAll().split('\n');
        QCOMPARE(lines[0], QByteArray("cell [m],cells,seconds [s],contact_force [N],contact_area [m^2]\r"));
        QCOMPARE(lines[1], QByteArray("1e-6,100,0.25,0.001,0\r"));
        QCOMPARE(lines.size(), 5); // the last one is empty
    }
    void whatDidNotEndIsNotWritten()
    {
        ConvergenceStudy study = someStudy();
        study.status = StudyStatus::Cancelled;
        QVERIFY(!writeConvergence(path("b.h5"), {}, "", study).empty());
        QVERIFY(!writeConvergenceCsv(path("b.csv"), study).empty());
        QVERIFY(!fs::exists(path("b.h5")) && !fs::exists(path("b.csv")));
    }
    void badTarget()
    {
        const std::string problem = writeConvergence(path("no/such.h5"), {}, "", someStudy());
        QVERIFY2(problem.starts_with("cannot write the study to "), problem.c_str());
    }

private:
    fs::path path(const char* name) const { return fs::path(folder_.path().toStdString()) / name; }
    QTemporaryDir folder_;
};

TOUCHDOWN_TEST(TestConvergenceFile)
#include "test_convergence_file.moc"

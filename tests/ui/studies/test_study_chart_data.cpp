// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/studies/study_chart_data.h"

#include <QBuffer>
#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_study_chart_data {

class TestStudyChartData : public QObject {
    Q_OBJECT

private slots:
    void pointsAndCells()
    {
        StudyChart chart;
        ChartPanel lines{{"Step", "s", "ns", true}, {"Error \"worst\"", "m", "nm", true}, {}, {}, {}, false};
        lines.series = {{"rk4", {{1e-8, 2.5e-10, "10 ns"}, {1e-9, 3e-12, "", PointKind::Failed}}}};
        ChartPanel cells{{"f_m"}, {"d_e"}, {}, {}, {}, false};
        cells.map = ChartMap{{1.0, 2.0}, {5.0}, {{"flies", 0}}, {0, -1}, {"settles, at 7 nm", ""}};
        chart.panels = {lines, cells};
        QBuffer buffer;
        buffer.open(QIODevice::WriteOnly);
        writeChartCsv(chart, buffer);
        QCOMPARE(QString::fromUtf8(buffer.data()),
                 QStringLiteral("panel,name,label,kind,\"Step [s]\",\"Error \"\"worst\"\" [m]\"\n"
                                "1,\"rk4\",\"10 ns\",\"good\",1e-8,2.5e-10\n"
                                "1,\"rk4\",\"\",\"failed\",1e-9,3e-12\n"
                                "panel,name,label,kind,\"f_m\",\"d_e\"\n"
                                "2,\"flies\",\"settles, at 7 nm\",\"cell\",1,5\n"
                                "2,\"not known\",\"\",\"cell\",2,5\n"));
    }
};

TOUCHDOWN_TEST(TestStudyChartData)

} // namespace test_study_chart_data

#include "test_study_chart_data.moc"

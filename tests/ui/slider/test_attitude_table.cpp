// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/attitude_table.h"

#include <QApplication>
#include <QScrollBar>
#include <QTextBrowser>
#include <QtTest>

#include "tests/support/test_program.h"
#include "tests/ui/sample_slider.h"

using namespace touchdown;

namespace test_attitude_table {

class TestAttitudeTable : public QObject {
    Q_OBJECT

private slots:
    /// Units and places are seen in the narrow pane of a small window and of large letters.
    void fitsANarrowPane_data()
    {
        QTest::addColumn<int>("width");
        QTest::addColumn<double>("letters");
        QTest::newRow("laptop") << 305 << 1.0;
        QTest::newRow("large letters") << 390 << 1.5;
    }
    void fitsANarrowPane()
    {
        QFETCH(const int, width);
        QFETCH(const double, letters);
        AttitudeTable table;
        QFont font = table.font();
        font.setPixelSize(static_cast<int>(13 * letters)); // as on a screen of 96 dpi
        table.setFont(font);
        const Case c = sampleFilmCase();
        SteadyResult result = sampleResult(c);
        result.sensitivities = {{"abs.crown", "m", 0.25, 2000.0, -40.0, 0.2}};
        table.setResult(c, result);
        table.resize(width, 500);
        table.show();
        const auto* text = table.findChild<QTextBrowser*>();
        QTRY_VERIFY(text->verticalScrollBar()->maximum() > 0);
        QCOMPARE(text->horizontalScrollBar()->maximum(), 0);
    }
};

TOUCHDOWN_TEST(TestAttitudeTable)

} // namespace test_attitude_table

#include "test_attitude_table.moc"

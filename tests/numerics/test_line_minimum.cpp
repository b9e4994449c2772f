// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/line_minimum.h"

#include <functional>

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_line_minimum {

class TestLineMinimum : public QObject {
    Q_OBJECT

private slots:
    void parts_data()
    {
        QTest::addColumn<int>("law");
        QTest::addColumn<double>("least");
        QTest::addColumn<double>("most");
        QTest::newRow("a parabola, least at 0.3, to a tenth of the slope") << 0 << 0.27 << 0.33;
        QTest::newRow("a quartic, least at 0.5") << 1 << 0.26 << 0.74; // 0.5 (1 - 0.1^(1/3)) = 0.27
        QTest::newRow("a kink at 0.01") << 2 << 1e-4 << 0.011;
        QTest::newRow("it falls to the end") << 3 << 1.0 << 1.0;
        QTest::newRow("flat at the end") << 4 << 1.0 << 1.0;
        QTest::newRow("it rises from the start") << 5 << 0.0 << 0.0;
    }
    void parts()
    {
        QFETCH(int, law);
        QFETCH(double, least);
        QFETCH(double, most);
        const std::function<double(double)> slopes[] = {
            [](double t) { return t - 0.3; },
            [](double t) { return 8.0 * (t - 0.5) * (t - 0.5) * (t - 0.5); },
            [](double t) { return t < 0.01 ? -1.0 : 100.0; },
            [](double t) { return 0.5 * t - 1.0; },
            [](double t) { return t - 1.0; },
            [](double t) { return 1.0 + t; }};
        const double part = lineMinimum(slopes[law]);
        QVERIFY2(part >= least && part <= most, qPrintable(QString::number(part)));
    }
};

TOUCHDOWN_TEST(TestLineMinimum)

} // namespace test_line_minimum

#include "test_line_minimum.moc"

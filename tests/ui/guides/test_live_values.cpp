// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guides/live_values.h"

#include <cmath>

#include <QSignalSpy>
#include <QtTest>

#include "core/case/parameters.h"
#include "core/case_files/case_file.h"
#include "tests/support/test_program.h"
#include "ui/guides/marked_slider.h"

using namespace touchdown;

namespace test_live_values {

const LiveValue force{{"ono_yamane.meniscus_force"}, 1e-3, 60e-3, {}}; // in steps of equal ratio
const LiveValue friction{{"ono_yamane.friction"}, 0.0, 3.0, {}};
const LiveValue reach{{"ono_yamane.take_off"}, 3.2e-9, 12e-9, {}};

/// The sliders of the default case, of which the numbers are kept that they ask for.
struct Fixture {
    Fixture()
    {
        values.setValues({force, friction, reach}, own);
        values.resize(300, 200);
        values.show();
        QObject::connect(&values, &LiveValues::moved, [this](const LiveValue& value, const std::string& text) {
            moved = value;
            texts.push_back(text);
            Case c = own;
            const Parameter& parameter = *findParameter(value.keys.front());
            if (setFromText(c, parameter, text)) return;
            numbers.push_back(numberOf(parameter, c));
            values.showCase(c);
        });
    }
    MarkedSlider& slider(int row) { return *static_cast<MarkedSlider*>(values.inputs().at(std::size_t(row))); }

    Case own = openCase("fig10a").value; // f_m 10.7 mN, mu 0.8, d_e 5 nm
    LiveValues values;
    LiveValue moved;
    std::vector<std::string> texts;
    std::vector<double> numbers; // that they give
};

class TestLiveValues : public QObject {
    Q_OBJECT

private slots:
    void standsAtTheValueOfTheCase()
    {
        Fixture f;
        QCOMPARE(f.slider(0).value(), int(std::lround(1000 * std::log(10.7) / std::log(60.0))));
        QCOMPARE(f.slider(1).value(), int(std::lround(1000 * 0.8 / 3.0)));
        QCOMPARE(f.slider(1).markedStep(), f.slider(1).value());
        Case other = f.own;
        other.onoYamane.friction = 1.5;
        f.values.showCase(other);
        QCOMPARE(f.slider(1).value(), 500);
        QCOMPARE(f.slider(1).markedStep(), int(std::lround(1000 * 0.8 / 3.0))); // the case's own
        QVERIFY(f.numbers.empty());                                             // by the case, not by the user
        other.onoYamane.friction = 7.0;                                         // beyond the end
        f.values.showCase(other);
        QCOMPARE(f.slider(1).value(), 1000);
        other.contact = noContact;
        f.values.showCase(other);
        QVERIFY(!f.slider(0).isEnabled());
    }

    /// Between the ends, with three digits; at the mark the very number of the case.
    void asksForNumbers()
    {
        Fixture f;
        for (int step = 0; step <= 1000; step += 7) f.slider(0).setValue(step);
        QCOMPARE(f.moved.keys, force.keys);
        QCOMPARE(f.numbers.size(), f.texts.size());
        double before = 0.0;
        for (std::size_t i = 0; i < f.numbers.size(); ++i) {
            QVERIFY(f.numbers[i] >= force.from && f.numbers[i] <= force.until && f.numbers[i] >= before);
            before = f.numbers[i];
            // The field shows the same three digits.
            Case c = f.own;
            const Parameter& parameter = *findParameter(force.keys.front());
            QVERIFY(!setFromText(c, parameter, f.texts[i]));
            QCOMPARE(toText(c, parameter), f.texts[i]);
            QVERIFY2(QString::fromStdString(f.texts[i]).count(QRegularExpression("\\d")) <= 4, f.texts[i].c_str());
        }
        f.slider(0).setValue(0);
        QCOMPARE(f.numbers.back(), force.from);
        f.slider(0).setValue(1000);
        QCOMPARE(f.numbers.back(), force.until);
        f.slider(0).setValue(f.slider(0).markedStep());
        QCOMPARE(f.numbers.back(), 10.7e-3);
        f.slider(1).setValue(0);
        QCOMPARE(f.numbers.back(), 0.0);
    }

    void saysWhenTheReaderLetsGo()
    {
        Fixture f;
        QVERIFY(QTest::qWaitForWindowExposed(&f.values));
        QSignalSpy settled(&f.values, &LiveValues::settled);
        MarkedSlider& slider = f.slider(1);
        slider.setSliderDown(true);
        slider.setSliderPosition(700);
        QVERIFY(!f.numbers.empty());
        QCOMPARE(settled.count(), 0);
        slider.setSliderDown(false);
        QCOMPARE(settled.count(), 1);
        // Keys: after the last of them.
        QTest::keyClick(&slider, Qt::Key_Right);
        QTest::keyClick(&slider, Qt::Key_Right);
        QCOMPARE(settled.count(), 1);
        QTRY_COMPARE(settled.count(), 2);
        QCOMPARE(slider.value(), 720);
    }

    void aDoubleClickGoesBack()
    {
        Fixture f;
        QVERIFY(QTest::qWaitForWindowExposed(&f.values));
        f.slider(2).setValue(900);
        QTest::mouseDClick(&f.slider(2), Qt::LeftButton, {}, QPoint(5, 5));
        QCOMPARE(f.numbers.back(), f.own.onoYamane.takeOff);
        QCOMPARE(f.slider(2).value(), f.slider(2).markedStep());
    }

    /// The handle is taken where it is drawn, above the mark.
    void theHandleIsWhereItIsDrawn()
    {
        Fixture f;
        QVERIFY(QTest::qWaitForWindowExposed(&f.values));
        MarkedSlider& slider = f.slider(1);
        slider.setValue(500);
        QSignalSpy pressed(&slider, &QSlider::sliderPressed);
        const int y = slider.style()->pixelMetric(QStyle::PM_SliderThickness, nullptr, &slider) / 2;
        QTest::mousePress(&slider, Qt::LeftButton, {}, QPoint(slider.width() / 2, y));
        QCOMPARE(pressed.count(), 1);
        QTest::mouseMove(&slider, QPoint(slider.width() - 2, y));
        QTest::mouseRelease(&slider, Qt::LeftButton, {}, QPoint(slider.width() - 2, y));
        QCOMPARE(slider.value(), 1000);
    }

    /// A slider that goes away, or that the case takes back, is let go.
    void isNeverLeftInTheHand()
    {
        Fixture f;
        QVERIFY(QTest::qWaitForWindowExposed(&f.values));
        QSignalSpy settled(&f.values, &LiveValues::settled);
        QTest::keyClick(&f.slider(1), Qt::Key_Right);
        f.values.setValues({friction}, f.own);
        QCOMPARE(settled.count(), 1);
        f.values.setValues({friction}, f.own);
        QCOMPARE(settled.count(), 1); // nothing has moved
        QTest::keyClick(&f.slider(0), Qt::Key_Right);
        f.values.showCase(f.own); // undo
        QTRY_COMPARE(settled.count(), 2);
        QCOMPARE(f.slider(0).value(), f.slider(0).markedStep());
    }

    void theWheelScrollsPast()
    {
        Fixture f;
        QVERIFY(QTest::qWaitForWindowExposed(&f.values));
        MarkedSlider& slider = f.slider(1);
        QWheelEvent wheel(QPointF(20, 5), slider.mapToGlobal(QPointF(20, 5)), {}, {0, 120}, Qt::NoButton, {},
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(&slider, &wheel);
        QVERIFY(!wheel.isAccepted());
        QVERIFY(f.texts.empty());
    }

    void namesItsSliders()
    {
        Fixture f;
        for (QWidget* input : f.values.inputs()) QVERIFY(!input->accessibleName().isEmpty());
        QVERIFY(f.slider(0).accessibleDescription().startsWith("10.7"));
        f.values.setValues({}, f.own);
        QVERIFY(f.values.inputs().empty() && f.values.isHidden());
    }
};

TOUCHDOWN_TEST(TestLiveValues)

} // namespace test_live_values

#include "test_live_values.moc"

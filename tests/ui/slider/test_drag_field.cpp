// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/drag_field.h"

#include <cmath>

#include <QSignalSpy>
#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_drag_field {

class TestDragField : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void readsLengths_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("expected"); // [m]; -1: no length
        QTest::newRow("in um") << "12.5" << 12.5e-6;
        QTest::newRow("negative") << "-3" << -3e-6;
        QTest::newRow("minus sign") << QString::fromUtf8("−3") << -3e-6;
        QTest::newRow("in mm") << "0.01 mm" << 10e-6;
        QTest::newRow("in µm") << QString::fromUtf8("7 µm") << 7e-6;
        QTest::newRow("no number") << "-" << -1.0;
        QTest::newRow("a force") << "3 mN" << -1.0;
        QTest::newRow("empty") << "" << -1.0;
    }
    void readsLengths()
    {
        QFETCH(QString, text);
        QFETCH(double, expected);
        QWidget plan;
        DragField field(&plan);
        field.open({}, {{QStringLiteral("dx"), {1.0, 0.0}}, {QStringLiteral("dy"), {0.0, -1.0}}}, 1, text);
        const auto shift = field.shift();
        QCOMPARE(shift.has_value(), expected != -1.0);
        if (!shift) return;
        QCOMPARE(shift->x, 0.0);
        QVERIFY(std::abs(shift->y + expected) < 1e-18); // against its direction
    }
    void readsTheCommaOfALocale()
    {
        QLocale::setDefault(QLocale(QLocale::German));
        QWidget plan;
        DragField field(&plan);
        field.open({}, {{QStringLiteral("dx"), {1.0, 0.0}}}, 0, QStringLiteral("1,5"));
        QVERIFY(field.shift() && std::abs(field.shift()->x - 1.5e-6) < 1e-18);
        QCOMPARE(field.shift()->y, 0.0); // the second field is hidden
        QLocale::setDefault(QLocale::c());
    }
    void keysTakeAndGiveBack()
    {
        QWidget plan;
        plan.resize(300, 200);
        DragField field(&plan);
        plan.show();
        QVERIFY(QTest::qWaitForWindowExposed(&plan));
        QSignalSpy changed(&field, &DragField::changed), taken(&field, &DragField::taken),
            givenBack(&field, &DragField::givenBack);
        field.open({290, 190}, {{QStringLiteral("dx"), {1.0, 0.0}}, {QStringLiteral("dy"), {0.0, 1.0}}}, 0,
                   QStringLiteral("1"));
        QVERIFY(plan.rect().contains(field.geometry())); // moved into the plan
        QTest::keyClick(field.focusWidget(), '2');
        QCOMPARE(changed.count(), 1);
        QTest::keyClick(field.focusWidget(), Qt::Key_Tab);
        QTest::keyClick(field.focusWidget(), '3');
        QCOMPARE(field.shift()->x, 12 * 1e-6);
        QCOMPARE(field.shift()->y, 3 * 1e-6);
        QTest::keyClick(field.focusWidget(), Qt::Key_Return);
        QCOMPARE(taken.count(), 1);
        QTest::keyClick(field.focusWidget(), Qt::Key_Escape);
        QCOMPARE(givenBack.count(), 1);
        for (const QLineEdit* text : field.findChildren<QLineEdit*>()) QVERIFY(!text->accessibleName().isEmpty());
    }
};

TOUCHDOWN_TEST(TestDragField)

} // namespace test_drag_field

#include "test_drag_field.moc"

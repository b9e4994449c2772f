// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/theme.h"

#include <cmath>

#include <QApplication>
#include <QCheckBox>
#include <QRadioButton>
#include <QStyle>
#include <QStyleOptionButton>
#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_theme {

class TestTheme : public QObject {
    Q_OBJECT

private slots:
    void contrastsAreThoseOfTheGuideline();
    void untickedBoxesHaveABorder_data();
    void untickedBoxesHaveABorder();
    void wordsCanBeRead_data() { untickedBoxesHaveABorder_data(); }
    void wordsCanBeRead();
    void cleanupTestCase() { applyTheme(Theme::Light); }
};

/// Black on white is 21:1. Grey #777777 has the luminance 0.1845: 1.05 / 0.2345 = 4.48.
void TestTheme::contrastsAreThoseOfTheGuideline()
{
    QCOMPARE(contrast(Qt::black, Qt::white), 21.0);
    QCOMPARE(contrast(Qt::white, Qt::white), 1.0);
    QVERIFY(std::abs(contrast(Qt::white, QColor("#777777")) - 4.48) < 0.01);
}

void TestTheme::untickedBoxesHaveABorder_data()
{
    QTest::addColumn<Theme>("theme");
    QTest::newRow("light") << Theme::Light;
    QTest::newRow("dark") << Theme::Dark;
}

/// The middle of each edge of the indicator, against its inside and against the window around it.
void TestTheme::untickedBoxesHaveABorder()
{
    QFETCH(const Theme, theme);
    applyTheme(theme);
    QCheckBox box(QStringLiteral("Log"));
    QRadioButton button(QStringLiteral("Log"));
    for (QAbstractButton* each : std::initializer_list<QAbstractButton*>{&box, &button}) {
        each->resize(each->sizeHint());
        const QImage image = each->grab().toImage();
        QStyleOptionButton option;
        option.initFrom(each);
        const bool round = each == &button;
        const QRect indicator = each->style()->subElementRect(
            round ? QStyle::SE_RadioButtonIndicator : QStyle::SE_CheckBoxIndicator, &option, each);
        const double ratio = image.devicePixelRatio();
        const auto at = [&](const QPoint& point) { return image.pixelColor((QPointF(point) * ratio).toPoint()); };
        const QColor inside = at(indicator.center());
        for (const QPoint& edge :
             {QPoint(indicator.left(), indicator.center().y()), QPoint(indicator.right(), indicator.center().y()),
              QPoint(indicator.center().x(), indicator.top()), QPoint(indicator.center().x(), indicator.bottom())}) {
            QVERIFY2(contrast(at(edge), inside) >= 3.0, qPrintable(at(edge).name()));
            QVERIFY2(contrast(at(edge), each->palette().color(QPalette::Window)) >= 3.0, qPrintable(at(edge).name()));
        }
    }
}

void TestTheme::wordsCanBeRead()
{
    QFETCH(const Theme, theme);
    applyTheme(theme);
    const QPalette palette = QApplication::palette();
    const MeaningColours meaning = meaningColours(palette);
    for (const QColor& colour : {meaning.failure, meaning.warning, meaning.success, meaning.change, meaning.muted,
                                 palette.color(QPalette::WindowText)})
        QVERIFY2(contrast(colour, palette.color(QPalette::Window)) >= 4.5, qPrintable(colour.name()));
}

TOUCHDOWN_TEST(TestTheme)

} // namespace test_theme

#include "test_theme.moc"

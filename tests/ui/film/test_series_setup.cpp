// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/series_setup.h"

#include <numbers>

#include <QTest>

#include "tests/support/test_program.h"
#include "tests/ui/named_widget.h"
#include "tests/ui/sample_slider.h"
#include "ui/style/theme.h"

using namespace touchdown;

namespace test_series_setup {

class TestSeriesSetup : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QLocale::setDefault(QLocale::c());
        applyTheme(Theme::Light);
    }
    void init()
    {
        case_ = sampleFilmCase();
        case_.disk.radius = 20e-3;
        case_.disk.skew = 0.123456; // 7.0735 degrees: more digits than the box
        setup_ = std::make_unique<SeriesSetup>();
        setup_->open(case_);
    }
    void beginsWithTheRadius();
    void theCasesOwnNumbersAreExact();
    void typedNumbersCount();
    void followsTheCaseUntilItIsChanged();
    void offersTheLists();
    void equalEndsAreNoSeries();
    void showsWhatFits();

private:
    QDoubleSpinBox* box(const char* name) const
    {
        return namedWidget<QDoubleSpinBox>(*setup_, QString::fromLatin1(name));
    }
    QComboBox* varied() const { return setup_->findChild<QComboBox*>(); }

    Case case_;
    std::unique_ptr<SeriesSetup> setup_;
};

void TestSeriesSetup::beginsWithTheRadius()
{
    QVERIFY(setup_->choice() == usualChoice(case_, Varied::Radius));
    QCOMPARE(box("First value of the series")->value(), 10.0);
    QCOMPARE(box("Last value of the series")->text(), QString::fromUtf8("30.00\u00A0mm"));
}

/// A box rounds what it shows, not what is solved.
void TestSeriesSetup::theCasesOwnNumbersAreExact()
{
    QCOMPARE(box("Skew at the first radius")->value(), 7.07);
    QCOMPARE(setup_->choice().skewFrom, 0.123456);
    QCOMPARE(setup_->points().front().skew, 0.123456);
}

void TestSeriesSetup::typedNumbersCount()
{
    QDoubleSpinBox* first = box("First value of the series");
    first->selectAll();
    QTest::keyClicks(first, QStringLiteral("15"));
    QTest::keyClick(first, Qt::Key_Return);
    QCOMPARE(setup_->points().front().radius, 15e-3);
    box("Skew at the first radius")->setValue(7.06);
    QVERIFY(std::abs(setup_->choice().skewFrom - 7.06 * std::numbers::pi / 180.0) < 1e-12);
    QVERIFY(!setup_->points().empty());
}

void TestSeriesSetup::followsTheCaseUntilItIsChanged()
{
    case_.disk.radius = 24e-3;
    setup_->setCase(case_);
    QCOMPARE(setup_->choice().from, 12e-3);
    box("First value of the series")->setValue(13.0);
    case_.disk.radius = 20e-3;
    setup_->setCase(case_);
    QCOMPARE(setup_->choice().from, 13e-3);
    setup_->open(case_);
    QCOMPARE(setup_->choice().from, 10e-3);
}

void TestSeriesSetup::offersTheLists()
{
    QCOMPARE(varied()->count(), 4);
    case_.steady.radii = {15e-3, 20e-3, 25e-3};
    setup_->setCase(case_);
    QCOMPARE(varied()->count(), 5);
    QVERIFY(setup_->choice().varied == Varied::Radius); // as it was chosen before
    QCOMPARE(setup_->choice().from, 15e-3);
    setup_->open(case_);
    QVERIFY(setup_->choice().varied == Varied::Lists);
    QCOMPARE(setup_->points().size(), std::size_t(3));
    case_.steady.radii.clear();
    setup_->setCase(case_);
    QVERIFY(setup_->choice().varied != Varied::Lists);
    QCOMPARE(varied()->count(), 4);
}

void TestSeriesSetup::equalEndsAreNoSeries()
{
    QVERIFY(setup_->problem().isEmpty());
    box("First value of the series")->setValue(30.0);
    QVERIFY(!setup_->problem().isEmpty());
}

void TestSeriesSetup::showsWhatFits()
{
    QVERIFY(box("Skew at the first radius")->isVisibleTo(setup_.get()));
    varied()->setCurrentIndex(static_cast<int>(Varied::Speed));
    QVERIFY(!box("Skew at the first radius")->isVisibleTo(setup_.get()));
    QVERIFY(box("First value of the series")->suffix().endsWith(QStringLiteral("rpm")));
    // 5400 rpm of the default case: from a half to 1.5 of it.
    QCOMPARE(box("First value of the series")->value(), 2700.0);
    QCOMPARE(box("Last value of the series")->value(), 8100.0);
    varied()->setCurrentIndex(static_cast<int>(Varied::Altitude));
    QCOMPARE(box("Last value of the series")->value(), 3000.0);
}

TOUCHDOWN_TEST(TestSeriesSetup)

} // namespace test_series_setup

#include "test_series_setup.moc"

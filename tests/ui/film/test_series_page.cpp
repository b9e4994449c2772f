// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/series_page.h"

#include <atomic>
#include <memory>
#include <thread>

#include <QClipboard>
#include <QGuiApplication>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/small_slider.h"
#include "tests/support/test_program.h"
#include "tests/ui/question.h"
#include "tests/ui/sample_slider.h"
#include "ui/film/series_setup.h"
#include "ui/style/quantity_format.h"
#include "ui/style/theme.h"

using namespace touchdown;

namespace test_series_page {

class TestSeriesPage : public QObject {
    Q_OBJECT

private slots:
    void init();
    void cleanup() { page_.reset(); }
    void beginsEmpty();
    void solvesTheChosenSeries();
    void solvesTheListsOfTheCase();
    void failedStatesAreNamedNotDrawn();
    void aStopKeepsWhatIsSolved();
    void handsOnEachState();
    void saysWhenTheCaseHasChanged();
    void refusesEqualEnds();
    void copiesAndSaves();
    void theKeyboardDoesAll();
    void asksBeforeAnUnsavedSeriesIsReplaced();
    void savedWhileUnderWayIsNotSavedWhole();
    void anotherCaseForgets();
    void aRealCase();

private:
    QPushButton* button() const { return page_->findChild<QPushButton*>(); }
    QString cell(int row, int column) const { return page_->table()->text(row, column); }
    QString head(int column) const { return page_->table()->head(column); }
    int statesDrawn() const
    {
        std::size_t dots = 0;
        for (const PlotCurve& curve : page_->plots()->plots()[0]->curves())
            if (curve.dots) dots += curve.data->size();
        return static_cast<int>(dots);
    }
    void solve()
    {
        QSignalSpy finished(&page_->controller(), &SeriesController::finished);
        button()->click();
        if (question(*page_, "unsavedSeries")) answer(*page_, "unsavedSeries", QStringLiteral("Replace"));
        QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, 60000);
    }

    Case case_;
    std::unique_ptr<SeriesPage> page_;
    std::atomic<double> failing_ = 0.0; // the radius at which there is no state [m]
    std::atomic<double> waiting_ = 1.0; // from this radius on the solver goes on until it is stopped [m]
};

void TestSeriesPage::init()
{
    QLocale::setDefault(QLocale::c());
    applyTheme(Theme::Light);
    failing_ = 0.0;
    waiting_ = 1.0;
    case_ = sampleFilmCase();
    case_.disk.radius = 20e-3;
    page_ = std::make_unique<SeriesPage>([this](const Case& c, const SteadyCallback& callback) {
        SteadyResult result = sampleResult(c);
        result.minimumSpacing = 1e-6 * c.disk.radius;
        while (callback({"grid 1 x 1", 1, 0.0, 0.0, {}}) && c.disk.radius >= waiting_) std::this_thread::yield();
        if (c.disk.radius >= waiting_) {
            result = {};
            result.status = SteadyStatus::Cancelled;
        }
        if (std::abs(c.disk.radius - failing_) < 1e-9) {
            result = {};
            result.message = "no flying attitude was found";
        }
        return result;
    });
    page_->open(case_);
    page_->resize(800, 700);
    page_->show();
    QVERIFY(QTest::qWaitForWindowExposed(page_.get()));
}

void TestSeriesPage::beginsEmpty()
{
    QVERIFY(!page_->plots()->isVisible());
    QVERIFY(page_->states().empty());
    QVERIFY(!page_->stale());
}

void TestSeriesPage::solvesTheChosenSeries()
{
    page_->setup()->setChoice({Varied::Radius, 10e-3, 30e-3, 0.0, 0.1, 5});
    solve();
    QVERIFY(page_->plots()->isVisible());
    QCOMPARE(page_->states().size(), std::size_t(5));
    QCOMPARE(statesDrawn(), 5);
    QCOMPARE(page_->table()->rowCount(), 5);
    // What varies, the status, the numbers.
    QCOMPARE(head(0), QStringLiteral("Radius [mm]"));
    QCOMPARE(head(1), QStringLiteral("Skew [deg]"));
    QCOMPARE(head(2), QStringLiteral("Status"));
    QCOMPARE(head(3), QStringLiteral("Minimum spacing [nm]"));
    QCOMPARE(cell(1, 0), QStringLiteral("15.00"));
    QCOMPARE(cell(1, 2), QStringLiteral("converged"));
    QCOMPARE(cell(1, 3), QStringLiteral("15.000"));
    QCOMPARE(cell(1, 4), QStringLiteral("0.020"));       // the stated error
    QVERIFY(page_->states()[0].result.pressure.empty()); // fields are not kept
}

void TestSeriesPage::solvesTheListsOfTheCase()
{
    case_.steady.radii = {15e-3, 25e-3};
    case_.steady.speeds = {400.0, 600.0};
    page_->open(case_);
    solve();
    QCOMPARE(page_->states().size(), std::size_t(4));
    QCOMPARE(head(1), QStringLiteral("Speed [rpm]"));
}

void TestSeriesPage::failedStatesAreNamedNotDrawn()
{
    page_->setup()->setChoice({Varied::Radius, 10e-3, 30e-3, 0.0, 0.0, 5});
    failing_ = 20e-3;
    solve();
    QCOMPARE(statesDrawn(), 4);
    QCOMPARE(cell(2, 1), QStringLiteral("failed"));
    QCOMPARE(cell(2, 2), QString(QChar(0x2013)));
    QCOMPARE(cell(2, page_->table()->columnCount() - 1), QStringLiteral("No flying attitude was found."));
    bool said = false;
    for (const QLabel* label : page_->findChildren<QLabel*>())
        said =
            said || (label->isVisible() && label->text().endsWith(QStringLiteral(": no flying attitude was found.")));
    QVERIFY(said);
    // Another theme colours them anew.
    const auto colour = [&] {
        return page_->table()->model()->index(2, 1).data(Qt::ForegroundRole).value<QBrush>().color();
    };
    const QColor light = colour();
    QCOMPARE(light, meaningColours(page_->palette()).failure);
    applyTheme(Theme::Dark);
    QTRY_VERIFY(colour() != light);
    QCOMPARE(colour(), meaningColours(page_->palette()).failure);
}

void TestSeriesPage::aStopKeepsWhatIsSolved()
{
    page_->setup()->setChoice({Varied::Radius, 10e-3, 30e-3, 0.0, 0.0, 5});
    waiting_ = 18e-3;
    QSignalSpy finished(&page_->controller(), &SeriesController::finished);
    button()->click();
    QTRY_COMPARE(page_->states().size(), std::size_t(2)); // as they come
    QCOMPARE(statesDrawn(), 2);
    QVERIFY(!page_->setup()->isEnabled());
    button()->click();
    QTRY_COMPARE(finished.count(), 1);
    QCOMPARE(page_->states().size(), std::size_t(2));
    QVERIFY(page_->setup()->isEnabled());
}

/// With its fields, and with the case of the state: one point, no lists.
void TestSeriesPage::handsOnEachState()
{
    QSignalSpy solved(page_.get(), &SeriesPage::solved);
    page_->setup()->setChoice({Varied::Radius, 10e-3, 30e-3, 0.0, 0.0, 3});
    solve();
    QCOMPARE(solved.count(), 3);
    QCOMPARE(solved[2][0].value<Case>().disk.radius, 30e-3);
    QVERIFY(seriesOf(solved[2][0].value<Case>()).size() == 1);
    QVERIFY(!solved[2][1].value<SteadyResult>().pressure.empty());
}

void TestSeriesPage::saysWhenTheCaseHasChanged()
{
    solve();
    QVERIFY(!page_->stale());
    Case edited = case_;
    edited.surface.crown += 1e-9;
    page_->setCase(edited);
    QVERIFY(page_->stale());
    page_->setCase(case_);
    QVERIFY(!page_->stale());
}

void TestSeriesPage::refusesEqualEnds()
{
    page_->setup()->setChoice({Varied::Radius, 20e-3, 20e-3, 0.0, 0.0, 3});
    button()->click();
    QVERIFY(!page_->controller().active());
    QVERIFY(page_->states().empty());
}

void TestSeriesPage::copiesAndSaves()
{
    page_->setup()->setChoice({Varied::Speed, 400.0, 600.0, 0.0, 0.0, 3});
    solve();
    page_->table()->setFocus();
    QTest::keyClick(page_->table(), Qt::Key_C, Qt::ControlModifier);
    QCOMPARE(QGuiApplication::clipboard()->text().split(QLatin1Char('\n')).size(), 5); // heads, 3 states, the end
    const QByteArrayList lines = page_->csv().split('\n');
    QCOMPARE(lines.size(), 5);
    QCOMPARE(lines[0].split(',').size(), lines[1].split(',').size());
    QVERIFY(lines[0].startsWith("radius [mm],skew [deg],speed [rpm],nominal_trailing_edge_height [nm]"));
    QCOMPARE(lines[1].split(',')[3].toDouble(), 10.0); // as sampleResult has it
    failing_ = case_.disk.radius;
    solve();
    QVERIFY(page_->csv().contains(",,")); // numbers that are not known
    QVERIFY(page_->csv().contains("no flying attitude"));
}

void TestSeriesPage::theKeyboardDoesAll()
{
    button()->setFocus();
    QSignalSpy finished(&page_->controller(), &SeriesController::finished);
    QTest::keyClick(button(), Qt::Key_Space);
    QTRY_COMPARE(finished.count(), 1);
    page_->table()->setFocus();
    page_->table()->selectRow(0);
    QTest::keyClick(page_->table(), Qt::Key_Down);
    // The usual series has steps of an eighth of the radius.
    QVERIFY(std::abs(*page_->plots()->plots()[0]->plotCursor(0) - 12.5e-3) < 1e-12);
    QTest::keyClick(page_->table(), Qt::Key_Tab);
    QVERIFY(!page_->table()->hasFocus());
}

void TestSeriesPage::asksBeforeAnUnsavedSeriesIsReplaced()
{
    const QTemporaryDir folder;
    solve();
    const std::size_t states = page_->states().size();
    button()->click();
    QVERIFY(question(*page_, "unsavedSeries"));
    answer(*page_, "unsavedSeries", QStringLiteral("Cancel"));
    QVERIFY(!page_->controller().active());
    QCOMPARE(page_->states().size(), states);
    QCOMPARE(page_->save(folder.filePath(QStringLiteral("series.csv"))), QString());
    button()->click();
    QVERIFY(!question(*page_, "unsavedSeries"));
    QTRY_VERIFY(!page_->controller().active());
}

void TestSeriesPage::savedWhileUnderWayIsNotSavedWhole()
{
    const QTemporaryDir folder;
    waiting_ = 18e-3; // behind 10 and 15 mm
    page_->setup()->setChoice({Varied::Radius, 10e-3, 30e-3, 0.0, 0.1, 5});
    button()->click();
    QTRY_COMPARE(page_->states().size(), std::size_t(2));
    QCOMPARE(page_->save(folder.filePath(QStringLiteral("series.csv"))), QString());
    QCOMPARE(page_->unsaved(), std::size_t(0));
    waiting_ = 1.0;
    QTRY_COMPARE(page_->states().size(), std::size_t(5));
    QCOMPARE(page_->unsaved(), std::size_t(5));
}

void TestSeriesPage::anotherCaseForgets()
{
    solve();
    page_->open(case_);
    beginsEmpty();
    QCOMPARE(statesDrawn(), 0);
}

/// The same numbers as each state alone.
void TestSeriesPage::aRealCase()
{
    Case c = test::smallSlider(33);
    c.steady.radii = {20e-3, 25e-3};
    page_ = std::make_unique<SeriesPage>();
    page_->open(c);
    solve();
    QCOMPARE(page_->table()->rowCount(), 2);
    for (std::size_t i = 0; i < 2; ++i) {
        const SteadyResult alone = steady(caseAt(c, seriesOf(c)[i]));
        QCOMPARE(alone.status, SteadyStatus::Converged);
        QCOMPARE(cell(static_cast<int>(i), 2), typeset(alone.minimumSpacing / 1e-9, 3));
    }
}

TOUCHDOWN_TEST(TestSeriesPage)

} // namespace test_series_page

#include "test_series_page.moc"

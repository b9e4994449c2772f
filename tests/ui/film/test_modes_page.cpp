// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/modes_page.h"

#include <atomic>
#include <memory>
#include <thread>

#include <QClipboard>
#include <QFile>
#include <QFileDialog>
#include <QGuiApplication>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/small_slider.h"
#include "tests/support/test_program.h"
#include "tests/ui/film/sample_modes.h"
#include "tests/ui/named_widget.h"
#include "ui/film/mode_picture.h"
#include "ui/style/quantity_format.h"
#include "ui/style/theme.h"

using namespace touchdown;

namespace test_modes_page {

class TestModesPage : public QObject {
    Q_OBJECT

private slots:
    void init();
    void cleanup() { page_.reset(); }
    void beginsEmpty();
    void showsTheModes();
    void statesLimitsOfValidity();
    void theKeyboardDoesAll();
    void saysWhenTheCaseHasChanged();
    void aStopKeepsWhatIsKnown();
    void aFailureSaysWhy();
    void refusesACaseThatContradictsItself();
    void copiesTheTable();
    void savesTheNumbers();
    void speedAndPause();
    void anotherCaseForgets();
    void aRealCase();

private:
    QPushButton* button() const { return page_->findChild<QPushButton*>(); }
    QString cell(int row, int column) const { return page_->table()->text(row, column); }
    QLabel* remarks() const { return namedWidget<QLabel>(*page_, QStringLiteral("Remarks on the modes")); }
    void find()
    {
        QSignalSpy finished(&page_->controller(), &ModesController::finished);
        button()->click();
        QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, 60000);
    }

    Case case_;
    std::unique_ptr<ModesPage> page_;
    std::atomic<bool> waiting_ = false; // the search goes on until it is stopped
    std::atomic<bool> failing_ = false;
};

void TestModesPage::init()
{
    QLocale::setDefault(QLocale::c());
    applyTheme(Theme::Light);
    waiting_ = failing_ = false;
    case_ = sampleFilmCase();
    page_ = std::make_unique<ModesPage>([this](const Case& c, const SteadyCallback& callback) {
        ModesResult result = sampleModes(c);
        while (callback({"mode 1", 0, 0.0, 0.0, {}}) && waiting_) std::this_thread::yield();
        if (waiting_) {
            result = {};
            result.status = SteadyStatus::Cancelled;
        }
        if (failing_) {
            result = {};
            result.message = "no flying attitude was found";
        }
        return result;
    });
    page_->setCase(case_);
    page_->resize(800, 600);
    page_->show();
    QVERIFY(QTest::qWaitForWindowExposed(page_.get()));
}

void TestModesPage::beginsEmpty()
{
    QVERIFY(!page_->picture()->isVisible());
    QCOMPARE(page_->table()->rowCount(), 0);
    QVERIFY(!page_->stale());
    QVERIFY(!remarks()->isVisible());
}

void TestModesPage::showsTheModes()
{
    find();
    QVERIFY(page_->picture()->isVisible());
    QVERIFY(page_->picture()->moving());
    QCOMPARE(page_->table()->rowCount(), 2);
    QCOMPARE(cell(0, 1), QStringLiteral("Roll"));
    QCOMPARE(cell(0, 2), QStringLiteral("100.0"));
    QCOMPARE(cell(0, 3), QStringLiteral("5.00"));
    QCOMPARE(cell(0, 4), QStringLiteral("turns about y = 0.35 mm")); // the middle of 0.7 mm
    QCOMPARE(cell(1, 4), QStringLiteral("turns about x = 0.64 mm")); // 0.75 of 0.85 mm
    QCOMPARE(page_->picture()->mode()->kind, std::string("roll"));   // the first is selected
    page_->table()->selectRow(1);
    QCOMPARE(page_->picture()->mode()->frequency, 200e3);
    page_->hide();
    QVERIFY(!page_->picture()->moving());
}

/// The error of each damping ratio that the cells leave, where it is known.
void TestModesPage::statesLimitsOfValidity()
{
    find();
    QCOMPARE(cell(0, 5), QStringLiteral("damping ± 0.30 %"));
    QCOMPARE(cell(1, 5), QString()); // not known
    QVERIFY(remarks()->isVisible());
}

void TestModesPage::theKeyboardDoesAll()
{
    button()->setFocus();
    QSignalSpy finished(&page_->controller(), &ModesController::finished);
    QTest::keyClick(button(), Qt::Key_Space);
    QTRY_COMPARE(finished.count(), 1);
    page_->table()->setFocus();
    QTest::keyClick(page_->table(), Qt::Key_Down);
    QCOMPARE(page_->picture()->mode()->frequency, 200e3);
    QTest::keyClick(page_->table(), Qt::Key_Tab);
    QVERIFY(!page_->table()->hasFocus()); // out of the table
    QTest::keyClick(page_->picture(), Qt::Key_Space);
    QVERIFY(!page_->picture()->moving());
    for (const QWidget* control : page_->findChildren<QWidget*>())
        if (control->focusPolicy() != Qt::NoFocus && control->isVisible() && control->inherits("QAbstractButton"))
            QVERIFY(!control->accessibleName().isEmpty() || !control->property("text").toString().isEmpty());
}

void TestModesPage::saysWhenTheCaseHasChanged()
{
    find();
    Case edited = case_;
    edited.title = "Another title";
    page_->setCase(edited);
    QVERIFY(!page_->stale());
    edited.disk.speed *= 2.0;
    page_->setCase(edited);
    QVERIFY(page_->stale());
    page_->setCase(case_);
    QVERIFY(!page_->stale());
}

void TestModesPage::aStopKeepsWhatIsKnown()
{
    QSignalSpy found(page_.get(), &ModesPage::found);
    find();
    QCOMPARE(found.count(), 1);
    QCOMPARE(found[0][1].value<ModesResult>().modes.size(), std::size_t(2));
    waiting_ = true;
    QSignalSpy progressed(&page_->controller(), &ModesController::progressed);
    QSignalSpy finished(&page_->controller(), &ModesController::finished);
    button()->click();
    QTRY_VERIFY(progressed.count() > 0);
    QVERIFY(page_->controller().active());
    button()->click(); // it says Stop by now
    QTRY_COMPARE(finished.count(), 1);
    QCOMPARE(page_->table()->rowCount(), 2);
    QCOMPARE(found.count(), 1); // a search that was stopped finds none
}

void TestModesPage::aFailureSaysWhy()
{
    failing_ = true;
    find();
    QCOMPARE(page_->table()->rowCount(), 0);
    QVERIFY(!page_->picture()->isVisible());
    QCOMPARE(remarks()->text(), QStringLiteral("No flying attitude was found."));
}

void TestModesPage::refusesACaseThatContradictsItself()
{
    Case c = case_;
    c.steady.radii = {20e-3, 25e-3};
    c.steady.skews = {0.1}; // one for two radii
    page_->setCase(c);
    button()->click();
    QVERIFY(!page_->controller().active());
    QVERIFY(remarks()->text().contains(QStringLiteral("skew")));
}

void TestModesPage::copiesTheTable()
{
    find();
    page_->table()->setFocus();
    QTest::keyClick(page_->table(), Qt::Key_C, Qt::ControlModifier);
    const QStringList lines = QGuiApplication::clipboard()->text().split(QLatin1Char('\n'));
    QCOMPARE(lines.size(), 4); // heads, two modes, the end
    QCOMPARE(lines[0].split(QLatin1Char('\t')).size(), page_->table()->columnCount());
    QVERIFY(lines[2].startsWith(QStringLiteral("2\tPitch\t200.0\t1.23\t")));
}

void TestModesPage::savesTheNumbers()
{
    auto* save = namedWidget<QToolButton>(*page_, QStringLiteral("Save the numbers of the modes"));
    QVERIFY(save && !save->isEnabled());
    find();
    QVERIFY(save->isEnabled() && save->isVisible());
    save->click();
    auto* dialog = page_->findChild<QFileDialog*>();
    QVERIFY(dialog);
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("modes.csv"));
    emit dialog->fileSelected(file);
    dialog->close();
    QFile written(file);
    QVERIFY(written.open(QIODevice::ReadOnly));
    QCOMPARE(written.readAll(), page_->csv());
    QVERIFY(!page_->unsaved());
}

void TestModesPage::speedAndPause()
{
    find();
    auto* pause = namedWidget<QToolButton>(*page_, QStringLiteral("Pause the motion"));
    QVERIFY(pause);
    pause->click();
    QVERIFY(!page_->picture()->moving());
    QVERIFY(namedWidget<QToolButton>(*page_, QStringLiteral("Play the motion")) == pause);
    auto* speed = page_->findChild<QSlider*>();
    const auto words = [&] {
        for (const QLabel* label : page_->findChildren<QLabel*>())
            if (label->text().startsWith(QStringLiteral("One cycle"))) return label->text();
        return QString();
    };
    QVERIFY(words().contains(timeText(1.0 / 100e3)));
    const QString before = words();
    speed->setValue(speed->maximum());
    QVERIFY(words() != before);
}

void TestModesPage::anotherCaseForgets()
{
    find();
    page_->clear();
    beginsEmpty();
    QVERIFY(!page_->picture()->mode());
}

void TestModesPage::aRealCase()
{
    const Case c = test::smallSlider(33);
    page_ = std::make_unique<ModesPage>();
    page_->setCase(c);
    find();
    const ModesResult expected = modes(c);
    QCOMPARE(page_->table()->rowCount(), static_cast<int>(expected.modes.size()));
    QVERIFY(!expected.modes.empty());
    for (int row = 0; row < page_->table()->rowCount(); ++row)
        QCOMPARE(cell(row, 2), typeset(expected.modes[std::size_t(row)].frequency / 1e3, 1));
}

TOUCHDOWN_TEST(TestModesPage)

} // namespace test_modes_page

#include "test_modes_page.moc"

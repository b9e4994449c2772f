// SPDX-License-Identifier: GPL-3.0-or-later
#include <QComboBox>
#include <QDropEvent>
#include <QLineEdit>
#include <QMessageBox>
#include <QMimeData>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

#include "core/case_files/case_file.h"
#include "core/studies/runs/reading.h"
#include "tests/support/test_program.h"
#include "tests/ui/window_fixture.h"
#include "ui/case/case_edits.h"
#include "ui/case/case_files.h"
#include "ui/case/case_panel.h"
#include "ui/lists/record_panel.h"
#include "ui/plot/plot_export.h"
#include "ui/plot/spectrum_view.h"
#include "ui/runs/live_plots.h"
#include "ui/runs/live_spectrum.h"
#include "ui/runs/run_record.h"
#include "ui/runs/run_view.h"
#include "ui/runs/run_window.h"
#include "ui/style/message_strip.h"
#include "ui/style/theme.h"
#include "ui/window/help_window.h"
#include "ui/window/main_window.h"
#include "ui/window/window_actions.h"

using namespace touchdown;

namespace test_main_window {

struct Fixture : test::WindowFixture {
    using WindowFixture::WindowFixture;
    QLineEdit* line(const char* key) { return qobject_cast<QLineEdit*>(window.casePanel().editor(key)->input()); }
    QMessageBox* box(const char* name) { return window.findChild<QMessageBox*>(QString::fromLatin1(name)); }
};

class TestMainWindow : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init() { QSettings().clear(); }
    void opensWithTheDefaultCase();
    void disablesRunForABadParameter();
    void takesWhatWasTypedWhenRunning();
    void takesWhatWasTypedWhenSavingAndClosing();
    void keepsCommentsWhenSaving();
    void asksAboutUnsavedChanges_data();
    void asksAboutUnsavedChanges();
    void changedBackIsUnchanged();
    void showsProblemsOfABadFile();
    void takesDroppedFiles();
    void restoresTheSession();
    void opensTheLastImportAgain();
    void changesThemeAndFont();
    void exportsThePage();
    void opensHelp();
    void namesEveryControl();
};

void TestMainWindow::initTestCase()
{
    QCoreApplication::setOrganizationName(QStringLiteral("touchdown"));
    QCoreApplication::setApplicationName(QStringLiteral("test_main_window"));
}

void TestMainWindow::opensWithTheDefaultCase()
{
    MainWindow window;
    window.openLastCase();
    QCOMPARE(window.files().sample(), QStringLiteral("fig10a"));
    QVERIFY(!window.files().modified());
    QVERIFY(window.actions().run->isEnabled());
    QVERIFY(!window.actions().stop->isEnabled());
    QVERIFY(!window.actions().exportCsv->isEnabled());
}

void TestMainWindow::disablesRunForABadParameter()
{
    Fixture f;
    f.edit("springs.flying_height", QStringLiteral("7 mN"));
    QVERIFY(!f.window.actions().run->isEnabled());
    QVERIFY(f.window.actions().run->toolTip().contains(QStringLiteral("flying height"), Qt::CaseInsensitive));
    QCOMPARE(f.window.messages().kind(), MessageStrip::Kind::Failure);
    f.window.actions().undo->trigger();
    QVERIFY(f.window.actions().run->isEnabled());
    QVERIFY(f.window.messages().isHidden());
}

void TestMainWindow::takesWhatWasTypedWhenRunning()
{
    Fixture f;
    QApplication::setActiveWindow(&f.window);
    QLineEdit* line = f.line("springs.flying_height");
    line->setFocus();
    line->selectAll();
    QTest::keyClicks(line, QStringLiteral("0.0065 um"));
    f.runToEnd();
    QCOMPARE(f.window.runs().record(0).value.springs.flyingHeight, 6.5e-9);
}

/// Without Return or Tab, as after it.
void TestMainWindow::takesWhatWasTypedWhenSavingAndClosing()
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("mine.toml"));
    QCOMPARE(writeCaseFile(file.toStdString(), "title = \"mine\"\n"), std::string());
    Fixture f;
    f.window.files().open(file);
    QApplication::setActiveWindow(&f.window);
    const auto type = [&f](const char* text) {
        QLineEdit* line = f.line("springs.flying_height");
        line->setFocus();
        line->selectAll();
        QTest::keyClicks(line, QString::fromLatin1(text));
    };
    type("6.5 nm");
    f.window.actions().save->trigger();
    QCOMPARE(readCaseFile(file.toStdString()).value.springs.flyingHeight, 6.5e-9);
    type("6 nm");
    f.window.close();
    QVERIFY(f.window.isVisible());
    QVERIFY(f.box("closing") != nullptr);
}

void TestMainWindow::keepsCommentsWhenSaving()
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("mine.toml"));
    QFile written(file);
    QVERIFY(written.open(QIODevice::WriteOnly));
    written.write("# my slider\nmodel = \"springs\"\n\n[springs]\nflying_height = \"7 nm\" # as designed\n");
    written.close();
    Fixture f;
    QVERIFY(f.window.files().openNow(file));
    QVERIFY(f.window.windowTitle().startsWith(QStringLiteral("mine.toml")));
    f.edit("springs.flying_height", QStringLiteral("4"));
    QVERIFY(f.window.isWindowModified());
    f.window.actions().save->trigger();
    QVERIFY(!f.window.isWindowModified());
    QVERIFY(written.open(QIODevice::ReadOnly));
    const QByteArray text = written.readAll();
    QVERIFY(text.startsWith("# my slider\n"));
    QVERIFY2(text.contains("flying_height = \"4 nm\" # as designed"), text.constData());
    QCOMPARE(f.window.files().recent().front(), file);
}

void TestMainWindow::asksAboutUnsavedChanges_data()
{
    QTest::addColumn<int>("answer");
    QTest::addColumn<bool>("opened");
    QTest::newRow("discard") << static_cast<int>(QMessageBox::Discard) << true;
    QTest::newRow("cancel") << static_cast<int>(QMessageBox::Cancel) << false;
}

void TestMainWindow::asksAboutUnsavedChanges()
{
    QFETCH(const int, answer);
    QFETCH(const bool, opened);
    Fixture f;
    f.edit("springs.flying_height", QStringLiteral("4"));
    f.window.files().open(QStringLiteral("fig11a"));
    QMessageBox* box = f.box("unsavedChanges");
    QVERIFY(box);
    QCOMPARE(f.window.files().sample(), QStringLiteral("fig10a"));
    box->button(static_cast<QMessageBox::StandardButton>(answer))->click();
    QCOMPARE(f.window.files().sample(), opened ? QStringLiteral("fig11a") : QStringLiteral("fig10a"));
    QCOMPARE(f.window.files().modified(), !opened);
}

void TestMainWindow::changedBackIsUnchanged()
{
    Fixture f;
    const QString before = QString::fromStdString(f.window.files().text());
    f.edit("springs.flying_height", QStringLiteral("4"));
    QVERIFY(f.window.isWindowModified());
    f.edit("springs.flying_height", QStringLiteral("much"));
    QVERIFY(f.window.isWindowModified());
    f.edit("springs.flying_height", QStringLiteral("7"));
    QVERIFY(!f.window.files().modified());
    QVERIFY(!f.window.isWindowModified());
    QCOMPARE(QString::fromStdString(f.window.files().text()), before);
    f.window.files().open(QStringLiteral("fig11a")); // without a question
    QVERIFY(!f.box("unsavedChanges"));
    QCOMPARE(f.window.files().sample(), QStringLiteral("fig11a"));
}

void TestMainWindow::showsProblemsOfABadFile()
{
    const QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("bad.toml")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("[slider]\nmas = \"1 mg\"\n");
    file.close();
    Fixture f;
    QVERIFY(!f.window.files().openNow(file.fileName()));
    QVERIFY(f.box("problems")->informativeText().contains(QStringLiteral("slider.mas")));
    QCOMPARE(f.window.files().sample(), QStringLiteral("fig10a"));
}

void TestMainWindow::takesDroppedFiles()
{
    const QTemporaryDir folder;
    Fixture f;
    f.runToEnd();
    const QString results = folder.filePath(QStringLiteral("run.h5"));
    QCOMPARE(saveHdf5(f.window.runs().record(0), results), QString());
    const QString caseFile = folder.filePath(QStringLiteral("mine.toml"));
    QCOMPARE(writeCaseFile(caseFile.toStdString(), "[springs]\nflying_height = \"5 nm\"\n"), std::string());

    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(results), QUrl::fromLocalFile(caseFile)});
    QDragEnterEvent enter({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&f.window, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&f.window, &drop);
    QCOMPARE(f.window.runs().count(), 2);
    QCOMPARE(f.window.runs().record(1).sampleCount(), std::size_t(20'001));
    QTRY_COMPARE(f.window.runView().spectrum()->view()->plot()->curves().size(), std::size_t(2)); // its spectrum too
    QCOMPARE(f.window.edits().value().springs.flyingHeight, 5e-9);
}

void TestMainWindow::restoresTheSession()
{
    {
        Fixture f("fig12a");
        f.window.restoreArrangement();
        f.window.files().openNow(QStringLiteral("fig12a"));
        f.window.runWindow().panel()->setOverlay(false);
        f.choosePace(1e-4);
        LivePlots* plots = f.window.runView().plots();
        plots->addPlot(plots->quantities().front());
        for (QAction* action : f.window.actions().theme->actions())
            if (action->data() == QStringLiteral("dark")) action->trigger();
        f.window.close();
    }
    MainWindow window;
    window.restoreArrangement();
    window.openLastCase();
    QCOMPARE(window.files().sample(), QStringLiteral("fig12a"));
    QVERIFY(!window.runWindow().panel()->overlay());
    QCOMPARE(window.controller().pace(), 1e-4);
    const LivePlots::Entry& own = window.runView().plots()->plots().back();
    QCOMPARE(own.name, QStringLiteral("own 1"));
    QVERIFY(window.actions().plots->actions().contains(own.wanted));
    QVERIFY(isDark(QApplication::palette()));
    applyTheme(Theme::Light);
}

/// A slider that was opened as its rails is there again at the next start.
void TestMainWindow::opensTheLastImportAgain()
{
    const QTemporaryDir folder;
    const QString place = folder.filePath(QStringLiteral("mine"));
    {
        Fixture f("film_pico");
        f.window.files().exportTo(place);
        f.window.files().openNow(place + QStringLiteral("/rail.dat"));
        f.window.close();
    }
    MainWindow window;
    window.openLastCase();
    QCOMPARE(window.files().shortName(), QStringLiteral("mine"));
    QCOMPARE(window.edits().value().model, ModelKind::Film);
}

void TestMainWindow::changesThemeAndFont()
{
    Fixture f;
    const int before = QApplication::font().pointSize();
    for (QAction* action : f.window.actions().fontSize->actions())
        if (action->data().toInt() == 5) action->trigger();
    QCOMPARE(QApplication::font().pointSize(), before + 5);
    for (QAction* action : f.window.actions().theme->actions())
        if (action->data() == QStringLiteral("dark")) action->trigger();
    QTRY_VERIFY(isDark(f.window.palette()));
    // Fields and check boxes have only the base to stand out by; 16 of 255 is what an eye still sees on a projector.
    const QPalette dark = f.window.palette();
    QVERIFY(dark.color(QPalette::Window).lightness() - dark.color(QPalette::Base).lightness() >= 16);
    QTRY_VERIFY(f.window.runView().plots()->plot(QStringLiteral("spacing"))->theme().background.lightness() < 128);
    applyTheme(Theme::Light);
    QTRY_VERIFY(!isDark(f.window.palette()));
}

void TestMainWindow::exportsThePage()
{
    const QTemporaryDir folder;
    Fixture f;
    f.runToEnd();
    for (const char* ending : {"png", "svg", "pdf"}) {
        const QString file = folder.filePath(QStringLiteral("page.%1").arg(QLatin1String(ending)));
        QCOMPARE(savePicture(*f.window.page(), file), QString());
        QVERIFY(QFileInfo(file).size() > 1000);
    }
}

void TestMainWindow::opensHelp()
{
    Fixture f;
    f.window.actions().help->trigger();
    auto* help = f.window.findChild<HelpWindow*>();
    QVERIFY(help && help->isVisible());
    const QRect screen = f.window.screen()->availableGeometry();
    QVERIFY(screen.contains(help->frameGeometry()));
    help->close();
    f.window.move(screen.right() - 300, screen.bottom() - 300);
    f.window.actions().help->trigger();
    QTRY_VERIFY(help->isVisible() && screen.contains(help->frameGeometry()));
    help->open(HelpWindow::Page::Equations);
    QVERIFY(help->text().contains(QStringLiteral("M z″")));
    help->open(HelpWindow::Page::Parameters);
    for (const Parameter& parameter : parameters())
        QVERIFY2(help->text().contains(QString::fromStdString(parameter.key)), parameter.key.c_str());
    help->open(HelpWindow::Page::Readings);
    for (const ReadingRow& row : allReadings())
        QVERIFY2(help->text().contains(QString::fromStdString(row.what.quantity.name)), row.what.quantity.name.c_str());
    help->open(HelpWindow::Page::Shortcuts);
    QVERIFY(help->text().contains(QStringLiteral("F5")));
    help->open(HelpWindow::Page::About);
    QVERIFY(help->text().contains(QStringLiteral("GNU")));
}

void TestMainWindow::namesEveryControl()
{
    Fixture f;
    for (const QWidget* widget : f.window.findChildren<QWidget*>()) {
        // What the keyboard can reach, a screen reader must be able to name.
        if (!widget->isVisibleTo(&f.window) || !(widget->focusPolicy() & Qt::TabFocus)) continue;
        if (widget->objectName().startsWith(QLatin1String("qt_")) || widget->inherits("QScrollBar")) continue;
        if (widget->focusProxy()) continue;
        const bool named = !widget->accessibleName().isEmpty() || !widget->property("text").toString().isEmpty();
        QVERIFY2(named, qPrintable(QString::fromLatin1(widget->metaObject()->className()) + QLatin1Char(' ') +
                                   widget->objectName() + QStringLiteral(" in ") +
                                   QString::fromLatin1(widget->parentWidget()->metaObject()->className())));
    }
}

TOUCHDOWN_TEST(TestMainWindow)

} // namespace test_main_window

#include "test_main_window.moc"

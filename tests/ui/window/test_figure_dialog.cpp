// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/figure_dialog.h"

#include <memory>

#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

#include "tests/support/test_program.h"
#include "ui/case/case_files.h"
#include "ui/runs/live_plots.h"
#include "ui/runs/run_view.h"
#include "ui/window/main_window.h"
#include "ui/window/window_actions.h"

using namespace touchdown;

namespace test_figure_dialog {

class TestFigureDialog : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QCoreApplication::setOrganizationName(QStringLiteral("touchdown"));
        QCoreApplication::setApplicationName(QStringLiteral("test_figure_dialog"));
    }
    void init()
    {
        QSettings().clear();
        window_ = std::make_unique<MainWindow>();
        window_->resize(1400, 900);
        window_->show();
        window_->files().openNow(QStringLiteral("fig10a"));
        QSignalSpy ended(window_.get(), &MainWindow::calculationEnded);
        window_->startRun();
        QVERIFY(ended.wait(20000));
    }
    void cleanup() { window_.reset(); }

    void beginsWithTheMotionAndItsSpectrum()
    {
        FigureDialog& dialog = open();
        QCOMPARE(dialog.panels()->count(), 5); // spacing, pitch, energy, forces, spectrum
        QStringList checked;
        for (int row = 0; row < dialog.panels()->count(); ++row)
            if (dialog.panels()->item(row)->checkState() == Qt::Checked) checked << dialog.panels()->item(row)->text();
        QCOMPARE(checked.size(), 2);
        QCOMPARE(checked[0], QString("Minimum spacing"));
        QVERIFY(checked[1].startsWith("Spectrum"));
        QVERIFY(dialog.exportButton()->isEnabled());
        QVERIFY(dialog.remark().startsWith("85.0 mm"));
        QVERIFY(!dialog.preview()->pixmap().isNull());
    }

    void previewFollowsTheChoices()
    {
        FigureDialog& dialog = open();
        const QImage before = dialog.preview()->pixmap().toImage();
        dialog.panels()->item(1)->setCheckState(Qt::Checked);
        QVERIFY(dialog.preview()->pixmap().toImage() != before);
        for (int row = 0; row < dialog.panels()->count(); ++row)
            dialog.panels()->item(row)->setCheckState(Qt::Unchecked);
        QVERIFY(!dialog.exportButton()->isEnabled());
        QVERIFY(dialog.remark().contains("at least one"));
        dialog.panels()->item(0)->setCheckState(Qt::Checked);
        FigureFormat low = dialog.format();
        low.height = 20.0;
        dialog.setFormat(low);
        QVERIFY(!dialog.exportButton()->isEnabled());
        QVERIFY(dialog.remark().contains("too low"));
    }

    void settingsAreKeptWithTheCase()
    {
        const QTemporaryDir folder;
        FigureFormat wanted;
        wanted.width = 120.0;
        wanted.height = 90.0;
        wanted.columns = 2;
        wanted.fontSize = 7.0;
        wanted.dotsPerInch = 300;
        wanted.colours = PaperColours::Black;
        wanted.letters = false;
        wanted.titles = false;
        wanted.data = false;
        {
            FigureDialog& dialog = open();
            wanted.family = dialog.format().family;
            dialog.setFormat(wanted);
            QCOMPARE(dialog.format(), wanted);
            dialog.panels()->insertItem(0, dialog.panels()->takeItem(2)); // energy first
            dialog.panels()->item(0)->setCheckState(Qt::Checked);
            dialog.exportTo(folder.filePath("figure.png"));
            QVERIFY2(dialog.remark().startsWith("Written: "), qPrintable(dialog.remark()));
            QVERIFY(QFileInfo::exists(folder.filePath("figure.png")));
            dialog.close();
        }
        QTRY_VERIFY(!window_->findChild<FigureDialog*>());
        FigureDialog& again = open();
        QCOMPARE(again.format(), wanted);
        QCOMPARE(again.panels()->item(0)->text(), QString("Energy"));
        QCOMPARE(again.panels()->item(0)->checkState(), Qt::Checked);
        QCOMPARE(again.panels()->item(1)->text(), QString("Minimum spacing"));
        again.close();
        // Another case has the same format, and its own panels.
        QTRY_VERIFY(!window_->findChild<FigureDialog*>());
        window_->files().openNow(QStringLiteral("fig10b"));
        FigureDialog& other = open();
        QCOMPARE(other.format(), wanted);
        QCOMPARE(other.panels()->item(0)->text(), QString("Minimum spacing"));
    }

    void problemIsShownAndNothingIsKept()
    {
        FigureDialog& dialog = open();
        dialog.exportTo("/no/such/folder/figure.pdf");
        QVERIFY2(dialog.remark().contains("could not be written"), qPrintable(dialog.remark()));
        QVERIFY(QSettings().allKeys().filter("figure/").isEmpty());
    }

    void clickedThrough()
    {
        const QTemporaryDir folder;
        FigureDialog& dialog = open();
        QTest::mouseClick(dialog.exportButton(), Qt::LeftButton);
        QFileDialog* files = nullptr;
        QTRY_VERIFY((files = dialog.findChild<QFileDialog*>()) != nullptr);
        emit files->fileSelected(folder.filePath("figure.pdf"));
        files->close();
        QVERIFY(QFileInfo::exists(folder.filePath("figure.pdf")));
        QVERIFY(QFileInfo::exists(folder.filePath("figure-b.csv")));
        QVERIFY(dialog.remark().contains("href=\"file://"));
    }

private:
    FigureDialog& open()
    {
        window_->actions().figure->trigger();
        auto* dialog = window_->findChild<FigureDialog*>();
        if (!dialog) qFatal("no dialog");
        return *dialog;
    }

    std::unique_ptr<MainWindow> window_;
};

TOUCHDOWN_TEST(TestFigureDialog)

} // namespace test_figure_dialog

#include "test_figure_dialog.moc"

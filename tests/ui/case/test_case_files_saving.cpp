// SPDX-License-Identifier: GPL-3.0-or-later
//
// Another program, or another window, writes the file of the case that is edited here. No text is lost without an
// answer.
#include "ui/case/case_files.h"

#include <array>
#include <functional>
#include <memory>
#include <random>
#include <set>

#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

#include "core/case_files/case_file.h"
#include "core/case_files/cml_case.h"
#include "tests/support/test_program.h"
#include "tests/ui/question.h"
#include "tests/ui/sample_slider.h"
#include "ui/case/file_notice.h"

using namespace touchdown;

namespace test_case_files_saving {

constexpr auto asked = "changedFile";
const QString writeOver = QStringLiteral("Write over it");
const QString reload = QStringLiteral("Reload the file");
const QString saveAs = QStringLiteral("Save as…");
const QString cancel = QStringLiteral("Cancel");

/// A window with nothing but the case and the notice of its file.
struct Window {
    explicit Window(const QString& file)
    {
        widget.show();
        files->openNow(file);
    }
    void edit(const QString& height) { edits.enter(*findParameter("springs.flying_height"), height); }
    double height() const { return edits.value().springs.flyingHeight; }
    bool asks() const { return question(widget, asked) != nullptr; }
    void answer(const QString& text)
    {
        touchdown::answer(widget, asked, text);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    QString notice() const { return widget.findChild<FileNotice*>()->text(); }

    QWidget widget;
    CaseEdits edits;
    CaseFiles* files = new CaseFiles(edits, widget);
    FileNotice* shown = new FileNotice(*files, &widget);
};

QString caseText(const QString& height, const QString& comment = {})
{
    return QStringLiteral("# %2\ntitle = \"mine\"\nmodel = \"springs\"\n[springs]\nflying_height = \"%1 nm\"\n")
        .arg(height, comment);
}

using Way = std::function<void(const QString& file)>; // in which another program leaves the file

class TestCaseFilesSaving : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QCoreApplication::setOrganizationName(QStringLiteral("touchdown"));
        QCoreApplication::setApplicationName(QStringLiteral("test_case_files_saving"));
    }
    void init()
    {
        QSettings().clear();
        folder_ = std::make_unique<QTemporaryDir>();
        file_ = folder_->filePath(QStringLiteral("mine.toml"));
        write(file_, caseText(QStringLiteral("7"), QStringLiteral("my notes")));
    }

    void anotherTextIsNotWrittenOver_data() { addChanges(); }
    void anotherTextIsNotWrittenOver()
    {
        QFETCH(const Way, change);
        Window window(file_);
        window.edit(QStringLiteral("4"));
        change(file_);
        const QString theirs = read(file_);
        window.files->save();
        QVERIFY(window.asks());
        QCOMPARE(read(file_), theirs);
        QVERIFY(question(window.widget, asked)->text().contains(QStringLiteral("mine.toml")));
        window.answer(cancel);
        QCOMPARE(read(file_), theirs);
        QCOMPARE(window.height(), 4e-9);
        QVERIFY(window.files->modified());
        QVERIFY(!window.files->write(file_).isEmpty()); // as Save all does
        QCOMPARE(read(file_), theirs);
        // Whoever wants to may.
        window.files->save();
        window.answer(writeOver);
        if (QFileInfo(file_).isDir()) {
            QVERIFY(question(window.widget, "problems") != nullptr);
            QVERIFY(window.files->modified());
            return;
        }
        QVERIFY(read(file_).contains(QStringLiteral("4 nm")));
        QVERIFY(!window.files->modified());
        window.edit(QStringLiteral("3"));
        window.files->save(); // one's own text is no change
        QVERIFY(!window.asks());
        QVERIFY(read(file_).contains(QStringLiteral("3 nm")));
    }

    void theSameBytesAreNoChange()
    {
        Window window(file_);
        window.edit(QStringLiteral("4"));
        const QString text = read(file_);
        QVERIFY(QFile::remove(file_));
        write(file_, text);
        window.files->save();
        QVERIFY(!window.asks());
        QVERIFY(read(file_).contains(QStringLiteral("4 nm")));
    }
    void aDeletedFileIsWrittenAgain()
    {
        Window window(file_);
        QVERIFY(QFile::remove(file_));
        QTRY_VERIFY(window.notice().contains(QStringLiteral("deleted")));
        window.edit(QStringLiteral("4"));
        window.files->save();
        QVERIFY(!window.asks());
        QVERIFY(read(file_).contains(QStringLiteral("4 nm")));
        QCOMPARE(window.notice(), QString());
    }

    void theQuestionShowsTheDifferences()
    {
        Window window(file_);
        window.edit(QStringLiteral("4"));
        write(file_, caseText(QStringLiteral("5")));
        window.files->save();
        const QString shown = question(window.widget, asked)->informativeText();
        QVERIFY2(shown.contains(QStringLiteral("5\u00A0nm → 4\u00A0nm")), qPrintable(shown));
        window.answer(cancel);
        write(file_, caseText(QStringLiteral("4"), QStringLiteral("other notes")));
        window.files->save();
        QVERIFY(!question(window.widget, asked)->informativeText().contains(QStringLiteral("→ 4")));
    }

    /// Undo brings the edits back, and they are then saved into the text of the other program.
    void reloadingIsAStepOfUndo()
    {
        Window window(file_);
        window.edit(QStringLiteral("4"));
        write(file_, caseText(QStringLiteral("5"), QStringLiteral("their notes")));
        window.files->save();
        window.answer(reload);
        QCOMPARE(window.height(), 5e-9);
        QVERIFY(!window.files->modified());
        QCOMPARE(QString::fromStdString(window.files->text()), read(file_));
        window.edits.undoStack().undo();
        QCOMPARE(window.height(), 4e-9);
        QVERIFY(window.files->modified());
        window.files->save();
        QVERIFY(!window.asks());
        QCOMPARE(read(file_), caseText(QStringLiteral("4"), QStringLiteral("their notes")));
    }

    void aFileThatIsNoCaseCannotBeReloaded()
    {
        Window window(file_);
        window.edit(QStringLiteral("4"));
        write(file_, QStringLiteral("title = \n"));
        QTRY_VERIFY(window.notice().contains(QStringLiteral("mine.toml:1")));
        window.files->save();
        QVERIFY(!namedWidget<QAbstractButton>(*question(window.widget, asked), reload)->isEnabled());
        window.answer(cancel);
        window.files->reload();
        QVERIFY(question(window.widget, "problems") != nullptr);
        QCOMPARE(window.height(), 4e-9);
        QCOMPARE(read(file_), QStringLiteral("title = \n"));
    }

    /// The answer is for the text that the person saw.
    void aFileThatChangesOnceMoreIsAskedForAgain()
    {
        Window window(file_);
        window.edit(QStringLiteral("4"));
        write(file_, caseText(QStringLiteral("5")));
        window.files->save();
        write(file_, caseText(QStringLiteral("6")));
        window.answer(writeOver);
        QVERIFY(window.asks());
        QCOMPARE(read(file_), caseText(QStringLiteral("6")));
        window.answer(writeOver);
        QVERIFY(read(file_).contains(QStringLiteral("4 nm")));
    }

    /// What was to follow the saving follows it, or nothing.
    void whatFollowsWaitsForTheAnswer()
    {
        for (const auto& [text, followed] : {std::pair(writeOver, 1), std::pair(reload, 0), std::pair(cancel, 0)}) {
            write(file_, caseText(QStringLiteral("7")));
            Window window(file_);
            window.edit(QStringLiteral("4"));
            write(file_, caseText(QStringLiteral("5")));
            int calls = 0;
            window.files->saveThen([&calls] { ++calls; });
            QCOMPARE(calls, 0);
            window.answer(text);
            QCOMPARE(calls, followed);
            window.edit(QStringLiteral("3"));
            if (text != cancel) window.files->save();
            QCOMPARE(calls, followed);
        }
    }
    void savingUnderAnotherNameLeavesTheFile()
    {
        Window window(file_);
        window.edit(QStringLiteral("4"));
        const QString theirs = caseText(QStringLiteral("5"));
        write(file_, theirs);
        window.files->save();
        window.answer(saveAs);
        auto* dialog = window.widget.findChild<QFileDialog*>();
        QVERIFY(dialog != nullptr);
        const QString other = folder_->filePath(QStringLiteral("other.toml"));
        emit dialog->fileSelected(other);
        QCOMPARE(window.files->file(), other);
        QVERIFY(read(other).contains(QStringLiteral("4 nm")));
        QCOMPARE(read(file_), theirs);
        QTRY_COMPARE(window.notice(), QString());
    }
    /// The dialog has asked whether to replace it, but not said that it changed.
    void theSameNameInTheDialogIsAskedFor()
    {
        Window window(file_);
        window.edit(QStringLiteral("4"));
        const QString theirs = caseText(QStringLiteral("5"));
        write(file_, theirs);
        window.files->saveAs();
        QVERIFY(QFile::link(file_, folder_->filePath(QStringLiteral("link.toml"))));
        emit window.widget.findChild<QFileDialog*>()->fileSelected(folder_->filePath(QStringLiteral("link.toml")));
        QVERIFY(window.asks());
        QCOMPARE(read(file_), theirs);
    }

    void aChangeIsNoticed_data() { addChanges(); }
    void aChangeIsNoticed()
    {
        QFETCH(const Way, change);
        Window window(file_);
        QCOMPARE(window.notice(), QString());
        change(file_);
        QTRY_VERIFY(window.notice().contains(QStringLiteral("mine.toml")));
        QVERIFY(window.shown->isVisible());
        // Nothing is reloaded by itself.
        QCOMPARE(window.height(), 7e-9);
        if (QFileInfo(file_).isDir()) QVERIFY(QDir().rmdir(file_));
        QFile::remove(file_);
        write(file_, caseText(QStringLiteral("7"), QStringLiteral("my notes")));
        QTRY_COMPARE(window.notice(), QString()); // as it was
        change(file_);
        QTRY_VERIFY(!window.notice().isEmpty());
        window.files->openNow(QStringLiteral("fig10a"));
        QCOMPARE(window.notice(), QString());
    }
    /// Also where the system reports nothing, as on a file system of the network.
    void aChangeIsNoticedWhenTheWindowComesToTheFront()
    {
        Window window(file_);
        QFile::remove(file_);
        write(file_, caseText(QStringLiteral("5")));
        QEvent activated(QEvent::WindowActivate);
        QCoreApplication::sendEvent(&window.widget, &activated);
        QVERIFY(window.notice().contains(QStringLiteral("changed")));
        auto* button = namedWidget<QAbstractButton>(*window.shown, QStringLiteral("Reload"));
        QVERIFY(button && button->isVisible());
        button->click();
        QCOMPARE(window.height(), 5e-9);
        QCOMPARE(window.notice(), QString());
    }
    void aClosedNoticeComesWithTheNextChange()
    {
        Window window(file_);
        write(file_, caseText(QStringLiteral("5")));
        QTRY_VERIFY(!window.notice().isEmpty());
        namedWidget<QAbstractButton>(*window.shown, QStringLiteral("Close the message"))->click();
        QEvent activated(QEvent::WindowActivate);
        QCoreApplication::sendEvent(&window.widget, &activated);
        QCOMPARE(window.notice(), QString());
        write(file_, caseText(QStringLiteral("6")));
        QTRY_VERIFY(!window.notice().isEmpty());
        namedWidget<QAbstractButton>(*window.shown, QStringLiteral("Differences…"))->click();
        QVERIFY(question(window.widget, asked)->informativeText().contains(QStringLiteral("6\u00A0nm → 7\u00A0nm")));
    }
    /// The text of the session may be older than the file.
    void aRestoredCaseKnowsItsFile()
    {
        const CaseState state = Window(file_).files->state();
        write(file_, caseText(QStringLiteral("5")));
        Window window(QStringLiteral("fig10a"));
        window.files->restore(state);
        QTRY_VERIFY(window.notice().contains(QStringLiteral("mine.toml")));
        window.edit(QStringLiteral("4"));
        window.files->save();
        QVERIFY(window.asks());
    }

    /// Not with the defaults in its place.
    void aTextThatCannotBeReadChangesNothing()
    {
        CaseState state = Window(file_).files->state();
        state.modified = true;
        for (const char* text :
             {"", "[springs]\nflying_hight = \"9 nm\"\n", "[slider]\nmass = \"6.5 stone\"\n", "[sli"}) {
            state.text = QString::fromLatin1(text);
            Window window(QStringLiteral("fig10a"));
            QVERIFY(!window.files->restore(state).isEmpty());
            QCOMPARE(window.files->sample(), QStringLiteral("fig10a"));
            QVERIFY(!window.files->modified());
        }
    }

    /// Their values are in the case since it was opened.
    void aNamedFileIsWatched_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("name");
        QTest::newRow("rails") << QStringLiteral("model = \"film\"\n[abs]\nrails = \"slider/rail.dat\"\n")
                               << QStringLiteral("slider/rail.dat");
        QTest::newRow("a measured surface")
            << QStringLiteral("model = \"contact\"\n[disk.surface]\nkind = \"file\"\nmotion = \"still\"\n"
                              "file = \"track.txt\"\n")
            << QStringLiteral("track.txt");
    }
    void aNamedFileIsWatched()
    {
        QFETCH(const QString, text);
        QFETCH(const QString, name);
        write(folder_->filePath(QStringLiteral("track.txt")),
              QStringLiteral("# x [um]  h [nm]\n0 0\n1 1\n2 0\n3 -1\n"));
        const CmlOutput output = formatCmlCase(sampleFilmCase());
        QCOMPARE(writeCmlCase(folder_->filePath(QStringLiteral("slider")).toStdString(), output.members),
                 std::string());
        write(file_, text);
        Window window(file_);
        QCOMPARE(window.files->file(), file_);
        const QString named = folder_->filePath(name), before = read(named);
        write(named, before + QLatin1Char('\n'));
        QTRY_VERIFY(window.notice().contains(QFileInfo(name).fileName()));
        QVERIFY(window.notice().contains(QStringLiteral("mine.toml")));
        write(named, before);
        QTRY_COMPARE(window.notice(), QString());
        write(named, before + QLatin1Char('\n'));
        QTRY_VERIFY(!window.notice().isEmpty());
        namedWidget<QAbstractButton>(*window.shown, QStringLiteral("Reload"))->click();
        QCOMPARE(window.notice(), QString());
        QVERIFY(!window.files->modified());
        QVERIFY(QFile::remove(named));
        QTRY_VERIFY(window.notice().contains(QStringLiteral("was deleted or renamed")));
        const auto* button = namedWidget<QAbstractButton>(*window.shown, QStringLiteral("Reload"));
        QVERIFY(!button || !button->isVisible());
    }

    void noTextIsLostInAnyOrder_data()
    {
        QTest::addColumn<unsigned>("seed");
        for (unsigned seed = 1; seed <= 50; ++seed) QTest::addRow("%u", seed) << seed;
    }
    /// Two windows and another program on one file. A text that its writer has seen on the disk is written over only
    /// by a window that read it, or after a question.
    void noTextIsLostInAnyOrder()
    {
        QFETCH(const unsigned, seed);
        std::mt19937 random(seed);
        const auto pick = [&random](int count) { return static_cast<int>(random() % static_cast<unsigned>(count)); };
        std::array<std::unique_ptr<Window>, 2> windows{std::make_unique<Window>(file_),
                                                       std::make_unique<Window>(file_)};
        std::array<QString, 2> known{read(file_), read(file_)}; // what each window last read or wrote there
        int height = 10;
        for (int step = 0; step < 40; ++step) {
            const auto which = static_cast<std::size_t>(pick(2));
            Window& window = *windows[which];
            const QString before = read(file_);
            const double own = window.height();
            switch (pick(6)) {
            case 0: window.edit(QString::number(++height)); break;
            case 1: write(file_, caseText(QString::number(++height), QStringLiteral("step %1").arg(step))); break;
            case 2: window.edits.undoStack().undo(); break;
            case 3: window.edits.undoStack().redo(); break;
            case 4:
                window.files->reload();
                known[which] = before;
                QCOMPARE(read(file_), before);
                if (window.height() == own) break;
                window.edits.undoStack().undo(); // the edits are still there
                QCOMPARE(window.height(), own);
                window.edits.undoStack().redo();
                break;
            case 5: {
                window.files->save();
                const bool isKnown = before == known[which];
                QCOMPARE(window.asks(), !isKnown);
                if (isKnown) {
                    known[which] = read(file_);
                    break;
                }
                QCOMPARE(read(file_), before);
                const QString choice = std::array{writeOver, reload, cancel}[static_cast<std::size_t>(pick(3))];
                window.answer(choice);
                if (choice != writeOver) QCOMPARE(read(file_), before);
                if (choice != cancel) known[which] = read(file_);
                break;
            }
            }
            QVERIFY(!window.asks());
        }
    }

private:
    static void addChanges()
    {
        QTest::addColumn<Way>("change");
        const QString theirs = caseText(QStringLiteral("5"), QStringLiteral("their notes"));
        QTest::newRow("written in place") << Way([theirs](const QString& file) { write(file, theirs); });
        QTest::newRow("replaced") << Way([theirs](const QString& file) {
            write(file + QStringLiteral(".new"), theirs);
            std::filesystem::rename((file + QStringLiteral(".new")).toStdString(), file.toStdString());
        });
        QTest::newRow("the same size") << Way(
            [](const QString& file) { write(file, caseText(QStringLiteral("5"), QStringLiteral("my notes"))); });
        QTest::newRow("another window") << Way([](const QString& file) {
            Window other(file);
            other.edit(QStringLiteral("6"));
            other.files->save();
        });
        QTest::newRow("no case any more")
            << Way([](const QString& file) { write(file, QStringLiteral("model = [\n")); });
        QTest::newRow("a directory") << Way([](const QString& file) {
            QFile::remove(file);
            QDir().mkdir(file);
        });
    }
    static void write(const QString& file, const QString& text)
    {
        QFile out(file);
        if (!out.open(QIODevice::WriteOnly) || out.write(text.toUtf8()) < 0) qFatal("cannot write");
    }
    static QString read(const QString& file)
    {
        QFile in(file);
        return in.open(QIODevice::ReadOnly) ? QString::fromUtf8(in.readAll()) : QString();
    }

    std::unique_ptr<QTemporaryDir> folder_;
    QString file_;
};

TOUCHDOWN_TEST(TestCaseFilesSaving)

} // namespace test_case_files_saving

#include "test_case_files_saving.moc"

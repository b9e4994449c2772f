// SPDX-License-Identifier: GPL-3.0-or-later
//
// The form of a study and its text are two views of one study.
#include "ui/studies/study_editor.h"

#include <algorithm>

#include <QCheckBox>
#include <QFile>
#include <QLineEdit>
#include <QPointer>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QWheelEvent>
#include <QtTest>

#include "core/case_files/case_file.h"
#include "tests/support/test_program.h"
#include "tests/ui/question.h"

using namespace touchdown;

namespace test_study_editor {

class TestStudyEditor : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        editor_ = std::make_unique<StudyEditor>(coreStudies());
        editor_->setCase(openCase("fig10a").value);
        editor_->setKind(QStringLiteral("hysteresis"));
        editor_->resize(360, 700);
        editor_->show();
        QVERIFY(QTest::qWaitForWindowExposed(editor_.get()));
    }
    void cleanup() { editor_.reset(); }
    void asksBeforeItReplacesAnEditedText_data()
    {
        QTest::addColumn<QString>("by");
        for (const char* by : {"a file", "a sample", "the defaults"})
            QTest::addRow("%s", by) << QString::fromLatin1(by);
    }
    void asksBeforeItReplacesAnEditedText()
    {
        QFETCH(const QString, by);
        const QTemporaryDir folder;
        const QString other = folder.filePath(QStringLiteral("other.toml"));
        const QString mine = folder.filePath(QStringLiteral("mine.toml"));
        for (const QString& path : {other, mine}) {
            QFile file(path);
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write("kind = \"hysteresis\"\nsteps = 31\n");
        }
        const auto replace = [&] {
            if (by == QLatin1String("a file")) QCOMPARE(editor_->open(other), QString());
            if (by == QLatin1String("a sample"))
                editor_->openSample(*std::ranges::find(sampleStudies(), std::string("hysteresis"), &SampleStudy::kind));
            if (by == QLatin1String("the defaults"))
                namedWidget<QAbstractButton>(*editor_, QStringLiteral("Use the defaults of this kind of study"))
                    ->click();
        };
        const QString edited = QStringLiteral("kind = \"hysteresis\"\nsteps = 123\n");
        QCOMPARE(editor_->open(mine), QString());
        QVERIFY(!question(*editor_, "unsavedStudy")); // nobody had edited the text
        editor_->setText(edited);
        replace();
        QCOMPARE(editor_->toText(), edited);
        answer(*editor_, "unsavedStudy", QStringLiteral("Cancel"));
        QCOMPARE(editor_->toText(), edited);
        replace();
        answer(*editor_, "unsavedStudy", QStringLiteral("Save"));
        QFile file(mine);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(QString::fromUtf8(file.readAll()), edited);
        QVERIFY(editor_->toText() != edited);
        QVERIFY(editor_->unsaved().empty());
        editor_->setText(edited);
        replace();
        answer(*editor_, "unsavedStudy", QStringLiteral("Discard"));
        QVERIFY(editor_->toText() != edited);
    }
    /// Another program, or another window, has written the file since.
    void aTextThatChangedOutsideIsNotWrittenOver_data()
    {
        QTest::addColumn<bool>("saved");
        QTest::newRow("opened") << false;
        QTest::newRow("saved here") << true;
    }
    void aTextThatChangedOutsideIsNotWrittenOver()
    {
        QFETCH(const bool, saved);
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("mine.toml"));
        const std::string first = "kind = \"hysteresis\"\nsteps = 3\n", theirs = "kind = \"hysteresis\"\nsteps = 5\n";
        QCOMPARE(writeCaseFile(file.toStdString(), first), std::string());
        QCOMPARE(editor_->open(file), QString());
        editor_->setText(QStringLiteral("kind = \"hysteresis\"\nsteps = 4\n"));
        if (saved) editor_->saveTo(file);
        QCOMPARE(writeCaseFile(file.toStdString(), theirs), std::string());
        const QSignalSpy succeeded(editor_.get(), &StudyEditor::succeeded);
        const auto text = [&file] {
            QFile read(file);
            return read.open(QIODevice::ReadOnly) ? read.readAll().toStdString() : std::string();
        };
        QVERIFY(!editor_->save(file).isEmpty()); // as Save all does
        QCOMPARE(text(), theirs);
        editor_->saveTo(file);
        QMessageBox* box = question(*editor_, "changedFile");
        QVERIFY(box != nullptr);
        QVERIFY(box->informativeText().contains(QStringLiteral("in the file: steps = 5")));
        QVERIFY(box->informativeText().contains(QStringLiteral("in this window: steps = 4")));
        QCOMPARE(text(), theirs);
        QCOMPARE(writeCaseFile(file.toStdString(), first), std::string()); // once more
        answer(*editor_, "changedFile", QStringLiteral("Write over it"));
        QCOMPARE(text(), first);
        QCOMPARE(succeeded.count(), 0);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        answer(*editor_, "changedFile", QStringLiteral("Reload the file"));
        QCOMPARE(editor_->toText().toStdString(), first);
        editor_->setText(QStringLiteral("kind = \"hysteresis\"\nsteps = 4\n"));
        editor_->saveTo(file);
        QCOMPARE(succeeded.count(), 1);
        QCOMPARE(text(), editor_->toText().toStdString());
    }
    /// The text of the window is given up only for one that can be read.
    void aFileThatHoldsNoTextByNow()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("mine.toml"));
        QCOMPARE(writeCaseFile(file.toStdString(), "kind = \"hysteresis\"\r\nsteps = 3\r\n"), std::string());
        QCOMPARE(editor_->open(file), QString());
        editor_->setText(QStringLiteral("kind = \"hysteresis\"\nsteps = 4\n"));
        QCOMPARE(writeCaseFile(file.toStdString(), "kind = \"hysteresis\"\r\nsteps = 5\r\n"), std::string());
        editor_->saveTo(file);
        QVERIFY(
            !question(*editor_, "changedFile")->informativeText().contains(QStringLiteral("kind"))); // the same line
        QCOMPARE(writeCaseFile(file.toStdString(), std::string("steps\0= 5", 10)), std::string());
        answer(*editor_, "changedFile", QStringLiteral("Reload the file"));
        QCOMPARE(editor_->unsaved().size(), std::size_t(1));
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        editor_->saveTo(file);
        QVERIFY(!namedWidget<QAbstractButton>(*question(*editor_, "changedFile"), QStringLiteral("Reload the file"))
                     ->isEnabled());
    }
    void showsTheDefaults()
    {
        QCOMPARE(line("from")->text(), QStringLiteral("14 nm"));
        QCOMPARE(line("steps")->text(), QStringLiteral("40"));
        QCOMPARE(line("hold")->text(), QStringLiteral("2000 µs"));
        QVERIFY(qobject_cast<QCheckBox*>(editor_->form()->field("equilibria"))->isChecked());
        QVERIFY2(editor_->subject().contains(QStringLiteral("the case at the left")), qPrintable(editor_->subject()));
        const auto* cases = qobject_cast<QComboBox*>(editor_->form()->field("case"));
        QVERIFY2(cases->currentText().startsWith(QStringLiteral("The case at the left")),
                 qPrintable(cases->currentText()));
        QCOMPARE(editor_->form()->field("title"), nullptr);
        QCOMPARE(editor_->form()->field("set"), nullptr);
    }
    void entries_data()
    {
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("typed");
        QTest::addColumn<QString>("written"); // in the text
        QTest::newRow("a whole number") << "steps"
                                        << "7"
                                        << "steps = 7";
        QTest::newRow("a bare number has the unit that stood there") << "from"
                                                                     << "12"
                                                                     << "from = \"12 nm\"";
        QTest::newRow("another unit") << "from" << QStringLiteral("0.012 µm") << "from = \"0.012 um\"";
        QTest::newRow("a key of the case") << "parameter"
                                           << "springs.flying_height"
                                           << "parameter = \"springs.flying_height\"";
    }
    void entries()
    {
        QFETCH(QString, key);
        QFETCH(QString, typed);
        QFETCH(QString, written);
        enter(key, typed);
        QVERIFY2(editor_->toText().contains(written), qPrintable(editor_->toText()));
        QVERIFY2(editor_->plan().valid(), qPrintable(editor_->problems()));
        QCOMPARE(editor_->form()->problemOf(key.toStdString()), QString());
    }
    void anEntryThatCannotBeTaken()
    {
        enter(QStringLiteral("from"), QStringLiteral("abc"));
        QVERIFY(!editor_->run()->isEnabled());
        QVERIFY2(editor_->form()->problemOf("from").contains(QStringLiteral("abc")),
                 qPrintable(editor_->form()->problemOf("from")));
        enter(QStringLiteral("from"), QStringLiteral("9 nm"));
        QVERIFY(editor_->run()->isEnabled());
        QCOMPARE(editor_->form()->problemOf("from"), QString());
    }
    /// An empty field leaves its key out; the default stands there in grey.
    void anEmptyField()
    {
        enter(QStringLiteral("steps"), {});
        QVERIFY(!editor_->toText().contains(QRegularExpression(QStringLiteral("(^|\n)steps ="))));
        QCOMPARE(line("steps")->placeholderText(), QStringLiteral("40"));
        QVERIFY(editor_->plan().valid());
    }
    /// Springs have no static state to study: no field without a meaning.
    void aKeyOfAnotherModel()
    {
        editor_->setKind(QStringLiteral("work-precision"));
        editor_->plan();
        QVERIFY(editor_->form()->field("quantity") != nullptr);
        QCOMPARE(editor_->form()->field("of"), nullptr);
        editor_->setCase(openCase("film_pico").value);
        editor_->plan();
        QVERIFY(editor_->form()->field("of") != nullptr);
    }
    void aCheckBox()
    {
        QTest::mouseClick(editor_->form()->field("anew"), Qt::LeftButton, {}, QPoint(8, 8));
        QVERIFY(editor_->toText().contains(QStringLiteral("anew = true")));
    }
    /// Comments and order of the text are kept, and its own undo takes an entry back.
    void theTextOfAnEntry()
    {
        editor_->setText(QStringLiteral("# mine\nkind = \"hysteresis\"\nsteps = 5 # few\nfrom = \"9 nm\"\n"));
        editor_->plan();
        QCOMPARE(line("steps")->text(), QStringLiteral("5"));
        enter(QStringLiteral("steps"), QStringLiteral("6"));
        QCOMPARE(editor_->toText(),
                 QStringLiteral("# mine\nkind = \"hysteresis\"\nsteps = 6 # few\nfrom = \"9 nm\"\n"));
        editor_->findChild<QPlainTextEdit*>()->undo();
        QVERIFY(editor_->toText().contains(QStringLiteral("steps = 5 # few")));
        QVERIFY(editor_->plan().valid());
        QCOMPARE(line("steps")->text(), QStringLiteral("5"));
    }
    void anotherCase()
    {
        auto* cases = qobject_cast<QComboBox*>(editor_->form()->field("case"));
        choose(cases, cases->findData(QStringLiteral("fig12b")));
        QVERIFY(editor_->toText().contains(QStringLiteral("case = \"fig12b\"")));
        QVERIFY2(editor_->subject().contains(QStringLiteral("changes at the left have no effect")),
                 qPrintable(editor_->subject()));
        cases = qobject_cast<QComboBox*>(editor_->form()->field("case"));
        QCOMPARE(cases->currentData().toString(), QStringLiteral("fig12b"));
        choose(cases, 0);
        QVERIFY(!editor_->toText().contains(QStringLiteral("case = \"fig12b\"")));
        QVERIFY(!editor_->subject().contains(QStringLiteral("no effect")));
        // A file that is no sample has an entry, too.
        editor_->setText(QStringLiteral("case = \"../mine.toml\"\n"));
        editor_->plan();
        cases = qobject_cast<QComboBox*>(editor_->form()->field("case"));
        QCOMPARE(cases->currentText(), QStringLiteral("../mine.toml"));
    }
    /// The form is built anew while its own input asks for it.
    void anotherCaseWithOtherKeys()
    {
        const QPointer<QWidget> from = editor_->form()->field("from");
        QVERIFY(!from.isNull());
        auto* cases = qobject_cast<QComboBox*>(editor_->form()->field("case"));
        cases->setFocus();
        const int film = cases->findData(QStringLiteral("film_pico"));
        cases->setCurrentIndex(film - 1);
        QTest::keyClick(cases, Qt::Key_Down);
        QCOMPARE(qobject_cast<QComboBox*>(editor_->form()->field("case"))->currentData().toString(),
                 QStringLiteral("film_pico"));
        QVERIFY(editor_->form()->field("from") != from); // built anew, with other defaults
    }
    /// In the text it is in SI, and stays so.
    void aNumberWithoutAUnit()
    {
        editor_->setText(QStringLiteral("hold = 0.002\n"));
        editor_->plan();
        enter(QStringLiteral("hold"), QStringLiteral("0.003"));
        QVERIFY2(editor_->toText().contains(QStringLiteral("hold = 0.003\n")), qPrintable(editor_->toText()));
    }
    void aLeadingZero()
    {
        enter(QStringLiteral("steps"), QStringLiteral("07"));
        QVERIFY(!editor_->run()->isEnabled());
        QVERIFY(line("steps")->isEnabled());
        QVERIFY(!editor_->form()->problemOf("steps").isEmpty());
    }
    /// A new case does not take it away, and Perform takes it.
    void whatIsBeingTyped()
    {
        line("steps")->setFocus();
        line("steps")->selectAll();
        QTest::keyClicks(line("steps"), QStringLiteral("7"));
        editor_->setCase(openCase("fig10b").value);
        QTRY_VERIFY(editor_->subject().contains(QStringLiteral("Fig. 10 (b)")));
        QCOMPARE(line("steps")->text(), QStringLiteral("7"));
        QVERIFY(editor_->plan().valid());
        QVERIFY(editor_->toText().contains(QStringLiteral("steps = 7")));
    }
    void undo()
    {
        QWidget* anew = editor_->form()->field("anew");
        QTest::mouseClick(anew, Qt::LeftButton, {}, QPoint(8, 8));
        QVERIFY(editor_->toText().contains(QStringLiteral("anew = true")));
        QTest::keySequence(anew, QKeySequence::Undo);
        QVERIFY(editor_->toText().contains(QStringLiteral("anew = false")));
        editor_->plan();
        QVERIFY(!qobject_cast<QCheckBox*>(editor_->form()->field("anew"))->isChecked());
    }
    void theWheelScrolls()
    {
        editor_->resize(360, 420);
        auto* cases = qobject_cast<QComboBox*>(editor_->form()->field("case"));
        QTRY_VERIFY(editor_->form()->verticalScrollBar()->maximum() > 100);
        cases->setFocus();
        QWheelEvent event(QPointF(5, 5), cases->mapToGlobal(QPointF(5, 5)), QPoint(), QPoint(0, -120), Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        event.ignore();
        for (QWidget* at = cases; at != editor_.get() && !event.isAccepted(); at = at->parentWidget())
            QApplication::sendEvent(at, &event); // as it goes on from one to the next
        QCOMPARE(cases->currentIndex(), 0);
        QVERIFY(editor_->form()->verticalScrollBar()->value() > 0);
    }
    void aList()
    {
        editor_->setKind(QStringLiteral("statements"));
        enter(QStringLiteral("only"), QStringLiteral("Fig. 12, Fig. 13"));
        QVERIFY2(editor_->toText().contains(QStringLiteral("only = [\"Fig. 12\", \"Fig. 13\"]")),
                 qPrintable(editor_->toText()));
        editor_->plan();
        QCOMPARE(line("only")->text(), QStringLiteral("Fig. 12, Fig. 13"));
    }
    void aTextThatCannotBeRead()
    {
        editor_->setText(QStringLiteral("steps = = 5\n"));
        editor_->plan();
        QVERIFY(!editor_->form()->field("steps")->isEnabled());
        editor_->setText(QStringLiteral("steps = 5\n"));
        editor_->plan();
        QVERIFY(editor_->form()->field("steps")->isEnabled());
    }
    /// Each kind with its fields, filled by the defaults of a case that it takes, without a problem at one.
    void everyKind_data()
    {
        QTest::addColumn<QString>("of");
        for (const StudyKind& kind : studyKinds())
            QTest::newRow(kind.name.c_str()) << (kind.name == "advise" || kind.name == "design" ? "film_pico"
                                                 : kind.name == "convergence"                   ? "contact_hertz"
                                                                                                : "fig10a");
    }
    void everyKind()
    {
        QFETCH(QString, of);
        const std::string kind = QTest::currentDataTag();
        editor_->setCase(openCase(of.toStdString()).value);
        editor_->setKind(QString::fromStdString(kind));
        editor_->plan();
        QVERIFY(editor_->form()->field("case") != nullptr);
        for (const StudyKey& key : studyForm(kind, openCase(of.toStdString()).value).keys)
            QCOMPARE(editor_->form()->problemOf(key.key), QString());
    }
    void samples()
    {
        Gallery* gallery = editor_->samples()->gallery();
        QVERIFY(gallery->count() >= 3);
        QCOMPARE(gallery->item(0)->text(), editor_->kinds()->currentText()); // the chosen kind comes first
        const QString text = gallery->item(1)->text();
        QCOMPARE(text.count(QLatin1Char('\n')), 1);
        QVERIFY2(text.endsWith(QLatin1Char('.')), qPrintable(text));
        editor_->tabs()->setCurrentWidget(editor_->samples());
        emit gallery->itemClicked(gallery->item(1)); // selects alone
        QVERIFY(editor_->toText().startsWith(QStringLiteral("kind = \"hysteresis\"\n")));
        emit gallery->itemActivated(gallery->item(1));
        QCOMPARE(editor_->tabs()->currentWidget(), editor_->form());
        QVERIFY(!editor_->toText().contains(QStringLiteral("SPDX")));
        QVERIFY(editor_->plan().valid());
        editor_->findChild<QPlainTextEdit*>()->undo(); // what stood there before
        QVERIFY(editor_->toText().startsWith(QStringLiteral("kind = \"hysteresis\"\n")));
    }
    /// The second click of a double click is on the row of the first.
    void samplesThatAreSeenKeepTheirOrder()
    {
        editor_->show();
        editor_->tabs()->setCurrentWidget(editor_->samples());
        const Gallery* gallery = editor_->samples()->gallery();
        QTRY_VERIFY(gallery->isVisible());
        const QStringList names = gallery->shownNames();
        editor_->setKind(QStringLiteral("stability"));
        QCOMPARE(gallery->shownNames(), names);
        editor_->tabs()->setCurrentWidget(editor_->form());
        editor_->tabs()->setCurrentWidget(editor_->samples());
        QVERIFY(gallery->shownNames() != names);
        QCOMPARE(gallery->item(0)->text(), editor_->kinds()->currentText());
    }
    /// A sample of another kind chooses that kind.
    void samplesOfAllKinds()
    {
        editor_->samples()->words()->setText(QStringLiteral("criterion start height"));
        const QStringList shown = editor_->samples()->gallery()->shownNames();
        QCOMPARE(shown, QStringList{QStringLiteral("stability_start_height")});
        emit editor_->samples()->gallery()->chosen(shown.front());
        QCOMPARE(editor_->kind(), QStringLiteral("stability"));
        QVERIFY(editor_->plan().valid());
    }

private:
    QLineEdit* line(const char* key) const { return qobject_cast<QLineEdit*>(editor_->form()->field(key)); }
    void enter(const QString& key, const QString& text) const
    {
        QLineEdit* field = line(key.toLatin1().constData());
        field->setText(text);
        emit field->editingFinished();
    }
    static void choose(QComboBox* box, int index)
    {
        box->setCurrentIndex(index);
        emit box->activated(index);
    }

    std::unique_ptr<StudyEditor> editor_;
};

TOUCHDOWN_TEST(TestStudyEditor)

} // namespace test_study_editor

#include "test_study_editor.moc"

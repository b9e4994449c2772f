// SPDX-License-Identifier: GPL-3.0-or-later
//
// Text that stands in a field and was not confirmed by Return is work, too: a session keeps it, and the case and the
// study in the window stay as they are.
#include <QLineEdit>
#include <QtTest>

#include "tests/support/test_program.h"
#include "tests/ui/sessions/window_session.h"
#include "ui/case/case_edits.h"
#include "ui/case/case_panel.h"
#include "ui/sessions/session_state.h"
#include "ui/studies/study_editor.h"
#include "ui/studies/study_window.h"

using namespace touchdown;

namespace test_session_typed {

class TestSessionTyped : public QObject, test::WindowSession {
    Q_OBJECT

private slots:
    void initTestCase() { useNames("test_session_typed"); }
    void init() { begin(); }
    void cleanup() { end(); }
    void keepsAValueOfTheCase()
    {
        start();
        type(height(), "4.5 nm");
        QCOMPARE(window_->edits().value().springs.flyingHeight, 7e-9);
        QVERIFY(!window_->files().modified());
        QTRY_COMPARE(kept().edited.entries, (std::map<QString, QString>{{key, QStringLiteral("4.5 nm")}}));
        window_.reset();
        start();
        const QMessageBox* box = question(*window_, "restoreSession");
        QVERIFY(box && box->informativeText().contains(QStringLiteral("the case fig10a with its edits")));
        restore();
        QCOMPARE(window_->edits().value().springs.flyingHeight, 4.5e-9);
        window_->actions().undo->trigger();
        QCOMPARE(window_->edits().value().springs.flyingHeight, 7e-9);
    }
    void keepsNothingThatIsNoChange_data()
    {
        QTest::addColumn<QString>("typed");
        QTest::newRow("no length") << "4.5 mN";
        QTest::newRow("half a number") << "4e";
        QTest::newRow("nothing") << "";
        QTest::newRow("as it was") << "7";
    }
    void keepsNothingThatIsNoChange()
    {
        QFETCH(const QString, typed);
        start();
        type(height(), "4.5");
        QTRY_COMPARE(kept().edited.entries.size(), std::size_t(1));
        type(height(), typed);
        QTRY_VERIFY(kept().edited.entries.empty() && !kept().edited.modified);
    }
    void forgetsWhatWasGivenUp()
    {
        start();
        type(height(), "4.5");
        QTRY_COMPARE(kept().edited.entries.size(), std::size_t(1));
        QTest::keyClick(height(), Qt::Key_Escape);
        QTRY_VERIFY(kept().edited.entries.empty());
    }
    void keepsAValueOfAStudy()
    {
        start();
        window_->setPage(MainWindow::Page::Studies);
        StudyEditor& editor = *window_->studies().editor();
        editor.setKind(QStringLiteral("hysteresis"));
        editor.plan();
        const QString before = editor.toText();
        type(qobject_cast<QLineEdit*>(editor.form()->field("steps")), "123");
        QTRY_COMPARE(kept().drafts.size(), std::size_t(1));
        QVERIFY2(kept().drafts[0].text.contains(QStringLiteral("steps = 123")), qPrintable(kept().drafts[0].text));
        QCOMPARE(editor.toText(), before);
        QCOMPARE(qobject_cast<QLineEdit*>(editor.form()->field("steps"))->text(), QStringLiteral("123"));
        window_.reset();
        start();
        restore();
        QVERIFY(window_->studies().editor()->toText().contains(QStringLiteral("steps = 123")));
    }

private:
    QLineEdit* height() const
    {
        return qobject_cast<QLineEdit*>(window_->casePanel().editor("springs.flying_height")->input());
    }
    SessionState kept() const { return readSession(onlyFolder()); }
    void type(QLineEdit* line, const QString& text)
    {
        QVERIFY(line);
        QApplication::setActiveWindow(window_.get());
        line->setFocus();
        line->selectAll();
        QTest::keyClick(line, Qt::Key_Delete);
        QTest::keyClicks(line, text);
    }
    void type(QLineEdit* line, const char* text) { type(line, QString::fromLatin1(text)); }

    const QString key = QStringLiteral("springs.flying_height");
};

TOUCHDOWN_TEST(TestSessionTyped)

} // namespace test_session_typed

#include "test_session_typed.moc"

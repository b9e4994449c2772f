// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QSettings>
#include <QToolButton>
#include <QtTest>

#include "tests/support/test_program.h"
#include "tests/ui/window_fixture.h"
#include "ui/case/case_panel.h"
#include "ui/case/parameter_editor.h"
#include "ui/studies/study_editor.h"
#include "ui/studies/study_results.h"
#include "ui/studies/study_window.h"
#include "ui/style/result_table.h"
#include "ui/window/main_window.h"

using namespace touchdown;

namespace test_study_links {

using Fixture = test::WindowFixture;

class TestStudyLinks : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QCoreApplication::setOrganizationName(QStringLiteral("touchdown"));
        QCoreApplication::setApplicationName(QStringLiteral("test_study_links"));
    }
    void init() { QSettings().clear(); }

    void aFieldIsVariedAndARowOpensItsCase()
    {
        Fixture f;
        vary(f, "slider.mass");
        StudyEditor& editor = *f.window.findChild<StudyEditor*>();
        QCOMPARE(editor.kind(), QStringLiteral("sweep"));
        QVERIFY2(editor.plan().valid(), qPrintable(editor.problems()));
        QCOMPARE(editor.plan().items, std::size_t(7));
        f.toEnd([&] { f.window.performStudy(); });
        StudyResults& results = *f.window.findChild<StudyResults*>();
        auto* table = results.findChild<ResultTable*>();
        QVERIFY(table);
        auto* open = button(results, QStringLiteral("Open the case"));
        QVERIFY(open && !open->isEnabled());
        table->selectRow(6);
        QVERIFY(open->isEnabled());
        open->click();
        QCOMPARE(f.window.edits().value().slider.mass, 1.5 * 1.6e-6);
        // The order that was chosen, too.
        table->sortByColumn(0, Qt::DescendingOrder);
        table->selectRow(6);
        open->click();
        QCOMPARE(f.window.edits().value().slider.mass, 0.5 * 1.6e-6);
    }

    void aChoiceIsVaried()
    {
        Fixture f;
        vary(f, "run.integrator");
        StudyEditor& editor = *f.window.findChild<StudyEditor*>();
        QVERIFY2(editor.plan().valid(), qPrintable(editor.problems()));
        QVERIFY(editor.plan().items >= 4);
    }

    void textsAndListsAreNot()
    {
        Fixture f;
        for (const char* key : {"title", "abs.wall_profiles", "degrees_of_freedom"})
            if (const ParameterEditor* field = f.window.casePanel().editor(key))
                QVERIFY(!field->findChild<QAction*>(QStringLiteral("vary")));
    }

private:
    static void vary(Fixture& f, const char* key)
    {
        const ParameterEditor* field = f.window.casePanel().editor(key);
        QVERIFY(field);
        auto* action = field->findChild<QAction*>(QStringLiteral("vary"));
        QVERIFY(action);
        action->trigger();
    }
    static QToolButton* button(const QWidget& in, const QString& text)
    {
        for (QToolButton* each : in.findChildren<QToolButton*>())
            if (each->text() == text) return each;
        return nullptr;
    }
};

} // namespace test_study_links

using test_study_links::TestStudyLinks;
TOUCHDOWN_TEST(TestStudyLinks)
#include "test_study_links.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QScrollBar>
#include <QSignalSpy>
#include <QWheelEvent>
#include <QtTest>

#include "core/case/integrator_kind.h"
#include "core/case_files/case_file.h"
#include "tests/support/test_program.h"
#include "tests/ui/named_widget.h"
#include "ui/case/case_edits.h"
#include "ui/case/case_panel.h"
#include "ui/case/parameter_text.h"

using namespace touchdown;

namespace test_case_panel {

constexpr const char* flyingHeight = "springs.flying_height";

/// A panel on a sample case, that of Fig. 10 (a) if none is named.
struct Fixture {
    explicit Fixture(const char* sample = "fig10a")
    {
        edits.open(openCase(sample).value);
        panel.setPreset(QString::fromLatin1(sample));
        panel.resize(360, 800);
        panel.show();
        QApplication::setActiveWindow(&panel);
    }

    QLineEdit* line(const char* key) const { return qobject_cast<QLineEdit*>(panel.editor(key)->input()); }
    QComboBox* preset() const { return namedWidget<QComboBox>(panel, QStringLiteral("Sample case")); }
    void type(const char* key, const QString& text)
    {
        QLineEdit* editor = line(key);
        editor->setFocus();
        editor->selectAll();
        QTest::keyClicks(editor, text);
        QTest::keyClick(editor, Qt::Key_Return);
    }

    CaseEdits edits;
    CasePanel panel{edits};
};

/// "3.2" as the user's locale writes it.
QString localised(QString number) { return number.replace(QLatin1Char('.'), QLocale().decimalPoint()); }

class TestCasePanel : public QObject {
    Q_OBJECT

private slots:
    void cleanup() { QLocale::setDefault(QLocale::system()); }
    void takesEntries_data();
    void takesEntries();
    void takesLists_data();
    void takesLists();
    void saysWhyAListIsBad();
    void showsEveryUsedParameter();
    void hidesFieldsThatTheModelDoesNotUse();
    void showsWhyAnEntryIsBad_data();
    void showsWhyAnEntryIsBad();
    void showsABadCombinationAtItsField();
    void warnsOfAContactThatCreatesEnergy();
    void undoesAndRedoes();
    void undoesABadEntry();
    void leavesUndoToTheLineWhileTyping();
    void resetsOneAndAll();
    void turnsThePresetToCustom();
    void emitsTheChosenPreset();
    void acceptsADecimalComma();
    void searches();
    void ranksWhatItFinds();
    void findsAGroupAndWhatAChoiceNeeds();
    void stacksRowsInANarrowPlace();
    void enteringAChoice();
    void closesAndOpensGroups();
    void ignoresTheWheelUnlessFocused();
    void committingTwiceIsOneEdit();
    void escapeForgetsWhatWasTyped();
    void marksStandIns();
    void namesEveryInput();
};

void TestCasePanel::takesEntries_data()
{
    QTest::addColumn<QString>("typed");
    QTest::addColumn<double>("value"); // [m]
    QTest::addColumn<QString>("shown");
    QTest::newRow("a bare number is in the unit beside the field") << "8.5" << 8.5e-9 << "8.5";
    QTest::newRow("micrometres") << "0.0032 um" << 3.2e-9 << "3.2";
    QTest::newRow("micro sign") << QStringLiteral("0.0032 µm") << 3.2e-9 << "3.2";
    QTest::newRow("no space") << "12nm" << 12e-9 << "12";
    QTest::newRow("metres") << "3e-9 m" << 3e-9 << "3";
    QTest::newRow("with spaces around") << "  4 nm " << 4e-9 << "4";
}

void TestCasePanel::takesEntries()
{
    QFETCH(const QString, typed);
    QFETCH(const double, value);
    QFETCH(const QString, shown);
    Fixture f;
    f.type(flyingHeight, typed);
    QVERIFY2(qFuzzyCompare(f.edits.value().springs.flyingHeight, value),
             qPrintable(QString::number(f.edits.value().springs.flyingHeight)));
    QCOMPARE(f.line(flyingHeight)->text(), localised(shown));
    QCOMPARE(f.panel.editor(flyingHeight)->reason(), QString());
    QVERIFY(f.edits.reasonNotToRun().isEmpty());
}

void TestCasePanel::takesLists_data()
{
    QTest::addColumn<QLocale>("locale");
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("shown");
    const QLocale english(QLocale::English, QLocale::UnitedStates);
    const QLocale german(QLocale::German, QLocale::Germany);
    QTest::newRow("bare numbers are in the unit beside the field") << english << "20.5, 30"
                                                                   << "20.5, 30";
    QTest::newRow("with units") << english << "0.0205 m,3cm"
                                << "20.5, 30";
    QTest::newRow("semicolons") << english << "20.5; 30"
                                << "20.5, 30";
    QTest::newRow("decimal commas") << german << "20,5; 30"
                                    << "20,5; 30";
    QTest::newRow("decimal commas parted by a comma and a blank") << german << "20,5, 30 mm"
                                                                  << "20,5; 30";
    QTest::newRow("a decimal point where commas are usual") << german << "20.5; 30"
                                                            << "20,5; 30";
}

void TestCasePanel::takesLists()
{
    QFETCH(const QLocale, locale);
    QFETCH(const QString, typed);
    QFETCH(const QString, shown);
    QLocale::setDefault(locale);
    Fixture f("film_pico");
    f.type("steady.radii", typed);
    QCOMPARE(f.panel.editor("steady.radii")->reason(), QString());
    QCOMPARE(f.edits.value().steady.radii, (std::vector<double>{20.5e-3, 30e-3}));
    QCOMPARE(f.line("steady.radii")->text(), shown);
    f.line("steady.radii")->clear();
    QTest::keyClick(f.line("steady.radii"), Qt::Key_Return);
    QVERIFY(f.edits.value().steady.radii.empty());
}

void TestCasePanel::saysWhyAListIsBad()
{
    Fixture f("film_pico");
    f.type("film.nodes", QStringLiteral("97; 100"));
    QVERIFY2(f.panel.editor("film.nodes")->reason().contains(QLatin1String("100 is not possible")),
             qPrintable(f.panel.editor("film.nodes")->reason()));
    f.type("film.nodes", QStringLiteral("97; 129"));
    QCOMPARE(f.panel.editor("film.nodes")->reason(), QString());
    QCOMPARE(f.edits.value().film.nodes, (std::array<int, 2>{97, 129}));
}

void TestCasePanel::showsEveryUsedParameter()
{
    const Fixture f;
    for (const Parameter& parameter : parameters()) {
        if (parameter.group() == "about") continue;
        const ParameterEditor* editor = f.panel.editor(parameter.key);
        QVERIFY2(editor, parameter.key.c_str());
        QCOMPARE(editor->isVisible(), parameter.used(f.edits.value()));
    }
}

void TestCasePanel::hidesFieldsThatTheModelDoesNotUse()
{
    Fixture f;
    // dopri5 has a tolerance, rk4 a step.
    QVERIFY(f.panel.editor("run.tolerance")->isVisible());
    QVERIFY(!f.panel.editor("run.step")->isVisible());
    f.edits.enter(*findParameter("run.integrator"), QStringLiteral("rk4"));
    QVERIFY(!f.panel.editor("run.tolerance")->isVisible());
    QVERIFY(f.panel.editor("run.step")->isVisible());
    QCOMPARE(qobject_cast<QComboBox*>(f.panel.editor("run.integrator")->input())->currentData(), QStringLiteral("rk4"));

    QVERIFY(f.panel.editor("ono_yamane.meniscus_force")->isVisible());
    f.edits.enter(*findParameter("contact"), QStringLiteral("none"));
    QVERIFY(!f.panel.editor("ono_yamane.meniscus_force")->isVisible());
}

void TestCasePanel::showsWhyAnEntryIsBad_data()
{
    QTest::addColumn<QString>("key");
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("part");
    QTest::newRow("negative mass") << "slider.mass"
                                   << "-1"
                                   << "at least";
    QTest::newRow("a force where a length belongs") << flyingHeight << "7 mN"
                                                    << "length";
    QTest::newRow("no number") << flyingHeight << "high"
                               << "high";
    QTest::newRow("empty") << flyingHeight << ""
                           << "empty";
    QTest::newRow("too many degrees of freedom") << "degrees_of_freedom"
                                                 << "7"
                                                 << "2";
}

void TestCasePanel::showsWhyAnEntryIsBad()
{
    QFETCH(const QString, key);
    QFETCH(const QString, typed);
    QFETCH(const QString, part);
    Fixture f;
    const std::string name = key.toStdString();
    QLineEdit* line = f.line(name.c_str());
    line->setFocus();
    line->selectAll();
    QTest::keyClick(line, Qt::Key_Delete);
    QTest::keyClicks(line, typed);
    QTest::keyClick(line, Qt::Key_Return);

    const ParameterEditor* editor = f.panel.editor(name);
    QVERIFY2(editor->reason().contains(part, Qt::CaseInsensitive), qPrintable(editor->reason()));
    QVERIFY(editor->reason().endsWith(QLatin1Char('.')));
    // The entry stays to be mended, and the value is what it was.
    QCOMPARE(line->text(), typed);
    const Parameter& parameter = *findParameter(name);
    QCOMPARE(toText(f.edits.value(), parameter), toText(f.edits.opened(), parameter));
    QVERIFY(f.edits.reasonNotToRun().contains(editor->reason()));
}

void TestCasePanel::showsABadCombinationAtItsField()
{
    Fixture f;
    f.type("ono_yamane.take_off", QStringLiteral("2 nm")); // d_s = 3 nm
    QVERIFY(!f.panel.editor("ono_yamane.take_off")->reason().isEmpty());
    QVERIFY(!f.edits.reasonNotToRun().isEmpty());
    f.type("ono_yamane.take_off", QStringLiteral("4 nm"));
    QVERIFY(f.panel.editor("ono_yamane.take_off")->reason().isEmpty());
    QVERIFY(f.edits.reasonNotToRun().isEmpty());
}

void TestCasePanel::warnsOfAContactThatCreatesEnergy()
{
    Fixture f;
    f.type("ono_yamane.meniscus_force", QStringLiteral("1 mN")); // W = 1 mN * 2 nm - 2.5 pJ
    QVERIFY(f.panel.editor("ono_yamane.meniscus_force")->reason().startsWith(QStringLiteral("W = −0.5 pJ")));
    QVERIFY(f.edits.reasonNotToRun().isEmpty());
    f.type("ono_yamane.meniscus_force", QStringLiteral("1.3 mN"));
    QVERIFY(f.panel.editor("ono_yamane.meniscus_force")->reason().isEmpty());
}

void TestCasePanel::undoesAndRedoes()
{
    Fixture f;
    f.type(flyingHeight, QStringLiteral("4"));
    f.type("slider.mass", QStringLiteral("2"));
    f.edits.undoStack().undo();
    QCOMPARE(f.edits.value().slider.mass, 1.6e-6);
    QCOMPARE(f.edits.value().springs.flyingHeight, 4e-9);
    f.edits.undoStack().undo();
    QCOMPARE(f.edits.value().springs.flyingHeight, 7e-9);
    QCOMPARE(f.line(flyingHeight)->text(), QStringLiteral("7"));
    QVERIFY(!f.edits.undoStack().canUndo());
    f.edits.undoStack().redo();
    QCOMPARE(f.line(flyingHeight)->text(), QStringLiteral("4"));
}

void TestCasePanel::undoesABadEntry()
{
    Fixture f;
    f.type(flyingHeight, QStringLiteral("4"));
    f.type(flyingHeight, QStringLiteral("nonsense"));
    QVERIFY(!f.edits.reasonNotToRun().isEmpty());
    f.edits.undoStack().undo();
    QVERIFY(f.edits.reasonNotToRun().isEmpty());
    QCOMPARE(f.line(flyingHeight)->text(), QStringLiteral("4"));
    QCOMPARE(f.panel.editor(flyingHeight)->reason(), QString());
    f.edits.undoStack().redo();
    QCOMPARE(f.line(flyingHeight)->text(), QStringLiteral("nonsense"));
    QVERIFY(!f.panel.editor(flyingHeight)->reason().isEmpty());
}

void TestCasePanel::leavesUndoToTheLineWhileTyping()
{
    Fixture f;
    const auto overridden = [&f] {
        QKeyEvent event(QEvent::ShortcutOverride, Qt::Key_Z, Qt::ControlModifier);
        event.ignore();
        QApplication::sendEvent(f.line(flyingHeight), &event);
        return event.isAccepted();
    };
    f.line(flyingHeight)->setFocus();
    QVERIFY(!overridden());
    QTest::keyClicks(f.line(flyingHeight), QStringLiteral("1"));
    QVERIFY(overridden());
}

void TestCasePanel::resetsOneAndAll()
{
    Fixture f;
    f.type(flyingHeight, QStringLiteral("4"));
    f.type("slider.mass", QStringLiteral("2"));
    f.type("slider.thickness", QStringLiteral("thick"));
    auto* reset = f.panel.editor(flyingHeight)->findChild<QToolButton*>();
    QVERIFY(reset->isVisible());
    reset->click();
    QCOMPARE(f.edits.value().springs.flyingHeight, 7e-9);
    QVERIFY(!reset->isVisible());
    QVERIFY(f.edits.changed(*findParameter("slider.mass")));
    f.edits.resetAll();
    QVERIFY(!f.edits.anyChanged());
    QVERIFY(f.edits.reasonNotToRun().isEmpty());
    // One step of undo brings all of it back.
    f.edits.undoStack().undo();
    QCOMPARE(f.edits.value().slider.mass, 2e-6);
    QCOMPARE(f.line("slider.thickness")->text(), QStringLiteral("thick"));
}

void TestCasePanel::turnsThePresetToCustom()
{
    Fixture f;
    QCOMPARE(f.preset()->currentData().toString(), QStringLiteral("fig10a"));
    f.type(flyingHeight, QStringLiteral("4"));
    QCOMPARE(f.preset()->currentIndex(), -1);
    QCOMPARE(f.preset()->placeholderText(), QStringLiteral("Custom"));
    f.edits.undoStack().undo();
    QCOMPARE(f.preset()->currentData().toString(), QStringLiteral("fig10a"));
}

void TestCasePanel::emitsTheChosenPreset()
{
    Fixture f;
    const QSignalSpy chosen(&f.panel, &CasePanel::presetChosen);
    f.preset()->setFocus();
    QTest::keyClick(f.preset(), Qt::Key_Down);
    QCOMPARE(chosen.count(), 1);
    QCOMPARE(chosen[0][0].toString(), QStringLiteral("fig10b"));
    // Until it has been opened, the panel shows what it holds.
    QCOMPARE(f.preset()->currentData().toString(), QStringLiteral("fig10a"));
    // The gallery stands above the names.
    const QSignalSpy gallery(&f.panel, &CasePanel::galleryWanted);
    QTest::keyClick(f.preset(), Qt::Key_Home);
    QCOMPARE(gallery.count(), 1);
    QCOMPARE(chosen.count(), 1);
    QCOMPARE(f.preset()->currentData().toString(), QStringLiteral("fig10a"));
}

void TestCasePanel::acceptsADecimalComma()
{
    QLocale::setDefault(QLocale(QLocale::German));
    Fixture f;
    f.type(flyingHeight, QStringLiteral("3,2"));
    QCOMPARE(f.edits.value().springs.flyingHeight, 3.2e-9);
    QCOMPARE(f.line(flyingHeight)->text(), QStringLiteral("3,2"));
    f.type(flyingHeight, QStringLiteral("0,0045 um"));
    QCOMPARE(f.edits.value().springs.flyingHeight, 4.5e-9);
    // As in a case file.
    f.type(flyingHeight, QStringLiteral("3.5"));
    QCOMPARE(f.edits.value().springs.flyingHeight, 3.5e-9);
    // A thousand or one? Neither is guessed.
    f.type(flyingHeight, QStringLiteral("1.000,5"));
    QCOMPARE(f.edits.value().springs.flyingHeight, 3.5e-9);
    QVERIFY(!f.panel.editor(flyingHeight)->reason().isEmpty());
}

void TestCasePanel::searches()
{
    Fixture f;
    f.panel.search()->setText(QStringLiteral("k_f0"));
    QVERIFY(f.panel.editor("springs.front_stiffness")->isVisible());
    QVERIFY(!f.panel.editor("springs.rear_stiffness")->isVisible());
    f.panel.search()->setText(QStringLiteral("stiffness REAR"));
    QVERIFY(!f.panel.editor("springs.front_stiffness")->isVisible());
    QVERIFY(f.panel.editor("springs.rear_stiffness")->isVisible());
    f.panel.search()->clear();
    QVERIFY(f.panel.editor("springs.front_stiffness")->isVisible());
    // Of another case all parameters are shown.
    f.panel.search()->setText(QStringLiteral("mass"));
    QVERIFY(!f.panel.editor("springs.front_stiffness")->isVisible());
    f.panel.setPreset({});
    QVERIFY(f.panel.editor("springs.front_stiffness")->isVisible());
}

/// The word of a heading finds all of its group. A choice that was found needs another field: that is shown, too,
/// and with a first wave the case can run.
void TestCasePanel::findsAGroupAndWhatAChoiceNeeds()
{
    Fixture f("film_pico");
    f.panel.search()->setText(QStringLiteral("disk surface"));
    const ParameterEditor* kind = f.panel.editor("disk.surface.kind");
    QVERIFY(kind->isVisible());
    QVERIFY(!f.panel.editor("suspension.preload")->isVisible());
    f.panel.search()->setText(QStringLiteral("surface kind"));
    f.edits.enter(*findParameter("disk.surface.kind"), QStringLiteral("waves"));
    QVERIFY(f.edits.reasonNotToRun().isEmpty());
    QCOMPARE(f.edits.value().diskSurface.waveAmplitudes, std::vector<double>{0.5e-9});
    f.edits.undoStack().undo();
    QVERIFY(f.edits.value().diskSurface.waveAmplitudes.empty()); // one edit
    f.edits.enter(*findParameter("disk.surface.kind"), QStringLiteral("file"));
    QVERIFY(!f.edits.reasonNotToRun().isEmpty());
    f.panel.search()->setText(QStringLiteral("preload"));
    QVERIFY(f.panel.editor("disk.surface.file")->isVisible());
    // The entry that makes it right does not take the field away; another search does.
    f.edits.enter(*findParameter("disk.surface.file"), QStringLiteral("disk.txt"));
    QVERIFY(f.edits.reasonNotToRun().isEmpty());
    QVERIFY(f.panel.editor("disk.surface.file")->isVisible());
    f.panel.search()->setText(QStringLiteral("preloa"));
    QVERIFY(!f.panel.editor("disk.surface.file")->isVisible());
}

/// Labels stand above their values where both have no room; nothing is cut at the side.
void TestCasePanel::stacksRowsInANarrowPlace()
{
    Fixture f("film_pico");
    const ParameterEditor* inertia = f.panel.editor("slider.pitch_inertia");
    const QScrollArea* area = f.panel.findChild<QScrollArea*>();
    const int beside = inertia->height();
    for (const int width : {600, 250, 600}) {
        f.panel.resize(width, 800);
        QTRY_COMPARE(inertia->height() > beside, width == 250);
        QTRY_COMPARE(area->horizontalScrollBar()->maximum(), 0);
    }
}

void TestCasePanel::enteringAChoice()
{
    Fixture f;
    auto* choice = qobject_cast<QComboBox*>(f.panel.editor("run.integrator")->input());
    const int newmark = choice->findData(QStringLiteral("newmark"));
    QCOMPARE(choice->itemText(newmark), QStringLiteral("Newmark"));
    choice->setCurrentIndex(newmark);
    emit choice->activated(newmark);
    QCOMPARE(f.edits.value().run.integrator, IntegratorKind::Newmark);
    f.edits.undoStack().undo();
    QCOMPARE(choice->currentData(), QStringLiteral("dopri5"));
}

void TestCasePanel::ranksWhatItFinds()
{
    Fixture f;
    const auto isShown = [&f](const char* key) { return f.panel.editor(key)->isVisible(); };
    // Labels first; explanations only when asked for.
    f.panel.search()->setText(QStringLiteral("mass"));
    QVERIFY(isShown("slider.mass"));
    QVERIFY(!isShown("springs.front_distance")); // "Distance from the mass centre ..."
    QVERIFY2(f.panel.searchRemark().contains(QStringLiteral("more in keys")), qPrintable(f.panel.searchRemark()));
    f.panel.showEveryMatch();
    QVERIFY(isShown("slider.mass"));
    QVERIFY(isShown("springs.front_distance"));
    QCOMPARE(f.panel.searchRemark(), QString());
    // Keys before explanations, and only the starts of words.
    f.panel.search()->setText(QStringLiteral("springs.cut"));
    QVERIFY(isShown("springs.cutoff"));
    f.panel.search()->setText(QStringLiteral("ass"));
    QVERIFY(!isShown("slider.mass"));
    // A choice is found by its name.
    f.panel.search()->setText(QStringLiteral("newmark"));
    QVERIFY(isShown("run.integrator"));
    f.panel.search()->setText(QStringLiteral("<b>zebra"));
    QCOMPARE(f.panel.searchRemark(), QStringLiteral("No parameter of this case matches “&lt;b&gt;zebra”."));
    for (const ParameterEditor* editor : f.panel.findChildren<ParameterEditor*>()) QVERIFY(!editor->isVisible());
    f.panel.search()->clear();
    QCOMPARE(f.panel.searchRemark(), QString());
}

void TestCasePanel::closesAndOpensGroups()
{
    Fixture f;
    QToolButton* header = nullptr;
    for (QToolButton* button : f.panel.findChildren<QToolButton*>())
        if (button->text() == QStringLiteral("Slider")) header = button;
    QVERIFY(header);
    header->click();
    QVERIFY(!f.panel.editor("slider.mass")->isVisible());
    QVERIFY(f.panel.editor(flyingHeight)->isVisible());
    // A search looks into closed groups too.
    f.panel.search()->setText(QStringLiteral("mass"));
    QVERIFY(f.panel.editor("slider.mass")->isVisible());
    f.panel.search()->clear();
    header->click();
    QVERIFY(f.panel.editor("slider.mass")->isVisible());
}

void TestCasePanel::ignoresTheWheelUnlessFocused()
{
    Fixture f;
    auto* choice = qobject_cast<QComboBox*>(f.panel.editor("run.integrator")->input());
    const auto turn = [choice] {
        QWheelEvent event(QPointF(5, 5), choice->mapToGlobal(QPointF(5, 5)), QPoint(), QPoint(0, 120), Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(choice, &event);
    };
    f.line(flyingHeight)->setFocus();
    turn();
    QCOMPARE(f.edits.value().run.integrator, IntegratorKind::Dopri5);
    choice->setFocus();
    turn();
    QCOMPARE(f.edits.value().run.integrator, IntegratorKind::Newmark); // the one above
}

void TestCasePanel::committingTwiceIsOneEdit()
{
    Fixture f;
    f.type(flyingHeight, QStringLiteral("4"));
    f.line("slider.mass")->setFocus(); // losing the focus ends the edit once more
    QCOMPARE(f.edits.undoStack().count(), 1);
    // The same number in another way is no edit, but is shown in its own way again.
    f.type(flyingHeight, QStringLiteral("0.004 um"));
    QCOMPARE(f.edits.undoStack().count(), 1);
    QCOMPARE(f.line(flyingHeight)->text(), QStringLiteral("4"));
}

void TestCasePanel::escapeForgetsWhatWasTyped()
{
    Fixture f;
    QLineEdit* line = f.line(flyingHeight);
    line->setFocus();
    line->selectAll();
    QTest::keyClicks(line, QStringLiteral("99"));
    QTest::keyClick(line, Qt::Key_Escape);
    QCOMPARE(line->text(), QStringLiteral("7"));
    QTest::keyClick(line, Qt::Key_Return);
    QCOMPARE(f.edits.value().springs.flyingHeight, 7e-9);
    // Also what was entered and could not be taken.
    f.type(flyingHeight, QStringLiteral("abc"));
    QVERIFY(f.panel.editor(flyingHeight)->wrong());
    QTest::keyClick(line, Qt::Key_Escape);
    QCOMPARE(line->text(), QStringLiteral("7"));
    QVERIFY(!f.panel.editor(flyingHeight)->wrong());
}

void TestCasePanel::marksStandIns()
{
    Fixture f;
    const auto mark = [&f](const char* key) -> QLabel* {
        for (QLabel* label : f.panel.editor(key)->findChildren<QLabel*>())
            if (label->text() == QStringLiteral("≈")) return label;
        return nullptr;
    };
    QVERIFY(mark("slider.mass")->isVisible());            // Table II is lost
    QVERIFY(!mark("ono_yamane.touch_down")->isVisible()); // stated in the paper
    QVERIFY(mark("slider.mass")->toolTip().contains(QStringLiteral("Table II")));
    f.type("slider.mass", QStringLiteral("2"));
    QVERIFY(!mark("slider.mass")->isVisible());
}

void TestCasePanel::namesEveryInput()
{
    const Fixture f;
    for (const Parameter& parameter : parameters()) {
        if (parameter.group() == "about") continue;
        const QWidget* input = f.panel.editor(parameter.key)->input();
        QCOMPARE(input->accessibleName(), QString::fromStdString(parameter.label));
        QVERIFY2(input->toolTip().contains(QString::fromStdString(parameter.key)), parameter.key.c_str());
    }
}

TOUCHDOWN_TEST(TestCasePanel)

} // namespace test_case_panel

#include "test_case_panel.moc"

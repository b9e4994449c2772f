// SPDX-License-Identifier: GPL-3.0-or-later
//
// The lists of tables of a study as rows of the form.
#include "ui/studies/study_form_view.h"

#include <algorithm>
#include <random>

#include <QAbstractItemView>
#include <QComboBox>
#include <QCompleter>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QToolButton>
#include <QtTest>

#include "core/case_files/case_file.h"
#include "tests/support/test_program.h"
#include "tests/ui/named_widget.h"
#include "ui/studies/study_editor.h"
#include "ui/studies/study_form_fields.h"

using namespace touchdown;

namespace test_study_form_rows {

/// A value of a cell with the comment behind it, "pitch" of `quantity = "pitch"  # 3`.
struct Cell {
    QString key, value, comment;
};

/// A study of random rows and comments, and its cells in the order of the text.
QString randomStudy(std::mt19937& random, std::vector<Cell>& cells)
{
    const auto draw = [&random](int below) { return static_cast<int>(random() % static_cast<unsigned>(below)); };
    QString text = QStringLiteral("kind = \"design\" # 1\n");
    const auto comment = [&] {
        if (draw(2) == 0) return QString();
        return QStringLiteral("%1# note %2, \"x\" = [y]").arg(QString(draw(3), u' ')).arg(draw(1000));
    };
    const auto add = [&](const QString& table, const char* leaf, const QString& value) {
        if (draw(3) == 0) text += QStringLiteral("# above %1\n").arg(draw(1000));
        cells.push_back({table + u'.' + QLatin1String(leaf), value, comment()});
        text += QStringLiteral("%1%2= \"%3\"%4\n")
                    .arg(QLatin1String(leaf), QString(1 + draw(3), u' '), value, cells.back().comment);
    };
    const int parameters = 1 + draw(3), targets = 1 + draw(3);
    for (int i = 1; i <= parameters; ++i) {
        text += QStringLiteral("\n[[parameter]] # %1\n").arg(i);
        const QString table = QStringLiteral("parameter[%1]").arg(i);
        add(table, "key", QStringLiteral("abs.rail[%1].width").arg(i));
        if (draw(2) == 0) add(table, "start", QStringLiteral("0.%1 mm").arg(11 + draw(80)));
        add(table, "minimum", QStringLiteral("0.0%1 mm").arg(1 + draw(9)));
        add(table, "maximum", QStringLiteral("%1 mm").arg(1 + draw(9)));
    }
    for (int i = 1; i <= targets; ++i) {
        text += QStringLiteral("\n[[target]]\n");
        const QString table = QStringLiteral("target[%1]").arg(i);
        add(table, "quantity", QStringLiteral("minimum_spacing"));
        add(table, "value", QStringLiteral("%1 nm").arg(1 + draw(99)));
        add(table, "tolerance", QStringLiteral("0.%1 nm").arg(1 + draw(9)));
    }
    return text + (draw(2) == 0 ? "\n# the end\n[search]\niterations = 9\n" : "");
}

class TestStudyFormRows : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        editor_ = std::make_unique<StudyEditor>(coreStudies());
        editor_->setCase(openCase("film_pico").value);
        editor_->setKind(QStringLiteral("design"));
        editor_->resize(360, 900);
        editor_->show();
        QVERIFY(QTest::qWaitForWindowExposed(editor_.get()));
    }
    void cleanup() { editor_.reset(); }
    /// Each value has a cell that shows it; an entry changes this value alone, and undo takes it back.
    void thereAndBack()
    {
        std::mt19937 random(7);
        for (int draw = 0; draw < 100; ++draw) {
            std::vector<Cell> cells;
            const QString text = randomStudy(random, cells);
            take(text);
            for (const Cell& cell : cells) QCOMPARE(shownValue(cell.key), cell.value);
            std::erase_if(cells, [](const Cell& cell) {
                return cell.key.endsWith(QLatin1String("key")) || cell.key.endsWith(QLatin1String("quantity"));
            });
            const Cell& cell = cells.at(random() % cells.size());
            const QString unit = cell.value.section(u' ', 1);
            QLineEdit* line = this->line(cell.key);
            line->setText(QStringLiteral("0.75")); // in the unit that stood there
            emit line->editingFinished();
            QStringList expected = text.split(u'\n');
            const QStringList now = editor_->toText().split(u'\n');
            QCOMPARE(now.size(), expected.size());
            int changed = 0;
            for (int i = 0; i < now.size(); ++i) {
                if (now[i] == expected[i]) continue;
                ++changed;
                QCOMPARE(now[i], expected[i].replace(u'"' + cell.value + u'"', "\"0.75 " + unit + "\""));
            }
            QCOMPARE(changed, 1);
            QCOMPARE(shownValue(cell.key), QStringLiteral("0.75 ") + unit);
            editor_->findChild<QPlainTextEdit*>()->undo();
            QCOMPARE(editor_->toText(), text);
            editor_->plan();
            QCOMPARE(shownValue(cell.key), cell.value);
        }
    }
    void addsAndRemovesRows()
    {
        std::mt19937 random(3);
        std::vector<Cell> cells;
        const QString text = randomStudy(random, cells);
        take(text);
        const QString next = nextOf("target");
        click(QStringLiteral("Add: Target"));
        QVERIFY(editor_->form()->field(next.toStdString() + ".quantity") != nullptr);
        QVERIFY(editor_->form()->field(next.toStdString() + ".quantity")->hasFocus());
        QVERIFY(!editor_->form()->problemOf(next.toStdString() + ".quantity").isEmpty());
        click(QStringLiteral("Remove: Target %1").arg(next.section(u'[', 1).chopped(1)));
        QCOMPARE(editor_->form()->field(next.toStdString() + ".quantity"), nullptr);
        // What stood there stands there, apart from empty lines.
        QCOMPARE(editor_->toText().split(u'\n', Qt::SkipEmptyParts), text.split(u'\n', Qt::SkipEmptyParts));
    }
    /// Words, not keys, above the numbers and in the problems.
    void words()
    {
        take(QStringLiteral("[[parameter]]\nkey = \"suspension.preload\"\nminimum = \"2 gf\"\nmaximum = \"1 gf\"\n"
                            "[[target]]\nquantity = \"pitch\"\nvalue = \"150 urad\"\ntolerance = \"1 urad\"\n"));
        QStringList labels;
        for (const QLabel* label : editor_->form()->findChildren<QLabel*>()) labels << label->text();
        for (const char* wanted : {"Number", "From", "To", "Quantity", "Wanted", "Tolerance"})
            QVERIFY2(labels.contains(QLatin1String(wanted)), wanted);
        QVERIFY(!labels.contains(QStringLiteral("Minimum")) && !labels.contains(QStringLiteral("Value")));
        QVERIFY2(editor_->form()->problemOf("parameter[1].maximum").startsWith(QStringLiteral("To ")),
                 qPrintable(editor_->form()->problemOf("parameter[1].maximum")));
        QVERIFY2(editor_->problems().contains(QStringLiteral("Parameter 1: maximum: ")),
                 qPrintable(editor_->problems()));
        take(QStringLiteral("set = { \"film.nodes\" = \"many\" }\n"));
        QVERIFY2(editor_->problems().contains(QStringLiteral("Nodes: ")) &&
                     !editor_->problems().contains(QStringLiteral("film.nodes")),
                 qPrintable(editor_->problems()));
        for (const auto& [label, key] : caseNumbers(openCase("film_pico").value))
            QVERIFY2(!label.contains(QString::fromStdString(key)), qPrintable(label));
    }
    /// Several keys of one parameter stand in place of the one; a list without headers stays in the text.
    void otherShapes()
    {
        take(QStringLiteral("[[parameter]]\nkeys = [\"abs.rail[1].recess\", \"abs.rail[3].recess\"]\n"
                            "minimum = \"0.1 um\"\nmaximum = \"3 um\"\n"
                            "[[target]]\nquantity = \"pitch\"\nvalue = \"150 urad\"\ntolerance = \"1 urad\"\n"));
        QCOMPARE(editor_->form()->field("parameter[1].key"), nullptr);
        QCOMPARE(line(QStringLiteral("parameter[1].keys"))->text(),
                 QStringLiteral("abs.rail[1].recess, abs.rail[3].recess"));
        QCOMPARE(line(QStringLiteral("target[1].value"))->text(), QStringLiteral("150 µrad"));
        take(QStringLiteral("target = [{ quantity = \"pitch\", value = \"150 urad\", tolerance = \"1 urad\" }]\n"));
        QCOMPARE(editor_->form()->field("target[1].quantity"), nullptr);
    }
    /// Other studies have rows, too.
    void methods()
    {
        editor_->setKind(QStringLiteral("work-precision"));
        take(QStringLiteral("[[method]]\nname = \"mine\"\nset = { \"run.steps\" = \"fixed\" }\nkey = \"run.step\"\n"
                            "values = [\"1 us\", \"2 us\"]\n"
                            "[[method]]\nname = \"nodes\"\nkey = \"film.nodes\"\nvalues = [49, 97]\n"));
        QCOMPARE(line(QStringLiteral("method[2].key"))->text(), QStringLiteral("Nodes"));
        QLineEdit* key = line(QStringLiteral("method[2].key"));
        key->setText(QStringLiteral("film.nodes")); // the key itself may be typed
        emit key->editingFinished();
        QVERIFY(editor_->toText().contains(QStringLiteral("key = \"film.nodes\"")));
        QCOMPARE(line(QStringLiteral("method[1].name"))->text(), QStringLiteral("mine"));
        QCOMPARE(line(QStringLiteral("method[1].values"))->text(), QStringLiteral("1 us, 2 us"));
        QCOMPARE(editor_->form()->field("method[1].set"), nullptr);
    }
    /// From an empty text to a reached target: only clicks and keys.
    void byHand()
    {
        take(QStringLiteral("kind = \"design\"\nset = { \"film.nodes\" = \"33, 33\" }\n"));
        QVERIFY(line(QStringLiteral("parameter[1].key")) != nullptr);
        QVERIFY(!line(QStringLiteral("parameter[1].key"))->isEnabled()); // as the study takes it by itself
        click(QStringLiteral("Edit: Parameter"));
        QVERIFY2(editor_->plan().valid(), qPrintable(editor_->problems()));
        type(QStringLiteral("parameter[1].minimum"), "0.5"); // [gf], the unit that stood there
        // The key again, by a part of its label.
        QLineEdit* key = line(QStringLiteral("parameter[1].key"));
        QVERIFY(key->isEnabled());
        QCOMPARE(key->text(), QStringLiteral("Preload"));
        // Another parameter by a click on its list.
        click(QStringLiteral("Add: Parameter"));
        key = line(QStringLiteral("parameter[2].key"));
        QTest::mouseClick(key, Qt::LeftButton);
        QTRY_VERIFY(key->completer()->popup()->isVisible());
        QTest::keyClicks(key, QStringLiteral("rail 1: rec"));
        QTRY_COMPARE(key->completer()->completionCount(), 1);
        QAbstractItemView* list = key->completer()->popup();
        QTRY_VERIFY(list->isVisible());
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(list->model()->index(0, 0)).center());
        QTRY_VERIFY2(editor_->toText().contains(QStringLiteral("key = \"abs.rail[1].recess\"")),
                     qPrintable(editor_->toText()));
        click(QStringLiteral("Remove: Parameter 2"));
        // The wanted quantity by the keyboard; the bare number has its unit.
        auto* quantity = qobject_cast<QComboBox*>(editor_->form()->field("target[1].quantity"));
        quantity->setFocus();
        QTest::keyClicks(quantity, QStringLiteral("Pitch"));
        QTest::keyClick(quantity, Qt::Key_Return);
        editor_->plan();
        quantity = qobject_cast<QComboBox*>(editor_->form()->field("target[1].quantity"));
        if (quantity->currentData().toString() != QLatin1String("pitch")) { // a style may open the list first
            quantity->setCurrentIndex(quantity->findData(QStringLiteral("pitch")));
            emit quantity->activated(quantity->currentIndex());
        }
        QVERIFY(!editor_->form()->problemOf("target[1].value").isEmpty()); // it is in nm
        const StudyPlan before = editor_->plan();
        type(QStringLiteral("target[1].value"), "150");
        type(QStringLiteral("target[1].tolerance"), "5");
        QVERIFY2(editor_->toText().contains(QStringLiteral("value = \"150 urad\"")), qPrintable(editor_->toText()));
        QVERIFY2(editor_->plan().valid(), qPrintable(editor_->problems() + editor_->toText()));
        const StudyReport report = editor_->plan().perform(1, {});
        QVERIFY2(report.status == StudyStatus::Completed, report.message.c_str());
    }

private:
    void take(const QString& text)
    {
        editor_->setText(text);
        editor_->plan();
    }
    QLineEdit* line(const QString& key) const
    {
        return qobject_cast<QLineEdit*>(editor_->form()->field(key.toStdString()));
    }
    /// As the text writes it.
    QString shownValue(const QString& key) const
    {
        if (const auto* choice = qobject_cast<QComboBox*>(editor_->form()->field(key.toStdString())))
            return choice->currentData().toString();
        const QString text = line(key) == nullptr ? QStringLiteral("no cell") : line(key)->text();
        const Case c = openCase("film_pico").value;
        for (const auto& [label, name] : caseNumbers(c))
            if (label == text) return QString::fromStdString(name);
        return text;
    }
    /// "target[3]" where there are two.
    QString nextOf(const char* list) const
    {
        int number = 1;
        while (editor_->form()->field(std::string(list) + '[' + std::to_string(number) + "].value") != nullptr)
            ++number;
        return QStringLiteral("%1[%2]").arg(QLatin1String(list)).arg(number);
    }
    void click(const QString& name) const
    {
        auto* button = namedWidget<QToolButton>(*editor_->form(), name);
        if (button == nullptr) qFatal("no button %s", qPrintable(name));
        QTest::mouseClick(button, Qt::LeftButton);
    }
    void type(const QString& key, const char* text) const
    {
        QLineEdit* field = line(key);
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, QString::fromLatin1(text));
        QTest::keyClick(field, Qt::Key_Return);
    }

    std::unique_ptr<StudyEditor> editor_;
};

TOUCHDOWN_TEST(TestStudyFormRows)

} // namespace test_study_form_rows

#include "test_study_form_rows.moc"

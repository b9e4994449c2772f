// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/case/choice_text.h"

#include <set>

#include <QTest>

#include "core/case/parameters.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_choice_text {

class TestChoiceText : public QObject {
    Q_OBJECT

private slots:
    /// Every choice of every parameter has a name of its own that fits the panel, and a sentence.
    void everyChoice()
    {
        for (const Parameter& parameter : parameters()) {
            std::set<QString> names;
            for (const std::string& choice : parameter.choices) {
                const ChoiceText text = choiceText(parameter.key, choice);
                const QByteArray what = (parameter.key + ": " + choice).c_str();
                QVERIFY2(!text.name.isEmpty() && text.name.size() <= 19, what.constData());
                QVERIFY2(names.insert(text.name).second, what.constData());
                QVERIFY2(text.meaning.size() > 6 && text.meaning.endsWith(QLatin1Char('.')), what.constData());
            }
        }
    }
    void noSuchChoice()
    {
        QVERIFY(choiceText("model", "ropes").name.isEmpty());
        QVERIFY(choiceText("ropes", "film").meaning.isEmpty());
    }
};

TOUCHDOWN_TEST(TestChoiceText)

} // namespace test_choice_text

#include "test_choice_text.moc"

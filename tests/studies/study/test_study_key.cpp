// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/study/study_key.h"

#include <limits>

#include <QtTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_study_key {

class TestStudyKey : public QObject {
    Q_OBJECT

private slots:
    void allowed()
    {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        QCOMPARE(allowedText(numberKey("x", {}, "m", "nm", 1e-9, 9e-9, "")), std::string("from 1 nm to 9 nm"));
        QCOMPARE(allowedText(numberKey("x", {}, "", "", 0.0, infinity, "")), std::string("at least 0"));
        QCOMPARE(allowedText(numberKey("x", {}, "", "", -infinity, infinity, "")), std::string("a number"));
        QCOMPARE(allowedText(integerKey("n", 2, 1, 5, "")), std::string("a whole number from 1 to 5"));
        QCOMPARE(allowedText(choiceKey("way", "up", {"up", "down"}, "")), std::string("one of up, down"));
        QCOMPARE(allowedText(booleanKey("on", true, "")), std::string("true or false"));
        QCOMPARE(allowedText(textKey("key", {}, "a key", "")), std::string("a key"));
        QCOMPARE(allowedText(textKey("name", {}, "", "")), std::string("text in quotation marks"));
    }
    /// Settings with their help, aligned; a long help stands above; tables come after the lists.
    void asTemplate()
    {
        const std::string longHelp = "a help of many words " + std::string(100, 'x') + " that does not fit";
        StudyForm form;
        form.remark = "Takes a while.";
        form.keys = {integerKey("steps", 40, 1, 999, "from one end to the other"),
                     numberKey("hold", 2e-3, "s", "us", 0.0, 1.0, "time at each value"),
                     textKey("title", {}, "", "no default, so that it is not written"),
                     listKey("models", std::vector<std::string>{"a", "b"}, longHelp),
                     inList(textKey("method.name", {}, "", "")),
                     onlyOffered(tableKey("ensemble", "Made only where it is needed.")),
                     onlyOffered(integerKey("ensemble.starts", 300, 2, 999, "number of runs"))};
        form.lists = "\n[[method]]\nname = \"a\"\n";
        QCOMPARE(templateText(form), std::string("# Takes a while.\n"
                                                 "steps = 40          # from one end to the other\n"
                                                 "hold = \"2000 us\"    # time at each value\n"
                                                 "# a help of many words\n# ") +
                                         std::string(100, 'x') +
                                         " that does not\n# fit\n"
                                         "models = [\"a\", \"b\"]\n"
                                         "\n[[method]]\nname = \"a\"\n"
                                         "\n# Made only where it is needed.\n# [ensemble]\n"
                                         "# starts = 300      # number of runs\n");
    }
    void defaults()
    {
        StudyKey tolerance = numberKey("tolerance", 0.01, "", "", 0.0, 1.0, "");
        QCOMPARE(defaultText(tolerance), std::string("0.01"));
        tolerance.shown = "1%";
        QCOMPARE(defaultText(tolerance), std::string("1%"));
        QCOMPARE(defaultText(textKey("x", {}, "", "")), std::string());
    }
};

TOUCHDOWN_TEST(TestStudyKey)

} // namespace test_study_key

#include "test_study_key.moc"

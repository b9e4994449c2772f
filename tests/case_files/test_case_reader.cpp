// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a case says without effect.
#include "core/case_files/case_reader.h"
#include "core/case_files/case_settings.h"

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_case_reader {

QStringList unusedOf(const CaseDocument& document)
{
    QStringList lines;
    for (const InputProblem& unused : document.unused) lines << QString::fromStdString(unused.text());
    return lines;
}

const std::string film =
    "model = 'film'\n[slider]\nlength = '1 mm'\n[ono_yamane]\ntouch_down = '3 nm'\nfriction = 0.2\n"
    "[run]\nstep = '1 ns'\nintegrator = 'rk4'\nduration = '1 ms'\n";

class TestCaseReader : public QObject {
    Q_OBJECT

private slots:
    void namesWhatHasNoEffect()
    {
        const CaseDocument document = parseCase(film, "case.toml");
        QVERIFY(document.valid());
        QCOMPARE(
            unusedOf(document),
            (QStringList{
                "case.toml:5: ono_yamane.touch_down: has no effect here, only with contact = \"ono-yamane\"; the same "
                "holds for ono_yamane.friction",
                "case.toml:8: run.step: has no effect here, only with run.steps = \"fixed\"",
                "case.toml:9: run.integrator: has no effect here, only with model = \"springs\""}));
    }

    /// It is the problems that have to be mended first.
    void saysNothingOfAFileThatIsWrong()
    {
        const CaseDocument document = parseCase(film + "[disk]\nspeed = 'fast'\n", "case.toml");
        QCOMPARE(document.problems.size(), std::size_t{1});
        QCOMPARE(unusedOf(document), QStringList());
    }

    /// A law of one summit by its own name: the file keeps it, and a setting is written as "asperity" and its model.
    void readsFurtherSpellings()
    {
        CaseDocument document = parseCase("model = 'contact'\ncontact = 'elastic-plastic'\n", "case.toml");
        QVERIFY(document.valid() && document.unused.empty());
        QCOMPARE(toText(document.value, *findParameter("contact")), std::string("asperity"));
        QCOMPARE(toText(document.value, *findParameter("asperity.model")), std::string("elastic-plastic"));
        applySettings(document, {"run.duration=1 ms"});
        QVERIFY(document.text.find("contact = 'elastic-plastic'") != std::string::npos);
        applySettings(document, {"contact=greenwood-williamson"});
        const CaseDocument back = parseCase(document.text, "case.toml");
        QVERIFY(back.valid() && back.value == document.value);
        QCOMPARE(toText(back.value, *findParameter("asperity.model")), std::string("greenwood-williamson"));
    }

    void whatIsGivenByItselfCounts()
    {
        const std::string law = "contact = 'greenwood-williamson'\n", model = "asperity.model = 'elastic-plastic'\n";
        for (const std::string& text : {law + model, model + law}) {
            const CaseDocument document = parseCase("model = 'contact'\n" + text, "case.toml");
            QVERIFY(document.valid());
            QCOMPARE(toText(document.value, *findParameter("asperity.model")), std::string("elastic-plastic"));
        }
    }

    void aSettingMayGiveItAnEffect()
    {
        CaseDocument document = parseCase(film, "case.toml");
        applySettings(document, {"contact=ono-yamane", "run.steps=fixed"});
        QVERIFY(document.valid());
        QCOMPARE(unusedOf(document),
                 QStringList("case.toml:9: run.integrator: has no effect here, only with model = \"springs\""));
    }

    void aSettingMayHaveNone()
    {
        CaseDocument document = parseCase("model = 'film'\n", "case.toml");
        applySettings(document, {" run.tolerance = 1e-9"});
        QCOMPARE(unusedOf(document),
                 QStringList("--set: run.tolerance: has no effect here, only with model = \"springs\""));
    }

    /// What is switched off on purpose is no mistake of the file.
    void whatASettingSwitchesOffIsNotNamed()
    {
        CaseDocument document =
            parseCase("model = 'film'\ncontact = 'ono-yamane'\n[ono_yamane]\nfriction = 0.2\n", "case.toml");
        applySettings(document, {"contact=none"});
        QVERIFY(document.valid());
        QCOMPARE(unusedOf(document), QStringList());
    }
};

TOUCHDOWN_TEST(TestCaseReader)

} // namespace test_case_reader

#include "test_case_reader.moc"

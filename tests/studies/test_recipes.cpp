// SPDX-License-Identifier: GPL-3.0-or-later
//
// Places that the recipes of core/README.md name, and that someone who follows one can forget.
#include <QtTest>

#include "core/case/contact_law.h"
#include "core/case/parameters.h"
#include "core/case_files/case_file.h"
#include "core/physics/film/slip.h"
#include "core/simulation/run.h"
#include "core/studies/study/sample_study.h"
#include "core/studies/study_plan.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_recipes {

QString textOf(const char* file)
{
    QFile source(QString(TOUCHDOWN_SOURCE_DIR) + "/" + file);
    return source.open(QIODevice::ReadOnly) ? QString::fromUtf8(source.readAll()) : QString();
}

/// From a heading to the next one of the same level.
QString sectionOf(const QString& text, const QString& heading)
{
    const qsizetype start = text.indexOf("\n## " + heading);
    return start < 0 ? QString() : text.mid(start, text.indexOf("\n## ", start + 1) - start);
}

class TestRecipes : public QObject {
    Q_OBJECT

private slots:
    void slipModelsAreExplained()
    {
        const std::string& help = findParameter("air.slip")->help;
        for (const SlipLaw& law : slipLaws())
            QVERIFY2(help.find(std::string(law.name)) != std::string::npos, std::string(law.name).c_str());
    }

    void integratorsAreExplainedAndCompared()
    {
        const QString table = sectionOf(textOf("core/README.md"), "Equations and methods"),
                      help = textOf("resources/help/equations.html");
        const std::string compared = studyTemplate("work-precision", Case{});
        for (const std::string& name : findParameter("run.integrator")->choices) {
            const QString text = QString::fromStdString(name);
            QVERIFY2(table.contains("`" + text + "`"), name.c_str());
            QVERIFY2(help.contains("<b>" + text + "</b>"), name.c_str());
            Case c;
            QVERIFY(!setFromText(c, *findParameter("run.integrator"), name));
            const bool isCompared = compared.find('"' + name + '"') != std::string::npos;
            QVERIFY2(isCompared || !reasonNotToRun(c).empty(), name.c_str());
        }
    }

    /// The table of the help says in which models a law acts.
    void contactLawsAreExplained()
    {
        const QString help = textOf("resources/help/contact.html");
        for (const ContactLaw& law : contactLaws()) {
            QStringList models;
            for (const ModelKind model : {ModelKind::Springs, ModelKind::Film, ModelKind::Contact}) {
                Case c;
                c.model = model;
                if (law.whyNot(model).empty()) models << QString::fromStdString(toText(c, *findParameter("model")));
            }
            const QString name = QString::fromUtf8(law.name.data(), qsizetype(law.name.size()));
            const QString row = "<tr><td><i>" + name + "</i></td><td>" + models.join(", ") + "</td>";
            QVERIFY2(help.contains(row), qPrintable(row));
        }
    }

    /// Every pair of model and contact law either runs or is refused at the key "contact".
    void contactLawsRunOrAreRefused()
    {
        for (const ModelKind model : {ModelKind::Springs, ModelKind::Film, ModelKind::Contact})
            for (const std::string& name : findParameter("contact")->choices) {
                Case c = defaultsOf(model);
                QVERIFY(!setFromText(c, *findParameter("contact"), name));
                const std::vector<CaseProblem> problems = checkCombinations(c);
                const bool refused =
                    std::ranges::any_of(problems, [](const CaseProblem& problem) { return problem.key == "contact"; });
                if (!refused && reasonNotToRun(c).empty()) QVERIFY2(!recordedQuantities(c).empty(), name.c_str());
            }
    }

    void recordedQuantitiesAreListed()
    {
        const QString table = sectionOf(textOf("core/README.md"), "The results file");
        QStringList missing;
        for (const SampleCase& sample : sampleCases())
            for (const Quantity& quantity : recordedQuantities(openCase(sample.name).value)) {
                // Of further points of interest the second stands for all.
                static const QRegularExpression further(QStringLiteral("_\\d+$"));
                const QString name = QString::fromStdString(quantity.name).replace(further, QStringLiteral("_2"));
                if (!table.contains("`" + name + "`")) missing.append(name);
            }
        missing.removeDuplicates();
        QVERIFY2(missing.isEmpty(), qPrintable(missing.join(", ")));
    }

    /// A sample study, or a sample case that can be studied without a file.
    void studiesHaveASample()
    {
        for (const StudyKind& kind : studyKinds()) {
            const bool sample = std::ranges::any_of(sampleStudyTexts(), [&](const SampleStudyText& study) {
                return study.text.find("\"" + kind.name + "\"") != std::string::npos;
            });
            const bool scene = std::ranges::any_of(sampleCases(), [&](const SampleCase& each) {
                const Case c = openCase(each.name).value;
                return parseStudy(kind.name, studyTemplate(kind.name, c), "a.toml", {}, &c).valid();
            });
            QVERIFY2(sample || scene, kind.name.c_str());
        }
    }

    /// "| `touchdown study KIND CASE` | question |"; advise has a command of its own. `study --help` lists all kinds.
    void studiesOfTheReadmeAreThere()
    {
        const QString readme = textOf("README.md");
        static const QRegularExpression row(
            QStringLiteral("^\\| `touchdown (?:study )?([a-z-]+) (?:CASE|FILE)` \\| \\S"),
            QRegularExpression::MultilineOption);
        QStringList rows, kinds;
        for (auto found = row.globalMatch(readme); found.hasNext();) rows << found.next().captured(1);
        for (const StudyKind& kind : studyKinds()) kinds << QString::fromStdString(kind.name);
        QVERIFY(rows.size() >= 10);
        for (const QString& each : rows) QVERIFY2(kinds.contains(each), qPrintable(each));
    }
};

TOUCHDOWN_TEST(TestRecipes)

} // namespace test_recipes

#include "test_recipes.moc"

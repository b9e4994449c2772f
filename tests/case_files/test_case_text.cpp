// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case_files/case_text.h"

#include "core/case/parameters.h"
#include "core/case_files/case_file.h"
#include "core/case_files/case_reader.h"
#include "tests/support/random_case.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <sstream>

using namespace touchdown;

namespace test_case_text {

using test::firstDifference;
using test::RandomCase;

const std::string written = "# my notes\n"
                            "\n"
                            "title = 'A case'   # a title\n"
                            "contact = \"ono-yamane\"\n"
                            "\n"
                            "[springs] # the air bearing\n"
                            "cutoff = \"3e-1nm\"  # d_1\n"
                            "flying_height = 7e-9 # FH\n"
                            "\n"
                            "# the start\n"
                            "[initial]\n"
                            "pitch = \"0 urad\"\n";

std::vector<std::string> linesOf(const std::string& text)
{
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

/// The lines of `after` that are not in `before`, in order.
QStringList newLines(const std::string& before, const std::string& after)
{
    const auto old = linesOf(before);
    QStringList fresh;
    for (const std::string& line : linesOf(after))
        if (std::ranges::find(old, line) == old.end()) fresh << QString::fromStdString(line);
    return fresh;
}

class TestCaseText : public QObject {
    Q_OBJECT

private slots:
    void anUnchangedCaseChangesNothing()
    {
        const CaseDocument document = parseCase(written, "");
        QVERIFY(document.valid());
        QCOMPARE(updateCaseText(written, document.value), written);
        // A text does not say where it is.
        QCOMPARE(updateCaseText(written, document.value, "/elsewhere"), written);
    }
    void aChangedValueChangesItsLineAlone()
    {
        Case c = parseCase(written, "").value;
        c.springs.cutoff = 3e-9;
        std::string expected = written;
        expected.replace(expected.find("\"3e-1nm\""), 8, "\"3 nm\"");
        QCOMPARE(updateCaseText(written, c), expected);
    }
    void aValueAtItsDefaultIsWrittenWhereItStood()
    {
        const std::string text = "[springs]\ncutoff = \"3 nm\" # d_1\n";
        QCOMPARE(updateCaseText(text, Case{}), std::string("[springs]\ncutoff = \"0.3 nm\" # d_1\n"));
    }
    void missingKeysGoToTheirTables()
    {
        Case c = parseCase(written, "").value;
        c.degreesOfFreedom = 2;
        c.run.stepCheck = false;
        c.run.step = 1e-9;
        c.springs.pitch = 95e-6;
        c.initial.flyingHeight = 100e-9;
        c.model = ModelKind::Springs;
        const std::string text = updateCaseText(written, c);
        QCOMPARE(newLines(written, text), (QStringList{"pitch = \"95 urad\"", "flying_height = \"100 nm\"", "[run]",
                                                       "step = \"1 ns\"", "step_check = false"}));
        QVERIFY(text.find("flying_height = 7e-9 # FH\npitch = \"95 urad\"\n") != std::string::npos);
        QVERIFY(text.ends_with(
            "pitch = \"0 urad\"\nflying_height = \"100 nm\"\n\n[run]\nstep = \"1 ns\"\nstep_check = false\n"));
    }
    void listsAreWritten()
    {
        Case c;
        c.film.nodes = {33, 65};
        c.steady.radii = {0.02, 0.03};
        QCOMPARE(updateCaseText("[film]\nnodes = [97, 97] # few\n", c),
                 std::string("[film]\nnodes = [33, 65] # few\n\n[steady]\nradii = [\"20 mm\", \"30 mm\"]\n"));
        c.steady.radii.clear();
        QCOMPARE(updateCaseText("[film]\nnodes = [33, 65]\n[steady]\nradii = [0.02]\n", c),
                 std::string("[film]\nnodes = [33, 65]\n[steady]\nradii = []\n"));
    }
    /// What a text leaves to the defaults of one model is written when the model changes.
    void theModelChanges()
    {
        Case c = defaultsOf(ModelKind::Film);
        c.contact = noContact;
        c.degreesOfFreedom = 2;
        QCOMPARE(updateCaseText("# notes\nmodel = \"springs\"\ncontact = \"none\"\n", c),
                 std::string("# notes\nmodel = \"film\"\ncontact = \"none\"\ndegrees_of_freedom = 2\n"));
        QCOMPARE(updateCaseText("# notes\nmodel = \"film\"\n", Case{}), std::string("# notes\nmodel = \"springs\"\n"));
        QCOMPARE(updateCaseText("", defaultsOf(ModelKind::Film)), std::string("model = \"film\"\n"));
    }
    /// To edit a text, the file of its measured surface is not read: it may be large, or gone.
    void aMeasuredSurfaceIsNotRead()
    {
        const std::string text =
            "model = 'contact'\n[disk.surface]\nkind = 'file'\nmotion = 'still'\nfile = 'gone.txt'\n";
        QVERIFY(!parseCase(text, "", "/tmp").valid());
        const CaseDocument unread = parseCase(text, "", "/tmp", OutsidePaths::Refused, MeasuredSurface::Unread);
        QVERIFY(unread.valid());
        QCOMPARE(updateCaseText(text, unread.value, "/tmp"), text);
    }
    void rootKeysStayAboveTheTables()
    {
        Case c;
        c.title = "New";
        QCOMPARE(updateCaseText("# notes\n\n[run]\nstep = '10 ns'\n", c),
                 std::string("# notes\ntitle = \"New\"\n\n[run]\nstep = '10 ns'\n"));
        QCOMPARE(updateCaseText("# of the run\n[run]\n", c), std::string("title = \"New\"\n# of the run\n[run]\n"));
        QCOMPARE(updateCaseText("", c), std::string("title = \"New\"\n"));
    }

    void shapesOfToml_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("expected");
        QTest::newRow("dotted keys") << "springs.cutoff = '1 nm' # d_1\n"
                                     << "springs.cutoff = '1 nm' # d_1\nsprings.pitch = \"80 urad\"\n";
        QTest::newRow("inline table") << "springs = { cutoff = '1 nm' } # all\n"
                                      << "springs = { cutoff = '1 nm', pitch = \"80 urad\" } # all\n";
        QTest::newRow("empty inline table") << "springs = {}\n"
                                            << "springs = { pitch = \"80 urad\"}\n";
        QTest::newRow("empty table at the end, without a newline") << "[springs]"
                                                                   << "[springs]\npitch = \"80 urad\"";
        QTest::newRow("Windows lines") << "[springs]\r\ncutoff = '1 nm' # d_1\r\n[run]\r\n"
                                       << "[springs]\r\ncutoff = '1 nm' # d_1\r\npitch = \"80 urad\"\r\n[run]\r\n";
        QTest::newRow("letters of many bytes") << "title = 'µ€𝛑'\n[springs] # µ\npitch = '7 µrad' # π\n"
                                               << "title = 'µ€𝛑'\n[springs] # µ\npitch = \"80 urad\" # π\n";
        QTest::newRow("a byte order mark") << "\ufeff[springs]\npitch = '7 urad'\n"
                                           << "\ufeff[springs]\npitch = \"80 urad\"\n";
        QTest::newRow("a bad value") << "[springs]\npitch = '7 kg' # bad\n"
                                     << "[springs]\npitch = \"80 urad\" # bad\n";
        QTest::newRow("an unknown key stays") << "banana = 1\n[springs]\npitch = 1e-6\n"
                                              << "banana = 1\n[springs]\npitch = \"80 urad\"\n";
    }
    void shapesOfToml()
    {
        QFETCH(QString, text);
        QFETCH(QString, expected);
        Case c = parseCase(text.toStdString(), "").value;
        c.springs.pitch = 80e-6;
        QCOMPARE(QString::fromStdString(updateCaseText(text.toStdString(), c)), expected);
    }
    void aBadValueIsPutRightByTheDefault()
    {
        QCOMPARE(updateCaseText("[springs]\npitch = '7 kg'\n", Case{}),
                 std::string("[springs]\npitch = \"90.6 urad\"\n"));
    }
    void aTextThatIsNoTomlIsReplaced()
    {
        Case c;
        c.slider.mass = 2e-6;
        QCOMPARE(firstDifference(parseCase(updateCaseText("[[[", c), "").value, c), std::string());
    }

    void updatingReadsBack_data()
    {
        QTest::addColumn<QString>("text");
        for (const SampleCase& sample : sampleCases())
            QTest::newRow(sample.name.c_str()) << QString::fromStdString(sample.text);
        QTest::newRow("hand-written") << QString::fromStdString(written);
        QTest::newRow("empty") << "";
        QTest::newRow("inline and dotted") << "springs = { cutoff = '1 nm' }\nrun.step = '1 ns'\nslider = {}";
    }
    /// Whatever changes, the text says the same case, keeps its comments, and settles.
    void updatingReadsBack()
    {
        QFETCH(QString, text);
        RandomCase random(11);
        for (int i = 0; i < 12; ++i) {
            Case c = parseCase(text.toStdString(), "").value;
            random.change(c, i % 2 == 0 ? 0.1 : 0.9);
            const std::string updated = updateCaseText(text.toStdString(), c);
            QCOMPARE(firstDifference(parseCase(updated, "").value, c), std::string());
            QCOMPARE(updateCaseText(updated, c), updated);
            if (text.contains("# my notes"))
                QVERIFY(updated.find("# my notes") != std::string::npos && updated.find(" # d_1") != std::string::npos);
        }
    }

    /// Bit for bit, whatever the values.
    void formattingReadsBack()
    {
        RandomCase random(13);
        for (int i = 0; i < 60; ++i) {
            Case c;
            random.change(c, i % 2 == 0 ? 1.0 : 0.3);
            const CaseDocument back = parseCase(formatCase(c), "");
            QCOMPARE(firstDifference(back.value, c), std::string());
            QCOMPARE(back.problems.size(), checkCombinations(c).size());
        }
    }
    void formattingWritesEveryUsedField()
    {
        for (const ModelKind model : {ModelKind::Film, ModelKind::Springs}) {
            const Case c = defaultsOf(model);
            const std::string text = formatCase(c);
            const CaseDocument document = parseCase(text, "");
            QVERIFY(document.valid());
            for (const Parameter& parameter : parameters()) {
                const bool isText = parameter.kind == ParameterKind::Text && parameter.key != "title"; // empty ones
                const std::string name = '\n' + parameter.key.substr(parameter.key.rfind('.') + 1) + " = ";
                if (parameter.used(c) && !isText)
                    QVERIFY2(('\n' + text).find(name) != std::string::npos, parameter.key.c_str());
            }
        }
        const std::string text = formatCase(Case{});
        QVERIFY(text.find("[film]") == std::string::npos);
        QVERIFY(text.find("newmark_beta") == std::string::npos);
        QVERIFY(text.find("cutoff = \"0.3 nm\" # d_1\n") != std::string::npos);
        QVERIFY(text.find("# The suspension, about the static state.\n[suspension]\n") != std::string::npos);
    }
};

TOUCHDOWN_TEST(TestCaseText)

} // namespace test_case_text

#include "test_case_text.moc"

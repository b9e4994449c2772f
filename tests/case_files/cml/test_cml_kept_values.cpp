// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case_files/cml/cml_kept_values.h"

#include <QTest>

#include "core/case/parameters.h"
#include "tests/support/random_case.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_cml_kept_values {

Case film() { return defaultsOf(ModelKind::Film); }

/// The case that comments make of another one; what is left of the comments goes to `rest`.
Case applied(Case c, const std::string& comments, QByteArray& warnings, QByteArray& rest)
{
    CmlParameters parameters(c);
    parameters.comments = comments;
    applyKeptValues(parameters);
    for (const InputProblem& each : parameters.warnings) warnings += QByteArray::fromStdString(each.text()) + '\n';
    for (const InputProblem& each : parameters.problems) warnings += QByteArray::fromStdString(each.text()) + '\n';
    rest = QByteArray::fromStdString(parameters.comments);
    return c;
}

class TestCmlKeptValues : public QObject {
    Q_OBJECT

private slots:
    void whatDiffersIsKept()
    {
        Case wanted = film();
        wanted.film.scheme = ConvectionScheme::Exponential;
        wanted.title = "a \"new\"\npad";
        const CmlKeptValues kept = keepValues(wanted, film());
        QCOMPARE(QByteArray::fromStdString(kept.comments).count('\n'), 2);
        QVERIFY(kept.comments.find("is = \"exponential\"") != std::string::npos);
        QCOMPARE(kept.keys, std::vector<std::string>{"film.scheme"}); // nobody need be warned of a title

        QByteArray warnings, rest;
        const Case c = applied(film(), "a note\n" + kept.comments + "another\n", warnings, rest);
        QCOMPARE(firstDifference(c, wanted), std::string());
        QCOMPARE(warnings, QByteArray());
        QCOMPARE(rest, QByteArray("a note\nanother\n"));
    }
    void anyCaseComesBack()
    {
        RandomCase random(23);
        for (int round = 0; round < 300; ++round) {
            Case wanted = film();
            random.change(wanted, 0.5);
            QByteArray warnings, rest;
            const Case c = applied(film(), keepValues(wanted, film()).comments, warnings, rest);
            QCOMPARE(warnings, QByteArray());
            QCOMPARE(firstDifference(c, wanted), std::string());
        }
    }
    void whatTheFilesNowSayHolds()
    {
        Case wanted = film();
        wanted.suspension.stiffness = 20.0;
        const std::string comments = keepValues(wanted, film()).comments;
        Case edited = film();
        edited.suspension.stiffness = 25.0;
        QByteArray warnings, rest;
        const Case c = applied(edited, comments, warnings, rest);
        QCOMPARE(c.suspension.stiffness, 25.0);
        QCOMPARE(warnings,
                 QByteArray("the comments keep \"20 N/m\" for suspension.stiffness in place of \"6 N/m\", but the "
                            "files now say \"25 N/m\", which holds\n"));
    }
    void lastDigitsNeedNoWarning()
    {
        Case wanted = film();
        wanted.suspension.preload = std::nextafter(wanted.suspension.preload, 1.0);
        const CmlKeptValues kept = keepValues(wanted, film());
        QVERIFY(kept.keys.empty());
        QVERIFY(!kept.comments.empty());
    }
    void spoiltComments_data()
    {
        QTest::addColumn<QByteArray>("comments");
        QTest::addColumn<QByteArray>("warning");
        QTest::newRow("no TOML") << QByteArray("touchdown: film.scheme = { was = \n") << QByteArray("cannot be read");
        QTest::newRow("Latin-1") << QByteArray("touchdown: title = { was = \"\xb5\", is = \"\" }\n")
                                 << QByteArray("cannot be read");
        QTest::newRow("unknown key") << QByteArray("touchdown: film.schem = { was = \"a\", is = \"b\" }\n")
                                     << QByteArray("unknown key");
        QTest::newRow("out of range") << QByteArray("touchdown: steady.shear_arm = { was = \"0.5\", is = \"9\" }\n")
                                      << QByteArray("out of range");
    }
    void spoiltComments()
    {
        QFETCH(QByteArray, comments);
        QFETCH(QByteArray, warning);
        QByteArray warnings, rest;
        const Case c = applied(film(), comments.toStdString(), warnings, rest);
        QVERIFY2(warnings.contains(warning), warnings);
        QCOMPARE(firstDifference(c, film()), std::string());
    }
};

TOUCHDOWN_TEST(TestCmlKeptValues)

} // namespace test_cml_kept_values

#include "test_cml_kept_values.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case_files/cml/cml_sections.h"

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_cml_sections {

class TestCmlSections : public QObject {
    Q_OBJECT

private slots:
    void listsStandBelowTheirHeadings()
    {
        const std::string text = "header 1 2\n"
                                 "  ***** Load Parameters ****\r\n"
                                 "f0(kg) xf0\n"
                                 " 1.5E-3\n"
                                 " 2 a remark 7\n"
                                 "\n"
                                 "empty\n"
                                 "last\n"
                                 "3\n"
                                 "*Runs\n"
                                 "9 9\n";
        const CmlSections all = splitCmlSections(text);
        QCOMPARE(all.sections.size(), std::size_t(2));
        const CmlSection& load = all.sections[0];
        QCOMPARE(load.name, std::string("Load Parameters"));
        QCOMPARE(load.line, 2);
        QCOMPARE(load.lists.size(), std::size_t(3));
        QCOMPARE(load.lists[0].heading, std::string_view("f0(kg) xf0"));
        QCOMPARE(load.lists[0].line, 3);
        QCOMPARE(load.lists[0].numbers.size(), std::size_t(2));
        QCOMPARE(load.lists[0].numbers[1].value, 2.0);
        QCOMPARE(load.lists[0].numbers[1].line, 5);
        QCOMPARE(load.lists[0].after, std::string_view("a"));
        QCOMPARE(load.lists[0].afterLine, 5);
        QVERIFY(load.lists[1].numbers.empty());
        QCOMPARE(load.lists[1].heading, std::string_view("empty"));
        QCOMPARE(load.lists[1].after, std::string_view("last"));
        QCOMPARE(load.lists[2].numbers[0].line, 9);
        QVERIFY(load.lists[2].after.empty());
        // Numbers without a heading have one that is empty.
        QCOMPARE(all.sections[1].lists.size(), std::size_t(1));
        QCOMPARE(all.sections[1].lists[0].numbers.size(), std::size_t(2));
    }
    void commentsTakeTheRest()
    {
        const CmlSections all = splitCmlSections("h\n**Comments**\n1 2\n**Runs**\nfree text");
        QCOMPARE(all.sections.size(), std::size_t(1));
        QVERIFY(all.sections[0].lists.empty());
        QCOMPARE(all.sections[0].body, std::string_view("\n1 2\n**Runs**\nfree text"));
    }
    void textWithoutSections()
    {
        QVERIFY(splitCmlSections("one\ntwo 3").sections.empty());
        QVERIFY_EXCEPTION_THROWN(splitCmlSections(" \n"), CmlError);
        QVERIFY_EXCEPTION_THROWN(splitCmlSections(std::string_view("a\0", 2)), CmlError);
    }
    void whatNoFileHasIsRefused_data()
    {
        QTest::addColumn<QByteArray>("line");
        QTest::addColumn<int>("times");
        QTest::newRow("sections") << QByteArray("*\n") << 2000000;
        QTest::newRow("headings") << QByteArray("a\n") << 2000000;
        QTest::newRow("numbers") << QByteArray("1\n") << 2000000;
        QTest::newRow("numbers on one line") << QByteArray("1 ") << 2000000;
    }
    void whatNoFileHasIsRefused()
    {
        QFETCH(QByteArray, line);
        QFETCH(int, times);
        const std::string text = "*Runs\n" + line.repeated(times).toStdString();
        QVERIFY_EXCEPTION_THROWN(splitCmlSections(text), CmlError);
    }
};

TOUCHDOWN_TEST(TestCmlSections)

} // namespace test_cml_sections

#include "test_cml_sections.moc"

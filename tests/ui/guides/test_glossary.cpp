// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guides/glossary.h"

#include <algorithm>
#include <random>
#include <set>

#include <QFile>
#include <QLabel>
#include <QSignalSpy>
#include <QTextDocument>
#include <QTextFragment>
#include <QToolTip>
#include <QtTest>

#include "core/studies/lesson/lesson.h"
#include "tests/support/test_program.h"
#include "tests/ui/named_widget.h"
#include "ui/guides/lesson_pane.h"
#include "ui/guides/lesson_text.h"
#include "ui/guides/term_marks.h"
#include "ui/window/help_window.h"

using namespace touchdown;

namespace test_glossary {

const std::vector<GlossaryEntry> few{{"spacing", {"spacings"}, "nm", "A distance."},
                                     {"minimum spacing", {}, "nm", "The smallest distance."},
                                     {"slip", {}, "", "A velocity."},
                                     {"slip length", {}, "nm", "Another distance."},
                                     {"meniscus force", {"f_m"}, "mN", "A force."}};

/// A use of a term in a text without tags.
struct Use {
    qsizetype at = 0;
    QString text;
    std::string term;
    bool operator==(const Use&) const = default;
};

QString described(const std::vector<Use>& uses)
{
    QStringList all;
    for (const Use& use : uses)
        all << QStringLiteral("%1 %2 (%3)").arg(use.at).arg(use.text, QString::fromStdString(use.term));
    return all.join(QStringLiteral(", "));
}

/// The links to terms of an HTML text, and the places of its other links and of its code.
struct Shown {
    QString text;
    std::vector<Use> links;
    std::vector<bool> closed; // for each character of the text
};

Shown shown(const QString& html)
{
    QTextDocument document;
    document.setHtml(html);
    Shown result{document.toPlainText().replace(QChar::Nbsp, u' '), {}, {}};
    result.closed.assign(static_cast<std::size_t>(result.text.size()), false);
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next())
        for (auto part = block.begin(); !part.atEnd(); ++part) {
            const QTextFragment fragment = part.fragment();
            const QString link = fragment.charFormat().anchorHref();
            if (link.startsWith(QStringLiteral("term:"))) {
                const std::string term = link.mid(5).toStdString();
                // A subscript is a fragment of its own.
                if (!result.links.empty() && result.links.back().term == term)
                    result.links.back().text += fragment.text();
                else
                    result.links.push_back({fragment.position(), fragment.text(), term});
            } else if (!link.isEmpty() || fragment.charFormat().fontFixedPitch()) {
                std::fill_n(result.closed.begin() + fragment.position(), fragment.length(), true);
            }
        }
    return result;
}

/// The first use of each term, found character by character in the text without marks.
std::vector<Use> firstUses(const Shown& plain, const std::vector<GlossaryEntry>& entries)
{
    const auto inWord = [&](qsizetype at) {
        if (at < 0 || at >= plain.text.size()) return false;
        const QChar c = plain.text[at];
        return c.isLetterOrNumber() || c == u'-' || c == u'_';
    };
    std::vector<Use> uses;
    std::set<std::string> used;
    for (qsizetype at = 0; at < plain.text.size(); ++at) {
        if (inWord(at - 1) || plain.closed[static_cast<std::size_t>(at)]) continue;
        Use best;
        const auto consider = [&](std::string spelling, const GlossaryEntry& entry) {
            const bool symbol = spelling.size() <= 2 || spelling.find('_') != std::string::npos;
            std::erase(spelling, '_'); // a subscript
            const QString sought = QString::fromStdString(spelling);
            const QString here = plain.text.mid(at, sought.size());
            const bool capital = !symbol && here == sought.front().toUpper() + sought.mid(1);
            if ((here == sought || capital) && !inWord(at + sought.size()) && sought.size() > best.text.size())
                best = {at, here, entry.term};
        };
        for (const GlossaryEntry& entry : entries) {
            consider(entry.term, entry);
            for (const std::string& spelling : entry.also) consider(spelling, entry);
        }
        if (best.text.isEmpty()) continue;
        if (used.insert(best.term).second) uses.push_back(best);
        at += best.text.size() - 1;
    }
    return uses;
}

QString marked(const std::string& text, const std::vector<GlossaryEntry>& entries = few)
{
    return TermMarks(entries).marked(lessonHtml(text), Qt::black);
}

std::vector<std::string> linkedTerms(const QString& html)
{
    std::vector<std::string> terms;
    for (const Use& use : shown(html).links) terms.push_back(use.term);
    return terms;
}

std::vector<QString> problemsOf(const char* text)
{
    std::vector<QString> problems;
    for (const InputProblem& problem : readGlossary(text, "g.toml").problems)
        problems.push_back(QString::fromStdString(problem.text()));
    return problems;
}

class TestGlossary : public QObject {
    Q_OBJECT

private slots:
    void explainsEachTerm()
    {
        QFile file(QStringLiteral(":/help/glossary.toml"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const Glossary glossary = readGlossary(file.readAll().toStdString(), "glossary.toml");
        for (const InputProblem& problem : glossary.problems) QFAIL(problem.text().c_str());
        QVERIFY2(glossary.entries.size() >= 38, qPrintable(QString::number(glossary.entries.size())));
        QCOMPARE(glossary.entries.size(), glossaryEntries().size());
        static const QRegularExpression end(QStringLiteral("[.!?](?= [A-Z]|$)"));
        for (const GlossaryEntry& entry : glossary.entries) {
            const QString text = QString::fromStdString(entry.text);
            const qsizetype sentences = text.count(end);
            QVERIFY2(sentences >= 1 && sentences <= 2 && text.endsWith(u'.'), entry.term.c_str());
            QVERIFY2(text.size() >= 30, entry.term.c_str()); // more than a synonym
        }
    }

    void reportsProblems()
    {
        QVERIFY(problemsOf("[[entry]]\nterm = 'a'\ntext = 'b'\n").empty());
        const struct {
            const char* text;
            std::vector<const char*> parts; // of the only problem
        } rows[]{{"[[entry]]\nterm = 'a'\n", {"g.toml:1", "entry[1].text"}},
                 {"\n[[entry]]\ntext = 'a'\n", {"g.toml:2", "entry[1].term"}},
                 {"[[entry]]\nterm = ''\ntext = 'b'\n", {"g.toml:2", "entry[1].term"}},
                 {"[[entry]]\nterm = 'a'\ntext = 5\n", {"g.toml:3", "entry[1].text"}},
                 {"[[entry]]\nterm = 'a'\ntext = 'b'\nalso = 'c'\n", {"g.toml:4", "entry[1].also"}},
                 {"[[entry]]\nterm = 'a'\ntext = 'b'\nalso = ['c', '']\n", {"g.toml:4", "entry[1].also"}},
                 {"[[entry]]\nterm = 'a'\ntext = 'b'\nunit = 'ell'\n", {"g.toml:4", "entry[1].unit", "nm"}},
                 {"[[entry]]\nterm = 'a'\ntext = 'b'\nnote = 'c'\n", {"g.toml:4", "entry[1].note"}},
                 {"[[entry]]\nterm = 'a'\ntext = 'b'\n[[entry]]\nterm = 'c'\ntext = 'b'\nalso = ['a']\n",
                  {"g.toml:7", "entry[2].also", "\"a\""}},
                 {"[[entry]\n", {"g.toml:1"}}};
        for (const auto& row : rows) {
            const std::vector<QString> problems = problemsOf(row.text);
            QVERIFY2(problems.size() == 1, row.text);
            for (const char* part : row.parts)
                QVERIFY2(problems.front().contains(QString::fromUtf8(part)), qPrintable(problems.front()));
        }
        // All of them at once.
        QCOMPARE(problemsOf("[[entry]]\nunit = 'ell'\nnote = 5\n").size(), std::size_t(4));
    }

    void marksTheFirstUseAlone()
    {
        const QString text = marked("A spacing, and a spacing; Slip and slip.");
        QCOMPARE(linkedTerms(text), (std::vector<std::string>{"spacing", "slip"}));
        const std::vector<Use> links = shown(text).links;
        QCOMPARE(links[0], (Use{2, QStringLiteral("spacing"), "spacing"}));
        QCOMPARE(links[1], (Use{26, QStringLiteral("Slip"), "slip"}));
        // Over the texts of a step, until it starts again.
        TermMarks marks(few);
        QVERIFY(linkedTerms(marks.marked("spacings", Qt::black)).size() == 1);
        QCOMPARE(marks.marked("spacing", Qt::black), QStringLiteral("spacing"));
        marks.restart();
        QVERIFY(linkedTerms(marks.marked("spacing", Qt::black)).size() == 1);
    }

    void leavesOtherTextsAlone()
    {
        for (const char* text : {"Nothing here.", "", "W >= 0 & -5 us", "A slipper, a nonslip and a slip-free wall.",
                                 "f_m2 and af_m", "minimum", "d_m and f", "spacings_x"})
            QCOMPARE(marked(text), lessonHtml(text));
        // A key is a link already, or code; a subscript belongs to its symbol.
        for (const char* html : {"<a href='air.slip'>air.slip</a>", "<code>the.slip</code>", "v<sub>slip</sub>",
                                 "<p style='slip'>x</p>", "<code>spacing <b>slip</b></code>"})
            QCOMPARE(TermMarks(few).marked(html, Qt::black), QString::fromUtf8(html));
        QVERIFY(linkedTerms(TermMarks(few).marked("<code>slip</code> <b>slip</b>", Qt::black)).size() == 1);
        QCOMPARE(TermMarks(std::vector<GlossaryEntry>()).marked("spacing", Qt::black), QStringLiteral("spacing"));
    }

    void prefersTheLongestTerm()
    {
        QCOMPARE(linkedTerms(marked("The minimum spacing.")), std::vector<std::string>{"minimum spacing"});
        QCOMPARE(linkedTerms(marked("Minimum spacing and spacing.")),
                 (std::vector<std::string>{"minimum spacing", "spacing"}));
        // The second use of the longer one is no first use of the shorter one.
        QCOMPARE(linkedTerms(marked("Minimum spacing, minimum spacing.")), std::vector<std::string>{"minimum spacing"});
        QCOMPARE(linkedTerms(marked("Slip length and slip.")), (std::vector<std::string>{"slip length", "slip"}));
        QCOMPARE(linkedTerms(marked("Slip lengths.")),
                 std::vector<std::string>{"slip"}); // no spelling of the longer one
        QCOMPARE(linkedTerms(marked("With f_m = 3 mN")), std::vector<std::string>{"meniscus force"});
    }

    /// Against a search that is written differently, in all texts of the guides and in random ones.
    void findsWhatASearchFinds()
    {
        const std::vector<GlossaryEntry>& entries = glossaryEntries();
        std::vector<std::string> texts;
        for (const auto* steps : {&lessonSteps(), &demonstrationSteps()})
            for (const LessonStep& step : *steps)
                for (const std::string& text : {step.text, step.question, step.change, step.answer})
                    texts.push_back(text);
        const std::size_t ours = texts.size();
        std::vector<std::string> words{"the", "of", "run.step", "no.key", "7 nm", "k_x", "in", "a"};
        for (const GlossaryEntry& entry : entries) {
            words.push_back(entry.term);
            words.insert(words.end(), entry.also.begin(), entry.also.end());
        }
        std::mt19937 random(7);
        const auto below = [&](std::size_t n) { return std::size_t(random() % n); };
        const std::vector<std::string> between{" ", " ", " ", ", ", ". ", "\n", "-", "", "x"};
        for (int i = 0; i < 500; ++i) {
            std::string text;
            for (std::size_t n = below(30); n > 0; --n)
                text += words[below(words.size())] + between[below(between.size())];
            texts.push_back(text);
        }
        std::size_t links = 0;
        for (std::size_t i = 0; i < texts.size(); ++i) {
            const QString html = lessonBlock({}, texts[i], Qt::black);
            const Shown plain = shown(html), all = shown(TermMarks(entries).marked(html, Qt::black));
            QCOMPARE(all.text, plain.text);
            const std::vector<Use> expected = firstUses(plain, entries);
            QVERIFY2(all.links == expected,
                     qPrintable(plain.text + u'\n' + described(all.links) + u'\n' + described(expected)));
            if (i < ours) links += all.links.size();
        }
        QVERIFY2(links > ours, qPrintable(QString::number(links))); // the guides use the terms
    }

    /// Each step explains each of its terms once.
    void explainsEachTermOfAStepOnce()
    {
        LessonPane pane(LessonPane::Kind::Lesson, lessonSteps());
        for (std::size_t step = 0; step < pane.count(); ++step) {
            pane.go(step);
            std::vector<std::string> terms;
            for (const QLabel* label : pane.findChildren<QLabel*>())
                for (const std::string& term : linkedTerms(label->text())) terms.push_back(term);
            QVERIFY(terms.size() > 3);
            std::ranges::sort(terms);
            QVERIFY(std::ranges::adjacent_find(terms) == terms.end());
        }
    }

    void showsTheExplanation()
    {
        LessonPane pane(LessonPane::Kind::Lesson, lessonSteps());
        pane.resize(400, 800);
        pane.show();
        QVERIFY(QTest::qWaitForWindowExposed(&pane));
        auto* text = namedWidget<QLabel>(pane, QStringLiteral("Text of the step"));
        QVERIFY(text && text->text().contains(QStringLiteral("<a href='term:slider'")));
        const QSignalSpy keys(&pane, &LessonPane::keyChosen);
        emit text->linkHovered(QStringLiteral("term:slider"));
        QTRY_VERIFY(QToolTip::isVisible());
        const auto slider = std::ranges::find(glossaryEntries(), "slider", &GlossaryEntry::term);
        QCOMPARE(QToolTip::text(), glossaryHtmlTip(*slider));
        emit text->linkHovered(QString());
        QTRY_VERIFY(!QToolTip::isVisible());
        // By the keyboard: the first link of the label.
        text->setFocus();
        QTest::keyClick(text, Qt::Key_Tab);
        QTest::keyClick(text, Qt::Key_Return);
        QTRY_VERIFY(QToolTip::isVisible());
        QVERIFY(keys.isEmpty());
        QToolTip::hideText();
        // A key of a parameter is no term.
        auto* change = namedWidget<QLabel>(pane, QStringLiteral("What to change"));
        QVERIFY(change && change->text().contains(QStringLiteral("<a href='initial.flying_height'>")));
        emit change->linkActivated(QStringLiteral("initial.flying_height"));
        QCOMPARE(keys.size(), 1);
        QCOMPARE(keys[0][0].toString(), QStringLiteral("initial.flying_height"));
    }

    void helpListsTheTerms()
    {
        HelpWindow help({});
        help.open(HelpWindow::Page::Glossary);
        std::vector<QString> terms;
        for (const GlossaryEntry& entry : glossaryEntries()) terms.push_back(QString::fromStdString(entry.term));
        std::ranges::sort(terms, [](const QString& a, const QString& b) { return a.toLower() < b.toLower(); });
        const QString text = help.text();
        qsizetype from = 0;
        for (const QString& term : terms) {
            const qsizetype at = text.indexOf(QRegularExpression(QStringLiteral("(?m)^%1\\b").arg(term)), from);
            QVERIFY2(at >= from, qPrintable(term));
            from = at + 1;
        }
        QVERIFY(text.contains(QStringLiteral("[nm]")));
    }
};

TOUCHDOWN_TEST(TestGlossary)

} // namespace test_glossary

#include "test_glossary.moc"

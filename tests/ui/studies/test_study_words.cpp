// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/studies/study_words.h"

#include <QtTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_study_words {

class TestStudyWords : public QObject {
    Q_OBJECT

private slots:
    void words_data()
    {
        QTest::addColumn<QString>("written");
        QTest::addColumn<QString>("shown");
        QTest::newRow("a key begins") << "suspension.preload: 25 mN, from 20 mN."
                                      << "Preload: 25 mN, from 20 mN.";
        QTest::newRow("a key within") << "more film.nodes are needed"
                                      << "more nodes are needed";
        QTest::newRow("of a rail") << "The search moved abs.rail[4].width."
                                   << "The search moved rail 4: width.";
        QTest::newRow("a quantity") << "minimum_spacing: 8 nm, wanted 8 nm within 0.1 nm."
                                    << "Minimum spacing: 8 nm, wanted 8 nm within 0.1 nm.";
        QTest::newRow("the button") << "Its case (--apply FILE, or Apply to the case) is to be run."
                                    << "Its case (Apply to the case) is to be run.";
        QTest::newRow("no key") << "e.g. a.b of pitch: 0.5 um" << QStringLiteral("e.g. a.b of pitch: 0.5 µm");
        QTest::newRow("a text of the user") << "The method \"film.nodes\" is the best."
                                            << "The method \"film.nodes\" is the best.";
    }
    void words()
    {
        QFETCH(const QString, written);
        QTEST(inWindowWords(written.toStdString()), "shown");
    }
};

TOUCHDOWN_TEST(TestStudyWords)

} // namespace test_study_words

#include "test_study_words.moc"

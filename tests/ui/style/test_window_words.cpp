// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/window_words.h"

#include <QtTest>

#include "tests/support/test_program.h"
#include "ui/style/quantity_format.h"

using namespace touchdown;

namespace test_window_words {

class TestWindowWords : public QObject {
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
    void sentences()
    {
        QCOMPARE(sentence("the roll stops at -4.093 urad, more film.nodes are needed"),
                 QStringLiteral("The roll stops at −4.093 µrad, more nodes are needed."));
        QCOMPARE(sentence("suspension.preload must be > 0 N"), QStringLiteral("Preload must be > 0 N."));
    }
    void labels()
    {
        QCOMPARE(labelOfKey("suspension.preload"), QStringLiteral("Preload"));
        QCOMPARE(labelOfKey("abs.rail[2].width"), QStringLiteral("Rail 2: width"));
        QCOMPARE(labelOfKey("contact"), QStringLiteral("Contact"));
        QCOMPARE(labelOfKey("steps"), QString());
    }
};

TOUCHDOWN_TEST(TestWindowWords)

} // namespace test_window_words

#include "test_window_words.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/message_strip.h"

#include <QtTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_message_strip {

class TestMessageStrip : public QObject {
    Q_OBJECT

private slots:
    /// A message about the case goes when the case is right again; a newer one about something else stays, whatever
    /// its words.
    void clearsAMessageByItsTopic()
    {
        using Kind = MessageStrip::Kind;
        using Topic = MessageStrip::Topic;
        const QString words = QStringLiteral("The case cannot be run.");
        MessageStrip strip;
        strip.show(Kind::Failure, words, {}, Topic::Case);
        strip.clear(Topic::Case);
        QVERIFY(strip.isHidden() && strip.text().isEmpty());
        strip.show(Kind::Failure, words, {}, Topic::Case);
        strip.show(Kind::Warning, words);
        strip.clear(Topic::Case);
        QVERIFY(!strip.isHidden());
        QCOMPARE(strip.text(), words);
        strip.clear();
        QVERIFY(strip.isHidden());
    }
};

TOUCHDOWN_TEST(TestMessageStrip)

} // namespace test_message_strip

#include "test_message_strip.moc"

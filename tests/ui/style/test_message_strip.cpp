// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/message_strip.h"

#include <QScrollBar>
#include <QVBoxLayout>
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
    /// It has one height, whatever it says, so that the page above never moves; all of a long message stands over the
    /// page after a click.
    void keepsThePageInItsPlace()
    {
        QWidget window;
        auto* page = new QWidget(&window);
        auto* strip = new MessageStrip(&window);
        auto* layout = new QVBoxLayout(&window);
        layout->addWidget(page, 1);
        layout->addWidget(strip);
        window.resize(500, 400);
        window.show();
        const QRect place = page->geometry();
        const QSize least = window.minimumSizeHint();
        QString many;
        for (int line = 0; line < 7; ++line)
            many += QStringLiteral("A sentence that is rather long, of line %1.\n").arg(line);
        many.chop(1);
        using Kind = MessageStrip::Kind;
        for (const auto& [text, action] :
             {std::pair(QStringLiteral("Short."), QString()), std::pair(many, QString()),
              std::pair(many, QStringLiteral("Show it")), std::pair(QString(), QString())}) {
            strip->show(Kind::Warning, text, action);
            QCoreApplication::processEvents();
            QCOMPARE(page->geometry(), place);
            QCOMPARE(window.minimumSizeHint().height(), least.height());
            QCOMPARE(strip->isCut(), text == many);
            QCOMPARE(strip->text(), text);
        }
        strip->clear();
        QCOMPARE(page->geometry(), place);

        strip->show(Kind::Failure, many);
        QCoreApplication::processEvents();
        QVERIFY(!strip->whole()->isVisible());
        QTest::mouseClick(strip, Qt::LeftButton, {}, {strip->width() / 3, strip->height() / 2});
        QVERIFY(strip->whole()->isVisible());
        QCOMPARE(strip->whole()->toPlainText(), many);
        QCOMPARE(strip->whole()->geometry().bottom() + 1, strip->geometry().top());
        QCOMPARE(strip->whole()->verticalScrollBar()->maximum(), 0); // all lines have room
        QCOMPARE(page->geometry(), place);
        strip->clear();
        QVERIFY(!strip->whole()->isVisible());
    }
};

TOUCHDOWN_TEST(TestMessageStrip)

} // namespace test_message_strip

#include "test_message_strip.moc"

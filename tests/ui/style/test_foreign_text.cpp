// SPDX-License-Identifier: GPL-3.0-or-later
//
// Foreign text is shown as it is written, and no document of the program reads a file.
#include <QLabel>
#include <QMessageBox>
#include <QProgressDialog>
#include <QTemporaryDir>
#include <QTextDocumentFragment>
#include <QtTest>

#include "tests/support/test_program.h"
#include "ui/style/foreign_text.h"

using namespace touchdown;

namespace test_foreign_text {

const QString foreign = QStringLiteral("<img src='/x'> & <b>bold</b>\nsecond line");

class TestForeignText : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        early_.setText(foreign);
        early_.ensurePolished();
        showForeignTextPlainly();
    }
    void aLabelThatWasThereBecomesPlain() { QCOMPARE(early_.textFormat(), Qt::PlainText); }
    void theLabelsOfABoxArePlain()
    {
        QMessageBox box(QMessageBox::Warning, QStringLiteral("x"), foreign, QMessageBox::Close);
        box.setInformativeText(foreign);
        box.show();
        int texts = 0;
        for (const QLabel* label : box.findChildren<QLabel*>()) {
            texts += label->text() == foreign ? 1 : 0;
            QVERIFY(label->text().isEmpty() || label->textFormat() == Qt::PlainText);
        }
        QCOMPARE(texts, 2);
    }
    void theLabelOfAProgressDialogIsPlain()
    {
        QProgressDialog dialog(foreign, {}, 0, 1);
        dialog.show();
        const auto* label = dialog.findChild<QLabel*>();
        QCOMPARE(label->text(), foreign);
        QCOMPARE(label->textFormat(), Qt::PlainText);
    }
    void aLabelIsPlainBeforeItIsMeasured()
    {
        const QLabel html(foreign), lines(QStringLiteral("the same\nnumber of lines"));
        QCOMPARE(html.sizeHint().height(), lines.sizeHint().height());
        QCOMPARE(html.textFormat(), Qt::PlainText);
    }
    void aLabelThatAsksForHtmlKeepsIt()
    {
        QLabel label(QStringLiteral("<b>10</b> nm"));
        label.setTextFormat(Qt::RichText);
        label.show();
        QCOMPARE(label.textFormat(), Qt::RichText);
    }
    void escapedTextIsReadBackAsItWas()
    {
        QCOMPARE(QTextDocumentFragment::fromHtml(escaped(foreign)).toPlainText(), foreign);
    }
    /// The words of the program behind it would be read from right to left.
    void marksOfDirectionAreReplaced()
    {
        const QString turned = QStringLiteral("a\u202Eb\u2066c");
        for (const QString& shown : {escaped(turned), plainTip(turned), onButton(turned), inOneLine(turned)})
            QCOMPARE(shown, QStringLiteral("a\uFFFDb\uFFFDc"));
    }
    /// Also in a text that comes later.
    void aLabelAndATitleShowNoMarksOfDirection()
    {
        QLabel label(QStringLiteral("a\u202Etxt.exe"));
        label.setWindowTitle(QStringLiteral("b\u202Etxt.exe"));
        label.show();
        QTRY_COMPARE(label.text(), QStringLiteral("a\uFFFDtxt.exe"));
        QCOMPARE(label.windowTitle(), QStringLiteral("b\uFFFDtxt.exe"));
        label.setText(QStringLiteral("c\u2067d"));
        label.setWindowTitle({});
        QTRY_COMPARE(label.text(), QStringLiteral("c\uFFFDd"));
    }
    void longTextsFitTheScreen()
    {
        QCOMPARE(plainTip(QStringLiteral("note\n").repeated(2000)).count(u'\n'), 39);
        QCOMPARE(inOneLine(QStringLiteral("a line\n").repeated(500)).size(), 81);
    }
    void aTipIsReadBackAsItWas_data()
    {
        QTest::addColumn<QString>("text");
        QTest::newRow("short") << QStringLiteral("7 nm < 8 nm & more");
        QTest::newRow("HTML") << foreign;
        QTest::newRow("an escape") << QStringLiteral("&lt;b&gt;");
        QTest::newRow("a link") << QStringLiteral("a <a href='http://example.org'>link</a>");
        QTest::newRow("blanks") << QStringLiteral("<b>two  blanks</b>");
        QTest::newRow("long") << QStringLiteral("some words ").repeated(20) + QStringLiteral("& more");
        QTest::newRow("a long word") << QStringLiteral("/folder<b>").repeated(20);
    }
    void aTipIsReadBackAsItWas()
    {
        QFETCH(QString, text);
        const QString tip = plainTip(text);
        // As Qt shows tool tips.
        QString shown = Qt::mightBeRichText(tip) ? QTextDocumentFragment::fromHtml(tip).toPlainText() : tip;
        QCOMPARE(shown.remove(QChar(0x200B)), text);
    }
    void aLongTipIsBrokenIntoLines()
    {
        for (const QString& text : {QStringLiteral("some words ").repeated(30), QString(400, u'x')}) {
            QLabel tip(plainTip(text)), line(QString(110, u'x'));
            tip.setWordWrap(Qt::mightBeRichText(tip.text())); // as the window of a tool tip does
            tip.setWindowFlag(Qt::ToolTip);
            QVERIFY2(tip.sizeHint().width() < line.sizeHint().width(), qPrintable(text));
        }
    }
    void aDocumentReadsNoFile_data()
    {
        QTest::addColumn<QString>("html");
        QTest::newRow("picture") << QStringLiteral("<img src='%1'>");
        QTest::newRow("its address") << QStringLiteral("<img src='file://%1'>");
        QTest::newRow("background") << QStringLiteral("<table background='%1'><tr><td>x</td></tr></table>");
    }
    void aDocumentReadsNoFile()
    {
        QFETCH(QString, html);
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("large.png"));
        QImage picture(300, 200, QImage::Format_RGB32);
        picture.fill(Qt::red);
        QVERIFY(picture.save(file));
        OwnDocument document;
        document.setHtml(html.arg(file));
        QVERIFY(document.size().height() < 100.0);
        QCOMPARE(document.resource(QTextDocument::ImageResource, QUrl(file)).value<QImage>().width(), 1);
        OwnTextBrowser browser;
        browser.setHtml(html.arg(file));
        QVERIFY(browser.document()->size().height() < 100.0);
        QCOMPARE(browser.document()->resource(QTextDocument::ImageResource, QUrl(file)).value<QImage>().width(), 1);
    }
    void aPictureOfTheProgramIsShown()
    {
        OwnDocument document;
        QImage picture(300, 200, QImage::Format_RGB32);
        picture.fill(Qt::red);
        document.addResource(QTextDocument::ImageResource, QUrl(QStringLiteral("picture0")), picture);
        document.setHtml(QStringLiteral("<img src='picture0'>"));
        QVERIFY(document.size().height() >= 200.0);
    }
    void aButtonShowsTheSign() { QCOMPARE(onButton(QStringLiteral("R&D")), QStringLiteral("R&&D")); }

private:
    QLabel early_; // measured before the rule holds
};

TOUCHDOWN_TEST(TestForeignText)

} // namespace test_foreign_text

#include "test_foreign_text.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/text_encoding.h"

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_text_encoding {

class TestTextEncoding : public QObject {
    Q_OBJECT

private slots:
    void everyEncodingBecomesUtf8_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QByteArray>("text");
        const auto row = [](const char* name, const QByteArray& bytes, const char* text) {
            QTest::newRow(name) << bytes << QByteArray(text);
        };
        row("nothing", "", "");
        row("ASCII", "x 1\n", "x 1\n");
        row("Latin-1 stays", "\xB5m", "\xB5m");
        row("a mark", "\xEF\xBB\xBFx", "x");
        row("low byte first", QByteArray("\xFF\xFE\xB5\0m\0", 6), "\xC2\xB5m");
        row("high byte first", QByteArray("\xFE\xFF\0\xB5\0m", 6), "\xC2\xB5m");
        row("three bytes", QByteArray("\xFE\xFF\x33\x9A", 4), "\xE3\x8E\x9A");
        row("a pair of surrogates", QByteArray("\xFE\xFF\xD8\x3D\xDE\x00", 6), "\xF0\x9F\x98\x80");
        row("half a pair", QByteArray("\xFE\xFF\xD8\x3D", 4), "\xEF\xBF\xBD");
        row("half a unit", QByteArray("\xFE\xFF\0m\0", 5), "m");
    }
    void everyEncodingBecomesUtf8()
    {
        QFETCH(QByteArray, bytes);
        QFETCH(QByteArray, text);
        QCOMPARE(QByteArray::fromStdString(asUtf8(bytes.toStdString())), text);
    }
};

TOUCHDOWN_TEST(TestTextEncoding)

} // namespace test_text_encoding

#include "test_text_encoding.moc"

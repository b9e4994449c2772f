// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/toml_document.h"

#include <QTest>

using namespace touchdown;

namespace {

std::string textOf(const TomlEntry& entry, std::string_view text)
{
    return std::string(text.substr(entry.begin, entry.end - entry.begin));
}

const TomlEntry* find(const TomlDocument& document, std::string_view key)
{
    for (const TomlEntry& entry : document.entries)
        if (entry.key == key) return &entry;
    return nullptr;
}

} // namespace

class TestTomlDocument : public QObject {
    Q_OBJECT

private slots:
    void placesOfValues_data()
    {
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("text");
        QTest::addColumn<int>("line");
        QTest::newRow("a literal string after two-byte letters") << "title"
                                                                 << "'µé a'" << 1;
        QTest::newRow("a string") << "slider.mass"
                                  << "\"1 µg\"" << 4;
        QTest::newRow("a number") << "slider.b"
                                  << "1.5" << 5;
        QTest::newRow("a string over two lines") << "slider.c"
                                                 << "\"\"\"a\nb\"\"\"" << 6;
        QTest::newRow("a dotted key") << "run.d.e"
                                      << "5" << 9;
        QTest::newRow("inside an inline table") << "run.in.q"
                                                << "true" << 10;
        QTest::newRow("an array") << "run.in.r"
                                  << "[1, 2]" << 10;
    }
    void placesOfValues()
    {
        QFETCH(QString, key);
        QFETCH(QString, text);
        QFETCH(int, line);
        for (const std::string& mark : {std::string(), std::string("\xEF\xBB\xBF")}) { // with a byte order mark as well
            const std::string toml =
                mark + "title = 'µé a'  # c\n\n[slider]\nmass = \"1 µg\" # x\nb = 1.5\nc=\"\"\"a\nb\"\"\"\n"
                       "[run]\nd.e = 5\nin = { q = true, r = [1, 2] }\n";
            const TomlDocument document = readToml(toml);
            QCOMPARE(document.problem, std::string());
            const TomlEntry* entry = find(document, key.toStdString());
            QVERIFY(entry != nullptr);
            QCOMPARE(QString::fromStdString(textOf(*entry, toml)), text);
            QCOMPARE(entry->line, line);
        }
    }
    void kindsOfTables()
    {
        const TomlDocument document = readToml("[ a.b ]\nx = 1\n[run]\nd.e = 5\nin = { }\n");
        QCOMPARE(document.tables.size(), std::size_t{5});
        const auto kind = [&](std::string_view key) {
            for (const TomlTable& table : document.tables)
                if (table.key == key) return table.kind;
            return TomlTableKind::Dotted;
        };
        QCOMPARE(kind("a"), TomlTableKind::Dotted);
        QCOMPARE(kind("a.b"), TomlTableKind::Header);
        QCOMPARE(kind("run"), TomlTableKind::Header);
        QCOMPARE(kind("run.d"), TomlTableKind::Dotted);
        QCOMPARE(kind("run.in"), TomlTableKind::Inline);
    }
    void valuesHaveTheirType()
    {
        const TomlDocument document =
            readToml("a = true\nb = 7\nc = 7.0\nd = '7'\ne = 1970-01-01\nf = \"\"\"x\r\ny\"\"\"\n");
        QVERIFY(std::get<bool>(document.entries[0].value));
        QCOMPARE(std::get<std::int64_t>(document.entries[1].value), std::int64_t{7});
        QCOMPARE(std::get<double>(document.entries[2].value), 7.0);
        QCOMPARE(std::get<std::string>(document.entries[3].value), std::string("7"));
        QVERIFY(std::holds_alternative<std::monostate>(document.entries[4].value));
        QCOMPARE(std::get<std::string>(document.entries[5].value), std::string("x\ny"));
    }
    /// "springs.cutoff" = 1 at the root is not the cutoff of [springs].
    void keysWithDotsInsideAreTheirOwn()
    {
        QCOMPARE(readToml("\"springs.cutoff\" = 1").entries.at(0).key, std::string("\"springs.cutoff\""));
    }

    void refuses_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("says");
        QTest::addColumn<int>("line");
        QTest::newRow("a key twice") << QByteArray("a = 1\na = 2\n")
                                     << "is not TOML: cannot redefine existing integer 'a'" << 2;
        QTest::newRow("a table twice") << QByteArray("[a]\n\n[a]\n")
                                       << "is not TOML: cannot redefine existing table 'a'" << 3;
        QTest::newRow("a missing value") << QByteArray("a = 1\nb =\n") << "is not TOML: expected value, saw '\\n'" << 2;
        QTest::newRow("a unit without quotation marks") << QByteArray("\n\na = 7 nm\n")
                                                        << "is not TOML: expected a comment or whitespace, saw 'n'; a "
                                                           "value with a unit stands in quotation marks, as \"7 nm\""
                                                        << 3;
        QTest::newRow("a zero byte") << QByteArray("a = 1\0\n", 7) << "is not a text file" << 0;
        QTest::newRow("Latin-1") << QByteArray("a = 1\nb = '\xb5m'\n") << "is not valid UTF-8 text" << 2;
        QTest::newRow("an endless line") << QByteArray("\n") + QByteArray(30000, '#')
                                         << "a line is longer than 10000 bytes" << 2;
        QTest::newRow("a bottomless key") << QByteArray("a") + QByteArray(".a").repeated(300000) + "=1"
                                          << "a line is longer than 10000 bytes" << 1;
    }
    void refuses()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, says);
        QFETCH(int, line);
        const TomlDocument document = readToml(text.toStdString());
        QCOMPARE(QString::fromStdString(document.problem), says);
        QCOMPARE(document.problemLine, line);
        QVERIFY(document.entries.empty());
    }
    /// As deep as a line allows; what lies below the eighth level is one entry.
    void deepKeysAreRead()
    {
        const TomlDocument document =
            readToml(QByteArray("a").append(QByteArray(".a").repeated(4990)).append("=1").toStdString());
        QCOMPARE(document.problem, std::string());
        QCOMPARE(document.tables.size(), std::size_t{7});
        QCOMPARE(document.entries.at(0).key, std::string("a.a.a.a.a.a.a.a"));
    }

    void stringsReadBack()
    {
        for (const std::string& text : {std::string(""), std::string("a \"b\" \\ c"), std::string("line\nnext\ttab"),
                                        std::string("µ€𝛑"), std::string("\x01\x1f\x7f")}) {
            const TomlDocument document = readToml("a = " + tomlString(text));
            QCOMPARE(document.problem, std::string());
            QCOMPARE(std::get<std::string>(document.entries.at(0).value), text);
        }
    }
};

QTEST_GUILESS_MAIN(TestTomlDocument)
#include "test_toml_document.moc"

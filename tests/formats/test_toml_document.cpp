// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/toml_document.h"

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_toml_document {

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
        QCOMPARE(kind("a"), TomlTableKind::Implied);
        QCOMPARE(kind("a.b"), TomlTableKind::Header);
        QCOMPARE(kind("run"), TomlTableKind::Header);
        QCOMPARE(kind("run.d"), TomlTableKind::Dotted);
        QCOMPARE(kind("run.in"), TomlTableKind::Inline);
    }
    /// Tables of one name are counted from 1, whether they have headers or stand in a line.
    void arraysOfTables()
    {
        const std::string text =
            "[a]\nb = [{ x = 1 }, { x = 2 }]\n\n[[c.d]] # first\ny = 1\n\n[[ c.d ]]\n[c.d.e]\nz = 1\n";
        const TomlDocument document = readToml(text);
        QCOMPARE(document.problem, std::string());
        QStringList tables;
        for (const TomlTable& table : document.tables)
            tables << QString("%1 %2 %3").arg(table.key.c_str()).arg(static_cast<int>(table.kind)).arg(table.line);
        const auto row = [](const char* key, TomlTableKind kind, int line) {
            return QString("%1 %2 %3").arg(key).arg(static_cast<int>(kind)).arg(line);
        };
        using enum TomlTableKind;
        QCOMPARE(tables, (QStringList{row("a", Header, 1), row("a.b", Array, 2), row("a.b[1]", Inline, 2),
                                      row("a.b[2]", Inline, 2), row("c", Implied, 4), row("c.d", Array, 4),
                                      row("c.d[1]", Header, 4), row("c.d[2]", Header, 7), row("c.d[2].e", Header, 8)}));
        QStringList keys;
        for (const TomlEntry& entry : document.entries) keys << entry.key.c_str();
        QCOMPARE(keys, (QStringList{"a.b[1].x", "a.b[2].x", "c.d[1].y", "c.d[2].e.z"}));
        QCOMPARE(text.substr(document.tables[7].begin, document.tables[7].end - document.tables[7].begin),
                 std::string("[[ c.d ]]"));
    }
    /// A quoted key may look like one of them.
    void bracketsInKeysAreNoNumbers()
    {
        const TomlDocument document = readToml("[\"a[\"]\nx = 1\n[\"b[1]\"]\nx = 1\n");
        QCOMPARE(document.problem, std::string());
        QCOMPARE(document.tables.at(0).key, std::string("\"a[\""));
        QCOMPARE(document.tables.at(1).key, std::string("\"b[1]\""));
    }
    void arraysKeepTheLinesOfTheirElements()
    {
        const TomlDocument document = readToml("a = [1,\n '2 m', [3.5,\n true], {}, 1970-01-01]\n");
        const auto& elements = std::get<TomlArray>(document.entries.at(0).value).elements;
        QCOMPARE(elements.size(), std::size_t{5});
        QCOMPARE(std::get<std::int64_t>(elements[0].value), std::int64_t{1});
        QCOMPARE(std::get<std::string>(elements[1].value), std::string("2 m"));
        QCOMPARE(elements[1].line, 2);
        const auto& inner = std::get<TomlArray>(elements[2].value).elements;
        QCOMPARE(std::get<double>(inner.at(0).value), 3.5);
        QVERIFY(std::get<bool>(inner.at(1).value));
        QCOMPARE(inner.at(1).line, 3);
        QVERIFY(std::holds_alternative<std::monostate>(elements[3].value));
        QVERIFY(std::holds_alternative<std::monostate>(elements[4].value));
    }
    /// Arrays in arrays are looked into as deep as tables are.
    void deepArraysAreRead()
    {
        const TomlDocument document = readToml("a = " + std::string(100, '[') + std::string(100, ']'));
        QCOMPARE(document.problem, std::string());
        const TomlValue* value = &document.entries.at(0).value;
        int depth = 0;
        while (const auto* array = std::get_if<TomlArray>(value)) {
            ++depth;
            value = &array->elements.at(0).value;
        }
        QCOMPARE(depth, 7);
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
        QTest::newRow("a missing value") << QByteArray("a = 1\nb =\n")
                                         << "is not TOML: expected value, but the line ends" << 2;
        QTest::newRow("a missing quotation mark")
            << QByteArray("a = 1\nb = \"x\nc = 2\n") << "is not TOML: a quotation mark is missing" << 2;
        QTest::newRow("a unit without quotation marks") << QByteArray("\n\na = 7 nm\n")
                                                        << "is not TOML: expected a comment or whitespace, saw 'n'; "
                                                           "write a value with a unit in quotation marks, as \"7 nm\""
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

TOUCHDOWN_TEST(TestTomlDocument)

} // namespace test_toml_document

#include "test_toml_document.moc"

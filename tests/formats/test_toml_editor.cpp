// SPDX-License-Identifier: GPL-3.0-or-later
//
// How values get into a text. What case files do with it: tests/case_files/test_case_text.cpp and
// test_surface_text.cpp.
#include "core/formats/toml_editor.h"

#include <QTest>

#include <functional>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_toml_editor {

std::string edited(const std::string& text, const std::function<void(TomlEditor&)>& change)
{
    const TomlDocument toml = readToml(text);
    TomlEditor editor(text, toml);
    change(editor);
    return editor.result();
}

class TestTomlEditor : public QObject {
    Q_OBJECT

private slots:
    void nothingChangesNothing()
    {
        for (const std::string text : {"", "a = 1", "[a]\r\nb = 1\r\n"})
            QCOMPARE(edited(text, [](TomlEditor&) {}), text);
    }
    void knowsItsKeys()
    {
        const std::string text = "[a]\nb = 1\n";
        const TomlDocument toml = readToml(text);
        const TomlEditor editor(text, toml);
        QVERIFY(editor.has("a.b"));
        QVERIFY(!editor.has("a.c"));
    }
    void puts()
    {
        QCOMPARE(edited("a = 1 # one\nb = 2\n", [](TomlEditor& e) { e.put("a", "\"x\""); }),
                 std::string("a = \"x\" # one\nb = 2\n"));
        QCOMPARE(edited("[t]\na = 1 # one", [](TomlEditor& e) { e.put("t.b", "2"); }),
                 std::string("[t]\na = 1 # one\nb = 2"));
        QCOMPARE(edited("a = 1",
                        [](TomlEditor& e) {
                            e.put("t.b", "2");
                            e.put("t.c", "3");
                            e.put("u.d", "4");
                        }),
                 std::string("a = 1\n\n[t]\nb = 2\nc = 3\n\n[u]\nd = 4\n"));
    }
    void removesFromAnInlineTable()
    {
        const std::string text = "e = { a = 1, b = \"x\", c = 3 } # mine\nf = 2\n";
        const auto without = [](const char* key) { return [key](TomlEditor& e) { e.remove(key); }; };
        QCOMPARE(edited(text, without("e.a")), std::string("e = { b = \"x\", c = 3 } # mine\nf = 2\n"));
        QCOMPARE(edited(text, without("e.b")), std::string("e = { a = 1, c = 3 } # mine\nf = 2\n"));
        QCOMPARE(edited(text, without("e.c")), std::string("e = { a = 1, b = \"x\"} # mine\nf = 2\n"));
        QCOMPARE(edited("e = { a = [1,\n2] }\n", without("e.a")), std::string("e = {}\n"));
    }
    /// New keys of a table do not fall into the [[tables]] below it.
    void putsAboveArraysOfTables()
    {
        QCOMPARE(edited("[t]\na = 1\n[[t.row]]\nb = 2\n", [](TomlEditor& e) { e.put("t.c", "3"); }),
                 std::string("[t]\na = 1\nc = 3\n[[t.row]]\nb = 2\n"));
        QCOMPARE(edited("[t]\n[[t.row]]\nb = 2\n", [](TomlEditor& e) { e.put("t.c", "3"); }),
                 std::string("[t]\nc = 3\n[[t.row]]\nb = 2\n"));
        QCOMPARE(edited("[[t.row]]\nb = 2\n", [](TomlEditor& e) { e.put("t.c", "3"); }),
                 std::string("[[t.row]]\nb = 2\n\n[t]\nc = 3\n"));
        QCOMPARE(edited("[[t.row]]\nb = 2\n[[t.row]]\n",
                        [](TomlEditor& e) {
                            e.put("t.row[1].c", "3");
                            e.put("t.row[2].c", "4");
                        }),
                 std::string("[[t.row]]\nb = 2\nc = 3\n[[t.row]]\nc = 4\n"));
    }
    /// [disk.surface] is a table of its own, whatever comes first and however it is written.
    void putsIntoTablesInTables()
    {
        const auto both = [](TomlEditor& e) {
            e.put("a.x", "3");
            e.put("a.b.y", "4");
        };
        QCOMPARE(edited("[a]\nu = 1\n\n[a.b]\nv = 2\n", both),
                 std::string("[a]\nu = 1\nx = 3\n\n[a.b]\nv = 2\ny = 4\n"));
        QCOMPARE(edited("[a.b]\nv = 2\n\n[a]\nu = 1\n", both),
                 std::string("[a.b]\nv = 2\ny = 4\n\n[a]\nu = 1\nx = 3\n"));
        QCOMPARE(edited("[a.b]\nv = 2\n", both), std::string("[a.b]\nv = 2\ny = 4\n\n[a]\nx = 3\n"));
        QCOMPARE(edited("[a]\nu = 1\n", both), std::string("[a]\nu = 1\nx = 3\n\n[a.b]\ny = 4\n"));
        QCOMPARE(edited("[a]\nb.v = 2\n", both), std::string("[a]\nb.v = 2\nx = 3\nb.y = 4\n"));
        QCOMPARE(edited("a.b.v = 2\n", both), std::string("a.b.v = 2\na.x = 3\na.b.y = 4\n"));
        QCOMPARE(edited("[a]\nb = { v = 2 }\n", both), std::string("[a]\nb = { v = 2, y = 4 }\nx = 3\n"));
    }
    void removes()
    {
        const std::string text = "[t]\na = 1 # one\nb = 2\nc = 3\n";
        QCOMPARE(edited(text, [](TomlEditor& e) { e.remove("t.b"); }), std::string("[t]\na = 1 # one\nc = 3\n"));
        QCOMPARE(edited(text, [](TomlEditor& e) { e.remove("t.a"); }), std::string("[t]\nb = 2\nc = 3\n"));
        QCOMPARE(edited(text, [](TomlEditor& e) { e.remove("t.z"); }), text);
        QCOMPARE(edited("a = 1\nb = 2\n", [](TomlEditor& e) { e.remove("a"); }), std::string("b = 2\n"));
        QCOMPARE(edited("a = 1\r\nb = 2\r\nc = 3\r\n", [](TomlEditor& e) { e.remove("b"); }),
                 std::string("a = 1\r\nc = 3\r\n"));
        QCOMPARE(edited("a = 1\nb = 2", [](TomlEditor& e) { e.remove("b"); }), std::string("a = 1"));
        // A new last key where the last one goes.
        QCOMPARE(edited("[t]\na = 1\nb = 2\n[u]\n",
                        [](TomlEditor& e) {
                            e.remove("t.b");
                            e.put("t.c", "3");
                        }),
                 std::string("[t]\na = 1\nc = 3\n[u]\n"));
    }
    void tablesComeAndGo()
    {
        const std::string text = "# first\n[[r]]\na = 1\n\n# second\n[[r]] # two\na = 2 # x\n\n[u]\n";
        QCOMPARE(edited(text, [](TomlEditor& e) { e.removeTable("r", 2); }),
                 std::string("# first\n[[r]]\na = 1\n\n# second\n\n[u]\n"));
        QCOMPARE(edited(text, [](TomlEditor& e) { e.removeTable("r", 7); }), text);
        QCOMPARE(edited(text, [](TomlEditor& e) { e.insertTable("r", 0, "[[r]]\na = 0\n"); }),
                 std::string("# first\n[[r]]\na = 0\n\n[[r]]\na = 1\n\n# second\n[[r]] # two\na = 2 # x\n\n[u]\n"));
        QCOMPARE(edited(text, [](TomlEditor& e) { e.insertTable("r", 2, "[[r]]\na = 3\n"); }),
                 std::string("# first\n[[r]]\na = 1\n\n# second\n[[r]] # two\na = 2 # x\n\n[[r]]\na = 3\n\n[u]\n"));
        QCOMPARE(edited("b = 1", [](TomlEditor& e) { e.insertTable("r", 0, "[[r]]\na = 1\n"); }),
                 std::string("b = 1\n\n[[r]]\na = 1\n"));
        QCOMPARE(edited("[[r]]", [](TomlEditor& e) { e.insertTable("r", 1, "[[r]]\na = 1\n"); }),
                 std::string("[[r]]\n\n[[r]]\na = 1\n"));
    }
    void linesEndAsInTheText()
    {
        QCOMPARE(edited("a = 1\r\n", [](TomlEditor& e) { e.put("a", "[1,\n2]"); }), std::string("a = [1,\r\n2]\r\n"));
        QCOMPARE(edited("a = 1\r\n", [](TomlEditor& e) { e.insertTable("r", 0, "[[r]]\na = 1\n"); }),
                 std::string("a = 1\r\n\r\n[[r]]\r\na = 1\r\n"));
    }
};

TOUCHDOWN_TEST(TestTomlEditor)

} // namespace test_toml_editor

#include "test_toml_editor.moc"

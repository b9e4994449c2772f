// SPDX-License-Identifier: GPL-3.0-or-later
//
// Files and arguments of other people may hold what a terminal obeys: it is shown, and has no effect.
#include <QtTest>
#include <cstdlib>
#include <memory>

#include <fcntl.h>
#include <unistd.h>

#include "tests/support/command_process.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_console {

// Sets the window's title; red; the same as a single character of C1; what follows is shown from right to left.
const QByteArray hostile = "\x1b]0;pwn\x07\x1b[31m\u009b31m\u202e\u2066";
const QByteArray inToml = R"(\u001b]0;pwn\u0007\u001b[31m\u009b31m\u202e\u2066)";
// A title without the control characters that a case refuses in it.
const QByteArray title = R"(pwn\u009b31m\u202e\u2066)";

/// Whether a terminal finds anything but letters and line breaks.
bool obeys(const QByteArray& text)
{
    for (const char32_t code : QString::fromUtf8(text).toStdU32String())
        if ((code < 0x20 && code != '\n') || (code >= 0x7f && code < 0xa0) || (code >= 0x202a && code <= 0x202e) ||
            (code >= 0x2066 && code <= 0x2069) || code == QChar::ReplacementCharacter)
            return true;
    return false;
}

class TestConsole : public QObject {
    Q_OBJECT

private slots:
    void init() { folder_ = std::make_unique<CommandFolder>(); }

    void nothingIsObeyed_data()
    {
        QTest::addColumn<QByteArray>("file");
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<int>("code");
        const QString text = QString::fromUtf8(hostile);
        const auto row = [](const char* name, const QByteArray& file, const QStringList& arguments, int code) {
            QTest::newRow(name) << file << arguments << code;
        };
        row("title of a case", "title = \"" + title + "\"\n", {"run", "a.toml"}, 0);
        row("title of a film", "title = \"" + title + "\"\nmodel = \"film\"\n[steady]\nfixed_attitude = true\n",
            {"steady", "a.toml", "--set", "film.nodes=33,33", "initial.pitch=200 urad"}, 0);
        row("value of a case", "model = \"" + inToml + "\"\n", {"run", "a.toml"}, 2);
        row("key of a case", "\"" + inToml + "\" = 1\n", {"validate", "a.toml"}, 2);
        row("case of a study", "kind = \"hysteresis\"\ncase = \"" + inToml + "\"\n", {"study", "hysteresis", "a.toml"},
            2);
        row("value of a study", "kind = \"hysteresis\"\ncase = \"fig10a\"\nparameter = \"" + inToml + "\"\n",
            {"study", "hysteresis", "a.toml"}, 2);
        row("key of a method", "kind = \"work-precision\"\ncase = \"fig10a\"\n[[method]]\n\"" + inToml + "\" = 1\n",
            {"study", "work-precision", "a.toml"}, 2);
        row("title of a study", "kind = \"hysteresis\"\ncase = \"fig10a\"\nsteps = 3\ntitle = \"" + title + "\"\n",
            {"study", "hysteresis", "a.toml"}, 0);
        row("name of a case", "", {"run", text}, 2);
        row("name of a target", "", {"run", "fig10a", "--out", text + "/a"}, 2);
        row("setting", "", {"run", "fig10a", "--set", text + "=1"}, 2);
        row("option", "", {"run", "fig10a", "--" + text}, 2);
        row("command", "", {text}, 2);
        row("key to describe", "", {"describe", text}, 2);
    }
    void nothingIsObeyed()
    {
        QFETCH(const QByteArray, file);
        QFETCH(const QStringList, arguments);
        QFETCH(const int, code);
        QVERIFY(obeys(hostile));
        folder_->put("a.toml", file);
        const Outcome o = folder_->touchdown(arguments);
        QCOMPARE(o.code, code);
        QVERIFY2(!obeys(o.out), o.out);
        QVERIFY2(!obeys(o.err), o.err);
        QVERIFY2((o.out + o.err).contains(code == 0 ? "pwn\\u009b31m\\u202e\\u2066" : "pwn"), o.out + o.err);
        const Outcome asJson = folder_->touchdown(arguments + QStringList{"--json"});
        QCOMPARE(asJson.code, code);
        QVERIFY2(!obeys(asJson.out), asJson.out);
        QVERIFY(!asJson.json().isEmpty());
    }

    /// The escapes of JSON stand for the characters themselves.
    void jsonKeepsTheText()
    {
        folder_->put("a.toml", "title = \"" + title + "\"\n");
        const Outcome o = folder_->touchdown({"validate", "a.toml", "--json"});
        QCOMPARE(o.json()["title"].toString(), QStringLiteral("pwn\u009b31m\u202e\u2066"));
        QVERIFY(!obeys(o.out));
    }

    /// To a file or a pipe a study goes as it stands; to a terminal as anything else.
    void aTemplateIsExact()
    {
        const QByteArray study = "# " + hostile.mid(hostile.indexOf("\u202e")) +
                                 "\nkind = \"hysteresis\"\n"
                                 "case = \"fig10a\"\n";
        folder_->put("a.toml", study);
        const QStringList arguments{"study", "hysteresis", "a.toml", "--template"};
        QCOMPARE(folder_->touchdown(arguments).out, study);

        const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
        QVERIFY(terminal >= 0 && ::grantpt(terminal) == 0 && ::unlockpt(terminal) == 0);
        QProcess process;
        process.setWorkingDirectory(folder_->path());
        process.setStandardOutputFile(QString::fromLocal8Bit(::ptsname(terminal)), QIODevice::Append);
        process.start(TOUCHDOWN_COMMAND, arguments);
        QCOMPARE(outcome(process).code, 0);
        QByteArray shown(4096, '\0');
        shown.resize(std::max<qsizetype>(0, ::read(terminal, shown.data(), static_cast<std::size_t>(shown.size()))));
        ::close(terminal);
        QVERIFY2(shown.contains("\\u202e\\u2066"), shown);
        QVERIFY2(!obeys(shown.replace("\r\n", "\n")), shown);
    }

private:
    std::unique_ptr<CommandFolder> folder_;
};

TOUCHDOWN_TEST(TestConsole)

} // namespace test_console

#include "test_console.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The program `touchdown` in a folder of its own: arguments in; exit code, standard output and standard error out.
#pragma once

#include <QtTest>
#include <memory>

#include "core/case_files/case_file.h"

namespace touchdown {

struct Outcome {
    int code = -1;
    QByteArray out;
    QByteArray err;
    QJsonObject json() const { return QJsonDocument::fromJson(out).object(); }
    QList<QByteArray> errorLines() const
    {
        QList<QByteArray> lines = err.split('\n');
        lines.removeAll(QByteArray());
        return lines;
    }
};

/// Whether standard output is that of refused arguments or input: empty or, with --json, one object with the problems.
inline bool isRefusal(const Outcome& o, const QStringList& arguments)
{
    if (!arguments.contains(QStringLiteral("--json"))) return o.out.isEmpty();
    const QJsonObject json = o.json();
    return json["status"] == "wrong input" && !json["message"].toString().isEmpty() &&
           !json["problems"].toArray().isEmpty();
}

inline Outcome outcome(QProcess& process)
{
    if (!process.waitForFinished(100000) || process.exitStatus() != QProcess::NormalExit) return {};
    return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
}

inline QByteArray defaultCase()
{
    for (const SampleCase& sample : sampleCases())
        if (sample.name == defaultCaseName) return QByteArray::fromStdString(sample.text);
    return {};
}

// The default case with one line changed, and that line's number.
inline QByteArray changedCase(const QByteArray& key, const QByteArray& line, int& number)
{
    QList<QByteArray> lines = defaultCase().split('\n');
    for (number = 1; number <= lines.size(); ++number)
        if (lines[number - 1].startsWith(key)) {
            lines[number - 1] = line;
            break;
        }
    return lines.join('\n');
}

/// A folder in which the program runs.
class CommandFolder {
public:
    /// `environment` adds to that of the test: "COLUMNS=80".
    Outcome touchdown(const QStringList& arguments, const QStringList& environment = {}) const
    {
        QProcess process;
        process.setEnvironment(QProcess::systemEnvironment() + environment);
        process.setWorkingDirectory(folder_.path());
        process.start(TOUCHDOWN_COMMAND, arguments);
        return outcome(process);
    }
    QString path(const QString& name = {}) const { return folder_.filePath(name); }
    void put(const QString& name, const QByteArray& text) const
    {
        QFile file(path(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(text), text.size());
    }
    /// What is in the folder, in the order of the names.
    QStringList files() const { return QDir(folder_.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot); }

private:
    QTemporaryDir folder_;
};

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sessions/session_reader.h"

#include <exception>

#include <QDir>
#include <QFileInfo>

#include "ui/sessions/session_folder.h"

namespace touchdown {

namespace {

/// What the user's file of a result is, if it is what the session knew; nothing if it is another one or gone.
std::optional<FileIdentity> identityStill(const ListedState& entry)
{
    const std::optional<FileIdentity> known = identityFromText(entry.identity.toStdString());
    if (entry.file.isEmpty() || !known) return {};
    return fileNow(entry.file.toStdString(), *known) == FileNow::Same ? known : std::nullopt;
}

void readResult(LeftResult& result)
{
    if (result.inFolder && !result.entries.empty()) result.identity = identityStill(result.entries.front());
    // A session of the version before knows no identity.
    for (const ListedState& entry : result.entries)
        if (!result.inFolder && !entry.identity.isEmpty() && !identityStill(entry)) {
            result.problem = SessionReader::tr("%1 is no longer the file that the session knew: it was changed or "
                                               "replaced. It was not opened; its note is “%2”.")
                                 .arg(QDir::toNativeSeparators(result.file), entry.note);
            return;
        }
    if (result.inFolder && !isOwnFile(result.file)) { // a link, a directory, a device
        result.problem = SessionReader::tr("%1 is no regular file.").arg(QDir::toNativeSeparators(result.file));
        return;
    }
    switch (result.kind) {
    case LeftResult::Kind::Run: result.run = recordFromFile(result.numbers.front(), result.file, result.problem); break;
    case LeftResult::Kind::Solutions:
        result.solutions = readSolutions(result.file);
        result.problem = result.solutions.problem;
        break;
    case LeftResult::Kind::Study:
        result.report = readStudy(result.file.toStdString());
        result.problem = QString::fromStdString(result.report.problem);
        break;
    case LeftResult::Kind::Series:
        result.series = readSeries(result.file);
        result.problem = result.series.problem;
        break;
    }
}

} // namespace

int SessionReader::start(std::vector<std::shared_ptr<LeftResult>> results)
{
    return begin([this, results = std::move(results)](const std::stop_token& stop) {
        for (std::size_t i = 0; i < results.size() && !stop.stop_requested(); ++i) {
            Progress progress;
            progress.share = static_cast<double>(i) / static_cast<double>(results.size());
            progress.activity = "result " + std::to_string(i + 1) + " of " + std::to_string(results.size());
            mailbox_.post([&](Mail& mail) { mail.progress = std::move(progress); });
            try {
                readResult(*results[i]);
            } catch (const std::exception& problem) {
                results[i]->problem = QString::fromUtf8(problem.what());
            }
            mailbox_.waitForRoom(stop, [](const Mail& mail) { return !mail.result; });
            if (!stop.stop_requested()) mailbox_.post([&](Mail& mail) { mail.result = results[i]; });
        }
        mailbox_.waitForRoom(stop, [](const Mail& mail) { return !mail.result; });
        mailbox_.post([&](Mail& mail) {
            mail.finished = true;
            mail.stopped = stop.stop_requested();
        });
    });
}

void SessionReader::deliver()
{
    const Mail mail = mailbox_.take();
    if (mail.progress) emit progressed(current(), *mail.progress);
    if (mail.result) emit read(mail.result);
    if (!mail.finished) return;
    end();
    emit finished(mail.stopped);
}

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/session_state.h"

#include <algorithm>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>

#include "ui/lists/record_list.h"
#include "ui/style/translate.h"

namespace touchdown {

namespace {

QJsonObject caseToJson(const CaseState& state)
{
    QJsonObject entries;
    for (const auto& [key, text] : state.entries) entries[key] = text;
    return {{"name", state.name},     {"file", state.file},         {"sample", state.sample},
            {"import", state.import}, {"folder", state.folder},     {"saved_text", state.savedText},
            {"text", state.text},     {"modified", state.modified}, {"entries_not_taken", entries}};
}

CaseState caseFromJson(const QJsonObject& json)
{
    CaseState state;
    state.name = json["name"].toString();
    state.file = json["file"].toString();
    state.sample = json["sample"].toString();
    state.import = json["import"].toString();
    state.folder = json["folder"].toString();
    state.savedText = json["saved_text"].toString();
    state.text = json["text"].toString();
    state.modified = json["modified"].toBool();
    const QJsonObject entries = json["entries_not_taken"].toObject();
    for (auto entry = entries.begin(); entry != entries.end(); ++entry)
        state.entries[entry.key()] = entry.value().toString();
    return state;
}

QJsonArray listToJson(const std::vector<ListedState>& list)
{
    QJsonArray array;
    for (const ListedState& each : list)
        array << QJsonObject{{"number", each.number}, {"note", each.note},          {"file", each.file},
                             {"shown", each.shown},   {"under_way", each.underWay}, {"place", each.place}};
    return array;
}

std::vector<ListedState> listFromJson(const QJsonArray& array)
{
    std::vector<ListedState> list;
    for (const QJsonValue& value : array) {
        const QJsonObject json = value.toObject();
        list.push_back({json["number"].toInt(), json["note"].toString(), json["file"].toString(),
                        json["shown"].toBool(true), json["under_way"].toBool(), json["place"].toInt()});
    }
    return list;
}

/// Leaves out entries without a file, which ended before their first sample was on disk; adds files without an entry.
void matchFiles(std::vector<ListedState>& list, const QDir& folder, const QString& kind)
{
    const auto kept = [&](int number) { return folder.exists(QStringLiteral("%1%2.h5").arg(kind).arg(number)); };
    std::erase_if(list, [&](const ListedState& each) { return !kept(each.number) && !QFileInfo::exists(each.file); });
    const QRegularExpression pattern(QStringLiteral("^%1(\\d{1,9})\\.h5$").arg(kind));
    for (const QString& name : folder.entryList({kind + QStringLiteral("*.h5")}, QDir::Files)) {
        const QRegularExpressionMatch match = pattern.match(name);
        const int number = match.captured(1).toInt();
        if (match.hasMatch() && std::ranges::find(list, number, &ListedState::number) == list.end())
            list.push_back({.number = number, .note = {}, .file = {}});
    }
    std::ranges::sort(list, {}, &ListedState::number);
}

} // namespace

bool SessionState::empty() const { return !edited.modified && runs.empty() && solutions.empty(); }

std::vector<ListedState> statesOf(const RecordList& list, int underWay)
{
    std::vector<ListedState> states;
    for (int row = 0; row < list.count(); ++row) {
        const ListedRecord& each = list.listed(row);
        states.push_back({each.number, each.note, each.file, each.shown, each.number == underWay, each.place});
    }
    return states;
}

QByteArray toJson(const SessionState& state)
{
    const QJsonObject json{{"written", state.written.toString(Qt::ISODate)},
                           {"closed", state.closed},
                           {"case", caseToJson(state.edited)},
                           {"page", state.page},
                           {"runs", listToJson(state.runs)},
                           {"solutions", listToJson(state.solutions)}};
    return QJsonDocument(json).toJson();
}

std::optional<SessionState> readSession(const QString& folder)
{
    SessionState state;
    QFile file(folder + QStringLiteral("/session.json"));
    const bool found = file.open(QIODevice::ReadOnly);
    if (found) {
        const QJsonObject json = QJsonDocument::fromJson(file.readAll()).object();
        state.written = QDateTime::fromString(json["written"].toString(), Qt::ISODate);
        state.closed = json["closed"].toBool();
        state.edited = caseFromJson(json["case"].toObject());
        state.page = json["page"].toInt();
        state.runs = listFromJson(json["runs"].toArray());
        state.solutions = listFromJson(json["solutions"].toArray());
    } else {
        state.written = QFileInfo(folder).lastModified();
    }
    matchFiles(state.runs, QDir(folder), QStringLiteral("run"));
    matchFiles(state.solutions, QDir(folder), QStringLiteral("solution"));
    if (!found && state.empty()) return std::nullopt;
    return state;
}

QStringList studiesIn(const QString& folder)
{
    QStringList kinds;
    for (const QString& name : QDir(folder).entryList({QStringLiteral("study-*.h5")}, QDir::Files, QDir::Name))
        kinds << name.mid(6).chopped(3);
    return kinds;
}

QString describe(const SessionState& state, const QStringList& studies)
{
    QStringList parts;
    if (state.edited.modified) parts << tr("the case %1 with its edits").arg(state.edited.name);
    const auto count = std::ssize(state.runs);
    const auto interrupted = std::ranges::count(state.runs, true, &ListedState::underWay);
    if (count == 1) parts << (interrupted == 1 ? tr("1 run, which was interrupted") : tr("1 run"));
    if (count > 1)
        parts << (interrupted == 0 ? tr("%1 runs").arg(count)
                                   : tr("%1 runs (%2 was interrupted)").arg(count).arg(interrupted));
    if (state.solutions.size() == 1) parts << tr("1 static solution");
    if (state.solutions.size() > 1) parts << tr("%1 static solutions").arg(state.solutions.size());
    if (studies.size() == 1) parts << tr("1 study report");
    if (studies.size() > 1) parts << tr("%1 study reports").arg(studies.size());
    return parts.join(QStringLiteral(", "));
}

} // namespace touchdown

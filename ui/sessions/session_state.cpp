// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sessions/session_state.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>

#include "core/formats/text_file.h"
#include "ui/lists/record_list.h"
#include "ui/sessions/session_folder.h"
#include "ui/style/foreign_text.h"
#include "ui/style/translate.h"

namespace touchdown {

namespace {

constexpr int version = 1; // of the file; a higher one is not understood
constexpr int mostNumber = 999'999'999;
constexpr qsizetype mostEntries = 10'000; // of a list; each is compared with all others

QJsonObject caseToJson(const CaseState& state)
{
    QJsonObject entries;
    for (const auto& [key, text] : state.entries) entries[key] = text;
    return {{"name", state.name},
            {"file", state.file},
            {"sample", state.sample},
            {"import", state.import},
            {"origin", state.origin},
            {"folder", state.folder},
            {"saved_text", state.savedText},
            {"text", state.text},
            {"modified", state.modified},
            {"entries_not_taken", entries}};
}

/// Reads the fields of an object. A field that is missing has its default; one of another type is a problem.
class JsonFields {
public:
    JsonFields(QJsonObject json, QString& problem) : json_(std::move(json)), problem_(problem) {}

    QString text(const char* key) const { return of(key, QJsonValue::String).toString(); }
    bool truth(const char* key, bool otherwise = false) const { return of(key, QJsonValue::Bool).toBool(otherwise); }
    int number(const char* key, int least, int most) const
    {
        const QJsonValue value = of(key, QJsonValue::Double);
        const double number = value.toDouble(least);
        if (!(number >= least && number <= most && number == std::floor(number))) refuse(key);
        return value.toInt(least);
    }
    QJsonObject object(const char* key) const { return of(key, QJsonValue::Object).toObject(); }
    JsonFields fields(const char* key) const { return {object(key), problem_}; }
    std::vector<JsonFields> list(const char* key) const
    {
        std::vector<JsonFields> all;
        const QJsonArray array = of(key, QJsonValue::Array).toArray();
        if (array.size() > mostEntries) {
            refuse(key);
            return all;
        }
        for (const QJsonValue& each : array) {
            if (!each.isObject()) refuse(key);
            all.emplace_back(each.toObject(), problem_);
        }
        return all;
    }
    bool has(const char* key) const { return json_.contains(QLatin1String(key)); }
    void refuse(const char* key) const { problem_ = tr("“%1” in it is not understood").arg(QLatin1String(key)); }

private:
    QJsonValue of(const char* key, QJsonValue::Type type) const
    {
        const QJsonValue value = json_[QLatin1String(key)];
        if (!value.isUndefined() && value.type() != type) refuse(key);
        return value;
    }

    QJsonObject json_;
    QString& problem_;
};

CaseState caseFromJson(const JsonFields& json)
{
    CaseState state;
    state.name = json.text("name");
    state.file = json.text("file");
    state.sample = json.text("sample");
    state.import = json.text("import");
    state.origin = json.text("origin");
    state.folder = json.text("folder");
    state.savedText = json.text("saved_text");
    state.text = json.text("text");
    state.modified = json.truth("modified");
    const QJsonObject entries = json.object("entries_not_taken");
    for (auto entry = entries.begin(); entry != entries.end(); ++entry) {
        if (!entry.value().isString()) json.refuse("entries_not_taken");
        state.entries[entry.key()] = entry.value().toString();
    }
    return state;
}

QJsonArray listToJson(const std::vector<ListedState>& list)
{
    QJsonArray array;
    for (const ListedState& each : list)
        array << QJsonObject{{"number", each.number}, {"note", each.note},         {"identity", each.identity},
                             {"file", each.file},     {"shown", each.shown},       {"place", each.place},
                             {"from", each.from},     {"under_way", each.underWay}};
    return array;
}

std::vector<ListedState> listFromJson(const JsonFields& state, const char* key)
{
    std::vector<ListedState> list;
    for (const JsonFields& json : state.list(key)) {
        const int number = json.number("number", 1, mostNumber);
        if (std::ranges::find(list, number, &ListedState::number) != list.end()) json.refuse("number");
        list.push_back({.number = number,
                        .note = json.text("note"),
                        .file = json.text("file"),
                        .identity = json.text("identity"),
                        .shown = json.truth("shown", true),
                        .underWay = json.truth("under_way"),
                        .place = json.number("place", 0, mostNumber),
                        .from = json.number("from", 0, mostNumber)});
    }
    return list;
}

QJsonArray draftsToJson(const std::vector<StudyDraft>& drafts)
{
    QJsonArray array;
    for (const StudyDraft& each : drafts)
        array << QJsonObject{{"kind", each.kind},
                             {"text", each.text},
                             {"saved_text", each.saved},
                             {"file", each.file},
                             {"identity", QString::fromStdString(each.identity.text())}};
    return array;
}

SessionState notUnderstood(const QString& reason)
{
    SessionState state;
    state.notUnderstood = reason;
    return state;
}

/// What the bytes of a state say; only `notUnderstood` when they are not those of a state.
SessionState stateFromJson(const QByteArray& bytes)
{
    SessionState state;
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(bytes, &error);
    if (!document.isObject())
        return notUnderstood(error.error == QJsonParseError::NoError ? tr("it holds no object")
                                                                     : tr("it is damaged or cut off"));
    QString problem;
    const JsonFields json(document.object(), problem);
    for (const char* key : {"case", "runs", "solutions"})
        if (!json.has(key)) problem = tr("“%1” is missing in it").arg(QLatin1String(key));
    if (json.number("version", 1, mostNumber) > version) {
        state.newer = true;
        state.notUnderstood = tr("it is of a newer version of the program");
        return state;
    }
    state.written = QDateTime::fromString(json.text("written"), Qt::ISODate);
    state.closed = json.truth("closed");
    state.edited = caseFromJson(json.fields("case"));
    state.page = json.number("page", 0, 2);
    state.runs = listFromJson(json, "runs");
    state.solutions = listFromJson(json, "solutions");
    for (const JsonFields& draft : json.list("studies"))
        state.drafts.push_back({draft.text("kind"), draft.text("text"), draft.text("saved_text"), draft.text("file"),
                                identityFromText(draft.text("identity").toStdString()).value_or(FileIdentity{})});
    if (json.has("modes") && !(state.modes = modesFromJson(json.object("modes")))) json.refuse("modes");
    state.study = json.text("study");
    state.studyUnderWay = json.text("study_under_way");
    state.restoring = json.text("restoring");
    return problem.isEmpty() ? state : notUnderstood(problem);
}

/// The state in a file, which may be anything.
SessionState stateIn(const QString& file)
{
    if (QFileInfo(file).isSymbolicLink()) return notUnderstood(tr("it is a symbolic link"));
    const auto content = readTextFile(file.toStdString(), largestState, FileContent::Text);
    if (const auto* problem = std::get_if<FileProblem>(&content))
        return notUnderstood(tr("it %1").arg(QString::fromStdString(problem->message)));
    return stateFromJson(QByteArray::fromStdString(std::get<std::string>(content)));
}

/// Leaves out entries without a file, which ended before their first sample was on disk; adds files without an entry.
/// `earlier`: a folder from which entries still arrive; empty: none.
void matchFiles(std::vector<ListedState>& list, const QString& folder, const QString& earlier, const QString& kind)
{
    const auto kept = [&kind](const QString& where, int number) { // whatever it is: why it is not restored is said
        return liesAt(QStringLiteral("%1/%2%3.h5").arg(where, kind).arg(number));
    };
    std::erase_if(list, [&](const ListedState& each) {
        const bool arrives = !earlier.isEmpty() && each.from > 0 && kept(earlier, each.from);
        const bool noted = !each.file.isEmpty() && !each.note.isEmpty(); // its note is nowhere else
        return !arrives && !noted && !kept(folder, each.number) && !QFileInfo::exists(each.file);
    });
    const QRegularExpression pattern(QStringLiteral("^%1([1-9]\\d{0,8})\\.h5$").arg(kind));
    for (const QString& name : ownFiles(folder)) {
        const QRegularExpressionMatch match = pattern.match(name);
        const int number = match.captured(1).toInt();
        if (match.hasMatch() && std::ranges::find(list, number, &ListedState::number) == list.end())
            list.push_back({.number = number, .note = {}, .file = {}, .identity = {}});
    }
    std::ranges::sort(list, {}, &ListedState::number);
}

} // namespace

bool SessionState::empty() const
{
    return !edited.modified && runs.empty() && solutions.empty() && drafts.empty() && !modes && !series &&
           reports.isEmpty();
}

std::vector<ListedState> statesOf(const RecordList& list, int underWay)
{
    std::vector<ListedState> states;
    for (int row = 0; row < list.count(); ++row) {
        const ListedRecord& each = list.listed(row);
        states.push_back({.number = each.number,
                          .note = each.note,
                          .file = each.file,
                          .identity = each.identity ? QString::fromStdString(each.identity->text()) : QString(),
                          .shown = each.shown,
                          .underWay = each.number == underWay,
                          .place = each.place});
    }
    return states;
}

QByteArray toJson(const SessionState& state)
{
    QJsonObject json{{"version", version},
                     {"written", state.written.toString(Qt::ISODate)},
                     {"closed", state.closed},
                     {"case", caseToJson(state.edited)},
                     {"page", state.page},
                     {"runs", listToJson(state.runs)},
                     {"solutions", listToJson(state.solutions)},
                     {"studies", draftsToJson(state.drafts)},
                     {"study", state.study},
                     {"study_under_way", state.studyUnderWay},
                     {"restoring", state.restoring}};
    if (state.modes) json["modes"] = toJson(*state.modes);
    return QJsonDocument(json).toJson();
}

SessionState readSession(const QString& folder)
{
    const QString file = folder + QStringLiteral("/session.json");
    SessionState state = liesAt(file) ? stateIn(file) : SessionState{};
    if (!state.written.isValid()) state.written = QFileInfo(folder).lastModified();
    const QString earlier = state.restoring.isEmpty() ? QString() : earlierFolder(folder, state.restoring);
    matchFiles(state.runs, folder, earlier, QStringLiteral("run"));
    matchFiles(state.solutions, folder, earlier, QStringLiteral("solution"));
    for (const QString& name : ownFiles(folder)) {
        if (name == QLatin1String("series.h5")) state.series = true;
        if (name.startsWith(QLatin1String("study-")) && name.endsWith(QLatin1String(".h5")))
            state.reports << name.mid(6).chopped(3);
    }
    return state;
}

std::vector<EndedSession> endedSessions()
{
    using Time = std::pair<qint64, QString>; // [ms since 1970]; the name decides between equal ones
    std::vector<std::pair<Time, EndedSession>> all;
    const QDateTime now = QDateTime::currentDateTimeUtc();
    for (const QString& path : SessionFolder::ended()) {
        EndedSession session{path, readSession(path)};
        Time time(0, path);
        for (const QDateTime& each :
             {QFileInfo(path + QStringLiteral("/session.json")).lastModified(), session.state.written})
            if (each.isValid() && each <= now) time.first = each.toMSecsSinceEpoch();
        all.emplace_back(std::move(time), std::move(session));
    }
    std::ranges::sort(all, std::ranges::greater(), [](const auto& each) -> const Time& { return each.first; });
    std::vector<EndedSession> sorted;
    for (auto& each : all) sorted.push_back(std::move(each.second));
    return sorted;
}

QString earlierFolder(const QString& folder, const QString& name)
{
    return QFileInfo(QFileInfo(folder).dir(), QFileInfo(name).fileName()).filePath();
}

QString describe(const SessionState& state)
{
    QStringList parts;
    const auto add = [&parts](auto count, const QString& one, const QString& more) {
        if (count > 0) parts << (count == 1 ? one : more.arg(count));
    };
    if (state.edited.modified) parts << tr("the case %1 with its edits").arg(inOneLine(state.edited.name));
    const auto interrupted = std::ranges::count(state.runs, true, &ListedState::underWay);
    if (interrupted == 0)
        add(state.runs.size(), tr("1 run"), tr("%1 runs"));
    else
        add(state.runs.size(), tr("1 run, which was interrupted"), tr("%2 runs (%1 was interrupted)").arg(interrupted));
    add(state.solutions.size(), tr("1 static solution"), tr("%1 static solutions"));
    if (state.series) parts << tr("1 series of static states");
    if (state.modes) parts << tr("modes");
    add(state.drafts.size(), tr("the edited text of 1 study"), tr("the edited texts of %1 studies"));
    if (state.reports.contains(state.studyUnderWay))
        add(state.reports.size(), tr("1 study, interrupted"), tr("%1 study reports (1 was interrupted)"));
    else
        add(state.reports.size(), tr("1 study report"), tr("%1 study reports"));
    return parts.join(QStringLiteral(", "));
}

} // namespace touchdown

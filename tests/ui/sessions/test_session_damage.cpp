// SPDX-License-Identifier: GPL-3.0-or-later
//
// The folder of a session that broke off is damaged in many ways, as by a full disk, another version or another
// program. The next start never removes what the program did not write, and loses nothing that it did.
#include "ui/sessions/session_offer.h"

#include <functional>
#include <map>
#include <random>

#include <sys/stat.h>

#include <QDir>
#include <QDirIterator>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QtTest>

#include "tests/support/test_program.h"
#include "ui/sessions/session_folder.h"
#include "ui/sessions/session_state.h"

using namespace touchdown;

namespace test_session_damage {

/// Every path below a folder with what it is: the bytes of a file, the target of a link.
using Content = std::map<QString, QByteArray>;

class TestSessionDamage : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void cleanup();
    void keepsWhatIsNotUnderstood_data();
    void keepsWhatIsNotUnderstood();
    void leavesWhatIsNoSession_data();
    void leavesWhatIsNoSession();
    void offersASessionWithoutALock();
    void offersTheSessionThatWasWrittenLast_data();
    void offersTheSessionThatWasWrittenLast();
    void leavesTheSessionOfANewerVersion();
    void keepsTheNoteOfARunWhoseFileIsGone();
    void readsWhatItWrites();
    void readsTheStateOfTheVersionBefore();
    void countsAndRemovesOnlyItsOwnFiles();

private:
    using Damage = std::function<void(TestSessionDamage&)>;
    static SessionState sampleState();
    static std::vector<std::pair<QString, Damage>> damages();
    static Content contentOf(const QString& folder);
    static void write(const QString& path, const QByteArray& bytes);
    static QByteArray read(const QString& path);
    QString file(const QString& name) const { return folder_ + QLatin1Char('/') + name; }
    QString state() const { return file(QStringLiteral("session.json")); }
    void become(const QByteArray& bytes) const { write(state(), bytes); }
    void set(const char* key, const QJsonValue& value) const
    {
        QJsonObject json = QJsonDocument::fromJson(read(state())).object();
        json[QLatin1String(key)] = value;
        become(QJsonDocument(json).toJson());
    }
    void setRun(const char* key, const QJsonValue& value) const
    {
        QJsonObject run{{"number", 1}, {"note", "the best"}};
        run[QLatin1String(key)] = value;
        set("runs", QJsonArray{run});
    }
    void link(const QString& name, const QString& target) const
    {
        QFile::remove(file(name));
        QVERIFY(QFile::link(target, file(name)));
    }
    void fifo(const QString& name) const
    {
        QFile::remove(file(name));
        QCOMPARE(::mkfifo(qPrintable(file(name)), 0600), 0);
    }

    std::unique_ptr<QTemporaryDir> data_;
    QString folder_;  // of the session
    QString foreign_; // a folder of another program
};

void TestSessionDamage::initTestCase()
{
    QCoreApplication::setOrganizationName(QStringLiteral("touchdown"));
    QCoreApplication::setApplicationName(QStringLiteral("test_session_damage"));
}

void TestSessionDamage::init()
{
    data_ = std::make_unique<QTemporaryDir>();
    qputenv("XDG_DATA_HOME", data_->path().toLocal8Bit());
    foreign_ = data_->filePath(QStringLiteral("foreign"));
    QVERIFY(QDir().mkpath(foreign_ + QStringLiteral("/below")));
    for (const char* name : {"lock", "session.json", "run1.h5", "below/letter.txt"})
        write(foreign_ + QLatin1Char('/') + QLatin1String(name), "of another program");
    QString problem;
    const std::unique_ptr<SessionFolder> folder = SessionFolder::create(problem);
    QCOMPARE(problem, QString());
    folder_ = folder->path();
    become(toJson(sampleState()));
    for (const char* name : {"run1.h5", "run3.h5", "solution2.h5", "study-cycles.h5"})
        write(file(QLatin1String(name)), QByteArray("results of ") + name);
}

void TestSessionDamage::cleanup()
{
    data_.reset();
    qunsetenv("XDG_DATA_HOME");
}

SessionState TestSessionDamage::sampleState()
{
    SessionState state;
    state.written = QDateTime::currentDateTimeUtc();
    state.edited.name = state.edited.sample = QStringLiteral("fig10a");
    state.edited.savedText = QStringLiteral("[springs]\n");
    state.edited.text = QStringLiteral("[springs]\nflying_height = \"4.321 nm\" # an hour of thought\n");
    state.edited.modified = true;
    state.runs = {{.number = 1, .note = QStringLiteral("the best"), .file = {}, .identity = {}},
                  {.number = 3, .note = QStringLiteral("the worst"), .file = {}, .identity = {}}};
    state.solutions = {{.number = 2, .note = QStringLiteral("flies"), .file = {}, .identity = {}}};
    state.drafts = {{QStringLiteral("cycles"), QStringLiteral("steps = 77\n"), QStringLiteral("steps = 7\n"), {}}};
    return state;
}

void TestSessionDamage::write(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    QVERIFY2(file.open(QIODevice::WriteOnly), qPrintable(path));
    QCOMPARE(file.write(bytes), bytes.size());
}

QByteArray TestSessionDamage::read(const QString& path)
{
    QFile file(path);
    return isOwnFile(path) && file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

Content TestSessionDamage::contentOf(const QString& folder)
{
    Content content;
    QDirIterator each(folder, QDir::AllEntries | QDir::System | QDir::Hidden | QDir::NoDotAndDotDot,
                      QDirIterator::Subdirectories);
    while (each.hasNext()) {
        const QFileInfo info(each.next());
        QByteArray what = "special";
        if (info.isSymbolicLink())
            what = "link to " + info.symLinkTarget().toUtf8();
        else if (info.isDir())
            what = "folder";
        else if (info.isFile()) {
            QFile file(info.filePath());
            what = file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("unreadable");
        }
        content[info.filePath()] = what;
    }
    return content;
}

std::vector<std::pair<QString, TestSessionDamage::Damage>> TestSessionDamage::damages()
{
    using T = TestSessionDamage;
    const auto bytes = [](const QByteArray& text) { return [text](T& t) { t.become(text); }; };
    const auto field = [](const char* key, const QJsonValue& value) { return [=](T& t) { t.set(key, value); }; };
    const auto run = [](const char* key, const QJsonValue& value) { return [=](T& t) { t.setRun(key, value); }; };
    std::vector<std::pair<QString, Damage>> all{
        {"empty", bytes({})},
        {"an object without fields", bytes("{}")},
        {"an array", bytes("[1, 2]")},
        {"null", bytes("null")},
        {"no JSON", bytes("flying_height = 4\n")},
        {"zero bytes", bytes(QByteArray(5000, '\0'))},
        {"blanks", bytes(QByteArray(qsizetype(largestState) + 1, ' '))},
        {"deep", bytes(QByteArray(100'000, '[') + QByteArray(100'000, ']'))},
        {"deep in a field", bytes("{\"case\":" + QByteArray(100'000, '[') + QByteArray(100'000, ']') + "}")},
        {"version -1", field("version", -1)},
        {"version a text", field("version", "1")},
        {"case a number", field("case", 4)},
        {"case a list", field("case", QJsonArray{})},
        {"case missing", field("case", QJsonValue::Undefined)},
        {"text of the case a number", field("case", QJsonObject{{"text", 4}})},
        {"entries a list", field("case", QJsonObject{{"entries_not_taken", QJsonArray{}}})},
        {"entry a number", field("case", QJsonObject{{"entries_not_taken", QJsonObject{{"slider.mass", 4}}}})},
        {"runs an object", field("runs", QJsonObject{})},
        {"runs missing", field("runs", QJsonValue::Undefined)},
        {"runs of texts", field("runs", QJsonArray{"1", "3"})},
        {"solutions null", field("solutions", QJsonValue::Null)},
        {"studies a text", field("studies", "steps = 77\n")},
        {"text of a study a list", field("studies", QJsonArray{QJsonObject{{"text", QJsonArray{}}}})},
        {"page 1e99", field("page", 1e99)},
        {"page -1", field("page", -1)},
        {"closed a text", field("closed", "yes")},
        {"time a number", field("written", 20261128)},
        {"number 1e99", run("number", 1e99)},
        {"number -1", run("number", -1)},
        {"number 0", run("number", 0)},
        {"number 1.5", run("number", 1.5)},
        {"number a text", run("number", "1")},
        {"place -1", run("place", -1)},
        {"note a list", run("note", QJsonArray{"the best"})},
        {"note of 5 MB", run("note", QString(5'000'000, u'x'))},
        {"shown a number", run("shown", 1)},
        {"one number twice", field("runs", QJsonArray{QJsonObject{{"number", 1}}, QJsonObject{{"number", 1}}})},
        {"a FIFO", [](T& t) { t.fifo(QStringLiteral("session.json")); }},
        {"a directory",
         [](T& t) { QVERIFY(QFile::remove(t.state()) && QDir().mkpath(t.state() + QStringLiteral("/below"))); }},
        {"a link to a file",
         [](T& t) { t.link(QStringLiteral("session.json"), t.foreign_ + QStringLiteral("/session.json")); }},
        {"a link to zeros", [](T& t) { t.link(QStringLiteral("session.json"), QStringLiteral("/dev/zero")); }},
        {"a link to a folder", [](T& t) { t.link(QStringLiteral("session.json"), t.foreign_); }},
        {"a link to nothing", [](T& t) { t.link(QStringLiteral("session.json"), QStringLiteral("/no/such/file")); }},
    };
    std::mt19937 random(20261128);
    const auto whole = static_cast<int>(toJson(sampleState()).size());
    for (int i = 0; i < 40; ++i) {
        const int place = std::uniform_int_distribution<int>(0, whole - 3)(random); // behind it stand "}" and a newline
        all.emplace_back(QStringLiteral("cut at %1").arg(place),
                         [place](T& t) { t.become(read(t.state()).first(place)); });
    }
    return all;
}

void TestSessionDamage::keepsWhatIsNotUnderstood_data()
{
    QTest::addColumn<int>("which");
    const auto all = damages();
    for (std::size_t i = 0; i < all.size(); ++i) QTest::addRow("%s", qPrintable(all[i].first)) << static_cast<int>(i);
}

void TestSessionDamage::keepsWhatIsNotUnderstood()
{
    QFETCH(const int, which);
    damages()[static_cast<std::size_t>(which)].second(*this);
    // Files of others beside those of the session.
    write(file(QStringLiteral("letter.txt")), "mine");
    write(file(QStringLiteral("run1.h5.bak")), "mine");
    QVERIFY(QDir().mkpath(file(QStringLiteral("photos"))));
    write(file(QStringLiteral("photos/one.png")), "mine");
    Content before = contentOf(data_->path());
    const QString aside = file(QStringLiteral("session-not-understood.json"));

    keepSessionsWithin(0);
    QVERIFY(contentOf(data_->path()) == before);
    QStringList remarks;
    std::unique_ptr<SessionFolder> offered = newestBrokenOff(remarks);
    QVERIFY(offered);
    QCOMPARE(remarks.size(), 1);
    QVERIFY2(remarks.front().contains(aside), qPrintable(remarks.front()));
    // The state has another name; all else is as it was.
    const auto renamed = [&](const Content& content) {
        Content result;
        for (const auto& [path, what] : content)
            result[path.startsWith(state()) ? aside + path.mid(state().size()) : path] = what;
        return result;
    };
    before = renamed(before);
    QVERIFY(contentOf(data_->path()) == before);
    const SessionState left = readSession(folder_);
    QCOMPARE(describe(left), QStringLiteral("2 runs, 1 static solution, 1 study report"));

    SessionFolder::remove(std::move(offered)); // Discard
    for (const char* name : {"run1.h5", "run3.h5", "solution2.h5", "study-cycles.h5", "lock"})
        QCOMPARE(before.erase(file(QLatin1String(name))), std::size_t(1));
    QVERIFY(contentOf(data_->path()) == before);
    remarks.clear();
    QVERIFY(!newestBrokenOff(remarks)); // it is no session any more
    QVERIFY(remarks.isEmpty());
    QVERIFY(contentOf(data_->path()) == before);
}

void TestSessionDamage::leavesWhatIsNoSession_data()
{
    QTest::addColumn<QString>("what");
    for (const char* what : {"a link to a foreign folder", "another name", "lock a link", "lock a FIFO",
                             "lock a directory", "lock with text"})
        QTest::addRow("%s", what) << QString::fromLatin1(what);
}

void TestSessionDamage::leavesWhatIsNoSession()
{
    QFETCH(const QString, what);
    const QString lock = file(QStringLiteral("lock"));
    if (what == QLatin1String("a link to a foreign folder")) {
        QVERIFY(QDir(folder_).removeRecursively());
        QVERIFY(QFile::remove(foreign_ + QStringLiteral("/lock")));
        write(foreign_ + QStringLiteral("/lock"), {}); // as an empty lock of another program
        QVERIFY(QFile::link(foreign_, folder_));
    } else if (what == QLatin1String("another name")) {
        QVERIFY(QDir().rename(folder_, folder_ + QStringLiteral("-copy")));
    } else {
        QVERIFY(QFile::remove(lock));
        if (what.endsWith(QLatin1String("link"))) QVERIFY(QFile::link(foreign_ + QStringLiteral("/lock"), lock));
        if (what.endsWith(QLatin1String("FIFO"))) fifo(QStringLiteral("lock"));
        if (what.endsWith(QLatin1String("directory"))) QVERIFY(QDir().mkpath(lock));
        if (what.endsWith(QLatin1String("text"))) write(lock, "mine");
    }
    const Content before = contentOf(data_->path());
    QStringList remarks;
    QVERIFY(!newestBrokenOff(remarks));
    // What is a session and cannot be taken is said.
    QCOMPARE(remarks.size(), what.startsWith(QLatin1String("lock")) ? 1 : 0);
    QVERIFY2(remarks.isEmpty() || remarks.front().contains(folder_), qPrintable(remarks.join(u' ')));
    keepSessionsWithin(0);
    QVERIFY(contentOf(data_->path()) == before);
}

/// A lock that a copy of the folder lost is made anew.
void TestSessionDamage::offersASessionWithoutALock()
{
    QVERIFY(QFile::remove(file(QStringLiteral("lock"))));
    QStringList remarks;
    QVERIFY(newestBrokenOff(remarks));
}

/// Names of folders and times of states, as clocks leave them that were set.
void TestSessionDamage::offersTheSessionThatWasWrittenLast_data()
{
    QTest::addColumn<QString>("name"); // of the folder of the older session
    QTest::addColumn<qint64>("age");   // of its state [s]
    QTest::newRow("in their order") << "20200101-000000-000-1" << qint64(3600);
    QTest::newRow("an older one with a later name") << "20990101-000000-000-1" << qint64(3600);
    QTest::newRow("an older one of a time to come") << "20990101-000000-000-1" << qint64(-100'000'000);
    QTest::newRow("of the same time, by the name") << "20200101-000000-000-1" << qint64(0);
}

void TestSessionDamage::offersTheSessionThatWasWrittenLast()
{
    QFETCH(const QString, name);
    QFETCH(const qint64, age);
    const QString older = QFileInfo(folder_).dir().filePath(name);
    QVERIFY(QDir().mkpath(older));
    const QDateTime now = QDateTime::currentDateTimeUtc();
    SessionState state = sampleState();
    state.written = now.addSecs(-age);
    write(older + QStringLiteral("/session.json"), toJson(state));
    QFile stateFile(older + QStringLiteral("/session.json"));
    QVERIFY(stateFile.open(QIODevice::ReadWrite));
    QVERIFY(stateFile.setFileTime(now.addSecs(-3600), QFileDevice::FileModificationTime));
    state.written = now;
    become(toJson(state));
    const std::vector<EndedSession> ended = endedSessions();
    QCOMPARE(ended.size(), std::size_t(2));
    QCOMPARE(ended.front().path, folder_);
    QStringList remarks;
    const std::unique_ptr<SessionFolder> offered = newestBrokenOff(remarks);
    QVERIFY(offered);
    QCOMPARE(offered->path(), folder_);
}

/// Only that version can take all of it.
void TestSessionDamage::leavesTheSessionOfANewerVersion()
{
    set("version", 2);
    const Content before = contentOf(data_->path());
    QStringList remarks;
    QVERIFY(!newestBrokenOff(remarks));
    QCOMPARE(remarks.size(), 1);
    QVERIFY2(remarks.front().contains(folder_), qPrintable(remarks.front()));
    QVERIFY(contentOf(data_->path()) == before);
}

/// Its note is nowhere else: a disk that is not there may come back.
void TestSessionDamage::keepsTheNoteOfARunWhoseFileIsGone()
{
    SessionState state;
    state.runs = {
        {.number = 1, .note = QStringLiteral("the best"), .file = QStringLiteral("/media/gone/a.h5"), .identity = {}}};
    for (const char* name : {"run1.h5", "run3.h5", "solution2.h5", "study-cycles.h5"})
        QVERIFY(QFile::remove(file(QLatin1String(name))));
    become(toJson(state));
    QStringList remarks;
    QVERIFY(newestBrokenOff(remarks));
    QCOMPARE(readSession(folder_).runs.front().note, QStringLiteral("the best"));
}

void TestSessionDamage::readsWhatItWrites()
{
    const SessionState state = sampleState();
    const SessionState back = readSession(folder_);
    QCOMPARE(back.notUnderstood, QString());
    QCOMPARE(toJson(back), toJson(state));
    // 300 runs with notes of a page, and a large case.
    SessionState large = state;
    large.edited.text = large.edited.savedText = QString(500'000, u'#');
    large.runs.clear();
    for (int i = 1; i <= 300; ++i) {
        large.runs.push_back({.number = i, .note = QString(2000, u'n'), .file = {}, .identity = {}});
        write(file(QStringLiteral("run%1.h5").arg(i)), "results");
    }
    become(toJson(large));
    QCOMPARE(toJson(readSession(folder_)), toJson(large));
}

void TestSessionDamage::readsTheStateOfTheVersionBefore()
{
    QJsonObject json = QJsonDocument::fromJson(read(state())).object();
    for (const char* key : {"version", "studies", "study", "study_under_way", "restoring"})
        json.remove(QLatin1String(key));
    become(QJsonDocument(json).toJson());
    const SessionState back = readSession(folder_);
    QCOMPARE(back.notUnderstood, QString());
    QCOMPARE(back.edited.text, sampleState().edited.text);
    QCOMPARE(back.runs.size(), std::size_t(2));
    QCOMPARE(back.runs.front().note, QStringLiteral("the best"));
}

void TestSessionDamage::countsAndRemovesOnlyItsOwnFiles()
{
    write(file(QStringLiteral("session.json.touchdown.0123abcd.part")), "12345"); // of a write that was interrupted
    write(file(QStringLiteral("letter.txt")), "mine");
    link(QStringLiteral("run7.h5"), foreign_ + QStringLiteral("/run1.h5"));
    qint64 own = 0;
    for (const char* name : {"session.json", "run1.h5", "run3.h5", "solution2.h5", "study-cycles.h5"})
        own += QFileInfo(file(QLatin1String(name))).size();
    QCOMPARE(bytesIn(folder_), own + 5);
    const Content foreign = contentOf(foreign_);
    SessionFolder::remove(SessionFolder::take(folder_));
    QCOMPARE(QDir(folder_).entryList(QDir::AllEntries | QDir::NoDotAndDotDot, QDir::Name),
             QStringList({QStringLiteral("letter.txt"), QStringLiteral("run7.h5")}));
    QVERIFY(contentOf(foreign_) == foreign);
}

TOUCHDOWN_TEST(TestSessionDamage)

} // namespace test_session_damage

#include "test_session_damage.moc"

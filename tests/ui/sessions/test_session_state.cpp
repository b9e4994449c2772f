// SPDX-License-Identifier: GPL-3.0-or-later
//
// States of a session that are drawn at random: a good one with some of its values replaced, or with some of its bytes
// changed. What is understood can be written and read again; what is not says why, and holds nothing.
#include "ui/sessions/session_state.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QtTest>

#include "tests/support/sample_steady.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_session_state {

class Draw {
public:
    explicit Draw(unsigned seed) : random_(seed) {}

    int below(int count) { return std::uniform_int_distribution(0, count - 1)(random_); }

    QJsonValue value()
    {
        const double number = std::exp2(std::uniform_real_distribution(-40.0, 70.0)(random_));
        const QString text = texts_[below(static_cast<int>(texts_.size()))];
        switch (below(10)) {
        case 0: return {};
        case 1: return below(2) == 1;
        case 2: return below(5) - 1;
        case 3: return number;
        case 4: return -std::floor(number);
        case 5: return QJsonArray{value(), value()};
        case 6: return QJsonArray();
        case 7: return QJsonObject{{text.left(20), value()}};
        case 8: return QJsonObject();
        default: return text;
        }
    }

    /// With one value, anywhere in it, replaced, removed, doubled or added.
    QJsonValue changed(const QJsonValue& whole)
    {
        if (whole.isObject() && !whole.toObject().isEmpty() && below(12) > 0) {
            QJsonObject object = whole.toObject();
            const QString key = object.keys()[below(static_cast<int>(object.size()))];
            switch (below(14)) {
            case 0: object.remove(key); break;
            case 1: object[key + QLatin1Char('2')] = object[key]; break;
            case 2: object[object.keys()[below(static_cast<int>(object.size()))]] = object[key]; break;
            default: object[key] = changed(object[key]);
            }
            return object;
        }
        if (whole.isArray() && !whole.toArray().isEmpty() && below(12) > 0) {
            QJsonArray array = whole.toArray();
            const int place = below(static_cast<int>(array.size()));
            switch (below(8)) {
            case 0: array.removeAt(place); break;
            case 1: array.append(array[place]); break;
            default: array[place] = changed(array[place]);
            }
            return array;
        }
        return value();
    }

    /// With some bytes replaced, removed or repeated.
    QByteArray changed(QByteArray bytes)
    {
        for (int i = below(4); i >= 0 && !bytes.isEmpty(); --i) {
            const int at = below(static_cast<int>(bytes.size()));
            switch (below(4)) {
            case 0: bytes[at] = static_cast<char>(below(256)); break;
            case 1: bytes.remove(at, 1 + below(30)); break;
            case 2: bytes.insert(at, bytes.mid(below(static_cast<int>(bytes.size())), below(200))); break;
            default: bytes[at] = "0123456789-+.eE{}[]\",:"[below(22)];
            }
        }
        return bytes;
    }

private:
    std::mt19937 random_;
    const QStringList texts_{{},
                             QStringLiteral("fig10a"),
                             QStringLiteral("cycles"),
                             QStringLiteral("run1.h5"),
                             QStringLiteral("../../etc/passwd"),
                             QStringLiteral("/dev/zero"),
                             QStringLiteral("<img src='/dev/zero'>"),
                             QStringLiteral("two\nlines\u202e"),
                             QStringLiteral("2026-13-45T99:00:00"),
                             QStringLiteral("ffffffffffffffff:0:0:0:1"),
                             QString(300, u'x'),
                             QString(QChar(0))};
};

SessionState goodState()
{
    SessionState state;
    state.written = QDateTime::fromSecsSinceEpoch(1'795'000'000, Qt::UTC);
    state.edited.name = state.edited.sample = QStringLiteral("fig10a");
    state.edited.savedText = state.edited.text = QStringLiteral("model = \"springs\"\n");
    state.edited.entries[QStringLiteral("suspension.stiffness")] = QStringLiteral("1 N");
    state.runs = {{.number = 1, .note = QStringLiteral("best"), .file = QStringLiteral("/a.h5"), .identity = {}},
                  {.number = 3, .note = {}, .file = {}, .identity = {}, .underWay = true, .from = 2}};
    state.solutions = {{.number = 2, .note = QStringLiteral("flies"), .file = {}, .identity = {}, .place = 1}};
    state.drafts = {{QStringLiteral("cycles"), QStringLiteral("steps = 77\n"), QStringLiteral("steps = 7\n"), {}}};
    FoundModes modes;
    modes.value = test::sampleFilmCase();
    modes.result.steady.attitude = {12e-9, 150e-6, -3e-6};
    AirBearingMode pitch;
    pitch.frequency = 91.5e3;
    pitch.dampingRatio = 0.031;
    pitch.kind = "pitch";
    modes.result.modes = {pitch};
    state.modes = modes;
    state.studyUnderWay = state.study = QStringLiteral("cycles");
    return state;
}

/// Without marks of direction, too.
bool isPlainLine(const QString& text)
{
    return std::ranges::all_of(text, [](QChar c) { return c.isPrint() && c.category() != QChar::Other_Format; });
}

class TestSessionState : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        folder_ = std::make_unique<QTemporaryDir>();
        for (const char* name : {"run1.h5", "run3.h5", "solution2.h5"}) write(QLatin1String(name), "results");
    }
    void readsAnyState_data()
    {
        QTest::addColumn<bool>("ofBytes");
        QTest::newRow("values") << false;
        QTest::newRow("bytes") << true;
    }
    void readsAnyState();
    void refusesAListWithoutEnd();

private:
    void write(const QString& name, const QByteArray& bytes)
    {
        QFile file(folder_->filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(bytes), bytes.size());
    }
    SessionState read() { return readSession(folder_->path()); }
    static void check(const SessionState& state);

    std::unique_ptr<QTemporaryDir> folder_;
};

/// What the window takes for granted.
void TestSessionState::check(const SessionState& state)
{
    QVERIFY(isPlainLine(describe(state)) && isPlainLine(state.notUnderstood));
    QVERIFY(state.written.isValid());
    for (const auto& list : {state.runs, state.solutions})
        for (std::size_t i = 0; i < list.size(); ++i) QVERIFY(list[i].number > (i > 0 ? list[i - 1].number : 0));
    QVERIFY(std::ranges::find(state.runs, 1, &ListedState::number) != state.runs.end());
    if (!state.notUnderstood.isEmpty()) {
        QVERIFY(state.edited.text.isEmpty() && state.drafts.empty() && !state.modes);
        return;
    }
    QVERIFY(state.page >= 0 && state.page <= 2);
    if (!state.modes) return;
    for (const AirBearingMode& mode : state.modes->result.modes) {
        QVERIFY(std::isfinite(mode.frequency) && std::isfinite(mode.dampingRatio));
        for (const auto& amplitude : mode.shape) QVERIFY(std::isfinite(amplitude[0]) && std::isfinite(amplitude[1]));
    }
}

void TestSessionState::readsAnyState()
{
    QFETCH(bool, ofBytes);
    const QByteArray good = toJson(goodState());
    const QJsonObject whole = QJsonDocument::fromJson(good).object();
    bool isGiven = false;
    const int given = qEnvironmentVariableIntValue("TOUCHDOWN_DRAWS", &isGiven);
    const int count = isGiven ? given : 500;
    int understood = 0;
    for (int i = 0; i < count; ++i) {
        Draw draw(static_cast<unsigned>(i));
        QByteArray bytes = good;
        if (ofBytes) {
            bytes = draw.changed(good);
        } else {
            QJsonValue value = whole;
            for (int times = draw.below(3); times >= 0; --times) value = draw.changed(value);
            bytes = QJsonDocument(value.toObject()).toJson();
        }
        write(QStringLiteral("session.json"), bytes);
        const SessionState state = read();
        check(state);
        if (QTest::currentTestFailed()) QFAIL(qPrintable(QStringLiteral("seed %1").arg(i)));
        if (!state.notUnderstood.isEmpty()) continue;
        ++understood;
        write(QStringLiteral("session.json"), toJson(state));
        QVERIFY2(toJson(read()) == toJson(state), qPrintable(QStringLiteral("seed %1").arg(i)));
    }
    QVERIFY(understood > count / 50 && understood < count); // else nothing of both is tried
}

/// A file of 4 MiB has room for more entries than can be compared with each other in a moment.
void TestSessionState::refusesAListWithoutEnd()
{
    QJsonObject whole = QJsonDocument::fromJson(toJson(goodState())).object();
    QJsonArray runs;
    for (int i = 1; i <= 100'000; ++i) runs << QJsonObject{{"number", i}};
    whole["runs"] = runs;
    const QByteArray bytes = QJsonDocument(whole).toJson(QJsonDocument::Compact);
    QVERIFY(static_cast<std::uintmax_t>(bytes.size()) < largestState);
    write(QStringLiteral("session.json"), bytes);
    QCOMPARE(read().notUnderstood, QStringLiteral("“runs” in it is not understood"));
}

TOUCHDOWN_TEST(TestSessionState)

} // namespace test_session_state

#include "test_session_state.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
//
// `touchdown modes` as a person and as a script use it. Whether the modes are right:
// tests/simulation/small_motions/test_modes.cpp.

#include <QtTest>

#include "tests/support/command_process.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_modes_command {

class TestModesCommand : public QObject {
    Q_OBJECT

private slots:
    void init() { folder_ = std::make_unique<CommandFolder>(); }
    void json();
    void text();
    void errors();
    void saysWhatIsLeftOut();
    void wrongInput_data();
    void wrongInput();
    void notConverged();

private:
    static QStringList quick() { return {"--set", "film.nodes=33,33", "film.grid=uniform"}; }
    std::unique_ptr<CommandFolder> folder_;
};

void TestModesCommand::json()
{
    const Outcome o = folder_->touchdown(QStringList{"modes", "film_pico", "--json"} + quick());
    QCOMPARE(o.code, 0);
    QCOMPARE(o.err, QByteArray());
    const QJsonObject json = o.json();
    QCOMPARE(json["status"].toString(), "converged");
    const QJsonArray modes = json["modes"].toArray();
    QCOMPARE(modes.size(), 3); // height, pitch and roll
    double last = 0.0;
    for (const auto& each : modes) {
        const QJsonObject mode = each.toObject();
        QVERIFY(mode["frequency"].toDouble() > last);
        last = mode["frequency"].toDouble();
        QVERIFY(mode["damping_ratio"].isDouble());
        QVERIFY(mode["damping_ratio_error"].isNull() && mode["frequency_error"].isNull()); // 32 cells have no half
        QVERIFY((QStringList{"vertical", "pitch", "roll"}).contains(mode["kind"].toString()));
        for (const char* motion : {"height", "pitch", "roll"})
            QCOMPARE(mode["shape"].toObject()[motion].toArray().size(), 2);
    }
    // The state about which they are is that of `touchdown steady`.
    const Outcome steady = folder_->touchdown(QStringList{"steady", "film_pico", "--json"} + quick());
    QCOMPARE(json["steady"].toObject()["minimum_spacing"].toDouble(), steady.json()["minimum_spacing"].toDouble());
}

void TestModesCommand::text()
{
    const Outcome o = folder_->touchdown(QStringList{"modes", "film_pico"} + quick());
    QCOMPARE(o.code, 0);
    QVERIFY2(o.out.startsWith("Film: a pico slider"), o.out);
    for (const char* part : {"converged", "static attitude", " kHz, damping ratio ", "roll 1", "pitch 1"})
        QVERIFY2(o.out.contains(part), o.out);
}

// The errors that the cells leave, where a coarser grid has the modes.
void TestModesCommand::errors()
{
    const QStringList settings{"--set", "film.nodes=65,65", "film.grid=uniform"};
    const Outcome o = folder_->touchdown(QStringList{"modes", "film_pico", "--json"} + settings);
    QCOMPARE(o.code, 0);
    for (const auto& each : o.json()["modes"].toArray())
        for (const char* error : {"damping_ratio_error", "frequency_error"})
            QVERIFY2(each.toObject()[error].toDouble() > 0.0, o.out);
    const Outcome text = folder_->touchdown(QStringList{"modes", "film_pico"} + settings);
    QVERIFY2(text.out.contains(" +- ") && text.out.contains("grids of half and of a quarter"), text.out);
}

// Modes are over a disk that stands still, and say so where the case has more.
void TestModesCommand::saysWhatIsLeftOut()
{
    const QStringList settings = quick() + QStringList{"contact=ono-yamane", "disk.surface.kind=rough"};
    const Outcome o = folder_->touchdown(QStringList{"modes", "film_pico", "--json"} + settings);
    QCOMPARE(o.code, 0);
    QVERIFY2(o.json()["message"].toString().contains("over a flat disk: disk.surface has no part in it"), o.out);
    QCOMPARE(o.json()["modes"].toArray().size(), 3);
}

void TestModesCommand::wrongInput_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QByteArray>("says");
    QTest::newRow("no case") << QStringList{} << QByteArray("CASE");
    QTest::newRow("springs") << QStringList{"fig10a"} << QByteArray("fig10a: model: must be \"film\"");
    QTest::newRow("a file that does not exist") << QStringList{"none.toml"} << QByteArray("none.toml");
    QTest::newRow("an option of another command") << QStringList{"film_pico", "--out", "a.h5"} << QByteArray("--out");
}

void TestModesCommand::wrongInput()
{
    QFETCH(QStringList, arguments);
    QFETCH(QByteArray, says);
    const Outcome o = folder_->touchdown(QStringList{"modes"} + arguments);
    QCOMPARE(o.code, 2);
    QVERIFY2(o.err.contains(says), o.err);
    QCOMPARE(o.out, QByteArray());
}

// Without a static state there are no modes about it.
void TestModesCommand::notConverged()
{
    const Outcome o =
        folder_->touchdown(QStringList{"modes", "film_pico", "--json"} + quick() + QStringList{"disk.speed=0 rpm"});
    QCOMPARE(o.code, 1);
    QVERIFY(o.json()["status"].toString() != "converged");
    QVERIFY(o.json()["modes"].toArray().isEmpty());
    QCOMPARE(o.errorLines().size(), 1);
}

TOUCHDOWN_TEST(TestModesCommand)

} // namespace test_modes_command

#include "test_modes_command.moc"

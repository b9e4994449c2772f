// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/modes_text.h"

#include <cmath>

#include <QJsonArray>
#include <QJsonDocument>
#include <QtTest>

#include "tests/support/sample_steady.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_modes_text {

FoundModes sampleModes()
{
    FoundModes modes;
    modes.value = test::sampleFilmCase();
    modes.result.status = SteadyStatus::Converged;
    modes.result.steady.attitude = {12e-9, 150e-6, -3e-6};
    modes.result.message = "one mode is not known";
    AirBearingMode pitch;
    pitch.frequency = 91.5e3;
    pitch.dampingRatio = 0.031;
    pitch.frequencyError = 120.0;
    pitch.shape = {{{0.5, -0.1}, {40.0, 3.0}, {0.0, 1e-9}}};
    pitch.kind = "pitch";
    AirBearingMode roll = pitch; // errors that are not known
    roll.kind = "roll";
    roll.frequencyError = roll.dampingError = DiscretisationError::unknown;
    pitch.dampingError = 0.002;
    modes.result.modes = {pitch, roll};
    return modes;
}

class TestModesText : public QObject {
    Q_OBJECT

private slots:
    void readsWhatItWrites();
    void refusesWhatIsNotOfModes();
    void leavesUnknownErrorsOutOfTheTable();
};

void TestModesText::readsWhatItWrites()
{
    const FoundModes modes = sampleModes();
    const QByteArray text = QJsonDocument(toJson(modes)).toJson();
    const std::optional<FoundModes> back = modesFromJson(QJsonDocument::fromJson(text).object());
    QVERIFY(back);
    QVERIFY(back->value == modes.value);
    QCOMPARE(back->result.message, modes.result.message);
    QCOMPARE(back->result.steady.attitude.pitch, modes.result.steady.attitude.pitch);
    QCOMPARE(back->result.modes.size(), std::size_t(2));
    for (std::size_t i = 0; i < 2; ++i) {
        const AirBearingMode &mode = back->result.modes[i], &expected = modes.result.modes[i];
        QCOMPARE(mode.kind, expected.kind);
        QCOMPARE(mode.frequency, expected.frequency);
        QCOMPARE(mode.dampingRatio, expected.dampingRatio);
        QVERIFY(mode.shape == expected.shape);
        QCOMPARE(std::isnan(mode.dampingError), std::isnan(expected.dampingError));
    }
    QCOMPARE(back->result.modes[0].dampingError, 0.002);
}

void TestModesText::refusesWhatIsNotOfModes()
{
    const QJsonObject whole = toJson(sampleModes());
    for (const char* key : {"case", "attitude", "modes"}) {
        QJsonObject json = whole;
        json.remove(QLatin1String(key));
        QVERIFY2(!modesFromJson(json), key);
    }
    QJsonObject json = whole;
    json["modes"] = QJsonArray{QJsonObject{{"kind", "pitch"}, {"numbers", QJsonArray{1.0}}}};
    QVERIFY(!modesFromJson(json));
}

void TestModesText::leavesUnknownErrorsOutOfTheTable()
{
    const QList<QByteArray> lines = csvOf(sampleModes().result).split('\n');
    QCOMPARE(lines[0], QByteArray("kind,frequency [Hz],frequency_error [Hz],damping_ratio,damping_ratio_error"));
    QCOMPARE(lines[1], QByteArray("pitch,91500,120,0.031,0.002"));
    QCOMPARE(lines[2], QByteArray("roll,91500,,0.031,"));
}

TOUCHDOWN_TEST(TestModesText)

} // namespace test_modes_text

#include "test_modes_text.moc"

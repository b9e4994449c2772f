// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/surfaces/column_name.h"

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_column_name {

class TestColumnName : public QObject {
    Q_OBJECT

private slots:
    void roles()
    {
        const auto are = [](ColumnRole role, std::initializer_list<const char*> names) {
            for (const char* name : names) QVERIFY2(columnName(name).role == role, name);
        };
        are(ColumnRole::X, {"x", "X axis", "Distance", "track position", "down-track position", "xPos", "xposition"});
        are(ColumnRole::Y, {"y", "y position", "across", "cross-track y"});
        are(ColumnRole::Height, {"z", "H", "height (raw)", "Surface Height", "ZSensor", "zheight", "z position",
                                 "depth", "scan height", "topography", "mean height above the plane", "height_data"});
        are(ColumnRole::Any, {"", "a", "data", "channel 2", "profile 3", "raw"});
        are(ColumnRole::Unknown, {"spot size", "etch", "-x"});
        are(ColumnRole::None,
            {"gap",       "flying height", "log10 z",      "logz",          "ln(h)",           "z^2",   "z\xC2\xB2",
             "z squared", "1/z",           "z x1000",      "z e-9",         "1e-9 z",          "10 z",  "|z|",
             "abs z",     "std z",         "z_std",        "rms",           "slope",           "dz/dx", "dz",
             "PSD",       "counts",        "height error", "z uncertainty", "film thickness",  "max z", "AFM amplitude",
             "phase",     "s.d.",          "\xCF\x83_z",   "z \xC2\xB1",    "height increment"});
    }
    void otherLanguages()
    {
        for (const char* name : {"H\xC3\xB6he", "Profilh\xC3\xB6he", "H\xC3\x96HE",
                                 "Oberfl\xC3\xA4"
                                 "chenh\xC3\xB6he",
                                 "Hauteur", "Altura", "Ho\xCC\x88he"}) {
            QVERIFY2(columnName(name).role == ColumnRole::Height && !columnName(name).turned, name);
            QVERIFY2(columnName(name).known, name);
        }
        for (const char* name :
             {"H\xC3\xB6he unter Referenz", "H\xC3\xB6he invertiert", "H\xC3\xB6he, negativ", "z nach unten",
              "Profundidad", "profondit\xC3\xA0", "Vertiefung", "-H\xC3\xB6he", "H\xC3\xB6hen umgekehrt"})
            QVERIFY2(columnName(name).turned, name);
        for (const char* name : {"H\xC3\xB6he quadriert", "H\xC3\xB6he logarithmisch", "Streuung der H\xC3\xB6he",
                                 "Fehler der H\xC3\xB6he", "Varianz", "Standardabweichung", "H\xC3\xB6hendifferenz",
                                 "Flugh\xC3\xB6he", "Steigung", "Desviaci\xC3\xB3n est\xC3\xA1ndar derivada"})
            QVERIFY2(columnName(name).role == ColumnRole::None, name);
    }
    void heightsCountUpwardsOrDownwards()
    {
        for (const char* name :
             {"depth", "Tiefe", "-z", "minus z", "negative height", "inverted z", "z flipped", "depth below surface",
              "z downwards", "height below the plane", "- z", "z-", "\xE2\x80\x93z", "recess", "pit depth"})
            QVERIFY2(columnName(name).turned, name);
        for (const char* name : {"z", "height", "-depth", "inverted depth", "x-axis", "down-track position", "gap",
                                 "- depth", "profile - height", "height - raw"})
            QVERIFY2(!columnName(name).turned, name);
    }
    void theWordIsNamed()
    {
        QCOMPARE(columnName("log10 z").word, std::string("log"));
        QCOMPARE(columnName("height error").word, std::string("error"));
        QCOMPARE(columnName("z^2").word, std::string("z^2"));
        QCOMPARE(columnName("mittlerer H\xC3\xB6henfehler").word,
                 std::string("H\xC3\xB6henfehler")); // as it is written
        QCOMPARE(columnName("height").word, std::string());
    }
    void unknownWords()
    {
        QVERIFY(columnName("raw surface height").known);
        QVERIFY(columnName("height error").known);
        QVERIFY(!columnName("tip height").known);
        QVERIFY(!columnName("step in z of the mask").known);
    }
};

TOUCHDOWN_TEST(TestColumnName)

} // namespace test_column_name

#include "test_column_name.moc"

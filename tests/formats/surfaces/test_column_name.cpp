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
            {"gap",       "flying height", "log10 z",      "logz",          "ln(h)",          "z^2",   "z\xC2\xB2",
             "z squared", "1/z",           "z x1000",      "z e-9",         "1e-9 z",         "10 z",  "|z|",
             "abs z",     "std z",         "z_std",        "rms",           "slope",          "dz/dx", "dz",
             "PSD",       "counts",        "height error", "z uncertainty", "film thickness", "max z", "AFM amplitude",
             "phase"});
    }
    void heightsCountUpwardsOrDownwards()
    {
        for (const char* name : {"depth", "Tiefe", "-z", "minus z", "negative height", "inverted z", "z flipped",
                                 "depth below surface", "z downwards", "height below the plane"})
            QVERIFY2(columnName(name).turned, name);
        for (const char* name : {"z", "height", "-depth", "inverted depth", "x-axis", "down-track position", "gap"})
            QVERIFY2(!columnName(name).turned, name);
    }
    void theWordIsNamed()
    {
        QCOMPARE(columnName("log10 z").word, std::string("log"));
        QCOMPARE(columnName("height error").word, std::string("error"));
        QCOMPARE(columnName("z^2").word, std::string("z^2"));
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

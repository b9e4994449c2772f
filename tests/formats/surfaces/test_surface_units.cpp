// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/surfaces/surface_units.h"

#include <QTest>

#include "core/formats/cml_text.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_surface_units {

class TestSurfaceUnits : public QObject {
    Q_OBJECT

private slots:
    void lengths()
    {
        for (const char* text : {"um", "\xB5m", "\xC2\xB5m", "\xCE\xBCm", "UM", "\\mum", "$\\mu$m", "Microns",
                                 "MICROMETERS", "mikrometer", " um ", "\"um\""})
            QCOMPARE(spelledLength(text), std::optional(1e-6));
        for (const char* text :
             {"A", "\xC5", "\xC3\x85", "A\xCC\x8A", "\xC3\x85ngstr\xC3\xB6m", "Angstroem", "angstroms"})
            QCOMPARE(spelledLength(text), std::optional(1e-10));
        QCOMPARE(spelledLength("NM"), std::optional(1e-9));
        QCOMPARE(spelledLength("metres"), std::optional(1.0));
    }
    void whatMayBeAnotherUnitIsNone()
    {
        for (const char* text : {"", "M", "MM", "Mm", "mM", "Nm", "nM", "Um", "u", "a", "s", "ms", "track", "um^2",
                                 "um/s", "10 um", "\xEF\xBF\xBDm"})
            QVERIFY2(!spelledLength(text), text);
    }
    void quantities()
    {
        const auto reads = [](const char* text, double number, const char* unit) {
            const auto parts = numberAndUnit(text);
            return parts && parts->number == number && parts->unit == unit;
        };
        QVERIFY(reads("2.5 um", 2.5, "um"));
        QVERIFY(reads("2,5um", 2.5, "um"));
        QVERIFY(reads("12e-6 [m]", 12e-6, "m"));
        QVERIFY(reads("2.5", 2.5, ""));
        QVERIFY(!numberAndUnit("um"));
        QVERIFY(!numberAndUnit("1,250 um")); // a thousand, or one
        QCOMPARE(numberAndUnit("12")->unit, std::string());
    }
    void otherUnits()
    {
        for (const char* text : {"V", "px", "counts", "deg", "ms", "Nm", "%"}) QVERIFY2(spellsOtherUnit(text), text);
        for (const char* text : {"um", "x", "height", ""}) QVERIFY2(!spellsOtherUnit(text), text);
    }
    void everyLengthHasASymbol()
    {
        for (const char* text : {"m", "cm", "mm", "um", "nm", "pm", "A", "in", "uin"})
            QCOMPARE(lengthSymbol(*spelledLength(text)), std::string(text));
        QCOMPARE(lengthSymbol(*spelledLength("microns")), std::string("um"));
    }
    void theKeyHoldsUnits()
    {
        QCOMPARE(unitsOfKey(""), std::optional(ColumnUnits{}));
        QCOMPARE(unitsOfKey("um, nm"), std::optional(ColumnUnits{1e-6, 1e-9}));
        QCOMPARE(unitsOfKey("um;um;nm"), std::optional(ColumnUnits{1e-6, 1e-6, 1e-9}));
        QVERIFY(!unitsOfKey("um, V"));
        QVERIFY(!unitsOfKey("um,"));
        QCOMPARE(unitsOfKey(ColumnUnits{1e-6}, 3), (ColumnUnits{1e-6, 1e-6, 1e-6}));
        QCOMPARE(unitsOfKey(ColumnUnits{1e-6, 1e-9}, 3), (ColumnUnits{1e-6, 1e-6, 1e-9}));
        QVERIFY_EXCEPTION_THROWN(unitsOfKey(ColumnUnits{1, 1, 1}, 2), CmlError);
    }
};

TOUCHDOWN_TEST(TestSurfaceUnits)

} // namespace test_surface_units

#include "test_surface_units.moc"

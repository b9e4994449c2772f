// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/surfaces/surface_units.h"

#include <QTest>

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
    void mentions_data()
    {
        QTest::addColumn<QByteArray>("line");
        QTest::addColumn<QByteArray>("texts"); // no lengths with a question mark
        const auto row = [](const char* line, const char* texts) {
            QTest::newRow(line) << QByteArray(line) << QByteArray(texts);
        };
        row("x [um] h [nm]", "um nm");
        row("x in um, h (in nm)", "um nm");
        row("x_um h/nm", "um nm");
        row("x [um, nm]", "um nm");
        row("A profile of 10 nm", "");
        row("speed 5 um/s, size 16 [um]", "");
        row("x (forward) [um]", "um");
        row("t [ms] h [foo]", "ms? foo?");
        row("t (ms) h (foo)", "ms?");
        row("h [nm] x 10", "nm 10?");
        row("h [nm] x [um]", "nm um");
        row("A;nm", "A nm");
        row("x;s", "");
    }
    void mentions()
    {
        QFETCH(QByteArray, line);
        QFETCH(QByteArray, texts);
        QByteArrayList found;
        for (const UnitMention& each : unitMentions(line.toStdString()))
            found << QByteArray::fromStdString(each.text) + (each.metres ? "" : "?");
        QCOMPARE(found.join(' '), texts);
    }
};

TOUCHDOWN_TEST(TestSurfaceUnits)

} // namespace test_surface_units

#include "test_surface_units.moc"

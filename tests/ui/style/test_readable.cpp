// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/readable.h"

#include <QTest>

#include "tests/support/test_program.h"
#include "ui/style/quantity_format.h"

using namespace touchdown;

namespace test_readable {

class TestReadable : public QObject {
    Q_OBJECT

private slots:
    /// A sentence begins with a capital, but a symbol and the name of a file keep their spelling; a key is a label.
    void aSentenceKeepsNames()
    {
        QCOMPARE(sentence("run.tolerance does not determine the motion"),
                 QStringLiteral("Tolerance does not determine the motion."));
        QCOMPARE(sentence("points.txt is empty."), QStringLiteral("points.txt is empty."));
        QCOMPARE(sentence("d_e is less"), QStringLiteral("d\u2091 is less."));
        QCOMPARE(sentence("the run is short"), QStringLiteral("The run is short."));
        QCOMPARE(sentence("over. the disk"), QStringLiteral("Over. the disk."));
        QCOMPARE(sentence("a"), QStringLiteral("A."));
    }
    void asPrinted_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("shown");
        QTest::newRow("units") << "49.45 us and 0.1 um, 3 uN"
                               << "49.45 µs and 0.1 µm, 3 µN";
        QTest::newRow("unit of an axis") << "length [um]"
                                         << "length [µm]";
        QTest::newRow("no unit") << "tell us more of the um"
                                 << "tell us more of the um";
        QTest::newRow("powers") << "nm^2, 1/m^3, 10^-3, A^2/2, nm^2."
                                << "nm², 1/m³, 10⁻³, A²/2, nm².";
        QTest::newRow("no power") << "2^1.5 stays"
                                  << "2^1.5 stays";
        QTest::newRow("uncertainty") << "7.0 +- 0.1 nm, 3 +/- 1"
                                     << "7.0 ± 0.1 nm, 3 ± 1";
        QTest::newRow("relations") << "W >= 0 and W <= 1"
                                   << "W ≥ 0 and W ≤ 1";
        QTest::newRow("minus") << "-3 nm, (-0.5), from -1 to -.5"
                               << "−3 nm, (−0.5), from −1 to −.5";
        QTest::newRow("hyphens") << "take-off, 1e-9, run-1, 5-10"
                                 << "take-off, 1e-9, run-1, 5-10";
        QTest::newRow("letters") << "Re lambda h, mu = 0.3, xi_f"
                                 << "Re λ h, μ = 0.3, ξ_f";
        QTest::newRow("front and rear") << "xi_f, xi_r, d_1, d_s"
                                        << "ξ_f, ξ_r, d₁, dₛ";
        QTest::newRow("letters inside words") << "simulation, maximum, film.mu, van-mu-x"
                                              << "simulation, maximum, film.mu, van-mu-x";
        QTest::newRow("symbols") << "f_m (d_e - d_s), d_1, F_m."
                                 << "fₘ (dₑ - dₛ), d₁, Fₘ.";
        QTest::newRow("subscripts without a character") << "k_c, f_c0"
                                                        << "k_c, f_c0";
        QTest::newRow("keys") << "run.step_error, map.x_to, film.d_e.x, abs.rail[2].x"
                              << "run.step_error, map.x_to, film.d_e.x, abs.rail[2].x";
        QTest::newRow("cells") << "97 x 97 cells"
                               << "97 × 97 cells";
        QTest::newRow("quotations") << "\"a -1 um d_s.toml\" is 5 um, `x >= 2`"
                                    << "\"a -1 um d_s.toml\" is 5 µm, `x >= 2`";
        QTest::newRow("empty") << ""
                               << "";
    }
    void asPrinted()
    {
        QFETCH(QString, text);
        QFETCH(QString, shown);
        QCOMPARE(readable(text.toStdString()), shown);
        QCOMPARE(readable(shown.toStdString()), shown);
    }
};

TOUCHDOWN_TEST(TestReadable)

} // namespace test_readable

#include "test_readable.moc"

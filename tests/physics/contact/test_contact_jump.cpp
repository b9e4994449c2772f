// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/contact/contact_jump.h"

#include <cmath>

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_contact_jump {

/// A contact that holds with force -k d until it is drawn to `off`, and then is free until it comes back to `in`.
struct Latch {
    double off = 5e-9, in = 3e-9; // [m]
    double stiffness = 1e6;       // [N/m]
    bool held = false, kept = false;
    int calls = 0;

    double force(double d)
    {
        ++calls;
        held = held ? d < off : d <= in;
        return held ? -stiffness * d : 0.0;
    }
    TracedContact traced()
    {
        return {[this](double d) { return force(d); }, [this] { kept = held; }, [this] { held = kept; }};
    }
};

class TestContactJump : public QObject {
    Q_OBJECT

private slots:
    void bothWays_data()
    {
        QTest::addColumn<double>("from");
        QTest::addColumn<double>("to");
        QTest::addColumn<double>("at");
        QTest::addColumn<double>("jump"); // [N]
        QTest::newRow("pull-off") << 1e-9 << 9e-9 << 5e-9 << 5e-3;
        QTest::newRow("snap-in") << 9e-9 << 1e-9 << 3e-9 << -3e-3;
        QTest::newRow("pull-off in a short interval") << 4.9999e-9 << 5.0001e-9 << 5e-9 << 5e-3;
    }

    /// Nine nanometres to 1e-14 m take log2(8e-9/1e-14) = 20 halvings.
    void bothWays()
    {
        QFETCH(double, from);
        QFETCH(double, to);
        QFETCH(double, at);
        QFETCH(double, jump);
        Latch latch;
        latch.held = from < to;
        const double start = latch.force(from);
        const ContactJump found = locateJump(latch.traced(), from, start, to, 1e-14, 1e-6);
        QVERIFY(found.found);
        QVERIFY(std::abs(found.before - at) <= 1e-14 && std::abs(found.after - at) <= 1e-14);
        QVERIFY((found.after - found.before) * (to - from) > 0.0);
        QVERIFY(std::abs(found.forceAfter - found.forceBefore - jump) < 1e-7);
        QCOMPARE(latch.held, from < to); // left before the jump
        QCOMPARE(latch.force(found.after), found.forceAfter);
        QVERIFY(latch.calls <= 26);
    }

    void smooth_data()
    {
        QTest::addColumn<int>("law");
        QTest::newRow("straight") << 0;
        QTest::newRow("a steep rise") << 1;
        QTest::newRow("the end of a branch, as a square root") << 2;
        QTest::newRow("nothing") << 3;
    }

    void smooth()
    {
        QFETCH(int, law);
        const auto force = [law](double d) {
            const double x = d / 1e-9;
            return law == 0   ? x
                   : law == 1 ? std::tanh(20.0 * (x - 0.3))
                   : law == 2 ? std::sqrt(std::max(0.0, 0.625 - x))
                              : 0.0;
        };
        const TracedContact contact{force, [] {}, [] {}};
        QVERIFY(!locateJump(contact, 0.0, force(0.0), 1e-9, 1e-12, 1e-9).found);
    }

    void firstOfTwo_data()
    {
        QTest::addColumn<double>("from");
        QTest::addColumn<double>("stiffness"); // of the latch that lets go first [N/m]
        QTest::newRow("a large one") << 3.5e-9 << 0.6e6;
        QTest::newRow("a small one, on a long way") << 1e-9 << 0.3e6;
    }
    /// Two latches in one interval: the smaller one lets go at 4 nm, where bisection alone finds the larger at 6 nm.
    void firstOfTwo()
    {
        QFETCH(double, from);
        QFETCH(double, stiffness);
        Latch small{.off = 4e-9, .stiffness = stiffness, .held = true}, large{.off = 6e-9, .held = true};
        bool smallMarked = false, largeMarked = false;
        TracedContact contact{[&](double d) { return small.force(d) + large.force(d); },
                              [&] {
                                  small.kept = small.held;
                                  large.kept = large.held;
                              },
                              [&] {
                                  small.held = small.kept;
                                  large.held = large.kept;
                              },
                              {},
                              [&] {
                                  smallMarked = small.held;
                                  largeMarked = large.held;
                              },
                              [&] {
                                  small.held = smallMarked;
                                  large.held = largeMarked;
                              }};
        const double start = contact.force(from);
        const ContactJump first = locateFirstJump(contact, from, start, 6.5e-9, 1e-13, 1e-6);
        QVERIFY(first.found);
        QVERIFY(std::abs(first.before - 4e-9) <= 1e-13);
        QVERIFY(small.held);
        const ContactJump second =
            locateFirstJump(contact, first.after, contact.force(first.after), 6.5e-9, 1e-13, 1e-6);
        QVERIFY(second.found);
        QVERIFY(std::abs(second.before - 6e-9) <= 1e-13);
        QVERIFY(large.held);
    }

    void tooSmall()
    {
        Latch latch{.held = true};
        QVERIFY(!locateJump(latch.traced(), 1e-9, latch.force(1e-9), 9e-9, 1e-13, 6e-3).found);
    }
};

TOUCHDOWN_TEST(TestContactJump)

} // namespace test_contact_jump

#include "test_contact_jump.moc"

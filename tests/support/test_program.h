// SPDX-License-Identifier: GPL-3.0-or-later
//
// A test program holds the tests of one folder. Its first argument is the name of a file of tests, "test_recess"; the
// rest are options of Qt Test. Without arguments it lists the names.
#pragma once

#include <QTest>

/// A wait ends when its condition holds. Its limit only decides when a test fails, so a machine with much to do gets
/// time (ms).
#undef QTRY_VERIFY
#define QTRY_VERIFY(condition) QTRY_VERIFY_WITH_TIMEOUT(condition, 60000)
#undef QTRY_COMPARE
#define QTRY_COMPARE(computed, expected) QTRY_COMPARE_WITH_TIMEOUT(computed, expected, 60000)

namespace touchdown::test {

/// Registers a function under a name; `file` may be a path, whose stem is the name.
struct Program {
    using Main = int (*)(int argc, char** argv);
    Program(const char* file, Main main);
};

} // namespace touchdown::test

/// Once in each file of tests, in place of a main function.
#define TOUCHDOWN_TEST(Class)                                                                                          \
    static const touchdown::test::Program programOf##Class(__FILE__, [](int argc, char** argv) {                       \
        Class test;                                                                                                    \
        return QTest::qExec(&test, argc, argv);                                                                        \
    });

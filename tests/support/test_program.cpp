// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_program.h"

#include <cstdio>
#include <filesystem>
#include <map>
#include <string>

#include "core/studies/reader_program.h"

#ifdef QT_WIDGETS_LIB
#include <QApplication>
using Application = QApplication;
#else
#include <QCoreApplication>
using Application = QCoreApplication;
#endif

namespace touchdown::test {

namespace {

std::map<std::string, Program::Main>& programs()
{
    static std::map<std::string, Program::Main> all;
    return all;
}

} // namespace

Program::Program(const char* file, Main main) { programs().emplace(std::filesystem::path(file).stem().string(), main); }

} // namespace touchdown::test

int main(int argc, char** argv)
{
    using touchdown::test::programs;
    if (const auto code = touchdown::runReader(argc, argv)) return *code;
    const auto chosen = argc > 1 ? programs().find(argv[1]) : programs().end();
    if (chosen == programs().end()) {
        for (const auto& [name, main] : programs()) std::puts(name.c_str());
        return argc > 1 ? 2 : 0;
    }
    QCoreApplication::setAttribute(Qt::AA_Use96Dpi, true); // as QTEST_MAIN does
    Application application(argc, argv);
    argv[1] = argv[0];
    return chosen->second(argc - 1, argv + 1);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <exception>

#include "app/commands/command_line.h"
#include "app/terminal/console.h"

int main(int argc, char** argv)
{
    try {
        return touchdown::commandLine(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "touchdown: %s\n", error.what());
        return touchdown::exitNoAnswer;
    }
}

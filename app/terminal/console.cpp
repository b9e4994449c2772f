// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/terminal/console.h"

#include <cstdio>

#include <unistd.h>

#include "core/formats/quotation.h"

namespace touchdown {

namespace {

void writeOut(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stdout); }

} // namespace

void complain(std::string_view sentence)
{
    std::fflush(stdout); // keeps the order when both go to one place
    std::fprintf(stderr, "%s\n", printable(sentence).c_str());
}

void print(std::string_view text) { writeOut(printable(text, true)); }

void printExactly(std::string_view text)
{
    if (::isatty(STDOUT_FILENO) == 1)
        print(text);
    else
        writeOut(text);
}

} // namespace touchdown

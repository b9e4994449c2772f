// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/terminal/console.h"

#include <cstdio>

namespace touchdown {

void complain(std::string_view sentence)
{
    std::fflush(stdout); // keeps the order when both go to one place
    std::fprintf(stderr, "%.*s\n", static_cast<int>(sentence.size()), sentence.data());
}

void print(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stdout); }

} // namespace touchdown

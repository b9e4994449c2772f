// SPDX-License-Identifier: GPL-3.0-or-later
//
// Descriptors 0, 1 and 2, which a caller may have closed.
#pragma once

#include <cerrno>

#include <fcntl.h>

namespace touchdown {

/// Opens /dev/null on each that is closed, so that no file that the program opens gets its number: a message would be
/// written into that file. Writing to such a standard output still fails, and is reported. The first thing in main().
inline void keepStandardStreams()
{
    for (int descriptor = 0; descriptor <= 2; ++descriptor)
        if (::fcntl(descriptor, F_GETFD) < 0 && errno == EBADF)
            static_cast<void>(::open("/dev/null", descriptor == 0 ? O_WRONLY : O_RDONLY)); // the lowest free number
}

} // namespace touchdown

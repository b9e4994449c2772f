// SPDX-License-Identifier: GPL-3.0-or-later
//
// Elastic contact of random surfaces, as CSV: from nothing under a load, and followed by steps of 0.01 nm. The last
// columns do not depend on the machine: the time of one iteration against one FFT there and back of the same grid
// (FFTW, real, estimated plans; the free half-space's convolution is on a grid four times as large).
#pragma once

namespace touchdown {

/// Of one thread's processor time, the least of `repeats`. Returns the exit status.
int benchmarkContact(int repeats);

} // namespace touchdown

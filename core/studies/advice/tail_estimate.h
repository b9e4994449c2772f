// SPDX-License-Identifier: GPL-3.0-or-later
//
// The spacing over the last tenth of a run: measured where the run went to its end, else predicted from its first part.
//
// If the second half of the part rings at the rates of the slider's modes and of the waves of the disk, the fit of
// ringing_fit.h is continued. Otherwise three overlapping blocks of that half, weighted by Hann's window so that the
// phase at their ends does not matter, have means m_i and variances v_i. A variance that changes by a constant factor r
// from block to block tends to
//
//   v = v_3 + (v_3 - v_2) r/(1 - r),  r = (v_3 - v_2)/(v_2 - v_1)          (Aitken 1926)
//
// or to zero. The mean follows, m = m_3 + (v - v_3) (m_3 - m_1)/(v_3 - v_1), since a motion shifts it by its square; or
// it tends to a limit of its own in the same way, where it creeps by more than a motion can shift the mean of a block.
//
// Uncertainty: the same prediction is made from 0.65 and from half of the part, and compared with the rest of the part
// in stretches of the tail's length. The largest miss is scaled by the time from the known part to the prediction, as
// an unknown drift grows. A second measure is the change of the result when the last tenth or fifth of the part is left
// out. The largest of all counts; with too few samples nothing is known. The kind is that of the part's last quarter;
// how long a slider bounces is not known.
#pragma once

#include <vector>

#include "core/studies/advice/ringing_fit.h"
#include "core/studies/runs/measured_run.h"

namespace touchdown {

/// Samples at equal intervals from zero on.
struct SpacingSamples {
    double interval = 0.0;       // [s]
    std::vector<double> spacing; // [m]
    std::vector<char> touching;  // as long: contact, or menisci, act
    double reached() const { return spacing.empty() ? 0.0 : interval * static_cast<double>(spacing.size() - 1); }
    /// Of a run of this duration [s] there is none more: the last one need not stand at its end.
    bool reachEnd(double duration) const;
    /// Those up to a time [s].
    SpacingSamples until(double time) const;
};

struct TailEstimate {
    EndKind kind = EndKind::Failed;
    double mean = 0.0, spread = 0.0; // of the spacing [m]
    double meanUncertainty = 0.0,
           spreadUncertainty = 0.0; // [m]; zero where the tail is there, infinite where nothing is known
    double peakFrequency = 0.0;     // of the largest peak of the spectrum of the second half; zero: there is none [Hz]
    double peakAmplitude = 0.0;     // [m]
    double resolution = 0.0;        // of that spectrum [Hz]
    bool sameKind = true;           // also without the last fifth, and it does not bounce; false: the kind is not known
};

/// Of a run of this duration [s], or of its first part; with the rates at which it may ring.
TailEstimate estimateTail(const SpacingSamples& samples, double duration, const std::vector<RingingRate>& rates = {});

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the spacing does over the last tenth of a run: as it is, where the run went to its end, and as the first part of
// a run predicts it. Where the second half of what is there rings as the slider's modes do and as the waves of the
// disk make it (ringing_fit.h), that continues. Else three overlapping blocks of that half, each weighted by Hann's
// window so that the phase in which it begins and ends does not count, have means m_i and variances v_i. Where the
// variance still changes, by a constant factor r from block to block, it tends to
//
//   v = v_3 + (v_3 - v_2) r/(1 - r),  r = (v_3 - v_2)/(v_2 - v_1)          (Aitken 1926)
//
// or dies out, and the mean goes along, m = m_3 + (v - v_3) (m_3 - m_1)/(v_3 - v_1), as a motion shifts it by its
// square, or tends to a limit of its own as the variance does, where it creeps by more than a motion in it can make a
// block's mean differ.
//
// None of this knows what it leaves out: motion that is not small, a rough disk, a rate that changes. So a forecast is
// believed as far as the same forecast, made earlier, has come true: from 0.65 and from half of the part the rest of it
// is predicted, in stretches of the tail's length, and compared with what was seen there. What that missed at most is
// taken to grow in proportion to the time between what was known and what is predicted, as an unknown drift does. By
// how much the outcome moves when the last tenth, or fifth, of the part is left out is another measure; the largest of
// all is the uncertainty. Where there are too few samples for that, nothing is known. The kind is that of the part's
// last quarter; of a slider that goes in and out of contact it is not known how long it will.
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

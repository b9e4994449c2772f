// SPDX-License-Identifier: GPL-3.0-or-later
//
// How the motion of a slider ends. All reports and studies use this one verdict. It is judged by the minimum spacing s
// and by the contact, over the last part of a run compared with the parts before it:
//
//   at rest             s swings by no more than 0.02 nm, peak to peak, neither grows nor was about to move on
//   settles             the swing decays, and the contact neither begins nor ends lately
//   swings              the swing lasts, without contact
//   vibrates in contact the swing lasts, and the slider touches the disk all the time
//   bounces             the swing lasts, and the slider touches the disk and takes off
//   too short to tell   none of these: the last part holds less than 3 periods or 10 samples; or the contact has begun
//                       or ended before the last part, but lately; or the swing over a moving surface decays or grows;
//                       or the rarest feature of that surface has not passed in the last part
//
// The landing is left out: the run counts from the first time at which s enters the range that it has in the last
// tenth. The last part is the last tenth of the time from then on, or the last fifth or third where a shorter part
// holds less than 3 periods. Over a moving surface it is the last third, or up to half of the whole run where the wait
// for the rarest feature is longer (core/physics/disk/surface_recurrence.h), and whole periods of the surface where
// these fit in; the part before it may then hold the landing. The
// swing decays if it is below 90 % of that in the part before. It decays slowly if over the last six parts the contact
// neither begins nor ends, and the swings of the last three are below 97 % of those of the three before, in the mean.
// Over a moving surface, where the swing of a part is random, the standard deviation decays if it is below 60 % of that
// in the part before, and grows if that is below 60 % of it. What lasts there is forced: the disk drives it. Lately: in
// the last third of the run after the landing or the last two parts; over a moving surface in the part before the last.
//
// A period: s goes from the lowest quarter of its range in the part to the highest quarter and back. The frequency is
// that of whole periods: as these need not be symmetric, from rise to rise and from fall to fall. Where a period is
// shorter than 2.5 samples, the frequency is not told. Over a moving surface it is that of the largest peak in the
// spectrum of the last part, and told if a half of the part holds 3 periods of it and at least half of the variance
// lies between 0.8 and 1.25 of it. At rest it was not about to move on if the last half of the run swings by less than
// three times as much, or if s crossed its mean value of the last tenth there and back, or if the swings of the last
// three parts shrink so fast that, at the slower of their two rates, all later ones together stay within 0.02 nm.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/physics/disk/surface_recurrence.h"
#include "core/simulation/recording/run_summary.h"

namespace touchdown {

/// Samples of a run at equal intervals.
struct MotionSamples {
    std::vector<double> spacing;     // minimum spacing [m]
    std::vector<double> least, most; // its extremes since the sample before [m]; as many
    std::vector<Touch> touch;        // since the sample before; as many
    std::vector<double> switches;    // times at which the contact began or ended, rising [s]
    double first = 0.0;              // time of the first sample [s]
    double interval = 0.0;           // between samples [s]
    SurfaceRecurrence surface{};     // of a disk that is not flat and moves

    void add(double s, Touch touching) { add(s, s, s, touching); }
    void add(double s, double lowest, double highest, Touch touching);
    /// Forgets the oldest samples.
    void dropFirst(std::size_t count);
};

MotionVerdict judgeMotion(const MotionSamples& samples);

/// Whether the motion from the sample `first` on is faster than half of the sampling rate, so that its spectrum shows
/// it at a wrong frequency: the spacing turns back between the samples. What its range within an interval exceeds the
/// difference of the two samples by is, over half of its range there and in the neighbours, in the mean 0.36 of a sine
/// at half of the sampling rate, more above it, and 0.2 at 2.5 samples a period; the limit is 0.3.
bool isFolded(const MotionSamples& samples, std::size_t first);

// ------------------------------------------------------------------------------------------------ parts of the rule

struct MotionRule {
    static constexpr std::size_t fewestSamples = 10; // of a part that tells anything
    static constexpr double smallestSwing = 0.02e-9; // that matters, peak to peak [m]
    static constexpr double smallestDecay = 0.9;     // of the swing of sustained motion, from part to part [-]
    static constexpr double slowDecay = 0.97;        // and from three parts to the next three, in the mean [-]
    static constexpr double forcedDecay = 0.6;       // of the standard deviation over a moving surface [-]
    static constexpr double fewestPeriods = 3.0;
};

struct MotionEvidence {
    double share = 0.1;                              // of the last part, of the time after the landing [-]
    std::array<double, 6> swings{};                  // peak to peak, newest part first [m]
    std::size_t parts = 6;                           // that there are
    bool oneLaw = false;                             // the contact neither begins nor ends in all of them
    double rms = 0.0, rmsBefore = 0.0;               // standard deviation in the last part and in that before [m]
    double periods = 0.0;                            // in the last part
    double frequency = 0.0;                          // of the motion there [Hz]; 0: no single one, or not known
    bool undersampled = false;                       // a period is shorter than 2.5 samples
    bool movedOn = false;                            // in the half before the end, though at rest in the last tenth
    Touch touch = Touch::Never;                      // in the last part
    Touch touchBefore = Touch::Never;                // in the part before
    bool switchedLately = false;                     // contact began or ended in the last third or two parts
    std::size_t samples = MotionRule::fewestSamples; // there
    double length = 0.0;                             // of the last part [s]
    double duration = 0.0;                           // of all samples [s]
    SurfaceRecurrence surface{};
    double swing() const { return swings[0]; }
    bool decays() const { return decaysFast() || decaysSlowly(); }
    bool decaysFast() const;
    bool decaysSlowly() const;
    bool grows() const;
    /// The contact of the motion, and over a moving surface its size, are those shortly before.
    bool isSteady() const;
    /// The rarest feature of the surface has not passed in the last part.
    bool awaitsSurface() const { return length < almost * surface.wait; }
    /// Fewer periods than needed to tell, unless the part holds whole periods of the surface.
    bool lacksPeriods() const
    {
        return periods < MotionRule::fewestPeriods && !(surface.moves() && length > almost * surface.period);
    }
    /// The shortest run whose half holds it, in two digits [s].
    double telling() const;
    bool lastsSoLong() const { return duration > almost * telling(); }
    bool movesOn() const;

private:
    static constexpr double almost = 1.0 - 1e-9; // for round-off
};
MotionVerdict verdictOf(const MotionEvidence& evidence);

/// Whether the last half of the samples, whose last tenth is at rest, was about to move on.
bool movesOn(std::span<const double> lastHalf);

} // namespace touchdown

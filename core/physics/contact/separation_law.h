// SPDX-License-Identifier: GPL-3.0-or-later
//
// A law of contact that knows one length alone: the separation d of a pad and the disk's mean plane. It may remember
// how it came there, on a branch between two switches. The branch's forces continue beyond its ends, so that a step has
// smooth forces; who moves the pad ends the step at the switch and takes the law beyond.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "core/numerics/interval.h"
#include "core/physics/contact/gap_law.h"
#include "core/physics/contact/multi_asperity.h"
#include "core/physics/contact/ono_yamane.h"
#include "core/work/state_stream.h"

namespace touchdown {

/// Tangents of the forces at one separation, and what else acts there.
struct SeparationForces {
    AffineForce contact;       // >= 0 at d, away from the disk
    AffineForce adhesion;      // <= 0 at d
    double area = 0.0;         // real area of contact [m^2]; zero where the law has none
    double storedEnergy = 0.0; // elastic [J]
    double netAt(double d) const { return contact.at(d) + adhesion.at(d); } // [N]
};

class SeparationLaw {
public:
    virtual ~SeparationLaw() = default;

    /// False: no force acts on the present branch.
    virtual bool acts() const { return true; }
    /// At d [m] on the present branch, from the accepted state.
    virtual SeparationForces at(double separation) const = 0;
    /// The state at d becomes the accepted one.
    virtual void accept(double /*separation*/) {}

    /// The separations between which the present branch holds [m].
    virtual Interval interval() const { return {}; }
    /// Takes the branch beyond an end of the interval; returns the switch's name: "touch-down".
    virtual std::string cross(bool /*upper*/) { return {}; }
    /// Starts at d [m]: reached from afar (touch-down), or on the way out of a contact (take-off).
    virtual void begin(ContactBranch branch, double separation) = 0;

    /// Whether nothing acts at d [m] on the present branch, nor at any greater separation.
    virtual bool outOfReach(double separation) const { return separation > reach(); }
    /// The greatest separation at which a force acts on any branch [m].
    virtual double reach() const = 0;

    /// The accepted state, written or read.
    virtual void pass(StateStream& /*stream*/) {}
};

/// Ono and Yamane's five parameters. Regions with the same law are one branch.
class CharacteristicLaw final : public SeparationLaw {
public:
    explicit CharacteristicLaw(const OnoYamane& parameters);

    bool acts() const override { return region_ != ContactRegion::Apart; }
    SeparationForces at(double separation) const override;
    Interval interval() const override { return interval_; }
    std::string cross(bool upper) override;
    void begin(ContactBranch branch, double separation) override;
    bool outOfReach(double separation) const override
    {
        return region_ == ContactRegion::Apart && separation > takeOff_;
    }
    double reach() const override { return takeOff_; }
    void pass(StateStream& stream) override
    {
        stream(region_);
        setInterval();
    }

    /// The region whose law acts.
    ContactRegion region() const { return region_; }
    /// The lowest region with the same law is taken.
    void setRegion(ContactRegion region);

private:
    bool sameLaw(ContactRegion a, ContactRegion b) const;
    ContactRegion lastOfLaw(bool upper) const;
    void setInterval();

    OnoYamaneLaw law_;
    double takeOff_; // d_e [m]
    ContactRegion region_ = ContactRegion::Apart;
    Interval interval_; // in which its law holds [m]
};

/// A pressure of the gap on a pad without tilt over a flat disk, where the gap is d everywhere. It keeps no memory.
class UniformGapLaw final : public SeparationLaw {
public:
    /// `area` of the pad [m^2].
    UniformGapLaw(GapLaw law, double area) : law_(std::move(law)), area_(area) {}

    SeparationForces at(double separation) const override;
    void begin(ContactBranch, double) override {}
    double reach() const override { return law_.reach(); }

private:
    GapLaw law_;
    double area_; // [m^2]
};

/// Many asperities with menisci on a pad that deforms. Beyond a fold, where no state continues, the forces stay those
/// of the fold.
class MultiAsperityLaw final : public SeparationLaw {
public:
    explicit MultiAsperityLaw(MultiAsperity model);

    SeparationForces at(double separation) const override;
    void accept(double separation) override;
    Interval interval() const override;
    std::string cross(bool upper) override;
    void begin(ContactBranch branch, double separation) override;
    double reach() const override { return reach_; }
    void pass(StateStream& stream) override
    {
        stream(state_);
        if (stream.reads()) setState(state_);
    }

private:
    /// The state at d on the present branch, at most at its ends.
    MultiAsperityState stateAt(double separation) const;
    void setState(const MultiAsperityState& state);

    MultiAsperity model_;
    double reach_; // [m]
    MultiAsperityState state_;
    std::optional<MultiAsperityJump> touchDown_, takeOff_; // ahead, on the way in and out
};

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Simplified contact characteristic of Ono and Yamane, five parameters (Chen & Bogy, Fig. 3).
//
// d is the separation of the contact pad and the mean plane of the disk [m].
//
//   branch        d >= d_e            d_s < d < d_e                             d <= d_s
//   touch-down    F_cr = F_m = 0      F_cr = F_m = 0                            F_cr = f_c0 + k_c (d_s - d), F_m = -f_m
//   take-off      (touch-down)        by the take-off shape                     as touch-down
//
//   take-off shape    F_cr on the take-off branch             F_m there
//   constant          max(0, f_c0 + k_c (d_s - d))            -f_m
//   linear            max(0, f_c0 + k_c (d_s - d))            linear from -f_m at d_s to 0 at d_e
//   both-linear       linear from f_c0 at d_s to 0 at d_e     linear from -f_m at d_s to 0 at d_e
//
// The shape is a reading of Fig. 3; the paper gives no equation for it.
//
// A cycle of touch-down and take-off takes the work W = -integral of F_cr + F_m from d_s to d_e out of the slider, as
// the pad meets no force on its way down to d_s. Below d_s both ways are the same. With W < 0 each cycle gives energy
// to the slider: such a law can keep it bouncing for ever, and no real contact does that. The forces are affine, so W
// is integrated exactly; where F_cr ends below d_e, that is d_e >= d_s + f_c0/k_c, it is cycleWorkFormulas.
//
// d >= d_e selects the touch-down branch, d <= d_s the take-off branch; between them the branch is kept.
//
// Inside one region F_cr and F_m are affine in d: the law is a table of four rows, and smooth within a region.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace touchdown {

struct Interval;

enum class TakeOffShape : std::uint8_t { Constant, Linear, BothLinear };

/// "constant", "linear", "both-linear".
inline constexpr std::array<std::string_view, 3> takeOffShapeNames{"constant", "linear", "both-linear"};
constexpr std::string_view name(TakeOffShape shape) { return takeOffShapeNames[static_cast<std::size_t>(shape)]; }
/// W by take-off shape; the first two where d_e >= d_s + f_c0/k_c.
inline constexpr std::array<std::string_view, 3> cycleWorkFormulas{
    "f_m (d_e - d_s) - f_c0^2/(2 k_c)", "f_m (d_e - d_s)/2 - f_c0^2/(2 k_c)", "(f_m - f_c0) (d_e - d_s)/2"};
enum class ContactBranch : std::uint8_t { TouchDown, TakeOff };

/// The five parameters and the friction coefficient.
struct OnoYamane {
    double meniscusForce = 10.7e-3;    // f_m  [N], largest adhesion, >= 0
    double contactStiffness = 5.0e6;   // k_c  [N/m], >= 0
    double initialContactForce = 5e-3; // f_c0 [N], >= 0
    double touchDown = 3e-9;           // d_s  [m]
    double takeOff = 5e-9;             // d_e  [m], >= d_s
    double friction = 0.8;             // mu   [-], >= 0
    TakeOffShape takeOffShape = TakeOffShape::Constant;
    bool operator==(const OnoYamane&) const = default;
};

struct CharacteristicError {
    double worst = 0.0; // [-]
    double rms = 0.0;   // [-]
    double at = 0.0;    // d of the worst [m]
};

/// The five parameters that best describe another model (core/physics/contact/characteristic_fit.h).
struct CharacteristicFit {
    OnoYamane parameters;         // friction as it came
    CharacteristicError contact;  // of F_cr, against its largest value on the way
    CharacteristicError adhesion; // of F_m, against the largest adhesion
    double cycleWork = 0.0;       // of the other model's loop, kept by the parameters where d_e > d_s [J]
    double lostInJumps = 0.0;     // the part of it that the other model loses in its jumps [J]
    bool describes = false;
    std::string message; // a sentence: how well, or what the five parameters cannot say of this model
};

/// Branch and range of the separation.
enum class ContactRegion : std::uint8_t {
    Apart,   // touch-down branch above d_s: no force
    Pressed, // d <= d_s: asperities pressed, menisci formed
    Lifting, // take-off branch, asperities still pressed
    Bridged, // take-off branch, held by menisci alone
};

/// A change of the region as an event: "touch-down".
std::string switchName(ContactRegion before, ContactRegion now);
/// The branch after an event of this name; none where the name is not one of switchName.
std::optional<ContactBranch> branchAfterSwitch(std::string_view name);

/// constant + slope (d - from).
struct AffineForce {
    double constant = 0.0; // [N]
    double slope = 0.0;    // [N/m]
    double from = 0.0;     // [m]
    double at(double d) const { return constant + slope * (d - from); }
    bool operator==(const AffineForce&) const = default;
};

class OnoYamaneLaw {
public:
    explicit OnoYamaneLaw(const OnoYamane& parameters);

    /// The region's smooth laws.
    const AffineForce& contactLaw(ContactRegion region) const { return row(region).contact; }
    const AffineForce& adhesionLaw(ContactRegion region) const { return row(region).adhesion; }
    /// Real contact force F_cr >= 0 [N] at separation d [m].
    double contactForce(ContactRegion region, double d) const { return row(region).contact.at(d); }
    /// Adhesion force F_m <= 0 [N].
    double adhesionForce(ContactRegion region, double d) const { return row(region).adhesion.at(d); }
    /// Elastic energy of the pressed asperities: the work of F_cr on lifting [J].
    double storedEnergy(ContactRegion region, double d) const;
    /// W, see above [J]. Exactly 0 where its parts cancel but for round-off.
    double cycleWork() const;

    /// The separations between which the region's law holds [m].
    Interval interval(ContactRegion region) const;
    /// The region beyond the lower (upper) end of this one's interval.
    ContactRegion beyond(ContactRegion region, bool upper) const
    {
        return upper ? row(region).above : row(region).below;
    }

    /// The region of separation d on a branch.
    ContactRegion region(ContactBranch branch, double d) const;
    /// The branch on which a region lies.
    static ContactBranch branch(ContactRegion region)
    {
        return region == ContactRegion::Apart ? ContactBranch::TouchDown : ContactBranch::TakeOff;
    }
    /// The branch at separation d after `previous`, evaluated once per step in the paper's program.
    ContactBranch nextBranch(ContactBranch previous, double d) const;

private:
    struct Row {
        AffineForce contact;
        AffineForce adhesion;
        double lower = 0.0, upper = 0.0; // ends of its interval [m]
        ContactRegion below = ContactRegion::Apart;
        ContactRegion above = ContactRegion::Apart;
    };
    const Row& row(ContactRegion region) const { return rows_[static_cast<std::size_t>(region)]; }

    std::array<Row, 4> rows_;
    double release_; // [m], where F_cr ends on the take-off branch
};

/// The f_m with which W is `work` [J], all else equal [N]; 0 where none is that small. Needs takeOff > touchDown.
double meniscusForceForWork(const OnoYamane& parameters, double work);

} // namespace touchdown

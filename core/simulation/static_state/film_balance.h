// SPDX-License-Identifier: GPL-3.0-or-later
//
// All forces on a slider of one case at an attitude over which its film is steady, under a flat disk and one law of Ono
// and Yamane's characteristic:
//
//   G(q) = film(q) + contact(q) + load - K (q - q_0),   q = (height of the mass centre, pitch, roll)
//
// K of the suspension, q_0 where it exerts its load: the static state of the film alone. Without contact that state
// itself is sought, and G has no springs. The film's force includes the torques of its shear.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "core/simulation/contact/ono_yamane_contact.h"
#include "core/simulation/static_state/slider_body.h"

namespace touchdown {

struct FilmGaps;
struct FilmLevel;

/// Neither copied nor moved: its parts point at each other.
class FilmBalance {
public:
    using GoOn = std::function<bool()>;

    /// `c` is valid, with a film and Ono and Yamane's contact; spacing and gaps are of its slider, `rest` is q_0.
    FilmBalance(const Case& c, MinimumSpacing spacing, std::shared_ptr<const FilmGaps> gaps, const Attitude& rest);
    /// On a grid. Null where `goOn` ends the making.
    static std::unique_ptr<FilmBalance> make(const Case& c, const CellGrid& grid, const Attitude& rest,
                                             const GoOn& goOn);
    FilmBalance(const FilmBalance&) = delete;
    ~FilmBalance();

    /// Takes another's pressure and responses on the same grid for the start of the next solution.
    void startFrom(const FilmBalance& other);
    /// Makes the film steady at q; false where it is not solved.
    bool solve(const Vector3& q, const GoOn& goOn);

    /// All of the following but spacing() are at the last q.
    Vector3 force(ContactRegion region);                       // G
    Matrix3 stiffness(ContactRegion region, const GoOn& goOn); // -dG/dq
    /// The stiffness of small motions about q: with the suspension's springs, also apart.
    Matrix3 stiffnessWithSprings(ContactRegion region, const GoOn& goOn);
    Matrix3 contactStiffness(ContactRegion region);
    double netContactForce(ContactRegion region); // [N]
    /// |G| as a share of the preload [-].
    double error(const Vector3& force) const;
    /// Newton's step; zero for a held roll.
    Vector3 newtonStep(const Matrix3& stiffness, const Vector3& force) const;

    double spacing(const Vector3& q) const { return spacing_.at(body_.attitude(q)).spacing; }
    /// Two without roll.
    Eigen::Index unknowns() const { return body_.holdsRoll() ? 2 : 3; }
    /// Spacings between which a region's law holds [m].
    Interval interval(ContactRegion region);
    /// The lowest region with this one's law.
    ContactRegion lowest(ContactRegion region);
    /// The region of the pad at the last q, on the touch-down or the take-off branch.
    ContactRegion regionOn(ContactBranch branch) const;
    struct Beyond {
        ContactRegion region;
        std::string name; // "touch-down"
        bool jumps;       // the force, at the last q
        bool kinks;       // its slope
    };
    Beyond beyond(ContactRegion region, bool upper);

    const Case& setup() const { return case_; }
    const SliderBody& body() const { return body_; }
    FilmLevel& level() { return *level_; }
    const Vector3& place() const { return q_; }

private:
    Vector3 contactForce(ContactRegion region);
    const Matrix3& filmStiffness(const GoOn& goOn);

    Case case_;
    MinimumSpacing spacing_;
    SliderBody body_;
    SliderLoad load_;
    std::unique_ptr<FilmLevel> level_;
    OnoYamaneContact contact_;
    OnoYamaneLaw law_;
    Vector3 q_ = Vector3::Zero();
    std::optional<Matrix3> filmStiffness_; // at q_
};

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
//
// All forces on a slider of one case at an attitude over which its film is steady, with its contact:
//
//   G(q) = film(q) + contact(q) + load - K (q - q_0),   q = (height of the mass centre, pitch, roll)
//
// K of the suspension, q_0 where it exerts its load: the static state of the film alone. Without contact that state
// itself is sought, and G has no springs. The film's force includes the torques of its shear. A balance made without
// the contact is that of the film alone.
//
// The disk is flat, or what stands still under a contact that sees its surface; a surface that moves counts as its mean
// plane. Regions are those of Ono and Yamane's characteristic; under other laws they are Apart, or anything else in
// contact, whose branch begin() chooses.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/physics/disk/disk_topography.h"
#include "core/physics/film/film_slopes.h"
#include "core/simulation/contact/disk_under_film.h"
#include "core/simulation/contact/pad_contact.h"
#include "core/simulation/static_state/flying_attitude.h"
#include "core/simulation/static_state/slider_body.h"

namespace touchdown {

struct FilmGaps;
struct FilmLevel;
struct SteadyResult;

/// Neither copied nor moved: its parts point at each other.
class FilmBalance {
public:
    using GoOn = std::function<bool()>;

    enum class Contact : std::uint8_t { Acts, Out };
    /// `c` is valid, with a film, and with a contact that acts; spacing and gaps are of its slider, `rest` is q_0.
    /// Invalid where `goOn` ends the making.
    FilmBalance(const Case& c, MinimumSpacing spacing, std::shared_ptr<const FilmGaps> gaps, const Attitude& rest,
                const GoOn& goOn = {}, Contact contact = Contact::Acts);
    /// On a grid, with its gaps where they are known. Null where `goOn` ends the making.
    static std::unique_ptr<FilmBalance> make(const Case& c, const CellGrid& grid, std::shared_ptr<const FilmGaps> gaps,
                                             const Attitude& rest, const GoOn& goOn, Contact contact = Contact::Acts);
    /// At a static state of `c`, with the contact where that acts in it. Null where `goOn` ends the making, or the
    /// contact of the state is not solved again.
    static std::unique_ptr<FilmBalance> at(const Case& c, const SteadyResult& state, const GoOn& goOn = {});
    FilmBalance(const FilmBalance&) = delete;
    ~FilmBalance();

    /// Takes another's pressure and responses on the same grid for the start of the next solution.
    void startFrom(const FilmBalance& other);
    /// Makes the film steady at q; false where it is not solved.
    bool solve(const Vector3& q, const GoOn& goOn);

    /// The contact at q on a branch, then the film; the region that acts, nothing where the film or the contact is not
    /// solved.
    std::optional<ContactRegion> settle(const Vector3& q, ContactBranch branch, const GoOn& goOn);
    double residual() const { return residual_; } // of the film last solved [-]
    /// Places slider and contact at q, with the film as it is.
    void place(const Vector3& q, ContactBranch branch, ContactRegion region);
    /// All of the following but spacing() are at the last q.
    Vector3 force(ContactRegion region);                       // G
    Matrix3 stiffness(ContactRegion region, const GoOn& goOn); // -dG/dq
    /// The stiffness of small motions about q: with the suspension's springs, also apart.
    Matrix3 stiffnessWithSprings(ContactRegion region, const GoOn& goOn);
    Matrix3 contactStiffness(ContactRegion region);
    FlyingAttitude::Adjoint adjoint(ContactRegion region);
    const SliderContactForces& contactForces(ContactRegion region);
    double netContactForce(ContactRegion region) { return contactForces(region).load()[0]; } // [N]
    /// |G| as a share of the preload [-].
    double error(const Vector3& force) const;
    /// Newton's step; zero for a held roll.
    Vector3 newtonStep(const Matrix3& stiffness, const Vector3& force) const;

    const MinimumSpacing& spacings() const { return spacing_; }
    MinimumSpacing::Place nearest(const Vector3& q) const { return spacing_.at(body_.attitude(q)); }
    double spacing(const Vector3& q) const { return nearest(q).spacing; }
    /// Two without roll.
    Eigen::Index unknowns() const { return body_.holdsRoll() ? 2 : 3; }
    /// Spacings between which a region's law holds [m].
    Interval interval(ContactRegion region);
    /// The lowest region with this one's law.
    ContactRegion lowest(ContactRegion region);
    /// The contact as it is at q when that was reached from afar, or out of a contact; the region that then acts.
    ContactRegion begin(ContactBranch branch, const Vector3& q);
    /// The greatest spacing at which the contact exerts a force on any branch [m].
    double reach() const { return contact_ ? contact_->reach() : 0.0; }
    bool outOfReach(const Vector3& q) const { return !contact_ || contact_->outOfReach(body_.attitude(q)); }
    /// It must act.
    SliderContact& contact() { return *contact_; }
    /// Of the film at the last q, where the contact deforms the disk; else null.
    const FilmSlopes* filmSlopes();
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
    void setRegion(ContactRegion region);
    Vector3 contactForce(ContactRegion region) { return contactForces(region).load(); }
    const Matrix3& filmStiffness(const GoOn& goOn);
    void setSurface(const Attitude& attitude);
    /// Sets slopes_ and elasticStiffness_ at q_.
    void followElastic();
    void moveTo(const Vector3& q);

    Case case_;
    MinimumSpacing spacing_;
    SliderBody body_;
    SliderLoad load_;
    std::unique_ptr<FilmLevel> level_;
    DiskTopography topography_;
    DiskUnderFilm disk_;
    std::vector<double> surface_;            // under the film, less the deformation by contact; padded [m]
    std::unique_ptr<SliderContact> contact_; // null: it does not act
    CharacteristicLaw* law_ = nullptr;       // of contact_; null: another one
    std::optional<FilmSlopes> slopes_;       // of an elastic contact, at the last q, as its stiffness
    Matrix3 elasticStiffness_ = Matrix3::Zero();
    Vector3 q_ = Vector3::Zero();
    double residual_ = 0.0;
    std::optional<Matrix3> filmStiffness_; // at q_
};

} // namespace touchdown

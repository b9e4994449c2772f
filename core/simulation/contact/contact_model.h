// SPDX-License-Identifier: GPL-3.0-or-later
//
// The pad of the model "contact" and its law: one of the separation alone, or surfaces on cells. The pad is moved to
// separations d, of its lowest point and the disk's mean plane, and remembers how it came there: branch, menisci,
// adhesion.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/case/case.h"
#include "core/physics/contact/ono_yamane.h"
#include "core/physics/contact/strongest_pull.h"
#include "core/physics/disk/surface_statistics.h"
#include "core/simulation/contact/contact_doubts.h"
#include "core/simulation/recording/field_snapshot.h"
#include "core/simulation/recording/quantity.h"
#include "core/work/state_stream.h"

namespace touchdown {

/// Forces on the pad at one separation. Values that a law does not have are zero.
struct ContactForces {
    double separation = 0.0;                          // d [m]
    double contact = 0.0;                             // >= 0, away from the disk [N]
    double adhesion = 0.0;                            // <= 0 [N]
    double area = 0.0;                                // real area of contact [m^2]
    double peakPressure = 0.0;                        // of contact [Pa]
    double minimumGap = 0.0;                          // of the deformed surfaces [m]
    double energy = 0.0;                              // stored by an elastic contact, with its adhesion [J]
    double fittedContact = 0.0, fittedAdhesion = 0.0; // of the five parameters that were fitted [N]
    int iterations = 0;                               // of the solution
    std::string problem;                              // a sentence, when it did not converge; "" when it did
    void pass(auto& stream)
    {
        stream(separation, contact, adhesion, area, peakPressure, minimumGap, energy, fittedContact, fittedAdhesion,
               iterations, problem);
    }
    double net() const { return contact + adhesion; } // [N]
};

/// A switch or a jump of the law on the pad's way.
struct ContactSwitch {
    double separation = 0.0; // [m]
    std::string name;        // "touch-down"
};

/// What a straight move passed.
struct PadMove {
    std::vector<ContactSwitch> switches; // in their order
    std::vector<PullPoint> pulls;        // way out, of a law that does not jump elsewhere: the strongest, net
};

class ContactModel {
public:
    virtual ~ContactModel() = default;

    /// Moves the pad straight from where it is to d [m]; the disk's surface is where it is at time t [s].
    virtual const ContactForces& move(double separation, double time) = 0;

    /// Of the last move.
    const PadMove& way() const { return way_; }
    /// Whether the force can jump where no switch says so, and whether it may have on the last move: the way
    /// decides, see core/physics/contact/contact_jump.h.
    virtual bool canJump() const { return false; }
    virtual bool mayHaveJumped() const { return false; }
    /// Stores the present state in one of two places; returns to it.
    virtual void remember(std::size_t /*place*/ = 0) {}
    virtual void recall(std::size_t /*place*/ = 0) {}

    /// All that the next move depends on, written or read.
    virtual void pass(StateStream& stream) = 0;

    /// Fills the values of contactMaps() after a move.
    virtual void observe(FieldSnapshot& snapshot) const { snapshot.values.clear(); }
    /// Errors of the last state that come from its grid and its patch; not known if `goOn` returns false.
    virtual ContactDoubts doubts(const std::function<bool()>& /*goOn*/) const { return {}; }
    /// What was assumed or left out, in sentences.
    virtual std::vector<std::string> remarks() const { return {}; }
    virtual std::optional<CharacteristicFit> fit() const { return std::nullopt; }
    virtual std::optional<SurfaceStatistics> surfaceStatistics() const { return std::nullopt; }

protected:
    PadMove way_;
};

/// `c` is valid, of the model "contact". If `goOn`, asked within long solutions, returns false they have a problem.
/// `coarser`: a pad with a grid gets cells twice as large.
std::unique_ptr<ContactModel> makeContactModel(const Case& c, const std::function<bool()>& goOn = {},
                                               bool coarser = false);

/// A state as it is recorded, and what a run of the case records of it.
struct ContactSample {
    const ContactForces& forces;
    double friction = 0.0, frictionTorque = 0.0; // [N], [N m]
};
using ContactRows = std::vector<RecordedQuantity<ContactSample>>;
ContactRows contactRows(const Case& c);
void contactValues(const Case& c, const ContactRows& rows, const ContactForces& forces, double* values);
inline std::vector<Quantity> contactQuantities(const Case& c) { return quantitiesOf(contactRows(c)); }
/// Over the patch that holds the pad's lowest point; empty where the law has no surfaces.
RecordedFields contactMaps(const Case& c);

} // namespace touchdown

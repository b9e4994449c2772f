// SPDX-License-Identifier: GPL-3.0-or-later
//
// Contact, adhesion and friction between a flying slider and the disk, by the attitude of the slider and the time that
// the disk's surface has moved. A law with memory (branches, snaps) continues from the last accepted state, so that a
// time step may be tried repeatedly.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/numerics/interval.h"
#include "core/numerics/small_matrix.h"
#include "core/physics/slider/attitude.h"
#include "core/simulation/contact/contact_doubts.h"
#include "core/simulation/recording/field_snapshot.h"

namespace touchdown {

class DiskTopography;
class MinimumSpacing;
class StateStream;
enum class ContactBranch : std::uint8_t;
struct Case;
struct PaddedGrid;

/// Forces of a contact on a flying slider at one attitude.
struct SliderContactForces {
    double contact = 0.0;      // >= 0, away from the disk [N]
    double adhesion = 0.0;     // <= 0 [N]
    double friction = 0.0;     // in the disk's direction [N]
    double pitchTorque = 0.0;  // of the three about the mass centre, nose up [N m]
    double rollTorque = 0.0;   // inner edge up [N m]
    double area = 0.0;         // real area of contact [m^2]; zero if the law has none
    double peakPressure = 0.0; // of contact [Pa]
    double storedEnergy = 0.0; // elastic [J]
    int iterations = 0;        // of the solution
    std::string problem;       // a sentence, when it did not converge; "" when it did
    void pass(auto& stream)
    {
        stream(contact, adhesion, friction, pitchTorque, rollTorque, area, peakPressure, storedEnergy, iterations,
               problem);
    }
    Vector3 load() const { return {contact + adhesion, pitchTorque, rollTorque}; }
};

class SliderContact {
public:
    virtual ~SliderContact() = default;

    /// At an attitude and the position of the disk's surface at `time` [s], from the last accepted state.
    virtual const SliderContactForces& at(const Attitude& attitude, double time) = 0;
    /// About -d(force, pitch, roll torque)/d(height of the mass centre, pitch, roll) at the last call, for Newton.
    virtual Matrix3 stiffness() const = 0;
    /// Whether nothing acts there at any time; then at() is cheap.
    virtual bool outOfReach(const Attitude& attitude) const = 0;
    /// The greatest minimum spacing at which a force may act, however the contact was reached [m]; unbounded by
    /// default.
    virtual double reach() const { return std::numeric_limits<double>::infinity(); }
    /// The last call's state becomes the accepted one.
    virtual void accept() = 0;
    /// The state at an attitude that was reached from afar (touch-down) or out of a contact (take-off) becomes the
    /// accepted one; of a law without such branches, nothing changes.
    virtual void begin(ContactBranch /*branch*/, const Attitude& /*attitude*/) {}

    /// The separation that switches the law, and the interval in which the accepted law holds. cross() takes the law
    /// beyond an end and returns the switch's name: "touch-down".
    virtual double separation(const Attitude&) const { return 0.0; }
    virtual Interval interval() const { return {}; }
    virtual std::string cross(bool /*upper*/) { return {}; }

    /// Longest step with which a moving surface is followed while it is in reach [s].
    virtual double longestStep() const { return std::numeric_limits<double>::infinity(); }
    /// Whether it displaces the disk; then its stiffness() is rough.
    virtual bool deforms() const { return false; }
    /// Subtracts the disk's mean displacement by contact in each cell from `height` (padded) [m]; false if none.
    virtual bool deform(std::span<double> /*height*/) const { return false; }
    /// Sets `field` (padded) to zero in the film's cells where the surfaces touch.
    virtual void clearTouching(std::span<double> /*field*/) const {}

    /// From now on the slider moves about one attitude; of the places where it may bear, only those are looked at that
    /// a displacement of its corners by `margin` [m] can bring nearest (NearbySpacing).
    virtual void moveLittle(double /*margin*/) {}

    /// Fills the values of contactFields() at the last call.
    virtual void observe(FieldSnapshot& snapshot) const { snapshot.values.clear(); }
    /// Errors, from grid and patches, of the accepted state of the largest contact force. It replaces
    /// the last state: the run is over. If `goOn` returns false it is not known.
    struct Doubts {
        ContactDoubts of;
        double contact = 0.0, adhesion = 0.0; // forces of that state [N]
    };
    virtual Doubts doubts(const std::function<bool()>& /*goOn*/) { return {}; }
    /// What was assumed or left out, in sentences.
    virtual std::vector<std::string> remarks() const { return {}; }
    /// A sentence where the slider touches outside the modelled patches; else empty.
    virtual std::string problemAt(const Attitude&) const { return {}; }
    /// The accepted state, written or read.
    virtual void pass(StateStream& /*stream*/) {}
};

/// `c` is valid, of the model "film"; null if only air acts. The spacing and the surface must last. `pad` and `grid`
/// are the film's. `goOn` is asked meanwhile and within long solutions; if it returns false they end with a problem.
std::unique_ptr<SliderContact> makeSliderContact(const Case& c, const MinimumSpacing& spacing,
                                                 const DiskTopography& surface, const CellGrid& grid,
                                                 const PaddedGrid& pad, const std::function<bool()>& goOn = {});

/// Longest step with which a contact follows a surface that moves over lengths of at least `shortest` [m] [s].
double longestStepOver(const Case& c, const DiskTopography& surface, double shortest,
                       const std::function<bool()>& goOn);

/// The first patch that can touch, with its fields; empty where the law has no surfaces.
RecordedFields sliderContactFields(const Case& c, const std::function<bool()>& goOn = {});

} // namespace touchdown

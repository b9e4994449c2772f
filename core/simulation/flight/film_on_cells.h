// SPDX-License-Identifier: GPL-3.0-or-later
//
// The film of a run, solved on its cells in each step.
#pragma once

#include <span>
#include <vector>

#include "core/physics/film/film_loads.h"
#include "core/physics/film/gas_film.h"
#include "core/simulation/contact/disk_under_film.h"
#include "core/simulation/contact/slider_contact.h"
#include "core/simulation/flight/film_in_time.h"
#include "core/simulation/flight/film_response.h"

namespace touchdown {

/// Allocates at construction alone.
class FilmOnCells final : public FilmInTime {
public:
    /// All must last; contact and disk may be null. `start`: the pressures with which it begins (padded) [Pa].
    FilmOnCells(GasFilm& film, const SliderBody& body, SliderContact* contact, DiskUnderFilm* disk,
                const FilmStepOptions& options, std::span<const double> start);

    void start(const SliderMotion& motion, double time) override;
    void setDisk(double time, bool touched) override;
    FilmStepResult step(double dt, const SliderMotion& from, const Vector3& q, double rate) override;
    Vector3 force() override;
    const Matrix3& stiffness() const override { return response_.stiffness(); }
    double stiffnessError() const override { return 0.02; }
    bool isResponseKnown() const override { return response_.known(); }
    bool isResponseOld() const override { return response_.isOld(); }
    int renewResponse(bool touched, const std::function<bool()>& goOn) override;
    void outdateResponse() override { response_.outdate(); }
    double follow(const Vector3& q, const Vector3& change) override;
    double allowed() const override { return stepper_.allowed(); }
    std::array<double, 3> timeErrorLoad() const override { return stepper_.timeErrorLoad(); }
    bool accept(const SliderMotion& to) override;
    bool isFitted() const override { return stepper_.isFitted(); }
    long long closings() const override { return stepper_.closings(); }
    double ambientForce() const override;
    Vector3 shearTorques() const override
    {
        return {0.0, -body_.shearArm() * shear_[0], -body_.shearArm() * shear_[1]};
    }
    FilmEnergyState energy() override { return energy_.at(stepper_.pressure()); }
    double surfaceWork() override;
    void pass(StateStream& stream) override;

    /// Of the last step; padded [Pa].
    std::span<const double> pressure() const { return stepper_.pressure(); }

private:
    bool isRough() const { return disk_ && !disk_->flat(); }
    void rememberWork();

    GasFilm& film_;
    FilmLoads loads_;
    const SliderBody& body_;
    SliderContact* contact_; // null: none
    DiskUnderFilm* disk_;    // null: flat
    std::span<const double> startPressure_;
    FilmStepper stepper_;
    FilmResponse response_;
    FilmEnergy energy_;
    std::vector<double> change_, surface_; // surface_: of the disk; padded [m]
    double surfaceTime_ = -1.0;            // of surface_ [s]
    bool deformed_ = false;                // surface_, by the contact
    std::array<double, 2> shear_{};
    // At the last call of surfaceWork(), where the disk may not be flat; padded [Pa], [m].
    std::vector<double> workPressure_, workSurface_;
};

} // namespace touchdown

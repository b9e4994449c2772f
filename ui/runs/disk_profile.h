// SPDX-License-Identifier: GPL-3.0-or-later
//
// The heights of the disk of a film case along the slider's centre line, moved with the disk or held still as under the
// film (core/simulation/contact/disk_under_film.h). The surface is made on another thread, as that of a long track
// takes a second.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include <QObject>
#include <QString>

#include "core/case/case.h"
#include "core/physics/disk/disk_topography.h"
#include "ui/calculation/task_queue.h"

namespace touchdown {

class DiskProfile : public QObject {
    Q_OBJECT

public:
    explicit DiskProfile(QObject* parent) : QObject(parent) {}
    ~DiskProfile() override { stop_.request_stop(); }

    enum class State : std::uint8_t { Flat, BeingMade, Uneven, Failed };

    /// Begins to make the surface, if it is another one; nothing: flat.
    void setCase(const std::optional<Case>& c);
    State state() const { return state_; }
    /// Why it failed: "" where it did not.
    const QString& problem() const { return problem_; }
    /// Whether nothing is known but the mean plane.
    bool empty() const { return !surface_; }
    /// From the leading to the trailing edge at this time [m]: the smallest and the largest height in each of equal
    /// parts of the length, in the order in which they come. Empty if empty().
    std::vector<double> at(double time) const;
    /// At a distance from the leading edge [m]; 0 if empty().
    double heightAt(double x, double time) const;

signals:
    /// Or it failed.
    void made();

private:
    Case case_;
    State state_ = State::Flat;
    QString problem_;
    std::shared_ptr<const DiskTopography> surface_;
    std::stop_source stop_; // of the surface that is being made
    TaskQueue queue_{this};
};

} // namespace touchdown

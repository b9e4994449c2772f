// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/disk/disk_surface_controller.h"

#include <exception>

namespace touchdown {

namespace {

constexpr int quiet = 250; // [ms]

} // namespace

DiskSurfaceController::DiskSurfaceController(Maker maker, QObject* parent)
    : CalculationController(parent), maker_(std::move(maker))
{
    pause_.setSingleShot(true);
    pause_.setInterval(quiet);
    connect(&pause_, &QTimer::timeout, this, &DiskSurfaceController::make);
}

void DiskSurfaceController::request(const Case& c)
{
    wanted_ = c;
    busy_ = true;
    ++requested_;
    pause_.start();
}

void DiskSurfaceController::cancel()
{
    pause_.stop();
    busy_ = false;
    ++requested_;
}

void DiskSurfaceController::make()
{
    if (active()) return; // `deliver` calls again
    making_ = requested_;
    begin([this, c = wanted_](const std::stop_token&) {
        DiskSurfacePreview preview;
        try {
            preview = maker_(c);
        } catch (const std::exception& problem) { // a map that is too large for the memory
            preview = {};
            preview.problem = std::string("The surface cannot be made: ") + problem.what();
        }
        mailbox_.post([&](std::optional<DiskSurfacePreview>& mail) { mail = std::move(preview); });
    });
}

void DiskSurfaceController::deliver()
{
    std::optional<DiskSurfacePreview> ready = mailbox_.take();
    if (!ready) return;
    end();
    if (!busy_ || pause_.isActive()) return;
    if (making_ != requested_) {
        make();
        return;
    }
    busy_ = false;
    made_ = std::move(*ready);
    emit made();
}

} // namespace touchdown

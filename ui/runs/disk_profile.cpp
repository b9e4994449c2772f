// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/disk_profile.h"

#include <algorithm>
#include <array>

#include "core/case/disk_setup.h"
#include "core/simulation/contact/disk_under_film.h"
#include "ui/slider/slider_profile.h"

namespace touchdown {

namespace {

constexpr int samples = 8; // in each part

} // namespace

void DiskProfile::setCase(const std::optional<Case>& c)
{
    const Case next = c.value_or(Case{});
    if (next.diskSurface == case_.diskSurface && next.folder == case_.folder) {
        case_ = next; // its speed may be another one
        return;
    }
    case_ = next;
    state_ = State::Flat;
    problem_.clear();
    surface_.reset();
    stop_.request_stop();
    stop_ = {};
    if (case_.diskSurface.kind == DiskSurfaceKind::Flat) return;
    state_ = State::BeingMade;
    auto result = std::make_shared<std::shared_ptr<const DiskTopography>>();
    queue_.post(
        [result, next, stop = stop_.get_token()] {
            auto surface = std::make_shared<const DiskTopography>(
                diskTopography(next, [&stop] { return !stop.stop_requested(); }));
            if (!surface->flat()) *result = surface;
            return QString();
        },
        [this, result, stop = stop_.get_token()](const QString& problem) {
            if (stop.stop_requested()) return;
            surface_ = *result;
            problem_ = problem;
            state_ = !problem.isEmpty() ? State::Failed : surface_ ? State::Uneven : State::Flat;
            emit made();
        });
}

std::vector<double> DiskProfile::at(double time) const
{
    std::vector<double> heights;
    if (empty()) return heights;
    constexpr int parts = SliderProfile::along;
    const Velocity velocity = surfaceVelocity(case_, *surface_);
    const double step = case_.slider.length / (parts * samples);
    const double y = 0.5 * case_.slider.width - velocity.y * time;
    for (int part = 0; part < parts; ++part) {
        std::array<double, samples> within{};
        for (int i = 0; i < samples; ++i)
            within[static_cast<std::size_t>(i)] =
                surface_->height((part * samples + i + 0.5) * step - velocity.x * time, y);
        const auto [low, high] = std::ranges::minmax_element(within);
        heights.push_back(*std::min(low, high));
        heights.push_back(*std::max(low, high));
    }
    return heights;
}

double DiskProfile::heightAt(double x, double time) const
{
    if (empty()) return 0.0;
    const Velocity velocity = surfaceVelocity(case_, *surface_);
    return surface_->height(x - velocity.x * time, 0.5 * case_.slider.width - velocity.y * time);
}

} // namespace touchdown

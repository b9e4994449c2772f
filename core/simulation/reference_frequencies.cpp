// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/reference_frequencies.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "core/case/contact_law.h"
#include "core/physics/disk/disk_surface_check.h"
#include "core/physics/disk/disk_velocity.h"
#include "core/simulation/equilibria/spring_equilibria.h"
#include "core/simulation/springs/spring_model.h"

namespace touchdown {

namespace {

constexpr double radiansPerCycle = 2.0 * std::numbers::pi;

/// Frequencies of the springs about their static state above a flat disk under one law [Hz], lowest first.
std::vector<double> springFrequencies(const SpringModel& model, ContactRegion contact)
{
    std::vector<double> found;
    for (const std::complex<double> s : eigenvaluesAt(model, model.staticState().head<2>(), {true, true, contact}))
        if (s.imag() > 0.0) found.push_back(s.imag() / radiansPerCycle);
    std::ranges::sort(found);
    return found;
}

void addNumbered(std::vector<ReferenceFrequency>& list, FrequencyKind kind, const std::string& name,
                 const std::vector<double>& frequencies)
{
    for (std::size_t i = 0; i < frequencies.size(); ++i)
        if (frequencies[i] > 0.0)
            list.push_back({kind, frequencies[i], frequencies.size() > 1 ? name + " " + std::to_string(i + 1) : name});
}

std::vector<double> waveFrequencies(const Case& c)
{
    const DiskSurface& surface = c.diskSurface;
    if (!hasWaves(surface) || surface.motion != SurfaceMotion::Moving) return {};
    const SliderCase& slider = c.slider;
    const Velocity disk = diskVelocity(c.disk, slider.length, slider.width, 0.5 * slider.length, 0.5 * slider.width);
    std::vector<double> found;
    for (std::size_t i = 0; i < surface.waveLengths.size(); ++i) {
        const double angle = surface.waveAngles.empty() ? 0.0 : surface.waveAngles[i];
        found.push_back(std::abs(disk.x * std::cos(angle) + disk.y * std::sin(angle)) / surface.waveLengths[i]);
    }
    return found;
}

} // namespace

std::vector<ReferenceFrequency> referenceFrequencies(const Case& c)
{
    std::vector<ReferenceFrequency> list;
    if (c.model == ModelKind::Contact) return list;
    const auto law = characteristic(c);
    const bool hasContact = law && law->contactStiffness > 0.0;
    std::vector<double> contact;
    if (c.model == ModelKind::Springs) {
        const SpringModel model(c);
        addNumbered(list, FrequencyKind::Mode, "mode", springFrequencies(model, ContactRegion::Apart));
        const std::vector<double> pressed = springFrequencies(model, ContactRegion::Pressed);
        if (hasContact && !pressed.empty()) contact = {pressed.back()};
    } else if (hasContact) {
        contact = {std::sqrt(law->contactStiffness / c.slider.mass) / radiansPerCycle};
    }
    addNumbered(list, FrequencyKind::Wave, "wave", waveFrequencies(c));
    addNumbered(list, FrequencyKind::Contact, "contact", contact);
    return list;
}

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/slider_profile.h"

#include <algorithm>

#include "core/physics/slider/recess.h"

namespace touchdown {

SliderProfile::SliderProfile(const Case& c) : length_(c.slider.length), width_(c.slider.width)
{
    const Recess recess(c.surface, length_, width_);
    recess_.reserve(static_cast<std::size_t>((along + 1) * (across + 1)));
    for (int j = 0; j <= across; ++j)
        for (int i = 0; i <= along; ++i) recess_.push_back(recess.at(length_ * i / along, width_ * j / across));
}

double SliderProfile::gap(int i, int j, const Attitude& attitude) const
{
    const double x = length_ * i / along, y = width_ * j / across;
    return recess_[static_cast<std::size_t>(j * (along + 1) + i)] + attitude.height + attitude.pitch * (length_ - x) -
           attitude.roll * (y - 0.5 * width_);
}

std::vector<double> SliderProfile::fromSide(const Attitude& attitude) const
{
    std::vector<double> heights;
    for (int i = 0; i <= along; ++i) {
        double lowest = gap(i, 0, attitude);
        for (int j = 1; j <= across; ++j) lowest = std::min(lowest, gap(i, j, attitude));
        heights.push_back(lowest);
    }
    return heights;
}

std::vector<double> SliderProfile::fromRear(const Attitude& attitude) const
{
    std::vector<double> heights;
    for (int j = 0; j <= across; ++j) {
        double lowest = gap(0, j, attitude);
        for (int i = 1; i <= along; ++i) lowest = std::min(lowest, gap(i, j, attitude));
        heights.push_back(lowest);
    }
    return heights;
}

} // namespace touchdown

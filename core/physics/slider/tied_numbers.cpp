// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/slider/tied_numbers.h"

#include <cmath>
#include <utility>

namespace touchdown {

TiedNumbers::TiedNumbers(std::size_t count) : links_(count)
{
    for (std::size_t i = 0; i < count; ++i) links_[i].parent = i;
}

TiedNumbers::Root TiedNumbers::rootOf(std::size_t number) const
{
    Root root{number, 1.0, 0.0};
    while (links_[root.at].parent != root.at) {
        const Link& link = links_[root.at];
        root = {link.parent, root.sign * link.sign, root.sign * link.offset + root.offset};
    }
    return root;
}

double TiedNumbers::fixRoot(std::size_t root, double value)
{
    std::optional<double>& known = links_[root].value;
    if (!known) known = value;
    const double by = *known - value;
    return std::abs(by) > reach ? by : 0.0;
}

double TiedNumbers::fix(std::size_t number, double value)
{
    const Root root = rootOf(number);
    return fixRoot(root.at, root.sign * (value - root.offset));
}

double TiedNumbers::tie(std::size_t number, double sign, std::size_t other, double offset)
{
    Root a = rootOf(number), b = rootOf(other);
    // root of a = turn * root of b + shift
    const double turn = a.sign * sign * b.sign;
    double shift = a.sign * (sign * b.offset + offset - a.offset);
    if (a.at == b.at) {
        if (turn < 0.0) return fixRoot(a.at, 0.5 * shift);
        return std::abs(shift) > reach ? shift : 0.0;
    }
    const std::optional<double> ofA = links_[a.at].value, ofB = links_[b.at].value;
    if (ofA && ofB) return fixRoot(a.at, turn * *ofB + shift);
    if (links_[a.at].size > links_[b.at].size) {
        std::swap(a, b);
        shift *= -turn;
    }
    Link &child = links_[a.at], &parent = links_[b.at];
    if (child.value) parent.value = turn * (*child.value - shift);
    parent.size += child.size;
    child.parent = b.at;
    child.sign = turn;
    child.offset = shift;
    return 0.0;
}

std::optional<double> TiedNumbers::value(std::size_t number) const
{
    const Root root = rootOf(number);
    if (!links_[root.at].value) return {};
    return root.sign * *links_[root.at].value + root.offset;
}

} // namespace touchdown

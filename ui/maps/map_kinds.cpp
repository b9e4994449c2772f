// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/maps/map_kinds.h"

#include <algorithm>

#include "ui/style/translate.h"

namespace touchdown {

namespace {

constexpr double weakPressure = 1e5; // contact: a logarithmic scale about zero shows a smaller value as zero [Pa]

bool isAir(const Quantity& quantity) { return quantity.name == "air_pressure"; }

MapKind kindOf(const Quantity& quantity, bool film)
{
    using Colours = MapKind::Colours;
    using Logarithm = MapKind::Logarithm;
    if (isAir(quantity)) // suction is negative
        return {tr("Air pressure above ambient"),
                {"kPa", "atm", "MPa"},
                Colours::Signed,
                Logarithm::Offered,
                nearAmbient,
                true,
                aboveAmbientSymbol()};
    const QString title = QString::fromStdString(quantity.longName);
    std::vector<std::string> units{quantity.displayUnit};
    const auto offer = [&units](const char* unit) {
        if (std::ranges::find(units, unit) == units.end()) units.push_back(unit);
    };
    if (quantity.unit == "Pa") { // attraction is negative
        offer("MPa");
        offer("GPa");
        // The contact pressure is zero where there is no contact, and zero has no logarithm.
        const bool contact = quantity.name == "contact_pressure";
        return {title, units, Colours::Signed, contact ? Logarithm::None : Logarithm::Offered, weakPressure};
    }
    if (quantity.unit == "m") {
        offer("nm");
        offer("um");
    }
    if (quantity.name == "gap") // a recess is a thousand times as far from the disk as a pad
        return {title, units, Colours::BrightLow, film ? Logarithm::AtFirst : Logarithm::Offered};
    return {title, units, Colours::Signed, Logarithm::None, 0.0, true};
}

QString shortName(const Quantity& quantity, bool besideAFilm)
{
    if (isAir(quantity)) return tr("Air pressure");
    if (quantity.name == "gap") return besideAFilm ? tr("Contact gap") : tr("Gap");
    if (quantity.name == "adhesion_pressure") return tr("Adhesion");
    if (quantity.name == "disk_surface") return tr("Disk");
    return QString::fromStdString(quantity.longName);
}

} // namespace

std::vector<RunField> runFields(const std::vector<RecordedFields>& sets)
{
    std::vector<RunField> list;
    for (std::size_t s = 0; s < sets.size(); ++s) {
        const bool film = std::ranges::any_of(sets[s].quantities, isAir);
        for (std::size_t f = 0; f < sets[s].quantities.size(); ++f) {
            const Quantity& quantity = sets[s].quantities[f];
            list.push_back({s, f, shortName(quantity, s > 0), QString::fromStdString(quantity.longName),
                            kindOf(quantity, film), isAir(quantity)});
        }
    }
    return list;
}

} // namespace touchdown

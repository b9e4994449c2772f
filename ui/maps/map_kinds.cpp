// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/maps/map_kinds.h"

#include <algorithm>

#include <QCoreApplication>

namespace touchdown {

namespace {

constexpr double weakPressure = 1e5; // contact: a logarithmic scale about zero shows a smaller value as zero [Pa]
constexpr double nearAmbient = 1e3;  // likewise, of air [Pa]

QString tr(const char* text) { return QCoreApplication::translate("touchdown::RunMaps", text); }

bool isAir(const Quantity& quantity) { return quantity.name == "air_pressure"; }

MapKind kindOf(const Quantity& quantity, bool film)
{
    using Colours = MapKind::Colours;
    MapKind kind;
    kind.title = isAir(quantity) ? tr("Air pressure above ambient") : QString::fromStdString(quantity.longName);
    kind.units = {quantity.displayUnit};
    const auto offer = [&kind](const char* unit) {
        if (std::ranges::find(kind.units, unit) == kind.units.end()) kind.units.push_back(unit);
    };
    if (quantity.unit == "Pa") {
        if (isAir(quantity)) {
            kind.units.clear();
            offer("kPa");
            offer("atm");
        }
        offer("MPa");
        if (!isAir(quantity)) offer("GPa");
        kind.colours = Colours::Signed; // attraction is negative, and so is suction
        // Pressure of contact is zero where there is none, so that only what has two signs can have a logarithm.
        if (quantity.name != "contact_pressure") kind.logarithm = MapKind::Logarithm::Offered;
        kind.near = isAir(quantity) ? nearAmbient : weakPressure;
        kind.aboutZero = isAir(quantity);
    } else if (quantity.name == "gap") {
        kind.colours = Colours::BrightLow;
        // Recesses are a thousand times as far from the disk as the pads.
        kind.logarithm = film ? MapKind::Logarithm::AtFirst : MapKind::Logarithm::Offered;
    } else {
        kind.colours = Colours::Signed;
        kind.aboutZero = true;
    }
    if (quantity.unit == "m") {
        offer("nm");
        offer("um");
    }
    return kind;
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

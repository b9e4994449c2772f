// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/contact_check.h"

#include <algorithm>
#include <cmath>

#include "core/physics/disk_surface_check.h"
#include "core/simulation/decimal.h"
#include "core/simulation/units.h"

namespace touchdown {

namespace {

using Problems = std::vector<CaseProblem>;

/// To four digits, for a message.
std::string inNanometres(double length) { return decimalText(length, 9, 4) + " nm"; }
std::string inMicrometres(double length) { return decimalText(length, 6, 4) + " um"; }

/// A whole number of cells to within rounding of both, and not too many.
void checkSide(const char* key, double side, double cell, Problems& problems)
{
    const double cells = std::round(side / cell);
    const std::string ofCells = inMicrometres(side) + " with elastic.cell = " + inMicrometres(cell);
    if (cells < fewestPatchCells || cells > mostPatchCells)
        problems.push_back({key, ofCells + " makes " + decimalText(cells, 0, 6) + " cells; from " +
                                     std::to_string(fewestPatchCells) + " to " + std::to_string(mostPatchCells) +
                                     " are possible"});
    else if (std::abs(side - cells * cell) > 1e-6 * cell)
        problems.push_back({key, ofCells + " is no whole number of cells; the nearest length is " +
                                     inMicrometres(cells * cell)});
}

void checkPad(const Case& c, Problems& problems)
{
    if (c.pad.shape != PadShape::Slider) {
        checkSide("pad.length", c.pad.length, c.elastic.cell, problems);
        checkSide("pad.width", c.pad.width, c.elastic.cell, problems);
    } else if (c.elastic.periodic) {
        problems.push_back({"elastic.periodic", "must be false with pad.shape \"slider\", whose pads do not repeat"});
    }
}

void checkElastic(const Case& c, Problems& problems)
{
    checkPad(c, problems);
}

} // namespace

void checkCharacteristic(const OnoYamane& parameters, Problems& problems)
{
    if (parameters.takeOff < parameters.touchDown)
        problems.push_back({"ono_yamane.take_off", "d_e = " + inNanometres(parameters.takeOff) +
                                                       " must be at least ono_yamane.touch_down (d_s = " +
                                                       inNanometres(parameters.touchDown) + ")"});
}

void checkContact(const Case& c, Problems& problems)
{
    if (c.approach.closest >= c.approach.start)
        problems.push_back({"approach.closest", inNanometres(c.approach.closest) +
                                                    " must be less than approach.start (" +
                                                    inNanometres(c.approach.start) + ")"});
    switch (c.contact) {
    case ContactKind::None:
        problems.push_back({"contact", "must not be \"none\" with model \"contact\", which is nothing else; allowed is one of "
                                       "ono-yamane, elastic, asperity, multi-asperity"});
        break;
    case ContactKind::OnoYamane: checkCharacteristic(c.onoYamane, problems); break;
    case ContactKind::Elastic: checkElastic(c, problems); break;
    case ContactKind::Asperity: break;
    case ContactKind::MultiAsperity:
        if (c.meniscus.breakingLength < c.meniscus.filmThickness)
            problems.push_back({"meniscus.breaking_length", inNanometres(c.meniscus.breakingLength) +
                                                                " must be at least meniscus.film_thickness (" +
                                                                inNanometres(c.meniscus.filmThickness) + ")"});
        break;
    }
}

} // namespace touchdown

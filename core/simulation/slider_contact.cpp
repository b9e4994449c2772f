// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/slider_contact.h"

#include "core/simulation/ono_yamane_contact.h"

namespace touchdown {

std::unique_ptr<SliderContact> makeSliderContact(const Case& c, const MinimumSpacing& spacing, const DiskTopography&, const CellGrid&,
                                                 const PaddedGrid&, const std::function<bool()>&)
{
    switch (c.contact) {
    case ContactKind::OnoYamane: return std::make_unique<OnoYamaneContact>(c, spacing);
    case ContactKind::Elastic:
    case ContactKind::Asperity:
    case ContactKind::MultiAsperity:
    case ContactKind::None: break;
    }
    return nullptr;
}

RecordedFields sliderContactFields(const Case&) { return {}; }

} // namespace touchdown

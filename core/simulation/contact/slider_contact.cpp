// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/contact/slider_contact.h"

#include "core/case/contact_kind.h"
#include "core/simulation/contact/elastic_slider_contact.h"
#include "core/simulation/contact/ono_yamane_contact.h"

namespace touchdown {

std::unique_ptr<SliderContact> makeSliderContact(const Case& c, const MinimumSpacing& spacing,
                                                 const DiskTopography& surface, const CellGrid& grid,
                                                 const PaddedGrid& pad, const std::function<bool()>& goOn)
{
    switch (c.contact) {
    case ContactKind::OnoYamane: return std::make_unique<OnoYamaneContact>(c, spacing);
    case ContactKind::Elastic: return std::make_unique<ElasticSliderContact>(c, spacing, surface, grid, pad, goOn);
    case ContactKind::Asperity:
    case ContactKind::MultiAsperity:
    case ContactKind::None: break;
    }
    return nullptr;
}

RecordedFields sliderContactFields(const Case& c, const std::function<bool()>& goOn)
{
    return c.contact == ContactKind::Elastic && c.run.fieldSnapshots > 0 ? ElasticSliderContact::fields(c, goOn)
                                                                         : RecordedFields{};
}

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/case.h"

#include "core/case/contact_kind.h"
#include "core/case/integrator_kind.h"

namespace touchdown {

const ContactKind noContact = ContactKind::None, usualContact = ContactKind::OnoYamane;
const IntegratorKind usualIntegrator = IntegratorKind::Dopri5;

Case::Case() = default;
Case::Case(const Case&) = default;
Case::Case(Case&&) noexcept = default;
Case& Case::operator=(const Case&) = default;
Case& Case::operator=(Case&&) noexcept = default;
Case::~Case() = default;
bool Case::operator==(const Case&) const = default;

} // namespace touchdown

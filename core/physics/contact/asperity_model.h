// SPDX-License-Identifier: GPL-3.0-or-later
//
// The laws of one summit in core/physics/contact/asperity_contact.h. Only for files that name one.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace touchdown {

enum class AsperityModel : std::uint8_t { GreenwoodWilliamson, ElasticPlastic };

/// In case files.
inline constexpr std::array<std::string_view, 2> asperityModelNames{"greenwood-williamson", "elastic-plastic"};

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/contact_law.h"

#include <algorithm>
#include <array>

#include "core/case/contact_kind.h"
#include "core/case/parameters.h"
#include "core/formats/words.h"

namespace touchdown {

namespace {

double noFriction(const Case&) { return 0.0; }
double elasticFriction(const Case& c) { return c.elastic.friction; }
double asperityFriction(const Case& c) { return c.asperity.friction; }
double noReach(const Case&) { return 0.0; }
/// Three in 100,000 summits are higher.
double highestSummit(const Case& c) { return c.asperity.planeHeight + 4.0 * c.asperity.heightDeviation; }
bool neverPulls(const Case&) { return false; }
bool attracts(const Case& c) { return c.adhesion.acts(); }
bool alwaysPulls(const Case&) { return true; }

/// An enumerator without a row does not compile (-Wswitch).
constexpr ContactLaw rowOf(ContactKind kind)
{
    switch (kind) {
    case ContactKind::None:
        return {.name = "none",
                .label = "none",
                .meaning = "Slider and disk do not touch.",
                .refusal = {.contact = "a pad alone has no other force"},
                .friction = noFriction,
                .adheres = neverPulls,
                .reach = noReach};
    case ContactKind::OnoYamane:
        return {.name = "ono-yamane",
                .label = "Ono & Yamane",
                .meaning =
                    "Straight lines for contact force and menisci, which differ between touch-down and take-off.",
                .friction = [](const Case& c) { return c.onoYamane.friction; },
                .adheres = alwaysPulls,
                .reach = [](const Case& c) { return std::max(c.onoYamane.touchDown, c.onoYamane.takeOff); },
                .menisci = true};
    case ContactKind::Elastic:
        return {.name = "elastic",
                .label = "elastic",
                .meaning = "The surfaces as they are, on a grid, with their elastic deformation and intermolecular "
                           "adhesion.",
                .refusal = {.springs = "it acts between surfaces given point by point, which springs do not have"},
                .friction = elasticFriction,
                .adheres = attracts,
                .reach = noReach,
                .remembers = true,
                .seesDisk = true,
                .recordsArea = true,
                .recordsSurfaces = true};
    case ContactKind::Asperity:
        return {.name = "asperity",
                .label = "asperities",
                .meaning = "Contact of many summits, by the statistics of the surface.",
                .friction = asperityFriction,
                .adheres = attracts,
                .reach = highestSummit,
                .seesDisk = true,
                .recordsArea = true};
    case ContactKind::MultiAsperity:
        return {.name = "multi-asperity",
                .label = "Ono & Yamane, full",
                .meaning = "Many summits with menisci on a pad that deforms, the full model of Ono & Yamane.",
                .refusal = {.springs = "it remembers how far menisci have formed, which the integrators of the springs "
                                       "do not follow; `touchdown run` of the pad, with model = \"contact\", fits the "
                                       "five parameters that contact = \"ono-yamane\" takes"},
                .friction = asperityFriction,
                .adheres = alwaysPulls,
                .reach = [](const Case& c) { return highestSummit(c) + c.meniscus.breakingLength; },
                .remembers = true,
                .menisci = true,
                .recordsArea = true,
                .recordsFit = true};
    }
    return {}; // beyond the last enumerator
}

constexpr std::size_t countLaws()
{
    std::size_t count = 0;
    while (!rowOf(static_cast<ContactKind>(count)).name.empty()) ++count;
    return count;
}

constexpr auto laws = [] {
    std::array<ContactLaw, countLaws()> rows{};
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = rowOf(static_cast<ContactKind>(i));
    return rows;
}();

} // namespace

std::string_view ContactLaw::whyNot(ModelKind model) const
{
    switch (model) {
    case ModelKind::Springs: return refusal.springs;
    case ModelKind::Film: return refusal.film;
    case ModelKind::Contact: return refusal.contact;
    }
    return {};
}

std::span<const ContactLaw> contactLaws() { return laws; }
const ContactLaw& contactLaw(ContactKind kind) { return laws[static_cast<std::size_t>(kind)]; }
const ContactLaw& contactLaw(const Case& c) { return contactLaw(c.contact); }

std::optional<std::string> contactRefusal(const Case& c)
{
    const std::string_view why = contactLaw(c).whyNot(c.model);
    if (why.empty()) return {};
    std::vector<std::string> allowed;
    for (const ContactLaw& law : laws)
        if (law.whyNot(c.model).empty()) allowed.emplace_back(law.name);
    return "must not be \"" + std::string(contactLaw(c).name) + "\" with model \"" +
           toText(c, *findParameter("model")) + "\": " + std::string(why) + "; allowed is one of " + joined(allowed);
}

bool contactActs(const Case& c) { return contactLaw(c).whyNot(c.model).empty(); }

Case withContactOf(Case c, const Case& other)
{
    c.contact = other.contact;
    c.onoYamane = other.onoYamane;
    c.elastic = other.elastic;
    c.adhesion = other.adhesion;
    c.asperity = other.asperity;
    c.meniscus = other.meniscus;
    return c;
}

std::optional<OnoYamane> characteristic(const Case& c)
{
    if (c.contact != ContactKind::OnoYamane) return {};
    return c.onoYamane;
}

std::optional<double> cycleWork(const Case& c)
{
    const auto law = characteristic(c);
    return law ? std::optional(OnoYamaneLaw(*law).cycleWork()) : std::nullopt;
}

} // namespace touchdown

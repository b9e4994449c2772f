// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/surface_selection.h"

#include <algorithm>
#include <iterator>

#include "core/physics/slider/surface_check.h"
#include "core/physics/slider/surface_relations.h"
#include "core/physics/slider/surface_symmetry.h"
#include "ui/slider/part_picking.h"
#include "ui/slider/rail_drawing.h"
#include "ui/slider/wall_menu.h"

namespace touchdown {

namespace {

constexpr double copyOffset = 10e-6; // [m]
constexpr double pairReach = 0.1e-6; // within which rails are mirror images [m]

PartSelection partsOfKinds(const PartSelection& parts, PartKind one, PartKind other)
{
    PartSelection found;
    std::ranges::copy_if(parts, std::inserter(found, found.end()),
                         [=](const SurfacePart& part) { return part.kind == one || part.kind == other; });
    return found;
}

} // namespace

void SurfaceSelection::setSurface(const AirBearingSurface& surface, double width)
{
    single_ = sameRails(surface_, surface, single_);
    surface_ = surface;
    width_ = width;
    PartSelection kept;
    std::ranges::copy_if(parts_, std::inserter(kept, kept.end()),
                         [&](const SurfacePart& part) { return has(surface, part); });
    select(kept);
    findLinks();
}

void SurfaceSelection::open()
{
    single_.clear();
    select({});
    findLinks();
}

void SurfaceSelection::select(const PartSelection& parts)
{
    if (parts == parts_) return;
    parts_ = parts;
    ++nudges_;
    emit changed();
}

PartSelection SurfaceSelection::rails() const { return railsOf(parts_); }

std::optional<SurfacePart> SurfaceSelection::oneEdge() const
{
    if (parts_.size() != 1 || parts_.begin()->kind != PartKind::Edge) return {};
    return *parts_.begin();
}

void SurfaceSelection::selectAll()
{
    PartSelection all;
    for (std::size_t i = 0; i < surface_.rails.size(); ++i) all.insert({PartKind::Rail, i});
    select(all);
}

void SurfaceSelection::selectRail(int places)
{
    const auto count = static_cast<int>(surface_.rails.size());
    if (count == 0) return;
    const int from = rails().empty() ? -places : static_cast<int>(rails().begin()->item); // without one, the first
    select({{PartKind::Rail, static_cast<std::size_t>((from + places + count) % count)}});
}

void SurfaceSelection::selectAround(PartKind kind, bool back)
{
    if (rails().empty()) return;
    const std::size_t rail = rails().begin()->item, count = surface_.rails[rail].points.size();
    const SurfacePart first = *parts_.begin();
    const bool continues = parts_.size() == 1 && first.kind == kind;
    select({{kind, rail, continues ? (first.index + (back ? count - 1 : 1)) % count : 0}});
}

void SurfaceSelection::setPairs(bool on)
{
    pairs_ = on;
    findLinks();
}

void SurfaceSelection::findLinks()
{
    links_.clear();
    noPairs_ = false;
    if (pairs_ && surfaceProblems(surface_).empty()) {
        const auto images = mirrorImages(surface_, width_, pairReach);
        noPairs_ = std::ranges::none_of(images, [](const auto& image) { return image.has_value(); });
        const std::vector<SurfacePoint> inside = railNumberPoints(surface_);
        for (std::size_t i = 0; i < images.size(); ++i) {
            if (!images[i] || images[i]->rail <= i) continue;
            const std::size_t image = images[i]->rail;
            const SurfacePoint to{inside[i].x, width_ - inside[i].y}; // straight across the centre line
            links_.push_back({i, image, single_.contains(i) || single_.contains(image), inside[i], to});
        }
    }
    emit linksChanged();
}

void SurfaceSelection::togglePair(std::size_t rail)
{
    for (const PairLink& link : links_) {
        if (!link.holds(rail)) continue;
        for (const std::size_t each : {link.rail, link.image})
            if (link.broken)
                single_.erase(each);
            else
                single_.insert(each);
    }
    findLinks();
}

bool SurfaceSelection::commit(const AirBearingSurface& surface, const QString& text, int merge)
{
    if (merge == 0) ++nudges_;
    if (surface == surface_) return false;
    emit edited(surface, text, merge);
    return true;
}

AirBearingSurface SurfaceSelection::moved(SurfaceShift by) const
{
    return keepingRelations(surface_,
                            pairs_ ? movedInPairs(surface_, parts_, by, width_, pairReach, single_)
                                   : touchdown::moved(surface_, parts_, by),
                            width_);
}

SurfaceShift SurfaceSelection::shiftOf(SurfaceShift by) const
{
    const auto edge = oneEdge();
    if (!edge) return by;
    const SurfaceShift normal = edgeNormal(surface_, *edge);
    const double distance = by.x * normal.x + by.y * normal.y;
    return {distance * normal.x, distance * normal.y};
}

bool SurfaceSelection::move(SurfaceShift by) { return commit(moved(by), tr("move %1").arg(selectionText(parts_))); }

void SurfaceSelection::nudge(SurfaceShift by)
{
    if (parts_.empty() || held_) return;
    commit(moved(by), tr("move %1").arg(selectionText(parts_)), nudges_ + 1);
}

void SurfaceSelection::remove()
{
    if (parts_.empty() || held_) return;
    commit(without(surface_, parts_), tr("delete %1").arg(selectionText(parts_)));
}

void SurfaceSelection::copy()
{
    const PartSelection originals = rails();
    if (originals.empty() || held_) return;
    commitCopies(withCopies(surface_, originals, {copyOffset, copyOffset}),
                 tr("copy %1").arg(selectionText(originals)));
}

void SurfaceSelection::commitCopies(const AirBearingSurface& surface, const QString& text)
{
    const std::size_t count = surface_.rails.size();
    if (!commit(surface, text)) return;
    PartSelection copies;
    for (std::size_t i = count; i < surface_.rails.size(); ++i) copies.insert({PartKind::Rail, i});
    select(copies);
}

void SurfaceSelection::mirrorCopy()
{
    if (rails().empty() || held_) return;
    commitCopies(withMirroredCopies(surface_, rails(), width_), tr("mirrored copy of %1").arg(selectionText(rails())));
}

void SurfaceSelection::align(Alignment to)
{
    if (!held_) commit(aligned(surface_, rails(), to), tr("align %1").arg(selectionText(rails())));
}

void SurfaceSelection::distribute(bool alongX)
{
    if (!held_) commit(distributed(surface_, rails(), alongX), tr("distribute %1").arg(selectionText(rails())));
}

void SurfaceSelection::array(int count, SurfaceShift step)
{
    if (rails().empty() || held_) return;
    commitCopies(withArray(surface_, rails(), count, step),
                 tr("%1 copies of %2").arg(count).arg(selectionText(rails())));
}

void SurfaceSelection::flip()
{
    PartSelection both = rails();
    both.merge(partsOfKinds(parts_, PartKind::Interest, PartKind::Interest));
    if (both.empty() || held_) return;
    AirBearingSurface flipped = mirrored(surface_, both, width_);
    const auto isFlipped = [&](const RailPlace& place) { return both.contains({PartKind::Rail, place.rail}); };
    for (KeptDistance& each : flipped.distances) // across, what was below is above now
        if (!each.alongX && isFlipped(each.from) && isFlipped(each.to)) std::swap(each.from, each.to);
    commit(flipped, tr("flip %1").arg(selectionText(both)));
}

std::optional<KeptDistance> SurfaceSelection::offeredDistance(bool alongX) const
{
    return drawnDistance(surface_, parts_, alongX);
}

std::optional<bool> SurfaceSelection::suggestedAxis() const
{
    const auto x = offeredDistance(true), y = offeredDistance(false);
    if (!x && !y) return {};
    return x && (!y || x->value >= y->value);
}

void SurfaceSelection::keepDistance(bool alongX)
{
    const auto distance = offeredDistance(alongX);
    if (!distance || held_) return;
    const auto same = [&](const KeptDistance& each) {
        return each.alongX == alongX && ((each.from == distance->from && each.to == distance->to) ||
                                         (each.from == distance->to && each.to == distance->from));
    };
    AirBearingSurface surface = surface_;
    const auto place = std::ranges::find_if(surface.distances, same) - surface.distances.begin();
    const SurfacePart kept{PartKind::Distance, static_cast<std::size_t>(place)};
    if (!has(surface, kept)) surface.distances.push_back(*distance);
    commit(surface, tr("keep a distance along %1").arg(alongX ? QStringLiteral("x") : QStringLiteral("y")));
    if (has(surface_, kept)) select({kept});
}

std::optional<KeptSymmetry> SurfaceSelection::offeredSymmetry() const
{
    if (parts_.empty() || parts_.size() > 2 || rails() != parts_) return {};
    const KeptSymmetry symmetry{parts_.begin()->item, parts_.rbegin()->item};
    if (!exists(surface_, symmetry)) return {};
    const bool kept = std::ranges::any_of(surface_.symmetries, [&](const KeptSymmetry& each) {
        return each == symmetry || each == KeptSymmetry{symmetry.image, symmetry.rail};
    });
    return kept ? std::nullopt : std::optional(symmetry);
}

void SurfaceSelection::keepSymmetric()
{
    const auto symmetry = offeredSymmetry();
    if (!symmetry || held_) return;
    const QString text = tr("keep %1 symmetric").arg(selectionText(parts_));
    commit(withSymmetry(surface_, *symmetry, width_), text);
    const SurfacePart kept{PartKind::Symmetry, surface_.symmetries.size() - 1};
    if (has(surface_, kept)) select({kept});
}

bool SurfaceSelection::lopsided() const { return madeSymmetric(surface_, rails(), width_, pairReach) != surface_; }

void SurfaceSelection::makeSymmetric()
{
    if (rails().empty() || held_) return;
    commit(madeSymmetric(surface_, rails(), width_, pairReach), tr("make %1 symmetric").arg(selectionText(rails())));
}

void SurfaceSelection::chooseWall(int wall)
{
    const PartSelection walled = partsOfKinds(parts_, PartKind::Edge, PartKind::Rail);
    if (walled.empty() || held_) return;
    const bool added = wall > static_cast<int>(surface_.walls.size());
    commit(withChosenWall(surface_, walled, wall), tr("wall of %1").arg(selectionText(walled)));
    if (added) emit wallWanted(wall);
}

void SurfaceSelection::moveInOrder(int places)
{
    if (rails().size() != 1 || held_) return;
    const SurfacePart rail = *rails().begin();
    const auto last = static_cast<std::ptrdiff_t>(surface_.rails.size()) - 1;
    const auto place =
        static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(rail.item) + places, 0, last));
    if (place == rail.item) return;
    commit(reordered(surface_, rail.item, place),
           (places > 0 ? tr("move %1 forward") : tr("move %1 backward")).arg(partText(rail)));
    select({{PartKind::Rail, place}});
}

void SurfaceSelection::insertCorner(std::size_t rail, std::size_t edge, SurfacePoint at)
{
    if (held_ || !has(surface_, {PartKind::Edge, rail, edge})) return;
    commit(withCorner(surface_, rail, edge, at), tr("insert a corner into %1").arg(partText({PartKind::Rail, rail})));
    select({{PartKind::Corner, rail, edge + 1}});
}

void SurfaceSelection::addRail(const std::vector<SurfacePoint>& corners)
{
    Rail rail;
    if (!rails().empty() && has(surface_, *rails().begin()))
        rail.recess[0] = surface_.rails[rails().begin()->item].recess[0];
    for (const SurfacePoint& corner : corners) rail.points.push_back({corner.x, corner.y, 0});
    AirBearingSurface surface = surface_;
    surface.rails.push_back(std::move(rail));
    const SurfacePart added{PartKind::Rail, surface.rails.size() - 1};
    commit(surface, tr("add %1").arg(partText(added)));
    if (has(surface_, added)) select({added});
}

} // namespace touchdown

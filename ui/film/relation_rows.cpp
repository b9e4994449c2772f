// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/relation_rows.h"

#include <algorithm>

#include <QTreeWidget>

#include "ui/slider/kept_distances.h"
#include "ui/slider/part_picking.h"
#include "ui/style/foreign_text.h"
#include "ui/style/quantity_format.h"
#include "ui/style/theme.h"

namespace touchdown {

namespace {

QString captionOf(const AirBearingSurface& surface, const SurfacePart& relation, const QString& wrong)
{
    const QString kept = sentence(relationText(surface, relation, true).toStdString());
    return wrong.isEmpty() ? kept : kept + QLatin1Char(' ') + wrong;
}

} // namespace

bool sameRows(const AirBearingSurface& one, const AirBearingSurface& other)
{
    const auto sameRail = [](const Rail& a, const Rail& b) {
        return a.kind == b.kind && a.recess == b.recess && a.points.size() == b.points.size();
    };
    return relationCount(one) + relationCount(other) == 0 && one.walls == other.walls &&
           std::ranges::equal(one.rails, other.rails, sameRail) &&
           one.pointsOfInterest.size() == other.pointsOfInterest.size();
}

std::size_t relationCount(const AirBearingSurface& surface)
{
    return surface.distances.size() + surface.symmetries.size();
}

SurfacePart relationAt(const AirBearingSurface& surface, std::size_t row)
{
    const std::size_t distances = surface.distances.size();
    if (row < distances) return {PartKind::Distance, row};
    return {PartKind::Symmetry, row - distances};
}

std::size_t rowOf(const AirBearingSurface& surface, const SurfacePart& part)
{
    return part.item + (part.kind == PartKind::Symmetry ? surface.distances.size() : 0);
}

std::string relationKey(const AirBearingSurface& surface, std::size_t row)
{
    if (relationAt(surface, row).kind != PartKind::Distance) return {};
    return "abs.distance[" + std::to_string(row + 1) + "].value";
}

QString relationCaption(const Case& c, std::size_t row)
{
    const SurfacePart relation = relationAt(c.surface, row);
    return captionOf(c.surface, relation, relationProblem(relationProblems(c.surface, c.slider.width), relation));
}

void fillRelation(QTreeWidgetItem& item, const AirBearingSurface& surface, std::size_t row,
                  const std::vector<SurfaceProblem>& problems)
{
    const SurfacePart relation = relationAt(surface, row);
    const QString wrong = relationProblem(problems, relation);
    item.setText(0, sentence(relationText(surface, relation, false).toStdString()).chopped(1));
    item.setFirstColumnSpanned(true);
    item.setToolTip(0, plainTip(captionOf(surface, relation, wrong)));
    const QPalette palette = item.treeWidget()->palette();
    item.setForeground(0, wrong.isEmpty() ? palette.text() : QBrush(meaningColours(palette).failure));
}

} // namespace touchdown

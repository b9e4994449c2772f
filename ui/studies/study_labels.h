// SPDX-License-Identifier: GPL-3.0-or-later
//
// Places of the labels of points: beside their points, not on a marker or another label and, if possible, not on a
// line. A label without room is omitted; pointing at its point shows it.
#pragma once

#include <optional>
#include <vector>

#include <QLineF>
#include <QRectF>

namespace touchdown {

struct LabelRequest {
    QPointF at;             // middle of the point [px]
    double radius = 0.0;    // of its marker
    QSizeF size;            // of the text
    bool important = false; // finds its place first
};

/// `taken` are the markers and whatever else has to stay free; the places that are given are added to it.
std::vector<std::optional<QRectF>> placeLabels(const std::vector<LabelRequest>& labels, const QRectF& bounds,
                                               std::vector<QRectF>& taken, const std::vector<QLineF>& lines);

} // namespace touchdown

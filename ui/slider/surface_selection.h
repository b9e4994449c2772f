// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is selected of the surface that is edited, the verbs for it, and the pairs of mirror rails that move together.
// A verb asks the owner by `edited` for one edit of the case, which comes back with setSurface. A gesture holds the
// verbs: what it previews is not the surface that they would change.
#pragma once

#include <optional>
#include <set>
#include <vector>

#include <QObject>
#include <QString>

#include "core/physics/slider/surface_arrange.h"

namespace touchdown {

/// Mirror rails that move together; a link that is broken lets both move alone until it is joined again.
struct PairLink {
    std::size_t rail, image;
    bool broken;
    SurfacePoint from, to; // inside the two rails [m]
    bool holds(std::size_t one) const { return one == rail || one == image; }
};

class SurfaceSelection : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// The surface of the case, on a slider of this width [m]. Parts that it does not have are not selected any more.
    void setSurface(const AirBearingSurface& surface, double width);
    const AirBearingSurface& surface() const { return surface_; }
    /// The surface is that of another case: nothing is selected, no pair is broken.
    void open();

    const PartSelection& parts() const { return parts_; }
    void select(const PartSelection& parts);
    PartSelection rails() const;
    /// The edge that alone is selected.
    std::optional<SurfacePart> oneEdge() const;
    void selectAll();
    /// The rail that many places after the first selected one, in a circle.
    void selectRail(int places);
    /// The next edge or corner of the rail, or the previous one.
    void selectAround(PartKind kind, bool back);

    void setPairs(bool on);
    const std::vector<PairLink>& pairLinks() const { return links_; }
    /// Pairs are to move together, but no rail has a mirror image.
    bool noPairs() const { return noPairs_; }
    void togglePair(std::size_t rail);

    void hold(bool held) { held_ = held; }
    /// Kept distances and symmetries are solved.
    AirBearingSurface moved(SurfaceShift by) const;
    /// The shift of the selected parts: a single edge moves normal to itself.
    SurfaceShift shiftOf(SurfaceShift by) const;
    /// False: nothing has changed, and nothing was asked for.
    bool move(SurfaceShift by);
    /// Moves in a row are one edit for undo.
    void nudge(SurfaceShift by);
    void remove();
    void copy();
    /// About the centre line: copies of the selected rails, or the rails and points of interest themselves.
    void mirrorCopy();
    void flip();
    void align(Alignment to);
    void distribute(bool alongX);
    void array(int count, SurfaceShift step);
    /// The distance of two selected parts along an axis.
    std::optional<KeptDistance> offeredDistance(bool alongX) const;
    /// The axis along which they are farther apart is x; nothing where they have no distance.
    std::optional<bool> suggestedAxis() const;
    void keepDistance(bool alongX);
    /// One or two selected rails, which may stay mirror images.
    std::optional<KeptSymmetry> offeredSymmetry() const;
    void keepSymmetric();
    bool lopsided() const;
    /// The selected rails get mirror images where they have none.
    void makeSymmetric();
    /// The wall of the selected edges and rails; one more than there are: a new one.
    void chooseWall(int wall);
    /// In the order of overlap: 1 forward, -1 backward.
    void moveInOrder(int places);
    void insertCorner(std::size_t rail, std::size_t edge, SurfacePoint at);
    /// A rail with these corners and the recess of the first selected one.
    void addRail(const std::vector<SurfacePoint>& corners);

signals:
    void changed();
    void linksChanged();
    /// `merge`: edits with the same number in a row are one for undo; 0: none.
    void edited(const touchdown::AirBearingSurface& surface, const QString& text, int merge);
    /// The numbers of a new wall are to be typed elsewhere.
    void wallWanted(int wall);

private:
    bool commit(const AirBearingSurface& surface, const QString& text, int merge = 0);
    /// Selects the rails that it adds to the end of the list.
    void commitCopies(const AirBearingSurface& surface, const QString& text);
    void findLinks();

    AirBearingSurface surface_;
    double width_ = 0.0; // of the slider [m]
    PartSelection parts_;
    bool held_ = false, pairs_ = false, noPairs_ = false;
    int nudges_ = 0;               // number of the row of nudges
    std::set<std::size_t> single_; // rails whose pairs are broken
    std::vector<PairLink> links_;
};

} // namespace touchdown

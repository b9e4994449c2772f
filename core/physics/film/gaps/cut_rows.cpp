// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/physics/film/gaps/cut_rows.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "core/physics/slider/edge_ridges.h"

namespace touchdown {

namespace {

/// A gap is deep beside another that it exceeds so many times [-].
constexpr double contrast = 3.0;
/// Deep parts count at most so many faces away.
constexpr int reach = 4;

double gapOf(double recess) { return comparedGap(recess); }

bool isDeep(double gap, double shallowGap) { return gap > contrast * shallowGap; }

} // namespace

CutRowArranger::CutRowArranger(FilmGaps& gaps, GapSampler& sampler, std::size_t axis)
    : gaps_(gaps), sampler_(sampler), axis_(axis)
{}

FacePath CutRowArranger::pathOf(std::size_t at) const
{
    const std::size_t i = static_cast<std::size_t>(gaps_.pad.column(at)),
                      j = static_cast<std::size_t>(gaps_.pad.row(at));
    const std::size_t line = axis_ == 0 ? i : j, across = axis_ == 0 ? j : i;
    const FilmGaps::Faces& f = gaps_.faces[axis_];
    const CellGrid& grid = gaps_.grid;
    const std::vector<double>&lines = axis_ == 0 ? grid.x : grid.y, &acrossLines = axis_ == 0 ? grid.y : grid.x;
    const double start = f.pathMid[line] - 0.5 * f.pathLength[line];
    return {static_cast<int>(axis_), start, start + f.pathLength[line], lines[line], acrossLines[across],
            acrossLines[across + 1]};
}

void CutRowArranger::add(std::size_t at, const FacePath& path)
{
    const std::uint32_t first = static_cast<std::uint32_t>(rows_.size()),
                        piece = static_cast<std::uint32_t>(pieces_.size());
    for (SampledRow row : sampler_.rows()) {
        row.pieces += piece;
        row.pieceEnd += piece;
        rows_.push_back(row);
    }
    pieces_.insert(pieces_.end(), sampler_.pieces().begin(), sampler_.pieces().end());
    faces_.push_back(
        {at, path, first, static_cast<std::uint32_t>(rows_.size()), sampler_.lowest(), sampler_.highest()});
}

void CutRowArranger::append(const CutRowArranger& next)
{
    const std::uint32_t first = static_cast<std::uint32_t>(rows_.size()),
                        piece = static_cast<std::uint32_t>(pieces_.size());
    for (SampledRow row : next.rows_) {
        row.pieces += piece;
        row.pieceEnd += piece;
        rows_.push_back(row);
    }
    pieces_.insert(pieces_.end(), next.pieces_.begin(), next.pieces_.end());
    for (SampledFace face : next.faces_) {
        face.rows += first;
        face.rowEnd += first;
        faces_.push_back(face);
    }
}

bool CutRowArranger::isOutermost(const SampledFace& face) const
{
    const int line = axis_ == 0 ? gaps_.pad.column(face.at) : gaps_.pad.row(face.at);
    return line == 0 || line == (axis_ == 0 ? gaps_.pad.nx : gaps_.pad.ny);
}

std::optional<std::size_t> CutRowArranger::receiver(const SampledFace& face, int direction, double shallowGap) const
{
    const std::size_t step = gaps_.pad.step(static_cast<int>(axis_)),
                      aside = gaps_.pad.step(1 - static_cast<int>(axis_));
    const int here = axis_ == 0 ? gaps_.pad.row(face.at) : gaps_.pad.column(face.at);
    const int count = axis_ == 0 ? gaps_.pad.ny : gaps_.pad.nx;
    for (int k = 1; k <= reach && here + k * direction >= 0 && here + k * direction < count; ++k) {
        const std::size_t distance = static_cast<std::size_t>(k) * aside;
        const std::size_t at = direction < 0 ? face.at - distance : face.at + distance;
        const auto next = std::lower_bound(faces_.begin(), faces_.end(), at,
                                           [](const SampledFace& f, std::size_t place) { return f.at < place; });
        const bool isSampled = next != faces_.end() && next->at == at;
        if (isSampled && parted_[static_cast<std::size_t>(next - faces_.begin())]) break;
        if (isDeep(gapOf(gaps_.centreRecess[at - step]), shallowGap) &&
            isDeep(gapOf(gaps_.centreRecess[at]), shallowGap))
            return at;
        const bool isOpen =
            isSampled && std::all_of(rows_.begin() + next->rows, rows_.begin() + next->rowEnd,
                                     [&](const SampledRow& row) { return isDeep(gapOf(row.recess), shallowGap); });
        if (!isOpen) break;
    }
    return std::nullopt;
}

int CutRowArranger::openSide(const SampledFace& face, double shallowGap) const
{
    const SampledRow &first = rows_[face.rows], &last = rows_[face.rowEnd - 1];
    const auto closed = [&](const SampledRow& row) {
        double length = 0.0;
        for (std::uint32_t k = row.pieces; k < row.pieceEnd; ++k)
            if (!isDeep(gapOf(pieces_[k].recess), shallowGap)) length += pieces_[k].extent;
        return length;
    };
    const double change = closed(last) - closed(first), width = face.path.high - face.path.low;
    const double most = static_cast<double>(reach) * width / std::max(1e-300, last.middle - first.middle);
    if (!(0.5 * (closed(first) + closed(last)) <= most * std::abs(change))) return 0;
    return change < 0.0 ? 1 : -1;
}

bool CutRowArranger::meetsRidge(const FacePath& path, double from, double to) const
{
    double deepest = 0.0;                                   // so far
    double ridge = std::numeric_limits<double>::infinity(); // the shallowest after one that is so much deeper
    for (const GapPiece& piece : sampler_.pieces()) {
        const double start = path.face + piece.start, gap = gapOf(piece.recess);
        if (start >= to || start + piece.extent <= from) continue;
        if (gap > ridgeContrast * ridge) return true;
        if (deepest > ridgeContrast * gap) ridge = std::min(ridge, gap);
        deepest = std::max(deepest, gap);
    }
    return false;
}

SampledRow CutRowArranger::keptMiddleRow(const FacePath& path)
{
    sampler_.setMiddleRow(path);
    SampledRow row = sampler_.rows().front();
    row.pieces = static_cast<std::uint32_t>(pieces_.size());
    pieces_.insert(pieces_.end(), sampler_.pieces().begin(), sampler_.pieces().end());
    row.pieceEnd = static_cast<std::uint32_t>(pieces_.size());
    return row;
}

bool CutRowArranger::isParted(const SampledFace& face, bool areDeep) const
{
    const FacePath& path = face.path;
    if (meetsRidge(path, path.start, path.end)) return true;
    if (!areDeep) return false;
    const double middle = 0.5 * (path.low + path.high);
    const double first = rows_[face.rows].middle, last = rows_[face.rowEnd - 1].middle;
    return std::ranges::any_of(std::array{path.start, path.end}, [&](double line) {
        const FacePath across{1 - path.axis, path.low, path.high, middle, line, line};
        sampler_.setMiddleRow(across);
        return meetsRidge(across, first, middle) || meetsRidge(across, middle, last);
    });
}

void CutRowArranger::give(std::size_t n, double shallowGap)
{
    const SampledFace& face = faces_[n];
    const auto isRowDeep = [&](std::uint32_t r) { return isDeep(gapOf(rows_[r].recess), shallowGap); };
    std::uint32_t deepBelow = face.rows, deepAbove = face.rowEnd; // the deep rows at the ends of the face
    while (deepBelow < face.rowEnd && isRowDeep(deepBelow)) ++deepBelow;
    while (deepAbove > face.rows && isRowDeep(deepAbove - 1)) --deepAbove;
    const bool whole = deepBelow == face.rowEnd;
    if (whole) {
        const int side = openSide(face, shallowGap);
        deepBelow = deepAbove = side < 0 ? face.rowEnd : face.rows;
        if (side == 0) return;
    }
    const std::optional<std::size_t> below = receiver(face, -1, shallowGap), above = receiver(face, 1, shallowGap);
    for (std::uint32_t r = face.rows; r < face.rowEnd; ++r) {
        if (!isRowDeep(r)) continue;
        const std::optional<std::size_t> to = r < deepBelow ? below : r >= deepAbove ? above : std::nullopt;
        if (to)
            given_.push_back({*to, n, rows_[r].width, rows_[r].middle, rows_[r].recess});
        else if (!whole)
            keptWidth_[r] = rows_[r].width;
    }
}

void CutRowArranger::finish()
{
    const std::size_t step = gaps_.pad.step(static_cast<int>(axis_));
    enum class Kind { Sampled, Deep, Middle };
    std::vector<Kind> kinds;
    keptWidth_.assign(rows_.size(), 0.0);
    for (const SampledFace& face : faces_) {
        const double lowest = gapOf(face.lowest);
        const bool areDeep = isDeep(gapOf(gaps_.centreRecess[face.at - step]), lowest) &&
                             isDeep(gapOf(gaps_.centreRecess[face.at]), lowest);
        const bool isPlain = isOutermost(face) || !isDeep(gapOf(face.highest), lowest);
        middleRows_.push_back(isPlain ? SampledRow{} : keptMiddleRow(face.path));
        parted_.push_back(!isPlain && isParted(face, areDeep));
        kinds.push_back(isPlain ? Kind::Sampled : areDeep && !parted_.back() ? Kind::Deep : Kind::Middle);
    }
    gaps_.partedFaces += static_cast<std::size_t>(std::ranges::count(parted_, true));
    for (std::size_t n = 0; n < faces_.size(); ++n)
        if (kinds[n] == Kind::Middle && !parted_[n])
            give(n, std::min(gapOf(gaps_.centreRecess[faces_[n].at - step]), gapOf(gaps_.centreRecess[faces_[n].at])));
    std::stable_sort(given_.begin(), given_.end(), [](const Given& a, const Given& b) { return a.to < b.to; });
    std::size_t n = 0, g = 0;
    while (n < faces_.size() || g < given_.size()) {
        const bool isGiven = n == faces_.size() || (g < given_.size() && given_[g].to < faces_[n].at);
        const std::size_t at = isGiven ? given_[g].to : faces_[n].at;
        gaps_.faces[axis_].cut.push_back({at, static_cast<std::uint32_t>(gaps_.rows.size()), 0});
        if (isGiven) {
            openFace(at);
        } else {
            const SampledFace& face = faces_[n];
            if (kinds[n] == Kind::Sampled)
                for (std::uint32_t r = face.rows; r < face.rowEnd; ++r)
                    addRow(rows_[r], pieces_, rows_[r].width, Feed::ByGap);
            else if (kinds[n] == Kind::Deep)
                addDeepFace(face);
            else
                addMiddleRow(n);
            ++n;
        }
        for (; g < given_.size() && given_[g].to == at; ++g) addGiven(given_[g]);
        gaps_.faces[axis_].cut.back().rowEnd = static_cast<std::uint32_t>(gaps_.rows.size());
    }
}

void CutRowArranger::addRow(const SampledRow& row, const std::vector<GapPiece>& pieces, double width, Feed feed)
{
    const std::uint32_t first = static_cast<std::uint32_t>(gaps_.pieces.size());
    gaps_.pieces.insert(gaps_.pieces.end(), pieces.begin() + row.pieces, pieces.begin() + row.pieceEnd);
    gaps_.rows.push_back({width, first, static_cast<std::uint32_t>(gaps_.pieces.size()), feed});
}

/// A smooth face, to which parts are given.
void CutRowArranger::openFace(std::size_t at)
{
    sampler_.setMiddleRow(pathOf(at));
    addRow(sampler_.rows().front(), sampler_.pieces(), sampler_.rows().front().width, Feed::ByGap);
}

/// Both centres are deep: a row that is deep at the face does not end at a shallow place beside a centre, as the air
/// flows round.
void CutRowArranger::addDeepFace(const SampledFace& face)
{
    const std::size_t step = gaps_.pad.step(static_cast<int>(axis_));
    for (std::uint32_t r = face.rows; r < face.rowEnd; ++r) {
        const double atFace = gapOf(rows_[r].recess);
        addRow(rows_[r], pieces_, rows_[r].width, Feed::ByGap);
        const auto open = [&](GapPiece& end) {
            const double centre = gapOf(gaps_.centreRecess[end.start < 0.0 ? face.at - step : face.at]);
            const bool blocks = isDeep(atFace, gapOf(end.recess)) && isDeep(centre, gapOf(end.recess));
            if (blocks) end.recess = rows_[r].recess, end.own = end.other = 0.0;
            return blocks;
        };
        const GapRow& row = gaps_.rows.back();
        for (std::uint32_t k = row.pieces; k < row.pieceEnd && open(gaps_.pieces[k]);) ++k;
        for (std::uint32_t k = row.pieceEnd; k > row.pieces && open(gaps_.pieces[k - 1]);) --k;
    }
}

void CutRowArranger::addMiddleRow(std::size_t n)
{
    const SampledFace& face = faces_[n];
    const std::size_t step = gaps_.pad.step(static_cast<int>(axis_));
    const double a = gapOf(gaps_.centreRecess[face.at - step]), b = gapOf(gaps_.centreRecess[face.at]);
    double kept = 0.0;
    for (std::uint32_t r = face.rows; r < face.rowEnd; ++r) {
        if (!(keptWidth_[r] > 0.0)) continue;
        addRow(rows_[r], pieces_, keptWidth_[r], Feed::None);
        kept += keptWidth_[r];
    }
    addRow(middleRows_[n], pieces_, middleRows_[n].width - kept,
           isDeep(std::max(a, b), std::min(a, b)) ? Feed::ByCentre : Feed::ByGap);
}

void CutRowArranger::addGiven(const Given& given)
{
    const FacePath path = pathOf(given.to);
    const std::uint32_t first = static_cast<std::uint32_t>(gaps_.pieces.size());
    for (const auto& [from, to] : {std::pair{path.start, path.face}, std::pair{path.face, path.end}}) {
        const double along = 0.5 * (from + to);
        gaps_.pieces.push_back({to - from, given.recess, axis_ == 0 ? along : given.middle,
                                axis_ == 0 ? given.middle : along, from - path.face});
    }
    gaps_.rows.push_back({given.width, first, static_cast<std::uint32_t>(gaps_.pieces.size()), Feed::None});
    addRow(middleRows_[given.from], pieces_, -given.width, Feed::None);
}

} // namespace touchdown

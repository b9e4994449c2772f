// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/dxf_surface.h"

#include <dxflib/dl_dxf.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>

namespace touchdown {

namespace {

constexpr double millimetre = 1e-3;      // [m]
constexpr int millimetres = 4;           // $INSUNITS
constexpr double samePlace = 1e-9;       // of two corners [m]
constexpr double meeting = 20e-9;        // of the ends of two lines: files of others have few digits [m]
constexpr std::size_t mostJoined = 5000; // open lines
constexpr double sameBorder = 1e-7;      // of an outline and the border of the slider [m]
constexpr double mostRecess = 1e9;       // the most that a case takes [nm]

/// "1500.25": a recess in nm to 1e-6 nm.
std::string nanometres(double metres)
{
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.6f", metres * 1e9);
    std::string number = text.data();
    number.erase(number.find_last_not_of('0') + 1);
    if (number.back() == '.') number.pop_back();
    return number == "-0" ? "0" : number;
}

std::string layerOf(const Rail& rail, std::size_t index)
{
    std::string name = "rail " + std::to_string(index + 1);
    if (rail.kind == RailKind::Step) return name + " recess " + nanometres(rail.recess[0]) + " nm";
    name += " ramp";
    for (const double recess : rail.recess) name += ' ' + nanometres(recess);
    return name + " nm";
}

struct Layer {
    std::string name;
    std::vector<SurfacePoint> outline; // [m]
};

/// What each file of this version must have around its layers and lines.
void writeDrawing(DL_Dxf& dxf, DL_WriterA& out, const std::vector<Layer>& layers)
{
    const DL_Attributes plain("", 7, -1, "CONTINUOUS", 1.0);
    dxf.writeHeader(out);
    out.dxfString(9, "$INSUNITS");
    out.dxfInt(70, millimetres);
    out.sectionEnd();
    out.sectionTables();
    dxf.writeVPort(out);
    out.tableLinetypes(3);
    for (const char* name : {"BYBLOCK", "BYLAYER", "CONTINUOUS"})
        dxf.writeLinetype(out, DL_LinetypeData(name, "", 0, 0, 0.0));
    out.tableEnd();
    out.tableLayers(static_cast<int>(layers.size()) + 1);
    dxf.writeLayer(out, DL_LayerData("0", 0), plain);
    for (std::size_t i = 0; i < layers.size(); ++i)
        dxf.writeLayer(out, DL_LayerData(layers[i].name, 0),
                       DL_Attributes("", static_cast<int>((i + 6) % 7) + 1, -1, "CONTINUOUS", 1.0));
    out.tableEnd();
    out.tableStyle(1);
    dxf.writeStyle(out, DL_StyleData("Standard", 0, 0.0, 1.0, 0.0, 0, 2.5, "txt", ""));
    out.tableEnd();
    dxf.writeView(out);
    dxf.writeUcs(out);
    out.tableAppid(1);
    dxf.writeAppid(out, "ACAD");
    out.tableEnd();
    dxf.writeDimStyle(out, 1.0, 1.0, 1.0, 1.0, 1.0);
    dxf.writeBlockRecord(out);
    out.tableEnd();
    out.sectionEnd();
    out.sectionBlocks();
    for (const char* name : {"*Model_Space", "*Paper_Space", "*Paper_Space0"}) {
        dxf.writeBlock(out, DL_BlockData(name, 0, 0.0, 0.0, 0.0));
        dxf.writeEndBlock(out, name);
    }
    out.sectionEnd();
    out.sectionEntities();
    for (const Layer& layer : layers) {
        dxf.writePolyline(out, DL_PolylineData(static_cast<int>(layer.outline.size()), 0, 0, 1),
                          DL_Attributes(layer.name, 256, -1, "BYLAYER", 1.0));
        for (const SurfacePoint& p : layer.outline)
            dxf.writeVertex(out, DL_VertexData(p.x / millimetre, p.y / millimetre));
        dxf.writePolylineEnd(out);
    }
    out.sectionEnd();
    dxf.writeObjects(out);
    dxf.writeObjectsEnd(out);
    out.dxfEOF();
    out.close();
}

SurfacePoint corner(const RailPoint& point) { return {point.x, point.y}; }

double apart(const SurfacePoint& a, const SurfacePoint& b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// Open lines that meet become longer ones; those that close become outlines. `tooMany` open lines are left out.
std::vector<DrawnPath> joined(std::vector<DrawnPath> paths, bool& tooMany)
{
    std::vector<DrawnPath> found, open;
    for (DrawnPath& path : paths) (path.closed ? found : open).push_back(std::move(path));
    tooMany = open.size() > mostJoined;
    if (tooMany) return found;
    while (!open.empty()) {
        DrawnPath chain = std::move(open.back());
        open.pop_back();
        const auto closes = [&] {
            return chain.points.size() > 3 && apart(chain.points.front(), chain.points.back()) < meeting;
        };
        while (!closes()) {
            const SurfacePoint end = chain.points.back();
            const auto next = std::ranges::find_if(open, [&](const DrawnPath& other) {
                return (apart(other.points.front(), end) < meeting || apart(other.points.back(), end) < meeting) &&
                       other.layer == chain.layer;
            });
            if (next == open.end()) break;
            if (apart(next->points.front(), end) >= meeting) std::ranges::reverse(next->points);
            chain.points.insert(chain.points.end(), next->points.begin() + 1, next->points.end());
            open.erase(next);
        }
        chain.closed = closes();
        if (chain.closed) found.push_back(std::move(chain));
    }
    return found;
}

bool isBorder(const Rail& rail, const std::string& layer, double length, double width)
{
    if (layer.starts_with("rail ")) return false; // a rail may cover the whole slider
    std::array<bool, 4> met{};
    for (const RailPoint& p : rail.points) {
        const bool left = std::abs(p.x) < sameBorder, right = std::abs(p.x - length) < sameBorder;
        const bool low = std::abs(p.y) < sameBorder, high = std::abs(p.y - width) < sameBorder;
        if (!(left || right) || !(low || high)) return false;
        met[(left ? 0U : 1U) + (low ? 0U : 2U)] = true;
    }
    return std::ranges::all_of(met, [](bool corner) { return corner; });
}

/// [m]; zero for what no case takes, as "nan" and "1e300".
double recessOf(double nm) { return std::abs(nm) <= mostRecess ? nm * 1e-9 : 0.0; }

void takeRecess(Rail& rail, const std::string& layer)
{
    int number = 0;
    std::array<double, 3> r{};
    if (std::sscanf(layer.c_str(), "rail %d recess %lf nm", &number, r.data()) == 2) rail.recess[0] = recessOf(r[0]);
    if (std::sscanf(layer.c_str(), "rail %d ramp %lf %lf %lf nm", &number, &r[0], &r[1], &r[2]) != 4) return;
    rail.kind = RailKind::Ramp;
    std::ranges::transform(r, rail.recess.begin(), recessOf);
}

} // namespace

std::string dxfText(const AirBearingSurface& surface, double length, double width)
{
    std::vector<Layer> layers{{"slider base " + nanometres(surface.baseRecess) + " nm",
                               {{0.0, 0.0}, {length, 0.0}, {length, width}, {0.0, width}}}};
    for (std::size_t i = 0; i < surface.rails.size(); ++i) {
        layers.push_back({layerOf(surface.rails[i], i), {}});
        for (const RailPoint& p : surface.rails[i].points) layers.back().outline.push_back({p.x, p.y});
    }
    // The library writes to files with names only: this one is in memory.
    const int memory = ::memfd_create("dxf", MFD_CLOEXEC);
    const std::string path = "/proc/self/fd/" + std::to_string(memory);
    DL_Dxf dxf;
    const std::unique_ptr<DL_WriterA> out(memory < 0 ? nullptr : dxf.out(path.c_str(), DL_Codes::AC1015));
    if (!out) throw std::runtime_error("there is no memory for the drawing");
    writeDrawing(dxf, *out, layers);
    std::ifstream file(path, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(file), {}};
    ::close(memory);
    return text;
}

DrawnRails railsOfDrawing(const std::vector<DrawnPath>& paths, double length, double width)
{
    DrawnRails drawn;
    for (const DrawnPath& path : joined(paths, drawn.tooManyOpenLines)) {
        Rail rail;
        for (const SurfacePoint& p : path.points)
            if (rail.points.empty() || apart(p, corner(rail.points.back())) > samePlace)
                rail.points.push_back({p.x, p.y});
        while (rail.points.size() > 1 && apart(corner(rail.points.front()), corner(rail.points.back())) < meeting)
            rail.points.pop_back();
        if (rail.points.size() < 3 || isBorder(rail, path.layer, length, width)) continue;
        takeRecess(rail, path.layer);
        drawn.rails.push_back(std::move(rail));
    }
    return drawn;
}

std::string lostInDrawing(const AirBearingSurface& surface)
{
    const auto hasWall = [](const Rail& rail) {
        return std::ranges::any_of(rail.points, [](const RailPoint& point) { return point.wall != 0; });
    };
    std::vector<std::string> lost;
    if (std::ranges::any_of(surface.rails, hasWall)) lost.push_back("walls");
    if (surface.crown != 0.0 || surface.camber != 0.0 || surface.twist != 0.0)
        lost.push_back("crown, camber and twist");
    if (surface.taperLength != 0.0) lost.push_back("taper");
    if (!surface.pointsOfInterest.empty()) lost.push_back("points of interest");
    if (!surface.distances.empty() || !surface.symmetries.empty()) lost.push_back("kept distances and symmetries");
    if (lost.empty()) return {};
    std::string text = "a drawing has no " + lost.front();
    for (std::size_t i = 1; i < lost.size(); ++i) text += (i + 1 < lost.size() ? ", no " : " and no ") + lost[i];
    return text;
}

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/dxf_drawing.h"

#include <dxflib/dl_creationadapter.h>
#include <dxflib/dl_dxf.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <new>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <variant>

#include "core/formats/quotation.h"
#include "core/formats/reader_process.h"
#include "core/formats/text_file.h"

namespace touchdown {

namespace {

constexpr std::uintmax_t largestFile = 64 << 20;                // [byte]
constexpr std::size_t mostPaths = 50'000, mostPoints = 500'000; // a plan draws them in a tenth of a second
constexpr double largestNumber = 1e9;                           // of a coordinate, in units of the drawing
constexpr double piece = 4.0 * std::numbers::pi / 180.0;        // of an arc [rad]

/// Length of a unit by its number in $INSUNITS [m]; 0: none.
double unitOf(int number)
{
    static const std::map<int, double> units{{1, 25.4e-3}, {2, 0.3048},  {4, 1e-3},   {5, 1e-2},  {6, 1.0},
                                             {8, 25.4e-9}, {9, 25.4e-6}, {11, 1e-10}, {12, 1e-9}, {13, 1e-6}};
    const auto found = units.find(number);
    return found == units.end() ? 0.0 : found->second;
}

/// "1 hatch", "2 hatches", "1 text".
std::string counted(int count, const std::string& plural)
{
    const std::size_t ending = count != 1 ? 0 : plural.ends_with("hes") ? 2 : 1;
    return std::to_string(count) + ' ' + plural.substr(0, plural.size() - ending);
}

/// Takes what the library finds in a file.
class DrawingReader : public DL_CreationAdapter {
public:
    Drawing drawing() &&
    {
        finish();
        for (const auto& [what, count] : others_) {
            const bool last = what == others_.rbegin()->first;
            if (!drawing_.remark.empty()) drawing_.remark += last ? " and " : ", ";
            drawing_.remark += counted(count, what);
        }
        if (!others_.empty())
            drawing_.remark +=
                others_.size() == 1 && others_.begin()->second == 1 ? " is not shown." : " are not shown.";
        if (drawing_.paths.empty())
            drawing_.problem = "holds no line, polyline, arc or circle that can be drawn" +
                               (others_.empty() ? "" : ": " + drawing_.remark.substr(0, drawing_.remark.size() - 1));
        return std::move(drawing_);
    }

    void setVariableInt(const std::string& key, int value, int /*code*/) override
    {
        if (key == "$INSUNITS") drawing_.unit = unitOf(value);
    }
    void addBlock(const DL_BlockData& /*data*/) override { inBlock_ = true; }
    void endBlock() override
    {
        finish();
        inBlock_ = false;
    }
    void addLine(const DL_LineData& line) override
    {
        begin(false);
        mirrored_ = false; // a line is in the coordinates of the world
        path_.points = {{line.x1, line.y1}, {line.x2, line.y2}};
        finish();
    }
    void addArc(const DL_ArcData& arc) override
    {
        begin(false);
        const double from = arc.angle1 * std::numbers::pi / 180.0;
        double sweep = std::fmod(arc.angle2 - arc.angle1, 360.0) * std::numbers::pi / 180.0;
        if (!(sweep > 0.0)) sweep += 2.0 * std::numbers::pi;
        addArc({arc.cx, arc.cy}, arc.radius, from, sweep, 1.0);
        finish();
    }
    void addCircle(const DL_CircleData& circle) override
    {
        begin(true);
        addArc({circle.cx, circle.cy}, circle.radius, 0.0, 2.0 * std::numbers::pi, 1.0);
        path_.points.pop_back(); // the first one again
        finish();
    }
    void addPolyline(const DL_PolylineData& polyline) override
    {
        constexpr int isClosed = 1, isSpatial = 8, isMesh = 16 | 64;
        if ((polyline.flags & isMesh) != 0) return count("meshes");
        begin((polyline.flags & isClosed) != 0);
        if ((polyline.flags & isSpatial) != 0) mirrored_ = false; // as a line
        polyline_ = true;
    }
    void addVertex(const DL_VertexData& vertex) override
    {
        if (!polyline_) return;
        limit();
        addBulge({vertex.x, vertex.y});
        bulge_ = vertex.bulge;
    }
    void endEntity() override
    {
        if (path_.points.size() > 1) finish();
    }
    void endSequence() override { finish(); }

    void addText(const DL_TextData& /*data*/) override { count("texts"); }
    void addMText(const DL_MTextData& /*data*/) override { count("texts"); }
    void addArcAlignedText(const DL_ArcAlignedTextData& /*data*/) override { count("texts"); }
    void addAttribute(const DL_AttributeData& /*data*/) override { count("texts"); }
    void addInsert(const DL_InsertData& /*data*/) override { count("blocks"); }
    void addSpline(const DL_SplineData& /*data*/) override { count("splines"); }
    void addEllipse(const DL_EllipseData& /*data*/) override { count("ellipses"); }
    void addHatch(const DL_HatchData& /*data*/) override { count("hatches"); }
    void addPoint(const DL_PointData& /*data*/) override { count("points"); }
    void addSolid(const DL_SolidData& /*data*/) override { count("solids"); }
    void addTrace(const DL_TraceData& /*data*/) override { count("solids"); }
    void add3dFace(const DL_3dFaceData& /*data*/) override { count("solids"); }
    void addLeader(const DL_LeaderData& /*data*/) override { count("leaders"); }
    void addImage(const DL_ImageData& /*data*/) override { count("pictures"); }
    void addXLine(const DL_XLineData& /*data*/) override { count("endless lines"); }
    void addRay(const DL_RayData& /*data*/) override { count("endless lines"); }
    void addDimAlign(const DL_DimensionData&, const DL_DimAlignedData&) override { count("dimensions"); }
    void addDimLinear(const DL_DimensionData&, const DL_DimLinearData&) override { count("dimensions"); }
    void addDimRadial(const DL_DimensionData&, const DL_DimRadialData&) override { count("dimensions"); }
    void addDimDiametric(const DL_DimensionData&, const DL_DimDiametricData&) override { count("dimensions"); }
    void addDimAngular(const DL_DimensionData&, const DL_DimAngular2LData&) override { count("dimensions"); }
    void addDimAngular3P(const DL_DimensionData&, const DL_DimAngular3PData&) override { count("dimensions"); }
    void addDimOrdinate(const DL_DimensionData&, const DL_DimOrdinateData&) override { count("dimensions"); }

private:
    /// A block counts where it is inserted, not what it is made of.
    void count(const char* what)
    {
        finish();
        if (!inBlock_) ++others_[what];
    }
    void begin(bool closed)
    {
        finish();
        path_ = {attributes.getLayer(), closed, {}};
        const auto mark = findInvalidUtf8(path_.layer);
        if (mark != std::string::npos) path_.layer.erase(mark);
        mirrored_ = getExtrusion() != nullptr && getExtrusion()->getDirection()[2] < 0.0;
    }
    void limit() const
    {
        if (drawing_.paths.size() >= mostPaths || points_ + path_.points.size() >= mostPoints)
            throw std::length_error("holds more than 50,000 lines or 500,000 corners, the most that are drawn");
    }
    void addArc(const SurfacePoint& centre, double radius, double from, double sweep, double sign)
    {
        limit();
        if (!(sweep > 0.0 && sweep < 2.0 * std::numbers::pi)) sweep = 2.0 * std::numbers::pi;
        const int pieces = std::max(1, static_cast<int>(std::ceil(sweep / piece - 1e-9)));
        for (int k = 0; k <= pieces; ++k) {
            const double angle = from + sign * sweep * k / pieces;
            path_.points.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
        }
    }
    /// To the next corner of a polyline: a bulge is the tangent of a quarter of the angle of an arc, positive to the
    /// left.
    void addBulge(const SurfacePoint& to)
    {
        constexpr double least = 1e-6, most = 1e6; // a smaller bulge cannot be seen
        if (!path_.points.empty() && std::abs(bulge_) > least && std::abs(bulge_) < most) {
            const SurfacePoint from = path_.points.back();
            const double dx = to.x - from.x, dy = to.y - from.y, aside = (1.0 - bulge_ * bulge_) / (4.0 * bulge_);
            const SurfacePoint centre{0.5 * (from.x + to.x) - aside * dy, 0.5 * (from.y + to.y) + aside * dx};
            path_.points.pop_back();
            addArc(centre, std::hypot(from.x - centre.x, from.y - centre.y),
                   std::atan2(from.y - centre.y, from.x - centre.x), 4.0 * std::atan(std::abs(bulge_)),
                   bulge_ > 0.0 ? 1.0 : -1.0);
            path_.points.pop_back();
        }
        path_.points.push_back(to);
    }
    void finish()
    {
        if (polyline_ && path_.closed && path_.points.size() > 1 && bulge_ != 0.0) {
            addBulge(path_.points.front());
            path_.points.pop_back();
        }
        polyline_ = false;
        bulge_ = 0.0;
        DrawnPath path = std::exchange(path_, {});
        if (inBlock_ || path.points.empty()) return;
        if (path.points.size() > 3 && path.points.front() == path.points.back()) {
            path.closed = true;
            path.points.pop_back();
        }
        const bool finite = std::ranges::all_of(path.points, [](const SurfacePoint& p) {
            return std::abs(p.x) < largestNumber && std::abs(p.y) < largestNumber;
        });
        if (!finite) ++others_["impossible lines"];
        if (!finite || path.points.size() < 2) return;
        if (mirrored_)
            for (SurfacePoint& p : path.points) p.x = -p.x;
        limit();
        points_ += path.points.size();
        drawing_.paths.push_back(std::move(path));
    }

    Drawing drawing_;
    DrawnPath path_;                    // under way
    std::map<std::string, int> others_; // what is not shown, by its kind
    double bulge_ = 0.0;                // from the last corner of a polyline on
    std::size_t points_ = 0;            // of all paths
    bool inBlock_ = false, polyline_ = false, mirrored_ = false;
};

Drawing failed(const std::string& problem)
{
    Drawing drawing;
    drawing.problem = problem;
    return drawing;
}

} // namespace

Drawing readDxfDirectly(const std::filesystem::path& file)
{
    const auto read = readTextFile(file, largestFile, FileContent::Text);
    if (const auto* problem = std::get_if<FileProblem>(&read)) return failed(problem->message);
    const std::string& text = std::get<std::string>(read);
    const std::string_view end = std::string_view(text).substr(0, text.find_last_not_of(" \t\r\n") + 1);
    if (end.empty()) return failed("is empty");
    if (text.find("SECTION") == std::string::npos) return failed("is not a DXF drawing");
    if (!end.ends_with("EOF")) return failed("is cut off: it does not end with EOF, as a DXF drawing does");
    try {
        std::istringstream stream(text);
        DrawingReader reader;
        DL_Dxf().in(stream, &reader);
        return std::move(reader).drawing();
    } catch (const std::length_error& tooLarge) {
        return failed(tooLarge.what());
    } catch (const std::bad_alloc&) {
        return failed("is damaged: it asks for more memory than a file of its size needs");
    }
}

Drawing readDxf(const std::filesystem::path& file)
{
    if (std::string problem = notRegularFile(file); !problem.empty()) return failed(problem);
    Drawing drawing;
    try {
        readAnswer({"drawing", file, ""}, drawing);
    } catch (const ReaderFailure& failure) {
        return failed(failure.what());
    }
    return drawing;
}

} // namespace touchdown

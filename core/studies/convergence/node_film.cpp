// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/convergence/node_film.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "core/numerics/gmres.h"
#include "core/numerics/multigrid.h"

namespace touchdown {

namespace {

constexpr double tolerance = 5e-7; // of the residual; the jumps of the fit of Fukui and Kaneko allow 1e-7 [-]
constexpr int maximumSteps = 60;

/// Control volumes along one axis: those of the nodes inside, from face to face.
struct Line {
    explicit Line(const std::vector<double>& lines) : node(lines)
    {
        for (std::size_t k = 0; k + 1 < node.size(); ++k) face.push_back(0.5 * (node[k] + node[k + 1]));
    }
    int volumes() const { return static_cast<int>(face.size()) - 1; }
    double width(int k) const { return face[static_cast<std::size_t>(k) + 1] - face[static_cast<std::size_t>(k)]; }

    /// From the node of a volume to the middle of the line.
    double arm(int k) const { return 0.5 * (node.front() + node.back()) - node[static_cast<std::size_t>(k) + 1]; }

    std::vector<double> node, face; // [m]
};

struct RecessShare {
    double recess; // [m]
    double share;  // of the face [-]
};

struct Face {
    std::size_t shares, shareEnd; // in shares_
    double x, y;                  // of its middle node [m]
    double lift;                  // of the slider's plane above the disk there [m]
    double meanRecess;            // [m]
    double width, length;         // of the face, between its nodes [m]
    double speed;                 // of the disk across it, halved [m/s]
};

} // namespace

class NodeFilm::Solver {
public:
    Solver(const Recess& recess, const FilmSetting& setting, const CellGrid& nodes, FaceGaps gaps)
        : setting_(setting),
          table_(setting.slip, setting.air),
          lines_{Line(nodes.x), Line(nodes.y)},
          pad_{lines_[0].volumes(), lines_[1].volumes()},
          p_(pad_.size(), setting.air.pressure)
    {
        for (int axis = 0; axis < 2; ++axis) {
            const std::size_t a = static_cast<std::size_t>(axis);
            faces_[a].resize(pad_.size());
            for (auto* field : {&flow_[a], &lower_[a], &upper_[a], &diffusion_[a], &effective_[a], &convection_[a]})
                field->assign(pad_.size(), 0.0);
            forFaces(axis, [&](std::size_t at, int along, int across) {
                faces_[a][at] = faceAt(recess, axis, along, across, gaps);
            });
        }
    }

    void setAttitude(const Attitude& attitude)
    {
        flowScale_ = 0.0;
        for (int axis = 0; axis < 2; ++axis) {
            const std::size_t a = static_cast<std::size_t>(axis);
            forFaces(axis, [&](std::size_t at, int, int) {
                Face& face = faces_[a][at];
                face.lift = attitude.height + attitude.pitch * (lines_[0].node.back() - face.x) -
                            attitude.roll * (face.y - 0.5 * lines_[1].node.back());
                flowScale_ +=
                    setting_.air.pressure * std::abs(convectionOf(face)) / static_cast<double>(lines_[a].face.size());
            });
        }
    }

    NodeFilmResult solve(const std::function<bool()>& goOn)
    {
        NodeFilmResult result;
        Multigrid<double> multigrid(pad_);
        Gmres<double> gmres(pad_.size());
        std::vector<double> residual(pad_.size(), 0.0), step(pad_.size());
        for (int k = 0; k <= maximumSteps; ++k) {
            linearise();
            divergence(flow_, flow_, p_, residual);
            double sum = 0.0;
            for (double& r : residual) {
                sum += std::abs(r);
                r = -r;
            }
            result.residual = sum / flowScale_;
            result.converged = result.residual <= tolerance;
            if (result.converged || (goOn && !goOn())) break;
            multigrid.setOperator({FaceOperator{diffusion_[0], effective_[0], convection_[0]},
                                   FaceOperator{diffusion_[1], effective_[1], convection_[1]}},
                                  {});
            std::fill(step.begin(), step.end(), 0.0);
            gmres.solve(
                [this](std::span<const double> v, std::span<double> out) { divergence(lower_, upper_, v, out); },
                [&](std::span<const double> v, std::span<double> out) { multigrid.precondition(v, out); }, residual,
                step, {});
            for (std::size_t at = 0; at < p_.size(); ++at)
                p_[at] = std::clamp(p_[at] + step[at], p_[at] / 3.0, 3.0 * p_[at]);
        }
        for (int j = 0; j < pad_.ny; ++j)
            for (int i = 0; i < pad_.nx; ++i) {
                const double force =
                    (p_[pad_.at(i, j)] - setting_.air.pressure) * lines_[0].width(i) * lines_[1].width(j);
                result.load += force;
                result.pitchTorque += force * lines_[0].arm(i);
                result.rollTorque += force * lines_[1].arm(j);
            }
        return result;
    }

private:
    /// Calls visit(padded index, number along the axis, number across).
    template <typename Visit>
    void forFaces(int axis, Visit&& visit) const
    {
        for (int j = 0; j < pad_.ny + axis; ++j)
            for (int i = 0; i < pad_.nx + 1 - axis; ++i) visit(pad_.at(i, j), axis == 0 ? i : j, axis == 0 ? j : i);
    }

    Face faceAt(const Recess& recess, int axis, int along, int across, FaceGaps gaps)
    {
        const Line& line = lines_[static_cast<std::size_t>(axis)];
        const Line& other = lines_[static_cast<std::size_t>(1 - axis)];
        const std::size_t k = static_cast<std::size_t>(along), m = static_cast<std::size_t>(across);
        const double position = line.face[k], low = other.face[m], high = other.face[m + 1], node = other.node[m + 1];
        const double x = axis == 0 ? position : node, y = axis == 0 ? node : position;
        const Velocity disk = diskVelocity(setting_.disk, recess.length(), recess.width(), x, y);
        Face face{.shares = shares_.size(),
                  .shareEnd = 0,
                  .x = x,
                  .y = y,
                  .lift = 0.0,
                  .meanRecess = 0.0,
                  .width = high - low,
                  .length = line.node[k + 1] - line.node[k],
                  .speed = 0.5 * (axis == 0 ? disk.x : disk.y)};

        breaks_.assign(1, low);
        const bool smooth =
            axis == 0 ? recess.isSmooth(position, position, low, high) : recess.isSmooth(low, high, position, position);
        if (!smooth && gaps == FaceGaps::TwoOfSamples) {
            const int samples = axis == 0 ? 10 : 20;
            for (int s = 1; s < samples; ++s) breaks_.push_back(low + (high - low) * s / samples);
        } else if (!smooth) {
            std::vector<double> edges;
            if (axis == 0)
                recess.breaksAlongY(position, low, high, edges);
            else
                recess.breaksAlongX(position, low, high, edges);
            edges.push_back(high);
            for (const double edge : edges) // walls slope between their breaks
                for (double from = breaks_.back(), part = 0.25; part <= 1.0; part += 0.25)
                    breaks_.push_back(from + part * (edge - from));
            breaks_.pop_back();
        }
        breaks_.push_back(high);
        for (std::size_t s = 0; s + 1 < breaks_.size(); ++s) {
            const double at = 0.5 * (breaks_[s] + breaks_[s + 1]), share = (breaks_[s + 1] - breaks_[s]) / face.width;
            shares_.push_back({axis == 0 ? recess.at(position, at) : recess.at(at, position), share});
            face.meanRecess += share * shares_.back().recess;
        }
        if (!smooth && gaps != FaceGaps::All) keepTwo(face);
        face.shareEnd = shares_.size();
        return face;
    }

    void keepTwo(const Face& face)
    {
        const auto first = shares_.begin() + static_cast<std::ptrdiff_t>(face.shares);
        const auto [lowest, highest] = std::minmax_element(
            first, shares_.end(), [](const RecessShare& a, const RecessShare& b) { return a.recess < b.recess; });
        const double shallow = lowest->recess, deep = highest->recess;
        const double share = deep > shallow ? (face.meanRecess - shallow) / (deep - shallow) : 0.5;
        shares_.resize(face.shares);
        shares_.push_back({deep, share});
        shares_.push_back({shallow, 1.0 - share});
    }

    double convectionOf(const Face& face) const
    {
        return face.speed * face.width * std::max(0.0, face.meanRecess + face.lift);
    }

    void linearise()
    {
        if (setting_.scheme == ConvectionScheme::PowerLaw)
            linearise<ConvectionScheme::PowerLaw>();
        else
            linearise<ConvectionScheme::Exponential>();
    }
    template <ConvectionScheme scheme>
    void linearise()
    {
        for (int axis = 0; axis < 2; ++axis) {
            const std::size_t a = static_cast<std::size_t>(axis), back = pad_.step(axis);
            forFaces(axis, [&](std::size_t at, int, int) {
                const Face& face = faces_[a][at];
                const double p1 = p_[at - back], p2 = p_[at], pm = 0.5 * (p1 + p2);
                double K = 0.0, byMean = 0.0; // dK/dpm
                for (std::size_t s = face.shares; s < face.shareEnd; ++s) {
                    const double h = shares_[s].recess + face.lift;
                    if (!(h > closedGap)) continue;
                    const FlowTable::Value g = table_.at(pm * h, h);
                    K += shares_[s].share * h * h * g.mobility;
                    byMean += shares_[s].share * h * h * h * g.derivative;
                }
                const double unit = face.width / (12.0 * setting_.air.viscosity * face.length);
                const double c = convectionOf(face);
                const EffectiveConductance e = effectiveConductance<scheme>(unit * K, c);
                const double own = 0.5 * e.byDiffusion * unit * byMean * (p1 - p2); // dF/dp1 and dF/dp2 from K alone
                flow_[a][at] = c * pm - e.value * (p2 - p1);
                lower_[a][at] = 0.5 * c + e.value + own;
                upper_[a][at] = 0.5 * c - e.value + own;
                diffusion_[a][at] = unit * K;
                convection_[a][at] = lower_[a][at] + upper_[a][at];
                effective_[a][at] = std::max(e.value, 0.5 * std::abs(convection_[a][at]));
            });
        }
    }

    using Pair = std::array<std::vector<double>, 2>;
    /// Net outflow of faces that pass lower v1 + upper v2, or, where both are the flow itself, of that.
    void divergence(const Pair& lower, const Pair& upper, std::span<const double> v, std::span<double> out) const
    {
        const bool flows = &lower == &upper;
        const auto through = [&](std::size_t a, std::size_t at, std::size_t back) {
            return flows ? lower[a][at] : lower[a][at] * v[at - back] + upper[a][at] * v[at];
        };
        const std::size_t up = pad_.stride();
        for (int j = 0; j < pad_.ny; ++j)
            for (int i = 0; i < pad_.nx; ++i) {
                const std::size_t at = pad_.at(i, j);
                out[at] = through(0, at + 1, 1) - through(0, at, 1) + through(1, at + up, up) - through(1, at, up);
            }
    }

    FilmSetting setting_;
    FlowTable table_;
    std::array<Line, 2> lines_;
    PaddedGrid pad_;
    std::vector<double> p_;  // rings at p0 [Pa]
    double flowScale_ = 0.0; // [Pa m^3/s]
    std::array<std::vector<Face>, 2> faces_;
    std::vector<RecessShare> shares_;
    std::vector<double> breaks_; // work space [m]
    Pair flow_, lower_, upper_, diffusion_, effective_, convection_;
};

NodeFilm::NodeFilm(const Recess& recess, const FilmSetting& setting, const CellGrid& nodes, FaceGaps gaps)
    : solver_(std::make_unique<Solver>(recess, setting, nodes, gaps))
{}

NodeFilm::~NodeFilm() = default;

NodeFilmResult NodeFilm::solve(const Attitude& attitude, const std::function<bool()>& goOn)
{
    solver_->setAttitude(attitude);
    return solver_->solve(goOn);
}

} // namespace touchdown

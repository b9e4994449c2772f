// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "core/case/contact_kind.h"
#include "core/simulation/contact/disk_under_film.h"
#include "core/simulation/flight/film_run.h"
#include "core/simulation/flight/film_scene.h"
#include "core/simulation/flight/linear_film.h"
#include "core/simulation/small_motions/disk_waves.h"
#include "core/simulation/small_motions/linear_state.h"
#include "core/simulation/small_motions/small_motions.h"
#include "core/simulation/static_state/film_setup.h"
#include "core/studies/response/forced_film.h"
#include "core/studies/response/forced_springs.h"
#include "core/work/team.h"

namespace touchdown {

using Complex = std::complex<double>;
using Eigen::Index, Eigen::VectorXcd;

namespace {

constexpr double nodesOfBeat = 8.0; // at least [-]
constexpr int degree = 5;           // of the polynomials between nodes

} // namespace

/// Of a case, while it is made.
struct FilmUnderWaves::Made {
    explicit Made(const Case& given) : c(given), still(FilmInPieces::stillCase(given)), scene(still) {}

    Case c, still;
    FilmScene scene;
    SurfacePoint point; // whose disk counts the time [m]
};

std::vector<Quantity> quantitiesOfForcedFilm(const Case& c)
{
    Case wavy = c;
    wavy.diskSurface.kind = DiskSurfaceKind::Waves;
    std::vector<Quantity> all = filmQuantities(wavy);
    std::erase_if(all, [](const Quantity& each) {
        constexpr std::array taken{"flying_height", "flying_height_above_disk", "minimum_spacing", "height", "pitch",
                                   "roll"};
        return std::ranges::find(taken, each.name) == taken.end();
    });
    return all;
}

std::string reasonAgainstForcedFilm(const Case& c)
{
    if (c.film.motion != FilmMotion::Linear)
        return "has its film solved in each step: a study of forced motion takes a linear film (film.motion = "
               "\"linear\")";
    if (c.contact != noContact && c.contact != ContactKind::OnoYamane)
        return "has a contact that is not linear in pieces: a study of forced motion takes contact = \"none\" or "
               "\"ono-yamane\"";
    return {};
}

std::shared_ptr<const FilmUnderWaves> FilmUnderWaves::make(const Case& c, const std::string& quantity, double amplitude,
                                                           std::span<const double> frequencies, double beat,
                                                           const std::function<bool(double share)>& goOn)
{
    const TeamScope team(filmThreads(c));
    Made made(c);
    switch (made.scene.prepare([&] { return goOn(0.0); })) {
    case FilmScene::State::Stopped: return nullptr;
    case FilmScene::State::Failed: throw std::runtime_error(made.scene.message);
    case FilmScene::State::Ready: break;
    }
    const std::shared_ptr<FilmUnderWaves> film(new FilmUnderWaves);
    film->pieces_ = std::make_unique<const FilmInPieces>(made.scene, made.still);
    const FilmInPieces& pieces = *film->pieces_;
    film->amplitude_ = amplitude;
    film->limit_ = c.film.linearLimit;

    made.point = FilmInPieces::pointOf(c);
    if (quantity == "minimum_spacing") film->quantity_.film = pieces.separation();
    if (quantity == "flying_height" || quantity == "flying_height_above_disk")
        film->quantity_.film = pieces.flyingHeight();
    if (quantity == "flying_height_above_disk") film->quantity_.disk = {0.0, 1.0}; // less a sin(omega t)
    for (Index k = 0; k < 3; ++k)
        if (quantity == std::array{"height", "pitch", "roll"}[static_cast<std::size_t>(k)])
            film->quantity_.film = pieces.reading(Vector3::Unit(k), pieces.place()[k]);

    // Where the case starts too far from the state for a linear film, the slider starts there at rest.
    auto [u, w] = pieces.startOf(c);
    if (linearErrorPerSize * u.cwiseAbs().sum() > film->limit_ * pieces.gap()) {
        u.setZero();
        w.setZero();
    }
    film->start_ = {pieces.settledAt(u, w), {.contact = pieces.regions()[pieces.atRest()].name}};
    return film->setForces(made, frequencies, beat, goOn) ? film : nullptr;
}

bool FilmUnderWaves::setForces(Made& made, std::span<const double> frequencies, double beat,
                               const std::function<bool(double)>& goOn)
{
    for (std::size_t i = 0; i < frequencies.size(); ++i) {
        const double from = frequencies[i], width = i + 1 < frequencies.size() ? frequencies[i + 1] - from : 0.0;
        const int parts = beat > 0.0 ? std::max(1, static_cast<int>(std::ceil(nodesOfBeat * width / beat))) : 1;
        for (int k = 0; k < (width > 0.0 ? parts : 1); ++k) nodes_.push_back(from + width * k / parts);
    }
    FilmScene& scene = made.scene;
    FilmLevel& level = *scene.level;
    level.film.setAttitude(scene.body->attitude(pieces_->place()));
    SmallMotions motions(level, *scene.body);
    bool goes = true;
    motions.ask(
        [&] { return goes = goes && goOn(static_cast<double>(forces_.size()) / static_cast<double>(nodes_.size())); });
    for (const double frequency : nodes_) {
        const Case over = caseOverWave(made.c, amplitude_, frequency, 0.0);
        const std::vector<DiskWave> waves = diskWaves(over, level.gaps);
        if (waves.empty()) throw std::runtime_error("the waves do not pass under the slider");
        const DiskWave& wave = waves.front();
        ComplexVector3 force = motions.force({0.0, wave.omega}, wave.real, wave.quarter);
        if (!goes) return false;
        if (!motions.converged() || !force.allFinite())
            throw std::runtime_error("the film's answer to waves at one frequency was not found");
        // The wave under the point is Re W e^(i omega t); it is to be a sin(omega t).
        const DiskTopography topography(over.diskSurface);
        const Velocity v = surfaceVelocity(over, topography);
        const auto under = [&](double time) {
            return topography.height(made.point.x - v.x * time, made.point.y - v.y * time);
        };
        Complex here(under(0.0), under(-0.5 * std::numbers::pi / wave.omega));
        if (wave.omega < 0.0) {
            force = force.conjugate().eval();
            here = std::conj(here);
        }
        force *= Complex(0.0, -amplitude_) / here;
        forces_.emplace_back(FilmInPieces::rateUnit *
                             force.cwiseProduct(pieces_->toRate().cast<Complex>()).head(pieces_->positions()));
    }
    return true;
}

VectorXcd FilmUnderWaves::forceAt(double frequency) const
{
    const std::size_t count = nodes_.size(), points = std::min<std::size_t>(degree + 1, count);
    const auto above = static_cast<std::size_t>(std::ranges::lower_bound(nodes_, frequency) - nodes_.begin());
    if (above < count && nodes_[above] == frequency) return forces_[above];
    const std::size_t first = std::min(above - std::min(above, points / 2), count - points);
    VectorXcd sum = VectorXcd::Zero(pieces_->positions());
    for (std::size_t i = first; i < first + points; ++i) {
        double weight = 1.0;
        for (std::size_t k = first; k < first + points; ++k)
            if (k != i) weight *= (frequency - nodes_[k]) / (nodes_[i] - nodes_[k]);
        sum += weight * forces_[i];
    }
    return sum;
}

} // namespace touchdown

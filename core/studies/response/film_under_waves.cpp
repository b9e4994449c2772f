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
#include "core/simulation/contact/pad_contact.h"
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
using Eigen::Index, Eigen::MatrixXcd, Eigen::MatrixXd, Eigen::VectorXcd, Eigen::VectorXd;

namespace {

constexpr double nodesOfBeat = 8.0;    // at least [-]
constexpr double bearingDepth = 1e-11; // as of the pad [m]
constexpr int degree = 5;              // of the polynomials between nodes

/// Over a flat disk, at rest: the slider's start is not that of the film.
Case stillCase(Case c)
{
    c.diskSurface = {};
    c.film.motion = FilmMotion::Linear;
    c.initial.state = InitialState::Static;
    c.initial.heightOffset = c.initial.pitchOffset = c.initial.rollOffset = 0.0;
    return c;
}

/// Of the height of a place of the slider, by q.
Vector3 slopeAt(const Case& c, SurfacePoint at)
{
    return {1.0, 0.5 * c.slider.length - at.x, 0.5 * c.slider.width - at.y};
}

double partsOf(Complex pole) { return pole.imag() == 0.0 ? 1.0 : 2.0; }

} // namespace

/// Of a case, while it is made.
struct FilmUnderWaves::Made {
    explicit Made(const Case& given) : c(given), still(stillCase(given)), scene(still) {}

    Case c, still;
    FilmScene scene;
    Vector3 q = Vector3::Zero(), scale = Vector3::Zero(), toRate = Vector3::Zero(); // q_0, S, 1/(M S)
    SurfacePoint point;                                                             // whose disk counts the time [m]
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
    const LinearFilmModel& linear = *made.scene.linear;
    const SliderBody& body = *made.scene.body;
    made.q = linear.place;
    made.scale = linear.arms.cwiseInverse();
    made.toRate = (body.inertia().cwiseProduct(made.scale)).cwiseInverse();
    film->positions_ = body.holdsRoll() ? 2 : 3;
    film->amplitude_ = amplitude;
    film->limit_ = c.film.linearLimit;
    for (const FilmFit::Pole& pole : linear.fit.poles) film->poles_.push_back(pole.rate);
    film->size_ = 2 * film->positions_;
    for (const Complex pole : film->poles_) film->size_ += static_cast<Index>(partsOf(pole)) * film->positions_;

    const Attitude rest = body.attitude(made.q);
    const SurfacePoint pad = made.scene.spacing.bearing(rest, bearingDepth).at;
    film->separation_ = film->readingOf(made, slopeAt(c, pad), made.scene.spacing.at(rest).spacing);
    made.point = c.surface.pointsOfInterest.empty() ? SurfacePoint{c.slider.length, 0.5 * c.slider.width}
                                                    : c.surface.pointsOfInterest.front();
    const Vector3 atPoint = slopeAt(c, made.point);
    const double flyingHeight = atPoint.dot(made.q) + made.scene.recess.at(made.point.x, made.point.y);
    if (quantity == "minimum_spacing") film->quantity_ = film->separation_;
    if (quantity == "flying_height" || quantity == "flying_height_above_disk")
        film->quantity_ = film->readingOf(made, atPoint, flyingHeight);
    if (quantity == "flying_height_above_disk") film->quantity_.disk = {0.0, 1.0}; // less a sin(omega t)
    for (Index k = 0; k < 3; ++k)
        if (quantity == std::array{"height", "pitch", "roll"}[static_cast<std::size_t>(k)])
            film->quantity_ = film->readingOf(made, Vector3::Unit(k), made.q[k]);
    film->setRegions(made);

    // Where the case starts too far from the state for a linear film, the slider starts there at rest.
    Vector3 u = Vector3::Zero(), w = Vector3::Zero();
    if (c.initial.state == InitialState::Static) {
        u = Vector3(c.initial.heightOffset, c.initial.pitchOffset, c.initial.rollOffset).cwiseQuotient(made.scale);
        w = Vector3(c.initial.verticalVelocity, c.initial.pitchVelocity, c.initial.rollVelocity)
                .cwiseQuotient(made.scale);
    }
    if (linearErrorPerSize * u.cwiseAbs().sum() > film->limit_ * film->gap()) u = w = Vector3::Zero();
    film->start_ = {film->settledAt(u.head(film->positions_), w.head(film->positions_)),
                    {.contact = film->regions_[film->atRest_].name}};
    return film->setForces(made, frequencies, beat, goOn) ? film : nullptr;
}

FilmUnderWaves::Reading FilmUnderWaves::readingOf(const Made& made, const Vector3& slope, double constant) const
{
    Reading reading;
    reading.row = Eigen::RowVectorXd::Zero(size_);
    reading.row.head(positions_) = slope.cwiseProduct(made.scale).head(positions_).transpose();
    reading.constant = constant;
    return reading;
}

double FilmUnderWaves::gap() const { return std::max(restSpacing(), leastLinearGap); }

VectorXd FilmUnderWaves::settledAt(const VectorXd& u, const VectorXd& w) const
{
    VectorXd y(size_);
    y << u, rateUnit * w, VectorXd::Zero(size_ - 2 * positions_);
    Index at = 2 * positions_;
    for (const Complex pole : poles_) {
        const Complex share = -std::abs(pole) / pole;
        y.segment(at, positions_) = share.real() * u;
        at += positions_;
        if (partsOf(pole) == 1.0) continue;
        y.segment(at, positions_) = share.imag() * u;
        at += positions_;
    }
    return y;
}

void FilmUnderWaves::setRegions(Made& made)
{
    const Index n = positions_;
    const LinearFilmModel& linear = *made.scene.linear;
    const SliderBody& body = *made.scene.body;
    const auto scaled = [&](const Matrix3& matrix) {
        return MatrixXd((made.toRate.asDiagonal() * matrix * made.scale.asDiagonal()).topLeftCorner(n, n));
    };
    // Without contact.
    MatrixXd a = MatrixXd::Zero(size_, size_);
    a.block(0, n, n, n) = MatrixXd::Identity(n, n) / rateUnit;
    a.block(n, 0, n, n) = -rateUnit * scaled(linear.fit.constant + Matrix3(body.springs().asDiagonal()));
    a.block(n, n, n, n) = -scaled(Matrix3(body.dampers().asDiagonal()));
    Index at = 2 * n;
    for (const FilmFit::Pole& pole : linear.fit.poles) {
        const double size = std::abs(pole.rate), parts = partsOf(pole.rate);
        const MatrixXd one = MatrixXd::Identity(n, n);
        a.block(at, at, n, n) = pole.rate.real() * one;
        a.block(at, 0, n, n) = size * one;
        a.block(n, at, n, n) = -rateUnit * parts / size * scaled(pole.residue.real());
        if (parts == 2.0) {
            a.block(n, at + n, n, n) = rateUnit * parts / size * scaled(pole.residue.imag());
            a.block(at, at + n, n, n) = -pole.rate.imag() * one;
            a.block(at + n, at, n, n) = pole.rate.imag() * one;
            a.block(at + n, at + n, n, n) = pole.rate.real() * one;
            at += n;
        }
        at += n;
    }
    const auto add = [&](ContactRegion name, const Matrix3& stiffness, const Vector3& force) -> Region& {
        Region& region = regions_.emplace_back();
        region.name = name;
        region.a = a;
        region.a.block(n, 0, n, n) -= rateUnit * scaled(stiffness);
        region.b = VectorXd::Zero(size_);
        region.b.segment(n, n) = rateUnit * force.cwiseProduct(made.toRate).head(n);
        const Eigen::EigenSolver<MatrixXd> eigen(region.a);
        region.rates = eigen.eigenvalues();
        region.vectors = eigen.eigenvectors();
        region.inverse = region.vectors.partialPivLu().inverse();
        region.shift = -region.a.partialPivLu().solve(region.b);
        if (eigen.info() != Eigen::Success || !region.inverse.allFinite() || !region.shift.allFinite())
            throw std::runtime_error("the motions over the linear film were not found (film.motion)");
        return region;
    };
    auto* pad = dynamic_cast<PadContact*>(made.scene.contact.get());
    CharacteristicLaw* law = pad ? pad->characteristic() : nullptr;
    if (!law) {
        add(ContactRegion::Apart, Matrix3::Zero(), Vector3::Zero());
    } else {
        const Attitude rest = body.attitude(made.q);
        const Vector3 bySeparation = slopeAt(made.c, made.scene.spacing.bearing(rest, bearingDepth).at);
        if (!law->acts()) pad->begin(made.c.initial.branch, rest); // else the scene has begun
        const Vector3 restForce = pad->at(rest, 0.0).load();
        const ContactRegion restRegion = law->region();
        constexpr std::array all{ContactRegion::Apart, ContactRegion::Pressed, ContactRegion::Lifting,
                                 ContactRegion::Bridged};
        const auto regionOf = [&](ContactRegion name) {
            law->setRegion(name);
            return law->region();
        };
        for (const ContactRegion name : all) {
            const ContactRegion known = regionOf(name);
            const auto found = std::ranges::find(regions_, known, &Region::name);
            places_[static_cast<std::size_t>(name)] = static_cast<std::size_t>(found - regions_.begin());
            if (found != regions_.end()) continue;
            // By the separation alone, which is that of a tangent: the bearing place stays as at rest.
            constexpr double rise = 1e-9; // [m]; the law is affine
            const Vector3 force = pad->at(rest, 0.0).load();
            const Vector3 slope = (pad->at({rest.height + rise, rest.pitch, rest.roll}, 0.0).load() - force) / rise;
            Region& region = add(known, -slope * bySeparation.transpose(), force - restForce);
            region.presses = known == ContactRegion::Pressed || known == ContactRegion::Lifting;
            region.interval = law->interval();
        }
        for (Region& region : regions_)
            for (const bool upper : {false, true}) {
                regionOf(region.name);
                law->cross(upper);
                (upper ? region.above : region.below) = placeOf(law->region());
            }
        atRest_ = placeOf(restRegion);
    }
    for (const Complex rate : regions_[atRest_].rates)
        if (std::abs(rate.imag()) > std::abs(rate.real())) fastest_ = std::max(fastest_, std::abs(rate));
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
    level.film.setAttitude(scene.body->attitude(made.q));
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
        forces_.emplace_back(rateUnit * force.cwiseProduct(made.toRate.cast<Complex>()).head(positions_));
    }
    return true;
}

VectorXcd FilmUnderWaves::forceAt(double frequency) const
{
    const std::size_t count = nodes_.size(), points = std::min<std::size_t>(degree + 1, count);
    const auto above = static_cast<std::size_t>(std::ranges::lower_bound(nodes_, frequency) - nodes_.begin());
    if (above < count && nodes_[above] == frequency) return forces_[above];
    const std::size_t first = std::min(above - std::min(above, points / 2), count - points);
    VectorXcd sum = VectorXcd::Zero(positions_);
    for (std::size_t i = first; i < first + points; ++i) {
        double weight = 1.0;
        for (std::size_t k = first; k < first + points; ++k)
            if (k != i) weight *= (frequency - nodes_[k]) / (nodes_[i] - nodes_[k]);
        sum += weight * forces_[i];
    }
    return sum;
}

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/flight/film_in_pieces.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "core/simulation/contact/pad_contact.h"
#include "core/simulation/flight/film_scene.h"
#include "core/simulation/flight/linear_film.h"

namespace touchdown {

using Complex = std::complex<double>;
using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr double bearingDepth = 1e-11; // as of the pad [m]

} // namespace

Case FilmInPieces::stillCase(Case c)
{
    c.diskSurface = {};
    c.film.motion = FilmMotion::Linear;
    c.initial.state = InitialState::Static;
    c.initial.heightOffset = c.initial.pitchOffset = c.initial.rollOffset = 0.0;
    return c;
}

FilmInPieces::FilmInPieces(const FilmScene& scene, const Case& still)
{
    const LinearFilmModel& linear = *scene.linear;
    const SliderBody& body = *scene.body;
    place_ = linear.place;
    scale_ = linear.arms.cwiseInverse();
    toRate_ = (body.inertia().cwiseProduct(scale_)).cwiseInverse();
    positions_ = body.holdsRoll() ? 2 : 3;
    for (const FilmFit::Pole& pole : linear.fit.poles) poles_.push_back(pole.rate);
    size_ = 2 * positions_;
    for (const Complex pole : poles_) size_ += static_cast<Index>(termsOf(pole)) * positions_;

    const Index n = positions_;
    const Attitude rest = body.attitude(place_);
    const SurfacePoint pad = scene.spacing.bearing(rest, bearingDepth).at;
    const Vector3 bySeparation{1.0, 0.5 * still.slider.length - pad.x, 0.5 * still.slider.width - pad.y};
    separation_ = reading(bySeparation, scene.spacing.at(rest).spacing);

    const auto scaled = [&](const Matrix3& matrix) {
        return MatrixXd((toRate_.asDiagonal() * matrix * scale_.asDiagonal()).topLeftCorner(n, n));
    };
    // Without contact.
    MatrixXd a = MatrixXd::Zero(size_, size_);
    a.block(0, n, n, n) = MatrixXd::Identity(n, n) / rateUnit;
    a.block(n, 0, n, n) = -rateUnit * scaled(linear.fit.constant + Matrix3(body.springs().asDiagonal()));
    a.block(n, n, n, n) = -scaled(Matrix3(body.dampers().asDiagonal()));
    Index at = 2 * n;
    for (const FilmFit::Pole& pole : linear.fit.poles) {
        const double size = std::abs(pole.rate), parts = termsOf(pole.rate);
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
        region.b.segment(n, n) = rateUnit * force.cwiseProduct(toRate_).head(n);
        const Eigen::EigenSolver<MatrixXd> eigen(region.a);
        region.rates = eigen.eigenvalues();
        region.vectors = eigen.eigenvectors();
        region.inverse = region.vectors.partialPivLu().inverse();
        region.shift = -region.a.partialPivLu().solve(region.b);
        if (eigen.info() != Eigen::Success || !region.inverse.allFinite() || !region.shift.allFinite())
            throw std::runtime_error("the motions over the linear film were not found (film.motion)");
        return region;
    };
    auto* padContact = dynamic_cast<PadContact*>(scene.contact.get());
    CharacteristicLaw* law = padContact ? padContact->characteristic() : nullptr;
    if (!law) {
        add(ContactRegion::Apart, Matrix3::Zero(), Vector3::Zero());
    } else {
        if (!law->acts()) padContact->begin(still.initial.branch, rest); // else the scene has begun
        const Vector3 restForce = padContact->at(rest, 0.0).load();
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
            constexpr double rise = 1e-9; // [m]; the law is affine
            const Vector3 force = padContact->at(rest, 0.0).load();
            const Vector3 slope =
                (padContact->at({rest.height + rise, rest.pitch, rest.roll}, 0.0).load() - force) / rise;
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

FilmInPieces::Reading FilmInPieces::reading(const Vector3& slope, double constant) const
{
    Reading reading{Eigen::RowVectorXd::Zero(size_), constant};
    reading.row.head(positions_) = slope.cwiseProduct(scale_).head(positions_).transpose();
    return reading;
}

double FilmInPieces::gap() const { return std::max(restSpacing(), leastLinearGap); }

VectorXd FilmInPieces::settledAt(const VectorXd& u, const VectorXd& w) const
{
    VectorXd y(size_);
    y << u, rateUnit * w, VectorXd::Zero(size_ - 2 * positions_);
    Index at = 2 * positions_;
    for (const Complex pole : poles_) {
        const Complex share = -std::abs(pole) / pole;
        y.segment(at, positions_) = share.real() * u;
        at += positions_;
        if (termsOf(pole) == 1.0) continue;
        y.segment(at, positions_) = share.imag() * u;
        at += positions_;
    }
    return y;
}

} // namespace touchdown

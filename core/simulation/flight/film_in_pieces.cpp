// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/flight/film_in_pieces.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "core/case/contact_law.h"
#include "core/simulation/contact/contact_lever.h"
#include "core/simulation/contact/pad_contact.h"
#include "core/simulation/flight/film_scene.h"
#include "core/simulation/flight/linear_film.h"

namespace touchdown {

using Complex = std::complex<double>;
using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr std::size_t contactRegions = 4;

} // namespace

Case FilmInPieces::stillCase(Case c)
{
    c.diskSurface = {};
    c.film.motion = FilmMotion::Linear;
    c.initial.state = InitialState::Static;
    c.initial.heightOffset = c.initial.pitchOffset = c.initial.rollOffset = 0.0;
    return c;
}

SurfacePoint FilmInPieces::pointOf(const Case& c)
{
    const auto& points = c.surface.pointsOfInterest;
    return points.empty() ? SurfacePoint{c.slider.length, 0.5 * c.slider.width} : points.front();
}

FilmInPieces::FilmInPieces(const FilmScene& scene, const Case& still, const Case& c, const FilmInPieces* known)
{
    minimumSpacing_ = known ? known->minimumSpacing_ : std::make_shared<const MinimumSpacing>(scene.spacing);
    length_ = c.slider.length;
    const LinearFilmModel& linear = *scene.linear;
    const SliderBody body = &c == &still ? *scene.body : bodyUnderLoad(c, *scene.body, linear.fit.at(0.0).real());
    place_ = linear.place;
    scale_ = linear.arms.cwiseInverse();
    toRate_ = (body.inertia().cwiseProduct(scale_)).cwiseInverse();
    positions_ = body.holdsRoll() ? 2 : 3;
    for (const FilmFit::Pole& pole : linear.fit.poles) poles_.push_back(pole.rate);
    size_ = 2 * positions_;
    for (const Complex pole : poles_) size_ += static_cast<Index>(termsOf(pole)) * positions_;

    const Attitude rest = body.attitude(place_);
    nearest_ = scene.spacing.bearing(rest, bearingDepth).at;
    const auto slopeAt = [&](SurfacePoint place) {
        return Vector3(1.0, 0.5 * c.slider.length - place.x, 0.5 * c.slider.width - place.y);
    };
    bySeparation_ = slopeAt(nearest_);
    separation_ = reading(bySeparation_, scene.spacing.at(rest).spacing);
    const SurfacePoint point = pointOf(c);
    const Vector3 atPoint = slopeAt(point);
    flyingHeight_ = reading(atPoint, atPoint.dot(place_) + scene.recess.at(point.x, point.y));

    setFlight(linear.fit, body);
    // What the load of the case adds to that of the static state.
    const Vector3 more = body.suspension(place_, Vector3::Zero()) - scene.body->suspension(place_, Vector3::Zero());
    setRegions(scene, still, c, more, known);
    for (const Complex rate : regions_[atRest_].rates)
        if (std::abs(rate.imag()) > std::abs(rate.real())) fastest_ = std::max(fastest_, std::abs(rate));
}

MatrixXd FilmInPieces::scaled(const Matrix3& matrix) const
{
    return (toRate_.asDiagonal() * matrix * scale_.asDiagonal()).topLeftCorner(positions_, positions_);
}

void FilmInPieces::setFlight(const FilmFit& fit, const SliderBody& body)
{
    const Index n = positions_;
    MatrixXd& a = flight_;
    a = MatrixXd::Zero(size_, size_);
    a.block(0, n, n, n) = MatrixXd::Identity(n, n) / rateUnit;
    a.block(n, 0, n, n) = -rateUnit * scaled(fit.constant + Matrix3(body.springs().asDiagonal()));
    a.block(n, n, n, n) = -scaled(Matrix3(body.dampers().asDiagonal()));
    Index at = 2 * n;
    for (const FilmFit::Pole& pole : fit.poles) {
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
    // Forces on the corners, of which the rows of w' are the accelerations.
    const VectorXd toForce = (scale_.cwiseQuotient(toRate_) / rateUnit).head(n);
    suspensionForce_ = MatrixXd::Zero(n, size_);
    const Vector3 springs = scale_.cwiseAbs2().cwiseProduct(body.springs()),
                  dampers = scale_.cwiseAbs2().cwiseProduct(body.dampers()) / rateUnit;
    suspensionForce_.leftCols(n).diagonal() = -springs.head(n);
    suspensionForce_.middleCols(n, n).diagonal() = -dampers.head(n);
    filmForce_ = toForce.asDiagonal() * a.middleRows(n, n) - suspensionForce_;
}

FilmInPieces::Region& FilmInPieces::add(ContactRegion name, const Matrix3& stiffness, const Vector3& force,
                                        const FilmInPieces* known)
{
    const Index n = positions_;
    Region& region = regions_.emplace_back();
    region.name = name;
    region.a = flight_;
    region.a.block(n, 0, n, n) -= rateUnit * scaled(stiffness);
    region.b = VectorXd::Zero(size_);
    region.b.segment(n, n) = rateUnit * force.cwiseProduct(toRate_).head(n);
    const Region* solved = known ? known->find(region.a) : nullptr;
    if (!solved) solved = find(region.a, regions_.size() - 1);
    if (solved) {
        region.rates = solved->rates;
        region.vectors = solved->vectors;
        region.inverse = solved->inverse;
    } else {
        const Eigen::EigenSolver<MatrixXd> eigen(region.a);
        region.rates = eigen.eigenvalues();
        region.vectors = eigen.eigenvectors();
        region.inverse = region.vectors.partialPivLu().inverse();
        if (eigen.info() != Eigen::Success || !region.inverse.allFinite())
            throw std::runtime_error("the motions over the linear film were not found (film.motion)");
    }
    region.shift = -region.a.partialPivLu().solve(region.b);
    if (!region.shift.allFinite())
        throw std::runtime_error("the state of rest on the linear film was not found (film.motion)");
    return region;
}

void FilmInPieces::setRegions(const FilmScene& scene, const Case& still, const Case& c, const Vector3& more,
                              const FilmInPieces* known)
{
    const std::optional<OnoYamane> parameters = characteristic(c);
    if (!parameters) {
        add(ContactRegion::Apart, Matrix3::Zero(), more, known);
        return;
    }
    struct Line {
        Vector3 atRest, slope;
    };
    struct Forces {
        Line contact, friction; // contact and adhesion; friction
        Vector3 atRest() const { return contact.atRest + friction.atRest; }
        Vector3 slope() const { return contact.slope + friction.slope; }
    };
    const double d = restSpacing();
    const auto forcesOf = [&](const OnoYamaneLaw& law, const Case& its, ContactRegion region) -> Forces {
        const AffineForce &pressing = law.contactLaw(region), &adhesion = law.adhesionLaw(region);
        const ContactLever::Rubbing by = ContactLever(its).rubbing(nearest_.x, nearest_.y);
        const Vector3 rubbing{0.0, by.pitchTorque, by.rollTorque};
        return {{bySeparation_ * (pressing.at(d) + adhesion.at(d)), bySeparation_ * (pressing.slope + adhesion.slope)},
                {rubbing * pressing.at(d), rubbing * pressing.slope}};
    };
    const auto* pad = dynamic_cast<const PadContact*>(scene.contact.get());
    const CharacteristicLaw* ofScene = pad ? pad->characteristic() : nullptr;
    const ContactRegion restRegion = ofScene ? ofScene->region() : ContactRegion::Apart;
    Vector3 restForce = Vector3::Zero();
    if (const auto before = characteristic(still))
        restForce = forcesOf(OnoYamaneLaw(*before), still, restRegion).atRest();

    const OnoYamaneLaw law(*parameters);
    const auto onCorners = [&](const Line& line) {
        return Force{line.atRest.cwiseProduct(scale_).head(positions_),
                     line.slope.cwiseProduct(scale_).head(positions_)};
    };
    for (std::size_t k = 0; k < contactRegions; ++k) {
        const auto name = static_cast<ContactRegion>(k);
        const Forces forces = forcesOf(law, c, name);
        Region& region =
            add(name, -forces.slope() * bySeparation_.transpose(), forces.atRest() - restForce + more, known);
        region.presses = name == ContactRegion::Pressed || name == ContactRegion::Lifting;
        region.interval = law.interval(name);
        region.contact = onCorners(forces.contact);
        region.friction = onCorners(forces.friction);
        for (const bool upper : {false, true}) {
            ContactRegion next = law.beyond(name, upper);
            const auto isEmpty = [&] { return !(law.interval(next).lower < law.interval(next).upper); };
            while (isEmpty() && law.beyond(next, upper) != next) next = law.beyond(next, upper);
            (upper ? region.above : region.below) = static_cast<std::size_t>(next);
        }
    }
    atRest_ = regionFrom(placeOf(restRegion), VectorXd::Zero(size_));
}

const FilmInPieces::Region* FilmInPieces::find(const MatrixXd& a, std::size_t count) const
{
    for (std::size_t k = 0; k < std::min(count, regions_.size()); ++k)
        if (regions_[k].a == a) return &regions_[k];
    return nullptr;
}

std::size_t FilmInPieces::regionFrom(std::size_t before, const VectorXd& y) const
{
    const double separation = separation_.row.dot(y) + separation_.constant;
    std::size_t at = before;
    for (std::size_t k = 0; k < contactRegions; ++k) {
        const Region& region = regions_[at];
        if (separation < region.interval.lower)
            at = region.below;
        else if (separation > region.interval.upper)
            at = region.above;
        else
            break;
    }
    return at;
}

Attitude FilmInPieces::attitude(const VectorXd& positions) const
{
    Vector3 q = place_;
    q.head(positions_) += positions.head(positions_).cwiseProduct(scale_.head(positions_));
    return {q[0] - 0.5 * length_ * q[1], q[1], q[2]};
}

FilmInPieces::Reading FilmInPieces::reading(const Vector3& slope, double constant) const
{
    Reading reading{Eigen::RowVectorXd::Zero(size_), constant};
    reading.row.head(positions_) = slope.cwiseProduct(scale_).head(positions_).transpose();
    return reading;
}

std::vector<double> FilmInPieces::frequencies() const
{
    constexpr double leastDamped = 0.2; // damping ratio [-]
    constexpr double ofSlider = 0.1;    // displacement, of the largest memory of the film in that mode [-]
    std::vector<double> all;
    const Region& rest = regions_[atRest_];
    for (Index k = 0; k < rest.rates.size(); ++k) {
        const Complex rate = rest.rates[k];
        const Eigen::VectorXd parts = rest.vectors.col(k).cwiseAbs();
        const Index memory = size_ - 2 * positions_;
        const double remembered = memory > 0 ? parts.tail(memory).maxCoeff() : 0.0;
        if (rate.imag() > 0.0 && -rate.real() < leastDamped * std::abs(rate) &&
            parts.head(positions_).maxCoeff() > ofSlider * remembered)
            all.push_back(rate.imag() / (2.0 * std::numbers::pi));
    }
    std::ranges::sort(all);
    return all;
}

std::pair<VectorXd, VectorXd> FilmInPieces::startOf(const Case& c) const
{
    Vector3 q{c.initial.heightOffset, c.initial.pitchOffset, c.initial.rollOffset};
    if (c.initial.state != InitialState::Static)
        q = Vector3(c.initial.nominalTrailingEdgeHeight + 0.5 * length_ * c.initial.pitch, c.initial.pitch,
                    c.initial.roll) -
            place_;
    const Vector3 v{c.initial.verticalVelocity, c.initial.pitchVelocity, c.initial.rollVelocity};
    return {q.cwiseQuotient(scale_).head(positions_), v.cwiseQuotient(scale_).head(positions_)};
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>

#include "core/physics/contact/elastic_contact.h"
#include "tests/support/allocation_count.h"
#include "tests/support/self_affine.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_elastic_contact {

class TestElasticContact : public QObject {
    Q_OBJECT

private slots:
    void fulfilsItsConditions_data();
    void fulfilsItsConditions();
    void doesNotDependOnTheStart_data() { fulfilsItsConditions_data(); }
    void doesNotDependOnTheStart();
    void hardnessOutOfReachChangesNothing();
    void hardnessEverywhere();
    void costsNothingWithoutContact();
    void followsTheLastSolution();
    void allocatesNothing();
    void threadsGiveTheSameBits();
    void refusesWhatCannotBeSolved();
    void tellsThatItDidNotConverge();
    void stopsWhenAsked();
};

constexpr double modulus = 1e11;
constexpr double side = 2e-6;

struct Rough {
    int n = 64;
    HalfSpaceEdges edges = HalfSpaceEdges::Free;
    double hardness = 0.0;
    double height = 0.0; // of the pad above the mean plane [m]

    UniformGrid grid() const { return {n, n, side / n, side / n}; }
    std::vector<double> separation() const
    {
        std::vector<double> values = test::selfAffineHeights({.n = n, .cutOff = n / 8.0, .slope = 0.02, .seed = 5});
        for (double& value : values) value = height - value * side;
        return values;
    }
    ElasticContact contact() const { return ElasticContact(HalfSpace(grid(), modulus, edges), {.hardness = hardness}); }
    ElasticContactSummary solve(ElasticContact& contact) const { return contact.solve(separation()); }
};

double range(std::span<const double> values)
{
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    return *most - *least;
}

void TestElasticContact::fulfilsItsConditions_data()
{
    QTest::addColumn<Rough>("rough");
    QTest::newRow("free") << Rough{.height = 2e-9};
    QTest::newRow("free, deep") << Rough{.height = -100e-9};
    QTest::newRow("free, hardness") << Rough{.hardness = 3e-3 * modulus, .height = 2e-9};
    QTest::newRow("periodic") << Rough{.n = 128, .edges = HalfSpaceEdges::Periodic, .height = 2e-9};
    QTest::newRow("periodic, hardness") << Rough{
        .edges = HalfSpaceEdges::Periodic, .hardness = 3e-3 * modulus, .height = 2e-9};
    QTest::newRow("periodic, overlap, hardness")
        << Rough{.edges = HalfSpaceEdges::Periodic, .hardness = 1e-2 * modulus, .height = -1e-9};
    QTest::newRow("odd grid") << Rough{.n = 45, .height = 2e-9};
}

void TestElasticContact::fulfilsItsConditions()
{
    QFETCH(Rough, rough);
    ElasticContact contact = rough.contact();
    const ElasticContactSummary summary = rough.solve(contact);
    QVERIFY2(summary.converged, summary.message.c_str());
    // Displacement and gap afresh, by another half-space.
    std::vector<double> displacement(rough.grid().cells());
    HalfSpace(rough.grid(), modulus, rough.edges).displace(contact.pressure(), displacement);
    const std::vector<double> separation = rough.separation();
    const double allowed = 1e-8 * range(displacement);
    double load = 0.0;
    bool flowed = false;
    for (std::size_t i = 0; i < separation.size(); ++i) {
        const double p = contact.pressure()[i];
        const double gap = separation[i] + displacement[i];
        QVERIFY(std::abs(gap - contact.gap()[i]) < 0.01 * allowed);
        QVERIFY(p >= 0.0);
        if (rough.hardness > 0.0) QVERIFY(p <= rough.hardness);
        const bool hard = rough.hardness > 0.0 && p == rough.hardness;
        QVERIFY(hard ? gap <= allowed : gap >= -allowed);
        if (p > 0.0 && !hard) QVERIFY(gap <= allowed);
        flowed = flowed || hard;
        load += p * rough.grid().cellArea();
    }
    QCOMPARE(flowed, rough.hardness > 0.0);
    QVERIFY(std::abs(load / summary.load - 1.0) < 1e-12);
}

void TestElasticContact::doesNotDependOnTheStart()
{
    QFETCH(Rough, rough);
    ElasticContact cold = rough.contact();
    const ElasticContactSummary expected = rough.solve(cold);
    ElasticContact warm = rough.contact();
    Rough other = rough;
    other.height += 3e-9;
    // A start from another height, on a surface shifted by a third.
    std::vector<double> shifted = other.separation();
    std::rotate(shifted.begin(), shifted.begin() + static_cast<std::ptrdiff_t>(shifted.size() / 3), shifted.end());
    QVERIFY(warm.solve(shifted).converged);
    const ElasticContactSummary summary = rough.solve(warm);
    QVERIFY2(summary.converged, summary.message.c_str());
    QVERIFY(std::abs(summary.load / expected.load - 1.0) < 1e-7);
    // The energy sets the pressures' difference: dp.A dp <= 2 sum |dp| |wrong gap|.
    const double peak = *std::max_element(cold.pressure().begin(), cold.pressure().end());
    for (std::size_t i = 0; i < cold.pressure().size(); ++i)
        QVERIFY(std::abs(cold.pressure()[i] - warm.pressure()[i]) < 1e-6 * peak);
}

void TestElasticContact::hardnessOutOfReachChangesNothing()
{
    Rough rough{.height = 2e-9};
    ElasticContact elastic = rough.contact();
    QVERIFY(rough.solve(elastic).converged);
    rough.hardness = 1.01 * *std::max_element(elastic.pressure().begin(), elastic.pressure().end());
    ElasticContact hard = rough.contact();
    QVERIFY(rough.solve(hard).converged);
    for (std::size_t i = 0; i < hard.pressure().size(); ++i)
        QVERIFY(std::abs(hard.pressure()[i] - elastic.pressure()[i]) < 1e-6 * rough.hardness);
}

void TestElasticContact::hardnessEverywhere()
{
    const Rough rough{.n = 16, .hardness = 1e-2 * modulus, .height = -1e-6};
    ElasticContact contact = rough.contact();
    const ElasticContactSummary summary = rough.solve(contact);
    QVERIFY2(summary.converged, summary.message.c_str());
    for (const double p : contact.pressure()) QCOMPARE(p, rough.hardness);
}

void TestElasticContact::costsNothingWithoutContact()
{
    Rough rough{.height = 2e-9};
    ElasticContact contact = rough.contact();
    QVERIFY(rough.solve(contact).iterations > 0);
    rough.height = 1e-6;
    const std::vector<double> apart = rough.separation();
    const ElasticContactSummary summary = contact.solve(apart);
    QVERIFY(summary.converged);
    QCOMPARE(summary.iterations, 0);
    QCOMPARE(summary.load, 0.0);
    QCOMPARE(contact.contactArea(), 0.0);
    for (std::size_t i = 0; i < apart.size(); ++i) {
        QCOMPARE(contact.pressure()[i], 0.0);
        QCOMPARE(contact.gap()[i], apart[i]);
    }
}

void TestElasticContact::followsTheLastSolution()
{
    Rough rough{.height = 2e-9};
    ElasticContact contact = rough.contact();
    QVERIFY(rough.solve(contact).iterations > 0);
    QCOMPARE(rough.solve(contact).iterations, 0); // it is the solution already
    // The second of two equal moves is foreseen from the first.
    rough.height -= 0.01e-9;
    const int first = rough.solve(contact).iterations;
    rough.height -= 0.01e-9;
    const int second = rough.solve(contact).iterations;
    QVERIFY(second > 0 && second < first);
    // A move back is not, and a jump to another solution and away from it leaves no trace.
    ElasticContact afresh = rough.contact();
    rough.solve(afresh);
    rough.height += 0.5e-9;
    rough.solve(contact);
    rough.height = 1.0;
    QCOMPARE(rough.solve(contact).iterations, 0);
    rough.height = 2e-9 - 0.02e-9;
    QVERIFY(rough.solve(contact).converged);
    for (std::size_t i = 0; i < afresh.pressure().size(); ++i) QCOMPARE(contact.pressure()[i], afresh.pressure()[i]);
}

void TestElasticContact::allocatesNothing()
{
    Rough rough{.n = 32, .height = 2e-9};
    for (const HalfSpaceEdges edges : {HalfSpaceEdges::Free, HalfSpaceEdges::Periodic}) {
        rough.edges = edges;
        ElasticContact contact = rough.contact();
        const std::vector<double> separation = rough.separation();
        std::vector<double> lower = separation;
        for (double& s : lower) s -= 1e-9;
        const long long before = test::allocations;
        QVERIFY(contact.solve(separation).converged);
        QVERIFY(contact.solve(lower).converged);
        QVERIFY(contact.solve(separation).converged);
        QCOMPARE(test::allocations.load(), before);
    }
}

void TestElasticContact::threadsGiveTheSameBits()
{
    const Rough rough{.height = 2e-9};
    std::vector<double> results[3];
    const auto compute = [&](std::vector<double>& out) {
        ElasticContact contact = rough.contact();
        rough.solve(contact);
        out.assign(contact.pressure().begin(), contact.pressure().end());
    };
    compute(results[0]);
    {
        std::thread first(compute, std::ref(results[1]));
        std::thread second(compute, std::ref(results[2]));
        first.join();
        second.join();
    }
    QVERIFY(results[0] == results[1]);
    QVERIFY(results[0] == results[2]);
}

void TestElasticContact::refusesWhatCannotBeSolved()
{
    Rough rough{.n = 16, .height = 2e-9};
    for (const HalfSpaceEdges edges : {HalfSpaceEdges::Free, HalfSpaceEdges::Periodic}) {
        rough.edges = edges;
        ElasticContact contact = rough.contact();
        const auto isRefused = [&](const ElasticContactSummary& summary, const char* words) {
            for (std::size_t i = 0; i < contact.pressure().size(); ++i)
                if (contact.pressure()[i] != 0.0 || !std::isfinite(contact.gap()[i])) return false;
            return !summary.converged && QString::fromStdString(summary.message).contains(words);
        };
        constexpr double infinity = std::numeric_limits<double>::infinity();
        for (const double bad : {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity}) {
            std::vector<double> separation = rough.separation();
            separation[77] = bad;
            QVERIFY(isRefused(contact.solve(separation), "not a finite number"));
        }
        QVERIFY(isRefused(contact.solve(std::vector<double>(256, -1e300)),
                          edges == HalfSpaceEdges::Free ? "too large" : "give a greater separation"));
        // A refusal leaves nothing behind.
        QVERIFY(contact.solve(rough.separation()).converged);
    }
}

void TestElasticContact::tellsThatItDidNotConverge()
{
    const Rough rough{.height = 2e-9};
    ElasticContact contact(HalfSpace(rough.grid(), modulus), {.tolerance = 1e-8, .maximumIterations = 3});
    const ElasticContactSummary summary = rough.solve(contact);
    QVERIFY(!summary.converged);
    QVERIFY(summary.iterations <= 4);
    QVERIFY(summary.error > 1e-8);
    QVERIFY(QString::fromStdString(summary.message).contains("did not converge"));
    for (const double p : contact.pressure()) QVERIFY(std::isfinite(p) && p >= 0.0);
}

void TestElasticContact::stopsWhenAsked()
{
    const Rough rough{.height = 2e-9};
    int left = 3;
    ElasticContact contact(HalfSpace(rough.grid(), modulus), {.goOn = [&left] { return left-- > 0; }});
    const ElasticContactSummary summary = rough.solve(contact);
    QVERIFY(!summary.converged);
    QVERIFY(summary.iterations < 10); // coarser grids ask, too
    QVERIFY(QString::fromStdString(summary.message).contains("stopped"));
    for (const double p : contact.pressure()) QVERIFY(std::isfinite(p) && p >= 0.0);
    left = 2000;
    QVERIFY(rough.solve(contact).converged); // and goes on from there
}

TOUCHDOWN_TEST(TestElasticContact)

} // namespace test_elastic_contact

#include "test_elastic_contact.moc"

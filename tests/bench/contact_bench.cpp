// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/contact_bench.h"

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include "core/physics/contact/elastic_contact.h"
#include "tests/support/self_affine.h"

namespace touchdown {
namespace {

double processorSeconds()
{
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double leastSeconds(int repeats, const std::function<void()>& work)
{
    double least = INFINITY;
    for (int i = 0; i < repeats; ++i) {
        const double start = processorSeconds();
        work();
        least = std::min(least, processorSeconds() - start);
    }
    return least;
}

// There and back.
double transformSeconds(int n, int repeats)
{
    std::vector<double> field(static_cast<std::size_t>(n) * static_cast<std::size_t>(n), 1.0);
    fftw_complex* modes = fftw_alloc_complex(static_cast<std::size_t>(n) * static_cast<std::size_t>(n / 2 + 1));
    const fftw_plan forward = fftw_plan_dft_r2c_2d(n, n, field.data(), modes, FFTW_ESTIMATE);
    const fftw_plan inverse = fftw_plan_dft_c2r_2d(n, n, modes, field.data(), FFTW_ESTIMATE);
    const double seconds = leastSeconds(10 * repeats, [&] {
        fftw_execute(forward);
        fftw_execute(inverse);
        std::fill(field.begin(), field.end(), 1.0);
    });
    fftw_destroy_plan(forward);
    fftw_destroy_plan(inverse);
    fftw_free(modes);
    return seconds;
}

void tell(const char* problem, int n, HalfSpaceEdges edges, double seconds, double iterations,
          const ElasticContactSummary& summary, ElasticContact& contact, double transform)
{
    const UniformGrid& grid = contact.space().grid();
    std::printf("%s,%d,%s,%.3f,%.1f,%.2g,%.2f,%.3f,%.3f,%.2f,%s\n", problem, n,
                edges == HalfSpaceEdges::Free ? "free" : "periodic", seconds * 1e3, iterations, summary.error,
                100.0 * contact.contactArea() / (static_cast<double>(grid.cells()) * grid.cellArea()),
                seconds / iterations * 1e3, transform * 1e3, seconds / iterations / transform,
                summary.converged ? "converged" : summary.message.c_str());
    std::fflush(stdout);
}

// Hurst 0.8, roll-off at 4 cycles, cut-off at n/8, RMS slope 1, under a smooth pad at its RMS height.
void benchmarkFromNothing(int n, HalfSpaceEdges edges, int repeats)
{
    std::vector<double> separation = test::selfAffineHeights({.n = n, .cutOff = n / 8.0});
    double squares = 0.0;
    for (const double s : separation) squares += s * s;
    const double height = std::sqrt(squares / static_cast<double>(separation.size()));
    for (double& s : separation) s = height - s;
    ElasticContact contact(HalfSpace({n, n, 1.0 / n, 1.0 / n}, 1.0, edges), {.tolerance = 1e-6});
    ElasticContactSummary summary;
    const double seconds = leastSeconds(repeats, [&] {
        contact.reset();
        summary = contact.solve(separation);
    });
    tell("from nothing", n, edges, seconds, summary.iterations, summary, contact, transformSeconds(n, repeats));
}

// The same kind of surface, 0.5 nm RMS on a patch of 2.56 um, under a smooth pad at a height above its mean plane.
void benchmarkSteps(double height, double tolerance, int repeats)
{
    constexpr int n = 128;
    constexpr double rms = 0.5e-9, move = 0.01e-9;
    constexpr int steps = 20;
    std::vector<double> heights = test::selfAffineHeights({.n = n, .cutOff = n / 8.0});
    double squares = 0.0;
    for (const double h : heights) squares += h * h;
    for (double& h : heights) h *= rms / std::sqrt(squares / (n * n));
    ElasticContact contact(HalfSpace({n, n, 20e-9, 20e-9}, 1e11), {.tolerance = tolerance});
    std::vector<double> separation(heights.size());
    const auto solveAt = [&](double z) {
        for (std::size_t i = 0; i < heights.size(); ++i) separation[i] = z - heights[i];
        return contact.solve(separation);
    };
    ElasticContactSummary summary;
    double total = INFINITY;
    int iterations = 0;
    for (int r = 0; r < repeats; ++r) {
        contact.reset();
        solveAt(height);
        iterations = 0;
        double seconds = 0.0;
        for (int k = 1; k <= steps; ++k) {
            const double start = processorSeconds();
            summary = solveAt(height - k * move);
            seconds += processorSeconds() - start;
            iterations += summary.iterations;
        }
        total = std::min(total, seconds);
    }
    char name[64];
    std::snprintf(name, sizeof name, "step from %.1f nm to %.0e", height * 1e9, tolerance);
    tell(name, n, HalfSpaceEdges::Free, total / steps, static_cast<double>(iterations) / steps, summary, contact,
         transformSeconds(n, repeats));
}

} // namespace

int benchmarkContact(int repeats)
{
    std::printf("problem,cells along a side,edges,time [ms],iterations,error [-],cells in contact [%%],time of an "
                "iteration [ms],FFT there and back [ms],"
                "iteration/FFT [-],status\n");
    for (const HalfSpaceEdges edges : {HalfSpaceEdges::Periodic, HalfSpaceEdges::Free})
        for (const int n : {128, 256, 512}) benchmarkFromNothing(n, edges, repeats);
    for (const double tolerance : {1e-6, 1e-8})
        for (const double height : {1.5e-9, 1.0e-9, 0.5e-9, 0.0}) benchmarkSteps(height, tolerance, repeats);
    return 0;
}

} // namespace touchdown

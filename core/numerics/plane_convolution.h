// SPDX-License-Identifier: GPL-3.0-or-later
//
// Convolution of a real field with a real kernel that is even along x and along y, by FFT. The field of nx x ny values,
// row by row, is part of a domain of mx x my values that repeats in both directions. The rest of the domain is zero.
// With m >= 2 n - 1 the repetition has no effect (zero-padding: exact).
#pragma once

#include <memory>
#include <span>

namespace touchdown {

/// A size m >= 2 n - 1 that FFTW transforms fast: up to 64 one that it has code for (18 takes twice as long as 20);
/// then the smallest multiple of 8 without prime factors above 7 or, up to 256, a power of two less than a third
/// longer.
int paddedSize(int n);

/// Keeps FFTW's plans and working memory. One thread at a time for each object.
class PlaneConvolution {
public:
    /// 1 <= nx <= mx, 1 <= ny <= my.
    PlaneConvolution(int nx, int ny, int mx, int my);
    ~PlaneConvolution();
    PlaneConvolution(PlaneConvolution&&) noexcept;
    PlaneConvolution& operator=(PlaneConvolution&&) noexcept;

    /// Sets the kernel by its transform, real and even: mx/2 + 1 wave numbers along x for each of my/2 + 1 along y.
    void setTransform(std::span<const double> transform);
    /// out = kernel * in, each nx ny long; may be the same array. Allocates nothing.
    void apply(std::span<const double> in, std::span<double> out);

    /// Transform for setTransform() of an even kernel given at the distances 0..mx/2, 0..my/2; mx and my even.
    static void transformKernel(std::span<double> kernel, int mx, int my);

private:
    struct Plans;
    std::unique_ptr<Plans> plans_;
};

} // namespace touchdown

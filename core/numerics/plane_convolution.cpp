// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numerics/plane_convolution.h"

#include <fftw3.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <new>
#include <utility>
#include <vector>

#include "core/numerics/fourier.h"
#include "core/numerics/vector_clones.h"

namespace touchdown {
namespace {

// Columns are transformed in blocks that stay in the cache. A block is 64 bytes wide, so that all its rows and those of
// the field's transform have the same alignment, as one FFTW plan requires.
constexpr int block = 4;

// w_k *= kernel_k for the block's rows k and my - k, to which the even kernel gives the same values.
TOUCHDOWN_VECTOR_CLONES void multiply(int my, const double* kernel, double* w)
{
    for (int k = 0; k < my; ++k) {
        const double* factor = kernel + static_cast<std::size_t>(std::min(k, my - k)) * block;
        double* value = w + static_cast<std::size_t>(k) * 2 * block;
        for (int c = 0; c < block; ++c) {
            value[2 * c] *= factor[c];
            value[2 * c + 1] *= factor[c];
        }
    }
}

} // namespace

int paddedSize(int n)
{
    const int least = 2 * n - 1;
    for (const int m : {2, 4, 6, 8, 10, 12, 14, 16, 20, 32, 64})
        if (m >= least) return m;
    constexpr int step = 8, longest = 256;
    const int power = static_cast<int>(std::bit_ceil(static_cast<unsigned>(least)));
    for (int m = (least + step - 1) / step * step;; m += step) {
        int rest = m;
        for (const int factor : {2, 3, 5, 7})
            while (rest % factor == 0) rest /= factor;
        if (rest == 1) return power <= longest && 3 * power < 4 * m ? power : m;
    }
}

/// Rows are transformed as real numbers, columns as complex ones. x is along the longer side of the domain here: a
/// patch of 10 x 180 cells takes a third of the time so.
struct PlaneConvolution::Plans {
    bool turned;
    int nx, ny, mx, my;
    std::size_t stride;         // of the rows of `lines`: mx/2 + 1, rounded up to whole blocks
    std::vector<double> kernel; // block after block
    double* row = nullptr;      // of the domain
    // Complex values, each as two numbers:
    double* lines = nullptr; // the ny rows' transforms along x
    double* columns = nullptr;
    fftw_plan rowForward = nullptr, rowInverse = nullptr, columnsForward = nullptr, columnsInverse = nullptr;

    Plans(int fieldX, int fieldY, int domainX, int domainY) : turned(domainY > domainX), mx(domainX), my(domainY)
    {
        nx = turned ? fieldY : fieldX;
        ny = turned ? fieldX : fieldY;
        if (turned) std::swap(mx, my);
        assert(nx >= 1 && nx <= mx && ny >= 1 && ny <= my);
        stride = static_cast<std::size_t>((mx / 2 + block) / block * block);
        kernel.assign(stride * static_cast<std::size_t>(my / 2 + 1), 0.0);
        const std::size_t lineValues = stride * static_cast<std::size_t>(ny);
        const std::lock_guard lock(fourierPlanner());
        row = fftw_alloc_real(static_cast<std::size_t>(mx) + 1);
        lines = fftw_alloc_real(2 * lineValues);
        columns = fftw_alloc_real(2 * static_cast<std::size_t>(my) * block);
        if (row && lines && columns) {
            std::fill_n(row, mx + 1, 0.0);
            std::fill_n(lines, 2 * lineValues, 0.0);
            // Estimated, not measured: a measured plan, and with it the last digits, would differ from run to run.
            rowForward = fftw_plan_dft_r2c_1d(mx, row, complex(lines), FFTW_ESTIMATE);
            rowInverse = fftw_plan_dft_c2r_1d(mx, complex(lines), row, FFTW_ESTIMATE);
            columnsForward = columnPlan(FFTW_FORWARD);
            columnsInverse = columnPlan(FFTW_BACKWARD);
        }
        if (!rowForward || !rowInverse || !columnsForward || !columnsInverse) {
            release();
            throw std::bad_alloc();
        }
    }
    ~Plans()
    {
        const std::lock_guard lock(fourierPlanner());
        release();
    }
    Plans(const Plans&) = delete;
    Plans& operator=(const Plans&) = delete;

    fftw_plan columnPlan(int direction) const
    {
        return fftw_plan_many_dft(1, &my, block, complex(columns), nullptr, block, 1, complex(columns), nullptr, block,
                                  1, direction, FFTW_ESTIMATE);
    }
    void release()
    {
        for (fftw_plan plan : {rowForward, rowInverse, columnsForward, columnsInverse})
            if (plan) fftw_destroy_plan(plan);
        fftw_free(row);
        fftw_free(lines);
        fftw_free(columns);
    }
    static fftw_complex* complex(double* values) { return reinterpret_cast<fftw_complex*>(values); }
    double* line(int j) const { return lines + 2 * static_cast<std::size_t>(j) * stride; }
    void convolveColumns(std::size_t first);
    void readRow(int j, const double* field)
    {
        if (turned)
            for (int i = 0; i < nx; ++i) row[i] = field[i * std::ptrdiff_t{ny} + j];
        else
            std::copy_n(field + j * std::ptrdiff_t{nx}, nx, row);
    }
    void writeRow(int j, double* field) const
    {
        if (turned)
            for (int i = 0; i < nx; ++i) field[i * std::ptrdiff_t{ny} + j] = row[i];
        else
            std::copy_n(row, nx, field + j * std::ptrdiff_t{nx});
    }
};

void PlaneConvolution::Plans::convolveColumns(std::size_t first)
{
    constexpr std::ptrdiff_t width = 2 * block;
    for (int j = 0; j < ny; ++j) std::copy_n(line(j) + 2 * first, width, columns + j * width);
    std::fill(columns + ny * width, columns + my * width, 0.0);
    fftw_execute(columnsForward);
    multiply(my, kernel.data() + first * static_cast<std::size_t>(my / 2 + 1), columns);
    fftw_execute(columnsInverse);
    for (int j = 0; j < ny; ++j) std::copy_n(columns + j * width, width, line(j) + 2 * first);
}

PlaneConvolution::PlaneConvolution(int nx, int ny, int mx, int my) : plans_(std::make_unique<Plans>(nx, ny, mx, my)) {}
PlaneConvolution::~PlaneConvolution() = default;
PlaneConvolution::PlaneConvolution(PlaneConvolution&&) noexcept = default;
PlaneConvolution& PlaneConvolution::operator=(PlaneConvolution&&) noexcept = default;

void PlaneConvolution::setTransform(std::span<const double> transform)
{
    Plans& p = *plans_;
    const auto width = static_cast<std::size_t>(p.mx / 2 + 1);
    const auto height = static_cast<std::size_t>(p.my / 2 + 1);
    assert(transform.size() == width * height);
    const double scale =
        1.0 / (static_cast<double>(p.mx) * p.my); // FFTW's inverse of its transform is m_x m_y times too large
    for (std::size_t k = 0; k < height; ++k)
        for (std::size_t i = 0; i < width; ++i)
            p.kernel[((i / block) * height + k) * block + i % block] =
                scale * transform[p.turned ? i * height + k : k * width + i];
}

void PlaneConvolution::apply(std::span<const double> in, std::span<double> out)
{
    Plans& p = *plans_;
    assert(in.size() == static_cast<std::size_t>(p.nx) * static_cast<std::size_t>(p.ny) && out.size() == in.size());
    for (int j = 0; j < p.ny; ++j) {
        p.readRow(j, in.data());
        std::fill(p.row + p.nx, p.row + p.mx, 0.0);
        fftw_execute_dft_r2c(p.rowForward, p.row, Plans::complex(p.line(j)));
    }
    for (std::size_t first = 0; first < p.stride; first += block) p.convolveColumns(first);
    for (int j = 0; j < p.ny; ++j) {
        fftw_execute_dft_c2r(p.rowInverse, Plans::complex(p.line(j)), p.row);
        p.writeRow(j, out.data());
    }
}

void PlaneConvolution::transformKernel(std::span<double> kernel, int mx, int my)
{
    assert(mx % 2 == 0 && my % 2 == 0 && mx > 0 && my > 0);
    assert(kernel.size() == static_cast<std::size_t>(mx / 2 + 1) * static_cast<std::size_t>(my / 2 + 1));
    fftw_plan plan = nullptr;
    {
        // An even periodic kernel's transform is the cosine transform of its quarter.
        const std::lock_guard lock(fourierPlanner());
        plan = fftw_plan_r2r_2d(my / 2 + 1, mx / 2 + 1, kernel.data(), kernel.data(), FFTW_REDFT00, FFTW_REDFT00,
                                FFTW_ESTIMATE);
    }
    if (!plan) throw std::bad_alloc();
    fftw_execute(plan);
    const std::lock_guard lock(fourierPlanner());
    fftw_destroy_plan(plan);
}

} // namespace touchdown

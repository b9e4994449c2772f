// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <span>

#include <QTest>

#include "core/physics/film/gas_film.h"
#include "tests/support/film_problem.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_gas_film_derivatives {

constexpr double L = 0.9e-3, W = 0.7e-3;

/// A taper, a crown, two walled rails of which one has an oblique edge, a plain step: every kind of face.
AirBearingSurface surface()
{
    AirBearingSurface result;
    result.baseRecess = 1.2e-6;
    result.crown = 15e-9;
    result.camber = -4e-9;
    result.taperLength = 0.1e-3;
    result.taperAngle = 1e-3;
    result.walls = {{.distance = {0.0, 20e-6}, .recess = {0.0, 1.2e-6}}};
    result.rails = {
        {.points = {{0.05e-3, 0.08e-3, 1}, {0.62e-3, 0.11e-3, 1}, {0.58e-3, 0.31e-3, 1}, {0.05e-3, 0.27e-3, 1}},
         .recess = {0.0}},
        {.points = {{0.0, 0.4e-3}, {0.33e-3, 0.4e-3}, {0.33e-3, 0.7e-3}, {0.0, 0.7e-3}}, .recess = {150e-9}},
        {.points = {{0.66e-3, 0.3e-3}, {0.87e-3, 0.3e-3}, {0.87e-3, 0.52e-3}, {0.66e-3, 0.52e-3}}, .recess = {0.0}}};
    return result;
}

CellGrid cells()
{
    CellGrid result;
    for (int i = 0; i <= 13; ++i) result.x.push_back(L * (i + 0.25 * std::sin(2.1 * i) * (i > 0 && i < 13)) / 13);
    for (int j = 0; j <= 10; ++j) result.y.push_back(W * (j + 0.25 * std::sin(1.3 * j) * (j > 0 && j < 10)) / 10);
    return result;
}

constexpr Attitude attitude{20e-9, 150e-6, 8e-6};

/// Pressures from 0.6 to 3.4 p0 in the cells, with differences between neighbours of all sizes.
std::vector<double> roughPressure(const PaddedGrid& pad, double ambient)
{
    std::mt19937 random(12);
    std::uniform_real_distribution<double> uniform(-0.4, 0.4);
    std::vector<double> p(pad.size(), ambient);
    for (int j = 0; j < pad.ny; ++j)
        for (int i = 0; i < pad.nx; ++i)
            p[pad.at(i, j)] =
                ambient *
                (1.0 + 2.0 * std::sin(3.1 * (i + 0.5) / pad.nx) * std::sin(3.1 * (j + 0.5) / pad.ny) + uniform(random));
    return p;
}

std::vector<double> randomCells(const PaddedGrid& pad, unsigned seed)
{
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::vector<double> v(pad.size(), 0.0);
    for (int j = 0; j < pad.ny; ++j)
        for (int i = 0; i < pad.nx; ++i) v[pad.at(i, j)] = normal(random);
    return v;
}

double inner(const std::vector<double>& a, const std::vector<double>& b)
{
    double sum = 0.0;
    for (std::size_t at = 0; at < a.size(); ++at) sum += a[at] * b[at];
    return sum;
}
double norm(const std::vector<double>& a) { return std::sqrt(inner(a, a)); }

/// out += scale times the operator of nine points on v.
void addPoints(const PaddedGrid& pad, const NinePoints& points, double scale, const std::vector<double>& v,
               std::vector<double>& out)
{
    for (int j = 0; j < pad.ny; ++j)
        for (int i = 0; i < pad.nx; ++i) {
            const std::size_t at = pad.at(i, j);
            double sum = points.sum[at] * v[at];
            for (int k = 0; k < 8; ++k) {
                const int place = k < 4 ? k : k + 1;
                sum += points.beside[static_cast<std::size_t>(k)][at] *
                       (v[pad.at(i + place % 3 - 1, j + place / 3 - 1)] - v[at]);
            }
            out[at] += scale * sum;
        }
}

/// Over a disk whose heights differ from cell to cell by up to this [m].
struct OverDisk : FilmProblem {
    std::vector<double> disk;

    OverDisk(const FilmSetting& setting, double waves) : FilmProblem(surface(), L, W, cells(), setting, attitude)
    {
        if (waves == 0.0) return;
        for (std::size_t at = 0; at < p.size(); ++at)
            disk.push_back(waves * std::sin(1.9 * static_cast<double>(at * at % 97)));
        film.setSurface(disk);
        film.setAttitude(attitude);
    }
};

/// All schemes with the slider's own slip model, all slip models with the default scheme, and air flowing every way.
void addSettings()
{
    QTest::addColumn<FilmSetting>("setting");
    QTest::addColumn<double>("waves");
    FilmSetting setting;
    setting.disk = {.speed = 600.0, .radius = 22e-3, .skew = 0.2};
    using enum ConvectionScheme;
    for (const auto& [name, scheme] : {std::pair{"upwind", Upwind},
                                       {"hybrid", Hybrid},
                                       {"power law", PowerLaw},
                                       {"exponential", Exponential},
                                       {"complete flux", CompleteFlux}}) {
        setting.scheme = scheme;
        QTest::addRow("%s", name) << setting << 0.0;
        setting.disk.skew = -2.5; // backwards along x
        QTest::addRow("%s, backwards", name) << setting << 0.0;
        setting.disk.skew = 0.2;
    }
    for (std::size_t model = 0; model < slipLaws().size(); ++model) {
        setting.slip = {.model = static_cast<SlipModel>(model), .switchGap = 40e-9, .blendWidth = 30e-9};
        QTest::addRow("complete flux, %s", slipLaws()[model].name.data()) << setting << 0.0;
    }
    setting.slip = {};
    setting.scheme = Exponential;
    QTest::newRow("exponential, wavy disk") << setting << 3e-9;
    setting.scheme = CompleteFlux;
    QTest::newRow("complete flux, wavy disk") << setting << 3e-9;
    setting.disk.speed = 0.0;
    QTest::newRow("disk at rest") << setting << 0.0;
}

/// Cells that store at this rate, nothing at p: by how much a face passes on more or less of it is left out of the
/// derivatives.
void store(FilmProblem& problem, std::vector<double>& history, double perTime)
{
    history.resize(problem.p.size());
    for (std::size_t at = 0; at < history.size(); ++at)
        history[at] = perTime * problem.film.volumes()[at] * problem.p[at];
    problem.film.setStorage(perTime, history);
}
constexpr double storing = 3e6; // [1/s]

class TestGasFilmDerivatives : public QObject {
    Q_OBJECT

private slots:
    /// dR/dp, column by column, against central differences of fourth order with a step of 1e-4 p: their error is the
    /// fifth derivative's 1e-16/30 and a rounding of 1e-16/1e-4 of the flows.
    void jacobian_data() { addSettings(); }
    void jacobian()
    {
        for (const double perTime : {0.0, storing}) jacobianWith(perTime);
    }
    void jacobianWith(double perTime)
    {
        QFETCH(FilmSetting, setting);
        QFETCH(double, waves);
        OverDisk problem(setting, waves);
        const PaddedGrid& pad = problem.gaps.pad;
        problem.p = roughPressure(pad, problem.film.ambient());
        std::vector<double> out(pad.size()), v(pad.size(), 0.0), image(pad.size()), p = problem.p, history;
        store(problem, history, perTime);
        FaceFlows<double> work;
        work.resize(pad.size());
        problem.film.linearise(problem.p, out);
        // As differences move the state of the film, all columns are taken first.
        std::vector<std::vector<double>> columns;
        for (int j = 0; j < pad.ny; ++j)
            for (int i = 0; i < pad.nx; ++i) {
                v[pad.at(i, j)] = 1.0;
                problem.film.applyJacobian<double>(v, image, work);
                v[pad.at(i, j)] = 0.0;
                columns.push_back(image);
            }
        std::vector<double> r1(pad.size()), r2 = r1, r3 = r1, r4 = r1;
        double worst = 0.0;
        for (int j = 0; j < pad.ny; ++j)
            for (int i = 0; i < pad.nx; ++i) {
                const std::size_t at = pad.at(i, j);
                const double step = 1e-4 * problem.p[at];
                const auto residual = [&](double offset, std::vector<double>& r) {
                    p[at] = problem.p[at] + offset * step;
                    problem.film.residual(p, r);
                };
                residual(-2.0, r1);
                residual(-1.0, r2);
                residual(1.0, r3);
                residual(2.0, r4);
                p[at] = problem.p[at];
                const std::vector<double>& column = columns[static_cast<std::size_t>(j * pad.nx + i)];
                double difference = 0.0;
                for (int n = 0; n < pad.ny; ++n)
                    for (int m = 0; m < pad.nx; ++m) {
                        const std::size_t row = pad.at(m, n);
                        const double slope = (8.0 * (r3[row] - r2[row]) - (r4[row] - r1[row])) / (12.0 * step);
                        difference = std::max(difference, std::abs(slope - column[row]));
                    }
                worst = std::max(worst, difference / std::abs(column[at]));
            }
        QVERIFY2(worst < 1e-6, qPrintable(QString::number(worst)));
    }

    /// linearise gives the residual too.
    void residualOfBoth_data() { addSettings(); }
    void residualOfBoth()
    {
        QFETCH(FilmSetting, setting);
        QFETCH(double, waves);
        OverDisk problem(setting, waves);
        const std::size_t size = problem.gaps.pad.size();
        problem.p = roughPressure(problem.gaps.pad, problem.film.ambient());
        std::vector<double> a(size), b(size);
        problem.film.residual(problem.p, a);
        problem.film.linearise(problem.p, b);
        for (std::size_t at = 0; at < size; ++at) QVERIFY(std::abs(a[at] - b[at]) < 1e-13 * norm(a));
    }

    /// u (J v) = v (J^T u), and the complex map is the real one on both parts.
    void transposeAndComplex_data() { addSettings(); }
    void transposeAndComplex()
    {
        QFETCH(FilmSetting, setting);
        QFETCH(double, waves);
        OverDisk problem(setting, waves);
        const PaddedGrid& pad = problem.gaps.pad;
        problem.p = roughPressure(pad, problem.film.ambient());
        const std::vector<double> u = randomCells(pad, 3), v = randomCells(pad, 4);
        std::vector<double> history;
        store(problem, history, storing);
        std::vector<double> residual(pad.size()), Ju(pad.size(), 0.0), Jv(pad.size(), 0.0), JTu(pad.size());
        FaceFlows<double> work;
        work.resize(pad.size());
        problem.film.linearise(problem.p, residual);
        problem.film.applyJacobian<double>(v, Jv, work);
        problem.film.applyJacobian<double>(u, Ju, work);
        problem.film.applyTransposedJacobian(u, JTu, work);
        QVERIFY(std::abs(inner(u, Jv) - inner(v, JTu)) < 1e-13 * norm(u) * norm(Jv));
        QCOMPARE(JTu[pad.at(-1, 3)], 0.0);

        using Complex = std::complex<double>;
        std::vector<Complex> both(pad.size()), image(pad.size());
        FaceFlows<Complex> complexWork;
        complexWork.resize(pad.size());
        for (std::size_t at = 0; at < both.size(); ++at) both[at] = Complex(u[at], v[at]);
        problem.film.applyJacobian<Complex>(both, image, complexWork);
        for (std::size_t at = 0; at < both.size(); ++at)
            QVERIFY(std::abs(image[at] - Complex(Ju[at], Jv[at])) < 1e-13 * norm(Jv));
    }

    /// The nine numbers a cell say the same, also when cells store at another rate: rounded by up to 2^-24 each, with
    /// random v. Those for multigrid leave the spreading of the storage out.
    void stencil_data() { addSettings(); }
    void stencil()
    {
        QFETCH(FilmSetting, setting);
        QFETCH(double, waves);
        OverDisk problem(setting, waves);
        const PaddedGrid& pad = problem.gaps.pad;
        problem.p = roughPressure(pad, problem.film.ambient());
        std::vector<double> residual(pad.size()), history(pad.size(), 0.0), Jv(pad.size(), 0.0), image(pad.size(), 0.0);
        FaceFlows<double> work;
        work.resize(pad.size());
        problem.film.setStorage(3e6, history);
        problem.film.linearise(problem.p, residual);
        FilmStencil stencil(pad);
        problem.film.setStencil(stencil);
        const std::vector<double> v = randomCells(pad, 5);
        for (const double rate : {0.0, 3e6, 2e7}) {
            problem.film.setStorage(rate, history);
            problem.film.applyJacobian<double>(v, Jv, work);
            stencil.apply(v, rate, problem.film.volumes(), image);
            for (std::size_t at = 0; at < image.size(); ++at) image[at] -= Jv[at];
            QVERIFY2(norm(image) < 1e-7 * norm(Jv), qPrintable(QString::number(norm(image) / norm(Jv))));
            FilmStencil even = stencil;
            even.spread = nullptr;
            std::vector<double> applied(pad.size(), 0.0);
            even.apply(v, rate, problem.film.volumes(), applied);
            stencil.setStorage(problem.film.volumes());
            std::vector<double> points(pad.size(), 0.0);
            addPoints(pad, stencil.points(), 1.0, v, points);
            addPoints(pad, stencil.storagePoints(), rate, v, points);
            for (std::size_t at = 0; at < points.size(); ++at) points[at] -= applied[at];
            QVERIFY2(norm(points) < 1e-6 * norm(Jv), qPrintable(QString::number(norm(points) / norm(Jv))));
        }
    }

    /// dR/dheight, dR/dpitch, dR/droll against central differences of fourth order; steps that move the gap by at most
    /// 0.05 nm, of 20 nm and more.
    void attitudeColumns_data() { addSettings(); }
    void attitudeColumns()
    {
        // So slow that a step of the attitude does not reverse a flow: the limiter is far from linear there.
        for (const double perTime : {0.0, 1e-3 * storing}) attitudeColumnsWith(perTime);
    }
    void attitudeColumnsWith(double perTime)
    {
        QFETCH(FilmSetting, setting);
        QFETCH(double, waves);
        OverDisk problem(setting, waves);
        const PaddedGrid& pad = problem.gaps.pad;
        problem.p = roughPressure(pad, problem.film.ambient());
        std::vector<double> history;
        store(problem, history, perTime);
        std::vector<double> out(pad.size());
        std::array<std::vector<double>, 3> columns;
        problem.film.linearise(problem.p, out);
        problem.film.attitudeColumns(problem.p, columns, problem.attitudeWork);
        const std::array<double, 3> steps{0.05e-9, 0.05e-9 / L, 0.05e-9 / W};
        for (std::size_t k = 0; k < 3; ++k) {
            std::vector<double> slope(pad.size(), 0.0), r(pad.size());
            for (const auto& [offset, weight] : {std::pair{-2, 1.0}, {-1, -8.0}, {1, 8.0}, {2, -1.0}}) {
                const double shift = offset * steps[k];
                problem.film.setAttitude({attitude.height + (k == 0 ? shift : 0.0),
                                          attitude.pitch + (k == 1 ? shift : 0.0),
                                          attitude.roll + (k == 2 ? shift : 0.0)});
                problem.film.residual(problem.p, r);
                for (std::size_t at = 0; at < r.size(); ++at) slope[at] += weight * r[at] / (12.0 * steps[k]);
            }
            double largest = 0.0, difference = 0.0;
            for (int j = 0; j < pad.ny; ++j)
                for (int i = 0; i < pad.nx; ++i) {
                    const std::size_t at = pad.at(i, j);
                    largest = std::max(largest, std::abs(columns[k][at]));
                    difference = std::max(difference, std::abs(columns[k][at] - slope[at]));
                }
            QVERIFY2(difference < 1e-6 * largest, qPrintable(QString("%1: %2").arg(k).arg(difference / largest)));
        }
    }

    /// The columns grow with the rate of storing by the storage columns, exactly, where nothing is stored at p.
    void attitudeStorageColumns_data() { addSettings(); }
    void attitudeStorageColumns()
    {
        QFETCH(FilmSetting, setting);
        QFETCH(double, waves);
        OverDisk problem(setting, waves);
        problem.p = roughPressure(problem.gaps.pad, problem.film.ambient());
        std::vector<double> history, out = problem.p;
        std::array<std::vector<double>, 3> still, all, byRate;
        problem.film.linearise(problem.p, out);
        problem.film.attitudeColumns(problem.p, still, problem.attitudeWork);
        problem.film.attitudeStorageColumns(problem.p, byRate, problem.attitudeWork);
        store(problem, history, storing);
        problem.film.attitudeColumns(problem.p, all, problem.attitudeWork);
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t at = 0; at < out.size(); ++at)
                out[at] = all[k][at] - still[k][at] - storing * byRate[k][at];
            QVERIFY(norm(out) < 1e-13 * norm(all[k]));
        }
    }

    /// What leaves one cell enters the next: changing a pressure that no face of the outline feels (two cells away and
    /// more, as the complete flux scheme looks that far) changes the sum of the residuals by its own storage alone. So
    /// J^T 1 = V times the rate there.
    void whatLeavesOneCellEntersTheNext_data() { addSettings(); }
    void whatLeavesOneCellEntersTheNext()
    {
        QFETCH(FilmSetting, setting);
        QFETCH(double, waves);
        OverDisk problem(setting, waves);
        const PaddedGrid& pad = problem.gaps.pad;
        problem.p = roughPressure(pad, problem.film.ambient());
        std::vector<double> out(pad.size()), ones(pad.size(), 0.0), sums(pad.size());
        FaceFlows<double> work;
        work.resize(pad.size());
        problem.film.linearise(problem.p, out);
        for (int j = 0; j < pad.ny; ++j)
            for (int i = 0; i < pad.nx; ++i) ones[pad.at(i, j)] = 1.0;
        std::vector<double> history;
        for (const double rate : {0.0, storing}) {
            store(problem, history, rate);
            problem.film.applyTransposedJacobian(ones, sums, work);
            const double size = norm(sums);
            for (std::size_t at = 0; at < sums.size(); ++at) sums[at] -= rate * problem.film.volumes()[at];
            for (int j = 2; j < pad.ny - 2; ++j)
                for (int i = 2; i < pad.nx - 2; ++i) QVERIFY(std::abs(sums[pad.at(i, j)]) < 1e-13 * size);
            QVERIFY(std::abs(sums[pad.at(0, 4)]) > 1e-3 * size);
        }
    }
};

TOUCHDOWN_TEST(TestGasFilmDerivatives)

} // namespace test_gas_film_derivatives

#include "test_gas_film_derivatives.moc"

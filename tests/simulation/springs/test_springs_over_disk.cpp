// SPDX-License-Identifier: GPL-3.0-or-later
//
// Springs over a disk that is not flat: against SciPy, exact answers, and the law of grazing.
#include "core/simulation/springs/springs_over_disk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <Eigen/LU>

#include "core/case/integrator_kind.h"
#include "core/case/parameters.h"
#include "core/case_files/case_settings.h"
#include "core/numerics/cvode.h"
#include "core/simulation/run.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_springs_over_disk {

using std::numbers::pi;
using Complex = std::complex<double>;

struct Record {
    Summary summary;
    std::vector<double> time;
    std::map<std::string, std::vector<double>> of;
    double figure(const char* name) const
    {
        for (const RunFigure& figure : summary.figures)
            if (figure.quantity.name == name) return figure.value;
        return std::nan("");
    }
};

Record recorded(const Case& c, const RunOptions& options = {})
{
    Record record;
    const std::vector<Quantity> quantities = recordedQuantities(c);
    record.summary = run(
        c,
        [&](const RunUpdate& update) {
            const auto append = [](std::vector<double>& to, const std::vector<double>& from) {
                to.insert(to.end(), from.begin(), from.end());
            };
            append(record.time, update.samples.time);
            for (std::size_t i = 0; i < quantities.size() && !update.samples.columns.empty(); ++i)
                append(record.of[quantities[i].name], update.samples.columns[i]);
            return true;
        },
        options);
    return record;
}

double speedOf(const Case& c) { return c.disk.speed * c.disk.radius * std::cos(c.disk.skew); }

/// A wave that passes with this frequency.
Case overWave(double amplitude, double frequency)
{
    Case c;
    c.initial.flyingHeight = c.springs.flyingHeight;
    c.initial.pitch = c.springs.pitch;
    c.diskSurface.kind = DiskSurfaceKind::Waves;
    c.diskSurface.waveAmplitudes = {amplitude};
    c.diskSurface.waveLengths = {speedOf(c) / frequency};
    c.diskSurface.wavePhases = {0.3};
    return c;
}

/// One set of the table of SciPy.
struct DrawnSet {
    std::vector<CaseSetting> settings;
    std::vector<std::array<double, 2>> spacing; // time [s], minimum spacing [m]
    int switches = 0;
};

std::vector<DrawnSet> drawnSets()
{
    QFile file(QStringLiteral(TOUCHDOWN_SOURCE_DIR "/tests/simulation/springs/scipy_reference_over_disk.csv"));
    if (!file.open(QIODevice::ReadOnly)) qFatal("no table");
    std::vector<DrawnSet> sets;
    for (const QByteArray& line : file.readAll().split('\n')) {
        if (line.startsWith("# set ")) {
            DrawnSet& set = sets.emplace_back();
            for (const QByteArray& each : line.mid(line.indexOf(':') + 1).split(';')) {
                const qsizetype at = each.indexOf('=');
                const std::string key = each.left(at).trimmed().toStdString();
                const std::string value = each.mid(at + 1).trimmed().toStdString();
                if (key == "switches")
                    set.switches = std::stoi(value);
                else
                    set.settings.push_back({key, value});
            }
        } else if (const QList<QByteArray> words = line.split(','); words.size() == 2 && !sets.empty()) {
            sets.back().spacing.push_back({words[0].toDouble() * 1e-6, words[1].toDouble() * 1e-9});
        }
    }
    return sets;
}

/// 64 points of a whole turn, 2 um apart, and the first one again.
void writeProfile(const QString& folder)
{
    QFile file(folder + "/profile.txt");
    if (!file.open(QIODevice::WriteOnly)) qFatal("no profile");
    for (int i = 0; i <= 64; ++i) {
        const double turn = 2.0 * pi * (i % 64) / 64.0;
        const double h =
            0.9 * std::sin(turn + 0.4) + 0.5 * std::sin(5.0 * turn + 1.1) + 0.2 * std::sin(11.0 * turn + 2.0);
        file.write(QByteArray::number(2.0 * i) + ' ' + QByteArray::number(h, 'g', 17) + '\n');
    }
}

Case caseOf(const DrawnSet& set, const QString& folder)
{
    Case c;
    c.folder = folder.toStdString();
    c.run.duration = 60e-6;
    c.run.sampleInterval = 1e-6;
    c.run.tolerance = 1e-13;
    if (const auto problem = changeCase(c, set.settings)) qFatal("%s", problem->text().c_str());
    return c;
}

/// The response of the linear motion about the static state to a wave: M q" + C q' + K q = sum (k + i w c) b W.
Eigen::Vector2cd linearResponse(const Case& c, double omega)
{
    const SpringsCase& s = c.springs;
    const double m = c.slider.mass, j = c.slider.pitchInertia;
    const Complex i(0.0, 1.0);
    const auto dashpot = [](double ratio, double inertia, double stiffness) {
        return 2.0 * ratio * std::sqrt(inertia * stiffness);
    };
    Eigen::Matrix2cd dynamic = Eigen::Matrix2cd::Zero();
    const SuspensionCase& held = c.suspension;
    dynamic(0, 0) = -m * omega * omega + held.stiffness + i * omega * dashpot(held.dampingRatio, m, held.stiffness);
    dynamic(1, 1) =
        -j * omega * omega + held.pitchStiffness + i * omega * dashpot(held.pitchDampingRatio, j, held.pitchStiffness);
    Eigen::Vector2cd force = Eigen::Vector2cd::Zero();
    const double number = 2.0 * pi / c.diskSurface.waveLengths[0];
    const auto add = [&](double stiffness, double ratio, double arm) {
        const Complex spring = stiffness + i * omega * dashpot(ratio, m, stiffness);
        const Eigen::Vector2cd lever(1.0, arm);
        dynamic += spring * lever * lever.transpose();
        // a sin(k x - w t + c) = Re W exp(i w t), W = i a exp(-i (k x + c))
        const double phase = number * (0.5 * c.slider.length - arm) + c.diskSurface.wavePhases[0];
        force += spring * lever * (i * c.diskSurface.waveAmplitudes[0] * std::exp(-i * phase));
    };
    add(s.frontStiffness, s.frontDampingRatio, s.frontDistance);
    add(s.rearStiffness, s.rearDampingRatio, -s.rearDistance);
    return dynamic.inverse() * force;
}

/// The complex amplitude of a record at omega, over its last whole periods.
Complex amplitudeOf(const Record& record, const char* quantity, double omega, int samples)
{
    const std::vector<double>& values = record.of.at(quantity);
    Complex sum = 0.0;
    for (std::size_t k = values.size() - static_cast<std::size_t>(samples); k < values.size(); ++k)
        sum += values[k] * std::exp(Complex(0.0, -omega * record.time[k]));
    return 2.0 * sum / static_cast<double>(samples);
}

/// Two equal air springs, four waves before and behind a pad in the middle: no pitch. The stop pushes from d_s on.
Case stopped(double touchDown, double jump, double stiffness)
{
    Case c;
    c.springs = {.frontStiffness = 5e5,
                 .rearStiffness = 5e5,
                 .frontDistance = 0.5e-3,
                 .rearDistance = 0.5e-3,
                 .frontDampingRatio = 0.05,
                 .rearDampingRatio = 0.05,
                 .cutoff = 0.1e-9,
                 .flyingHeight = 40e-9,
                 .pitch = 0.0,
                 .potential = PotentialBelowCutoff::Held};
    c.onoYamane.meniscusForce = c.onoYamane.friction = c.springs.padDistance = 0.0;
    c.onoYamane.touchDown = c.onoYamane.takeOff = touchDown;
    c.onoYamane.initialContactForce = jump;
    c.onoYamane.contactStiffness = stiffness;
    c.diskSurface.kind = DiskSurfaceKind::Waves;
    c.diskSurface.waveAmplitudes = {6e-9};
    c.diskSurface.waveLengths = {0.5e-3 / 4.0};
    c.diskSurface.wavePhases = {0.3};
    c.initial.flyingHeight = 40e-9;
    c.run.tolerance = 1e-12;
    c.run.duration = c.diskSurface.waveLengths[0] / speedOf(c); // one period
    c.run.sampleInterval = c.run.duration / 20000.0;
    return c;
}

class TestSpringsOverDisk : public QObject {
    Q_OBJECT

private slots:
    /// An independent integration: own formulas of equations (1) to (4), DOP853 of SciPy 1.10 with located switches,
    /// rtol 1e-12, in nm and us. Drawn sliders, contacts and disks: 12 with waves, 5 with bumps, 3 with a profile. The
    /// energy balance is closed with friction, contact and the work of the disk.
    void agreesWithSciPy()
    {
        QTemporaryDir folder;
        writeProfile(folder.path());
        const std::vector<DrawnSet> sets = drawnSets();
        QCOMPARE(sets.size(), std::size_t(20));
        double largest = 0.0, imbalance = 0.0;
        int switches = 0;
        for (const DrawnSet& set : sets) {
            const Case c = caseOf(set, folder.path());
            const Record record = recorded(c, {.energyBalance = true});
            QVERIFY2(record.summary.status == RunStatus::Completed, record.summary.message.c_str());
            QCOMPARE(static_cast<int>(record.summary.events.size()), set.switches);
            switches += set.switches;
            const std::vector<double>& spacing = record.of.at("minimum_spacing");
            for (const auto& [time, expected] : set.spacing) {
                const auto k = static_cast<std::size_t>(std::lround(time / c.run.sampleInterval));
                QVERIFY(std::abs(record.time[k] - time) < 1e-15);
                largest = std::max(largest, std::abs(spacing[k] - expected));
            }
            imbalance = std::max(imbalance, record.figure("energy_balance"));
        }
        QVERIFY(switches > 100);
        QVERIFY2(largest < 1e-12, qPrintable(QString::number(largest)));
        QVERIFY2(imbalance < 1e-9, qPrintable(QString::number(imbalance)));
    }

    /// The pad stays on the contact stiffness, which is linear: M z" + c z' + k (z - z_0) = k_c (d_s - z + w). The
    /// amplitude is a k_c/|k_c + k - M w^2 + i w c| at every frequency.
    void linearOscillator()
    {
        Case c = overWave(1e-9, 200e3);
        c.springs.frontStiffness = c.springs.rearStiffness = 0.0;
        c.springs.flyingHeight = 100e-9;
        c.springs.pitch = c.initial.pitch = 0.0;
        c.suspension.stiffness = 1e5;
        c.suspension.dampingRatio = 0.5;
        c.onoYamane = {.meniscusForce = 0.0,
                       .contactStiffness = 5e6,
                       .initialContactForce = 0.0,
                       .touchDown = 1e-6,
                       .takeOff = 1e-6,
                       .friction = 0.0,
                       .takeOffShape = TakeOffShape::Constant};
        c.springs.padDistance = 0.0;
        c.initial.flyingHeight = 982e-9;
        c.run.tolerance = 1e-12;
        double largest = 0.0;
        for (const double frequency : {50e3, 150e3, 250e3, 280e3, 285e3, 300e3, 400e3, 800e3}) {
            constexpr int samplesInPeriod = 64;
            const double omega = 2.0 * pi * frequency;
            c.diskSurface.waveLengths = {speedOf(c) / frequency};
            c.run.sampleInterval = 1.0 / frequency / samplesInPeriod;
            c.run.duration = (std::ceil(0.4e-3 * frequency) + 32.0) / frequency;
            const Record record = recorded(c);
            QVERIFY2(record.summary.status == RunStatus::Completed, record.summary.message.c_str());
            QVERIFY(record.summary.events.empty());
            const double stiffness = c.onoYamane.contactStiffness, m = c.slider.mass, k = c.suspension.stiffness;
            const double dashpot = 2.0 * c.suspension.dampingRatio * std::sqrt(m * k);
            const double expected =
                1e-9 * stiffness / std::abs(Complex(stiffness + k - m * omega * omega, omega * dashpot));
            const double got = std::abs(amplitudeOf(record, "height", omega, 32 * samplesInPeriod));
            largest = std::max(largest, std::abs(got / expected - 1.0));
        }
        QVERIFY2(largest < 1e-6, qPrintable(QString::number(largest)));
    }

    /// A wave of 1e-4 nm under both air springs: height and pitch with amplitude and phase of the linear motion, which
    /// tells the two places, the direction of the disk and the dashpots.
    void smallWaves()
    {
        for (const double frequency : {60e3, 140e3, 310e3}) {
            constexpr int samplesInPeriod = 64;
            Case c = overWave(1e-13, frequency);
            c.contact = noContact;
            c.springs.frontDampingRatio = 0.1;
            c.springs.rearDampingRatio = 0.2;
            c.run.tolerance = 1e-13;
            c.run.sampleInterval = 1.0 / frequency / samplesInPeriod;
            c.run.duration = (std::ceil(0.4e-3 * frequency) + 32.0) / frequency;
            const double omega = 2.0 * pi * frequency;
            const Record record = recorded(c);
            const Eigen::Vector2cd expected = linearResponse(c, omega);
            const Eigen::Vector2cd got{amplitudeOf(record, "height", omega, 32 * samplesInPeriod),
                                       amplitudeOf(record, "pitch", omega, 32 * samplesInPeriod)};
            for (int k = 0; k < 2; ++k)
                QVERIFY2(std::abs(got[k] - expected[k]) < 1e-5 * std::abs(expected[k]),
                         qPrintable(QString("%1: %2").arg(frequency).arg(std::abs(got[k] / expected[k] - 1.0))));
        }
    }

    /// Grazing. An orbit that would dip by delta below the stop meets it with the speed sqrt(2 a delta), a its
    /// acceleration there (Nordmark, J. Sound Vib. 145 (1991) 279-297). An elastic stop holds it for 2 sqrt(2
    /// delta/a). A force F that is there at once sends it off with the speed 2 sqrt(2 a delta) F/(M a + F) beyond that
    /// of the free orbit, so that the amplitude grows with the square root of delta; where the force begins at zero,
    /// with delta^(3/2) (di Bernardo, Budd & Champneys, Physica D 160 (2001) 222-254).
    void grazing()
    {
        Case c = stopped(0.0, 0.0, 0.0);
        c.contact = noContact;
        Record free;
        std::size_t lowest = 0;
        for (int turn = 0; turn < 2; ++turn) {
            for (int k = 0; k < 60; ++k) { // until the motion repeats with the wave
                free = recorded(c);
                QVERIFY(std::abs(free.of.at("pitch").back()) < 1e-15);
                c.initial.flyingHeight = free.of.at("height").back();
                c.initial.verticalVelocity = free.of.at("vertical_velocity").back();
            }
            const std::vector<double>& d = free.of.at("flying_height");
            lowest = static_cast<std::size_t>(std::ranges::min_element(d) - d.begin());
            if (turn == 0) c.diskSurface.wavePhases[0] += 2.0 * pi * (0.5 - double(lowest) / 20000.0);
        }
        const std::vector<double>& d = free.of.at("flying_height");
        QVERIFY(std::abs(double(lowest) - 10000.0) < 20.0);
        const double apart = 200.0 * c.run.sampleInterval;
        const double a = (d[lowest - 200] - 2.0 * d[lowest] + d[lowest + 200]) / (apart * apart);
        const auto with = [&](double delta, double jump, double stiffness) {
            Case touching = stopped(d[lowest] + delta, jump, stiffness);
            touching.initial = c.initial;
            touching.diskSurface = c.diskSurface;
            return recorded(touching);
        };
        const auto speedBeyond = [&](const Record& record) { // of the free orbit, just after the take-off
            const double end = record.summary.events.at(1).time;
            const auto k = static_cast<std::size_t>(std::ceil(end / c.run.sampleInterval));
            return record.of.at("vertical_velocity")[k] - free.of.at("vertical_velocity")[k];
        };
        const double m = c.slider.mass;
        std::vector<double> jumped, elastic;
        for (const double delta : {0.001e-9, 0.004e-9, 0.016e-9}) {
            const double law = std::sqrt(2.0 * a * delta);
            const Record hard = with(delta, 1e-3, 1.0);
            QCOMPARE(hard.summary.events.size(), std::size_t(2));
            jumped.push_back(speedBeyond(hard));
            const double expected = 2.0 * law * 1e-3 / (m * a + 1e-3);
            QVERIFY2(std::abs(jumped.back() / expected - 1.0) < 0.02,
                     qPrintable(QString("%1 of %2").arg(jumped.back()).arg(expected)));
            const Record soft = with(delta, 0.0, 1e6);
            QCOMPARE(soft.summary.events.size(), std::size_t(2));
            elastic.push_back(speedBeyond(soft));
            const double held = soft.summary.events[1].time - soft.summary.events[0].time;
            QVERIFY2(std::abs(held * a / (2.0 * law) - 1.0) < 0.02, qPrintable(QString::number(held * a / law)));
        }
        for (std::size_t k = 0; k + 1 < jumped.size(); ++k) {
            const double power = std::log(jumped[k + 1] / jumped[k]) / std::log(4.0);
            const double soft = std::log(elastic[k + 1] / elastic[k]) / std::log(4.0);
            QVERIFY2(std::abs(power - 0.5) < 0.01, qPrintable(QString::number(power)));
            QVERIFY2(std::abs(soft - 1.5) < 0.03, qPrintable(QString::number(soft)));
        }
    }

    /// A surface that stands still and is flat under all three places gives the bits of a flat disk.
    void stillAndFlat()
    {
        Case flat;
        flat.run.duration = 100e-6;
        Case still = flat;
        still.diskSurface.kind = DiskSurfaceKind::Bumps;
        still.diskSurface.motion = SurfaceMotion::Still;
        still.diskSurface.bumpHeights = {20e-9};
        still.diskSurface.bumpLengths = {50e-6};
        still.diskSurface.bumpX = {400e-6};
        still.diskSurface.bumpY = {0.0};
        still.diskSurface.trackWidth = 1e-3;
        const Record a = recorded(flat), b = recorded(still);
        QVERIFY(a.time.size() > 100 && a.summary.events.size() > 4);
        QCOMPARE(b.summary.steps, a.summary.steps);
        for (const auto& [name, values] : a.of) QVERIFY2(b.of.at(name) == values, name.c_str());
        for (const char* name : {"disk_height", "front_disk_height", "rear_disk_height", "disk_power"})
            QVERIFY(std::ranges::all_of(b.of.at(name), [](double value) { return value == 0.0; }));
    }

    /// A wave that runs across lifts all three places alike. Without a suspension nothing else says where the disk is,
    /// so that the slider moves as above a flat disk, higher by this. An ellipsoid may stand still.
    void stillAndRaised()
    {
        Case flat;
        flat.run.duration = 50e-6;
        flat.run.tolerance = 1e-11;
        flat.suspension.stiffness = 0.0;
        Case raised = flat;
        raised.diskSurface.kind = DiskSurfaceKind::Waves;
        raised.diskSurface.motion = SurfaceMotion::Still;
        raised.diskSurface.waveAmplitudes = {2e-9};
        raised.diskSurface.waveLengths = {1e-3};
        raised.diskSurface.waveAngles = {0.5 * pi};
        raised.diskSurface.wavePhases = {0.4}; // sin(pi + 0.4) at the slider's middle
        const double height = 2e-9 * std::sin(pi + 0.4);
        raised.initial.flyingHeight = flat.initial.flyingHeight + height;
        const Record a = recorded(flat), b = recorded(raised, {.energyBalance = true});
        QCOMPARE(b.summary.events.size(), a.summary.events.size());
        for (std::size_t k = 0; k < a.time.size(); ++k) {
            QVERIFY(std::abs(a.of.at("minimum_spacing")[k] - b.of.at("minimum_spacing")[k]) < 1e-14);
            QVERIFY(std::abs(a.of.at("height")[k] + height - b.of.at("height")[k]) < 1e-14);
            QVERIFY(std::abs(b.of.at("disk_height")[k] - height) < 1e-20);
        }
        QVERIFY(b.figure("energy_balance") < 1e-6);
        raised.diskSurface.kind = DiskSurfaceKind::Bumps;
        raised.diskSurface.bumpHeights = raised.diskSurface.bumpLengths = {1e-9};
        raised.diskSurface.bumpX = raised.diskSurface.bumpY = {0.0};
        QVERIFY(checkCombinations(raised).empty());
    }

    /// All methods take the disk with them. Over waves alone, that the slider follows without contact.
    void integratorsAgree()
    {
        Case c = overWave(1e-9, 100e3);
        c.initial.flyingHeight = 9e-9;
        c.contact = noContact;
        c.run.duration = 50e-6;
        c.run.tolerance = 1e-12;
        c.run.stepCheck = false;
        const Record exact = recorded(c);
        const auto apart = [&](IntegratorKind kind, double step) {
            c.run.integrator = kind;
            c.run.step = step;
            const Record other = recorded(c);
            double largest = 0.0;
            for (std::size_t k = 0; k < exact.time.size(); ++k)
                largest =
                    std::max(largest, std::abs(other.of.at("flying_height")[k] - exact.of.at("flying_height")[k]));
            return largest;
        };
        const auto order = [&](IntegratorKind kind, double step) {
            return std::log2(apart(kind, step) / apart(kind, 0.5 * step));
        };
        QVERIFY(std::abs(order(IntegratorKind::Rk4, 40e-9) - 4.0) < 0.15);
        QVERIFY(std::abs(order(IntegratorKind::Rk4Events, 40e-9) - 4.0) < 0.15);
        QVERIFY(std::abs(order(IntegratorKind::Newmark, 20e-9) - 2.0) < 0.15);
        if (haveCvode) QVERIFY(apart(IntegratorKind::Cvode, 1e-8) < 1e-14);
    }

    /// The heights along a step, as switches see them, are as near as the header says, and exact at both ends.
    void heightsAlongAStep()
    {
        const Case c = overWave(1e-9, 100e3);
        const SpringModel model(c);
        const DiskUnderSprings disk(c);
        const SpringsOverDisk system(model, disk, c.run.duration);
        QVERIFY(std::abs(disk.longestStep() - 1.0 / 1.6e6) < 1e-18);
        const double h = disk.longestStep(), bound = 7.5e-5 * std::pow(2.0 * pi / 16.0, 5.0) * 1e-9;
        double largest = 0.0;
        for (int begin = 0; begin < 20; ++begin) {
            SpringsOverDisk::State first = system.initialState(), last = first;
            first[2] = 0.71e-6 * begin;
            last[2] = first[2] + h;
            std::array<SpringsOverDisk::State, 5> c5;
            for (std::size_t k = 0; k < 5; ++k) c5[k] = first + 0.25 * double(k) * (last - first);
            const auto path = system.guardPath(c5);
            for (int k = 0; k <= 40; ++k) {
                const double x = k / 40.0, w = 1.0 - x;
                const SpringModel::Guards at = w * w * w * w * path[0] + 4.0 * w * w * w * x * path[1] +
                                               6.0 * w * w * x * x * path[2] + 4.0 * w * x * x * x * path[3] +
                                               x * x * x * x * path[4];
                const Eigen::Vector3d q(first[0], first[1], std::lerp(first[2], last[2], x));
                largest = std::max(largest, (at - system.guards(q)).cwiseAbs().maxCoeff());
                if (k % 40 == 0) QVERIFY((at - system.guards(q)).cwiseAbs().maxCoeff() < 1e-22);
            }
        }
        QVERIFY2(largest < bound && largest > 0.3 * bound, qPrintable(QString::number(largest / bound)));
    }

    /// What is refused names its key.
    void refusals()
    {
        const auto key = [](const Case& c) {
            const std::vector<CaseProblem> problems = checkCombinations(c);
            return problems.empty() ? std::string() : problems.front().key;
        };
        Case c = overWave(1e-9, 100e3);
        QCOMPARE(key(c), std::string());
        c.run.integrator = IntegratorKind::Rk4Events;
        c.run.step = 0.63e-6; // 1/16 of the wave passes in 0.625 us
        QCOMPARE(key(c), std::string("run.step"));
        c.run.step = 0.62e-6;
        QCOMPARE(key(c), std::string());
        c.disk.speed = 0.0;
        QCOMPARE(key(c), std::string("disk.surface.motion"));
        Case bumps = overWave(1e-9, 100e3);
        bumps.diskSurface.kind = DiskSurfaceKind::Bumps;
        bumps.diskSurface.bumpHeights = {1e-9};
        bumps.diskSurface.bumpLengths = {20e-6};
        bumps.diskSurface.bumpX = bumps.diskSurface.bumpY = {0.0};
        QCOMPARE(key(bumps), std::string("disk.surface.bump_shape"));
        bumps.diskSurface.bumpShape = BumpShape::Cosine;
        QCOMPARE(key(bumps), std::string());
        QTemporaryDir folder; // half a cell of 2 um passes in 77 ns, which only the file tells
        writeProfile(folder.path());
        Case profile = overWave(1e-9, 100e3);
        profile.diskSurface = {};
        profile.folder = folder.path().toStdString();
        profile.diskSurface.kind = DiskSurfaceKind::File;
        profile.diskSurface.file = "profile.txt";
        profile.diskSurface.unit = "um, nm";
        profile.run.integrator = IntegratorKind::Rk4Events;
        profile.run.duration = 1e-6;
        profile.run.step = 78e-9;
        QCOMPARE(key(profile), std::string());
        QVERIFY2(run(profile).message.starts_with("run.step must be at most 76.5 ns"), run(profile).message.c_str());
        profile.run.step = 76.5e-9;
        QCOMPARE(run(profile).status, RunStatus::Completed);
        Case inside = overWave(20e-9, 100e3); // higher than the rear spring's spacing somewhere at the start
        inside.diskSurface.wavePhases = {0.5 * pi - 2.0 * pi / inside.diskSurface.waveLengths[0] *
                                                        (0.5 * inside.slider.length + inside.springs.rearDistance)};
        const Summary summary = run(inside);
        QCOMPARE(summary.status, RunStatus::Failed);
        QVERIFY2(summary.message.starts_with("initial.flying_height"), summary.message.c_str());
    }
};

TOUCHDOWN_TEST(TestSpringsOverDisk)

} // namespace test_springs_over_disk

#include "test_springs_over_disk.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/reference_frequencies.h"

#include <cmath>
#include <numbers>

#include <QTest>

#include "core/case/case.h"
#include "core/case/contact_kind.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_reference_frequencies {

constexpr double twoPi = 2.0 * std::numbers::pi;

/// Springs without suspension and dashpots; without contact.
Case springsAlone()
{
    Case c;
    c.model = ModelKind::Springs;
    c.contact = noContact;
    c.suspension.stiffness = c.suspension.pitchStiffness = 0.0;
    c.suspension.dampingRatio = c.suspension.pitchDampingRatio = 0.0;
    c.springs.frontDampingRatio = c.springs.rearDampingRatio = 0.0;
    return c;
}

std::vector<double> of(const Case& c, FrequencyKind kind)
{
    std::vector<double> found;
    for (const ReferenceFrequency& each : referenceFrequencies(c))
        if (each.kind == kind) found.push_back(each.frequency);
    return found;
}

void compareRelative(double found, double expected)
{
    QVERIFY2(std::abs(found - expected) < 1e-9 * expected,
             qPrintable(QStringLiteral("%1 Hz, expected %2 Hz").arg(found, 0, 'g', 12).arg(expected, 0, 'g', 12)));
}

class TestReferenceFrequencies : public QObject {
    Q_OBJECT

private slots:
    void modesOfEqualSprings();
    void contactOfAPressedPad();
    void contactOfAFilm();
    void wavesOfAMovingDisk();
    void nothingThatTheCaseDoesNotHave();
};

/// Equal springs k at equal arms d decouple: M z'' = -2 k z, J theta'' = -2 k d^2 theta.
void TestReferenceFrequencies::modesOfEqualSprings()
{
    Case c = springsAlone();
    c.springs.frontStiffness = c.springs.rearStiffness = 2e5;
    c.springs.frontDistance = c.springs.rearDistance = 0.5e-3;
    const std::vector<ReferenceFrequency> found = referenceFrequencies(c);
    QCOMPARE(found.size(), std::size_t(2));
    const double vertical = std::sqrt(4e5 / c.slider.mass) / twoPi;
    const double pitch = std::sqrt(4e5 * 0.5e-3 * 0.5e-3 / c.slider.pitchInertia) / twoPi;
    compareRelative(found[0].frequency, std::min(vertical, pitch));
    compareRelative(found[1].frequency, std::max(vertical, pitch));
    QCOMPARE(found[0].name, std::string("mode 1"));
    QCOMPARE(found[1].name, std::string("mode 2"));
    QVERIFY(found[0].kind == FrequencyKind::Mode);
}

/// With soft springs and without friction the pad at d_h moves as a mass 1/(1/M + d_h^2/J) on k_c.
void TestReferenceFrequencies::contactOfAPressedPad()
{
    Case c = springsAlone();
    c.contact = ContactKind::OnoYamane;
    c.springs.frontStiffness = c.springs.rearStiffness = 1e-6;
    c.onoYamane.friction = 0.0;
    const double d = c.springs.padDistance;
    const double expected =
        std::sqrt(c.onoYamane.contactStiffness * (1.0 / c.slider.mass + d * d / c.slider.pitchInertia)) / twoPi;
    const std::vector<double> found = of(c, FrequencyKind::Contact);
    QCOMPARE(found.size(), std::size_t(1));
    compareRelative(found[0], expected);
    c.onoYamane.contactStiffness = 0.0;
    QVERIFY(of(c, FrequencyKind::Contact).empty());
}

void TestReferenceFrequencies::contactOfAFilm()
{
    Case c;
    c.model = ModelKind::Film;
    c.contact = ContactKind::OnoYamane;
    const std::vector<double> found = of(c, FrequencyKind::Contact);
    QCOMPARE(found.size(), std::size_t(1));
    compareRelative(found[0], std::sqrt(c.onoYamane.contactStiffness / c.slider.mass) / twoPi);
    QVERIFY(of(c, FrequencyKind::Mode).empty()); // not without a solution
}

/// At 23 mm and 100 rad/s the disk moves at 2.3 m/s: waves of 10 um along the track pass at 230 kHz, under 60 degrees
/// at half of it, and waves across it do not pass. With a skew of 30 degrees the track turns by as much.
void TestReferenceFrequencies::wavesOfAMovingDisk()
{
    Case c;
    c.model = ModelKind::Film;
    c.contact = noContact;
    c.disk = {100.0, 23e-3, 0.0, VelocityField::Rotating};
    c.diskSurface.kind = DiskSurfaceKind::Waves;
    c.diskSurface.waveAmplitudes = {1e-9};
    c.diskSurface.waveLengths = {10e-6};
    QCOMPARE(referenceFrequencies(c).size(), std::size_t(1));
    QCOMPARE(referenceFrequencies(c)[0].name, std::string("wave"));
    compareRelative(referenceFrequencies(c)[0].frequency, 230e3);
    c.disk.skew = std::numbers::pi / 6.0;
    compareRelative(referenceFrequencies(c)[0].frequency, 230e3 * std::cos(std::numbers::pi / 6.0));
    c.disk.skew = 0.0;
    c.diskSurface.waveAmplitudes = {1e-9, 1e-9};
    c.diskSurface.waveLengths = {10e-6, 20e-6};
    c.diskSurface.waveAngles = {std::numbers::pi / 3.0, 0.0};
    const std::vector<ReferenceFrequency> two = referenceFrequencies(c);
    QCOMPARE(two.size(), std::size_t(2));
    compareRelative(two[0].frequency, 115e3);
    compareRelative(two[1].frequency, 115e3);
    QCOMPARE(two[1].name, std::string("wave 2"));
    c.diskSurface.motion = SurfaceMotion::Still;
    QVERIFY(referenceFrequencies(c).empty());
}

void TestReferenceFrequencies::nothingThatTheCaseDoesNotHave()
{
    Case c = springsAlone();
    c.springs.frontDampingRatio = c.springs.rearDampingRatio = 50.0; // nothing oscillates
    QVERIFY(referenceFrequencies(c).empty());
    c = springsAlone();
    c.diskSurface.kind = DiskSurfaceKind::Waves; // which pass under springs, too
    c.diskSurface.waveAmplitudes = {1e-9};
    c.diskSurface.waveLengths = {10e-6};
    QCOMPARE(of(c, FrequencyKind::Wave).size(), std::size_t(1));
    compareRelative(of(c, FrequencyKind::Wave)[0], c.disk.speed * c.disk.radius / 10e-6);
    c.diskSurface.motion = SurfaceMotion::Still;
    QVERIFY(of(c, FrequencyKind::Wave).empty());
    c.model = ModelKind::Contact;
    QVERIFY(referenceFrequencies(c).empty());
}

TOUCHDOWN_TEST(TestReferenceFrequencies)

} // namespace test_reference_frequencies

#include "test_reference_frequencies.moc"

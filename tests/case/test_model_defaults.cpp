// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/model_defaults.h"

#include <QTest>

#include "core/case/contact_kind.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_model_defaults {

bool nothing(const Parameter&) { return false; }

class TestModelDefaults : public QObject {
    Q_OBJECT

private slots:
    /// From any model to any other and back, a case of defaults is one of defaults.
    void aNewCaseFollows()
    {
        for (const ModelKind from : {ModelKind::Springs, ModelKind::Film, ModelKind::Contact})
            for (const ModelKind to : {ModelKind::Springs, ModelKind::Film, ModelKind::Contact}) {
                Case c = defaultsOf(from);
                c.model = to;
                QCOMPARE(takeModelDefaults(c, from, nothing), from != to);
                QVERIFY(c == defaultsOf(to));
                c.model = from;
                takeModelDefaults(c, to, nothing);
                QVERIFY(c == defaultsOf(from));
            }
    }
    /// An uneven disk can run at once; what is there already stays, and other disks have what they need.
    void anUnevenDiskHasAFirstFeature()
    {
        for (const DiskSurfaceKind kind : {DiskSurfaceKind::Waves, DiskSurfaceKind::Bumps}) {
            Case c;
            c.diskSurface.kind = kind;
            QVERIFY(!checkCombinations(c).empty());
            QVERIFY(takeFirstUnevenness(c));
            QVERIFY(checkCombinations(c).empty());
            QVERIFY(!takeFirstUnevenness(c));
        }
        for (const DiskSurfaceKind kind : {DiskSurfaceKind::Flat, DiskSurfaceKind::Rough, DiskSurfaceKind::File}) {
            Case c;
            c.diskSurface.kind = kind;
            QVERIFY(!takeFirstUnevenness(c));
        }
        Case own;
        own.diskSurface.kind = DiskSurfaceKind::Waves;
        own.diskSurface.waveAmplitudes = {2e-9};
        QVERIFY(!takeFirstUnevenness(own));
    }
    /// A new film starts where it flies, unless a start was chosen.
    void aFilmStartsAtItsStaticState()
    {
        Case c = defaultsOf(ModelKind::Springs);
        QVERIFY(!takeFilmStart(c));
        c.model = ModelKind::Film;
        Case own = c;
        QVERIFY(takeFilmStart(c));
        QCOMPARE(c.initial.state, InitialState::Static);
        own.initial.pitch = 80e-6;
        QVERIFY(!takeFilmStart(own) && own.initial.state == InitialState::Given);
    }
    /// A value that is not the default was chosen, and so was one that is stated.
    void whatWasChosenStays()
    {
        Case c = defaultsOf(ModelKind::Springs);
        c.model = ModelKind::Film;
        c.run.duration = 3e-3;
        takeModelDefaults(c, ModelKind::Springs, [](const Parameter& each) { return each.key == "contact"; });
        QCOMPARE(c.degreesOfFreedom, 3);
        QCOMPARE(c.contact, ContactKind::OnoYamane);
        QCOMPARE(c.run.duration, 3e-3);
    }
};

TOUCHDOWN_TEST(TestModelDefaults)

} // namespace test_model_defaults

#include "test_model_defaults.moc"

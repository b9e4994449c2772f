// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/flight/film_scene.h"

#include <QTest>

#include "core/case/contact_kind.h"
#include "core/case/parameters.h"
#include "core/physics/contact/adhesion_kind.h"
#include "core/simulation/static_state/film_setup.h"
#include "tests/support/small_slider.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_film_scene {

/// Over a disk whose map has 64 x 32 points, with a contact.
Case touching()
{
    Case c = test::smallSlider(33);
    c.film.tolerance = 1e-7;
    c.steady.loadTolerance = 1e-6;
    c.contact = ContactKind::Elastic;
    c.elastic.cell = 1e-6;
    c.elastic.patchPitch = 120e-6;
    c.elastic.patchReach = 4e-9;
    c.adhesion.kind = AdhesionKind::LennardJones;
    c.diskSurface.kind = DiskSurfaceKind::Rough;
    c.diskSurface.cell = 1e-6;
    c.diskSurface.correlationLength = 4e-6;
    c.diskSurface.track = 64e-6;
    c.diskSurface.trackWidth = 32e-6;
    return c;
}

class TestFilmScene : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        FilmScene scene(case_);
        QVERIFY(scene.prepare([&] { return ++calls_ > 0; }) == FilmScene::State::Ready);
        QVERIFY(scene.contact && !scene.disk->flat());
    }
    /// No more work than this between two calls: a row of a spectrum of 33 rows, of amplitudes of 32 (twice: first
    /// their sum), or of statistics (twice: first their mean); one of 512 scan lines for the patches, which are sought
    /// for the recorded fields and for the contact.
    void isAskedAtEachRow()
    {
        constexpr int rows = 32, spectrum = rows / 2 + 1, scanLines = 512;
        QVERIFY2(calls_ >= spectrum + 4 * rows + 2 * scanLines, qPrintable(QString::number(calls_)));
    }
    /// Wherever it is told to: of what asks inside something else, each that encloses it asks once more at most.
    void stopsAnywhere()
    {
        constexpr int deepest = 5;
        for (int share = 0; share < 40; ++share) {
            const int last = 1 + (calls_ - 1) * share / 39;
            FilmScene scene(case_);
            int asked = 0;
            QVERIFY(scene.prepare([&] { return ++asked < last; }) == FilmScene::State::Stopped);
            QVERIFY2(asked >= last && asked <= last + deepest,
                     qPrintable(QString("%1 calls after call %2").arg(asked - last).arg(last)));
        }
    }

    /// Of a film that is to be solved more exactly than numbers are.
    void saysHowToBegin_data()
    {
        QTest::addColumn<double>("height");
        QTest::addColumn<ContactKind>("contact");
        QTest::addColumn<QString>("advice");
        QTest::newRow("above")
            << 20e-9 << ContactKind::None
            << "start higher (initial.nominal_trailing_edge_height) or allow more film.maximum_iterations";
        QTest::newRow("below, where a contact may carry it")
            << -60e-9 << ContactKind::Elastic
            << "start higher (initial.nominal_trailing_edge_height): air that the rails shut in";
        QTest::newRow("below, without contact")
            << -60e-9 << ContactKind::None
            << "(contact = \"none\"); start higher (initial.nominal_trailing_edge_height)";
    }
    void saysHowToBegin()
    {
        QFETCH(double, height);
        QFETCH(ContactKind, contact);
        QFETCH(QString, advice);
        Case c = case_;
        c.contact = contact;
        c.diskSurface.kind = DiskSurfaceKind::Flat;
        c.film.tolerance = 1e-30;
        c.film.maximumIterations = 3;
        c.initial.nominalTrailingEdgeHeight = height;
        FilmScene scene(c);
        QVERIFY(scene.prepare([] { return true; }) == FilmScene::State::Failed);
        QVERIFY2(scene.message.find(advice.toStdString()) != std::string::npos, scene.message.c_str());
    }

private:
    Case case_ = touching();
    int calls_ = 0;
};

TOUCHDOWN_TEST(TestFilmScene)

} // namespace test_film_scene

#include "test_film_scene.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/shape_follower.h"

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include <QSignalSpy>
#include <QTest>

#include "tests/support/test_program.h"
#include "tests/ui/sample_slider.h"
#include "ui/film/film_view.h"
#include "ui/film/film_window.h"
#include "ui/film/surface_page.h"
#include "ui/style/theme.h"

using namespace touchdown;

namespace test_shape_follower {

/// Remembers what it was asked for; the minimum spacing is the recess of the first rail. Waits while `held`.
struct Solver {
    std::atomic<bool> held = false;
    std::atomic<int> solving = 0, most = 0;
    std::mutex mutex;
    std::vector<Case> asked;
    std::vector<double> starts; // minimum spacing of what it came from

    SteadyResult operator()(const Case& c, const Case&, const SteadyResult& from, const SteadyCallback& callback)
    {
        most = std::max<int>(most, ++solving);
        {
            const std::lock_guard lock(mutex);
            asked.push_back(c);
            starts.push_back(from.minimumSpacing);
        }
        bool stopped = false;
        while (held && !stopped) {
            stopped = !callback({"grid", 1, 0.1, 0.1, {}});
            std::this_thread::yield();
        }
        --solving;
        SteadyResult result = sampleResult(c);
        result.minimumSpacing = c.surface.rails[0].recess[0];
        if (stopped) result.status = SteadyStatus::Cancelled;
        return result;
    }
    std::size_t count()
    {
        const std::lock_guard lock(mutex);
        return asked.size();
    }
};

class TestShapeFollower : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QLocale::setDefault(QLocale::c());
        applyTheme(Theme::Light);
    }

    void onACoarseGrid()
    {
        Case c = sampleFilmCase();
        c.film.nodes = {193, 49};
        c.steady.stiffness = c.steady.sensitivities = true;
        c.steady.radii = {20e-3, 30e-3};
        const Case coarse = ShapeFollower::coarse(c);
        QCOMPARE(coarse.film.nodes, (std::array{65, 49}));
        QVERIFY(!coarse.steady.stiffness && !coarse.steady.sensitivities);
        QVERIFY(coarse.steady.radii.empty());
        QCOMPARE(coarse.disk.radius, c.disk.radius); // as F9 solves it
    }

    /// Ten positions while one is solved: the first and the last are.
    void theNewestReplacesTheWaiting()
    {
        auto solver = std::make_shared<Solver>();
        ShapeFollower follower(std::ref(*solver));
        QSignalSpy followed(&follower, &ShapeFollower::followed);
        Case c = sampleFilmCase();
        solver->held = true;
        for (int i = 0; i < 10; ++i) {
            c.surface.rails[0].recess[0] = (i + 1) * 1e-9;
            follower.follow(c);
        }
        QTRY_COMPARE(solver->count(), std::size_t(1));
        QVERIFY(follower.busy());
        solver->held = false;
        QTRY_COMPARE(followed.count(), 2);
        QCOMPARE(followed[0].front().value<SteadyResult>().minimumSpacing, 1e-9);
        QCOMPARE(followed[1].front().value<SteadyResult>().minimumSpacing, 10e-9);
        QCOMPARE(solver->starts, (std::vector<double>{0.0, 1e-9})); // each from the state before
        QCOMPARE(solver->most, 1);
        QVERIFY(!follower.busy());
    }

    void whatIsForgottenIsNotTold()
    {
        auto solver = std::make_shared<Solver>();
        ShapeFollower follower(std::ref(*solver));
        QSignalSpy followed(&follower, &ShapeFollower::followed);
        solver->held = true;
        follower.follow(sampleFilmCase());
        follower.follow(sampleFilmCase());
        follower.forget();
        QTRY_VERIFY(!follower.busy());
        QCOMPARE(followed.count(), 0);
        solver->held = false;
        follower.follow(sampleFilmCase());
        QTRY_COMPARE(followed.count(), 1);
    }

    /// The line above the plan: the change of a preview is that from the case on the same grid; after the gesture the
    /// case's own grid is solved; an impossible shape is told and not solved; undo is followed, too.
    void theLineFollows()
    {
        auto solver = std::make_shared<Solver>();
        QWidget window;
        QAction action;
        FilmWindow film(
            [solver](const Case& c, const SteadyCallback& callback) { return (*solver)(c, c, {}, callback); }, &action,
            &window, std::ref(*solver));
        Case c = sampleFilmCase();
        c.film.nodes = {193, 193};
        film.open(c);
        SurfacePage& page = *film.view()->shape();
        connect(&film, &FilmWindow::surfaceEdited, &film, [&](const AirBearingSurface& surface) {
            c.surface = surface;
            film.edit(c);
        });
        QVERIFY(page.flightText().contains(QStringLiteral("Not solved")));
        AirBearingSurface changed = c.surface;
        changed.rails[0].recess[0] = 151e-9;
        emit page.editor()->previewed(changed);
        QTRY_VERIFY(page.flightText().contains(QStringLiteral("<b>151.00</b> nm  +1.00")));
        QVERIFY(page.flightText().contains(QStringLiteral("preview")));
        QCOMPARE(solver->asked.back().film.nodes[0], 65);
        QCOMPARE(solver->count(), std::size_t(2));
        changed.rails[0].recess[0] = 152e-9;
        emit page.editor()->previewed(changed);
        QTRY_VERIFY(page.flightText().contains(QStringLiteral("+2.00")));
        QCOMPARE(solver->count(), std::size_t(3)); // the case itself is known

        AirBearingSurface impossible = changed;
        impossible.rails[0].points.resize(2);
        emit page.editor()->previewed(impossible);
        QVERIFY(page.flightText().contains(QStringLiteral("it needs three or more")));
        QVERIFY(page.flightText().contains(QStringLiteral("152.00"))); // the last good one

        emit page.editor()->edited(changed, QStringLiteral("change"), 0);
        QTRY_VERIFY(!page.flightText().contains(QStringLiteral("preview")));
        QCOMPARE(solver->asked.back().film.nodes[0], 193);
        QVERIFY(!film.stale());
        // As undo does.
        c.surface.rails[0].recess[0] = 150e-9;
        film.edit(c);
        QVERIFY(film.stale());
        QTRY_VERIFY(page.flightText().contains(QStringLiteral("150.00")));
        // A gesture that is given up while the case's own grid is solved: it is solved all the same.
        QTRY_VERIFY(!film.stale());
        c.surface.rails[0].recess[0] = 149e-9;
        film.edit(c);
        emit page.editor()->previewed(c.surface);
        QTRY_VERIFY(!film.stale());
        const std::size_t solved = solver->count();
        page.findChild<QCheckBox*>(QStringLiteral("follow"))->setChecked(false);
        emit page.editor()->previewed(changed);
        QCOMPARE(solver->count(), solved);
    }
};

TOUCHDOWN_TEST(TestShapeFollower)

} // namespace test_shape_follower

#include "test_shape_follower.moc"

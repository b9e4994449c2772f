// SPDX-License-Identifier: GPL-3.0-or-later
//
// The solutions of the film's part of the window: kept, chosen, compared, found again by undo.
#include <atomic>
#include <memory>
#include <thread>

#include <QAction>
#include <QLabel>
#include <QSignalSpy>
#include <QTest>

#include "core/simulation/static_state/field_difference.h"
#include "tests/support/test_program.h"
#include "tests/ui/named_widget.h"
#include "tests/ui/sample_slider.h"
#include "ui/calculation/progress_strip.h"
#include "ui/film/compare_page.h"
#include "ui/film/film_view.h"
#include "ui/film/film_window.h"
#include "ui/film/series_page.h"
#include "ui/film/surface_page.h"
#include "ui/lists/record_panel.h"
#include "ui/maps/field_map.h"
#include "ui/maps/field_sections.h"
#include "ui/maps/fields_view.h"
#include "ui/slider/attitude_table.h"

using namespace touchdown;

namespace test_film_solutions {

using Page = FilmView::Page;

class TestFilmSolutions : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void init()
    {
        solves_ = previews_ = 0;
        waiting_ = previewsWait_ = previewing_ = failing_ = false;
        hasFields_ = true;
        window_ = std::make_unique<QWidget>();
        film_ = new FilmWindow(
            [this](const Case& c, const SteadyCallback& callback) {
                SteadyResult result = sampleResult(c);
                while (waiting_ && callback({})) std::this_thread::yield();
                if (waiting_) result.status = SteadyStatus::Cancelled;
                result.minimumSpacing = (10.0 + ++solves_) * 1e-9;
                if (failing_) {
                    result.status = hasFields_ ? SteadyStatus::NotConverged : SteadyStatus::Failed;
                    result.message = "no flying attitude was found";
                    if (!hasFields_) result.pressure.clear();
                }
                return result;
            },
            new QAction(window_.get()), window_.get(),
            [this](const Case& c, const Case&, const SteadyResult&, const SteadyCallback& callback) {
                previewing_ = true;
                ++previews_;
                SteadyResult result = sampleResult(c);
                while (previewsWait_ && callback({})) std::this_thread::yield();
                result.minimumSpacing = 20e-9;
                previewing_ = false;
                return result;
            });
        case_ = sampleFilmCase();
        film_->open(case_);
    }

    void cleanup() { window_.reset(); }

    void theChosenOneIsShown()
    {
        solve();
        const Case first = case_;
        case_.surface.rails[1].recess[0] = 5e-9;
        film_->edit(case_);
        solve();
        QCOMPARE(film_->solutions().count(), 2);
        QCOMPARE(film_->result()->minimumSpacing, 12e-9);
        QVERIFY(!film_->stale());
        film_->panel()->choose(1);
        QCOMPARE(film_->result()->minimumSpacing, 11e-9);
        QVERIFY(film_->stale()); // of another shape than the one that is edited
        film_->edit(first);
        QVERIFY(!film_->stale());
    }

    /// No solver is needed where the list has the answer.
    void undoFindsItsSolution()
    {
        solve();
        const Case first = case_;
        case_.surface.rails[1].recess[0] = 5e-9;
        film_->edit(case_);
        solve();
        film_->edit(first);
        QCOMPARE(film_->result()->minimumSpacing, 11e-9);
        film_->edit(case_);
        QCOMPARE(film_->result()->minimumSpacing, 12e-9);
        QCOMPARE(solves_, 2);
        QVERIFY(!film_->controller().active());
        film_->open(first); // also where the case is opened again
        QCOMPARE(film_->result()->minimumSpacing, 11e-9);
    }

    /// Of any parameter, also while the other case is being solved: what is known is not replaced.
    void undoOfAParameterFindsItToo()
    {
        solve();
        const Case first = case_;
        case_.suspension.preload *= 2.0;
        film_->edit(case_);
        solve();
        film_->edit(first);
        QCOMPARE(film_->result()->minimumSpacing, 11e-9);
        QVERIFY(!film_->stale());

        case_.suspension.preload *= 2.0;
        film_->edit(case_);
        waiting_ = true;
        const QSignalSpy solved(film_, &FilmWindow::solved);
        film_->solve(case_, false);
        film_->edit(first);
        QTRY_COMPARE(solved.count(), 1);
        QCOMPARE(film_->result()->minimumSpacing, 11e-9);
        QVERIFY(!film_->stale());
    }

    /// What only a run uses, and a start at the state that was found.
    void whatARunUsesDoesNotMakeItStale()
    {
        solve();
        case_.diskSurface.kind = DiskSurfaceKind::Rough;
        case_.run.duration *= 2.0;
        case_.initial.state = InitialState::Static;
        case_.initial.heightOffset = 1e-9;
        film_->edit(case_);
        QVERIFY(!film_->stale());
        const Attitude found = film_->result()->attitude;
        case_.initial.pitch = 2.0 * found.pitch; // another start may lead to another balance
        film_->edit(case_);
        QVERIFY(film_->stale());
        case_.initial.nominalTrailingEdgeHeight = found.height;
        case_.initial.pitch = found.pitch;
        case_.initial.roll = found.roll;
        film_->edit(case_);
        QVERIFY(!film_->stale());
    }

    /// The reason stands before what is known of the shape before, until the shape is another one.
    void undoTakesTheReasonAway()
    {
        SurfacePage* shape = film_->view()->shape();
        const QString unsolved = shape->flightText();
        const auto cross = [&] {
            AirBearingSurface crossing = case_.surface;
            std::swap(crossing.rails[1].points[0], crossing.rails[1].points[1]);
            emit shape->previewed(crossing);
            QVERIFY2(shape->flightText().contains(QStringLiteral("crosses itself")), qPrintable(shape->flightText()));
            Case crossed = case_;
            crossed.surface = crossing;
            film_->edit(crossed);
            QVERIFY(shape->flightText().contains(QStringLiteral("crosses itself")));
            film_->edit(case_);
        };
        cross();
        QCOMPARE(shape->flightText(), unsolved);
        solve();
        const QString solved = shape->flightText();
        QVERIFY(solved.contains(QStringLiteral("<b>11.00</b>")));
        cross();
        QCOMPARE(shape->flightText(), solved);
    }

    /// A gesture that ends where it began, or is given up, leaves the number of the case's own grid, also while the
    /// coarse grid still solves: 11 nm, where previews find 20 nm.
    void aGestureThatChangesNothingLeavesTheNumber_data()
    {
        QTest::addColumn<bool>("solving");
        QTest::newRow("after a preview") << false;
        QTest::newRow("while one is solved") << true;
    }
    void aGestureThatChangesNothingLeavesTheNumber()
    {
        QFETCH(const bool, solving);
        SurfacePage* shape = film_->view()->shape();
        solve();
        const QString confirmed = shape->flightText();
        QVERIFY(confirmed.contains(QStringLiteral("<b>11.00</b>")));
        AirBearingSurface dragged = case_.surface;
        for (RailPoint& point : dragged.rails[1].points) point.x += 1e-6;
        emit shape->editor()->previewed(dragged);
        QTRY_VERIFY(shape->flightText().contains(QStringLiteral("preview")));
        if (solving) {
            previewsWait_ = true;
            const int before = previews_;
            dragged.rails[1].recess[0] += 1e-9;
            emit shape->editor()->previewed(dragged);
            QTRY_COMPARE(previews_, before + 1);
        }
        emit shape->editor()->previewed(case_.surface);
        QCOMPARE(shape->flightText(), confirmed);
        QTRY_VERIFY(!previewing_);
        QCoreApplication::processEvents();
        QCOMPARE(shape->flightText(), confirmed);
        QVERIFY(!film_->stale());
        QCOMPARE(solves_, 1);
        previewsWait_ = false; // the next gesture is followed
        emit shape->editor()->previewed(dragged);
        QTRY_VERIFY(shape->flightText().contains(QStringLiteral("preview")));
    }

    /// An impossible shape shows why, and no number of a shape that was solved meanwhile.
    void aPreviewOfAnotherShapeIsForgotten()
    {
        SurfacePage* shape = film_->view()->shape();
        solve();
        AirBearingSurface dragged = case_.surface;
        dragged.rails[1].recess[0] += 1e-9;
        emit shape->editor()->previewed(dragged);
        QTRY_VERIFY(shape->flightText().contains(QStringLiteral("preview")));
        previewsWait_ = true;
        const int before = previews_;
        dragged.rails[1].recess[0] += 1e-9;
        emit shape->editor()->previewed(dragged);
        QTRY_COMPARE(previews_, before + 1);
        std::swap(dragged.rails[1].points[0], dragged.rails[1].points[1]);
        emit shape->editor()->previewed(dragged);
        const QString why = shape->flightText();
        QVERIFY(why.contains(QStringLiteral("crosses itself")));
        QTRY_VERIFY(!previewing_);
        QCoreApplication::processEvents();
        QCOMPARE(shape->flightText(), why);
    }

    /// The change is that of the edit which made the shape, after undo and redo, too; the shape that was opened has
    /// none.
    void theChangeFollowsUndo()
    {
        SurfacePage* shape = film_->view()->shape();
        solve();
        const Case first = case_;
        const QString opened = shape->flightText();
        std::vector<std::pair<Case, QString>> edits;
        for (int i = 0; i < 3; ++i) {
            case_.surface.rails[1].recess[0] += 5e-9;
            film_->edit(case_);
            solve(); // 12, 13, 14 nm
            QVERIFY(shape->flightText().contains(QStringLiteral("  +1.00")));
            edits.emplace_back(case_, shape->flightText());
        }
        for (const int at : {1, 0, 1, 2}) {
            film_->edit(edits[std::size_t(at)].first);
            QCOMPARE(shape->flightText(), edits[std::size_t(at)].second);
        }
        film_->edit(first);
        QCOMPARE(shape->flightText(), opened);
        QCOMPARE(solves_, 4);
        solve(); // once more: the former edits are no part of it
        QVERIFY(!shape->flightText().contains(QStringLiteral("  +")));
        film_->open(edits[1].first); // as it is saved
        QVERIFY(shape->flightText().contains(QStringLiteral("<b>13.00</b>")));
        QVERIFY(!shape->flightText().contains(QStringLiteral("  +")));
    }

    /// Undo of a shape that did not fly shows the one before as it was; redo shows the failure, without another
    /// solution in the list.
    void aFailureFollowsUndo()
    {
        SurfacePage* shape = film_->view()->shape();
        const QLabel* state = namedWidget<QLabel>(*film_->progress(), QStringLiteral("State of the static solution"));
        solve();
        const Case first = case_;
        const QString flying = shape->flightText(), converged = state->text();
        const QSignalSpy changed(film_, &FilmWindow::shownChanged);
        for (const bool hasFields : {true, false}) {
            case_ = first;
            case_.surface.rails[1].recess[0] += hasFields ? 5e-9 : 6e-9;
            film_->edit(case_);
            failing_ = true;
            hasFields_ = hasFields;
            solve();
            failing_ = false;
            const QString failed = state->text();
            QVERIFY(failed != converged);
            QVERIFY(film_->solvedAsEdited());
            const int listed = film_->solutions().count(), solved = solves_;
            const qsizetype before = changed.count();
            film_->edit(first);
            QVERIFY(changed.count() > before);
            QCOMPARE(shape->flightText(), flying);
            QCOMPARE(state->text(), converged);
            QVERIFY(!film_->stale() && film_->result()->status == SteadyStatus::Converged);
            QVERIFY(!film_->solvedAsEdited());
            QCOMPARE(solves_, solved);
            if (!hasFields) continue; // it is not in the list
            film_->edit(case_);
            QCOMPARE(film_->result()->status, SteadyStatus::NotConverged);
            QVERIFY(!film_->stale() && !film_->controller().active());
            QVERIFY(shape->flightText() != flying);
            QCOMPARE(state->text(), failed);
            QCOMPARE(film_->solutions().count(), listed);
            QCOMPARE(solves_, solved);
            film_->edit(first);
        }
    }

    /// A shape that was not solved has no outcome, whatever became of the one before.
    void anEditHasNoOutcome()
    {
        const QLabel* state = namedWidget<QLabel>(*film_->progress(), QStringLiteral("State of the static solution"));
        const QString ready = state->text();
        failing_ = true;
        solve();
        QVERIFY(state->text() != ready);
        case_.suspension.preload *= 2.0;
        film_->edit(case_);
        QCOMPARE(state->text(), ready);
    }

    /// What undo brings back is among the solutions side by side, as what is solved is.
    void comparesWhatIsShown()
    {
        solve();
        const Case first = case_;
        for (int i = 0; i < 4; ++i) {
            case_.suspension.preload *= 1.1;
            film_->edit(case_);
            solve();
        }
        const auto columns = [&] { return film_->view()->comparison()->comparison().columns; };
        QCOMPARE(columns().size(), SolutionsModel::mostByItself + 1);
        QVERIFY(columns()[0].startsWith(QStringLiteral("1 ")) && columns()[1].startsWith(QStringLiteral("3 ")));
        case_ = first;
        case_.suspension.preload *= 1.1;
        film_->edit(case_); // as solution 2
        QCOMPARE(columns().size(), SolutionsModel::mostByItself + 1);
        QVERIFY(columns()[1].startsWith(QStringLiteral("2 ")));
    }

    void deletingTheShownOneShowsAnother()
    {
        solve();
        solve();
        film_->solutions().remove(1);
        QCOMPARE(film_->result()->minimumSpacing, 11e-9);
        film_->solutions().remove(0);
        QVERIFY(!film_->result());
        QVERIFY(film_->attitude()->sections().empty());
        QVERIFY(film_->view()->maps()->map()->empty());
        QVERIFY(film_->view()->comparison()->comparison().columns.isEmpty());
    }

    void theLineTellsTheDifferenceToTheBaseline()
    {
        solve();
        film_->solutions().setBaseline(1);
        solve();
        QVERIFY2(film_->view()->shape()->flightText().contains(QStringLiteral("<b>12.00</b> nm  +1.00")),
                 qPrintable(film_->view()->shape()->flightText()));
        QVERIFY(film_->view()->shape()->flightText().contains(QStringLiteral("<b>100.0</b> µrad  0.0"))); // no sign
        film_->solutions().setBaseline(-1);
        QVERIFY2(!film_->view()->shape()->flightText().contains(QStringLiteral("+1.00")),
                 qPrintable(film_->view()->shape()->flightText()));
        film_->solutions().setBaseline(1);
        case_.slider.length *= 1.1; // another slider
        film_->open(case_);
        solve();
        QVERIFY2(film_->view()->shape()->flightText().contains(QStringLiteral("<b>13.00</b> nm (")),
                 qPrintable(film_->view()->shape()->flightText()));
    }

    void theMapsSubtractTheBaseline()
    {
        film_->view()->resize(900, 700);
        window_->show();
        solve();
        const Case first = case_;
        const SteadyResult base = *film_->result();
        case_.surface.rails[1].recess[0] = 5e-9;
        film_->edit(case_);
        solve();
        film_->view()->setPage(Page::Gap);
        QVERIFY(!film_->view()->difference()->isVisible());
        film_->solutions().setBaseline(1);
        QVERIFY(film_->view()->difference()->isVisible());
        QCOMPARE(film_->view()->difference()->text().remove(QLatin1Char('&')), QStringLiteral("Minus 1"));
        film_->view()->difference()->click();
        const FieldDifference expected = fieldDifference(case_, *film_->result(), first, base);
        const FieldMap& map = *film_->view()->maps()->map();
        QCOMPARE(map.title(), QStringLiteral("Difference of gaps"));
        for (const std::size_t cell : {std::size_t(0), std::size_t(999)}) QCOMPARE(map.value(cell), expected.gap[cell]);
        film_->view()->setPage(Page::Pressure);
        QCOMPARE(map.value(99), expected.pressure[99]);
        film_->panel()->choose(1); // the baseline minus itself is not offered
        QVERIFY(!film_->view()->difference()->isVisible());
        QCOMPARE(map.title(), QStringLiteral("Pressure above ambient"));
    }

    void sectionsOfComparedSolutionsLieOverEachOther()
    {
        solve();
        solve();
        film_->view()->setPage(Page::Gap);
        const auto& curves = film_->view()->maps()->sections()->alongX()->curves();
        QCOMPARE(curves.size(), std::size_t{2});
        QCOMPARE(curves[0].legend, QStringLiteral("1"));
        QCOMPARE(curves[1].legend, QStringLiteral("2")); // the shown one is drawn last
        film_->solutions().setData(film_->solutions().index(0), Qt::Unchecked, Qt::CheckStateRole);
        QCOMPARE(film_->view()->maps()->sections()->alongX()->curves().size(), std::size_t{1});
        QCOMPARE(film_->view()->comparison()->comparison().columns.size(), 1);
    }

    /// States of a series are kept, but nothing else is shown for them.
    void aSeriesIsKept()
    {
        solve();
        Case other = case_;
        other.disk.radius *= 1.1;
        emit film_->view()->series()->solved(other, sampleResult(other));
        QCOMPARE(film_->solutions().count(), 2);
        QCOMPARE(film_->result()->minimumSpacing, 11e-9);
        QVERIFY(!film_->solutions().listed(1).shown);
        QVERIFY(film_->solutions().listed(1).name.startsWith(QStringLiteral("radius")));
    }

private:
    void solve()
    {
        const QSignalSpy solved(film_, &FilmWindow::solved);
        film_->solve(case_, false);
        QTRY_COMPARE(solved.count(), 1);
    }

    std::unique_ptr<QWidget> window_;
    FilmWindow* film_ = nullptr;
    Case case_;
    int solves_ = 0;
    std::atomic<bool> waiting_ = false;                    // the solver goes on until it is stopped
    std::atomic<bool> failing_ = false, hasFields_ = true; // it finds no state
    std::atomic<int> previews_ = 0;                        // that were begun
    std::atomic<bool> previewsWait_ = false;               // as the solver, on the coarse grid
    std::atomic<bool> previewing_ = false;
};

TOUCHDOWN_TEST(TestFilmSolutions)

} // namespace test_film_solutions

#include "test_film_solutions.moc"

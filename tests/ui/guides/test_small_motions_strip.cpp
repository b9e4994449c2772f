// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guides/small_motions_strip.h"

#include <algorithm>
#include <memory>

#include <QSettings>
#include <QSignalSpy>
#include <QtTest>

#include "core/case/parameters.h"
#include "core/case_files/case_file.h"
#include "core/case_files/case_reader.h"
#include "core/simulation/small_motions/linear_state.h"
#include "tests/support/test_program.h"
#include "tests/ui/fake_workbench.h"
#include "ui/guides/live_runs.h"
#include "ui/guides/live_values.h"
#include "ui/guides/marked_slider.h"

using namespace touchdown;

namespace test_small_motions_strip {

constexpr int longest = 60000; // for what takes some seconds on an idle machine [ms]

/// A sample slider in contact at rest, on few cells.
Case touching()
{
    Case c = openCase("fig07_mu_2").value;
    c.film.nodes = {49, 49};
    c.initial.branch = ContactBranch::TakeOff;
    c.initial.heightOffset = 0.02e-9;
    c.run.duration = 20e-6;
    return c;
}

const LiveValue* valueOf(const std::vector<LiveValue>& values, const char* key)
{
    const auto found = std::ranges::find_if(values, [key](const LiveValue& value) { return value.keys[0] == key; });
    return found == values.end() ? nullptr : &*found;
}

class TestSmallMotionsStrip : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QCoreApplication::setOrganizationName(QStringLiteral("touchdown"));
        QCoreApplication::setApplicationName(QStringLiteral("test_small_motions_strip"));
    }
    void init()
    {
        QSettings().clear();
        bench_ = std::make_unique<test::FakeWorkbench>(QStringLiteral("fig07_mu_2"));
        bench_->window().show();
        live_ = std::make_unique<LiveRuns>(*bench_, nullptr);
        action_ = std::make_unique<QAction>();
        action_->setCheckable(true);
        guide_ = new QWidget(&bench_->window());
        guide_->hide();
        strip_ = new SmallMotionsStrip(*bench_, *live_, *action_, *guide_);
        bench_->edits().setAll(touching(), "short");
    }
    void cleanup()
    {
        live_.reset(); // its runs end first
        bench_.reset();
        action_.reset();
    }

    void isThereForALinearFilm()
    {
        QVERIFY(strip_->isHidden());
        strip_->makeLinear(true);
        QVERIFY(strip_->isVisible());
        QCOMPARE(bench_->edits().value().film.motion, FilmMotion::Linear);
        QVERIFY(bench_->controller().active());
        QVERIFY(!strip_->full()->isEnabled());
        QVERIFY(action_->isChecked());
        guide_->show();
        strip_->showState();
        QVERIFY(strip_->isHidden());
        guide_->hide();
        bench_->setPage(Workbench::Page::Studies);
        strip_->showState();
        QVERIFY(strip_->isHidden());
        bench_->setPage(Workbench::Page::Run);
        strip_->showState();
        QVERIFY(strip_->isVisible());
        action_->trigger();
        QVERIFY(strip_->isHidden() && !action_->isChecked());
        QCOMPARE(bench_->edits().value().film.motion, FilmMotion::Full);
        bench_->edits().undoStack().undo();
        QVERIFY(strip_->isVisible());
        bench_->files().leaveUnsaved();
        bench_->files().openNow("film_pico");
        QVERIFY(strip_->isHidden());
        bench_->controller().stopAndWait();
    }

    /// A start far away would end at once.
    void startsNearTheStaticState()
    {
        const auto madeLinear = [this](const Case& c) {
            bench_->edits().setAll(c, "start");
            strip_->makeLinear(true);
            bench_->controller().stopAndWait();
            return bench_->edits().value();
        };
        Case c = touching();
        Case expected = c;
        expected.film.motion = FilmMotion::Linear;
        QCOMPARE(madeLinear(c), expected); // a small start stays
        for (const auto& far : {+[](Case& each) { each.initial.state = InitialState::Given; },
                                +[](Case& each) { each.initial.heightOffset = 6.8e-9; },
                                +[](Case& each) { each.initial.pitchOffset = 1e-6; },
                                +[](Case& each) { each.initial.verticalVelocity = -1e-3; }}) {
            c = touching();
            far(c);
            const Case made = madeLinear(c);
            QCOMPARE(made.initial.state, InitialState::Static);
            QCOMPARE(made.initial.heightOffset, 0.1e-9);
            QCOMPARE(made.initial.pitchOffset, 0.0);
            QCOMPARE(made.initial.verticalVelocity, 0.0);
        }
    }

    /// What the case uses, with its own value between the ends; every end is a value that the case may have.
    void offersWhatTheCaseUses()
    {
        for (const SampleCase& sample : sampleCases()) {
            const Case c = openCase(sample.name).value;
            if (c.model != ModelKind::Film) continue;
            const std::vector<LiveValue> values = valuesOfSmallMotions(c);
            QVERIFY2(!values.empty() && values.size() <= 5, sample.name.c_str());
            for (const LiveValue& value : values) {
                const Parameter& parameter = *findParameter(value.keys[0]);
                QVERIFY(parameter.used(c));
                const double own = numberOf(parameter, c);
                QVERIFY2(value.from <= own && own <= value.until && value.from < value.until, parameter.key.c_str());
                for (const double end : {value.from, value.until}) {
                    Case moved = c;
                    QVERIFY2(!setFromNumber(moved, parameter, end), parameter.key.c_str());
                    QVERIFY2(checkCombinations(moved).empty(), (sample.name + " " + parameter.key).c_str());
                }
            }
        }
        const std::vector<LiveValue> values = valuesOfSmallMotions(touching());
        QVERIFY(valueOf(values, "ono_yamane.friction") && valueOf(values, "ono_yamane.meniscus_force"));
        QVERIFY(!valueOf(values, "disk.surface.wave_amplitudes"));
        QCOMPARE(valueOf(values, "ono_yamane.friction")->until, 6.0);
        QVERIFY(valueOf(values, "slider.mass")->from > 0.0);
    }

    /// While a value is moved a run about the state that is known; then one about its own, in the same place.
    void runsFollowTheSliders()
    {
        strip_->makeLinear(true);
        QTRY_VERIFY_WITH_TIMEOUT(!bench_->runWindow().runUnderWay(), longest);
        QCOMPARE(bench_->runs().count(), 1);
        QVERIFY(strip_->text().contains("run 1") && strip_->text().contains("%"));
        QVERIFY(strip_->full()->isEnabled());

        const LiveValue friction = *valueOf(valuesOfSmallMotions(touching()), "ono_yamane.friction");
        live_->move(friction, "1.9");
        QVERIFY(live_->busy() && !live_->finds());
        QTRY_COMPARE_WITH_TIMEOUT(bench_->runs().count(), 2, longest);
        const Case& now = bench_->edits().value();
        QCOMPARE(bench_->runs().record(1).value, now);
        QCOMPARE(bench_->runs().record(1).note, QString("preview"));
        QVERIFY(strip_->text().contains("preview"));
        QVERIFY(!hasLinearState(now));
        live_->settle();
        QVERIFY(live_->finds());
        QVERIFY(strip_->text().contains("finding"));
        QTRY_VERIFY_WITH_TIMEOUT(!live_->busy(), longest);
        QVERIFY(hasLinearState(now));
        QCOMPARE(bench_->runs().count(), 2);
        QVERIFY(bench_->runs().record(1).note.isEmpty());
        QCOMPARE(bench_->runs().record(1).caseText, bench_->files().wholeText());
        QVERIFY(strip_->text().contains("run 2"));

        // A damper keeps the state: its run is no preview.
        live_->move({{"suspension.damping"}, 0.0, 0.02, {}}, "0.01 N s/m");
        QTRY_COMPARE_WITH_TIMEOUT(bench_->runs().count(), 3, longest);
        QVERIFY(bench_->runs().record(2).note.isEmpty());
        live_->settle();
        QVERIFY(!live_->finds());
    }

    /// A value that is moved before any state is known: the first run finds one.
    void theFirstMovementFindsTheState()
    {
        Case c = touching();
        c.film.motion = FilmMotion::Linear;
        c.slider.thickness *= 1.01; // no other test has its film
        bench_->edits().setAll(c, "linear");
        QVERIFY(strip_->isVisible());
        QVERIFY(!strip_->full()->isEnabled());
        live_->move({{"ono_yamane.friction"}, 0.0, 6.0, {}}, "1.8");
        QVERIFY(live_->finds());
        QVERIFY(strip_->text().contains("finding"));
        QTRY_COMPARE_WITH_TIMEOUT(bench_->runs().count(), 1, longest);
        QVERIFY(hasLinearState(bench_->edits().value()));
        live_->settle();
        QTRY_VERIFY_WITH_TIMEOUT(!live_->busy(), longest);
        QCOMPARE(bench_->runs().count(), 1);
        QVERIFY(bench_->runs().record(0).note.isEmpty());
    }

    /// The same case with the film solved in each step, beside it.
    void repeatsWithTheFullFilm()
    {
        strip_->makeLinear(true);
        QTRY_VERIFY_WITH_TIMEOUT(!bench_->runWindow().runUnderWay(), longest);
        strip_->full()->click();
        QVERIFY(!strip_->full()->isEnabled());
        QTRY_VERIFY_WITH_TIMEOUT(!bench_->runWindow().runUnderWay(), longest);
        QCOMPARE(bench_->runs().count(), 2);
        const RunRecord& full = bench_->runs().record(1);
        QCOMPARE(full.value.film.motion, FilmMotion::Full);
        Case same = full.value;
        same.film.motion = FilmMotion::Linear;
        QCOMPARE(same, bench_->edits().value());
        QCOMPARE(parseCase(full.caseText, "full").value.film.motion, FilmMotion::Full);
        QVERIFY(bench_->runs().record(0).shown && full.shown);
        QVERIFY(strip_->full()->isEnabled());
    }

private:
    std::unique_ptr<test::FakeWorkbench> bench_;
    std::unique_ptr<LiveRuns> live_;
    std::unique_ptr<QAction> action_;
    QWidget* guide_ = nullptr; // of the window, as the strip
    SmallMotionsStrip* strip_ = nullptr;
};

TOUCHDOWN_TEST(TestSmallMotionsStrip)

} // namespace test_small_motions_strip

#include "test_small_motions_strip.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/solutions_model.h"

#include <QAbstractItemModelTester>
#include <QClipboard>
#include <QFile>
#include <QGuiApplication>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTextBrowser>
#include <QWidget>

#include "core/physics/film/gaps/film_gaps.h"
#include "core/physics/slider/recess.h"
#include "tests/support/test_program.h"
#include "tests/ui/sample_slider.h"
#include "ui/film/compare_page.h"
#include "ui/film/solution_files.h"
#include "ui/slider/attitude_sections.h"

using namespace touchdown;

namespace test_solutions_model {

class TestSolutionsModel : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void namesWhatChanged()
    {
        SolutionsModel model;
        const QAbstractItemModelTester tester(&model);
        Case c = sampleFilmCase();
        const auto name = [&] {
            SteadyResult result = sampleResult(c);
            result.minimumSpacing = 12.004e-9;
            result.discretisationError.minimumSpacing = 0.11e-9; // the digits end where it begins
            return model.record(model.rowOf(model.add(c, result))).name;
        };
        QCOMPARE(name(), QStringLiteral("A slider of our own"));
        for (RailPoint& point : c.surface.rails[1].points) point.x += 2e-6;
        QCOMPARE(name(), QStringLiteral("rail 2: +2, 0\u00a0µm"));
        QCOMPARE(name(), QStringLiteral("as solution 2"));
        c.disk.speed *= 2.0;
        const QString both = name(); // the newest first
        QVERIFY2(both.startsWith(QStringLiteral("disk speed")) &&
                     both.endsWith(QStringLiteral("rail 2: +2, 0\u00a0µm")),
                 qPrintable(both));
        c.title = "Another one";
        QCOMPARE(name(), QStringLiteral("Another one"));
        model.remove(0);
        QCOMPARE(model.record(0).name, QStringLiteral("rail 2: +2, 0\u00a0µm")); // it keeps its name
        QCOMPARE(model.index(0).data(RecordList::ResultRole).toString(), QStringLiteral("12.00\u00a0nm"));
    }

    /// An edit is named by the first shape, as a comparison reads it, not by the edit before.
    void namesWhatChangedAfterAnUndo()
    {
        SolutionsModel model;
        const Case first = sampleFilmCase();
        const auto name = [&](std::size_t rail, double shift) {
            Case c = first;
            for (RailPoint& point : c.surface.rails[rail].points) point.x += shift;
            return model.record(model.rowOf(model.add(c, sampleResult(c)))).name;
        };
        name(0, 0.0);
        QCOMPARE(name(0, 4e-6), QStringLiteral("rail 1: +4, 0\u00a0µm"));
        QCOMPARE(name(1, 1e-6), QStringLiteral("rail 2: +1, 0\u00a0µm"));
        QCOMPARE(name(1, 3e-6), QStringLiteral("rail 2: +3, 0\u00a0µm"));
        QCOMPARE(name(0, 0.0), QStringLiteral("as solution 1"));
    }

    /// A shape that was moved before the first solution is not taken for the one that was opened.
    void namesFollowTheOpenedCase()
    {
        SolutionsModel model;
        const Case opened = sampleFilmCase();
        model.setOpened(opened);
        const auto name = [&](std::size_t rail, double shift) {
            Case c = opened;
            for (RailPoint& point : c.surface.rails[rail].points) point.x += shift;
            return model.record(model.rowOf(model.add(c, sampleResult(c)))).name;
        };
        QCOMPARE(name(0, -22e-6), QStringLiteral("A slider of our own: rail 1: −22, 0 µm"));
        QCOMPARE(name(0, 0.0), QStringLiteral("A slider of our own"));
        QCOMPARE(name(0, 0.0), QStringLiteral("as solution 2"));
        QCOMPARE(name(1, 1e-6), QStringLiteral("rail 2: +1, 0 µm"));
        model.setBaseline(1);
        QVERIFY(name(1, 2e-6).contains(QStringLiteral("rail 1"))); // from the moved shape
    }

    void findsTheSolutionOfACase()
    {
        SolutionsModel model;
        Case c = sampleFilmCase();
        QVERIFY(!model.of(c));
        SteadyResult failed = sampleResult(c);
        failed.status = SteadyStatus::NotConverged;
        const int failure = model.add(c, failed);
        QVERIFY(!model.of(c));
        QCOMPARE(model.failureOf(c)->number, failure);
        Case further = c; // from where the search gave up another one may find a state
        further.initial.nominalTrailingEdgeHeight = failed.attitude.height;
        further.initial.pitch = failed.attitude.pitch;
        further.initial.roll = failed.attitude.roll;
        QVERIFY(!model.failureOf(further));
        further = c;
        further.run.duration *= 2.0;
        QVERIFY(model.failureOf(further));
        const int number = model.add(c, sampleResult(c));
        Case held = c;
        held.steady.fixedAttitude = true;
        model.add(held, sampleResult(held));
        c.title = "a name is no difference";
        QCOMPARE(model.of(c)->number, number);
        QCOMPARE(model.of(held)->number, number + 1);
        c.surface.rails[0].recess[0] += 1e-12;
        QVERIFY(!model.of(c));
    }

    /// Gaps take more memory than fields.
    void theNewestAloneKeepsItsGaps()
    {
        SolutionsModel model;
        const Case c = sampleFilmCase();
        SteadyResult result = sampleResult(c);
        result.gaps = std::make_shared<const FilmGaps>(Recess(c.surface, c.slider.length, c.slider.width), result.grid);
        for (int i = 0; i < 3; ++i) model.add(c, result);
        QVERIFY(!model.record(0).result.gaps && !model.record(1).result.gaps && model.record(2).result.gaps);
        QCOMPARE(model.record(0).result.pressure, result.pressure);
        QVERIFY(model.restOf(c)->state.gaps == result.gaps);
    }

    /// The newest is compared with the first one and at most two others that nobody chose.
    void comparesAFew()
    {
        SolutionsModel model;
        const Case c = sampleFilmCase();
        for (int i = 0; i < 5; ++i) model.add(c, sampleResult(c));
        const auto numbers = [&model] {
            std::vector<int> list;
            for (const SolutionRecord* each : model.compared()) list.push_back(each->number);
            return list;
        };
        QCOMPARE(numbers(), (std::vector<int>{1, 3, 4, 5}));
        model.setBaseline(2); // is compared without its box
        QCOMPARE(numbers(), (std::vector<int>{1, 2, 3, 4, 5}));
        model.setData(model.index(0), Qt::Unchecked, Qt::CheckStateRole);
        model.setData(model.index(3), Qt::Unchecked, Qt::CheckStateRole);
        QCOMPARE(numbers(), (std::vector<int>{2, 3, 5}));
        model.remove(1);
        QCOMPARE(numbers(), (std::vector<int>{3, 5}));
        QCOMPARE(model.baseline(), -1);
    }

    /// The one that undo brings back is compared, too, unless its box was unchecked by the user.
    void comparesWhatComesBack()
    {
        SolutionsModel model;
        const Case c = sampleFilmCase();
        for (int i = 0; i < 5; ++i) model.add(c, sampleResult(c));
        const auto numbers = [&model] {
            std::vector<int> list;
            for (const SolutionRecord* each : model.compared()) list.push_back(each->number);
            return list;
        };
        model.compareByItself(2);
        QCOMPARE(numbers(), (std::vector<int>{1, 2, 4, 5}));
        model.compareByItself(5);
        QCOMPARE(numbers(), (std::vector<int>{1, 2, 4, 5}));
        model.setData(model.index(1), Qt::Unchecked, Qt::CheckStateRole);
        model.compareByItself(2);
        QCOMPARE(numbers(), (std::vector<int>{1, 4, 5}));
    }

    /// A search that found no state is marked over its numbers, in the list and in what is copied.
    void marksWhatDidNotConverge()
    {
        SolutionsModel model;
        const Case c = sampleFilmCase();
        SteadyResult lost = sampleResult(c);
        lost.status = SteadyStatus::NotConverged;
        lost.minimumSpacing *= 2.0;
        model.add(c, sampleResult(c));
        model.add(c, lost);
        const SolutionComparison all = comparisonOf(model.compared(), -1);
        QCOMPARE(all.states, (QStringList{QString(), notFoundText(lost)}));
        QVERIFY(!notFoundText(lost).isEmpty());
        for (const int baseline : {1, 2}) // neither has a difference to the other
            for (const ComparedRow& row : comparisonOf(model.compared(), baseline).rows)
                QVERIFY2(row.differences.join(QString()).isEmpty(), qPrintable(row.name));
        ComparePage page;
        page.setSolutions(model.compared(), -1);
        page.copy();
        QVERIFY(QGuiApplication::clipboard()->text().contains(QStringLiteral("\t\t") + notFoundText(lost)));
        QVERIFY(page.findChild<QTextBrowser*>()->toPlainText().contains(notFoundText(lost)));
        QVERIFY(model.index(1).data(RecordList::FailedRole).toBool());
        QVERIFY(model.index(1).data(RecordList::ChangesRole).toString().startsWith(QStringLiteral("last step")));
        const QString copied = sectionsAsText(attitudeSections(c, lost));
        QVERIFY2(copied.section(QLatin1Char('\n'), 0, 0).startsWith(QStringLiteral("Not converged")),
                 qPrintable(copied));
        QVERIFY(sectionsAsText(attitudeSections(c, sampleResult(c))).startsWith(QStringLiteral("Attitude")));
    }

    /// A change is printed with the decimals of its value, and with up to two more where these show less than two
    /// digits of it. Four digits of a stiffness, be it 2.5e6 N/m = 2.500 mN/nm or 0.08 N m/rad.
    void digitsOfChanges()
    {
        SolutionsModel model;
        const Case c = sampleFilmCase();
        SteadyResult first = sampleResult(c), second = first;
        first.discretisationError.roll = second.discretisationError.roll = 11e-6;
        first.attitude.roll = -1.694e-6;
        second.attitude.roll = -1.994e-6;
        second.minimumSpacing = first.minimumSpacing + 4e-15;
        model.add(c, first);
        model.add(c, second);
        const auto row = [&](const QString& name) {
            for (const ComparedRow& each : comparisonOf(model.compared(), -1).rows)
                if (each.name == name) return each;
            return ComparedRow();
        };
        QCOMPARE(row(QStringLiteral("Roll")).differences.back(), QStringLiteral("\u22120.30"));
        QCOMPARE(row(QStringLiteral("Minimum spacing")).differences.back(), QStringLiteral("0.00"));
        QCOMPARE(row(QStringLiteral("Vertical stiffness")).values.front(), QStringLiteral("2.500\u00a0mN/nm"));
        QCOMPARE(row(QStringLiteral("Roll stiffness")).values.front(), QStringLiteral("0.08000\u00a0N·m/rad"));
    }

    /// What the user chose is not taken back by the next solution.
    void comparesWhatIsChecked()
    {
        SolutionsModel model;
        const Case c = sampleFilmCase();
        for (int i = 0; i < 4; ++i) model.add(c, sampleResult(c));
        for (int row = 0; row < 4; ++row) model.setData(model.index(row), Qt::Checked, Qt::CheckStateRole);
        model.add(c, sampleResult(c));
        QCOMPARE(model.compared().size(), std::size_t{5});
    }

    void longListsOfChangesAreCut()
    {
        SolutionsModel model;
        Case c = sampleFilmCase();
        model.add(c, sampleResult(c));
        for (std::size_t i = 0; i < 5; ++i) c.surface.rails[3].points[i].x += 1e-6 * double(i + 1);
        QCOMPARE(model.record(model.rowOf(model.add(c, sampleResult(c)))).name.count(QStringLiteral(": +")), 3);
        QVERIFY(model.record(1).name.endsWith(QStringLiteral("and 2 more")));
    }

    /// Three fields of 5 million cells are 15 million values: three solutions are more than 33.5 million.
    void theOldestLosesItsFields()
    {
        SolutionsModel model;
        const Case c = sampleFilmCase();
        SteadyResult large = sampleResult(c);
        for (std::vector<double>* field : {&large.pressure, &large.gap, &large.recess}) field->assign(5'000'000, 1.0);
        for (int i = 0; i < 3; ++i) model.add(c, large);
        QVERIFY(model.record(0).fieldsDropped);
        QVERIFY(model.record(0).result.gap.empty());
        QCOMPARE(model.record(0).result.minimumSpacing, large.minimumSpacing);
        QVERIFY(!model.record(1).fieldsDropped && !model.record(2).fieldsDropped);
        const QTemporaryDir folder;
        QVERIFY(saveSolution(model.record(0), folder.filePath(QStringLiteral("a.h5")))
                    .contains(QStringLiteral("given up to save memory")));
    }

    /// Fields of solutions that are not compared go first, also those that are newer.
    void comparedFieldsAreKept()
    {
        SolutionsModel model;
        const Case c = sampleFilmCase();
        SteadyResult large = sampleResult(c);
        for (std::vector<double>* field : {&large.pressure, &large.gap, &large.recess}) field->assign(5'000'000, 1.0);
        model.add(c, large);
        model.add(c, large, {}, false);
        model.add(c, large, {}, false);
        QVERIFY(!model.record(0).fieldsDropped && model.record(1).fieldsDropped && !model.record(2).fieldsDropped);
    }

    void tellsDifferences()
    {
        SolutionsModel model;
        Case c = sampleFilmCase();
        SteadyResult first = sampleResult(c), second = first;
        first.minimumSpacing = 10.21e-9;
        first.discretisationError.minimumSpacing = 0.1e-9;
        second.minimumSpacing = 9.9e-9;
        second.attitude.pitch = first.attitude.pitch + 1.5e-6;
        second.interestSpacing = {};
        model.add(c, first);
        c.surface.rails[0].recess[0] += 10e-9;
        model.add(c, second);
        const SolutionComparison all = comparisonOf(model.compared(), -1);
        QCOMPARE(all.columns.size(), 2);
        QCOMPARE(all.base, 0);
        const auto row = [&all](const QString& name) {
            for (const ComparedRow& each : all.rows)
                if (each.name == name) return each;
            return ComparedRow();
        };
        const ComparedRow spacing = row(QStringLiteral("Minimum spacing"));
        QCOMPARE(spacing.values.front(), QStringLiteral("10.21\u00a0±\u00a00.10\u00a0nm"));
        QCOMPARE(spacing.differences, (QStringList{QString(), QStringLiteral("\u22120.31")}));
        QCOMPARE(row(QStringLiteral("Pitch")).differences.back(), QStringLiteral("+1.5"));
        QCOMPARE(row(QStringLiteral("Spacing at P1")).values.back(), QString());
        QCOMPARE(row(QStringLiteral("Spacing at P1")).differences.back(), QString());
        QVERIFY(all.changes.front().isEmpty());
        QCOMPARE(all.changes.back(), QStringList{QStringLiteral("rail 1: recess 0.15\u00a0µm → 0.16\u00a0µm")});

        const SolutionComparison other = comparisonOf(model.compared(), 2);
        QCOMPARE(other.base, 1);
        QCOMPARE(other.rows.front().differences, (QStringList{QStringLiteral("+0.31"), QString()}));
        // No sign where the difference rounds to nothing.
        second.attitude.height = first.attitude.height + 1e-15;
        model.add(c, second);
        QCOMPARE(comparisonOf({&model.record(0), &model.record(2)}, -1).rows[1].differences.back(),
                 QStringLiteral("0.00"));
        QVERIFY(comparisonOf({}, -1).columns.isEmpty());
    }

    void savedSolutionsComeBack()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("a.h5"));
        SolutionsModel model;
        Case c = sampleFilmCase();
        c.steady.radii = {20e-3, 25e-3}; // of a series of which this is one state
        QCOMPARE(saveSolution(model.record(model.rowOf(model.add(c, sampleResult(c)))), file), QString());

        QWidget window;
        SolutionFiles files(model, window);
        const QSignalSpy succeeded(&files, &SolutionFiles::succeeded), failed(&files, &SolutionFiles::failed);
        files.open(file);
        QCOMPARE(failed.count(), 0);
        QCOMPARE(succeeded.count(), 1);
        QCOMPARE(model.count(), 2);
        const SolutionRecord& again = model.record(1);
        QCOMPARE(again.file, file);
        QCOMPARE(again.result.pressure, model.record(0).result.pressure);
        QCOMPARE(again.value.surface, c.surface);
        QVERIFY(again.value.steady.radii.empty());

        QVERIFY(QFile::resize(file, 3000));
        files.open(file);
        QCOMPARE(failed.count(), 1);
        QVERIFY(failed.front().front().toString().contains(QStringLiteral("damaged or cut short")));
        QCOMPARE(model.count(), 2);
    }
};

TOUCHDOWN_TEST(TestSolutionsModel)

} // namespace test_solutions_model

#include "test_solutions_model.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
//
// 300 random edits of a shape as the window makes them, and 300 undos. After each edit the saved text opens as the same
// case, also out to the files of the established program and in again.
#include <array>
#include <filesystem>
#include <random>
#include <vector>

#include <QTemporaryDir>
#include <QTest>
#include <QUndoStack>

#include "core/case_files/case_reader.h"
#include "core/case_files/case_text.h"
#include "core/case_files/cml_case.h"
#include "core/physics/slider/surface_check.h"
#include "tests/support/random_case.h"
#include "tests/support/random_slider.h"
#include "tests/support/test_program.h"
#include "tests/ui/sample_slider.h"
#include "ui/case/case_edits.h"
#include "ui/film/surface_page.h"

using namespace touchdown;

namespace test_random_edits {

/// A page and the case that it edits, connected as in the window.
class Edited {
public:
    explicit Edited(const Case& c)
    {
        edits.open(c);
        page.resize(900, 700);
        page.setCase(c);
        page.open(c);
        QObject::connect(&page, &SurfacePage::edited, &edits, &CaseEdits::setSurface);
        QObject::connect(&edits, &CaseEdits::edited, &page, [this] { page.setCase(edits.value()); });
    }

    const AirBearingSurface& surface() const { return edits.value().surface; }

    CaseEdits edits;
    SurfacePage page;
};

class Hand {
public:
    Hand(Edited& edited, unsigned seed) : edited_(edited), generator_(seed) {}

    /// One edit; it may change nothing, as the mirror image of a symmetric rail.
    void edit()
    {
        SurfaceEditor& editor = *edited_.page.editor();
        const AirBearingSurface& surface = edited_.surface();
        const int verb = surface.rails.size() < 2 ? 8 : below(14);
        if (surface.rails.size() > 40) editor.select({{PartKind::Rail, std::size_t(below(20))}});
        switch (surface.rails.size() > 40 ? 2 : verb) {
        case 0:
        case 1:
            selectSome();
            editor.verbs().nudge({(below(401) - 200) * 1e-7, (below(401) - 200) * 1e-7});
            break;
        case 2: editor.verbs().remove(); break;
        case 3:
            selectSome();
            editor.verbs().copy();
            break;
        case 4:
            selectSome();
            below(2) == 0 ? editor.verbs().flip() : editor.verbs().mirrorCopy();
            break;
        case 5:
            selectSome();
            editor.verbs().moveInOrder(below(2) == 0 ? 1 : -1);
            break;
        case 6: {
            const std::size_t rail = below(surface.rails.size()), edge = below(surface.rails[rail].points.size());
            const std::vector<RailPoint>& points = surface.rails[rail].points;
            const RailPoint &a = points[edge], &b = points[(edge + 1) % points.size()];
            editor.verbs().insertCorner(rail, edge, {0.5 * (a.x + b.x), 0.5 * (a.y + b.y)});
            break;
        }
        case 7:
            selectSome();
            editor.verbs().chooseWall(static_cast<int>(below(surface.walls.size() + 2)));
            break;
        case 8:
            selectSome();
            editor.verbs().makeSymmetric();
            if (surface.rails.size() < 2) addRail();
            break;
        case 9: addRail(); break;
        case 10:
            if (surface.walls.empty()) break;
            set(withoutWall(surface, below(surface.walls.size())));
            break;
        case 11:
            selectRails();
            below(2) == 0 ? editor.verbs().align(static_cast<Alignment>(below(6)))
                          : editor.verbs().distribute(below(2) == 0);
            break;
        case 12:
            selectSome();
            editor.verbs().array(1 + below(3), {below(100) * 1e-6, below(100) * 1e-6});
            break;
        default: {
            AirBearingSurface deeper = surface;
            deeper.rails[below(deeper.rails.size())].recess[0] = below(2000) * 1e-9;
            set(deeper);
        }
        }
    }

private:
    std::size_t below(std::size_t count) { return generator_() % count; }
    int below(int count) { return static_cast<int>(generator_() % static_cast<unsigned>(count)); }

    void selectRails()
    {
        PartSelection parts;
        for (int i = 0; i < 4; ++i) parts.insert({PartKind::Rail, below(edited_.surface().rails.size())});
        edited_.page.editor()->select(parts);
    }
    void selectSome()
    {
        const AirBearingSurface& surface = edited_.surface();
        PartSelection parts;
        const int count = 1 + below(3);
        for (int i = 0; i < count && !surface.rails.empty(); ++i) {
            const std::size_t rail = below(surface.rails.size());
            const std::size_t point = below(surface.rails[rail].points.size());
            const std::array<SurfacePart, 3> kinds{
                {{PartKind::Rail, rail}, {PartKind::Edge, rail, point}, {PartKind::Corner, rail, point}}};
            parts.insert(kinds[below(kinds.size())]);
        }
        if (!surface.pointsOfInterest.empty() && below(5) == 0)
            parts.insert({PartKind::Interest, below(surface.pointsOfInterest.size())});
        edited_.page.editor()->select(parts);
    }

    void addRail()
    {
        AirBearingSurface more = edited_.surface();
        const double x = below(500) * 1e-6, y = below(400) * 1e-6;
        more.rails.push_back({RailKind::Step, {{x, y}, {x + 1e-4, y}, {x + 1e-4, y + 1e-4}, {x, y + 1e-4}}, {}});
        set(more);
    }

    void set(const AirBearingSurface& surface) { edited_.edits.setSurface(surface, QStringLiteral("set"), 0); }

    Edited& edited_;
    std::mt19937 generator_;
};

class TestRandomEdits : public QObject {
    Q_OBJECT

private:
    /// Rails, walls and points of interest; the files hold other numbers of the case in their own units.
    static void comesBackFromEstablishedFiles(const Case& c)
    {
        const QTemporaryDir folder;
        const std::filesystem::path path = std::filesystem::path(folder.path().toStdString()) / "case.cml";
        const CmlOutput output = formatCmlCase(c);
        QCOMPARE(output.problem, std::string());
        QCOMPARE(writeCmlCase(path, output.members), std::string());
        const CaseDocument again = readCmlCase(path);
        QVERIFY2(again.valid(), again.valid() ? "" : again.problems.front().text().c_str());
        QVERIFY(again.value.surface == c.surface);
    }

private slots:
    void thereAndBack_data()
    {
        QTest::addColumn<unsigned>("seed");
        for (const unsigned seed : {1U, 2U}) QTest::addRow("%u", seed) << seed;
    }

    void thereAndBack()
    {
        QFETCH(const unsigned, seed);
        const Case first = seed == 1 ? sampleFilmCase() : test::RandomSlider(seed).shape();
        Edited edited(first);
        Hand hand(edited, seed);
        QUndoStack& undo = edited.edits.undoStack();
        std::string text = formatCase(first);
        std::vector<Case> states{first}; // at each place of the undo stack
        int valid = 0;
        for (int round = 0; undo.index() < 300; ++round) {
            QVERIFY(round < 3000);
            hand.edit();
            states.resize(static_cast<std::size_t>(undo.index()));
            states.push_back(edited.edits.value());
            // Half of the shapes that are not whole are taken back, so that most edits start from a whole one.
            if (!surfaceProblems(edited.surface()).empty()) {
                if (round % 2 == 0) undo.undo();
                continue;
            }
            ++valid;
            text = updateCaseText(text, edited.edits.value());
            const CaseDocument again = parseCase(text, "a.toml");
            QVERIFY2(again.valid(), again.valid() ? "" : again.problems.front().text().c_str());
            QCOMPARE(test::firstDifference(edited.edits.value(), again.value), std::string());
            if (valid % 10 == 0) comesBackFromEstablishedFiles(edited.edits.value());
        }
        QVERIFY2(valid > 100, qPrintable(QString::number(valid)));
        for (; undo.canUndo(); undo.undo())
            QVERIFY(edited.edits.value() == states[static_cast<std::size_t>(undo.index())]);
        QVERIFY(edited.edits.value() == first);
    }
};

TOUCHDOWN_TEST(TestRandomEdits)

} // namespace test_random_edits

#include "test_random_edits.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/influence_controller.h"

#include <QSignalSpy>
#include <QTest>

#include "tests/support/small_slider.h"
#include "tests/support/test_program.h"
#include "ui/film/surface_page.h"
#include "ui/style/theme.h"

using namespace touchdown;

namespace test_influence_controller {

class TestInfluenceController : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QLocale::setDefault(QLocale::c());
        applyTheme(Theme::Light);
    }

    /// As the core finds it, for the parts of the page: all rails, and the edges of the selected one.
    void findsAndShows()
    {
        const Case c = test::smallSlider(33);
        SurfacePage page;
        page.resize(900, 700);
        page.setCase(c);
        PartSelection parts, all;
        for (std::size_t i = 0; i < 5; ++i) {
            parts.insert({PartKind::Rail, i});
            for (std::size_t k = 0; k < c.surface.rails[i].points.size(); ++k) all.insert({PartKind::Edge, i, k});
        }
        all.insert(parts.begin(), parts.end());
        QCOMPARE(page.influencingParts(), all);
        // Of more than 60 edges, those of the selected rails.
        Case many = c;
        for (int i = 0; i < 15; ++i) many.surface.rails.push_back(c.surface.rails[4]);
        page.setCase(many);
        for (std::size_t i = 5; i < 20; ++i) parts.insert({PartKind::Rail, i});
        QCOMPARE(page.influencingParts(), parts);
        for (std::size_t k = 0; k < 4; ++k) parts.insert({PartKind::Edge, 4, k});
        page.editor()->select({{PartKind::Corner, 4, 1}});
        QCOMPARE(page.influencingParts(), parts);
        page.setCase(c);
        page.show();
        QVERIFY(QTest::qWaitForWindowExposed(&page));
        QTRY_VERIFY(page.editor()->settled());
        std::erase_if(parts, [](const SurfacePart& part) { return part.item >= 5; });

        InfluenceController controller;
        QSignalSpy found(&controller, &InfluenceController::found);
        controller.start(c, parts);
        QTRY_VERIFY_WITH_TIMEOUT(!controller.active(), 60000);
        const auto influence = found.back().front().value<std::vector<PartInfluence>>();
        const auto expected = shapeInfluence(attitudeCase(c), steady(attitudeCase(c)), parts);
        QCOMPARE(influence.size(), expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i) {
            QVERIFY(influence[i].part == expected[i].part);
            QCOMPARE(influence[i].per.minimumSpacing, expected[i].per.minimumSpacing);
        }

        auto* shown = page.findChild<QCheckBox*>(QStringLiteral("influence"));
        const QImage before = page.editor()->grab().toImage();
        page.showInfluence(influence); // not wanted
        QCOMPARE(page.editor()->grab().toImage(), before);
        QSignalSpy wanted(&page, &SurfacePage::influenceWanted);
        const QRectF plan = page.editor()->planArea();
        const QPoint place = page.editor()->pos();
        QTest::keyClick(page.editor(), Qt::Key_I);
        QVERIFY(shown->isChecked());
        QCOMPARE(wanted.count(), 1);
        page.showInfluence(influence);
        QVERIFY(page.editor()->grab().toImage() != before);
        QVERIFY(page.editor()->influenceWords().contains(QStringLiteral("per µm")));
        QCOMPARE(page.editor()->planArea(), plan); // the plan stays
        QCOMPARE(page.editor()->pos(), place);
        shown->setChecked(false);
        QCOMPARE(page.editor()->grab().toImage(), before);
    }

    /// Where the attitude is held there is none; what is stopped is not told.
    void tellsNothing()
    {
        Case c = test::smallSlider(33);
        InfluenceController controller;
        QSignalSpy found(&controller, &InfluenceController::found);
        controller.start(c, {{PartKind::Rail, 0}});
        controller.stopAndWait();
        QCOMPARE(found.count(), 0);
        c.steady.fixedAttitude = true;
        controller.start(c, {{PartKind::Rail, 0}});
        QTRY_COMPARE_WITH_TIMEOUT(found.count(), 1, 60000);
        QVERIFY(found.front().front().value<std::vector<PartInfluence>>().empty());
    }
};

TOUCHDOWN_TEST(TestInfluenceController)

} // namespace test_influence_controller

#include "test_influence_controller.moc"

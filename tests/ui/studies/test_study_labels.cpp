// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/studies/study_labels.h"

#include <algorithm>

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_study_labels {

constexpr QRectF bounds(0.0, 0.0, 400.0, 300.0);

LabelRequest at(double x, double y, bool important = false) { return {{x, y}, 4.0, {30.0, 12.0}, important}; }

/// The markers of these points.
std::vector<QRectF> markers(const std::vector<LabelRequest>& labels)
{
    std::vector<QRectF> boxes;
    for (const LabelRequest& label : labels) boxes.emplace_back(label.at.x() - 4.0, label.at.y() - 4.0, 8.0, 8.0);
    return boxes;
}

class TestStudyLabels : public QObject {
    Q_OBJECT

private slots:
    void standsAtTheRightOfALonelyPoint();
    void staysInside();
    void coversNeitherLabelsNorMarkers();
    void leavesOutWhatFindsNoRoom();
    void importantOnesComeFirst();
    void keepsOffALine();
};

/// The gap is 2: 100 + 4 + 2, in the middle of the height.
void TestStudyLabels::standsAtTheRightOfALonelyPoint()
{
    std::vector<QRectF> taken;
    const auto places = placeLabels({at(100.0, 100.0)}, bounds, taken, {});
    QCOMPARE(*places[0], QRectF(106.0, 94.0, 30.0, 12.0));
    QCOMPARE(taken.size(), std::size_t(1));
}

void TestStudyLabels::staysInside()
{
    std::vector<QRectF> taken;
    const std::vector<LabelRequest> labels{at(396.0, 5.0), at(3.0, 297.0), at(398.0, 298.0), at(2.0, 2.0)};
    for (const auto& place : placeLabels(labels, bounds, taken, {})) QVERIFY(place && bounds.contains(*place));
}

void TestStudyLabels::coversNeitherLabelsNorMarkers()
{
    std::vector<LabelRequest> labels;
    for (int i = 0; i < 12; ++i) labels.push_back(at(60.0 + 17.0 * i, 150.0 + 9.0 * (i % 3)));
    const std::vector<QRectF> points = markers(labels);
    std::vector<QRectF> taken = points;
    const auto places = placeLabels(labels, bounds, taken, {});
    int found = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (!places[i]) continue;
        ++found;
        for (const QRectF& point : points) QVERIFY(!places[i]->intersects(point));
        for (std::size_t j = 0; j < i; ++j) QVERIFY(!places[j] || !places[i]->intersects(*places[j]));
    }
    QVERIFY(found > 4);
}

/// All at one place: each of the eight places about a point can be taken once at most.
void TestStudyLabels::leavesOutWhatFindsNoRoom()
{
    const std::vector<LabelRequest> labels(20, at(200.0, 150.0));
    std::vector<QRectF> taken = markers(labels);
    const auto places = placeLabels(labels, bounds, taken, {});
    const auto found = std::ranges::count_if(places, [](const auto& place) { return place.has_value(); });
    QVERIFY(found >= 3 && found <= 8);
}

void TestStudyLabels::importantOnesComeFirst()
{
    std::vector<LabelRequest> labels(20, at(200.0, 150.0));
    labels.back().important = true;
    std::vector<QRectF> taken = markers(labels);
    const auto places = placeLabels(labels, bounds, taken, {});
    QCOMPARE(*places.back(), QRectF(206.0, 144.0, 30.0, 12.0));
}

/// A line goes on to the right: the label is better off beside it. A line that passes a corner at a distance is none.
void TestStudyLabels::keepsOffALine()
{
    std::vector<QRectF> taken;
    const auto places = placeLabels({at(100.0, 100.0)}, bounds, taken, {QLineF(100.0, 100.0, 300.0, 100.0)});
    QVERIFY(places[0] && places[0]->bottom() < 100.0);
    taken.clear();
    const auto past = placeLabels({at(100.0, 100.0)}, bounds, taken, {QLineF(90.0, 90.0, 150.0, 40.0)});
    QCOMPARE(*past[0], QRectF(106.0, 94.0, 30.0, 12.0));
}

TOUCHDOWN_TEST(TestStudyLabels)

} // namespace test_study_labels

#include "test_study_labels.moc"

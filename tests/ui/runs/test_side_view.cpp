// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/side_view.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include <QBuffer>
#include <QFile>
#include <QFontInfo>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include "core/case/contact_kind.h"
#include "core/physics/disk/disk_velocity.h"
#include "tests/support/test_program.h"
#include "tests/ui/sample_slider.h"
#include "ui/plot/paper_figure.h"
#include "ui/plot/plot_theme.h"
#include "ui/runs/disk_profile.h"
#include "ui/runs/run_record.h"
#include "ui/runs/runs_model.h"
#include "ui/style/theme.h"

using namespace touchdown;

namespace test_side_view {

const std::vector<Quantity> quantities{{"minimum_spacing", "m", "nm", "Minimum spacing"},
                                       {"pitch", "rad", "urad", "Pitch"},
                                       {"height", "m", "nm", "Height"},
                                       {"contact_force", "N", "mN", "Contact"}};

/// A slider that falls: 60 nm above the disk with 100 urad at 0, 52 nm with 110 urad at 1 us and in contact.
SampleBatch falling() { return {{0.0, 1e-6}, {{17e-9, 5e-9}, {100e-6, 110e-6}, {60e-9, 52e-9}, {0.0, 1e-3}}}; }

class TestSideView : public QObject {
    Q_OBJECT

private slots:
    void init();
    void beginsWithoutARun();
    void showsTheLatestSample();
    void showsAChosenTime();
    void keepsItsScale();
    void springs();
    void springsOverAnUnevenDisk();
    void aContactHasNone();
    void paintsBothThemes_data();
    void paintsBothThemes();
    void textOfAPictureHasItsSize();
    void aSecondRunStandsThereAtTheSameTime();
    void aRunThatIsReplacedIsTheSecondAgain();
    void bothRunsAreDrawnAndNamed();
    void aRoughDiskIsDrawnAsItIs();
    void saysWhyAnUnevenDiskIsFlat();
    void aHiddenViewGivesTheSurfaceBack();
    void writesDiskAndSecondRun();

private:
    void add(const Case& c, int number = 1) { runs_->add(std::make_unique<RunRecord>(number, c, "", quantities)); }

    std::unique_ptr<RunsModel> runs_;
    std::unique_ptr<SideView> view_;
};

void TestSideView::init()
{
    QLocale::setDefault(QLocale::c());
    applyTheme(Theme::Light);
    view_.reset();
    runs_ = std::make_unique<RunsModel>();
    view_ = std::make_unique<SideView>(*runs_);
    view_->resize(800, 500);
    view_->show();
    QVERIFY(QTest::qWaitForWindowExposed(view_.get()));
}

void TestSideView::beginsWithoutARun()
{
    QVERIFY(!view_->state());
    add(sampleFilmCase());
    view_->showRun(1);
    QVERIFY(!view_->state()); // no sample yet
}

void TestSideView::showsTheLatestSample()
{
    add(sampleFilmCase());
    view_->showRun(1);
    runs_->append(1, falling(), {});
    view_->dataArrived(1);
    // Half of 0.85 mm times 110 urad is 46.75 nm: the trailing edge lies 52 - 46.75 nm above the disk.
    QVERIFY(std::abs(view_->state()->trailingHeight - 5.25e-9) < 1e-15);
    QCOMPARE(view_->state()->contactForce, 1e-3);
    // At 0.3 mm there is the front pad, on which only the crown is left: 15 nm (1 - (0.3 - 0.425)^2/0.425^2) above the
    // chord or below it; the shelf and the base beside it are no part of the outline.
    const double share = 0.3 / 0.85;
    const double chord = 5.25e-9 + 110e-6 * 0.55e-3;
    QVERIFY2(std::abs(view_->heightAt(share) - chord) < 15.1e-9,
             qPrintable(QString::number(view_->heightAt(share) - chord)));
    // Between the rails, at 0.5 mm, the base is lowest: 1.5 um higher.
    QVERIFY(view_->heightAt(0.5 / 0.85) > 1.4e-6);
}

void TestSideView::showsAChosenTime()
{
    add(sampleFilmCase());
    runs_->append(1, falling(), {});
    view_->showRun(1);
    view_->showTime(0.0);
    QCOMPARE(view_->state()->spacing, 17e-9);
    QCOMPARE(view_->state()->contactForce, 0.0);
    view_->showTime(0.5e-6); // between two samples
    QVERIFY(std::abs(view_->state()->pitch - 105e-6) < 1e-15);
    view_->showTime(std::nullopt);
    QCOMPARE(view_->state()->time, 1e-6);
    runs_->remove(0);
    QVERIFY(!view_->state());
}

void TestSideView::keepsItsScale()
{
    add(sampleFilmCase());
    runs_->append(1, falling(), {});
    view_->showRun(1);
    const double before = view_->exaggeration();
    QVERIFY(before > 1000.0);
    view_->showTime(0.0);
    view_->showTime(1e-6);
    QCOMPARE(view_->exaggeration(), before);
}

/// The bottom of the slider passes through the heights at the mass centre, the pad and the pressure centres.
void TestSideView::springs()
{
    const Case c;
    runs_->add(std::make_unique<RunRecord>(1, c, "",
                                           std::vector<Quantity>{{"flying_height", "m", "nm", ""},
                                                                 {"minimum_spacing", "m", "nm", ""},
                                                                 {"pitch", "rad", "urad", ""},
                                                                 {"height", "m", "nm", ""}}));
    const double pitch = 90e-6, height = 60e-9, pad = height - c.springs.padDistance * pitch;
    runs_->append(1, {{0.0}, {{pad}, {pad}, {pitch}, {height}}}, {});
    view_->showRun(1);
    QVERIFY(view_->state());
    QCOMPARE(view_->state()->separation, pad);
    const SpringsDrawing drawing(c);
    const auto near = [&](double behind, double expected) {
        const double share = (drawing.centre() + behind) / drawing.length();
        return std::abs(view_->heightAt(share) - expected) < 1.01 * pitch * drawing.length() / 800.0; // half a step
    };
    QVERIFY(near(0.0, height));
    QVERIFY(near(c.springs.padDistance, pad));
    QVERIFY(near(-c.springs.frontDistance, height + c.springs.frontDistance * pitch));
    // The pad's own picture reaches beyond the height at which the menisci break.
    QVERIFY(drawing.padReach() > c.onoYamane.takeOff);
    // Summits have a pad, but neither d_s nor d_e; without contact there is no pad.
    Case other;
    other.contact = ContactKind::Asperity;
    QVERIFY(SpringsDrawing(other).padReach() > other.asperity.planeHeight);
    other.contact = noContact;
    QCOMPARE(SpringsDrawing(other).padReach(), 0.0);
    QVERIFY(!view_->grab().isNull());
}

/// The height of the disk under pad and pressure centres is read from the run and drawn: without it the picture
/// differs.
void TestSideView::springsOverAnUnevenDisk()
{
    const std::vector<Quantity> recorded{{"flying_height", "m", "nm", ""},     {"minimum_spacing", "m", "nm", ""},
                                         {"pitch", "rad", "urad", ""},         {"height", "m", "nm", ""},
                                         {"front_disk_height", "m", "nm", ""}, {"rear_disk_height", "m", "nm", ""},
                                         {"disk_height", "m", "nm", ""}};
    const auto pictureOver = [&](int number, double front, double rear, double pad) {
        runs_->add(std::make_unique<RunRecord>(number, Case{}, "", recorded));
        runs_->append(number, {{0.0}, {{7e-9}, {7e-9}, {90e-6}, {60e-9}, {front}, {rear}, {pad}}}, {});
        view_->showRun(number);
        return view_->grab().toImage();
    };
    const QImage flat = pictureOver(1, 0.0, 0.0, 0.0);
    QVERIFY(view_->state()->disk.flat());
    const QImage uneven = pictureOver(2, 5e-9, -4e-9, -3e-9);
    QCOMPARE(view_->state()->disk.front, 5e-9);
    QCOMPARE(view_->state()->disk.rear, -4e-9);
    QCOMPARE(view_->state()->disk.pad, -3e-9);
    QVERIFY(flat != uneven);
}

void TestSideView::aContactHasNone()
{
    Case c;
    c.model = ModelKind::Contact;
    add(c);
    runs_->append(1, falling(), {});
    view_->showRun(1);
    QVERIFY(!view_->state());
}

void TestSideView::paintsBothThemes_data()
{
    QTest::addColumn<bool>("dark");
    QTest::newRow("light") << false;
    QTest::newRow("dark") << true;
}

void TestSideView::paintsBothThemes()
{
    QFETCH(const bool, dark);
    applyTheme(dark ? Theme::Dark : Theme::Light);
    add(sampleFilmCase());
    runs_->append(1, falling(), {});
    view_->showRun(1);
    QTRY_COMPARE(view_->grab().toImage().pixelColor(2, 2).lightness() < 128, dark);
    const QImage image = view_->grab().toImage();
    int coloured = 0;
    for (int y = 0; y < image.height(); y += 3)
        for (int x = 0; x < image.width(); x += 3) coloured += image.pixelColor(x, y).saturation() > 60;
    QVERIFY2(coloured > 500, qPrintable(QString::number(coloured)));
}

/// As on the screen; on paper as the figure says.
void TestSideView::textOfAPictureHasItsSize()
{
    add(sampleFilmCase());
    view_->showRun(1);
    runs_->append(1, falling(), {});
    view_->dataArrived(1);
    const QTemporaryDir folder;
    const auto largest = [](const QString& path) {
        QFile file(path);
        if (!file.open(QIODevice::ReadOnly)) qFatal("no picture");
        static const QRegularExpression size("<text[^>]*font-size=\"([0-9.]+)\"");
        double most = 0.0;
        for (auto match = size.globalMatch(QString::fromUtf8(file.readAll())); match.hasNext();)
            most = std::max(most, match.next().captured(1).toDouble());
        return most;
    };
    QCOMPARE(savePicture(*view_, folder.filePath("screen.svg")), QString());
    QCOMPARE(largest(folder.filePath("screen.svg")), 1.0 * QFontInfo(view_->font()).pixelSize());
    FigureFormat wide;
    wide.width = FigureFormat::twoColumns;
    const PaperFigure figure({view_.get()}, wide);
    QCOMPARE(figure.save(folder.filePath("paper.svg")), QString());
    const double point = figure.picture().size.width() / (170.0 / 25.4 * 72.0); // [px]
    QVERIFY(std::abs(largest(folder.filePath("paper.svg")) / point - 8.0) < 0.01);
    QCOMPARE(view_->size(), QSize(800, 500));
}

/// The baseline, or else the newest other run that is shown; not where it has no sample at the time.
void TestSideView::aSecondRunStandsThereAtTheSameTime()
{
    for (const int number : {1, 2, 3}) {
        runs_->add(std::make_unique<RunRecord>(number, sampleFilmCase(), "", quantities));
        SampleBatch batch = falling();
        for (std::vector<double>& column : batch.columns)
            for (double& value : column) value *= number;
        if (number == 3) batch.time[1] = 0.5e-6; // ends before the others
        runs_->append(number, batch, {});
    }
    view_->showRun(2);
    QCOMPARE(view_->otherRun(), 3);
    view_->showTime(0.25e-6);
    QVERIFY(view_->otherState() && view_->otherState()->time == 0.25e-6);
    QVERIFY(std::abs(view_->otherState()->pitch - 3 * 105e-6) < 1e-12); // halfway
    QVERIFY(std::abs(view_->state()->pitch - 2 * 102.5e-6) < 1e-12);
    view_->showTime(0.75e-6);
    QVERIFY(!view_->otherState());
    runs_->setBaseline(1);
    QCOMPARE(view_->otherRun(), 1);
    QVERIFY(view_->otherState() && std::abs(view_->otherState()->pitch - 107.5e-6) < 1e-12);
    const QImage both = view_->grab().toImage();
    runs_->remove(0);
    QCOMPARE(view_->otherRun(), 3);
    QVERIFY(view_->grab().toImage() != both);
    runs_->setData(runs_->index(1), Qt::Unchecked, Qt::CheckStateRole);
    QCOMPARE(view_->otherRun(), -1);
    QVERIFY(view_->state());
}

/// As a window does when it shows the case that is edited: another run with the number of one that was removed.
void TestSideView::aRunThatIsReplacedIsTheSecondAgain()
{
    for (const int number : {1, 2, 3}) {
        add(sampleFilmCase(), number);
        runs_->append(number, falling(), {});
    }
    view_->showRun(2);
    QCOMPARE(view_->otherRun(), 3);
    runs_->remove(2);
    QCOMPARE(view_->otherRun(), 1);
    Case longer = sampleFilmCase();
    longer.slider.length *= 1.5;
    add(longer, 3);
    SampleBatch other = falling();
    other.columns[1] = {200e-6, 210e-6};
    runs_->append(3, other, {});
    view_->showTime(0.0);
    QCOMPARE(view_->otherRun(), 3);
    QVERIFY(view_->otherState() && view_->otherState()->pitch == 200e-6);
    QCOMPARE(view_->otherState()->trailingHeight, 60e-9 - 0.5 * longer.slider.length * 200e-6);
}

/// Over the second run, that of the shown run has the colour of this one; the legend has a line of each colour.
void TestSideView::bothRunsAreDrawnAndNamed()
{
    const PlotTheme theme = lightPlotTheme();
    const auto colourOf = [&](int number) { return theme.colour(RunsModel::style(*runs_->find(number))); };
    const auto pixels = [&](const QColor& colour) {
        const QImage image = view_->grab().toImage();
        int count = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x) count += image.pixelColor(x, y) == colour ? 1 : 0;
        return count;
    };
    add(sampleFilmCase(), 1);
    runs_->append(1, falling(), {});
    view_->showRun(1);
    const int alone = pixels(colourOf(1));
    QVERIFY(alone > 100);
    add(sampleFilmCase(), 2); // at the same place
    runs_->append(2, falling(), {});
    view_->showTime(std::nullopt);
    QVERIFY(view_->otherState());
    const int above = pixels(colourOf(1));
    QVERIFY2(above > 0.75 * alone, qPrintable(QStringLiteral("%1 of %2").arg(above).arg(alone)));
    QVERIFY(pixels(colourOf(2)) >= 12); // in the legend
    view_->showRun(2);
    QVERIFY(pixels(colourOf(2)) > 0.75 * alone);
}

/// A wave of 3 nm and 0.1 mm along the centre line, which has moved with the disk: at time t the height at x is that of
/// the disk at x - U t. It is as high in the picture as in the surface.
void TestSideView::aRoughDiskIsDrawnAsItIs()
{
    Case c = sampleFilmCase();
    c.diskSurface.kind = DiskSurfaceKind::Waves;
    c.diskSurface.waveAmplitudes = {3e-9};
    c.diskSurface.waveLengths = {1e-4};
    add(c);
    runs_->append(1, falling(), {});
    view_->showRun(1);
    QTRY_VERIFY(!view_->disk()->empty());
    const double speed =
        diskVelocity(c.disk, c.slider.length, c.slider.width, 0.5 * c.slider.length, 0.5 * c.slider.width).x;
    for (const double time : {0.0, 0.4e-6, 1e-6}) {
        const std::vector<double> heights = view_->disk()->at(time);
        QVERIFY(heights.size() > 700);
        for (std::size_t i = 0; i < heights.size(); ++i) {
            const double x = c.slider.length * (static_cast<double>(i) + 0.5) / static_cast<double>(heights.size());
            const double expected = 3e-9 * std::sin(2.0 * std::numbers::pi * (x - speed * time) / 1e-4);
            QVERIFY(std::abs(heights[i] - expected) < 3e-9 * 2.0 * std::numbers::pi * 2.2e-6 / 1e-4); // of a part
        }
    }
    const QImage wavy = view_->grab().toImage();
    // In the picture: the upper border of the disk at its crests and troughs, below what flies.
    const PlotTheme theme = lightPlotTheme();
    int highest = wavy.height(), lowest = 0;
    const int floor = wavy.height() - static_cast<int>(2.6 * view_->fontMetrics().height()) - 3;
    for (int x = wavy.width() / 4; x < wavy.width() / 2; ++x) {
        int top = floor; // upwards through the disk and the marks on it
        while (top > 0 && wavy.pixelColor(x, top - 1) != theme.plotArea &&
               wavy.pixelColor(x, top - 1).saturation() < 40)
            --top;
        highest = std::min(highest, top);
        lowest = std::max(lowest, top);
    }
    const double pixelsOfLength = (wavy.width() - 6.5 * view_->fontMetrics().height()) / c.slider.length;
    const double expected = 6e-9 * view_->exaggeration() * pixelsOfLength;
    QVERIFY2(expected > 8.0 && std::abs(lowest - highest - expected) <= 2.5,
             qPrintable(QStringLiteral("%1 of %2").arg(lowest - highest).arg(expected)));
    view_->showTime(0.4e-6);
    QVERIFY(view_->grab().toImage() != wavy);
    // Held still it does not move; a flat disk has no profile.
    c.diskSurface.motion = SurfaceMotion::Still;
    DiskProfile still(nullptr);
    still.setCase(c);
    QTRY_VERIFY(!still.empty());
    QVERIFY(still.at(0.0) == still.at(1e-6));
    still.setCase(sampleFilmCase());
    QVERIFY(still.empty() && still.at(0.0).empty());
    runs_->remove(0);
    QVERIFY(view_->disk()->empty());
}

/// While it is made, and where its file cannot be read.
void TestSideView::saysWhyAnUnevenDiskIsFlat()
{
    add(sampleFilmCase());
    runs_->append(1, falling(), {});
    view_->showRun(1);
    QCOMPARE(view_->disk()->state(), DiskProfile::State::Flat);
    const QImage flat = view_->grab().toImage();
    Case c = sampleFilmCase();
    c.diskSurface.kind = DiskSurfaceKind::File;
    c.diskSurface.file = "no_such_map.toml";
    DiskProfile profile(nullptr);
    profile.setCase(c);
    QCOMPARE(profile.state(), DiskProfile::State::BeingMade);
    QTRY_COMPARE(profile.state(), DiskProfile::State::Failed);
    QVERIFY2(profile.problem().contains(QStringLiteral("no_such_map.toml")), qPrintable(profile.problem()));
    QVERIFY(profile.empty());
    runs_->remove(0);
    add(c);
    runs_->append(1, falling(), {});
    view_->showRun(1);
    const QImage being = view_->grab().toImage();
    QTRY_COMPARE(view_->disk()->state(), DiskProfile::State::Failed);
    const QImage failed = view_->grab().toImage();
    QVERIFY(being != flat && failed != flat && failed != being);
}

void TestSideView::aHiddenViewGivesTheSurfaceBack()
{
    Case c = sampleFilmCase();
    c.diskSurface.kind = DiskSurfaceKind::Waves;
    c.diskSurface.waveAmplitudes = {3e-9};
    c.diskSurface.waveLengths = {1e-4};
    for (const int number : {1, 2}) {
        add(c, number);
        runs_->append(number, falling(), {});
    }
    view_->showRun(1);
    QTRY_VERIFY(!view_->disk()->empty());
    QCOMPARE(view_->otherRun(), 2);
    view_->hide();
    QVERIFY(view_->disk()->empty());
    QCOMPARE(view_->otherRun(), -1);
    view_->show();
    QTRY_VERIFY(!view_->disk()->empty());
    QCOMPARE(view_->otherRun(), 2);
}

/// At 0.5 us, over a wave of 3 nm.
void TestSideView::writesDiskAndSecondRun()
{
    Case c = sampleFilmCase();
    c.diskSurface.kind = DiskSurfaceKind::Waves;
    c.diskSurface.waveAmplitudes = {3e-9};
    c.diskSurface.waveLengths = {1e-4};
    c.diskSurface.motion = SurfaceMotion::Still;
    for (const int number : {1, 2}) {
        add(c, number);
        SampleBatch batch = falling();
        for (double& height : batch.columns[2]) height += 1e-9 * (number - 1);
        runs_->append(number, batch, {});
    }
    view_->showRun(1);
    view_->showTime(0.5e-6);
    QTRY_VERIFY(!view_->disk()->empty());
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    view_->dataWriter()(buffer);
    const QList<QByteArray> lines = buffer.data().trimmed().split('\n');
    QCOMPARE(lines.front(), QByteArray("x at 5e-7 s [m],height of the slider of run 1 [m],height of the disk [m],"
                                       "height of the slider of run 2 [m]"));
    QVERIFY(lines.size() > 300);
    for (qsizetype i = 1; i < lines.size(); ++i) {
        const QList<QByteArray> cells = lines[i].split(',');
        QCOMPARE(cells.size(), 4);
        QVERIFY(std::abs(cells[2].toDouble() - 3e-9 * std::sin(2.0 * std::numbers::pi * cells[0].toDouble() / 1e-4)) <
                1e-13);
        QVERIFY(std::abs(cells[3].toDouble() - cells[1].toDouble() - 1e-9) < 1e-13);
    }
}

TOUCHDOWN_TEST(TestSideView)

} // namespace test_side_view

#include "test_side_view.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The slider over the disk, from the side: x to scale, heights exaggerated. Shows the air bearing surface along the
// slider (at each x what reaches furthest down, across all y) at the attitude of a run's latest sample, or at a time
// that was chosen; and how the disk moves. Recesses that are deep beside the heights at which pads fly are cut off. Of
// the model springs it shows a flat slider on two springs, and the pad near the disk. The uneven disk of a film is
// drawn as it is along the slider's centre line at that time.
//
// The lower side of a second run of the same model stands there dashed, at the same time: that of the baseline, or
// without one that of the newest other run that is shown. Then a legend names both.
#pragma once

#include "ui/plot/picture_widget.h"
#include "ui/plot/plot_axis.h"
#include "ui/runs/springs_drawing.h"
#include "ui/slider/profile_drawing.h"

#include <QPen>

#include <optional>
#include <vector>

namespace touchdown {

class DiskProfile;
class RunsModel;

class SideView : public PictureWidget {
    Q_OBJECT

public:
    /// `runs` must outlive the widget.
    explicit SideView(RunsModel& runs, QWidget* parent = nullptr);

    /// A run of a film or of springs; -1: none.
    void showRun(int number);
    void dataArrived(int number);
    /// Nothing: the latest sample, as it comes.
    void showTime(const std::optional<double>& time);

    /// The shown state.
    struct State {
        double time = 0.0;           // [s]
        double trailingHeight = 0.0; // nominal, of the trailing edge's centre above the mean disk plane [m]
        double pitch = 0.0;          // [rad]
        double spacing = 0.0;        // the smallest one [m]
        bool aboveDisk = false;      // the spacing is, else above its mean plane
        double contactForce = 0.0;   // [N]
        double separation = 0.0;     // springs: of the pad [m]
        SpringsDrawing::Disk disk;   // springs
    };
    const std::optional<State>& state() const { return first_.state; }
    /// Number of the second run; -1: there is none.
    int otherRun() const { return second_.number; }
    /// Nothing while it has no sample at the time.
    const std::optional<State>& otherState() const { return second_.state; }
    const DiskProfile* disk() const { return disk_; }
    /// The times of the run's samples so far [s].
    std::optional<PlotRange> span() const;
    /// Metres of length drawn as long as one metre of height.
    double exaggeration() const;
    /// Height of the surface at a share of the slider's length [m].
    double heightAt(double share) const { return first_.heightAt(share); }

    QString title() const override { return tr("Side view"); }
    std::function<void(QIODevice&)> dataWriter() const override;

    QSize sizeHint() const override { return {640, 400}; }
    QSize minimumSizeHint() const override { return {240, 160}; }

protected:
    void hideEvent(QHideEvent* event) override;
    void paint(QPainter& painter, const PlotTheme& theme) override;
    void showEvent(QShowEvent* event) override;

private:
    /// A run as it is drawn.
    struct Seen {
        int number = -1;
        std::vector<double> profile; // lowest recess at equal steps from the leading to the trailing edge [m]
        std::optional<SpringsDrawing> springs;
        double length = 0.0; // of the slider [m]
        double centre = 0.0; // of the mass centre, from the leading edge [m]
        double speed = 0.0;  // of the disk [m/s]
        std::optional<State> state;

        double heightAt(double share) const;
        std::vector<double> heights() const; // at the steps of the profile
    };
    Seen seenOf(int number) const;
    std::optional<State> stateOf(const Seen& seen, const std::optional<double>& time) const;
    void takeState();
    void takeOther(int except = -1);
    int wantedOther(int except) const;
    QRectF plotArea() const;
    QRectF padArea() const;
    ProfileDrawing drawing() const;
    void writeProfile(QIODevice& device) const;
    void paintAxes(QPainter& painter, const PlotTheme& theme) const;
    void paintSlider(QPainter& painter, const PlotTheme& theme) const;
    QPen penOf(const Seen& seen, const PlotTheme& theme) const;
    void paintLegend(QPainter& painter, const PlotTheme& theme) const;
    void paintRemark(QPainter& painter, const PlotTheme& theme) const;
    void paintReadings(QPainter& painter, const PlotTheme& theme) const;

    RunsModel& runs_;
    Seen first_, second_;
    std::optional<double> time_;
    DiskProfile* disk_;
    PlotAxis height_;
};

} // namespace touchdown

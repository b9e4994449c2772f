// SPDX-License-Identifier: GPL-3.0-or-later
//
// The slider over the disk, from the side: x to scale, heights exaggerated. Shows the air bearing surface along the
// slider (at each x what reaches furthest down, across all y) at the attitude of a run's latest sample, or at a time
// that was chosen; and how the disk moves. Recesses that are deep beside the heights at which pads fly are cut off. Of
// the model springs it shows a flat slider on two springs, and the pad near the disk.
#pragma once

#include "ui/plot/plot_axis.h"
#include "ui/plot/plot_export.h"
#include "ui/plot/plot_theme.h"
#include "ui/runs/springs_drawing.h"
#include "ui/slider/profile_drawing.h"

#include <QWidget>

#include <optional>
#include <vector>

namespace touchdown {

class RunsModel;

class SideView : public QWidget, public PagePart {
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
        double contactForce = 0.0;   // [N]
        double separation = 0.0;     // springs: of the pad [m]
        SpringsDrawing::Disk disk;   // springs
    };
    const std::optional<State>& state() const { return state_; }
    /// The times of the run's samples so far [s].
    std::optional<PlotRange> span() const;
    /// Metres of length drawn as long as one metre of height.
    double exaggeration() const;
    /// Height of the surface at a share of the slider's length [m].
    double heightAt(double share) const;

    QString title() const override { return tr("Side view"); }
    void paintInto(QPainter& painter, const QRectF& target, const PlotTheme& theme) override;
    void paintOnPaper(QPainter& painter, const QSizeF& size, const QFont& font, PaperColours colours) override;
    double heightOnPaper(double width, const QFont& font) const override;
    std::function<void(QIODevice&)> dataWriter() const override;

    QSize sizeHint() const override { return {640, 400}; }
    QSize minimumSizeHint() const override { return {240, 160}; }

protected:
    void changeEvent(QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void takeRun();
    void takeState();
    QRectF plotArea() const;
    ProfileDrawing drawing() const;
    void paint(QPainter& painter, const PlotTheme& theme) const;
    void writeProfile(QIODevice& device) const;
    void paintAxes(QPainter& painter, const PlotTheme& theme) const;
    void paintSlider(QPainter& painter, const PlotTheme& theme) const;
    void paintReadings(QPainter& painter, const PlotTheme& theme) const;

    RunsModel& runs_;
    int number_ = -1;
    std::optional<double> time_;
    std::optional<State> state_;
    std::vector<double> profile_; // lowest recess at equal steps from the leading to the trailing edge [m]
    std::optional<SpringsDrawing> springs_;
    double length_ = 0.0; // of the slider [m]
    double centre_ = 0.0; // of the mass centre, from the leading edge [m]
    double speed_ = 0.0;  // of the disk [m/s]
    PlotAxis height_;
};

} // namespace touchdown

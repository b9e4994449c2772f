// SPDX-License-Identifier: GPL-3.0-or-later
//
// A chart of a study in the window: pointing shows series, setting and numbers; a box zooms a panel, a double click
// shows all of it; the arrow keys go from point to point; the right button copies and saves.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/studies/study/study.h"
#include "ui/plot/picture_widget.h"
#include "ui/studies/study_panel.h"

namespace touchdown {

class StudyChartDrawing;

class StudyChartView : public PictureWidget {
    Q_OBJECT

public:
    explicit StudyChartView(QWidget* parent = nullptr);
    ~StudyChartView() override;

    /// A chart with the same axes as before keeps its zoom, as during a study. `underWay`: there is more to come.
    void setChart(StudyChart chart, bool underWay = false);
    const StudyChart& chart() const { return chart_; }
    void fit();

    /// As it would be drawn now.
    const StudyChartDrawing& drawing() const;
    QString title() const override { return QString::fromStdString(chart_.title); }
    double heightOnPaper(double width, const QFont& font) const override;
    std::function<void(QIODevice&)> dataWriter() const override;
    /// Description of the point under the pointer or the keyboard cursor; empty for none.
    QString htmlTip() const;

    QSize sizeHint() const override;
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;

protected:
    void fillMenu(QMenu& menu) override;
    void paint(QPainter& painter, const PlotTheme& theme) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    struct Pointed {
        std::size_t panel = 0;
        PanelHit hit;
        bool operator==(const Pointed&) const = default;
    };

    std::optional<std::size_t> panelAt(const QPointF& pixel) const;
    void point(const QPointF& pixel);
    void setPointed(const std::optional<Pointed>& pointed, const QPoint& at);
    void goToPoint(int by);
    void redraw();

    StudyChart chart_;
    bool underWay_ = false;
    std::vector<std::optional<PanelRange>> zoomed_;
    mutable std::unique_ptr<StudyChartDrawing> drawing_; // nothing when it has to be made anew
    std::optional<Pointed> pointed_;
    std::optional<std::size_t> dragged_; // the panel in which a box is drawn
    QRectF drag_;
};

} // namespace touchdown

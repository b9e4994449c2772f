// SPDX-License-Identifier: GPL-3.0-or-later
//
// A picture (PNG, JPEG) or a DXF drawing under the plan of a slider, to trace. It belongs to the window and changes no
// number of a case: its file and its place are remembered in the settings, for each case by itself.
//
// A file is read beside the window. A picture of many pixels is made smaller on reading; one that the system has no
// memory for, and a file that cannot be read, are told in a sentence.
#pragma once

#include <memory>
#include <vector>

#include <QImage>
#include <QObject>
#include <QPainter>
#include <QRectF>

#include "core/formats/dxf_drawing.h"
#include "ui/calculation/task_queue.h"
#include "ui/plot/plot_theme.h"

namespace touchdown {

class SliderPlan;

/// Where and how it is shown.
struct UnderlayPlace {
    double width = 0.0;      // [m]; the height follows
    double x = 0.0, y = 0.0; // of its lower left corner [m]
    bool mirrored = false;   // top and bottom are exchanged
    double opacity = 0.7;    // 0 to 1
    bool shown = true;
    bool operator==(const UnderlayPlace&) const = default;
};

class Underlay : public QObject {
    Q_OBJECT

public:
    explicit Underlay(QObject* parent);

    /// By the name of a file.
    static bool canLoad(const QString& file);
    /// Another case, by its file or name, with what was remembered for it.
    void openCase(const QString& name);
    /// The case has another name from now on.
    void renameCase(const QString& name);
    /// A file of the user's, under a slider of this size [m]: a drawing with a unit where its coordinates are, unless
    /// that is beside the slider; else from corner to corner.
    void load(
        const QString& file, double length, double width, const std::function<void()>& then = [] {});
    void remove();

    bool loaded() const { return !content_.box.isEmpty(); }
    bool shown() const { return loaded() && place_.shown; }
    bool isDrawing() const { return content_.picture.isNull(); }
    QString file() const { return file_; }
    /// What of a drawing is not shown, in a sentence; or "".
    QString remark() const { return QString::fromStdString(content_.drawing.remark); }
    /// Of a drawing; 0: its file does not tell [m].
    double unit() const { return content_.drawing.unit; }
    /// Width of a drawing in its own units.
    double drawnWidth() const { return content_.box.width(); }
    const UnderlayPlace& place() const { return place_; }
    void setPlace(const UnderlayPlace& place);

    /// Of a drawing, on the slider [m].
    std::vector<DrawnPath> paths() const;
    void paint(QPainter& painter, const SliderPlan& plan, const PlotTheme& theme) const;

signals:
    void changed();
    /// Another file is shown.
    void fileShown();
    void failed(const QString& sentence);

private:
    struct Content {
        QImage picture;
        Drawing drawing;
        QRectF box; // around it, in pixels or units of the drawing; its top is the smallest y
        QString problem;
    };
    static Content contentOf(const QString& file);
    static void readPicture(const QString& file, Content& content);
    /// Reads a file; then calls `placed`, unless another one was asked for meanwhile.
    void read(
        const QString& file, std::function<void()> placed, std::function<void()> then = [] {});
    void remember() const;
    SurfacePoint onSlider(double u, double v) const;

    QString case_, file_;
    Content content_;
    UnderlayPlace place_;
    int asked_ = 0; // number of the last file that was asked for
    TaskQueue* tasks_;
};

} // namespace touchdown

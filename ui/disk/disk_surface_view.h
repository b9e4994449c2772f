// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page of the surface of the disk that the case asks for: a piece of it as a map with sections, the spectrum of its
// profiles along the track beside the requested one, and its statistics. A hidden page makes no surface.
#pragma once

#include <functional>
#include <optional>
#include <utility>

#include <QLabel>
#include <QSlider>
#include <QStackedWidget>

#include "ui/calculation/calculation_controller.h"
#include "ui/disk/disk_surface_preview.h"
#include "ui/plot/min_max_pyramid.h"
#include "ui/style/result_table.h"

namespace touchdown {

class FieldsView;
class PlotGroup;
class PlotWidget;

/// Makes the surfaces beside the window, always for the latest requested case. A surface that is out of date when it is
/// ready is discarded.
class DiskSurfaceController : public CalculationController {
    Q_OBJECT

public:
    using Maker = std::function<DiskSurfacePreview(const Case&)>;

    /// `maker` is `previewOf` or a stand-in of a test.
    explicit DiskSurfaceController(Maker maker, QObject* parent = nullptr);
    /// Waits for the surface that is being made.
    ~DiskSurfaceController() override { giveUp(); }

    /// Starts after a quarter of a second without another request, once the surface that is being made is ready.
    void request(const Case& c);
    /// Discards the request.
    void cancel();
    bool busy() const { return busy_; }
    /// The surface that was made last.
    DiskSurfacePreview take() { return std::move(made_); }

signals:
    /// The requested surface can be taken.
    void made();

protected:
    void deliver() override;

private:
    void make();

    Maker maker_;
    QTimer pause_; // until the user stops typing
    Case wanted_;
    bool busy_ = false;
    int requested_ = 0, making_ = 0; // numbers of requests
    DiskSurfacePreview made_;
    Mailbox<std::optional<DiskSurfacePreview>> mailbox_{*this};
};

class DiskSurfaceView : public QWidget {
    Q_OBJECT

public:
    /// A test has another `maker`.
    explicit DiskSurfaceView(QWidget* parent = nullptr, DiskSurfaceController::Maker maker = previewOf);

    void setCase(const Case& c);
    void fit();

    DiskSurfaceController& controller() { return controller_; }
    FieldsView* view() const { return view_; }
    PlotWidget* spectrum() const { return spectrum_; }
    ResultTable* statistics() const { return statistics_; }
    QSlider* place() const { return place_; }
    bool empty() const { return pages_->currentWidget() == text_; }
    QString text() const { return text_->text(); }

protected:
    void showEvent(QShowEvent* event) override;

private:
    void build();
    void request();
    void say(const QString& sentence);
    void onMade();
    void showPiece();
    void showSpectrum();
    void showStatistics();

    Case case_;
    bool wanted_ = false; // not yet asked for, or not shown
    DiskSurfacePreview preview_;
    DiskSurfaceController controller_;
    QStackedWidget* pages_;
    QLabel* text_;
    FieldsView* view_;
    QSlider* place_;
    QLabel* placeText_;
    PlotWidget* spectrum_;
    PlotGroup* spectrumGroup_;
    std::vector<MinMaxPyramid> curves_; // of the spectrum
    ResultTable* statistics_;
};

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The surface of the disk as the case asks for it: a piece of it as a map with sections, the spectrum of its profiles
// along the track beside the one that was asked for, and its statistics computed back.
//
// Nothing is made while the page is hidden.
#pragma once

#include "ui/disk/disk_surface_controller.h"

#include <QLabel>
#include <QSlider>
#include <QStackedWidget>
#include <QTableWidget>

#include "ui/plot/min_max_pyramid.h"

namespace touchdown {

class FieldsView;
class PlotGroup;
class PlotWidget;

class DiskSurfaceView : public QWidget {
    Q_OBJECT

public:
    explicit DiskSurfaceView(QWidget* parent = nullptr);
    /// With another maker than `previewOf`.
    explicit DiskSurfaceView(DiskSurfaceController::Maker maker, QWidget* parent = nullptr);

    void setCase(const Case& c);
    void fit();

    DiskSurfaceController& controller() { return controller_; }
    FieldsView* view() const { return view_; }
    PlotWidget* spectrum() const { return spectrum_; }
    QTableWidget* statistics() const { return statistics_; }
    QSlider* place() const { return place_; }
    bool empty() const { return pages_->currentWidget() == text_; }
    QString text() const { return text_->text(); }

protected:
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;

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
    QWidget* foot_;
    QSlider* place_;
    QLabel* placeText_;
    PlotWidget* spectrum_;
    PlotGroup* spectrumGroup_;
    std::vector<MinMaxPyramid> curves_; // of the spectrum
    QTableWidget* statistics_;
};

} // namespace touchdown

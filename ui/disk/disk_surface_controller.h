// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes the surfaces of the disk page beside the window, always for the latest case that was requested. A surface that
// is out of date when it is ready is discarded.
#pragma once

#include <functional>
#include <optional>
#include <utility>

#include "ui/calculation/calculation_controller.h"
#include "ui/disk/disk_surface_preview.h"

namespace touchdown {

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
    void setPause(int milliseconds) { pause_.setInterval(milliseconds); }
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

} // namespace touchdown

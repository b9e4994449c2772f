// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes the surfaces of the page of the disk beside the window: one thread, which takes the latest case that was asked
// for. A surface that is no longer wanted when it is ready is thrown away.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include <QObject>
#include <QTimer>

#include "ui/disk/disk_surface_preview.h"

namespace touchdown {

class DiskSurfaceController : public QObject {
    Q_OBJECT

public:
    using Maker = std::function<DiskSurfacePreview(const Case&)>;

    /// `maker` is `previewOf`, or what stands for it in a test.
    explicit DiskSurfaceController(Maker maker, QObject* parent = nullptr);
    /// Waits for the surface under way.
    ~DiskSurfaceController() override;

    /// Begins when no other case was asked for in the last quarter of a second, or in that time.
    void request(const Case& c);
    void setPause(int milliseconds) { pause_.setInterval(milliseconds); }
    /// What was asked for is no longer wanted.
    void cancel();
    bool busy() const { return busy_; }
    /// The surface that was made last.
    DiskSurfacePreview take() { return std::move(made_); }

signals:
    /// What was asked for is ready to be taken.
    void made();

protected:
    void customEvent(QEvent* event) override;

private:
    void begin();
    void work(const std::stop_token& stop);

    Maker maker_;
    QTimer pause_; // until typing has come to an end
    Case wanted_;
    bool busy_ = false;
    int number_ = 0; // of what is wanted
    DiskSurfacePreview made_;

    std::mutex mailbox_;
    std::condition_variable_any asked_;
    std::optional<std::pair<int, Case>> order_;
    std::optional<std::pair<int, DiskSurfacePreview>> ready_;
    std::jthread thread_; // last, so that it ends before what it uses
};

} // namespace touchdown

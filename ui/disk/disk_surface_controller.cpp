// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/disk/disk_surface_controller.h"

#include <exception>
#include <utility>

#include <QCoreApplication>
#include <QEvent>

namespace touchdown {

namespace {

constexpr int quiet = 250; // [ms]
constexpr auto mailEvent = QEvent::User;

} // namespace

DiskSurfaceController::DiskSurfaceController(Maker maker, QObject* parent) : QObject(parent), maker_(std::move(maker))
{
    pause_.setSingleShot(true);
    pause_.setInterval(quiet);
    connect(&pause_, &QTimer::timeout, this, &DiskSurfaceController::begin);
}

DiskSurfaceController::~DiskSurfaceController() = default;

void DiskSurfaceController::request(const Case& c)
{
    wanted_ = c;
    busy_ = true;
    ++number_;
    pause_.start();
}

void DiskSurfaceController::cancel()
{
    pause_.stop();
    busy_ = false;
    ++number_;
}

void DiskSurfaceController::begin()
{
    {
        const std::lock_guard lock(mailbox_);
        order_ = {number_, wanted_};
    }
    asked_.notify_one();
    if (!thread_.joinable()) thread_ = std::jthread([this](const std::stop_token& stop) { work(stop); });
}

void DiskSurfaceController::work(const std::stop_token& stop)
{
    for (;;) {
        std::pair<int, Case> order;
        {
            std::unique_lock lock(mailbox_);
            if (!asked_.wait(lock, stop, [this] { return order_.has_value(); })) return;
            order = std::move(*order_);
            order_.reset();
        }
        DiskSurfacePreview preview;
        try {
            preview = maker_(order.second);
        } catch (const std::exception& problem) { // a map that is too large for the memory
            preview = {};
            preview.problem = std::string("The surface cannot be made: ") + problem.what();
        }
        {
            const std::lock_guard lock(mailbox_);
            ready_ = {order.first, std::move(preview)};
        }
        QCoreApplication::postEvent(this, new QEvent(mailEvent));
    }
}

void DiskSurfaceController::customEvent(QEvent* event)
{
    if (event->type() != mailEvent) return;
    std::optional<std::pair<int, DiskSurfacePreview>> ready;
    {
        const std::lock_guard lock(mailbox_);
        ready = std::exchange(ready_, std::nullopt);
    }
    if (!ready || ready->first != number_) return;
    busy_ = false;
    made_ = std::move(ready->second);
    emit made();
}

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calculation/task_queue.h"

#include <exception>
#include <utility>

#include "ui/style/translate.h"

namespace touchdown {

TaskQueue::TaskQueue(QObject* parent) : QObject(parent), thread_([this](const std::stop_token& stop) { work(stop); }) {}

TaskQueue::~TaskQueue()
{
    thread_.request_stop();
    thread_.join();
}

void TaskQueue::post(Task task, Then then, std::size_t bytes)
{
    {
        const std::lock_guard lock(mutex_);
        entries_.push_back({std::move(task), std::move(then), bytes});
        bytes_ += bytes;
    }
    changed_.notify_all();
}

std::size_t TaskQueue::pending() const
{
    const std::lock_guard lock(mutex_);
    return bytes_;
}

void TaskQueue::wait()
{
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return entries_.empty(); });
}

void TaskQueue::work(const std::stop_token& stop)
{
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, stop, [this] { return !entries_.empty(); });
        if (entries_.empty()) return; // stopped, with nothing left to do
        Task task = std::move(entries_.front().task);
        lock.unlock();
        QString problem;
        try {
            problem = task();
        } catch (const std::exception& error) {
            problem = QString::fromUtf8(error.what());
        }
        task = {}; // frees its memory without the lock
        lock.lock();
        if (Then then = std::move(entries_.front().then); then && !stop.stop_requested())
            QMetaObject::invokeMethod(
                this, [then = std::move(then), problem] { then(problem); }, Qt::QueuedConnection);
        bytes_ -= entries_.front().bytes;
        entries_.pop_front();
        changed_.notify_all();
    }
}

} // namespace touchdown

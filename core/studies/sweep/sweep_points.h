// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rows of a sweep by its points: what a table, a curve or a map of it shows at each.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/studies/study/item_study.h"
#include "core/studies/sweep/sweep_task.h"

namespace touchdown {

/// The items that are one row of the table: those of an averaged axis together.
struct SweepPoint {
    std::vector<SweepValue> at; // of the axes that are not averaged over
    std::vector<const ItemRow*> rows{};
    std::size_t items = 0; // that there are when all are done
};

/// A row holds a value for each reading of the task, then the file of its run where they are kept, then the problem of
/// the item, "" for none. Task and rows must last.
class SweepPoints {
public:
    SweepPoints(const SweepTask& task, const ItemRows& rows);

    const SweepTask& task() const { return task_; }
    const ItemRows& rows() const { return rows_; }
    /// In the order of the items.
    const std::vector<SweepPoint>& points() const { return points_; }
    /// Those that are not averaged over.
    std::size_t axes() const { return axes_.size(); }
    const SweepAxis& axis(std::size_t k) const { return task_.axes[axes_[k]]; }
    bool averages() const { return axes_.size() < task_.axes.size(); }
    const Reading& reading(std::size_t r) const { return task_.readings[r]; }
    std::size_t readings() const { return task_.readings.size(); }
    /// Readings that are numbers and no stated errors.
    std::vector<std::size_t> drawn() const;

    /// The numbers of a point's items that have one.
    std::vector<double> numbers(const SweepPoint& point, std::size_t reading) const;
    /// Their mean; the text that most items have.
    StudyValue valueOf(const SweepPoint& point, std::size_t reading) const;
    /// The same as a number; NaN where there is none.
    double numberOf(const SweepPoint& point, std::size_t reading) const;
    /// "6.2 nm", "bounces", "no value".
    std::string textOf(const SweepPoint& point, std::size_t reading) const;
    /// "Static flying height 7 nm, meniscus force 5 mN".
    std::string nameOf(const SweepPoint& point) const;

    const std::string& problemOf(const ItemRow& row) const;
    /// Of the point's items; "" where all have a valid end.
    std::string firstProblem(const SweepPoint& point) const;

    ChartAxis chartAxis(const SweepAxis& axis) const;
    ChartAxis chartAxis(const Reading& reading) const;

private:
    const SweepTask& task_;
    const ItemRows& rows_;
    std::vector<std::size_t> axes_; // places in the task's axes
    std::vector<SweepPoint> points_;
};

} // namespace touchdown

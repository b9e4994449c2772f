// SPDX-License-Identifier: GPL-3.0-or-later
//
// The static state of a slider while it is shaped: of each position of the mouse on a coarse grid, from the state of
// the position before, one solution at a time. A newer position waits, and replaces one that waits already.
#pragma once

#include <optional>

#include "ui/film/steady_controller.h"

namespace touchdown {

class ShapeFollower : public QObject {
    Q_OBJECT

public:
    /// The state of a case near that of another one, or from nothing: `touchdown::steadyNear` or a stand-in of a test.
    using Solver =
        std::function<SteadyResult(const Case&, const Case& before, const SteadyResult& from, const SteadyCallback&)>;
    explicit ShapeFollower(Solver solver, QObject* parent = nullptr);

    /// Returns at once.
    void follow(const Case& c);
    /// Forgets what waits, and the solution under way.
    void forget();
    /// Something is still to be followed.
    bool busy() const { return wanted_ != 0 || waiting_.has_value(); }

    /// The case on at most 65 x 65 nodes, for its attitude alone.
    static Case coarse(const Case& c);

signals:
    void followed(const touchdown::SteadyResult& result);

private:
    void startNext();

    Case before_, solving_; // changed only between two solutions, as is the next
    SteadyResult from_;     // the state of the case before; empty: none
    std::optional<Case> waiting_;
    int wanted_ = 0;              // number of the solution under way; 0: none, or it is forgotten
    SteadyController controller_; // the last member: its thread uses the others
};

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/springs/springs_over_disk.h"

#include <algorithm>

#include "core/physics/disk/disk_passage.h"
#include "core/simulation/springs/spring_integration.h"
#include "core/simulation/springs/spring_recorder.h"

namespace touchdown {

std::array<SpringModel::Guards, 5> SpringsOverDisk::guardPath(const std::array<State, 5>& c) const
{
    const double begin = c.front()[2], length = c.back()[2] - begin;
    const SpringModel::Under first = disk_.at(begin), last = disk_.at(c.back()[2]);
    const Guards middle = disk_.at(begin + 0.5 * length).height;
    std::array<Guards, 5> w;
    w[0] = first.height;
    w[1] = first.height + 0.25 * length * first.rate;
    w[3] = last.height - 0.25 * length * last.rate;
    w[4] = last.height;
    w[2] = (16.0 * middle - w[0] - 4.0 * w[1] - 4.0 * w[3] - w[4]) / 6.0;
    std::array<Guards, 5> path;
    for (std::size_t k = 0; k < path.size(); ++k) path[k] = model_.guards(c[k].head<2>(), w[k]);
    return path;
}

double SpringsOverDisk::period(const State& y, Mode mode) const
{
    const Guards at = guards(y.head<3>());
    const double own = model_.period(model_.jacobianAt(at, mode));
    return std::min(own, passageParts * disk_.longestStep());
}

Eigen::Matrix<double, 3, 6> SpringsOverDisk::jacobian(const State& y, Mode mode) const
{
    const Guards at = guards(y.head<3>());
    const Eigen::Matrix<double, 2, 4> j = model_.jacobianAt(at, mode);
    Eigen::Matrix<double, 3, 6> all = Eigen::Matrix<double, 3, 6>::Zero();
    all.topLeftCorner<2, 2>() = j.leftCols<2>();
    all.block<2, 2>(0, 3) = j.rightCols<2>();
    return all;
}

IntegrationResult integrateOverDisk(const SpringModel& model, const DiskUnderSprings& disk, const Case& c, double step,
                                    SpringRecorder& recorder)
{
    const SpringsOverDisk system(model, disk, c.run.duration);
    return integrateSprings(system, c, step, model.shortestPeriod(), recorder);
}

} // namespace touchdown

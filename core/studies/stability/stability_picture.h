// SPDX-License-Identifier: GPL-3.0-or-later
//
// The linear picture of stability: how much each method changes a small motion per step (numerics/stability_region.h),
// with the case's own eigenvalues.
//
// Springs: eigenvalues of the model's Jacobian in the static state, where an air spring is stiffest on the way of the
// case's own run, and in contact; rk4, dopri5 and newmark with the case's parameters. cvode's Adams methods change
// order and step as they go and have no one region.
//
// Film: the modes of the static state, as lambda = omega (-zeta +- i sqrt(1 - zeta^2)); Euler, BDF2 and BDF2OPT for the
// air, the trapezoidal rule and Fox & Goodwin's for the slider, and both together. A slider on a film that is a spring
// with a leak has the eigenvalues of its mode where s = 2 zeta omega, as lambda^2 + s lambda + omega^2 = 0; so the
// coupled charts are those of the mode.
#pragma once

#include <functional>

namespace touchdown {

struct Case;
struct StudyReport;

/// Adds charts, tables and sentences to the report; its message tells why there are none. False where `goOn`, asked
/// about every 50 ms, said so.
bool makeLinearPicture(const Case& c, StudyReport& picture, const std::function<bool()>& goOn);

} // namespace touchdown

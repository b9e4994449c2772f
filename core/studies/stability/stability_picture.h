// SPDX-License-Identifier: GPL-3.0-or-later
//
// The linear picture of stability: how much each method changes a small motion per step (numerics/stability_region.h),
// with the case's own eigenvalues.
//
// Springs: eigenvalues of the model's Jacobian in the static state, where an air spring is stiffest during the case's
// own run, and in contact; rk4, dopri5 and newmark with the case's parameters. cvode's Adams methods change order and
// step and have no single region.
//
// Film: the modes of the static state, lambda = omega (-zeta +- i sqrt(1 - zeta^2)); Euler, BDF2, BDF2OPT and the
// fitted formula for the air, the trapezoidal rule and Fox & Goodwin's for the slider, and both together. A slider on a
// film that is a spring with a leak has the eigenvalues of its mode if s = 2 zeta omega, since lambda^2 + s lambda +
// omega^2 = 0; the coupled charts are those of that mode.
#pragma once

#include <functional>

namespace touchdown {

struct Case;
struct StudyReport;

/// Adds charts, tables and sentences to the report; its message tells why there are none. False where `goOn`, asked
/// about every 50 ms, said so.
bool makeLinearPicture(const Case& c, StudyReport& picture, const std::function<bool()>& goOn);

} // namespace touchdown

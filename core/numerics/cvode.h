// SPDX-License-Identifier: GPL-3.0-or-later
//
// `cvode`: variable-order Adams methods of SUNDIALS (Hindmarsh et al. 2005) with its root finding, for comparison.
//
// The mode is frozen until a root is returned, then the solver restarts. CVODE looks for changes of sign between steps
// only, so a contact that touches and leaves within one step can be missed. SUNDIALS is optional: without it
// TOUCHDOWN_HAVE_CVODE is not defined and `haveCvode` is false.
#pragma once

#include "core/numerics/adaptive.h"

#ifdef TOUCHDOWN_HAVE_CVODE
#include <algorithm>
#include <memory>

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#endif

namespace touchdown {

#ifdef TOUCHDOWN_HAVE_CVODE

inline constexpr bool haveCvode = true;

namespace cvode {

using Context = std::unique_ptr<std::remove_pointer_t<SUNContext>, decltype([](SUNContext c) { SUNContext_Free(&c); })>;
using Vector = std::unique_ptr<std::remove_pointer_t<N_Vector>, decltype([](N_Vector v) { N_VDestroy(v); })>;
using Matrix = std::unique_ptr<std::remove_pointer_t<SUNMatrix>, decltype([](SUNMatrix m) { SUNMatDestroy(m); })>;
using Solver =
    std::unique_ptr<std::remove_pointer_t<SUNLinearSolver>, decltype([](SUNLinearSolver s) { SUNLinSolFree(s); })>;
using Memory = std::unique_ptr<void, decltype([](void* m) { CVodeFree(&m); })>;

/// What the callbacks see.
template <SwitchedSystem System>
struct View {
    const System& system;
    GuardWatch<System> watch;
};

template <class State>
Eigen::Map<State> map(N_Vector v)
{
    return Eigen::Map<State>(N_VGetArrayPointer(v));
}

} // namespace cvode

/// Integrates from `start` over [0, until]; recorder as in adaptive.h. Allocates.
template <SwitchedSystem System, class Recorder>
IntegrationResult integrateCvode(const System& system, Start<System> start, double until,
                                 const AdaptiveOptions& options, Recorder& recorder)
{
    using State = typename System::State;
    constexpr int size = State::RowsAtCompileTime;
    constexpr int guardEnds = 2 * System::guardCount; // lower and upper end of each guard's interval

    IntegrationResult result;
    SUNContext rawContext = nullptr;
    SUNContext_Create(nullptr, &rawContext);
    const cvode::Context context(rawContext);
    const cvode::Vector y(N_VNew_Serial(size, context.get()));
    const cvode::Vector tolerance(N_VNew_Serial(size, context.get()));
    const cvode::Vector work(N_VNew_Serial(size, context.get()));
    const cvode::Matrix matrix(SUNDenseMatrix(size, size, context.get()));
    const cvode::Solver solver(SUNLinSol_Dense(y.get(), matrix.get(), context.get()));
    const cvode::Memory memory(CVodeCreate(CV_ADAMS, context.get()));
    void* const cv = memory.get();

    cvode::View<System> view{system, GuardWatch<System>(system, start.mode)};
    cvode::map<State>(y.get()) = start.y;
    cvode::map<State>(tolerance.get()) = options.tolerance * system.scale();

    const CVRhsFn derivative = [](realtype, N_Vector at, N_Vector rate, void* data) {
        const auto& v = *static_cast<cvode::View<System>*>(data);
        cvode::map<State>(rate) = v.system.derivative(cvode::map<State>(at), v.watch.mode());
        return cvode::map<State>(rate).allFinite() ? 0 : 1; // 1: try a shorter step
    };
    const CVRootFn ends = [](realtype, N_Vector at, realtype* inside, void* data) {
        const auto& v = *static_cast<cvode::View<System>*>(data);
        for (int i = 0; i < System::guardCount; ++i) {
            for (const bool upper : {false, true}) {
                const double distance = v.watch.inside(cvode::map<State>(at), i, upper);
                inside[2 * i + upper] = std::isfinite(distance) ? distance : 1.0;
            }
        }
        return 0;
    };
    const CVLsJacFn jacobian = [](realtype, N_Vector at, N_Vector, SUNMatrix j, void* data, N_Vector, N_Vector,
                                  N_Vector) {
        const auto& v = *static_cast<cvode::View<System>*>(data);
        Eigen::Map<Eigen::Matrix<double, size, size>> out(SUNDenseMatrix_Data(j));
        out.setZero();
        out.template topRightCorner<size / 2, size / 2>().setIdentity();
        out.template bottomRows<size / 2>() = v.system.jacobian(cvode::map<State>(at), v.watch.mode());
        return 0;
    };

    std::array<int, guardEnds> falling;
    falling.fill(-1);
    CVodeInit(cv, derivative, 0.0, y.get());
    CVodeSVtolerances(cv, 4.0 * std::numeric_limits<double>::epsilon(),
                      tolerance.get()); // not below round-off, as in adaptive.h
    CVodeSetUserData(cv, &view);
    CVodeSetLinearSolver(cv, solver.get(), matrix.get());
    CVodeSetJacFn(cv, jacobian);
    CVodeRootInit(cv, guardEnds, ends);
    CVodeSetRootDirection(cv, falling.data());
    CVodeSetNoInactiveRootWarn(cv);
    CVodeSetErrHandlerFn(
        cv, [](int, const char*, const char*, char*, void*) {}, nullptr);
    CVodeSetMaxNumSteps(cv, -1);
    CVodeSetStopTime(cv, until);
    if constexpr (requires { system.longestStep(); }) CVodeSetMaxStep(cv, system.longestStep());

    // CVODE resets its counts at each switch.
    const auto count = [&] {
        long evaluations = 0;
        long failures = 0;
        CVodeGetNumRhsEvals(cv, &evaluations);
        CVodeGetNumErrTestFails(cv, &failures);
        result.evaluations += evaluations;
        result.rejectedSteps += failures;
    };
    realtype t = 0.0;
    while (t < until) {
        const realtype begin = t;
        const int flag = CVode(cv, until, y.get(), &t, CV_ONE_STEP);
        if (flag < 0) {
            result.end = flag == CV_CONV_FAILURE  ? IntegrationEnd::NewtonFailed
                         : flag == CV_ERR_FAILURE ? IntegrationEnd::StepUnderflow
                                                  : IntegrationEnd::Diverged;
            break;
        }
        const State y1 = cvode::map<State>(y.get());
        if (!y1.allFinite()) {
            result.end = IntegrationEnd::Diverged;
            break;
        }
        ++result.steps;
        result.time = t;
        const auto at = [&](double s) {
            CVodeGetDky(cv, s, 0, work.get());
            return State(cvode::map<State>(work.get()));
        };
        if (t > begin && !recorder.step(t, y1, view.watch.mode(), at)) {
            result.end = IntegrationEnd::Stopped;
            break;
        }
        // CVODE looks for roots a little after a restart, so a guard that turns back at once crosses unseen.
        std::array<int, guardEnds> found{};
        if (flag == CV_ROOT_RETURN) {
            CVodeGetRootInfo(cv, found.data());
        } else {
            constexpr double certain = 1e3; // resolutions beyond an end
            for (int i = 0; i < guardEnds; ++i)
                found[static_cast<std::size_t>(i)] =
                    view.watch.inside(y1, i / 2, i % 2 == 1) < -certain * view.watch.resolution(y1, i / 2, t);
            if (std::ranges::all_of(found, [](int each) { return each == 0; })) continue;
        }
        bool tooMany = false;
        for (int i = 0; i < guardEnds; ++i) {
            if (found[static_cast<std::size_t>(i)] == 0) continue;
            tooMany = !view.watch.cross(t, i / 2, i % 2 == 1, y1, recorder) || tooMany;
        }
        if (tooMany) {
            result.end = IntegrationEnd::Chattering;
            break;
        }
        count();
        CVodeReInit(cv, t, y.get());
    }
    count();
    return result;
}

#else

inline constexpr bool haveCvode = false;

/// Declared for `if constexpr (haveCvode)`, which looks the name up in either configuration; never called.
template <SwitchedSystem System, class Recorder>
IntegrationResult integrateCvode(const System& system, Start<System> start, double until,
                                 const AdaptiveOptions& options, Recorder& recorder);

#endif

} // namespace touchdown

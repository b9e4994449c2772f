// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/recording/run_summary.h"

#include "core/formats/units.h"

namespace touchdown {

std::string_view name(RunStatus status)
{
    switch (status) {
    case RunStatus::Completed: return "completed";
    case RunStatus::Cancelled: return "cancelled";
    case RunStatus::Diverged: return "diverged";
    case RunStatus::Failed: return "failed";
    }
    return {};
}

std::string_view name(Motion motion)
{
    switch (motion) {
    case Motion::NotJudged: return "not judged";
    case Motion::AtRest: return "at rest";
    case Motion::Settles: return "settles";
    case Motion::Swings: return "swings";
    case Motion::Vibrates: return "vibrates in contact";
    case Motion::Bounces: return "bounces";
    case Motion::TooShort: return "too short to tell";
    }
    return {};
}

std::string_view name(Touch touch)
{
    switch (touch) {
    case Touch::Never: return "flying";
    case Touch::AtTimes: return "in and out of contact";
    case Touch::Always: return "contact";
    }
    return {};
}

std::string textOf(const MotionVerdict& verdict)
{
    std::string text(name(verdict.motion));
    const std::string frequency = verdict.frequency > 0.0 ? fewDigits(verdict.frequency, "kHz", 3) : std::string();
    if (verdict.forced)
        return text + ", forced by the disk (" + (frequency.empty() ? frequency : frequency + ", ") +
               fewDigits(verdict.rms, "nm") + " rms)";
    return lasts(verdict.motion) && !frequency.empty() ? text + " at " + frequency : text;
}

std::string_view name(RunFailure failure)
{
    switch (failure) {
    case RunFailure::None: return "";
    case RunFailure::Diverged: return "the motion diverged";
    case RunFailure::NegativeEnergy: return "the total energy became negative";
    case RunFailure::Chattering: return "chattering";
    case RunFailure::FrontSpringLost: return "the front air spring is lost for good";
    case RunFailure::RearSpringLost: return "the rear air spring is lost for good";
    case RunFailure::Tunnelled: return "a step tunnelled through an air spring";
    case RunFailure::NoStep: return "no step was short enough";
    case RunFailure::NotConverged: return "the solution did not converge";
    case RunFailure::Other: return "it could not go on";
    }
    return {};
}

Summary refusedRun(std::string reason)
{
    Summary refused;
    refused.status = RunStatus::Failed;
    refused.failure = RunFailure::Other;
    refused.message = std::move(reason);
    return refused;
}

} // namespace touchdown

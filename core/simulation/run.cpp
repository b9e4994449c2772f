// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/run.h"

#include "core/case/contact_patches.h"
#include "core/case/disk_setup.h"
#include "core/case/parameters.h"
#include "core/numerics/cvode.h"
#include "core/simulation/contact/contact_model.h"
#include "core/simulation/contact/contact_run.h"
#include "core/simulation/contact/slider_contact.h"
#include "core/simulation/flight/film_run.h"
#include "core/simulation/springs/spring_model.h"
#include "core/simulation/springs/spring_run.h"

namespace touchdown {

std::string reasonNotToRun(const Case& c)
{
    if (c.model == ModelKind::Springs)
        return c.run.integrator == IntegratorKind::Cvode && !haveCvode
                   ? "this program was built without SUNDIALS, so the integrator cvode is missing"
                   : "";
    // A file may have changed since the case was read.
    if (const auto problems = diskFileProblems(c); !problems.empty()) return problems.front().text();
    if (c.model == ModelKind::Contact && usesSliderSurface(c)) return patchesOf(c, diskTopography(c)).problem;
    return {};
}

std::vector<Quantity> recordedQuantities(const Case& c)
{
    switch (c.model) {
    case ModelKind::Springs: return SpringModel::quantities(c);
    case ModelKind::Contact: return contactQuantities(c);
    case ModelKind::Film: return filmQuantities(c);
    }
    return {};
}

std::vector<RecordedFields> recordedFields(const Case& c)
{
    std::vector<RecordedFields> sets;
    if (c.model == ModelKind::Contact) sets.push_back(contactMaps(c));
    if (c.model == ModelKind::Film) sets = {filmMaps(c), sliderContactFields(c)};
    std::erase_if(sets, [](const RecordedFields& set) { return set.empty(); });
    return sets;
}

Summary run(const Case& c, const RunCallback& callback, const RunOptions& options)
{
    if (const std::string reason = reasonNotToRun(c); !reason.empty()) {
        Summary refused;
        refused.status = RunStatus::Failed;
        refused.failure = RunFailure::Other;
        refused.message = reason;
        refused.model = toText(c, *findParameter("model"));
        return refused;
    }
    Summary summary;
    switch (c.model) {
    case ModelKind::Springs:
        summary = runSprings(c, callback, options);
        summary.integrator = toText(c, *findParameter("run.integrator"));
        break;
    case ModelKind::Contact:
        summary = runContact(c, callback);
        summary.integrator = "quasi-static";
        break;
    case ModelKind::Film:
        summary = runFilm(c, callback);
        summary.integrator = toText(c, *findParameter("film.coupling"));
        break;
    }
    summary.model = toText(c, *findParameter("model"));
    return summary;
}

} // namespace touchdown

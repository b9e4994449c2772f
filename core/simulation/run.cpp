// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/run.h"

#include <algorithm>

#include "core/case/contact_law.h"
#include "core/case/contact_patches.h"
#include "core/case/disk_setup.h"
#include "core/case/integrator_kind.h"
#include "core/case/parameters.h"
#include "core/numerics/cvode.h"
#include "core/simulation/contact/contact_model.h"
#include "core/simulation/contact/contact_run.h"
#include "core/simulation/contact/slider_contact.h"
#include "core/simulation/flight/film_run.h"
#include "core/simulation/springs/spring_model.h"
#include "core/simulation/springs/spring_run.h"
#include "core/simulation/static_state/film_setup.h"
#include "core/work/state_stream.h"
#include "core/work/team.h"

namespace touchdown {

namespace {

std::string reasonNotToRun(const Case& c, const DiskFileCheck& disk)
{
    if (c.model == ModelKind::Springs && c.run.integrator == IntegratorKind::Cvode && !haveCvode)
        return "this program was built without SUNDIALS, so the integrator cvode is missing";
    if (!disk.problems.empty()) return disk.problems.front().text();
    if (c.model == ModelKind::Contact && usesSliderSurface(c)) return patchesOf(c, diskTopography(c)).problem;
    return {};
}

} // namespace

std::string reasonNotToRun(const Case& c) { return reasonNotToRun(c, checkDiskFile(c)); }

std::vector<Quantity> recordedQuantities(const Case& c)
{
    switch (c.model) {
    case ModelKind::Springs: return SpringModel::quantities(c);
    case ModelKind::Contact: return contactQuantities(c);
    case ModelKind::Film: return filmQuantities(c);
    }
    return {};
}

bool recordsFields(const Case& c)
{
    return c.run.fieldSnapshots > 0 && ((c.model == ModelKind::Film && c.film.motion == FilmMotion::Full) ||
                                        (c.model == ModelKind::Contact && contactLaw(c).recordsSurfaces));
}

std::vector<RecordedFields> recordedFields(const Case& c, const std::function<bool()>& goOn)
{
    std::vector<RecordedFields> sets;
    if (c.model == ModelKind::Contact) sets.push_back(contactMaps(c));
    if (c.model == ModelKind::Film && c.film.motion == FilmMotion::Full)
        sets = {filmMaps(c), sliderContactFields(c, goOn)};
    std::erase_if(sets, [](const RecordedFields& set) { return set.empty(); });
    return sets;
}

namespace {

/// What the characteristic does to the energy: W, and what its touch-downs brought. Their F_cr begins at f_c0, not at
/// zero, so that each adds the elastic energy of f_c0 that the slider did no work for.
void addCharacteristicFigures(const OnoYamane& parameters, Summary& summary)
{
    const OnoYamaneLaw law(parameters);
    const auto touchDowns =
        std::ranges::count(summary.events, switchName(ContactRegion::Apart, ContactRegion::Pressed), &RunEvent::name);
    const double each = law.storedEnergy(ContactRegion::Pressed, parameters.touchDown);
    summary.figures.push_back(
        {{"cycle_work", "J", "pJ", "Work W that a touch-down and take-off takes out of the slider"}, law.cycleWork()});
    summary.figures.push_back({{"touch_downs", "1", "1", "Touch-downs"}, static_cast<double>(touchDowns), true});
    summary.figures.push_back({{"touch_down_energy", "J", "pJ", "Elastic energy that the touch-downs brought"},
                               static_cast<double>(touchDowns) * each});
}

/// How much the flying height above a disk that is not flat changes in the last tenth of a run. One that holds few
/// samples does not tell.
void addModulation(const Case& c, Summary& summary)
{
    constexpr double fewestSamples = 10.0;
    if (summary.status != RunStatus::Completed || 0.1 * c.run.duration < fewestSamples * c.run.sampleInterval) return;
    const Statistics* height = valueIn(summary.tail, "flying_height_above_disk");
    if (!height) return;
    summary.figures.push_back({{"flying_height_modulation", "m", "nm",
                                "Flying height modulation over the last tenth, above the disk, peak to peak"},
                               height->max - height->min});
    summary.figures.push_back({{"flying_height_modulation_rms", "m", "nm",
                                "Flying height modulation over the last tenth, above the disk, RMS"},
                               height->std});
}

Summary runFilmOnTeam(const Case& c, const RunCallback& callback, const RunOptions& options)
{
    const TeamScope team(filmThreads(c));
    Summary summary = runFilm(c, callback, options);
    summary.threads = Team::mine().size();
    return summary;
}

} // namespace

Summary run(const Case& c, const RunCallback& callback, const RunOptions& options)
{
    const DiskFileCheck disk = checkDiskFile(c); // its file may have changed since the case was read
    if (const std::string reason = reasonNotToRun(c, disk); !reason.empty()) {
        Summary refused = refusedRun(reason);
        refused.model = toText(c, *findParameter("model"));
        return refused;
    }
    Summary summary;
    try {
        switch (c.model) {
        case ModelKind::Springs:
            summary = runSprings(c, callback, options);
            summary.integrator = toText(c, *findParameter("run.integrator"));
            break;
        case ModelKind::Contact:
            summary = runContact(c, callback, options);
            summary.integrator = "quasi-static";
            break;
        case ModelKind::Film:
            summary = runFilmOnTeam(c, callback, options);
            summary.integrator =
                toText(c, *findParameter(c.film.motion == FilmMotion::Linear ? "film.motion" : "film.coupling"));
            break;
        }
    } catch (const StateMisfit& misfit) {
        summary = refusedRun("the run cannot be continued from its checkpoint: " + std::string(misfit.what()));
    }
    summary.model = toText(c, *findParameter("model"));
    addModulation(c, summary);
    if (const auto law = characteristic(c)) addCharacteristicFigures(*law, summary);
    for (const CaseProblem& warning : caseWarnings(c)) summary.warnings.push_back(warning.message);
    for (const InputProblem& warning : disk.warnings) summary.warnings.push_back(warning.text());
    return summary;
}

} // namespace touchdown

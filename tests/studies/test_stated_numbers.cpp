// SPDX-License-Identifier: GPL-3.0-or-later
//
// The numbers that the cards of the sample cases, the comments of the sample studies, the help and README.md state:
// each one with a unit is that of a run, a value of the file itself, or a constant with its source. What takes too long
// for a test is a constant here, and its source says which command or table gives it. The numbers of the lesson and of
// the demonstrations: tests/studies/lesson.
#include <functional>
#include <map>
#include <numbers>

#include <QFile>
#include <QTest>

#include "core/case/parameters.h"
#include "core/case_files/case_settings.h"
#include "core/formats/csv_cell.h"
#include "core/formats/toml_document.h"
#include "core/formats/units.h"
#include "core/physics/contact/contact_bodies.h"
#include "core/physics/contact/ono_yamane.h"
#include "core/simulation/reference_frequencies.h"
#include "core/simulation/run.h"
#include "core/simulation/static_state/steady.h"
#include "core/studies/runs/ensemble.h"
#include "core/studies/study/sample_study.h"
#include "core/studies/study_plan.h"
#include "tests/support/amounts.h"
#include "tests/support/sample_case.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_stated_numbers {

using Settings = std::vector<CaseSetting>;

Case changed(const std::string& name, const Settings& settings)
{
    Case c = sample(name);
    if (const auto problem = changeCase(c, settings)) qFatal("%s", problem->text().c_str());
    return c;
}

struct Ran {
    Summary summary;
    std::vector<Quantity> quantities;
    SampleBatch samples;
    const std::vector<double>& of(const char* quantity) const
    {
        return samples.columns.at(std::size_t(findQuantity(quantities, quantity)));
    }
};

QString textOf(const QString& path)
{
    QFile file(QStringLiteral(TOUCHDOWN_SOURCE_DIR "/") + path);
    if (!file.open(QIODevice::ReadOnly)) qFatal("%s cannot be read", qPrintable(path));
    return QString::fromUtf8(file.readAll());
}

/// Each run once.
const Ran& ran(const std::string& name, const Settings& settings = {})
{
    static std::map<std::string, Ran> all;
    std::string key = name;
    for (const CaseSetting& setting : settings) key += ' ' + setting.key + '=' + setting.value;
    const auto [place, isNew] = all.emplace(key, Ran{});
    if (!isNew) return place->second;
    Ran& made = place->second;
    const Case c = changed(name, settings);
    made.quantities = recordedQuantities(c);
    made.samples.columns.resize(made.quantities.size());
    made.summary = run(c, [&](const RunUpdate& update) {
        made.samples.time.insert(made.samples.time.end(), update.samples.time.begin(), update.samples.time.end());
        for (std::size_t i = 0; i < made.quantities.size(); ++i)
            made.samples.columns[i].insert(made.samples.columns[i].end(), update.samples.columns[i].begin(),
                                           update.samples.columns[i].end());
        return true;
    });
    return made;
}

template <typename Pairs>
auto valueOf(const Pairs& pairs, const std::string& quantity)
{
    for (const auto& [name, value] : pairs)
        if (name == quantity) return value;
    qFatal("no %s", quantity.c_str());
}

double end(const std::string& name, const char* quantity, const Settings& settings = {})
{
    return valueOf(ran(name, settings).summary.final, quantity);
}

double height(const std::string& name, const Settings& settings = {}) // at the end [nm]
{
    return 1e9 * end(name, "flying_height", settings);
}

double pitch(const std::string& name, const Settings& settings = {}) // at the end [urad]
{
    return 1e6 * end(name, "pitch", settings);
}

double swing(const std::string& name, const char* quantity) // over the last tenth
{
    const Statistics tail = valueOf(ran(name).summary.tail, quantity);
    return tail.max - tail.min;
}

double figure(const std::string& name, const std::string& wanted, const Settings& settings = {})
{
    for (const RunFigure& each : ran(name, settings).summary.figures)
        if (each.quantity.name == wanted) return each.value;
    qFatal("no figure %s", wanted.c_str());
}

double events(const std::string& name, const std::string& event)
{
    return double(std::ranges::count(ran(name).summary.events, event, &RunEvent::name));
}

double greatest(const std::string& name, const char* quantity, const Settings& settings = {}) // of the samples
{
    return std::ranges::max(ran(name, settings).of(quantity));
}

/// The mean time between passages of a level on the way up [s], and the mean ratio of the maxima between them.
struct Ringing {
    double period = 0.0, ratio = 0.0;
};
Ringing ringing(const std::string& name, double level)
{
    const std::vector<double>&time = ran(name).samples.time, &value = ran(name).of("flying_height");
    std::vector<double> passages, maxima;
    for (std::size_t i = 1; i < value.size(); ++i) {
        if (value[i - 1] < level && value[i] >= level) {
            const double share = (level - value[i - 1]) / (value[i] - value[i - 1]);
            passages.push_back(time[i - 1] + share * (time[i] - time[i - 1]));
            maxima.push_back(0.0);
        }
        if (!maxima.empty()) maxima.back() = std::max(maxima.back(), value[i] - level);
    }
    const double count = double(passages.size()) - 2.0; // the last maximum may lie behind the end
    return {(passages.back() - passages.front()) / (count + 1.0),
            std::pow(maxima[maxima.size() - 2] / maxima.front(), 1.0 / count)};
}

const SteadyResult& rests(const std::string& name)
{
    static std::map<std::string, SteadyResult> all;
    const auto [place, isNew] = all.emplace(name, SteadyResult{});
    if (isNew) place->second = steady(sample(name));
    return place->second;
}

double atmospheres(const std::string& name, double pressure) // absolute [Pa]
{
    return pressure / std::get<double>(findParameter("air.pressure")->get(sample(name)));
}

double coarseLoad(const char* scheme) // of film_plane [gf]
{
    const Case c = changed("film_plane", {{"film.nodes", "[33, 33]"}, {"film.scheme", scheme}});
    return steady(c).forces.net / unitFactor("gf");
}

/// Of results_amd_epyc.csv, which touchdown-bench writes: of fig10a.
double measured(const std::string& integrator, const std::string& setting, const std::string& title)
{
    const std::vector<std::vector<std::string>> rows =
        csvRows(textOf("tests/bench/results_amd_epyc.csv").toStdString());
    const auto column = std::size_t(std::ranges::find(rows[1], title) - rows[1].begin());
    for (const std::vector<std::string>& row : rows)
        if (row.size() > column && row[0] == "fig10a" && row[1] == integrator && row[2] == setting)
            return std::stod(row[column]);
    qFatal("no row of %s", integrator.c_str());
}

/// Force over area of the statistical surface where the force is this share of its largest [GPa].
double meanPressure(double share, const Settings& settings = {})
{
    const Ran& run = ran("contact_greenwood_williamson", settings);
    const std::vector<double>&force = run.of("contact_force"), &area = run.of("contact_area");
    const double wanted = share * std::ranges::max(force);
    std::size_t i = 0;
    while (force[i] < wanted) ++i;
    return 1e-9 * force[i] / area[i];
}

/// Where the row of the help with the command "touchdown run NAME" says that the run ends.
double endInHelp(const std::string& name)
{
    const std::vector<std::vector<std::string>> rows = csvRows(textOf("resources/help/paper.csv").toStdString());
    const auto column = [&](const char* title) { return std::ranges::find(rows[0], title) - rows[0].begin(); };
    for (const std::vector<std::string>& row : rows) {
        if (row[std::size_t(column("command"))] != "touchdown run " + name) continue;
        const std::string& found = row[std::size_t(column("found"))];
        if (found.starts_with("flies at") || found.starts_with("ends in contact at")) return amountsIn(found)[0].value;
    }
    qFatal("no row of %s", name.c_str());
}

double pullOff(double factor) // of the sphere of contact_pull_off: factor pi R dgamma [uN]
{
    const Case c = sample("contact_pull_off");
    return 1e6 * factor * std::numbers::pi * c.pad.radius * c.adhesion.surfaceEnergy;
}
double largestPull() { return 1e6 * figure("contact_pull_off", "pull_off_force"); } // [uN]

std::vector<double> forcesOfSeeds() // the largest of contact_rough with the seeds 1 to 4 [mN]
{
    std::vector<double> forces;
    for (const char* seed : {"1", "2", "3", "4"})
        forces.push_back(1e3 * figure("contact_rough", "largest_contact_force", {{"disk.surface.seed", seed}}));
    return forces;
}

double frequency(double stiffness, double mass) { return std::sqrt(stiffness / mass) / (2.0 * std::numbers::pi); }

/// Of a case of Fig. 8, above the disk [nm].
double startOf(const std::string& name)
{
    return 1e9 * (rests("film_fig4_pico").minimumSpacing + sample(name).initial.heightOffset);
}

/// A number after these words in the findings of `touchdown study hysteresis fig10a` [nm].
double hysteresis(const QString& words, std::size_t i)
{
    static const std::vector<std::string> findings = openStudy("hysteresis", "fig10a").perform(2, {}).findings;
    for (const std::string& finding : findings)
        if (const QString text = QString::fromStdString(finding); text.contains(words))
            return amountsIn(text.mid(text.indexOf(words))).at(i).value;
    qFatal("no %s", qPrintable(words));
}

/// Which of the 300 starts of precision_fig12b lose the rear spring. They do so near 50 us or not at all.
std::vector<bool> losesTheSpring(const Settings& method)
{
    Case c = changed("fig12b", method);
    c.run.duration = 0.12e-3;
    c.run.sampleInterval = 10e-6;
    c.run.stepCheck = false;
    std::vector<bool> loses;
    for (const double start : startsOf(c, EnsembleTask{})) {
        c.initial.flyingHeight = start;
        loses.push_back(run(c).failure == RunFailure::RearSpringLost);
    }
    return loses;
}

/// How many of them end otherwise by steps that do not locate the switches.
double otherEnds(const char* step)
{
    const std::vector<bool> located = losesTheSpring({});
    const std::vector<bool> naive = losesTheSpring({{"run.integrator", "rk4"}, {"run.step", step}});
    double count = 0.0;
    for (std::size_t i = 0; i < located.size(); ++i) count += located[i] != naive[i] ? 1.0 : 0.0;
    return count;
}

/// The lowest mode of the springs, or the next one [kHz].
double mode(const Case& c, std::size_t i) { return 1e-3 * referenceFrequencies(c).at(i).frequency; }

/// The case of a study of an oscillator with a stop: fig10a with the values of its table.
Case stopCase(const std::string& study)
{
    Settings settings;
    for (const TomlEntry& entry : readToml(findSampleStudy("response", study)->text).entries) {
        if (!entry.key.starts_with("set.")) continue;
        const auto* text = std::get_if<std::string>(&entry.value);
        const auto* number = std::get_if<double>(&entry.value);
        settings.push_back({entry.key.substr(4), text != nullptr     ? *text
                                                 : number != nullptr ? std::to_string(*number)
                                                                     : "0"});
    }
    return changed("fig10a", settings);
}

OnoYamane lawOf(const std::string& name, const Settings& settings) { return changed(name, settings).onoYamane; }
double workOf(const OnoYamane& law) { return 1e12 * OnoYamaneLaw(law).cycleWork(); } // [pJ]
double stepWork(const OnoYamane& law) // of the force with which contact begins [pJ]
{
    return 1e12 * law.initialContactForce * law.initialContactForce / (2.0 * law.contactStiffness);
}
double forceWithoutWork(const OnoYamane& law) { return 1e3 * meniscusForceForWork(law, 0.0); } // f_m with W = 0 [mN]

const Settings low{{"springs.flying_height", "3.2 nm"}, {"ono_yamane.take_off", "4 nm"}};
const Settings naive5ns{{"run.integrator", "rk4"}, {"run.step", "5 ns"}};
const Settings fig12a{{"ono_yamane.meniscus_force", "50 mN"}, {"springs.cutoff", "0.3 nm"}};
const Settings linear{{"ono_yamane.take_off_shape", "linear"}};
const Settings yields{{"asperity.model", "elastic-plastic"}, {"asperity.yield_strength", "0.2 GPa"}};

/// The words end with the number; its value comes in its unit.
struct Row {
    std::string place; // name of a case or study, file of the help, "README.md"
    std::string words;
    std::function<double()> found;
};

const std::vector<Row>& rows()
{
    static const std::vector<Row> all{
        {"advise_skew", "rolls by 11 urad", [] { return 1e6 * rests("advise_skew").attitude.roll; }},
        {"contact_greenwood_williamson", "grows from 0.36", [] { return meanPressure(1e-3); }},
        {"contact_greenwood_williamson", "to 0.55 GPa", [] { return meanPressure(1.0); }},
        {"contact_greenwood_williamson", "from 0.30", [] { return meanPressure(1e-3, yields); }},
        {"contact_greenwood_williamson", "to 0.31 GPa", [] { return meanPressure(1.0, yields); }},
        // No summit yields: the force is that of elastic summits.
        {"contact_greenwood_williamson", "default of 2 GPa",
         [] {
             const Settings may{{"asperity.model", "elastic-plastic"}};
             const bool same = figure("contact_greenwood_williamson", "largest_contact_force", may) ==
                               figure("contact_greenwood_williamson", "largest_contact_force");
             return same ? 1e-9 * Asperities{}.yieldStrength : NAN;
         }},
        {"contact_hertz", "p_0 = 0.171 GPa", [] { return 1e-9 * greatest("contact_hertz", "peak_contact_pressure"); }},
        {"contact_hertz", "hardness = \"0.1 GPa\"",
         [] {
             return 1e-9 * greatest("contact_hertz", "peak_contact_pressure", {{"elastic.hardness", "0.1 GPa"}});
         }},
        // Johnson, Kendall and Roberts, and Derjaguin, Muller and Toporov; the largest pull lies between.
        {"contact_pull_off", "4.7", [] { return pullOff(1.5) < largestPull() ? pullOff(1.5) : NAN; }},
        {"contact_pull_off", "4.7 and 6.3 uN", [] { return largestPull() < pullOff(2.0) ? pullOff(2.0) : NAN; }},
        {"contact_rough", "largest force is 0.48", [] { return std::ranges::min(forcesOfSeeds()); }},
        {"contact_rough", "to 0.58 mN", [] { return std::ranges::max(forcesOfSeeds()); }},
        {"fig05_fm_15mN", "preload of 14.71 mN", [] { return 1e3 * sample("fig05_fm_15mN").suspension.preload; }},
        {"fig06_de_4nm", "0.8 nm",
         [] { return 1e9 * (sample("fig06_de_4nm").onoYamane.takeOff - rests("film_fig4_pico").minimumSpacing); }},
        {"fig10a", "settles at 7 nm", [] { return height("fig10a"); }},
        {"fig10a", "pitch at 90.6 urad", [] { return pitch("fig10a"); }},
        {"fig10b", "at 3.120 nm",
         [] {
             const Settings fine{{"run.sample_interval", "1 ns"}, {"run.duration", "0.2 ms"}};
             return 1e9 * std::ranges::min(ran("fig10b", fine).of("rear_spacing"));
         }},
        {"fig10b", "they show 3.24 nm", [] { return 1e9 * std::ranges::min(ran("fig10b").of("rear_spacing")); }},
        {"fig10b_first_set", "falls to 1.69 nm",
         [] { return 1e9 * valueOf(ran("fig10b_first_set").summary.extremes, "rear_spacing").least; }},
        {"fig10b_first_set", "lost once", [] { return events("fig10b_first_set", "rear spring lost"); }},
        {"fig10b_first_set", "gives 93.2 urad",
         [] {
             return pitch("fig10b_first_set", {{"ono_yamane.take_off", "8 nm"}});
         }},
        {"fig10b_first_set", "95.6 urad", [] { return pitch("fig10b_first_set", fig12a); }},
        {"fig10b_naive_switching", "in contact at 3.80 nm", [] { return height("fig10b_naive_switching"); }},
        {"fig10b_naive_switching", "flies at 7 nm",
         [] {
             return height("fig10b_naive_switching", {{"run.step", "5 ns"}});
         }},
        {"fig10b_naive_switching", "flies at 7 nm",
         [] {
             return height("fig10b_naive_switching", {{"run.step", "1 ns"}});
         }},
        {"fig11a", "7 nm", [] { return height("fig11a"); }},
        {"fig11a", "7 nm and 90.6 urad", [] { return pitch("fig11a"); }},
        {"fig11b", "7 nm", [] { return height("fig11b"); }},
        {"fig11b", "7 nm and 90.6 urad", [] { return pitch("fig11b"); }},
        {"fig12a", "in contact at 1.60 nm", [] { return height("fig12a"); }},
        {"fig12a", "1.60 nm and 94.2 urad", [] { return pitch("fig12a"); }},
        {"fig12b", "with 2.5 ns",
         [] {
             const Settings steps{{"run.integrator", "rk4"}, {"run.step", "2.5 ns"}};
             return ran("fig12b", steps).summary.failure == RunFailure::RearSpringLost ? 2.5 : NAN;
         }},
        {"fig12b", "in contact at 1.60 nm", [] { return height("fig12b", naive5ns); }},
        {"fig13a", "in contact: 3.80 nm", [] { return height("fig13a"); }},
        {"fig13a", "3.80 nm and 94.2 urad", [] { return pitch("fig13a"); }},
        {"fig13b", "3.80 nm", [] { return height("fig13b"); }},
        {"fig13b", "3.80 nm and 94.2 urad", [] { return pitch("fig13b"); }},
        {"fig14a", "oscillates about 7 nm",
         [] { return 1e9 * valueOf(ran("fig14a").summary.tail, "flying_height").mean; }},
        {"fig14a", "by 0.08 nm", [] { return 1e9 * swing("fig14a", "flying_height"); }},
        {"film_fig1_micro_pad", "about 0.8 nm", [] { return -1e9 * rests("film_fig1_micro_pad").minimumSpacing; }},
        {"film_fig2_pressed_pad", "trailing edge 5 nm",
         [] { return -1e9 * rests("film_fig2_pressed_pad").minimumSpacing; }},
        {"film_fig4_pico", "flying at 3.2 nm", [] { return 1e9 * rests("film_fig4_pico").minimumSpacing; }},
        {"film_fig4_pico", "flying at 3.2 nm and 176 urad",
         [] { return 1e6 * rests("film_fig4_pico").attitude.pitch; }},
        {"film_fig4_pico", "up to 18 atmospheres",
         [] { return atmospheres("film_fig4_pico", rests("film_fig4_pico").forces.maximumPressure); }},
        {"film_pico", "falls to 0.23 atmospheres",
         [] { return atmospheres("film_pico", rests("film_pico").forces.minimumPressure); }},
        {"film_pico", "pulls twice",
         [] { return -rests("film_pico").forces.negative / sample("film_pico").suspension.preload; }},
        {"film_plane", "carries 8.215 gf", [] { return rests("film_plane").forces.net / unitFactor("gf"); }},
        {"film_plane", "nodes it carries 8.239 gf", [] { return coarseLoad("complete-flux"); }},
        {"film_plane", "\"upwind\" 8.309 gf", [] { return coarseLoad("upwind"); }},
        {"film_plane", "centred at 0.7304",
         [] { return rests("film_plane").forces.centreOfPositive.x / sample("film_plane").slider.length; }},
        {"film_plane", "peaks at 3.317",
         [] { return atmospheres("film_plane", rests("film_plane").forces.maximumPressure); }},
        {"springs_waviness", "oscillates at 260 kHz",
         [] { return 1e-3 * ran("springs_waviness").summary.peaks.at(0).frequency; }},
        {"springs_waviness", "about eight times",
         [] { return 0.5e9 * swing("springs_waviness", "flying_height") / 0.5; }},
        {"springs_waviness", "mode is at 275 kHz", [] { return mode(sample("springs_waviness"), 1); }},
        {"table3_3nm_from_100nm", "at 2.33 nm", [] { return height("table3_3nm_from_100nm"); }},
        {"table3_3nm_from_100nm", "on again twice", [] { return events("table3_3nm_from_100nm", "rear spring lost"); }},
        {"table3_3nm_from_250nm", "at 2.33 nm", [] { return height("table3_3nm_from_250nm"); }},
        {"table3_3nm_from_250nm", "on again 10", [] { return events("table3_3nm_from_250nm", "rear spring lost"); }},
        {"table3_4nm_from_100nm", "at 2.65 nm", [] { return height("table3_4nm_from_100nm"); }},
        {"table3_4nm_from_100nm", "on again once", [] { return events("table3_4nm_from_100nm", "rear spring lost"); }},
        {"table3_4nm_from_250nm", "at 2.65 nm", [] { return height("table3_4nm_from_250nm"); }},
        {"table3_4nm_from_250nm", "on again 6", [] { return events("table3_4nm_from_250nm", "rear spring lost"); }},
        {"textbook_bounce", "to 5 nm",
         [] { return 1e9 * valueOf(ran("textbook_bounce").summary.extremes, "flying_height").least; }},
        {"textbook_bounce", "every 62.09 us", [] { return 1e6 * ringing("textbook_bounce", 50e-9).period; }},
        {"textbook_oscillator", "periods of 99.37 us",
         [] { return 1e6 * ringing("textbook_oscillator", 150e-9).period; }},
        {"textbook_oscillator", "each 0.882", [] { return ringing("textbook_oscillator", 150e-9).ratio; }},
        {"textbook_oscillator", "near 10.1 kHz",
         [] { return 1e-3 * ran("textbook_oscillator").summary.peaks.at(0).frequency; }},
        {"fig05_fm_2_7mN", "flies at 3.2 nm", [] { return endInHelp("fig05_fm_2_7mN"); }},
        {"fig05_fm_15mN", "in contact at 1.38 nm", [] { return endInHelp("fig05_fm_15mN"); }},
        {"fig06_de_5_5nm", "in contact at 3.29 nm", [] { return endInHelp("fig06_de_5_5nm"); }},
        {"fig06_de_8nm", "in contact at 3.29 nm", [] { return endInHelp("fig06_de_8nm"); }},
        {"fig07_mu_2", "in contact at 3.38 nm", [] { return endInHelp("fig07_mu_2"); }},
        {"fig08_start_03_5nm", "flies at 3.19 nm", [] { return endInHelp("fig08_start_03_5nm"); }},
        {"fig08_start_05nm", "in contact at 3.29 nm", [] { return endInHelp("fig08_start_05nm"); }},
        {"fig08_start_10nm", "flies at 3.2 nm", [] { return endInHelp("fig08_start_10nm"); }},
        {"fig08_start_20nm", "in contact at 3.29 nm", [] { return endInHelp("fig08_start_20nm"); }},
        {"fig06_de_5_5nm", "static spacing of 3.2 nm", [] { return 1e9 * rests("film_fig4_pico").minimumSpacing; }},
        {"fig06_de_8nm", "static spacing of 3.2 nm", [] { return 1e9 * rests("film_fig4_pico").minimumSpacing; }},
        {"fig08_start_03_5nm", "start at 3.5 nm", [] { return startOf("fig08_start_03_5nm"); }},
        {"fig08_start_05nm", "start at 5 nm", [] { return startOf("fig08_start_05nm"); }},
        {"fig08_start_10nm", "start at 10 nm", [] { return startOf("fig08_start_10nm"); }},
        {"fig08_start_20nm", "start at 20 nm", [] { return startOf("fig08_start_20nm"); }},
        // The spring of contact and air on the mass at the pad, and how far that is below the peak.
        {"fig02_case_2_moving", "That gives 795 kHz", [] { return 1e-3 * frequency(9.2e6 + 1.9e6, 0.445e-6); }},
        {"fig02_case_2_moving", "795 kHz, 5 %", [] { return 100.0 * (1.0 - 795.0 / 836.0); }},
        {"fig02_micro_pad_case_2_moving", "stiff (336 kHz",
         [] {
             const SliderCase body = sample("fig02_micro_pad_case_2_moving").slider;
             const double arm = 1.22e-3 - 0.5 * body.length; // of the pad's middle [m]
             return 1e-3 * frequency(2e6, 1.0 / (1.0 / body.mass + arm * arm / body.pitchInertia));
         }},
        // The same run has a case in each figure.
        {"fig05_fm_3_62mN", "flies at 3.2 nm", [] { return endInHelp("fig08_start_10nm"); }},
        {"fig06_de_4nm", "flies at 3.2 nm", [] { return endInHelp("fig08_start_10nm"); }},
        {"fig07_mu_0_3", "flies at 3.2 nm", [] { return endInHelp("fig08_start_10nm"); }},
        {"cycles_air_damping", "W = -0.3 pJ",
         [] {
             Settings settings = low;
             settings.push_back({"ono_yamane.meniscus_force", "2.2 mN"});
             return workOf(lawOf("fig10a", settings));
         }},
        {"cycles_map_air_damping", "f_m 1 nm",
         [] { return 1e9 * (lawOf("fig10a", low).takeOff - lawOf("fig10a", low).touchDown); }},
        {"cycles_map_air_damping", "- 2.5 pJ", [] { return stepWork(lawOf("fig10a", low)); }},
        {"cycles_map_air_damping", "at f_m = 2.5 mN", [] { return forceWithoutWork(lawOf("fig10a", low)); }},
        {"cycles_map_paper", "Where does the 7 nm", [] { return 1e9 * sample("fig10a").springs.flyingHeight; }},
        {"cycles_map_paper", "flies at 4", [] { return 1e9 * sample("table3_4nm_from_250nm").springs.flyingHeight; }},
        {"cycles_map_paper", "flies at 4 and 3 nm",
         [] { return 1e9 * sample("table3_3nm_from_250nm").springs.flyingHeight; }},
        {"cycles_meniscus_force", "touch-down height of 3 nm",
         [] { return 1e9 * sample("fig10a").onoYamane.touchDown; }},
        {"cycles_meniscus_force", "at f_m = 2.5 mN", [] { return forceWithoutWork(lawOf("fig10a", low)); }},
        {"cycles_meniscus_force_friction", "beyond f_m = 2.5 mN",
         [] { return forceWithoutWork(lawOf("fig10a", low)); }},
        {"hysteresis_film_bouncing", "W = f_m 0.5 nm",
         [] {
             const OnoYamane law = lawOf("fig05_fm_3_62mN", linear);
             return 0.5e9 * (law.takeOff - law.touchDown);
         }},
        {"hysteresis_film_bouncing", "- 2.5 pJ", [] { return stepWork(lawOf("fig05_fm_3_62mN", linear)); }},
        {"hysteresis_film_bouncing", "at 5 mN", [] { return forceWithoutWork(lawOf("fig05_fm_3_62mN", linear)); }},
        {"hysteresis_meniscus_force", "held by 50 mN", [] { return 1e3 * sample("fig12a").onoYamane.meniscusForce; }},
        {"precision_fig12b", "leads 75", [] { return otherEnds("10 ns"); }},
        {"precision_fig12b", "with 10 ns, 137", [] { return otherEnds("5 ns"); }},
        {"precision_fig12b", "with 5 ns, 75", [] { return otherEnds("2 ns"); }},
        {"precision_fig12b", "with 2 ns and 12", [] { return otherEnds("1 ns"); }},
        {"precision_fig12b", "nanometre 287", [] { return double(std::ranges::count(losesTheSpring({}), true)); }},
        {"response_elastic_stop", "3 nm",
         [] {
             return 1e9 * (stopCase("response_elastic_stop").springs.flyingHeight -
                           stopCase("response_elastic_stop").onoYamane.touchDown);
         }},
        {"response_elastic_stop", "resonance is at 100 kHz", [] { return mode(stopCase("response_elastic_stop"), 0); }},
        {"response_period_doubling", "0.3 nm",
         [] {
             return 1e9 * (stopCase("response_period_doubling").springs.flyingHeight -
                           stopCase("response_period_doubling").onoYamane.touchDown);
         }},
        // Half a period off the stop and half a period on it (Shaw and Holmes), as the stop is near the static state.
        {"response_period_doubling", "near 145 kHz",
         [] {
             const Case c = stopCase("response_period_doubling");
             const double stiffness = c.springs.frontStiffness + c.springs.rearStiffness;
             const double pressed = std::sqrt((stiffness + c.onoYamane.contactStiffness) / stiffness);
             return mode(c, 0) * 2.0 * pressed / (1.0 + pressed);
         }},
        {"response_waviness", "mode is at 275 kHz", [] { return mode(sample("springs_waviness"), 1); }},
        {"response_waviness", "waves of 0.5 nm",
         [] { return 1e9 * sample("springs_waviness").diskSurface.waveAmplitudes.at(0); }},
        // Means over n cells of a wave keep sin(pi/n)/(pi/n) of it.
        {"air_film.html", "A wave with two cells keeps 64 %", [] { return 200.0 / std::numbers::pi; }},
        {"air_film.html", "one with six cells 95 %",
         [] { return 600.0 / std::numbers::pi * std::sin(std::numbers::pi / 6.0); }},
        {"air_film.html", "default 0.005 nm", [] { return 1e9 * Case{}.run.stepError; }},
        {"glossary.toml", "about 64 nm",
         [] { return 1e9 * std::get<double>(findParameter("air.mean_free_path")->get(Case{})); }},
        {"glossary.toml", "1 gf is 9.81 mN", [] { return 1e3 * unitFactor("gf"); }},
        {"README.md", "dropped from 250 nm", [] { return 1e9 * sample("fig10a").initial.flyingHeight; }},
        {"README.md", "bounces that end at 7 nm", [] { return height("fig10a"); }},
        {"README.md", "spacing ends at 1.6 nm", [] { return height("fig12a"); }},
        {"README.md", "meniscus force\" to 10.7 mN", [] { return 1e3 * sample("fig10a").onoYamane.meniscusForce; }},
        {"README.md", "flies again, at 7 nm",
         [] {
             return height("fig12a", {{"ono_yamane.meniscus_force", "10.7 mN"}});
         }},
        {"README.md", "final flying height 3.7994 nm", [] { return height("fig13a"); }},
        {"README.md", "3.7994 nm\", 126", [] { return double(ran("fig13a").summary.events.size()); }},
        {"README.md", "in contact, at 3.0 nm",
         [] {
             return height("fig10a", {{"springs.flying_height", "5 nm"}});
         }},
        {"README.md", "pull-off force 0.84 mN", [] { return 1e3 * figure("contact_adhesion", "pull_off_force"); }},
        {"README.md", "touch-down at 3.1 nm", [] { return hysteresis("Touch-down at ", 0); }},
        {"README.md", "take-off at 8.5 nm", [] { return hysteresis("Take-off at ", 0); }},
        {"README.md", "touches down at 3.1 nm", [] { return hysteresis("Touch-down at ", 0); }},
        {"README.md", "takes off only at 8.5 nm", [] { return hysteresis("Take-off at ", 0); }},
        {"README.md", "falls from 14 nm", [] { return hysteresis("all equilibria from ", 0); }},
        {"README.md", "to 1.4 nm", [] { return hysteresis("all equilibria from ", 1); }},
        {"README.md", "the default: 8e-6 nm", [] { return measured("dopri5", "1e-8", "largest error [nm]"); }},
        {"README.md", "8e-6 nm in 0.9 ms", [] { return measured("dopri5", "1e-8", "minimum [ms]"); }},
        {"README.md", "needs 15 ms", [] { return measured("rk4", "10 ns", "minimum [ms]"); }},
        {"README.md", "off by 3 nm", [] { return measured("rk4", "10 ns", "largest error [nm]"); }},
        {"README.md", "ends at 3.8 nm", [] { return height("fig10b_naive_switching"); }},
        {"README.md", "half the step ends at 7 nm",
         [] {
             return height("fig10b_naive_switching", {{"run.step", "5 ns"}});
         }},
    };
    return all;
}

/// What no run of this test gives. The words hold the numbers, in all texts whose place has the pattern.
struct Given {
    QString place;
    QString words;
    QString source;
};

const std::vector<Given>& given()
{
    const QString paper("the paper"), figs("fig0[5-8]"), fig2("fig02|film_fig2"), grid("paper_grids|film_fig5_to_8");
    const QString spread("film_fig5_to_8.toml: the spread of the starts");
    const QString ends("film_fig5_to_8.csv, which test_statements compares with the cards");
    const QString search("how the values in place of the lost tables were searched for");
    const QString slow("a run of minutes: touchdown run, with this name"), bench("tests/bench/README.md");
    const QString stated("minutes: touchdown study statements tests/bench/stated_fig2.toml");
    const QString keys("keys and texts of the window"), key("a setting, or a limit in the code");
    static const std::vector<Given> all{
        {"fig12a", "1.6 nm and 94.2 urad", paper},
        {"fig13", "3.8 nm and 94.2 urad", paper},
        {"first_set", "the paper reads 94.2 urad", paper},
        {"naive_switching|table3", "1e-8 s and of 1e-9 s", paper},
        {"table3_4nm", "1e-8 and 1e-9 s", paper},
        {"fig12b", "a step of 1e-9 s", paper},
        {"precision_fig12b", "even with steps of 1 ns", paper},
        {"precision_fig12b", "75 with 2 ns and 12 with 1 ns", "the settings of its rows"},
        {"fig12b", "With 5 ns", "the settings of its row"},
        {"fig10b_naive_switching", "with 5 ns or 1 ns", "the settings of its rows"},
        {"table3_3nm", "steps of 10 ns and 1 ns", paper},
        {"table3_3nm", "the 4 nm and 3 nm", paper},
        {"precision_springs", "steps of 10 ns", paper},
        {fig2, "peaks around 800 kHz", paper},
        {"fig05", "With f_m = 15 mN", paper},
        {"fig06_de_4nm", "5.5 and 8 nm", paper},
        {"fig08_start_10nm", "from 3.5 and 10 nm; contact from 5 and 20 nm", paper},
        {"fig0|film_fig|advise", "slip at 0.3 nm", paper},
        {"advise_snap", "blended over 0.1 nm at 0.3 nm", paper},
        {"micro_pad", "roughness of 0.2 nm", paper},
        // Figs. 5 to 8: their defaults, and what takes half an hour.
        {figs, "f_m = 3.62 mN, d_e = 4 nm, mu = 0.3 and a start at 10 nm", "fig05_fm_3_62mN"},
        {figs, "Compare with 3.62 mN", "fig05_fm_3_62mN"},
        {figs, "see 15 mN", "fig05_fm_15mN"},
        {figs, "between the start height and 3.2 nm", "film_fig4_pico"},
        {figs, "within 0.2 nm of 10 nm", spread},
        {"fig08_start_03", "within 0.07 nm", spread},
        {"fig08_start_05", "within 0.1 nm", spread},
        {"fig08_start_20", "within 0.4 nm", spread},
        {"fig08_start_10nm", "From 9.7 or 10.3 nm", ends},
        {"fig07_mu_2", "near 10.15 nm", ends},
        {grid, "within about 2 %", spread},
        {grid, "interval at 95 %", "the study"},
        {grid, "from 9.7 and 10.3 nm", ends},
        {grid, "near 10.15 nm", ends},
        {grid, "From 10 nm", ends},
        {grid, "= 3.62 mN", "fig05_fm_3_62mN"},
        {grid, "from 9.8 to about 10.1 nm", ends},
        {grid, "flies from 20.3 nm", slow},
        {grid, "from 19.75 and 20 nm on all", slow},
        {"film_fig5_to_8", "0.1 to 1.6 pJ", search},
        {"film_fig5_to_8", "up to 2 %", search},
        {"film_fig5_to_8", "flies from 10 nm", search},
        {"film_fig5_to_8", "2e-4 N s/m", search},
        {"film_fig5_to_8", "0.4 %", search},
        {"film_fig5_to_8", "f_m 6.2 mN", search},
        // Fig. 2.
        {"fig02_case_1", "After 0.02 ms it moves by less than 0.02 nm RMS, in the last tenth of the run by 0.001 nm",
         stated},
        {"fig02_case_1", "carry 1.9 mN of 19.6 mN", stated},
        {"fig02_case_2",
         "0.10 nm RMS in the last tenth of the run, against less than 0.002 nm in cases I and III. From 0.1 ms on its "
         "spectrum has peaks from 775 to 872 kHz, the "
         "highest at 836 kHz. The contact (9.2e6 N/m on the average over the motion) and the air under the pad "
         "(1.9e6 N/m in this run) act as one spring on a mass of 0.445 mg",
         stated},
        {"fig02_case_3", "less than 0.002 nm", stated},
        {"fig02_case_3", "near 100 kHz, and around 800 kHz", slow},
        {"fig02_micro_pad_case_2", "at most about 2e6 N/m", slow},
        {fig2, "peaks at 800 kHz", paper},
        {fig2, "width of 180 um, the disk's modulus of 300 GPa", "film_fig2_pressed_pad"},
        {fig2, "surface energy of 3 mN/m", "fig02_case_1_flat"},
        {fig2,
         "far below the 50 to 106 mN/m that are reported: with 5 mN/m (tried at 200 GPa) case I rings on at 785 kHz",
         search},
        {"fig02_case",
         "above 50 kHz: from 0.06 to 0.15 ms case II vibrates by 0.077 nm RMS about 807 kHz (mean of the spectrum from "
         "400 to 1300 kHz), on 193 x 193 and 289 x 289 nodes by 0.053 and 0.055 nm about 882 and 876 kHz",
         bench},
        // Studies.
        {"cycles_map_paper", "mode at 229 kHz", bench},
        {"cycles_meniscus_force_friction", "W = +0.28 pJ", "test_lesson: the findings of this study"},
        {"hysteresis_disk_speed", "Around 5800 rpm", slow},
        {"hysteresis_disk_speed", "about 200 kHz", slow},
        {"hysteresis_disk_speed", "needs 0.2 ms", slow},
        {"hysteresis_film_bouncing", "at 5.5 mN", slow},
        {"hysteresis_film_bouncing", "dropped from 10 nm", "fig05_fm_3_62mN"},
        {"response_waviness", "3 to 20 m/s", "from 60 to 400 kHz with 50 um"},
        {"stability_start_height", "from 10 ns to 1 ns", paper},
        {"advise_waviness", "100 kHz", "the length of the waves and the speed of the disk"},
        // Help and README.
        {"glossary", "1 gf is", "the definition of the unit"},
        {"air_film", "by more than 1 %", key},
        {"README", "97² to 193², 80 kHz to 1.7 MHz", bench},
        {"results",
         "near 14 nm: 30 of 30; of 20 other sliders at 2 to 36 nm 18 on 97² and 20 on 193² nodes. It is often much "
         "too large: 6 times in the median. Below some 2 nm",
         bench},
        {"results", "of 80 to 1675 kHz", bench},
        {"results", "2.5 Hz apart in the median, 4.6 Hz at worst",
         "against an own sweep with steps of 1 to 4 Hz, once"},
        {"results", "0.1 nm too high at worst", "core/physics/slider/minimum_spacing.h"},
        {"results", "under a skewed slider one named 42 ms", "twice the path of surface_recurrence.h, 2^20 points"},
        {"results", "within 0.1 % of the RMS height", "core/physics/slider/disk_clearance.h"},
        {"results", "more than 0.001 nm", "the rule of the warning"},
        {"air_film", "move by 1 µm, with Shift by 10 µm, with Alt by 0.1 µm", keys},
        {"air_film", "within 0.1 µm", key},
        {"air_film", "the edge 4 µm", key},
        {"air_film", "0.001 nm per µm", "measured once; no command repeats it"},
        {"contact.html", "# Spacing: 0.5 um", "an example"},
        {"response_period_doubling", "420 kHz the slider bounces at 140 kHz",
         "test_response: otherStartsFindOtherMotions"},
        {"contact.html", "Width: 10 um, # Height: 5 um", "an example"},
        {"contact.html", "points more than 1 mm", key},
        {"contact.html", "contains 95 %", key},
        {"^paper.html", "start by 0.1 nm", ends},
        {"use.html", "100 µs/s", keys},
        {"use.html", "0.0032 um", "an example"},
        {"README", "100 µs/s", keys},
        {"README", "(rk4, 10 ns)", paper},
        {"README", "takes 0.3 s", bench},
        {"README", "0.35 % of the preload in the median, 2.9 % at worst", bench},
        {"README", "0.14 % and 1.1 %", bench},
        {"README", "2.3 % on 385² nodes, in the same time, and by up to 67 %", bench},
        {"README", "Below 2 nm", bench},
        {"README", "cells of 5 µm has a load that is off by up to 1 %", "tests/physics/film/test_cut_rows.cpp"},
        {"README", "near 45° by 2 %", "tests/physics/film/test_cut_rows.cpp"},
    };
    return all;
}

/// A text and the numbers of its own file.
struct Text {
    QString text;
    std::vector<Amount> own{};
};

void addValues(std::vector<Amount>& amounts, const TomlValue& value)
{
    if (const auto* text = std::get_if<std::string>(&value))
        for (const Amount& amount : amountsIn(*text)) amounts.push_back(amount);
    if (const auto* list = std::get_if<TomlArray>(&value))
        for (const TomlElement& element : list->elements) addValues(amounts, element.value);
}

/// The values of a case or study file, without its words.
std::vector<Amount> valuesOf(const std::string& toml)
{
    std::vector<Amount> amounts;
    for (const TomlEntry& entry : readToml(toml).entries)
        if (!entry.key.starts_with("about.") && entry.key != "title") addValues(amounts, entry.value);
    return amounts;
}

QString withoutTags(QString page)
{
    page.remove(QRegularExpression("<[^>]*>"));
    return page.replace("&nbsp;", " ").replace("&gt;", ">").replace("&lt;", "<").replace("&amp;", "&");
}

const std::map<QString, Text>& texts()
{
    static const std::map<QString, Text> all = [] {
        std::map<QString, Text> made;
        for (const SampleCase& each : sampleCases()) {
            const Case c = sample(each.name);
            made[QString::fromStdString(each.name)] = {
                QString::fromStdString(c.title + ". " + c.about.paper + ' ' + c.about.watch + ' ' + c.about.assumed),
                valuesOf(each.text)};
        }
        for (const SampleStudy& each : sampleStudies()) {
            QString comment;
            for (const QString& line : QString::fromStdString(each.text).split('\n'))
                if (line.startsWith('#')) comment += line.mid(1) + ' ';
            Text& text = made[QString::fromStdString(each.name)]; // a case may have the same name
            text.text += ' ' + QString::fromStdString(each.title) + ". " + comment;
            for (const Amount& amount : valuesOf(each.text)) text.own.push_back(amount);
            for (const TomlEntry& entry : readToml(each.text).entries)
                if (const auto* name = std::get_if<std::string>(&entry.value); entry.key == "case" && name != nullptr)
                    for (const SampleCase& start : sampleCases())
                        if (start.name == *name)
                            for (const Amount& amount : valuesOf(start.text)) text.own.push_back(amount);
        }
        for (const char* page : {"air_film", "contact", "equations", "paper", "paper_grids", "results", "use"})
            made[QString(page) + ".html"] = {withoutTags(textOf(QString("resources/help/%1.html").arg(page)))};
        made["glossary.toml"] = {textOf("resources/help/glossary.toml")};
        made["README.md"] = {textOf("README.md")};
        for (auto& [place, text] : made) text.text = text.text.replace(" \\\n", " ").simplified();
        return made;
    }();
    return all;
}

/// As in run.step = "5 ns" or --set run.step=5ns: what somebody may try.
bool isSetting(const QString& text, const Amount& amount)
{
    const QString before = text.mid(std::max<qsizetype>(0, amount.begin - 3), std::min<qsizetype>(3, amount.begin));
    return before.endsWith('=') || before.endsWith("= \"");
}

/// The number at the end of words, a count also as a word.
Amount saidIn(const QString& words)
{
    if (const std::vector<Amount> amounts = amountsIn(words); !amounts.empty()) return amounts.back();
    for (const auto& [word, value] : {std::pair{"once", 1.0}, {"twice", 2.0}, {"eight times", 8.0}})
        if (words.endsWith(word)) return {.value = value, .half = 0.5};
    qFatal("no number in %s", qPrintable(words));
}

class TestStatedNumbers : public QObject {
    Q_OBJECT

private slots:
    void numbersAreThoseOfRuns_data()
    {
        QTest::addColumn<int>("row");
        for (std::size_t i = 0; i < rows().size(); ++i)
            QTest::addRow("%s: %s", rows()[i].place.c_str(), rows()[i].words.c_str()) << int(i);
    }
    void numbersAreThoseOfRuns()
    {
        QFETCH(const int, row);
        const Row& each = rows().at(std::size_t(row));
        const QString words = QString::fromStdString(each.words);
        const auto text = texts().find(QString::fromStdString(each.place));
        QVERIFY2(text != texts().end() && text->second.text.contains(words), "is not said");
        const double found = each.found();
        QVERIFY2(rounds(found, saidIn(words)), qPrintable(QString::number(found, 'g', 8)));
    }

    void everyNumberHasASource_data()
    {
        QTest::addColumn<QString>("place");
        for (const auto& [place, text] : texts()) QTest::newRow(qPrintable(place)) << place;
    }
    void everyNumberHasASource()
    {
        QFETCH(const QString, place);
        const Text& text = texts().at(place);
        std::vector<bool> known(std::size_t(text.text.size()), false);
        const auto know = [&](const QString& words, bool whole) {
            for (qsizetype at = text.text.indexOf(words); at >= 0; at = text.text.indexOf(words, at + 1))
                for (qsizetype i = whole ? at : at + words.size() - 1; i < at + words.size(); ++i)
                    known[std::size_t(i)] = true;
        };
        for (const Row& row : rows())
            if (QString::fromStdString(row.place) == place) know(QString::fromStdString(row.words), false);
        for (const Given& constant : given())
            if (place.contains(QRegularExpression(constant.place))) know(constant.words, true);
        QStringList unknown;
        for (const Amount& said : amountsIn(text.text)) {
            const bool isOwn = std::ranges::any_of(text.own, [&](const Amount& own) {
                return own.unit == said.unit && std::abs(own.value) == std::abs(said.value);
            });
            if (!said.unit.isEmpty() && !isOwn && !isSetting(text.text, said) && !known[std::size_t(said.end - 1)])
                unknown << text.text.mid(std::max<qsizetype>(0, said.begin - 30), said.end - said.begin + 40);
        }
        QVERIFY2(unknown.isEmpty(), qPrintable(unknown.join(QStringLiteral("\n    "))));
    }

    /// A source that nobody needs any more goes.
    void everySourceIsNeeded()
    {
        for (const Given& constant : given())
            QVERIFY2(std::ranges::any_of(texts(),
                                         [&](const auto& each) {
                                             return each.first.contains(QRegularExpression(constant.place)) &&
                                                    each.second.text.contains(constant.words);
                                         }),
                     qPrintable(constant.words));
    }
};

TOUCHDOWN_TEST(TestStatedNumbers)

} // namespace test_stated_numbers

#include "test_stated_numbers.moc"

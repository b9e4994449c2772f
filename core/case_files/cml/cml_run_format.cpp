// SPDX-License-Identifier: GPL-3.0-or-later
//
// run.dat as text, in the layout of the established program.
#include "core/case_files/cml/cml_run_file.h"

#include <algorithm>
#include <initializer_list>
#include <string>
#include <vector>

#include "core/formats/decimal.h"
#include "core/formats/units.h"
#include "core/physics/film/slip_model.h"

namespace touchdown {

namespace {

class RunWriter {
public:
    std::string text;

    void line(std::string_view words = {}) { text.append(words).append("\r\n"); }
    void section(std::string_view name) { line("***************" + std::string(name) + "***************"); }
    /// A heading, and the numbers below its words.
    void list(std::initializer_list<std::string_view> names, const std::vector<std::string>& values)
    {
        constexpr std::size_t column = 14;
        std::string heading;
        std::string numbers;
        for (std::size_t i = 0; i < values.size(); ++i) {
            const std::string name(i < names.size() ? names.begin()[i] : std::string_view());
            const std::size_t width = std::max({name.size(), values[i].size(), column}) + 1;
            heading += name + std::string(width - name.size(), ' ');
            numbers += values[i] + std::string(width - values[i].size(), ' ');
        }
        for (std::string* row : {&heading, &numbers})
            while (row->ends_with(' ')) row->pop_back();
        line(heading);
        line(numbers);
    }
};

std::string number(double value, std::string_view unit = {}) { return formatNumber(value, unit); }
/// A force or a spring rate, from N; the reader converts by grams in the same way.
std::string kilograms(double force) { return decimalText(*readDecimal(formatNumber(force, "gf")), -3); }
std::string flag(bool on) { return on ? "1" : "0"; }

std::vector<std::string> numbers(const std::vector<double>& values, std::string_view unit = {})
{
    std::vector<std::string> result;
    result.reserve(values.size());
    for (const double value : values) result.push_back(number(value, unit));
    return result;
}

void writeSolution(RunWriter& out, const Case& c)
{
    out.section("Solution Control");
    out.list({"istiff", "isolv", "ioldg", "iadpt", "isave"}, {flag(c.steady.stiffness), flag(!c.steady.fixedAttitude),
                                                              "0", flag(c.film.grid == GridKind::Adapted), "1"});
    out.section("Intial Attitude"); // its spelling
    out.list({"hm(m)", "pitch(rad)", "roll(rad)"},
             {number(c.initial.nominalTrailingEdgeHeight), number(c.initial.pitch), number(c.initial.roll)});
}

void writeRuns(RunWriter& out, const Case& c)
{
    const SteadyCase& steady = c.steady;
    const std::vector<double> radii = steady.radii.empty() ? std::vector{c.disk.radius} : steady.radii;
    std::vector<double> skews = steady.skews;
    skews.resize(radii.size(), c.disk.skew);
    const std::vector<double> speeds = steady.speeds.empty() ? std::vector{c.disk.speed} : steady.speeds;
    std::vector<double> altitudes = steady.altitudes;
    if (altitudes.empty()) altitudes = {c.air.source == AirSource::Atmosphere ? c.air.altitude : 0.0};
    out.section("Runs");
    out.list({"irad", "irpm", "ialt", "sort"},
             {std::to_string(radii.size()), std::to_string(speeds.size()), std::to_string(altitudes.size()), "0"});
    out.list({"radii(m)"}, numbers(radii));
    out.list({"skews(deg)"}, numbers(skews, "deg"));
    out.list({"RPMs"}, numbers(speeds, "rpm"));
    out.list({"altitudes(m)"}, numbers(altitudes));
}

void writeAirAndLoad(RunWriter& out, const Case& c)
{
    const Air& air = c.air.given;
    const SuspensionCase& load = c.suspension;
    out.section("Air Parameters");
    out.list({"p0(pa)", "al(m)", "vis(nsm^-2)"}, numbers({air.pressure, air.meanFreePath, air.viscosity}));
    out.section("Load Parameters");
    out.list({"f0(kg)", "xf0(m)", "yf0(m)", "psa", "rsa", "usestiff"},
             {kilograms(load.preload), number(load.offsetX), number(load.offsetY), number(load.staticPitch),
              number(load.staticRoll), flag(load.holdsAttitude)});
    out.list({"xfs(uNM)", "yfs(uNM)", "emax", "skp", "skr"},
             {number(load.pitchTorque, "uN m"), number(load.rollTorque, "uN m"), number(c.steady.loadTolerance),
              number(load.pitchStiffness), number(load.rollStiffness)});
}

void writeGrid(RunWriter& out, const Case& c)
{
    out.section("Grid Control");
    out.list({"nx", "ny"}, {std::to_string(c.film.nodes[0]), std::to_string(c.film.nodes[1])});
    out.list({"nsx", "nsy", "isymm"}, {"1", "1", "0"});
    for (const std::string_view sections : {"xnt(i), i = 2, nsx", "nxt(i), i = 2, nsx", "dxr(i), i = 1, nsx",
                                            "ynt(i), i = 2, nsy", "nyt(i), i = 2, nsy", "dyr(i), i = 1, nsy"}) {
        out.line(sections);
        out.line(sections.starts_with('d') ? "1" : ""); // the ratio of the one section
    }
    out.section("Adaptive Grid");
    out.list({"difmax_x", "decay_x", "ipmax_x", "iadaptmode_x"}, {"100", "50", "0", "1"});
    out.list({"difmax_y", "decay_y", "ipmax_y"}, {"40", "50", "0"});
    for (const std::string axis : {"X", "Y"}) {
        out.section("Mesh Refinement in " + axis + " Direction");
        out.list({"num" + axis + "Regions"}, {"0"});
        out.line("Lower         Upper          Amount");
    }
}

/// The nearest of the program's three schemes: its power law approximates the exponential one.
std::string schemeNumber(ConvectionScheme scheme)
{
    return scheme == ConvectionScheme::Upwind ? "0" : scheme == ConvectionScheme::Hybrid ? "1" : "2";
}

/// The nearest of its models: Fukui-Kaneko for those that it does not have.
std::string slipNumber(SlipModel model)
{
    return model == SlipModel::Continuum     ? "0"
           : model == SlipModel::FirstOrder  ? "1"
           : model == SlipModel::SecondOrder ? "2"
                                             : "3";
}

void writeReynolds(RunWriter& out, const Case& c)
{
    out.section("Reynolds Equation");
    out.list({"ischeme", "imodel", "akmax", "beta", "gamma", "accommodation", "mgnest"},
             {schemeNumber(c.film.scheme), slipNumber(c.air.slip.model), number(c.film.tolerance), "6", "6",
              number(c.air.slip.accommodation), "4"});
    out.section("Partial Contact"); // off, with the values that the program proposes
    out.list({"icmodel", "stdasp(m)", "dnsasp(m^-2)", "ConstantA", "ConstantB"},
             {"0", "3e-10", "1e12", "1e-19", "1e-76"});
    out.list({"rdsasp(m)", "eyoung(pa)", "yldstr(pa)", "elecpot(v)"}, {"1e-8", "1e10", "1e12", "0"});
    out.list({"frcoe", "pratio"}, {"0.3", "0.3"});
}

void writeSensitivities(RunWriter& out, const Case& c)
{
    const auto increments = [&](std::initializer_list<double> values) {
        return c.steady.sensitivities ? numbers(values) : std::vector<std::string>(values.size(), "0");
    };
    out.section("Sensitivities");
    out.list({"crowninc(m)", "camberinc(m)", "twistinc(m)"}, increments({1e-9, 1e-9, 1e-9}));
    out.list({"tlnginc(m)", "tanginc(rad)", "loadinc(kg)"}, increments({1e-6, 1e-6, 1e-6}));
    out.list({"ptrqinc(uNM)", "rtrqinc(uNM)", "recessinc(m)"}, increments({0.01, 0.01, 1e-9}));
    out.list({"iwscale"}, {"1"});
}

} // namespace

std::string formatCmlRun(const Case& c, std::string_view comments)
{
    RunWriter out;
    out.line("CML Version 7.0  RUN.DAT");
    out.line("written by touchdown " TOUCHDOWN_VERSION);
    writeSolution(out, c);
    writeRuns(out, c);
    writeAirAndLoad(out, c);
    writeGrid(out, c);
    writeReynolds(out, c);
    writeSensitivities(out, c);
    // Altitudes count with standard air only.
    const bool standardAir = c.air.source != AirSource::Given || !c.steady.altitudes.empty();
    out.section("Additional Parameters");
    out.list({"output_shear", "use_imf", "use_standard_air"}, {"1", "0", flag(standardAir)});
    out.list({"do_humidity", "temperature", "humidity"}, {"0", number(c.air.temperature, "degC"), "50"});
    out.section("Comments");
    out.text.append(comments);
    return out.text;
}

} // namespace touchdown

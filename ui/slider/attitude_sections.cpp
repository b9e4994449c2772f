// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/attitude_sections.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/case/parameters.h"
#include "core/formats/units.h"
#include "core/simulation/static_state/film_setup.h"
#include "ui/style/quantity_format.h"
#include "ui/style/translate.h"

namespace touchdown {

namespace {

constexpr double gramForce = 9.80665e-3; // [N]

/// Decimals that show `digits` significant digits of a number.
int decimalsOf(double value, int digits)
{
    if (value == 0.0) return 0;
    return std::clamp(digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(value)) + 1e-9)), 0, 12);
}

/// In mm, as the heads of the columns say.
QString place(const SurfacePoint& at, const QLocale& locale)
{
    const QString separator = locale.decimalPoint() == QLatin1String(",") ? QStringLiteral("; ") : QStringLiteral(", ");
    return typeset(at.x / 1e-3, 3, locale) + separator + typeset(at.y / 1e-3, 3, locale);
}

AttitudeSection attitude(const SteadyResult& r, const QLocale& locale)
{
    const DiscretisationError& error = r.discretisationError;
    AttitudeSection section{tr("Attitude"),
                            {},
                            {{tr("Nominal trailing edge height"), withError(r.attitude.height, 0.0, "nm", locale)},
                             {tr("Pitch"), withError(r.attitude.pitch, error.pitch, "urad", locale)},
                             {tr("Roll"), withError(r.attitude.roll, error.roll, "urad", locale)},
                             {tr("Minimum spacing"), withError(r.minimumSpacing, error.minimumSpacing, "nm", locale)},
                             {tr("at x, y [mm]"), place(r.minimumAt, locale)}}};
    if (r.attitude.height < r.minimumSpacing)
        section.rows.insert(section.rows.begin() + 1, {tr("(of recess 0; all rails are higher)")});
    return section;
}

AttitudeSection interest(const Case& c, const SteadyResult& r, const QLocale& locale)
{
    AttitudeSection section{tr("Points of interest"), {tr("Spacing"), tr("At x, y [mm]")}, {}};
    const std::size_t points = std::min(r.interestSpacing.size(), c.surface.pointsOfInterest.size());
    for (std::size_t i = 0; i < points; ++i)
        section.rows.push_back({QStringLiteral("P%1").arg(i + 1), withError(r.interestSpacing[i], 0.0, "nm", locale),
                                place(c.surface.pointsOfInterest[i], locale)});
    return section;
}

/// Pressures above ambient, as in the maps.
AttitudeSection forces(const Case& c, const SteadyResult& r, const QLocale& locale)
{
    const FilmForces& f = r.forces;
    const auto milli = [&](double newtons, double error = 0.0) { return withError(newtons, error, "mN", locale); };
    const auto torque = [&](double value) { return withError(value, 0.0, "uN m", locale); };
    const double ambient = airOf(c.air).pressure;
    const auto pressure = [&](double value) { return withError(value - ambient, 0.0, "kPa", locale); };
    return {tr("Air bearing"),
            {QString(), tr("At x, y [mm]")},
            {{tr("Net force"), milli(f.net, r.discretisationError.load),
              std::isfinite(f.net) ? typeset(f.net / gramForce, 3, locale) + QStringLiteral("\u00A0gf") : QString()},
             {tr("Above ambient"), milli(f.positive), place(f.centreOfPositive, locale)},
             {tr("Below ambient"), milli(f.negative), place(f.centreOfNegative, locale)},
             {tr("Peak pressure above ambient"), pressure(f.maximumPressure), place(f.maximumAt, locale)},
             {tr("Smallest pressure above ambient"), pressure(f.minimumPressure), place(f.minimumAt, locale)},
             {tr("Shear along x"), milli(f.shearX)},
             {tr("Shear along y"), milli(f.shearY)},
             {tr("Pitch torque"), torque(f.pitchTorque)},
             {tr("Roll torque"), torque(f.rollTorque)}}};
}

QString stateText(const ContactAtRest& at)
{
    const QString state = QString::fromStdString(at.state);
    return at.diverges ? tr("%1, unstable").arg(state) : state;
}

AttitudeSection contact(const SteadyResult& r, const QLocale& locale)
{
    AttitudeSection section{tr("Contact"), {}, {}};
    const ContactAtRest& at = r.contact;
    if (at.state.empty()) return section;
    const auto row = [&](const QString& name, double value, const char* unit) {
        section.rows.push_back({name, withError(value, 0.0, unit, locale)});
    };
    section.rows.push_back({tr("State"), stateText(at)});
    if (!at.acts()) return section;
    row(tr("Real contact force"), at.contact, "mN");
    row(tr("Adhesion force"), at.adhesion, "mN");
    row(tr("Friction force"), at.friction, "mN");
    if (at.area > 0.0) row(tr("Real area"), at.area, "um^2");
    return section;
}

/// Of the law of contact.
AttitudeSection otherStates(const SteadyResult& r, const QLocale& locale)
{
    AttitudeSection section{tr("Other states"), {tr("Minimum spacing"), tr("Net contact")}, {}};
    for (const RestingState& other : r.contactStates)
        section.rows.push_back({stateText(other.contact), withError(other.minimumSpacing, 0.0, "nm", locale),
                                withError(other.contact.contact + other.contact.adhesion, 0.0, "mN", locale)});
    return section;
}

AttitudeSection stiffness(const SteadyResult& r, const QLocale& locale)
{
    AttitudeSection section{
        tr("Stiffness of the film"), {tr("per nm height"), tr("per µrad pitch"), tr("per µrad roll")}, {}};
    if (!r.stiffness) return section;
    const std::array<QString, 3> names{tr("Force [mN]"), tr("Pitch [µN·m]"), tr("Roll [µN·m]")};
    constexpr std::array<double, 3> shown{1e-3, 1e-6, 1e-6}; // [N], [N m]
    constexpr std::array<double, 3> moved{1e-9, 1e-6, 1e-6}; // [m], [rad]
    for (std::size_t i = 0; i < 3; ++i) {
        QStringList row{names[i]};
        for (std::size_t j = 0; j < 3; ++j) row << fourDigits((*r.stiffness)(i, j) * moved[j] / shown[i], locale);
        section.rows.push_back(row);
    }
    return section;
}

AttitudeSection sensitivities(const SteadyResult& r, const QLocale& locale)
{
    AttitudeSection section{tr("Sensitivities"),
                            {tr("Height [nm]"), tr("Pitch [µrad]"), tr("Roll [µrad]"), tr("Minimum spacing [nm]")},
                            {}};
    for (const Sensitivity& s : r.sensitivities) {
        const Parameter* parameter = findParameter(s.parameter);
        const std::string unit = parameter && !parameter->displayUnit.empty() ? parameter->displayUnit : s.unit;
        const double step = unit.empty() ? 1.0 : unitFactor(unit);
        const QString name = parameter ? QString::fromStdString(parameter->label) : QString::fromStdString(s.parameter);
        section.rows.push_back({unit.empty() ? tr("%1, per 1").arg(name) : tr("%1, per %2").arg(name, unitText(unit)),
                                fourDigits(s.height * step / 1e-9, locale), fourDigits(s.pitch * step / 1e-6, locale),
                                fourDigits(s.roll * step / 1e-6, locale),
                                fourDigits(s.minimumSpacing * step / 1e-9, locale)});
    }
    return section;
}

AttitudeSection equilibria(const SteadyResult& r, const QLocale& locale)
{
    AttitudeSection section{tr("Other equilibria"), {tr("Height"), tr("Pitch"), tr("Roll")}, {}};
    for (std::size_t i = 0; i < r.otherEquilibria.size(); ++i) {
        const Attitude& a = r.otherEquilibria[i];
        section.rows.push_back({QString::number(i + 2), withError(a.height, 0.0, "nm", locale),
                                withError(a.pitch, 0.0, "urad", locale), withError(a.roll, 0.0, "urad", locale)});
    }
    return section;
}

AttitudeSection solution(const SteadyResult& r, const QLocale& locale)
{
    const QString cells = r.grid.x.empty() ? QString() : tr("%1 × %2 cells").arg(r.grid.nx()).arg(r.grid.ny());
    return {tr("Solution"),
            {},
            {{tr("Status"), statusText(name(r.status))},
             {tr("Grid"), cells},
             {tr("Iterations"), locale.toString(r.iterations)},
             {tr("Residual"), fourDigits(r.residual, locale)},
             {tr("Load error"), fourDigits(r.loadError, locale)},
             {tr("Time"), timeText(r.wallSeconds, locale)}}};
}

bool known(double error) { return error > 0.0 && std::isfinite(error); }

} // namespace

/// One digit of the error, two of one that begins with 1; the next power of ten when rounding gets there.
int decimalsOfError(double error)
{
    const double lead = error / std::pow(10.0, std::floor(std::log10(error)));
    return decimalsOf(error, lead < 1.95 ? 2 : 1);
}

int decimalsWithError(double value, double error, std::string_view displayUnit)
{
    const double factor = unitFactor(displayUnit);
    if (known(error)) return decimalsOfError(error / factor);
    return std::abs(value / factor) < 1.0 ? 3 : decimalsOf(value / factor, 4);
}

QString changeText(double change, double value, double error, std::string_view displayUnit, const QLocale& locale)
{
    constexpr int more = 2;
    const double shown = change / unitFactor(displayUnit);
    int decimals = decimalsWithError(value, error, displayUnit);
    if (std::abs(shown) >= 0.5 * std::pow(10.0, -decimals - more))
        decimals = std::clamp(decimalsOf(shown, 2), decimals, decimals + more);
    return typesetChange(shown, decimals, locale);
}

QString fourDigits(double value, const QLocale& locale)
{
    const double size = std::abs(value);
    if (size != 0.0 && (size < 1e-3 || size >= 1e6)) return trueMinus(locale.toString(value, 'e', 2));
    return typeset(value, decimalsOf(value, 4), locale);
}

QString notFoundText(const SteadyResult& result)
{
    return result.status == SteadyStatus::Converged ? QString() : statusText(name(result.status));
}

QString withError(double value, double error, std::string_view displayUnit, const QLocale& locale)
{
    if (!known(error) || !std::isfinite(value)) return roundedToError(value, error, displayUnit, locale);
    const double factor = unitFactor(displayUnit);
    const int decimals = decimalsOfError(error / factor);
    return typeset(value / factor, decimals, locale) + QStringLiteral("\u00A0±\u00A0") +
           typeset(error / factor, decimals, locale) + QChar(0x00A0) + unitText(displayUnit);
}

QString roundedToError(double value, double error, std::string_view displayUnit, const QLocale& locale)
{
    if (!std::isfinite(value)) return tr("not known");
    return typeset(value / unitFactor(displayUnit), decimalsWithError(value, error, displayUnit), locale) +
           QChar(0x00A0) + unitText(displayUnit);
}

std::vector<AttitudeSection> attitudeSections(const Case& c, const SteadyResult& result, const QLocale& locale)
{
    std::vector<AttitudeSection> sections;
    if (!result.pressure.empty()) {
        sections = {attitude(result, locale),      interest(c, result, locale), contact(result, locale),
                    otherStates(result, locale),   forces(c, result, locale),   stiffness(result, locale),
                    sensitivities(result, locale), equilibria(result, locale)};
        std::erase_if(sections, [](const AttitudeSection& section) { return section.rows.empty(); });
        if (const QString state = notFoundText(result); !state.isEmpty())
            sections.insert(sections.begin(),
                            {sentence(tr("%1: numbers of the last step").arg(state).toStdString()).chopped(1), {}, {}});
    }
    sections.push_back(solution(result, locale));
    return sections;
}

QString sectionsAsText(const std::vector<AttitudeSection>& sections)
{
    QStringList lines;
    for (const AttitudeSection& section : sections) {
        if (!lines.isEmpty()) lines << QString();
        lines << (QStringList{section.title} + section.columns).join(QLatin1Char('\t'));
        for (const QStringList& row : section.rows) lines << row.join(QLatin1Char('\t'));
    }
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

QString steadyText(const SteadyResult& result, const QLocale& locale)
{
    const QString reason = sentence(result.message);
    if (result.status == SteadyStatus::Cancelled) return reason.isEmpty() ? tr("Stopped.") : reason;
    if (result.status == SteadyStatus::Failed) return reason.isEmpty() ? tr("The calculation failed.") : reason;
    const QString state =
        tr("minimum spacing %1, nominal trailing edge height %2, pitch %3, roll %4, net force %5.")
            .arg(withError(result.minimumSpacing, result.discretisationError.minimumSpacing, "nm", locale),
                 withError(result.attitude.height, 0.0, "nm", locale),
                 withError(result.attitude.pitch, result.discretisationError.pitch, "urad", locale),
                 withError(result.attitude.roll, result.discretisationError.roll, "urad", locale),
                 withError(result.forces.net, result.discretisationError.load, "mN", locale));
    if (result.status == SteadyStatus::NotConverged)
        return (reason.isEmpty() ? tr("Not converged.") : reason) + QLatin1Char(' ') +
               tr("The last state: %1").arg(state);
    QString text = sentence(state.toStdString());
    if (const ContactAtRest& at = result.contact; at.acts())
        text += QLatin1Char(' ') + tr("The slider is %1: contact force %2, adhesion force %3.")
                                       .arg(stateText(at), withError(at.contact, 0.0, "mN", locale),
                                            withError(at.adhesion, 0.0, "mN", locale));
    return text + (reason.isEmpty() ? QString() : QLatin1Char(' ') + reason);
}

} // namespace touchdown

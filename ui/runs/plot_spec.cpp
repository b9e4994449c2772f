// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/plot_spec.h"

#include <algorithm>
#include <utility>
#include <variant>

#include <QJsonObject>

#include "core/formats/units.h"
#include "ui/style/quantity_format.h"
#include "ui/style/translate.h"

namespace touchdown {

namespace {

constexpr auto phaseName = "phase";
constexpr auto phaseAcross = "height", phaseUp = "vertical_velocity";

bool sameKind(const std::string& displayUnit, const Quantity& quantity)
{
    return displayUnit == quantity.displayUnit ||
           std::holds_alternative<double>(parseQuantity("1 " + displayUnit, quantity.unit));
}

QString lowerFirst(QString text)
{
    const bool symbol = text.size() > 1 && text[1].isUpper();
    return symbol || text.isEmpty() ? text : text[0].toLower() + text.mid(1);
}

/// Of a plot whose axes are chosen: what it shows.
QString chosenTitle(const PlotSpec& spec)
{
    if (spec.spectrogram) return tr("Spectrogram");
    if (spec.name == QLatin1String(phaseName) && spec.across && spec.across->name == phaseAcross &&
        spec.curves.size() == 1 && spec.curves[0].quantity == phaseUp)
        return tr("Phase portrait");
    QStringList names;
    for (const PlotSpec::Curve& curve : spec.curves) names += curve.name;
    const QString up = names.join(QStringLiteral(", "));
    return spec.across ? tr("%1 against %2").arg(up, lowerFirst(QString::fromStdString(spec.across->longName))) : up;
}

QJsonObject toJson(const Quantity& quantity)
{
    return {{"name", QString::fromStdString(quantity.name)},
            {"unit", QString::fromStdString(quantity.unit)},
            {"display_unit", QString::fromStdString(quantity.displayUnit)},
            {"long_name", QString::fromStdString(quantity.longName)}};
}

/// Nothing where a unit is not known, as in settings of another version.
std::optional<Quantity> quantityFrom(const QJsonObject& json)
{
    const auto text = [&json](const char* key) { return json[QLatin1String(key)].toString().toStdString(); };
    const Quantity quantity{text("name"), text("unit"), text("display_unit"), text("long_name")};
    const bool known = std::holds_alternative<double>(parseQuantity("1 " + quantity.displayUnit, quantity.unit));
    if (quantity.name.empty() || !known) return std::nullopt;
    return quantity;
}

} // namespace

void PlotSpec::setUp(const Quantity& quantity)
{
    curves.clear();
    if (!spectrogram) unit = quantity.displayUnit;
    add(quantity);
}

void PlotSpec::setAcross(const std::optional<Quantity>& quantity)
{
    across = quantity;
    if (choosable) title = chosenTitle(*this);
}

void PlotSpec::add(const Quantity& quantity)
{
    if (spectrogram) curves.clear();
    curves.push_back({.quantity = quantity.name, .name = QString::fromStdString(quantity.longName), .added = quantity});
    if (choosable) title = chosenTitle(*this);
}

void PlotSpec::remove(std::string_view quantity)
{
    std::erase_if(curves, [quantity](const Curve& curve) { return curve.added && curve.quantity == quantity; });
    if (choosable) title = chosenTitle(*this);
}

bool PlotSpec::has(std::string_view quantity) const
{
    return std::ranges::find(curves, quantity, &Curve::quantity) != curves.end();
}

QString PlotSpec::refusal(const Quantity& quantity) const
{
    const QString named = QString::fromStdString(quantity.longName);
    if (spectrogram) return {}; // it takes the place of the one that is shown
    if (has(quantity.name)) return tr("%1 already stands in the plot \"%2\".").arg(named, title);
    if (sameKind(unit, quantity)) return {};
    return tr("%1 has the unit %2, but the plot \"%3\" shows values in %4. Make a plot of its own for it.")
        .arg(named, unitText(quantity.displayUnit), title, unitText(unit));
}

std::vector<PlotSpec> standardPlots()
{
    const Quantity separation{"minimum_spacing", "m", "nm", tr("Separation").toStdString()};
    const Quantity height{phaseAcross, "m", "nm", tr("Height").toStdString()};
    const bool hidden = false;
    return {
        {"force_separation",
         tr("Force against separation"),
         "mN",
         {{"contact_force", tr("Contact")},
          {"adhesion_force", tr("Adhesion")},
          {"net_contact_force", tr("Net")},
          {"fitted_contact_force", tr("Fitted"), true, 6, 1},
          {"fitted_adhesion_force", tr("Fitted"), true, 6, 1}},
         separation,
         hidden},
        {"spacing", tr("Minimum spacing"), "nm", {{"minimum_spacing", tr("Minimum spacing")}}},
        {"above_disk",
         tr("Above the disk"),
         "nm",
         {{"minimum_gap", tr("Minimum gap")},
          {"flying_height_above_disk", tr("Flying height")},
          {"disk_height", tr("Disk, above its mean plane"), true, 6, 1}}},
        {"pitch", tr("Pitch"), "urad", {{"pitch", tr("Pitch")}}},
        {"roll", tr("Roll"), "urad", {{"roll", tr("Roll")}}},
        {"energy",
         tr("Energy"),
         "pJ",
         {{"kinetic_energy", tr("Kinetic")},
          {"air_spring_energy", tr("Air springs")},
          {"suspension_energy", tr("Suspension")},
          {"contact_energy", tr("Contact")},
          {"film_energy", tr("Air film"), true, 1}, // no case has both kinds of air
          {"energy", tr("Total without contact"), true, 6}}},
        {"forces",
         tr("Contact forces"),
         "mN",
         {{"contact_force", tr("Contact")},
          {"adhesion_force", tr("Adhesion")},
          {"net_contact_force", tr("Net")},
          {"friction_force", tr("Friction"), false}}},
        {"air_bearing", tr("Air bearing force"), "mN", {{"air_bearing_force", tr("Air bearing")}}, {}, hidden},
        {"velocity", tr("Vertical velocity"), "mm/s", {{"vertical_velocity", tr("Vertical velocity")}}, {}, hidden},
        {"angular_velocity",
         tr("Angular velocities"),
         "rad/s",
         {{"pitch_velocity", tr("Pitch")}, {"roll_velocity", tr("Roll")}},
         {},
         hidden},
        {"area", tr("Contact area"), "um^2", {{"contact_area", tr("Contact area")}}, {}, hidden},
        {"pressure",
         tr("Peak contact pressure"),
         "MPa",
         {{"peak_contact_pressure", tr("Peak contact pressure")}},
         {},
         hidden},
        {"step", tr("Time step"), "ns", {{"time_step", tr("Time step")}}, {}, hidden, AxisScale::Logarithmic},
        {phaseName,
         tr("Phase portrait"),
         "mm/s",
         {{phaseUp, tr("Vertical velocity")}},
         height,
         hidden,
         AxisScale::Linear,
         true},
        {"spectrogram",
         tr("Spectrogram"),
         "kHz",
         {{"minimum_spacing", tr("Minimum spacing")}},
         {},
         hidden,
         AxisScale::Linear,
         true,
         false,
         true},
    };
}

PlotSpec ownPlot(const QString& name, const Quantity& up, const std::optional<Quantity>& across)
{
    PlotSpec spec;
    spec.name = name;
    spec.own = spec.choosable = true;
    spec.across = across;
    spec.setUp(up);
    return spec;
}

void nameApart(std::vector<PlotSpec>& specs)
{
    for (PlotSpec& spec : specs) {
        if (!spec.choosable) continue;
        const QString title = chosenTitle(spec);
        const auto isTaken = [&](const QString& wanted) {
            return std::ranges::any_of(specs, [&](const PlotSpec& other) {
                return &other != &spec && (!other.choosable || &other < &spec) && other.title == wanted;
            });
        };
        spec.title = title;
        for (int number = 2; isTaken(spec.title); ++number)
            spec.title = tr("%1 (%2)").arg(title, QString::number(number));
    }
}

QJsonArray changedPlots(const std::vector<PlotSpec>& specs)
{
    const std::vector<PlotSpec> standard = standardPlots();
    QJsonArray changed;
    for (const PlotSpec& spec : specs) {
        const auto before = std::ranges::find(standard, spec.name, &PlotSpec::name);
        QJsonArray added;
        for (const PlotSpec::Curve& curve : spec.curves)
            if (curve.added) added.append(toJson(*curve.added));
        const auto nameOf = [](const PlotSpec& each) { return each.across ? each.across->name : std::string(); };
        if (!spec.own && added.isEmpty() && nameOf(*before) == nameOf(spec)) continue;
        QJsonObject json{{"plot", spec.name}, {"own", spec.own}, {"added", added}};
        if (spec.across) json[QStringLiteral("across")] = toJson(*spec.across);
        changed.append(json);
    }
    return changed;
}

std::vector<PlotSpec> plotsWith(const QJsonArray& changed)
{
    std::vector<PlotSpec> specs = standardPlots();
    for (const QJsonValue& value : changed) {
        const QJsonObject json = value.toObject();
        const QString name = json[QStringLiteral("plot")].toString();
        const std::optional<Quantity> across = quantityFrom(json[QStringLiteral("across")].toObject());
        std::vector<Quantity> added;
        for (const QJsonValue& each : json[QStringLiteral("added")].toArray())
            if (const auto quantity = quantityFrom(each.toObject())) added.push_back(*quantity);
        auto spec = std::ranges::find(specs, name, &PlotSpec::name);
        if (spec == specs.end()) {
            if (!json[QStringLiteral("own")].toBool() || added.empty() || name.isEmpty()) continue;
            specs.push_back(ownPlot(name, added.front(), across));
            spec = specs.end() - 1;
        } else if (spec->choosable) {
            if (!added.empty()) spec->setUp(added.front());
            spec->setAcross(across);
        }
        for (const Quantity& quantity : added)
            if (spec->refusal(quantity).isEmpty()) spec->add(quantity);
    }
    return specs;
}

} // namespace touchdown

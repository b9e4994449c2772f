// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/modes_text.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QJsonArray>

#include "core/case_files/case_file.h"
#include "core/case_files/case_reader.h"
#include "core/case_files/case_text.h"

namespace touchdown {

namespace {

/// Frequency, damping ratio, their errors, the shape: JSON has no NaN, so an error that is not known is null.
QJsonArray numbersOf(const AirBearingMode& mode)
{
    QJsonArray numbers;
    for (const double value : {mode.frequency, mode.dampingRatio, mode.frequencyError, mode.dampingError})
        numbers << (std::isfinite(value) ? QJsonValue(value) : QJsonValue());
    for (const auto& amplitude : mode.shape)
        for (const double part : amplitude) numbers << part;
    return numbers;
}

constexpr qsizetype countOfNumbers = 10;

} // namespace

QJsonObject toJson(const FoundModes& modes)
{
    QJsonArray all;
    for (const AirBearingMode& mode : modes.result.modes)
        all << QJsonObject{{"kind", QString::fromStdString(mode.kind)}, {"numbers", numbersOf(mode)}};
    const Attitude& attitude = modes.result.steady.attitude;
    return {{"case", QString::fromStdString(formatCase(modes.value))},
            {"attitude", QJsonArray{attitude.height, attitude.pitch, attitude.roll}},
            {"message", QString::fromStdString(modes.result.message)},
            {"modes", all}};
}

std::optional<FoundModes> modesFromJson(const QJsonObject& json)
{
    FoundModes found;
    const CaseDocument document = parseCase(json["case"].toString().toStdString(), "the modes");
    const QJsonArray attitude = json["attitude"].toArray();
    if (json["case"].toString().isEmpty() || attitude.size() != 3) return std::nullopt;
    found.value = document.value;
    found.result.status = SteadyStatus::Converged;
    found.result.message = json["message"].toString().toStdString();
    found.result.steady.attitude = {attitude[0].toDouble(), attitude[1].toDouble(), attitude[2].toDouble()};
    for (const QJsonValue& each : json["modes"].toArray()) {
        AirBearingMode mode;
        const QJsonArray numbers = each["numbers"].toArray();
        if (numbers.size() != countOfNumbers) return std::nullopt;
        const auto number = [&numbers](qsizetype i) { return numbers[i].toDouble(DiscretisationError::unknown); };
        mode.kind = each["kind"].toString().toStdString();
        mode.frequency = number(0);
        mode.dampingRatio = number(1);
        mode.frequencyError = number(2);
        mode.dampingError = number(3);
        for (std::size_t i = 0; i < mode.shape.size(); ++i)
            for (std::size_t part = 0; part < 2; ++part)
                mode.shape[i][part] = numbers[static_cast<qsizetype>(4 + 2 * i + part)].toDouble();
        if (!std::isfinite(mode.frequency) || !std::isfinite(mode.dampingRatio)) return std::nullopt;
        found.result.modes.push_back(mode);
    }
    if (found.result.modes.empty()) return std::nullopt;
    return found;
}

QByteArray csvOf(const ModesResult& result)
{
    QByteArray text = "kind,frequency [Hz],frequency_error [Hz],damping_ratio,damping_ratio_error\n";
    for (const AirBearingMode& mode : result.modes) {
        text += QByteArray::fromStdString(mode.kind);
        for (const double value : {mode.frequency, mode.frequencyError, mode.dampingRatio, mode.dampingError})
            text += ',' + (std::isfinite(value) ? QByteArray::number(value, 'g', 12) : QByteArray());
        text += '\n';
    }
    return text;
}

} // namespace touchdown

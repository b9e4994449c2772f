// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/disk/disk_statistics.h"

#include <cmath>

#include <QCoreApplication>

#include "core/physics/disk/disk_surface_check.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("touchdown::DiskStatistics", text); }

QString withTrueMinus(QString text)
{
    if (text.startsWith(QLatin1Char('-'))) text.replace(0, 1, QChar(0x2212));
    return text;
}

} // namespace

std::vector<QStringList> diskStatistics(const DiskSurfacePreview& preview, const QLocale& locale)
{
    const SurfaceStatistics& s = preview.statistics;
    const DiskSurface& asked = preview.asked;
    const bool rough = !preview.requested.empty(); // and nothing else, so that the request is that of the whole
    const bool byLength = rough && asked.spectrum != RoughnessSpectrum::SelfAffine;
    const auto nanometres = [&locale](double value) { return withTrueMinus(readout(value, "nm", 4, locale)); };
    const auto length = [&locale](double value) { return trackText(value, locale); };
    const auto shape = [&locale](double value) {
        return withTrueMinus(locale.toString(std::abs(value) < 5e-4 ? 0.0 : value, 'f', 3));
    };
    const auto slope = [&locale](double value) { return locale.toString(value, 'g', 3); };
    const UniformGrid period = preview.topography.period();
    std::vector<QStringList> rows{
        {tr("RMS height"), nanometres(s.rms), rough ? nanometres(asked.rms) : QString()},
        {tr("Skewness"), shape(s.skewness), rough ? QStringLiteral("0") : QString()},
        {tr("Kurtosis"), shape(s.kurtosis), rough ? QStringLiteral("3") : QString()},
        {tr("RMS slope, x"), slope(s.slopeX), {}},
        {tr("RMS slope, y"), slope(s.slopeY), {}},
        {tr("Correlation"), s.correlationLength > 0.0 ? length(s.correlationLength) : QStringLiteral("–"),
         byLength ? length(asked.correlationLength) : QString()},
        {tr("Highest point"), nanometres(s.maximum), {}},
        {tr("Lowest point"), nanometres(s.minimum), {}},
        {tr("Track"), length(period.nx * period.dx), {}},
        {tr("Points"),
         period.ny > 1 ? QStringLiteral("%1 × %2").arg(period.nx).arg(period.ny) : QString::number(period.nx),
         {}},
    };
    if (period.ny == 1) rows.erase(rows.begin() + 4); // a profile has no slope across
    if (rough && asked.seed >= 0) rows.push_back({tr("Seed"), QString::number(asked.seed), {}});
    return rows;
}

QString trackText(double metres, const QLocale& locale)
{
    if (metres == 0.0) return QStringLiteral("0");
    if (metres < 0.9999995e-3) return lengthText(metres, 4, locale);
    return locale.toString(metres / 1e-3, 'g', 5) + QChar(0x00A0) + QStringLiteral("mm");
}

} // namespace touchdown

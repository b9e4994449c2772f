// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/studies/study_legend.h"

#include <algorithm>
#include <cmath>

#include <QFontMetricsF>

#include "ui/plot/plot_painter.h"
#include "ui/style/readable.h"
#include "ui/style/translate.h"

namespace touchdown {

namespace {

constexpr double between = 18.0;  // entries [px]
constexpr double sampleGap = 6.0; // sample and text [px]

} // namespace

StudyLegend::StudyLegend(const StudyChart& chart, const ChartStyles& styles, const PlotTheme& theme, const QFont& font,
                         bool underWay)
    : theme_(theme), font_(plotNumberFont(font))
{
    addSeries(chart, styles);
    addClasses(chart, underWay);
    addKey(chart);
}

void StudyLegend::addSeries(const StudyChart& chart, const ChartStyles& styles)
{
    for (const bool quiet : {false, true})
        for (const ChartPanel& panel : chart.panels)
            for (const ChartSeries& series : panel.series) {
                const QString name = readable(series.name);
                const auto known = std::ranges::find(entries_, name, &Entry::text);
                if (series.quiet != quiet || name.isEmpty() || known != entries_.end()) continue;
                entries_.push_back({Entry::Kind::Series,
                                    name,
                                    {series.name, {}, series.line, series.markers, quiet},
                                    styles.of(series.name),
                                    {}});
            }
}

void StudyLegend::addClasses(const StudyChart& chart, bool underWay)
{
    std::vector<std::pair<int, Entry>> classes; // by severity: from good to failed, as the colours go
    bool unknown = false;
    for (const ChartPanel& panel : chart.panels) {
        if (!panel.map) continue;
        unknown = unknown || std::ranges::any_of(panel.map->cells, [](int cell) { return cell < 0; });
        const std::vector<ClassStyle> fills = classStyles(panel.map->classes, theme_);
        for (std::size_t i = 0; i < fills.size(); ++i) {
            const bool used = std::ranges::find(panel.map->cells, static_cast<int>(i)) != panel.map->cells.end();
            const QString name = readable(panel.map->classes[i].name);
            const bool known =
                std::ranges::any_of(classes, [&name](const auto& each) { return each.second.text == name; });
            if (used && !known)
                classes.push_back({panel.map->classes[i].severity, {Entry::Kind::Class, name, {}, {}, fills[i]}});
        }
    }
    std::ranges::stable_sort(classes, {}, &std::pair<int, Entry>::first);
    for (auto& [severity, entry] : classes) entries_.push_back(std::move(entry));
    if (unknown)
        entries_.push_back({Entry::Kind::Unknown, underWay ? tr("not yet computed") : tr("not computed"), {}, {}, {}});
}

void StudyLegend::addKey(const StudyChart& chart)
{
    bool wrong = false, failed = false, chosen = false;
    for (const ChartPanel& panel : chart.panels)
        for (const ChartSeries& series : panel.series)
            for (const ChartPoint& point : series.points) {
                wrong = wrong || point.kind == PointKind::WrongState;
                failed = failed || point.kind == PointKind::Failed;
                chosen = chosen || point.chosen;
            }
    if (wrong) entries_.push_back({Entry::Kind::WrongState, tr("ends in another state"), {}, {}, {}});
    if (failed) entries_.push_back({Entry::Kind::Failed, tr("no valid answer"), {}, {}, {}});
    if (chosen) entries_.push_back({Entry::Kind::Chosen, tr("default or recommended"), {}, {}, {}});
}

double StudyLegend::sampleWidth(const Entry& entry) const
{
    return (entry.kind == Entry::Kind::Series ? 2.1 : 1.1) * QFontMetricsF(font_).height();
}

std::vector<QRectF> StudyLegend::places(double width) const
{
    const double row = std::ceil(1.35 * QFontMetricsF(font_).height());
    std::vector<QRectF> result;
    double x = 0.0, y = 0.0;
    for (const Entry& entry : entries_) {
        const double wanted = sampleWidth(entry) + sampleGap + QFontMetricsF(font_).horizontalAdvance(entry.text);
        if (x > 0.0 && x + wanted > width) {
            x = 0.0;
            y += row;
        }
        result.emplace_back(x, y, std::min(wanted, width), row);
        x += wanted + between;
    }
    return result;
}

double StudyLegend::height(double width) const { return entries_.empty() ? 0.0 : places(width).back().bottom(); }

void StudyLegend::paintSample(QPainter& painter, const Entry& entry, const QRectF& box) const
{
    const QPointF centre = box.center();
    const double radius = 0.32 * font_.pixelSize();
    SeriesStyle plain = entry.style;
    plain.quiet = true; // the key is about no series: in grey
    const QRectF square(box.left(), centre.y() - 0.5 * box.width(), box.width(), box.width());
    switch (entry.kind) {
    case Entry::Kind::Series:
        if (entry.look.line != ChartLine::None) {
            painter.setPen(seriesPen(entry.style, entry.look, theme_));
            painter.drawLine(QPointF(box.left(), centre.y()), QPointF(box.right(), centre.y()));
        }
        if (entry.look.markers)
            paintMarker(painter, centre, entry.look.quiet ? 0.7 * radius : radius, entry.style, PointKind::Good,
                        theme_);
        return;
    case Entry::Kind::WrongState: paintMarker(painter, centre, radius, plain, PointKind::WrongState, theme_); return;
    case Entry::Kind::Failed: paintMarker(painter, centre, radius, plain, PointKind::Failed, theme_); return;
    case Entry::Kind::Chosen: paintRing(painter, centre, 0.8 * radius, theme_); return;
    case Entry::Kind::Class: paintCell(painter, square, entry.fill, true); return;
    case Entry::Kind::Unknown: paintUnknownCell(painter, square, theme_); return;
    }
}

void StudyLegend::paint(QPainter& painter, const QRectF& box) const
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(font_);
    const QFontMetricsF metrics(font_);
    const std::vector<QRectF> where = places(box.width());
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        const QRectF place = where[i].translated(box.topLeft());
        const double sample = sampleWidth(entries_[i]);
        painter.setFont(font_);
        paintSample(painter, entries_[i], QRectF(place.left(), place.top(), sample, place.height()));
        painter.setPen(theme_.text);
        const QRectF text = place.adjusted(sample + sampleGap, 0.0, 2.0, 0.0);
        painter.drawText(text, Qt::AlignLeft | Qt::AlignVCenter,
                         metrics.elidedText(entries_[i].text, Qt::ElideRight, text.width()));
    }
    painter.restore();
}

} // namespace touchdown

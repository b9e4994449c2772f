// SPDX-License-Identifier: GPL-3.0-or-later
//
// The legend of a study's chart: one entry for each name of a series in any of its panels, one for each class of a map,
// cells that are not known, and the key of hollow, crossed and ringed points where there are such.
#pragma once

#include <vector>

#include <QFont>
#include <QPainter>

#include "core/studies/study/study.h"
#include "ui/studies/study_chart_style.h"

namespace touchdown {

class StudyLegend {
public:
    struct Entry {
        enum class Kind { Series, WrongState, Failed, Chosen, Class, Unknown };
        Kind kind = Kind::Series;
        QString text;
        ChartSeries look{}; // of a series, without its points
        SeriesStyle style{};
        ClassStyle fill{}; // of a class
    };

    /// `underWay`: cells without a class will have one.
    StudyLegend(const StudyChart& chart, const ChartStyles& styles, const PlotTheme& theme, const QFont& font,
                bool underWay = false);

    const std::vector<Entry>& entries() const { return entries_; }
    /// In rows as wide as this.
    double height(double width) const;
    void paint(QPainter& painter, const QRectF& box) const;

private:
    void addSeries(const StudyChart& chart, const ChartStyles& styles);
    void addClasses(const StudyChart& chart, bool underWay);
    void addKey(const StudyChart& chart);
    double sampleWidth(const Entry& entry) const;
    void paintSample(QPainter& painter, const Entry& entry, const QRectF& box) const;
    std::vector<QRectF> places(double width) const;

    const PlotTheme& theme_;
    QFont font_;
    std::vector<Entry> entries_;
};

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rows in which a series is chosen: what varies, from where to where, in how many states.
#pragma once

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSpinBox>
#include <QWidget>

#include "ui/film/series_points.h"

namespace touchdown {

class SeriesSetup : public QWidget {
    Q_OBJECT

public:
    explicit SeriesSetup(QWidget* parent = nullptr);

    /// The case as it is edited: offers its lists; numbers that were not changed by hand follow it.
    void setCase(const Case& c);
    /// Another case was opened: its lists where it has some, else the radius; usual numbers.
    void open(const Case& c);

    void setChoice(const SeriesChoice& choice);
    SeriesChoice choice() const;
    std::vector<SteadySeriesPoint> points() const { return pointsOf(case_, choice()); }
    /// Why there is no series; empty if there is one.
    QString problem() const;

private:
    Varied varied() const;
    void offerLists();
    void takeUsual();
    void showUnits();

    Case case_;
    SeriesChoice set_; // the numbers before the boxes rounded them
    QComboBox* varied_;
    QDoubleSpinBox *from_, *to_, *skewFrom_, *skewTo_;
    QSpinBox* states_;
    QLabel* lists_;
    std::vector<QWidget*> ends_, skews_; // shown where there are such
};

} // namespace touchdown

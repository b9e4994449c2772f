// SPDX-License-Identifier: GPL-3.0-or-later
//
// The fields of a static state: a map of one of them, and its sections along x and y through a point.
//
// The sections follow the pointer until a click pins them; Escape lets them follow again, Shift + arrows move them by a
// cell.
#pragma once

#include <vector>

#include <QCheckBox>
#include <QComboBox>
#include <QWidget>

#include "core/simulation/steady.h"
#include "ui/field_map.h"
#include "ui/field_sections.h"

namespace touchdown {

class MapsView : public QWidget {
    Q_OBJECT

public:
    enum class Quantity { Pressure, Gap, Recess };
    Q_ENUM(Quantity)

    explicit MapsView(QWidget* parent = nullptr);

    /// The fields of a result at this ambient pressure [Pa]; the slider as it was solved. Chosen quantity, units and view stay.
    void setResult(const SteadyResult& result, const SliderCase& slider, double skew, double ambient);
    void clear();

    void setQuantity(Quantity quantity);
    Quantity quantity() const { return quantity_; }
    void setSectionPoint(const SurfacePoint& point, bool pinned);
    std::optional<SurfacePoint> sectionPoint() const { return sectionPoint_; }
    bool pinned() const { return pinned_; }
    void fit();

    FieldMap* map() const { return map_; }
    FieldSections* sections() const { return sections_; }
    QComboBox* unit() const { return unit_; }
    QCheckBox* logarithmic() const { return logarithmic_; }
    /// Unit and scale, for the row in which the quantity is chosen.
    QWidget* controls() const { return controls_; }

protected:
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void buildControls();
    void showQuantity();
    void showField();
    void moveSection(int cellsX, int cellsY);
    std::optional<SurfacePoint> nearestTheDisk() const;
    FieldLook look(const std::vector<double>& values) const;

    SteadyResult result_;
    double ambient_ = 101325.0; // [Pa]
    Quantity quantity_ = Quantity::Pressure;
    bool logarithmicGap_ = true;
    bool logarithmicPressure_ = false;
    std::optional<SurfacePoint> sectionPoint_;
    bool pinned_ = false;
    QWidget* controls_;
    QComboBox* unit_;
    QCheckBox* logarithmic_;
    FieldMap* map_;
    FieldSections* sections_;
};

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fields on one grid: a map of one of them, its sections along x and y through cursor 1, and a table of the values at
// cursors 1 and 2.
//
// Cursor 1 and the sections follow the pointer until a click pins them. Shift + click, on the map or in a section, sets
// cursor 2. Shift + arrows move cursor 1 by a cell, Ctrl + Shift + arrows cursor 2. Escape takes cursor 2 away and lets
// cursor 1 follow again.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QCheckBox>
#include <QComboBox>
#include <QWidget>

#include "core/numerics/cell_grid.h"
#include "core/physics/slider/air_bearing_surface.h"
#include "ui/maps/field_map.h"
#include "ui/plot/min_max_pyramid.h"
#include "ui/plot/plot_theme.h"

namespace touchdown {

class FieldCursorTable;
class FieldSections;
struct OtherField;

/// A field that can be shown, and how.
struct MapKind {
    enum class Colours {
        BrightHigh,
        BrightLow, // small gaps are bright
        Recess,    // as the design of a slider is drawn
        Signed,    // about zero where both signs are, else what is strong is bright
    };
    enum class Logarithm { None, Offered, AtFirst };

    QString title;                  // "Gap"
    std::vector<std::string> units; // to choose from; the first at the start
    Colours colours = Colours::BrightHigh;
    Logarithm logarithm = Logarithm::None; // none where a value is zero or less, except about zero
    double near = 0.0;                     // a value that a logarithm about zero does not tell from zero [SI]
    bool aboutZero = false;                // zero in the middle even where one sign is missing
    QString symbol{};                      // on the axes of the sections: "p − p₀" for a pressure above ambient
};

class FieldsView : public QWidget {
    Q_OBJECT

public:
    explicit FieldsView(QWidget* parent = nullptr);

    void setKinds(std::vector<MapKind> kinds);
    /// One field for each kind, one value for each cell [SI], x fastest; none where there is nothing to show. With
    /// `ranges`, one for each kind, colours and sections span these instead of the shown values.
    /// `points`, one for each kind as far as known, has values between the centres of the cells.
    void setFields(const CellGrid& grid, std::vector<std::vector<double>> fields, std::vector<PlotRange> ranges = {},
                   std::vector<FieldAtPoints> points = {});

    /// Fields of the same kinds of another state, drawn in the sections beside those of `setFields`.
    struct OtherFields {
        QString name;
        CurveStyle style;
        CellGrid grid;
        std::vector<std::vector<double>> fields;
        std::vector<FieldAtPoints> points{}; // as far as known
    };
    /// At the next `setFields`; its own sections are then called `name` and look so.
    void setOthers(const QString& name, const CurveStyle& style, std::vector<OtherFields> others);

    void setField(int kind);
    int field() const { return field_; }
    void setSectionPoint(const SurfacePoint& point, bool pinned);
    /// Sections through this point, or none, at the next fields; a pinned point inside the area remains.
    void proposeSectionPoint(const std::optional<SurfacePoint>& point);
    std::optional<SurfacePoint> sectionPoint() const { return sectionPoint_; }
    bool pinned() const { return pinned_; }
    /// Cursor 2; nothing takes it away.
    void setSecondPoint(const std::optional<SurfacePoint>& point);
    std::optional<SurfacePoint> secondPoint() const { return secondPoint_; }
    void fit();

    FieldMap* map() const { return map_; }
    FieldSections* sections() const { return sections_; }
    FieldCursorTable* cursors() const { return table_; }
    QComboBox* unit() const { return unit_; }
    QCheckBox* logarithmic() const { return logarithmic_; }
    /// Unit and scale, for the row in which the field is chosen.
    QWidget* controls() const { return controls_; }

protected:
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void showKind();
    void showField();
    void showCursors();
    void moveCursor(bool second, int cellsX, int cellsY);
    FieldLook look(const MapKind& kind, bool logarithmic, double low, double high) const;

    std::vector<MapKind> kinds_;
    std::vector<bool> logarithms_; // of each kind, as the user chose
    CellGrid grid_;
    std::vector<std::vector<double>> fields_;
    std::vector<PlotRange> ranges_;
    std::vector<FieldAtPoints> points_;
    QString name_;
    CurveStyle style_{0, 0};
    std::vector<OtherFields> others_;
    std::vector<OtherField> shownOthers_; // of the field that is shown
    int field_ = 0;
    std::optional<SurfacePoint> sectionPoint_, secondPoint_;
    bool pinned_ = false;
    QWidget* controls_;
    QComboBox* unit_;
    QCheckBox* logarithmic_;
    FieldMap* map_;
    FieldSections* sections_;
    FieldCursorTable* table_;
};

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
//
// Place and value at the two cursors of a map, their differences and their distance, to be read and copied. A value is
// that of the cell that holds the cursor; fields of other states have a column each.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <QWidget>

#include "core/physics/slider/air_bearing_surface.h"
#include "ui/style/result_table.h"

namespace touchdown {

class FieldMap;
struct OtherField;

/// Cursor 1, through which the sections lie, and cursor 2.
using FieldCursors = std::array<std::optional<SurfacePoint>, 2>;

class FieldCursorTable : public QWidget {
    Q_OBJECT

public:
    explicit FieldCursorTable(QWidget* parent = nullptr);

    /// `name` of the field of the map, where others stand beside it. Without a cursor on the map the table is hidden.
    void show(const FieldMap& map, const FieldCursors& cursors, const QString& name,
              const std::vector<OtherField>& others);
    ResultTable* table() const { return table_; }

private:
    void fitHeight();

    ResultTable* table_;
};

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The fields of a static state: pressure, gap and recess on the slider.
#pragma once

#include "ui/maps/fields_view.h"

namespace touchdown {

struct Case;
struct SliderCase;
struct SteadyResult;

class MapsView : public FieldsView {
    Q_OBJECT

public:
    enum class Quantity { Pressure, Gap, Recess };
    Q_ENUM(Quantity)

    explicit MapsView(QWidget* parent = nullptr);

    /// The fields of a result at this ambient pressure [Pa]; the slider as it was solved. Chosen quantity, units and
    /// view stay.
    void setResult(const SteadyResult& result, const SliderCase& slider, double skew, double ambient);
    void clear();

    void setQuantity(Quantity quantity) { setField(static_cast<int>(quantity)); }
    Quantity quantity() const { return static_cast<Quantity>(field()); }
};

/// The air's pressure far from the slider [Pa].
double ambientPressure(const Case& c);

} // namespace touchdown

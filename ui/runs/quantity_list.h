// SPDX-License-Identifier: GPL-3.0-or-later
//
// The quantities of the runs, to be dragged into plots. A double click, or Enter, asks for a plot of its own.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QLabel>
#include <QListWidget>
#include <QMimeData>

#include "core/simulation/recording/quantity.h"

namespace touchdown {

class QuantityList : public QWidget {
    Q_OBJECT

public:
    explicit QuantityList(QWidget* parent = nullptr);

    /// The row that is chosen stays, if its quantity is still there.
    void setQuantities(const std::vector<Quantity>& quantities);
    QListWidget* list() const { return list_; }

signals:
    void plotWanted(const touchdown::Quantity& quantity);

private:
    QListWidget* list_;
    std::vector<Quantity> quantities_; // one a row
};

/// The name of the quantity that is dragged; nothing: something else is.
std::optional<std::string> draggedQuantity(const QMimeData& data);
/// What a drag of this quantity carries.
QMimeData* quantityDrag(const std::string& name);

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/quantity_list.h"

#include <algorithm>

#include <QVBoxLayout>

#include "ui/style/quantity_format.h"

namespace touchdown {

namespace {

const QString quantityFormat = QStringLiteral("application/x-touchdown-quantity");

class DraggedList : public QListWidget {
public:
    using QListWidget::QListWidget;

protected:
    QStringList mimeTypes() const override { return {quantityFormat}; }
    QMimeData* mimeData(const QList<QListWidgetItem*>& items) const override
    {
        return items.empty() ? nullptr : quantityDrag(items.front()->data(Qt::UserRole).toString().toStdString());
    }
};

} // namespace

QuantityList::QuantityList(QWidget* parent) : QWidget(parent), list_(new DraggedList(this))
{
    auto* hint = new QLabel(tr("Drag a quantity into a plot. Double-click for a plot of its own."), this);
    hint->setWordWrap(true);
    hint->setContentsMargins(6, 4, 6, 4);
    list_->setAccessibleName(tr("Quantities of the runs"));
    list_->setFrameShape(QFrame::NoFrame);
    list_->setDragEnabled(true);
    list_->setDragDropMode(QAbstractItemView::DragOnly);
    list_->setWordWrap(true);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFixedWidth(fontMetrics().averageCharWidth() * 32);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(hint);
    layout->addWidget(list_, 1);
    connect(list_, &QListWidget::itemActivated, this, [this](const QListWidgetItem* item) {
        emit plotWanted(quantities_[static_cast<std::size_t>(list_->row(item))]);
    });
}

void QuantityList::setQuantities(const std::vector<Quantity>& quantities)
{
    const auto same = [](const Quantity& a, const Quantity& b) { return a.name == b.name && a.longName == b.longName; };
    if (std::ranges::equal(quantities, quantities_, same)) return;
    const QString chosen = list_->currentItem() ? list_->currentItem()->data(Qt::UserRole).toString() : QString();
    quantities_ = quantities;
    list_->clear();
    for (const Quantity& quantity : quantities_) {
        auto* item = new QListWidgetItem(
            tr("%1 [%2]").arg(QString::fromStdString(quantity.longName), unitText(quantity.displayUnit)));
        item->setData(Qt::UserRole, QString::fromStdString(quantity.name));
        list_->addItem(item);
        if (item->data(Qt::UserRole).toString() == chosen) list_->setCurrentItem(item);
    }
}

std::optional<std::string> draggedQuantity(const QMimeData& data)
{
    if (!data.hasFormat(quantityFormat)) return std::nullopt;
    return data.data(quantityFormat).toStdString();
}

QMimeData* quantityDrag(const std::string& name)
{
    auto* data = new QMimeData;
    data->setData(quantityFormat, QByteArray::fromStdString(name));
    return data;
}

} // namespace touchdown

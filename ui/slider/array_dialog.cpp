// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/array_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>

#include "ui/slider/drag_field.h"

namespace touchdown {

ArrayDialog::ArrayDialog(QWidget* parent)
    : QDialog(parent), count_(new QSpinBox(this)), x_(new QLineEdit(this)), y_(new QLineEdit(this))
{
    setWindowTitle(tr("Array"));
    setAttribute(Qt::WA_DeleteOnClose);
    count_->setRange(1, 100);
    x_->setText(QStringLiteral("0"));
    y_->setText(QStringLiteral("0"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    auto* layout = new QFormLayout(this);
    layout->addRow(tr("&Copies"), count_);
    layout->addRow(tr("dx from one to the next [µm]"), x_);
    layout->addRow(tr("dy from one to the next [µm]"), y_);
    layout->addRow(buttons);
    const auto check = [this, buttons] { buttons->button(QDialogButtonBox::Ok)->setEnabled(step().has_value()); };
    for (QLineEdit* text : {x_, y_}) connect(text, &QLineEdit::textChanged, this, check);
    check();
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(buttons, &QDialogButtonBox::accepted, this, [this] {
        if (const auto by = step()) emit taken(count_->value(), *by);
        accept();
    });
}

std::optional<SurfaceShift> ArrayDialog::step() const
{
    const auto x = typedLength(x_->text()), y = typedLength(y_->text());
    if (!x || !y || (*x == 0.0 && *y == 0.0)) return {};
    return SurfaceShift{*x, *y};
}

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/slider/underlay_dialog.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QSignalBlocker>

#include "core/formats/units.h"
#include "ui/slider/drag_field.h"
#include "ui/style/foreign_text.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

UnderlayDialog::UnderlayDialog(Underlay& underlay, QWidget* parent)
    : QDialog(parent),
      underlay_(underlay),
      file_(new QLabel(this)),
      remark_(new QLabel(this)),
      unit_(new QComboBox(this)),
      width_(new QLineEdit(this)),
      x_(new QLineEdit(this)),
      y_(new QLineEdit(this)),
      mirrored_(new QCheckBox(tr("&Exchange top and bottom"), this)),
      opacity_(new QSlider(Qt::Horizontal, this))
{
    setObjectName(QStringLiteral("underlay"));
    setWindowTitle(tr("Drawing under the plan"));
    setAttribute(Qt::WA_DeleteOnClose);
    file_->setTextFormat(Qt::PlainText);
    remark_->setTextFormat(Qt::PlainText);
    remark_->setWordWrap(true);
    for (const char* unit : {"mm", "um", "nm", "inch"}) unit_->addItem(unitText(unit), unitFactor(unit));
    opacity_->setRange(5, 100);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    QPushButton* choose = buttons->addButton(tr("&Another file…"), QDialogButtonBox::ActionRole);
    rails_ = buttons->addButton(tr("&Take outlines as rails"), QDialogButtonBox::ActionRole);
    rails_->setToolTip(
        plainTip(tr("Each closed outline becomes a rail: with the recess that its layer tells, else zero. "
                    "The border of the slider is left out.")));
    remove_ = buttons->addButton(tr("&Remove"), QDialogButtonBox::DestructiveRole);
    for (QPushButton* button : {choose, rails_, remove_}) button->setAutoDefault(false); // Enter ends an entry
    auto* layout = new QFormLayout(this);
    layout->addRow(tr("File"), file_);
    layout->addRow(remark_);
    layout->addRow(tr("&Unit of the drawing"), unit_);
    layout->addRow(tr("&Width [µm]"), width_);
    layout->addRow(tr("Left edge, &x [µm]"), x_);
    layout->addRow(tr("Lower edge, &y [µm]"), y_);
    layout->addRow(mirrored_);
    layout->addRow(tr("&Opacity"), opacity_);
    layout->addRow(buttons);

    showPlace();
    for (QLineEdit* text : {width_, x_, y_}) connect(text, &QLineEdit::textEdited, this, &UnderlayDialog::take);
    connect(mirrored_, &QCheckBox::toggled, this, &UnderlayDialog::take);
    connect(opacity_, &QSlider::valueChanged, this, &UnderlayDialog::take);
    connect(unit_, &QComboBox::activated, this, [this] {
        width_->setText(typeset(underlay_.drawnWidth() * unit_->currentData().toDouble() * 1e6, 3));
        take();
    });
    connect(&underlay_, &Underlay::fileShown, this, [this] { showPlace(); });
    connect(&underlay_, &Underlay::changed, this, [this] {
        if (!underlay_.loaded()) close();
    });
    connect(choose, &QPushButton::clicked, this, &UnderlayDialog::fileWanted);
    connect(rails_, &QPushButton::clicked, this, &UnderlayDialog::railsWanted);
    connect(remove_, &QPushButton::clicked, &underlay_, &Underlay::remove);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
}

void UnderlayDialog::showPlace()
{
    const QSignalBlocker quietMirror(mirrored_), quietOpacity(opacity_);
    const UnderlayPlace& place = underlay_.place();
    file_->setText(QFileInfo(underlay_.file()).fileName());
    file_->setToolTip(plainTip(underlay_.file()));
    const bool asked = underlay_.isDrawing() && underlay_.unit() == 0.0;
    remark_->setText(underlay_.remark());
    remark_->setVisible(!remark_->text().isEmpty());
    unit_->setEnabled(asked);
    unit_->setToolTip(plainTip(asked ? tr("The file does not tell its unit") : QString()));
    const int known = unit_->findData(underlay_.unit());
    unit_->setCurrentIndex(asked ? -1 : known);
    for (const auto& [text, value] : {std::pair(width_, place.width), std::pair(x_, place.x), std::pair(y_, place.y)})
        text->setText(typeset(value * 1e6, 3));
    mirrored_->setChecked(place.mirrored);
    opacity_->setValue(static_cast<int>(std::lround(100.0 * place.opacity)));
    rails_->setEnabled(underlay_.isDrawing());
}

void UnderlayDialog::take()
{
    UnderlayPlace place = underlay_.place();
    if (const auto width = typedLength(width_->text()); width && *width > 0.0) place.width = *width;
    if (const auto x = typedLength(x_->text())) place.x = *x;
    if (const auto y = typedLength(y_->text())) place.y = *y;
    place.mirrored = mirrored_->isChecked();
    place.opacity = 0.01 * opacity_->value();
    underlay_.setPlace(place);
}

void askForUnderlay(QWidget* parent, const std::function<void(const QString& file)>& take)
{
    auto* dialog = new QFileDialog(parent, UnderlayDialog::tr("Drawing under the plan"), {},
                                   UnderlayDialog::tr("Pictures and drawings (*.png *.jpg *.jpeg *.dxf)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    QObject::connect(dialog, &QFileDialog::fileSelected, parent, take);
    dialog->open();
}

} // namespace touchdown

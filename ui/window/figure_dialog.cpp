// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/figure_dialog.h"

#include <algorithm>
#include <cmath>

#include <QDialogButtonBox>
#include <QEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLocale>
#include <QPainter>
#include <QSettings>
#include <QUrl>
#include <QVBoxLayout>

#include "ui/style/foreign_text.h"
#include "ui/style/save_dialog.h"

namespace touchdown {

namespace {

constexpr int atFirst = 2;    // panels
constexpr int mostKept = 100; // cases whose settings are kept
constexpr double ownWidth = -1.0;

/// The settings as text: a figure of one case, or the latest one.
QString settingsKey(const QString& of) { return QStringLiteral("figure/") + of; }

/// Each number and text of the format, with its name in the settings.
template <class Format, class Use>
void eachSetting(Format& format, const Use& use)
{
    use("width", format.width);
    use("height", format.height);
    use("columns", format.columns);
    use("family", format.family);
    use("fontSize", format.fontSize);
    use("dots", format.dotsPerInch);
    use("letters", format.letters);
    use("titles", format.titles);
    use("data", format.data);
}

} // namespace

FigureDialog::FigureDialog(QWidget& page, const QString& key, const QString& name, QWidget* parent)
    : QDialog(parent),
      key_(QString::number(qHash(key, 0), 16)),
      name_(name),
      panels_(new QListWidget),
      preview_(new QLabel),
      remark_(new QLabel),
      export_(new QPushButton(tr("&Export…")))
{
    setWindowTitle(tr("Figure for a paper"));
    setObjectName(QStringLiteral("figureDialog"));
    preview_->setAlignment(Qt::AlignCenter);
    preview_->setMinimumSize(320, 240);
    preview_->installEventFilter(this); // a remark of two lines takes its room
    preview_->setAccessibleName(tr("Preview of the figure"));
    remark_->setWordWrap(true);
    remark_->setTextFormat(Qt::RichText);
    remark_->setOpenExternalLinks(true);
    remark_->setTextInteractionFlags(Qt::TextBrowserInteraction);

    buildPanels(page);
    QWidget* form = buildForm();
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->addButton(export_, QDialogButtonBox::ActionRole);
    buttons->button(QDialogButtonBox::Close)->setAutoDefault(false);
    export_->setDefault(true);
    connect(export_, &QPushButton::clicked, this, &FigureDialog::chooseFile);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);

    preview_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored); // its picture follows it, not it the picture
    auto* right = new QVBoxLayout;
    right->addWidget(preview_, 1);
    right->addWidget(remark_);
    auto* upper = new QHBoxLayout;
    upper->addWidget(form);
    upper->addLayout(right, 1);
    auto* all = new QVBoxLayout(this);
    all->addLayout(upper, 1);
    all->addWidget(buttons);

    restore();
    resize(860, 620);
    changed();
}

void FigureDialog::buildPanels(QWidget& page)
{
    panels_->setAccessibleName(tr("Panels of the figure"));
    panels_->setToolTip(tr("Tick what the figure shows; drag to change the order"));
    panels_->setDragDropMode(QAbstractItemView::InternalMove);
    panels_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    panels_->setTextElideMode(Qt::ElideRight);
    for (QWidget* part : visibleParts(page)) {
        auto* item = new QListWidgetItem(dynamic_cast<PagePart*>(part)->title(), panels_);
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable | Qt::ItemIsDragEnabled);
        item->setCheckState(Qt::Unchecked);
        item->setData(Qt::UserRole, static_cast<int>(parts_.size()));
        parts_.emplace_back(part);
    }
    // The first and the last picture: the motion and its spectrum.
    for (int row = 0; row < panels_->count(); ++row)
        if (row < atFirst - 1 || row == panels_->count() - 1) panels_->item(row)->setCheckState(Qt::Checked);
    connect(panels_, &QListWidget::itemChanged, this, &FigureDialog::changed);
    connect(panels_->model(), &QAbstractItemModel::rowsMoved, this, &FigureDialog::changed);
}

QWidget* FigureDialog::buildForm()
{
    const auto number = [this](double least, double most, const QString& unit, int decimals) {
        auto* box = new QDoubleSpinBox;
        box->setRange(least, most);
        box->setDecimals(decimals);
        box->setSuffix(QChar(0x00A0) + unit);
        box->setKeyboardTracking(false);
        connect(box, &QDoubleSpinBox::valueChanged, this, &FigureDialog::changed);
        return box;
    };
    const auto whole = [this](int least, int most, const QString& suffix) {
        auto* box = new QSpinBox;
        box->setRange(least, most);
        box->setSuffix(suffix);
        box->setKeyboardTracking(false);
        connect(box, &QSpinBox::valueChanged, this, &FigureDialog::changed);
        return box;
    };
    const auto check = [this](const QString& text) {
        auto* box = new QCheckBox(text);
        connect(box, &QCheckBox::toggled, this, &FigureDialog::changed);
        return box;
    };
    width_ = new QComboBox;
    width_->setAccessibleName(tr("Width"));
    width_->addItem(tr("One column, 85 mm"), FigureFormat::oneColumn);
    width_->addItem(tr("Two columns, 170 mm"), FigureFormat::twoColumns);
    width_->addItem(tr("Another width"), ownWidth);
    ownWidth_ = number(20.0, 500.0, tr("mm"), 1);
    ownHeight_ = check(tr("Given height"));
    height_ = number(20.0, 2000.0, tr("mm"), 1);
    height_->setAccessibleName(tr("Height"));
    columns_ = whole(1, 4, {});
    columns_->setToolTip(tr("Panels beside each other"));
    family_ = new QFontComboBox;
    family_->setFontFilters(QFontComboBox::ScalableFonts);
    family_->setMinimumContentsLength(12);
    family_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    fontSize_ = number(4.0, 36.0, tr("pt"), 1);
    fontSize_->setToolTip(
        plainTip(tr("Of titles and legend; the numbers at the axes are a tenth smaller. Lines follow it: 1 pt "
                    "wide beside a text of 8 pt.")));
    dots_ = whole(72, 1200, tr(" dots per inch"));
    dots_->setToolTip(tr("Of a PNG. PDF and SVG hold lines and text."));
    colours_ = new QComboBox;
    colours_->addItem(tr("Coloured"));
    colours_->addItem(tr("Black and grey, dashed"));
    letters_ = check(tr("Letters (a), (b), …"));
    titles_ = check(tr("Titles"));
    titles_->setToolTip(plainTip(tr("Over spectra and other plots whose axis does not say what they show")));
    data_ = check(tr("The numbers beside it, as CSV"));
    connect(width_, &QComboBox::currentIndexChanged, this, [this] {
        const double chosen = width_->currentData().toDouble();
        ownWidth_->setEnabled(chosen < 0.0);
        if (chosen > 0.0) ownWidth_->setValue(chosen);
        changed();
    });
    connect(family_, &QFontComboBox::currentFontChanged, this, &FigureDialog::changed);
    connect(colours_, &QComboBox::currentIndexChanged, this, &FigureDialog::changed);

    auto* widths = new QHBoxLayout;
    widths->addWidget(width_, 1);
    widths->addWidget(ownWidth_);
    ownWidth_->setAccessibleName(tr("Another width"));
    auto* heights = new QHBoxLayout;
    heights->addWidget(ownHeight_, 1);
    heights->addWidget(height_);
    auto* form = new QWidget;
    auto* rows = new QFormLayout(form);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->addRow(tr("&Panels"), panels_);
    rows->addRow(tr("Width"), widths);
    rows->addRow({}, heights);
    rows->addRow(tr("Panels in a &row"), columns_);
    rows->addRow(tr("&Font"), family_);
    rows->addRow(tr("Font &size"), fontSize_);
    rows->addRow(tr("&Curves"), colours_);
    rows->addRow(tr("&Resolution"), dots_);
    rows->addRow({}, letters_);
    rows->addRow({}, titles_);
    rows->addRow({}, data_);
    form->setMaximumWidth(380);
    return form;
}

FigureFormat FigureDialog::format() const
{
    FigureFormat format;
    format.width = ownWidth_->value();
    format.height = ownHeight_->isChecked() ? height_->value() : 0.0;
    format.columns = columns_->value();
    format.family = family_->currentFont().family();
    format.fontSize = fontSize_->value();
    format.dotsPerInch = dots_->value();
    format.colours = colours_->currentIndex() == 1 ? PaperColours::Black : PaperColours::Coloured;
    format.letters = letters_->isChecked();
    format.titles = titles_->isChecked();
    format.data = data_->isChecked();
    return format;
}

void FigureDialog::setFormat(const FigureFormat& format)
{
    const int known = width_->findData(format.width);
    width_->setCurrentIndex(known >= 0 ? known : width_->findData(ownWidth));
    ownWidth_->setEnabled(known < 0);
    ownWidth_->setValue(format.width);
    ownHeight_->setChecked(format.height > 0.0);
    if (format.height > 0.0) height_->setValue(format.height);
    columns_->setValue(format.columns);
    family_->setCurrentFont(format.family.isEmpty() ? font() : QFont(format.family));
    fontSize_->setValue(format.fontSize);
    dots_->setValue(format.dotsPerInch);
    colours_->setCurrentIndex(format.colours == PaperColours::Black ? 1 : 0);
    letters_->setChecked(format.letters);
    titles_->setChecked(format.titles);
    data_->setChecked(format.data);
}

PaperFigure FigureDialog::figure() const
{
    std::vector<QWidget*> chosen;
    for (int row = 0; row < panels_->count(); ++row) {
        const QListWidgetItem* item = panels_->item(row);
        const QPointer<QWidget>& part = parts_[item->data(Qt::UserRole).toUInt()];
        if (item->checkState() == Qt::Checked && part) chosen.push_back(part);
    }
    return {chosen, format()};
}

void FigureDialog::restore()
{
    const QSettings settings;
    const bool known = settings.contains(settingsKey(key_));
    const QVariantMap kept = settings.value(settingsKey(known ? key_ : QStringLiteral("latest"))).toMap();
    FigureFormat format;
    eachSetting(format, [&kept](const char* name, auto& value) {
        using Value = std::remove_reference_t<decltype(value)>;
        const QVariant found = kept.value(QLatin1String(name));
        if (found.canConvert<Value>()) value = found.value<Value>();
    });
    if (kept.value(QStringLiteral("black")).toBool()) format.colours = PaperColours::Black;
    const QSignalBlocker quiet(panels_);
    setFormat(format);
    const QStringList names = kept.value(QStringLiteral("panels")).toStringList();
    if (!known || names.isEmpty()) return;
    for (int row = 0; row < panels_->count(); ++row) panels_->item(row)->setCheckState(Qt::Unchecked);
    int next = 0; // in the order in which they stood
    for (const QString& name : names)
        for (int row = next; row < panels_->count(); ++row) {
            if (panels_->item(row)->text() != name) continue;
            panels_->insertItem(next, panels_->takeItem(row));
            panels_->item(next++)->setCheckState(Qt::Checked);
            break;
        }
}

void FigureDialog::keep() const
{
    const FigureFormat now = format();
    QStringList names;
    for (int row = 0; row < panels_->count(); ++row)
        if (panels_->item(row)->checkState() == Qt::Checked) names << panels_->item(row)->text();
    QVariantMap kept{{QStringLiteral("black"), now.colours == PaperColours::Black}, {QStringLiteral("panels"), names}};
    eachSetting(now, [&kept](const char* name, const auto& value) { kept[QLatin1String(name)] = value; });
    QSettings settings;
    settings.setValue(settingsKey(key_), kept);
    settings.setValue(settingsKey(QStringLiteral("latest")), kept);
    const QString orderKey = settingsKey(QStringLiteral("cases"));
    QStringList order = settings.value(orderKey).toStringList();
    order.removeAll(key_);
    order.prepend(key_);
    while (order.size() > mostKept) settings.remove(settingsKey(order.takeLast()));
    settings.setValue(orderKey, order);
}

/// What was chosen is there again when the figure is made another time, also where nothing was exported.
void FigureDialog::done(int result)
{
    if (!figure().empty()) keep();
    QDialog::done(result);
}

void FigureDialog::changed()
{
    height_->setEnabled(ownHeight_->isChecked());
    const PaperFigure figure = this->figure();
    const QString problem = figure.empty() ? tr("Tick at least one panel.") : figure.problem();
    const QSizeF size = figure.size();
    if (!figure.empty() && !ownHeight_->isChecked()) {
        const QSignalBlocker quiet(height_);
        height_->setValue(size.height());
    }
    const auto oneDigit = [](double number) { return QLocale().toString(number, 'f', 1); };
    const QString sizeText = tr("%1 mm × %2 mm.").arg(oneDigit(size.width()), oneDigit(size.height()));
    remark_->setText(escaped(problem.isEmpty() ? (sizeText + QLatin1Char(' ') + figure.remark()).trimmed() : problem));
    export_->setEnabled(problem.isEmpty());
    showPreview();
}

void FigureDialog::showPreview()
{
    const PaperFigure figure = this->figure();
    const QSizeF size = figure.picture().size;
    if (figure.empty() || size.isEmpty()) return preview_->setPixmap({});
    const double ratio = devicePixelRatioF();
    const QSizeF room = preview_->size() * ratio;
    const double scale = std::min({room.width() / size.width(), room.height() / size.height(), 2.0 * ratio});
    QPixmap pixmap((size * scale).toSize().expandedTo({1, 1}));
    pixmap.fill(Qt::white);
    QPainter painter(&pixmap);
    painter.scale(scale, scale);
    figure.picture().paint(painter);
    painter.end();
    pixmap.setDevicePixelRatio(ratio);
    preview_->setPixmap(pixmap);
}

void FigureDialog::chooseFile()
{
    const QFileDialog* dialog =
        openSaveDialog(this, tr("Export the figure"), pictureFilters(), name_ + QStringLiteral(".pdf"));
    connect(dialog, &QFileDialog::fileSelected, this, &FigureDialog::exportTo);
}

void FigureDialog::exportTo(const QString& path)
{
    const PaperFigure figure = this->figure();
    const QString problem = figure.save(path);
    if (!problem.isEmpty()) return remark_->setText(escaped(problem));
    keep();
    QStringList links;
    for (const QString& file : QStringList{path} + figure.dataFiles(path))
        links << QStringLiteral("<a href=\"%1\">%2</a>")
                     .arg(QUrl::fromLocalFile(file).toString(QUrl::FullyEncoded), escaped(QFileInfo(file).fileName()));
    remark_->setText(tr("Written: %1").arg(links.join(QStringLiteral(", "))));
}

bool FigureDialog::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == preview_ && event->type() == QEvent::Resize) showPreview();
    return QDialog::eventFilter(watched, event);
}

} // namespace touchdown

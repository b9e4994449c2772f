// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/spectrum_view.h"

#include <algorithm>
#include <cmath>

#include <QEvent>
#include <QVBoxLayout>

#include "core/formats/units.h"
#include "ui/style/foreign_text.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

namespace {

constexpr double kilohertz = 1e3;  // [Hz]
constexpr int quantityStretch = 3; // the other choices are short
// Share of the power of the highest peak, 50 dB: a fainter peak does not widen the axis.
constexpr double faintest = 1e-5;

QString squared(const QString& unit)
{
    if (unit.isEmpty()) return QStringLiteral("1");
    const bool simple = std::ranges::all_of(unit, [](QChar c) { return c.isLetter(); });
    return (simple ? unit : u'(' + unit + u')') + QChar(0x00b2);
}

/// Coarse, so that the axis stays while a run goes.
double roundedUp(double frequency)
{
    const double power = std::pow(10.0, std::floor(std::log10(frequency)));
    for (const double factor : {1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0})
        if (factor * power >= frequency) return factor * power;
    return 10.0 * power;
}

void choose(QComboBox* box, const QVariant& data)
{
    const QSignalBlocker quiet(box);
    box->setCurrentIndex(box->findData(data));
}

} // namespace

SpectrumView::SpectrumView(QWidget* parent)
    : QWidget(parent),
      plot_(new PlotWidget(this)),
      group_(new PlotGroup(this, PlotGroup::Across::Frequency)),
      controls_(new QWidget(this)),
      quantity_(new QComboBox(controls_)),
      window_(new QComboBox(controls_)),
      segment_(new QComboBox(controls_)),
      overlap_(new QSpinBox(controls_)),
      scaling_(new QComboBox(controls_)),
      logFrequency_(new QCheckBox(tr("&Log"), controls_)),
      row_(new QHBoxLayout)
{
    window_->addItem(tr("Hann"), static_cast<int>(SpectrumWindow::Hann));
    window_->addItem(tr("Hamming"), static_cast<int>(SpectrumWindow::Hamming));
    window_->addItem(tr("Blackman"), static_cast<int>(SpectrumWindow::Blackman));
    window_->addItem(tr("Flat top"), static_cast<int>(SpectrumWindow::FlatTop));
    window_->addItem(tr("Rectangular"), static_cast<int>(SpectrumWindow::Rectangular));
    for (int samples = 256; samples <= 65536; samples *= 2) segment_->addItem(tr("%1 pts").arg(samples), samples);
    overlap_->setRange(0, 95);
    overlap_->setSingleStep(5);
    overlap_->setSuffix(tr(" % overlap"));
    overlap_->setKeyboardTracking(false);
    scaling_->addItem(tr("Density"), static_cast<int>(SpectrumScaling::Density));
    scaling_->addItem(tr("Amplitude"), static_cast<int>(SpectrumScaling::Amplitude));
    logFrequency_->setToolTip(tr("Logarithmic frequency axis"));
    logFrequency_->setAccessibleName(tr("Logarithmic frequency axis"));
    plot_->setYScale(AxisScale::Logarithmic);
    setOptions({});

    auto* rows = new QVBoxLayout(controls_);
    rows->setSpacing(4);
    rows->setContentsMargins(6, 4, 6, 4);
    row_->setSpacing(6);
    rows->addLayout(row_);
    // The boxes have no labels: these would make the window too wide for a small screen.
    const auto add = [&](QWidget* box, int stretch, const QString& name, const QString& toolTip) {
        box->setAccessibleName(name);
        box->setToolTip(plainTip(toolTip));
        row_->addWidget(box, stretch);
    };
    add(quantity_, quantityStretch, tr("Quantity"), tr("Quantity whose spectrum is shown"));
    add(window_, 1, tr("Window"), tr("Window that each segment is multiplied with"));
    add(segment_, 1, tr("Segment"),
        tr("Samples in each segment: more give a finer resolution, fewer a smoother average"));
    add(overlap_, 1, tr("Overlap"), tr("Overlap of neighbouring segments"));
    add(scaling_, 1, tr("Scaling"),
        tr("Density: its integral over frequency is the mean square. "
           "Amplitude: a sine of amplitude A shows A\u00b2/2 at its frequency."));
    row_->addSpacing(6);
    row_->addWidget(logFrequency_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(controls_);
    layout->addWidget(plot_, 1);

    group_->add(plot_);
    plot_->setTitle(tr("Spectrum"));
    plot_->setXLabel({tr("Frequency"), QStringLiteral("kHz"), kilohertz, AxisScale::Linear});
    updateAxes();
    for (QComboBox* box : {quantity_, window_, segment_, scaling_}) {
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(box == quantity_ ? 12 : 6);
        connect(box, &QComboBox::currentIndexChanged, this, &SpectrumView::request);
    }
    connect(overlap_, &QSpinBox::valueChanged, this, &SpectrumView::request);
    for (const auto& [kind, text] : {std::pair(FrequencyKind::Mode, tr("Lines at the &modes")),
                                     std::pair(FrequencyKind::Contact, tr("Line at the frequency of co&ntact")),
                                     std::pair(FrequencyKind::Wave, tr("Lines at the &waves of the disk"))}) {
        lines_[kind] = new QAction(text, this);
        lines_[kind]->setCheckable(true);
        connect(lines_[kind], &QAction::toggled, this, &SpectrumView::updateLines);
    }
    connect(logFrequency_, &QCheckBox::toggled, this, [this](bool on) {
        AxisLabel label = plot_->xAxis().label;
        label.scale = on ? AxisScale::Logarithmic : AxisScale::Linear;
        plot_->setXLabel(label);
        group_->fit();
        group_->followNewest();
        updateMarks();
    });
}

bool SpectrumView::event(QEvent* event)
{
    const bool handled = QWidget::event(event);
    if (event->type() == QEvent::Resize || event->type() == QEvent::LayoutRequest) arrangeControls();
    return handled;
}

/// The quantity has a line of its own where the choices have no room beside it.
void SpectrumView::arrangeControls()
{
    auto* rows = static_cast<QVBoxLayout*>(controls_->layout());
    const bool beside = row_->indexOf(quantity_) >= 0;
    const QMargins around = rows->contentsMargins();
    const int own = beside ? 0 : quantity_->sizeHint().width() + row_->spacing();
    const bool room = row_->sizeHint().width() + own + around.left() + around.right() <= width();
    if (room == beside) return;
    (beside ? static_cast<QBoxLayout*>(row_) : rows)->removeWidget(quantity_);
    if (room)
        row_->insertWidget(0, quantity_, quantityStretch);
    else
        rows->insertWidget(0, quantity_);
}

void SpectrumView::setQuantities(const std::vector<Quantity>& quantities)
{
    const QString before = quantity();
    const QSignalBlocker quiet(quantity_);
    quantities_ = quantities;
    quantity_->clear();
    for (const Quantity& q : quantities)
        quantity_->addItem(QString::fromStdString(q.longName), QString::fromStdString(q.name));
    quantity_->setCurrentIndex(std::max(0, quantity_->findData(before)));
    updateAxes();
}

QString SpectrumView::quantity() const { return quantity_->currentData().toString(); }

void SpectrumView::setQuantity(const QString& name)
{
    if (quantity_->findData(name) < 0) return;
    choose(quantity_, name);
    updateAxes();
}

WelchOptions SpectrumView::options() const
{
    WelchOptions options;
    options.window = static_cast<SpectrumWindow>(window_->currentData().toInt());
    options.scaling = static_cast<SpectrumScaling>(scaling_->currentData().toInt());
    options.segment = static_cast<std::size_t>(segment_->currentData().toInt());
    options.overlap = overlap_->value() / 100.0;
    return options;
}

void SpectrumView::setOptions(const WelchOptions& options)
{
    const int samples = static_cast<int>(options.segment);
    if (segment_->findData(samples) < 0) {
        const QSignalBlocker quiet(segment_);
        segment_->addItem(tr("%1 pts").arg(samples), samples);
    }
    choose(segment_, samples);
    choose(window_, static_cast<int>(options.window));
    choose(scaling_, static_cast<int>(options.scaling));
    const QSignalBlocker quiet(overlap_);
    overlap_->setValue(static_cast<int>(std::lround(100.0 * options.overlap)));
    updateAxes();
}

void SpectrumView::request()
{
    const AxisLabel before = plot_->yAxis().label;
    const QString title = plot_->title();
    updateAxes();
    // Curves of another quantity or scaling would be read with the new unit.
    if (plot_->yAxis().label != before || plot_->title() != title) clear();
    emit requested(quantity(), options());
}

void SpectrumView::updateAxes()
{
    AxisLabel label{tr("Power"), QStringLiteral("1"), 1.0, plot_->yAxis().label.scale};
    if (quantity_->currentIndex() >= 0) {
        const Quantity& q = quantities_[static_cast<std::size_t>(quantity_->currentIndex())];
        const double factor = q.displayUnit.empty() ? 1.0 : unitFactor(q.displayUnit);
        label.unit = squared(unitText(q.displayUnit));
        label.factor = factor * factor;
        plot_->setTitle(tr("Spectrum: %1").arg(QString::fromStdString(q.longName)));
    }
    if (options().scaling == SpectrumScaling::Density) {
        label.title = tr("Density");
        label.unit += QStringLiteral("/Hz");
    }
    plot_->setYLabel(label);
}

void SpectrumView::setSpectrum(const QString& id, const QString& name, const CurveStyle& style,
                               const Spectrum& spectrum, const std::vector<Peak>& peaks)
{
    auto samples = std::make_unique<MinMaxPyramid>();
    std::vector<double> frequency;
    std::vector<double> power;
    for (std::size_t i = 0; i < std::min(spectrum.frequency.size(), spectrum.power.size()); ++i) {
        if (!(spectrum.power[i] > 0.0)) continue;
        frequency.push_back(spectrum.frequency[i]);
        power.push_back(spectrum.power[i]);
    }
    samples->append(frequency, power);

    std::vector<PointMark> marks;
    for (const Peak& peak : peaks) {
        const auto height = samples->valueAt(peak.frequency);
        if (!height) continue;
        // The mark is at the top of the line, at a bin beside the interpolated frequency.
        const double resolution = spectrum.frequency.size() > 1 ? spectrum.frequency[1] - spectrum.frequency[0] : 0.0;
        const auto top = samples->extremes(peak.frequency - resolution, peak.frequency + resolution);
        const int decimals = peak.frequency >= 100.0 * kilohertz ? 1 : peak.frequency >= 10.0 * kilohertz ? 2 : 3;
        marks.push_back({peak.frequency, top ? top->high : *height,
                         tr("%1 kHz").arg(typeset(peak.frequency / kilohertz, decimals)), style});
    }
    peaks_[id] = std::move(marks);
    const auto before = std::ranges::find(plot_->curves(), id, &PlotCurve::id);
    PlotCurve curve = before == plot_->curves().end() ? PlotCurve{} : *before;
    curve.id = id;
    curve.name = name;
    curve.style = style;
    curve.data = samples.get();
    plot_->addCurve(curve);
    spectra_[id] = std::move(samples); // the curve points to the new data by now
    updateMarks();
    group_->dataChanged();
    emit curvesChanged();
}

void SpectrumView::removeSpectrum(const QString& id)
{
    plot_->removeCurve(id);
    spectra_.erase(id);
    peaks_.erase(id);
    updateMarks();
    group_->dataChanged();
    emit curvesChanged();
}

void SpectrumView::clear()
{
    plot_->clearCurves();
    spectra_.clear();
    peaks_.clear();
    ranged_.clear();
    updateMarks();
    emit curvesChanged();
}

void SpectrumView::updateCurves(const std::function<void(PlotCurve&)>& change)
{
    plot_->updateCurves(change);
    updateMarks();
    group_->dataChanged();
    emit curvesChanged();
}

void SpectrumView::setReferences(std::vector<ReferenceFrequency> references)
{
    if (references == references_) return;
    references_ = std::move(references);
    for (const auto& [kind, wanted] : lines_) {
        if (std::ranges::find(references_, kind, &ReferenceFrequency::kind) != references_.end())
            plot_->addAction(wanted);
        else
            plot_->removeAction(wanted);
    }
    updateLines();
}

void SpectrumView::updateLines()
{
    std::vector<ReferenceLine> lines;
    for (const ReferenceFrequency& each : references_)
        if (lines_.at(each.kind)->isChecked())
            lines.push_back(
                {each.frequency,
                 QStringLiteral("%1 %2").arg(QString::fromStdString(each.name), frequencyText(each.frequency)), true});
    plot_->setReferenceLines(std::move(lines));
}

void SpectrumView::updateMarks()
{
    std::vector<PointMark> marks;
    double last = 0.0; // peak that stands out [Hz]
    for (const PlotCurve& curve : plot_->curves()) {
        const auto found = peaks_.find(curve.id);
        if (!curve.visible || !curve.leads || found == peaks_.end()) continue;
        double highest = 0.0;
        for (const PointMark& mark : found->second) highest = std::max(highest, mark.y);
        for (const PointMark& mark : found->second)
            if (mark.y >= faintest * highest) last = std::max(last, mark.x);
        marks.insert(marks.end(), found->second.begin(), found->second.end());
    }
    plot_->setPointMarks(std::move(marks));
    const bool linear = !plot_->xAxis().logarithmic();
    const auto leads = std::ranges::find_if(plot_->curves(), [](const PlotCurve& c) { return c.visible && c.leads; });
    const bool grows = leads != plot_->curves().end() && !leads->still && leads->id == ranged_;
    widest_ = std::max(last > 0.0 ? roundedUp(1.25 * last) : 0.0, grows ? widest_ : 0.0);
    ranged_ = leads != plot_->curves().end() ? leads->id : QString();
    if (!spectra_.empty())
        group_->setFirstRange(widest_ > 0.0 && linear ? std::optional(PlotRange{0.0, widest_}) : std::nullopt);
}

} // namespace touchdown

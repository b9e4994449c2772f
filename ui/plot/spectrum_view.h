// SPDX-License-Identifier: GPL-3.0-or-later
//
// Power spectra of one quantity of several runs, with the choices of Welch's method above them.
//
// The frequency axis ends a little above the last peak that stands out and is not faint, until the user zooms or asks
// for everything.
// The view computes nothing: connect `requested`, compute (on any thread), and hand the result to setSpectrum().
// Power that is zero, negative or not finite is left out.
#pragma once

#include <map>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QSpinBox>

#include "core/numerics/spectrum.h"
#include "core/simulation/recording/quantity.h"
#include "core/simulation/reference_frequencies.h"
#include "ui/plot/plot_group.h"

namespace touchdown {

class SpectrumView : public QWidget {
    Q_OBJECT

public:
    explicit SpectrumView(QWidget* parent = nullptr);

    /// Fills the selector; the chosen quantity stays chosen when it is still there. Emits nothing.
    void setQuantities(const std::vector<Quantity>& quantities);
    QString quantity() const; // its name, "minimum_spacing"; empty when there is none
    void setQuantity(const QString& name);
    WelchOptions options() const;
    void setOptions(const WelchOptions& options); // emits nothing

    /// A curve with the same id is replaced. Frequencies in Hz, power in SI of the chosen quantity; the peaks are
    /// labelled in kHz.
    void setSpectrum(const QString& id, const QString& name, const CurveStyle& style, const Spectrum& spectrum,
                     const std::vector<Peak>& peaks = {});
    void removeSpectrum(const QString& id);
    void clear();

    /// Changes how spectra are shown: name, pale or not, shown at all. Peaks and the automatic range of frequency are
    /// those of the curves that lead.
    void updateCurves(const std::function<void(PlotCurve&)>& change);

    /// Frequencies of the case: the menu of the plot offers lines at those kinds that it has.
    void setReferences(std::vector<ReferenceFrequency> references);
    /// Shows the lines of this kind.
    QAction* linesWanted(FrequencyKind kind) const { return lines_.at(kind); }

    /// The choices of Welch's method and of the quantity, above the plot.
    void showControls(bool shown) { controls_->setVisible(shown); }

    PlotWidget* plot() const { return plot_; }
    PlotGroup* group() const { return group_; }

signals:
    /// The user chose: please compute the spectra of all runs anew.
    void requested(const QString& quantity, const touchdown::WelchOptions& options);
    /// Spectra came, went or are shown in another way.
    void curvesChanged();

protected:
    bool event(QEvent* event) override;

private:
    void arrangeControls();
    void request();
    void updateAxes();
    void updateMarks();
    void updateLines();

    PlotWidget* plot_;
    PlotGroup* group_;
    QWidget* controls_;
    QComboBox* quantity_;
    QComboBox* window_;
    QComboBox* segment_;
    QSpinBox* overlap_;
    QComboBox* scaling_;
    QCheckBox* logFrequency_;
    QHBoxLayout* row_; // of these
    std::vector<Quantity> quantities_;
    std::map<FrequencyKind, QAction*> lines_;
    std::vector<ReferenceFrequency> references_;
    std::map<QString, std::unique_ptr<MinMaxPyramid>> spectra_;
    QString ranged_;      // the curve that leads, whose run may go on: its axis does not become shorter then
    double widest_ = 0.0; // the axis of that curve; 0: all of it [Hz]
    std::map<QString, std::vector<PointMark>> peaks_;
};

} // namespace touchdown

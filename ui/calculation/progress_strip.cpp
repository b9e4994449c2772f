// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calculation/progress_strip.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QEvent>
#include <QHBoxLayout>
#include <QPainter>
#include <QStyle>

#include "core/work/wall_clock.h"
#include "ui/style/foreign_text.h"
#include "ui/style/quantity_format.h"
#include "ui/style/readable.h"

namespace touchdown {

namespace {

constexpr int barSteps = 1000;

/// A text that is wider than its place is cut in the middle, and whole in the tool tip.
class ElidedLabel : public QLabel {
public:
    using QLabel::QLabel;

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        style()->drawItemText(&painter, contentsRect(), Qt::AlignLeft | Qt::AlignVCenter, palette(), isEnabled(),
                              shown(), foregroundRole());
    }
    bool event(QEvent* event) override
    {
        if (event->type() == QEvent::ToolTip) setToolTip(shown() == text() ? QString() : plainTip(text()));
        return QLabel::event(event);
    }

private:
    QString shown() const { return fontMetrics().elidedText(text(), Qt::ElideMiddle, contentsRect().width()); }
};

QString timeLeftText(double seconds)
{
    if (seconds < 1.0) return ProgressStrip::tr("less than 1 s left");
    if (seconds < 99.5) return ProgressStrip::tr("%1 s left").arg(std::lround(seconds));
    const long minutes = std::lround(seconds / 60.0);
    if (minutes < 60) return ProgressStrip::tr("%1 min left").arg(minutes);
    return ProgressStrip::tr("%1 h %2 min left").arg(minutes / 60).arg(minutes % 60, 2, 10, QLatin1Char('0'));
}

QStringList partsOf(const Progress& progress, std::optional<double> left)
{
    QStringList parts;
    if (progress.share) parts << ProgressStrip::tr("%1 %").arg(std::floor(100.0 * std::min(1.0, *progress.share)));
    if (!progress.activity.empty()) parts << readable(progress.activity);
    for (const ProgressFigure& figure : progress.figures) {
        const auto spelled = [&](double value) { return roundedText(value, figure.displayUnit, figure.digits); };
        const QString text = QString::fromStdString(figure.name) + QLatin1Char(' ') + spelled(figure.value);
        parts << (figure.whole ? ProgressStrip::tr("%1 of %2").arg(text, spelled(*figure.whole)) : text);
        if (figure.whole && left)
            parts << ProgressStrip::tr("%1 per second").arg(spelled((*figure.whole - figure.value) / *left));
    }
    if (left) parts << timeLeftText(*left);
    return parts;
}

} // namespace

ProgressStrip::ProgressStrip(CalculationController& controller, const QString& calculation, QString running,
                             QWidget* parent)
    : QWidget(parent),
      running_(std::move(running)),
      state_(new QLabel(tr("Ready"), this)),
      bar_(new QProgressBar(this)),
      text_(new ElidedLabel(this))
{
    bar_->setTextVisible(false);
    bar_->setFixedHeight(10);
    bar_->setFixedWidth(180);
    bar_->setRange(0, barSteps);
    bar_->setAccessibleName(tr("Progress of the %1").arg(calculation));
    state_->setAccessibleName(tr("State of the %1").arg(calculation));
    text_->setAccessibleName(tr("Progress of the %1 in words").arg(calculation));
    text_->setMinimumWidth(1); // cut off rather than widening the window
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 2, 8, 2);
    layout->setSpacing(10);
    layout->addWidget(state_);
    layout->addWidget(bar_);
    layout->addWidget(text_, 1);
    bar_->hide();
    connect(&controller, &CalculationController::stateChanged, this, &ProgressStrip::setState);
    connect(&controller, &CalculationController::progressed, this,
            [this](int, const Progress& progress) { advance(progress); });
}

void ProgressStrip::setState(CalculationController::State state)
{
    using State = CalculationController::State;
    timeLeft_.restart();
    if (state == State::Idle) {
        bar_->hide();
        return;
    }
    state_->setText(state == State::Running ? running_ : state == State::Paused ? tr("Paused") : tr("Stopping"));
    if (bar_->isHidden()) {
        progress_ = {};
        bar_->setRange(0, 0); // moves until a share is known
        bar_->show();
    }
    showText(); // without the time left
}

void ProgressStrip::advance(const Progress& progress)
{
    progress_ = progress;
    bar_->setRange(0, progress.share ? barSteps : 0);
    bar_->setUpdatesEnabled(false); // a bar paints at once, and with it all of the window that waits to be painted
    if (progress.share) bar_->setValue(static_cast<int>(std::lround(std::clamp(*progress.share, 0.0, 1.0) * barSteps)));
    bar_->setUpdatesEnabled(true);
    showText();
}

void ProgressStrip::showText()
{
    const std::optional<double> left = timeLeft_.at(progress_.share, wallClock());
    text_->setText(partsOf(progress_, left).join(QStringLiteral(" · ")));
}

void ProgressStrip::conclude(std::string_view status, const QString& text)
{
    bar_->hide();
    QString state = statusText(status);
    state[0] = state[0].toUpper();
    state_->setText(state);
    text_->setText(text);
}

void ProgressStrip::clear()
{
    state_->setText(tr("Ready"));
    text_->clear();
}

} // namespace touchdown

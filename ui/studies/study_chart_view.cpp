// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/studies/study_chart_view.h"

#include <algorithm>
#include <utility>

#include <QFontMetricsF>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include "ui/studies/study_chart_data.h"
#include "ui/studies/study_chart_drawing.h"

namespace touchdown {

namespace {

constexpr double leastBox = 6.0; // below it a drag was a click [px]

bool sameAxes(const StudyChart& a, const StudyChart& b)
{
    const auto same = [](const ChartAxis& x, const ChartAxis& y) {
        return x.label == y.label && x.unit == y.unit && x.logarithmic == y.logarithmic;
    };
    return a.title == b.title && std::ranges::equal(a.panels, b.panels, [&](const ChartPanel& p, const ChartPanel& q) {
               return same(p.x, q.x) && same(p.y, q.y);
           });
}
constexpr double chartOnPaper = 480.0; // width in which titles and legend have room [px]

} // namespace

StudyChartView::StudyChartView(QWidget* parent) : PictureWidget(parent, chartOnPaper)
{
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    setAccessibleName(tr("Chart of the study"));
}

StudyChartView::~StudyChartView() = default;

void StudyChartView::setChart(StudyChart chart, bool underWay)
{
    if (!sameAxes(chart, chart_)) zoomed_.assign(chart.panels.size(), std::nullopt);
    drawing_.reset(); // it refers to the chart
    chart_ = std::move(chart);
    underWay_ = underWay;
    setAccessibleName(chart_.title.empty() ? tr("Chart of the study") : QString::fromStdString(chart_.title));
    setAccessibleDescription(QString::fromStdString(chart_.caption));
    if (pointed_) setPointed({}, {});
    dragged_.reset();
    updateGeometry();
    redraw();
}

void StudyChartView::fit()
{
    std::ranges::fill(zoomed_, std::nullopt);
    redraw();
}

const StudyChartDrawing& StudyChartView::drawing() const
{
    if (!drawing_)
        drawing_ =
            std::make_unique<StudyChartDrawing>(chart_, plotTheme(palette()), font(), size(), zoomed_, underWay_);
    return *drawing_;
}

void StudyChartView::paint(QPainter& painter, const PlotTheme& theme)
{
    StudyChartDrawing(chart_, theme, font(), size(), zoomed_, underWay_).paint(painter);
}

double StudyChartView::heightOnPaper(double width, const QFont& font) const
{
    const double wider = widening(width, chartOnPaper);
    return StudyChartDrawing::goodHeight(chart_, font, wider * width) / wider;
}

std::function<void(QIODevice&)> StudyChartView::dataWriter() const
{
    return [this](QIODevice& device) { writeChartCsv(chart_, device); };
}

QString StudyChartView::htmlTip() const
{
    return pointed_ ? drawing().panels()[pointed_->panel].reading(pointed_->hit) : QString();
}

QSize StudyChartView::sizeHint() const { return {700, heightForWidth(700)}; }

int StudyChartView::heightForWidth(int width) const
{
    return static_cast<int>(StudyChartDrawing::leastHeight(chart_, font(), width));
}

void StudyChartView::redraw()
{
    drawing_.reset();
    update();
}

void StudyChartView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const PlotTheme theme = plotTheme(palette());
    drawing().paint(painter);
    if (pointed_) drawing().panels()[pointed_->panel].paintPointed(painter, pointed_->hit);
    if (dragged_ && drag_.width() > 1.0) {
        QColor fill = theme.selection;
        fill.setAlphaF(0.15F);
        painter.fillRect(drag_, fill);
        painter.setPen(QPen(theme.selection, 1.0));
        painter.drawRect(drag_);
    }
}

void StudyChartView::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    drawing_.reset();
}

void StudyChartView::changeEvent(QEvent* event)
{
    PictureWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        updateGeometry();
        redraw();
    }
}

std::optional<std::size_t> StudyChartView::panelAt(const QPointF& pixel) const
{
    const std::vector<StudyPanel>& panels = drawing().panels();
    for (std::size_t i = 0; i < panels.size(); ++i)
        if (panels[i].area().contains(pixel)) return i;
    return {};
}

void StudyChartView::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton) return QWidget::mousePressEvent(event);
    dragged_ = panelAt(event->position());
    drag_ = QRectF(event->position(), QSizeF());
}

void StudyChartView::mouseMoveEvent(QMouseEvent* event)
{
    if (!dragged_ || !(event->buttons() & Qt::LeftButton)) return point(event->position());
    const QRectF area = drawing().panels()[*dragged_].area();
    const QPointF to(std::clamp(event->position().x(), area.left(), area.right()),
                     std::clamp(event->position().y(), area.top(), area.bottom()));
    drag_.setBottomRight(to);
    update();
}

void StudyChartView::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || !dragged_) return;
    const std::size_t panel = *dragged_;
    dragged_.reset();
    const QRectF box = drag_.normalized();
    if (box.width() >= leastBox && box.height() >= leastBox) zoomed_[panel] = drawing().panels()[panel].rangeOf(box);
    redraw();
}

void StudyChartView::mouseDoubleClickEvent(QMouseEvent* event)
{
    const std::optional<std::size_t> panel = panelAt(event->position());
    if (!panel) return;
    zoomed_[*panel].reset();
    redraw();
}

void StudyChartView::leaveEvent(QEvent* event)
{
    QWidget::leaveEvent(event);
    setPointed({}, {});
}

void StudyChartView::point(const QPointF& pixel)
{
    const std::vector<StudyPanel>& panels = drawing().panels();
    std::optional<Pointed> found;
    for (std::size_t i = 0; i < panels.size() && !found; ++i)
        if (const std::optional<PanelHit> hit = panels[i].at(pixel)) found = Pointed{i, *hit};
    setPointed(found, mapToGlobal(pixel.toPoint()));
}

void StudyChartView::setPointed(const std::optional<Pointed>& pointed, const QPoint& at)
{
    if (pointed == pointed_) return;
    pointed_ = pointed;
    if (pointed_)
        QToolTip::showText(at, htmlTip(), this);
    else
        QToolTip::hideText();
    update();
}

void StudyChartView::goToPoint(int by)
{
    std::vector<Pointed> all;
    const std::vector<StudyPanel>& panels = drawing().panels();
    for (std::size_t i = 0; i < panels.size(); ++i)
        for (std::size_t s = 0; s < panels[i].panel().series.size(); ++s)
            for (std::size_t p = 0; p < panels[i].panel().series[s].points.size(); ++p)
                all.push_back({i, {static_cast<int>(s), static_cast<int>(p), -1, -1}});
    for (std::size_t i = 0; i < panels.size() && all.empty(); ++i)
        for (std::size_t c = 0; panels[i].panel().map && c < panels[i].panel().map->cells.size(); ++c)
            all.push_back({i, {-1, -1, static_cast<int>(c), -1}});
    if (all.empty()) return;
    const auto now = pointed_ ? std::ranges::find(all, *pointed_) : all.end();
    const auto count = static_cast<std::ptrdiff_t>(all.size());
    const std::ptrdiff_t next = now == all.end() ? (by > 0 ? 0 : count - 1) : (now - all.begin() + by + count) % count;
    const Pointed& to = all[static_cast<std::size_t>(next)];
    const StudyPanel& panel = panels[to.panel];
    QPointF at = panel.area().center();
    if (to.hit.point >= 0) {
        const ChartPoint& p = panel.panel()
                                  .series[static_cast<std::size_t>(to.hit.series)]
                                  .points[static_cast<std::size_t>(to.hit.point)];
        at = panel.toPixel(p.x, p.y);
    }
    setPointed(to, mapToGlobal(at.toPoint()));
}

void StudyChartView::keyPressEvent(QKeyEvent* event)
{
    switch (event->key()) {
    case Qt::Key_Right: return goToPoint(1);
    case Qt::Key_Left: return goToPoint(-1);
    case Qt::Key_Home: return fit();
    case Qt::Key_Escape: return setPointed({}, {});
    default: QWidget::keyPressEvent(event);
    }
}

void StudyChartView::fillMenu(QMenu& menu)
{
    menu.addAction(tr("&Fit all"), QKeySequence(Qt::Key_Home), this, &StudyChartView::fit);
    menu.addSeparator();
}

} // namespace touchdown

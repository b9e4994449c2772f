// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/paper_figure.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include <QBuffer>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QFontMetricsF>

#include "ui/plot/plot_painter.h"
#include "ui/style/translate.h"
#include "ui/style/whole_file.h"

namespace touchdown {

namespace {

// The font decides all other sizes: in a figure its text is 12 pixels high, so that a curve of 1.5 pixels is 1 point
// wide beside a text of 8 points.
constexpr int textPixels = 12;
constexpr double pointsPerInch = 72.0, millimetresPerInch = 25.4;
constexpr double betweenPanels = 8.0;                // [px]
constexpr double leastAcross = 90.0, leastUp = 48.0; // of the area of curves [px]

QByteArray firstLine(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readLine() : QByteArray();
}

PagePart& partOf(QWidget* widget) { return dynamic_cast<PagePart&>(*widget); }

} // namespace

PaperFigure::PaperFigure(const std::vector<QWidget*>& panels, const FigureFormat& format)
    : format_(format), pixelsPerInch_(textPixels * pointsPerInch / format.fontSize)
{
    if (!format.family.isEmpty()) font_.setFamily(format.family);
    font_.setPixelSize(textPixels);
    const double pixels = pixelsPerInch_ / millimetresPerInch;
    size_ = {format.width * pixels, format.height * pixels};
    const int count = static_cast<int>(panels.size());
    const int columns = std::clamp(format.columns, 1, std::max(1, count));
    const int rows = (count + columns - 1) / columns;
    const double width = (size_.width() - (columns - 1) * betweenPanels) / columns;
    std::vector<double> heights(static_cast<std::size_t>(rows)); // of the rows
    for (int i = 0; i < count; ++i) {
        double& height = heights[static_cast<std::size_t>(i / columns)];
        height = std::max(height, partOf(panels[static_cast<std::size_t>(i)]).heightOnPaper(width, font_));
    }
    const double wanted = std::accumulate(heights.begin(), heights.end(), 0.0);
    const double between = std::max(0, rows - 1) * betweenPanels;
    if (format.height <= 0.0) size_.setHeight(wanted + between);
    double top = 0.0;
    for (int row = 0; row < rows; ++row) {
        const double height = heights[static_cast<std::size_t>(row)] * (size_.height() - between) / wanted;
        for (int i = row * columns; i < std::min(count, (row + 1) * columns); ++i)
            cells_.push_back({panels[static_cast<std::size_t>(i)],
                              QRectF((i % columns) * (width + betweenPanels), top, width, height)});
        top += height + betweenPanels;
    }
    for (const Cell& cell : cells_)
        if (const auto* plot = qobject_cast<const PlotWidget*>(cell.panel))
            paperCurves(plot->curves(), format_.colours, styles_);
}

/// Panels over one quantity leave labels of reference lines the same room: below each other they stay aligned.
PaperSheet PaperFigure::sheetOf(const Cell& cell) const
{
    double labels = 0.0;
    const auto* plot = qobject_cast<const PlotWidget*>(cell.panel);
    for (const Cell& other : cells_)
        if (const auto* beside = qobject_cast<const PlotWidget*>(other.panel);
            plot && beside && beside->xAxis().label == plot->xAxis().label)
            labels = std::max(labels, beside->labelRoom(font_).width);
    return {cell.box.size(), font_, format_.colours, styles_, labels, format_.titles};
}

QSizeF PaperFigure::size() const { return size_ * millimetresPerInch / pixelsPerInch_; }

QString PaperFigure::letter(std::size_t cell) const
{
    return cells_.size() > 1 ? QString(QChar(u'a' + static_cast<char16_t>(cell))) : QString();
}

QString PaperFigure::problem() const
{
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        const QString name = cells_.size() > 1 ? tr("Panel (%1)").arg(letter(i)) : tr("The panel");
        const auto* plot = qobject_cast<const PlotWidget*>(cells_[i].panel);
        if (plot == nullptr) continue;
        const PlotTheme theme = paperTheme(format_.colours);
        const PlotPainter painter(*plot, theme, sheetOf(cells_[i]));
        if (painter.area().width() < leastAcross)
            return tr("%1 is too narrow for its axes: make the figure wider, its font smaller or its columns fewer.")
                .arg(name);
        if (painter.area().height() < std::max(leastUp, PlotFrame::leastOnPaper * painter.heightOfTitle()))
            return tr("%1 is too low for its axes and legend: make the figure higher or its font smaller.").arg(name);
        std::vector<CurveStyle> styles;
        for (const LegendEntry& entry : painter.legend().entries) {
            if (std::ranges::find(styles, entry.curve->style) != styles.end())
                return tr("%1 has more curves than can be told apart: hide some of them.").arg(name);
            styles.push_back(entry.curve->style);
        }
    }
    return {};
}

QString PaperFigure::remark() const
{
    QStringList panels;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        const auto* plot = qobject_cast<const PlotWidget*>(cells_[i].panel);
        if (plot == nullptr) continue;
        const PlotTheme theme = paperTheme(format_.colours);
        const std::size_t missing = PlotPainter(*plot, theme, sheetOf(cells_[i])).labelsWithoutRoom();
        if (missing > 0)
            panels << (cells_.size() > 1 ? tr("%1 in panel (%2)").arg(missing).arg(letter(i))
                                         : QString::number(missing));
    }
    if (panels.isEmpty()) return {};
    return tr("Labels of lines that are cut or left out: %1. A wider figure, a smaller font or fewer lines give them "
              "room.")
        .arg(panels.join(QStringLiteral(", ")));
}

Picture PaperFigure::picture() const
{
    return {size_,
            {},
            [this](QPainter& painter) { paint(painter); },
            pixelsPerInch_,
            static_cast<double>(format_.dotsPerInch)};
}

void PaperFigure::paint(QPainter& painter) const
{
    painter.fillRect(QRectF(QPointF(), size_), Qt::white);
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        const auto& [panel, box] = cells_[i];
        painter.save();
        painter.translate(box.topLeft());
        auto* plot = qobject_cast<PlotWidget*>(panel);
        if (plot != nullptr)
            plot->paintOnSheet(painter, sheetOf(cells_[i]));
        else
            partOf(panel).paintOnPaper(painter, box.size(), font_, format_.colours);
        if (const QString name = letter(i); !name.isEmpty() && format_.letters) {
            const QString text = QStringLiteral("(%1)").arg(name);
            // Beside the legend of a plot; other pictures have less room there.
            const QRectF corner(2.0, plot != nullptr ? PlotFrame::gap : 0.0,
                                QFontMetricsF(font_).horizontalAdvance(text) + 4.0, 1.0 * textPixels);
            painter.fillRect(corner, Qt::white);
            painter.setFont(font_);
            painter.setPen(Qt::black);
            painter.drawText(corner, Qt::AlignLeft | Qt::AlignTop | Qt::TextDontClip, text);
        }
        painter.restore();
    }
}

QStringList PaperFigure::dataFiles(const QString& path) const
{
    QStringList files;
    const QFileInfo info(path);
    for (std::size_t i = 0; i < cells_.size() && format_.data; ++i) {
        if (!partOf(cells_[i].panel).dataWriter()) continue;
        const QString name = letter(i);
        files << info.dir().filePath(info.completeBaseName() + (name.isEmpty() ? QString() : u'-' + name) +
                                     QStringLiteral(".csv"));
    }
    return files;
}

QString PaperFigure::save(const QString& path) const
{
    const auto picture = pictureBytes(this->picture(), path);
    if (!picture)
        return tr("%1 does not end in .pdf, .svg or .png, so its format is not known.")
            .arg(QDir::toNativeSeparators(path));
    if (picture->isEmpty())
        return tr("%1 could not be written: the picture has too many pixels. Choose a lower resolution.")
            .arg(QDir::toNativeSeparators(path));
    const QStringList data = dataFiles(path);
    std::vector<std::pair<QString, QByteArray>> files{{path, *picture}};
    for (const Cell& cell : cells_) {
        const auto write = partOf(cell.panel).dataWriter();
        if (!write || !format_.data) continue;
        QBuffer buffer;
        buffer.open(QIODevice::WriteOnly);
        write(buffer);
        const QString& file = data[static_cast<qsizetype>(files.size()) - 1];
        // The person was asked about the figure itself only: another figure's numbers are not replaced.
        if (QFileInfo::exists(file) && firstLine(file) != buffer.data().left(buffer.data().indexOf('\n') + 1))
            return tr("%1 exists already and holds something else: choose another name for the figure.")
                .arg(QDir::toNativeSeparators(file));
        files.emplace_back(file, buffer.data());
    }
    return writeWholeFiles(files);
}

} // namespace touchdown

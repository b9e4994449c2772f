// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/theme.h"

#include <algorithm>
#include <cmath>

#include <QApplication>
#include <QFile>
#include <QFont>
#include <QHeaderView>
#include <QPainter>
#include <QProxyStyle>
#include <QSvgRenderer>

namespace touchdown {

namespace {

/// The look of the platform, as it was before the first applyTheme().
struct SystemLook {
    bool dark = isDark(QGuiApplication::palette());
    int pointSize = QApplication::font().pointSize() > 0 ? QApplication::font().pointSize() : 10;
};

const SystemLook& systemLook()
{
    static const SystemLook look;
    return look;
}

const QStringList& themeNames() // in the order of Theme
{
    static const QStringList names{"system", "light", "dark"};
    return names;
}

struct Tones {
    QColor window, base, alternate, button, text, muted, highlight, highlightedText, link, toolTip, line;
};

QPalette paletteOf(const Tones& tones)
{
    QPalette palette(tones.button, tones.window);
    palette.setColor(QPalette::WindowText, tones.text);
    palette.setColor(QPalette::Base, tones.base);
    palette.setColor(QPalette::AlternateBase, tones.alternate);
    palette.setColor(QPalette::Text, tones.text);
    palette.setColor(QPalette::ButtonText, tones.text);
    palette.setColor(QPalette::BrightText, tones.highlightedText);
    palette.setColor(QPalette::PlaceholderText, tones.muted);
    palette.setColor(QPalette::Highlight, tones.highlight);
    palette.setColor(QPalette::HighlightedText, tones.highlightedText);
    palette.setColor(QPalette::Link, tones.link);
    palette.setColor(QPalette::LinkVisited, tones.link);
    palette.setColor(QPalette::ToolTipBase, tones.toolTip);
    palette.setColor(QPalette::ToolTipText, tones.text);
    palette.setColor(QPalette::Mid, tones.line);
    for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, tones.muted);
    palette.setColor(QPalette::Disabled, QPalette::Highlight, tones.line);
    return palette;
}

/// Fusion with a border around boxes and round buttons that nobody ticked: its own vanishes in the dark.
class BorderedStyle : public QProxyStyle {
public:
    BorderedStyle() : QProxyStyle(QStringLiteral("Fusion")) {}

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override
    {
        QProxyStyle::drawPrimitive(element, option, painter, widget);
        const bool round = element == PE_IndicatorRadioButton;
        if (!(element == PE_IndicatorCheckBox || round) || !option->state.testFlag(State_Enabled)) return;
        painter->save();
        painter->setPen(meaningColours(option->palette).muted);
        painter->setBrush(Qt::NoBrush);
        painter->setRenderHint(QPainter::Antialiasing, round);
        const QRectF border = QRectF(option->rect).adjusted(0.5, 0.5, -0.5, -0.5);
        round ? painter->drawEllipse(border) : painter->drawRect(border);
        painter->restore();
    }
};

QByteArray svgOf(const QString& name)
{
    QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QPixmap drawn(QByteArray svg, const QColor& colour, int size)
{
    svg.replace("currentColor", colour.name().toLatin1());
    QSvgRenderer renderer(svg);
    QPixmap pixmap(size, size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    renderer.render(&painter);
    return pixmap;
}

} // namespace

QString themeName(Theme theme) { return themeNames()[static_cast<int>(theme)]; }

Theme themeFromName(const QString& name)
{
    return static_cast<Theme>(std::max<qsizetype>(0, themeNames().indexOf(name)));
}

void applyTheme(Theme theme, int pointSize)
{
    const SystemLook& system = systemLook();
    QApplication::setStyle(new BorderedStyle);
    const bool dark = theme == Theme::Dark || (theme == Theme::System && system.dark);
    // Fusion draws no lighter frame around a text box: the dark window is clearly lighter than its base.
    QApplication::setPalette(dark ? paletteOf({"#2d3238", "#1a1d21", "#22262b", "#3b424a", "#e4e8ec", "#a0a8b1",
                                               "#2f7fc4", "#ffffff", "#6db3ee", "#2f353c", "#545c66"})
                                  : paletteOf({"#f3f4f6", "#ffffff", "#f0f2f5", "#fbfbfc", "#1b1f24", "#7b838c",
                                               "#1f6fb5", "#ffffff", "#155d9c", "#fffdf2", "#c9ced5"}));
    QFont font = QApplication::font();
    font.setPointSize(pointSize > 0 ? pointSize : system.pointSize);
    QApplication::setFont(font);
}

int systemPointSize() { return systemLook().pointSize; }

MeaningColours meaningColours(const QPalette& palette)
{
    if (isDark(palette)) return {"#ff8a80", "#f0b860", "#7fcf8f", "#6db3ee", "#9aa3ad"};
    return {"#b3261e", "#8a5300", "#1c7434", "#155d9c", "#626b75"};
}

double contrast(const QColor& a, const QColor& b)
{
    const auto luminance = [](const QColor& colour) {
        const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
        return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
    };
    const auto [low, high] = std::minmax({luminance(a), luminance(b)});
    return (high + 0.05) / (low + 0.05);
}

bool isDark(const QPalette& palette)
{
    return palette.color(QPalette::Window).lightness() < palette.color(QPalette::WindowText).lightness();
}

void setTextColour(QWidget* widget, const QColor& colour)
{
    QPalette palette;
    if (colour.isValid()) palette.setColor(QPalette::WindowText, colour);
    if (widget->palette() != palette) widget->setPalette(palette);
}

void makePlain(QTableView& table)
{
    table.verticalHeader()->hide();
    table.setEditTriggers(QAbstractItemView::NoEditTriggers);
    table.setShowGrid(false);
    table.setAlternatingRowColors(true);
    table.setFrameShape(QFrame::NoFrame);
    table.setWordWrap(false);
}

void makePlainTable(QTableWidget* table, const QStringList& headers)
{
    makePlain(*table);
    table->setColumnCount(static_cast<int>(headers.size()));
    table->setHorizontalHeaderLabels(headers);
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
}

QIcon icon(const QString& name, const QPalette& palette)
{
    const QByteArray svg = svgOf(name);
    QIcon made;
    if (svg.isEmpty()) return made;
    for (const int size : {16, 20, 24, 32, 48, 64}) {
        made.addPixmap(drawn(svg, palette.color(QPalette::Active, QPalette::ButtonText), size), QIcon::Normal);
        made.addPixmap(drawn(svg, palette.color(QPalette::Disabled, QPalette::ButtonText), size), QIcon::Disabled);
    }
    return made;
}

QIcon programIcon()
{
    const QByteArray svg = svgOf(QStringLiteral("touchdown"));
    QIcon made;
    if (svg.isEmpty()) return made;
    for (const int size : {16, 32, 48, 64, 128, 256}) made.addPixmap(drawn(svg, Qt::black, size));
    return made;
}

} // namespace touchdown

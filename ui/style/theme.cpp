// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/theme.h"

#include <QApplication>
#include <QFont>
#include <QStyleFactory>

namespace touchdown {

namespace {

/// The palette of the platform.
struct SystemLook {
    bool dark = isDark(QGuiApplication::palette());
    int pointSize = QApplication::font().pointSize() > 0 ? QApplication::font().pointSize() : 10;
};

const SystemLook& systemLook()
{
    static const SystemLook look;
    return look;
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

QPalette lightPalette()
{
    return paletteOf({"#f3f4f6", "#ffffff", "#f0f2f5", "#fbfbfc", "#1b1f24", "#7b838c", "#1f6fb5", "#ffffff", "#155d9c",
                      "#fffdf2", "#c9ced5"});
}

QPalette darkPalette()
{
    // Fusion draws no lighter frame round a field or a check box: the panel must be clearly lighter than the base in
    // them.
    return paletteOf({"#2d3238", "#1a1d21", "#22262b", "#3b424a", "#e4e8ec", "#a0a8b1", "#2f7fc4", "#ffffff", "#6db3ee",
                      "#2f353c", "#545c66"});
}

} // namespace

QString themeName(Theme theme)
{
    switch (theme) {
    case Theme::Light: return QStringLiteral("light");
    case Theme::Dark: return QStringLiteral("dark");
    case Theme::System: break;
    }
    return QStringLiteral("system");
}

Theme themeFromName(const QString& name)
{
    if (name == QLatin1String("light")) return Theme::Light;
    return name == QLatin1String("dark") ? Theme::Dark : Theme::System;
}

void applyTheme(Theme theme, int pointSize)
{
    const SystemLook& system = systemLook();
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    const bool dark = theme == Theme::Dark || (theme == Theme::System && system.dark);
    QApplication::setPalette(dark ? darkPalette() : lightPalette());
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

bool isDark(const QPalette& palette)
{
    return palette.color(QPalette::Window).lightness() < palette.color(QPalette::WindowText).lightness();
}

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
//
// A picture that paints itself: on the screen in the colours of its theme, in the picture of its page, and on paper;
// with the menu that copies and saves it. A derived class says what is painted.
#pragma once

#include <QMenu>
#include <QWidget>

#include "ui/plot/plot_export.h"

namespace touchdown {

class PictureWidget : public QWidget, public PagePart {
    Q_OBJECT

public:
    /// `textWidth`: in which its texts have room on paper [px]; 0: in any. `shape`: height by width there.
    explicit PictureWidget(QWidget* parent, double textWidth = 0.0, double shape = 0.6)
        : QWidget(parent), textWidth_(textWidth), shape_(shape)
    {}

    void paintInto(QPainter& painter, const QRectF& target, const PlotTheme& theme) override;
    void paintOnPaper(QPainter& painter, const QSizeF& size, const QFont& font, PaperColours colours) override;
    double heightOnPaper(double width, const QFont& font) const override;

protected:
    /// The whole widget, in its size and font.
    virtual void paint(QPainter& painter, const PlotTheme& theme) = 0;
    /// What the menu has above the actions of every picture.
    virtual void fillMenu(QMenu& /*menu*/) {}

    void changeEvent(QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    double textWidth_, shape_;
};

/// Gives a widget another size and font while this lives, to paint it for a figure on paper. The screen shows nothing
/// of it: no event is handled meanwhile.
class LaidOutAs : public QObject {
public:
    LaidOutAs(QWidget& widget, const QSizeF& size, const QFont& font);
    ~LaidOutAs() override;

protected:
    /// The widget alone hears of its new size: a scroll area around it would give it the old one at once.
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget& widget_;
    const QRect geometry_;
    const QSize least_;
    const QFont font_;
};

/// How many times wider than its place a picture is laid out whose texts need `least` pixels of width: its font becomes
/// smaller by as much.
inline double widening(double width, double least) { return least > width ? least / width : 1.0; }

/// Copying and saving the picture and the numbers that it shows. `shown` is a PagePart.
void addPictureActions(QMenu& menu, QWidget& shown);
void chooseSavePicture(QWidget& shown);

} // namespace touchdown

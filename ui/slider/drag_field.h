// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small fields beside the pointer that take the distances of a drag as they are typed, in µm or with a unit of one's
// own. Tab goes from one to the next, Enter takes them, Escape gives back.
#pragma once

#include <optional>
#include <vector>

#include <QFrame>
#include <QLabel>
#include <QLineEdit>

#include "core/physics/slider/surface_edit.h"

namespace touchdown {

/// A distance that is typed: its name, and its direction [-].
struct DragWay {
    QString name;
    SurfaceShift direction;
};

/// A length that is typed in µm or with a unit of one's own [m]; nothing where it is none.
std::optional<double> typedLength(QString text);

class DragField : public QFrame {
    Q_OBJECT

public:
    explicit DragField(QWidget* parent);

    /// Shows one field or two for these ways beside a place of the parent [px]; the field `first` has the text that was
    /// typed, the other one 0.
    void open(const QPoint& beside, const std::vector<DragWay>& ways, int first, const QString& typed);
    /// What the field holds will be typed over.
    void selectText();
    /// The distances along their ways [m]; nothing where one of the shown texts is no length.
    std::optional<SurfaceShift> shift() const;

signals:
    void changed();
    void taken();
    void givenBack();

protected:
    bool event(QEvent* event) override;
    bool focusNextPrevChild(bool next) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    struct Entry {
        QLabel* name;
        QLineEdit* text;
    };
    std::vector<Entry> entries_;
    std::vector<DragWay> ways_; // of the shown entries
};

} // namespace touchdown

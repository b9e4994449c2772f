// SPDX-License-Identifier: GPL-3.0-or-later
//
// The editor of a surface with the edits of its case, and the gestures of a mouse.
#pragma once

#include <memory>

#include <QTest>
#include <QUndoStack>

#include "tests/ui/sample_slider.h"
#include "ui/case/case_edits.h"
#include "ui/slider/surface_editor.h"

namespace touchdown {

class EditorUnderTest {
public:
    explicit EditorUnderTest(const Case& c)
    {
        editor->resize(1000, 800);
        const auto show = [this] {
            const Case& now = edits->value();
            editor->setCase(now.surface, now.slider.length, now.slider.width);
        };
        QObject::connect(edits.get(), &CaseEdits::edited, editor.get(), show);
        QObject::connect(editor.get(), &SurfaceEditor::edited, edits.get(), &CaseEdits::setSurface);
        edits->open(c);
        editor->show();
    }

    QPoint pixel(double x, double y) const { return editor->toPixel({x, y}).toPoint(); }
    void moveTo(const QPointF& at, Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers = {})
    {
        QMouseEvent move(QEvent::MouseMove, at, editor->mapToGlobal(at), Qt::NoButton, buttons, modifiers);
        QCoreApplication::sendEvent(editor.get(), &move);
    }
    void drag(QPoint from, QPoint to, Qt::KeyboardModifiers modifiers = {}, bool release = true)
    {
        QTest::mousePress(editor.get(), Qt::LeftButton, modifiers, from);
        for (int i = 1; i <= 4; ++i) moveTo(QPointF(from) + 0.25 * i * QPointF(to - from), Qt::LeftButton, modifiers);
        if (release) QTest::mouseRelease(editor.get(), Qt::LeftButton, modifiers, to);
    }
    void click(QPoint at) { QTest::mouseClick(editor.get(), Qt::LeftButton, {}, at); }
    const AirBearingSurface& surface() const { return edits->value().surface; }
    const RailPoint& point(std::size_t rail, std::size_t k) const { return surface().rails.at(rail).points.at(k); }
    double metre() const { return editor->toPixel({1.0, 0.0}).x() - editor->toPixel({0.0, 0.0}).x(); }

    std::unique_ptr<CaseEdits> edits = std::make_unique<CaseEdits>();
    std::unique_ptr<SurfaceEditor> editor = std::make_unique<SurfaceEditor>();
};

} // namespace touchdown

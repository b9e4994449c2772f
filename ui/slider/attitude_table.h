// SPDX-License-Identifier: GPL-3.0-or-later
//
// The static state as tables that can be read, selected and copied.
#pragma once

#include <QTextBrowser>
#include <QToolButton>
#include <QWidget>

#include "ui/slider/attitude_sections.h"

namespace touchdown {

class AttitudeTable : public QWidget {
    Q_OBJECT

public:
    explicit AttitudeTable(QWidget* parent = nullptr);

    void setResult(const Case& c, const SteadyResult& result);
    void clear();
    /// The case has changed since: the result stays, and says so.
    void setStale(bool stale);

    const std::vector<AttitudeSection>& sections() const { return sections_; }

public slots:
    /// All of it, tab-separated, on the clipboard.
    void copy() const;

protected:
    void changeEvent(QEvent* event) override;

private:
    void write();

    std::vector<AttitudeSection> sections_;
    bool stale_ = false;
    QTextBrowser* text_;
    QToolButton* copy_;
};

} // namespace touchdown

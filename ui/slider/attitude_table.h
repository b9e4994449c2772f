// SPDX-License-Identifier: GPL-3.0-or-later
//
// The static state as tables that can be read, selected and copied.
#pragma once

#include "ui/slider/attitude_sections.h"
#include "ui/style/copied_text.h"

namespace touchdown {

class AttitudeTable : public CopiedText {
    Q_OBJECT

public:
    explicit AttitudeTable(QWidget* parent = nullptr);

    void setResult(const Case& c, const SteadyResult& result);
    void clear();
    /// The case has changed since: the result stays, and says so.
    void setStale(bool stale);

    const std::vector<AttitudeSection>& sections() const { return sections_; }

protected:
    QString html() const override;
    QString plainText() const override;

private:
    std::vector<AttitudeSection> sections_;
    bool stale_ = false;
};

} // namespace touchdown

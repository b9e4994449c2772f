// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

#include "core/studies/study_plan.h"

namespace touchdown::test {

/// "sweep, work-precision, ...", as sentences list them.
inline QByteArray studyKindNames()
{
    QByteArray names;
    for (const StudyKind& kind : studyKinds())
        names += (names.isEmpty() ? "" : ", ") + QByteArray::fromStdString(kind.name);
    return names;
}

} // namespace touchdown::test

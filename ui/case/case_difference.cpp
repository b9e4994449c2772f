// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/case/case_difference.h"

#include "core/case/fields.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

QStringList caseDifference(const Case& before, const Case& after)
{
    QStringList changes;
    for (const Field& field : fields()) {
        if (field.kind == FieldKind::Text || field.get(before) == field.get(after)) continue;
        if (!field.used(before) && !field.used(after)) continue;
        changes << QStringLiteral("%1 %2 → %3")
                       .arg(QString::fromStdString(field.label), valueText(before, field), valueText(after, field));
    }
    return changes;
}

} // namespace touchdown

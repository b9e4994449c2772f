// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/whole_file.h"

#include <QDir>

#include "core/formats/text_file.h"
#include "ui/style/translate.h"

namespace touchdown {

QString writeWholeFile(const QString& path, const QByteArray& bytes)
{
    QString reason = QString::fromStdString(writeTextFile(path.toStdString(), bytes.toStdString()));
    if (reason.isEmpty()) return {};
    const QLatin1String beginning("cannot be written: ");
    reason = reason.startsWith(beginning) ? reason.sliced(beginning.size()) : QLatin1String("it ") + reason;
    return tr("%1 could not be written: %2.").arg(QDir::toNativeSeparators(path), reason);
}

} // namespace touchdown

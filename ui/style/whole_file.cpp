// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/whole_file.h"

#include <exception>
#include <filesystem>
#include <system_error>

#include <QDir>

#include "core/formats/output_file.h"
#include "core/formats/text_file.h"
#include "ui/style/translate.h"

namespace touchdown {

namespace {

QString notWritten(const QString& path, const QString& reason)
{
    return tr("%1 could not be written: %2.").arg(QDir::toNativeSeparators(path), reason);
}

} // namespace

QString writeWholeFile(const QString& path, const QByteArray& bytes)
{
    QString reason = QString::fromStdString(writeTextFile(path.toStdString(), bytes.toStdString()));
    if (reason.isEmpty()) return {};
    const QLatin1String beginning("cannot be written: ");
    reason = reason.startsWith(beginning) ? reason.sliced(beginning.size()) : QLatin1String("it ") + reason;
    return notWritten(path, reason);
}

QString copyWholeFile(const QString& from, const QString& path)
{
    const std::filesystem::path target = path.toStdString();
    if (const std::string problem = checkOutputFile(target); !problem.empty()) return QString::fromStdString(problem);
    try {
        PartFile part(target);
        std::filesystem::copy_file(from.toStdString(), part.path());
        part.show();
        return {};
    } catch (const std::system_error& error) {
        return notWritten(path, QString::fromStdString(error.code().message()));
    } catch (const std::exception& error) {
        return notWritten(path, QString::fromUtf8(error.what()));
    }
}

} // namespace touchdown

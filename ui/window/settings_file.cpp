// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/settings_file.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QLockFile>
#include <QSettings>
#include <QStandardPaths>

#include "core/formats/text_file.h"
#include "ui/style/translate.h"

namespace touchdown {

namespace {

constexpr std::uintmax_t largestSettings = std::uintmax_t(1) << 20; // [byte]
constexpr int longestLock = 2000;                                   // of another window that writes its settings [ms]

/// All that QSettings looks at, of this program and of its organisation, of the user and of the system.
QStringList filesOfSettings()
{
    const QString organisation = QCoreApplication::organizationName();
    QStringList files;
    for (const QString& folder : QStandardPaths::standardLocations(QStandardPaths::GenericConfigLocation))
        for (const QString& name : {organisation + u'/' + QCoreApplication::applicationName(), organisation})
            files << folder + u'/' + name + QLatin1String(".conf");
    return files;
}

/// Without the name of the file; "" if it can be used, or is not there.
QString problemOf(const QString& file)
{
    const auto exists = [](const QString& path) { return QFileInfo::exists(path) || QFileInfo(path).isSymbolicLink(); };
    if (const QString lock = file + QLatin1String(".lock"); exists(lock) && !QFileInfo(lock).isFile())
        return tr("has a lock beside it, %1, which is not a regular file").arg(QFileInfo(lock).fileName());
    if (!QFileInfo::exists(file)) return {};
    const auto content = readTextFile(file.toStdString(), largestSettings, FileContent::Text);
    if (const auto* problem = std::get_if<FileProblem>(&content)) return QString::fromStdString(problem->message);
    // QSettings would wait for up to half a minute.
    QLockFile lock(file + QLatin1String(".lock"));
    if (!lock.tryLock(longestLock) && lock.error() == QLockFile::LockFailedError)
        return tr("is locked by another program (%1)").arg(QFileInfo(file).fileName() + QLatin1String(".lock"));
    lock.unlock();
    const QSettings settings(file, QSettings::IniFormat);
    static_cast<void>(settings.allKeys()); // reads all lines
    return settings.status() == QSettings::NoError ? QString() : tr("holds no settings");
}

} // namespace

SettingsFile::SettingsFile()
{
    for (const QString& file : filesOfSettings()) {
        const QString reason = problemOf(file);
        if (reason.isEmpty()) continue;
        problem_ = tr("The settings are the default ones, and what is set now is not kept: %1 %2. It stays as it is.")
                       .arg(QDir::toNativeSeparators(file), reason);
        instead_ = std::make_unique<QTemporaryDir>();
        for (const auto scope : {QSettings::UserScope, QSettings::SystemScope})
            QSettings::setPath(QSettings::NativeFormat, scope, instead_->path());
        return;
    }
}

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/whole_file.h"

#include <exception>
#include <filesystem>
#include <memory>
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

QString writeWholeFile(const QString& path, const QByteArray& bytes) { return writeWholeFiles({{path, bytes}}); }

QString writeWholeFiles(const std::vector<std::pair<QString, QByteArray>>& files)
{
    std::vector<std::unique_ptr<PartFile>> parts;
    QString now; // the file that is written
    try {
        for (const auto& [path, bytes] : files) {
            now = path;
            if (const std::string obstacle = outputObstacle(path.toStdString()); !obstacle.empty())
                return notWritten(path, QString::fromStdString(obstacle));
            parts.push_back(std::make_unique<PartFile>(path.toStdString()));
            if (const std::string reason = writePart(*parts.back(), bytes.toStdString()); !reason.empty())
                return notWritten(path, QString::fromStdString(reason));
        }
        for (std::size_t i = 0; i < parts.size(); ++i) {
            now = files[i].first;
            parts[i]->show();
        }
    } catch (const std::exception& error) {
        return notWritten(now, QString::fromUtf8(error.what()));
    }
    return {};
}

QString copyWholeFile(const QString& from, const QString& path)
{
    const std::filesystem::path target = path.toStdString();
    if (const std::string problem = checkOutputFile(target); !problem.empty()) return QString::fromStdString(problem);
    try {
        PartFile part(target);
        const auto over = std::filesystem::copy_options::overwrite_existing; // a part without a name exists
        std::filesystem::copy_file(from.toStdString(), part.path(), over);
        part.show();
        return {};
    } catch (const std::system_error& error) {
        return notWritten(path, QString::fromStdString(error.code().message()));
    } catch (const std::exception& error) {
        return notWritten(path, QString::fromUtf8(error.what()));
    }
}

SavedFile::SavedFile(const QString& path)
    : path_(path), identity_(identityOf(path.toStdString()).value_or(FileIdentity{}))
{}

bool SavedFile::holds() const { return !path_.isEmpty() && fileNow(path_.toStdString(), identity_) == FileNow::Same; }

} // namespace touchdown

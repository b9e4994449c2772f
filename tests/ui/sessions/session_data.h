// SPDX-License-Identifier: GPL-3.0-or-later
//
// A folder of its own for the data of the program, in which sessions are kept.
#pragma once

#include <memory>

#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

#include "ui/sessions/session_folder.h"

namespace touchdown::test {

class SessionData {
protected:
    static void useNames(const char* application)
    {
        QCoreApplication::setOrganizationName(QStringLiteral("touchdown"));
        QCoreApplication::setApplicationName(QString::fromLatin1(application));
    }
    void begin()
    {
        QSettings().clear();
        data_ = std::make_unique<QTemporaryDir>();
        qputenv("XDG_DATA_HOME", data_->path().toLocal8Bit());
    }
    static QString onlyFolder()
    {
        const QStringList all = SessionFolder::all();
        if (all.size() != 1) qFatal("there are %d sessions", int(all.size()));
        return all.front();
    }

    std::unique_ptr<QTemporaryDir> data_;
};

} // namespace touchdown::test

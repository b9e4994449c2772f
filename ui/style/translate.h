// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace touchdown {

/// For texts outside a QObject, whose member tr() this stands in for.
inline QString tr(const char* text) { return QCoreApplication::translate("touchdown", text); }

} // namespace touchdown

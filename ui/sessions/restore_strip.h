// SPDX-License-Identifier: GPL-3.0-or-later
//
// The progress of a session that is restored, with a button that stops it; hidden otherwise. Reports the result.
#pragma once

#include <QStringList>
#include <QWidget>

namespace touchdown {

class MessageStrip;
class Session;

class RestoreStrip : public QWidget {
    Q_OBJECT

public:
    /// All must outlive this.
    RestoreStrip(Session& session, MessageStrip& messages, QWidget& window);

private:
    void tell(const QString& what, const QStringList& problems, bool stopped);

    MessageStrip& messages_;
    QWidget& window_;
};

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/window_session.h"

#include <QSettings>

#include "ui/runs/runs_panel.h"
#include "ui/window/window_actions.h"

namespace touchdown {

namespace {

constexpr int stateVersion = 2; // of the arrangement of docks

} // namespace

void WindowSession::save(const QString& lastCase) const
{
    QSettings settings;
    settings.setValue(QStringLiteral("window/geometry"), parts_.window.saveGeometry());
    settings.setValue(QStringLiteral("window/state"), parts_.window.saveState(stateVersion));
    settings.setValue(QStringLiteral("window/splitter"), parts_.splitter.saveState());
    if (const QAction* theme = parts_.actions.theme->checkedAction())
        settings.setValue(QStringLiteral("window/theme"), theme->data());
    if (const QAction* size = parts_.actions.fontSize->checkedAction())
        settings.setValue(QStringLiteral("window/font"), size->data());
    settings.setValue(QStringLiteral("runs/overlay"), parts_.runsPanel.overlay());
    settings.setValue(QStringLiteral("runs/pace"), parts_.actions.pace->currentIndex());
    settings.setValue(QStringLiteral("files/last"), lastCase);
}

void WindowSession::restore() const
{
    const QSettings settings;
    parts_.window.restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray());
    parts_.window.restoreState(settings.value(QStringLiteral("window/state")).toByteArray(), stateVersion);
    parts_.splitter.restoreState(settings.value(QStringLiteral("window/splitter")).toByteArray());
    const auto check = [](QActionGroup* group, const QVariant& value) {
        for (QAction* action : group->actions())
            if (action->data().toString() == value.toString()) action->setChecked(true);
    };
    check(parts_.actions.theme, settings.value(QStringLiteral("window/theme"), QStringLiteral("system")));
    check(parts_.actions.fontSize, settings.value(QStringLiteral("window/font"), 0));
    parts_.runsPanel.setOverlay(settings.value(QStringLiteral("runs/overlay"), true).toBool());
    parts_.actions.pace->setCurrentIndex(settings.value(QStringLiteral("runs/pace"), 0).toInt());
}

QString WindowSession::lastCase() { return QSettings().value(QStringLiteral("files/last")).toString(); }

} // namespace touchdown

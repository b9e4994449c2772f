// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workbench/workbench_study.h"

#include <algorithm>
#include <iostream>

#include <QApplication>
#include <QDir>
#include <QThread>

#include "ui/plot/plot_export.h"
#include "ui/studies/study_chart_drawing.h"

namespace touchdown {

namespace {

constexpr int done = 0, noAnswer = 1, badInput = 2; // exit codes

Picture pictureOf(const StudyChart& chart, int width)
{
    const QFont font = QApplication::font();
    const QSizeF size(width, StudyChartDrawing::goodHeight(chart, font, width));
    return {size, QString::fromStdString(chart.title), [&chart, font, size](QPainter& painter) {
                StudyChartDrawing(chart, lightPlotTheme(), font, size).paint(painter);
            }};
}

} // namespace

int pictureStudy(const StudyPlan& plan, const QString& folder, int width)
{
    const QDir directory(folder);
    if (!directory.mkpath(QStringLiteral("."))) {
        std::cerr << "The folder " << folder.toStdString() << " cannot be created.\n";
        return badInput;
    }
    const StudyReport report =
        plan.perform(std::max(1, QThread::idealThreadCount()), [](const StudyProgress&) { return true; });
    for (const std::string& finding : report.findings) std::cerr << finding << '\n';
    for (const std::string& warning : report.warnings) std::cerr << "warning: " << warning << '\n';

    bool written = true;
    for (std::size_t i = 0; i < report.charts.size(); ++i) {
        const Picture picture = pictureOf(report.charts[i], width);
        const QString number = report.charts.size() > 1 ? QStringLiteral("-%1").arg(i + 1) : QString();
        for (const char* ending : {".png", ".svg"}) {
            const QString file =
                directory.filePath(QString::fromStdString(plan.kind) + number + QString::fromLatin1(ending));
            const QString problem = savePicture(picture, file);
            if (problem.isEmpty())
                std::cout << file.toStdString() << '\n';
            else
                std::cerr << problem.toStdString() << '\n';
            written = written && problem.isEmpty();
        }
    }
    if (!written) return badInput;
    if (report.status == StudyStatus::Completed) return done;
    std::cerr << "The study ended without a valid answer: " << report.message << '\n';
    return noAnswer;
}

} // namespace touchdown

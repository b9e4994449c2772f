// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workbench/workbench_pictures.h"

#include <algorithm>
#include <iostream>

#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QFileInfo>
#include <QPixmap>
#include <QRegularExpression>
#include <QThread>

#include "app/terminal/console.h"
#include "app/terminal/refusal.h"
#include "core/studies/lesson/lesson.h"
#include "core/studies/study_plan.h"
#include "ui/disk/disk_surface_view.h"
#include "ui/film/film_view.h"
#include "ui/film/film_window.h"
#include "ui/guides/lesson_print.h"
#include "ui/plot/plot_export.h"
#include "ui/plot/plot_widget.h"
#include "ui/plot/spectrum_view.h"
#include "ui/runs/live_plots.h"
#include "ui/runs/live_spectrum.h"
#include "ui/runs/run_view.h"
#include "ui/studies/study_chart_drawing.h"
#include "ui/style/whole_file.h"
#include "ui/window/main_window.h"

namespace touchdown {

namespace {

/// Writes the file's name to standard output, or the problem to standard error.
bool report(const QString& problem, const QString& file)
{
    if (problem.isEmpty())
        printExactly(file.toStdString() + '\n');
    else
        complain(problem.toStdString());
    return problem.isEmpty();
}

bool makeFolder(const QDir& folder)
{
    return folder.mkpath(QStringLiteral(".")) ||
           report(QStringLiteral("The folder %1 cannot be created.").arg(folder.path()), {});
}

/// Waits until the window has refreshed.
void settle(QWidget& window)
{
    QElapsedTimer clock;
    clock.start();
    while (clock.elapsed() < 400) QApplication::processEvents(QEventLoop::AllEvents, 20);
    window.repaint();
}

bool exportFilm(MainWindow& window, const QDir& directory)
{
    using Page = FilmView::Page;
    bool good = true;
    for (const auto& [page, name] : {std::pair(Page::Surface, "surface"), std::pair(Page::Pressure, "pressure"),
                                     std::pair(Page::Gap, "gap"), std::pair(Page::Recess, "recess")}) {
        window.film().view()->setPage(page);
        settle(window);
        const QString file = directory.filePath(QString::fromLatin1(name) + QStringLiteral(".png"));
        good = report(savePicture(*window.page(), file), file) && good;
    }
    return good;
}

bool exportPlots(MainWindow& window, const QString& folder, bool staticState)
{
    const QDir directory(folder);
    if (!makeFolder(directory)) return false;
    if (staticState) return exportFilm(window, directory);
    const QString page = directory.filePath(QStringLiteral("page.png"));
    bool good = report(savePicture(*window.page(), page), page);
    for (const LivePlots::Entry& entry : window.runView().plots()->plots()) {
        if (entry.plot->isHidden()) continue;
        const QString file = directory.filePath(entry.name + QStringLiteral(".png"));
        good = report(savePicture(*entry.plot, file), file) && good;
    }
    for (const auto& [shown, name] : {std::pair(RunView::Page::Side, "side"), std::pair(RunView::Page::Maps, "maps"),
                                      std::pair(RunView::Page::Disk, "disk")}) {
        if (!window.runView().tabs()->isTabVisible(static_cast<int>(shown))) continue;
        window.runView().setPage(shown);
        do settle(window);
        while (window.runView().disk()->controller().busy());
        const QString file = directory.filePath(QString::fromLatin1(name) + QStringLiteral(".png"));
        good = report(savePicture(*window.page(), file), file) && good;
    }
    window.runView().setPage(RunView::Page::Plots);
    if (window.runView().spectrum()->isHidden()) return good;
    const QString spectrum = directory.filePath(QStringLiteral("spectrum.png"));
    return report(savePicture(*window.runView().spectrum()->view()->plot(), spectrum), spectrum) && good;
}

Picture pictureOf(const StudyChart& chart)
{
    constexpr double width = 1000.0; // [px]
    const QFont font = QApplication::font();
    const QSizeF size(width, StudyChartDrawing::goodHeight(chart, font, width));
    return {size, QString::fromStdString(chart.title), [&chart, font, size](QPainter& painter) {
                StudyChartDrawing(chart, lightPlotTheme(), font, size).paint(painter);
            }};
}

} // namespace

int takePictures(MainWindow& window, const PictureRequest& request)
{
    const QRegularExpressionMatch size =
        QRegularExpression(QStringLiteral("^(\\d{3,5})x(\\d{3,5})$")).match(request.size);
    if (!size.hasMatch()) {
        complain("--size is written as 1600x1000, not \"" + request.size.toStdString() + "\".");
        return exitWrongInput;
    }
    window.resize(size.captured(1).toInt(), size.captured(2).toInt());
    window.show();
    settle(window);

    bool valid = false;
    QString message;
    QEventLoop untilEnded;
    QObject::connect(&window, &MainWindow::calculationEnded, &untilEnded, [&](bool answered, const QString& said) {
        valid = answered;
        message = said;
        untilEnded.quit();
    });
    if (request.staticState)
        window.solveStaticState();
    else
        window.startRun();
    untilEnded.exec();
    settle(window);

    bool written = true;
    if (!request.exportFolder.isEmpty()) written = exportPlots(window, request.exportFolder, request.staticState);
    if (!request.screenshot.isEmpty()) {
        const QString problem = saveImage(window.grab().toImage(), request.screenshot);
        written = report(problem, request.screenshot) && written;
    }
    if (!written) return exitWrongInput;
    if (valid) return exitDone;
    complain("The run ended without a valid answer: " + message.toStdString());
    return exitNoAnswer;
}

int takeStudyPictures(const QString& kind, const QString& fileOrSample, const QString& folder, OutsidePaths outside)
{
    const StudyPlan plan = openStudy(kind.toStdString(), fileOrSample.toStdString(), {}, {}, outside);
    complainOf(plan.problems);
    const QDir directory(folder);
    if (!plan.valid() || !makeFolder(directory)) return exitWrongInput;
    const StudyReport study =
        plan.perform(std::max(1, QThread::idealThreadCount()), [](const StudyProgress&) { return true; });
    for (const std::string& finding : study.findings) complain(finding);
    for (const std::string& warning : study.warnings) complain("warning: " + warning);

    bool written = true;
    for (std::size_t i = 0; i < study.charts.size(); ++i) {
        const Picture picture = pictureOf(study.charts[i]);
        const QString number = study.charts.size() > 1 ? QStringLiteral("-%1").arg(i + 1) : QString();
        for (const char* ending : {".png", ".svg"}) {
            const QString file =
                directory.filePath(QString::fromStdString(plan.kind) + number + QString::fromLatin1(ending));
            written = report(savePicture(picture, file), file) && written;
        }
    }
    if (!written) return exitWrongInput;
    if (study.status == StudyStatus::Completed) return exitDone;
    complain("The study ended without a valid answer: " + study.message);
    return exitNoAnswer;
}

int printLesson(const QString& file)
{
    const QString folder = QFileInfo(file).absolutePath();
    if (!QFileInfo(folder).isWritable()) {
        complain("touchdown-workbench: " + file.toStdString() + " could not be written: there is no such directory, " +
                 "or it is not writable.");
        return exitWrongInput;
    }
    LessonPrint print(lessonSteps(), QCoreApplication::translate("LessonPrint", "Touchdown: the lesson"), nullptr);
    int code = exitDone;
    QEventLoop loop;
    QObject::connect(&print, &LessonPrint::ended, &loop, [&](bool whole, const QString& problem) {
        QString said = problem;
        if (whole) said = writeWholeFile(file, print.pdf());
        if (whole && !said.isEmpty()) code = exitWrongInput;
        if (!whole) code = exitNoAnswer;
        if (!said.isEmpty()) complain("touchdown-workbench: " + said.toStdString());
        loop.quit();
    });
    print.start();
    loop.exec();
    if (code == exitDone) std::cout << file.toStdString() << '\n';
    return code;
}

} // namespace touchdown

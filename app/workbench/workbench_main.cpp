// SPDX-License-Identifier: GPL-3.0-or-later
//
// touchdown-workbench: the window, and the same window without a screen for pictures.
#include <cstdio>
#include <iostream>

#include <QApplication>
#include <QCommandLineParser>
#include <QCoreApplication>
#include <QFileInfo>
#include <QTimer>

#include "app/workbench/workbench_pictures.h"
#include "app/workbench/workbench_study.h"
#include "core/case_files/case_file.h"
#include "core/results/results_reader.h"
#include "ui/case/case_files.h"
#include "ui/style/theme.h"
#include "ui/window/main_window.h"

namespace {

constexpr int badInput = 2; // exit code

struct Arguments {
    QString file;
    bool run = false;
    bool staticState = false;
    QString exportFolder;
    QString screenshot;
    QString study;    // kind
    QString pictures; // folder
    QString size;
    QString theme;
};

constexpr int studyWidth = 1000; // of the charts of a study [px]

/// Ends the program for --help, --version and mistakes: none of them needs a display.
Arguments parse(int argc, char** argv)
{
    QStringList list;
    for (int i = 0; i < argc; ++i) list << QString::fromLocal8Bit(argv[i]);

    QCommandLineParser parser;
    parser.setApplicationDescription(
        QStringLiteral("Touchdown: the dynamics of hard-disk sliders at the edge of contact."));
    parser.addPositionalArgument(
        QStringLiteral("CASE"), QStringLiteral("A case file (.toml), a saved run (.h5), or the name of a sample case."),
        QStringLiteral("[CASE]"));
    const QCommandLineOption help({QStringLiteral("h"), QStringLiteral("help")}, QStringLiteral("Prints this help."));
    const QCommandLineOption version({QStringLiteral("v"), QStringLiteral("version")},
                                     QStringLiteral("Prints the version."));
    const QCommandLineOption run(QStringLiteral("run"), QStringLiteral("Starts the case at once."));
    const QCommandLineOption staticState(
        QStringLiteral("static"),
        QStringLiteral("For a film case: starts or pictures its static state instead of its run in time."));
    const QCommandLineOption exportTo(
        QStringLiteral("export"),
        QStringLiteral("Runs the case, writes its plots as PNG pictures to <folder>, prints their paths and ends."),
        QStringLiteral("folder"));
    const QCommandLineOption screenshot(
        QStringLiteral("screenshot"),
        QStringLiteral("Runs the case, writes a picture of the whole window to <file> and ends."),
        QStringLiteral("file"));
    const QCommandLineOption study(
        QStringLiteral("study"),
        QStringLiteral("Performs a study of this <kind>, of a study's file or with its defaults for a case, needs no "
                       "display, writes its "
                       "charts as PNG and SVG to the folder of --pictures, prints their paths and ends."),
        QStringLiteral("kind"));
    const QCommandLineOption pictures(QStringLiteral("pictures"), QStringLiteral("Folder for the charts of --study."),
                                      QStringLiteral("folder"));
    const QCommandLineOption size(QStringLiteral("size"),
                                  QStringLiteral("Size of the window for pictures, as 1600x1000."),
                                  QStringLiteral("size"), QStringLiteral("1600x1000"));
    const QCommandLineOption theme(QStringLiteral("theme"), QStringLiteral("light, dark or system."),
                                   QStringLiteral("name"));
    parser.addOptions({help, version, run, staticState, exportTo, screenshot, study, pictures, size, theme});

    const auto fail = [](const QString& sentence) {
        std::cerr << "touchdown-workbench: " << sentence.toStdString() << "\nSee touchdown-workbench --help.\n";
        std::exit(badInput);
    };
    if (!parser.parse(list)) fail(parser.errorText());
    if (parser.isSet(help)) {
        std::cout << parser.helpText().toStdString();
        std::exit(0);
    }
    if (parser.isSet(version)) {
        std::cout << "touchdown-workbench " TOUCHDOWN_VERSION "\n";
        std::exit(0);
    }
    if (parser.positionalArguments().size() > 1) fail(QStringLiteral("more than one case was given."));

    Arguments arguments;
    arguments.file = parser.positionalArguments().value(0);
    arguments.run = parser.isSet(run);
    arguments.staticState = parser.isSet(staticState);
    arguments.exportFolder = parser.value(exportTo);
    arguments.screenshot = parser.value(screenshot);
    arguments.study = parser.value(study);
    arguments.pictures = parser.value(pictures);
    arguments.size = parser.value(size);
    arguments.theme = parser.value(theme);
    if (!arguments.theme.isEmpty() && !QStringList{"light", "dark", "system"}.contains(arguments.theme))
        fail(QStringLiteral("--theme is light, dark or system, not \"%1\".").arg(arguments.theme));
    if (arguments.study.isEmpty() != arguments.pictures.isEmpty())
        fail(
            QStringLiteral("--study and --pictures need each other: the kind of study and the folder for its charts."));
    return arguments;
}

void useNames()
{
    QCoreApplication::setOrganizationName(QStringLiteral("touchdown"));
    QCoreApplication::setApplicationName(QStringLiteral("touchdown-workbench"));
    QCoreApplication::setApplicationVersion(QStringLiteral(TOUCHDOWN_VERSION));
}

/// The study that was asked for, as pictures; the exit code. Mistakes in it come before anything that draws.
int studyPictures(const Arguments& arguments, int argc, char** argv)
{
    const std::string file =
        arguments.file.isEmpty() ? std::string(touchdown::defaultCaseName) : arguments.file.toStdString();
    const touchdown::StudyPlan plan = touchdown::openStudy(arguments.study.toStdString(), file);
    if (!plan.valid()) {
        for (const touchdown::InputProblem& problem : plan.problems) std::cerr << problem.text() << '\n';
        return badInput;
    }
    qputenv("QT_QPA_PLATFORM", "offscreen"); // there is no window
    const QApplication application(argc, argv);
    useNames();
    touchdown::applyTheme(touchdown::Theme::Light);
    return touchdown::pictureStudy(plan, arguments.pictures, studyWidth);
}

/// The case that was asked for; ends the program with a sentence for each problem when it is bad.
touchdown::CaseDocument readCase(const QString& fileOrSample)
{
    touchdown::CaseDocument document = touchdown::openCase(fileOrSample.toStdString());
    if (!document.valid()) {
        for (const touchdown::InputProblem& problem : document.problems) std::cerr << problem.text() << '\n';
        std::exit(badInput);
    }
    return document;
}

/// Ends the program when a saved run cannot be opened, or is no case to run for pictures.
void checkRun(const QString& file, bool pictures)
{
    std::string problem;
    if (pictures)
        problem = file.toStdString() + ": is a saved run; pictures need a case";
    else
        problem = touchdown::readResults(file.toStdString()).problem;
    if (problem.empty()) return;
    std::cerr << problem << '\n';
    std::exit(badInput);
}

} // namespace

int main(int argc, char** argv)
{
    using namespace touchdown;
    // Help and mistakes come before anything that needs a display.
    const Arguments arguments = [&] {
        int count = 1;
        const QCoreApplication forTheParser(count, argv);
        return parse(argc, argv);
    }();
    if (!arguments.study.isEmpty()) return studyPictures(arguments, argc, argv);
    const bool isRun = CaseFiles::isResultsFile(arguments.file);
    const bool pictures = !arguments.exportFolder.isEmpty() || !arguments.screenshot.isEmpty();
    if (isRun) checkRun(arguments.file, pictures);
    CaseDocument document;
    if (!arguments.file.isEmpty() && !isRun)
        document = readCase(arguments.file);
    else if (pictures)
        document = readCase(QString::fromUtf8(defaultCaseName.data(), static_cast<qsizetype>(defaultCaseName.size())));

    QApplication application(argc, argv);
    useNames();
    QGuiApplication::setDesktopFileName(QStringLiteral("touchdown-workbench"));
    applyTheme(themeFromName(arguments.theme));

    MainWindow window;
    // Pictures must not depend on the last session.
    if (!pictures) window.restoreSession();
    if (!arguments.theme.isEmpty()) applyTheme(themeFromName(arguments.theme));

    const QFileInfo info(arguments.file);
    if (!document.name.empty())
        window.files().take(document, info.exists() ? info.absoluteFilePath() : QString());
    else
        window.openLastCase();

    const bool staticState = arguments.staticState && document.value.model == ModelKind::Film;
    if (pictures)
        return takePictures(window, {arguments.exportFolder, arguments.screenshot, arguments.size, staticState});
    window.show();
    if (isRun) window.openResults(arguments.file);
    if (arguments.run)
        QTimer::singleShot(0, &window, staticState ? &MainWindow::solveStaticState : &MainWindow::startRun);
    return QApplication::exec();
}

// SPDX-License-Identifier: GPL-3.0-or-later
//
// touchdown-workbench: the window; with --export, --screenshot or --study, pictures of it.
#include <clocale>
#include <csignal>
#include <cstdlib>
#include <iostream>

#include <QApplication>
#include <QCommandLineParser>
#include <QCoreApplication>
#include <QFileInfo>
#include <QScreen>
#include <QTimer>

#include "app/terminal/console.h"
#include "app/terminal/refusal.h"
#include "app/terminal/standard_streams.h"
#include "app/workbench/workbench_pictures.h"
#include "core/case_files/case_file.h"
#include "core/studies/reader_program.h"
#include "ui/case/case_files.h"
#include "ui/style/theme.h"
#include "ui/window/main_window.h"
#include "ui/window/settings_file.h"
#include "ui/window/start_card.h"

namespace {

struct Arguments {
    QString file;
    bool run = false;
    bool staticState = false;
    QString exportFolder;
    QString screenshot;
    QString study;    // kind
    QString pictures; // folder
    QString printLesson;
    QString size;
    QString theme;
    bool fresh = false;
    touchdown::OutsidePaths outside = touchdown::OutsidePaths::Refused;
};

/// Ends the program for --help, --version and wrong arguments; needs no display.
Arguments parse(int argc, char** argv)
{
    QStringList list;
    for (int i = 0; i < argc; ++i) list << QString::fromLocal8Bit(argv[i]);

    QCommandLineParser parser;
    parser.setApplicationDescription("Touchdown: the dynamics of hard-disk sliders at the edge of contact.");
    parser.addPositionalArgument("CASE", "A case file (.toml), a saved run (.h5), or the name of a sample case.",
                                 "[CASE]");
    parser.addOptions(
        {{{"h", "help"}, "Prints this help."},
         {{"v", "version"}, "Prints the version."},
         {"run", "Starts the case at once."},
         {"static", "For a film case: starts or pictures its static state instead of its run in time."},
         {"export", "Runs the case, writes its plots as PNG pictures to <folder>, prints their paths and ends.",
          "folder"},
         {"screenshot", "Runs the case, writes a picture of the whole window to <file> and ends.", "file"},
         {"study",
          "Performs a study of this <kind>, of a study's file or with its defaults for a case, needs no display, "
          "writes its charts as PNG and SVG to the folder of --pictures, prints their paths and ends.",
          "kind"},
         {"pictures", "Folder for the charts of --study.", "folder"},
         {"print-lesson", "Performs the runs of the lesson, needs no display, writes it as PDF to <file> and ends.",
          "file"},
         {"size", "Size of the window for pictures, as 1600x1000.", "size", "1600x1000"},
         {"theme", "light, dark or system.", "name"},
         {"allow-paths", "Also reads files that a case or a study names outside its own folder."},
         {"fresh", "Starts with the default case and the default arrangement, whatever the last session was."}});

    const auto fail = [](const QString& sentence) {
        touchdown::complain("touchdown-workbench: " + sentence.toStdString());
        touchdown::complain("See touchdown-workbench --help.");
        std::exit(touchdown::exitWrongInput);
    };
    if (!parser.parse(list)) fail(parser.errorText());
    if (parser.isSet("help")) {
        std::cout << parser.helpText().toStdString();
        std::exit(0);
    }
    if (parser.isSet("version")) {
        std::cout << "touchdown-workbench " TOUCHDOWN_VERSION "\n";
        std::exit(0);
    }
    if (parser.positionalArguments().size() > 1) fail("more than one case was given.");

    const Arguments arguments{.file = parser.positionalArguments().value(0),
                              .run = parser.isSet("run"),
                              .staticState = parser.isSet("static"),
                              .exportFolder = parser.value("export"),
                              .screenshot = parser.value("screenshot"),
                              .study = parser.value("study"),
                              .pictures = parser.value("pictures"),
                              .printLesson = parser.value("print-lesson"),
                              .size = parser.value("size"),
                              .theme = parser.value("theme"),
                              .fresh = parser.isSet("fresh"),
                              .outside = parser.isSet("allow-paths") ? touchdown::OutsidePaths::Allowed
                                                                     : touchdown::OutsidePaths::Refused};
    for (const char* option : {"export", "screenshot", "study", "pictures", "print-lesson"})
        if (parser.isSet(option) && parser.value(option).isEmpty())
            fail(QString("the value of --%1 is empty.").arg(option));
    if (!arguments.theme.isEmpty() && !QStringList{"light", "dark", "system"}.contains(arguments.theme))
        fail(QString("--theme is light, dark or system, not \"%1\".").arg(arguments.theme));
    if (!arguments.printLesson.isEmpty() && !arguments.file.isEmpty())
        fail("--print-lesson prints the lesson and takes no case.");
    if (arguments.study.isEmpty() != arguments.pictures.isEmpty())
        fail("--study and --pictures need each other: the kind of study and the folder for its charts.");
    return arguments;
}

void useNames()
{
    QCoreApplication::setOrganizationName(QStringLiteral("touchdown"));
    QCoreApplication::setApplicationName(QStringLiteral("touchdown-workbench"));
    QCoreApplication::setApplicationVersion(QStringLiteral(TOUCHDOWN_VERSION));
}

/// Ends the program with a sentence for each problem when the case is not valid; with `window`, that will say it.
touchdown::CaseDocument readCase(const QString& fileOrSample, touchdown::OutsidePaths outside, bool window)
{
    touchdown::CaseDocument document = touchdown::openCase(fileOrSample.toStdString(), outside);
    if (!document.valid() && !window) {
        touchdown::complainOf(document.problems);
        std::exit(touchdown::exitWrongInput);
    }
    return document;
}

} // namespace

int main(int argc, char** argv)
{
    using namespace touchdown;
    if (const auto code = runReader(argc, argv)) return *code;
    keepStandardStreams();
    std::signal(SIGXFSZ, SIG_IGN); // a file beyond the limit of its size is a problem of its writer, as a full disk is
    // Before anything that needs a display.
    const Arguments arguments = [&] {
        int count = 1;
        const QCoreApplication forTheParser(count, argv);
        return parse(argc, argv);
    }();
    const QString defaultCase = QString::fromUtf8(defaultCaseName.data(), qsizetype(defaultCaseName.size()));
    if (!arguments.study.isEmpty()) {
        qputenv("QT_QPA_PLATFORM", "offscreen"); // there is no window
        const QApplication application(argc, argv);
        std::setlocale(LC_NUMERIC, "C");
        useNames();
        const SettingsFile settings;
        applyTheme(Theme::Light);
        return takeStudyPictures(arguments.study, arguments.file.isEmpty() ? defaultCase : arguments.file,
                                 arguments.pictures, arguments.outside);
    }
    if (!arguments.printLesson.isEmpty()) {
        qputenv("QT_QPA_PLATFORM", "offscreen");
        const QApplication application(argc, argv);
        std::setlocale(LC_NUMERIC, "C");
        useNames();
        const SettingsFile settings;
        applyTheme(Theme::Light);
        return printLesson(arguments.printLesson);
    }
    const bool isRun = CaseFiles::isResultsFile(arguments.file);
    const bool pictures = !arguments.exportFolder.isEmpty() || !arguments.screenshot.isEmpty();
    if (isRun && pictures) {
        complain(arguments.file.toStdString() + ": is a saved run; pictures need a case");
        return exitWrongInput;
    }
    CaseDocument document;
    if (!arguments.file.isEmpty() && !isRun)
        document = readCase(arguments.file, arguments.outside, !pictures);
    else if (pictures)
        document = readCase(defaultCase, arguments.outside, false);

    QApplication application(argc, argv);
    std::setlocale(LC_NUMERIC, "C"); // QApplication took the user's, in which the core would print a decimal comma
    useNames();
    const SettingsFile settings;
    const QStringList remarks = settings.problem().isEmpty() ? QStringList() : QStringList{settings.problem()};
    for (const QString& remark : remarks) complain(remark.toStdString());
    QGuiApplication::setDesktopFileName(QStringLiteral("touchdown-workbench"));
    applyTheme(themeFromName(arguments.theme));

    MainWindow window;
    // Pictures must not depend on the last session.
    if (!pictures && !arguments.fresh) window.restoreArrangement();
    if (!arguments.theme.isEmpty()) window.useTheme(arguments.theme);

    const QFileInfo info(arguments.file);
    if (!document.valid()) {
        window.files().open(defaultCase);
        window.files().open(arguments.file); // asks, or says what is wrong; a study opens its page
    } else if (!document.name.empty()) {
        window.files().take(document, info.exists() ? info.absoluteFilePath() : QString());
    } else if (arguments.fresh) {
        window.files().take(readCase(defaultCase, arguments.outside, false), {});
    } else {
        window.openLastCase();
    }

    const bool staticState = arguments.staticState && document.value.model == ModelKind::Film;
    if (pictures)
        return takePictures(window, {arguments.exportFolder, arguments.screenshot, arguments.size, staticState});
    window.fitScreen();
    window.show();
    window.beginSession(arguments.file.isEmpty() && !arguments.fresh, remarks);
    if (isRun) window.files().open(arguments.file);
    const bool plainStart = arguments.file.isEmpty() || (arguments.run && arguments.file == defaultCase);
    // A person whose settings cannot be read is no newcomer.
    if (plainStart && !arguments.fresh && remarks.isEmpty() && StartCard::wanted()) {
        QTimer::singleShot(0, &window, &MainWindow::greet);
        return QApplication::exec();
    }
    if (arguments.run && document.valid())
        QTimer::singleShot(0, &window, [&] { staticState ? window.solveStaticState() : window.startRun(); });
    return QApplication::exec();
}

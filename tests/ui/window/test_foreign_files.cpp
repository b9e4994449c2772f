// SPDX-License-Identifier: GPL-3.0-or-later
//
// Files of another person whose texts look like HTML. Each is opened in the window. Then no label, tool tip, view,
// document or box of the program may take its text for HTML, and no picture that a text names may be asked for.
#include <QAbstractItemView>
#include <QComboBox>
#include <QFileDialog>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QPlainTextEdit>
#include <QSettings>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTextEdit>
#include <QtTest>

#include "core/case/parameters.h"
#include "core/case_files/case_file.h"
#include "core/case_files/case_text.h"
#include "core/case_files/cml_case.h"
#include "core/formats/hdf5_file.h"
#include "core/results/results_writer.h"
#include "core/results/steady_writer.h"
#include "core/studies/study/study_file.h"
#include "tests/support/test_program.h"
#include "tests/ui/question.h"
#include "tests/ui/sample_slider.h"
#include "tests/ui/sample_study.h"
#include "tests/ui/sessions/window_session.h"
#include "ui/case/case_edits.h"
#include "ui/film/film_window.h"
#include "ui/film/solutions_model.h"
#include "ui/style/save_dialog.h"
#include "ui/window/apply_question.h"

using namespace touchdown;

namespace test_foreign_files {

/// A text of a file.
const std::string foreign =
    "<img src='/stranger.png'><a href='http://example.org'>link</a> <b>bold</b> &amp; \u202Eleft";
/// A name of a file or folder.
const QString foreignName = QStringLiteral("<img src='stranger.png'><b> & \u202Eleft");

/// Of what Qt draws as HTML.
bool isForeign(const QString& text) { return text.contains(QLatin1String("<img")); }

class TestForeignFiles : public QObject, private test::WindowSession {
    Q_OBJECT

private slots:
    void initTestCase();
    void cleanupTestCase() { QTextDocument::setDefaultResourceProvider({}); }
    void init();
    void cleanup() { end(); }
    void findsHtml();
    void casesWithProblems();
    void aStudyWithProblems_data();
    void aStudyWithProblems();
    void aCmlCaseWithProblems_data();
    void aCmlCaseWithProblems();
    void aSurface_data();
    void aSurface();
    void aCase();
    void entries();
    void aRun();
    void aStaticState();
    void theReportOfAStudy();
    void aSession();
    void aFileThatCannotBeWritten();

private:
    QString path(const QString& name) const { return folder_->filePath(name); }
    QString write(const QString& name, const std::string& text) const
    {
        QFile file(path(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(text.c_str(), qsizetype(text.size())) < 0)
            qFatal("%s cannot be written", qPrintable(name));
        return file.fileName();
    }
    /// Draws all that there is and looks at it.
    void look();
    void lookAt(QWidget& widget);
    void lookAt(const QAbstractItemModel& model, const QModelIndex& parent);
    /// A text that Qt takes for HTML by itself where it looks like it, as in tool tips.
    void check(const QString& text, const QString& place)
    {
        if (text.contains(QLatin1String("stranger"))) ++shown_;
        if (Qt::mightBeRichText(text) && isForeign(text)) html_ << place + QStringLiteral(": ") + text;
    }

    std::unique_ptr<QTemporaryDir> folder_;
    int shown_ = 0; // texts of the file
    QStringList html_;
    QStringList asked_; // pictures and style sheets
};

void TestForeignFiles::initTestCase()
{
    useNames("test_foreign_files");
    QTextDocument::setDefaultResourceProvider([this](const QUrl& url) {
        asked_ << url.toString();
        return QVariant();
    });
}

void TestForeignFiles::init()
{
    begin();
    folder_ = std::make_unique<QTemporaryDir>();
    start(false);
    shown_ = 0;
    html_.clear();
    asked_.clear();
}

void TestForeignFiles::look()
{
    for (const auto page : {MainWindow::Page::StaticState, MainWindow::Page::Run, MainWindow::Page::Studies}) {
        window_->setPage(page);
        window_->grab();
    }
    for (auto* menu : window_->findChildren<QMenu*>()) emit menu->aboutToShow(); // fills it
    for (QWidget* widget : QApplication::allWidgets()) lookAt(*widget);
    for (QWidget* widget : QApplication::topLevelWidgets())
        if (widget->isVisible()) widget->grab();
}

void TestForeignFiles::lookAt(QWidget& widget)
{
    const QString place = QString::fromLatin1(widget.metaObject()->className()) + u' ' + widget.objectName();
    widget.ensurePolished(); // as before it is measured
    check(widget.toolTip(), place);
    check(widget.whatsThis(), place);
    if (const auto* label = qobject_cast<QLabel*>(&widget)) {
        if (label->textFormat() != Qt::PlainText) check(label->text(), place);
        if (label->textFormat() == Qt::RichText && isForeign(label->text())) html_ << place;
        if (label->text().contains(QLatin1String("stranger"))) ++shown_;
    }
    if (const auto* text = qobject_cast<QTextEdit*>(&widget)) { // it writes the texts of its document escaped
        if (isForeign(text->toHtml())) html_ << place;
        if (text->toPlainText().contains(QLatin1String("stranger"))) ++shown_;
    }
    if (const auto* tabs = qobject_cast<QTabBar*>(&widget))
        for (int i = 0; i < tabs->count(); ++i) check(tabs->tabToolTip(i), place);
    if (const auto* text = qobject_cast<QPlainTextEdit*>(&widget);
        text && text->toPlainText().contains(QLatin1String("stranger")))
        ++shown_;
    const auto* menu = qobject_cast<QMenu*>(&widget);
    for (const QAction* action : widget.actions()) {
        if (menu != nullptr && menu->toolTipsVisible()) check(action->toolTip(), place);
        if (action->text().contains(QLatin1String("stranger"))) ++shown_;
    }
    if (const auto* view = qobject_cast<QAbstractItemView*>(&widget); view && view->model())
        lookAt(*view->model(), view->rootIndex());
    if (const auto* box = qobject_cast<QComboBox*>(&widget)) lookAt(*box->model(), {});
}

void TestForeignFiles::lookAt(const QAbstractItemModel& model, const QModelIndex& parent)
{
    const QString place = QString::fromLatin1(model.metaObject()->className());
    for (int column = 0; column < model.columnCount(parent); ++column) {
        for (const int role : {Qt::ToolTipRole, Qt::WhatsThisRole}) {
            check(model.headerData(column, Qt::Horizontal, role).toString(), place);
            for (int row = 0; row < model.rowCount(parent); ++row)
                check(model.index(row, column, parent).data(role).toString(), place);
        }
    }
    for (int row = 0; row < model.rowCount(parent); ++row)
        if (const QModelIndex index = model.index(row, 0, parent); model.hasChildren(index)) lookAt(model, index);
}

#define LOOK()                                                                                                         \
    look();                                                                                                            \
    QVERIFY(shown_ > 0);                                                                                               \
    QVERIFY2(html_.isEmpty(), qPrintable(html_.join(QLatin1Char('\n'))));                                              \
    QVERIFY2(asked_.isEmpty(), qPrintable(asked_.join(QLatin1Char('\n'))))

/// The test itself sees HTML where there is some.
void TestForeignFiles::findsHtml()
{
    const QString text = QString::fromStdString(foreign);
    QLabel label(text, window_.get());
    label.setTextFormat(Qt::RichText);
    label.show();
    label.setToolTip(text);
    look();
    QVERIFY(html_.size() >= 2);
    QVERIFY(!asked_.isEmpty());
}

void TestForeignFiles::casesWithProblems()
{
    const std::string quoted = '"' + foreign + '"';
    std::string many; // more than the box holds
    for (int i = 0; i < 20; ++i) many += "\"" + std::to_string(i) + foreign + "\" = 1\n";
    const std::vector<std::string> texts{quoted + " = 1\n",
                                         "[" + quoted + "]\nx = 1\n",
                                         "[run." + quoted + "]\nx = 1\n",
                                         "model = " + quoted + "\n",
                                         "model = \"a\\n" + foreign + "\"\n",
                                         "[run]\nduration = " + quoted + "\n",
                                         "[run]\nduration = \"1 " + foreign + "\"\n",
                                         "[abs]\nrails = " + quoted + "\n",
                                         many};
    for (const std::string& text : texts) {
        const int before = shown_;
        window_->files().open(write(foreignName + ".toml", text));
        look();
        QVERIFY2(shown_ > before, text.c_str());
    }
    QVERIFY(window_->findChildren<QMessageBox*>().size() >= std::ssize(texts));
    LOOK();
}

void TestForeignFiles::aStudyWithProblems_data()
{
    QTest::addColumn<std::string>("text");
    QTest::newRow("key") << "\"" + foreign + "\" = 1\n";
    QTest::newRow("value") << "steps = \"" + foreign + "\"\n";
    QTest::newRow("case") << "case = \"" + foreign + "\"\n";
    QTest::newRow("set") << "[set]\n\"" + foreign + "\" = 1\n";
    QTest::newRow("value of a set") << "[set]\n\"run.duration\" = \"" + foreign + "\"\n";
    QTest::newRow("title") << "[set]\n\"title\" = \"" + foreign + "\"\n";
}

void TestForeignFiles::aStudyWithProblems()
{
    QFETCH(std::string, text);
    window_->files().open(write(foreignName + ".toml", "kind = \"hysteresis\"\n" + text));
    LOOK();
}

void TestForeignFiles::aCmlCaseWithProblems_data()
{
    QTest::addColumn<std::string>("member");
    QTest::newRow("rails") << std::string("rail.dat");
    QTest::newRow("run") << std::string("run.dat");
}

void TestForeignFiles::aCmlCaseWithProblems()
{
    QFETCH(std::string, member);
    CmlOutput output = formatCmlCase(sampleFilmCase());
    QCOMPARE(output.problem, std::string());
    for (CmlMember& each : output.members) {
        if (each.name != member) continue;
        // In place of the first number of the third line; an ordinary blank would end the word.
        const auto line = each.text.find('\n', each.text.find('\n') + 1) + 1;
        each.text.replace(line, each.text.find('\n', line) - line, "<img\u00A0src='/stranger.png'>");
    }
    for (const QString& ending : {QString(), QStringLiteral(".cml")}) {
        const QString file = path(foreignName + ending);
        QCOMPARE(writeCmlCase(file.toStdString(), output.members), std::string());
        window_->files().open(file);
    }
    QCOMPARE(window_->findChildren<QMessageBox*>(QStringLiteral("problems")).size(), 2);
    LOOK();
}

void TestForeignFiles::aSurface_data()
{
    QTest::addColumn<QString>("ending");
    QTest::addColumn<std::string>("text"); // empty: HDF5
    const auto row = [](const char* name, const char* ending, const std::string& text) {
        QTest::newRow(name) << QString::fromLatin1(ending) << text;
    };
    row("name of a column", ".txt", "x [um]; " + foreign + " [nm]\n0; 1\n1; 2\n2; 1\n3; 2\n");
    row("unit", ".txt", "x [um]; z [" + foreign + "]\n0; 1\n1; 2\n2; 1\n3; 2\n");
    row("remark", ".txt", "# direction down: " + foreign + "\nx [um]; z [nm]\n0; 1\n1; 2\n2; 1\n3; 2\n");
    row("value", ".txt", "x [um]; z [nm]\n0; 1\n1; " + foreign + "\n");
    row("wave.def", "wave.def", "0 1 5\n1e-6 " + foreign + " 6\n");
    row("GSF", ".gsf", "Gwyddion Simple Field 1.0\nXRes = 2\nYRes = 1\nXYUnits = " + foreign + "\n");
    row("SDF", ".sdf", "aBCR-1.0\nManufacID = none\nNumPoints = " + foreign + "\nNumProfiles = 2\n*\n1 2\n*\n");
    row("HDF5", ".h5", {});
}

void TestForeignFiles::aSurface()
{
    QFETCH(QString, ending);
    QFETCH(std::string, text);
    const QString name = foreignName + ending;
    if (text.empty()) {
        const Hdf5Access access;
        const Hdf5Group file = createHdf5File(path(name).toStdString());
        const std::vector<double> values{0.0, 1.0, 2.0, 3.0};
        file.put("x", values).set("units", foreign);
        file.put(foreignName.toStdString(), values).set("units", foreign);
    } else {
        write(name, text);
    }
    window_->files().open(
        write(QStringLiteral("case.toml"),
              "title = \"stranger\"\n[disk.surface]\nkind = \"file\"\nfile = \"" + name.toStdString() + "\"\n"));
    LOOK();
}

/// A valid case: its title and path, what is asked before it is left, and what the window remembers.
void TestForeignFiles::aCase()
{
    QVERIFY(QDir(folder_->path()).mkdir(foreignName));
    const QString file = write(foreignName + u'/' + foreignName + ".toml",
                               "title = \"" + foreign + "\"\n[about]\nwatch = \"\"\"" + foreign + "\n" + foreign +
                                   "\"\"\"\n[run]\nduration = \"20 us\"\n");
    window_->files().open(file);
    QCOMPARE(window_->edits().value().title, foreign);
    run();
    LOOK();
    Case changed = window_->edits().value();
    changed.title += " changed";
    window_->edits().setAll(changed, QString::fromStdString(foreign));
    window_->files().open(QStringLiteral("fig12a"));
    QVERIFY(question(*window_, "unsavedChanges"));
    window_->close();
    QVERIFY(question(*window_, "closing"));
    askToApply(*window_, window_->edits().value(), sampleFilmCase(), true, QString::fromStdString(foreign), [] {});
    QVERIFY(question(*window_, "applyQuestion"));
    LOOK();
}

/// What a person types, or a session brings back.
void TestForeignFiles::entries()
{
    for (const char* key : {"run.duration", "title", "springs.flying_height"})
        if (const Parameter* parameter = findParameter(key))
            window_->edits().enter(*parameter, QString::fromStdString(foreign));
    QVERIFY(!window_->edits().reasonNotToRun().isEmpty());
    LOOK();
}

void TestForeignFiles::aRun()
{
    Case c = window_->edits().value();
    c.title = foreign;
    const std::vector<Quantity> quantities{{"flying_height", "m", "nm", "Flying height " + foreign},
                                           {foreignName.toStdString(), "m", "nm", foreign},
                                           {"stranger", foreign, foreign, foreign}};
    SampleBatch batch{{}, std::vector<std::vector<double>>(3)};
    for (int i = 0; i < 200; ++i) {
        batch.time.push_back(1e-7 * i);
        for (auto& column : batch.columns) column.push_back(1e-9 * (i % 7));
    }
    Summary summary;
    summary.message = summary.model = summary.integrator = foreign;
    summary.endTime = batch.time.back();
    summary.warnings = {foreign};
    summary.events = {{1e-6, foreign}};
    summary.verdict.rule = foreign;
    ResultsWriter writer(std::nullopt);
    const QString file = path(foreignName + ".h5");
    QCOMPARE(writer.open(file.toStdString(), c, formatCase(c), quantities), std::string());
    QCOMPARE(writer.append(batch), std::string());
    QCOMPARE(writer.finish(summary), std::string());
    window_->files().open(file);
    QCOMPARE(window_->runs().count(), 1);
    QVERIFY(window_->runs().setData(window_->runs().index(0), QString::fromStdString(foreign), RecordList::NoteRole));
    LOOK();
}

void TestForeignFiles::aStaticState()
{
    Case c = sampleFilmCase();
    c.title = foreign;
    SteadyResult result = sampleResult(c, 12, 10);
    result.message = foreign;
    SteadyWriter writer;
    const QString file = path(foreignName + ".h5");
    QCOMPARE(writer.open(file.toStdString(), c, formatCase(c)), std::string());
    QCOMPARE(writer.add({c.disk.radius, c.disk.skew, c.disk.speed, {}}, result), std::string());
    QCOMPARE(writer.finish(result.status, foreign), std::string());
    window_->files().open(file);
    SolutionsModel& solutions = window_->film().solutions();
    QCOMPARE(solutions.count(), 1);
    QVERIFY(solutions.setData(solutions.index(0), QString::fromStdString(foreign), RecordList::NoteRole));
    LOOK();
}

void TestForeignFiles::theReportOfAStudy()
{
    StudyReport report = sampleReport();
    report.title = report.message = foreign;
    report.status = StudyStatus::Failed;
    report.findings = report.warnings = {foreign, "two\n" + foreign};
    report.found = window_->edits().value();
    report.found->title = foreign;
    for (StudyChart& chart : report.charts) {
        chart.title = chart.caption = foreign;
        for (ChartPanel& panel : chart.panels) {
            panel.x.label = panel.y.label = foreign;
            for (ChartSeries& series : panel.series) {
                series.name = foreign;
                for (ChartPoint& point : series.points) point.label = foreign;
            }
            for (ChartBand& band : panel.bands) band.label = foreign;
            if (panel.map)
                for (ChartClass& each : panel.map->classes) each.name = foreign;
        }
    }
    for (StudyTable& table : report.tables) {
        for (StudyColumn& column : table.columns) column.longName = foreign;
        for (auto& row : table.rows) row.front() = foreign;
    }
    Case c = window_->edits().value();
    c.title = foreign;
    const QString file = path(foreignName + ".h5");
    QCOMPARE(writeStudy(file.toStdString(), report, c, formatCase(c), "kind = \"work-precision\"\n# " + foreign),
             std::string());
    window_->files().open(file);
    LOOK();
}

void TestForeignFiles::aSession()
{
    window_->files().open(write(foreignName + ".toml", "title = \"" + foreign + "\"\n[run]\nduration = \"20 us\"\n"));
    run();
    QVERIFY(window_->runs().setData(window_->runs().index(0), QString::fromStdString(foreign), RecordList::NoteRole));
    window_->edits().enter(*findParameter("run.duration"), QString::fromStdString(foreign));
    const auto said = [] {
        QFile state(onlyFolder() + QStringLiteral("/session.json"));
        return state.open(QIODevice::ReadOnly) ? state.readAll() : QByteArray();
    };
    QTRY_VERIFY(said().contains("stranger.png'><a") && said().contains("run.duration"));
    start();
    QVERIFY(question(*window_, "restoreSession"));
    LOOK();
    restore();
    LOOK();
}

void TestForeignFiles::aFileThatCannotBeWritten()
{
    askAndSave(window_.get(), foreignName, pictureFilters(), QStringLiteral("pdf"),
               [](const QString& file) { return file + QStringLiteral(" cannot be written."); });
    auto* dialog = window_->findChild<QFileDialog*>();
    QVERIFY(QDir(folder_->path()).mkpath(foreignName + u'/' + foreignName));
    dialog->setDirectory(path(foreignName));
    dialog->findChild<QComboBox*>(QStringLiteral("lookInCombo"))->showPopup(); // fills it
    emit dialog->fileSelected(path(foreignName));
    QVERIFY(window_->findChild<QMessageBox*>());
    LOOK();
}

TOUCHDOWN_TEST(TestForeignFiles)

} // namespace test_foreign_files

#include "test_foreign_files.moc"

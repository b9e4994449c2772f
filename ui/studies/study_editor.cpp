// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/studies/study_editor.h"

#include <algorithm>

#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "core/formats/toml_document.h"
#include "core/formats/toml_editor.h"
#include "core/studies/engine/engine.h"
#include "ui/case/parameter_text.h"
#include "ui/studies/engine_dialog.h"
#include "ui/style/foreign_text.h"
#include "ui/style/quantity_format.h"
#include "ui/style/readable.h"
#include "ui/style/result_table.h"
#include "ui/style/theme.h"
#include "ui/style/window_words.h"

namespace touchdown {

namespace {

constexpr int planDelay = 250;          // [ms] after the last key
constexpr std::size_t mostProblems = 6; // shown at once

bool hasCluster()
{
    static const bool has = reasonAgainst(EngineKind::Slurm).empty();
    return has;
}

} // namespace

StudyCatalogue coreStudies()
{
    const std::span<const StudyKind> kinds = studyKinds();
    return {{kinds.begin(), kinds.end()},
            sampleStudies(),
            studyTemplate,
            [](const std::string& kind, const std::string& text, const std::string& name,
               const std::filesystem::path& folder, const Case& c) { return parseStudy(kind, text, name, folder, &c); },
            studyForm};
}

StudyEditor::StudyEditor(StudyCatalogue catalogue, QWidget* parent)
    : QWidget(parent),
      catalogue_(std::move(catalogue)),
      kinds_(new QComboBox(this)),
      help_(new QLabel(this)),
      subject_(new QLabel(this)),
      tabs_(new QTabWidget(this)),
      form_(new StudyFormView(this)),
      text_(new StudyTextEdit(this)),
      samples_(new StudySamples(this)),
      problems_(new QLabel(this)),
      duration_(new QLabel(this)),
      run_(new QPushButton(tr("Perform"), this)),
      stop_(new QPushButton(tr("Stop"), this)),
      open_(quietButton(tr("Open…"), tr("Open a study file"), tr("Open a study"), this)),
      save_(quietButton(tr("Save…"), tr("Save this text as a study file; the command line can perform it, too"),
                        tr("Save the study's text"), this)),
      defaults_(quietButton(tr("Defaults"), tr("Restore the default text for this case"),
                            tr("Use the defaults of this kind of study"), this)),
      cluster_(quietButton(tr("Cluster…"), tr("Perform the study in parts, as jobs of Slurm"),
                           tr("Perform the study on a cluster"), this))
{
    for (const StudyKind& kind : catalogue_.kinds)
        kinds_->addItem(QString::fromStdString(kind.title), QString::fromStdString(kind.name));
    build();
    soon_.setSingleShot(true);
    soon_.setInterval(planDelay);
    connect(&soon_, &QTimer::timeout, this, &StudyEditor::replan);
    connect(kinds_, &QComboBox::currentIndexChanged, this, &StudyEditor::showKind);
    connect(text_, &QPlainTextEdit::textChanged, this, [this] {
        drafts_[kind()].text = toText();
        stale_ = true;
        soon_.start();
        emit edited();
    });
    connect(form_, &StudyFormView::entered, this, &StudyEditor::enter);
    connect(form_, &StudyFormView::typedChanged, this, &StudyEditor::edited);
    connect(form_, &StudyFormView::rowAdded, this, [this](const QString& list, std::size_t after) {
        const std::string name = list.toStdString();
        change([&](TomlEditor& editor) { editor.insertTable(name, after, "[[" + name + "]]\n"); });
    });
    connect(form_, &StudyFormView::rowRemoved, this, [this](const QString& list, std::size_t number) {
        change([&](TomlEditor& editor) { editor.removeTable(list.toStdString(), number); });
    });
    connect(form_, &StudyFormView::defaultsWanted, this, [this] {
        const QString text = toText();
        const std::string lists = catalogue_.form(kind().toStdString(), plan_.start.value).lists;
        replaceText(text + (text.endsWith(u'\n') ? "" : "\n") + QString::fromStdString(lists));
        replan();
    });
    connect(form_, &StudyFormView::undoRequested, text_, &QPlainTextEdit::undo);
    connect(form_, &StudyFormView::redoRequested, text_, &QPlainTextEdit::redo);
    connect(samples_, &StudySamples::chosen, this, [this](const SampleStudy& sample) { openSample(sample); });
    connect(problems_, &QLabel::linkActivated, this, [this](const QString& line) {
        tabs_->setCurrentWidget(text_);
        text_->goToLine(line.toInt());
    });
    connect(open_, &QToolButton::clicked, this, &StudyEditor::chooseOpen);
    connect(run_, &QPushButton::clicked, this, &StudyEditor::runRequested);
    connect(cluster_, &QToolButton::clicked, this, &StudyEditor::chooseEngine);
    connect(stop_, &QPushButton::clicked, this, &StudyEditor::stopRequested);
    connect(save_, &QToolButton::clicked, this, [this] { chooseSave(kind(), {}); });
    connect(defaults_, &QToolButton::clicked, this, &StudyEditor::takeDefaults);
    showKind();
}

void StudyEditor::build()
{
    kinds_->setAccessibleName(tr("Kind of study"));
    kinds_->setFocusPolicy(Qt::StrongFocus);
    kinds_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    kinds_->setMinimumContentsLength(12);
    help_->setWordWrap(true);
    subject_->setTextFormat(Qt::RichText);
    problems_->setWordWrap(true);
    problems_->setTextFormat(Qt::RichText);
    problems_->setTextInteractionFlags(Qt::TextBrowserInteraction);
    problems_->setAccessibleName(tr("Errors of the study"));
    duration_->setWordWrap(true);
    duration_->setAccessibleName(tr("The time that the study takes"));
    duration_->hide();
    stop_->setAccessibleName(tr("Stop the study"));
    stop_->setToolTip(tr("Stop the study; its results so far are kept (F8)"));
    stop_->setEnabled(false);
    nameRun();
    for (QPushButton* button : {run_, stop_}) button->setAutoDefault(false);

    subject_->setWordWrap(true);
    subject_->setAccessibleName(tr("The case that is studied"));
    tabs_->setDocumentMode(true);
    tabs_->addTab(form_, tr("Form"));
    tabs_->addTab(text_, tr("Text"));
    tabs_->addTab(samples_, tr("Samples"));
    tabs_->setAccessibleName(tr("The study as form and text; sample studies"));

    auto* files = new QHBoxLayout;
    files->setSpacing(2);
    files->addWidget(open_);
    files->addWidget(save_);
    files->addWidget(defaults_);
    files->addStretch(1);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(run_, 2);
    buttons->addWidget(stop_, 1);
    buttons->addWidget(cluster_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 6, 8, 8);
    layout->setSpacing(6);
    layout->addWidget(kinds_);
    layout->addWidget(help_);
    layout->addLayout(files);
    layout->addWidget(subject_);
    layout->addWidget(tabs_, 1);
    layout->addWidget(problems_);
    layout->addWidget(duration_);
    layout->addLayout(buttons);
    setMinimumWidth(240);
    colour();
}

void StudyEditor::colour()
{
    QPalette quiet;
    quiet.setColor(QPalette::WindowText, meaningColours(palette()).muted);
    help_->setPalette(quiet);
    duration_->setPalette(quiet);
}

void StudyEditor::setDuration(const QString& sentence)
{
    duration_->setText(sentence);
    duration_->setVisible(!sentence.isEmpty());
}

void StudyEditor::setCase(const Case& c)
{
    case_ = c;
    stale_ = true;
    if (isVisible()) soon_.start();
}

void StudyEditor::setKind(const QString& name)
{
    if (const int index = kinds_->findData(name); index >= 0) kinds_->setCurrentIndex(index);
}

void StudyEditor::showKind()
{
    const auto found = std::ranges::find(catalogue_.kinds, kind().toStdString(), &StudyKind::name);
    help_->setText(found == catalogue_.kinds.end() ? QString() : sentence(found->help));
    samples_->setSamples(catalogue_.samples, catalogue_.kinds, kind().toStdString());
    tabs_->setTabVisible(tabs_->indexOf(samples_), samples_->gallery()->count() > 0);
    const Draft draft = drafts_[kind()];
    text_->setPlainText(draft.text);
    stale_ = true;
    if (isVisible()) replan();
}

QString StudyEditor::folder() const
{
    const auto draft = drafts_.find(kind());
    return draft == drafts_.end() || draft->second.file.isEmpty() ? QString()
                                                                  : QFileInfo(draft->second.file).absolutePath();
}

const StudyPlan& StudyEditor::plan()
{
    form_->commitTyped();
    if (stale_) replan();
    return plan_;
}

void StudyEditor::replan()
{
    soon_.stop();
    if (kinds_->count() == 0) return;
    Draft& draft = drafts_[kind()];
    if (draft.text == draft.defaults && draft.file.isEmpty()) {
        const QString defaults = QString::fromStdString(catalogue_.defaultText(kind().toStdString(), case_));
        draft.text = draft.saved = draft.defaults = defaults;
        if (toText() != defaults) text_->setPlainText(defaults);
        soon_.stop();
    }
    const QFileInfo file(draft.file);
    const QString name = draft.file.isEmpty() ? tr("the study") : file.fileName();
    const QString folder = draft.file.isEmpty() ? QString() : file.absolutePath();
    plan_ = catalogue_.plan(kind().toStdString(), draft.text.toStdString(), name.toStdString(), folder.toStdString(),
                            case_);
    stale_ = false;
    showForm();
    showProblems();
    emit planned();
}

void StudyEditor::showForm()
{
    const TomlDocument toml = readToml(plan_.text);
    if (!toml.problem.empty()) {
        form_->show({}, toml, {}, {});
        return;
    }
    const bool namesCase = std::ranges::find(toml.entries, "case", &TomlEntry::key) != toml.entries.end();
    const QString title = escaped(readable(plan_.start.value.title));
    const bool differs = namesCase && !caseDifference(case_, plan_.start.value).isEmpty();
    subject_->setText(namesCase ? tr("Studies <b>%1</b>; changes at the left have no effect.").arg(title)
                                : tr("Studies the case at the left: <b>%1</b>").arg(title));
    setTextColour(subject_, differs ? meaningColours(palette()).warning : QColor());
    if (catalogue_.form)
        form_->show(catalogue_.form(kind().toStdString(), plan_.start.value), toml, plan_.start.value,
                    QString::fromStdString(case_.title));
    form_->mark(plan_.problems, plan_.name);
}

void StudyEditor::chooseEngine()
{
    auto* dialog = new EngineDialog(folder(), this);
    connect(dialog, &EngineDialog::taken, this, &StudyEditor::engineChosen);
    dialog->open();
}

void StudyEditor::enter(const QString& key, const QString& value)
{
    replaceText(textWith(key.toStdString(), value.toStdString()));
    replan();
}

QString StudyEditor::textWith(const std::string& key, const std::string& value) const
{
    const std::string text = toText().toStdString();
    const TomlDocument toml = readToml(text);
    TomlEditor editor(text, toml);
    if (value.empty())
        editor.remove(key);
    else
        editor.put(key, value);
    return QString::fromStdString(editor.result());
}

void StudyEditor::change(const std::function<void(TomlEditor&)>& change)
{
    const std::string text = toText().toStdString();
    const TomlDocument toml = readToml(text);
    TomlEditor editor(text, toml);
    change(editor);
    replaceText(QString::fromStdString(editor.result()));
    replan();
}

/// So that the text's own undo takes it back.
void StudyEditor::replaceText(const QString& text)
{
    QTextCursor all(text_->document());
    all.select(QTextCursor::Document);
    all.insertText(text);
}

void StudyEditor::showProblems()
{
    const QString colour = meaningColours(palette()).failure.name();
    QStringList lines;
    std::vector<int> marked;
    for (const InputProblem& problem : plan_.problems) {
        const bool ofTheText = problem.file == plan_.name && problem.line > 0;
        if (ofTheText) marked.push_back(problem.line);
        if (static_cast<std::size_t>(lines.size()) >= mostProblems) continue;
        QString text = inWindowWords(problem.message);
        if (!problem.key.empty()) text = QStringLiteral("%1: %2").arg(keyLabel(problem.key), text);
        text = escaped(text);
        if (ofTheText)
            text = QStringLiteral("<a href='%1' style='color:%2'>%3</a>: ")
                       .arg(problem.line)
                       .arg(colour, tr("line %1").arg(problem.line)) +
                   text;
        else if (problem.file != plan_.name)
            text = escaped(QString::fromStdString(problem.file)) + QStringLiteral(": ") + text;
        lines << QStringLiteral("<span style='color:%1'>✕</span> ").arg(colour) + text;
    }
    if (plan_.problems.size() > mostProblems)
        lines << tr("and %n more", nullptr, static_cast<int>(plan_.problems.size() - mostProblems));
    problems_->setText(lines.join(QStringLiteral("<br>")));
    problems_->setVisible(!lines.isEmpty());
    text_->markLines(marked);
    run_->setEnabled(plan_.valid() && plan_.perform != nullptr);
    cluster_->setVisible(hasCluster());
    cluster_->setEnabled(plan_.valid() && plan_.performList != nullptr);
}

void StudyEditor::setRunning(bool running, bool chosen)
{
    running_ = running && chosen;
    stop_->setEnabled(running);
    nameRun();
}

void StudyEditor::setContinues(bool continues)
{
    continues_ = continues;
    nameRun();
}

void StudyEditor::nameRun()
{
    run_->setAccessibleName(continues_ ? tr("Continue the study") : tr("Perform the study"));
    run_->setText(running_ ? tr("Perform again") : continues_ ? tr("Continue") : tr("Perform"));
    if (continues_)
        run_->setToolTip(tr("Solve the rows that are missing (Shift+F5)"));
    else
        run_->setToolTip(tr("Perform the study (Shift+F5)"));
}

void StudyEditor::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        colour();
        if (stale_) return;
        showForm();
        showProblems();
    }
}

void StudyEditor::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    if (stale_)
        replan();
    else
        emit planned(); // what waits until it is seen
}

void StudyEditor::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    emit hidden();
}

} // namespace touchdown

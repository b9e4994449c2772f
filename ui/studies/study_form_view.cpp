// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/studies/study_form_view.h"

#include <algorithm>
#include <utility>

#include <QCompleter>
#include <QEvent>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QTimer>

#include "core/case/case.h"
#include "core/formats/toml_document.h"
#include "ui/style/foreign_text.h"
#include "ui/style/quantity_format.h"
#include "ui/style/readable.h"
#include "ui/style/theme.h"
#include "ui/style/window_words.h"

namespace touchdown {

StudyFormView::StudyFormView(QWidget* parent) : QScrollArea(parent)
{
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::NoFocus);
    setWidget(new QWidget);
}

void StudyFormView::show(const StudyForm& form, const TomlDocument& toml, const Case& c, const QString& givenTitle)
{
    widget()->setEnabled(toml.problem.empty());
    if (!toml.problem.empty()) return; // the fields stay as they were until the text can be read
    FormFields fields = fieldsOf(form, toml, c);
    auto numbers = caseNumbers(c);
    const TomlDocument shown = withDefaultLists(toml, form);
    for (const TomlEntry& entry : shown.entries) { // what a method varies need not be a single number
        const auto* key = std::get_if<std::string>(&entry.value);
        const QString label = key && takesCaseKey(withoutNumbers(entry.key)) ? labelOfKey(*key) : QString();
        const auto isListed = [&](const auto& each) { return each.first == label || each.second == *key; };
        if (!label.isEmpty() && std::ranges::none_of(numbers, isListed)) numbers.emplace_back(label, *key);
    }
    if (fields != fields_ || numbers != numbers_) {
        fields_ = std::move(fields);
        numbers_ = std::move(numbers);
        build();
    }
    for (Row& row : rows_) fill(row, shown, givenTitle);
    QStringList others;
    const auto named = [&others](const std::string& key) {
        const QString text = QStringLiteral("[[%1]]").arg(QString::fromStdString(key));
        if (!others.contains(text)) others << text;
    };
    for (const FormList& list : fields_.lists)
        if (list.onlyText) named(list.name);
    for (const TomlTable& table : toml.tables) {
        const auto isTable = [&](const StudyKey& key) {
            return key.inList && key.kind == StudyKeyKind::Settings && key.key == withoutNumbers(table.key);
        };
        if (std::ranges::any_of(form.keys, isTable))
            if (const QString text = QString::fromStdString(withoutNumbers(table.key)); !others.contains(text))
                others << text;
    }
    lists_->setText(others.isEmpty() ? QString() : tr("In the text only: %1").arg(others.join(QStringLiteral(", "))));
    lists_->setVisible(!others.isEmpty());
}

void StudyFormView::build()
{
    std::string focused;
    QString typed; // and not entered yet
    for (const Row& row : rows_) {
        if (row.input->hasFocus()) {
            focused = row.key.key;
            const auto* entry = qobject_cast<QLineEdit*>(row.input);
            if (entry != nullptr && entry->isModified()) typed = entry->text();
        }
        row.input->disconnect(this); // an input that loses its focus while it is destroyed
    }
    rows_.clear();
    notes_.clear();
    auto* page = new QWidget;
    auto* grid = new QGridLayout(page);
    grid->setContentsMargins(0, 2, 6, 2);
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(1);
    grid->setColumnStretch(1, 1);
    int line = 0;
    for (const StudyKey& key : fields_.keys) {
        Row& row = addRow(key, fieldLabel(key.key));
        row.help = new QLabel(sentence(key.help));
        row.help->setWordWrap(true);
        row.help->setFont(row.problem->font());
        row.help->setContentsMargins(0, 0, 0, 6);
        row.input->setAccessibleDescription(row.help->text());
        grid->addWidget(row.label, line, 0);
        grid->addWidget(row.input, line++, 1);
        grid->addWidget(row.problem, line++, 0, 1, 2);
        grid->addWidget(row.help, line++, 0, 1, 2);
    }
    for (const FormList& list : fields_.lists)
        if (!list.onlyText) grid->addWidget(makeList(list), line++, 0, 1, 2);
    lists_ = new QLabel;
    lists_->setWordWrap(true);
    grid->addWidget(lists_, line++, 0, 1, 2);
    grid->setRowStretch(line, 1);
    takeWidget()->deleteLater(); // one of its inputs may have asked for this
    setWidget(page);
    colour();
    const std::string wanted = std::exchange(wanted_, {});
    for (const Row& row : rows_)
        if (wanted.empty() ? row.key.key == focused : row.key.key.starts_with(wanted)) {
            row.input->setFocus();
            if (!wanted.empty()) QTimer::singleShot(0, row.input, [this, at = row.input] { ensureWidgetVisible(at); });
            break;
        }
    auto* entry = qobject_cast<QLineEdit*>(field(focused));
    if (entry == nullptr || typed.isNull()) return;
    entry->setText(typed);
    entry->setModified(true);
}

StudyFormView::Row& StudyFormView::addRow(const StudyKey& key, const QString& name)
{
    Row row{.key = key, .input = makeInput(key), .label = new QLabel(name), .problem = makeProblem()};
    row.label->setBuddy(row.input);
    const QString allowed = tr("Key: %1. Allowed: %2").arg(QString::fromStdString(key.key), readable(allowedText(key)));
    const QString tip = key.inList ? sentence(key.help) + QLatin1Char('\n') + allowed : allowed;
    for (QWidget* part : {static_cast<QWidget*>(row.label), row.input}) part->setToolTip(plainTip(tip));
    row.input->installEventFilter(this);
    row.input->setObjectName(QString::fromStdString(key.key));
    row.input->setAccessibleName(keyLabel(key.key));
    rows_.push_back(std::move(row));
    return rows_.back();
}

QLabel* StudyFormView::makeProblem()
{
    auto* label = new QLabel;
    QFont font = label->font();
    font.setPointSizeF(0.9 * font.pointSizeF());
    label->setFont(font);
    label->setWordWrap(true);
    label->hide();
    return label;
}

void StudyFormView::mark(const std::vector<InputProblem>& problems, const std::string& name)
{
    const auto markOne = [&](const std::string& key, QLabel* label, const QString& before) {
        const auto isHere = [&](const InputProblem& problem) { return problem.file == name && problem.key == key; };
        const auto found = std::ranges::find_if(problems, isHere);
        QString text = found == problems.end() ? QString()
                       : before.isEmpty()      ? sentence(found->message)
                                               : before + QLatin1Char(' ') + inWindowWords(found->message);
        label->setText(text.remove(QStringLiteral(" in quotation marks"))); // which a text needs, a field does not
        label->setVisible(found != problems.end());
    };
    for (Row& row : rows_) markOne(row.key.key, row.problem, row.key.inList ? columnLabel(row.key.key) : "");
    for (const auto& [key, label] : notes_) markOne(key, label, fieldLabel(key));
}

QWidget* StudyFormView::field(const std::string& key) const
{
    const auto row = std::ranges::find(rows_, key, [](const Row& each) { return each.key.key; });
    return row == rows_.end() ? nullptr : row->input;
}

QString StudyFormView::problemOf(const std::string& key) const
{
    const auto row = std::ranges::find(rows_, key, [](const Row& each) { return each.key.key; });
    return row == rows_.end() ? QString() : row->problem->text();
}

void StudyFormView::colour()
{
    const MeaningColours colours = meaningColours(palette());
    for (const Row& row : rows_) {
        setTextColour(row.key.inList ? row.label : row.help, colours.muted);
        setTextColour(row.problem, colours.failure);
    }
    for (const auto& [key, label] : notes_) setTextColour(label, colours.failure);
    if (lists_ != nullptr) setTextColour(lists_, colours.muted);
}

bool StudyFormView::eventFilter(QObject* watched, QEvent* event)
{
    // The wheel scrolls the form and changes no input, not even the one with the focus.
    if (event->type() == QEvent::Wheel) {
        const auto isInput = [watched](const Row& row) { return row.input == watched; };
        if (std::ranges::none_of(rows_, isInput)) return QScrollArea::eventFilter(watched, event); // a scroll bar
        event->ignore();
        return true;
    }
    // A line with choices opens their list, as a combo box does.
    if (auto* line = qobject_cast<QLineEdit*>(watched); line != nullptr && line->completer() != nullptr) {
        const bool isDown = event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Down;
        if (isDown || (event->type() == QEvent::MouseButtonRelease && !line->isModified())) {
            line->selectAll();
            showAllCompletions(line);
            return true;
        }
    }
    // With nothing typed, undo and redo are those of the study.
    const auto* entry = qobject_cast<QLineEdit*>(watched);
    const bool isKey = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
    if (!isKey || (entry != nullptr && entry->isModified())) return QScrollArea::eventFilter(watched, event);
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool undo = key->matches(QKeySequence::Undo);
    if (!undo && !key->matches(QKeySequence::Redo)) return QScrollArea::eventFilter(watched, event);
    event->accept();
    if (event->type() == QEvent::KeyPress) undo ? emit undoRequested() : emit redoRequested();
    return true;
}

void StudyFormView::changeEvent(QEvent* event)
{
    QScrollArea::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) colour();
}

} // namespace touchdown

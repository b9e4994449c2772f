// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/studies/study_form_view.h"

#include <algorithm>
#include <utility>

#include <QCheckBox>
#include <QComboBox>
#include <QCompleter>
#include <QEvent>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QRegularExpression>
#include <QStringListModel>

#include "core/case/parameters.h"
#include "core/case_files/case_file.h"
#include "core/case_files/case_reader.h"
#include "core/formats/toml_document.h"
#include "core/formats/units.h"
#include "ui/case/parameter_text.h"
#include "ui/style/foreign_text.h"
#include "ui/style/quantity_format.h"
#include "ui/style/readable.h"
#include "ui/style/theme.h"

namespace touchdown {

namespace {

const TomlEntry* entryOf(const TomlDocument& toml, const std::string& key)
{
    const auto found = std::ranges::find(toml.entries, key, &TomlEntry::key);
    return found == toml.entries.end() ? nullptr : &*found;
}

bool hasTable(const TomlDocument& toml, const std::string& key)
{
    return std::ranges::any_of(toml.tables, [&key](const TomlTable& table) { return table.key == key; });
}

/// Keys with a field: those of the study itself, and those of a single table that the text has.
std::vector<StudyKey> keysWithFields(const std::vector<StudyKey>& keys, const TomlDocument& toml)
{
    std::vector<StudyKey> some;
    for (const StudyKey& key : keys) {
        const std::string table = ownerOf(key.key);
        // A choice without a default has none for the model of this case.
        if (key.kind == StudyKeyKind::Choice && defaultText(key).empty() && entryOf(toml, key.key) == nullptr) continue;
        const bool shown = !key.inList && key.kind != StudyKeyKind::Settings && key.kind != StudyKeyKind::Table &&
                           key.key != "kind" && key.key != "title" && (table.empty() || hasTable(toml, table));
        if (shown) some.push_back(key);
    }
    return some;
}

/// "time_limit" as "Time limit", "map.x_from" as "Map: x from".
QString fieldLabel(const std::string& key)
{
    QString text = QString::fromStdString(key).replace(QLatin1Char('_'), QLatin1Char(' '));
    text.replace(QLatin1Char('.'), QStringLiteral(": "));
    text[0] = text[0].toUpper();
    return text;
}

std::string asText(const TomlValue& value)
{
    if (const auto* text = std::get_if<std::string>(&value)) return *text;
    if (const auto* whole = std::get_if<std::int64_t>(&value)) return std::to_string(*whole);
    if (const auto* number = std::get_if<double>(&value)) return formatNumber(*number);
    if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
    std::string list;
    if (const auto* array = std::get_if<TomlArray>(&value))
        for (const TomlElement& element : array->elements) list += (list.empty() ? "" : ", ") + asText(element.value);
    return list;
}

/// "um" of "2 um".
std::string unitOf(const std::string& text)
{
    const auto space = text.find(' ');
    return space == std::string::npos ? std::string() : text.substr(space + 1);
}

/// What parameter_text.h needs to know to read a number, or a list of numbers, as it was typed.
Parameter typedAs(ParameterKind kind, std::string displayUnit)
{
    Parameter parameter;
    parameter.kind = kind;
    parameter.displayUnit = std::move(displayUnit);
    return parameter;
}

/// A bare number, or a text in quotation marks.
std::string asToml(const std::string& text)
{
    static const QRegularExpression number(QStringLiteral("^[+-]?(0|[1-9][0-9]{0,17})(\\.[0-9]+)?([eE][+-]?[0-9]+)?$"));
    return number.match(QString::fromStdString(text)).hasMatch() ? text : tomlString(text);
}

std::string listAsToml(const std::string& list)
{
    std::string toml;
    for (const std::string_view element : listElements(list))
        toml += (toml.empty() ? "" : ", ") + asToml(std::string(element));
    return "[" + toml + "]";
}

/// Names and titles of the sample cases.
const std::vector<std::pair<QString, QString>>& titlesOfSamples()
{
    static const std::vector<std::pair<QString, QString>> titles = [] {
        std::vector<std::pair<QString, QString>> all;
        for (const SampleCase& each : sampleCases())
            all.emplace_back(QString::fromStdString(each.name),
                             QString::fromStdString(parseCase(each.text, each.name).value.title));
        return all;
    }();
    return titles;
}

/// Keys of the numbers of a case.
QCompleter* keyCompleter(QObject* parent)
{
    QStringList keys;
    for (const Parameter& parameter : parameters())
        if (parameter.kind == ParameterKind::Number) keys << QString::fromStdString(parameter.key);
    auto* completer = new QCompleter(keys, parent);
    completer->setFilterMode(Qt::MatchContains);
    completer->setCaseSensitivity(Qt::CaseInsensitive);
    return completer;
}

} // namespace

StudyFormView::StudyFormView(QWidget* parent) : QScrollArea(parent)
{
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::NoFocus);
    setWidget(new QWidget);
}

void StudyFormView::show(const std::vector<StudyKey>& keys, const TomlDocument& toml, const QString& givenTitle)
{
    widget()->setEnabled(toml.problem.empty());
    if (!toml.problem.empty()) return; // the fields stay as they were until the text can be read
    if (std::vector<StudyKey> some = keysWithFields(keys, toml); some != keys_) build(std::move(some));
    for (Row& row : rows_) fill(row, toml, givenTitle);
    QStringList lists;
    for (const TomlTable& table : toml.tables) {
        if (table.kind != TomlTableKind::Array) continue;
        const auto isOne = [&table](const TomlTable& each) { return each.key.starts_with(table.key + "["); };
        lists << QStringLiteral("%1 %2")
                     .arg(std::ranges::count_if(
                         toml.tables,
                         [&](const TomlTable& each) { return isOne(each) && each.key.find('.') == std::string::npos; }))
                     .arg(QStringLiteral("[[%1]]").arg(QString::fromStdString(table.key)));
    }
    lists_->setText(lists.isEmpty() ? QString() : tr("In the text only: %1").arg(lists.join(QStringLiteral(", "))));
    lists_->setVisible(!lists.isEmpty());
}

void StudyFormView::build(std::vector<StudyKey> keys)
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
    keys_ = std::move(keys);
    rows_.clear();
    auto* page = new QWidget;
    auto* grid = new QGridLayout(page);
    grid->setContentsMargins(0, 2, 6, 2);
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(1);
    grid->setColumnStretch(1, 1);
    int line = 0;
    for (const StudyKey& key : keys_) {
        Row row{.key = key, .input = makeInput(key), .help = new QLabel, .problem = new QLabel, .shown = {}};
        auto* label = new QLabel(fieldLabel(key.key));
        label->setBuddy(row.input);
        QFont font = row.help->font();
        font.setPointSizeF(0.9 * font.pointSizeF());
        for (QLabel* under : {row.help, row.problem}) {
            under->setWordWrap(true);
            under->setFont(font);
        }
        row.help->setContentsMargins(0, 0, 0, 6);
        row.help->setText(sentence(key.help));
        row.problem->hide();
        const QString allowed =
            tr("Key: %1. Allowed: %2").arg(QString::fromStdString(key.key), readable(allowedText(key)));
        for (QWidget* part : {static_cast<QWidget*>(label), row.input}) part->setToolTip(plainTip(allowed));
        row.input->installEventFilter(this);
        row.input->setObjectName(QString::fromStdString(key.key));
        row.input->setAccessibleName(fieldLabel(key.key));
        row.input->setAccessibleDescription(row.help->text());
        grid->addWidget(label, line, 0);
        grid->addWidget(row.input, line++, 1);
        grid->addWidget(row.problem, line++, 0, 1, 2);
        grid->addWidget(row.help, line++, 0, 1, 2);
        rows_.push_back(std::move(row));
    }
    lists_ = new QLabel;
    lists_->setWordWrap(true);
    grid->addWidget(lists_, line++, 0, 1, 2);
    grid->setRowStretch(line, 1);
    takeWidget()->deleteLater(); // one of its inputs may have asked for this
    setWidget(page);
    colour();
    if (QWidget* input = field(focused)) input->setFocus();
    auto* entry = qobject_cast<QLineEdit*>(field(focused));
    if (entry == nullptr || typed.isNull()) return;
    entry->setText(typed);
    entry->setModified(true);
}

QWidget* StudyFormView::makeInput(const StudyKey& key)
{
    const auto commitKey = [this, name = key.key] { commit(name); };
    if (key.kind == StudyKeyKind::Boolean) {
        auto* check = new QCheckBox;
        connect(check, &QCheckBox::clicked, this, commitKey);
        return check;
    }
    if (key.kind == StudyKeyKind::Choice || key.key == "case") {
        auto* choice = new QComboBox;
        choice->setFocusPolicy(Qt::StrongFocus);
        choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        choice->setMinimumContentsLength(8);
        for (const std::string& each : key.choices)
            choice->addItem(QString::fromStdString(each).replace(QLatin1Char('_'), QLatin1Char(' ')),
                            QString::fromStdString(each));
        connect(choice, &QComboBox::activated, this, commitKey);
        return choice;
    }
    auto* line = new QLineEdit;
    if (key.key == "parameter" || key.key == "map.x" || key.key == "map.y" || key.key.ends_with(".key"))
        line->setCompleter(keyCompleter(line));
    line->setPlaceholderText(readable(defaultText(key)));
    connect(line, &QLineEdit::editingFinished, this, commitKey);
    connect(line, &QLineEdit::textEdited, this, &StudyFormView::typedChanged);
    return line;
}

void StudyFormView::fill(Row& row, const TomlDocument& toml, const QString& givenTitle)
{
    const TomlEntry* entry = entryOf(toml, row.key.key);
    const std::string text = entry == nullptr ? std::string() : asText(entry->value);
    if (row.key.key == "case") {
        fillCases(qobject_cast<QComboBox*>(row.input), text, givenTitle);
    } else if (auto* check = qobject_cast<QCheckBox*>(row.input)) {
        check->setChecked((entry == nullptr ? defaultText(row.key) : text) == "true");
    } else if (auto* choice = qobject_cast<QComboBox*>(row.input)) {
        choice->setCurrentIndex(
            choice->findData(QString::fromStdString(entry == nullptr ? defaultText(row.key) : text)));
    } else if (auto* line = qobject_cast<QLineEdit*>(row.input)) {
        const bool isNumber = row.key.kind == StudyKeyKind::Number;
        row.shown = isNumber ? readable(text) : QString::fromStdString(text);
        row.isBare = entry != nullptr && !std::holds_alternative<std::string>(entry->value);
        const bool beingTyped = line->hasFocus() && line->isModified();
        if (line->text() != row.shown && !beingTyped) {
            line->setText(row.shown);
            line->setCursorPosition(0);
        }
        const Parameter* parameter = findParameter(text);
        row.help->setText(sentence(row.key.help + (parameter == nullptr ? "" : ": " + parameter->label)));
    }
}

void StudyFormView::fillCases(QComboBox* cases, const std::string& chosen, const QString& givenTitle)
{
    if (cases->count() == 0) {
        cases->addItem({}, QString());
        for (const auto& [name, title] : titlesOfSamples()) cases->addItem(title, name);
    }
    cases->setItemText(0, tr("The case at the left: %1").arg(givenTitle));
    if (chosen.empty()) return cases->setCurrentIndex(0);
    const QString name = QString::fromStdString(chosen);
    if (cases->findData(name) < 0) cases->addItem(name, name); // a file
    cases->setCurrentIndex(cases->findData(name));
}

void StudyFormView::commit(const std::string& key)
{
    Row& row = *std::ranges::find(rows_, key, [](const Row& each) { return each.key.key; });
    const auto emitValue = [&](const std::string& value) {
        emit entered(QString::fromStdString(key), QString::fromStdString(value));
    };
    if (const auto* check = qobject_cast<QCheckBox*>(row.input))
        return emitValue(check->isChecked() ? "true" : "false");
    if (const auto* choice = qobject_cast<QComboBox*>(row.input)) {
        const std::string chosen = choice->currentData().toString().toStdString();
        return emitValue(chosen.empty() ? chosen : tomlString(chosen));
    }
    auto* line = qobject_cast<QLineEdit*>(row.input);
    if (line->text() == row.shown) return; // Enter, and then the loss of the focus
    const std::string value = valueIn(row);
    row.shown = line->text();
    line->setModified(false);
    emitValue(value);
}

std::string StudyFormView::valueIn(const Row& row)
{
    const QString text = qobject_cast<QLineEdit*>(row.input)->text();
    if (text.trimmed().isEmpty()) return {};
    switch (row.key.kind) {
    case StudyKeyKind::Number: {
        // A bare number has the unit that stood there, which may be none (SI).
        std::string unit = unitOf(entryText(row.shown, typedAs(ParameterKind::Number, "")));
        if (unit.empty() && !row.isBare) unit = row.key.displayUnit;
        return asToml(entryText(text, typedAs(ParameterKind::Number, unit)));
    }
    case StudyKeyKind::List: return listAsToml(entryText(text, typedAs(ParameterKind::List, "")));
    case StudyKeyKind::Integer: return asToml(text.trimmed().toStdString());
    default: return tomlString(text.trimmed().toStdString());
    }
}

std::optional<std::pair<std::string, std::string>> StudyFormView::typed() const
{
    for (const Row& row : rows_)
        if (const auto* line = qobject_cast<QLineEdit*>(row.input);
            line && line->isModified() && line->text() != row.shown)
            return std::pair(std::string(row.key.key), valueIn(row));
    return std::nullopt;
}

void StudyFormView::mark(const std::vector<InputProblem>& problems, const std::string& name)
{
    for (Row& row : rows_) {
        const auto isHere = [&](const InputProblem& problem) {
            return problem.file == name && problem.key == row.key.key;
        };
        const auto found = std::ranges::find_if(problems, isHere);
        row.problem->setText(found == problems.end() ? QString() : sentence(found->message));
        row.problem->setVisible(found != problems.end());
    }
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
        setTextColour(row.help, colours.muted);
        setTextColour(row.problem, colours.failure);
    }
    if (lists_ != nullptr) setTextColour(lists_, colours.muted);
}

bool StudyFormView::eventFilter(QObject* watched, QEvent* event)
{
    // The wheel scrolls the form unless the input has the focus.
    if (event->type() == QEvent::Wheel && !qobject_cast<QWidget*>(watched)->hasFocus()) {
        event->ignore();
        return true;
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

void StudyFormView::commitTyped()
{
    for (const Row& row : rows_)
        if (qobject_cast<QLineEdit*>(row.input) != nullptr && row.input->hasFocus())
            return commit(std::string(row.key.key));
}

void StudyFormView::changeEvent(QEvent* event)
{
    QScrollArea::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) colour();
}

} // namespace touchdown

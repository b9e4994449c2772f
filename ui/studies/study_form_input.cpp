// SPDX-License-Identifier: GPL-3.0-or-later
//
// The inputs of the form: what they show of a study's text, and what they enter into it.
#include "ui/studies/study_form_view.h"

#include <algorithm>
#include <utility>

#include <QCheckBox>
#include <QComboBox>
#include <QCompleter>
#include <QLineEdit>
#include <QRegularExpression>

#include "core/case/parameters.h"
#include "core/case_files/case_file.h"
#include "core/formats/units.h"
#include "ui/case/parameter_text.h"
#include "ui/style/quantity_format.h"
#include "ui/style/readable.h"

namespace touchdown {

namespace {

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

QString choiceLabel(const StudyKey& key, const std::string& choice)
{
    const QString label = key.inList && leafOf(key.key) == "quantity" ? quantityLabel(choice) : QString();
    return label.isEmpty() ? QString::fromStdString(choice).replace(QLatin1Char('_'), QLatin1Char(' ')) : label;
}

} // namespace

QWidget* StudyFormView::makeInput(const StudyKey& key)
{
    const auto commitKey = [this, name = key.key] { commit(name); };
    if (key.kind == StudyKeyKind::Boolean) {
        auto* check = new QCheckBox;
        connect(check, &QCheckBox::clicked, this, commitKey);
        return check;
    }
    if (!key.choices.empty() || key.key == "case") {
        auto* choice = new QComboBox;
        choice->setFocusPolicy(Qt::StrongFocus);
        choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        choice->setMinimumContentsLength(8);
        for (const std::string& each : key.choices)
            choice->addItem(choiceLabel(key, each), QString::fromStdString(each));
        connect(choice, &QComboBox::activated, this, commitKey);
        return choice;
    }
    auto* line = new QLineEdit;
    if (takesCaseKey(key.key)) {
        QStringList labels;
        for (const auto& [label, caseKey] : numbers_) labels << label;
        auto* completer = new QCompleter(labels, line);
        completer->setFilterMode(Qt::MatchContains);
        completer->setCaseSensitivity(Qt::CaseInsensitive);
        line->setCompleter(completer);
        // After the line has taken the label.
        connect(completer, qOverload<const QString&>(&QCompleter::activated), this, commitKey, Qt::QueuedConnection);
    }
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
        const auto number = std::ranges::find(numbers_, text, [](const auto& each) { return each.second; });
        if (takesCaseKey(row.key.key) && number != numbers_.end()) row.shown = number->first;
        row.isBare = entry != nullptr && !std::holds_alternative<std::string>(entry->value);
        const bool beingTyped = line->hasFocus() && line->isModified();
        if (line->text() != row.shown && !beingTyped) {
            line->setText(row.shown);
            line->setCursorPosition(0);
        }
    }
}

void StudyFormView::showAllCompletions(QLineEdit* line)
{
    line->completer()->setCompletionPrefix({});
    line->completer()->complete();
}

void StudyFormView::fillCases(QComboBox* cases, const std::string& chosen, const QString& givenTitle)
{
    if (cases->count() == 0) {
        cases->addItem({}, QString());
        for (const SampleCase& each : sampleCases())
            cases->addItem(QString::fromStdString(titleOf(each)), QString::fromStdString(each.name));
    }
    cases->setItemText(0, tr("The case at the left: %1").arg(givenTitle));
    if (chosen.empty()) return cases->setCurrentIndex(0);
    const QString name = QString::fromStdString(chosen);
    if (cases->findData(name) < 0) cases->addItem(name, name); // a file
    cases->setCurrentIndex(cases->findData(name));
}

void StudyFormView::commit(const std::string& key)
{
    const auto found = std::ranges::find(rows_, key, [](const Row& each) { return each.key.key; });
    if (found == rows_.end()) return; // the form was built anew since
    Row& row = *found;
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

std::string StudyFormView::valueIn(const Row& row) const
{
    const QString text = qobject_cast<QLineEdit*>(row.input)->text();
    if (text.trimmed().isEmpty()) return {};
    switch (row.key.kind) {
    case StudyKeyKind::Number: {
        // A bare number has the unit that stood there, which may be none (SI).
        std::string unit = unitOf(entryText(row.shown, typedAs(ParameterKind::Number, "")));
        const bool isOther = !row.key.displayUnit.empty() && !row.problem->text().isEmpty(); // of another quantity
        if ((unit.empty() && !row.isBare) || isOther) unit = row.key.displayUnit;
        return asToml(entryText(text, typedAs(ParameterKind::Number, unit)));
    }
    case StudyKeyKind::List: return listAsToml(entryText(text, typedAs(ParameterKind::List, "")));
    case StudyKeyKind::Integer: return asToml(text.trimmed().toStdString());
    default: break;
    }
    const auto number = std::ranges::find_if(
        numbers_, [&text](const auto& each) { return each.first.compare(text.trimmed(), Qt::CaseInsensitive) == 0; });
    const bool isLabel = takesCaseKey(row.key.key) && number != numbers_.end();
    return tomlString(isLabel ? number->second : text.trimmed().toStdString());
}

std::optional<std::pair<std::string, std::string>> StudyFormView::typed() const
{
    for (const Row& row : rows_)
        if (const auto* line = qobject_cast<QLineEdit*>(row.input);
            line && line->isModified() && line->text() != row.shown)
            return std::pair(std::string(row.key.key), valueIn(row));
    return std::nullopt;
}

void StudyFormView::commitTyped()
{
    for (const Row& row : rows_)
        if (qobject_cast<QLineEdit*>(row.input) != nullptr && row.input->hasFocus())
            return commit(std::string(row.key.key));
}

} // namespace touchdown

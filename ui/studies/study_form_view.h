// SPDX-License-Identifier: GPL-3.0-or-later
//
// The keys of a study as fields with their help, and lists of tables, such as [[method]], as rows of fields. The
// study's text is the one source: the fields show its values, and an entry changes the text.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <QLabel>
#include <QScrollArea>

#include "core/formats/input_problem.h"
#include "core/studies/study/study_key.h"
#include "ui/studies/study_form_fields.h"

class QComboBox;
class QLineEdit;

namespace touchdown {

class StudyFormView : public QScrollArea {
    Q_OBJECT

public:
    explicit StudyFormView(QWidget* parent = nullptr);

    /// `form`: of the studied case `c`, as studyForm() makes it; `givenTitle`: of the case that is studied where the
    /// text names none.
    void show(const StudyForm& form, const TomlDocument& toml, const Case& c, const QString& givenTitle);
    /// Shows each problem of the text `name` at its field.
    void mark(const std::vector<InputProblem>& problems, const std::string& name);
    /// Takes what is typed in a line and was not confirmed yet.
    void commitTyped();
    /// What it would enter, key and value as in entered(); nothing where nothing is typed.
    std::optional<std::pair<std::string, std::string>> typed() const;
    /// nullptr if the key has no field: a QLineEdit, QCheckBox or QComboBox.
    QWidget* field(const std::string& key) const;
    /// The problem with the value of a key; "" if there is none.
    QString problemOf(const std::string& key) const;

signals:
    /// The value as TOML; empty: the key is to be left out.
    void entered(const QString& key, const QString& value);
    void typedChanged();
    /// A table [[list]] is to follow number `after`; number `number` is to be removed.
    void rowAdded(const QString& list, std::size_t after);
    void rowRemoved(const QString& list, std::size_t number);
    /// The rows that the study takes by itself are to be written.
    void defaultsWanted();
    void undoRequested();
    void redoRequested();

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Row {
        StudyKey key;
        QWidget* input = nullptr;
        QLabel *label = nullptr, *problem = nullptr;
        QLabel* help = nullptr; // of a key of the study itself
        QString shown{};        // text that was put into a line
        bool isBare = false;    // the text has a number without quotation marks, in SI
    };

    void build();
    Row& addRow(const StudyKey& key, const QString& name);
    static QLabel* makeProblem();
    QWidget* makeList(const FormList& list);
    QWidget* makeTable(const FormList& list, std::size_t number);
    QWidget* makeInput(const StudyKey& key);
    /// The list of all that may be chosen, below the line.
    static void showAllCompletions(QLineEdit* line);
    void fill(Row& row, const TomlDocument& toml, const QString& givenTitle);
    void fillCases(QComboBox* cases, const std::string& chosen, const QString& givenTitle);
    void commit(const std::string& key);
    /// Of the text in a line, as TOML.
    std::string valueIn(const Row& row) const;
    void colour();

    FormFields fields_;
    std::vector<std::pair<QString, std::string>> numbers_; // of the case: labels and keys
    std::vector<Row> rows_;
    std::vector<std::pair<std::string, QLabel*>> notes_; // problems of whole tables and lists
    std::string wanted_;                                 // the next form has the focus at the first key that begins so
    QLabel* lists_ = nullptr;                            // what only the text shows
};

} // namespace touchdown

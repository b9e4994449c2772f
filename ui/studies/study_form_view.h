// SPDX-License-Identifier: GPL-3.0-or-later
//
// The keys of a study as fields with their help. The study's text is the one source: the fields show its values, and
// an entry changes the text. Lists of tables, such as [[method]], are only counted.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <QLabel>
#include <QScrollArea>

#include "core/formats/input_problem.h"
#include "core/studies/study/study_key.h"

class QComboBox;
class QGridLayout;

namespace touchdown {

struct TomlDocument;

class StudyFormView : public QScrollArea {
    Q_OBJECT

public:
    explicit StudyFormView(QWidget* parent = nullptr);

    /// `keys` as studyForm() lists them; `givenTitle`: of the case that is studied where the text names none.
    void show(const std::vector<StudyKey>& keys, const TomlDocument& toml, const QString& givenTitle);
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
    void undoRequested();
    void redoRequested();

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Row {
        StudyKey key;
        QWidget* input = nullptr;
        QLabel *help = nullptr, *problem = nullptr;
        QString shown;       // text that was put into a line
        bool isBare = false; // the text has a number without quotation marks, in SI
    };

    void build(std::vector<StudyKey> keys);
    QWidget* makeInput(const StudyKey& key);
    void fill(Row& row, const TomlDocument& toml, const QString& givenTitle);
    void fillCases(QComboBox* cases, const std::string& chosen, const QString& givenTitle);
    void commit(const std::string& key);
    /// Of the text in a line, as TOML.
    static std::string valueIn(const Row& row);
    void colour();

    std::vector<StudyKey> keys_; // that have fields
    std::vector<Row> rows_;
    QLabel* lists_ = nullptr; // what only the text shows
};

} // namespace touchdown

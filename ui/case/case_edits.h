// SPDX-License-Identifier: GPL-3.0-or-later
//
// The case that is being edited: its values, the entries that could not be taken, and undo.
//
// An entry that cannot be read remains as it was typed and is part of the state: undo and redo treat it as any other
// edit.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <QUndoStack>

#include "core/case/parameters.h"

namespace touchdown {

/// Text typed for a parameter, and why it is not accepted.
struct BadEntry {
    QString text;
    QString reason;
};

class CaseEdits : public QObject {
    Q_OBJECT

public:
    explicit CaseEdits(QObject* parent = nullptr);

    /// Starts again from a case; undo does not go back beyond it.
    void open(const Case& opened);

    /// The case with which marks and resets compare is another one, and its values replace those that are edited: as
    /// one edit, which can be undone.
    void reopen(const Case& opened, const QString& text);

    const Case& value() const { return state_.value; }
    /// The case that marks and resets compare with.
    const Case& opened() const { return opened_; }
    QUndoStack& undoStack() { return undo_; }

    /// Takes what was typed, or keeps it with the reason why not.
    void enter(const Parameter& parameter, const QString& typed);
    /// Back to the value of the case from an entry that it could not take.
    void forgetEntry(const Parameter& parameter);
    /// Text that stands in the field of a parameter and is not entered yet.
    void setTyped(const Parameter& parameter, const QString& text);
    void reset(const Parameter& parameter);
    void resetAll();
    /// All values at once, as one edit. Edits in a row with the same `merge` other than 0 are one for undo.
    void setAll(const Case& value, const QString& text, int merge = 0);
    /// The surface alone; its kept distances and symmetries are solved.
    void setSurface(const AirBearingSurface& surface, const QString& text, int merge = 0);

    bool changed(const Parameter& parameter) const;
    /// Any value at all, also of rails, walls and points of interest.
    bool anyChanged() const;

    /// nullptr when the entry was taken.
    const BadEntry* badEntry(const Parameter& parameter) const;
    bool anyBadEntry() const { return !state_.bad.empty(); }
    /// By the key of the parameter.
    const std::map<std::string, BadEntry>& badEntries() const { return state_.bad; }
    /// What would be a change if it were entered, by the key of its parameter; at most one. An edit ends it.
    const std::map<std::string, QString>& typed() const { return typed_; }
    /// Problems of the accepted values; each names its keys.
    const std::vector<CaseProblem>& combinationProblems() const { return problems_; }
    const std::vector<CaseProblem>& warnings() const { return warnings_; }
    /// Why the case cannot be run, in a sentence; empty when it can.
    QString reasonNotToRun() const;

signals:
    void edited();
    void undoneOrRedone(); // after edited()
    void typedChanged();
    /// Another model was entered, and values that were defaults are those of the new model: "Contact Ono & Yamane →
    /// none".
    void modelFollowed(const QStringList& changes);
    /// A sentence about kept distances and symmetries that this edit of the shape has ended.
    void relationsEnded(const QString& sentence);

private:
    struct State {
        Case value;
        std::map<std::string, BadEntry> bad;
    };
    class Edit;

    void push(const QString& text, State after, int merge = 0);
    /// As `push`, of one parameter; with the model its defaults are taken.
    void pushChange(const Parameter& parameter, const QString& text, State after);
    void apply(const State& state);

    Case opened_;
    State state_;
    std::map<std::string, QString> typed_;
    std::vector<CaseProblem> problems_;
    std::vector<CaseProblem> warnings_;
    QUndoStack undo_;
};

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/case/case_edits.h"

#include <utility>

#include "core/case/model_defaults.h"
#include "core/physics/slider/surface_relations.h"
#include "ui/case/parameter_text.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

/// A case is small: a command keeps the whole state before and after.
class CaseEdits::Edit : public QUndoCommand {
public:
    Edit(CaseEdits& edits, const QString& text, State after, int merge)
        : QUndoCommand(text), edits_(edits), before_(edits.state_), after_(std::move(after)), merge_(merge)
    {}
    int id() const override { return merge_ == 0 ? -1 : merge_; }
    bool mergeWith(const QUndoCommand* next) override
    {
        after_ = static_cast<const Edit*>(next)->after_;
        return true;
    }
    void undo() override
    {
        edits_.apply(before_);
        emit edits_.undoneOrRedone();
    }
    void redo() override
    {
        edits_.apply(after_);
        if (std::exchange(done_, true)) emit edits_.undoneOrRedone();
    }

private:
    CaseEdits& edits_;
    State before_;
    State after_;
    int merge_;
    bool done_ = false; // once
};

CaseEdits::CaseEdits(QObject* parent) : QObject(parent) { apply(state_); }

void CaseEdits::open(const Case& opened)
{
    undo_.clear();
    opened_ = opened;
    apply({opened, {}});
}

void CaseEdits::reopen(const Case& opened, const QString& text)
{
    opened_ = opened;
    push(text, {opened, {}});
}

void CaseEdits::enter(const Parameter& parameter, const QString& typed)
{
    const BadEntry* bad = badEntry(parameter);
    if (bad ? typed == bad->text : typed == editorText(state_.value, parameter)) return;

    State after = state_;
    after.bad.erase(parameter.key);
    const std::optional<std::string> reason = setFromText(after.value, parameter, entryText(typed, parameter));
    if (reason) after.bad[parameter.key] = {typed, sentence(*reason)};
    // The same number written in another way is no edit, but the editor shows it in its own way again.
    if (!reason && !bad && parameter.get(after.value) == parameter.get(state_.value)) {
        emit edited();
        return;
    }
    pushChange(parameter, tr("change %1").arg(QString::fromStdString(parameter.label)), std::move(after));
}

void CaseEdits::forgetEntry(const Parameter& parameter)
{
    State after = state_;
    if (after.bad.erase(parameter.key) == 0) return;
    pushChange(parameter, tr("change %1").arg(QString::fromStdString(parameter.label)), std::move(after));
}

void CaseEdits::setTyped(const Parameter& parameter, const QString& text)
{
    Case entered = state_.value;
    const bool read = !setFromText(entered, parameter, entryText(text, parameter));
    std::map<std::string, QString> now;
    if (read && (badEntry(parameter) || entered != state_.value)) now[parameter.key] = text;
    if (std::exchange(typed_, now) != now) emit typedChanged();
}

void CaseEdits::reset(const Parameter& parameter)
{
    State after = state_;
    after.bad.erase(parameter.key);
    parameter.set(after.value, parameter.get(opened_));
    pushChange(parameter, tr("reset %1").arg(QString::fromStdString(parameter.label)), std::move(after));
}

void CaseEdits::resetAll()
{
    if (anyChanged()) push(tr("reset all parameters"), {opened_, {}});
}

void CaseEdits::setAll(const Case& value, const QString& text, int merge) { push(text, {value, {}}, merge); }

void CaseEdits::setSurface(const AirBearingSurface& surface, const QString& text, int merge)
{
    State after = state_;
    after.value.surface = keepingRelations(state_.value.surface, surface, state_.value.slider.width);
    const auto count = [](const AirBearingSurface& each) { return each.distances.size() + each.symmetries.size(); };
    const std::size_t before = count(state_.value.surface), now = count(after.value.surface);
    push(text, std::move(after), merge);
    if (now < before)
        emit relationsEnded(before - now == 1
                                ? tr("A kept distance or symmetry ended with this edit. Undo brings it back.")
                                : tr("%1 kept distances and symmetries ended with this edit. Undo brings "
                                     "them back.")
                                      .arg(before - now));
}

bool CaseEdits::changed(const Parameter& parameter) const
{
    return badEntry(parameter) != nullptr || parameter.get(state_.value) != parameter.get(opened_);
}

bool CaseEdits::anyChanged() const { return anyBadEntry() || state_.value != opened_; }

const BadEntry* CaseEdits::badEntry(const Parameter& parameter) const
{
    const auto found = state_.bad.find(parameter.key);
    return found == state_.bad.end() ? nullptr : &found->second;
}

QString CaseEdits::reasonNotToRun() const
{
    const auto named = [](const Parameter& parameter, const QString& reason) {
        return tr("%1: %2").arg(sentence(parameter.label).chopped(1), reason);
    };
    for (const Parameter& parameter : parameters())
        if (const BadEntry* bad = badEntry(parameter); bad && parameter.used(state_.value))
            return named(parameter, bad->reason);
    if (problems_.empty()) return {};
    const CaseProblem& problem = problems_.front();
    const Parameter* parameter = findParameter(problem.key);
    return parameter ? named(*parameter, sentence(problem.message)) : sentence(problem.message);
}

void CaseEdits::push(const QString& text, State after, int merge)
{
    undo_.push(new Edit(*this, text, std::move(after), merge));
}

void CaseEdits::pushChange(const Parameter& parameter, const QString& text, State after)
{
    const Case entered = after.value;
    const auto stated = [&after](const Parameter& other) { return after.bad.contains(other.key); };
    const bool newModel = parameter.key == "model";
    const bool defaults = newModel && takeModelDefaults(after.value, state_.value.model, stated);
    const bool start = newModel && takeFilmStart(after.value);
    const bool followed =
        defaults || start || (parameter.key == "disk.surface.kind" && takeFirstUnevenness(after.value));
    const QStringList changes = followed ? caseDifference(entered, after.value) : QStringList();
    push(text, std::move(after));
    if (followed) emit modelFollowed(changes);
}

void CaseEdits::apply(const State& state)
{
    state_ = state;
    typed_.clear();
    problems_ = checkCombinations(state_.value);
    warnings_ = caseWarnings(state_.value);
    emit edited();
}

} // namespace touchdown

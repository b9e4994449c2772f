// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/solutions_model.h"

#include <algorithm>
#include <utility>

#include <QRegularExpression>

#include "ui/case/parameter_text.h"
#include "ui/slider/attitude_sections.h"
#include "ui/style/quantity_format.h"
#include "ui/style/readable.h"

namespace touchdown {

namespace {

std::size_t fieldSize(const SteadyResult& state)
{
    return state.pressure.size() + state.gap.size() + state.recess.size();
}

constexpr qsizetype mostChanges = 3; // in a name

/// "rail 2, corner 2: +3.1, 0 µm" of "rail 2, corner 2 moved by 3.1, 0 µm": a name that is cut loses its end first.
QString shiftFirst(const QString& change)
{
    const QString verb = QStringLiteral(" moved by ");
    const qsizetype at = change.indexOf(verb);
    if (at < 0) return change;
    QString shift = change.mid(at + verb.size());
    static const QRegularExpression positive(QStringLiteral("(?:(?<=^)|(?<=[,;] ))(?=[1-9]|0[.,][0-9])"));
    shift.replace(positive, QStringLiteral("+"));
    return QStringLiteral("%1: %2").arg(change.left(at), shift);
}

} // namespace

int SolutionsModel::add(const Case& solved, const SteadyResult& result, const QString& file, bool shown, int place,
                        const std::optional<FileIdentity>& identity, int number)
{
    auto record = std::make_unique<SolutionRecord>();
    record->number = number > 0 ? number : nextNumber();
    record->name = nameOf(solved);
    record->value = solved;
    record->file = file;
    record->identity = identity;
    record->place = place;
    record->result = result;
    record->shown = record->comparedByItself = shown;
    if (shown) uncheckOldest(mostByItself - 1);
    const int added = addRecord(std::move(record)).number;
    dropFields();
    return added;
}

/// Of the boxes that nobody touched, all but the newest `kept`; the first solution, from which an edit began, stays.
void SolutionsModel::uncheckOldest(int kept, int besides)
{
    for (int row = count() - 1; row > 0; --row) {
        const SolutionRecord& each = record(row);
        if (each.shown && each.comparedByItself && each.number != baseline() && each.number != besides && --kept < 0)
            RecordList::setData(index(row), Qt::Unchecked, Qt::CheckStateRole);
    }
}

void SolutionsModel::compareByItself(int number)
{
    const int row = rowOf(number);
    if (row < 0 || record(row).shown || !record(row).comparedByItself) return;
    uncheckOldest(mostByItself - 1, number);
    RecordList::setData(index(row), Qt::Checked, Qt::CheckStateRole);
}

/// By what differs from the baseline, else from the case as it was opened, else from the first one; where that is too
/// much for a name, from the solution that it resembles most, which is named. What is new comes first.
QString SolutionsModel::nameOf(const Case& solved) const
{
    const QString title = readable(solved.title);
    std::vector<int> rows; // of this slider, the oldest first
    for (int row = 0; row < count(); ++row)
        if (listed(row).value.title == solved.title) rows.push_back(row);
    const auto base = std::ranges::find(rows, baseline(), [this](int row) { return listed(row).number; });
    const bool wasOpened = base == rows.end() && opened_ && opened_->title == solved.title;
    const int usual = wasOpened || rows.empty() ? -1 : base != rows.end() ? *base : rows.front();
    int from = usual; // -1: the case as it was opened
    const auto caseAt = [&](int row) -> const Case& { return row >= 0 ? listed(row).value : *opened_; };
    QStringList changes = from >= 0 || wasOpened ? caseDifference(caseAt(from), solved) : QStringList();
    const bool tooMuch = changes.size() > mostChanges;
    for (auto row = rows.rbegin(); row != rows.rend() && (!changes.isEmpty() || from < 0); ++row) {
        QStringList fewer = caseDifference(listed(*row).value, solved);
        if (!fewer.isEmpty() && (!tooMuch || fewer.size() >= changes.size())) continue;
        changes = std::move(fewer);
        from = *row;
    }
    if (changes.isEmpty() && from >= 0) return tr("as solution %1").arg(listed(from).number);
    if (changes.isEmpty()) { // as it was opened; another case may have had this title before
        const auto named = std::ranges::find(rows, title, [this](int row) { return listed(row).name; });
        if (named == rows.end()) return title;
        from = *named;
        changes = caseDifference(caseAt(from), solved);
    }
    if (!rows.empty()) {
        const QStringList before = caseDifference(caseAt(from), listed(rows.back()).value);
        std::ranges::stable_partition(changes, [&](const QString& change) { return !before.contains(change); });
    }
    std::ranges::transform(changes, changes.begin(), shiftFirst);
    if (changes.size() > mostChanges) {
        const qsizetype more = changes.size() - mostChanges;
        changes = changes.first(mostChanges) << tr("and %1 more").arg(more);
    }
    const QString text = changes.join(QStringLiteral(", "));
    if (rows.empty()) return QStringLiteral("%1: %2").arg(title, text);
    return from == usual ? text : tr("%1, from solution %2").arg(text, QString::number(listed(from).number));
}

bool SolutionsModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (role == Qt::CheckStateRole && index.isValid())
        static_cast<SolutionRecord&>(changeable(index.row())).comparedByItself = false;
    return RecordList::setData(index, value, role);
}

void SolutionsModel::dropFields()
{
    for (int row = 0; row + 1 < count(); ++row)
        if (record(row).result.gaps) static_cast<SolutionRecord&>(changeable(row)).result.gaps = nullptr;
    std::size_t held = 0;
    for (int row = 0; row < count(); ++row) held += fieldSize(record(row).result);
    for (const bool compared : {false, true}) // these last
        for (int row = 0; row + 1 < count() && held > fieldCapacity; ++row) {
            auto& each = static_cast<SolutionRecord&>(changeable(row));
            if (each.shown != compared || each.number == baseline() || each.fieldsDropped) continue;
            held -= fieldSize(each.result);
            each.result.dropFields();
            each.fieldsDropped = true;
        }
}

const SolutionRecord* SolutionsModel::find(int number) const
{
    const int row = rowOf(number);
    return row < 0 ? nullptr : &record(row);
}

const SolutionRecord* SolutionsModel::of(const Case& c) const
{
    for (int row = count() - 1; row >= 0; --row) {
        const SolutionRecord& each = record(row);
        if (each.result.status == SteadyStatus::Converged && !each.fieldsDropped &&
            hasStaticState(c, each.value, each.result.attitude))
            return &each;
    }
    return nullptr;
}

std::shared_ptr<const StaticSolution> SolutionsModel::restOf(const Case& c) const
{
    for (int row = count() - 1; row >= 0; --row) {
        const SolutionRecord& each = record(row);
        if (isRestOf(c, each.value, each.result))
            return std::make_shared<const StaticSolution>(StaticSolution{each.value, each.result});
    }
    return nullptr;
}

const SolutionRecord* SolutionsModel::failureOf(const Case& c) const
{
    for (int row = count() - 1; row >= 0; --row) {
        const SolutionRecord& each = record(row);
        // From another start a search may find a state, also from where this one gave up.
        if (failed(row) && !each.fieldsDropped && sameFilm(c, withRunOf(each.value, c))) return &each;
    }
    return nullptr;
}

std::vector<const SolutionRecord*> SolutionsModel::compared() const
{
    std::vector<const SolutionRecord*> list;
    for (int row = 0; row < count(); ++row)
        if (listed(row).shown || listed(row).number == baseline()) list.push_back(&record(row));
    return list;
}

QString SolutionsModel::changes(int row) const
{
    const SolutionRecord& each = record(row);
    const SteadyResult& state = each.result;
    const QString pitch = withError(state.attitude.pitch, state.discretisationError.pitch, "urad");
    const QString roll = withError(state.attitude.roll, state.discretisationError.roll, "urad");
    if (!notFoundText(state).isEmpty()) return tr("last step: pitch %1, roll %2").arg(pitch, roll);
    return each.value.steady.fixedAttitude ? tr("at a given attitude, pitch %1, roll %2").arg(pitch, roll)
                                           : tr("pitch %1, roll %2").arg(pitch, roll);
}

QString SolutionsModel::result(int row) const
{
    const SteadyResult& state = record(row).result;
    if (state.status != SteadyStatus::Converged) return statusText(touchdown::name(state.status));
    return roundedToError(state.minimumSpacing, state.discretisationError.minimumSpacing, "nm");
}

bool SolutionsModel::failed(int row) const
{
    const SteadyStatus status = record(row).result.status;
    return status == SteadyStatus::Failed || status == SteadyStatus::NotConverged;
}

QStringList SolutionsModel::details(int row) const
{
    const SolutionRecord& each = record(row);
    QStringList lines{steadyText(each.result),
                      tr("%1 × %2 cells").arg(each.result.grid.nx()).arg(each.result.grid.ny())};
    if (each.fieldsDropped) lines << tr("Its fields were given up to save memory; its numbers are here.");
    return lines;
}

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
//
// The static solutions of this session, newest last, each named by what differs from the case as it was
// opened, or from another solution.
#pragma once

#include <memory>
#include <optional>

#include "core/simulation/static_state/static_solution.h"
#include "ui/lists/record_list.h"

namespace touchdown {

struct SolutionRecord : ListedRecord {
    SteadyResult result;
    bool fieldsDropped = false;   // see SolutionsModel::fieldCapacity
    bool comparedByItself = true; // nobody checked or unchecked its box
};

class SolutionsModel : public RecordList {
    Q_OBJECT

public:
    using RecordList::RecordList;

    /// Values of all fields of all solutions: 256 MB. Beyond it the oldest ones lose their
    /// fields, not their numbers: first those that are not compared. The newest alone keeps its gaps.
    static constexpr std::size_t fieldCapacity = std::size_t(1) << 25;

    /// The case as it was opened: what is solved next is named by what differs from it.
    void setOpened(const Case& opened) { opened_ = opened; }
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    /// A solution with a field; `shown`: its box is checked, and the list chooses it. Returns its number.
    /// `number`: one that was kept free; 0: the next one.
    int add(const Case& solved, const SteadyResult& result, const QString& file = {}, bool shown = true, int place = 0,
            const std::optional<FileIdentity>& identity = {}, int number = 0);

    const SolutionRecord& record(int row) const { return static_cast<const SolutionRecord&>(listed(row)); }
    const SolutionRecord* find(int number) const; // nullptr: it is gone
    /// The newest that converged, with its fields, and is the static state of `c`; nullptr: none.
    const SolutionRecord* of(const Case& c) const;
    /// That state for a run of `c`, if its attitude was not given; null: none.
    std::shared_ptr<const StaticSolution> restOf(const Case& c) const;
    /// The newest search for the state of `c` that found none; nullptr: there was none.
    const SolutionRecord* failureOf(const Case& c) const;
    /// Checks its box, unless the user has unchecked it. Of boxes that nobody touched the newest ones and the first one
    /// stay checked.
    void compareByItself(int number);
    static constexpr int mostByItself = 3; // beside the baseline and the first one
    /// Those whose box is checked, and the baseline, in their order.
    std::vector<const SolutionRecord*> compared() const;

protected:
    QString changes(int row) const override;
    QString result(int row) const override;
    bool failed(int row) const override;
    QStringList details(int row) const override;
    QString kind() const override { return tr("Solution"); }

private:
    QString nameOf(const Case& solved) const;
    void dropFields();
    std::optional<Case> opened_;
    void uncheckOldest(int kept, int besides = -1);
};

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/film/shape_panel.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <QHBoxLayout>
#include <QHeaderView>
#include <QSignalBlocker>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include "core/case/case_key.h"
#include "ui/case/parameter_text.h"
#include "ui/film/part_tree.h"
#include "ui/film/relation_rows.h"
#include "ui/slider/wall_picture.h"
#include "ui/style/foreign_text.h"
#include "ui/style/quantity_format.h"
#include "ui/style/theme.h"

namespace touchdown {

namespace {

std::string wallKey(std::size_t wall) { return "abs.wall[" + std::to_string(wall + 1) + "]"; }

/// "rail 3, corner 2, x" of "abs.rail[3].point[2].x".
std::string words(const Parameter& parameter)
{
    std::string text;
    for (const char letter : parameter.label) switch (letter) {
        case '[':
        case '_': text += ' '; break;
        case ']': break;
        case '.': text += ", "; break;
        default: text += letter;
        }
    // As in the plan and the table; points are those of walls and of interest.
    constexpr std::string_view point = ", point ";
    if (const auto at = text.find(point); at != std::string::npos && text.starts_with("rail"))
        text.replace(at, point.size(), ", corner ");
    return text;
}

/// Shows a number of many digits, as an edge's move makes it, with seven; the editor has all of them.
class RoundingDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    QString displayText(const QVariant& value, const QLocale&) const override
    {
        const QString text = value.toString();
        QLocale locale;
        locale.setNumberOptions(QLocale::OmitGroupSeparator);
        bool isNumber = false;
        const double number = locale.toDouble(text, &isNumber);
        return isNumber && text.size() > 9 ? locale.toString(number, 'g', 7) : text;
    }
};

} // namespace

ShapePanel::ShapePanel(QWidget* parent)
    : QWidget(parent),
      parts_(new QSplitter(Qt::Vertical, this)),
      lower_(new QWidget(this)),
      numbers_(new QBoxLayout(QBoxLayout::TopToBottom)),
      list_(new PartTree(this)),
      table_(new QTableWidget(this)),
      caption_(new QLabel(this)),
      problem_(new QLabel(this)),
      profile_(new WallPicture(this))
{
    buildList();
    list_->installEventFilter(this);
    table_->installEventFilter(this);
    table_->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(table_, &QWidget::customContextMenuRequested, this, &ShapePanel::onTableMenu);
    caption_->setContentsMargins(4, 4, 4, 0);
    caption_->setWordWrap(true);
    caption_->setBuddy(table_);
    problem_->setWordWrap(true);
    problem_->hide();
    table_->setAccessibleName(tr("Numbers of the chosen part"));
    table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 8);
    table_->setSelectionBehavior(QAbstractItemView::SelectItems);
    table_->setTabKeyNavigation(false);
    table_->setMinimumWidth(120);
    table_->setItemDelegate(new RoundingDelegate(table_));

    const auto button = [this](const QString& text, const QString& tip, auto perform) {
        auto* made = new QToolButton(this);
        made->setText(text);
        made->setToolTip(plainTip(tip));
        made->setAccessibleName(tip);
        made->setFocusPolicy(Qt::StrongFocus);
        connect(made, &QToolButton::clicked, this, perform);
        return made;
    };
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(button(tr("+ Rail"), tr("Add a rectangular rail in the middle"), [this] { addRail(); }));
    buttons->addWidget(corner_ = button(tr("+ Corner"), tr("Insert a corner after the chosen one"),
                                        [this] { chosen_.kind == Kind::Wall ? addWallPoint() : addCorner(); }));
    buttons->addWidget(button(tr("+ Wall"), tr("Add a wall profile"), [this] { addWall(); }));
    buttons->addWidget(button(tr("+ Point"), tr("Add a point of interest"), [this] { addInterest(); }));
    buttons->addStretch(1);
    auto* verbs = new QHBoxLayout;
    verbs->addWidget(forward_ = button(QStringLiteral("↓"), tr("Forward, over the next rail of the list"),
                                       [this] { moveChosen(1); }));
    verbs->addWidget(
        backward_ = button(QStringLiteral("↑"), tr("Backward, under the rail before"), [this] { moveChosen(-1); }));
    buildWallMenu();
    verbs->addWidget(wall_);
    verbs->addWidget(remove_ = button(tr("Delete"), tr("Delete the chosen part"), [this] { removeChosen(); }));
    verbs->addStretch(1);

    auto* upper = new QWidget(this);
    auto* upperLayout = new QVBoxLayout(upper);
    upperLayout->setContentsMargins(0, 0, 0, 0);
    upperLayout->addWidget(list_, 1);
    upperLayout->addLayout(buttons);
    upperLayout->addLayout(verbs);
    upperLayout->setSpacing(2);
    auto* lowerLayout = new QVBoxLayout(lower_);
    lowerLayout->setContentsMargins(0, 0, 0, 0);
    lowerLayout->addWidget(caption_);
    numbers_->addWidget(table_, 3);
    numbers_->addWidget(profile_, 2);
    lowerLayout->addLayout(numbers_, 1);
    lowerLayout->addWidget(problem_);
    parts_->addWidget(upper);
    parts_->addWidget(lower_);
    parts_->setChildrenCollapsible(false);
    parts_->setStretchFactor(0, 2);
    parts_->setStretchFactor(1, 3);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 0, 4, 4);
    layout->addWidget(parts_);

    connect(list_, &QTreeWidget::itemSelectionChanged, this, &ShapePanel::onListSelected);
    connect(list_, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item, int column) {
        if (!filling_) take(item->data(column, keyRole).toString().toStdString(), item->text(column));
    });
    connect(table_, &QTableWidget::itemChanged, this, [this](QTableWidgetItem* item) {
        if (!filling_) take(item->data(keyRole).toString().toStdString(), item->text());
    });
    connect(table_, &QTableWidget::itemSelectionChanged, this, &ShapePanel::onTableSelected);
    connect(profile_, &WallPicture::edited, this, &ShapePanel::onWallEdited);
    connect(profile_, &WallPicture::pointChosen, this, [this](int point) {
        ++rowOfMoves_;
        if (chosen_.kind == Kind::Wall) table_->setCurrentCell(point, std::max(0, table_->currentColumn()));
    });
}

void ShapePanel::setCase(const Case& c)
{
    const AirBearingSurface before = std::exchange(case_, c).surface;
    const bool filled = rails_->childCount() > 0;
    if (filled && c.surface == before) return;
    say({});
    if (!filled || !sameRows(c.surface, before)) fillList();
    fillTable();
}

void ShapePanel::preview(const AirBearingSurface& surface)
{
    Case passing = case_;
    passing.surface = surface;
    setCase(passing);
}

void ShapePanel::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    const bool narrow = width() < 2 * height();
    parts_->setOrientation(narrow ? Qt::Vertical : Qt::Horizontal);
    numbers_->setDirection(narrow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

void ShapePanel::onTableSelected()
{
    if (!filling_ && chosen_.kind == Kind::Wall && table_->currentRow() >= 0)
        profile_->setPoint(static_cast<std::size_t>(table_->currentRow()));
    if (filling_ || chosen_.kind != Kind::Rail) return;
    PartSelection parts;
    for (const QTableWidgetItem* item : table_->selectedItems())
        parts.insert({PartKind::Corner, chosen_.item, static_cast<std::size_t>(item->row())});
    if (parts.empty() || parts == selection_) return;
    selection_ = parts;
    emit selected(parts);
}

void ShapePanel::setHeaders(const QStringList& headers)
{
    table_->setColumnCount(static_cast<int>(headers.size()));
    QStringList lines;
    for (QString head : headers) lines << head.replace(QStringLiteral(" ["), QStringLiteral("\n["));
    table_->setHorizontalHeaderLabels(lines);
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
}

void ShapePanel::setCell(int row, int column, const QString& text, const std::string& key)
{
    auto* item = new QTableWidgetItem(text);
    item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    item->setData(keyRole, QString::fromStdString(key));
    if (key.empty()) item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
    table_->setItem(row, column, item);
}

void ShapePanel::setNumber(int row, int column, const std::string& key)
{
    const auto found = caseKey(case_, key);
    if (const auto* parameter = std::get_if<Parameter>(&found))
        setCell(row, column, editorText(case_, *parameter), key);
    else
        setCell(row, column, {});
}

void ShapePanel::fillTable()
{
    filling_ = true;
    const QSignalBlocker silent(table_);
    const AirBearingSurface& surface = case_.surface;
    // The keyboard stays where it was.
    const int row = table_->currentRow(), column = table_->currentColumn();
    table_->clearContents();
    table_->setRowCount(0);
    profile_->setVisible(chosen_.kind == Kind::Wall);
    lower_->setVisible(chosen_.kind != Kind::None);
    switch (chosen_.kind) {
    case Kind::Rail:
        caption_->setText(tr("Corners of rail %1").arg(chosen_.item + 1));
        fillRail(surface.rails[chosen_.item], "abs.rail[" + std::to_string(chosen_.item + 1) + "]");
        break;
    case Kind::Wall:
        caption_->setText(tr("Profile of wall %1: recess against the distance from the edge").arg(chosen_.item + 1));
        fillWall(surface.walls[chosen_.item], wallKey(chosen_.item));
        profile_->setWall(surface.walls[chosen_.item]);
        break;
    case Kind::Interest: {
        caption_->setText(tr("Point of interest %1").arg(chosen_.item + 1));
        setHeaders({tr("x [mm]"), tr("y [mm]")});
        table_->setRowCount(1);
        const std::string key = "abs.points_of_interest[" + std::to_string(chosen_.item + 1) + "]";
        setNumber(0, 0, key + ".x");
        setNumber(0, 1, key + ".y");
        break;
    }
    case Kind::Relation: {
        const std::string key = relationKey(surface, chosen_.item);
        caption_->setText(relationCaption(case_, chosen_.item));
        setHeaders(key.empty() ? QStringList() : QStringList{tr("distance [µm]")});
        table_->setRowCount(key.empty() ? 0 : 1);
        if (!key.empty()) setNumber(0, 0, key);
        break;
    }
    case Kind::None: setHeaders({}); break;
    }
    if (row >= 0 && row < table_->rowCount() && column < table_->columnCount())
        table_->setCurrentCell(row, column, QItemSelectionModel::NoUpdate);
    if (chosen_.kind == Kind::Rail)
        for (const SurfacePart& part : selection_)
            if (part.kind == PartKind::Corner && part.item == chosen_.item)
                if (const int corner = static_cast<int>(part.index); corner < table_->rowCount())
                    table_->item(corner, corner == table_->currentRow() ? table_->currentColumn() : 0)
                        ->setSelected(true);
    filling_ = false;
}

void ShapePanel::fillRail(const Rail& rail, const std::string& key)
{
    const bool ramp = rail.kind == RailKind::Ramp;
    QStringList headers{tr("x [mm]"), tr("y [mm]"), tr("wall"), tr("edge [µm]"), tr("angle [°]")};
    if (ramp) headers << tr("recess [µm]");
    setHeaders(headers);
    table_->setRowCount(static_cast<int>(rail.points.size()));
    for (std::size_t k = 0; k < rail.points.size(); ++k) {
        const int row = static_cast<int>(k);
        const std::string index = "[" + std::to_string(k + 1) + "]";
        setNumber(row, 0, key + ".point" + index + ".x");
        setNumber(row, 1, key + ".point" + index + ".y");
        setNumber(row, 2, key + ".wall" + index);
        const RailPoint &a = rail.points[k], &b = rail.points[(k + 1) % rail.points.size()];
        setCell(row, 3, typeset(std::hypot(b.x - a.x, b.y - a.y) * 1e6, 2));
        setCell(row, 4, typeset(std::atan2(b.y - a.y, b.x - a.x) * 180.0 / std::numbers::pi, 1));
        if (ramp) setNumber(row, 5, key + ".recess" + index);
    }
}

void ShapePanel::fillWall(const WallProfile& wall, const std::string& key)
{
    setHeaders({tr("distance [µm]"), tr("recess [µm]")});
    table_->setRowCount(static_cast<int>(wall.distance.size()));
    for (std::size_t k = 0; k < wall.distance.size(); ++k) {
        const std::string index = "[" + std::to_string(k + 1) + "]";
        setNumber(static_cast<int>(k), 0, key + ".distance" + index);
        setNumber(static_cast<int>(k), 1, key + ".recess" + index);
    }
}

std::string ShapePanel::keyAt(int row, int column) const
{
    const QTableWidgetItem* item = table_->item(row, column);
    return item ? item->data(keyRole).toString().toStdString() : std::string();
}

void ShapePanel::say(const QString& problem)
{
    setTextColour(problem_, meaningColours(palette()).failure);
    problem_->setText(problem);
    problem_->setVisible(!problem.isEmpty());
}

void ShapePanel::take(const std::string& key, const QString& typed)
{
    Case changed = case_;
    QString what;
    const std::vector<std::string> keys = chosenWith(key);
    for (const std::string& each : keys) {
        const auto found = caseKey(case_, each);
        const auto* parameter = std::get_if<Parameter>(&found);
        if (parameter == nullptr) return;
        if (what.isEmpty()) what = QString::fromStdString(words(*parameter));
        if (const auto reason = setFromText(changed, *parameter, entryText(typed, *parameter))) {
            say(tr("%1: %2").arg(sentence(words(*parameter)).chopped(1), sentence(*reason)));
            fillList(); // as it was
            fillTable();
            return;
        }
    }
    say({});
    if (changed.surface == case_.surface) {
        fillList();
        fillTable();
        return;
    }
    emit edited(
        changed.surface,
        keys.size() > 1 ? tr("change %1 and %2 more").arg(what).arg(keys.size() - 1) : tr("change %1").arg(what), 0);
}

std::vector<std::string> ShapePanel::chosenWith(const std::string& key) const
{
    std::vector<std::string> keys{key};
    std::set<std::string> chosen;
    for (const SurfacePart& part : selection_) {
        const std::string rail = "abs.rail[" + std::to_string(part.item + 1) + "].";
        if (part.kind == PartKind::Rail) chosen.insert(rail + "recess");
        if (part.kind == PartKind::Corner) chosen.insert(rail + "wall[" + std::to_string(part.index + 1) + "]");
    }
    if (!chosen.contains(key)) return keys;
    chosen.erase(key);
    keys.insert(keys.end(), chosen.begin(), chosen.end());
    return keys;
}

void ShapePanel::updateButtons()
{
    const bool wall = chosen_.kind == Kind::Wall;
    corner_->setEnabled(wall || chosen_.kind == Kind::Rail);
    corner_->setText(wall ? tr("+ Row") : tr("+ Corner"));
    corner_->setToolTip(plainTip(wall ? tr("Add a point to the wall after the chosen one (Insert)")
                                      : tr("Insert a corner after the chosen one (Insert)")));
    wall_->setEnabled(chosen_.kind == Kind::Rail);
    remove_->setEnabled(chosen_.kind == Kind::Wall || !selection_.empty());
    const std::size_t count = case_.surface.rails.size();
    forward_->setEnabled(chosen_.kind == Kind::Rail && chosen_.item + 1 < count);
    backward_->setEnabled(chosen_.kind == Kind::Rail && chosen_.item > 0);
}

} // namespace touchdown

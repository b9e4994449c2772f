// SPDX-License-Identifier: GPL-3.0-or-later
//
// The air bearing surface as a list and a table beside its plan: rails with their recess, walls, points of interest,
// relations, and the numbers of the chosen one, each typed as a parameter is (core/case/case_key.h). The last rail of
// the list lies on top; rails are dragged to another place. Keys: Del removes what is chosen, Insert adds a corner or a
// point of a wall after the chosen row, the menu key has more.
#pragma once

#include <string>
#include <vector>

#include <QBoxLayout>
#include <QLabel>
#include <QSplitter>
#include <QTableWidget>
#include <QToolButton>
#include <QTreeWidget>
#include <QWidget>

#include "core/case/case.h"
#include "core/physics/slider/surface_edit.h"

namespace touchdown {

class PartTree;
class WallPicture;

class ShapePanel : public QWidget {
    Q_OBJECT

public:
    explicit ShapePanel(QWidget* parent = nullptr);

    void setCase(const Case& c);
    /// The numbers of a surface that is dragged; the case with it, or the one before, follows.
    void preview(const AirBearingSurface& surface);
    /// Shows and marks these parts; emits nothing.
    void setSelection(const PartSelection& parts);

    /// The keyboard goes to the table, at the chosen corner or edge; or to the recess of the chosen rail.
    void typeCoordinates();
    void typeRecess();
    void showWall(std::size_t wall);

    /// "abs.rail[3].point[2].x" of a cell of the table; empty where it cannot be changed.
    std::string keyAt(int row, int column) const;

signals:
    void selected(const touchdown::PartSelection& parts);
    void edited(const touchdown::AirBearingSurface& surface, const QString& text, int merge);
    /// The menu for what is selected, at a place of the screen.
    void menuWanted(const QPoint& globalPos);

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    static constexpr int keyRole = Qt::UserRole, kindRole = Qt::UserRole + 1; // of items
    enum class Kind { None, Rail, Wall, Interest, Relation };
    struct Chosen {
        Kind kind = Kind::None;
        std::size_t item = 0;
        bool operator==(const Chosen&) const = default;
    };

    void buildList();
    void buildWallMenu();
    void onListMenu(const QPoint& at);
    void onTableMenu(const QPoint& at);
    void onReordered(int from, int to);
    PartSelection chosenEdges() const;
    void chooseWall(int wall);
    void addWallPoint();
    void removeTableRows();
    void onWallEdited(const WallProfile& wall, bool row);
    void fillList();
    void fillTable();
    void fillRail(const Rail& rail, const std::string& key);
    void fillWall(const WallProfile& wall, const std::string& key);
    void onListSelected();
    void onTableSelected();
    void take(const std::string& key, const QString& typed);
    /// The other parts that are chosen with this one get the same recess or wall: their keys, this one's first.
    std::vector<std::string> chosenWith(const std::string& key) const;
    void addRail();
    void addCorner();
    void addWall();
    void addInterest();
    void removeChosen();
    void moveChosen(int places);
    void setHeaders(const QStringList& headers);
    void setCell(int row, int column, const QString& text, const std::string& key = {});
    void setNumber(int row, int column, const std::string& key);
    void say(const QString& problem);
    Chosen chosenOf(const QTreeWidgetItem* item) const;
    void updateButtons();

    Case case_;
    Chosen chosen_;
    PartSelection selection_;
    bool filling_ = false;
    QSplitter* parts_;    // list and numbers, below each other in a narrow place
    QWidget* lower_;      // what belongs to the chosen part
    QBoxLayout* numbers_; // table and profile of a wall, likewise
    PartTree* list_;
    QTreeWidgetItem *rails_ = nullptr, *walls_ = nullptr, *interests_ = nullptr, *relations_ = nullptr;
    QTableWidget* table_;
    QLabel* caption_;
    QLabel* problem_;
    WallPicture* profile_;
    QToolButton *corner_ = nullptr, *remove_ = nullptr, *forward_ = nullptr, *backward_ = nullptr;
    QToolButton* wall_ = nullptr; // of the chosen edges
    int rowOfMoves_ = 0;          // number of the row of moves of a wall's point
};

} // namespace touchdown

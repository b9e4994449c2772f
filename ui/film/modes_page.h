// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page of the air bearing modes about the static state: a table, and the selected mode as an animation.
#pragma once

#include <optional>

#include <QSlider>

#include "ui/calculation/result_page.h"
#include "ui/film/modes_controller.h"
#include "ui/film/modes_text.h"

namespace touchdown {

class ModePicture;

class ModesPage : public ResultPage {
    Q_OBJECT

public:
    explicit ModesPage(ModesController::Solver solver = modes, QWidget* parent = nullptr);

    /// The case as it is edited.
    void setCase(const Case& c);
    /// Another case was opened: its modes are not known.
    void clear();

    ModesController& controller() { return controller_; }
    ModePicture* picture() const { return picture_; }
    bool stale() const override;
    /// The modes that are known; nothing where there are none.
    std::optional<FoundModes> known() const;
    /// Modes of another window.
    void restore(const FoundModes& modes);
    /// Whether there are modes that no file has.
    bool unsaved() const { return known().has_value() && !saved(); }
    QByteArray csv() const override { return csvOf(*result_); }

signals:
    /// Modes were found, or none, for this case.
    void found(const touchdown::Case& solved, const touchdown::ModesResult& result);

public slots:
    void startOrStop() override;

protected:
    Notes notes() const override;
    void changeEvent(QEvent* event) override;

private:
    QWidget* buildPicture();
    void onFinished(const ModesResult& result);
    void take(const Case& c, const ModesResult& result);
    TableRow rowOf(std::size_t mode) const;
    void showMode(int row);
    void showSpeed();
    void showPlaying();

    ModesController controller_;
    ModePicture* picture_;
    QToolButton* play_;
    QSlider* speed_;
    QLabel* cycle_;
    Case case_, asked_, solved_;
    QString refusal_; // why the last search did not start
    std::optional<ModesResult> result_;
};

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
//
// A figure for a paper from the pictures of a page: what it shows, its size and its font, beside a preview. What was
// chosen is kept for each case and page, and a case without a choice begins with the latest.
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QFontComboBox>
#include <QLabel>
#include <QListWidget>
#include <QPointer>
#include <QPushButton>
#include <QSpinBox>

#include <vector>

#include "ui/plot/paper_figure.h"

namespace touchdown {

class FigureDialog : public QDialog {
    Q_OBJECT

public:
    /// `key` names the case and the page; `name` is that of a file, "fig10a". The page must outlive the dialog.
    FigureDialog(QWidget& page, const QString& key, const QString& name, QWidget* parent);

    /// With the chosen panels.
    PaperFigure figure() const;
    FigureFormat format() const;
    void setFormat(const FigureFormat& format);

    QListWidget* panels() const { return panels_; }
    QLabel* preview() const { return preview_; }
    QString remark() const { return remark_->text(); }
    QPushButton* exportButton() const { return export_; }
    /// Writes it and keeps the settings; shows where it is, or the problem.
    void exportTo(const QString& path);

    void done(int result) override;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void buildPanels(QWidget& page);
    QWidget* buildForm();
    void restore();
    void keep() const;
    void changed();
    void showPreview();
    void chooseFile();

    QString key_, name_;
    std::vector<QPointer<QWidget>> parts_; // of the entries, which hold the number
    QListWidget* panels_;
    QComboBox* width_;
    QDoubleSpinBox* ownWidth_;
    QCheckBox* ownHeight_;
    QDoubleSpinBox* height_;
    QSpinBox* columns_;
    QFontComboBox* family_;
    QDoubleSpinBox* fontSize_;
    QSpinBox* dots_;
    QComboBox* colours_;
    QCheckBox *letters_, *titles_, *data_;
    QLabel *preview_, *remark_;
    QPushButton* export_;
};

} // namespace touchdown

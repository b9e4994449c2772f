// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/studies/study_results.h"

#include <algorithm>

#include <QDir>
#include <QEvent>
#include <QHBoxLayout>
#include <QMenu>
#include <QScrollArea>
#include <QVBoxLayout>

#include "core/studies/study/study_file.h"
#include "core/studies/study/study_verdict.h"
#include "ui/calculation/result_page.h"
#include "ui/plot/picture_widget.h"
#include "ui/studies/study_chart_view.h"
#include "ui/studies/study_table.h"
#include "ui/style/foreign_text.h"
#include "ui/style/quantity_format.h"
#include "ui/style/readable.h"
#include "ui/style/save_dialog.h"
#include "ui/style/theme.h"
#include "ui/style/window_words.h"

namespace touchdown {

namespace {

/// "largest_errors" as "Largest errors".
QString tableTitle(const std::string& name)
{
    QString title = QString::fromStdString(name).replace(QLatin1Char('_'), QLatin1Char(' '));
    if (!title.isEmpty()) title[0] = title[0].toUpper();
    return title;
}

void setTabTexts(QTabBar* tabs, const QStringList& texts)
{
    while (tabs->count() > texts.size()) tabs->removeTab(tabs->count() - 1);
    while (tabs->count() < texts.size()) tabs->addTab({});
    for (int i = 0; i < texts.size(); ++i) {
        tabs->setTabText(i, onButton(texts[i]));
        tabs->setTabToolTip(i, plainTip(texts[i]));
    }
}

QTabBar* makeTabs(const QString& name, QWidget* parent)
{
    auto* tabs = new QTabBar(parent);
    tabs->setAccessibleName(name);
    tabs->setExpanding(false);
    tabs->setDocumentMode(true);
    tabs->setElideMode(Qt::ElideRight);
    tabs->setFocusPolicy(Qt::StrongFocus);
    return tabs;
}

} // namespace

StudyResults::StudyResults(QWidget* parent)
    : QWidget(parent),
      pages_(new ResultPages(this)),
      chartTabs_(makeTabs(tr("Charts of the study"), this)),
      factTabs_(makeTabs(tr("Findings and tables"), this)),
      chartPages_(new QStackedWidget(this)),
      factPages_(new QStackedWidget(this)),
      findings_(new OwnTextBrowser(this)),
      staleMark_(new QLabel(tr("The case or the study has changed since."), this)),
      apply_(new QPushButton(tr("Apply to the case"), this)),
      open_(quietButton(tr("Open the case"),
                        tr("Open the case or the run of the chosen row; a double click on the row does it, too"),
                        tr("Open the chosen row"), this)),
      copy_(quietButton(tr("Copy"), tr("Copy the table, or its selected rows, for a spreadsheet"), tr("Copy the table"),
                        this)),
      save_(quietButton(tr("Save"), tr("Save the chart, the table or the whole report"),
                        tr("Save the results of the study"), this))
{
    build();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(pages_);
    clear(false);
}

void StudyResults::build()
{
    staleMark_->setObjectName(QStringLiteral("stale"));

    auto* charts = new QWidget(this);
    auto* above = new QVBoxLayout(charts);
    above->setContentsMargins(0, 0, 0, 0);
    above->setSpacing(0);
    above->addWidget(chartTabs_);
    above->addWidget(chartPages_, 1);

    findings_->setAccessibleName(tr("Findings"));
    findings_->setFrameShape(QFrame::NoFrame);
    findings_->setOpenLinks(false);
    findings_->document()->setDocumentMargin(10);
    factPages_->addWidget(findings_);
    apply_->setAutoDefault(false);
    apply_->setToolTip(tr("Copy the case that was found into the parameters; undo restores them"));
    apply_->setAccessibleName(tr("Apply the case that was found"));
    save_->setPopupMode(QToolButton::InstantPopup);
    save_->setMenu(new QMenu(save_));
    connect(save_->menu(), &QMenu::aboutToShow, this, &StudyResults::fillSaveMenu);
    connect(apply_, &QPushButton::clicked, this, &StudyResults::applyRequested);
    connect(open_, &QToolButton::clicked, this, [this] { emit openRequested(row_); });
    connect(copy_, &QToolButton::clicked, this, [this] {
        if (const ResultTable* table = shownTable()) table->copy();
    });

    auto* facts = new QWidget(this);
    auto* tools = new QHBoxLayout;
    tools->setContentsMargins(0, 0, 6, 0);
    tools->addWidget(factTabs_, 1);
    tools->addWidget(staleMark_);
    tools->addWidget(apply_);
    tools->addWidget(open_);
    tools->addWidget(copy_);
    tools->addWidget(save_);
    auto* below = new QVBoxLayout(facts);
    below->setContentsMargins(0, 2, 0, 0);
    below->setSpacing(0);
    below->addLayout(tools);
    below->addWidget(factPages_, 1);
    pages_->setParts(charts, facts, {520, 210}, 5, 2);
    connect(chartTabs_, &QTabBar::currentChanged, chartPages_, &QStackedWidget::setCurrentIndex);
    connect(factTabs_, &QTabBar::currentChanged, this, [this](int index) {
        factPages_->setCurrentIndex(index);
        updateTools();
    });
}

void StudyResults::clear(bool underWay)
{
    report_.reset();
    underWay_ = underWay;
    const QString title = underWay ? tr("In progress") : tr("Studies of the case");
    const QString text =
        underWay
            ? tr("Charts appear as soon as there is something to show.")
            : tr("A study solves the case in the window many times and answers one question: which method and time "
                 "step are accurate and fast enough, where a method is unstable, at which value of a parameter the "
                 "slider touches down and takes off, which model is simple and good enough, which design has a "
                 "wanted attitude, or how small the cells of a contact patch must be.<br><br>"
                 "Choose the kind of study at the right and press Perform: its form begins with values of the case. "
                 "Where a kind does not suit the case, the form says why.");
    pages_->introduce(title, text);
    pages_->showResult(false);
    setStale(false);
}

void StudyResults::setReport(const StudyReport& report, bool underWay)
{
    const bool other = !report_ || report_->kind != report.kind;
    report_ = report;
    underWay_ = underWay;
    showCharts();
    showTables();
    writeFindings();
    apply_->setVisible(report.found.has_value() && !underWay);
    setStale(false);
    if (other) {
        chartTabs_->setCurrentIndex(0);
        factTabs_->setCurrentIndex(0);
    }
    pages_->showResult(true);
    updateTools();
}

void StudyResults::showCharts()
{
    while (charts_.size() > report_->charts.size()) {
        delete chartPages_->widget(chartPages_->count() - 1);
        charts_.pop_back();
    }
    while (charts_.size() < report_->charts.size()) {
        auto* scroll = new QScrollArea(chartPages_);
        scroll->setWidgetResizable(true);
        scroll->setFrameShape(QFrame::NoFrame);
        scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        scroll->setFocusPolicy(Qt::NoFocus);
        charts_.push_back(new StudyChartView);
        scroll->setWidget(charts_.back());
        chartPages_->addWidget(scroll);
    }
    QStringList titles;
    for (std::size_t i = 0; i < charts_.size(); ++i) {
        charts_[i]->setChart(report_->charts[i], underWay_);
        titles << readable(report_->charts[i].title).section(QLatin1Char(':'), 0, 0);
    }
    setTabTexts(chartTabs_, titles);
    chartTabs_->setVisible(titles.size() > 1);
    chartPages_->parentWidget()->setVisible(!charts_.empty());
    chartPages_->setCurrentIndex(chartTabs_->currentIndex());
}

void StudyResults::showTables()
{
    while (tables_.size() > report_->tables.size()) {
        delete tables_.back();
        tables_.pop_back();
    }
    while (tables_.size() < report_->tables.size()) {
        tables_.push_back(new ResultTable({}, factPages_));
        tables_.back()->setSortable();
        factPages_->addWidget(tables_.back());
        if (tables_.size() > 1) continue;
        connect(tables_.front(), &ResultTable::chosen, this, [this](int row) {
            row_ = row;
            updateTools();
        });
        connect(tables_.front(), &ResultTable::doubleClicked, this, [this] {
            if (open_->isEnabled()) emit openRequested(row_);
        });
    }
    QStringList titles{tr("Findings")};
    for (std::size_t i = 0; i < tables_.size(); ++i) {
        const StudyTable& table = report_->tables[i];
        tables_[i]->setAccessibleName(tr("Table %1").arg(QString::fromStdString(table.name)));
        tables_[i]->setRows(headsOf(table), rowsOf(table));
        tables_[i]->fitColumns();
        titles << tableTitle(table.name);
    }
    setTabTexts(factTabs_, titles);
    updateTools();
}

void StudyResults::updateTools()
{
    const ResultTable* table = shownTable();
    copy_->setVisible(table != nullptr);
    const auto opens = [this](int row) { return opening_ && row >= 0 ? opening_(row) : QString(); };
    const QString own = opens(row_), some = own.isEmpty() ? opens(0) : own;
    open_->setText(some);
    open_->setVisible(!some.isEmpty() && !underWay_ && table != nullptr && table == tables_.front());
    open_->setEnabled(!own.isEmpty());
}

ResultTable* StudyResults::shownTable() const { return qobject_cast<ResultTable*>(factPages_->currentWidget()); }

void StudyResults::writeFindings()
{
    if (!report_) return;
    const MeaningColours colours = meaningColours(palette());
    QString html;
    const auto add = [&html](const QString& mark, const QColor& colour, const QString& text) {
        html += QStringLiteral(
                    "<tr><td style='color:%1; padding:2px 8px 2px 0'>%2</td><td style='padding:2px 0'>%3</td></tr>")
                    .arg(colour.name(), mark, escaped(text));
    };
    if (report_->status == StudyStatus::Failed) add(QStringLiteral("✕"), colours.failure, sentence(report_->message));
    if (report_->status == StudyStatus::Cancelled || report_->status == StudyStatus::Interrupted)
        add(QStringLiteral("◼"), colours.muted, tr("Stopped: these are the results up to that point."));
    // The first finding of a study that checks something is its verdict.
    const StudyVerdict verdict = report_->status == StudyStatus::Completed ? verdictOf(*report_) : StudyVerdict::None;
    for (std::size_t i = 0; i < report_->findings.size(); ++i) {
        const QString finding = inWindowWords(report_->findings[i]);
        if (i == 0 && verdict == StudyVerdict::Holds)
            add(QStringLiteral("✓"), colours.success, finding);
        else if (i == 0 && verdict != StudyVerdict::None)
            add(QStringLiteral("⚠"), colours.warning, finding);
        else
            add(QStringLiteral("•"), colours.change, finding);
    }
    for (const std::string& warning : report_->warnings)
        add(QStringLiteral("⚠"), colours.warning, inWindowWords(warning));
    html = QStringLiteral("<table cellspacing='0'>%1</table>").arg(html);
    if (underWay_ && report_->findings.empty())
        html = QStringLiteral("<p style='color:%1'>%2</p>").arg(colours.muted.name(), tr("In progress…"));
    findings_->setHtml(html);
}

void StudyResults::setStale(bool stale)
{
    setTextColour(staleMark_, meaningColours(palette()).warning);
    staleMark_->setVisible(stale && report_.has_value());
}

void StudyResults::fillSaveMenu()
{
    QMenu* menu = save_->menu();
    menu->clear();
    if (!charts_.empty()) {
        StudyChartView* chart = charts_[static_cast<std::size_t>(chartTabs_->currentIndex())];
        menu->addAction(tr("&Copy chart"), chart, [chart] { copyPicture(*chart); });
        menu->addAction(tr("Save &chart…"), chart, [chart] { chooseSavePicture(*chart); });
        menu->addSeparator();
    }
    menu->addAction(tr("Save &table as CSV…"), this, &StudyResults::chooseSaveTable)->setEnabled(!tables_.empty());
    menu->addAction(tr("Save all as &HDF5…"), this, &StudyResults::saveRequested);
}

void StudyResults::chooseSaveTable()
{
    const StudyTable table = report_->tables[static_cast<std::size_t>(std::max(0, factTabs_->currentIndex() - 1))];
    askAndSave(this, tr("Save the table"), {tr("Comma-separated values (*.csv)")},
               QString::fromStdString(table.name) + QStringLiteral(".csv"), [this, table](const QString& file) {
                   StudyReport alone;
                   alone.tables = {table};
                   const QString problem = QString::fromStdString(writeStudyCsv(file.toStdString(), alone));
                   if (problem.isEmpty()) emit succeeded(tr("Written: %1").arg(QDir::toNativeSeparators(file)));
                   return problem;
               });
}

bool StudyResults::isEmpty() const { return pages_->empty(); }

void StudyResults::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() != QEvent::PaletteChange && event->type() != QEvent::FontChange) return;
    writeFindings();
    setStale(!staleMark_->isHidden());
}

} // namespace touchdown

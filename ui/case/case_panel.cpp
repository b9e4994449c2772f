// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/case/case_panel.h"

#include <algorithm>

#include <QEvent>
#include <QHBoxLayout>
#include <QScrollBar>
#include <QVBoxLayout>

#include "core/case_files/case_file.h"
#include "ui/case/case_edits.h"
#include "ui/case/parameter_text.h"
#include "ui/style/foreign_text.h"
#include "ui/style/readable.h"
#include "ui/style/theme.h"

namespace touchdown {

CasePanel::CasePanel(CaseEdits& edits, QWidget* parent)
    : QWidget(parent),
      edits_(edits),
      preset_(new QComboBox(this)),
      search_(new QLineEdit(this)),
      found_(new QLabel(this)),
      resetAll_(new QToolButton(this)),
      scroll_(new QScrollArea(this)),
      legend_(new QLabel(this))
{
    buildPresets();

    search_->setPlaceholderText(tr("Search parameters"));
    search_->setAccessibleName(tr("Search parameters"));
    search_->setClearButtonEnabled(true);
    connect(search_, &QLineEdit::textChanged, this, [this] {
        everyMatch_ = false;
        needed_.clear();
        refreshVisibility();
    });
    found_->setWordWrap(true);
    found_->setTextFormat(Qt::RichText);
    connect(found_, &QLabel::linkActivated, this, &CasePanel::showEveryMatch);

    resetAll_->setText(tr("Reset all"));
    resetAll_->setToolTip(tr("Set every parameter back to the case as it was opened"));
    resetAll_->setAccessibleName(tr("Reset all parameters"));
    connect(resetAll_, &QToolButton::clicked, &edits_, &CaseEdits::resetAll);

    legend_->setWordWrap(true);

    auto* page = new QWidget;
    buildGroups(page);
    scroll_->setWidget(page);
    alignUnits();
    scroll_->setWidgetResizable(true);
    scroll_->setFrameShape(QFrame::NoFrame);
    scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    scroll_->setFocusPolicy(Qt::NoFocus);

    auto* tools = new QHBoxLayout;
    tools->addWidget(search_, 1);
    tools->addWidget(resetAll_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 6, 4, 6);
    layout->addWidget(preset_);
    layout->addLayout(tools);
    layout->addWidget(found_);
    layout->addWidget(scroll_, 1);
    layout->addWidget(legend_);

    connect(&edits_, &CaseEdits::edited, this, &CasePanel::refresh);
    setTextColour(legend_, meaningColours(palette()).warning);
    refresh();
}

CasePanel::~CasePanel()
{
    // An editor that loses the focus while it is destroyed would end its edit without a receiver.
    for (ParameterEditor* editor : editors_) editor->disconnect(this);
}

void CasePanel::buildPresets()
{
    preset_->setAccessibleName(tr("Sample case"));
    preset_->setToolTip(tr("The sample case that these parameters come from"));
    preset_->setPlaceholderText(tr("Custom"));
    preset_->setFocusPolicy(Qt::StrongFocus);
    preset_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    preset_->setMinimumContentsLength(20);
    preset_->addItem(tr("Gallery of cases…"));
    preset_->insertSeparator(1);
    for (const SampleCase& sample : sampleCases())
        preset_->addItem(readable(titleOf(sample)), QString::fromStdString(sample.name));
    preset_->setCurrentIndex(-1);
    connect(preset_, &QComboBox::activated, this, [this](int index) {
        const QString name = preset_->itemData(index).toString();
        refresh(); // the choice shows once it has been opened
        name.isEmpty() ? emit galleryWanted() : emit presetChosen(name);
    });
}

void CasePanel::buildGroups(QWidget* page)
{
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins(0, 0, 4, 0);
    layout->setSpacing(0);
    for (const Parameter& parameter : parameters()) {
        const std::string name = parameter.group();
        if (name == "about") continue; // the description of the case has its own pane
        auto group = std::ranges::find(groups_, name, &Group::name);
        if (group == groups_.end()) group = addGroup(name, page);
        auto* editor = new ParameterEditor(parameter, group->body);
        connect(editor, &ParameterEditor::entered, this,
                [this, &parameter](const QString& text) { edits_.enter(parameter, text); });
        connect(editor, &ParameterEditor::typed, this,
                [this, &parameter](const QString& text) { edits_.setTyped(parameter, text); });
        connect(editor, &ParameterEditor::givenUp, this, [this, &parameter] { edits_.forgetEntry(parameter); });
        connect(editor, &ParameterEditor::resetRequested, this, [this, &parameter] { edits_.reset(parameter); });
        connect(editor, &ParameterEditor::varyRequested, this,
                [this, &parameter] { emit varyWanted(QString::fromStdString(parameter.key)); });
        group->body->layout()->addWidget(editor);
        editors_.push_back(editor);
    }
    layout->addStretch(1);
}

std::vector<CasePanel::Group>::iterator CasePanel::addGroup(const std::string& name, QWidget* page)
{
    Group group;
    group.name = name;
    group.header = new QToolButton(page);
    group.header->setText(groupTitle(name));
    group.header->setAutoRaise(true);
    group.header->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    group.header->setArrowType(Qt::DownArrow);
    group.header->setIconSize(QSize(10, 10));
    group.header->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    QFont font = group.header->font();
    font.setBold(true);
    group.header->setFont(font);
    group.header->setAccessibleName(tr("Group %1").arg(groupTitle(name)));

    group.body = new QWidget(page);
    auto* rows = new QVBoxLayout(group.body);
    rows->setContentsMargins(4, 0, 0, 8);
    rows->setSpacing(0);
    page->layout()->addWidget(group.header);
    page->layout()->addWidget(group.body);

    connect(group.header, &QToolButton::clicked, this, [this, name] {
        const auto clicked = std::ranges::find(groups_, name, &Group::name);
        clicked->open = !clicked->open;
        refreshVisibility();
    });
    return groups_.insert(groups_.end(), std::move(group));
}

void CasePanel::alignUnits()
{
    int width = 0;
    for (const ParameterEditor* editor : editors_) width = std::max(width, editor->unitWidth());
    const QMargins page = scroll_->widget()->layout()->contentsMargins();
    const QMargins body = groups_.front().body->layout()->contentsMargins();
    const int around =
        page.left() + page.right() + body.left() + body.right() + scroll_->verticalScrollBar()->sizeHint().width();
    int narrowest = 0; // in which all rows have room
    besideWidths_.clear();
    for (ParameterEditor* editor : editors_) {
        editor->setUnitWidth(width);
        editor->setStacked(true);
        narrowest = std::max(narrowest, editor->minimumSizeHint().width());
        editor->setStacked(false);
        besideWidths_.push_back(editor->minimumSizeHint().width() + around);
    }
    scroll_->setMinimumWidth(narrowest + around);
    stackRows();
}

void CasePanel::stackRows()
{
    for (std::size_t i = 0; i < besideWidths_.size(); ++i) editors_[i]->setStacked(scroll_->width() < besideWidths_[i]);
}

void CasePanel::setPreset(const QString& sampleName)
{
    presetName_ = sampleName;
    search_->clear();
    refresh();
}

ParameterEditor* CasePanel::editor(std::string_view key) const
{
    const auto found =
        std::ranges::find(editors_, key, [](const ParameterEditor* each) { return each->parameter().key; });
    return found == editors_.end() ? nullptr : *found;
}

bool CasePanel::showFirstProblem()
{
    const auto bad = std::ranges::find_if(editors_, [this](const ParameterEditor* editor) {
        return editor->wrong() && editor->parameter().used(edits_.value());
    });
    if (bad == editors_.end()) return false;
    bringIntoView(**bad);
    return true;
}

bool CasePanel::showParameter(std::string_view key)
{
    ParameterEditor* found = editor(key);
    if (!found || !found->parameter().used(edits_.value())) return false;
    bringIntoView(*found);
    found->flash();
    return true;
}

void CasePanel::bringIntoView(ParameterEditor& editor)
{
    search_->clear();
    std::ranges::find(groups_, editor.parameter().group(), &Group::name)->open = true;
    refreshVisibility();
    scroll_->ensureWidgetVisible(&editor);
    editor.setFocus();
}

void CasePanel::showEveryMatch()
{
    everyMatch_ = true;
    refreshVisibility();
}

void CasePanel::refresh()
{
    for (ParameterEditor* editor : editors_) editor->show(edits_);
    const bool changed = edits_.anyChanged();
    resetAll_->setEnabled(changed);
    const bool film = edits_.value().model == ModelKind::Film;
    legend_->setText(film ? tr("≈ assumed: this case gives no value of its own")
                          : tr("≈ assumed, because the paper's value is lost"));
    legend_->setToolTip(plainTip(
        film ? tr("The tip of each value tells where the assumed one comes from.")
             : tr("The tables of the paper that list these values are lost. The stand-ins were chosen so that runs do "
                  "what the paper says of them; each case tells how far they do.")));
    preset_->setCurrentIndex(changed || presetName_.isEmpty() ? -1 : preset_->findData(presetName_));
    refreshVisibility();
}

void CasePanel::refreshVisibility()
{
    const QString search = search_->text().trimmed();
    std::vector<SearchMatch> matches;
    for (const ParameterEditor* editor : editors_)
        matches.push_back(editor->parameter().used(edits_.value())
                              ? editor->match(search, groupTitle(editor->parameter().group()))
                              : SearchMatch::None);
    const SearchMatch best = *std::ranges::min_element(matches),
                      last = std::min(everyMatch_ ? SearchMatch::Help : best, SearchMatch::Help);
    std::ptrdiff_t more = 0; // matches of a lower rank
    for (std::size_t i = 0; i < editors_.size(); ++i) {
        // What a choice needs is shown, whatever is sought, also after it was entered.
        if (editors_[i]->wrong()) needed_.insert(editors_[i]);
        const bool needed = needed_.contains(editors_[i]) && editors_[i]->parameter().used(edits_.value());
        editors_[i]->setVisible(matches[i] <= last || needed);
        more += matches[i] > last && matches[i] != SearchMatch::None && !needed ? 1 : 0;
    }
    for (const Group& group : groups_) {
        const bool any = std::ranges::any_of(editors_, [&group](const ParameterEditor* editor) {
            return editor->parentWidget() == group.body && !editor->isHidden();
        });
        // A search looks into closed groups too.
        const bool open = group.open || !search.isEmpty();
        group.header->setVisible(any);
        group.header->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
        group.body->setVisible(any && open);
    }
    if (best == SearchMatch::None)
        found_->setText(tr("No parameter of this case matches “%1”.").arg(search.toHtmlEscaped()));
    else if (more > 0)
        found_->setText(tr("<a href=\"more\">%n more in keys and explanations</a>", nullptr, static_cast<int>(more)));
    found_->setVisible(best == SearchMatch::None || more > 0);
}

void CasePanel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange) // when the rows have the new font, too
        QMetaObject::invokeMethod(this, &CasePanel::alignUnits, Qt::QueuedConnection);
    if (event->type() == QEvent::PaletteChange) setTextColour(legend_, meaningColours(palette()).warning);
}

void CasePanel::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    stackRows();
}

} // namespace touchdown

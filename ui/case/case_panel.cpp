// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/case/case_panel.h"

#include <algorithm>
#include <array>
#include <utility>

#include <QEvent>
#include <QHBoxLayout>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "core/case_files/case_reader.h"
#include "ui/style/theme.h"

namespace touchdown {

namespace {

QString groupTitle(const std::string& name)
{
    static const std::array<std::pair<const char*, const char*>, 16> titles{
        {{"", QT_TRANSLATE_NOOP("touchdown::CasePanel", "Model")},
         {"springs", QT_TRANSLATE_NOOP("touchdown::CasePanel", "Air bearing springs")},
         {"pad", QT_TRANSLATE_NOOP("touchdown::CasePanel", "Contact pad")},
         {"approach", QT_TRANSLATE_NOOP("touchdown::CasePanel", "Approach and retraction")},
         {"elastic", QT_TRANSLATE_NOOP("touchdown::CasePanel", "Elastic contact")},
         {"adhesion", QT_TRANSLATE_NOOP("touchdown::CasePanel", "Intermolecular adhesion")},
         {"asperity", QT_TRANSLATE_NOOP("touchdown::CasePanel", "Asperities")},
         {"meniscus", QT_TRANSLATE_NOOP("touchdown::CasePanel", "Menisci")},
         {"disk.surface", QT_TRANSLATE_NOOP("touchdown::CasePanel", "Disk surface")},
         {"ono_yamane", QT_TRANSLATE_NOOP("touchdown::CasePanel", "Contact and adhesion")},
         {"initial", QT_TRANSLATE_NOOP("touchdown::CasePanel", "Start")},
         {"run", QT_TRANSLATE_NOOP("touchdown::CasePanel", "Run and numerics")},
         {"spectrum", QT_TRANSLATE_NOOP("touchdown::CasePanel", "Spectrum")},
         {"abs", QT_TRANSLATE_NOOP("touchdown::CasePanel", "Air bearing surface")},
         {"film", QT_TRANSLATE_NOOP("touchdown::CasePanel", "Film and grid")},
         {"steady", QT_TRANSLATE_NOOP("touchdown::CasePanel", "Static attitude")}}};
    for (const auto& [key, title] : titles)
        if (name == key) return CasePanel::tr(title);
    // A group that is new to this list is shown by its name.
    QString text = QString::fromStdString(name).replace(QLatin1Char('_'), QLatin1Char(' '));
    text[0] = text[0].toUpper();
    return text;
}

/// The description of the case has its own pane; it is no parameter.
bool isParameter(const Field& field) { return field.group() != "about"; }

} // namespace

CasePanel::CasePanel(CaseEdits& edits, QWidget* parent)
    : QWidget(parent),
      edits_(edits),
      preset_(new QComboBox(this)),
      search_(new QLineEdit(this)),
      resetAll_(new QToolButton(this)),
      scroll_(new QScrollArea(this)),
      legend_(new QLabel(this))
{
    buildPresets();

    search_->setPlaceholderText(tr("Search parameters"));
    search_->setAccessibleName(tr("Search parameters"));
    search_->setClearButtonEnabled(true);
    connect(search_, &QLineEdit::textChanged, this, &CasePanel::refreshVisibility);

    resetAll_->setText(tr("Reset all"));
    resetAll_->setToolTip(tr("Set every parameter back to the case as it was opened"));
    resetAll_->setAccessibleName(tr("Reset all parameters"));
    connect(resetAll_, &QToolButton::clicked, &edits_, &CaseEdits::resetAll);

    legend_->setText(tr("≈ assumed, because the paper's value is lost"));
    legend_->setWordWrap(true);
    legend_->setToolTip(
        tr("The tables of the paper that list these values are lost. The stand-ins were found by matching "
           "the steady states that the paper states."));

    auto* page = new QWidget;
    buildGroups(page);
    scroll_->setWidget(page);
    scroll_->setWidgetResizable(true);
    scroll_->setFrameShape(QFrame::NoFrame);
    scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll_->setFocusPolicy(Qt::NoFocus);
    page->installEventFilter(this);

    auto* tools = new QHBoxLayout;
    tools->addWidget(search_, 1);
    tools->addWidget(resetAll_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 6, 4, 6);
    layout->addWidget(preset_);
    layout->addLayout(tools);
    layout->addWidget(scroll_, 1);
    layout->addWidget(legend_);

    connect(&edits_, &CaseEdits::edited, this, &CasePanel::refresh);
    colour();
    refresh();
}

CasePanel::~CasePanel()
{
    // An editor that loses the focus while it is destroyed would end its edit without a receiver.
    for (const Group& group : groups_)
        for (FieldEditor* editor : group.editors) editor->disconnect(this);
}

void CasePanel::buildPresets()
{
    preset_->setAccessibleName(tr("Sample case"));
    preset_->setToolTip(tr("The sample case that these parameters come from"));
    preset_->setPlaceholderText(tr("Custom"));
    preset_->setFocusPolicy(Qt::StrongFocus);
    preset_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    preset_->setMinimumContentsLength(20);
    for (const SampleCase& sample : sampleCases()) {
        const CaseDocument document = parseCase(sample.text, sample.name);
        preset_->addItem(QString::fromStdString(document.value.title), QString::fromStdString(sample.name));
    }
    preset_->setCurrentIndex(-1);
    connect(preset_, &QComboBox::activated, this, [this](int index) {
        const QString name = preset_->itemData(index).toString();
        refresh(); // the choice shows once it has been opened
        emit presetChosen(name);
    });
}

void CasePanel::buildGroups(QWidget* page)
{
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins(0, 0, 4, 0);
    layout->setSpacing(0);
    for (const Field& field : fields()) {
        if (!isParameter(field)) continue;
        const std::string name = field.group();
        auto group = std::ranges::find(groups_, name, &Group::name);
        if (group == groups_.end()) {
            addGroup(name, page);
            group = groups_.end() - 1;
        }
        auto* editor = new FieldEditor(field, group->body);
        connect(editor, &FieldEditor::entered, this,
                [this, &field](const QString& text) { edits_.enter(field, text); });
        connect(editor, &FieldEditor::resetRequested, this, [this, &field] { edits_.reset(field); });
        group->body->layout()->addWidget(editor);
        group->editors.push_back(editor);
    }
    layout->addStretch(1);
    alignUnits();
}

void CasePanel::addGroup(const std::string& name, QWidget* page)
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
    groups_.push_back(std::move(group));
}

void CasePanel::alignUnits()
{
    int width = 0;
    for (const Group& group : groups_)
        for (const FieldEditor* editor : group.editors) width = std::max(width, editor->unitWidth());
    for (const Group& group : groups_)
        for (FieldEditor* editor : group.editors) editor->setUnitWidth(width);
}

void CasePanel::setPreset(const QString& sampleName)
{
    presetName_ = sampleName;
    refresh();
}

FieldEditor* CasePanel::editor(std::string_view key) const
{
    for (const Group& group : groups_)
        for (FieldEditor* editor : group.editors)
            if (editor->field().key == key) return editor;
    return nullptr;
}

void CasePanel::showFirstProblem()
{
    for (Group& group : groups_) {
        for (FieldEditor* editor : group.editors) {
            if (editor->reason().isEmpty() || !editor->field().used(edits_.value())) continue;
            search_->clear();
            group.open = true;
            refreshVisibility();
            scroll_->ensureWidgetVisible(editor);
            editor->setFocus();
            return;
        }
    }
}

void CasePanel::refresh()
{
    for (const Group& group : groups_)
        for (FieldEditor* editor : group.editors) editor->show(edits_);
    const bool changed = edits_.anyChanged();
    resetAll_->setEnabled(changed);
    preset_->setCurrentIndex(changed || presetName_.isEmpty() ? -1 : preset_->findData(presetName_));
    refreshVisibility();
}

void CasePanel::refreshVisibility()
{
    const QString search = search_->text();
    for (const Group& group : groups_) {
        bool any = false;
        for (FieldEditor* editor : group.editors) {
            const bool wanted = editor->field().used(edits_.value()) && editor->matches(search);
            editor->setVisible(wanted);
            any = any || wanted;
        }
        // A search looks into closed groups too.
        const bool open = group.open || !search.isEmpty();
        group.header->setVisible(any);
        group.header->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
        group.body->setVisible(any && open);
    }
}

void CasePanel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange) alignUnits();
    if (event->type() == QEvent::PaletteChange) colour();
}

bool CasePanel::eventFilter(QObject* watched, QEvent* event)
{
    // Rows scroll up and down only, so that the panel must be as wide as they need, whatever the font.
    if (watched == scroll_->widget() && event->type() == QEvent::LayoutRequest)
        scroll_->setMinimumWidth(scroll_->widget()->minimumSizeHint().width() +
                                 scroll_->verticalScrollBar()->sizeHint().width());
    return QWidget::eventFilter(watched, event);
}

void CasePanel::colour()
{
    QPalette ofLegend;
    ofLegend.setColor(QPalette::WindowText, meaningColours(palette()).warning);
    if (legend_->palette() != ofLegend) legend_->setPalette(ofLegend);
}

} // namespace touchdown

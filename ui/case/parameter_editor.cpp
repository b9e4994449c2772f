// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/case/parameter_editor.h"

#include <algorithm>

#include <QAction>
#include <QKeyEvent>
#include <QMenu>
#include <QPainter>
#include <QRegularExpression>

#include "ui/case/case_edits.h"
#include "ui/case/choice_text.h"
#include "ui/case/parameter_text.h"
#include "ui/style/foreign_text.h"
#include "ui/style/quantity_format.h"
#include "ui/style/theme.h"

namespace touchdown {

namespace {

constexpr int inputCharacters = 9; // wide enough for "0.0032 um"
constexpr int spacing = 4;         // [px]
constexpr int flashTime = 1600;    // [ms]

bool isStandIn(const Parameter& parameter)
{
    return QString::fromStdString(parameter.source).contains(QLatin1String("assumed"), Qt::CaseInsensitive);
}

/// Under the heading of its group, "suspension stiffness" is a stiffness.
QString labelOf(const Parameter& parameter)
{
    QString text = QString::fromStdString(parameter.label).toHtmlEscaped();
    const QString group = QString::fromStdString(parameter.group()) + QLatin1Char(' ');
    if (text.startsWith(group)) text.remove(0, group.size());
    if (!text.isEmpty()) text[0] = text[0].toUpper();
    return parameter.symbol.empty() ? text : text + QStringLiteral("&nbsp;") + symbolText(parameter.symbol);
}

/// Whether each word of `search` is the start of a word of the text. Words consist of letters and digits.
bool hasWords(const QString& text, const QString& search)
{
    static const QRegularExpression between(QStringLiteral("[^\\p{L}\\p{N}]+"));
    const QStringList words = text.split(between, Qt::SkipEmptyParts);
    return std::ranges::all_of(search.split(between, Qt::SkipEmptyParts), [&words](const QString& wanted) {
        return std::ranges::any_of(
            words, [&wanted](const QString& word) { return word.startsWith(wanted, Qt::CaseInsensitive); });
    });
}

/// Texts and lists have a line of their own below their label.
bool isWide(const Parameter& parameter)
{
    return parameter.kind == ParameterKind::Text || parameter.kind == ParameterKind::List;
}

} // namespace

ParameterEditor::ParameterEditor(const Parameter& parameter, QWidget* parent)
    : QWidget(parent),
      parameter_(parameter),
      grid_(new QGridLayout(this)),
      label_(new QLabel(labelOf(parameter), this)),
      unit_(new QLabel(unitText(parameter.displayUnit), this)),
      assumed_(new QLabel(QStringLiteral("≈"), this)),
      reset_(new QToolButton(this)),
      reason_(new QLabel(this))
{
    setObjectName(QString::fromStdString(parameter.key));
    buildInput();

    label_->setBuddy(input());
    label_->setTextFormat(Qt::RichText);
    label_->setWordWrap(true);
    label_->setMinimumWidth(0);

    assumed_->setAccessibleName(tr("Assumed value"));
    reset_->setText(QStringLiteral("↺"));
    reset_->setAutoRaise(true);
    reset_->setFocusPolicy(Qt::NoFocus);
    reset_->setAccessibleName(tr("Reset %1").arg(QString::fromStdString(parameter.label)));
    for (QWidget* mark : std::initializer_list<QWidget*>{assumed_, reset_}) {
        QSizePolicy policy = mark->sizePolicy();
        policy.setRetainSizeWhenHidden(true);
        mark->setSizePolicy(policy);
    }
    reason_->setWordWrap(true);
    reason_->hide();

    grid_->setContentsMargins(4, 1, 0, 1);
    grid_->setHorizontalSpacing(spacing);
    grid_->setVerticalSpacing(1);
    grid_->addWidget(reason_, 2, 0, 1, 5);
    grid_->setColumnStretch(0, 1);
    if (choice_) unit_->hide();
    arrange(false);

    buildMenu();
    connect(reset_, &QToolButton::clicked, this, &ParameterEditor::resetRequested);
    connect(&flash_, &QVariantAnimation::valueChanged, this, qOverload<>(&QWidget::update));
    describe();
    colour();
}

/// That of a line has its own entries, too.
void ParameterEditor::buildMenu()
{
    if (parameter_.kind != ParameterKind::Number && parameter_.kind != ParameterKind::Choice) return;
    auto* vary = new QAction(tr("&Vary this…"), this);
    vary->setObjectName(QStringLiteral("vary"));
    connect(vary, &QAction::triggered, this, &ParameterEditor::varyRequested);
    for (QWidget* place : std::initializer_list<QWidget*>{this, choice_}) {
        if (!place) continue;
        place->addAction(vary);
        place->setContextMenuPolicy(Qt::ActionsContextMenu);
    }
    if (!line_) return;
    line_->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(line_, &QWidget::customContextMenuRequested, this, [this, vary](const QPoint& at) {
        QMenu* menu = line_->createStandardContextMenu();
        menu->setAttribute(Qt::WA_DeleteOnClose);
        menu->addSeparator();
        menu->addAction(vary);
        menu->popup(line_->mapToGlobal(at));
    });
}

void ParameterEditor::setStacked(bool stacked)
{
    if (stacked != stacked_) arrange(stacked);
}

void ParameterEditor::arrange(bool stacked)
{
    stacked_ = stacked;
    const bool wide = isWide(parameter_);
    const int row = stacked || wide ? 1 : 0; // of the value
    for (QWidget* part : {static_cast<QWidget*>(label_), static_cast<QWidget*>(assumed_), input(),
                          static_cast<QWidget*>(unit_), static_cast<QWidget*>(reset_)})
        grid_->removeWidget(part);
    const bool line = stacked && choice_; // for itself, as a text has
    grid_->addWidget(label_, 0, 0, 1, row == 0 ? 1 : line ? 4 : 5);
    grid_->addWidget(reset_, row, 4);
    if (wide) {
        grid_->addWidget(input(), 1, 0, 1, 3);
        if (parameter_.kind == ParameterKind::List) grid_->addWidget(unit_, 1, 3);
        return;
    }
    grid_->addWidget(assumed_, line ? 0 : row, line ? 4 : 1);
    grid_->addWidget(input(), row, line ? 0 : 2, 1, line ? 4 : choice_ ? 2 : 1);
    fitChoice();
    if (!choice_) grid_->addWidget(unit_, row, 3);
}

QWidget* ParameterEditor::input() const
{
    if (choice_) return choice_;
    if (check_) return check_;
    return line_;
}

void ParameterEditor::buildInput()
{
    if (parameter_.kind == ParameterKind::Choice) {
        choice_ = new QComboBox(this);
        for (const std::string& name : parameter_.choices) {
            const ChoiceText text = choiceText(parameter_.key, name);
            choice_->addItem(text.name, QString::fromStdString(name));
            choice_->setItemData(choice_->count() - 1, plainTip(text.meaning), Qt::ToolTipRole);
        }
        choice_->setFocusPolicy(Qt::StrongFocus);
        connect(choice_, &QComboBox::activated, this, [this] { emit entered(choice_->currentData().toString()); });
    } else if (parameter_.kind == ParameterKind::Boolean) {
        check_ = new QCheckBox(this);
        connect(check_, &QCheckBox::clicked, this,
                [this](bool on) { emit entered(on ? QStringLiteral("true") : QStringLiteral("false")); });
    } else {
        line_ = new QLineEdit(this);
        if (!isWide(parameter_)) {
            line_->setAlignment(Qt::AlignRight);
            line_->setFixedWidth(inputWidth());
        }
        connect(line_, &QLineEdit::editingFinished, this, &ParameterEditor::commitLine);
        connect(line_, &QLineEdit::textEdited, this, &ParameterEditor::typed);
    }
    input()->installEventFilter(this);
    input()->setAccessibleName(QString::fromStdString(parameter_.label));
    setFocusProxy(input());
}

QString ParameterEditor::meaning(int choice) const
{
    return choiceText(parameter_.key, choice_->itemData(choice).toString().toStdString()).meaning;
}

int ParameterEditor::inputWidth() const { return fontMetrics().averageCharWidth() * inputCharacters + 14; }

int ParameterEditor::unitWidth() const
{
    // The hint of a label counts its least width: it would never get narrower.
    unit_->setMinimumWidth(0);
    unit_->setIndent(unit_->indent()); // forgets the hint
    return unit_->sizeHint().width();
}

void ParameterEditor::setUnitWidth(int width)
{
    unit_->setFixedWidth(width);
    fitChoice();
}

/// As wide as a number and its unit, so that the column is even; a longer name takes room from its label.
void ParameterEditor::fitChoice()
{
    if (!choice_) return;
    choice_->setMinimumWidth(std::max(inputWidth() + spacing + unit_->minimumWidth(), choice_->sizeHint().width()));
    choice_->setMaximumWidth(stacked_ ? QWIDGETSIZE_MAX : choice_->minimumWidth());
}

void ParameterEditor::describe()
{
    QString htmlTip = QStringLiteral("<b>%1</b>").arg(labelOf(parameter_));
    const auto paragraph = [&htmlTip](const QString& text) {
        if (!text.isEmpty()) htmlTip += QStringLiteral("<p style='margin:4px 0 0 0'>%1</p>").arg(text.toHtmlEscaped());
    };
    if (choice_) {
        for (int i = 0; i < choice_->count(); ++i) paragraph(tr("%1: %2").arg(choice_->itemText(i), meaning(i)));
    } else {
        paragraph(QString::fromStdString(parameter_.help));
    }
    if (const std::string range = allowedRange(parameter_); !range.empty())
        paragraph((choice_ ? tr("In a file: %1") : tr("Allowed: %1")).arg(QString::fromStdString(range)));
    if (!parameter_.source.empty()) paragraph(tr("Source: %1").arg(QString::fromStdString(parameter_.source)));
    paragraph(tr("Key: %1").arg(QString::fromStdString(parameter_.key)));
    label_->setToolTip(htmlTip);
    input()->setToolTip(htmlTip);
    input()->setAccessibleDescription(QString::fromStdString(parameter_.help));
    assumed_->setToolTip(plainTip(tr("Assumed: %1").arg(QString::fromStdString(parameter_.source))));
}

void ParameterEditor::show(const CaseEdits& edits)
{
    const Case& value = edits.value();
    const BadEntry* bad = edits.badEntry(parameter_);

    if (choice_) {
        choice_->setCurrentIndex(choice_->findData(QString::fromStdString(toText(value, parameter_))));
    } else if (check_) {
        check_->setChecked(std::get<bool>(parameter_.get(value)));
    } else {
        shown_ = bad ? bad->text : editorText(value, parameter_);
        refused_ = bad != nullptr;
        const bool isNew = line_->text() != shown_;
        if (isNew) line_->setText(shown_);
        line_->setModified(false);
        if (isNew || isWide(parameter_)) line_->setCursorPosition(0); // of a long number the beginning
    }

    QString reason = bad ? bad->reason : QString();
    for (const CaseProblem& problem : edits.combinationProblems())
        if (!bad && problem.key == parameter_.key) reason = sentence(problem.message);
    wrong_ = !reason.isEmpty();
    for (const CaseProblem& warning : edits.warnings())
        if (!wrong_ && warning.key == parameter_.key) reason = sentence(warning.message);
    reason_->setText(reason);
    reason_->setVisible(!reason.isEmpty());

    changed_ = edits.changed(parameter_);
    reset_->setVisible(changed_);
    reset_->setToolTip(plainTip(tr("Back to %1").arg(valueText(edits.opened(), parameter_))));
    // The mark of an assumed value disappears when the value is changed.
    assumed_->setVisible(isStandIn(parameter_) && parameter_.get(value) == parameter_.get(Case{}));
    colour();
}

SearchMatch ParameterEditor::match(const QString& search, const QString& heading) const
{
    QString texts = QString::fromStdString(parameter_.help);
    for (int i = 0; choice_ && i < choice_->count(); ++i)
        texts += QLatin1Char(' ') + choice_->itemText(i) + QLatin1Char(' ') + meaning(i);
    const QString label = QString::fromStdString(parameter_.label + ' ' + parameter_.symbol) + u' ' + heading,
                  key = label + QLatin1Char(' ') + QString::fromStdString(parameter_.key);
    if (hasWords(label, search)) return SearchMatch::Label;
    if (hasWords(key, search)) return SearchMatch::Key;
    return hasWords(key + QLatin1Char(' ') + texts, search) ? SearchMatch::Help : SearchMatch::None;
}

bool ParameterEditor::eventFilter(QObject* watched, QEvent* event)
{
    if (watched != input()) return QWidget::eventFilter(watched, event);
    // The wheel scrolls the panel unless this input has the focus.
    if (event->type() == QEvent::Wheel && !input()->hasFocus()) {
        event->ignore();
        return true;
    }
    const bool isKey = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
    const auto* key = isKey ? static_cast<QKeyEvent*>(event) : nullptr;
    // With nothing typed, undo and redo are those of the case, not of the line.
    if (line_ && !line_->isModified() && event->type() == QEvent::ShortcutOverride &&
        (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo))) {
        event->ignore();
        return true;
    }
    if (line_ && line_->isModified() && event->type() == QEvent::KeyPress && key->key() == Qt::Key_Escape) {
        line_->setText(shown_);
        line_->setModified(false);
        emit typed(shown_);
        return true;
    }
    // A wrong entry that was taken: back to the value that the case has.
    if (line_ && refused_ && event->type() == QEvent::KeyPress && key->key() == Qt::Key_Escape) {
        emit givenUp();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

void ParameterEditor::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) colour();
    if (event->type() == QEvent::FontChange && line_ && !isWide(parameter_)) line_->setFixedWidth(inputWidth());
}

void ParameterEditor::flash()
{
    flash_.setStartValue(1.0);
    flash_.setEndValue(0.0);
    flash_.setDuration(flashTime);
    flash_.start();
}

void ParameterEditor::paintEvent(QPaintEvent* event)
{
    QWidget::paintEvent(event);
    if (flash_.state() != QAbstractAnimation::Running) return;
    QColor colour = palette().color(QPalette::Highlight);
    colour.setAlphaF(0.6F * flash_.currentValue().toFloat());
    QPainter(this).fillRect(rect(), colour);
}

void ParameterEditor::commitLine()
{
    // Enter and loss of focus both end an edit; the second must not repeat it.
    if (line_->text() == shown_) return;
    shown_ = line_->text();
    line_->setModified(false);
    emit entered(shown_);
}

void ParameterEditor::colour()
{
    const MeaningColours colours = meaningColours(palette());
    const bool bad = wrong_;
    setTextColour(label_, bad ? colours.failure : changed_ ? colours.change : QColor());
    setTextColour(unit_, colours.muted);
    setTextColour(assumed_, colours.warning);
    setTextColour(reason_, bad ? colours.failure : colours.warning);
    QFont font = label_->font();
    if (font.bold() != changed_) {
        font.setBold(changed_);
        label_->setFont(font);
    }
    if (line_) {
        QPalette palette;
        if (bad) {
            palette.setColor(QPalette::Base, isDark(palette) ? QColor("#4a2626") : QColor("#fdeaea"));
            palette.setColor(QPalette::Highlight, colours.failure);
        }
        if (line_->palette() != palette) line_->setPalette(palette);
    }
}

} // namespace touchdown

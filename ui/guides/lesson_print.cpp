// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guides/lesson_print.h"

#include <algorithm>
#include <exception>
#include <numeric>
#include <string>
#include <utility>

#include <QBuffer>
#include <QMarginsF>
#include <QPainter>
#include <QPdfWriter>
#include <QProgressDialog>
#include <QRegularExpression>
#include <QTextDocument>
#include <QUrl>

#include "ui/guides/lesson_stages.h"
#include "ui/guides/lesson_text.h"
#include "ui/plot/paper_figure.h"
#include "ui/plot/plot_widget.h"
#include "ui/plot/spectrum_view.h"
#include "ui/runs/live_plots.h"
#include "ui/runs/live_spectrum.h"
#include "ui/runs/run_record.h"
#include "ui/runs/run_view.h"
#include "ui/runs/side_view.h"
#include "ui/style/foreign_text.h"

namespace touchdown {

namespace {

// Lengths on paper [mm].
constexpr double pageWidth = 210.0, pageHeight = 297.0, margin = 18.0;
constexpr double footHeight = 8.0;
constexpr double textWidth = pageWidth - 2.0 * margin;
constexpr double panelHeight = 45.0;
constexpr int dotsPerInch = 200; // of a picture
constexpr double millimetresPerInch = 25.4;
constexpr double pixelsPerInch = 96.0; // in which the text is laid out
constexpr int pointSize = 9;
const QColor quiet(0x55, 0x5b, 0x66), accent(0x15, 0x5d, 0x9c), good(0x1c, 0x74, 0x34); // on white paper

double pixels(double millimetres) { return millimetres / millimetresPerInch * pixelsPerInch; }

/// Links lead nowhere on paper.
QString withoutLinks(QString html)
{
    static const QRegularExpression link(QStringLiteral("<a [^>]*>(.*?)</a>"));
    return html.replace(link, QStringLiteral("<i>\\1</i>"));
}

/// Without its studies.
int runsOf(const LessonStep& step)
{
    return static_cast<int>(std::ranges::count(step.runs, std::string(), &LessonRun::kind));
}

} // namespace

LessonPrint::LessonPrint(std::vector<LessonStep> steps, const QString& title, QObject* parent)
    : QObject(parent),
      steps_(std::move(steps)),
      title_(title),
      view_(std::make_unique<RunView>(list_)),
      stages_(std::make_unique<LessonStages>(*view_, list_, nullptr)),
      queue_(nullptr)
{
    view_->setAttribute(Qt::WA_DontShowOnScreen);
    view_->resize(1000, 800);
    view_->show(); // its parts ask whether they are seen
    connect(view_->spectrum()->view(), &SpectrumView::curvesChanged, this, &LessonPrint::finishModel,
            Qt::QueuedConnection);
}

LessonPrint::~LessonPrint() { cancel(); }

void LessonPrint::cancel()
{
    cancelled_ = true;
    QMetaObject::invokeMethod(this, &LessonPrint::finishModel, Qt::QueuedConnection); // it may wait for a spectrum
}

int LessonPrint::runs() const
{
    return std::accumulate(steps_.begin(), steps_.end(), 0,
                           [](int count, const LessonStep& step) { return count + runsOf(step); });
}

void LessonPrint::showProgress(QWidget* window, const QString& file)
{
    auto* progress = new QProgressDialog(tr("Print the lesson to %1").arg(file), tr("Cancel"), 0, runs(), window);
    progress->setWindowTitle(tr("Print the lesson"));
    progress->setAutoClose(false);
    progress->setAutoReset(false);
    progress->setMinimumDuration(0);
    progress->setValue(0);
    connect(progress, &QProgressDialog::canceled, this, &LessonPrint::cancel);
    connect(this, &LessonPrint::performed, progress, &QProgressDialog::setValue);
    connect(this, &LessonPrint::ended, progress, &QObject::deleteLater);
}

void LessonPrint::start()
{
    html_ = QStringLiteral("<h1 style='margin:0'>%1</h1>").arg(title_.toHtmlEscaped());
    stages_->show(steps_.front());
    QMetaObject::invokeMethod(this, &LessonPrint::next, Qt::QueuedConnection);
}

void LessonPrint::next()
{
    if (cancelled_) return emit ended(false, {});
    if (step_ == steps_.size()) return emit ended(true, {});
    const std::vector<LessonRun>& runs = steps_[step_].runs;
    while (run_ < runs.size() && !runs[run_].kind.empty()) ++run_;
    const bool sameModel = run_ < runs.size() && (numbers_.empty() || caseOf(runs[run_]).model == model_);
    if (sameModel) return perform(run_++);
    allThere_ = true;
    view_->plots()->setWords(lessonWords(steps_[step_], numbers_, list_));
    finishModel();
}

void LessonPrint::perform(std::size_t run)
{
    const Case c = caseOf(steps_[step_].runs[run]);
    model_ = c.model;
    view_->setCase(c);
    auto record = std::make_shared<std::unique_ptr<RunRecord>>();
    queue_.post(
        [this, c, record] {
            try {
                *record = performedRecord(c, c.run.duration, [this] { return !cancelled_; });
            } catch (const std::exception& problem) {
                return QString::fromUtf8(problem.what());
            }
            return QString();
        },
        [this, run, record](const QString& problem) {
            if (!problem.isEmpty()) return emit ended(false, problem);
            if (cancelled_) return emit ended(false, {});
            (*record)->number = list_.nextNumber();
            numbers_[run] = list_.add(std::move(*record)).number;
            emit performed(++performed_);
            next();
        });
}

/// A picture of the runs of one model, when all are there and their spectra, where the step shows them. The springs and
/// the film of a step have pictures of their own: 8 nm and 0.1 nm are not seen on one axis.
void LessonPrint::finishModel()
{
    if (!allThere_) return;
    if (!cancelled_ && view_->spectrum()->isVisible() && !view_->spectrum()->complete()) return;
    allThere_ = false;
    if (cancelled_) return emit ended(false, {});
    // As the list below numbers them.
    for (const auto& [run, number] : numbers_) list_.rename(number, tr("run %1").arg(run + 1));
    addPicture(false);
    if (run_ < steps_[step_].runs.size()) {
        showOnly(std::nullopt);
        return perform(run_++);
    }
    if (!numbers_.empty()) {
        const std::optional<std::size_t> parts = steps_[step_].stage.parts;
        showOnly(parts ? numbers_.at(*parts) : numbers_.rbegin()->second);
        addPicture(true);
    }
    addStep();
    while (list_.count() > 0) list_.remove(0);
    numbers_.clear();
    run_ = 0;
    if (++step_ < steps_.size()) stages_->show(steps_[step_]);
    next();
}

/// A run of the list, or none.
void LessonPrint::showOnly(std::optional<int> number)
{
    for (int row = 0; row < list_.count(); ++row)
        list_.setData(list_.index(row), list_.record(row).number == number ? Qt::Checked : Qt::Unchecked,
                      Qt::CheckStateRole);
}

void LessonPrint::addStep()
{
    const LessonStep& step = steps_[step_];
    html_ += QStringLiteral("<h2 style='margin:0 0 4px 0%1'>%2. %3</h2>")
                 .arg(step_ > 0 ? QStringLiteral("; page-break-before:always") : QString())
                 .arg(step_ + 1)
                 .arg(lessonHtml(step.title));
    html_ += lessonBlock({}, step.text, quiet) + lessonBlock(tr("Question"), step.question, accent);
    html_ += std::exchange(figures_, {});
    html_ += QStringLiteral("<ol style='margin:2px 0'>");
    for (std::size_t i = 0; i < step.runs.size(); ++i) {
        const LessonRun& run = step.runs[i];
        const RunRecord* record = numbers_.contains(i) ? list_.find(numbers_[i]) : nullptr;
        html_ += QStringLiteral("<li>%1 <span style='color:%2'>%3</span> %4</li>")
                     .arg(lessonHtml(run.purpose), quiet.name(),
                          record ? lessonSubject(run)
                                 : QStringLiteral("<code>%1</code>").arg(QString::fromStdString(commandOf(run))),
                          record ? QStringLiteral("→ ") + lessonResult(*record, step.stage.from).toHtmlEscaped()
                                 : QString());
    }
    html_ += QStringLiteral("</ol>");
    html_ += lessonBlock(tr("Answer"), step.answer, good);
    html_ += lessonBlock(tr("Then change it yourself"), step.change, quiet);
}

/// A picture of the runs shown: of the plots with one curve for each run and of the spectrum, or, for one run, of the
/// plots with several curves.
void LessonPrint::addPicture(bool several)
{
    std::vector<QWidget*> panels;
    for (QWidget* part : visibleParts(*view_)) {
        const auto entry = std::ranges::find(view_->plots()->plots(), part, &LivePlots::Entry::plot);
        const bool ofTime = entry != view_->plots()->plots().end();
        const bool hasSeveral = ofTime && view_->plots()->spec(entry->name).curves.size() > 1;
        if (hasSeveral == several && !qobject_cast<SideView*>(part)) panels.push_back(part);
    }
    if (panels.empty() || numbers_.empty()) return;
    FigureFormat format;
    format.width = textWidth;
    format.height = panelHeight * static_cast<double>(panels.size());
    format.letters = false;
    const PaperFigure paper(panels, format);
    const Picture figure = paper.picture();
    const double scale = dotsPerInch / figure.pixelsPerInch;
    QImage image((figure.size * scale).toSize(), QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.scale(scale, scale);
    figure.paint(painter);
    painter.end();
    QStringList names;
    for (const auto& [run, number] : numbers_)
        if (list_.find(number)->shown) names << QString::number(run + 1);
    if (names.size() < runsOf(steps_[step_]))
        figures_ += QStringLiteral("<p style='margin:4px 0 0 0; color:%1'>%2</p>")
                        .arg(quiet.name(), names.size() == 1 ? tr("Run %1:").arg(names.front())
                                                             : tr("Runs %1:").arg(names.join(QStringLiteral(", "))));
    figures_ += QStringLiteral("<p style='margin:4px 0'><img src='picture%1' width='%2' height='%3'></p>")
                    .arg(pictures_.size())
                    .arg(pixels(textWidth), 0, 'f', 1)
                    .arg(pixels(textWidth) * image.height() / std::max(image.width(), 1), 0, 'f', 1);
    pictures_.push_back(std::move(image));
}

std::unique_ptr<QTextDocument> LessonPrint::document() const
{
    auto document = std::make_unique<OwnDocument>();
    for (std::size_t i = 0; i < pictures_.size(); ++i)
        document->addResource(QTextDocument::ImageResource, QUrl(QStringLiteral("picture%1").arg(i)), pictures_[i]);
    QFont font;
    font.setPixelSize(static_cast<int>(pointSize * pixelsPerInch / 72.0));
    document->setDefaultFont(font);
    document->setDocumentMargin(0.0);
    document->setUseDesignMetrics(true);
    document->setHtml(QStringLiteral("<body style='color:black'>%1</body>").arg(withoutLinks(html_)));
    document->setPageSize({pixels(textWidth), pixels(pageHeight - 2.0 * margin - footHeight)});
    return document;
}

int LessonPrint::pages() const { return document()->pageCount(); }

QByteArray LessonPrint::pdf() const
{
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins(QMarginsF(margin, margin, margin, margin), QPageLayout::Millimeter);
    writer.setResolution(600);
    writer.setTitle(title_);
    writer.setCreator(QStringLiteral("Touchdown " TOUCHDOWN_VERSION));
    const std::unique_ptr<QTextDocument> text = document();
    const QSizeF page = text->pageSize();
    QPainter painter(&writer);
    painter.scale(writer.logicalDpiX() / pixelsPerInch, writer.logicalDpiY() / pixelsPerInch);
    painter.setFont(text->defaultFont());
    for (int i = 0; i < text->pageCount(); ++i) {
        if (i > 0) writer.newPage();
        painter.save();
        painter.translate(0.0, -i * page.height());
        text->drawContents(&painter, QRectF(0.0, i * page.height(), page.width(), page.height() - 3.0));
        painter.restore();
        painter.setPen(quiet);
        const QRectF foot(0.0, page.height(), page.width(), pixels(footHeight));
        painter.drawText(foot, Qt::AlignLeft | Qt::AlignBottom, QStringLiteral("Touchdown " TOUCHDOWN_VERSION));
        painter.drawText(foot, Qt::AlignRight | Qt::AlignBottom, tr("%1 of %2").arg(i + 1).arg(text->pageCount()));
    }
    painter.end();
    return buffer.data();
}

} // namespace touchdown

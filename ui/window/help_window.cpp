// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/help_window.h"

#include <algorithm>
#include <ranges>

#include <QFile>
#include <QHBoxLayout>
#include <QScreen>
#include <QShortcut>
#include <QSplitter>
#include <QStyle>

#include "core/case/parameters.h"
#include "core/formats/csv_cell.h"
#include "core/formats/words.h"
#include "core/studies/runs/reading.h"
#include "ui/case/parameter_text.h"
#include "ui/guides/glossary.h"
#include "ui/style/foreign_text.h"
#include "ui/style/quantity_format.h"

namespace touchdown {

namespace {

QString resource(const QString& name)
{
    QFile file(QStringLiteral(":/help/") + name);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// The reference of the parameters, from their one description.
QString parameterTable()
{
    const Case defaults;
    QString html = QStringLiteral("<h2>%1</h2><p>%2</p><table cellpadding='4' cellspacing='0' border='0'>")
                       .arg(HelpWindow::tr("Parameters"),
                            HelpWindow::tr("Every key of a case file, with its default and its allowed values."));
    for (const Parameter& parameter : parameters()) {
        html += QStringLiteral(
                    "<tr><td><b>%1</b> "
                    "%2<br><code>%3</code></td><td>%4</td><td>%5<br><small>%6</small><br><small>%7</small></td></tr>")
                    .arg(QString::fromStdString(parameter.label).toHtmlEscaped(),
                         parameter.symbol.empty() ? QString() : symbolText(parameter.symbol),
                         QString::fromStdString(parameter.key).toHtmlEscaped(),
                         valueText(defaults, parameter).toHtmlEscaped(),
                         QString::fromStdString(parameter.help).toHtmlEscaped(),
                         QString::fromStdString(allowedRange(parameter)).toHtmlEscaped(),
                         QString::fromStdString(parameter.source).toHtmlEscaped());
    }
    return html + QStringLiteral("</table>");
}

/// What a sweep can read off a run, a static state or modes, from their one table.
QString readingTable()
{
    const auto text = [](std::string_view words) { return QString::fromUtf8(words).toHtmlEscaped(); };
    QString single, overTime, places;
    for (const ReadingRow& row : allReadings()) {
        const Quantity& quantity = row.what.quantity;
        const QString unit = row.what.isText ? HelpWindow::tr("text") : unitText(quantity.displayUnit);
        (row.what.overTime ? overTime : single) +=
            QStringLiteral("<tr><td><code>%1</code></td><td>%2</td><td>%3<br><small>%4</small></td></tr>")
                .arg(text(quantity.name), unit, text(quantity.longName), text(joined(row.where)));
    }
    for (std::size_t i = 1; i < readAtCount; ++i) {
        const auto taken = static_cast<ReadAt>(i);
        places +=
            QStringLiteral("<tr><td><code>%1</code></td><td>%2</td></tr>").arg(text(name(taken)), text(meaning(taken)));
    }
    const auto table = [](const QString& rows) {
        return QStringLiteral("<table cellpadding='4' cellspacing='0' border='0'>%1</table>").arg(rows);
    };
    return QStringLiteral("<h2>%1</h2><p>%2</p>%3<p>%4</p>%5<p>%6</p>%7")
        .arg(
            HelpWindow::tr("What a sweep can read"),
            HelpWindow::tr("The names that “Quantity” of a reading takes, with the unit in tables. Small: where a case "
                           "has it. One number or text each:"),
            table(single), HelpWindow::tr("With a value at each time of a run; “At” tells where it is taken:"),
            table(overTime), HelpWindow::tr("Values of “At”:"), table(places));
}

/// What `touchdown study statements paper --csv` wrote, a row for each statement.
QString paperTable(const QString& csv)
{
    QString html = QStringLiteral("<table cellpadding='4' cellspacing='0' border='0'>");
    const std::vector<std::vector<std::string>> rows = csvRows(csv.toStdString());
    const auto cell = [](const std::string& text) { return QString::fromStdString(text).toHtmlEscaped(); };
    for (const std::vector<std::string>& row : rows | std::views::drop(1)) {
        const auto of = [&](const char* column) {
            const auto found = std::ranges::find(rows.front(), column);
            return found == rows.front().end() ? QString() : cell(row.at(std::size_t(found - rows.front().begin())));
        };
        const bool holds = of("holds") == QLatin1String("yes");
        const auto under = [](const QString& text) {
            return text.isEmpty() ? QString() : QStringLiteral("<br><small>%1</small>").arg(text);
        };
        html += QStringLiteral("<tr><td><b>%1</b>%8</td><td>%2<br><code>%3</code></td><td>%4</td><td>%5%6%7</td></tr>")
                    .arg(of("figure"), of("statement"), of("command"),
                         holds ? HelpWindow::tr("✓ holds") : HelpWindow::tr("⚠ does not hold"),
                         of("found") + under(HelpWindow::tr("expected: %1").arg(of("expected"))), under(of("starts")),
                         under(of("remark")), under(of("candidate")));
    }
    return html + QStringLiteral("</table>");
}

} // namespace

HelpWindow::HelpWindow(const QString& shortcuts, QWidget* parent)
    : QWidget(parent, Qt::Window),
      shortcuts_(shortcuts),
      contents_(new QListWidget(this)),
      browser_(new OwnTextBrowser(this))
{
    setWindowTitle(tr("Touchdown: help"));
    contents_->addItems({tr("How to use it"), tr("The equations"), tr("The air film"), tr("Contact and disk"),
                         tr("What a result says of itself"), tr("The paper and this program"), tr("Glossary"),
                         tr("Parameters"), tr("What a sweep can read"), tr("Shortcuts"), tr("About Touchdown")});
    contents_->setAccessibleName(tr("Contents"));
    browser_->setAccessibleName(tr("Help text"));
    browser_->setOpenExternalLinks(true);
    browser_->document()->setDocumentMargin(16);
    connect(contents_, &QListWidget::currentRowChanged, this, [this](int row) {
        if (row >= 0) browser_->setHtml(html(static_cast<Page>(row)));
    });
    auto* splitter = new QSplitter(this);
    splitter->addWidget(contents_);
    splitter->addWidget(browser_);
    splitter->setStretchFactor(1, 1);
    splitter->setSizes({190, 640});
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(splitter);
    connect(new QShortcut(QKeySequence(Qt::Key_Escape), this), &QShortcut::activated, this, &QWidget::close);
    resize(860, 640);
}

void HelpWindow::open(Page page)
{
    contents_->setCurrentRow(static_cast<int>(page));
    if (isHidden()) placeOnScreen();
    show();
    raise();
    activateWindow();
}

/// In the middle of the window that it belongs to, with its frame within the screen.
void HelpWindow::placeOnScreen()
{
    const int title = 2 * style()->pixelMetric(QStyle::PM_TitleBarHeight, nullptr, this); // of other styles, too
    const QWidget& owner = parentWidget() ? *parentWidget() : *this;
    const QRect room = owner.screen()->availableGeometry().adjusted(8, 8, -8, -8 - title);
    resize(size().boundedTo(room.size()));
    QRect place(QPoint(), size());
    place.moveCenter(owner.frameGeometry().center());
    move(std::clamp(place.left(), room.left(), room.right() + 1 - width()),
         std::clamp(place.top(), room.top(), room.bottom() + 1 - height()));
}

QString HelpWindow::html(Page page) const
{
    switch (page) {
    case Page::Use: return resource(QStringLiteral("use.html"));
    case Page::Equations: return resource(QStringLiteral("equations.html"));
    case Page::AirFilm: return resource(QStringLiteral("air_film.html"));
    case Page::Contact: return resource(QStringLiteral("contact.html"));
    case Page::Results: return resource(QStringLiteral("results.html"));
    case Page::Paper:
        return resource(QStringLiteral("paper.html")) + paperTable(resource(QStringLiteral("paper.csv"))) +
               resource(QStringLiteral("paper_grids.html")) +
               paperTable(resource(QStringLiteral("film_fig5_to_8.csv")));
    case Page::Glossary:
        return QStringLiteral("<h2>%1</h2><p>%2</p>")
                   .arg(tr("Glossary"), tr("Terms of disk drives and of this program, with their symbols and units.")) +
               glossaryPage(glossaryEntries());
    case Page::Parameters: return parameterTable();
    case Page::Readings: return readingTable();
    case Page::Shortcuts:
        return QStringLiteral("<h2>%1</h2>").arg(tr("Shortcuts")) + shortcuts_ +
               resource(QStringLiteral("plot_keys.html"));
    case Page::About: break;
    }
    return resource(QStringLiteral("about.html"))
        .arg(QStringLiteral(TOUCHDOWN_VERSION), QString::fromLatin1(qVersion()));
}

} // namespace touchdown

// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a case may read outside its folder: only what the person at the window has allowed since its start.
#include "ui/case/case_files.h"

#include <QAbstractButton>
#include <QFileInfo>
#include <QMessageBox>

#include "core/case_files/case_file.h"
#include "core/case_files/case_reader.h"
#include "core/formats/quotation.h"

namespace touchdown {

namespace {

/// What a person allows: that a case reads these files outside its folder, and no others that it may name later.
QString permission(const QString& file, const std::vector<std::string>& outside)
{
    QString text = QFileInfo(file).absoluteFilePath();
    for (const std::string& name : outside) text += QLatin1Char('\n') + QString::fromStdString(name);
    return text;
}

} // namespace

CaseDocument CaseFiles::readAllowed(const QString& file, const std::function<CaseDocument(OutsidePaths)>& read) const
{
    CaseDocument document = read(OutsidePaths::Refused);
    if (document.outsideFiles.empty() || !allowed_.contains(permission(file, document.outsideFiles))) return document;
    CaseDocument whole = read(OutsidePaths::Allowed);
    return whole.text == document.text ? whole : document; // else it has just been changed
}

CaseDocument CaseFiles::readNow(const QString& fileOrSample) const
{
    return readAllowed(fileOrSample,
                       [&](OutsidePaths outside) { return openCase(fileOrSample.toStdString(), outside); });
}

CaseDocument CaseFiles::readState(const CaseState& state, const QString& text) const
{
    return readAllowed(state.file, [&](OutsidePaths outside) {
        return parseCase(text.toStdString(), state.name.toStdString(), state.folder.toStdString(), outside);
    });
}

void CaseFiles::askForOutsideFiles(const QString& file, const std::vector<std::string>& outside,
                                   const std::function<void()>& again, const std::function<void()>& refused)
{
    QStringList names;
    for (const std::string& name : outside) names << QString::fromStdString(inQuotes(name));
    auto* box = new QMessageBox(QMessageBox::Question, tr("Files outside the folder"),
                                tr("This case reads %1 outside its folder. Read it?").arg(names.join(tr(" and "))),
                                QMessageBox::Yes | QMessageBox::No, &window_);
    box->setObjectName(QStringLiteral("outsideFiles"));
    box->setInformativeText(tr("A case from another person could read a private file this way. Without the file the "
                               "case cannot be opened."));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setDefaultButton(QMessageBox::No);
    connect(box, &QMessageBox::buttonClicked, this,
            [this, box, asked = permission(file, outside), again, refused](QAbstractButton* button) {
                outside_ = nullptr; // it is answered
                if (box->standardButton(button) != QMessageBox::Yes) return refused();
                allowed_.insert(asked);
                again();
            });
    outside_ = box;
    box->open();
}

void CaseFiles::askBeforeRestoring(const CaseState& state, const std::function<void()>& next)
{
    // A name that led to the folder of the case may lead elsewhere by now.
    for (const QString& text : {state.savedText, state.modified ? state.text : QString()})
        if (const CaseDocument document = readState(state, text); !document.outsideFiles.empty())
            return askForOutsideFiles(
                state.file, document.outsideFiles, [this, state, next] { askBeforeRestoring(state, next); }, next);
    next();
}

} // namespace touchdown

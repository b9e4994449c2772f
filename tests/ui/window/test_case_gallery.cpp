// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/case_gallery.h"

#include <set>

#include <QSettings>
#include <QSignalSpy>
#include <QTest>

#include "core/case_files/case_file.h"
#include "tests/support/test_program.h"
#include "ui/case/case_files.h"
#include "ui/window/main_window.h"
#include "ui/window/window_actions.h"

using namespace touchdown;

namespace test_case_gallery {

class TestCaseGallery : public QObject {
    Q_OBJECT

private slots:
    void init() { QSettings().clear(); }

    void everySampleCaseIsOfOneTheme()
    {
        std::set<QString> names, themes;
        QString theme;
        for (const GalleryItem& item : sampleCaseItems()) {
            QVERIFY2(names.insert(item.name).second, qPrintable(item.name));
            if (item.theme != theme) QVERIFY2(themes.insert(item.theme).second, qPrintable(item.theme));
            theme = item.theme;
        }
        QCOMPARE(names.size(), sampleCases().size());
        QCOMPARE(themes.size(), std::size_t{5});
    }
    void wordsAndEnterChoose()
    {
        CaseGallery dialog(QStringLiteral("Gallery of cases"), sampleCaseItems(), nullptr);
        const QSignalSpy chosen(&dialog, &CaseGallery::chosen);
        dialog.open();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog));
        QVERIFY(!dialog.openButton()->isEnabled());
        QTest::keyClicks(dialog.words(), QStringLiteral("exact period"));
        QCOMPARE(dialog.gallery()->shownNames(), QStringList{QStringLiteral("textbook_bounce")});
        QVERIFY(dialog.openButton()->isEnabled());
        QTest::keyClick(dialog.words(), Qt::Key_Return);
        QCOMPARE(chosen.count(), 1);
        QCOMPARE(chosen.front().front().toString(), QStringLiteral("textbook_bounce"));
        QVERIFY(!dialog.isVisible());
    }
    /// Also where no title names them.
    void modelsAndContactsAreFound()
    {
        CaseGallery dialog(QStringLiteral("Gallery of cases"), sampleCaseItems(), nullptr);
        dialog.words()->setText(QStringLiteral("springs"));
        QVERIFY(dialog.gallery()->shownNames().contains(QStringLiteral("fig10a")));
        QVERIFY(!dialog.gallery()->shownNames().contains(QStringLiteral("film_pico")));
        dialog.words()->setText(QStringLiteral("asperities"));
        QVERIFY(dialog.gallery()->shownNames().contains(QStringLiteral("contact_greenwood_williamson")));
    }
    void wordsOfNoCaseChooseNothing()
    {
        CaseGallery dialog(QStringLiteral("Gallery of cases"), sampleCaseItems(), nullptr);
        dialog.words()->setText(QStringLiteral("no such words"));
        QVERIFY(!dialog.openButton()->isEnabled());
        QCOMPARE(dialog.gallery()->accessibleDescription(), QStringLiteral("No case has all of these words."));
    }
    void theWindowOpensTheCase()
    {
        MainWindow window;
        window.show();
        window.files().openNow(QStringLiteral("fig10a"));
        window.actions().caseGallery->trigger();
        auto* dialog = window.findChild<CaseGallery*>();
        QVERIFY(dialog != nullptr);
        const QSignalSpy opened(&window.files(), &CaseFiles::opened);
        emit dialog->gallery()->chosen(QStringLiteral("contact_hertz"));
        QTRY_COMPARE(opened.count(), 1);
        QCOMPARE(window.files().sample(), QStringLiteral("contact_hertz"));
    }
    /// A new case begins with a slider of the gallery, or with defaults; it is nobody's file and nothing to save.
    void aNewCaseBeginsWithASlider()
    {
        MainWindow window;
        window.show();
        const auto begin = [&](const QString& name) {
            window.actions().newCase->trigger();
            auto* dialog = window.findChild<CaseGallery*>();
            QVERIFY(dialog != nullptr);
            QCOMPARE(dialog->gallery()->shownNames().size(), qsizetype(sliderTemplates().size()) + 1);
            QVERIFY(dialog->openButton()->isEnabled()); // Enter takes the first
            const QSignalSpy opened(&window.files(), &CaseFiles::opened);
            emit dialog->gallery()->chosen(name);
            QTRY_COMPARE(opened.count(), 1);
            delete dialog;
        };
        begin(QStringLiteral("pico_three_rails"));
        QVERIFY(window.edits().value().model == ModelKind::Film);
        QCOMPARE(window.edits().value().surface.rails.size(), std::size_t(6));
        QVERIFY(window.files().file().isEmpty() && !window.files().modified());
        begin({});
        QVERIFY(window.edits().value() == Case{});
    }
};

TOUCHDOWN_TEST(TestCaseGallery)

} // namespace test_case_gallery

#include "test_case_gallery.moc"

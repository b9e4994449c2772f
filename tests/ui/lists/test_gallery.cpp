// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lists/gallery.h"

#include <algorithm>

#include <QDir>
#include <QFile>
#include <QImage>
#include <QSignalSpy>
#include <QTest>

#include "core/case_files/case_file.h"
#include "core/studies/study/sample_study.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_gallery {

std::vector<GalleryItem> fewItems()
{
    return {{"bounce", "Springs", "A bouncing mass", "It has an exact period.", {}, {}},
            {"drop", "Springs", "A drop", "It comes to rest.", {}, {}},
            {"pico", "Films", "A pico slider", "It flies at its static attitude.", {}, "asperities"}};
}

class TestGallery : public QObject {
    Q_OBJECT

private slots:
    void groupsByTheme()
    {
        Gallery gallery;
        gallery.setItems(fewItems());
        QCOMPARE(gallery.count(), 5); // two headings
        QVERIFY(gallery.at(0) == nullptr);
        QCOMPARE(gallery.item(0)->text(), QStringLiteral("Springs"));
        QCOMPARE(gallery.item(0)->flags(), Qt::ItemFlags(Qt::NoItemFlags));
        QCOMPARE(gallery.at(4)->name, QStringLiteral("pico"));
        QVERIFY(gallery.at(5) == nullptr);
    }
    void wordsNarrowIt_data()
    {
        QTest::addColumn<QString>("words");
        QTest::addColumn<QStringList>("shown");
        QTest::newRow("none") << "" << QStringList{"bounce", "drop", "pico"};
        QTest::newRow("of a title") << "BOUNC" << QStringList{"bounce"};
        QTest::newRow("of a sentence") << "rest" << QStringList{"drop"};
        QTest::newRow("of a theme") << "springs" << QStringList{"bounce", "drop"};
        QTest::newRow("of its own") << "asperities" << QStringList{"pico"};
        QTest::newRow("all of them") << " comes  drop " << QStringList{"drop"};
        QTest::newRow("of no item") << "drop pico" << QStringList{};
    }
    void wordsNarrowIt()
    {
        QFETCH(QString, words);
        QFETCH(QStringList, shown);
        Gallery gallery;
        gallery.setItems(fewItems());
        gallery.setCurrentRow(1);
        gallery.setWords(words);
        QCOMPARE(gallery.shownNames(), shown);
        QCOMPARE(gallery.item(0)->isHidden(), !shown.contains("bounce") && !shown.contains("drop"));
        QCOMPARE(gallery.item(3)->isHidden(), !shown.contains("pico"));
        QCOMPARE(gallery.currentRow(), shown.contains("bounce") ? 1 : -1);
        gallery.setWords({});
        QCOMPARE(gallery.shownNames().size(), 3);
    }
    void saysThatNothingIsFound()
    {
        Gallery gallery;
        gallery.setItems(fewItems());
        gallery.show();
        QVERIFY(QTest::qWaitForWindowExposed(&gallery));
        gallery.setWords(QStringLiteral("drop pico"));
        const QImage without = gallery.grab().toImage();
        gallery.setNothingFound(QStringLiteral("Nothing has all of these words."));
        gallery.setWords(QStringLiteral("drop pico"));
        QCOMPARE(gallery.accessibleDescription(), QStringLiteral("Nothing has all of these words."));
        QVERIFY(gallery.grab().toImage() != without);
        gallery.setWords(QStringLiteral("drop"));
        QCOMPARE(gallery.accessibleDescription(), QString());
    }
    void theKeyEnterChooses()
    {
        Gallery gallery;
        gallery.setItems(fewItems());
        gallery.show();
        QVERIFY(QTest::qWaitForWindowExposed(&gallery));
        const QSignalSpy chosen(&gallery, &Gallery::chosen);
        gallery.setCurrentRow(2);
        QTest::keyClick(&gallery, Qt::Key_Return);
        QCOMPARE(chosen.count(), 1);
        QCOMPARE(chosen.front().front().toString(), QStringLiteral("drop"));
        emit gallery.itemActivated(gallery.item(0)); // a heading chooses nothing
        QCOMPARE(chosen.count(), 1);
    }
    void drawsItemsWithAndWithoutAPicture()
    {
        QPixmap red(240, 160);
        red.fill(Qt::red);
        red.setDevicePixelRatio(2.0);
        std::vector<GalleryItem> items = fewItems();
        items[0].picture = red;
        Gallery gallery;
        gallery.resize(500, 400);
        gallery.setItems(std::move(items));
        gallery.show();
        QVERIFY(QTest::qWaitForWindowExposed(&gallery));
        const QImage image = gallery.grab().toImage();
        const auto inTheMiddleOf = [&](int row) {
            return image.pixelColor(gallery.visualItemRect(gallery.item(row)).topLeft() + QPoint(40, 30));
        };
        QCOMPARE(inTheMiddleOf(1), QColor(Qt::red));
        QVERIFY(inTheMiddleOf(2) != QColor(Qt::red));
    }
    void aNarrowListHasSmallPictures()
    {
        QPixmap white(240, 160);
        white.fill(Qt::white);
        std::vector<GalleryItem> items = fewItems();
        items[0].picture = white;
        Gallery gallery;
        gallery.setItems(std::move(items));
        gallery.show();
        gallery.resize(700, 400);
        QVERIFY(QTest::qWaitForWindowExposed(&gallery));
        QTRY_VERIFY(gallery.visualItemRect(gallery.item(1)).height() >= 80);
        QVERIFY(gallery.visualItemRect(gallery.item(2)).height() < 80); // no place is kept for a missing picture
        gallery.resize(300, 400);
        QTRY_VERIFY(gallery.visualItemRect(gallery.item(1)).height() < 80);
    }
    void firstSentences()
    {
        QCOMPARE(firstSentence("# SPDX-License-Identifier: X\n#\n# One 5.3 nm step\n# more. Two.\n\nkind = 1\n"),
                 QStringLiteral("One 5.3 nm step more."));
        QCOMPARE(firstSentence("# As in Fig. 12, or Figs. 5 to 8. Two.\n"),
                 QStringLiteral("As in Fig. 12, or Figs. 5 to 8."));
        QCOMPARE(firstSentence("# Does it fly? Yes.\n"), QStringLiteral("Does it fly?"));
        QCOMPARE(firstSentence("# A paragraph\n#\n# Another one.\n"), QStringLiteral("A paragraph."));
        QCOMPARE(firstSentence("kind = 1\n"), QString());
        QCOMPARE(withoutLicence("# SPDX-License-Identifier: X\n#\n# A.\n"), QStringLiteral("# A.\n"));
    }
    /// 240 x 160 pixels, at most 8 kB; CONTRIBUTING.md says how they are drawn. Cases whose runs take a minute, and
    /// most studies, have none.
    void samplesHaveTheirPictures()
    {
        const QStringList without{"fig05_fm_3_62mN", "fig06_", "fig07_", "fig08_"};
        std::size_t pictures = 0;
        const auto check = [&](const QString& name, bool needed) {
            QFile file(QStringLiteral(":/gallery/%1.png").arg(name));
            if (!needed && !file.exists()) return;
            ++pictures;
            QVERIFY2(file.open(QIODevice::ReadOnly), qPrintable(name));
            QVERIFY2(file.size() <= 8192, qPrintable(name));
            QCOMPARE(galleryPicture(name).size(), QSize(240, 160));
        };
        for (const SampleCase& each : sampleCases()) {
            const QString name = QString::fromStdString(each.name);
            const bool slow = std::ranges::any_of(without, [&](const QString& some) { return name.startsWith(some); });
            check("case_" + name, !slow);
        }
        const std::size_t ofCases = pictures;
        for (const SampleStudy& each : sampleStudies()) check("study_" + QString::fromStdString(each.name), false);
        QVERIFY(pictures >= ofCases + 9);
        QCOMPARE(std::size_t(QDir(QStringLiteral(":/gallery")).count()), pictures); // none of a sample that has gone
    }
    /// A sentence is a line or two of the gallery.
    void everySampleHasASentence()
    {
        const auto check = [&](const std::string& name, const std::string& text) {
            const QString about = firstSentence(text);
            QVERIFY2(about.size() >= 30 && about.size() <= 200, qPrintable(QString::fromStdString(name) + about));
            QVERIFY2(!about.contains(QLatin1Char('`')) && !about.contains(QStringLiteral(".toml")), qPrintable(about));
        };
        for (const SampleCase& each : sampleCases()) check(each.name, each.text);
        for (const SampleStudy& each : sampleStudies()) check(each.name, each.text);
    }
};

TOUCHDOWN_TEST(TestGallery)

} // namespace test_gallery

#include "test_gallery.moc"

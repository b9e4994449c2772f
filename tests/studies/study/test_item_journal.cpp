// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/study/item_journal.h"

#include <cmath>
#include <random>

#include <QtTest>

#include "tests/support/file_size_limit.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_item_journal {

namespace fs = std::filesystem;

class TestItemJournal : public QObject {
    Q_OBJECT

private slots:
    void init() { folder_ = std::make_unique<QTemporaryDir>(); }

    /// Any number and any text come back as they were, also line ends, tabs, backslashes and quotation marks.
    void rowsComeBack()
    {
        std::mt19937_64 random(5);
        for (int i = 0; i < 2000; ++i) {
            ItemRow row;
            for (int k = 0; k < 1 + int(random() % 6); ++k) {
                const std::uint64_t bits = random();
                double number = 0.0;
                std::memcpy(&number, &bits, sizeof number);
                std::string text;
                for (int c = 0; c < int(random() % 12); ++c) text += "ab\n\t\\\"n 1.-"[random() % 12];
                switch (random() % 3) {
                case 0: row.emplace_back(std::isfinite(number) ? number : 0.0); break;
                case 1: row.emplace_back(text); break;
                default: row.emplace_back();
                }
            }
            const auto back = readRow(rowText(row));
            QVERIFY(back.has_value());
            QVERIFY2(*back == row, rowText(row).c_str());
            QVERIFY(rowText(row).find('\n') == std::string::npos);
        }
        for (const char* none : {"1\tsix", "inf", "nan", "1.5xyz", "0x10", "1e999"})
            QVERIFY(!readRow(none).has_value());
        QVERIFY(!readRow("\"cut\\").has_value());
    }

    void goesOn()
    {
        KeptRows kept;
        {
            ItemJournal journal;
            QCOMPARE(journal.open(file(), false, kept), std::string());
            QCOMPARE(journal.keep("a", {1.0, std::string("x")}), std::string());
            QCOMPARE(journal.keep("b", {2.0, StudyValue()}), std::string());
        }
        QVERIFY(kept.empty());
        ItemJournal next;
        const std::string refused = next.open(file(), false, kept);
        QVERIFY2(refused.find("holds 2 rows of a study that was interrupted") != std::string::npos, refused.c_str());
        QCOMPARE(next.open(file(), true, kept), std::string());
        QCOMPARE(kept.size(), std::size_t(2));
        QVERIFY((kept.at("a") == ItemRow{1.0, std::string("x")}));
        next.remove();
        QVERIFY(!fs::exists(ItemJournal::besides(file())));
    }

    /// A program that was killed leaves a part of a line; a disk may have lost bytes. The rest stays.
    void damagedLinesArePassedOver()
    {
        KeptRows kept;
        {
            ItemJournal journal;
            QCOMPARE(journal.open(file(), false, kept), std::string());
            for (int i = 0; i < 20; ++i) QCOMPARE(journal.keep("k" + std::to_string(i), {double(i)}), std::string());
        }
        const std::string whole = text();
        std::mt19937 random(2);
        for (int trial = 0; trial < 200; ++trial) {
            std::string damaged = whole.substr(0, whole.size() - random() % 40);
            damaged[20 + random() % (damaged.size() - 20)] ^= char(1 + random() % 255);
            put(damaged);
            KeptRows some;
            ItemJournal journal;
            QCOMPARE(journal.open(file(), true, some), std::string());
            QVERIFY(some.size() >= 15 && some.size() <= 20);
            for (const auto& [key, row] : some) QCOMPARE("k" + std::to_string(int(std::get<double>(row[0]))), key);
            QCOMPARE(journal.keep("new", {7.0}), std::string());
            KeptRows again;
            ItemJournal third;
            QCOMPARE(third.open(file(), true, again), std::string());
            QCOMPARE(again.size(), some.size() + 1);
        }
    }

    void killedAtItsFirstLine()
    {
        for (const char* begun : {"", "touch", "touchdown-items 1"}) {
            put(begun);
            KeptRows kept;
            ItemJournal journal;
            QCOMPARE(journal.open(file(), false, kept), std::string());
            QCOMPARE(journal.keep("a", {1.0}), std::string());
            QVERIFY(text().starts_with("touchdown-items 1\na\t1\t"));
        }
        put("touchdown-items 10\n");
        KeptRows kept;
        ItemJournal journal;
        QVERIFY(!journal.open(file(), true, kept).empty());
    }

    void somethingElseStays()
    {
        put("my notes\n");
        KeptRows kept;
        ItemJournal journal;
        QVERIFY(journal.open(file(), true, kept).find("is in the way") != std::string::npos);
        QCOMPARE(text(), std::string("my notes\n"));
    }

    /// On a full disk the rows that are there stay.
    void aFullDisk()
    {
        KeptRows kept;
        ItemJournal journal;
        QCOMPARE(journal.open(file(), false, kept), std::string());
        QCOMPARE(journal.keep("a", {1.0}), std::string());
        {
            const FileSizeLimit limit(60);
            QVERIFY(journal.keep("b", {std::string(100, 'x')}).find("cannot write to ") != std::string::npos);
        }
        QCOMPARE(journal.keep("c", {3.0}), std::string());
        ItemJournal next;
        QCOMPARE(next.open(file(), true, kept), std::string());
        QCOMPARE(kept.size(), std::size_t(2));
        QVERIFY(kept.contains("a") && kept.contains("c"));
    }

private:
    fs::path file() const { return folder_->filePath("a.h5").toStdString(); }
    std::string text() const
    {
        QFile file(QString::fromStdString(ItemJournal::besides(this->file()).string()));
        return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
    }
    void put(const std::string& text) const
    {
        QFile file(QString::fromStdString(ItemJournal::besides(this->file()).string()));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(QByteArray::fromStdString(text));
    }
    std::unique_ptr<QTemporaryDir> folder_;
};

TOUCHDOWN_TEST(TestItemJournal)

} // namespace test_item_journal

#include "test_item_journal.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/sample_column.h"

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_sample_column {

class TestSampleColumn : public QObject {
    Q_OBJECT

private slots:
    void holdsWhatItTook()
    {
        SampleColumn column;
        constexpr std::size_t count = 2 * SampleColumn::pieceSize + 100;
        for (std::size_t i = 0; i < count; ++i) column.push_back(0.5 * static_cast<double>(i));
        QCOMPARE(column.size(), count);
        QCOMPARE(column.pieces(), std::size_t(3));
        QCOMPARE(column.piece(1).size(), SampleColumn::pieceSize);
        QCOMPARE(column.piece(2).size(), std::size_t(100));
        for (std::size_t i = 0; i < count; ++i) QCOMPARE(column[i], 0.5 * static_cast<double>(i));
        QCOMPARE(column.bytesInMemory(), (2 * SampleColumn::pieceSize + 128) * sizeof(double));
        column.shrink();
        QCOMPARE(column.bytesInMemory(), count * sizeof(double));
        QCOMPARE(column[count - 1], 0.5 * static_cast<double>(count - 1));
    }

    /// What is known of a piece on the disk: the numbers, and that memory has them no longer.
    void aPieceMovesToTheDisk()
    {
        SampleColumn column;
        for (std::size_t i = 0; i < SampleColumn::pieceSize + 10; ++i) column.push_back(1.0);
        const auto other = std::make_shared<double[]>(SampleColumn::pieceSize, 2.0);
        const std::shared_ptr<const double[]> before = column.owner(0);
        column.replace(0, other);
        QVERIFY(column.onDisk(0));
        QVERIFY(!column.onDisk(1));
        QCOMPARE(column.bytesOnDisk(), SampleColumn::pieceSize * sizeof(double));
        QCOMPARE(column.bytesInMemory(), 64 * sizeof(double));
        QCOMPARE(column[SampleColumn::pieceSize - 1], 2.0);
        QCOMPARE(column[SampleColumn::pieceSize], 1.0);
        QCOMPARE(before.use_count(), 1L); // nothing but this holds the memory
        column.push_back(3.0);
        QCOMPARE(column[SampleColumn::pieceSize + 10], 3.0);
    }

    void emptyHasNothing()
    {
        SampleColumn column;
        column.shrink();
        QVERIFY(column.empty());
        QCOMPARE(column.pieces(), std::size_t(0));
        QVERIFY(column.atHand(0, 10));
        QCOMPARE(column.bytesInMemory(), std::size_t(0));
    }
};

TOUCHDOWN_TEST(TestSampleColumn)

} // namespace test_sample_column

#include "test_sample_column.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/unnamed_file.h"

#include <csignal>
#include <sys/mman.h>
#include <sys/resource.h>

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_unnamed_file {

class TestUnnamedFile : public QObject {
    Q_OBJECT

private slots:
    void keepsTheNumbersWithoutAName()
    {
        const QTemporaryDir folder;
        const std::vector<double> first{1.0, -2.5, 1e-300}, second(10'000, 7.25);
        QString problem;
        const auto stored = toUnnamedFile(folder.filePath(QStringLiteral("new")), {first, second}, problem);
        QVERIFY2(stored, qPrintable(problem));
        QVERIFY(std::equal(first.begin(), first.end(), stored.get()));
        QVERIFY(std::equal(second.begin(), second.end(), stored.get() + 3));
        QVERIFY(QDir(folder.filePath(QStringLiteral("new"))).isEmpty(QDir::Files | QDir::Hidden));
        QVERIFY(atHand({stored.get(), 10'003}));
        letGo({stored.get(), 10'003});
        QCOMPARE(stored[5000], 7.25);
    }

    /// A limit of the system on the size of files stands in for a disk that is full.
    void aFullDiskLeavesNothing()
    {
        const QTemporaryDir folder;
        rlimit before{};
        ::getrlimit(RLIMIT_FSIZE, &before);
        const rlimit small{1000, before.rlim_max};
        const auto signalBefore = std::signal(SIGXFSZ, SIG_IGN);
        ::setrlimit(RLIMIT_FSIZE, &small);
        QString problem;
        const auto stored = toUnnamedFile(folder.path(), {std::vector<double>(1000)}, problem);
        ::setrlimit(RLIMIT_FSIZE, &before);
        std::signal(SIGXFSZ, signalBefore);
        QVERIFY(!stored);
        QVERIFY(problem.contains(folder.path()));
        QVERIFY(QDir(folder.path()).isEmpty(QDir::Files | QDir::Hidden));
    }

    void aFolderThatCannotBe()
    {
        QString problem;
        QVERIFY(!toUnnamedFile(QStringLiteral("/dev/null/runs"), {std::vector{1.0}}, problem));
        QVERIFY(problem.contains(QStringLiteral("/dev/null/runs")));
    }

    /// Pages that the system has dropped are read again in the background.
    void whatIsNotInMemoryIsReadOnRequest()
    {
#ifdef MADV_PAGEOUT
        const QTemporaryDir folder;
        const std::vector<double> numbers(3'000'000, 3.5); // 24 MB: more than systems read ahead at once
        QString problem;
        const auto stored = toUnnamedFile(folder.path(), {numbers}, problem);
        QVERIFY2(stored, qPrintable(problem));
        const std::span<const double> all{stored.get(), numbers.size()};
        double sum = 0.0;
        for (const double each : all) sum += each; // a page must be mapped to be dropped
        QCOMPARE(sum, 10.5e6);
        ::madvise(const_cast<double*>(stored.get()), all.size_bytes(), MADV_PAGEOUT);
        if (atHand(all)) QSKIP("this system does not drop the pages");
        QTRY_VERIFY(atHand(all));
        QCOMPARE(all[777'777], 3.5);
#else
        QSKIP("this system cannot drop pages on request");
#endif
    }
};

TOUCHDOWN_TEST(TestUnnamedFile)

} // namespace test_unnamed_file

#include "test_unnamed_file.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calculation/task_queue.h"

#include <algorithm>
#include <latch>
#include <stdexcept>
#include <thread>
#include <vector>

#include <QCoreApplication>
#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_task_queue {

class TestTaskQueue : public QObject {
    Q_OBJECT

private slots:
    void performsInOrderAndAnswersOnThisThread()
    {
        TaskQueue queue(nullptr);
        std::vector<int> performed;
        QStringList answers;
        const auto here = std::this_thread::get_id();
        for (int i = 0; i < 20; ++i)
            queue.post(
                [&performed, i] {
                    performed.push_back(i);
                    return i % 2 == 0 ? QString() : QString::number(i);
                },
                [&answers, here](const QString& problem) {
                    if (std::this_thread::get_id() == here) answers << problem;
                },
                100);
        queue.wait();
        QCOMPARE(queue.pending(), std::size_t(0));
        QCOMPARE(performed.size(), std::size_t(20));
        QVERIFY(std::ranges::is_sorted(performed));
        QVERIFY(answers.isEmpty()); // they follow as events
        QTRY_COMPARE(answers.size(), 20);
        QCOMPARE(answers[3], QStringLiteral("3"));
        QCOMPARE(answers[4], QString());
    }

    void anExceptionIsAProblem()
    {
        TaskQueue queue(nullptr);
        QString problem;
        queue.post([]() -> QString { throw std::runtime_error("no luck"); },
                   [&problem](const QString& text) { problem = text; });
        QTRY_COMPARE(problem, QStringLiteral("no luck"));
    }

    void performsWhatWasAskedForBeforeItEnds()
    {
        int performed = 0;
        bool answered = false;
        std::latch posted(1); // all tasks wait while the queue is about to end
        {
            TaskQueue queue(nullptr);
            for (int i = 0; i < 5; ++i)
                queue.post(
                    [&performed, &posted] {
                        posted.wait();
                        ++performed;
                        return QString();
                    },
                    [&answered](const QString&) { answered = true; });
            posted.count_down();
        }
        QCoreApplication::sendPostedEvents();
        QCOMPARE(performed, 5);
        QVERIFY(!answered);
    }
};

TOUCHDOWN_TEST(TestTaskQueue)

} // namespace test_task_queue

#include "test_task_queue.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/replay_bar.h"

#include <algorithm>

#include <QLabel>
#include <QSignalSpy>
#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_replay_bar {

class TestReplayBar : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        span_ = PlotRange{1e-3, 2e-3};
        bar_ = std::make_unique<ReplayBar>([this] { return span_; });
        bar_->show();
        bar_->showTime(std::nullopt);
        chosen_.clear();
        connect(bar_.get(), &ReplayBar::timeChosen, this, [this](double time) {
            chosen_.push_back(time);
            bar_->showTime(time); // as the plots do
        });
    }
    void cleanup() { bar_.reset(); }
    /// From the end it begins anew; a pass of ten seconds shows all.
    void plays()
    {
        bar_->setPlaying(true);
        QVERIFY(bar_->playing());
        QCOMPARE(chosen_.at(0), 1e-3);
        bar_->advance(0.25 * ReplayBar::passSeconds);
        QVERIFY(std::abs(chosen_.back() - 1.25e-3) < 1e-9);
        bar_->advance(0.5 * ReplayBar::passSeconds);
        QVERIFY(std::abs(chosen_.back() - 1.75e-3) < 1e-9);
        QCOMPARE(bar_->slider()->value(), 750);
        bar_->advance(ReplayBar::passSeconds);
        QCOMPARE(chosen_.back(), 2e-3);
        QVERIFY(!bar_->playing());
    }
    void goesOnAfterAPause()
    {
        QTest::mouseClick(bar_->button(), Qt::LeftButton);
        bar_->advance(0.5 * ReplayBar::passSeconds);
        QTest::mouseClick(bar_->button(), Qt::LeftButton);
        QVERIFY(!bar_->playing());
        const std::size_t before = chosen_.size();
        QTest::mouseClick(bar_->button(), Qt::LeftButton);
        bar_->advance(0.0);
        QVERIFY(chosen_.size() > before && chosen_.back() >= 1.5e-3 - 1e-9);
    }
    void scrubs()
    {
        bar_->setPlaying(true);
        bar_->slider()->setValue(500);
        QVERIFY(!bar_->playing());
        QCOMPARE(chosen_.back(), 1.5e-3);
    }
    /// The time was chosen elsewhere: nothing is sent back.
    void follows()
    {
        bar_->showTime(1.25e-3);
        QCOMPARE(bar_->slider()->value(), 250);
        QVERIFY(chosen_.empty());
        bar_->showTime(5e-3);
        QCOMPARE(bar_->slider()->value(), 1000);
    }
    /// 1 ms in ten seconds.
    void saysItsSpeed()
    {
        const auto says = [this](const QString& text) {
            const auto labels = bar_->findChildren<QLabel*>();
            return std::ranges::any_of(labels, [&](const QLabel* label) { return label->text() == text; });
        };
        QVERIFY(says(QStringLiteral("100.0\u00a0µs per second")));
        span_ = PlotRange{0.0, 2e-4};
        bar_->showTime(std::nullopt);
        QVERIFY(says(QStringLiteral("20.00\u00a0µs per second")));
    }
    void withoutARun()
    {
        span_.reset();
        bar_->showTime(std::nullopt);
        bar_->setPlaying(true);
        QVERIFY(!bar_->playing());
        QVERIFY(chosen_.empty());
    }
    void stopsWhenHidden()
    {
        bar_->setPlaying(true);
        bar_->hide();
        QVERIFY(!bar_->playing());
    }

private:
    std::optional<PlotRange> span_;
    std::unique_ptr<ReplayBar> bar_;
    std::vector<double> chosen_;
};

TOUCHDOWN_TEST(TestReplayBar)

} // namespace test_replay_bar

#include "test_replay_bar.moc"

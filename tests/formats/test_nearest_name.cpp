// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/nearest_name.h"

#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_nearest_name {

class TestNearestName : public QObject {
    Q_OBJECT

private slots:
    void finds_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("nearest");
        QTest::newRow("the name itself") << "pitch"
                                         << "pitch";
        QTest::newRow("a letter missing") << "pich"
                                          << "";
        QTest::newRow("a letter missing in a word of five") << "thicness"
                                                            << "thickness";
        QTest::newRow("a letter too many") << "masss"
                                           << "mass";
        QTest::newRow("a wrong letter") << "pitsh"
                                        << "pitch";
        QTest::newRow("two letters swapped") << "picth"
                                             << "pitch";
        QTest::newRow("nothing like it") << "banana"
                                         << "";
        QTest::newRow("empty") << ""
                               << "";
    }
    void finds()
    {
        QFETCH(QString, name);
        QFETCH(QString, nearest);
        const std::vector<std::string> names{"mass", "pitch", "thickness"};
        QCOMPARE(
            QString::fromStdString(nearestName(name.toStdString(), names, static_cast<std::size_t>(name.size() / 5))),
            nearest);
    }
    void theNearestOfSeveralWins()
    {
        QCOMPARE(nearestName("fig10c", {"fig11a", "fig10a", "fig10b"}), std::string("fig10a"));
    }
    void endlessNamesCostNothing()
    {
        QCOMPARE(nearestName(std::string(1 << 20, 'a'), {"mass"}, 1u << 20), std::string());
    }
    void question()
    {
        QCOMPARE(didYouMean("mass"), std::string("; did you mean mass?"));
        QCOMPARE(didYouMean(""), std::string());
    }
};

TOUCHDOWN_TEST(TestNearestName)

} // namespace test_nearest_name

#include "test_nearest_name.moc"

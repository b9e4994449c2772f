// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/study_plan.h"

#include <algorithm>

#include <QtTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_study_keys {

DescribedKey find(const std::string& kind, const std::string& name)
{
    const std::vector<DescribedKey> keys = studyKeys(kind);
    const auto key = std::ranges::find_if(keys, [&](const DescribedKey& each) { return each.key.key == name; });
    if (key == keys.end()) qFatal("%s has no %s", kind.c_str(), name.c_str());
    return *key;
}

class TestStudyKeys : public QObject {
    Q_OBJECT

private slots:
    void everyKind_data()
    {
        QTest::addColumn<QString>("kind");
        for (const StudyKind& each : studyKinds())
            QTest::newRow(each.name.c_str()) << QString::fromStdString(each.name);
    }
    /// The keys of the head, and some of its own, each with what it takes.
    void everyKind()
    {
        QFETCH(QString, kind);
        const std::vector<DescribedKey> keys = studyKeys(kind.toStdString());
        QVERIFY(keys.size() > 4);
        for (const char* head : {"title", "kind", "case", "set"})
            QVERIFY2(std::ranges::count_if(keys, [&](const DescribedKey& each) { return each.key.key == head; }) == 1,
                     head);
        for (const DescribedKey& each : keys)
            QVERIFY2(!each.allowed.empty() && !each.key.help.empty(), each.key.key.c_str());
        QVERIFY(std::ranges::any_of(keys, [](const DescribedKey& each) { return !each.standards.empty(); }));
        // Keys of tables come last, whatever models they are of.
        QVERIFY(std::ranges::is_partitioned(
            keys, [](const DescribedKey& each) { return each.key.key.find('.') == std::string::npos; }));
    }
    void aNumber()
    {
        const DescribedKey hold = find("hysteresis", "hold");
        QCOMPARE(hold.allowed, std::string("from 0.1 us to 1e6 us"));
        QCOMPARE(hold.key.unit, std::string("s"));
        QCOMPARE(hold.key.displayUnit, std::string("us"));
        QCOMPARE(hold.standards.front(), (std::pair<std::string, std::string>{"springs", "2000 us"}));
        QCOMPARE(hold.key.help, std::string("time at each value; its last tenth is evaluated"));
        QVERIFY(!hold.varies);
        QVERIFY(find("hysteresis", "from").varies); // it is of the parameter
    }
    /// What a template only offers has a default, too.
    void anOffer()
    {
        const DescribedKey starts = find("work-precision", "ensemble.starts");
        QCOMPARE(starts.standards.front().second, std::string("300"));
        QVERIFY(!starts.key.inList);
        QVERIFY(find("work-precision", "method.name").key.inList);
    }
    /// Advice is of films alone.
    void oneModel()
    {
        const DescribedKey tolerance = find("advise", "tolerance");
        QCOMPARE(tolerance.standards.size(), std::size_t{1});
        QCOMPARE(tolerance.standards.front().first, std::string("film"));
    }
    void noSuchKind() { QVERIFY(studyKeys("hysterese").empty()); }
};

TOUCHDOWN_TEST(TestStudyKeys)

} // namespace test_study_keys

#include "test_study_keys.moc"

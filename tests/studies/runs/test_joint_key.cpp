// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/studies/runs/joint_key.h"

#include <QTest>

#include "tests/support/sample_case.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_joint_key {

class TestJointKey : public QObject {
    Q_OBJECT

private slots:
    void movesTogether()
    {
        Case c = sample("fig10a");
        const JointKey joint = std::get<JointKey>(of(c, {"springs.front_stiffness", "springs.rear_stiffness"}));
        QCOMPARE(setFromNumber(c, joint.key, 7e5).value_or(""), std::string());
        QCOMPARE(c.springs.frontStiffness, 7e5);
        QCOMPARE(c.springs.rearStiffness, 7e5);
        QCOMPARE(joint.key.key, std::string("springs.front_stiffness, springs.rear_stiffness"));
        QVERIFY2(joint.text.label.find(" and ") != std::string::npos, joint.text.label.c_str());
    }
    /// The range of both: a mass is above zero, a height is not.
    void theNarrowerRange()
    {
        Case c = sample("fig10a");
        const JointKey joint = std::get<JointKey>(of(c, {"ono_yamane.touch_down", "ono_yamane.take_off"}));
        for (const Parameter& each : {*findParameter("ono_yamane.touch_down"), *findParameter("ono_yamane.take_off")}) {
            QVERIFY(joint.key.minimum >= each.minimum);
            QVERIFY(joint.key.maximum <= each.maximum);
        }
    }
    void refuses()
    {
        const Case c = sample("fig10a");
        QCOMPARE(std::get<std::string>(of(c, {"springs.front_stiffness", "springs.pitch"})),
                 std::string("\"springs.pitch\" has another unit than \"springs.front_stiffness\" and cannot take the "
                             "same value"));
        const std::string unknown = std::get<std::string>(of(c, {"springs.front_stifness"}));
        QVERIFY2(unknown.find("springs.front_stiffness") != std::string::npos, unknown.c_str());
    }

private:
    static std::variant<JointKey, std::string> of(const Case& c, const std::vector<std::string>& keys)
    {
        return jointKey(keys, [&](std::string_view key) { return caseKey(c, key); });
    }
};

TOUCHDOWN_TEST(TestJointKey)

} // namespace test_joint_key

#include "test_joint_key.moc"

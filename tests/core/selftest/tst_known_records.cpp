// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/selftest/known_records.h"
#include "core/selftest/passing_folder.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <fstream>

using namespace dyncal;

class TestKnownRecords : public QObject
{
    Q_OBJECT

private slots:
    void sharpStep_isAtItsSample()
    {
        const Eigen::VectorXd step = sharpStep(10, 4, 1.0, 2.0);
        QCOMPARE(step[3], 1.0);
        QCOMPARE(step[4], 3.0);
        QCOMPARE(step[9], 3.0);
    }

    void shockRecords_haveTheirRolesAndArrivals()
    {
        const CaptureSet set = shockRecords();
        const Shot &shot = set.shots.at(0);
        QVERIFY(shot.channelWithRole(ChannelRole::Dut));
        const Channel *near = shot.channelCalled("near"), *far = shot.channelCalled("far");
        QVERIFY(near && far && near->role == ChannelRole::DrivenSide);
        QCOMPARE(physicalValues(*far, 1999, 2), Eigen::VectorXd(Eigen::Vector2d(0.0, 1.0)));
        QCOMPARE(physicalValues(*near, 2999, 2), Eigen::VectorXd(Eigen::Vector2d(0.0, 1.0)));
        QCOMPARE(near->timeOf_s(3000), 3e-3);
    }

    /// Nothing of it is left, and two of them do not meet.
    void passingFolder_isGoneAtTheEnd()
    {
        std::string path;
        {
            const PassingFolder folder, other;
            path = folder.file("one");
            QVERIFY(path != other.file("one"));
            std::ofstream(path) << "something";
            QVERIFY(std::filesystem::exists(path));
            const auto rights = std::filesystem::status(std::filesystem::path(path).parent_path());
            QVERIFY(rights.permissions() == std::filesystem::perms::owner_all);
        }
        QVERIFY(!std::filesystem::exists(std::filesystem::path(path).parent_path()));
    }
};

DYNCAL_TEST(TestKnownRecords)
#include "tst_known_records.moc"

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/session/import_choices.h"

#include <QtTest>

using namespace dyncal;

namespace {

/// A text table: times, then two channels of which the first is the DUT.
ImportView table()
{
    ImportView view;
    view.format = "text";
    view.channels = {{"p", "V", ChannelRole::Dut, ChannelRole::Dut, 1, 100},
        {"side", "V", ChannelRole::Other, ChannelRole::Other, 2, 100}};
    return view;
}

/// An HDF5 file of another program.
ImportView datasets()
{
    ImportView view = table();
    view.format = "hdf5";
    for (ImportChannel &channel : view.channels)
        channel.column.reset();
    view.datasets.resize(2);
    return view;
}

} // namespace

class TestImportChoices : public QObject
{
    Q_OBJECT

private slots:
    void times_fromAColumn_isNamed();
    void times_none_namesTheColumnsOfSamples();
    void times_none_withoutADut_namesOneColumn();
    void times_automatic_forgetsTheChoice();
    void shotColumns_forgetRolesAndKeepTheTimes();
    void shotColumns_timesNone_leavesTheirColumnOut();
    void role_secondDut_takesItFromTheFirst();
    void role_withTimesLeftOut_namesItsColumnAndReadsAgain();
    void role_ofADataset_namesAllThatAreRead();
    void dataset_withoutARole_isNotRead();
    void dataset_secondDut_takesItFromTheFirst();
    void reason_isNeededWhereTheFileSaysOtherwise();
};

void TestImportChoices::times_fromAColumn_isNamed()
{
    ImportSettings settings;
    chooseTimes(settings, table(), TimeFirstColumn + 2);
    QCOMPARE(settings.columns.at("time"), Index(2));
    QVERIFY(!leavesTimesOut(settings));
}

void TestImportChoices::times_none_namesTheColumnsOfSamples()
{
    ImportSettings settings;
    chooseTimes(settings, table(), TimeNone);
    QVERIFY(leavesTimesOut(settings));
    QCOMPARE(settings.columns.size(), std::size_t(1));
    QCOMPARE(settings.columns.at(channelRoleName(ChannelRole::Dut)), Index(1));
}

void TestImportChoices::times_none_withoutADut_namesOneColumn()
{
    ImportView view = table();
    view.channels[0].role = ChannelRole::Other;
    ImportSettings settings;
    chooseTimes(settings, view, TimeNone);
    QVERIFY(leavesTimesOut(settings));
    QCOMPARE(settings.columns.at(channelRoleName(ChannelRole::Other)), Index(1));
}

void TestImportChoices::times_automatic_forgetsTheChoice()
{
    ImportSettings settings;
    chooseTimes(settings, table(), TimeNone);
    chooseTimes(settings, table(), TimeAuto);
    QVERIFY(settings.columns.empty());
}

void TestImportChoices::shotColumns_forgetRolesAndKeepTheTimes()
{
    ImportSettings settings;
    settings.columns = {{"time", 0}, {"dut", 1}};
    settings.channels = {{"side", "driven_side"}, {"elsewhere", "dut"}};
    settings.channelDetails["p"].gain = 10.0;
    chooseShotColumns(settings, table(), true);
    QCOMPARE(settings.columnsAre, std::string("shots"));
    QCOMPARE(settings.columns, (std::map<std::string, Index>{{"time", 0}}));
    // A channel that this table no longer has would stop the import.
    QCOMPARE(settings.channels, (std::map<std::string, std::string>{{"elsewhere", "dut"}}));
    QVERIFY(settings.channelDetails.empty());

    ImportView shots;
    shots.channels = {{"DUT", "V", ChannelRole::Dut, ChannelRole::Dut, 1, 100}};
    settings.channelDetails["DUT"].gain = 10.0;
    chooseShotColumns(settings, shots, false);
    QCOMPARE(settings.columnsAre, std::string("channels"));
    QVERIFY(settings.channelDetails.empty());
}

void TestImportChoices::shotColumns_timesNone_leavesTheirColumnOut()
{
    ImportView view = table();
    view.text = TextPreview();
    view.text->shots = {0, 1, 2};
    view.text->timeColumn = 0;
    ImportSettings settings;
    chooseShotColumns(settings, view, true);
    chooseTimes(settings, view, TimeNone);
    QVERIFY(leavesTimesOut(settings));
    QCOMPARE(settings.columns, (std::map<std::string, Index>{{"other", 0}}));
    view.text->timeColumn.reset(); // there are none to be left out
    view.text->shots = {1, 2, 3};
    chooseTimes(settings, view, TimeNone);
    QVERIFY(settings.columns.empty());
}

void TestImportChoices::role_secondDut_takesItFromTheFirst()
{
    ImportView view = table();
    ImportSettings settings;
    QVERIFY(!chooseRole(settings, view, "side", ChannelRole::Dut));
    QCOMPARE(view.channels[0].role, ChannelRole::Other);
    QCOMPARE(view.channels[1].role, ChannelRole::Dut);
}

void TestImportChoices::role_withTimesLeftOut_namesItsColumnAndReadsAgain()
{
    ImportView view = table();
    ImportSettings settings;
    chooseTimes(settings, view, TimeNone);
    QVERIFY(chooseRole(settings, view, "side", ChannelRole::Dut));
    QVERIFY(leavesTimesOut(settings));
    QCOMPARE(settings.columns.at(channelRoleName(ChannelRole::Dut)), Index(2));
}

void TestImportChoices::role_ofADataset_namesAllThatAreRead()
{
    ImportView view = datasets();
    ImportSettings settings;
    QVERIFY(!chooseRole(settings, view, "side", ChannelRole::DrivenSide));
    QCOMPARE(settings.channels.size(), std::size_t(2));
    QCOMPARE(settings.channels.at("p"), std::string(channelRoleName(ChannelRole::Dut)));
    QCOMPARE(settings.channels.at("side"), std::string(channelRoleName(ChannelRole::DrivenSide)));
}

void TestImportChoices::dataset_withoutARole_isNotRead()
{
    ImportSettings settings;
    chooseDatasetRole(settings, datasets(), "side", std::nullopt);
    QCOMPARE(settings.channels.size(), std::size_t(1));
    QVERIFY(settings.channels.contains("p"));
}

void TestImportChoices::dataset_secondDut_takesItFromTheFirst()
{
    ImportSettings settings;
    chooseDatasetRole(settings, datasets(), "side", ChannelRole::Dut);
    QCOMPARE(settings.channels.at("p"), std::string(channelRoleName(ChannelRole::Other)));
    QCOMPARE(settings.channels.at("side"), std::string(channelRoleName(ChannelRole::Dut)));
}

void TestImportChoices::reason_isNeededWhereTheFileSaysOtherwise()
{
    ImportView view = table();
    ImportSettings settings;
    view.sampleRate_Hz = 1e6;
    QVERIFY(!needsRateReason(settings, view)); // nothing typed
    settings.sampleRate_Hz = 1e6;
    QVERIFY(!needsRateReason(settings, view));
    settings.sampleRate_Hz = 2e6;
    QVERIFY(needsRateReason(settings, view));
    view.sampleRate_Hz = 0.0; // the file says nothing
    QVERIFY(!needsRateReason(settings, view));
}

DYNCAL_TEST(TestImportChoices)
#include "tst_import_choices.moc"

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The parts that the reader of LabVIEW files is made of, one by one.

#include "core/capture/formats/lvm/lvm_header.h"
#include "core/capture/formats/text/text_table.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;

namespace {

/// A multi-channel LVM head up to the line of names, tab separated.
const char *const kLvmSegment = "Channels\t2\t\t\t\n"
                                "Samples\t10\t\t20\t\n"
                                "X0\t-0,5\t\t0.25\t\n"
                                "Delta_X\t1E-6\t\t2E-6\t\n"
                                "Y_Unit_Label\tVolts\t\tbar\t\n"
                                "Notes\tcold day\n"
                                "***End_of_Header***\n";

LvmTags tagsOf(const char *text)
{
    LineCursor lines(text);
    LvmTags tags;
    readLvmTags(lines, {}, '\t', tags);
    return tags;
}

} // namespace

class TestLvmParts : public QObject
{
    Q_OBJECT

private slots:
    void lvmSeparator_standsBehindATag();
    void lvmTags_special_isPassedOver();
    void lvmFileHeader_words();
    void lvmSegment_multi_everyChannelItsColumn();
    void lvmSegment_claims_areChecked();
    void lvmSegment_badNumbers_areUnknown();
};

void TestLvmParts::lvmSeparator_standsBehindATag()
{
    QCOMPARE(lvmSeparator("LabVIEW Measurement\t\nWriter_Version\t2\n"), '\t');
    QCOMPARE(lvmSeparator("LabVIEW Measurement,\nSeparator,Comma\n"), ',');
    QCOMPARE(lvmSeparator("***End_of_Header***,\nSeparator\tTab\n"), ',');
    QCOMPARE(lvmSeparator("***End_of_Header***\nSeparator,Comma\n"), '\t'); // behind the header
    QCOMPARE(lvmSeparator(""), '\t');
}

void TestLvmParts::lvmTags_special_isPassedOver()
{
    LineCursor lines("***Start_Special***\nOperator\tnobody\n***End_of_Header***\n"
                     "***End_Special***\n\nOperator\tsomebody\nOperator\tlater\n"
                     "***End_of_Header***\t\nrest\n");
    LvmTags tags;
    QVERIFY(readLvmTags(lines, "Project\tx", '\t', tags));
    QCOMPARE(tags.at("Operator").at(0), std::string_view("somebody")); // the first one counts
    QCOMPARE(tags.at("Project").at(0), std::string_view("x"));
    std::string_view rest;
    QVERIFY(lines.next(rest) && rest == "rest");
    LineCursor endless("Operator\tx\n");
    QVERIFY(!readLvmTags(endless, {}, '\t', tags));
}

void TestLvmParts::lvmFileHeader_words()
{
    const LvmFileHeader comma
        = lvmFileHeader(tagsOf("Decimal_Separator\t,\nX_Columns\tMulti\nOperator\tJ\xF8rgen\n"
                               "Date\t2024/05/06\nTime\t01:02:03\n***End_of_Header***\n"),
            '\t');
    QCOMPARE(comma.decimal.value_or('?'), ',');
    QCOMPARE(comma.xColumns, LvmXColumns::Multi);
    QCOMPARE(comma.notes.at("operator"), std::string("J\xC3\xB8rgen"));
    QCOMPARE(comma.notes.at("start_local"), std::string("2024/05/06 01:02:03"));
    const LvmFileHeader plain
        = lvmFileHeader(tagsOf("X_Columns\tNo\nDate\t1903/12/31\n***End_of_Header***\n"), '\t');
    QVERIFY(!plain.decimal && plain.notes.empty()); // that date means none
    QCOMPARE(plain.xColumns, LvmXColumns::None);
    QCOMPARE(lvmFileHeader({}, ',').xColumns, LvmXColumns::One);
}

void TestLvmParts::lvmSegment_multi_everyChannelItsColumn()
{
    LvmFileHeader file;
    file.xColumns = LvmXColumns::Multi;
    const auto segment
        = lvmSegment(tagsOf(kLvmSegment), "X_Value\tDUT\tX_Value\tside\tComment", file);
    QVERIFY(segment.has_value());
    QCOMPARE(segment->channels.size(), std::size_t(2));
    const LvmChannel &dut = segment->channels[0];
    const LvmChannel &side = segment->channels[1];
    QCOMPARE(dut.name, std::string("DUT"));
    QCOMPARE(dut.column, Index(1));
    QCOMPARE(dut.xColumn.value_or(-1), Index(0));
    QCOMPARE(dut.x0, -0.5); // either decimal mark
    QCOMPARE(dut.deltaX, 1e-6);
    QCOMPARE(dut.declaredSamples.value_or(-1), Index(10));
    QCOMPARE(side.name, std::string("side"));
    QCOMPARE(side.column, Index(3));
    QCOMPARE(side.xColumn.value_or(-1), Index(2));
    QCOMPARE(side.unit, std::string("bar"));
    QCOMPARE(side.deltaX, 2e-6);
    QCOMPARE(side.declaredSamples.value_or(-1), Index(20));
    QCOMPARE(segment->notes.at("comment"), std::string("cold day"));
}

void TestLvmParts::lvmSegment_claims_areChecked()
{
    LvmFileHeader file;
    const char *end = "***End_of_Header***\n";
    const auto claimed = [&](const std::string &count, const char *names) {
        const std::string text = "Channels\t" + count + "\n" + end;
        LineCursor lines(text);
        LvmTags tags;
        readLvmTags(lines, {}, '\t', tags);
        const auto segment = lvmSegment(tags, names, file);
        return segment ? static_cast<int>(segment->channels.size()) : -1;
    };
    QCOMPARE(claimed("2", "X_Value\ta\tb\tComment"), 2);
    QCOMPARE(claimed("1", "X_Value\ta\tb\tComment"), 1);
    QCOMPARE(claimed("3", "X_Value\ta\tb\tComment"), -1);
    QCOMPARE(claimed("1e15", "X_Value\ta\tComment"), -1);
    QCOMPARE(claimed("0", "X_Value\ta\tComment"), -1);
    QCOMPARE(claimed("-1", "X_Value\ta\tComment"), 1); // no count: the names tell
    QCOMPARE(claimed("many", "X_Value\ta\tb"), 2);
    QCOMPARE(claimed("1", ""), -1);
    QCOMPARE(claimed("1", "X_Value"), -1);
}

void TestLvmParts::lvmSegment_badNumbers_areUnknown()
{
    const auto segment = lvmSegment(
        tagsOf("Channels\t1\nSamples\t1e300\nX0\tnan\nDelta_X\t-1\n***End_of_Header***\n"),
        "X_Value\ta\tComment", {});
    QVERIFY(segment.has_value());
    QVERIFY(!segment->channels[0].declaredSamples);
    QCOMPARE(segment->channels[0].x0, 0.0);
    QCOMPARE(segment->channels[0].deltaX, 0.0);
}

DYNCAL_TEST(TestLvmParts)
#include "tst_lvm_parts.moc"

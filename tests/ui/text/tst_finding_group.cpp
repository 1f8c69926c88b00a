// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/text/finding_group.h"
#include "ui/text/finding_text.h"

#include <QtTest>

using namespace dyncal;

namespace {

Finding overrun(Index shot, const char *by)
{
    return {.id = "WIN-001",
        .severity = Severity::Caution,
        .shot = shot,
        .message = {"Shot %1: the window ends %2 after the plateau.", {std::to_string(shot), by}}};
}

Finding other(const char *id, Severity severity, const char *text)
{
    return {.id = id, .severity = severity, .message = {text, {}}};
}

} // namespace

class TestFindingGroup : public QObject
{
    Q_OBJECT

private slots:
    void same_areOneGroup_gravestFirst();
    void line_namesShots_andWhatDiffers();
    void line_ofOne_isTheFindingsOwn();
    void line_ofManyShots_isShort();
    void line_withoutShots_saysHowOften();
    void line_joinsSentencesWithin();
    void unknownIds_areNeverJoined();
    void shots_data();
    void shots();
};

void TestFindingGroup::same_areOneGroup_gravestFirst()
{
    const auto groups = grouped({other("SPC-001", Severity::Info, "None."), overrun(2, "0.3 ms"),
        other("WIN-001", Severity::Caution, "Another sentence."), overrun(3, "0.4 ms"),
        other("CAP-008", Severity::Block, "Flat.")});
    QCOMPARE(groups.size(), std::size_t(4));
    QCOMPARE(groups[0].front().id, std::string("CAP-008"));
    QCOMPARE(groups[1].size(), std::size_t(2));
    QCOMPARE(groups[1].back().shot, Index(3));
    QCOMPARE(groups[2].size(), std::size_t(1)); // says something else
    QCOMPARE(groups[3].front().severity, Severity::Info);
}

void TestFindingGroup::line_namesShots_andWhatDiffers()
{
    QCOMPARE(groupLine({overrun(2, "0.3 ms"), overrun(3, "0.4 ms")}),
        QString("▲ Caution WIN-001, shots 2 and 3: Shot 2 / 3: the window ends 0.3 ms / 0.4 ms "
                "after the plateau."));
    QVERIFY(groupLine({overrun(2, "0.3 ms"), overrun(3, "0.3 ms")})
                .endsWith("the window ends 0.3 ms after the plateau."));
}

void TestFindingGroup::line_ofOne_isTheFindingsOwn()
{
    QCOMPARE(groupLine({overrun(2, "0.3 ms")}), findingLine(overrun(2, "0.3 ms")));
}

void TestFindingGroup::line_ofManyShots_isShort()
{
    Findings all;
    for (Index shot = 1; shot <= 22; ++shot)
        all.push_back(overrun(shot, std::to_string(shot).c_str()));
    QVERIFY2(
        groupLine(all).contains("shots 1 to 22: Shot 1 / … / 22: "), qPrintable(groupLine(all)));
}

void TestFindingGroup::line_withoutShots_saysHowOften()
{
    const Finding left = other("CAP-024", Severity::Caution, "Left out.");
    const QString line = groupLine({left, left, left});
    QVERIFY2(line.startsWith("▲ Caution CAP-024, 3 time") && line.endsWith(": Left out."),
        qPrintable(line));
}

/// An error of no entry of the catalogue says what it says.
void TestFindingGroup::unknownIds_areNeverJoined()
{
    const Finding error = other("", Severity::Block, "Internal error.");
    QCOMPARE(grouped({error, error}).size(), std::size_t(2));
}

void TestFindingGroup::shots_data()
{
    QTest::addColumn<QList<int>>("numbers");
    QTest::addColumn<QString>("text");
    QTest::newRow("one") << QList<int>{3} << "3";
    QTest::newRow("two") << QList<int>{3, 2} << "2 and 3";
    QTest::newRow("run") << QList<int>{1, 2, 3} << "1 to 3";
    QTest::newRow("mixed") << QList<int>{1, 3, 5, 6, 7, 8} << "1, 3 and 5 to 8";
    QTest::newRow("pairs") << QList<int>{1, 2, 5, 6} << "1, 2, 5 and 6";
    QTest::newRow("twice") << QList<int>{2, 2} << "2";
}

void TestFindingGroup::shots()
{
    QFETCH(QList<int>, numbers);
    QFETCH(QString, text);
    std::vector<Index> shots;
    for (const int number : numbers)
        shots.push_back(number);
    QCOMPARE(shotList(shots), text);
}

void TestFindingGroup::line_joinsSentencesWithin()
{
    const auto leftOut = [](const char *file) {
        return Finding{.id = "CAP-024",
            .severity = Severity::Info,
            .message = {"A file was left out. %M1", {}, {Message{"%1 is empty.", {file}}}}};
    };
    const auto line = [&](std::vector<const char *> files) {
        FindingGroup group;
        for (const char *file : files)
            group.push_back(leftOut(file));
        return groupLine(group);
    };
    QVERIFY(line({"a"}).endsWith("A file was left out. a is empty."));
    QVERIFY(line({"a", "b", "b"}).endsWith("A file was left out. a is empty. / b is empty."));
    QVERIFY(line({"a", "b", "c", "d"}).endsWith("left out. a is empty. / … / d is empty."));
    QCOMPARE(grouped({leftOut("a"), leftOut("b")}).size(), std::size_t(1));
}

DYNCAL_TEST(TestFindingGroup)
#include "tst_finding_group.moc"

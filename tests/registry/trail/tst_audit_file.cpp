// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/trail/audit_file.h"

#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>

using namespace dyncal;

namespace {

const std::string kOurs = "certificate 2";

/// Five entries, the second and the fourth about certificate 2.
std::vector<AuditEntry> someEntries()
{
    std::vector<AuditEntry> entries;
    for (const char *object :
        {"certificate 1", "certificate 2", "certificate 3", "certificate 2", "sensor secret"})
        entries.push_back(
            chained({.utc = "2026-01-31T12:00:00Z",
                        .who = "A. Berg",
                        .action = "reserved",
                        .object = object,
                        .after = R"({"customer":"secret of )" + std::string(object) + "\"}",
                        .reason = "line\nbreak and \"quote\"",
                        .program = "dyncal 1"},
                entries.empty() ? nullptr : &entries.back()));
    return entries;
}

} // namespace

/// audit.jsonl of an issued folder.
class TestAuditFile : public QObject
{
    Q_OBJECT

private slots:
    void everyLine_comesBack()
    {
        const auto entries = someEntries();
        const auto lines = parseAudit(auditText(entries, kOurs));
        QVERIFY(lines);
        QCOMPARE(lines->size(), entries.size());
        for (std::size_t i = 0; i < entries.size(); ++i) {
            QCOMPARE((*lines)[i].sequence, entries[i].sequence);
            QCOMPARE((*lines)[i].sha256, entries[i].sha256);
            QCOMPARE((*lines)[i].entry.has_value(), entries[i].object == kOurs);
            if ((*lines)[i].entry)
                QVERIFY(*(*lines)[i].entry == entries[i]);
        }
        QVERIFY(!firstBrokenLine(*lines));
    }

    /// A customer learns nothing of others.
    void linesOfOthers_sayNothing()
    {
        const std::string text = auditText(someEntries(), kOurs);
        QVERIFY(text.find("secret of certificate 2") != text.npos);
        QVERIFY(text.find("secret of certificate 1") == text.npos);
        QVERIFY(text.find("secret of certificate 3") == text.npos);
        QVERIFY(text.find("sensor secret") == text.npos);
        QCOMPARE(std::ranges::count(text, '\n'), 5);
    }

    /// A part from the middle is a chain too.
    void partOfTheTrail_isAChain()
    {
        auto entries = someEntries();
        entries.erase(entries.begin());
        QVERIFY(!firstBrokenLine(*parseAudit(auditText(entries, kOurs))));
        entries.erase(entries.begin() + 1);
        QCOMPARE(firstBrokenLine(*parseAudit(auditText(entries, kOurs))), std::optional<Index>(2));
    }

    /// A flip in any byte makes another text, or another chain: nothing goes unnoticed.
    void flipInAnyByte_isNoticed()
    {
        const std::string text = auditText(someEntries(), kOurs);
        const auto before = *parseAudit(text);
        for (std::size_t i = 0; i < text.size(); ++i) {
            std::string flipped = text;
            flipped[i] = static_cast<char>(flipped[i] ^ (1 << (i % 8)));
            const auto lines = parseAudit(flipped);
            const bool isSeen
                = !lines || firstBrokenLine(*lines) || lines->back().sha256 != before.back().sha256;
            QVERIFY2(isSeen, qPrintable(QString("byte %1").arg(i)));
        }
    }

    void whatIsNoTrail_isRefusedWithItsLine()
    {
        const std::string text = auditText(someEntries(), kOurs);
        for (const std::string &wrong :
            {text.substr(0, text.size() - 1), text + "\n", text + "{}\n", text + "nonsense\n"}) {
            const auto lines = parseAudit(wrong);
            QVERIFY(!lines);
            QCOMPARE(lines.error().kind, ErrorKind::FileUnreadable);
            QVERIFY(english(lines.error().message).starts_with("Line "));
        }
        QCOMPARE(english(parseAudit(text + "{}\n").error().message).substr(0, 6), "Line 6");
        QVERIFY(parseAudit("")->empty());
    }
};

DYNCAL_TEST(TestAuditFile)
#include "tst_audit_file.moc"

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/trail/audit_entry.h"

#include "core/base/content_hash.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace dyncal;

namespace {

AuditEntry someEntry(const char *action, const char *reason = "")
{
    return {.utc = "2026-01-31T12:00:00Z",
        .who = "A. Berg",
        .action = action,
        .object = "certificate 1",
        .reason = reason,
        .program = "dyncal 1"};
}

std::vector<AuditEntry> someChain(int count)
{
    std::vector<AuditEntry> entries;
    for (int i = 0; i < count; ++i) {
        const std::string action = "did " + std::to_string(i);
        entries.push_back(
            chained(someEntry(action.c_str()), entries.empty() ? nullptr : &entries.back()));
    }
    return entries;
}

} // namespace

/// The chain of the audit trail.
class TestAuditEntry : public QObject
{
    Q_OBJECT

private slots:
    /// Written out by hand: another program can follow the chain with nothing but SHA-256.
    void hash_isThatOfTheDocumentedText()
    {
        const AuditEntry entry = chained(someEntry("reserved", "first"), nullptr);
        const std::string content
            = R"({"action":"reserved","after":"","before":"","object":"certificate 1",)"
              R"("program":"dyncal 1","reason":"first","utc":"2026-01-31T12:00:00Z","who":"A. Berg"})"
              "\n";
        QCOMPARE(contentSha256(entry), sha256Hex(std::string_view(content)));
        const std::string place
            = std::string(64, '0') + " 1 " + sha256Hex(std::string_view(content));
        QCOMPARE(entry.sha256, sha256Hex(std::string_view(place)));
        QCOMPARE(entry.sequence, 1);
        QCOMPARE(entry.previous, kNoEntry);
    }

    void entries_followEachOther()
    {
        const auto chain = someChain(5);
        for (std::size_t i = 1; i < chain.size(); ++i) {
            QCOMPARE(chain[i].previous, chain[i - 1].sha256);
            QCOMPARE(chain[i].sequence, chain[i - 1].sequence + 1);
        }
        QVERIFY(!firstBreak(chain));
        QVERIFY(!firstBreak({}));
    }

    /// Whatever of an entry is changed, the break is at it.
    void everyChange_isFoundWhereItIs()
    {
        constexpr std::string AuditEntry::*kTexts[]{&AuditEntry::utc, &AuditEntry::who,
            &AuditEntry::action, &AuditEntry::object, &AuditEntry::before, &AuditEntry::after,
            &AuditEntry::reason, &AuditEntry::program, &AuditEntry::previous, &AuditEntry::sha256};
        for (const auto text : kTexts) {
            auto chain = someChain(4);
            chain[2].*text += 'x';
            QCOMPARE(firstBreak(chain), std::optional<Index>(3));
        }
        auto chain = someChain(4);
        chain[1].sequence = 7;
        QCOMPARE(firstBreak(chain), std::optional<Index>(7));
    }

    /// An entry that was changed and given the hash of what it says now breaks the next one.
    void rewrittenEntry_breaksTheNext()
    {
        auto chain = someChain(4);
        chain[1].who = "B. Berg";
        chain[1] = chained(chain[1], &chain[0]);
        QCOMPARE(firstBreak(chain), std::optional<Index>(3));
    }

    void missingEntries_areFound()
    {
        for (std::size_t i = 0; i + 1 < someChain(4).size(); ++i) {
            auto chain = someChain(4);
            chain.erase(chain.begin() + static_cast<std::ptrdiff_t>(i));
            QVERIFY(firstBreak(chain));
        }
        auto swapped = someChain(4);
        std::swap(swapped[1], swapped[2]);
        QVERIFY(firstBreak(swapped));
    }

    /// Said in docs/registry.md: what was cut off at the end is not seen.
    void cutAtTheEnd_isNotSeen()
    {
        auto chain = someChain(4);
        chain.pop_back();
        QVERIFY(!firstBreak(chain));
    }
};

DYNCAL_TEST(TestAuditEntry)
#include "tst_audit_entry.moc"

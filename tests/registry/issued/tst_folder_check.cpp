// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/issued/folder_check.h"

#include "registry/issued/bound_files.h"
#include "tests/support/made_certificate.h"
#include "tests/support/made_registry.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"

#include <QtTest>

#include <random>

using namespace dyncal;
using namespace dyncal::testing;

namespace fs = std::filesystem;

namespace {

/// Certificate 2 of a registry, issued, with its folder.
struct Laboratory
{
    ScratchFolder folder;
    CertificateRegister registry = openedRegister(folder.file("registry.sqlite"));
    std::string output = folder.file("certificates");
    std::string place = output + "/2";

    Laboratory()
    {
        issue("other");
        issue("a");
    }
    void issue(const std::string &job, Index amends = 0)
    {
        NumberRequest request = numberRequest(job);
        request.amends = amends;
        request.reason = amends > 0 ? "corrected" : "";
        const auto reserved = registry.reserve(request);
        const auto hashes
            = writeIssuedFolder(output, *reserved, madeCertificate(reserved->record), {});
        if (!registry.markIssued(reserved->record.number, *hashes, kNoon))
            std::abort();
    }

    std::string fault(bool withRegistry = true)
    {
        const auto check = checkIssuedFolder(place, withRegistry ? &registry : nullptr);
        return !check                ? "unreadable: " + english(check.error().message)
            : check->firstDifference ? english(*check->firstDifference)
                                     : std::string();
    }

    void write(const std::string &name, const std::string &bytes) const
    {
        std::ofstream(place + '/' + name, std::ios::binary) << bytes;
    }

    /// Replaces a word in a file and, as a careful forger would, the hashes in manifest and list.
    void forge(const std::string &name, const std::string &from, const std::string &to) const
    {
        std::string bytes = contentOf(place + '/' + name);
        const std::string before = sha256Hex(std::string_view(bytes));
        bytes.replace(bytes.find(from), from.size(), to);
        write(name, bytes);
        replaceIn("manifest.json", before, sha256Hex(std::string_view(bytes)));
    }

    /// And what lists that file in turn.
    void replaceIn(const std::string &name, const std::string &from, const std::string &to) const
    {
        std::string bytes = contentOf(place + '/' + name);
        const std::string before = sha256Hex(std::string_view(bytes));
        for (std::size_t at; (at = bytes.find(from)) != bytes.npos;)
            bytes.replace(at, from.size(), to);
        write(name, bytes);
        if (name == "manifest.json") {
            replaceIn("written.json", from, to);
            replaceIn("written.json", before, sha256Hex(std::string_view(bytes)));
        }
    }
};

bool holds(const std::string &text, const std::string &part)
{
    return text.find(part) != text.npos;
}

} // namespace

/// An issued folder held against itself and the registry.
class TestFolderCheck : public QObject
{
    Q_OBJECT

private slots:
    void wholeFolder_hasNoDifference()
    {
        Laboratory lab;
        QCOMPARE(lab.fault(), std::string());
        const auto check = checkIssuedFolder(lab.place, &lab.registry);
        QCOMPARE(check->number, 2);
        QVERIFY(check->state == CertificateState::Issued);
        QCOMPARE(check->entries, 1);
        QCOMPARE(check->head, lab.registry.find(2)->head);
        QVERIFY(check->remarks.empty());
    }

    void withoutRegistry_isSaid()
    {
        Laboratory lab;
        const auto check = checkIssuedFolder(lab.place, nullptr);
        QVERIFY(!check->firstDifference && !check->state);
        QCOMPARE(check->remarks.size(), 1U);
    }

    void missingChangedAndAddedFiles_areNamed()
    {
        for (const char *name : {"project.dyncal", "recipe.json", "results.json", "certificate.pdf",
                 "audit.jsonl", "written.json"}) {
            Laboratory lab;
            const std::string bytes = contentOf(lab.place + '/' + name);
            fs::remove(lab.place + '/' + name);
            QCOMPARE(lab.fault(), std::string(name) + " is missing.");
            QVERIFY(checkIssuedFolder(lab.place, nullptr)->isMissing);
            lab.write(name, bytes + " ");
            QVERIFY2(lab.fault().starts_with(std::string(name) + " is not the file"), name);
            QVERIFY(!checkIssuedFolder(lab.place, nullptr)->isMissing);
            lab.write(name, bytes);
            QCOMPARE(lab.fault(), std::string());
        }
        Laboratory lab;
        lab.write("extra.txt", "x");
        QVERIFY(lab.fault().starts_with("extra.txt does not belong"));
        fs::remove(lab.place + "/extra.txt");
        fs::remove(lab.place + "/manifest.json");
        QVERIFY(lab.fault().starts_with("unreadable: "));
    }

    /// Whoever changes a file and all hashes beside it is found by what does not fit, and by the
    /// registry in any case.
    void forgedFiles_contradictEachOther_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("from");
        QTest::addColumn<QString>("to");
        QTest::addColumn<QString>("said");
        QTest::newRow("recipe of the results") << "recipe.json"
                                               << "\"2\""
                                               << "\"3\""
                                               << "the recipe";
        QTest::newRow("project") << "project.dyncal"
                                 << "\"2\""
                                 << "\"3\""
                                 << "the recipe";
        QTest::newRow("recordings") << "project.dyncal"
                                    << "shot.h5"
                                    << "shut.h5"
                                    << "the recordings";
        QTest::newRow("time") << "results.json"
                              << "2026-01-31"
                              << "2026-01-30"
                              << "the time";
        QTest::newRow("no project") << "project.dyncal"
                                    << "captures"
                                    << "cuptures"
                                    << "project.dyncal";
        QTest::newRow("number on the PDF") << "certificate.pdf"
                                           << "number>2"
                                           << "number>3"
                                           << "the number";
        QTest::newRow("results of the PDF") << "results.json"
                                            << "dyncal-results/1"
                                            << "dyncal-results/2"
                                            << "the results";
        QTest::newRow("what only the project says") << "project.dyncal"
                                                    << "dyncal-project"
                                                    << "dyncal-notions"
                                                    << "the files";
        QTest::newRow("trail") << "audit.jsonl"
                               << "A. Berg"
                               << "B. Berg"
                               << "line 1";
    }

    void forgedFiles_contradictEachOther()
    {
        QFETCH(QString, name);
        QFETCH(QString, from);
        QFETCH(QString, to);
        QFETCH(QString, said);
        Laboratory lab;
        lab.forge(name.toStdString(), from.toStdString(), to.toStdString());
        const std::string fault = lab.fault(false);
        QVERIFY2(holds(fault, said.toStdString()), fault.c_str());
        QVERIFY(!lab.fault().empty());
    }

    /// The hash that the PDF states is that of a list anybody can make with sha256sum.
    void statedFiles_areAllButThePdfAndWhatFollowsIt()
    {
        const std::map<std::string, std::string> hashes{{"recipe.json", "b"},
            {"project.dyncal", "a"}, {"sources/x.csv", "c"}, {"certificate.pdf", "d"},
            {"dcc.xml", "h"}, {"audit.jsonl", "e"}, {"manifest.json", "f"}, {"written.json", "g"}};
        QCOMPARE(boundFilesHash(hashes),
            sha256Hex(std::string_view("project.dyncal a\nrecipe.json b\nsources/x.csv c\n")));
    }

    void pdfThatStatesNoFiles_isOfAnEarlierVersion()
    {
        Laboratory lab;
        lab.forge("certificate.pdf", "<dyncal:files>", "<dyncal:trials>");
        QCOMPARE(lab.fault(false), std::string());
    }

    /// A forgery that fits itself in all is found by the registry alone.
    void perfectForgery_isFoundByTheRegistry()
    {
        Laboratory lab;
        lab.forge("certificate.pdf", "xxxx", "yyyy");
        QCOMPARE(lab.fault(false), std::string());
        QVERIFY2(holds(lab.fault(), "certificate.pdf is not the file"), lab.fault().c_str());
    }

    void states_areRemarked()
    {
        Laboratory lab;
        QVERIFY(lab.registry.withdraw(2, "A", "damaged reference", kNoon));
        const auto withdrawn = checkIssuedFolder(lab.place, &lab.registry);
        QVERIFY(!withdrawn->firstDifference);
        QCOMPARE(
            english(withdrawn->remarks.front()), "Certificate 2 is withdrawn: damaged reference");
        lab.issue("b", 1);
        const auto replaced = checkIssuedFolder(lab.output + "/1", &lab.registry);
        QVERIFY(!replaced->firstDifference);
        QCOMPARE(english(replaced->remarks.front()), "Certificate 1 is replaced by 3.");
        QVERIFY(!checkIssuedFolder(lab.output + "/3", &lab.registry)->firstDifference);
    }

    void reservedOrUnknownNumber_isNotIssued()
    {
        Laboratory lab, other;
        const auto reserved = lab.registry.reserve(numberRequest("c"));
        QVERIFY(writeIssuedFolder(lab.output, *reserved, madeCertificate(reserved->record), {}));
        lab.place = lab.output + "/3";
        QVERIFY2(holds(lab.fault(), "was not issued"), lab.fault().c_str());
        const auto check = checkIssuedFolder(lab.place, &other.registry);
        QVERIFY(holds(english(*check->firstDifference), "has no certificate 3"));
    }

    void singleFile_isKnownByItsHash()
    {
        Laboratory lab;
        const auto known = certificateWithFile(
            lab.registry, sha256Hex(std::string_view(contentOf(lab.place + "/certificate.pdf"))));
        QCOMPARE((*known)->number, 2);
        QVERIFY(!*certificateWithFile(lab.registry, sha256Hex(std::string_view("x"))));
    }

    /// Every flipped bit of every file is reported, without the registry too.
    void flippedBits_areReported()
    {
        Laboratory lab;
        std::vector<std::string> names;
        for (const auto &entry : fs::directory_iterator(lab.place))
            names.push_back(entry.path().filename().string());
        std::mt19937_64 random(7);
        const int count = trials::count(300, 5000);
        for (int i = 0; i < count; ++i) {
            const std::string name = names[random() % names.size()];
            const std::string whole = contentOf(lab.place + '/' + name);
            std::string bytes = whole;
            const std::size_t at = random() % bytes.size();
            bytes[at] = static_cast<char>(bytes[at] ^ (1 << (random() % 8)));
            lab.write(name, bytes);
            QVERIFY2(!lab.fault(i % 2 == 0).empty(), qPrintable(QString::fromStdString(name)));
            lab.write(name, whole);
        }
        QCOMPARE(lab.fault(), std::string());
    }
};

DYNCAL_TEST(TestFolderCheck)
#include "tst_folder_check.moc"

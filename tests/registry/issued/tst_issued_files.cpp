// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/issued/issued_files.h"

#include "core/base/content_hash.h"
#include "core/base/writing/written_list.h"
#include "tests/support/made_certificate.h"
#include "tests/support/made_registry.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace dyncal;
using namespace dyncal::testing;

namespace fs = std::filesystem;

namespace {

/// A registry and the folder that gets the certificates.
struct Laboratory
{
    ScratchFolder folder;
    CertificateRegister registry = openedRegister(folder.file("registry.sqlite"));
    std::string output = folder.file("certificates");

    ReservedNumber reserved(const std::string &job)
    {
        return *registry.reserve(numberRequest(job));
    }
    Result<std::map<std::string, std::string>> write(const ReservedNumber &number)
    {
        return writeIssuedFolder(output, number, madeCertificate(number.record), {});
    }
};

std::vector<std::string> namesIn(const std::string &folder)
{
    std::vector<std::string> names;
    for (const auto &entry : fs::recursive_directory_iterator(folder))
        names.push_back(fs::relative(entry.path(), folder).string());
    std::ranges::sort(names);
    return names;
}

} // namespace

/// The folder of an issued certificate.
class TestIssuedFiles : public QObject
{
    Q_OBJECT

private slots:
    void manifest_comesBack()
    {
        const IssuedManifest manifest{
            17, 3, "job", kNoon, "head", {{"a", "1"}, {"sources/b", "2"}}};
        QVERIFY(parseManifest(manifestText(manifest)) == manifest);
        const std::string text = manifestText(manifest);
        for (const std::string &wrong :
            {std::string("{}"), std::string("nonsense"), text + " ", text.substr(1), std::string()})
            QVERIFY(!parseManifest(wrong));
    }

    void names_areThoseOfTheContract()
    {
        for (const char *name : {"project.dyncal", "recipe.json", "results.json", "certificate.pdf",
                 "dcc.xml", "audit.jsonl", "manifest.json"})
            QVERIFY(isIssuedName(name));
        QVERIFY(isIssuedName("sources/0123456789abcdef-table.csv"));
        for (const char *name : {"shot.h5", "sources/x", "../recipe.json", "csv/poles.csv", ""})
            QVERIFY(!isIssuedName(name));
    }

    void folder_holdsTheFilesAndTheirHashes()
    {
        Laboratory lab;
        lab.reserved("other");
        const ReservedNumber number = lab.reserved("a");
        const auto hashes = lab.write(number);
        QVERIFY(hashes);
        const std::string folder = issuedFolder(lab.output, 2);
        QCOMPARE(folder, lab.output + "/2");
        QVERIFY((namesIn(lab.output)
            == std::vector<std::string>{"2", "2/audit.jsonl", "2/certificate.pdf",
                "2/manifest.json", "2/project.dyncal", "2/recipe.json", "2/results.json",
                "2/written.json"}));
        for (const auto &[name, hash] : *hashes)
            QCOMPARE(sha256Hex(std::string_view(contentOf(folder + '/' + name))), hash);
        const auto manifest = parseManifest(contentOf(folder + "/manifest.json"));
        QCOMPARE(manifest->number, 2);
        QCOMPARE(manifest->head, number.record.head);
        QCOMPARE(manifest->files.size() + 1, hashes->size());
    }

    /// The same reservation makes the same bytes, also over what a killed program left.
    void writtenAgain_isTheSame()
    {
        Laboratory lab;
        const ReservedNumber number = lab.reserved("a");
        const auto first = lab.write(number);
        const auto again = lab.write(*lab.registry.reserve(numberRequest("a")));
        QVERIFY(first && again);
        QVERIFY(*first == *again);
        QCOMPARE(namesIn(lab.output).size(), 8U);
    }

    /// Another registry's certificate of the same number is never replaced.
    void folderOfAnother_isLeftAlone()
    {
        Laboratory lab, other;
        QVERIFY(other.write(other.reserved("b")));
        fs::create_directories(lab.output);
        fs::copy(other.output + "/1", lab.output + "/1");
        const std::string before = contentOf(lab.output + "/1/manifest.json");
        const auto refused = lab.write(lab.reserved("a"));
        QVERIFY(!refused);
        QCOMPARE(refused.error().kind, ErrorKind::Usage);
        QVERIFY(english(refused.error().message).ends_with("The number 1 stays reserved."));
        QCOMPARE(contentOf(lab.output + "/1/manifest.json"), before);
        QCOMPARE(namesIn(lab.output).size(), 8U);
    }

    void whatIsNoFolder_isLeftAlone()
    {
        Laboratory lab;
        fs::create_directories(lab.output);
        std::ofstream(lab.output + "/1") << "mine";
        QVERIFY(!lab.write(lab.reserved("a")));
        QCOMPARE(contentOf(lab.output + "/1"), "mine");
    }

    void refusedAtTheEnd_leavesNothing()
    {
        Laboratory lab;
        const ReservedNumber number = lab.reserved("a");
        const auto refused = writeIssuedFolder(
            lab.output, number, madeCertificate(number.record), {}, []() -> Result<void> {
                return fail(ErrorKind::Usage, {"changed", {}});
            });
        QCOMPARE(english(refused.error().message), "changed");
        QVERIFY(!fs::exists(lab.output) || namesIn(lab.output).empty());
        QVERIFY(lab.write(number));
    }
};

DYNCAL_TEST(TestIssuedFiles)
#include "tst_issued_files.moc"

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The plan of a write and the list of what was written: what comes back from the disk is what was
// put there, or nothing.

#include "core/base/writing/folder_plan.h"
#include "tests/core/base/writing/opened_folder.h"
#include "tests/support/failing_calls.h"
#include "tests/support/python_answer.h"
#include "tests/support/test_program.h"

#include "core/base/content_hash.h"

#include <QTest>

#include <sys/stat.h>

#include <limits>
#include <random>

using namespace dyncal;
using namespace dyncal::testing;
namespace fs = std::filesystem;

namespace {

WrittenFile fileNamed(const std::string &name, const std::string &by = "run")
{
    return {name, by, sha256Hex(name)};
}

/// Names that may stand in a list, in no order.
WrittenList someFiles()
{
    return {fileNamed("written.json", ""), fileNamed("csv/b.csv"), fileNamed("csv/a.csv"),
        fileNamed("a b\"c"), fileNamed("\xC3\xA5/\xE2\x84\x96.csv", "export"), fileNamed("..."),
        fileNamed("a/.b/..c"), fileNamed(std::string(255, 'n'))};
}

bool areEqual(const WrittenList &a, const WrittenList &b)
{
    const auto sorted = [](WrittenList list) {
        std::ranges::sort(list, {}, &WrittenFile::file);
        return list;
    };
    return sorted(a) == sorted(b);
}

bool areEqual(const FolderPlan &a, const FolderPlan &b)
{
    return a.tree == b.tree && a.folder == b.folder && areEqual(a.retired, b.retired)
        && areEqual(a.placed, b.placed);
}

/// JSON in a test is easier to read with single quotes.
std::string json(std::string text)
{
    std::ranges::replace(text, '\'', '"');
    return text;
}

std::string listOf(const std::string &file, const std::string &hash)
{
    return json("{'schema': 'dyncal-written/1', 'files': [{'by': 'run', 'file': '" + file
        + "', 'sha256': '" + hash + "'}]}");
}

} // namespace

class TestFolderPlan : public QObject
{
    Q_OBJECT

private slots:
    void list_isTheJsonThatPythonWrites()
    {
        const ScratchFolder place;
        put(place.file("list"), writtenListText(someFiles()));
        const PythonAnswer answer = python({"-c",
            "import json, sys\n"
            "text = open(sys.argv[1], encoding='utf-8', newline='').read()\n"
            "data = json.loads(text)\n"
            "assert list(data) == ['files', 'schema'] and data['schema'] == 'dyncal-written/1'\n"
            "names = [f['file'].encode() for f in data['files']]\n"
            "assert names == sorted(names) and len(names) == 8\n"
            "again = json.dumps(data, indent=2, sort_keys=True, ensure_ascii=False) + '\\n'\n"
            "assert again == text, again\n",
            QString::fromStdString(place.file("list"))});
        QVERIFY2(answer.ran, answer.err.constData());
    }

    void list_comesBackWhateverItsOrder()
    {
        WrittenList files = someFiles();
        const std::string text = writtenListText(files);
        std::mt19937 random(1);
        for (int i = 0; i < 20; ++i) {
            std::shuffle(files.begin(), files.end(), random);
            QCOMPARE(writtenListText(files), text);
        }
        const auto read = parseWrittenList(text);
        QVERIFY(read && areEqual(*read, files));
        for (const WrittenFile &file : files)
            QVERIFY(listed(*read, file.file) && *listed(*read, file.file) == file);
        QVERIFY(!listed(*read, "csv") && !listed(*read, "csv/a.cs") && !listed(*read, ""));
        QVERIFY(parseWrittenList(writtenListText({}))->empty());
    }

    void namesThatLeadElsewhere_makeTheWholeListUnbelieved()
    {
        const std::string hash = sha256Hex("x");
        QVERIFY(parseWrittenList(listOf("a/b", hash)));
        for (const char *name : {"", "/", "/a", "a/", "a//b", ".", "..", "a/..", "../a", "a/../b",
                 "./a", "a/.", "a\\\\b", "a\\u0000b", "a\\nb", "a\\u007fb", "a\\u001b[31m"})
            QVERIFY2(!parseWrittenList(listOf(name, hash)), name);
        for (const std::string &wrong : {std::string(), hash.substr(1), hash + "0",
                 std::string(64, 'g'), std::string(63, '0') + " "})
            QVERIFY2(!parseWrittenList(listOf("a", wrong)), wrong.c_str());
    }

    void otherJson_isNoList()
    {
        const std::string rest = "'file': 'a', 'sha256': '" + sha256Hex("") + "'}";
        const std::string entry = "{'by': 'run', " + rest;
        const std::string head = "{'schema': 'dyncal-written/1', 'files': ";
        QVERIFY(parseWrittenList(json(head + "[" + entry + "]}")));
        const std::vector<std::string> others{"", "[]", "null", "7", head + "{}}", head + "[7]}",
            head + "[" + entry + ", null]}", head + "[[]]}", head + "[{}]}",
            head + "[" + entry + "]", head + "null}", head + "[{'by': 1, " + rest + "]}",
            head + "[{" + rest + "]}", "{'schema': 'dyncal-written/2', 'files': []}",
            "{'files': []}", "{'schema': 1, 'files': []}", "{'schema': 'dyncal-written/1'}",
            head + std::string(1000000, '[')};
        for (const std::string &text : others)
            QVERIFY2(!parseWrittenList(json(text)), text.substr(0, 200).c_str());
    }

    void plan_comesBack()
    {
        for (const ino_t tree : {ino_t(0), ino_t(1), std::numeric_limits<ino_t>::max()}) {
            const ScratchFolder place;
            const FileDescriptor folder = opened(place.file(""));
            const FolderPlan plan{tree, tree / 2, someFiles(), {fileNamed("only one")}};
            QVERIFY(writePlan(folder.get(), kMovesPlan, plan));
            const auto read = readPlan(folder.get(), kMovesPlan);
            QVERIFY(read && areEqual(*read, plan));
            QVERIFY(!readPlan(folder.get(), kExchangePlan));
            QCOMPARE(entriesOf(place.file("")), (std::set<std::string>{kMovesPlan}));
        }
    }

    void largePlan_comesBack()
    {
        const ScratchFolder place;
        const FileDescriptor folder = opened(place.file(""));
        FolderPlan plan;
        for (int i = 0; i < 20000; ++i)
            plan.placed.push_back(fileNamed("csv/shot " + std::to_string(i) + ".csv"));
        QVERIFY(writePlan(folder.get(), kMovesPlan, plan));
        const auto read = readPlan(folder.get(), kMovesPlan);
        QVERIFY(read && areEqual(*read, plan));
    }

    void planThatIsCutOrNoFile_isNone()
    {
        const ScratchFolder place;
        const FileDescriptor folder = opened(place.file(""));
        QVERIFY(writePlan(folder.get(), "whole", {7, 8, {fileNamed("a")}, {fileNamed("b")}}));
        const std::string whole = contentOf(place.file("whole"));
        const std::size_t last = whole.find_last_of('}');
        for (std::size_t size = 0; size <= last; ++size) {
            put(place.file("cut"), whole.substr(0, size));
            QVERIFY2(!readPlan(folder.get(), "cut"), whole.substr(0, size).c_str());
        }
        fs::create_symlink("whole", place.file("link"));
        fs::create_directory(place.file("folder"));
        QCOMPARE(::mkfifo(place.file("pipe").c_str(), 0600), 0);
        for (const char *name : {"link", "folder", "pipe", "none"})
            QVERIFY2(!readPlan(folder.get(), name), name);
    }

    /// A byte that turned on the disk must not send a file out of the folder.
    void planWithAWrongByte_namesNothingElsewhere()
    {
        const ScratchFolder place;
        const FileDescriptor folder = opened(place.file(""));
        QVERIFY(writePlan(folder.get(), "whole", {7, 8, {fileNamed("a/b")}, {fileNamed("c/d")}}));
        const std::string whole = contentOf(place.file("whole"));
        for (std::size_t at = 0; at < whole.size(); ++at)
            for (const char wrong : {'.', '/', '\0', '"', '-', '\\'}) {
                std::string bytes = whole;
                bytes[at] = wrong;
                put(place.file("wrong"), bytes);
                const auto plan = readPlan(folder.get(), "wrong");
                QVERIFY(!plan || (plan->retired.size() == 1 && plan->placed.size() == 1));
                for (const WrittenList &list :
                    plan ? std::vector{plan->retired, plan->placed} : std::vector<WrittenList>())
                    for (const WrittenFile &file : list)
                        QVERIFY2(fs::path(file.file).is_relative()
                                && fs::path(file.file).lexically_normal() == file.file,
                            file.file.c_str());
            }
    }

    void everyFailingCall_leavesNoPlanUnderItsName()
    {
        int failures = 0;
        bool wasReached = true;
        for (int call = 0; wasReached; ++call) {
            const ScratchFolder place;
            const FileDescriptor folder = opened(place.file(""));
            const FolderPlan plan{7, 8, {fileNamed("a")}, {fileNamed("b")}};
            FailingCalls::arm(call, ENOSPC);
            const bool written = writePlan(folder.get(), kMovesPlan, plan);
            const int problem = errno;
            wasReached = FailingCalls::countdown < 0;
            FailingCalls::disarm();
            failures += written ? 0 : 1;
            QVERIFY(written || problem == ENOSPC);
            const auto read = readPlan(folder.get(), kMovesPlan); // the last call follows the name
            QVERIFY(read ? areEqual(*read, plan) : !fs::exists(place.file(kMovesPlan)));
            QVERIFY(!written || read);
        }
        QCOMPARE(failures, 5); // opened, written, flushed, named, folder flushed
    }

    void plannedPart_isNotOverwritten()
    {
        const ScratchFolder place;
        put(place.file("precious"), "precious");
        fs::create_symlink("precious", place.file("moves.part"));
        const FileDescriptor folder = opened(place.file(""));
        QVERIFY(!writePlan(folder.get(), kMovesPlan, {}));
        QCOMPARE(contentOf(place.file("precious")), std::string("precious"));
        QVERIFY(!fs::exists(place.file(kMovesPlan)));
    }
};

DYNCAL_TEST(TestFolderPlan)
#include "tst_folder_plan.moc"

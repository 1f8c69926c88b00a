// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/recheck/named_recordings.h"
#include "tests/core/recheck/earlier_results.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

std::vector<RecordedInput> inputsCalled(const std::vector<std::string> &names)
{
    std::vector<RecordedInput> inputs;
    for (const std::string &name : names)
        inputs.push_back({name, {}});
    return inputs;
}

} // namespace

class TestNamedRecordings : public QObject
{
    Q_OBJECT

private slots:
    void unchangedNames_keepTheirPaths()
    {
        const ScratchFolder scratch;
        const std::string path = put(scratch, "deep/a.csv", "x");
        const auto named = NamedRecordings::of(inputsCalled({"a.csv"}), {path});
        QVERIFY(named.has_value());
        QCOMPARE(named->paths(), std::vector<std::string>{path});
    }

    void renamed_isReadUnderItsOldName_andTheLinkGoes()
    {
        const ScratchFolder scratch;
        const std::string a = put(scratch, "x1.bin", "first");
        const std::string b = put(scratch, "x2.bin", "second");
        const std::string c = put(scratch, "c.csv", "third");
        std::vector<std::string> paths;
        {
            const auto named
                = NamedRecordings::of(inputsCalled({"a.csv", "a.csv", "c.csv"}), {a, b, c});
            QVERIFY(named.has_value());
            paths = named->paths();
            QCOMPARE(contentOf(paths[0]), std::string("first"));
            QCOMPARE(contentOf(paths[1]), std::string("second")); // of the same name
            QCOMPARE(paths[2], c);
            for (int i : {0, 1})
                QCOMPARE(std::filesystem::path(paths[static_cast<std::size_t>(i)]).filename(),
                    std::filesystem::path("a.csv"));
        }
        for (int i : {0, 1})
            QVERIFY(
                !std::filesystem::exists(std::filesystem::path(paths[static_cast<std::size_t>(i)])
                                             .parent_path()
                                             .parent_path()));
        QCOMPARE(contentOf(a), std::string("first")); // the recording stays
    }

    void relativePath_isLinkedToo()
    {
        const ScratchFolder scratch;
        put(scratch, "x.bin", "content");
        const std::filesystem::path before = std::filesystem::current_path();
        std::filesystem::current_path(scratch.file(""));
        const auto named = NamedRecordings::of(inputsCalled({"a.csv"}), {"x.bin"});
        std::filesystem::current_path(before);
        QVERIFY(named.has_value());
        QCOMPARE(contentOf(named->paths()[0]), std::string("content"));
    }

    void nameThatLeadsElsewhere_isNotMade()
    {
        const ScratchFolder scratch;
        const std::string path = put(scratch, "x.bin", "content");
        for (const char *name : {"../evil.csv", "..", ".", "", "/etc/evil"}) {
            const auto named = NamedRecordings::of(inputsCalled({name}), {path});
            QVERIFY(named.has_value());
            QCOMPARE(named->paths()[0], path);
        }
    }

    void noPlaceForLinks_isSaid()
    {
        const ScratchFolder scratch;
        const std::string path = put(scratch, "x.bin", "content");
        const QByteArray before = qgetenv("TMPDIR");
        qputenv("TMPDIR", QByteArray::fromStdString(path)); // a file
        const auto named = NamedRecordings::of(inputsCalled({"a.csv"}), {path});
        if (before.isNull())
            qunsetenv("TMPDIR");
        else
            qputenv("TMPDIR", before);
        QVERIFY(!named && named.error().kind == ErrorKind::FileUnreadable);
        QVERIFY(english(named.error().message).find("give it its old name") != std::string::npos);
    }
};

DYNCAL_TEST(TestNamedRecordings)
#include "tst_named_recordings.moc"

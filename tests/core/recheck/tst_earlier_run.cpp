// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/writing/written_list.h"
#include "core/recheck/earlier_run.h"
#include "core/reference/reference_source.h"
#include "tests/core/recheck/earlier_results.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

EarlierJson wholeResults()
{
    return withInputs(earlierResults(), {{"a.csv", recordingBytes(1)}});
}

std::string whyNotRead(const std::string &folder)
{
    const auto run = readEarlierRun(folder);
    return run ? std::string() : english(run.error().message);
}

bool saysOf(const std::string &folder, const char *words)
{
    return whyNotRead(folder).find(words) != std::string::npos;
}

std::string remarksOf(const std::string &folder)
{
    const auto run = readEarlierRun(folder);
    std::string text;
    for (const Message &remark : run ? run->remarks : std::vector<Message>())
        text += english(remark) + '\n';
    return text;
}

std::string listOf(const std::string &file, const std::string &text)
{
    return writtenListText({{file, "run", sha256Hex(std::string_view(text))}});
}

} // namespace

class TestEarlierRun : public QObject
{
    Q_OBJECT

private slots:
    void run_isReadFromResultsAlone()
    {
        const ScratchFolder scratch;
        EarlierJson root = withInputs(
            wholeResults(), {{"b.csv", recordingBytes(2)}, {"a.csv", recordingBytes(1)}});
        root["recipe"]["realization"]["order"] = 3;
        const auto run = readEarlierRun(putResults(scratch, "out", root));
        QVERIFY2(run.has_value(), run ? "" : english(run.error().message).c_str());
        QVERIFY(!run->recipe.realization.order.isAuto());
        QCOMPARE(run->inputs.size(), std::size_t(2));
        QCOMPARE(run->inputs[0].file, std::string("b.csv")); // in their order
        QCOMPARE(run->inputs[1].sha256, sha256Hex(std::string_view(recordingBytes(1))));
        QVERIFY(run->remarks.empty());
        QCOMPARE(run->folder, scratch.file("out"));
    }

    void writtenList_tellsWhetherResultsAreAsWritten()
    {
        const ScratchFolder scratch;
        const std::string folder = putResults(scratch, "out", wholeResults());
        put(scratch, "out/written.json", listOf("results.json", jsonText(wholeResults())));
        QCOMPARE(remarksOf(folder), std::string());
        put(scratch, "out/written.json", listOf("results.json", "something else"));
        QVERIFY(remarksOf(folder).starts_with("results.json is not the file that the run wrote"));
        put(scratch, "out/written.json", listOf("recipe.json", "something else"));
        QCOMPARE(remarksOf(folder), std::string());
        put(scratch, "out/written.json", "no list");
        QCOMPARE(remarksOf(folder), std::string());
    }

    void results_areReadUnderWhateverName()
    {
        const ScratchFolder scratch;
        const std::string text = jsonText(earlierResults()); // no recording, and no recipe needed
        const std::string file = put(scratch, "kept/of-2024.json", text);
        put(scratch, "kept/written.json", listOf("results.json", "something else"));
        const auto read = readEarlierResults(file);
        QVERIFY(read.has_value());
        QCOMPARE(read->file, file);
        QVERIFY(read->results == earlierResults());
        QCOMPARE(read->sha256, sha256Hex(std::string_view(text)));
        QVERIFY(read->remarks.empty());
        put(scratch, "kept/written.json", listOf("of-2024.json", "something else"));
        QCOMPARE(readEarlierResults(file)->remarks.size(), std::size_t(1));
        QCOMPARE(readEarlierResults(putResults(scratch, "out", earlierResults()))->file,
            scratch.file("out/results.json"));
    }

    void resultsThatAreNone_areRefused()
    {
        const ScratchFolder scratch;
        const auto kindOf = [](const std::string &path) {
            const auto read = readEarlierResults(path);
            return read ? std::optional<ErrorKind>() : std::optional(read.error().kind);
        };
        QCOMPARE(kindOf(scratch.file("none.json")), std::optional(ErrorKind::FileUnreadable));
        QCOMPARE(kindOf(scratch.file("")), std::optional(ErrorKind::FileUnreadable));
        QCOMPARE(kindOf(put(scratch, "a.json", "damaged {")), std::optional(ErrorKind::Usage));
        QCOMPARE(kindOf(put(scratch, "b.json", "{}")), std::optional(ErrorKind::Usage));
        QCOMPARE(kindOf(put(scratch, "c.json", "")), std::optional(ErrorKind::Usage));
    }

    void otherRecipeFile_isToldAndNotUsed()
    {
        const ScratchFolder scratch;
        const std::string folder = putResults(scratch, "out", wholeResults());
        put(scratch, "out/recipe.json", jsonText(wholeResults()["recipe"]));
        QCOMPARE(remarksOf(folder), std::string());
        put(scratch, "out/recipe.json", R"({"realization": {"order": 9}})");
        QVERIFY(remarksOf(folder).starts_with("recipe.json is not the recipe"));
        QVERIFY(readEarlierRun(folder)->recipe == Recipe());
        put(scratch, "out/recipe.json", "damaged {");
        QVERIFY(remarksOf(folder).starts_with("recipe.json is not the recipe"));
    }

    void keysOfToday_thatTheRecipeLacks_areNamed()
    {
        const ScratchFolder scratch;
        EarlierJson root = wholeResults();
        root["recipe"].erase("chain");
        root["recipe"]["shock"].erase("attenuation");
        const std::string remarks = remarksOf(putResults(scratch, "out", root));
        QVERIFY2(
            remarks.find("from before 2 of today's keys") != std::string::npos, remarks.c_str());
        QVERIFY(remarks.find("chain, shock.attenuation.") != std::string::npos);
        root["recipe"] = {{"schema", "dyncal-recipe/1"}};
        QVERIFY(remarksOf(putResults(scratch, "out", root)).find(", ....") != std::string::npos);
    }

    void tableOfTheRecipe_isTheOneOfItsHash()
    {
        const ScratchFolder scratch;
        const std::string table = "frequency_hz,magnitude\n1000,1\n2000,1\n";
        const std::string hash = sha256Hex(std::string_view(table));
        EarlierJson root = wholeResults();
        root["recipe"]["chain"]["source"] = "../elsewhere/amp.csv";
        root["recipe"]["chain"]["sha256"] = hash;
        const std::string folder = putResults(scratch, "out", root);
        const auto loaded = [&] {
            const auto run = readEarlierRun(folder);
            return run && run->recipe.chain.loaded && run->recipe.chain.loaded->content == table;
        };
        QVERIFY(saysOf(folder, "The file ../elsewhere/amp.csv (SHA-256 "));
        put(scratch, "elsewhere/amp.csv", "another table");
        QVERIFY(saysOf(folder, "is not there as it was"));
        put(scratch, "out/" + keptSourceName("amp.csv", hash), table);
        QVERIFY(loaded()); // beside the other one
        put(scratch, "out/" + keptSourceName("amp.csv", hash), "a changed copy");
        QVERIFY(saysOf(folder, "is not there as it was"));
        put(scratch, "elsewhere/amp.csv", table);
        QVERIFY(loaded());
    }

    void referenceThatIsNotUsed_isNotNeeded()
    {
        const ScratchFolder scratch;
        EarlierJson root = wholeResults();
        root["recipe"]["comparison"]["source"] = "reference.csv";
        QVERIFY(readEarlierRun(putResults(scratch, "out", root)).has_value());
        root["recipe"]["comparison"]["enabled"] = true;
        QVERIFY(saysOf(putResults(scratch, "out", root), "The file reference.csv"));
    }

    void damaged_isSaidInOneSentence_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("words");
        EarlierJson other = wholeResults();
        other["schema"] = "dyncal-model/1";
        EarlierJson later = wholeResults();
        later["schema"] = "dyncal-results/7";
        EarlierJson unhashed = wholeResults();
        unhashed["inputs"][0]["sha256"] = nullptr;
        EarlierJson without = wholeResults();
        without["inputs"] = EarlierJson::array();
        EarlierJson recipe = wholeResults();
        recipe["recipe"]["realisation"] = 3;
        EarlierJson none = wholeResults();
        none.erase("recipe");
        const auto row = [](const char *name, const EarlierJson &json, const char *words) {
            QTest::newRow(name) << QByteArray::fromStdString(jsonText(json)) << QByteArray(words);
        };
        QTest::newRow("cut") << QByteArray("{\"schema\": \"dyncal-res") << QByteArray("line 1");
        QTest::newRow("empty") << QByteArray() << QByteArray("is not valid JSON");
        row("foreign", other, "\"dyncal-model/1\"");
        row("later", later, "written by a later version");
        row("recording without hash", unhashed, "states no SHA-256 of its recording a.csv");
        row("no recordings", without, "names no recordings");
        row("unknown key", recipe, "realisation");
        row("no recipe", none, "out/results.json holds cannot be used");
    }
    void damaged_isSaidInOneSentence()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, words);
        const ScratchFolder scratch;
        put(scratch, "out/results.json", text.toStdString());
        const std::string why = whyNotRead(scratch.file("out"));
        QVERIFY2(QByteArray::fromStdString(why).contains(words), why.c_str());
        QCOMPARE(why.find('\n'), std::string::npos);
        QVERIFY(why.ends_with('.'));
    }

    void unreadableFile_isNamed()
    {
        const ScratchFolder scratch;
        std::filesystem::create_directories(scratch.file("out/results.json"));
        QVERIFY(saysOf(scratch.file("out"), "out/results.json cannot be read"));
        QVERIFY(saysOf(scratch.file("nowhere"), "nowhere/results.json cannot be read"));
    }

    void folders_areFoundAtAnyDepth_inNaturalOrder()
    {
        const ScratchFolder scratch;
        for (const char *name : {"r/b10/calibration", "r/b9/calibration", "r/a", "r/.hidden", "r"})
            putResults(scratch, name, {});
        put(scratch, "r/recordings/a.csv", "x");
        std::filesystem::create_directory_symlink(scratch.file("r/a"), scratch.file("r/link"));
        const auto found = runFoldersBelow(scratch.file("r"));
        QVERIFY(found.has_value());
        const std::vector<std::string> needed{scratch.file("r"), scratch.file("r/a"),
            scratch.file("r/b9/calibration"), scratch.file("r/b10/calibration")};
        QCOMPARE(*found, needed);
    }

    void folderWithoutResults_isAnError()
    {
        const ScratchFolder scratch;
        put(scratch, "empty/sub/a.csv", "x");
        const auto empty = runFoldersBelow(scratch.file("empty"));
        QVERIFY(!empty && empty.error().kind == ErrorKind::FileUnreadable);
        QVERIFY(english(empty.error().message).starts_with("There is no results.json in"));
        for (const char *name : {"empty/sub/a.csv", "nowhere"}) {
            const auto none = runFoldersBelow(scratch.file(name));
            QVERIFY(!none && none.error().kind == ErrorKind::FileUnreadable);
            QVERIFY(english(none.error().message).find("is no folder") != std::string::npos);
        }
    }
};

DYNCAL_TEST(TestEarlierRun)
#include "tst_earlier_run.moc"

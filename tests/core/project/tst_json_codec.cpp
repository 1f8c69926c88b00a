// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/project/json_codec.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <limits>

using namespace dyncal;

namespace {

struct Leaf
{
    Index count = 3;
    std::string name = "default";
    bool operator==(const Leaf &) const = default;
};

struct Tree
{
    Leaf leaf;
    std::vector<Leaf> leaves;
    Auto<double> rate;
    std::optional<double> limit;
    std::map<std::string, Index> columns;
    bool operator==(const Tree &) const = default;
};

Codec<Leaf> leafCodec()
{
    return object<Leaf>({
        field("count", &Leaf::count, whole(0, 10), true),
        field("name", &Leaf::name, anyText()),
    });
}

Codec<Tree> treeCodec()
{
    return object<Tree>({
        field("leaf", &Tree::leaf, leafCodec()),
        field("leaves", &Tree::leaves, list(leafCodec())),
        field("rate", &Tree::rate, orAuto(positiveNumber())),
        field("limit", &Tree::limit, orNull(number(-1.0, 1.0))),
        field("columns", &Tree::columns, dictionary(whole(0, 9), "a role", {{"dut"}, {"time"}})),
    });
}

const std::vector<std::string> &knownPaths()
{
    static const std::vector<std::string> paths{"leaf", "leaf.count", "leaf.name", "leaves",
        "leaves[].count", "leaves[].name", "rate", "limit", "columns", "columns.dut",
        "columns.time"};
    return paths;
}

template <typename T>
Result<T> readAs(const Codec<T> &codec, const char *json, const char *path = "key")
{
    const Json value = Json::parse(json);
    return codec.read({value, path, knownPaths()});
}

template <typename T>
std::string refusal(const Codec<T> &codec, const char *json, const char *path = "key")
{
    const Result<T> value = readAs(codec, json, path);
    return value ? "(accepted)" : english(value.error().message);
}

enum class Colour { Red, Green };

} // namespace

class TestJsonCodec : public QObject
{
    Q_OBJECT

private slots:
    void number_keepsItsBounds()
    {
        const Codec<double> closed = number(0.0, 1.0);
        QVERIFY(readAs(closed, "0").has_value());
        QVERIFY(readAs(closed, "1").has_value());
        QVERIFY(!readAs(closed, "1.0000000000000002").has_value());
        QVERIFY(!readAs(closed, "-5e-324").has_value());
        const Codec<double> open = number(0.0, 1.0, Bound::Exclusive);
        QVERIFY(!readAs(open, "0").has_value());
        QVERIFY(!readAs(open, "1").has_value());
        QVERIFY(readAs(open, "5e-324").has_value());
    }

    void number_takesNoOtherType()
    {
        for (const char *json : {"\"1\"", "null", "true", "[1]", "{}"})
            QVERIFY2(!readAs(anyNumber(), json).has_value(), json);
    }

    void number_neverReadsInfinity()
    {
        QVERIFY(readAs(anyNumber(), "1.7976931348623157e308").has_value());
        const Json infinite = std::numeric_limits<double>::infinity();
        QVERIFY(!anyNumber().read({infinite, "key", knownPaths()}).has_value());
    }

    void whole_isExact_data()
    {
        QTest::addColumn<QByteArray>("json");
        QTest::addColumn<bool>("accepted");
        QTest::newRow("integer") << QByteArray("7") << true;
        QTest::newRow("float without fraction") << QByteArray("7.0") << true;
        QTest::newRow("exponent") << QByteArray("7e0") << true;
        QTest::newRow("fraction") << QByteArray("7.5") << false;
        QTest::newRow("below") << QByteArray("-1") << false;
        QTest::newRow("above") << QByteArray("11") << false;
        QTest::newRow("beyond 63 bits") << QByteArray("18446744073709551615") << false;
        QTest::newRow("beyond 64 bits") << QByteArray("1e30") << false;
        QTest::newRow("text") << QByteArray("\"7\"") << false;
        QTest::newRow("truth value") << QByteArray("true") << false;
    }

    void whole_isExact()
    {
        QFETCH(QByteArray, json);
        QFETCH(bool, accepted);
        QCOMPARE(readAs(whole(0, 10), json.constData()).has_value(), accepted);
    }

    void orAuto_readsWordOrValue()
    {
        const Codec<Auto<double>> codec = orAuto(positiveNumber());
        QVERIFY(readAs(codec, "\"auto\"")->isAuto());
        QCOMPARE(*readAs(codec, "2.5")->value, 2.5);
        QCOMPARE(refusal(codec, "\"Auto\""),
            std::string("Recipe key key is \"Auto\"; it needs \"auto\" or a number above 0."));
        QVERIFY(codec.write({}) == "auto");
        QVERIFY(codec.write(Auto<double>(2.5)) == 2.5);
    }

    void orNull_readsNullOrValue()
    {
        const Codec<std::optional<double>> codec = orNull(positiveNumber());
        QVERIFY(!readAs(codec, "null")->has_value());
        QCOMPARE(**readAs(codec, "2.5"), 2.5);
        QVERIFY(codec.write(std::nullopt).is_null());
    }

    void oneOf_withAnEmptyWord_readsAndWritesNull()
    {
        const Codec<std::string> codec = oneOf({"", "gauge"});
        QCOMPARE(*readAs(codec, "null"), std::string());
        QCOMPARE(*readAs(codec, "\"gauge\""), std::string("gauge"));
        QVERIFY(codec.write("").is_null());
        QVERIFY(!readAs(oneOf({"gauge"}), "null").has_value());
        QCOMPARE(refusal(codec, "\"vacuum\""),
            std::string("Recipe key key is \"vacuum\"; it needs one of null, \"gauge\"."));
    }

    void choice_mapsWordsToValues()
    {
        const Codec<Colour> codec
            = choice<Colour>({{"red", Colour::Red}, {"green", Colour::Green}});
        QVERIFY(*readAs(codec, "\"green\"") == Colour::Green);
        QVERIFY(codec.write(Colour::Red) == "red");
        QVERIFY(!readAs(codec, "\"blue\"").has_value());
    }

    void interval_isTwoNumbersInOrder()
    {
        QCOMPARE(readAs(interval(), "[-1, 2]")->end, 2.0);
        for (const char *json : {"[2, -1]", "[1, 1]", "[1]", "[1, 2, 3]", "[\"1\", 2]", "3"})
            QVERIFY2(!readAs(interval(), json).has_value(), json);
    }

    void list_namesThePlaceOfTheWrongElement()
    {
        QCOMPARE(refusal(list(positiveNumber()), "[1, 2, -3]"),
            std::string("Recipe key key[2] is -3; it needs a number above 0."));
        QVERIFY(readAs(list(positiveNumber()), "[]").has_value());
        QVERIFY(!readAs(list(positiveNumber(), 1), "[]").has_value());
    }

    void object_keepsDefaultsOfWhatIsMissing()
    {
        const Result<Tree> tree = readAs(treeCodec(), "{\"leaf\": {\"count\": 7}}", "");
        QVERIFY(tree.has_value());
        QCOMPARE(tree->leaf.count, Index(7));
        QCOMPARE(tree->leaf.name, std::string("default"));
        QVERIFY(tree->rate.isAuto());
    }

    void object_demandsWhatIsRequired()
    {
        QCOMPARE(refusal(treeCodec(), "{\"leaves\": [{\"count\": 1}, {\"name\": \"x\"}]}", ""),
            std::string("Recipe key leaves[1] is {\"name\":\"x\"}; it needs the key \"count\"."));
    }

    void object_refusesUnknownKeysAtAnyDepth()
    {
        QCOMPARE(refusal(treeCodec(), "{\"leaves\": [{\"count\": 1, \"nam\": \"x\"}]}", ""),
            std::string(
                "Recipe key leaves[0].nam is unknown; the nearest known key is leaves[].name."));
        QCOMPARE(refusal(treeCodec(), "{\"columns\": {\"tim\": 1}}", ""),
            std::string(
                "Recipe key columns.tim is unknown; the nearest known key is columns.time."));
    }

    void object_knowsThePathsBelow()
    {
        std::vector<std::string> paths;
        for (const RecipeKey &key : treeCodec().keys)
            paths.push_back(key.path);
        QCOMPARE(paths.size(), knownPaths().size());
        for (const std::string &path : knownPaths())
            QVERIFY2(
                std::find(paths.begin(), paths.end(), "." + path) != paths.end(), path.c_str());
    }

    void written_readsBackTheSame()
    {
        Tree tree;
        tree.leaf = {5, "å \"quoted\" \\ \n"};
        tree.leaves = {{1, ""}, {2, "two"}};
        tree.rate = 0.1 + 0.2;
        tree.limit = -1.0;
        tree.columns = {{"dut", 2}};
        const std::string json = treeCodec().write(tree).dump();
        const Result<Tree> read = readAs(treeCodec(), json.c_str(), "");
        QVERIFY(read.has_value());
        QVERIFY(*read == tree);
    }

    void foundValue_isCutInTheSentence()
    {
        const std::string json = std::string("\"").append(500, 'x') + "\"";
        const std::string sentence = refusal(anyNumber(), json.c_str());
        QVERIFY(sentence.size() < 120);
        QVERIFY(sentence.find("xxx...") != std::string::npos);
    }
};

DYNCAL_TEST(TestJsonCodec)
#include "tst_json_codec.moc"

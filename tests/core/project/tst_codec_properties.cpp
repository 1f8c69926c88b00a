// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What holds of every codec and of every list of words: writing gives what reading takes, and the
// nearest word is by the definition of the distance.

#include "core/project/json_codec.h"
#include "core/project/nearest_word.h"
#include "core/project/recipe.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <limits>
#include <random>

using namespace dyncal;

namespace {

const std::vector<std::string> kPaths{"a", "b[].c", "d{}.e"};

template <typename T>
Result<T> readBy(const Codec<T> &codec, const Json &value)
{
    return codec.read({value, "key", kPaths});
}

/// What is written is read as the same value, and says of itself what it needs.
template <typename T>
void comesBack(const Codec<T> &codec, const T &value)
{
    const Json written = Json::parse(codec.write(value).dump());
    const Result<T> read = readBy(codec, written);
    QVERIFY2(read.has_value(), (codec.needs + ": " + written.dump()).c_str());
    QVERIFY2(*read == value, written.dump().c_str());
    QVERIFY(!codec.needs.empty());
}

/// Least number of changes, by the definition: all ways are tried.
Index distanceByDefinition(const std::string &a, const std::string &b)
{
    if (a.empty() || b.empty())
        return static_cast<Index>(a.size() + b.size());
    const std::string restA = a.substr(1), restB = b.substr(1);
    if (a[0] == b[0])
        return distanceByDefinition(restA, restB);
    return 1
        + std::min({distanceByDefinition(restA, restB), distanceByDefinition(restA, b),
            distanceByDefinition(a, restB)});
}

std::vector<std::string> someWords()
{
    std::mt19937 random(4);
    std::vector<std::string> words{"", "a", "ab", "ba", "aaa"};
    while (words.size() < 14) {
        std::string word;
        for (unsigned i = 0; i < 1 + random() % 6; ++i)
            word += static_cast<char>('a' + random() % 3);
        words.push_back(word);
    }
    return words;
}

} // namespace

class TestCodecProperties : public QObject
{
    Q_OBJECT

private slots:
    void everyCodec_readsWhatItWrites();
    void nested_readsWhatItWrites();
    void wholeNumbers_atTheEdgesOfTheirTypes();
    void sentences_holdTheirKeyAndNothingUnprintable();
    void distance_isThatOfItsDefinition();
    void nearest_isNoFartherThanAnyOther();
    void everyMisspeltKey_leadsToItself();
};

void TestCodecProperties::everyCodec_readsWhatItWrites()
{
    for (const double value : {0.0, -0.0, 5e-324, 0.1, -1.0 / 3.0, 1e22, 1.7976931348623157e308,
             -1.7976931348623157e308}) {
        comesBack(anyNumber(), value);
        comesBack(orNull(anyNumber()), std::optional<double>(value));
        comesBack(orAuto(anyNumber()), Auto<double>(value));
    }
    comesBack(orNull(anyNumber()), std::optional<double>());
    comesBack(orAuto(anyNumber()), Auto<double>());
    for (const Index value :
        {Index(0), Index(-1), std::numeric_limits<Index>::max(), std::numeric_limits<Index>::min()})
        comesBack(
            whole(std::numeric_limits<Index>::min(), std::numeric_limits<Index>::max()), value);
    for (const bool value : {true, false})
        comesBack(boolean(), value);
    for (const char *value : {"", "x", "null", "auto", "å日本\n\t\"\\/", "\x01\x1F\x7F"})
        comesBack(anyText(), std::string(value));
    comesBack(interval(), Interval{-5e-324, 0.0});
    comesBack(oneOf({"", "a", "b"}), std::string());
    comesBack(oneOf({"", "a", "b"}), std::string("b"));
    comesBack(choice<int>({{"one", 1}, {"two", 2}}), 2);
}

void TestCodecProperties::nested_readsWhatItWrites()
{
    // Words that stand for no value inside one another: each still means its own.
    const auto codec = valueOr(Json("none"), orNull(orAuto(list(orNull(positiveNumber())))));
    using Inner = Auto<std::vector<std::optional<double>>>;
    using Value = std::optional<std::optional<Inner>>;
    comesBack(codec, Value());
    comesBack(codec, Value(std::optional<Inner>()));
    comesBack(codec, Value(std::optional(Inner())));
    comesBack(codec, Value(std::optional(Inner({{}, 2.5, {}}))));
    comesBack(codec, Value(std::optional(Inner(std::vector<std::optional<double>>()))));
    const auto words = dictionary(dictionary(anyText(), "a name"), "a name");
    comesBack(words, {{"", {{"å.b[0]{c}", "x"}, {"", ""}}}, {"empty", {}}});
    QVERIFY(!readBy(codec, Json::array({nullptr, -1.0})));
    QVERIFY(!readBy(words, Json::parse(R"({"a": {"b": 1}})")));
}

void TestCodecProperties::wholeNumbers_atTheEdgesOfTheirTypes()
{
    constexpr Index kMost = std::numeric_limits<Index>::max();
    constexpr Index kLeast = std::numeric_limits<Index>::min();
    const Codec<Index> any = whole(kLeast, kMost);
    const std::vector<std::pair<const char *, std::optional<Index>>> cases{
        {"9223372036854775807", kMost}, {"-9223372036854775808", kLeast},
        {"9223372036854775808", {}}, // one too many: must not become the smallest number
        {"18446744073709551615", {}}, {"9007199254740992.0", Index(9007199254740992)},
        {"9007199254740994.0", {}}, // no longer every whole number is a double
        {"-1e15", Index(-1000000000000000)}, {"1e-5", {}}, {"-0.0", Index(0)}, {"1e300", {}}};
    for (const auto &[text, expected] : cases) {
        const Result<Index> read = readBy(any, Json::parse(text));
        QCOMPARE(read.has_value(), expected.has_value());
        if (expected)
            QCOMPARE(*read, *expected);
    }
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()})
        QVERIFY(!readBy(any, Json(bad)));
}

void TestCodecProperties::sentences_holdTheirKeyAndNothingUnprintable()
{
    for (const Json &value :
        {Json("\x01\n\x7F\xC3\xA5"), Json("\xFF\xFE"), Json(std::string(3000, '\xC3')),
            Json::array({std::string(47, 'x') + "\xC3\xA5"}), Json("%1 %2 %3")}) {
        const auto refused = readBy(positiveNumber(), value);
        QVERIFY(!refused);
        const std::string sentence = english(refused.error().message);
        QVERIFY2(sentence.starts_with("Recipe key key is "), sentence.c_str());
        QVERIFY2(sentence.ends_with("; it needs a number above 0."), sentence.c_str());
        QVERIFY(sentence.size() < 120);
        for (const char c : sentence)
            QVERIFY2(c >= ' ' && c <= '~', sentence.c_str());
    }
}

void TestCodecProperties::distance_isThatOfItsDefinition()
{
    const std::vector<std::string> words = someWords();
    for (const std::string &a : words) {
        for (const std::string &b : words) {
            QCOMPARE(editDistance(a, b), distanceByDefinition(a, b));
            QCOMPARE(editDistance(a, b), editDistance(b, a));
            QCOMPARE(editDistance(a, b) == 0, a == b);
            for (const std::string &c : words)
                QVERIFY(editDistance(a, c) <= editDistance(a, b) + editDistance(b, c));
        }
    }
}

void TestCodecProperties::nearest_isNoFartherThanAnyOther()
{
    const std::vector<std::string> words = someWords(); // of one section: plain distance
    for (const char *unknown : {"abcab", "c", "bbbbbbb", ""}) {
        const std::string nearest = nearestKey(unknown, words);
        for (const std::string &word : words)
            QVERIFY(editDistance(unknown, nearest) <= editDistance(unknown, word));
    }
}

/// A letter more, less or other anywhere in the last part of a key: the sentence names the key, or
/// one that is as near.
void TestCodecProperties::everyMisspeltKey_leadsToItself()
{
    int tried = 0;
    for (const std::string &key : recipeKeyPaths()) {
        const std::size_t name = key.rfind('.') + 1; // npos + 1 == 0
        for (std::size_t at = name; at <= key.size(); ++at) {
            std::string more = key, less = key, other = key;
            more.insert(at, 1, 'Q');
            if (at < key.size()) {
                less.erase(at, 1);
                other[at] = 'Q';
            }
            for (const std::string &misspelt : {more, less, other}) {
                const std::string nearest = nearestKey(misspelt, recipeKeyPaths());
                const bool isAnother = misspelt != key && misspelt == nearest;
                QVERIFY2(nearest == key || isAnother
                        || editDistance(
                               misspelt.substr(name), nearest.substr(nearest.rfind('.') + 1))
                            <= 1,
                    (misspelt + " -> " + nearest).c_str());
                ++tried;
            }
        }
    }
    QVERIFY(tried > 3000);
}

DYNCAL_TEST(TestCodecProperties)
#include "tst_codec_properties.moc"

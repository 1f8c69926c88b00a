// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Every key of docs/recipe.md at the ends of its documented range and with every wrong type, and
// recipes that were damaged on the way.

#include "core/project/recipe.h"
#include "tests/core/project/full_recipe.h"
#include "tests/support/test_program.h"

#include <nlohmann/json.hpp>

#include <QFile>
#include <QRegularExpression>
#include <QTest>

#include <cmath>
#include <limits>

using namespace dyncal;
using Json = nlohmann::json;

namespace {

/// The keys without which an element is refused, so that one key can be tried beside them.
const std::map<std::string, const char *> kElements{
    {"import.exclude", R"({"shot": 1, "reason": "x"})"},
    {"import.shots", R"({"shot": 1, "channels": {}})"},
    {"shock.arrival_sensors", R"({"channel": "a", "distance_to_end_wall_m": 1})"},
    {"shock.counters", R"({"far_m": 1, "near_m": 0, "time_s": 1})"},
    {"window.exclude_stretches", R"({"shot": 1, "from_s": 0, "to_s": 1, "reason": "x"})"},
    {"realization.nuisance_modes", R"({"frequency_hz": 1, "reason": "x"})"},
    {"realization.candidate_notes", R"({"order": 3, "note": "x"})"},
    {"response.known", R"({"label": "a", "magnitude": 1, "u": 1, "unit": "V/Pa"})"},
    {"uncertainty.budget", R"({"quantity": "a", "u": 1})"},
    {"uncertainty.correlations", R"({"quantity": "p1_pa", "with": "t1_k", "r": 0.5})"},
    {"uncertainty.cmc", R"({"of": "f0_hz", "expanded": 1})"},
    {"profile", R"({"name": "a", "version": "1", "sha256": "b", "sections": {}})"},
    {"acknowledge", R"({"finding": "a", "reason": "x"})"},
    {"comparison.model",
        R"({"sensitivity": 1, "u_sensitivity": 0, "f0_hz": 1, "u_f0_hz": 0, "zeta": 1, "u_zeta": 0})"},
    {"certificate.decision",
        R"({"rule": "simple", "within_percent": 5, "from_hz": 1, "to_hz": 1.7e308})"},
    {"shock.driven_gas", R"({"gamma": 1.3, "molar_mass_kg_mol": 0.03})"},
    {"shock.driver_gas", R"({"gamma": 1.3, "molar_mass_kg_mol": 0.03})"},
};

/// One documented key, and where its value stands in a document.
struct Place
{
    std::string key; ///< "import.exclude[].shot"
    std::string named; ///< as a sentence names it: "import.exclude[0].shot"
    std::string pointer; ///< "/import/exclude/0/shot"
};

Place placeOf(const std::string &key)
{
    QString named = QString::fromStdString(key).replace("[]", "[0]").replace("{}", "{A}");
    QString pointer = "/" + QString::fromStdString(key);
    pointer.replace("[]", "/0").replace("{}", "/A").replace('.', '/');
    return {key, named.toStdString(), pointer.toStdString()};
}

/// A recipe with nothing but that value, and the keys that its neighbours need.
Json documentWith(const Place &place, const Json &value)
{
    Json document = Json::object();
    for (const auto &[list, element] : kElements) {
        if (place.key.starts_with(list + "[]."))
            document[Json::json_pointer(placeOf(list).pointer)]
                = Json::array({Json::parse(element)});
        else if (place.key.starts_with(list + "."))
            document[Json::json_pointer(placeOf(list).pointer)] = Json::parse(element);
    }
    if (place.key == "realization.order") // the largest of all is up to max_order
        document["realization"]["max_order"] = 2000;
    if (place.key.ends_with("{}.role") || place.key.find("{}.") != std::string::npos)
        document[Json::json_pointer(place.pointer.substr(0, place.pointer.rfind('/')))]
            = Json::object();
    document[Json::json_pointer(place.pointer)] = value;
    return document;
}

std::string refusal(const Json &document)
{
    const Result<Recipe> recipe = parseRecipe(document.dump());
    if (recipe)
        return "(accepted)";
    return recipe.error().kind == ErrorKind::Usage ? english(recipe.error().message)
                                                   : "(wrong kind)";
}

/// The value that the recipe writes where `value` was read; a later key is left out while null.
Json readBack(const Place &place, const Json &value)
{
    const Result<Recipe> recipe = parseRecipe(documentWith(place, value).dump());
    const Json written = Json::parse(recipeJson(*recipe));
    const Json::json_pointer pointer(place.pointer);
    return written.contains(pointer) ? written.at(pointer) : Json();
}

/// The documented range of a number.
struct Range
{
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool lowOpen = false;
    bool highOpen = false;
};

double numberOf(const QString &text)
{
    return text == "2^53 - 1" ? 9007199254740991.0 : text.toDouble();
}

std::optional<Range> rangeOf(const QString &text)
{
    static const QString kNumber = R"((2\^53 - 1|-?[0-9.]+(?:e[0-9]+)?))";
    static const QRegularExpression fromTo("^" + kNumber + " to " + kNumber + "( each)?$");
    static const QRegularExpression above(
        "^above " + kNumber + "(?:, (at most|below) " + kNumber + ")?(?: \\(.*\\))?$");
    static const QRegularExpression from("^from " + kNumber + "$");
    static const QRegularExpression between("^between " + kNumber + " and " + kNumber + "$");
    if (const auto m = fromTo.match(text); m.hasMatch())
        return Range{numberOf(m.captured(1)), numberOf(m.captured(2)), false, false};
    if (const auto m = above.match(text); m.hasMatch()) {
        Range range{numberOf(m.captured(1))};
        range.lowOpen = true;
        if (!m.captured(3).isEmpty())
            range.high = numberOf(m.captured(3));
        range.highOpen = m.captured(2) == "below";
        return range;
    }
    if (const auto m = from.match(text); m.hasMatch())
        return Range{numberOf(m.captured(1))};
    if (const auto m = between.match(text); m.hasMatch())
        return Range{numberOf(m.captured(1)), numberOf(m.captured(2)), true, true};
    return std::nullopt;
}

} // namespace

class TestRecipeRanges : public QObject
{
    Q_OBJECT

private:
    struct Row
    {
        Place place;
        QString range;
    };
    std::vector<Row> m_rows;

    /// Keys whose one value is a list of such numbers.
    static Json asWritten(const Row &row, double number)
    {
        Json value = number;
        if (number == std::floor(number) && std::abs(number) < 1e16)
            value = static_cast<std::int64_t>(number);
        const bool isList = row.place.key == "response.frequencies_hz"
            || row.place.key == "spectrum.resonance" || row.place.key == "realization.candidates";
        return isList ? Json::array({value}) : value;
    }

    static bool takes(const Row &row, double number)
    {
        return refusal(documentWith(row.place, asWritten(row, number))) == "(accepted)";
    }

private slots:
    void initTestCase();
    void numbers_endWhereTheTableSays();
    void words_areThoseOfTheTable();
    void anyValue_isKeptOrRefusedByItsKey();
    void everyPrefix_isRefused();
    void oneByteDamaged_isRefusedOrReadWhole();
    void budgetQuantityTwice_isRefused();
    void fileSize_hasItsLimit();
    void byteOrderMark_isNoDamage();
};

void TestRecipeRanges::initTestCase()
{
    QFile file(qEnvironmentVariable("DYNCAL_SOURCE_DIR") + "/docs/recipe.md");
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QString table
        = QString::fromUtf8(file.readAll()).section("\n## Keys", 1).section("\n## ", 0, 0);
    for (const QString &line : table.split('\n')) {
        const QStringList cells = QString(line).replace("\\|", "/").split('|');
        if (line.startsWith("| `"))
            m_rows.push_back(
                {placeOf(cells[1].trimmed().remove('`').toStdString()), cells[5].trimmed()});
    }
    QVERIFY(m_rows.size() > 80);
}

void TestRecipeRanges::numbers_endWhereTheTableSays()
{
    int checked = 0;
    for (const Row &row : m_rows) {
        QString text = row.range;
        if (row.place.key == "realization.order")
            text = "1 to 2000";
        const auto range = rangeOf(text);
        if (!range)
            continue;
        const bool isWhole = !takes(row,
            std::isinf(range->high)
                ? range->low + 2.5
                : 0.5 * (std::floor(range->low) + std::ceil(range->high)) + 0.25);
        const auto beside = [&](double edge, double direction) {
            return isWhole ? edge + direction
                           : std::nextafter(edge, direction * std::numeric_limits<double>::max());
        };
        const auto check = [&](double edge, double inwards, bool isOpen) {
            const std::string wrong
                = row.place.key + " at " + std::to_string(edge) + ": " + row.range.toStdString();
            QVERIFY2(takes(row, isOpen ? beside(edge, inwards) : edge), wrong.c_str());
            const double outside = isOpen ? edge : beside(edge, -inwards);
            const std::string sentence = refusal(documentWith(row.place, asWritten(row, outside)));
            QVERIFY2(sentence.starts_with("Recipe key " + row.place.named), sentence.c_str());
        };
        check(range->low, 1.0, range->lowOpen);
        if (!std::isinf(range->high))
            check(range->high, -1.0, range->highOpen);
        ++checked;
    }
    qInfo("%d ranges of numbers", checked);
    QVERIFY(checked > 55);
}

void TestRecipeRanges::words_areThoseOfTheTable()
{
    static const QRegularExpression word("`(\"[^`]*\")`");
    int checked = 0;
    for (const Row &row : m_rows) {
        QStringList words;
        for (auto match = word.globalMatch(row.range); match.hasNext();)
            words << match.next().captured(1).replace('/', '|');
        if (words.isEmpty())
            continue;
        const bool isList
            = row.place.key == "certificate.languages" || row.place.key == "import.levels";
        for (const QString &text : words) {
            Json value = Json::parse(text.toStdString());
            value = isList ? Json::array({value}) : value;
            QVERIFY2(refusal(documentWith(row.place, value)) == "(accepted)",
                (row.place.key + ": " + text.toStdString()).c_str());
            QVERIFY2(readBack(row.place, value) == value, row.place.key.c_str());
        }
        const Json unknown = isList ? Json::array({"?"}) : Json("?");
        const std::string sentence = refusal(documentWith(row.place, unknown));
        QVERIFY2(sentence.starts_with("Recipe key " + row.place.named), sentence.c_str());
        ++checked;
    }
    QVERIFY(checked > 18);
}

/// A value that is accepted is written again as it is: nothing is dropped or bent without a word.
void TestRecipeRanges::anyValue_isKeptOrRefusedByItsKey()
{
    const std::vector<Json> values{nullptr, true, 0, 1, -1, 1.5, 1e300, "", "?", "auto", "none",
        Json::array(), Json::array({1.5}), Json::array({2.5, 1.5}), Json::array({1.5, 2.5}),
        Json::array({nullptr}), Json::array({Json::array()}), Json::object(),
        Json::object({{"?", 1}}), Json::array({Json::object({{"?", 1}})}), 9223372036854775807LL,
        std::string("\xC3\x85\xF0\x9F\x94\x94\n\"")};
    // Words, empty lists and lists of one have a shorter or a longer form that means the same.
    const auto meansTheSame = [](const Json &value, const Json &written) {
        return written == value || (value == "" && written.is_null())
            || (written.is_object() && written.value("substance", "") == value) // a gas by its name
            || (value == Json::array() && (written.is_null() || written == "none"))
            || (value.is_array() && value.size() == 1 && written == value[0]);
    };
    int accepted = 0, refused = 0;
    for (const Row &row : m_rows) {
        for (const Json &value : values) {
            const std::string sentence = refusal(documentWith(row.place, value));
            const std::string tried = row.place.key + " = " + value.dump() + ": ";
            if (sentence != "(accepted)") {
                QVERIFY2(sentence.starts_with("Recipe key " + row.place.named),
                    (tried + sentence).c_str());
                QVERIFY2(sentence.ends_with("."), sentence.c_str());
                ++refused;
            } else if (!value.is_object()) {
                const Json written = readBack(row.place, value);
                QVERIFY2(meansTheSame(value, written), (tried + written.dump()).c_str());
                ++accepted;
            }
        }
    }
    qInfo("%d values kept, %d refused", accepted, refused);
    QVERIFY(accepted > 200 && refused > 1000);
}

void TestRecipeRanges::everyPrefix_isRefused()
{
    const std::string json = recipeJson(fullRecipe());
    for (std::size_t length = 0; length + 2 < json.size(); ++length) {
        const Result<Recipe> cut = parseRecipe(json.substr(0, length));
        QVERIFY2(!cut && cut.error().kind == ErrorKind::Usage, std::to_string(length).c_str());
        QVERIFY(english(cut.error().message).starts_with("The recipe is not valid JSON"));
    }
}

void TestRecipeRanges::oneByteDamaged_isRefusedOrReadWhole()
{
    const std::string json = recipeJson(fullRecipe());
    const std::string bytes("\0\xFF}9-\"", 6);
    for (std::size_t at = 0; at < json.size(); ++at) {
        std::string damaged = json;
        damaged[at] = bytes[at % bytes.size()];
        const Result<Recipe> read = parseRecipe(damaged);
        if (!read)
            QVERIFY(english(read.error().message).size() > 20);
        else // another number or another text: what is read is what is written
            QVERIFY(parseRecipe(recipeJson(*read)).value() == *read);
    }
}

void TestRecipeRanges::budgetQuantityTwice_isRefused()
{
    // Only one of the two lines would count, and the uncertainty would be too small.
    const Json line{{"quantity", "t1_k"}, {"u", 0.3}};
    Json document;
    document["uncertainty"]["budget"] = Json::array({line, line});
    QCOMPARE(refusal(document),
        std::string(
            "Recipe key uncertainty.budget holds the quantity \"t1_k\" twice; join the two contributions to one."));
    document["uncertainty"]["budget"][1]["quantity"] = "t1_K";
    QCOMPARE(refusal(document), std::string("(accepted)"));
}

void TestRecipeRanges::fileSize_hasItsLimit()
{
    constexpr std::size_t kLimit = 4 * 1024 * 1024; // the header's "4 MiB that any recipe needs"
    const QString path = QDir::temp().filePath(
        QStringLiteral("recipe-å-%1.json").arg(QCoreApplication::applicationPid()));
    for (const std::size_t size : {kLimit, kLimit + 1}) {
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("{}" + QByteArray(static_cast<qsizetype>(size) - 2, ' '));
        file.close();
        const Result<Recipe> recipe = readRecipeFile(path.toStdString());
        QCOMPARE(recipe.has_value(), size == kLimit);
        if (!recipe)
            QCOMPARE(recipe.error().kind, ErrorKind::FileUnreadable);
    }
    QFile::remove(path);
}

void TestRecipeRanges::byteOrderMark_isNoDamage()
{
    QVERIFY(parseRecipe("\xEF\xBB\xBF{\"remap\": false}").value().remap == false);
    QVERIFY(!parseRecipe("\xFF\xFE{\0}\0"));
}

DYNCAL_TEST(TestRecipeRanges)
#include "tst_recipe_ranges.moc"

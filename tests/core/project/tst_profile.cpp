// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A recipe over a laboratory's profile: what it leaves out is as in the profile, whatever the way
// in which either writes it.

#include "core/project/json_merge.h"
#include "core/project/recipe.h"
#include "tests/core/project/full_recipe.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <filesystem>

using namespace dyncal;
using dyncal::testing::ScratchFolder;

class TestProfile : public QObject
{
    Q_OBJECT

private:
    ScratchFolder m_folder;

    std::string written(const char *name, const std::string &text) const
    {
        return m_folder.write(name, text.data(), text.size());
    }

    Result<Recipe> merged(const std::string &recipe, const std::string &profile) const
    {
        return readRecipeFiles(written("r.json", recipe), written("p.json", profile));
    }

    static Json over(Json lower, const Json &upper)
    {
        putOver(lower, upper);
        return lower;
    }

private slots:
    void profileAlone_andUnderAnEmptyRecipe_areTheSame();
    void recipeThatSaysEverything_hidesTheProfile();
    void channels_roleAndDetailsJoin_data();
    void channels_roleAndDetailsJoin();
    void merging_isAssociativeAndRepeats();
    void faultOfEither_isNamedAsItsOwn();
    void contradictionOfBoth_isRefused();
    void foldersAndUnicodeNames();
};

void TestProfile::profileAlone_andUnderAnEmptyRecipe_areTheSame()
{
    const std::string profile = R"({"import": {"unit": "psi", "exclude": [{"shot": 2, "reason":
        "x"}]}, "checks": {"min_codes": 8}})";
    const Recipe alone = readRecipeFiles({}, written("p.json", profile)).value();
    QVERIFY(merged("{}", profile).value() == alone);
    QVERIFY(alone == parseRecipe(profile).value());
    QVERIFY(merged(R"({"import": {}})", profile).value() == alone);
}

/// A recipe with every default filled in says everything: nothing of the profile is left but the
/// names that it does not know.
void TestProfile::recipeThatSaysEverything_hidesTheProfile()
{
    const std::string profile = R"({"import": {"unit": "psi", "scale": 7, "levels": ["low"],
        "decimal": ","}, "checks": {"min_codes": 8, "step_sigma": 99}})";
    QVERIFY(merged(recipeJson(Recipe()), profile).value() == Recipe());
    QVERIFY(merged(recipeJson(fullRecipe()), profile).value() == fullRecipe());
}

void TestProfile::channels_roleAndDetailsJoin_data()
{
    QTest::addColumn<QByteArray>("profile");
    QTest::addColumn<QByteArray>("recipe");
    QTest::addColumn<QByteArray>("together");
    const auto row = [](const char *name, const char *profile, const char *recipe,
                         const char *together) {
        QTest::newRow(name) << QByteArray(profile) << QByteArray(recipe) << QByteArray(together);
    };
    row("details under a role", R"({"role": "other", "sensitivity": 5e-6})", R"("dut")",
        R"({"role": "dut", "sensitivity": 5e-6})");
    row("role under details", R"("dut")", R"({"sensitivity": 5e-6})",
        R"({"role": "dut", "sensitivity": 5e-6})");
    row("role over role", R"("dut")", R"("other")", R"("other")");
    row("role in both, with details", R"("dut")", R"({"role": "other", "gain": 2})",
        R"({"role": "other", "gain": 2})");
    row("details in both", R"({"unit": "mV", "gain": 10})", R"({"gain": 2, "scale": 3})",
        R"({"unit": "mV", "gain": 2, "scale": 3})");
    row("taken back", R"({"role": "dut", "unit": "mV"})", R"({"role": null, "unit": null})",
        R"({"role": null, "unit": null})");
}

void TestProfile::channels_roleAndDetailsJoin()
{
    QFETCH(QByteArray, profile);
    QFETCH(QByteArray, recipe);
    QFETCH(QByteArray, together);
    const auto forAll = [](const QByteArray &channel) {
        return R"({"import": {"channels": {"A": )" + channel.toStdString() + "}}}";
    };
    const auto forOneFile = [](const QByteArray &channel) {
        return R"({"import": {"files": {"a.csv": {"channels": {"A": )" + channel.toStdString()
            + "}}}}}";
    };
    QVERIFY(
        merged(forAll(recipe), forAll(profile)).value() == parseRecipe(forAll(together)).value());
    QVERIFY(merged(forOneFile(recipe), forOneFile(profile)).value()
        == parseRecipe(forOneFile(together)).value());
}

void TestProfile::merging_isAssociativeAndRepeats()
{
    const Json a = Json::parse(R"({"x": {"channels": {"A": "dut", "B": {"gain": 2}}}, "y": [1]})");
    const Json b = Json::parse(R"({"x": {"channels": {"A": {"gain": 3}, "B": "other"}}, "z": {}})");
    const Json c = Json::parse(R"({"x": {"channels": {"A": "other", "C": "dut"}}, "y": {"w": 1}})");
    QVERIFY(over(over(a, b), c) == over(a, over(b, c)));
    for (const Json &one : {a, b, c}) {
        QVERIFY(over(one, one) == one);
        QVERIFY(over(one, Json::object()) == one);
        QVERIFY(over(Json::object(), one) == one);
        QVERIFY(over(over(a, one), one) == over(a, one));
    }
    // Only below "channels" is a word the role of an object.
    QVERIFY(over(Json::parse(R"({"gas": {"gamma": 1.4}})"), Json::parse(R"({"gas": "he"})"))
        == Json::parse(R"({"gas": "he"})"));
}

void TestProfile::faultOfEither_isNamedAsItsOwn()
{
    const auto sentence = [&](const std::string &recipe, const std::string &profile) {
        const auto read = merged(recipe, profile);
        return read ? std::string("(accepted)") : english(read.error().message);
    };
    QVERIFY(sentence("{", "{}").starts_with("The recipe is not valid JSON"));
    QVERIFY(sentence("{}", "{").starts_with("The profile is not valid JSON"));
    QVERIFY(sentence("[]", "{}").starts_with("Recipe key (the whole) is []"));
    QVERIFY(sentence("{}", "[]").starts_with("Recipe key (the whole) is []"));
    QVERIFY(sentence("{}", R"({"import": {"scale": -1}})").starts_with("Recipe key import.scale"));
    // A mistake of the profile is none less for the recipe hiding it.
    QVERIFY(sentence(R"({"import": {"scale": 1}})", R"({"import": {"scale": -1}})")
                .starts_with("Recipe key import.scale is -1"));
    QVERIFY(sentence("{}", R"({"schema": "dyncal-recipe/2"})").starts_with("Recipe key schema"));
    for (const char *section : {"shock", "window", "spectrum", "pca", "input", "realization",
             "response", "uncertainty", "certificate"}) {
        const std::string profile = std::string("{\"") + section + "\": {}}";
        QVERIFY2(
            sentence("{}", profile).find('"' + std::string(section) + '"') != std::string::npos,
            section);
    }
}

void TestProfile::contradictionOfBoth_isRefused()
{
    // Each is a recipe by itself; joined, an object meets a word that is no channel.
    const auto read = merged(R"({"import": {"files": "none"}})", R"({"import": {"files": {}}})");
    QVERIFY(!read && read.error().kind == ErrorKind::Usage);
    QVERIFY(english(read.error().message).starts_with("Recipe key import.files"));
}

void TestProfile::foldersAndUnicodeNames()
{
    const std::string name = "Labb Å–α 日本.json";
    const std::string profile = written(name.c_str(), R"({"import": {"unit": "psi"}})");
    QCOMPARE(readRecipeFiles({}, profile)->import.unit.value(), std::string("psi"));
    const std::string folder = std::filesystem::path(profile).parent_path().string();
    for (const std::string &path : {folder, profile + "x", std::string(5000, 'x')}) {
        const auto read = readRecipeFiles({}, path);
        QVERIFY(!read && read.error().kind == ErrorKind::FileUnreadable);
        QVERIFY(!readRecipeFiles(path, profile));
        QVERIFY(!readRecipeFiles(path, {}));
    }
}

DYNCAL_TEST(TestProfile)
#include "tst_profile.moc"

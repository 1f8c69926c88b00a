// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A damaged profile: whatever stands in it, there is a recipe or a sentence.

#include "core/project/recipe.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <random>

using namespace dyncal;
using dyncal::testing::ScratchFolder;

namespace {

const std::string kWhole = R"({"schema": "dyncal-profile/1", "name": "Tube", "version": "1",
    "import": {"channels": {"A": "dut"}}, "shock": {"driven_length_m": 0.97},
    "uncertainty": {"budget": [{"quantity": "t1_k", "u": 0.3, "due": "2027-01-31"}],
    "cmc": [{"of": "f0_hz", "expanded": 0.02}]}, "chain": {"source": "amp.csv"}})";

} // namespace

class TestProfileHostile : public QObject
{
    Q_OBJECT

private:
    ScratchFolder m_folder;

    /// Read, or refused in a sentence; what is read can be written and read again.
    bool isAnswered(const std::string &profile, const std::string &recipe = "{}") const
    {
        const std::string path = m_folder.write("p.json", profile.data(), profile.size());
        const std::string upper = m_folder.write("r.json", recipe.data(), recipe.size());
        const auto read = readRecipeFiles(upper, path);
        if (!read)
            return english(read.error().message).size() > 20;
        return parseRecipe(recipeJson(*read)).has_value();
    }

private slots:
    void everyBeginning()
    {
        for (std::size_t length = 0; length <= kWhole.size(); ++length)
            QVERIFY2(isAnswered(kWhole.substr(0, length)), std::to_string(length).c_str());
    }

    void changedBytes()
    {
        std::mt19937 random(20261126);
        for (int trial = 0; trial < 500; ++trial) {
            std::string text = kWhole;
            for (int change = 0; change < 1 + trial % 4; ++change)
                text[random() % text.size()] = static_cast<char>(random() % 128);
            QVERIFY2(isAnswered(text), text.c_str());
        }
    }

    /// Another kind of value in the place of a section, in either of the two.
    void otherKinds()
    {
        for (const char *section : {"import", "shock", "uncertainty", "chain", "checks", "name"})
            for (const char *value : {"null", "1", "\"x\"", "[]", "{}", "[{}]", R"({"budget": 1})",
                     R"({"budget": [1], "cmc": {}})", R"({"cmc": [[]]})"}) {
                const std::string pair = std::string("\"") + section + "\": " + value;
                QVERIFY2(
                    isAnswered(R"({"schema": "dyncal-profile/1", "version": "1", )" + pair + "}"),
                    pair.c_str());
                QVERIFY2(isAnswered(kWhole, "{" + pair + "}"), pair.c_str());
            }
    }

    void markInARecipe_isNotTrusted()
    {
        for (const char *mark : {R"({"name": "x", "version": "1", "sha256": "a", "sections": {}})",
                 R"({"name": "x", "version": "1", "sha256": "a", "sections": {"a": {"b": [1]}}})",
                 R"({"name": "x", "version": "1", "sha256": "a",
                     "sections": {"uncertainty": {"budget": [1, {}, {"quantity": 3}]}}})"}) {
            const auto read = parseRecipe(R"({"profile": )" + std::string(mark) + "}");
            QVERIFY(read.has_value());
            QVERIFY(changedFromProfile(*read).size() <= 3);
        }
    }
};

DYNCAL_TEST(TestProfileHostile)
#include "tst_profile_hostile.moc"

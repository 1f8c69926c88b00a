// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/issue/issued_recipe.h"

#include "core/base/content_hash.h"
#include "tests/support/example_results.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <set>

using namespace dyncal;

namespace {

const IssueNames kNames{"A. Berg", "B. Ek", "2026-11-21T12:00:00Z"};

CaptureSet exampleCaptures()
{
    return example::calibration({}).captures->set;
}

} // namespace

/// What is frozen of a job, and by what it is known again.
class TestIssuedRecipe : public QObject
{
    Q_OBJECT

private slots:
    void numberDateAndNames_areFilledIn()
    {
        Recipe typed;
        typed.certificate.fields
            = {{"certificate_number", "draft 3"}, {"date_issued", "2020-01-01"}, {"operator", " "}};
        const auto fields = issuedRecipe(typed, "17", kNames).certificate.fields;
        QCOMPARE(fields.at("certificate_number"), "17");
        QCOMPARE(fields.at("date_issued"), "2026-11-21");
        QCOMPARE(fields.at("operator"), "A. Berg");
        QCOMPARE(fields.at("approved_by"), "B. Ek");
    }

    /// Whoever calibrated stays, and so does what was typed of the approval if nobody is named.
    void typedNames_stay()
    {
        Recipe typed;
        typed.certificate.fields = {{"operator", "C. Operator"}, {"approved_by", "D. Boss"}};
        const auto fields
            = issuedRecipe(typed, "1", {"A. Berg", {}, kNames.utc}).certificate.fields;
        QCOMPARE(fields.at("operator"), "C. Operator");
        QCOMPARE(fields.at("approved_by"), "D. Boss");
        QCOMPARE(issuerOf(typed, {}), "C. Operator");
        QCOMPARE(issuerOf(typed, kNames), "A. Berg");
        QCOMPARE(issuerOf({}, {}), "");
    }

    void folders_areNotNamed()
    {
        Recipe recipe;
        recipe.chain.source = "/home/user/secret/chain.csv";
        recipe.comparison.source = "../lab/transducer.xml";
        const Recipe issued = issuedRecipe(recipe, "1", kNames);
        QCOMPARE(issued.chain.source, "chain.csv");
        QCOMPARE(issued.comparison.source, "transducer.xml");
        QCOMPARE(issuedRecipe({}, "1", kNames).chain.source, "");
    }

    /// From the documented text: the hashes in order, each with the numbers of its shots.
    void job_isThatOfTheRecordings()
    {
        CaptureSet set;
        set.inputs = {{"/a/x.h5", "x.h5", "bbb", "f"}, {"/a/y.h5", "y.h5", "aaa", "f"}};
        set.shots.resize(3);
        set.shots[0].input = 0;
        set.shots[0].inFile = 1;
        set.shots[1].input = set.shots[2].input = 1;
        set.shots[1].inFile = 2;
        set.shots[2].inFile = 5;
        QCOMPARE(jobOf(set), sha256Hex(std::string_view("aaa 2 5\nbbb 1\n")));
        std::swap(set.inputs[0], set.inputs[1]); // in another order, under other names
        for (Shot &shot : set.shots)
            shot.input = 1 - shot.input;
        set.inputs[0].path = set.inputs[0].file = "renamed";
        QCOMPARE(jobOf(set), sha256Hex(std::string_view("aaa 2 5\nbbb 1\n")));
    }

    void hash_isOfAllThatIsOnTheCertificate()
    {
        const CaptureSet captures = exampleCaptures();
        Recipe recipe;
        std::set<std::string> hashes;
        const auto add = [&](const Recipe &of, const IssueNames &names, const char *amends,
                             const char *reason) {
            hashes.insert(jobSha256(captures, of, names, amends, reason));
        };
        add(recipe, kNames, "", "");
        add(recipe, kNames, "1", "");
        add(recipe, kNames, "1", "why");
        add(recipe, {"A. Berg", {}, kNames.utc}, "", "");
        add(recipe, {"C", "B. Ek", kNames.utc}, "", "");
        recipe.certificate.fields["customer"] = "other";
        add(recipe, kNames, "", "");
        recipe.window.end_s = 1e-4;
        add(recipe, kNames, "", "");
        QCOMPARE(hashes.size(), 7U);
        // The time is none of it, nor what issuing fills in.
        IssueNames later = kNames;
        later.utc = "2027-01-01T00:00:00Z";
        add(recipe, later, "", "");
        recipe.certificate.fields["certificate_number"] = "draft";
        recipe.certificate.fields["date_issued"] = "2026-01-01";
        add(recipe, later, "", "");
        QCOMPARE(hashes.size(), 7U);
    }

    void decisions_haveTheirReasons()
    {
        CaptureSet captures = exampleCaptures();
        QVERIFY(decisionsOf(captures, {}).empty());
        captures.shots[1].included = false;
        captures.shots[1].excludeReason = "diaphragm held";
        Recipe recipe;
        recipe.acknowledge = {{"WIN-001", 3, "plateau seen"}, {"CAP-014", 0, "small step"}};
        recipe.realization.adoptedReason = "lowest order that fits";
        recipe.import.sampleRateReason = "the header is wrong";
        recipe.import.interpolateInvalid = 5;
        using Decisions = std::vector<std::pair<std::string, std::string>>;
        QVERIFY((decisionsOf(captures, recipe)
            == Decisions{{"left out shot 2", "diaphragm held"},
                {"accepted WIN-001, shot 3", "plateau seen"}, {"accepted CAP-014", "small step"},
                {"chose the model order", "lowest order that fits"},
                {"stated the sample rate", "the header is wrong"},
                {"interpolated invalid samples, at most 5 in a row", ""}}));
    }

    void sensor_isAsTheCertificateStatesIt()
    {
        const CalibrationResults results = example::calibration();
        Recipe recipe;
        QCOMPARE(sensorName(results, recipe), "Fibre Works optic3 SN-0042"); // from its card
        recipe.certificate.fields["sensor_serial"] = "typed";
        QCOMPARE(sensorName(results, recipe), "Fibre Works optic3 typed");
        QCOMPARE(sensorName({}, {}), "");
    }
};

DYNCAL_TEST(TestIssuedRecipe)
#include "tst_issued_recipe.moc"

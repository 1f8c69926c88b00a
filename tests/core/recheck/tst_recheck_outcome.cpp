// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/recheck/recheck_outcome.h"
#include "tests/core/recheck/earlier_results.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

EarlierRun runWith(const EarlierJson &results)
{
    EarlierRun run;
    run.folder = "out";
    run.results = results;
    return run;
}

RecheckAnswer answerOf(const std::string &folder, const EarlierJson &issued, const EarlierJson &now,
    const std::string &refusal = {})
{
    return {folder, recheckedRun(runWith(issued), now, refusal)};
}

EarlierJson withF0(double f0_Hz)
{
    EarlierJson root = earlierResults();
    root["characteristics"][0]["value"] = f0_Hz;
    return root;
}

EarlierJson blockedBy(EarlierJson root, const char *id)
{
    root["findings"].push_back({{"id", id}, {"severity", "block"}, {"message", "It is frozen."}});
    return root;
}

std::string kindsOf(const std::vector<RecheckAnswer> &answers)
{
    std::string text;
    for (const RecheckRow &row : recheckRows(answers))
        text += row.answer->folder + ' ' + recheckKindName(row.kind)
            + (row.difference ? ' ' + row.difference->pair.of : std::string()) + ';';
    return text;
}

EarlierJson jsonOf(const std::vector<RecheckAnswer> &answers)
{
    return EarlierJson::parse(recheckJson(answers));
}

} // namespace

class TestRecheckOutcome : public QObject
{
    Q_OBJECT

private slots:
    void sameResults_giveNothing()
    {
        const std::vector<RecheckAnswer> answers{
            answerOf("out", earlierResults(), earlierResults())};
        const RecheckedRun &run = *answers[0].run;
        QVERIFY(!run.hasDifferences() && !run.needsAmendment());
        QCOMPARE(run.quantities.compared(), 17);
        QCOMPARE(run.quantities.list.front().overU, 0.0);
        QCOMPARE(run.software, std::string("0.1.0 (build abc)"));
        QCOMPARE(run.createdUtc, std::string("2026-01-01T00:00:00Z"));
        QVERIFY(recheckRows(answers).empty());
        QCOMPARE(recheckJson(answers), std::string("[]\n"));
    }

    /// Only then need nothing be drawn again.
    void asIssued_isToTheLastBit_byTheSameMethods()
    {
        const auto same = [](const EarlierJson &issued, const EarlierJson &now) {
            return answerOf("out", issued, now).run->isAsIssued();
        };
        QVERIFY(same(earlierResults(), earlierResults()));
        QVERIFY(!same(earlierResults(), withF0(std::nextafter(318e3, 1e9))));
        EarlierJson other = earlierResults();
        other["software"]["method"]["monte_carlo_of_the_chain"] = 99;
        QVERIFY(!same(other, earlierResults()));
        other["software"].erase("method");
        QVERIFY(!same(other, earlierResults()));
        other = earlierResults();
        other["findings"].push_back({{"id", "A-1"}, {"severity", "info"}, {"message", "x"}});
        QVERIFY(!same(other, earlierResults()) && !same(earlierResults(), other));
        other = earlierResults();
        other["sensitivity"]["value"] = nullptr;
        QVERIFY(!same(other, earlierResults()) && !same(earlierResults(), other));
        const EarlierJson blocked = blockedBy(earlierResults(), "CAP-007");
        QVERIFY(!same(blocked, blocked));
    }

    void otherUnit_isNamed_andNeedsAnAmendment()
    {
        EarlierJson now = earlierResults();
        now["sensitivity"]["unit"] = "pC/Pa";
        const auto answer = answerOf("out", earlierResults(), now);
        QVERIFY(answer.run->hasDifferences() && answer.run->needsAmendment());
        QCOMPARE(kindsOf({answer}),
            std::string("out unit-changed sensitivity;out unit-changed sensitivity.per_level[0];"));
        const EarlierJson row = jsonOf({answer})[0];
        QCOMPARE(row["unit"], EarlierJson("V/Pa"));
        QCOMPARE(row["unit_now"], EarlierJson("pC/Pa"));
        QVERIFY(row["difference_over_u"].is_null());
        QCOMPARE(row["amendment_needed"], EarlierJson(true));
    }

    /// A pressure step that was typed as exact.
    void exactValueThatDiffers_isOverU()
    {
        EarlierJson issued = earlierResults();
        issued["shock"][0]["u_step_pa"] = 0.0;
        EarlierJson now = issued;
        now["shock"][0]["step_pa"] = 168.001e3;
        const auto answer = answerOf("out", issued, now);
        QCOMPARE(kindsOf({answer}), std::string("out over-u shock[0].step_pa;"));
        QCOMPARE(jsonOf({answer})[0]["u_expanded"], EarlierJson(0.0));
        QVERIFY(jsonOf({answer})[0]["difference_over_u"].is_null());
        QVERIFY(!answerOf("out", issued, issued).run->hasDifferences());
    }

    void difference_withinU_isNone()
    {
        const auto answer = answerOf("out", earlierResults(), withF0(318e3 + 19.0));
        QVERIFY(!answer.run->hasDifferences());
        QVERIFY(recheckRows({answer}).empty());
        QVERIFY(answer.run->quantities.largestWithinU() > 0.9);
    }

    void rows_areWorstFirst_overAllFolders()
    {
        EarlierJson lost = withF0(318e3 - 50.0);
        lost["sensitivity"]["value"] = nullptr;
        EarlierJson issued = earlierResults();
        issued["shock"][0]["step_pa"] = nullptr;
        const std::vector<RecheckAnswer> answers{
            answerOf("a", earlierResults(), withF0(318e3 + 30.0)), answerOf("b", issued, lost),
            answerOf("c", earlierResults(), blockedBy(earlierResults(), "CAP-007")),
            {"d", fail(ErrorKind::Usage, {"Damaged.", {}})}};
        QCOMPARE(kindsOf(answers),
            std::string("d unreadable;c blocked;b withdrawn sensitivity;b over-u f0_hz;"
                        "a over-u f0_hz;b stated-now shock[0].step_pa;c finding-appeared;"));
    }

    void json_hasTheKeysOfTheContract()
    {
        EarlierJson issued = earlierResults();
        issued["software"]["method"]["model"] = 1;
        const EarlierJson list = jsonOf({answerOf("out", issued, withF0(318e3 - 50.0))});
        QCOMPARE(list.size(), std::size_t(2));
        const EarlierJson &row = list[0];
        QCOMPARE(row["kind"], EarlierJson("over-u"));
        QCOMPARE(row["of"], EarlierJson("f0_hz"));
        QCOMPARE(row["issued"], EarlierJson(318e3));
        QCOMPARE(row["now"], EarlierJson(318e3 - 50.0));
        QCOMPARE(row["u_expanded"], EarlierJson(20.0));
        QCOMPARE(row["difference_over_u"], EarlierJson(2.5));
        QCOMPARE(row["method_issued"], (EarlierJson{{"model", 1}}));
        QCOMPARE(row["method_now"], (EarlierJson{{"model", methodVersions()["model"]}}));
        QCOMPARE(row["amendment_needed"], EarlierJson(true));
        QCOMPARE(row["folder"], EarlierJson("out"));
        QVERIFY(row["number"].is_null() && row["message"].is_null() && row["where"].is_null());
        QCOMPARE(row["k"], EarlierJson(2.0));
        QCOMPARE(row["k_assumed"], EarlierJson(false));
        QCOMPARE(row["u_of_noise_alone"], EarlierJson(false));
        QCOMPARE(list[1]["kind"], EarlierJson("methods"));
        QCOMPARE(list[1]["amendment_needed"], EarlierJson(false));
        for (const auto &[key, value] : row.items())
            QVERIFY2(list[1].contains(key), key.c_str());
        QCOMPARE(list[1].size(), row.size());
    }

    void changedMethods_areNamedWithoutADifference()
    {
        EarlierJson issued = earlierResults();
        issued["software"]["method"]["model"] = 1;
        issued["software"]["method"].erase("uncertainty");
        const auto answer = answerOf("out", issued, earlierResults());
        QVERIFY(!answer.run->hasDifferences());
        const MethodVersions now = methodVersions();
        QCOMPARE(methodChangesText(*answer.run),
            "model 1 -> " + std::to_string(now.at("model")) + ", uncertainty "
                + std::to_string(now.at("uncertainty")) + " (new)");
        QCOMPARE(kindsOf({answer}), std::string("out methods;"));
        QVERIFY(jsonOf({answer})[0]["method_issued"]["uncertainty"].is_null());
    }

    void resultsFromBeforeMethodVersions_sayThat()
    {
        EarlierJson issued = earlierResults();
        issued["software"].erase("method");
        const auto answer = answerOf("out", issued, earlierResults());
        const std::string text = methodChangesText(*answer.run);
        QVERIFY(text.starts_with("made before method versions were recorded"));
        for (const auto &[step, version] : methodVersions())
            QCOMPARE(text.find(step + " -> ") != std::string::npos, version > 1);
        QVERIFY(jsonOf({answer})[0]["method_issued"].is_null());
        QVERIFY(jsonOf({answer})[0]["method_now"].is_object());
    }

    void resultsOfALaterVersion_sayThat()
    {
        EarlierJson issued = earlierResults();
        issued["software"]["method"]["model"] = 99;
        QVERIFY(methodChangesText(*answerOf("out", issued, earlierResults()).run)
                    .ends_with("the results were made by a later version of Dyncal"));
    }

    void nowBlocked_isOneRow_notAHundred()
    {
        EarlierJson now{{"error", {{"message", "No step."}, {"finding", "WIN-002"}}}};
        EarlierJson issued = earlierResults();
        issued["findings"].push_back({{"id", "A-1"}, {"severity", "info"}, {"message", "x"}});
        const auto answer = answerOf("out", issued, now);
        QVERIFY(answer.run->hasDifferences() && answer.run->needsAmendment());
        const EarlierJson list = jsonOf({answer});
        QCOMPARE(list.size(), std::size_t(1));
        QCOMPARE(list[0]["kind"], EarlierJson("blocked"));
        QCOMPARE(list[0]["message"], EarlierJson("WIN-002: No step."));
        QCOMPARE(list[0]["amendment_needed"], EarlierJson(true));
    }

    void refusedRecording_isBlocked()
    {
        EarlierJson issued = earlierResults();
        issued["findings"].push_back({{"id", "A-1"}, {"severity", "info"}, {"message", "x"}});
        const auto answer = answerOf("out", issued, nullptr, "CAP-003: No rate.");
        QCOMPARE(kindsOf({answer}), std::string("out blocked;")); // a finding is not gone by that
        QCOMPARE(answer.run->blockedNow, std::string("CAP-003: No rate."));
    }

    void blockedThenAndNow_isNoDifference()
    {
        const EarlierJson blocked = blockedBy(earlierResults(), "CAP-007");
        const auto answer = answerOf("out", blocked, blocked);
        QVERIFY(!answer.run->hasDifferences());
        QVERIFY(recheckRows({answer}).empty());
    }

    void blockedThen_needsNoAmendment()
    {
        EarlierJson issued = blockedBy(earlierResults(), "CAP-007");
        issued["sensitivity"]["value"] = nullptr;
        const auto answer = answerOf("out", issued, withF0(318e3 + 100.0));
        QVERIFY(answer.run->hasDifferences() && !answer.run->needsAmendment());
        QCOMPARE(kindsOf({answer}), std::string("out over-u f0_hz;out finding-gone;"));
        QCOMPARE(jsonOf({answer})[0]["amendment_needed"], EarlierJson(false));
    }

    void withdrawn_needsAnAmendment_statedNowNone()
    {
        EarlierJson now = earlierResults();
        now["response"]["magnitude"][1] = nullptr;
        const auto gone = answerOf("out", earlierResults(), now);
        QVERIFY(gone.run->needsAmendment());
        QCOMPARE(kindsOf({gone}), std::string("out withdrawn response.magnitude[1];"));
        QVERIFY(jsonOf({gone})[0]["now"].is_null());
        QVERIFY(jsonOf({gone})[0]["difference_over_u"].is_null());
        const auto fresh = answerOf("out", now, earlierResults());
        QVERIFY(!fresh.run->hasDifferences());
        QCOMPARE(kindsOf({fresh}), std::string("out stated-now response.magnitude[1];"));
        QVERIFY(jsonOf({fresh})[0]["k"].is_null());
    }

    void unreadable_keepsItsSentence()
    {
        const RecheckAnswer answer{"out", fail(ErrorKind::FileUnreadable, {"No %1.", {"file"}})};
        const EarlierJson list = jsonOf({answer});
        QCOMPARE(list[0]["kind"], EarlierJson("unreadable"));
        QCOMPARE(list[0]["message"], EarlierJson("No file."));
        QVERIFY(list[0]["method_now"].is_null());
        QCOMPARE(list[0]["amendment_needed"], EarlierJson(false));
    }

    void remarks_areKept()
    {
        EarlierRun run = runWith(earlierResults());
        run.remarks = {{"Changed.", {}}};
        QCOMPARE(recheckedRun(run, earlierResults()).remarks.size(), std::size_t(1));
    }
};

DYNCAL_TEST(TestRecheckOutcome)
#include "tst_recheck_outcome.moc"

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/correction/calibrated_response.h"
#include "core/correction/corrected_pressure.h"
#include "core/pipeline/pipeline.h"
#include "core/results/results_json.h"
#include "tests/support/made_results.h"
#include "tests/support/near.h"
#include "tests/support/simulated_example.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using namespace dyncal::testing;
using Json = MadeJson;

namespace {

std::string whyRefused(const Json &root)
{
    const auto read = calibratedResponse(jsonText(root), "out/results.json");
    return read ? std::string() : english(read.error().message);
}

bool says(const Json &root, const char *words)
{
    return whyRefused(root).find(words) != std::string::npos;
}

/// results.json of a whole simulated calibration.
const std::string &exampleResults()
{
    static const std::string text = [] {
        ResultCache cache;
        Recipe recipe;
        const PipelineOutcome outcome
            = runPipeline(simulatedExample(10e6, 0.01), recipe, cache, StageId::Uncertainty, {});
        return resultsJson(outcome, recipe, "2026-01-01T00:00:00Z");
    }();
    return text;
}

} // namespace

class TestCalibratedResponse : public QObject
{
    Q_OBJECT

private slots:
    void response_isThatOfTheFile()
    {
        const MadeResults results;
        const auto read = calibratedResponse(results.text(), "results.json");
        QVERIFY2(read.has_value(), read ? "" : english(read.error().message).c_str());
        const KnownResponse &response = read->response;
        QCOMPARE(response.unit, std::string("V/Pa"));
        QCOMPARE(read->fLow_Hz, 700.0);
        QCOMPARE(read->createdUtc, std::string("2026-01-01T00:00:00Z"));
        QVERIFY(read->cautions.empty());
        QCOMPARE(response.knot_Hz[0], 0.0);
        QCOMPARE(response.atKnots[0], std::complex<double>(results.sensor.S0));
        QVERIFY(isNear(response.validTo_Hz, 500e3)); // half the model's rate
        QVERIFY(isNear(response.u_alone[5], 1e-3));
        const Eigen::VectorXd f = Eigen::VectorXd::LinSpaced(400, 0.0, 450e3);
        QVERIFY((response.at(f) - results.sensor.at(f)).cwiseAbs().maxCoeff()
            < 1e-7 * results.sensor.S0);
    }

    /// The way to the filter: the inverse of the truth, with the gain's u on the gain.
    void filter_ofTheFile_invertsTheSensor()
    {
        const MadeResults results;
        const auto read = calibratedResponse(results.text(), "results.json");
        const auto filter = designCorrection(read->response, 5e6, {200e3});
        QVERIFY2(filter.has_value(), filter ? "" : english(filter.error().message).c_str());
        QVERIFY(isNear(filter->gain(), 1.0 / results.sensor.S0, 3e-4));
        const double u_gain = std::sqrt((filter->tapErrors.colwise().sum()).squaredNorm());
        QVERIFY(std::abs(u_gain / filter->gain() / 5e-3 - 1.0) < 0.01);
    }

    void cautions_areNamedOnce()
    {
        Json root = MadeResults().json();
        for (const char *id : {"UNC-001", "RSP-001", "UNC-001"})
            root["findings"].push_back({{"id", id}, {"severity", "caution"}});
        root["findings"].push_back({{"id", "SHK-005"}, {"severity", "info"}});
        const auto read = calibratedResponse(jsonText(root), "results.json");
        QCOMPARE(read->cautions, (std::vector<std::string>{"RSP-001", "UNC-001"}));
    }

    void otherFiles_areRefused()
    {
        QVERIFY(!calibratedResponse("", "x"));
        QVERIFY(!calibratedResponse("[1, 2", "x"));
        QVERIFY(!calibratedResponse("[]", "x"));
        QVERIFY(says(Json::object(), "is no results.json"));
        Json root = MadeResults().json();
        root["schema"] = "dyncal-model/1";
        QVERIFY(says(root, "dyncal-model/1"));
        root["schema"] = 7;
        QVERIFY(says(root, "is no results.json"));
    }

    void resultsWithoutPressure_areRefused()
    {
        Json root = MadeResults().json();
        root["response"]["unit"] = "1";
        QVERIFY(says(root, "gives no pressure"));
        root = MadeResults().json();
        root["response"] = nullptr;
        QVERIFY(says(root, "gives no pressure"));
        root = MadeResults().json();
        root["sensitivity"] = nullptr;
        QVERIFY(says(root, "gives no pressure"));
        root = MadeResults().json();
        root["input"]["treatment"] = "step-as-impulse";
        QVERIFY(says(root, "step-as-impulse"));
        root = MadeResults().json();
        root["model"] = nullptr;
        QVERIFY(says(root, "no model"));
        root = MadeResults().json();
        root["budget"] = nullptr;
        QVERIFY(says(root, "no budget"));
        root = MadeResults().json();
        for (Json &pole : root["model"]["poles"])
            pole["u_frequency_hz"] = nullptr;
        QVERIFY(says(root, "no uncertainty"));
        root = MadeResults().json();
        root["response"]["magnitude"] = nullptr;
        QVERIFY(says(root, "no frequency with magnitude"));
    }

    /// Any section or value replaced by something else: an answer or a sentence, never a crash.
    void damagedFiles_giveASentence()
    {
        const Json whole = MadeResults().json();
        const std::vector<Json> others{nullptr, 0, -1e300, "x", Json::array(), Json::object(), true,
            Json::array({nullptr}), Json::array({Json::array()})};
        for (const auto &[section, value] : whole.items()) {
            for (const Json &other : others) {
                Json root = whole;
                root[section] = other;
                const auto read = calibratedResponse(jsonText(root), "x");
                QVERIFY(read || !english(read.error().message).empty());
                if (!value.is_object())
                    continue;
                for (auto inner = value.begin(); inner != value.end(); ++inner) {
                    root = whole;
                    root[section][inner.key()] = other;
                    const auto again = calibratedResponse(jsonText(root), "x");
                    QVERIFY(again || !english(again.error().message).empty());
                }
            }
        }
    }

    /// Cut at any place it is refused.
    void cutFiles_areRefused()
    {
        const std::string text = MadeResults().text();
        for (std::size_t size = 0; size + 2 < text.size(); size += 97)
            QVERIFY(!calibratedResponse(text.substr(0, size), "x"));
    }

    /// A calibration by the program: what lies between its rows is the model's curve in the file.
    void calibration_ofTheProgram_isRead()
    {
        const auto read = calibratedResponse(exampleResults(), "results.json");
        QVERIFY2(read.has_value(), read ? "" : english(read.error().message).c_str());
        const Json root = Json::parse(exampleResults());
        const Json &section = root["response"];
        const KnownResponse carried = carriedByShape(read->response).value();
        for (std::size_t i = 0; i < section["frequency_hz"].size(); ++i) {
            const double f = section["frequency_hz"][i];
            if (section["u_magnitude"][i].is_null() || f > carried.knot_Hz.tail(1)[0])
                continue;
            const double model = section["model_magnitude"][i];
            const double u = section["u_magnitude"][i];
            const double found = std::abs(carried.at(Eigen::VectorXd::Constant(1, f))[0]);
            QVERIFY2(std::abs(found - model) < 3.0 * u, qPrintable(QString::number(f)));
        }
    }

    /// The calibration's own shot through the filter is its step of pressure, flat from the front
    /// on, within U.
    void shotOfTheCalibration_isItsStep()
    {
        const auto read = calibratedResponse(exampleResults(), "results.json");
        const auto set = simulatedExample(10e6, 0.01);
        const Channel &channel = *set->shots[2].channelWithRole(ChannelRole::Dut);
        const auto filter = designCorrection(read->response, channel.sampleRate_Hz, {200e3});
        QVERIFY2(filter.has_value(), filter ? "" : english(filter.error().message).c_str());
        const double step_Pa = Json::parse(exampleResults())["shock"][2]["step_pa"];
        const double arrival_s = Json::parse(exampleResults())["shots"][2]["onset_s"];
        WindowedResponse quiet;
        quiet.sampleRate_Hz = channel.sampleRate_Hz;
        quiet.noise = physicalValues(channel, 0, 20000);
        const double level = quiet.noise.mean();
        quiet.noise.array() -= level;
        quiet.noiseSd = std::sqrt(quiet.noise.squaredNorm() / 19999.0);
        const Eigen::VectorXd values
            = physicalValues(channel, 0, channel.samples.size()).array() - level;
        const CorrectedPressure found
            = correctedPressure({values, channel.t0_s}, NoiseDensity(quiet), *filter).value();
        const auto at = [&](double time_s) {
            return static_cast<Index>(std::lround((time_s - found.time_s) * found.rate_Hz));
        };
        for (const double after_s : {20e-6, 50e-6, 200e-6}) {
            const Index i = at(arrival_s + after_s);
            QVERIFY(std::abs(found.pressure_Pa[i] - step_Pa) < 3.0 * found.u_Pa[i]);
            QVERIFY(found.u_Pa[i] < 0.03 * step_Pa);
        }
        const Index before = at(arrival_s - 40e-6);
        QVERIFY(std::abs(found.pressure_Pa[before]) < 4.0 * found.u_Pa[before]);
    }
};

DYNCAL_TEST(TestCalibratedResponse)
#include "tst_calibrated_response.moc"

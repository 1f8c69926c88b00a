// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/project/recipe.h"

namespace dyncal {

/// A recipe in which no member has its default value.
inline Recipe fullRecipe()
{
    Recipe r;
    r.import = {.format = "text",
        .columns = {{"time", 0}, {"dut", 2}},
        .columnsAre = "shots",
        .channels = {{"Acceleration_1", "dut"}},
        .channelDetails = {{"Acceleration_1", {"mV", 2.0, 10.0, 5e-6, -1, "gauge"}}},
        .decimal = ",",
        .separator = "tab",
        .sampleRate_Hz = 1e8,
        .sampleRateReason = "the header is wrong",
        .unit = "V",
        .scale = 0.1,
        .polarity = -1,
        .reference = "absolute",
        .skipRows = 3,
        .interpolateInvalid = 5,
        .maxExpansion = 50.0,
        .channelFiles = "apart",
        .levels = {"low", "high"},
        .exclude = {{2, "diaphragm leaked"}},
        .shots = {{3, {{"Acceleration_1", "other"}}}},
        .files = {{"low.csv",
            {.format = "text",
                .columns = {{"dut", 1}},
                .columnsAre = "channels",
                .channels = {{"x", "driver"}},
                .channelDetails = {{"x", {"bar", 3.0, 4.0, 6e-6, -1, "absolute"}}},
                .decimal = ".",
                .separator = ";",
                .sampleRate_Hz = 1e7,
                .sampleRateReason = "counted",
                .unit = "psi",
                .scale = 2.0,
                .polarity = -1,
                .reference = "gauge",
                .skipRows = 2,
                .interpolateInvalid = 4,
                .maxExpansion = 30.0}}}};
    r.checks = {.saturationRun = 4,
        .flatCodes = 2.0,
        .leastCodes = 32.0,
        .stepSigmas = 8.0,
        .rateMismatch_percent = 0.5,
        .readingFactor = 5.0};
    r.shock = {.enabled = false,
        .p1_Pa = 101100.0,
        .T1_K = 294.15,
        .T4_K = 295.35,
        .drivenGas = {1.4, 0.028, "n2", "variable"},
        .driverGas = {1.667, 0.004, "he", "variable"},
        .relativeHumidity = 0.4,
        .velocity_m_s = 512.8,
        .step_Pa = PerShot({4.3e5, std::nullopt}),
        .arrivalSensors = {{"side", 0.8, 0.0002, 1e-3, 1e-7, 4e-7, 2e-7, {}},
            {"far", 0.9, 0.0, {}, 0.0, {}, 0.0, {1e-3, std::nullopt}}},
        .driverLength_m = 0.97,
        .drivenLength_m = 0.96,
        .innerDiameter_m = 0.1,
        .dutPosition = "side-wall",
        .frontDuration_s = 1e-7,
        .u_frontDuration_s = 2e-8,
        .stateFrom = "p4",
        .p2_Pa = 2.4e5,
        .p4_Pa = 6.8e5,
        .carbonDioxide = 5e-4,
        .counters = {{1.4, 1.1, 2.6e-4, 1e-4, 1e-8}},
        .attenuation = "linear",
        .attenuation_per_m = {-0.001, 0.02},
        .useDutArrival = false,
        .dutDistance_m = 0.3,
        .dutDiameter_m = 5.5e-3,
        .tubeLength_m = 2.0,
        .wallSoundSpeed_m_s = 5900.0,
        .plateauGuard_s = 2e-5,
        .largestMach = 4.0,
        .largestDriverPressure_Pa = 2e7};
    r.window.start_s = {0.001, 0.0021};
    r.window.baseline_s = Interval{-2e-4, -1e-5};
    r.window.end_s = 1.5e-3;
    r.window.settle_s = Interval{8e-4, 1.4e-3};
    r.window.excludeStretches = {{2, 1e-4, 1.2e-4, "a door slammed"}};
    r.remap = false;
    r.spectrum = {.taper = Taper::Hann,
        .method = SpectrumMethod::Welch,
        .segment = 4096,
        .detrend = Detrend::Linear,
        .resonanceBand_Hz = Interval{1e5, 3e6},
        .searchResonance = false,
        .resonances_Hz = {2.33e6}};
    r.pca = {.components = 2, .centre = true, .residualLags = 100, .residualConfidence = 0.95};
    r.input.sampleRate_Hz = 1e6;
    r.input.samples = Index(1000);
    r.input.offset_s = 1e-6;
    r.input.combine = CombineMethod::PcaAverage;
    r.input.treatment = ResponseTreatment::StepAsImpulse;
    r.realization.order = Index(3);
    r.realization.maxOrder = 60;
    r.realization.rows = Index(499);
    r.realization.refine = false;
    r.realization.nuisanceModes = {{{6.8e3, 6.1e3}, 2, false, "mount", "seen on the mount, too"}};
    r.realization.stableFrequency = 0.02;
    r.realization.stableDamping = 0.1;
    r.realization.candidates = {2, 3, 100};
    r.realization.candidateNotes = {{3, "splits the second mode"}};
    r.realization.adoptedReason = "lowest order that fits";
    r.response = {.frequencies_Hz = {1e3, 1e5},
        .grid = "list",
        .reference = "unit-step",
        .known = {{"static", 500.0, 1.02, 0.01, "mV/bar", 12.0, "K 7"}}};
    r.uncertainty = {.budget
        = {{"t1_k", 0.3, "rectangular", 12.0, "C 12", "2027-01-31"}, {"p1_pa", 50.0, "normal", {}}},
        .correlations = {{"t1_k", "p1_pa", -0.5}},
        .cmc = {{"magnitude", 0.02, false, 1e3, 1e5}},
        .monteCarloTrials = 0,
        .seed = 7,
        .coverage = 0.99};
    r.chain.source = "amp.csv";
    r.chain.sha256 = std::string(64, 'b');
    r.chain.quantityId = "gain";
    r.profile = {"Tube 2", "7", std::string(64, 'c'),
        "{\n  \"checks\": {\n    \"min_codes\": 8.0\n  }\n}\n"};
    r.acknowledge = {{"WIN-001", 3, "known"}};
    r.certificate = {.templateName = "short",
        .languages = {"sv", "en"},
        .fields = {{"customer", "Åsa Ström AB"}},
        .decision = DecisionSettings{DecisionRule::Risk, 10.0, 1e3, 1e5, 2.5}};
    return r;
}

} // namespace dyncal

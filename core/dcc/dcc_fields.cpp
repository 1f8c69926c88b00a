// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc/dcc_fields.h"

#include <algorithm>
#include <array>

namespace dyncal {
namespace {

constexpr std::array kFields{
    // Key results, by their labels.
    DccField{"key-results", "basic_measurementResult"},
    DccField{"key-results/Sensitivity at the onset of the step", "dyncal_sensitivity"},
    DccField{"key-results/Sensitivity at the onset of the step, mean of the shots",
        "dyncal_sensitivity"},
    DccField{
        "key-results/Sensitivity at the onset of the step, mean of the shots, which do not agree",
        "dyncal_sensitivity"},
    DccField{"key-results/Sensitivity at the onset of the step, low level",
        "dyncal_sensitivity dyncal_lowLevel"},
    DccField{"key-results/Sensitivity at the onset of the step, medium level",
        "dyncal_sensitivity dyncal_mediumLevel"},
    DccField{"key-results/Sensitivity at the onset of the step, high level",
        "dyncal_sensitivity dyncal_highLevel"},
    DccField{"key-results/Undamped natural frequency", "dyncal_naturalFrequency"},
    DccField{"key-results/Damping ratio", "dyncal_dampingRatio"},
    DccField{"key-results/Quality factor", "dyncal_qualityFactor"},
    DccField{"key-results/Resonance frequency (largest magnitude)", "dyncal_resonanceFrequency"},
    DccField{"key-results/Magnitude at the resonance over the level at the onset",
        "dyncal_resonanceGain"},
    DccField{
        "key-results/Magnitude at the resonance, from the records", "dyncal_resonanceMagnitude"},
    DccField{"key-results/Magnitude within 5 % up to", "dyncal_bandEdge5Percent"},
    DccField{"key-results/Magnitude within 10 % up to", "dyncal_bandEdge10Percent"},
    DccField{"key-results/Magnitude above -3 dB up to", "dyncal_bandEdge3dB"},
    DccField{"key-results/Rise time, 10 % to 90 %", "dyncal_riseTime"},
    DccField{"key-results/Overshoot", "dyncal_overshoot"},
    DccField{"key-results/Settling time, within 5 %", "dyncal_settlingTime"},
    // Conditions.
    DccField{"conditions.ambient_temperature", "basic_temperature"},
    DccField{"conditions.ambient_pressure", "dyncal_ambientPressure"},
    DccField{"conditions.relative_humidity", "basic_humidityRelative"},
    DccField{"shock", "dyncal_pressureSteps"},
    DccField{"shock/Shot", "basic_tableIndex0 dyncal_shot"},
    DccField{"shock/Level", "dyncal_level"},
    DccField{"shock/Initial pressure", "dyncal_initialPressure"},
    DccField{"shock/Initial temperature", "dyncal_initialTemperature"},
    DccField{"shock/Shock velocity", "dyncal_shockVelocity"},
    DccField{"shock/Mach number", "dyncal_machNumber"},
    DccField{"shock/Pressure step", "basic_referenceValue dyncal_pressureStep"},
    DccField{"shock/Step is", "dyncal_sourceOfStep"},
    DccField{"shock/Plateau", "dyncal_plateauTime"},
    // Method.
    DccField{"method.series", "dyncal_shotsCombined"},
    DccField{"method.model_rate", "dyncal_modelRate"},
    DccField{"method.model_samples", "dyncal_modelSamples"},
    DccField{"method.model_offset", "dyncal_modelOffset"},
    DccField{"method.order_reason", "dyncal_orderReason"},
    DccField{"method.order_spread", "dyncal_orderSpread"},
    DccField{"method.profile", "dyncal_profile"},
    DccField{"method.profile_changed", "dyncal_profileChanged"},
    DccField{"method.chain", "dyncal_chain"},
    DccField{"method.cmc", "dyncal_capability"},
    DccField{"method.monte_carlo", "dyncal_monteCarlo"},
    DccField{"method.reference_channel", "dyncal_referenceChannel"},
    DccField{"method.reference_certificate", "dyncal_referenceCertificate"},
    DccField{"method.reference_source", "dyncal_referenceSource"},
    // Results in detail.
    DccField{"results", "dyncal_resultsInDetail"},
    DccField{"results.linearity", "dyncal_linearity"},
    DccField{"results.drift", "dyncal_drift"},
    DccField{"shots", "dyncal_shots"},
    DccField{"shots/Shot", "basic_tableIndex0 dyncal_shot"},
    DccField{"shots/Level", "dyncal_level"},
    DccField{"shots/Sample rate", "dyncal_sampleRate"},
    DccField{"shots/Output step", "dyncal_outputStep"},
    DccField{"shots/Largest deflection", "dyncal_outputStep"},
    DccField{"shots/Signal to noise", "dyncal_signalToNoise"},
    DccField{"shots/Rise time", "dyncal_riseTime"},
    DccField{"shots/Overshoot", "dyncal_overshoot"},
    DccField{"shots/Settling time", "dyncal_settlingTime"},
    DccField{"shots/Sensitivity", "dyncal_sensitivity"},
    DccField{"model", "dyncal_model"},
    DccField{"model.order", "dyncal_modelOrder"},
    DccField{"model.fit", "dyncal_fit"},
    DccField{"model.fit_listing", "dyncal_fitListing"},
    DccField{"poles", "dyncal_poles"},
    DccField{"poles/Class", "dyncal_poleClass"},
    DccField{"poles/z-plane", "dyncal_poleZ"},
    DccField{"poles/Undamped frequency", "dyncal_naturalFrequency"},
    DccField{"poles/Damping ratio", "dyncal_dampingRatio"},
    DccField{"poles/Amplitude", "dyncal_poleAmplitude"},
    DccField{"nuisance-modes", "dyncal_nuisanceModes"},
    DccField{"nuisance-modes/Mode", "dyncal_nuisanceMode"},
    DccField{"nuisance-modes/Shot", "dyncal_shot"},
    DccField{"nuisance-modes/Undamped frequency", "dyncal_naturalFrequency"},
    DccField{"nuisance-modes/Damping ratio", "dyncal_dampingRatio"},
    DccField{"nuisance-modes/Size, of the plateau", "dyncal_nuisanceSize"},
    DccField{"nuisance-modes/Reason", "dyncal_reason"},
    DccField{"nuisance-effect", "dyncal_nuisanceEffect"},
    DccField{"nuisance-effect/Oscillations", "dyncal_nuisanceMode"},
    DccField{"nuisance-effect/Residual, rms of the plateau", "dyncal_residual"},
    DccField{"nuisance-effect/Fit", "dyncal_fit"},
    DccField{"nuisance-effect/Undamped frequency", "dyncal_naturalFrequency"},
    DccField{"nuisance-effect/Damping ratio", "dyncal_dampingRatio"},
    DccField{"nuisance-effect/Plateau gain", "dyncal_plateauGain"},
    DccField{"left-out", "dyncal_leftOut"},
    DccField{"left-out/Shot", "dyncal_shot"},
    DccField{"left-out/From", "dyncal_from"},
    DccField{"left-out/To", "dyncal_to"},
    DccField{"left-out/Reason", "dyncal_reason"},
    // Frequency response.
    DccField{"frequency-response.f_low", "dyncal_lowerLimit"},
    DccField{"frequency-response.f_high", "dyncal_upperLimit"},
    DccField{"frequency-response", "dyncal_frequencyResponse"},
    DccField{"frequency-response/Frequency", "basic_tableIndex0 dyncal_frequency"},
    DccField{"frequency-response/Magnitude", "basic_measuredValue dyncal_magnitude"},
    DccField{"frequency-response/Phase", "basic_measuredValue dyncal_phase"},
    DccField{"frequency-response/Model, magnitude", "dyncal_modelMagnitude"},
    DccField{"frequency-response/Model, phase", "dyncal_modelPhase"},
    DccField{"known-values", "dyncal_knownValues"},
    DccField{"known-values/Calibration", "dyncal_otherCalibration"},
    DccField{"known-values/Frequency", "dyncal_frequency"},
    DccField{"known-values/Its value", "dyncal_otherValue"},
    DccField{"known-values/This calibration", "dyncal_magnitude"},
    DccField{"known-values/En", "dyncal_normalisedError"},
    DccField{"known-values/Verdict", "dyncal_verdict"},
    // Earlier calibrations: a table for each quantity, with the same columns.
    DccField{"history", "dyncal_history"},
    DccField{"history/f0_hz", "dyncal_historyOf dyncal_naturalFrequency"},
    DccField{"history/damping_ratio", "dyncal_historyOf dyncal_dampingRatio"},
    DccField{"history/sensitivity", "dyncal_historyOf dyncal_sensitivity"},
    DccField{"history/magnitude", "dyncal_historyOf dyncal_magnitude"},
    DccField{"history/phase_rad", "dyncal_historyOf dyncal_phase"},
    DccField{"history/Date", "dyncal_dayOfCalibration"},
    DccField{"history/Certificate", "dyncal_earlierCertificate"},
    DccField{"history/Value", "dyncal_earlierValue"},
    DccField{"history/En", "dyncal_normalisedError"},
    DccField{"history/Control chart", "dyncal_controlState"},
    DccField{"signature", "dyncal_signature"},
    DccField{"signature.signed_by", "dyncal_signedBy"},
    DccField{"signature.signed_at", "dyncal_signedAt"},
    DccField{"signature.signed_number", "dyncal_signedNumber"},
    // Statements.
    DccField{"conformity.claim", "dyncal_conformityClaim"},
    DccField{"conformity.rule", "dyncal_conformityRule"},
    DccField{"conformity.verdict", "dyncal_conformityResult"},
    DccField{"conformity.worst", "dyncal_conformityWorst"},
    DccField{"conformity/limit", "dyncal_conformityLimit"},
    DccField{"conformity/frequency", "dyncal_conformityWorst dyncal_frequency"},
    DccField{"conformity/deviation", "dyncal_conformityDeviation"},
    DccField{"conformity/risk", "dyncal_conformityRisk"},
    DccField{"issue.state", "dyncal_state"},
    DccField{"issue.trail_head", "dyncal_trailHead dyncal_sha256"},
    DccField{"issue.results_sha256", "dyncal_resultsHash dyncal_sha256"},
    // Remarks and records.
    DccField{"remarks", "dyncal_remarks"},
    DccField{"findings", "dyncal_findings"},
    DccField{"findings/Finding", "dyncal_finding"},
    DccField{"findings/Shot", "dyncal_shot"},
    DccField{"findings/Severity", "dyncal_severity"},
    DccField{"findings/What was found", "dyncal_whatWasFound"},
    DccField{"findings/Accepted because", "dyncal_reason"},
    DccField{"checks", "dyncal_checks"},
    DccField{"checks/Quantity", "dyncal_comparedQuantity"},
    DccField{"checks/One way", "dyncal_oneWay"},
    DccField{"checks/Other way", "dyncal_otherWay"},
    DccField{"checks/Made", "dyncal_comparisonsMade"},
    DccField{"checks/Largest difference, u", "dyncal_largestDifference"},
    DccField{"checks/Fault seen in 90 %", "dyncal_detectableFault"},
    DccField{"checks/Verdict", "dyncal_verdict"},
    DccField{"records", "dyncal_records"},
    DccField{"records.software", "dyncal_software"},
    DccField{"records.created", "dyncal_computed"},
    DccField{"inputs", "dyncal_recordings"},
    DccField{"inputs/File", "dyncal_recordingFile"},
    DccField{"inputs/Format", "dyncal_recordingFormat"},
    DccField{"inputs/SHA-256 of the file", "dyncal_sha256"},
};

} // namespace

std::span<const DccField> dccFields()
{
    return kFields;
}

std::string refTypeOf(std::string_view place)
{
    const auto found = std::ranges::find_if(
        kFields, [&](const DccField &field) { return place == field.place; });
    return found == kFields.end() ? std::string() : found->refType;
}

} // namespace dyncal

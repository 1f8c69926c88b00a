// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate_templates.h"

namespace dyncal {

using enum CalibrationKind;

Message certificateTitle(CalibrationKind kind)
{
    switch (kind) {
    case ComputedStep:
    case TypedStep:
    case Transducer:
        return {DYNCAL_TEXT("core", "Certificate of dynamic calibration"), {}};
    case UnknownStep:
        return {DYNCAL_TEXT("core", "Certificate of the normalised dynamic response"), {}};
    case FreeDecay:
        break;
    }
    return {DYNCAL_TEXT("core", "Certificate of natural frequency and damping"), {}};
}

Message measurandSentence(CalibrationKind kind, const std::string &dutPosition)
{
    switch (kind) {
    case ComputedStep:
        return dutPosition == "side-wall"
            ? Message{DYNCAL_TEXT("core",
                          "The sensitivity S(f) is the complex ratio of the item's output to the change of pressure at the sensor's face in the side wall of a shock tube; phase of output over input, lag negative, relative to the sensor's own onset."),
                {}}
            : Message{
                DYNCAL_TEXT("core",
                    "The sensitivity S(f) is the complex ratio of the item's output to the change of pressure at the sensor's face in the end-wall plane of a shock tube; phase of output over input, lag negative, relative to the sensor's own onset."),
                {}};
    case TypedStep:
        return {
            DYNCAL_TEXT("core",
                "The sensitivity S(f) is the complex ratio of the item's output to the change of pressure at the sensor's face; phase of output over input, lag negative, relative to the sensor's own onset."),
            {}};
    case Transducer:
        return {
            DYNCAL_TEXT("core",
                "The sensitivity S(f) is the complex ratio of the item's output to the change of pressure at the sensor's face, found by comparison with a reference transducer that the same change reached; phase of output over pressure, lag negative."),
            {}};
    case UnknownStep:
        return {
            DYNCAL_TEXT("core",
                "The normalised response N(f) is the complex ratio of the item's output to a step, relative to the level at the onset of that step; phase of output over input, lag negative, relative to the sensor's own onset."),
            {}};
    case FreeDecay:
        break;
    }
    return {
        DYNCAL_TEXT("core",
            "The item decayed freely after an excitation that was not measured. Its undamped natural frequencies and damping ratios are determined; the ratio of its output to what excited it is not."),
        {}};
}

std::vector<Message> stepSentences(CalibrationKind kind)
{
    switch (kind) {
    case ComputedStep:
        return {
            {DYNCAL_TEXT("core",
                 "The pressure step of each shot follows from the shock wave and the initial state of the gas, unless the section \"Conditions\" says that it was stated."),
                {}}};
    case TypedStep:
        return {
            {DYNCAL_TEXT("core",
                 "The pressure step of each shot was stated by the operator. It was not computed, and its uncertainty is not known."),
                {}}};
    case Transducer:
        return {
            {DYNCAL_TEXT("core",
                 "The pressure step of each shot is what the reference transducer saw: the settled level of its output over its sensitivity at the lowest frequency of its calibration."),
                {}}};
    case UnknownStep:
        return {
            {DYNCAL_TEXT("core",
                 "The size of the step is not known: no sensitivity is stated, and all magnitudes are relative."),
                {}}};
    case FreeDecay:
        break;
    }
    return {};
}

Message uncertaintyNote(CalibrationKind kind)
{
    switch (kind) {
    case ComputedStep:
    case TypedStep:
        return {
            DYNCAL_TEXT("core",
                "Uncertainties marked U (k = 2) are expanded uncertainties with the coverage factor k = 2, or with the larger one printed beside them, for a coverage probability of about 95 % (GUM, JCGM 100). Those of the sensitivity contain the pressure step, the shots, the noise, gain, linearity and mounting; those of the frequency response also the end of the records, the sampling, the front and a drift; those of frequencies and times the noise and the sample clock, and where they or an overshoot depend on the height of the ringing the front and the mounting. What was not stated counts with the usual range: gain 0.5 %, linearity and mounting 0.1 %, clock 50 ppm, a front of up to 100 ns. The budget of every value is in results.json. A value without an uncertainty beside it has none that is complete: it is no result, and has three significant digits; settings and readings are quoted with four at most, temperatures with five. Rise time, overshoot, settling time and band edges are those of the model, as far as records and model reach."),
            {}};
    case Transducer:
        return {
            DYNCAL_TEXT("core",
                "Uncertainties marked U (k = 2) are expanded uncertainties with the coverage factor k = 2, or with the larger one printed beside them, for a coverage probability of about 95 % (GUM, JCGM 100). Those of the sensitivity contain the reference transducer's certificate, its chain and its level, the shots, the noise, gain, linearity and mounting; those of the frequency response also the noise of the reference, the end of the records, the sampling, a drift and, in the phase, the delay between the two; those of frequencies and times the noise and the sample clock, and where they or an overshoot depend on the height of the ringing the front and the mounting. What was not stated counts with the usual range: gain of either chain 0.5 %, linearity and mounting 0.1 %, clock 50 ppm, a delay of up to 0.5 \xC2\xB5s. The budget of every value is in results.json. A value without an uncertainty beside it has none that is complete: it is no result, and has three significant digits; settings and readings are quoted with four at most, temperatures with five. Rise time, overshoot, settling time and band edges are those of the model, as far as records and model reach."),
            {}};
    case UnknownStep:
        return {
            DYNCAL_TEXT("core",
                "Uncertainties marked U (k = 2) are expanded uncertainties with the coverage factor k = 2, or with the larger one printed beside them, for a coverage probability of about 95 % (GUM, JCGM 100). Those of the frequency response contain the noise of the recordings and of the level, the end of the records, the sampling, the front and a drift; those of frequencies and times the noise and the sample clock, and where they or an overshoot depend on the height of the ringing the front and the mounting. What was not stated counts with the usual range: mounting 0.1 %, clock 50 ppm, a front of up to 100 ns. The budget of every value is in results.json. A value without an uncertainty beside it has none that is complete: it is no result, and has three significant digits; settings and readings are quoted with four at most, temperatures with five. Rise time, overshoot, settling time and band edges are those of the model, as far as records and model reach."),
            {}};
    case FreeDecay:
        break;
    }
    return {
        DYNCAL_TEXT("core",
            "Uncertainties marked U (k = 2) are expanded uncertainties with the coverage factor k = 2, or with the larger one printed beside them, for a coverage probability of about 95 % (GUM, JCGM 100). They contain the noise of the recordings and, of frequencies, the sample clock, which counts with 50 ppm unless it was stated. A value without an uncertainty beside it has none that is complete: it is no result, and has three significant digits; settings and readings are quoted with four at most, temperatures with five."),
        {}};
}

Message shotsNote(CalibrationKind kind)
{
    return kind == FreeDecay
        ? Message{DYNCAL_TEXT("core",
                      "Signal to noise is the largest deflection over the standard deviation of the noise before it. No uncertainty is known of the deflection: it has three significant digits."),
            {}}
        : Message{
            DYNCAL_TEXT("core",
                "Signal to noise is the output step over the standard deviation of the noise before it. Rise time 10 % to 90 %; settling to within 5 % of the step; a dash where the record does not show it. These are read from single records, whose noise raises overshoot and settling time; those of the sensor are the key results. Values without an uncertainty have none that is known: they have three significant digits."),
            {}};
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/synthesis/shot_truth.h"

#include "core/synthesis/defects.h"

#include <array>

namespace dyncal {
namespace {

void addSensorTruth(ShotTruth &truth, const SensorSpec &dut)
{
    if (dut.realPole_Hz)
        truth["real_pole_Hz"] = *dut.realPole_Hz;
    if (dut.acCoupling_s)
        truth["ac_tau_s"] = *dut.acCoupling_s;
    if (dut.heat) {
        truth["heat_share"] = dut.heat->share;
        truth["heat_tau_s"] = dut.heat->tau_s;
    }
}

/// What is wrong with the record itself.
void addRecordTruth(ShotTruth &truth, const SimulationSettings &settings, const ShotPlan &plan)
{
    if (plan.axis.statedRate_Hz)
        truth["true_sample_rate_Hz"] = plan.axis.sampleRate_Hz;
    if (plan.noise.colour == NoiseColour::Autoregressive)
        truth["noise_phi"] = plan.noise.phi;
    if (plan.noise.colour == NoiseColour::Flicker)
        truth["noise_exponent"] = -1.0;
    const auto scale = defectOf(settings, DefectKind::Scale, plan.number);
    if (scale)
        truth["scale_factor"] = *scale->size;
    if (plan.bow_codes != 0.0)
        truth["bow_codes"] = plan.bow_codes;
}

/// What was noted less what should have been.
void addNotes(ShotTruth &truth, const SimulationSettings &settings, const ShotPlan &plan)
{
    constexpr std::array<std::pair<DefectKind, const char *>, 3> kErrors{
        {{DefectKind::Distance, "noted_distance_error_m"},
            {DefectKind::Temperature, "noted_T1_error_K"},
            {DefectKind::Pressure, "noted_p1_relative_error"}}};
    for (const auto &[kind, key] : kErrors) {
        if (const auto defect = defectOf(settings, kind, plan.number))
            truth[key] = *defect->size;
    }
    const ShotLevel level = settings.shots[static_cast<std::size_t>(plan.number - 1)];
    if (level != plan.level)
        truth["true_level"] = static_cast<double>(level); // 1 low, 2 medium, 3 high
    if (const auto nitrogen = defectOf(settings, DefectKind::OtherGas, plan.number))
        truth["nitrogen_share"] = *nitrogen->size;
    if (const auto humidity = defectOf(settings, DefectKind::Humidity, plan.number))
        truth["relative_humidity"] = *humidity->size;
}

void addWaveTruth(ShotTruth &truth, const SimulationSettings &settings, const ShotPlan &plan)
{
    const Gas noted = RecordedConditions::gas;
    if (plan.scene.gas.gamma != noted.gamma
        || plan.scene.gas.molarMass_kg_mol != noted.molarMass_kg_mol) {
        truth["gamma"] = plan.scene.gas.gamma;
        truth["molar_mass_kg_mol"] = plan.scene.gas.molarMass_kg_mol;
    }
    if (plan.scene.attenuation_per_m != 0.0) {
        truth["attenuation_per_m"] = plan.scene.attenuation_per_m;
        truth["side_p2_Pa"] = plan.scene.pressureBehindShockAtSide_Pa;
    }
    if (plan.sideDelay_s > 0.0)
        truth["side_delay_s"] = plan.sideDelay_s;
    if (plan.front)
        truth["front_s"] = plan.front->duration_s;
    if (plan.front && plan.front->kind == Front::Kind::Tilt)
        truth["tilt_deg"] = defectSize(settings, DefectKind::Tilt, plan.number, 0.0);
    if (plan.echo) {
        truth["echo_share"] = plan.echo->share;
        truth["echo_delay_s"] = plan.echo->delay_s;
    }
    if (plan.tubeMode) {
        truth["tube_mode_Hz"] = plan.tubeMode->oscillation.frequency_Hz;
        truth["tube_mode_zeta"] = plan.tubeMode->oscillation.zeta;
        truth["tube_mode_phase_rad"] = plan.tubeMode->oscillation.phase_rad;
        truth["tube_mode_amplitude"] = plan.tubeMode->amplitude;
    }
}

} // namespace

ShotTruth truthOf(
    const SimulationSettings &settings, const ShotPlan &plan, const Digitizer &digitizer)
{
    ShotTruth truth{{"f0_Hz", plan.dut.modes.front().f0_Hz}, {"zeta", plan.dut.modes.front().zeta},
        {"sensitivity", plan.dut.sensitivity_V_Pa}, {"noise_sd_V", plan.noise_V},
        {"input_range_V", digitizer.range_V}, {"p1_Pa", plan.scene.states.driven.pressure_Pa},
        {"T1_K", plan.scene.states.driven.temperature_K}, {"p4_Pa", plan.scene.driverPressure_Pa},
        {"distance_m", plan.scene.distance_m}, {"step_Pa", 0.0}};
    addRecordTruth(truth, settings, plan);
    addSensorTruth(truth, plan.dut);
    addNotes(truth, settings, plan);
    if (!plan.burst)
        return truth;
    const ShotTruth shock{{"arrival_s", plan.scene.wallArrival_s},
        {"side_arrival_s", plan.scene.sideArrival_s}, {"plateau_s", plan.scene.plateau_s},
        {"velocity_m_s", plan.scene.states.velocity_m_s}, {"mach", plan.scene.states.mach},
        {"p2_Pa", plan.scene.states.shocked.pressure_Pa},
        {"p5_Pa", plan.scene.states.reflected.pressure_Pa},
        {"a5_m_s", plan.scene.states.reflected.soundSpeed_m_s}};
    truth.insert(shock.begin(), shock.end());
    addWaveTruth(truth, settings, plan);
    truth["step_Pa"] = plan.scene.step_Pa();
    return truth;
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/json_text.h"
#include "tests/support/known_sensor.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

/// A results.json of a sensor of second order, written down from closed forms.
namespace dyncal::testing {

using MadeJson = nlohmann::json;

struct MadeResults
{
    TrueSensor sensor;
    double dt_s = 1e-6;
    double fLow_Hz = 700.0;
    double u_noise = 1e-3; ///< relative and in rad, of every row
    double u_gain = 5e-3;
    double u_onset_s = 1e-8;

    std::vector<double> frequencies_Hz() const
    {
        std::vector<double> list;
        for (Index k = 0; k < 26; ++k)
            list.push_back(std::pow(10.0, 3.0 + 0.1 * static_cast<double>(k)));
        return list;
    }

    MadeJson line(const std::string &of, const char *quantity, double contribution,
        const MadeJson &dof = nullptr, const MadeJson &shot = nullptr) const
    {
        return {{"of", of}, {"quantity", quantity}, {"contribution", contribution}, {"dof", dof},
            {"shot", shot}, {"u", std::abs(contribution)}};
    }

    /// Rows with magnitude, phase and both u, and the lines that make them.
    void addRows(MadeJson &root) const
    {
        MadeJson &rows = root["response"];
        MadeJson &budget = root["budget"];
        for (const char *list : {"magnitude", "phase_rad", "u_magnitude", "u_phase_rad"})
            rows[list] = MadeJson::array();
        for (const double f_Hz : frequencies_Hz()) {
            const std::complex<double> S = sensor.at(f_Hz);
            const std::string place = "[" + std::to_string(rows["magnitude"].size()) + "]";
            const double late = -u_onset_s * 2.0 * std::numbers::pi * f_Hz;
            rows["frequency_hz"].push_back(f_Hz);
            rows["magnitude"].push_back(std::abs(S));
            rows["phase_rad"].push_back(std::arg(S));
            rows["u_magnitude"].push_back(std::abs(S) * std::hypot(u_noise, u_gain));
            rows["u_phase_rad"].push_back(std::hypot(u_noise, late));
            budget.push_back(
                line("response.magnitude" + place, "noise", std::abs(S) * u_noise, 30));
            budget.push_back(
                line("response.magnitude" + place, "gain_relative", std::abs(S) * u_gain));
            budget.push_back(line("response.phase_rad" + place, "noise", u_noise, 30));
            budget.push_back(line("response.phase_rad" + place, "onset_s", late));
        }
    }

    MadeJson pole(std::complex<double> z) const
    {
        return {{"re", z.real()}, {"im", z.imag()}, {"frequency_hz", sensor.f0_Hz},
            {"u_frequency_hz", 1e-4 * sensor.f0_Hz}, {"damping_ratio", sensor.zeta},
            {"u_damping_ratio", 1e-4}};
    }

    /// In modal form: C A^k B = 2 Re r z^k, r = c (z - 1).
    MadeJson model() const
    {
        const PoleShape shape = sensor.shape();
        const std::complex<double> z = std::exp(shape.s_rad_s[0] * dt_s);
        const std::complex<double> r = shape.c[0] * (z - 1.0);
        MadeJson made;
        made["A"] = MadeJson::array(
            {MadeJson::array({z.real(), z.imag()}), MadeJson::array({-z.imag(), z.real()})});
        made["B"] = MadeJson::array({MadeJson::array({2.0}), MadeJson::array({0.0})});
        made["C"] = MadeJson::array({MadeJson::array({r.real(), r.imag()})});
        made["D"] = MadeJson::array({MadeJson::array({0.0})});
        made["dt_s"] = dt_s;
        made["poles"] = MadeJson::array({pole(z), pole(std::conj(z))});
        return made;
    }

    MadeJson json() const
    {
        MadeJson root;
        root["schema"] = "dyncal-results/1";
        root["created_utc"] = "2026-01-01T00:00:00Z";
        root["input"]["treatment"] = "step-deflated";
        root["sensitivity"] = {{"value", sensor.S0}, {"u", sensor.S0 * u_gain}};
        root["response"]["unit"] = "V/Pa";
        root["response"]["f_low_hz"] = fLow_Hz;
        root["model"] = model();
        root["budget"] = MadeJson::array({line("sensitivity", "gain_relative", sensor.S0 * u_gain),
            line("sensitivity", "level_relative", 1e-4 * sensor.S0, nullptr, 1)});
        root["findings"] = MadeJson::array();
        addRows(root);
        return root;
    }

    std::string text() const { return jsonText(json()); }
};

} // namespace dyncal::testing

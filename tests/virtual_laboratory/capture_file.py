# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a calibration: capture.h5, recipe.json as a technician would, truth.json beside them."""
import json
from pathlib import Path

import h5py
import numpy as np

from .laboratory import SIDE_SENSITIVITY, TRUTH_FREQUENCIES, driven, dut_system, reference_system

TEXT = h5py.string_dtype("utf-8")


def attributes(group, **values):
    for name, value in values.items():
        if value is None:
            continue
        if isinstance(value, str):
            group.attrs.create(name, value, dtype=TEXT)
        else:
            group.attrs[name] = value


def write_setup(file, lab):
    noted = lab.noted
    gas = {"driven_gas": noted.gas, "driver_gas": noted.gas, "gamma1": noted.gamma, "gamma4": noted.gamma,
           "M1": noted.molar_mass, "M4": noted.molar_mass}
    attributes(file.create_group("setup/tube"), driver_length_m=lab.driver_length,
               driven_length_m=lab.driven_length, inner_diameter_m=0.1, diaphragm="polyester", **gas)
    attributes(file.create_group("setup/sensors/dut"), role="dut", quantity="pressure", unit="V",
               sensitivity=noted.card, u_sensitivity=noted.u_card, sensitivity_unit="V/Pa",
               serial="virtual")
    for i, side in enumerate(lab.sides):
        card = {"sensitivity": SIDE_SENSITIVITY, "u_sensitivity": SIDE_SENSITIVITY * noted.u_gain,
                "sensitivity_unit": "V/Pa"} if side.calibrated else {}
        attributes(file.create_group(f"setup/sensors/side{i + 1}"), role="driven_side",
                   quantity="pressure", unit="V", serial=f"virtual side {i + 1}", **card)
    if lab.reference:
        attributes(file.create_group("setup/sensors/reference"), role="reference", quantity="pressure",
                   unit="V", serial="virtual reference")
    attributes(file.create_group("setup/instruments/recorder"), vendor="virtual", adc_bits=lab.recorder.bits)


def write_channel(group, lab, channel, t0_s):
    noted, limit = lab.noted, 2 ** (channel.adc_bits - 1)
    data = group.create_dataset(channel.name, data=channel.counts)
    is_dut = channel.role == "dut"
    sensor = channel.role if channel.role != "driven_side" else "side" + channel.name.split()[1]
    attributes(data, sample_rate_Hz=lab.recorder.rate_hz * noted.rate_factor, t0_s=t0_s / noted.rate_factor,
               scale=channel.scale * (noted.scale_factor if is_dut else 1.0), offset=0.0,
               unit=channel.unit, quantity="voltage" if channel.unit == "V" else "pressure", role=channel.role,
               sensor=f"/setup/sensors/{sensor}", instrument="/setup/instruments/recorder",
               pressure_reference="" if channel.unit == "V" else "gauge", adc_bits=channel.adc_bits,
               adc_min=float(-limit), adc_max=float(limit - 1))


def write_shot(file, lab, number, record):
    noted = lab.noted
    group = file.create_group(f"shots/{number:03d}", track_order=True)
    level = (noted.levels or [plan.level for plan in lab.shots])[number - 1]
    attributes(group, label=f"Shot {number}", level=level, valid=np.int8(1))
    missing = float("nan")
    attributes(group.create_group("environment"), p1_Pa=noted.p1, u_p1_Pa=noted.u_p1, T1_K=noted.t1,
               u_T1_K=noted.u_t1, T4_K=noted.t1, p4_Pa=record.p4_pa if noted.p4 else missing,
               relative_humidity=missing if noted.humidity is None else noted.humidity)
    channels = group.create_group("channels", track_order=True)
    for channel in record.channels:
        write_channel(channels, lab, channel, record.t0_s)


def write_capture(path, lab, records):
    with h5py.File(path, "w") as file:
        attributes(file, format="dyncal-capture", creator="virtual laboratory", title="Virtual laboratory",
                   created_utc="2026-01-01T00:00:00Z", format_version=np.array([1, 0], np.int32))
        write_setup(file, lab)
        for number, record in enumerate(records, 1):
            write_shot(file, lab, number, record)


def recipe(lab):
    noted = lab.noted
    shock = {"arrival_sensors": [
        {"channel": f"Side {i + 1}", "distance_to_end_wall_m": d, "u_distance_m": noted.u_distance}
        for i, d in enumerate(noted.distances)]}
    shock.update(noted.shock)
    # Few trials: nothing that a study judges comes from them, and 10 000 take three times as long as all else.
    uncertainty = {"monte_carlo_trials": 100, **noted.recipe.get("uncertainty", {})}
    return {"schema": "dyncal-recipe/1", "shock": shock, **noted.recipe, "uncertainty": uncertainty}


def truth(lab, records, name, seed):
    f0, zeta, _ = lab.dut.modes[0]
    s = lab.dut.sensitivity * dut_system(lab.dut, disturbed=False).response(TRUTH_FREQUENCIES)
    gas = driven(lab)
    return {"condition": name, "seed": seed, "causes": lab.causes, "size": lab.size,
            "operator": lab.operator, "judge_shot": lab.judge_shot,
            "sensitivity": lab.dut.sensitivity, "f0_hz": f0, "zeta": zeta, "modes": lab.dut.modes,
            "lag_hz": lab.dut.lag_hz, "heat": lab.dut.heat, "ac_s": lab.dut.ac_s, "echo": lab.dut.echo,
            "front": lab.dut.front, "mount": lab.dut.mount, "attenuation_per_m": lab.attenuation,
            "attenuation_law": lab.attenuation_law, "p1_pa": lab.p1, "t1_k": lab.t1,
            "sound_speed_m_s": gas.sound_speed, "gamma": gas.gamma, "clock": lab.recorder.clock,
            "distances_m": [side.distance_m for side in lab.sides],
            "response": {"frequency_hz": TRUTH_FREQUENCIES.tolist(), "re": s.real.tolist(),
                         "im": s.imag.tolist()},
            "shots": [record.truth for record in records]}


def certificate(reference):
    """The reference's table as its laboratory gave it."""
    f = np.array(reference.frequencies_hz)
    s = reference.sensitivity * reference_system(reference).response(f)
    u = reference.u_certified
    lines = [f"{a!r},{b!r},{u * b!r},{c!r},{u!r}" for a, b, c in zip(
        f.tolist(), (abs(s) * reference.certified).tolist(),
        (np.angle(s) + reference.certified_phase_rad).tolist())]
    return "\n".join(["frequency_hz,magnitude,u_magnitude,phase_rad,u_phase_rad", *lines]) + "\n"


def write(folder, lab, records, name, seed):
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    if lab.reference:
        (folder / "reference.csv").write_text(certificate(lab.reference), encoding="utf-8")
    write_capture(folder / "capture.h5", lab, records)
    for file, content in (("recipe.json", recipe(lab)), ("truth.json", truth(lab, records, name, seed))):
        (folder / file).write_text(json.dumps(content, indent=1) + "\n", encoding="utf-8")

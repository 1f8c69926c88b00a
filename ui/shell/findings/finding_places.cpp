// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/findings/finding_places.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace dyncal {

namespace {

using enum Page;

constexpr std::pair<std::string_view, FindingPlace> kPlaces[]{
    {"CAP-001", {Captures, "addCaptures"}},
    {"CAP-002", {Captures, "roleOf_*"}},
    {"CAP-003", {Captures, "sampleRate"}},
    {"CAP-004", {Captures, "shotTable"}},
    {"CAP-006", {Captures, "shotTable"}},
    {"CAP-007", {Captures, "shotTable"}},
    {"CAP-008", {Captures, "roleOf_*"}},
    {"CAP-009", {Window, "start"}},
    {"CAP-010", {Captures, "roleOf_*"}},
    {"CAP-011", {Captures, "shotTable"}},
    {"CAP-012", {Captures, "dutInverted"}},
    {"CAP-013", {Captures, "dutUnit"}},
    {"CAP-014", {Captures, "shotTable"}},
    {"CAP-015", {Captures, "shotTable"}},
    {"CAP-016", {Captures, "sampleRate"}},
    {"CAP-018", {Captures, "importSettings"}},
    {"CAP-019", {Captures, "importSettings"}},
    {"CAP-020", {Window, "baseline"}},
    {"CAP-022", {Captures, "importSettings"}},
    {"CAP-023", {Captures, "dutUnit"}},
    {"CAP-024", {Captures, "addCaptures"}},
    {"CAP-025", {Captures, "sampleRate"}},
    {"CAP-026", {Captures, "importSettings"}},
    {"CAP-027", {Captures, "dutScale"}},
    {"CAP-030", {Captures, "dutUnit"}},
    {"CAP-031", {Captures, "shotTable"}},
    {"CAP-032", {Captures, "dutScale"}},
    {"CAP-033", {Captures, "dutUnit"}},
    {"CAP-034", {Captures, "shotTable"}},
    {"SHK-001", {Shock, "arrivalDistance"}},
    {"SHK-002", {Checks, "checkTable"}},
    {"SHK-003", {Shock, "stepBudgetTable"}},
    {"SHK-004", {Shock, "T1"}},
    {"SHK-006", {Shock, "T4"}},
    {"SHK-007", {Shock, "p1"}},
    {"SHK-008", {Shock, "addArrivalSensor"}},
    {"SHK-009", {Shock, "drivenGas"}},
    {"SHK-015", {Shock, "drivenGas"}},
    {"SHK-010", {Shock, "arrivalTable"}},
    {"SHK-011", {Shock, "p1"}},
    {"SHK-012", {Shock, "stepUncertaintyTable"}},
    {"SHK-013", {Shock, "stepBudgetTable"}},
    {"SHK-018", {Shock, "shockVelocity"}},
    {"SHK-020", {Shock, "p1"}},
    {"SHK-019", {Shock, "arrivalDistance"}},
    {"CHK-001", {Checks, "checkTable"}},
    {"CHK-002", {Checks, "checkTable"}},
    {"CHK-003", {Checks, "checkTable"}},
    {"CHK-004", {Captures, "shotTable"}},
    {"CHK-005", {Checks, "checkTable"}},
    {"CHK-006", {Captures, "dutUnit"}},
    {"CMP-001", {Comparison, "comparisonVerdict"}},
    {"CMP-002", {Comparison, "comparisonVerdict"}},
    {"CMP-003", {Comparison, "comparisonVerdict"}},
    {"CMP-004", {Comparison, "comparisonVerdict"}},
    {"CMP-005", {Comparison, "comparisonVerdict"}},
    {"CMP-006", {Comparison, "comparisonVerdict"}},
    {"WIN-001", {Window, "windowEnd"}},
    {"WIN-002", {Window, "baseline"}},
    {"WIN-003", {Window, "settle"}},
    {"WIN-004", {Window, "baseline"}},
    {"WIN-005", {Window, "windowEnd"}},
    {"WIN-006", {Window, "windowPlot"}},
    {"WIN-008", {Window, "stretches"}},
    {"WIN-009", {ModelInput, "combine"}},
    {"WIN-010", {Window, "windowPlot"}},
    {"WIN-011", {Window, "start"}},
    {"SPC-002", {Spectrum, "resonanceTable"}},
    {"PCA-001", {Components, "residualTable"}},
    {"PCA-003", {Components, "residualSpectrumPlot"}},
    {"PCA-004", {Components, "residualTable"}},
    {"MIN-001", {ModelInput, "modelRate"}},
    {"MIN-002", {ModelInput, "modelRate"}},
    {"MIN-005", {ModelInput, "modelSamples"}},
    {"MIN-006", {ModelInput, "modelOffset"}},
    {"MIN-007", {Window, "windowEnd"}},
    {"NUI-001", {Spectrum, "nuisanceModes"}},
    {"NUI-002", {Spectrum, "nuisanceModes"}},
    {"NUI-004", {ModelInput, "combine"}},
    {"NUI-005", {Spectrum, "nuisanceModes"}},
    {"ORD-001", {Order, "order"}},
    {"ORD-003", {Order, "order"}},
    {"MOD-001", {Order, "order"}},
    {"MOD-002", {Page::Model, "polePlot"}},
    {"MOD-004", {Order, "order"}},
    {"MOD-006", {Order, "order"}},
    {"MOD-007", {Page::Model, "modelErrorPlot"}},
    {"MOD-008", {Order, "order"}},
    {"MOD-009", {ModelInput, "modelRate"}},
    {"MOD-010", {Page::Model, "polePlot"}},
    {"MOD-012", {Spectrum, "nuisanceModes"}},
    {"MOD-013", {ModelInput, "treatment"}},
    {"MOD-014", {Page::Model, "poleTable"}},
    {"MOD-015", {Page::Model, "poleTable"}},
    {"MOD-016", {Page::Model, "poleTable"}},
    {"MOD-017", {Shock, "frontDuration"}},
    {"MOD-018", {Page::Model, "poleTable"}},
    {"MOD-019", {Shock, "frontDuration"}},
    {"MOD-020", {Window, "stretches"}},
    {"RSP-001", {Page::Model, "magnitudePlot"}},
    {"RSP-002", {Page::Shock, "sensitivityTable"}},
    {"RSP-005", {Comparison, "comparisonTable"}},
    {"RSP-006", {Page::Model, "magnitudePlot"}},
    {"RSP-007", {Page::Model, "magnitudePlot"}},
    {"RSP-008", {Page::Model, "magnitudePlot"}},
    {"UNC-001", {Page::Uncertainty, "uncertaintyResult"}},
    {"UNC-002", {Page::Uncertainty, "budgetTable"}},
    {"UNC-003", {Page::Uncertainty, "drawnResult"}},
    {"UNC-004", {Comparison, "knownList"}},
    {"UNC-005", {Comparison, "knownList"}},
    {"UNC-006", {Page::Uncertainty, "drawnResult"}},
    {"CER-001", {Page::Certificate, "field_customer"}},
    {"CER-002", {Page::Certificate, "field_remarks"}},
    {"CER-003", {Page::Uncertainty, "budgetTable"}},
    {"CER-004", {Page::Certificate, "exportCertificate"}},
    {"CER-005", {Page::Certificate, "field_approved_by"}},
    {"CER-006", {Page::Certificate, "exportCertificate"}},
    {"CER-007", {Page::Uncertainty, "capabilityOf"}},
    {"CER-008", {Page::Uncertainty, "uncertaintyResult"}},
    {"CER-009", {Page::Uncertainty, "budgetTable"}},
    {"CER-010", {Page::Certificate, "field_laboratory_country"}},
    {"CER-011", {Page::Certificate, "exportCertificate"}},
    {"PRJ-001", {Captures, "shotTable"}},
    {"COR-001", {Captures, "shotTable"}},
};

} // namespace

std::optional<FindingPlace> placeOfFinding(const std::string &id)
{
    const auto found
        = std::ranges::find(kPlaces, id, [](const auto &entry) { return entry.first; });
    if (found != std::end(kPlaces))
        return found->second;
    const std::optional<Page> page = pageOfFinding(id);
    return page ? std::optional(FindingPlace{*page, ""}) : std::nullopt;
}

} // namespace dyncal

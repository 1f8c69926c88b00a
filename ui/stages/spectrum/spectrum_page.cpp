// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/spectrum/spectrum_page.h"

#include "ui/plot/curves/signal_curves.h"
#include "ui/stages/frame/optional_edit.h"
#include "ui/stages/frame/quantity_edit.h"
#include "ui/stages/frame/tube_mode_choice.h"
#include "ui/stages/frame/value_table.h"
#include "ui/stages/spectrum/nuisance_list.h"
#include "ui/text/quantity_column.h"
#include "ui/text/quantity_format.h"

#include <QComboBox>
#include <QSplitter>

namespace dyncal {

namespace {

enum Source { Search, Given, None };
constexpr double kLowest_Hz = 1e-3;
constexpr double kHighest_Hz = 1e12;

Source sourceOf(const SpectrumSettings &settings)
{
    if (settings.searchResonance)
        return Search;
    return settings.resonances_Hz.empty() ? None : Given;
}

} // namespace

SpectrumPage::SpectrumPage(Session &session)
    : StagePage(session,
        {"spectrumPage", tr("Spectrum"),
            tr("Confirm the resonance. With \"given by me\" a click on a peak takes it; else the click marks an oscillation that is not the sensor's.")},
        Page::Spectrum)
    , m_plot(makePlot("spectrumPlot", tr("Power spectral density")))
    , m_table(new ValueTable("resonanceTable", tr("Resonances"), this))
{
    auto *split = new QSplitter(Qt::Vertical, this);
    split->addWidget(m_plot);
    split->addWidget(m_table);
    split->setSizes({1000, 180});
    content()->addWidget(split);
    shareCursors(CursorAxis::Frequency, {m_plot});
    connect(m_plot, &PlotWidget::pointPicked, this, [this](double frequency_Hz, double) {
        if (sourceOf(recipe().spectrum) == Given)
            giveResonance(frequency_Hz);
        else
            m_nuisance->mark(frequency_Hz);
    });
    buildInspector();
}

void SpectrumPage::buildInspector()
{
    InspectorForm *form = inspector();
    form->addSection(tr("Resonance"));
    m_source = form->addChoice(tr("Source"), "resonanceSource",
        {tr("search in the spectrum"), tr("given by me"), tr("none")});
    connect(m_source, &QComboBox::activated, this, &SpectrumPage::setSource);
    m_frequency = form->add(tr("Frequency"), "resonanceFrequency",
        new QuantityEdit({"kHz", 1e3}, kLowest_Hz, kHighest_Hz, 6));
    connect(m_frequency, &QuantityEdit::edited, this, &SpectrumPage::giveResonance);
    m_bandBegin = form->add(
        tr("Search from"), "resonanceBandBegin", new OptionalEdit({"kHz", 1e3}, 0.0, kHighest_Hz));
    m_bandEnd = form->add(tr("Search to"), "resonanceBandEnd",
        new OptionalEdit({"kHz", 1e3}, kLowest_Hz, kHighest_Hz));
    for (OptionalEdit *edit : {m_bandBegin, m_bandEnd})
        edit->setEmptyText(tr("no limit"));
    connect(m_bandBegin, &OptionalEdit::edited, this,
        [this](const std::optional<double> &f_Hz) { setBand(true, f_Hz); });
    connect(m_bandEnd, &OptionalEdit::edited, this,
        [this](const std::optional<double> &f_Hz) { setBand(false, f_Hz); });

    form->addSection(tr("Estimate"));
    m_method
        = form->addChoice(tr("Method"), "spectrumMethod", {tr("periodogram"), tr("Welch average")});
    connect(m_method, &QComboBox::activated, this, [this](int choice) {
        change(tr("Change the spectrum's method"),
            [&](Recipe &r) { r.spectrum.method = static_cast<SpectrumMethod>(choice); });
    });
    m_taper = form->addChoice(tr("Taper"), "taper", {tr("rectangular"), tr("Hann")});
    connect(m_taper, &QComboBox::activated, this, [this](int choice) {
        change(tr("Change the taper"),
            [&](Recipe &r) { r.spectrum.taper = static_cast<Taper>(choice); });
    });
    m_detrend = form->addChoice(
        tr("Take away"), "detrend", {tr("nothing"), tr("the mean"), tr("a straight line")});
    connect(m_detrend, &QComboBox::activated, this, [this](int choice) {
        change(tr("Change what is taken away"),
            [&](Recipe &r) { r.spectrum.detrend = static_cast<Detrend>(choice); });
    });
    m_tubeModes = new TubeModeChoice(*form, this);
    connect(m_tubeModes, &TubeModeChoice::changed, this, &SpectrumPage::showPlot);
    buildNuisance();
}

void SpectrumPage::buildNuisance()
{
    inspector()->addSection(tr("Not the sensor"));
    m_nuisance = new NuisanceList(this);
    inspector()->addWide(m_nuisance);
    connect(m_nuisance, &NuisanceList::addRequested, this, [this](const NuisanceMode &mode) {
        change(tr("Leave an oscillation out of the model"),
            [&](Recipe &r) { r.realization.nuisanceModes.push_back(mode); });
    });
    connect(m_nuisance, &NuisanceList::removeRequested, this, [this](int position) {
        change(tr("Leave an oscillation in the model"), [&](Recipe &r) {
            auto &modes = r.realization.nuisanceModes;
            if (position >= 0 && position < static_cast<int>(modes.size()))
                modes.erase(modes.begin() + position);
        });
    });
}

void SpectrumPage::setSource(int choice)
{
    change(tr("Change where the resonance comes from"), [&](Recipe &r) {
        r.spectrum.searchResonance = choice == Search;
        r.spectrum.resonances_Hz.clear();
        if (choice == Given)
            r.spectrum.resonances_Hz = {m_frequency->si()};
    });
}

void SpectrumPage::setBand(bool begin, const std::optional<double> &frequency_Hz)
{
    Interval band = recipe().spectrum.resonanceBand_Hz.value_or(Interval{0.0, kHighest_Hz});
    (begin ? band.begin : band.end) = frequency_Hz.value_or(begin ? 0.0 : kHighest_Hz);
    if (band.begin >= band.end) {
        showRecipe(); // not taken: the last good values come back
        return;
    }
    const bool whole = band.begin <= 0.0 && band.end >= kHighest_Hz;
    change(tr("Change the search band"), [&](Recipe &r) {
        r.spectrum.resonanceBand_Hz = whole ? std::nullopt : std::optional(band);
    });
}

void SpectrumPage::giveResonance(double frequency_Hz)
{
    change(tr("Give the resonance"), [&](Recipe &r) {
        r.spectrum.searchResonance = false;
        r.spectrum.resonances_Hz = {frequency_Hz};
    });
}

void SpectrumPage::showRecipe()
{
    const SpectrumSettings &settings = recipe().spectrum;
    const auto &found = results().spectrum;
    const Source source = sourceOf(settings);
    m_source->setCurrentIndex(source);
    m_frequency->setShownOnly(source != Given);
    if (source == Given)
        m_frequency->setSi(settings.resonances_Hz.front());
    else if (found && !found->resonances.empty())
        m_frequency->setSi(found->resonances.front().frequency_Hz);
    const auto &band = settings.resonanceBand_Hz;
    m_bandBegin->set(band ? std::optional(band->begin) : std::nullopt);
    m_bandEnd->set(band && band->end < kHighest_Hz ? std::optional(band->end) : std::nullopt);
    m_taper->setCurrentIndex(static_cast<int>(settings.taper));
    m_method->setCurrentIndex(static_cast<int>(settings.method));
    m_detrend->setCurrentIndex(static_cast<int>(settings.detrend));
    m_nuisance->showModes(recipe().realization.nuisanceModes, results());
}

void SpectrumPage::showPlot()
{
    const auto spectrum = results().spectrum;
    const auto window = results().window;
    if (spectrum && window)
        draw(m_plot,
            {{spectrum, window}, pointsOf(*window),
                [spectrum, window] { return spectrumCurves(*spectrum, *window); },
                [this](const PlotContent &made) { return m_tubeModes->with(made); }});
    else
        clear(m_plot);
}

void SpectrumPage::showResults()
{
    const auto &spectrum = results().spectrum;
    m_tubeModes->set(results());
    showPlot();
    QStringList headers{tr("Resonance"), tr("Above background"), tr("Q")};
    QVector<QStringList> rows;
    if (spectrum) {
        if (results().window)
            for (const WindowedResponse &response : results().window->responses)
                headers << tr("Shot %1").arg(response.shot);
        std::vector<double> heights_dB;
        std::vector<double> qualities;
        heights_dB.reserve(spectrum->resonances.size());
        qualities.reserve(spectrum->resonances.size());
        for (const Resonance &resonance : spectrum->resonances) {
            heights_dB.push_back(resonance.prominence_dB);
            qualities.push_back(resonance.q);
        }
        const QStringList heights = shownColumn(heights_dB, "dB", 3);
        const QStringList q = shownColumn(qualities, {}, 3);
        for (const Resonance &resonance : spectrum->resonances) {
            std::vector<std::optional<double>> frequencies_Hz{resonance.frequency_Hz};
            frequencies_Hz.insert(
                frequencies_Hz.end(), resonance.perShot_Hz.begin(), resonance.perShot_Hz.end());
            QStringList row = shownColumn(frequencies_Hz, "Hz", 5); // all of one peak
            row.insert(1, heights[rows.size()]);
            row.insert(2, q[rows.size()]);
            rows.push_back(row);
        }
    }
    m_table->setValues(headers, rows);
    m_nuisance->showCandidates(results());
    m_nuisance->showModes(recipe().realization.nuisanceModes, results());
}

} // namespace dyncal

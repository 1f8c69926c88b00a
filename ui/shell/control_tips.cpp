// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/control_tips.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QLineEdit>
#include <QPlainTextEdit>

#include <algorithm>
#include <iterator>
#include <utility>

namespace dyncal {

namespace {

/// Gives the sentences below their translation context.
struct Tips
{
    Q_DECLARE_TR_FUNCTIONS(ControlTips)
};

using Tip = std::pair<const char *, const char *>;

constexpr Tip kTips[]{
    {"addCaptures", QT_TRANSLATE_NOOP("ControlTips", "Open further recordings beside these")},
    {"importSettings",
        QT_TRANSLATE_NOOP(
            "ControlTips", "How the file of the selected shot is read: channels, units, rate")},
    {"removeShot",
        QT_TRANSLATE_NOOP(
            "ControlTips", "Take the selected shot out of the job; the file stays as it is")},
    {"levelOfShot", QT_TRANSLATE_NOOP("ControlTips", "Name of the shot's pressure level")},
    {"roleOf_", QT_TRANSLATE_NOOP("ControlTips", "What this channel recorded, in all shots")},
    {"dutUnit",
        QT_TRANSLATE_NOOP(
            "ControlTips", "Unit of the sensor's record, where the file's is wrong or missing")},
    {"dutScale", QT_TRANSLATE_NOOP("ControlTips", "Factor on the sensor's values")},
    {"dutInverted",
        QT_TRANSLATE_NOOP("ControlTips", "The sensor's voltage falls when the pressure rises")},
    {"dutReference",
        QT_TRANSLATE_NOOP("ControlTips",
            "Whether the sensor reads pressure from vacuum or from the air around it")},
    {"sampleRate",
        QT_TRANSLATE_NOOP(
            "ControlTips", "Samples per second, where the file is wrong; a reason is asked for")},
    {"shockShot",
        QT_TRANSLATE_NOOP("ControlTips", "The shot that plots, tables and arrivals are of")},
    {"shockEnabled",
        QT_TRANSLATE_NOOP(
            "ControlTips", "Compute the pressure step from shock velocity and gas state")},
    {"stepPressure",
        QT_TRANSLATE_NOOP(
            "ControlTips", "The pressure step, where a reference sensor measured it")},
    {"shockVelocity",
        QT_TRANSLATE_NOOP(
            "ControlTips", "Shock velocity, where it is known otherwise than from arrivals")},
    {"p1",
        QT_TRANSLATE_NOOP(
            "ControlTips", "Absolute pressure in the driven section before the shot")},
    {"T1", QT_TRANSLATE_NOOP("ControlTips", "Temperature in the driven section before the shot")},
    {"T4", QT_TRANSLATE_NOOP("ControlTips", "Temperature in the driver section before the shot")},
    {"drivenGas", QT_TRANSLATE_NOOP("ControlTips", "Gas that the shock runs through")},
    {"driverGas", QT_TRANSLATE_NOOP("ControlTips", "Gas behind the diaphragm")},
    {"drivenGamma", QT_TRANSLATE_NOOP("ControlTips", "Ratio of the heat capacities of the gas")},
    {"driverGamma", QT_TRANSLATE_NOOP("ControlTips", "Ratio of the heat capacities of the gas")},
    {"drivenMolarMass", QT_TRANSLATE_NOOP("ControlTips", "Molar mass of the gas")},
    {"driverMolarMass", QT_TRANSLATE_NOOP("ControlTips", "Molar mass of the gas")},
    {"variableHeatCapacity",
        QT_TRANSLATE_NOOP(
            "ControlTips", "Take the heat capacity at the temperature behind the shock")},
    {"humidity",
        QT_TRANSLATE_NOOP("ControlTips", "Relative humidity of the air in the driven section")},
    {"carbonDioxide", QT_TRANSLATE_NOOP("ControlTips", "Share of carbon dioxide in the air")},
    {"drivenLength",
        QT_TRANSLATE_NOOP(
            "ControlTips", "Length from diaphragm to end wall: gives the end of the plateau")},
    {"driverLength",
        QT_TRANSLATE_NOOP("ControlTips", "Length of the section behind the diaphragm")},
    {"innerDiameter", QT_TRANSLATE_NOOP("ControlTips", "Inner diameter of the driven section")},
    {"plateauGuard",
        QT_TRANSLATE_NOOP(
            "ControlTips", "How long before its computed end the plateau is no longer used")},
    {"arrivalSensor", QT_TRANSLATE_NOOP("ControlTips", "The sensor that the fields below are of")},
    {"arrivalChannel",
        QT_TRANSLATE_NOOP("ControlTips", "Channel that shows when the shock passes")},
    {"arrivalDistance",
        QT_TRANSLATE_NOOP("ControlTips", "Distance of the sensor from the end wall")},
    {"arrivalDistanceUncertainty",
        QT_TRANSLATE_NOOP("ControlTips", "Standard uncertainty of the distance")},
    {"arrivalTime",
        QT_TRANSLATE_NOOP("ControlTips", "When the shock passes, on the record's own axis")},
    {"arrivalDelay", QT_TRANSLATE_NOOP("ControlTips", "By how much the sensor's signal is late")},
    {"addArrivalSensor",
        QT_TRANSLATE_NOOP("ControlTips", "A further sensor that the shock passes")},
    {"removeArrivalSensor",
        QT_TRANSLATE_NOOP("ControlTips", "No longer use this sensor's arrival")},
    {"start",
        QT_TRANSLATE_NOOP("ControlTips", "Where the response begins, on the record's own axis")},
    {"subtractBaseline",
        QT_TRANSLATE_NOOP("ControlTips", "Take the level before the step off the response")},
    {"baseline",
        QT_TRANSLATE_NOOP(
            "ControlTips", "Stretch before the step that gives level 0 and the noise")},
    {"windowEnd", QT_TRANSLATE_NOOP("ControlTips", "Where the response ends, after the start")},
    {"windowEndFor",
        QT_TRANSLATE_NOOP("ControlTips",
            "Whether an end that is typed or dragged holds for all shots, or for the shot alone whose values are shown")},
    {"endAtPlateau",
        QT_TRANSLATE_NOOP("ControlTips", "End every shot where its own computed plateau ends")},
    {"settle",
        QT_TRANSLATE_NOOP("ControlTips", "Stretch after the ringing that gives the step's height")},
    {"remap",
        QT_TRANSLATE_NOOP(
            "ControlTips", "Divide each response by its step, so that shots can be compared")},
    {"stretchBegin",
        QT_TRANSLATE_NOOP("ControlTips", "Begin of the stretch left out, after the start")},
    {"stretchEnd",
        QT_TRANSLATE_NOOP("ControlTips", "End of the stretch left out, after the start")},
    {"stretchShot", QT_TRANSLATE_NOOP("ControlTips", "Shots in which the stretch is left out")},
    {"stretchReason",
        QT_TRANSLATE_NOOP("ControlTips", "Why it is left out; the certificate prints it")},
    {"stretchRemove", QT_TRANSLATE_NOOP("ControlTips", "Use the selected stretch again")},
    {"spectrumMethod", QT_TRANSLATE_NOOP("ControlTips", "How the power spectrum is estimated")},
    {"taper",
        QT_TRANSLATE_NOOP("ControlTips", "Weight of the samples towards the ends of the window")},
    {"detrend",
        QT_TRANSLATE_NOOP(
            "ControlTips", "What is taken off before the spectrum: nothing, a mean, a line")},
    {"resonanceSource",
        QT_TRANSLATE_NOOP(
            "ControlTips", "Whether the program looks for the resonance or you give it")},
    {"resonanceFrequency",
        QT_TRANSLATE_NOOP("ControlTips", "Frequency of the resonance that you give")},
    {"resonanceBand",
        QT_TRANSLATE_NOOP("ControlTips", "Frequencies between which a resonance is looked for")},
    {"nuisanceCandidates",
        QT_TRANSLATE_NOOP("ControlTips", "Oscillations that the gas of the tube can have")},
    {"nuisanceFrequency",
        QT_TRANSLATE_NOOP("ControlTips", "Frequency of an oscillation that is not the sensor's")},
    {"nuisanceShot", QT_TRANSLATE_NOOP("ControlTips", "Shot in which this frequency was read")},
    {"nuisanceKind",
        QT_TRANSLATE_NOOP(
            "ControlTips", "Whether it moves with the sound speed of the gas from shot to shot")},
    {"nuisanceReason",
        QT_TRANSLATE_NOOP("ControlTips", "Why it is not the sensor's; the certificate prints it")},
    {"nuisanceAdd",
        QT_TRANSLATE_NOOP("ControlTips", "Fit it in each shot and leave it out of the model")},
    {"nuisanceRemove",
        QT_TRANSLATE_NOOP("ControlTips", "Let the model describe the selected oscillation again")},
    {"componentsKept",
        QT_TRANSLATE_NOOP("ControlTips", "How many components make up what the shots share")},
    {"centre",
        QT_TRANSLATE_NOOP("ControlTips", "Take the mean of every shot off before the components")},
    {"residualConfidence",
        QT_TRANSLATE_NOOP("ControlTips", "Confidence of the band that white noise stays in")},
    {"residualLags",
        QT_TRANSLATE_NOOP("ControlTips", "How far the residual is compared with itself")},
    {"treatment", QT_TRANSLATE_NOOP("ControlTips", "What the model takes the response for")},
    {"combine",
        QT_TRANSLATE_NOOP("ControlTips", "Whether shots are fitted together or averaged first")},
    {"modelRate",
        QT_TRANSLATE_NOOP("ControlTips", "Rate that the response is resampled to for the model")},
    {"modelSamples", QT_TRANSLATE_NOOP("ControlTips", "How many samples the model is made from")},
    {"modelOffset",
        QT_TRANSLATE_NOOP("ControlTips", "How long after the start the model input begins")},
    {"order", QT_TRANSLATE_NOOP("ControlTips", "Number of states of the model")},
    {"useSuggestion",
        QT_TRANSLATE_NOOP("ControlTips", "Take the order that the program suggests (Home)")},
    {"adoptReason", QT_TRANSLATE_NOOP("ControlTips", "Why this order; the certificate prints it")},
    {"adoptOrder",
        QT_TRANSLATE_NOOP("ControlTips", "Keep this order and the reason for it (Enter)")},
    {"stableFrequency",
        QT_TRANSLATE_NOOP(
            "ControlTips", "By how much a frequency may move from one order to the next")},
    {"stableDamping",
        QT_TRANSLATE_NOOP(
            "ControlTips", "By how much a damping may move from one order to the next")},
    {"maxOrder", QT_TRANSLATE_NOOP("ControlTips", "Largest order that can be chosen")},
    {"hankelRows",
        QT_TRANSLATE_NOOP("ControlTips", "Rows of the Hankel matrix that is decomposed")},
    {"refinePoles",
        QT_TRANSLATE_NOOP("ControlTips", "Fit the poles to the samples after the decomposition")},
    {"differenceToAdopted",
        QT_TRANSLATE_NOOP(
            "ControlTips", "Show the candidates' numbers as differences from the adopted order")},
    {"candidateUnpin", QT_TRANSLATE_NOOP("ControlTips", "No longer compare this order (Space)")},
    {"candidateOverlay",
        QT_TRANSLATE_NOOP("ControlTips", "Draw this order over the others in the plots")},
    {"candidateRemark",
        QT_TRANSLATE_NOOP("ControlTips", "A note on this order, kept in the project")},
    {"cancelWholeSet",
        QT_TRANSLATE_NOOP("ControlTips", "Go on with the first singular values alone")},
    {"computeWholeSet", QT_TRANSLATE_NOOP("ControlTips", "Compute all singular values now")},
    {"drawCandidates", QT_TRANSLATE_NOOP("ControlTips", "Draw the pinned orders beside the model")},
    {"drawSecondOrder",
        QT_TRANSLATE_NOOP("ControlTips", "Draw the second-order sensor that describes it best")},
    {"uncertaintyQuantity", QT_TRANSLATE_NOOP("ControlTips", "The value whose budget is shown")},
    {"uncertaintyFrequency",
        QT_TRANSLATE_NOOP("ControlTips", "The frequency of S(f) whose budget is shown")},
    {"whatIfInput", QT_TRANSLATE_NOOP("ControlTips", "The input whose u is tried")},
    {"whatIfU",
        QT_TRANSLATE_NOOP(
            "ControlTips", "Another standard uncertainty of this input; empty: as it is")},
    {"wantedU",
        QT_TRANSLATE_NOOP("ControlTips", "Expanded uncertainty that is wanted, of the value")},
    {"wantedK", QT_TRANSLATE_NOOP("ControlTips", "Coverage factor of the wanted U")},
    {"comparisonEnabled",
        QT_TRANSLATE_NOOP("ControlTips",
            "Compute S(f) against the reference transducer too, and compare it with that against the step")},
    {"responseReference",
        QT_TRANSLATE_NOOP("ControlTips",
            "What the stated S(f) is divided by; the comparison is made in either case")},
    {"referenceChannel",
        QT_TRANSLATE_NOOP("ControlTips", "Channel that recorded the reference transducer")},
    {"referenceUnit",
        QT_TRANSLATE_NOOP("ControlTips",
            "Unit of the sensitivity in its file or model: that of its channel over Pa")},
    {"referenceBrowse",
        QT_TRANSLATE_NOOP("ControlTips",
            "A table (CSV) or a digital calibration certificate (XML) with its sensitivity over frequency")},
    {"referenceRemove",
        QT_TRANSLATE_NOOP(
            "ControlTips", "No longer use this file; the comparison is switched off")},
    {"referenceList",
        QT_TRANSLATE_NOOP("ControlTips", "Which list of the certificate is meant, by its id")},
    {"referenceSensitivity", QT_TRANSLATE_NOOP("ControlTips", "Sensitivity at low frequency")},
    {"referenceSensitivityU",
        QT_TRANSLATE_NOOP("ControlTips", "Standard uncertainty of the sensitivity, in its unit")},
    {"referenceF0",
        QT_TRANSLATE_NOOP("ControlTips", "Natural frequency of the reference transducer")},
    {"referenceF0U",
        QT_TRANSLATE_NOOP("ControlTips", "Standard uncertainty of its natural frequency")},
    {"referenceZeta",
        QT_TRANSLATE_NOOP("ControlTips", "Damping ratio of the reference transducer")},
    {"referenceZetaU",
        QT_TRANSLATE_NOOP("ControlTips", "Standard uncertainty of its damping ratio")},
    {"referenceModelRemove",
        QT_TRANSLATE_NOOP("ControlTips", "Drop these values; the comparison is switched off")},
    {"referenceDelay",
        QT_TRANSLATE_NOOP("ControlTips", "By how much later the step reaches it than the sensor")},
    {"referenceDelayU",
        QT_TRANSLATE_NOOP(
            "ControlTips", "Standard uncertainty of the delay; empty: anything within ±0.5 µs")},
    {"referenceCorrelation",
        QT_TRANSLATE_NOOP(
            "ControlTips", "Of its sensitivity and the computed step, from -1 to 1; empty: none")},
    {"chainBrowse",
        QT_TRANSLATE_NOOP("ControlTips",
            "A table (CSV) or a certificate (XML) with the response of amplifier and converter, relative to the gain at low frequency")},
    {"chainRemove",
        QT_TRANSLATE_NOOP("ControlTips", "No longer divide the chain's response out of S(f)")},
    {"chainList",
        QT_TRANSLATE_NOOP("ControlTips", "Which list of the certificate is meant, by its id")},
    {"knownLabel",
        QT_TRANSLATE_NOOP("ControlTips", "What the certificate calls the other calibration")},
    {"knownCertificate",
        QT_TRANSLATE_NOOP("ControlTips", "Number of its certificate; may be left out")},
    {"knownFrequency", QT_TRANSLATE_NOOP("ControlTips", "At which the value holds; empty: static")},
    {"knownUnit",
        QT_TRANSLATE_NOOP(
            "ControlTips", "Such as V/Pa or mV/bar; it is converted to the unit of S(f)")},
    {"knownMagnitude",
        QT_TRANSLATE_NOOP("ControlTips", "The sensitivity that it states, in this unit")},
    {"knownU",
        QT_TRANSLATE_NOOP(
            "ControlTips", "Its expanded uncertainty, in the unit of the value, at k = 2")},
    {"correlationOf",
        QT_TRANSLATE_NOOP("ControlTips",
            "An input of the budget whose error goes along with another's; the budget must state its u")},
    {"correlationWith",
        QT_TRANSLATE_NOOP("ControlTips",
            "The other input, as where one instrument or one certificate is behind both")},
    {"correlationR",
        QT_TRANSLATE_NOOP("ControlTips",
            "The part of their variance that both have in common, -1 to 1; negative where they err the opposite way")},
    {"capabilityOf",
        QT_TRANSLATE_NOOP(
            "ControlTips", "What the laboratory is accredited for: no smaller U of it is stated")},
    {"capabilityIn",
        QT_TRANSLATE_NOOP(
            "ControlTips", "Whether the least U is relative to the value or in its unit")},
    {"capabilityU",
        QT_TRANSLATE_NOOP("ControlTips",
            "The smallest expanded uncertainty that the laboratory states, at 95 %")},
    {"capabilityFrom",
        QT_TRANSLATE_NOOP("ControlTips", "Lowest frequency of the entry; empty: from 0 on")},
    {"capabilityTo",
        QT_TRANSLATE_NOOP("ControlTips", "Highest frequency of the entry; empty: without end")},
    {"decisionRule",
        QT_TRANSLATE_NOOP(
            "ControlTips", "How deviation and uncertainty decide whether the sensor conforms")},
    {"decisionWithin",
        QT_TRANSLATE_NOOP(
            "ControlTips", "Limit of the deviation from the sensitivity at low frequency")},
    {"decisionFrom", QT_TRANSLATE_NOOP("ControlTips", "Lowest frequency of the claim")},
    {"decisionTo", QT_TRANSLATE_NOOP("ControlTips", "Highest frequency of the claim")},
    {"decisionRisk",
        QT_TRANSLATE_NOOP(
            "ControlTips", "Largest probability of being outside the limit, at any frequency")},
    {"certificateTemplate",
        QT_TRANSLATE_NOOP("ControlTips",
            "Which sections, figures and key results the certificate has, in which order")},
    {"templateBrowse",
        QT_TRANSLATE_NOOP(
            "ControlTips", "A template of your own (.json), with the logo beside it")},
    {"certificateLanguage",
        QT_TRANSLATE_NOOP("ControlTips", "Language of the document, not of the window")},
    {"exportCertificate",
        QT_TRANSLATE_NOOP("ControlTips", "Write the certificate as a PDF (Ctrl+P)")},
    {"field_date_",
        QT_TRANSLATE_NOOP("ControlTips", "A day as 2026-01-31; printed on the certificate")},
    {"field_approved_by",
        QT_TRANSLATE_NOOP("ControlTips", "Who approves the certificate; may be left empty")},
    {"field_remarks",
        QT_TRANSLATE_NOOP("ControlTips", "Printed on the certificate; may be left empty")},
    {"field_sensor_",
        QT_TRANSLATE_NOOP("ControlTips",
            "Printed on the certificate; taken from the recordings where they say it")},
    {"field_",
        QT_TRANSLATE_NOOP(
            "ControlTips", "Printed on the certificate; it cannot be issued without")},
    {"startOpenCaptures",
        QT_TRANSLATE_NOOP("ControlTips", "Choose the recordings of one sensor (Ctrl+Shift+O)")},
    {"startOpenExample",
        QT_TRANSLATE_NOOP("ControlTips", "Three simulated shots, ready to look at")},
    {"startOpenProject",
        QT_TRANSLATE_NOOP("ControlTips", "Go on with a job saved before (Ctrl+O)")},
    {"cancelButton",
        QT_TRANSLATE_NOOP("ControlTips", "Stop the work under way; what is on show stays")},
    {"retryProblems", QT_TRANSLATE_NOOP("ControlTips", "Read the files of this list again")},
    {"copyProblems", QT_TRANSLATE_NOOP("ControlTips", "Put the list on the clipboard")},
    {"dismissProblems", QT_TRANSLATE_NOOP("ControlTips", "Close the list; nothing is changed")},
};

/// Of every list of entries in the recipe (EntryList), whose controls share a beginning.
constexpr const char *kEntryLists[]{"known", "correlation", "capability", "stated"};
constexpr Tip kEntryTips[]{
    {"List",
        QT_TRANSLATE_NOOP(
            "ControlTips", "Entries of the recipe; the selected one stands in the fields below")},
    {"Add",
        QT_TRANSLATE_NOOP(
            "ControlTips", "Put what stands in the fields into the recipe, as a further entry")},
    {"Replace",
        QT_TRANSLATE_NOOP(
            "ControlTips", "Put what stands in the fields in the place of the selected entry")},
    {"Remove", QT_TRANSLATE_NOOP("ControlTips", "Take the selected entry out of the recipe")},
};

const char *sentenceOfEntries(const QString &name)
{
    for (const char *list : kEntryLists)
        for (const auto &[part, sentence] : kEntryTips)
            if (name == QLatin1String(list) + QLatin1String(part))
                return sentence;
    return nullptr;
}

/// The longest entry that the name is, or, for one that ends in '_' or a digit, begins with.
const char *sentenceFor(const QString &name)
{
    const char *best = nullptr;
    qsizetype length = 0;
    for (const auto &[key, sentence] : kTips) {
        const QLatin1String begin(key);
        const bool isOpen
            = begin.endsWith(QLatin1Char('_')) || begin == QLatin1String("levelOfShot");
        const bool fits = isOpen ? name.startsWith(begin) : name == begin;
        if (fits && begin.size() > length) {
            best = sentence;
            length = begin.size();
        }
    }
    return best;
}

bool isControl(const QWidget &widget)
{
    return qobject_cast<const QAbstractButton *>(&widget)
        || qobject_cast<const QLineEdit *>(&widget)
        || qobject_cast<const QAbstractSpinBox *>(&widget)
        || qobject_cast<const QComboBox *>(&widget)
        || qobject_cast<const QPlainTextEdit *>(&widget);
}

QString keysOf(const QWidget &widget)
{
    const auto *button = qobject_cast<const QAbstractButton *>(&widget);
    return button && !button->shortcut().isEmpty()
        ? " (" + button->shortcut().toString(QKeySequence::NativeText) + ")"
        : QString();
}

void giveTip(QWidget &widget)
{
    // The line of a spin box or a list of choices speaks for the whole.
    const QWidget *owner = widget.parentWidget();
    const bool isPart = owner && isControl(*owner);
    const QWidget &named = isPart ? *owner : widget;
    QString tip = tipFor(named.objectName());
    if (tip.isEmpty())
        tip = named.accessibleName();
    if (const auto *button = qobject_cast<const QAbstractButton *>(&named); tip.isEmpty() && button)
        tip = button->text().remove('&');
    if (!tip.isEmpty())
        widget.setToolTip(tip + keysOf(named));
}

} // namespace

ControlTips::ControlTips(QObject *parent)
    : QObject(parent)
{
    qApp->installEventFilter(this);
}

/// When a control is shown for the first time it has its names; a tip that is taken away later
/// gives way to the control's own.
bool ControlTips::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() != QEvent::Polish && event->type() != QEvent::ToolTipChange)
        return false;
    auto *widget = qobject_cast<QWidget *>(watched);
    if (widget && widget->toolTip().isEmpty() && isControl(*widget))
        giveTip(*widget);
    return false;
}

QString tipFor(const QString &objectName)
{
    for (const auto find : {sentenceFor, sentenceOfEntries})
        if (const char *sentence = find(objectName))
            return Tips::tr(sentence);
    if (objectName.endsWith(QLatin1String("Auto")))
        return Tips::tr("Ticked, the program decides, and the field shows what it took");
    for (const char *part : {"Value", "Begin", "End"})
        if (objectName.endsWith(QLatin1String(part)))
            if (const char *sentence = sentenceFor(objectName.chopped(
                    static_cast<qsizetype>(std::char_traits<char>::length(part)))))
                return Tips::tr(sentence);
    return {};
}

} // namespace dyncal

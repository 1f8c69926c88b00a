// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/shock/gas_edit.h"

#include "core/project/gas_names.h"
#include "ui/stages/frame/inspector_form.h"
#include "ui/stages/frame/quantity_edit.h"

#include <QComboBox>

namespace dyncal {

namespace {

struct Choice
{
    const char *substance;
    QString text;
};

QVector<Choice> choices()
{
    return {{kAutoGas, GasEdit::tr("as recorded")}, {"air", GasEdit::tr("dry air")},
        {"humid-air", GasEdit::tr("humid air")}, {"n2", QStringLiteral("N₂")},
        {"he", QStringLiteral("He")}, {"ar", QStringLiteral("Ar")}, {"co2", QStringLiteral("CO₂")},
        {"custom", GasEdit::tr("other, typed")}};
}

QStringList words()
{
    QStringList list;
    for (const Choice &choice : choices())
        list << choice.text;
    return list;
}

} // namespace

GasEdit::GasEdit(InspectorForm &form, const QString &label, const QString &name, QObject *parent)
    : QObject(parent)
    , m_substance(form.addChoice(label, name + "Gas", words()))
    , m_gamma(form.add(tr("γ"), name + "Gamma", new QuantityEdit({}, 1.0001, 2.0, 5)))
    , m_molarMass(form.add(
          tr("Molar mass"), name + "MolarMass", new QuantityEdit({"g/mol", 1e-3}, 1e-3, 1.0, 4)))
{
    connect(m_substance, &QComboBox::activated, this, &GasEdit::choose);
    connect(m_gamma, &QuantityEdit::edited, this, [this](double gamma) {
        m_settings.gamma = gamma;
        emit edited(m_settings);
    });
    connect(m_molarMass, &QuantityEdit::edited, this, [this](double mass) {
        m_settings.molarMass_kg_mol = mass;
        emit edited(m_settings);
    });
}

void GasEdit::choose(int choice)
{
    const std::string substance = choices()[choice].substance;
    const std::string heatCapacity = m_settings.heatCapacity;
    for (const auto &[name, settings] : namedGases()) {
        if (name == substance)
            m_settings = settings;
    }
    m_settings.substance = substance;
    const bool hasHeatCapacity = substance != "custom" && substance != "humid-air";
    m_settings.heatCapacity = hasHeatCapacity ? heatCapacity : kConstantHeatCapacity;
    emit edited(m_settings);
}

void GasEdit::set(const GasSettings &settings, const std::optional<GasModel> &used)
{
    m_settings = settings;
    const QVector<Choice> all = choices();
    for (int i = 0; i < all.size(); ++i) {
        if (settings.substance == all[i].substance)
            m_substance->setCurrentIndex(i);
    }
    const bool typed = settings.substance == "custom";
    const bool known
        = used && (used->name == settings.substance || settings.substance == kAutoGas) && !typed;
    m_gamma->setShownOnly(!typed);
    m_molarMass->setShownOnly(!typed);
    m_gamma->setSi(known ? used->constants.gamma : settings.gamma);
    m_molarMass->setSi(known ? used->constants.molarMass_kg_mol : settings.molarMass_kg_mol);
    const QString source = known ? tr("Source of the constants: %1").arg(used->source) : QString();
    for (QWidget *control : std::initializer_list<QWidget *>{m_substance, m_gamma, m_molarMass})
        control->setToolTip(source);
}

} // namespace dyncal

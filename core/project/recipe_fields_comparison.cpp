// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/project/recipe_fields_comparison.h"

#include "core/base/content_hash.h"

namespace dyncal {
namespace {

Codec<std::string> hashOrNull()
{
    return formedTextOrNull("null or 64 hexadecimal digits in lower case", isSha256Hex);
}

Codec<ReferenceModel> modelCodec()
{
    using M = ReferenceModel;
    return object<M>({
        field("sensitivity", DYNCAL_TEXT("RecipeLabel", "sensitivity of the reference"),
            &M::sensitivity, positiveNumber(), true),
        field("u_sensitivity", DYNCAL_TEXT("RecipeLabel", "u of the reference's sensitivity"),
            &M::u_sensitivity, nonNegativeNumber(), true),
        field("f0_hz", DYNCAL_TEXT("RecipeLabel", "resonance of the reference"), &M::f0_Hz,
            positiveNumber(), true),
        field("u_f0_hz", DYNCAL_TEXT("RecipeLabel", "u of the reference's resonance"), &M::u_f0_Hz,
            nonNegativeNumber(), true),
        field("zeta", DYNCAL_TEXT("RecipeLabel", "damping of the reference"), &M::zeta,
            positiveNumber(), true),
        field("u_zeta", DYNCAL_TEXT("RecipeLabel", "u of the reference's damping"), &M::u_zeta,
            nonNegativeNumber(), true),
    });
}

Codec<ComparisonSettings> comparisonCodec()
{
    using S = ComparisonSettings;
    return object<S>({
        field("enabled", DYNCAL_TEXT("RecipeLabel", "comparison with a reference transducer"),
            &S::enabled, boolean()),
        field("channel", DYNCAL_TEXT("RecipeLabel", "channel of the reference"), &S::channel,
            textOrNull()),
        field("source", DYNCAL_TEXT("RecipeLabel", "file of the reference"), &S::source,
            textOrNull()),
        field("sha256", DYNCAL_TEXT("RecipeLabel", "hash of the reference's file"), &S::sha256,
            hashOrNull()),
        field("quantity_id", DYNCAL_TEXT("RecipeLabel", "list in the reference's certificate"),
            &S::quantityId, textOrNull()),
        later(field("certificate", DYNCAL_TEXT("RecipeLabel", "certificate of the reference"),
            &S::certificate, textOrNull())),
        later(field(
            "due", DYNCAL_TEXT("RecipeLabel", "due date of the reference"), &S::due, dateOrNull())),
        field("model", DYNCAL_TEXT("RecipeLabel", "model of the reference"), &S::model,
            orNull(modelCodec())),
        field("unit", DYNCAL_TEXT("RecipeLabel", "unit of the reference's sensitivity"), &S::unit,
            nonEmptyText()),
        field("delay_s", DYNCAL_TEXT("RecipeLabel", "delay of the reference"), &S::delay_s,
            anyNumber()),
        field("u_delay_s", DYNCAL_TEXT("RecipeLabel", "u of the reference's delay"), &S::u_delay_s,
            orNull(nonNegativeNumber())),
        field("correlation_with_step",
            DYNCAL_TEXT("RecipeLabel", "correlation of reference and step"),
            &S::correlationWithStep, number(-1.0, 1.0)),
    });
}

Codec<ChainSettings> chainCodec()
{
    using S = ChainSettings;
    return object<S>({
        field("source", DYNCAL_TEXT("RecipeLabel", "file of the chain's response"), &S::source,
            textOrNull()),
        field("sha256", DYNCAL_TEXT("RecipeLabel", "hash of the chain's file"), &S::sha256,
            hashOrNull()),
        field("quantity_id", DYNCAL_TEXT("RecipeLabel", "list in the chain's certificate"),
            &S::quantityId, textOrNull()),
        later(field("certificate", DYNCAL_TEXT("RecipeLabel", "certificate of the chain"),
            &S::certificate, textOrNull())),
    });
}

} // namespace

std::vector<Field<Recipe>> comparisonSections()
{
    return {field("chain", DYNCAL_TEXT("RecipeLabel", "amplifier and converter"), &Recipe::chain,
                chainCodec()),
        field("comparison", DYNCAL_TEXT("RecipeLabel", "comparison"), &Recipe::comparison,
            comparisonCodec())};
}

} // namespace dyncal

#include "core/aggregate/material.h"

#include "core/message/number_text.h"

#include <cmath>

namespace knead {

namespace {

constexpr const char* panelOfMaterials = "MaterialPanel"; // has the names of fields among its words

std::string withUnit(double number, const MaterialField& field)
{
    return *field.unit == '\0' ? inDigits(number) : inDigits(number) + ' ' + field.unit;
}

/// Names of fields are said as the panel says them.
Message problem(const MaterialField& field, double number)
{
    return Message("Material", "%1 is %2; it must lie between %3 and %4.")
        .with(Message(panelOfMaterials, field.name), withUnit(number, field), inDigits(field.minimum),
              withUnit(field.maximum, field));
}

} // namespace

double Material::soundSpeed() const
{
    return std::sqrt(youngsModulus / density);
}

const std::vector<MaterialField>& materialFields()
{
    static const std::vector<MaterialField> fields{
        {"density_kg_m3", "Density", "kg/m^3", 1, 30'000, &Material::density},
        {"youngs_modulus_pa", "Young's modulus", "Pa", 100, 1e12, &Material::youngsModulus},
        {"poisson_ratio", "Poisson's ratio", "", 0, 0.49, &Material::poissonRatio},
        {"damping_ratio", "Damping ratio", "", 0, 0.3, &Material::dampingRatio},
        {"shape_damping_per_s", "Shape damping", "1/s", 0, 1000, &Material::shapeDamping},
        {"friction", "Friction", "", 0, 2, &Material::friction},
        {"rubberlike", "Rubberlike", "", 0, 1, &Material::rubberlike, "for small strains"},
        {"second_invariant_share", "Second-invariant share", "", 0, 1, &Material::secondInvariantShare},
        {"locking_elongation", "Locking elongation", "", 0, 100, &Material::lockingElongation, "never locks"},
        {"yield_stress_pa", "Yield stress", "Pa", 0, 1e11, &Material::yieldStress, "never yields"},
        {"hardening_pa", "Hardening", "Pa", 0, 1e11, &Material::hardening},
        {"relaxation_time_s", "Relaxation time", "s", 0, 1000, &Material::relaxationTime, "flows at once"},
        {"tensile_strength_pa", "Tensile strength", "Pa", 0, 1e11, &Material::tensileStrength, "never breaks"},
        {"elongation_at_break", "Elongation at break", "", 0, 100, &Material::elongationAtBreak, "no limit"},
        {"toughness_j_m2", "Toughness", "J/m^2", 0, 1e6, &Material::toughness, "knives do not cut it"},
        {"adhesion_pa", "Adhesion", "Pa", 0, 1e9, &Material::adhesion, "does not stick"},
        {"healing_time_s", "Healing time", "s", 0, 1e4, &Material::healingTime, "does not heal"},
    };
    return fields;
}

std::vector<Message> materialProblems(const Material& material)
{
    std::vector<Message> problems;
    for (const MaterialField& field : materialFields()) {
        const double number = material.*field.value;
        // A NaN fails every comparison, so the range is asked for, not its opposite.
        const bool inRange = number >= field.minimum && number <= field.maximum;
        if (!inRange)
            problems.push_back(problem(field, number));
    }
    return problems;
}

} // namespace knead

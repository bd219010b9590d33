#include "model_units.hpp"

#include <fmt/format.h>

namespace libration::import {

namespace {

// mole/litre of a concentration, mole of an amount.
std::string unit_of_species(const Species& of, const Model& model) {
    const std::string amount = of.isSetSubstanceUnits() ? of.getSubstanceUnits() : model.getSubstanceUnits();
    const Compartment* const in = model.getCompartment(of.getCompartment());
    const std::string volume = in != nullptr && in->isSetUnits() ? in->getUnits() : model.getVolumeUnits();
    return amount.empty() || volume.empty() || of.getHasOnlySubstanceUnits() ? amount : amount + "/" + volume;
}

std::string unit_of(const std::string& id, const Model& model) {
    if (const Parameter* const parameter = model.getParameter(id); parameter != nullptr) {
        return parameter->getUnits();
    }
    if (const Compartment* const compartment = model.getCompartment(id); compartment != nullptr) {
        return compartment->getUnits();
    }
    const Species* const species = model.getSpecies(id);
    return species != nullptr ? unit_of_species(*species, model) : "";
}

}  // namespace

std::string units_line(const Model& model, const std::vector<std::string>& ids, problem_names& names) {
    std::string text;
    const auto add = [&](const std::string& name, const std::string& unit) {
        if (!unit.empty() && unit != "dimensionless") {
            text += fmt::format("{}{} in {}", text.empty() ? "# units: " : ", ", name, unit);
        }
    };
    add("t", model.getTimeUnits());
    for (const std::string& id : ids) {
        add(names.of(id), unit_of(id, model));
    }
    return text.empty() ? "" : text + "\n";
}

}  // namespace libration::import

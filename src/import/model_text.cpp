#include "model_text.hpp"

#include <fmt/format.h>

#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "expansion.hpp"
#include "formula.hpp"
#include "model_units.hpp"
#include "names.hpp"

namespace libration::import {

namespace {

// How a quantity of the model changes.
enum class change { never, by_rate, by_assignment, by_events, by_reactions, by_algebra };

struct quantity {
    change how = change::never;
    std::optional<double> value = {};                            // the initial value
    const Species* species = nullptr;                            // if it is one
    const ASTNode* formula = nullptr;                            // of its rule
    std::vector<std::pair<std::string, double>> reactions = {};  // with its stoichiometry
};

class model_reader {
public:
    explicit model_reader(Model& model) : model_(model) {
        read_quantities();
        read_rules();
        read_reactions();
        read_events();
        find_algebraic_unknowns();
        find_diluted_species();
    }

    std::string text() {
        for (const std::string& id : order_) {
            write(id, quantities_.at(id));
        }
        for (unsigned int i = 0; i < model_.getNumReactions(); ++i) {
            const Reaction& each = *model_.getReaction(i);
            definitions_ +=
                fmt::format("{} = {}\n", names_.of(each.getId()), now(*each.getKineticLaw()->getMath()).text);
        }
        for (unsigned int i = 0; i < model_.getNumRules(); ++i) {
            const Rule& each = *model_.getRule(i);
            if (each.isAlgebraic()) {
                equations_ += fmt::format("0 = {}\n", now(*each.getMath()).text);
            }
        }
        for (unsigned int i = 0; i < model_.getNumEvents(); ++i) {
            write_event(*model_.getEvent(i));
        }
        const std::string name = model_.isSetName() ? model_.getName() : model_.getId();
        const std::string open =
            has_open_piecewise(model_) ? "# piecewise functions without a value for all other cases are 0 there\n" : "";
        return fmt::format("# {}\n{}{}{}{}{}{}", name.empty() ? "A model in SBML" : name,
                           units_line(model_, order_, names_), open, equations_, initial_values(), definitions_,
                           events_);
    }

private:
    // Of a delayed unknown it is the value at all earlier times.
    std::string initial_values() const {
        std::string text;
        for (const auto& [name, value] : starts_) {
            text += fmt::format("{}({}) = {}\n", name, delayed_.contains(name) ? "t <= 0" : "0", value);
        }
        return text;
    }

    void add(const std::string& id, bool has_value, double value, const Species* species = nullptr) {
        order_.push_back(id);
        quantities_[id] = {.value = has_value ? std::optional(value) : std::nullopt, .species = species};
    }

    void read_quantities() {
        if (model_.isSetConversionFactor()) {
            throw unsupported("a conversion factor");
        }
        for (unsigned int i = 0; i < model_.getNumCompartments(); ++i) {
            const Compartment& each = *model_.getCompartment(i);
            const bool point = each.isSetSpatialDimensions() && each.getSpatialDimensions() == 0;
            add(each.getId(), each.isSetSize() || point, point ? 1 : each.getSize());
        }
        for (unsigned int i = 0; i < model_.getNumSpecies(); ++i) {
            const Species& each = *model_.getSpecies(i);
            if (each.isSetConversionFactor()) {
                throw unsupported("a conversion factor");
            }
            const bool amount = each.isSetInitialAmount();
            add(each.getId(), amount || each.isSetInitialConcentration(),
                amount ? each.getInitialAmount() : each.getInitialConcentration(), &each);
        }
        for (unsigned int i = 0; i < model_.getNumParameters(); ++i) {
            const Parameter& each = *model_.getParameter(i);
            add(each.getId(), each.isSetValue(), each.getValue());
        }
    }

    quantity& quantity_of(const std::string& id) {
        const auto found = quantities_.find(id);
        if (found == quantities_.end()) {
            throw unsupported("a rule or an event for '" + id + "'");
        }
        return found->second;
    }

    void read_rules() {
        for (unsigned int i = 0; i < model_.getNumRules(); ++i) {
            const Rule& each = *model_.getRule(i);
            if (each.getMath() == nullptr) {
                throw unsupported("a rule without a formula");
            }
            if (!each.isAlgebraic()) {
                quantity& of = quantity_of(each.getVariable());
                of.how = each.isRate() ? change::by_rate : change::by_assignment;
                of.formula = each.getMath();
            }
        }
    }

    void read_reactions() {
        for (unsigned int i = 0; i < model_.getNumReactions(); ++i) {
            const Reaction& each = *model_.getReaction(i);
            if (!each.isSetKineticLaw() || each.getKineticLaw()->getMath() == nullptr) {
                throw unsupported("the reaction '" + each.getId() + "' without a kinetic law");
            }
            if (each.isSetFast() && each.getFast()) {
                throw unsupported("the fast reaction '" + each.getId() + "'");
            }
            for (unsigned int k = 0; k < each.getNumReactants(); ++k) {
                take_part(*each.getReactant(k), each.getId(), -1);
            }
            for (unsigned int k = 0; k < each.getNumProducts(); ++k) {
                take_part(*each.getProduct(k), each.getId(), 1);
            }
        }
    }

    void take_part(const SpeciesReference& of, const std::string& reaction, int sign) {
        const bool varies =
            of.isSetStoichiometryMath() ||
            (of.isSetId() && (quantities_.contains(of.getId()) || model_.getRule(of.getId()) != nullptr));
        if (varies || (model_.getLevel() > 2 && !of.isSetStoichiometry())) {
            throw unsupported("a stoichiometry that is not a number in the reaction '" + reaction + "'");
        }
        quantity& species = quantity_of(of.getSpecies());
        const bool is_constant = species.species->getBoundaryCondition() || species.species->getConstant();
        if (!is_constant && species.how == change::never) {
            species.how = change::by_reactions;
        }
        if (species.how == change::by_reactions) {
            species.reactions.emplace_back(reaction, sign * of.getStoichiometry());
        }
    }

    void read_events() {
        for (unsigned int i = 0; i < model_.getNumEvents(); ++i) {
            const Event& each = *model_.getEvent(i);
            const std::string name = "the event " + (each.isSetId() ? "'" + each.getId() + "'" : std::to_string(i + 1));
            if (each.isSetPriority() && model_.getNumEvents() > 1) {
                throw unsupported("a priority of " + name);
            }
            if (!each.isSetTrigger() || each.getTrigger()->getMath() == nullptr) {
                throw unsupported(name + " without a trigger");
            }
            if (each.isSetDelay() && each.getTrigger()->isSetPersistent() && !each.getTrigger()->getPersistent()) {
                throw unsupported("a delay that the trigger of " + name + " may end");
            }
            if (each.getTrigger()->isSetInitialValue() && !each.getTrigger()->getInitialValue()) {
                throw unsupported(name + ", which may happen at the initial time");
            }
            for (unsigned int k = 0; k < each.getNumEventAssignments(); ++k) {
                quantity& of = quantity_of(each.getEventAssignment(k)->getVariable());
                of.how = of.how == change::never ? change::by_events : of.how;
            }
        }
    }

    // What algebraic rules contain, may vary and has no other rule.
    void find_algebraic_unknowns() {
        std::size_t rules = 0;
        std::size_t found = 0;
        for (unsigned int i = 0; i < model_.getNumRules(); ++i) {
            const Rule& each = *model_.getRule(i);
            if (each.isAlgebraic()) {
                ++rules;
                formula_of(*each.getMath(), [&](const std::string& id, const occurrence&) {
                    const auto at = quantities_.find(id);
                    if (at != quantities_.end() && at->second.how == change::never && may_vary(id, at->second)) {
                        at->second.how = change::by_algebra;
                        ++found;
                    }
                    return formula{id};
                });
            }
        }
        if (found != rules) {
            throw unsupported(
                fmt::format("{} algebraic rules for {} quantities that no other rule determines", rules, found));
        }
    }

    bool may_vary(const std::string& id, const quantity& of) const {
        const Parameter* const parameter = model_.getParameter(id);
        const Compartment* const compartment = model_.getCompartment(id);
        return (of.species != nullptr && !of.species->getConstant()) ||
               (parameter != nullptr && !parameter->getConstant()) ||
               (compartment != nullptr && !compartment->getConstant());
    }

    // The amount of a species without reactions is constant, but not its concentration in a volume that varies.
    void find_diluted_species() {
        for (auto& [id, of] : quantities_) {
            if (of.species != nullptr && of.how == change::never && is_concentration(of) && !in_constant_volume(of)) {
                of.how = change::by_reactions;
            }
        }
    }

    // A formula at any time.
    formula now(const ASTNode& e, const occurrence& at = {}) {
        return formula_of(
            e, [this](const std::string& id, const occurrence& where) { return meaning(id, where); }, "t", at);
    }

    formula meaning(const std::string& id, const occurrence& at) {
        const auto found = quantities_.find(id);
        if (at.in_delay && (found == quantities_.end() || found->second.how != change::never)) {
            throw unsupported("a delay that varies");
        }
        return at.delay.empty() ? formula{names_.of(id)} : earlier(id, at);
    }

    // The value of a name at an earlier time.
    formula earlier(const std::string& id, const occurrence& at) {
        const auto found = quantities_.find(id);
        if (found == quantities_.end()) {
            const Reaction* const reaction = model_.getReaction(id);
            if (reaction == nullptr) {
                throw unsupported("the name '" + id + "' with a delay");
            }
            return now(*reaction->getKineticLaw()->getMath(), at);
        }
        const quantity& of = found->second;
        switch (of.how) {
            case change::never: return {names_.of(id)};
            case change::by_assignment: return now(*of.formula, at);
            case change::by_reactions:
                if (is_concentration(of) && !in_constant_volume(of)) {
                    throw unsupported("a delayed concentration in a compartment that varies");
                }
                break;
            case change::by_rate: break;
            case change::by_events:
            case change::by_algebra:
                throw unsupported("a delay of '" + id + "', which events or algebraic rules determine");
        }
        delayed_.insert(names_.of(id));
        return {fmt::format("{}(t - {})", names_.of(id), at.delay)};
    }

    // A formula at the initial time, before which everything is as it is then.
    formula at_start(const ASTNode& e) {
        return formula_of(
            e, [this](const std::string& id, const occurrence&) { return initial(id); }, "0");
    }

    // The initial value in terms of constants of the model.
    formula initial(const std::string& id) {
        const auto found = quantities_.find(id);
        if (found == quantities_.end()) {
            const Reaction* const reaction = model_.getReaction(id);
            if (reaction == nullptr) {
                throw unsupported("the name '" + id + "' in an initial value");
            }
            return at_start(*reaction->getKineticLaw()->getMath());
        }
        if (found->second.how == change::never) {
            return {names_.of(id)};
        }
        if (!open_.insert(id).second) {
            throw unsupported("initial values that depend on each other, as that of '" + id + "'");
        }
        formula value = initial_value(id, found->second);
        open_.erase(id);
        return value;
    }

    formula initial_value(const std::string& id, const quantity& of) {
        if (of.how == change::by_assignment) {
            return at_start(*of.formula);
        }
        if (const InitialAssignment* const assigned = model_.getInitialAssignment(id); assigned != nullptr) {
            return at_start(*assigned->getMath());
        }
        if (!of.value) {
            throw incomplete("no initial value of '" + id + "'",
                             of.species != nullptr ? "add initialConcentration or initialAmount to the species"
                                                   : "add its value or size to the model");
        }
        formula number{decimal_of(*of.value), *of.value < 0 ? binding::sum : binding::name};
        if (of.species == nullptr) {
            return number;
        }
        const formula volume = initial(of.species->getCompartment());
        if (of.species->isSetInitialAmount() && is_concentration(of)) {
            return {number.within(binding::product) + "/" + volume.within(binding::power), binding::product};
        }
        if (!of.species->isSetInitialAmount() && !is_concentration(of)) {
            return {number.within(binding::product) + "*" + volume.within(binding::power), binding::product};
        }
        return number;
    }

    static bool is_concentration(const quantity& of) { return !of.species->getHasOnlySubstanceUnits(); }

    bool in_constant_volume(const quantity& of) const {
        return quantities_.at(of.species->getCompartment()).how == change::never;
    }

    void write(const std::string& id, const quantity& of) {
        const std::string name = names_.of(id);
        switch (of.how) {
            case change::never: return write_constant(id, of);
            case change::by_assignment: definitions_ += fmt::format("{} = {}\n", name, now(*of.formula).text); return;
            case change::by_rate: return write_unknown(name, now(*of.formula).text, initial(id).text);
            case change::by_events: return write_unknown(name, "0", initial(id).text);
            case change::by_reactions: return write_species(id, of);
            case change::by_algebra: return;  // its initial value follows from the algebraic equations
        }
    }

    void write_constant(const std::string& id, const quantity& of) {
        const bool assigned = model_.getInitialAssignment(id) != nullptr;
        if (!assigned && !of.value) {
            return;  // an open parameter
        }
        definitions_ += fmt::format("{} = {}\n", names_.of(id), initial_value(id, of).text);
    }

    void write_unknown(const std::string& name, const std::string& slope, const std::string& start) {
        equations_ += fmt::format("{}' = {}\n", name, slope);
        starts_.emplace_back(name, start);
    }

    void write_species(const std::string& id, const quantity& of) {
        std::string sum;
        for (const auto& [reaction, times] : of.reactions) {
            const double size = times < 0 ? -times : times;
            sum += times < 0 ? (sum.empty() ? "-" : " - ") : sum.empty() ? "" : " + ";
            sum += (size == 1 ? "" : decimal_of(size) + "*") + names_.of(reaction);
        }
        sum = sum.empty() ? "0" : sum;
        const std::string name = names_.of(id);
        const std::string volume = names_.of(of.species->getCompartment());
        if (!is_concentration(of)) {
            return write_unknown(name, sum, initial(id).text);
        }
        if (in_constant_volume(of)) {
            return write_unknown(name, fmt::format("({})/{}", sum, volume), initial(id).text);
        }
        const std::string amount = names_.of("amount_" + id);
        write_unknown(
            amount, sum,
            initial(id).within(binding::product) + "*" + initial(of.species->getCompartment()).within(binding::power));
        definitions_ += fmt::format("{} = {}/{}\n", name, amount, volume);
    }

    void write_event(const Event& of) {
        const auto name = [this](const std::string& id, const occurrence& where) { return meaning(id, where); };
        const std::string trigger = condition_of(*of.getTrigger()->getMath(), name);
        if (of.isSetDelay() && of.getDelay()->getMath() != nullptr) {
            return write_delayed_event(of, trigger);
        }
        events_ += fmt::format("when {}:", trigger);
        for (unsigned int k = 0; k < of.getNumEventAssignments(); ++k) {
            const EventAssignment& each = *of.getEventAssignment(k);
            events_ += fmt::format("{} {} = {}", k == 0 ? "" : ";", changed_by_event(each), now(*each.getMath()).text);
        }
        events_ += "\n";
    }

    const std::string& changed_by_event(const EventAssignment& of) {
        const quantity& changed = quantities_.at(of.getVariable());
        if (changed.species != nullptr && changed.how == change::by_reactions && is_concentration(changed) &&
            !in_constant_volume(changed)) {
            throw unsupported("an event for a species in a compartment that varies");
        }
        return names_.of(of.getVariable());
    }

    // Further unknowns, which events alone change: the time of execution, set by the trigger, and, if they are those at the trigger,
    // the assigned values. The solution ends where the trigger holds again before.
    void write_delayed_event(const Event& of, const std::string& trigger) {
        const std::string execution = names_.free("execution_" + (of.isSetId() ? of.getId() : std::string("of_event")));
        const std::string waiting = names_.free("waiting_" + (of.isSetId() ? of.getId() : std::string("event")));
        write_unknown(execution, "0", "-1");
        write_unknown(waiting, "0", "0");
        std::string at_trigger = fmt::format("when {}: {} = t + {}; {} = {} + 1", trigger, execution,
                                             now(*of.getDelay()->getMath()).within(binding::product), waiting, waiting);
        std::string at_execution = fmt::format("when t = {} up: {} = 0", execution, waiting);
        const bool keeps_values = !of.isSetUseValuesFromTriggerTime() || of.getUseValuesFromTriggerTime();
        for (unsigned int k = 0; k < of.getNumEventAssignments(); ++k) {
            const EventAssignment& each = *of.getEventAssignment(k);
            std::string value = now(*each.getMath()).text;
            if (keeps_values) {
                const std::string kept = names_.free(fmt::format("{}_{}", names_.of(each.getVariable()), execution));
                write_unknown(kept, "0", "0");
                at_trigger += fmt::format("; {} = {}", kept, value);
                value = kept;
            }
            at_execution += fmt::format("; {} = {}", changed_by_event(each), value);
        }
        events_ += fmt::format("{}\n{}\nwhen ({}) and {} > 1/2: stop\n", at_trigger, at_execution, trigger, waiting);
    }

    Model& model_;
    problem_names names_;
    std::vector<std::string> order_;  // of the quantities, as in the model
    std::map<std::string, quantity> quantities_;
    std::set<std::string> open_;     // initial values being computed
    std::set<std::string> delayed_;  // the unknowns with delays
    std::vector<std::pair<std::string, std::string>> starts_;
    std::string equations_, definitions_, events_;
};

}  // namespace

std::string model_text(Model& model) { return model_reader(model).text(); }

}  // namespace libration::import

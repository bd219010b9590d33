#include "expansion.hpp"

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "formula.hpp"

namespace libration::import {

namespace {

constexpr int deepest_call = 100;

using owned_node = std::unique_ptr<ASTNode>;
using arguments = std::map<std::string, const ASTNode*>;
using changed_formula = std::function<owned_node(const ASTNode&)>;

template <class Element>
void rewrite(Element* of, const changed_formula& by) {
    if (of != nullptr && of->getMath() != nullptr) {
        const owned_node made = by(*of->getMath());
        of->setMath(made.get());
    }
}

// Of each element that has one, except function definitions.
void change_formulas(Model& model, const changed_formula& by) {
    for (unsigned int i = 0; i < model.getNumRules(); ++i) {
        rewrite(model.getRule(i), by);
    }
    for (unsigned int i = 0; i < model.getNumReactions(); ++i) {
        rewrite(model.getReaction(i)->getKineticLaw(), by);
    }
    for (unsigned int i = 0; i < model.getNumInitialAssignments(); ++i) {
        rewrite(model.getInitialAssignment(i), by);
    }
    for (unsigned int i = 0; i < model.getNumEvents(); ++i) {
        Event& each = *model.getEvent(i);
        rewrite(each.getTrigger(), by);
        rewrite(each.getDelay(), by);
        rewrite(each.getPriority(), by);
        for (unsigned int k = 0; k < each.getNumEventAssignments(); ++k) {
            rewrite(each.getEventAssignment(k), by);
        }
    }
}

owned_node with_children(const ASTNode& e, const changed_formula& of_child) {
    owned_node made(e.deepCopy());
    for (unsigned int i = 0; i < e.getNumChildren(); ++i) {
        made->replaceChild(i, of_child(*e.getChild(i)).release(), true);
    }
    return made;
}

owned_node substituted(const ASTNode& e, const arguments& by) {
    const auto found = e.getType() == AST_NAME ? by.find(e.getName()) : by.end();
    return found != by.end() ? owned_node(found->second->deepCopy())
                             : with_children(e, [&](const ASTNode& child) { return substituted(child, by); });
}

owned_node expanded(const ASTNode& e, const Model& model, int depth) {
    owned_node made = with_children(e, [&](const ASTNode& child) { return expanded(child, model, depth); });
    if (e.getType() != AST_FUNCTION) {
        return made;
    }
    const std::string name = e.getName();
    const FunctionDefinition* const of = model.getFunctionDefinition(name);
    if (of == nullptr || of->getBody() == nullptr || of->getNumArguments() != made->getNumChildren()) {
        throw unsupported("the function '" + name + "', which has no definition with so many arguments");
    }
    if (depth == deepest_call) {
        throw unsupported("the function '" + name + "', which calls itself");
    }
    arguments by;
    for (unsigned int i = 0; i < of->getNumArguments(); ++i) {
        by.emplace(of->getArgument(i)->getName(), made->getChild(i));
    }
    return expanded(*substituted(*of->getBody(), by), model, depth + 1);
}

bool is_open(const ASTNode& e) {
    bool open = e.getType() == AST_FUNCTION_PIECEWISE && e.getNumChildren() % 2 == 0;
    for (unsigned int i = 0; i < e.getNumChildren(); ++i) {
        open = open || is_open(*e.getChild(i));
    }
    return open;
}

}  // namespace

void expand_functions(Model& model) {
    change_formulas(model, [&](const ASTNode& e) { return expanded(e, model, 0); });
}

void promote_local_parameters(Model& model) {
    for (unsigned int i = 0; i < model.getNumReactions(); ++i) {
        const Reaction& reaction = *model.getReaction(i);
        KineticLaw* const law = model.getReaction(i)->getKineticLaw();
        while (law != nullptr && law->getNumParameters() > 0) {
            const std::unique_ptr<Parameter> local(model.getLevel() > 2 ? law->removeLocalParameter(0U)
                                                                        : law->removeParameter(0U));
            std::string name = reaction.getId() + "_" + local->getId();
            while (model.getElementBySId(name) != nullptr) {
                name += "_";
            }
            rewrite(law, [&](const ASTNode& e) {
                owned_node made(e.deepCopy());
                made->renameSIdRefs(local->getId(), name);
                return made;
            });
            Parameter& own = *model.createParameter();
            own.setId(name);
            own.setConstant(true);
            if (local->isSetValue()) {
                own.setValue(local->getValue());
            }
            if (local->isSetUnits()) {
                own.setUnits(local->getUnits());
            }
        }
    }
}

bool has_open_piecewise(Model& model) {
    bool found = false;
    change_formulas(model, [&](const ASTNode& e) {
        found = found || is_open(e);
        return owned_node(e.deepCopy());
    });
    return found;
}

}  // namespace libration::import

// The known facts about each problem: one function per file of known/. A new one is declared here and named in
// known_facts.cpp.
#pragma once

#include "libration/problem/known_facts.hpp"

namespace libration {

known_facts facts_of_blasius();
known_facts facts_of_falkner_skan();
known_facts facts_of_flierl_petviashvili();
known_facts facts_of_kepler();
known_facts facts_of_painleve_1();
known_facts facts_of_pendulum();
known_facts facts_of_rayleigh();
known_facts facts_of_sakiadis();
known_facts facts_of_seir();
known_facts facts_of_sir();
known_facts facts_of_sir_japan();
known_facts facts_of_thomas_fermi();

}  // namespace libration

// The radius of convergence and the nearest singularities from a list of coefficients: start with verdict_on(), or with
// report_on_radius() for the classical tests of coefficients that are scaled to their unit.
#pragma once

#include "libration/convergence/coefficient_list.hpp"
#include "libration/convergence/coefficient_unit.hpp"
#include "libration/convergence/radius_report.hpp"
#include "libration/convergence/verdict.hpp"

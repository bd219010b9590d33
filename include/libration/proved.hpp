// The public interface of the target libration::proved: everything in libration.hpp, and proved arithmetic.
#pragma once

#include "libration/approximant/proved/approximant.hpp"
#include "libration/digits/proved/digits.hpp"
#include "libration/elliptic/proved/elliptic.hpp"
#include "libration/function/ball/values.hpp"
#include "libration/libration.hpp"
#include "libration/ode/proved/ode.hpp"
#include "libration/pendulum/proved/pendulum.hpp"
#include "libration/problem/known/proved/blasius.hpp"
#include "libration/problem/known/proved/falkner_skan.hpp"
#include "libration/problem/known/proved/painleve_1.hpp"
#include "libration/problem/known/proved/sakiadis.hpp"
#include "libration/problem/known/proved/sir.hpp"
#include "libration/problem/known/proved/thomas_fermi.hpp"
#include "libration/scalar/ball/ball.hpp"
#include "libration/scalar/ball/decimal.hpp"

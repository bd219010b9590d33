# cmake -D TYPE=file -D INCLUDE= -D COMPILER= -D WORK= [-D FLAGS=] -P check_missing_operation.cmake
# Compiles a number type without one of its operations at a time: each must be rejected, with a message that names the
# concept and the operation.

file(READ ${TYPE} whole)
file(MAKE_DIRECTORY ${WORK})
separate_arguments(FLAGS)

# Without the lines that contain `removed`; `expected` is a regular expression of the message.
function(check removed expected)
    string(REGEX REPLACE "\n[^\n]*${removed}[^\n]*" "" type "${whole}")
    if(type STREQUAL whole)
        message(FATAL_ERROR "${TYPE} has no line with ${removed}")
    endif()
    file(WRITE ${WORK}/lacking.cpp "${type}\n"
        "static_assert(libration::closed_form_scalar<counting> && libration::ordered_scalar<counting>);\n")
    execute_process(
        COMMAND ${COMPILER} -std=c++20 -fsyntax-only ${FLAGS} -I${INCLUDE} ${WORK}/lacking.cpp
        RESULT_VARIABLE failed ERROR_VARIABLE said)
    if(NOT failed)
        message(FATAL_ERROR "compiles without ${removed}")
    elseif(NOT said MATCHES "${expected}")
        message(FATAL_ERROR "without ${removed} the message does not match ${expected}:\n${said}")
    endif()
endfunction()

check("friend counting cos" "scalar.*cos ?\\(")
check("friend counting atan2" "closed_form_scalar.*atan2 ?\\(")
check("operator<=>.counting a, int" "ordered_scalar.*x ?< ?n")
check("static counting pi" "scalar.*pi ?\\(")

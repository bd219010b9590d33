# Completion of the command libration in bash, loaded by bash-completion or by `source`. All words are the program's own:
# it is asked for its help, its studies and its problems.

# The words that one of its options takes, where its help names them: NAMES|NAMES, or a list of them.
_libration_words() { # HELP OPTION
    local line type
    line=$(sed -n "s/^  \([^ ]*,\)\{0,1\}$2\(,[^ ]*\)\{0,1\} //p" <<<"$1")
    type=${line%% *}
    case $2,$type in
        *'|'*) tr '|' '\n' <<<"${type%%=*}" ;;
        --format,* | --scalar,*)
            line=${line#"$type"}
            tr -s ' ' '\n' <<<"${line%%;*}" | sed -n 's/^\([a-z][a-z-]*\),\{0,1\}$/\1/p' | grep -vx or
            ;;
    esac
}

# The names of studies or of problems: the first words of the lines that are not indented, but for the header.
_libration_names() { # PROGRAM studies|problems
    "$1" "$2" | sed -n '/^name  /d; s/^\([a-z][^ ]*\).*/\1/p' | sort -u
}

_libration() { # PROGRAM
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command=${COMP_WORDS[1]} help words=
    if [[ $word == '=' ]]; then # --format=
        word=
    elif [[ $before == '=' ]]; then # --format=c
        before=${COMP_WORDS[COMP_CWORD - 2]}
    fi
    COMPREPLY=()
    if ((COMP_CWORD == 1)); then
        command=
    fi
    # Continued lines are joined.
    help=$("$1" ${command:+"$command"} --help 2>/dev/null | sed -e ':a' -e '$!N;s/\n \{20,\}/ /;ta' -e 'P;D') || return 0
    case $before,$word in
        *,-*) words=$(sed -n 's/^  \(-.,\)\{0,1\}\(--[^ ]*\).*/\2/p' <<<"$help" | tr ',' '\n') ;;
        --problem,*) words=$(_libration_names "$1" problems) ;;
        --only,* | --skip,*) words=$(_libration_names "$1" studies) ;;
        --*) words=$(_libration_words "$help" "$before") ;;
        *)
            case $command in
                '') words=$(sed -n '/^Subcommands:/,$ s/^  \([a-z]*\) .*/\1/p' <<<"$help") ;;
                study | studies | figure) words=$(_libration_names "$1" studies) ;;
                problems) words=$(_libration_names "$1" problems) ;;
                elliptic | table)
                    words=$(sed -n 's/^  function FUNCTION REQUIRED //p; s/^  what \(pendulum\)|FUNCTION .*:/\1/p' <<<"$help" | tr ',' ' ')
                    ;;
            esac
            ;;
    esac
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
}

complete -o bashdefault -o default -F _libration libration

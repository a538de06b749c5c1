# SPDX-License-Identifier: MIT
# Completion of nakawari for bash. Commands and options are those that --help prints.
_nakawari()
{
    local current=${COMP_WORDS[COMP_CWORD]} command=${COMP_WORDS[1]} program=${COMP_WORDS[0]}
    COMPREPLY=()
    if [ "$COMP_CWORD" -eq 1 ]; then
        COMPREPLY=($(compgen -W "$("$program" --help 2>/dev/null | sed -n 's/^  \([a-z]*\) .*/\1/p') --help --version" -- \
            "$current"))
    elif [[ $current == -* ]]; then
        COMPREPLY=($(compgen -W "$("$program" "$command" --help 2>/dev/null |
            sed -nE '/^$/q; s/^  (-., |    )(--[a-z-]+).*/\2/p')" \
            -- "$current"))
    else
        COMPREPLY=($(compgen -f -- "$current"))
    fi
}
complete -o filenames -F _nakawari nakawari

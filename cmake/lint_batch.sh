#!/usr/bin/env bash
# clang-tidy over several sources as if they were one: it goes through all headers of each, so eight take as long as two
# that way. Names in their anonymous namespaces have to be different. They become one text, not a list of includes, as some
# checks only look at the main file. What may be missed: an include that another source of the batch has, and a
# using-declaration that only another one uses. Warnings have to be errors in CONFIGURATION, else they are not seen.
#
#   lint_batch.sh STAMP CLANG CLANG_TIDY CONFIGURATION FLAGS... -- SOURCES...
#
# writes STAMP.cpp and its dependencies STAMP.d; STAMP only if nothing was found.
set -euo pipefail
stamp=$1 clang=$2 tidy=$3 configuration=$4
shift 4
flags=()
while [[ $1 != -- ]]; do flags+=("$1"); shift; done
shift
cat "$@" >"$stamp.cpp"
"$clang" "${flags[@]}" -MM -MQ "$stamp" -MF "$stamp.d" "$stamp.cpp"
status=0
found=$("$tidy" --quiet --config-file="$configuration" "$stamp.cpp" -- "${flags[@]}" 2>&1) || status=$?
((status)) || { touch "$stamp"; exit 0; }
# Where it is in the sources.
awk -v batch="$stamp.cpp:" '
  FNR == 1 { file++ }
  file < ARGC - 1 { name[++lines] = FILENAME; line[lines] = FNR; next }
  index($0, batch) == 1 { rest = substr($0, length(batch) + 1); n = rest + 0; if (n > lines) n = lines; sub(/^[0-9]+/, "", rest); $0 = name[n] ":" line[n] rest }
  { print }' "$@" - <<<"$found"
exit "$status"

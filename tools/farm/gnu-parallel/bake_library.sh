#!/bin/bash
# A library over the computers that GNU parallel reaches, then the check of the result:
#   bake_library.sh LIBRARY OUTPUT SHARDS [OPTION of splitsum-bake]...
# PARALLEL holds options of parallel: two shards at a time here and four on another computer, which
# sees both folders under the same names, are
#   PARALLEL='--sshlogin 2/:,4/render1' bake_library.sh /shared/hdris /shared/baked 64 --threads 4
# A shard that fails is tried again, on another computer if there is one.
set -eu
if (($# < 3)); then
    sed -n '2,7s/^# \?//p' "$0" >&2
    exit 2
fi
library=$1
output=$2
shards=$3
shift 3

# --halt never, and no end after a failure: the other shards are baked, and the check has the last word.
parallel --quote --will-cite --retries 3 --halt never \
    splitsum-bake "$library" -o "$output" --shard "{}/$shards" "$@" ::: $(seq "$shards") || true
exec splitsum-bake "$library" -o "$output" --merge "$@"

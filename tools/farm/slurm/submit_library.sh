#!/bin/bash
# Submits a library as a job array, and the job that checks the result when all of it has ended:
#   submit_library.sh LIBRARY OUTPUT SHARDS [OPTION of splitsum-bake]...
# Prints the numbers of the array and of the check. sbatch reads more settings from the environment:
#   SBATCH_PARTITION=long submit_library.sh /shared/hdris /shared/baked 64 --size 512
set -eu
if (($# < 3)); then
    sed -n '2,5s/^# \?//p' "$0" >&2
    exit 2
fi
recipes=$(dirname -- "$(readlink -f -- "$0")")
library=$1
output=$2
shards=$3
shift 3

array=$(sbatch --parsable --array="1-$shards" "$recipes/bake_library.sbatch" "$library" "$output" "$@")
# afterany: where a panorama has failed the check is what says so.
merge=$(sbatch --parsable --dependency="afterany:${array%%;*}" \
    "$recipes/merge_library.sbatch" "$library" "$output" "$@")
printf '%s %s\n' "${array%%;*}" "${merge%%;*}"

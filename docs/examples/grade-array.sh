#!/bin/sh
# A course as a job array of Slurm. From this project's folder, with the submissions in $HOME/submissions:
#
#     ./cga doctor                                  once, so that the program is built
#     sbatch docs/examples/grade-array.sh           a job that was killed may be submitted again: it goes on
#     ./cga grade --merge "$HOME"/results/* --out "$HOME"/course
#
#SBATCH --array=1-8
#SBATCH --cpus-per-task=2
#SBATCH --mem=4G
#SBATCH --time=01:00:00
set -eu

exec ./cga grade "$HOME"/submissions/* --out "$HOME/results/$SLURM_ARRAY_TASK_ID" \
    --shard "$SLURM_ARRAY_TASK_ID/${SLURM_ARRAY_TASK_COUNT:-8}" --jobs 2 --resume

package cga.grading.pipeline

import cga.grading.sandbox.Limits

/**
 * How much each step of a submission may use; see [Limits].
 *
 * @param prepare of reading what was handed in: an honest one takes 0.3 s; what may be unpacked and copied is bounded by itself.
 * @param compile measured: the course's own 3300 lines take 6 s of processor time and 400 MB.
 * @param run of the submission itself: an honest one takes about 3 s and 450 MB.
 * @param measure of its shaders: about 5 s and 430 MB, the expected pictures included.
 */
public class PipelineLimits(
    public val prepare: Limits = Limits(wallSeconds = 60.0, cpuSeconds = 60.0, diskBytes = 1280L shl 20, diskEntries = 60_000),
    public val compile: Limits = Limits(wallSeconds = 120.0, cpuSeconds = 180.0),
    public val run: Limits = Limits(wallSeconds = 60.0, cpuSeconds = 60.0),
    public val measure: Limits = Limits(wallSeconds = 120.0, cpuSeconds = 120.0),
)

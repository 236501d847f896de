package cga.grading.sandbox

/**
 * How much a job may use before its whole tree of processes is killed.
 *
 * @param wallSeconds from the start to the end, without what it waits for processors that others have; at most eight times as much.
 * @param cpuSeconds of all processes together.
 * @param memoryBytes resident memory of all processes together.
 * @param tasks processes and threads together.
 * @param diskBytes in the scratch folder, deleted but still open files included; [diskEntries] files and folders in it.
 * @param outputBytes of standard output and standard error together, of which [keptBytes] each are kept.
 * @param temporaryBytes in the job's private `/tmp`.
 * @param lookSeconds from one look at what it uses to the next: for that long it may go past a limit.
 */
public class Limits(
    public val wallSeconds: Double = 60.0,
    public val cpuSeconds: Double = 120.0,
    public val memoryBytes: Long = 1536L shl 20,
    public val tasks: Int = 256,
    public val diskBytes: Long = 256L shl 20,
    public val diskEntries: Int = 5000,
    public val outputBytes: Long = 16L shl 20,
    public val keptBytes: Int = 64 shl 10,
    public val temporaryBytes: Long = 128L shl 20,
    public val lookSeconds: Double = 0.05,
) {
    init {
        require(wallSeconds > 0 && cpuSeconds > 0 && lookSeconds > 0) {
            "no time: wallSeconds = $wallSeconds, cpuSeconds = $cpuSeconds, lookSeconds = $lookSeconds"
        }
        require(minOf(memoryBytes, diskBytes, outputBytes, temporaryBytes) > 0 && tasks > 0 && diskEntries > 0 && keptBytes >= 0) {
            "nothing allowed: memory $memoryBytes, disk $diskBytes ($diskEntries entries), output $outputBytes ($keptBytes kept), " +
                "/tmp $temporaryBytes, tasks $tasks"
        }
    }
}

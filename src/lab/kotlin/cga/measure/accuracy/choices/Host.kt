package cga.measure.accuracy.choices

import java.io.File
import java.lang.management.ManagementFactory

/** What decides how fast this machine is; no names of hosts and no paths. */
internal object Host {
    /** One sentence's beginning: processor, what drew, Java. */
    fun describe(
        renderer: String,
        version: String,
    ): String {
        val mesa = Regex("""Mesa \S+""").find(version)?.value ?: version
        return "${processor()}, ${Runtime.getRuntime().availableProcessors()} processors, $renderer, $mesa, " +
            "JDK ${System.getProperty("java.version")} on ${System.getProperty("os.name")} ${System.getProperty("os.arch")}"
    }

    /** How many processes want to run, on the mean of the last minute; measured beside others, times are long and their spread wide. */
    fun load(): String {
        val load = ManagementFactory.getOperatingSystemMXBean().systemLoadAverage
        return if (load < 0) "unknown" else "%.1f".format(null, load)
    }

    private fun processor(): String {
        val info = File("/proc/cpuinfo").takeIf { it.canRead() }?.readText().orEmpty()
        return Regex("""(?m)^model name\s*: (.*)$""").find(info)?.groupValues?.get(1) ?: "processor of unknown model"
    }
}

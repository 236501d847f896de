package cga.grading.sandbox

import kotlin.io.path.Path
import kotlin.io.path.exists
import kotlin.io.path.readText

/** Why bubblewrap cannot make a sandbox although it is installed, as far as the system tells. */
internal object Forbidden {
    private const val CONTAINER_OPTIONS =
        "--cap-add SYS_ADMIN --cap-add NET_ADMIN --security-opt seccomp=unconfined --security-opt apparmor=unconfined " +
            "--security-opt systempaths=unconfined"

    private val MARKS_OF_CONTAINERS = listOf("/.dockerenv", "/run/.containerenv")

    /** The kernel's settings that forbid user namespaces, by name: what they must be, and a value that is. */
    private val SETTINGS = listOf(
        Setting("kernel.apparmor_restrict_unprivileged_userns", cure = 0) { it == 0 },
        Setting("kernel.unprivileged_userns_clone", cure = 1) { it != 0 },
        Setting("user.max_user_namespaces", cure = 10_000) { it > 0 },
    )

    private class Setting(
        val name: String,
        val cure: Int,
        val allows: (Int) -> Boolean,
    )

    /** The causes, each with its cure. */
    fun causes(
        value: (String) -> Int? = ::kernelsOwn,
        isContainer: Boolean = MARKS_OF_CONTAINERS.any { Path(it).exists() },
    ): String {
        val forbidding = SETTINGS.filterNot { setting -> value(setting.name)?.let(setting.allows) ?: true }
        val kernel = forbidding.map { "${it.name} = ${value(it.name)} forbids user namespaces: type sudo sysctl -w ${it.name}=${it.cure}." }
        val container = "${if (isContainer) "Start this container" else "If this is a container, start it"} with $CONTAINER_OPTIONS."
        return (kernel + listOfNotNull(container.takeIf { isContainer || kernel.isEmpty() })).joinToString(" ")
    }

    private fun kernelsOwn(name: String): Int? =
        runCatching { Path("/proc/sys/${name.replace('.', '/')}").readText().trim().toInt() }.getOrNull()
}

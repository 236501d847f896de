package cga.grading.sandbox

import kotlin.io.path.Path
import kotlin.io.path.exists
import kotlin.io.path.readText

/** What keeps bubblewrap from making a sandbox where it is installed, as far as the system tells. */
internal object Forbidden {
    private val IN_CONTAINER = listOf("/.dockerenv", "/run/.containerenv")

    /** What the kernel's settings must be. Who is root in a container cannot change them there. */
    private val SETTINGS = listOf(
        "kernel.apparmor_restrict_unprivileged_userns" to 0..0,
        "kernel.unprivileged_userns_clone" to 1..1,
        "user.max_user_namespaces" to 1..Int.MAX_VALUE,
    )

    /** A sentence or two with the cure. */
    fun cause(): String {
        val wrong = SETTINGS.filter { (name, right) -> setting(name)?.let { it !in right } ?: false }
        val sentences = wrong.map { (name, right) ->
            "The kernel forbids user namespaces ($name = ${setting(name)}): on the machine itself type sudo sysctl -w $name=${maxOf(right.first, 0)}."
        }
        val container = "This is a container that forbids it: start it with $CONTAINER_OPTIONS."
        val all = sentences + listOfNotNull(container.takeIf { IN_CONTAINER.any { Path(it).exists() } })
        return all.ifEmpty { listOf("In a container: start it with $CONTAINER_OPTIONS.") }.joinToString(" ")
    }

    private fun setting(name: String): Int? =
        runCatching { Path("/proc/sys", *name.split(".").toTypedArray()).readText().trim().toInt() }.getOrNull()

    /** What bubblewrap needs as root: namespaces and mounts, and the network of its own to be set up. */
    const val CONTAINER_OPTIONS: String =
        "--cap-add SYS_ADMIN --cap-add NET_ADMIN --security-opt seccomp=unconfined --security-opt apparmor=unconfined"
}

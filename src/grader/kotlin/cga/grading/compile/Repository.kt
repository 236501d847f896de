package cga.grading.compile

import cga.framework.AtomicFile
import java.io.IOException
import java.net.URI
import java.net.http.HttpClient
import java.net.http.HttpRequest
import java.net.http.HttpResponse.BodyHandlers
import java.nio.file.Files
import java.nio.file.Path
import java.security.MessageDigest
import java.time.Duration
import kotlin.io.path.exists
import kotlin.io.path.isRegularFile
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.readText
import kotlin.io.path.writeBytes

/**
 * Libraries from Maven Central: taken from where Maven and Gradle keep theirs when there, downloaded to [cache] otherwise. Downloads are
 * checked against the checksum beside them. Safe to use from several threads.
 *
 * @param base null to work offline.
 * @param home whose `.m2` and `.gradle` are looked into.
 */
public class Repository(
    private val cache: Path,
    private val base: URI? = defaultBase(),
    home: Path = Path.of(System.getProperty("user.home")),
) {
    private val maven = System.getProperty("maven.repo.local")?.let(Path::of) ?: home.resolve(".m2/repository")
    private val gradle = home.resolve(".gradle/caches/modules-2/files-2.1")
    private val client by lazy {
        HttpClient
            .newBuilder()
            .followRedirects(
                HttpClient.Redirect.NORMAL,
            ).connectTimeout(PATIENCE)
            .proxy(java.net.ProxySelector.getDefault())
            .build()
    }

    /** The jar of [artifact]. Throws [LibraryUnavailable]. */
    public fun jar(artifact: Artifact): Path = file(artifact, "jar")

    /** The jars of [artifact] and of all that it needs at run time, itself first. Throws [LibraryUnavailable]. */
    public fun jars(artifact: Artifact): List<Path> {
        val chosen = LinkedHashMap<Pair<String, String>, Artifact>()
        var level = listOf(Dependency(artifact, isAlone = false))
        // The version nearest to the root wins, as in Maven.
        while (level.isNotEmpty()) {
            if (chosen.size > MOST) throw LibraryUnavailable("$artifact needs more than $MOST others.")
            val fresh = level.filter { chosen.putIfAbsent(it.artifact.group to it.artifact.name, it.artifact) == null }
            level = fresh.filterNot { it.isAlone }.flatMap { Pom.dependencies(file(it.artifact, "pom").readText(), it.artifact) }
        }
        return chosen.values.map(::jar)
    }

    /** What [artifact] has of native code for this machine; null where it has none. Throws [LibraryUnavailable]. */
    public fun natives(artifact: Artifact): Path? {
        val machine = if (System.getProperty("os.arch") == "aarch64") "natives-linux-arm64" else "natives-linux"
        return try {
            jar(artifact.copy(classifier = machine))
        } catch (e: LibraryUnavailable) {
            if (e.isUnknown) null else throw e
        }
    }

    /** All released versions of [name], as the repository lists them; none when offline. */
    public fun versions(group: String, name: String): List<String> {
        if (base == null) return emptyList()
        val list = download("${group.replace('.', '/')}/$name/maven-metadata.xml").decodeToString()
        return Regex("<version>([^<]+)</version>").findAll(list).map { it.groupValues[1] }.filter { RELEASE.matches(it) }.toList()
    }

    private fun file(artifact: Artifact, extension: String): Path =
        listOf(maven, cache).map { it.resolve(artifact.path(extension)) }.firstOrNull { it.isRegularFile() }
            ?: inGradle(artifact, extension) ?: fetch(artifact, extension)

    /** Gradle keeps each file in a folder named for its checksum. */
    private fun inGradle(artifact: Artifact, extension: String): Path? {
        val folder = gradle.resolve(artifact.group).resolve(artifact.name).resolve(artifact.version)
        if (!folder.exists()) return null
        return folder.listDirectoryEntries().map { it.resolve(artifact.fileName(extension)) }.firstOrNull { it.isRegularFile() }
    }

    private fun fetch(artifact: Artifact, extension: String): Path {
        val path = artifact.path(extension)
        val bytes = download(path)
        val (algorithm, expected) = checksum(path)
        val found = MessageDigest.getInstance(algorithm).digest(bytes).joinToString("") { "%02x".format(it) }
        if (found !=
            expected
        ) {
            throw LibraryUnavailable("${artifact.fileName(extension)} arrived broken: its $algorithm is $found, not $expected.")
        }
        val target = cache.resolve(path)
        Files.createDirectories(target.parent)
        AtomicFile.write(target) { it.writeBytes(bytes) }
        return target
    }

    /** The better of the two checksums that [path] has; old releases have SHA-1 only. */
    private fun checksum(path: String): Pair<String, String> =
        try {
            "SHA-256" to sum("$path.sha256")
        } catch (e: LibraryUnavailable) {
            if (!e.isUnknown) throw e
            "SHA-1" to sum("$path.sha1")
        }

    private fun sum(path: String) = download(path).decodeToString().trim().substringBefore(' ').lowercase()

    private fun download(path: String): ByteArray {
        val address =
            base?.resolve(path) ?: throw LibraryUnavailable("${path.substringAfterLast('/')} is not on this machine, and it is offline.")
        try {
            val answer = client.send(HttpRequest.newBuilder(address).timeout(PATIENCE).build(), BodyHandlers.ofInputStream())
            val body = answer.body().use { it.readNBytes(LARGEST + 1) }
            if (body.size > LARGEST) throw LibraryUnavailable("${path.substringAfterLast('/')} is larger than any library of use.")
            when (answer.statusCode()) {
                OK -> return body
                NOT_FOUND -> throw LibraryUnavailable("there is no ${path.substringAfterLast('/')} in the repository.", isUnknown = true)
                else -> throw LibraryUnavailable("${path.substringAfterLast('/')}: the repository answers ${answer.statusCode()}.")
            }
        } catch (e: IOException) {
            throw LibraryUnavailable("${path.substringAfterLast('/')} cannot be downloaded ($e): is the machine offline?", cause = e)
        }
    }

    /** Where Maven Central is. */
    public companion object {
        private const val CENTRAL = "https://repo.maven.apache.org/maven2/"
        private const val OK = 200

        /** Bytes: what is fetched may be of a submission's choice. The Kotlin compiler has 60 million. */
        private const val LARGEST = 200_000_000
        private const val MOST = 100
        private const val NOT_FOUND = 404
        private val PATIENCE: Duration = Duration.ofSeconds(120)
        private val RELEASE = Regex("""\d+(?:\.\d+)+""")

        /** Maven Central, or its mirror that the system property `cga.repository` names; null when that is `offline`. */
        public fun defaultBase(): URI? =
            System.getProperty("cga.repository", CENTRAL).takeIf { it != "offline" }?.let { URI(if (it.endsWith('/')) it else "$it/") }
    }
}

package cga.grading.compile

import cga.grading.prepared.NamedLibrary
import cga.testing.Slow
import com.sun.net.httpserver.HttpServer
import org.junit.jupiter.api.AfterEach
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.net.InetAddress
import java.net.InetSocketAddress
import java.net.URI
import java.nio.file.Path
import java.security.MessageDigest
import kotlin.io.path.createParentDirectories
import kotlin.io.path.exists
import kotlin.io.path.name
import kotlin.io.path.readText
import kotlin.io.path.writeText

/** Against a repository of our own on this machine. */
@Slow
class RepositoryTest {
    @TempDir
    lateinit var folder: Path

    private val served = HashMap<String, ByteArray>()
    private val asked = mutableListOf<String>()
    private val server = HttpServer.create(InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0).apply {
        createContext("/") { exchange ->
            val path = exchange.requestURI.path.removePrefix("/maven2/")
            asked += path
            val body = served[path]
            exchange.sendResponseHeaders(if (body == null) 404 else 200, if (body == null) -1 else body.size.toLong().coerceAtLeast(1))
            body?.let(exchange.responseBody::write)
            exchange.close()
        }
        start()
    }

    private val base = URI("http://127.0.0.1:${server.address.port}/maven2/")
    private val repository get() = Repository(folder.resolve("cache"), base, folder.resolve("home"))

    @AfterEach
    fun close() = server.stop(0)

    @Test
    fun `a library comes with what it needs, the nearest version of each, and is asked for once`() {
        serve(
            "g:a:1",
            needs("g:b:1", "g:c:2") + dependency("g:alone:1", ALONE) + dependency("g:test:1", "<scope>test</scope>") +
                dependency("g:maybe:1", "<optional>true</optional>"),
        )
        serve("g:b:1", needs("g:c:1", "g:d:\${project.version}"))
        serve("g:alone:1", needs("g:unwanted:1"))
        listOf("g:c:2", "g:d:1").forEach { serve(it, "") }
        assertEquals(
            listOf("a-1.jar", "b-1.jar", "c-2.jar", "alone-1.jar", "d-1.jar"),
            repository.jars(Artifact("g", "a", "1")).map { it.name },
        )
        assertEquals("jar of g:a:1", repository.jar(Artifact("g", "a", "1")).readText())
        val before = asked.size
        repository.jars(Artifact("g", "a", "1"))
        assertEquals(before, asked.size)
    }

    @Test
    fun `of the libraries that a build file names those come that are not there, LWJGL's in the version of ours`() {
        serve("g:a:1", needs("g:b:1", "org.joml:joml:1.9.2"))
        listOf("g:b:1", "org.joml:joml:1.9.2", "org.lwjgl:lwjgl-openal:3.4.3").forEach { serve(it, "") }
        val named = listOf(
            NamedLibrary("g", "a", "1"),
            NamedLibrary("org.lwjgl", "lwjgl-openal", "3.2.3"),
            NamedLibrary("org.lwjgl", "lwjgl-glfw", null),
            NamedLibrary("org.jetbrains.kotlin", "kotlin-stdlib-jdk8", "1.4.10"),
            NamedLibrary("g", "nowhere", "2"),
            NamedLibrary("../..", "up", "2"),
        )
        val ours = listOf("lwjgl-3.4.3.jar", "lwjgl-glfw-3.4.3.jar", "lwjgl-glfw-3.4.3-natives-linux.jar", "joml-1.10.9.jar")
        val found = FurtherLibraries.of(named, ours.map(Path::of), repository)
        assertEquals(listOf("a-1.jar", "b-1.jar", "lwjgl-openal-3.4.3.jar"), found.jars.map { it.name })
        assertEquals(listOf("nowhere", "up"), found.notes.map { it.removePrefix("The library ").substringBefore(' ') })
        // With native code for this machine where there is some.
        val machine = if (System.getProperty("os.arch") == "aarch64") "natives-linux-arm64" else "natives-linux"
        serveNatives("org.lwjgl:lwjgl-openal:3.4.3", machine)
        val jars = FurtherLibraries.of(named.take(2), ours.map(Path::of), repository).jars.map { it.name }
        assertEquals("lwjgl-openal-3.4.3-$machine.jar", jars.last())
    }

    @Test
    fun `what Maven and Gradle have is not downloaded`() {
        folder.resolve("home/.m2/repository/g/a/1/a-1.jar").createParentDirectories().writeText("Maven's")
        folder.resolve("home/.gradle/caches/modules-2/files-2.1/g/b/1/0123abc/b-1.jar").createParentDirectories().writeText("Gradle's")
        assertEquals("Maven's", repository.jar(Artifact("g", "a", "1")).readText())
        assertEquals("Gradle's", repository.jar(Artifact("g", "b", "1")).readText())
        assertEquals(emptyList<String>(), asked)
    }

    @Test
    fun `what arrives broken or without a checksum is not kept`() {
        serve("g:a:1", "")
        served["g/a/1/a-1.jar"] = "changed".toByteArray()
        assertTrue("arrived broken" in refusal("g:a:1").message.orEmpty())
        served -= "g/a/1/a-1.jar.sha1"
        assertFalse(folder.resolve("cache").toFile().walk().any { it.name == "a-1.jar" })
        refusal("g:a:1")
        assertFalse(folder.resolve("cache/g/a/1/a-1.jar").exists())
    }

    @Test
    fun `the better checksum counts where there is one`() {
        serve("g:a:1", "")
        served["g/a/1/a-1.jar.sha256"] = "0000  a-1.jar".toByteArray()
        assertTrue("SHA-256" in refusal("g:a:1").message.orEmpty())
    }

    @Test
    fun `a missing library, a missing machine and being offline are told apart`() {
        assertTrue(refusal("g:none:1").isUnknown)
        val dead = Repository(folder.resolve("cache"), URI("http://127.0.0.1:1/"), folder.resolve("home"))
        val unreachable = assertThrows(LibraryUnavailable::class.java) { dead.jar(Artifact("g", "a", "1")) }
        assertFalse(unreachable.isUnknown)
        val offline = Repository(folder.resolve("cache"), null, folder.resolve("home"))
        assertTrue("offline" in assertThrows(LibraryUnavailable::class.java) { offline.jar(Artifact("g", "a", "1")) }.message.orEmpty())
    }

    @Test
    fun `a version that is no version never becomes a path`() {
        for (version in listOf("../../x", "1/../2", "", "1.0?x", "a b")) {
            assertThrows(IllegalArgumentException::class.java) {
                Artifact("g", "a", version)
            }
        }
    }

    @Test
    fun `a project file with a document type is refused`() {
        serve("g:a:1", "")
        val evil = "<!DOCTYPE project [<!ENTITY x SYSTEM \"file:///etc/passwd\">]><project>&x;</project>".toByteArray()
        put("g/a/1/a-1.pom", evil)
        assertThrows(LibraryUnavailable::class.java) { repository.jars(Artifact("g", "a", "1")) }
    }

    @Test
    fun `a version that does not exist is replaced by the nearest that does`() {
        served["org/jetbrains/kotlin/kotlin-compiler-embeddable/maven-metadata.xml"] =
            "<metadata><versions>${listOf(
                "1.3.72",
                "1.9.0-RC",
                "1.9.24",
                "2.0.0",
            ).joinToString("") { "<version>$it</version>" }}</versions></metadata>"
                .toByteArray()
        assertEquals(listOf("1.3.72", "1.9.24", "2.0.0"), repository.versions("org.jetbrains.kotlin", "kotlin-compiler-embeddable"))
        assertEquals("1.9.24", CompilerCache.nearest("1.9.99", listOf("1.3.72", "1.9.24", "2.0.0")))
        assertEquals("1.3.72", CompilerCache.nearest("1.4", listOf("1.3.72", "1.9.24")))
        assertEquals(null, CompilerCache.nearest("1.4", emptyList()))
    }

    private fun refusal(name: String) = assertThrows(LibraryUnavailable::class.java) { repository.jar(artifact(name)) }

    private fun artifact(name: String) = name.split(':').let { (group, artifact, version) -> Artifact(group, artifact, version) }

    private fun needs(vararg names: String) = names.joinToString("") { dependency(it) }

    private fun dependency(name: String, more: String = ""): String {
        val (group, artifact, version) = name.split(':')
        return "<dependency><groupId>$group</groupId><artifactId>$artifact</artifactId><version>$version</version>$more</dependency>"
    }

    private fun serve(name: String, dependencies: String) {
        val artifact = artifact(name)
        put(artifact.path("pom"), "<project><dependencies>$dependencies</dependencies></project>".toByteArray())
        put(artifact.path("jar"), "jar of $name".toByteArray())
    }

    private fun serveNatives(name: String, machine: String) =
        put(artifact(name).copy(classifier = machine).path("jar"), "natives of $name".toByteArray())

    private fun put(path: String, bytes: ByteArray) {
        served[path] = bytes
        served["$path.sha1"] = MessageDigest.getInstance("SHA-1").digest(bytes).joinToString("") { "%02x".format(it) }.toByteArray()
    }

    private companion object {
        const val ALONE = "<exclusions><exclusion><groupId>*</groupId><artifactId>*</artifactId></exclusion></exclusions>"
    }
}

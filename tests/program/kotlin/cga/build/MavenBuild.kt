package cga.build

import org.w3c.dom.Element
import org.w3c.dom.Node
import javax.xml.parsers.DocumentBuilderFactory

/**
 * What the poms say of the build, as facts that [gradleFacts] names alike.
 *
 * Throws [IllegalStateException] where it could overlook something.
 *
 * @param parts the pom of each part, by its name.
 */
internal fun mavenFacts(pom: String, parts: Map<String, String>): Map<String, String> = MavenBuild(pom, parts).facts()

private class MavenBuild(pom: String, parts: Map<String, String>) {
    private val project = parsed(pom)
    private val parts = parts.mapValues { parsed(it.value) }
    private val properties = project.child("properties").children().associate { it.tagName to it.textContent }
    private val build = project.child("build")
    private val kotlin = plugin("kotlin-maven-plugin")
    private val surefire = plugin("maven-surefire-plugin").child("configuration")

    fun facts(): Map<String, String> =
        buildMap {
            put("name", project.value("artifactId"))
            put("group", project.value("groupId"))
            put("version", project.value("version"))
            put("Kotlin", kotlin.value("version"))
            put("JVM target", kotlin.child("configuration").value("jvmTarget"))
            put("parts", project.child("modules").children().joinToString { it.textContent })
            put("tested together", together().joinToString())
            put("main sources", sources("sourceDirectory"))
            put("test sources", sources("testSourceDirectory"))
            put("warnings are errors", ("-Werror" in arguments(kotlin.child("configuration"))).toString())
            put("compiler", arguments(kotlin.child("configuration")).filter { it.startsWith("-X") }.joinToString())
            put("explicit API", ("-Xexplicit-api=strict" in arguments(execution("compile"))).toString())
            putAll(testFacts())
            putAll(dependencies())
        }

    /** The parts whose tests the profile `together` has in one list. */
    private fun together(): List<String> {
        val profile = parts.getValue("program").child("profiles").children().single { it.value("id") == "together" }
        val folders = profile.getElementsByTagName("resource")
        return List(folders.length) { folders.item(it).textContent.trim().removeSurrounding("../../target/", "/test-classes") }
    }

    private fun sources(element: String): String {
        check(project.getElementsByTagName("sourceDirs").length == 0) { "pom.xml: <sourceDirs>: this test knows only <$element>" }
        return build.value(element).removePrefix("../../").replace("\${project.artifactId}", "\$name")
    }

    private fun execution(goal: String) =
        kotlin.child("executions").children().single { it.child("goals").value("goal") == goal }.child("configuration")

    private fun arguments(configuration: Element) = configuration.child("args").children().map { it.textContent }

    private fun testFacts(): Map<String, String> {
        val arguments = surefire.value("argLine").split(' ')
        val environment = surefire.child("environmentVariables").children().associate { "test environment ${it.tagName}" to it.textContent }
        val properties = arguments.filter { it.startsWith("-D") }.associate {
            "test property ${it.substringBefore('=').drop(2)}" to it.substringAfter('=')
        }
        val heap = arguments.single { it.startsWith("-Xmx") }.drop(4)
        return environment + properties + mapOf("test processes" to surefire.value("forkCount"), "test heap" to heap)
    }

    private fun dependencies(): Map<String, String> =
        buildMap {
            for ((part, pom) in parts) {
                for (dependency in listed(project) + listed(pom)) put("$part: ${name(dependency)}", version(dependency))
            }
        }

    /** The dependencies of [pom], with those of the profile for tests. */
    private fun listed(pom: Element): List<Element> {
        val profiles = pom.optionalChild("profiles")?.children().orEmpty().filter { it.value("id") == "tests" }
        val lists = (listOf(pom) + profiles).mapNotNull { it.optionalChild("dependencies") }.flatMap { it.children() }
        check(pom.getElementsByTagName("dependency").length == lists.size) { "pom.xml: dependencies outside of the two lists" }
        return lists
    }

    private fun name(dependency: Element): String {
        val scope = dependency.optional("scope") ?: "compile"
        val testing = dependency.optional("type")?.let { "tests" }
        val name = listOfNotNull(dependency.value("groupId"), dependency.value("artifactId"), dependency.optional("classifier"), testing)
        return "$scope ${name.joinToString(":")}"
    }

    private fun version(dependency: Element) = dependency.value("version").replace("\${project.version}", "ours")

    private fun plugin(artifact: String) = build.child("plugins").children().single { it.value("artifactId") == artifact }

    private fun Element.value(name: String): String = interpolated(child(name).textContent)

    private fun Element.optional(name: String): String? = children().firstOrNull { it.tagName == name }?.textContent

    private fun interpolated(text: String) = text.replace(Regex("""\$\{(.+?)}""")) { properties[it.groupValues[1]] ?: it.value }

    private fun parsed(pom: String) = DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(pom.byteInputStream()).documentElement

    private fun Element.optionalChild(name: String): Element? = children().singleOrNull { it.tagName == name }

    private fun Element.child(name: String): Element =
        children().singleOrNull { it.tagName == name } ?: error("pom.xml: <$tagName> without exactly one <$name>")

    private fun Node.children(): List<Element> = (0 until childNodes.length).map { childNodes.item(it) }.filterIsInstance<Element>()
}

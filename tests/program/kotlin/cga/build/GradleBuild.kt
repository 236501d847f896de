package cga.build

/**
 * What Gradle's three files say of the build, as facts that [mavenFacts] names alike.
 *
 * Not a parser of Kotlin: it knows the forms of line that build.gradle.kts uses, and throws [IllegalStateException] on any other
 * where it could overlook something.
 */
internal fun gradleFacts(catalogue: String, settings: String, script: String): Map<String, String> =
    GradleBuild(Catalogue(catalogue), withoutComments(settings), withoutComments(script)).facts()

private class GradleBuild(private val catalogue: Catalogue, private val settings: String, private val script: String) {
    private val kotlin = catalogue.plugin(find("""alias\(libs\.plugins\.([\w.]+)\)""", script))
    private val usedLibraries = mutableSetOf<String>()

    fun facts(): Map<String, String> =
        buildMap {
            put("name", find("""rootProject\.name = "(.+)"""", settings))
            put("group", find("""(?m)^group = "(.+)"""", script))
            put("version", find("""(?m)^version = "(.+)"""", script))
            put("Kotlin", kotlin)
            put("JVM target", jvmTarget())
            put("main sources", sources("main"))
            put("test sources", sources("test"))
            put("warnings are errors", ("allWarningsAsErrors = true" in script).toString())
            put("compiler", strings(find("""freeCompilerArgs\.addAll\((.+)\)""", script)).joinToString())
            put("explicit API", ("explicitApi()" in script).toString())
            put("test processes", find("""maxParallelForks = (\d+)""", block("tasks.test")))
            put("test heap", find("""maxHeapSize = "(.+)"""", block("tasks.test")))
            putAll(calls("systemProperty", "test property"))
            putAll(calls("environment", "test environment"))
            putAll(dependencies())
        }

    private fun jvmTarget(): String {
        val (alias, literal) = findAll(JVM_TARGET, script).single().destructured
        return literal.ifEmpty { catalogue.version(alias) }
    }

    private fun sources(set: String): String {
        check(findAll("(?i)srcDir", script).size == 2) { "build.gradle.kts: source folders are set in a form that this test does not know" }
        return strings(find("""\b$set \{ kotlin\.setSrcDirs\(listOf\((.+)\)\) }""", script)).joinToString()
    }

    private fun calls(function: String, fact: String): Map<String, String> {
        val calls = findAll("""\b$function\("(.+)", "(.+)"\)""", block("tasks.test"))
        return calls.associate { "$fact ${it.groupValues[1]}" to it.groupValues[2] }
    }

    private fun dependencies(): Map<String, String> {
        // Gradle's Kotlin plugin adds the library of its own version.
        val facts = mutableMapOf("compile org.jetbrains.kotlin:kotlin-stdlib" to kotlin)
        for (line in block("dependencies").lines().map { it.trim() }.filter { it.isNotEmpty() }) {
            facts += libraryFacts(line)
        }
        val unused = catalogue.libraries.keys - usedLibraries
        check(unused.isEmpty()) { "libs.versions.toml: $unused is not used in build.gradle.kts" }
        return facts
    }

    private fun libraryFacts(line: String): Map<String, String> {
        if (line == "for (platform in nativePlatforms) {" || line == "}") return emptyMap()
        val natives = NATIVES.matchEntire(line)?.destructured
        if (natives != null) {
            val (alias) = natives
            return platforms().associate { platform -> "runtime ${module(alias)}:natives-$platform" to version(alias) }
        }
        val library = checkNotNull(LIBRARY.matchEntire(line)) { "build.gradle.kts: cannot read the dependency: $line" }
        val (configuration, alias) = library.destructured
        val scope = checkNotNull(SCOPES[configuration]) { "build.gradle.kts: no Maven scope is like $configuration" }
        return mapOf("$scope ${module(alias)}" to version(alias))
    }

    private fun platforms() = strings(find("""val nativePlatforms = listOf\((.+)\)""", script))

    private fun module(alias: String) = catalogue.library(alias).first.also { usedLibraries += alias }

    private fun version(alias: String) = catalogue.library(alias).second

    private fun block(name: String) = find("""(?s)(?:^|\n)${Regex.escape(name)} \{\n(.*?)\n}\n""", script)

    private companion object {
        const val JVM_TARGET = """jvmTarget = JvmTarget\.fromTarget\((?:libs\.versions\.(\w+)\.get\(\)|"(\w+)")\)"""
        val LIBRARY = Regex("""(\w+)\(libs\.([\w.]+)\)""")
        val NATIVES = Regex("""runtimeOnly\(variantOf\(libs\.([\w.]+)\) \{ classifier\("natives-\${'$'}platform"\) }\)""")
        val SCOPES =
            mapOf("implementation" to "compile", "runtimeOnly" to "runtime", "testImplementation" to "test", "testRuntimeOnly" to "test")
    }
}

/** libs.versions.toml; aliases are spelt as build.gradle.kts spells them, with dots. */
private class Catalogue(text: String) {
    private val sections =
        text.split(Regex("""(?m)^\[""")).drop(1).associate { section ->
            section.substringBefore(']') to section.lines().drop(1).filterNot { it.isBlank() || it.startsWith("#") }
        }
    private val versions = sections.getValue("versions").associate { line -> pair("""(\w+) = "(.+)"""", line) }
    private val plugins = sections.getValue("plugins").associate { line -> entry("id", line) }

    /** Module and version by alias. */
    val libraries: Map<String, Pair<String, String>> = sections.getValue("libraries").associate { line -> entry("module", line) }

    fun version(alias: String): String = checkNotNull(versions[alias]) { "libs.versions.toml: no version $alias" }

    fun library(alias: String): Pair<String, String> = checkNotNull(libraries[alias]) { "libs.versions.toml: no library $alias" }

    fun plugin(alias: String): String = checkNotNull(plugins[alias]) { "libs.versions.toml: no plugin $alias" }.second

    private fun entry(key: String, line: String): Pair<String, Pair<String, String>> {
        val (alias, name, version) = match("""([\w-]+) = \{ $key = "(.+)", version\.ref = "(.+)" }""", line)
        return alias.replace('-', '.') to (name to version(version))
    }

    private fun pair(pattern: String, line: String) = match(pattern, line).let { (key, value) -> key to value }

    private fun match(pattern: String, line: String) =
        checkNotNull(Regex(pattern).matchEntire(line)) { "libs.versions.toml: cannot read: $line" }.destructured
}

private fun withoutComments(kotlin: String) = kotlin.replace(Regex("""(?m)^\s*//.*\n|\s+//.*$"""), "")

private fun strings(list: String) = findAll("\"(.+?)\"", list).map { it.groupValues[1] }

private fun findAll(pattern: String, text: String) = Regex(pattern).findAll(text).toList()

/** The one group of [pattern], which is in [text] once. */
private fun find(pattern: String, text: String): String {
    val found = findAll(pattern, text)
    check(found.size == 1) { "the build files have ${found.size} lines like $pattern; this test knows builds with one" }
    return found.single().groupValues[1]
}

package cga.build

/**
 * What Gradle's files say of the build, as facts that [mavenFacts] names alike.
 *
 * Not a parser of Kotlin: it knows the forms of line that the scripts use, and throws [IllegalStateException] on any other
 * where it could overlook something.
 *
 * @param parts the script of each part, by its name.
 */
internal fun gradleFacts(catalogue: String, settings: String, script: String, parts: Map<String, String>): Map<String, String> =
    GradleBuild(
        Catalogue(catalogue),
        withoutComments(settings),
        withoutComments(script),
        parts.mapValues { withoutComments(it.value) },
    ).facts()

private class GradleBuild(
    private val catalogue: Catalogue,
    private val settings: String,
    private val script: String,
    private val parts: Map<String, String>,
) {
    private val kotlin = catalogue.plugin(find("""alias\(libs\.plugins\.([\w.]+)\) apply false""", script))
    private val usedLibraries = mutableSetOf<String>()

    fun facts(): Map<String, String> =
        buildMap {
            put("name", find("""rootProject\.name = "(.+)"""", settings))
            put("group", find("""(?m)^ {4}group = "(.+)"""", script))
            put("version", find("""(?m)^ {4}version = "(.+)"""", script))
            put("parts", (partsInOrder().map { "src/$it" } + "tests/program").joinToString())
            // Gradle's `test` at the root has all of them; Maven's list is written out.
            put("tested together", (partsInOrder() + "program").joinToString())
            put("Kotlin", kotlin)
            put("JVM target", jvmTarget())
            check(
                findAll("(?i)srcDir", script).size == 4,
            ) { "build.gradle.kts: source folders are set in a form that this test does not know" }
            put("main sources", find("""kotlin\.setSrcDirs\(listOf\("(.+)"\)\)""", script))
            put(
                "test sources",
                find("""val tests = rootDir\.resolve\("(.+)"\)""", script) + "/" +
                    find("""kotlin\.setSrcDirs\(listOf\(tests\.resolve\("(.+)"\)\)\)""", script),
            )
            put("warnings are errors", ("allWarningsAsErrors = true" in script).toString())
            put("compiler", strings(find("""freeCompilerArgs\.addAll\((.+)\)""", script)).joinToString())
            put("explicit API", ("explicitApi()" in script).toString())
            put("test processes", find("""maxParallelForks = (\d+)""", tests()))
            put("test heap", find("""maxHeapSize = "(.+)"""", tests()))
            putAll(calls("systemProperty", "test property"))
            putAll(calls("environment", "test environment"))
            putAll(dependencies())
        }

    private fun partsInOrder() = findAll("""(?m)^part\("(\w+)"\)""", settings).map { it.groupValues[1] }

    private fun jvmTarget(): String {
        val (alias, literal) = findAll(JVM_TARGET, script).single().destructured
        return literal.ifEmpty { catalogue.version(alias) }
    }

    private fun calls(function: String, fact: String): Map<String, String> {
        val calls = findAll("""\b$function\("(.+)", "(.+)"\)""", tests())
        return calls.associate { "$fact ${it.groupValues[1]}" to it.groupValues[2] }
    }

    private fun dependencies(): Map<String, String> {
        val facts = mutableMapOf<String, String>()
        for ((part, script) in parts) {
            // Gradle's Kotlin plugin adds the library of its own version.
            facts["$part: compile org.jetbrains.kotlin:kotlin-stdlib"] = kotlin
            val common = lines(find("""(?s)\n {4}dependencies \{\n(.*?)\n {4}}\n""", this.script))
            val own = lines(find("""(?s)(?:^|\n)dependencies \{\n(.*?)\n}\n""", script))
            for (line in common + own) facts += libraryFacts(line).mapKeys { "$part: ${it.key}" }
        }
        val unused = catalogue.libraries.keys - usedLibraries
        check(unused.isEmpty()) { "libs.versions.toml: $unused is not used by any part" }
        return facts
    }

    private fun lines(block: String) = block.lines().map { it.trim().replace("rootProject.libs.", "libs.") }.filter { it.isNotEmpty() }

    private fun libraryFacts(line: String): Map<String, String> {
        val natives = NATIVES.matchEntire(line)?.destructured
        if (natives != null) {
            val (alias) = natives
            return platforms().associate { platform -> "runtime ${module(alias)}:natives-$platform" to version(alias) }
        }
        val project = PROJECT.matchEntire(line)?.destructured
        if (project != null) {
            val (configuration, part, testing) = project
            return mapOf("${scope(configuration)} cga:$part${if (testing.isEmpty()) "" else ":tests"}" to "ours")
        }
        val library = checkNotNull(LIBRARY.matchEntire(line)) { "build.gradle.kts: cannot read the dependency: $line" }
        val (configuration, alias) = library.destructured
        return mapOf("${scope(configuration)} ${module(alias)}" to version(alias))
    }

    private fun scope(configuration: String) = checkNotNull(
        SCOPES[configuration],
    ) { "build.gradle.kts: no Maven scope is like $configuration" }

    private fun tests() = find("""(?s)\n {4}tasks\.named<Test>\("test"\) \{\n(.*?)\n {4}}\n""", script)

    private fun platforms() = strings(find("""val nativePlatforms = listOf\((.+)\)""", script))

    private fun module(alias: String) = catalogue.library(alias).first.also { usedLibraries += alias }

    private fun version(alias: String) = catalogue.library(alias).second

    private companion object {
        const val JVM_TARGET = """jvmTarget = JvmTarget\.fromTarget\((?:rootProject\.libs\.versions\.(\w+)\.get\(\)|"(\w+)")\)"""
        val LIBRARY = Regex(""""?(\w+)"?\(libs\.([\w.]+)\)""")
        val NATIVES = Regex(""""natives"\(libs\.([\w.]+)\)""")
        val PROJECT = Regex("""(\w+)\(project\(":(\w+)"(, "testing")?\)\)""")

        // Maven's `compile` is seen by whoever uses the part, like `api`: it knows no other.
        val SCOPES =
            mapOf(
                "api" to "compile",
                "implementation" to "compile",
                "runtimeOnly" to "runtime",
                "testImplementation" to "test",
                "testRuntimeOnly" to "test",
            )
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

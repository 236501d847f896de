package cga.build

import org.jetbrains.kotlin.lexer.KotlinLexer
import org.jetbrains.kotlin.lexer.KtTokens
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Test

/** Who may know whom in the main sources (CONTRIBUTING.md says it in words), and no `!!` there. */
class LayerTest {
    private val mayUse =
        mapOf(
            "framework" to setOf(),
            "exercise" to setOf("framework"),
            "reader" to setOf("framework"),
            "coach" to setOf("reader", "framework"),
            "reference" to setOf("framework"),
            "imaging" to setOf("framework"),
            "grading" to setOf("coach", "imaging", "reference", "exercise", "reader", "framework"),
            "measure" to setOf("imaging", "reference", "exercise", "framework"),
            "inspect" to setOf("coach", "imaging", "reference", "exercise", "framework"),
            "cli" to setOf("grading", "measure", "inspect", "coach", "imaging", "reference", "exercise", "framework"),
        )

    private val sources = kotlinFiles(
        *PARTS.map { "src/$it/kotlin" }.toTypedArray(),
    ).map { Source(it.invariantSeparatorsPath, it.readText()) }

    @Test
    fun `the sources keep to their layers`() {
        assertNotEquals(0, sources.size, "no sources found")
        assertEquals("", sources.flatMap(::violations).joinToString("\n"))
    }

    @Test
    fun `no packages use each other in a circle`() {
        assertEquals("", circle(sources).joinToString(" uses "))
    }

    @Test
    fun `each part has its own packages, and its tests are of those or of the parts below`() {
        val wrong = PARTS.flatMap { part ->
            val below = PARTS.takeWhile { it != part } + part
            outside(part, "src", PACKAGES.getValue(part)) +
                // What the tests of all parts share lies with those of the first one.
                outside(part, "tests", below.flatMap(PACKAGES::getValue) + "testing")
        }
        assertEquals(emptyList<String>(), wrong)
    }

    /** The files of a part that lie in none of [packages]. */
    private fun outside(part: String, folder: String, packages: Collection<String>): List<String> =
        kotlinFiles("$folder/$part/kotlin").map { it.invariantSeparatorsPath }.filterNot { path ->
            packages.any { path.startsWith("$folder/$part/kotlin/cga/${it.replace('.', '/')}/") }
        }

    @Test
    fun `what reads a stranger's files runs in jobs only`() {
        val own = sources.filter { !isJobs(it.packageName) && layer(it.packageName) in setOf("grading", "cli") }
        assertNotEquals(0, own.size, "no sources of the grader found")
        assertEquals("", own.flatMap(::crossings).joinToString("\n"))
    }

    @Test
    fun `a use of what runs in jobs is reported, and so is a regular expression between them`() {
        fun crossings(code: String) = crossings(Source("X.kt", "package cga.grading.pipeline\n$code\n"))
        val reader = "cga.grading.submission.SubmissionReader"
        assertEquals(listOf("X.kt:2: only a job may use $reader"), crossings("import $reader"))
        assertEquals(listOf("X.kt:2: text of a submission is not matched here"), crossings("val a = Regex(\"a\")"))
        assertEquals(emptyList<String>(), crossings("const val MAIN = \"cga.grading.submission.PrepareMain\""))
    }

    private fun crossings(source: Source): List<String> {
        val uses = source.uses.filter { isJobs(it.second) }.map { (line, name) -> "${source.name}:$line: only a job may use $name" }
        val isBetween = BETWEEN_JOBS.any { source.packageName == "cga.grading.$it" }
        return uses + if (isBetween) source.regexes.map { "${source.name}:$it: text of a submission is not matched here" } else emptyList()
    }

    private fun isJobs(name: String) = JOBS.any { "$name.".startsWith("cga.grading.$it.") }

    @Test
    fun `a use of a higher layer is reported with its line`() {
        assertViolations("cga.exercise.game", "import cga.grading.Check", "X.kt:2: exercise must not use cga.grading.Check")
        assertViolations("cga.framework", "val x = cga.exercise.Scene()", "X.kt:2: framework must not use cga.exercise.Scene")
        assertViolations("cga.imaging", "import cga.reference.shade", "X.kt:2: imaging must not use cga.reference.shade")
        assertViolations("cga.measure", "import cga.grading.Check", "X.kt:2: measure must not use cga.grading.Check")
        assertViolations("cga.cli", "import cga.grading.Check\nimport cga.measure.Speed\nimport cga.framework.Frame")
    }

    @Test
    fun `OpenGL in the reference is reported`() {
        assertViolations("cga.reference", "import org.lwjgl.opengl.GL33C.*", "X.kt:2: reference must not use org.lwjgl.opengl.GL33C")
        assertViolations("cga.framework", "import org.lwjgl.opengl.GL33C.*")
    }

    @Test
    fun `a package outside the layers is reported`() {
        assertViolations("cga.misc", "val x = 1", "X.kt:1: cga.misc is in no layer; there are ${mayUse.keys}")
    }

    @Test
    fun `a double bang is reported, but not in text or comments`() {
        assertViolations("cga.cli", "val a = \"cga.x!! \${b(\"!!\")}\" + '!' // !!\nval c = \"\${d!!}\"", "X.kt:3: !! is for tests only")
    }

    @Test
    fun `a circle of packages is reported`() {
        val there = Source("A.kt", "package cga.exercise.a\nimport cga.exercise.b.B\n")
        val back = Source("B.kt", "package cga.exercise.b\nval a = cga.exercise.a.a()\n")
        val noWayBack = Source("B.kt", "package cga.exercise.b\nimport cga.exercise.C\n")
        assertEquals(listOf("cga.exercise.a", "cga.exercise.b", "cga.exercise.a"), circle(listOf(there, back)))
        val parent = Source("C.kt", "package cga.exercise\nimport cga.exercise.b.B\n")
        assertEquals(emptyList<String>(), circle(listOf(there, noWayBack, parent)))
    }

    private fun assertViolations(packageName: String, code: String, vararg expected: String) =
        assertEquals(expected.toList(), violations(Source("X.kt", "package $packageName\n$code\n")))

    private fun violations(source: Source): List<String> {
        val layer = layer(source.packageName)
        val allowed = mayUse[layer] ?: return listOf("${source.name}:1: ${source.packageName} is in no layer; there are ${mayUse.keys}")
        val forbidden = source.uses.filter { (_, name) ->
            val isOtherLayer = layer(name) in mayUse && layer(name) != layer
            val isOpenGl = name.startsWith("org.lwjgl.opengl")
            (isOtherLayer && layer(name) !in allowed) || (isOpenGl && layer == "reference")
        }
        return forbidden.map { (line, name) -> "${source.name}:$line: $layer must not use $name" } +
            source.doubleBangs.map { "${source.name}:$it: !! is for tests only" }
    }

    private fun layer(name: String) = name.removePrefix("cga.").substringBefore('.')

    /** The packages of a circle, the first again at the end; empty where there is none. */
    private fun circle(sources: List<Source>): List<String> {
        val uses = packageUses(sources)
        val free = mutableSetOf<String>()

        fun circleFrom(path: List<String>): List<String>? {
            val here = path.last()
            if (here in free) return null
            if (here in path.dropLast(1)) return path.dropWhile { it != here }
            return uses.getValue(here).firstNotNullOfOrNull { circleFrom(path + it) }.also { if (it == null) free += here }
        }
        return uses.keys.firstNotNullOfOrNull { circleFrom(listOf(it)) }.orEmpty()
    }

    /** Which packages each package uses, but for those that it lies in or that lie in it. */
    private fun packageUses(sources: List<Source>): Map<String, List<String>> {
        val files = sources.groupBy { it.packageName }

        fun owner(name: String) = files.keys.filter { name.startsWith("$it.") }.maxByOrNull { it.length }

        fun isNested(a: String, b: String) = "$a.".startsWith("$b.") || "$b.".startsWith("$a.")
        return files.mapValues { (self, ofSelf) ->
            ofSelf.flatMap { it.uses }.mapNotNull { owner(it.second) }.distinct().filterNot { isNested(it, self) }
        }
    }

    /** What a Kotlin file says outside of comments and text, by line. */
    private class Source(val name: String, text: String) {
        private val lines = code(text).lines()

        val packageName = lines.firstOrNull { it.startsWith("package ") }?.removePrefix("package ")?.trim().orEmpty()

        /** Names of ours and of LWJGL with the lines that they stand on, imported or written out. */
        val uses: List<Pair<Int, String>> =
            lines.withIndex().filter { !it.value.startsWith("package ") }.flatMap { (index, line) ->
                QUALIFIED_NAME.findAll(line).map { index + 1 to it.value }
            }

        val regexes = lines.withIndex().filter { "Regex(" in it.value }.map { it.index + 1 }

        val doubleBangs = lines.withIndex().filter { "!!" in it.value }.map { it.index + 1 }

        private companion object {
            val QUALIFIED_NAME = Regex("""(?<![\w.])(?:cga|org\.lwjgl)(?:\.\w+)+""")

            fun code(text: String) = buildString {
                val lexer = KotlinLexer()
                lexer.start(text)
                while (lexer.tokenType != null) {
                    val isCode = lexer.tokenType !in KtTokens.COMMENTS && lexer.tokenType !in TEXT
                    append(if (isCode) lexer.tokenText else lexer.tokenText.replace(Regex("."), " "))
                    lexer.advance()
                }
            }

            val TEXT = setOf(KtTokens.REGULAR_STRING_PART, KtTokens.ESCAPE_SEQUENCE, KtTokens.CHARACTER_LITERAL)
        }
    }

    private companion object {
        /** Parts of the grader that run in the sandbox: they are started by name, and nothing outside of it may call them. */
        val JOBS =
            listOf("submission", "likeness", "worker", "analysis", "reading", "sheet4", "study", "scene", "replay", "substitute")

        /** Parts that start jobs and hand on what those say. */
        val BETWEEN_JOBS = listOf("pipeline", "prepared")
    }
}

package cga.build

import cga.testing.projectRoot
import com.pinterest.ktlint.rule.engine.api.Code
import com.pinterest.ktlint.rule.engine.api.KtLintRuleEngine
import com.pinterest.ktlint.rule.engine.api.LintError
import com.pinterest.ktlint.rule.engine.core.api.AutocorrectDecision.ALLOW_AUTOCORRECT
import com.pinterest.ktlint.ruleset.standard.StandardRuleSetProvider
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.io.File

/** All Kotlin is in the form that .editorconfig asks for. With `-Dcga.format=fix` it is put into that form first. */
class FormatTest {
    private val engine = KtLintRuleEngine(StandardRuleSetProvider().getRuleProviders())

    @Test
    fun `every Kotlin file is formatted`() {
        val parts = PARTS.map { "src/$it" } + "tests/program"
        val scripts = (listOf("build.gradle.kts", "settings.gradle.kts") + parts.map { "$it/build.gradle.kts" }).map(::File)
        val check = if (System.getProperty("cga.format") == "fix") ::fix else ::complaints
        val known = Formatted.known()
        val (sound, others) = (scripts + kotlinFiles("src", "tests")).map(Formatted::of).partition { it in known }
        val found = others.parallelStream().map { it.file to check(it.file) }.toList()
        Formatted.remember(sound + found.filter { it.second.isEmpty() }.map { Formatted.of(it.first) })
        val complaints = found.flatMap { it.second }
        assertTrue(complaints.isEmpty()) {
            "Most of this is cured by running the tests with -Dcga.format=fix.\n" +
                complaints.joinToString("\n")
        }
    }

    @Test
    fun `a badly formatted file is reported with its line`() {
        val complaints = complaints("package cga\n\nclass Bad {\n  val x=1;\n}\n")
        assertEquals(listOf(4), complaints.map { it.line }.distinct())
        assertEquals(setOf("indent", "op-spacing", "no-semi"), complaints.map { it.ruleId.value.substringAfter(':') }.toSet())
    }

    @Test
    fun `of a line that is too long only that is reported`() {
        val code = "package cga\n\nval x = listOf(1, 2, 3).map { it + ${"1".repeat(140)} }\n"
        assertEquals(listOf(3 to "standard:max-line-length"), complaints(code).map { it.line to it.ruleId.value })
    }

    @Test
    fun `wildcards are for the constants of C libraries`() {
        fun rules(import: String) = complaints("package cga\n\nimport $import\n\nval x = 1\n").map { it.ruleId.value }
        assertEquals(emptyList<String>(), rules("org.lwjgl.opengl.GL33C.*"))
        for (import in listOf("java.util.*", "org.lwjgl.opengl.*", "kotlin.math.*")) {
            assertEquals(listOf("standard:no-wildcard-imports"), rules(import), import)
        }
    }

    private fun complaints(file: File): List<String> =
        complaints(Code.fromFile(file.absoluteFile)).map {
            "${file.invariantSeparatorsPath}:${it.line}:${it.col} ${it.ruleId.value} ${it.detail}"
        }

    /** Rewrites [file] and returns what a person has to cure. */
    private fun fix(file: File): List<String> {
        val before = file.readText()
        val after = engine.format(Code.fromFile(file.absoluteFile)) { ALLOW_AUTOCORRECT }
        if (after != before) file.writeText(after)
        return complaints(file)
    }

    /** What is wrong with [text], were it a file of the project. */
    private fun complaints(text: String): List<LintError> =
        complaints(Code.fromSnippetWithPath(text, projectRoot.resolve("src/scene/kotlin/cga/Bad.kt").toPath()))

    /** Of a line that is too long only that: ktlint names every place as well where it could be broken. */
    private fun complaints(code: Code): List<LintError> {
        val errors = buildList { engine.lint(code) { add(it) } }
        val longLines = errors.filter { it.ruleId.value == MAX_LINE_LENGTH }.map { it.line }.toSet()
        return errors.filter { it.line !in longLines || it.ruleId.value == MAX_LINE_LENGTH }
    }

    private companion object {
        const val MAX_LINE_LENGTH = "standard:max-line-length"
    }
}

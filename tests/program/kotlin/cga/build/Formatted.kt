package cga.build

import cga.testing.projectRoot
import cga.testing.testingFolder
import com.pinterest.ktlint.rule.engine.api.KtLintRuleEngine
import com.pinterest.ktlint.ruleset.standard.StandardRuleSetProvider
import java.io.File
import java.security.MessageDigest
import kotlin.io.path.createDirectories
import kotlin.io.path.exists
import kotlin.io.path.readLines
import kotlin.io.path.writeLines

/** The version of [file] with this [sum], which also covers the rules: what once had nothing to complain of has nothing to complain of. */
internal data class Formatted(val sum: String, val file: File) {
    companion object {
        private val list = testingFolder.resolve("formatted")
        private val rules =
            projectRoot.resolve(".editorconfig").readText() +
                listOf(KtLintRuleEngine::class, StandardRuleSetProvider::class).map { it.java.protectionDomain.codeSource.location.file }

        fun of(file: File): Formatted {
            val digest = MessageDigest.getInstance("SHA-256").digest((rules + file.readText()).toByteArray())
            return Formatted(digest.joinToString("") { "%02x".format(it) }, file)
        }

        /** What the last run found in form. */
        fun known(): Set<Formatted> {
            val lines = if (list.exists()) list.readLines() else emptyList()
            return lines.map { Formatted(it.substringBefore(' '), File(it.substringAfter(' '))) }.toSet()
        }

        fun remember(files: List<Formatted>) {
            testingFolder.createDirectories()
            list.writeLines(files.map { "${it.sum} ${it.file.invariantSeparatorsPath}" })
        }
    }
}

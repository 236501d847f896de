package cga.imaging.tolerance

import cga.imaging.JsonNode
import java.nio.file.Path
import java.util.regex.PatternSyntaxException

/**
 * Tolerances with names in one file, each for some renderers; the first that fits is the one that counts:
 *
 *     { "tiers": [ { "name": "exact", "renderer": "llvmpipe.*", "cpu": "ssse3", "sameMachine": true, "byte": RULE, "float": RULE }, … ] }
 *
 * `renderer` is a regular expression that the whole of `GL_RENDERER` must match. `cpu`, which may be left away, lists features that the
 * processor must have, with spaces between them. With `sameMachine` a tier counts only where all that decides the renderer's code
 * (version, processor, settings) is as it was when the expected picture was made.
 */
public class ToleranceTiers private constructor(
    private val node: JsonNode,
    private val tiers: List<Tier>,
) {
    private class Tier(
        private val renderer: Regex,
        private val cpu: List<String>,
        private val sameMachine: Boolean,
        val tolerance: Tolerance,
    ) {
        fun isFor(
            renderer: String,
            cpu: Collection<String>,
            sameMachine: Boolean,
        ) = this.renderer.matches(renderer) && cpu.containsAll(this.cpu) && (sameMachine || !this.sameMachine)
    }

    /** The tolerance for pictures of the renderer [renderer] on a processor with the features [cpu], or null where the file has none. */
    public fun choose(
        renderer: String,
        cpu: Collection<String>,
        sameMachine: Boolean,
    ): Tolerance? = tiers.firstOrNull { it.isFor(renderer, cpu, sameMachine) }?.tolerance

    internal fun named(name: String?): Tolerance =
        tiers.firstOrNull { it.tolerance.name == name }?.tolerance
            ?: node.fail(
                (if (name == null) "holds several tolerances" else "has no tolerance \"$name\"") +
                    ": name one of ${tiers.joinToString { it.tolerance.name }}.",
            )

    public companion object {
        /** The tiers in the file at [path]. Throws [cga.framework.InputError] naming the file, the place in it and the cure. */
        public fun read(path: Path): ToleranceTiers = of(JsonNode.read(path, "tolerance"))

        internal fun of(node: JsonNode): ToleranceTiers {
            node.allowOnly("tiers")
            val tiers = node.get("tiers").list().map(::tier)
            val twice = tiers.groupBy { it.tolerance.name }.entries.firstOrNull { it.value.size > 1 }
            if (twice != null) node.fail("has two tiers \"${twice.key}\": rename one.")
            return ToleranceTiers(node, tiers)
        }

        private fun tier(node: JsonNode): Tier {
            node.allowOnly("name", "renderer", "cpu", "sameMachine", "byte", "float")
            val cpu = node.find("cpu")?.text()?.split(' ').orEmpty()
            val sameMachine = node.find("sameMachine")?.flag() ?: false
            return Tier(pattern(node.get("renderer")), cpu, sameMachine, Tolerance.of(node, node.get("name").text()))
        }

        private fun pattern(node: JsonNode): Regex =
            try {
                Regex(node.text())
            } catch (e: PatternSyntaxException) {
                node.fail("is no regular expression (${e.description}): correct it.")
            }
    }
}

package cga.grading.worker

/**
 * What passes from the [vertex] to the [fragment] shader, by their sources. A variable that the fragment shader reads and no vertex shader
 * writes has no defined value, and another in each picture; some drivers do not even link it.
 */
internal class Varyings(
    vertex: String,
    fragment: String,
) {
    private val vertex = GlslTokens.of(vertex)
    private val fragment = GlslTokens.of(fragment)
    private val vertexWords = words(this.vertex)
    private val fragmentWords = words(this.fragment)
    private val sent = Varying.declared(this.vertex, "out").associateBy { it.name }
    private val wanted = Varying.declared(this.fragment, "in").associateBy { it.name }
    private val received = wanted.filterKeys { fragmentWords.getValue(it) > 1 }

    /** What the fragment shader reads and the vertex shader does not write, neither under its name nor at its location. */
    val missing: Set<String> =
        (received - sent.keys)
            .filter { (name, own) -> name !in vertexWords && (own.location == null || sent.values.none { it.location == own.location }) }
            .keys

    /** The fragment shader with each name that is [missing] replaced by the likest of its type that is not read yet; null where there is none. */
    fun matched(): String? {
        val spare = (sent - received.keys).filterKeys { it !in fragmentWords }.toMutableMap()
        val meant = missing.associateWith { name ->
            val alike = spare.filterValues { it.isLike(received.getValue(name)) }.keys
            val likest = alike.maxByOrNull { it.commonPrefixWith(name).length + it.commonSuffixWith(name).length } ?: return null
            likest.also { spare -= it }
        }
        return fragment.text { token -> token.renamed { meant[it] ?: it }.text }
    }

    /** The fragment shader with 0 in the place of each that is [missing], as drivers have it that link it. */
    fun zeroed(): String = Varying.replaced(fragment, "in") { it.takeIf { it.name in missing }?.zero() }

    /** The vertex shader with what it sends interpolated as the fragment shader wants it, as GLSL 4.40 has it. */
    fun interpolated(): String = Varying.replaced(vertex, "out") { own ->
        wanted[own.name]?.takeIf { it.interpolation != own.interpolation }?.let { own.declaration("out", it.interpolation) }
    }

    private companion object {
        /** How often each word occurs, in directives too. */
        fun words(tokens: List<Token>): Map<String, Int> =
            tokens
                .flatMap { if (it.kind == TokenKind.DIRECTIVE) it.directive() else listOf(it) }
                .filter { it.kind == TokenKind.WORD }
                .groupingBy { it.text }
                .eachCount()
    }
}

/**
 * A variable that passes between the stages.
 *
 * @param interpolation how, null where it is not said.
 * @param others what else is said before its direction.
 * @param array its size in brackets, empty where it is none.
 */
internal class Varying(
    val name: String,
    val type: String,
    val interpolation: String?,
    private val others: List<String>,
    private val array: String,
) {
    /** The number that its layout gives it, null where there is none. */
    val location: String? get() = others.getOrNull(others.indexOf("location") + 2).takeIf { "location" in others }

    /** Whether one could have been meant by the other. */
    fun isLike(other: Varying): Boolean = type == other.type && array == other.array && interpolation == other.interpolation

    fun declaration(
        direction: String,
        interpolation: String? = this.interpolation,
    ): String {
        // Older versions want them in this order.
        val layout = others.take(others.indexOf(")") + 1)
        val words = layout + listOfNotNull(interpolation) + others.drop(layout.size) + listOf(direction, type, "$name$array;")
        return words.joinToString(" ")
    }

    /** The declaration of a variable of this name with the value 0, where that can be said of its type. */
    fun zero(): String = if (array.isEmpty() && ZERO.any { type.startsWith(it) }) "$type $name = $type(0);" else "$type $name$array;"

    companion object {
        private val INTERPOLATIONS = setOf("flat", "smooth", "noperspective")
        private val PRECISIONS = setOf("lowp", "mediump", "highp")
        private val ZERO = listOf("float", "int", "uint", "vec", "ivec", "uvec", "mat")

        /** What [tokens] declare as `in` or `out`. Blocks are matched by their own names and left out. */
        fun declared(
            tokens: List<Token>,
            direction: String,
        ): List<Varying> = GlobalStatements.of(tokens).flatMap { of(it, direction).orEmpty() }

        /** The source of [tokens] in which [say] declares what it has another declaration for. */
        fun replaced(
            tokens: List<Token>,
            direction: String,
            say: (Varying) -> String?,
        ): String {
            val said = HashMap<Token, String>()
            for (statement in GlobalStatements.of(tokens)) {
                val varyings = of(statement, direction) ?: continue
                if (varyings.all { say(it) == null }) continue
                statement.forEach { said[it] = "" }
                said[statement.first()] = varyings.joinToString(" ") { say(it) ?: it.declaration(direction) }
            }
            return tokens.text { said[it] ?: it.text }
        }

        private fun of(
            statement: List<Token>,
            direction: String,
        ): List<Varying>? {
            val at = statement.indexOfFirst { it.isWord(direction) }
            if (at < 0 || !statement.last().isSign(';') || statement.any { it.isSign('{') }) return null
            val rest = statement.drop(at + 1).dropLast(1).filterNot { it.text in PRECISIONS }
            val before = statement.take(at).map { it.text }
            val typeArray = rest.drop(1).takeWhile { it.kind != TokenKind.WORD }.text()
            val type = rest.firstOrNull()?.text ?: return null
            return split(rest.drop(1)).mapNotNull { one ->
                val name = one.firstOrNull { it.kind == TokenKind.WORD } ?: return@mapNotNull null
                val array = one.dropWhile { it != name }.drop(1).text()
                Varying(name.text, type, before.find { it in INTERPOLATIONS }, before - INTERPOLATIONS, typeArray + array)
            }
        }

        private fun split(tokens: List<Token>): List<List<Token>> {
            val parts = mutableListOf(mutableListOf<Token>())
            for (token in tokens) if (token.isSign(',')) parts += mutableListOf<Token>() else parts.last() += token
            return parts
        }
    }
}

/** What stands outside of all functions. */
internal object GlobalStatements {
    /** The code of each declaration, struct or function, up to its semicolon or closing brace. */
    fun of(tokens: List<Token>): List<List<Token>> {
        val statements = mutableListOf(mutableListOf<Token>())
        var depth = 0
        for (token in tokens.filter { it.isCode }) {
            statements.last() += token
            if (token.isSign('{')) depth++
            if (token.isSign('}')) depth--
            if (depth <= 0 && (token.isSign(';') || (token.isSign('}') && isFunction(statements.last())))) {
                statements += mutableListOf<Token>()
                depth = 0
            }
        }
        return statements.filter { it.isNotEmpty() }
    }

    /** What has other braces goes on behind them. */
    private fun isFunction(statement: List<Token>) = statement.takeWhile { !it.isSign('{') }.lastOrNull()?.isSign(')') == true
}

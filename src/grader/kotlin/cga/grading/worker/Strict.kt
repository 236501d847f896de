package cga.grading.worker

/** A shader whose first line is `#version`, with its words and signs as the specification wants them; see [Dialect]. */
internal class Strict(source: List<Token>) {
    val tokens: List<Token> = hoisted(casts(renamed(source.map { number(directive(it)) })))

    /** `1f` is 1.0, in macros too. */
    private fun number(token: Token): Token {
        if (token.kind == TokenKind.DIRECTIVE) return token.changed(::number)
        val digits = token.text.dropLast(1)
        val isSuffixed = token.kind == TokenKind.NUMBER && token.text.last() in "fF" && digits.isNotEmpty() && digits.all { it.isDigit() }
        return if (isSuffixed) Token(token.kind, "$digits.0") else token
    }

    /** Nothing follows `#else` and `#endif`; what an extension would bring is missed where it is used, if anywhere. */
    private fun directive(token: Token): Token {
        if (token.kind != TokenKind.DIRECTIVE) return token
        val words = token.directive()
        return when (words.firstOrNull { it.isCode }?.text) {
            "else", "endif" -> Token(token.kind, "#" + words.first { it.isCode }.text)
            "extension" -> token.renamed { if (it == "require") "enable" else it }
            else -> token
        }
    }

    /** Names that the specification keeps for later, where nobody outside of the shader can ask for them. */
    private fun renamed(tokens: List<Token>): List<Token> {
        val used = tokens.filter { it.kind == TokenKind.WORD && it.text in RESERVED }.map { it.text }.toSet()
        if (used.isEmpty()) return tokens
        val seen = GlobalStatements.of(tokens).filter(::isAskedFor).flatten().map { it.text }
        val own = used - seen.toSet()
        return tokens.map { token -> token.renamed { if (it in own) "${it}_own" else it } }
    }

    private fun isAskedFor(statement: List<Token>) = statement.last().isSign(';') && statement.any { it.text in INTERFACE }

    /** `(float) x` is float(x). From the end, so that what is cast has been said already. */
    private fun casts(tokens: List<Token>): List<Token> {
        val result = ArrayList(tokens)
        for (i in tokens.indices.reversed()) {
            if (!tokens[i].isSign('(')) continue
            val type = code(result, i + 1)?.takeIf { result[it].kind == TokenKind.WORD && result[it].text in TYPES } ?: continue
            val close = code(result, type + 1)?.takeIf { result[it].isSign(')') } ?: continue
            if (!mayPrecedeOperand(tokens, i)) continue
            val end = operandEnd(result, close + 1) ?: continue
            result.add(end, Token(TokenKind.SIGN, ")"))
            result[close] = Token(TokenKind.SIGN, "(")
            result.removeAt(i)
        }
        return result
    }

    /** Whether an operand, and not an operator or the arguments of a function, begins at [at]; another cast may stand before it. */
    private fun mayPrecedeOperand(
        tokens: List<Token>,
        at: Int,
    ): Boolean {
        val before = (at - 1 downTo 0).asSequence().map { tokens[it] }.filter { it.isCode }.take(CAST).toList()
        val last = before.firstOrNull() ?: return true
        if (last.isSign(')')) return before.size == CAST && before[1].text in TYPES && before[2].isSign('(')
        return last.isWord("return") || (last.kind == TokenKind.SIGN && !last.isSign(']'))
    }

    /** Where the operand ends that begins at or behind [from]: signs, a name, number or bracket, then calls, indices and members. */
    private fun operandEnd(
        tokens: List<Token>,
        from: Int,
    ): Int? {
        var at = code(tokens, from) ?: return null
        while (tokens[at].kind == TokenKind.SIGN && tokens[at].text[0] in "+-!~") at = code(tokens, at + 1) ?: return null
        var end =
            when {
                tokens[at].isSign('(') -> closing(tokens, at) ?: return null
                tokens[at].kind == TokenKind.SIGN -> return null
                else -> at
            }
        while (true) {
            val next = code(tokens, end + 1) ?: return end + 1
            end =
                when {
                    tokens[next].isSign('(') || tokens[next].isSign('[') -> closing(tokens, next) ?: return null
                    tokens[next].isSign('.') -> code(tokens, next + 1) ?: return null
                    else -> return end + 1
                }
        }
    }

    private fun closing(
        tokens: List<Token>,
        open: Int,
    ): Int? {
        var depth = 0
        for (i in open until tokens.size) {
            if (tokens[i].isSign('(') || tokens[i].isSign('[')) depth++
            if ((tokens[i].isSign(')') || tokens[i].isSign(']')) && --depth == 0) return i
        }
        return null
    }

    private fun code(
        tokens: List<Token>,
        from: Int,
    ): Int? = (from until tokens.size).firstOrNull { tokens[it].isCode }

    /** With `#extension` before the first declaration. */
    private fun hoisted(tokens: List<Token>): List<Token> {
        val code = tokens.indexOfFirst { it.isCode }
        val late = tokens.drop(maxOf(code, 0)).filter { isExtension(it) }
        if (code < 0 || late.isEmpty()) return tokens
        val version = tokens.indexOfFirst { it.kind == TokenKind.DIRECTIVE } + 1
        val moved = late.flatMap { listOf(Token(TokenKind.SPACE, "\n"), it) }
        return tokens.take(version) + moved + tokens.drop(version).filterNot { it in late }
    }

    private fun isExtension(token: Token) =
        token.kind == TokenKind.DIRECTIVE && token.directive().firstOrNull { it.isCode }?.isWord("extension") == true

    private companion object {
        /** Tokens of `(float)`. */
        const val CAST = 3
        val RESERVED = setOf("input", "output", "active", "filter", "common", "partition")
        val INTERFACE = setOf("uniform", "in", "out", "attribute", "varying", "struct")
        val TYPES = setOf("float", "int", "uint", "bool") + listOf("", "i", "u", "b").flatMap { kind -> (2..4).map { "${kind}vec$it" } }
    }
}

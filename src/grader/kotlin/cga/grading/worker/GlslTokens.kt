package cga.grading.worker

/** What a [Token] is. A directive is the whole of its line, continued lines included, up to a comment. */
internal enum class TokenKind { SPACE, COMMENT, DIRECTIVE, WORD, NUMBER, SIGN }

/** A piece of GLSL as it is written. */
internal class Token(
    val kind: TokenKind,
    val text: String,
) {
    /** Whether it is code: neither space nor comment nor directive. */
    val isCode: Boolean get() = kind == TokenKind.WORD || kind == TokenKind.NUMBER || kind == TokenKind.SIGN

    fun isSign(sign: Char): Boolean = kind == TokenKind.SIGN && text[0] == sign

    fun isWord(word: String): Boolean = kind == TokenKind.WORD && text == word

    /** The tokens behind the `#` of a directive. */
    fun directive(): List<Token> = GlslTokens.of(text.substringAfter('#'))

    /** A directive with each token behind its `#` as [change] has it. */
    fun changed(change: (Token) -> Token): Token =
        Token(kind, text.substringBefore('#') + "#" + directive().text { change(it).text })

    /** This token with each word in it, those of a directive too, replaced by what [name] answers. */
    fun renamed(name: (String) -> String): Token =
        when (kind) {
            TokenKind.WORD -> Token(kind, name(text))
            TokenKind.DIRECTIVE -> changed { it.renamed(name) }
            else -> this
        }
}

/** Takes GLSL apart. It never fails, whatever it is given, and reads each character once. */
internal object GlslTokens {
    /** The tokens of [source]; joined they are [source] again. */
    fun of(source: String): List<Token> = Scanner(source).tokens()

    private class Scanner(private val source: String) {
        private val tokens = ArrayList<Token>()
        private var at = 0

        fun tokens(): List<Token> {
            var isLineStart = true
            while (at < source.length) {
                val first = source[at]
                val kind =
                    when {
                        first.isWhitespace() -> TokenKind.SPACE
                        source.startsWith("//", at) || source.startsWith("/*", at) -> TokenKind.COMMENT
                        first == '#' && isLineStart -> TokenKind.DIRECTIVE
                        isLetter(first) -> TokenKind.WORD
                        first.isDigit() || (first == '.' && source.getOrNull(at + 1)?.isDigit() == true) -> TokenKind.NUMBER
                        else -> TokenKind.SIGN
                    }
                val end = end(kind)
                val text = source.substring(at, end)
                tokens += Token(kind, text)
                at = end
                isLineStart =
                    if (kind == TokenKind.SPACE) isLineStart || '\n' in text || '\r' in text else kind == TokenKind.COMMENT && isLineStart
            }
            return tokens
        }

        private fun end(kind: TokenKind): Int =
            when (kind) {
                TokenKind.SPACE -> skip(at) { source[it].isWhitespace() }
                TokenKind.COMMENT -> comment()
                TokenKind.DIRECTIVE -> skip(at) { !isEndOfLine(it) && !isComment(it) }
                TokenKind.WORD -> skip(at) { isLetter(source[it]) || source[it].isDigit() }
                TokenKind.NUMBER -> skip(at) { isLetter(source[it]) || source[it].isDigit() || source[it] == '.' || isSignOfExponent(it) }
                TokenKind.SIGN -> at + 1
            }

        private fun comment(): Int {
            if (source[at + 1] == '/') return skip(at) { !isEndOfLine(it) }
            val end = source.indexOf("*/", at + 2)
            return if (end < 0) source.length else end + 2
        }

        /** A line that ends in a backslash goes on in the next. */
        private fun isEndOfLine(i: Int) =
            (source[i] == '\n' || source[i] == '\r') && source[i - 1] != '\\' && !source.startsWith("\\\r\n", i - 2)

        private fun isComment(i: Int) = source[i] == '/' && source.getOrNull(i + 1).let { it == '/' || it == '*' }

        private fun isSignOfExponent(i: Int) =
            (source[i] == '+' || source[i] == '-') && source[i - 1] in "eE" && !source.startsWith("0x", at, ignoreCase = true)

        private fun isLetter(letter: Char) = letter in 'a'..'z' || letter in 'A'..'Z' || letter == '_'

        private inline fun skip(
            from: Int,
            isInside: (Int) -> Boolean,
        ): Int {
            var end = from + 1
            while (end < source.length && isInside(end)) end++
            return end
        }
    }
}

/** The source that the tokens are, each said as [say] has it. */
internal fun List<Token>.text(say: (Token) -> String = { it.text }): String = joinToString("", transform = say)

/** The GLSL [source] without what is not read of it. */
internal fun withoutComments(source: String): String =
    GlslTokens.of(source).text { token ->
        when {
            token.kind != TokenKind.COMMENT -> token.text
            token.text.startsWith("/*") -> " "
            else -> ""
        }
    }

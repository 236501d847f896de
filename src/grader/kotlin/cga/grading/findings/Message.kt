package cga.grading.findings

/**
 * What is to be said to a reader, in whatever language: the text that the message files have under [key], with [arguments] in its places.
 *
 * Text that has no words of ours (a log, a line of an exception) is [plain].
 *
 * @param arguments each a name (a [String]: the submission's own, shown as it is), a [Number], another [Message], or a list of these.
 */
public data class Message(
    public val key: String,
    public val arguments: List<Any> = emptyList(),
) {
    init {
        arguments.forEach(::check)
    }

    /** Whether there is nothing to say. */
    public val isEmpty: Boolean get() = this == NONE

    /** What it says, for whoever looks into a case: the key and the arguments. */
    override fun toString(): String =
        (if (key == PLAIN) "" else "$key ") + arguments.joinToString(" ")

    private fun check(argument: Any) {
        require(argument is String || argument is Number || argument is Message || argument is List<*>) {
            "${argument::class.simpleName} is no argument of the message $key"
        }
        if (argument is List<*>) argument.forEach { check(it ?: "null") }
    }

    public companion object {
        internal const val PLAIN = "plain"
        internal const val SENTENCES = "sentences"

        /** The text under [key] with [arguments] in its places. */
        public fun of(
            key: String,
            vararg arguments: Any,
        ): Message = Message(key, arguments.toList())

        /** [text] as it is, in every language. */
        public fun plain(text: String): Message = Message(PLAIN, listOf(text))

        /** One message after another. */
        public fun sentences(messages: List<Message>): Message =
            messages.filterNot { it.isEmpty }.let { told -> told.singleOrNull() ?: if (told.isEmpty()) NONE else Message(SENTENCES, told) }

        /** Nothing to say. */
        public val NONE: Message = plain("")
    }
}

package cga.inspect.view

/**
 * One of the numbers that a [Look] is made of, so that it can be written down.
 *
 * @param word its name there.
 * @param max the largest value; the least is 0.
 * @param isWhole whether there is nothing between 1 and 2.
 */
internal enum class LookNumber(
    val word: String,
    private val max: Int,
    private val get: Get,
    private val isWhole: Boolean = true,
    private val set: (Look, Float) -> Unit,
) {
    VIEW("view", View.entries.lastIndex, { it.view.ordinal.toFloat() }, set = { look, value -> look.view = View.entries[value.toInt()] }),
    LIGHT("light", Look.MAX_LIGHTS - 1, { it.light.toFloat() }, set = { look, value -> look.light = value.toInt() }),

    /** A bit for each light that is off. */
    OFF("off", (1 shl Look.MAX_LIGHTS) - 1, { it.off.toFloat() }, set = { look, value -> look.off = value.toInt() }),
    SPLIT("split", 1, { if (it.isSplit) 1f else 0f }, set = { look, value -> look.isSplit = value == 1f }),
    DIVIDER("divider", 1, { it.divider }, isWhole = false, set = { look, value -> look.divider = value }),
    GIZMOS("gizmos", 1, { if (it.hasGizmos) 1f else 0f }, set = { look, value -> look.hasGizmos = value == 1f }),
    ;

    /** As (Look) -> Float, but without an object for the answer: it is asked in every update. */
    fun interface Get {
        fun of(look: Look): Float
    }

    fun get(look: Look): Float = get.of(look)

    /** Gives [look] the [value], which it must be able to [take][takes]. */
    fun set(
        look: Look,
        value: Float,
    ): Unit = set.invoke(look, value)

    fun takes(value: Float): Boolean = value in 0f..max.toFloat() && (!isWhole || value == value.toInt().toFloat())
}

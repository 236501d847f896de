package cga.inspect.view

import cga.framework.SpecularModel

/** How the scene is looked at: what the panel switches and the programs obey. Changes nothing of the scene itself. */
internal class Look {
    var view: View = View.FULL

    /** The light that a view of one light speaks of: the point lights first, then the spotlights. */
    var light: Int = 0

    /** Whether Phong is shown on the left and Blinn-Phong on the right of the divider. */
    var isSplit: Boolean = false

    /** Where the divider is, as a share of the width. */
    var divider: Float = 0.5f
        set(value) {
            field = value.coerceIn(0f, 1f)
        }

    /** The specular model in place of the scene's, or null. */
    var specularModel: SpecularModel? = null

    private val off = BooleanArray(MAX_LIGHTS)

    /** Whether light number [light] shines. */
    fun isOn(light: Int): Boolean = !off[light]

    val areAllOn: Boolean get() = off.none { it }

    fun switch(
        light: Int,
        isOn: Boolean,
    ) {
        off[light] = !isOn
    }

    /** All lights but [light] go off; again, and all go on. */
    fun solo(light: Int) {
        val isSolo = off.indices.all { off[it] == (it != light) }
        for (i in off.indices) off[i] = !isSolo && i != light
        this.light = light
    }

    /** Everything as at the start. */
    fun reset() {
        view = View.FULL
        isSplit = false
        divider = 0.5f
        off.fill(false)
    }

    companion object {
        /** As many as the shaders have room for. */
        const val MAX_LIGHTS: Int = 10
    }
}

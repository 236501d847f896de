package cga.inspect.view

import cga.framework.SpecularModel

/** How the scene is looked at: what the panel and the keys switch and the programs obey. Changes nothing of the scene itself. */
internal class Look {
    var view: View = View.FULL

    /** Number of the light that a view of one light speaks of. */
    var light: Int = 0

    /** Whether Phong is shown on the left and Blinn-Phong on the right of the divider. */
    var isSplit: Boolean = false

    /** Where the divider is, as a share of the width. */
    var divider: Float = 0.5f
        set(value) {
            field = value.coerceIn(0f, 1f)
        }

    /** Whether the lights are marked. */
    var hasGizmos: Boolean = false

    /** The specular model in place of the scene's, or null. */
    var specularModel: SpecularModel? = null

    /** A bit for each light that does not shine. */
    var off: Int = 0

    /** Whether light number [light] shines. */
    fun isOn(light: Int): Boolean = off and (1 shl light) == 0

    val areAllOn: Boolean get() = off == 0

    fun switch(
        light: Int,
        isOn: Boolean,
    ) {
        off = if (isOn) off and (1 shl light).inv() else off or (1 shl light)
    }

    /** All lights but [light] go off; again, and all go on. */
    fun solo(light: Int) {
        val others = ALL and (1 shl light).inv()
        off = if (off == others) 0 else others
        this.light = light
    }

    /** The same, which stays as it is now. */
    fun copy(): Look {
        val copy = Look()
        copy.view = view
        copy.light = light
        copy.off = off
        return copy
    }

    /** Everything as at the start. */
    fun reset() {
        view = View.FULL
        isSplit = false
        divider = 0.5f
        hasGizmos = false
        off = 0
    }

    companion object {
        /** As many as the shaders have room for. */
        const val MAX_LIGHTS: Int = 10
        private const val ALL = (1 shl MAX_LIGHTS) - 1
    }
}

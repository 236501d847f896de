package cga.inspect.view

/** Which of the scene's uniforms have to be black, so that of all terms and lights the shader shows those that [look] wants. */
internal class HiddenTerms(private val look: Look) {
    /** Whether there is a texture that [isTexture]. */
    val isAnyTexture: Boolean get() = look.view == View.DIFFUSE || look.view == View.SPECULAR

    /** Whether the sampler called [name] has to read black. */
    fun isTexture(name: String): Boolean =
        when (name) {
            "material.diffuse" -> look.view == View.SPECULAR
            "material.specular" -> look.view == View.DIFFUSE
            else -> false
        }

    /** Whether the colour called [name] has to be black. */
    fun isColor(name: String): Boolean {
        val view = look.view
        if (name == "emissiveTint") return view != View.FULL && view != View.EMISSION
        if (name == "ambient") return view != View.FULL && view != View.AMBIENT
        val light = light(name)
        return light != NO_LIGHT && (view == View.EMISSION || view == View.AMBIENT || !look.isOn(light))
    }

    /** The number of the light whose colour the uniform [name] is. */
    private fun light(name: String): Int {
        if (!name.startsWith(LIGHT) || !name.endsWith("].color")) return NO_LIGHT
        return (name[LIGHT.length] - '0').coerceAtMost(Look.MAX_LIGHTS - 1)
    }

    private companion object {
        const val NO_LIGHT = -1
        const val LIGHT = "light["
    }
}

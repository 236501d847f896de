package cga.exercise.game

import cga.framework.SpecularModel

/**
 * The steps of the sheet, each a superset of the one before: what of the scene is on.
 *
 * @param sheet the task's number, by which the step is called.
 * @param title what the step adds, in a few words.
 */
public enum class Step(
    public val sheet: String,
    public val title: String,
    internal val pointLight: Boolean = true,
    internal val spotLight: Boolean = true,
    public val attenuation: Boolean = true,
    internal val color: Boolean = true,
    public val turnsWithMouse: Boolean = true,
    internal val cornerLights: Boolean = true,
    public val specularModel: SpecularModel = SpecularModel.PHONG,
) {
    EMISSION(
        "4.1",
        "emission only",
        pointLight = false,
        spotLight = false,
        attenuation = false,
        color = false,
        turnsWithMouse = false,
        cornerLights = false,
    ),
    POINT_LIGHT("4.2", "point light", spotLight = false, attenuation = false, color = false, turnsWithMouse = false, cornerLights = false),
    SPOT_LIGHT("4.3", "spotlight", attenuation = false, color = false, turnsWithMouse = false, cornerLights = false),
    ATTENUATION("4.3.4", "attenuation", color = false, turnsWithMouse = false, cornerLights = false),
    COLOR("4.4", "colour", turnsWithMouse = false, cornerLights = false),
    ORBIT("4.5", "mouse orbit", cornerLights = false),
    MORE_LIGHTS("4.6", "corner lights"),
    BLINN_PHONG("4.7", "Blinn-Phong", specularModel = SpecularModel.BLINN_PHONG),
    ;

    public companion object {
        /** The finished sheet. */
        public val FINAL: Step = entries.last()

        /** The step called [sheet], or null. */
        public fun of(sheet: String): Step? = entries.find { it.sheet == sheet }
    }
}

package cga.grading.sheet4.scene

import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * What an edition of the sheet asks of the scene in numbers.
 *
 * @param pointK (K_c, K_l, K_q) of the motorcycle's point light; null: any that fades with distance.
 * @param spotK likewise of the spotlight.
 * @param radiansPerPixel what a pixel of the mouse turns the camera by; null: any.
 */
public class SceneProfile(public val pointK: Vector3dc?, public val spotK: Vector3dc?, public val radiansPerPixel: Double? = 0.002) {
    public companion object {
        /** The sheet of 2020/21: Table 1. */
        public val SHEET: SceneProfile = SceneProfile(Vector3d(1.0, 0.5, 0.1), Vector3d(0.5, 0.05, 0.01))

        /** From 2022 on: the attenuation is free, 1/d² as a rule. */
        public val LATER: SceneProfile = SceneProfile(null, null)
    }
}

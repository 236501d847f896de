package cga.inspect.probe

import cga.framework.SpecularModel
import org.joml.Vector3dc
import java.util.Locale

/** A probed pixel in words and numbers, as the panel shows them: made once a click. */
internal class ProbeText(probed: Probed) {
    /** One line: name and values. */
    class Line(
        val name: String,
        val value: String,
    )

    val where: String = "pixel ${probed.column}, ${probed.row} at t = ${number(probed.time, 2)} s · ${probed.look.view}"

    /** The numbers of the point that no light has a part in. */
    val surface: List<Line> = surface(probed)

    /** A title for each light, and its numbers. */
    val lights: List<Pair<String, List<Line>>> = lights(probed)

    val expected: String = color(probed.expected)
    val drawn: String = color(probed.drawn)
    val shown: String = probed.shown.joinToString("  ")
    val difference: String = "${number(probed.difference, 3)} of 255"

    private fun surface(probed: Probed): List<Line> {
        val point = probed.point ?: return listOf(Line("nothing is drawn here", ""))
        val isGround = point.draw == 0
        return listOf(
            Line("object", if (isGround) "ground" else "motorcycle, mesh ${point.draw}"),
            Line("position (view space)", color(point.position)),
            Line("n", color(point.normal)),
            Line("v", color(point.toCamera)),
            Line("M_e", color(point.emissive)),
            Line("M_d", color(point.diffuse)),
            Line("M_s", color(point.specular)),
            Line("k", number(probed.frame.draws[point.draw].material.shininess.toDouble(), 1)),
            Line("A  emission", color(point.emission)),
            Line("B  ambient", color(point.ambient)),
        )
    }

    private fun lights(probed: Probed): List<Pair<String, List<Line>>> {
        val point = probed.point ?: return emptyList()
        val isBlinnPhong = probed.frame.specularModel == SpecularModel.BLINN_PHONG
        return point.lights.mapIndexed { i, light ->
            "light[$i]" to
                listOf(
                    Line("d", number(light.distance, 4)),
                    Line("F", number(light.attenuation, 6)),
                    Line("I", number(light.cone, 6)),
                    Line("θ", "${number(Math.toDegrees(light.theta), 3)}°"),
                    Line("n·l = cos α", number(light.cosAlpha, 6)),
                    Line(if (isBlinnPhong) "n·h = cos β" else "r·v = cos β", number(light.cosBeta, 6)),
                    Line("C  diffuse", color(light.diffuse)),
                    Line("D  specular", color(light.specular)),
                )
        }
    }

    companion object {
        /** With so many digits behind the point, whatever the locale. */
        fun number(
            x: Double,
            digits: Int,
        ): String = "%.${digits}f".format(Locale.ROOT, x)

        private fun color(v: Vector3dc) = "${number(v.x(), 4)}  ${number(v.y(), 4)}  ${number(v.z(), 4)}"
    }
}

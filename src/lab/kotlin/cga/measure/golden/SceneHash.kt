package cga.measure.golden

import cga.framework.Frame
import cga.framework.FrameDraw
import cga.framework.FrameTexture
import cga.imaging.golden.Checksum
import org.joml.Matrix4dc
import org.joml.Matrix4fc
import org.joml.Vector3dc
import org.joml.Vector3fc

/**
 * Hashes of the parameters of a scene, a hash a part so that it can be told which changed. Vertices and texels are not among them, which
 * are files. Doubles count as floats: the last bit of a JVM's `sin` is no change.
 */
internal object SceneHash {
    fun of(frame: Frame): Map<String, String> =
        linkedMapOf(
            "scene camera" to hex { add(frame.view).add(frame.projection) },
            "scene shading" to hex { add(frame.ambient).add(frame.specularModel.name).add(frame.gamma) },
            "scene lights" to hex { lights(frame) },
            "scene placement" to hex { frame.draws.forEach { add(it.model).add(it.tint) } },
            "scene materials" to hex { frame.draws.forEach { material(it) } },
        )

    private fun hex(fill: Checksum.() -> Unit): String = Checksum().apply(fill).hex()

    private fun Checksum.lights(frame: Frame) {
        add(frame.lights.size)
        for (light in frame.lights) {
            add(light.position).add(light.color).add(light.attenuation)
            light.cone?.let { add(it.direction).add(it.innerAngle).add(it.outerAngle) }
        }
    }

    private fun Checksum.material(draw: FrameDraw) {
        val material = draw.material
        add(material.shininess).add(material.tcMultiplier.x()).add(material.tcMultiplier.y())
        listOf(material.emissive, material.diffuse, material.specular).forEach { sampling(it) }
    }

    private fun Checksum.sampling(texture: FrameTexture) {
        add(texture.wrapS).add(texture.wrapT).add(texture.minFilter).add(texture.magFilter)
    }

    private fun Checksum.add(v: Vector3fc) = add(v.x()).add(v.y()).add(v.z())

    private fun Checksum.add(v: Vector3dc) = add(v.x().toFloat()).add(v.y().toFloat()).add(v.z().toFloat())

    private fun Checksum.add(m: Matrix4fc) = apply { m.get(FloatArray(16)).forEach { add(it) } }

    private fun Checksum.add(m: Matrix4dc) = apply { m.get(FloatArray(16)).forEach { add(it) } }
}

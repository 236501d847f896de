package cga.reader.run

import cga.reader.fragment
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Test

/** What a sampler is asked is what the shader says. */
class TextureTest {
    private class Asked : Sampler {
        val looks = ArrayList<String>()
        var reference: Double? = null

        override fun sample(look: TextureLook, result: DoubleArray) {
            reference = look.reference
            val parts = listOf(
                look.coordinates.asList(),
                if (look.isFetch) "fetch" else null,
                look.level?.let { "level $it" },
                look.bias.takeIf { it != 0.0 }?.let { "bias $it" },
                look.gradientX.takeIf { it.isNotEmpty() }?.let { "along x ${it.asList()} y ${look.gradientY.asList()}" },
                look.offset.takeIf { it.isNotEmpty() }?.let { "offset ${it.asList()}" },
            )
            looks += parts.filterNotNull().joinToString(" ")
            for (i in result.indices) result[i] = i + 1.0
        }

        override fun size(level: Int) = intArrayOf(64 shr level, 32 shr level, 3)
    }

    @Test
    fun `looks of every sort`() {
        assertLook("[0.25, 0.5]", "sampler2D", "texture(t, uv)")
        assertLook("[0.25, 0.5] bias 2.0", "sampler2D", "texture(t, uv, 2.0)")
        assertLook("[0.25, 0.5] level 3.0", "sampler2D", "textureLod(t, uv, 3.0)")
        assertLook("[0.25, 0.5] along x [0.5, 0.25] y [1.0, 2.0]", "sampler2D", "textureGrad(t, uv, uv.yx, vec2(1.0, 2.0))")
        assertLook("[0.25, 0.5] offset [1, -2]", "sampler2D", "textureOffset(t, uv, ivec2(1, -2))")
        assertLook("[0.125, 0.25]", "sampler2D", "textureProj(t, vec3(uv, 2.0))")
        assertLook("[0.125, 0.25]", "sampler2D", "textureProj(t, vec4(uv, 9.0, 2.0))")
        assertLook("[3.0, 4.0] fetch level 1.0", "sampler2D", "texelFetch(t, ivec2(3, 4), 1)")
        assertLook("[0.25, 0.5, 1.0]", "samplerCube", "texture(t, vec3(uv, 1.0))")
        assertLook("[0.25, 0.5, 2.0]", "sampler2DArray", "texture(t, vec3(uv, 2.0))")
        assertLook("[0.25]", "sampler1D", "texture(t, uv.x)")
    }

    @Test
    fun `a shadow sampler is asked with what to compare`() {
        val sampler = look("sampler2DShadow", "vec4(texture(t, vec3(uv, 0.75)))")
        assertEquals(listOf("[0.25, 0.5]"), sampler.looks)
        assertEquals(0.75, sampler.reference)
        assertEquals(0.375, look("sampler2DShadow", "vec4(textureProj(t, vec4(uv, 0.75, 2.0)))").reference)
        assertNull(look("sampler2D", "texture(t, uv)").reference)
    }

    @Test
    fun `a texture has a size`() {
        val machine =
            Machine(fragment("color = vec4(textureSize(t, 1), textureSize(a, 0).yz);", "uniform sampler2D t; uniform sampler2DArray a;"))
        for (slot in machine.shader.uniforms) machine[slot] = Asked()
        machine.run()
        assertEquals(listOf(32.0, 16.0, 32.0, 3.0), machine["color"].asList())
    }

    @Test
    fun `a sampler that is missing is an outcome`() {
        assertEquals(Outcome.NO_SAMPLER, Machine(fragment("color = texture(t, vec2(0.5));", "uniform sampler2D t;")).run())
    }

    private fun assertLook(expected: String, type: String, call: String) = assertEquals(listOf(expected), look(type, call).looks, call)

    private fun look(type: String, call: String): Asked {
        val machine = Machine(fragment("color = $call;", "uniform $type t; uniform vec2 uv;"))
        machine["uv"] = doubleArrayOf(0.25, 0.5)
        val sampler = Asked()
        machine[machine.shader.uniforms.single { it.name == "t" }] = sampler
        assertEquals(Outcome.DONE, machine.run())
        return sampler
    }
}

package cga.measure.mutation

import cga.framework.image.ImageData

private val MAPS = listOf("emissive", "diffuse", "specular")

/** The same change of how each of the three textures is read. */
private fun Part.sampling(
    name: String,
    sample: (map: String) -> String,
) = Mutant(this, name, MAPS.map { TextEdit("shaders/scene.frag", "texture(material.$it, surfaceTexCoord)", sample("material.$it")) })

private fun Part.texture(
    name: String,
    vararg files: String,
    repaint: (ImageData) -> ImageData,
) = Mutant(this, name, files.map { TextureEdit("assets/$it", repaint) })

private fun nearest(map: String): String {
    val texel = "(floor(surfaceTexCoord * vec2(textureSize($map, 0))) + 0.5) / vec2(textureSize($map, 0))"
    return "textureGrad($map, $texel, dFdx(surfaceTexCoord), dFdy(surfaceTexCoord))"
}

internal val TEXTURE_MUTANTS: List<Mutant> =
    with(Part.TEXTURES) {
        listOf(
            texture("ground's lines one texel to the right", "ground/ground_emissive.png") { it.moved(1) },
            texture("body's colours one texel to the right", "motorcycle/body_diffuse.png") { it.moved(1) },
            texture("one texel of the ground white", "ground/ground_emissive.png") { image ->
                image.repainted { x, y -> if (x == 100 && y == 100) 255 else texel(x, y) }
            },
            texture("one texel of the body white", "motorcycle/body_emissive.png") { image ->
                image.repainted { x, y -> if (x == 500 && y == 500) 255 else texel(x, y) }
            },
            texture("ground's lines 2/255 darker", "ground/ground_emissive.png") { image ->
                image.repainted { x, y -> maxOf(0, texel(x, y) - 2) }
            },
            texture("tyres without their pattern", "motorcycle/tyre_emissive.png") { image -> image.repainted { _, _ -> 0 } },
            vertex("ground's textures repeat 63 times", "texCoord * tcMultiplier", "texCoord * (tcMultiplier - step(2.0, tcMultiplier))"),
            sampling("textures read without mipmaps") { "textureLod($it, surfaceTexCoord, 0.0)" },
            sampling("textures read one mip level too coarse") { "texture($it, surfaceTexCoord, 1.0)" },
            sampling("textures read without interpolation", ::nearest),
            fragment("specular colours read from the diffuse texture", "texture(material.specular,", "texture(material.diffuse,"),
        )
    }

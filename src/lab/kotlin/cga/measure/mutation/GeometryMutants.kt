package cga.measure.mutation

import org.lwjgl.opengl.GL33C.*

private const val PLACE = "gl_Position = projection * vec4(positionView, 1.0);"
private const val GROUND = "assets/ground/ground.obj"
private const val MOTORCYCLE = "assets/motorcycle/motorcycle.obj"

private fun Part.model(
    name: String,
    file: String,
    old: String,
    new: String,
) = Mutant(this, name, listOf(TextEdit(file, old, new)))

internal val GEOMETRY_MUTANTS: List<Mutant> =
    with(Part.GEOMETRY) {
        listOf(
            model("one triangle of the ground missing", GROUND, "f 144/144/1 145/145/1 162/162/1\n", ""),
            model("one triangle of the fin missing", MOTORCYCLE, "f 17668/9739/18471 17670/9743/18478 17669/9742/18474\n", ""),
            model("one small triangle of the body missing", MOTORCYCLE, "f 17665/9733/18466 17667/9738/18470 17666/9735/18468\n", ""),
            model("one vertex of the fin 1 cm off", MOTORCYCLE, "v 0.2540 1.0946 1.6989\n", "v 0.2640 1.0946 1.6989\n"),
            model("one vertex of the ground 5 cm too high", GROUND, "v -2.8000 0.0000 0.0000\n", "v -2.8000 0.0500 0.0000\n"),
            // tan 45° / tan 45.05°
            vertex("field of view +0.1°", PLACE, "$PLACE gl_Position.xy *= 0.9982563;"),
            vertex(
                "camera pitched by 0.1°",
                PLACE,
                PLACE.replace("positionView", "positionView + 0.0017453 * vec3(0.0, -positionView.z, positionView.y)"),
            ),
            // Of a near plane at 1 and a far plane at 100; only what lies before the near plane and the depth's rounding can differ.
            vertex("near plane at 1", PLACE, "$PLACE gl_Position.z = (-101.0 * positionView.z - 200.0) / 99.0;"),
            vertex("near plane at 3", PLACE, "$PLACE gl_Position.z = (-103.0 * positionView.z - 600.0) / 97.0;"),
            vertex("half a pixel to the right", PLACE, "$PLACE gl_Position.x += gl_Position.w / 480.0;"),
            vertex("a tenth of a pixel to the right", PLACE, "$PLACE gl_Position.x += gl_Position.w / 4800.0;"),
            Mutant(this, "no depth test", beforeRender = { glDepthFunc(GL_ALWAYS) }, afterRender = { glDepthFunc(GL_LESS) }),
            Mutant(this, "front faces culled", beforeRender = { glCullFace(GL_FRONT) }, afterRender = { glCullFace(GL_BACK) }),
            Mutant(this, "no antialiasing", beforeRender = { glDisable(GL_MULTISAMPLE) }, afterRender = { glEnable(GL_MULTISAMPLE) }),
        )
    }

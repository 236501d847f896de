package cga.exercise.game

import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.components.texture.Texture2D
import cga.framework.GameWindow
import cga.framework.ModelLoader
import cga.framework.OBJLoader
import org.joml.Math.toRadians
import org.joml.Matrix4f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL30.*
import java.io.File
import kotlin.math.cos
import kotlin.math.sin

class Scene(private val window: GameWindow) {
    val prog: Int
    val ground: Mesh
    val bike: List<Mesh>

    // motorcycle
    var bikePos = Vector3f(0f, 0f, 0f)
    var bikeAngle = 0f
    val bikeMat = Matrix4f()

    // camera
    var camAngle = 0f
    var firstMouse = true
    var lastX = 0.0

    // light and spot are relative to the motorcycle, the others in the world
    val light = PointLight(Vector3f(0f, 1.6f, 0.2f), Vector3f(1f, 1f, 1f))
    val spot = SpotLight(Vector3f(0f, 1f, -1.7f), Vector3f(0f, -0.2f, -1f), Vector3f(3f, 3f, 2.5f), toRadians(13f), toRadians(24f))
    val red = PointLight(Vector3f(-12f, 2f, -12f), Vector3f(7f, 0.5f, 0.5f))
    val green = PointLight(Vector3f(12f, 2f, -12f), Vector3f(0.5f, 7f, 0.5f))
    val blue = PointLight(Vector3f(-12f, 2f, 12f), Vector3f(0.5f, 0.5f, 7f))
    val yellow = PointLight(Vector3f(12f, 2f, 12f), Vector3f(6f, 6f, 0.5f))

    init {
        // shader
        val vs = glCreateShader(GL_VERTEX_SHADER)
        glShaderSource(vs, File("assets/shaders/tron_vert.glsl").readText())
        glCompileShader(vs)
        if (glGetShaderi(vs, GL_COMPILE_STATUS) == 0) throw Exception("vs: " + glGetShaderInfoLog(vs))
        val fs = glCreateShader(GL_FRAGMENT_SHADER)
        glShaderSource(fs, File("assets/shaders/tron_frag.glsl").readText())
        glCompileShader(fs)
        if (glGetShaderi(fs, GL_COMPILE_STATUS) == 0) throw Exception("fs: " + glGetShaderInfoLog(fs))
        prog = glCreateProgram()
        glAttachShader(prog, vs)
        glAttachShader(prog, fs)
        glLinkProgram(prog)
        if (glGetProgrami(prog, GL_LINK_STATUS) == 0) throw Exception("link: " + glGetProgramInfoLog(prog))

        glClearColor(0f, 0f, 0f, 1f)
        glEnable(GL_DEPTH_TEST)
        glEnable(GL_CULL_FACE)

        // ground
        val obj = OBJLoader.loadOBJ("assets/models/ground.obj")
        val attr = arrayOf(VertexAttribute(3, 32, 0), VertexAttribute(2, 32, 12), VertexAttribute(3, 32, 20))
        val diff = Texture2D("assets/textures/ground_diff.png", true)
        val emit = Texture2D("assets/textures/ground_emit.png", true)
        val spec = Texture2D("assets/textures/ground_spec.png", true)
        diff.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        emit.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        spec.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        ground = Mesh(obj.vertexData, obj.indexData, attr, Material(diff, emit, spec, 60f, 64f))

        // motorcycle
        bike = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0f, 0f, 0f)!!.meshes
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        glUseProgram(prog)

        // camera turns around the motorcycle
        val a = bikeAngle + camAngle
        val eye = Vector3f(bikePos).add(3.2f * sin(a), 2.2f, 3.2f * cos(a))
        val center = Vector3f(bikePos).add(0f, 0.5f, 0f)
        val view = Matrix4f().lookAt(eye, center, Vector3f(0f, 1f, 0f))
        val proj = Matrix4f().perspective(toRadians(80f), 16f / 9f, 0.1f, 100f)
        glUniformMatrix4fv(glGetUniformLocation(prog, "v"), false, view.get(FloatArray(16)))
        glUniformMatrix4fv(glGetUniformLocation(prog, "p"), false, proj.get(FloatArray(16)))

        bikeMat.translation(bikePos).rotateY(bikeAngle).scale(0.8f)

        // colour of the motorcycle and its light
        val r = 0.5f + 0.5f * sin(t)
        val g = 0.5f + 0.5f * sin(t * 0.7f + 2f)
        val b = 0.5f + 0.5f * sin(t * 1.3f + 4f)
        light.col.set(r, g, b)

        // lights
        val lp = bikeMat.transformPosition(light.pos, Vector3f())
        glUniform3f(glGetUniformLocation(prog, "lightPos"), lp.x, lp.y, lp.z)
        glUniform3f(glGetUniformLocation(prog, "lightCol"), light.col.x, light.col.y, light.col.z)
        glUniform3f(glGetUniformLocation(prog, "lightK"), light.k.x, light.k.y, light.k.z)

        val sp = bikeMat.transformPosition(spot.pos, Vector3f())
        val sd = bikeMat.transformDirection(spot.dir, Vector3f())
        glUniform3f(glGetUniformLocation(prog, "spotPos"), sp.x, sp.y, sp.z)
        glUniform3f(glGetUniformLocation(prog, "spotDir"), sd.x, sd.y, sd.z)
        glUniform3f(glGetUniformLocation(prog, "spotCol"), spot.col.x, spot.col.y, spot.col.z)
        glUniform3f(glGetUniformLocation(prog, "spotK"), spot.k.x, spot.k.y, spot.k.z)
        glUniform2f(glGetUniformLocation(prog, "spotCone"), cos(spot.inner), cos(spot.outer))

        glUniform3f(glGetUniformLocation(prog, "redPos"), red.pos.x, red.pos.y, red.pos.z)
        glUniform3f(glGetUniformLocation(prog, "redCol"), red.col.x, red.col.y, red.col.z)
        glUniform3f(glGetUniformLocation(prog, "redK"), red.k.x, red.k.y, red.k.z)
        glUniform3f(glGetUniformLocation(prog, "greenPos"), green.pos.x, green.pos.y, green.pos.z)
        glUniform3f(glGetUniformLocation(prog, "greenCol"), green.col.x, green.col.y, green.col.z)
        glUniform3f(glGetUniformLocation(prog, "greenK"), green.k.x, green.k.y, green.k.z)
        glUniform3f(glGetUniformLocation(prog, "bluePos"), blue.pos.x, blue.pos.y, blue.pos.z)
        glUniform3f(glGetUniformLocation(prog, "blueCol"), blue.col.x, blue.col.y, blue.col.z)
        glUniform3f(glGetUniformLocation(prog, "blueK"), blue.k.x, blue.k.y, blue.k.z)
        glUniform3f(glGetUniformLocation(prog, "yellowPos"), yellow.pos.x, yellow.pos.y, yellow.pos.z)
        glUniform3f(glGetUniformLocation(prog, "yellowCol"), yellow.col.x, yellow.col.y, yellow.col.z)
        glUniform3f(glGetUniformLocation(prog, "yellowK"), yellow.k.x, yellow.k.y, yellow.k.z)

        // ground in green
        glUniformMatrix4fv(glGetUniformLocation(prog, "m"), false, Matrix4f().get(FloatArray(16)))
        glUniform3f(glGetUniformLocation(prog, "tint"), 0f, 1f, 0f)
        draw(ground)

        // motorcycle
        glUniformMatrix4fv(glGetUniformLocation(prog, "m"), false, bikeMat.get(FloatArray(16)))
        glUniform3f(glGetUniformLocation(prog, "tint"), r, g, b)
        for (mesh in bike) draw(mesh)
    }

    fun draw(mesh: Mesh) {
        mesh.material.diff.bind(0)
        mesh.material.spec.bind(1)
        mesh.material.emit.bind(2)
        glUniform1i(glGetUniformLocation(prog, "diffTex"), 0)
        glUniform1i(glGetUniformLocation(prog, "specTex"), 1)
        glUniform1i(glGetUniformLocation(prog, "emitTex"), 2)
        glUniform1f(glGetUniformLocation(prog, "shine"), mesh.material.shininess)
        glUniform2f(glGetUniformLocation(prog, "tiles"), mesh.material.tiles, mesh.material.tiles)
        glBindVertexArray(mesh.vao)
        glDrawElements(GL_TRIANGLES, mesh.count, GL_UNSIGNED_INT, 0)
        glBindVertexArray(0)
    }

    fun update(dt: Float, t: Float) {
        var speed = 0f
        if (window.getKeyState(GLFW_KEY_W)) speed = 5f
        if (window.getKeyState(GLFW_KEY_S)) speed = -3f
        if (speed != 0f && window.getKeyState(GLFW_KEY_A)) bikeAngle += 1.5f * dt
        if (speed != 0f && window.getKeyState(GLFW_KEY_D)) bikeAngle -= 1.5f * dt
        bikePos.x -= sin(bikeAngle) * speed * dt
        bikePos.z -= cos(bikeAngle) * speed * dt
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        if (firstMouse) {
            lastX = xpos
            firstMouse = false
        }
        camAngle -= ((xpos - lastX) * 0.002).toFloat()
        lastX = xpos
    }

    fun cleanup() {
        glDeleteProgram(prog)
    }
}

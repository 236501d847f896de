package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.*
import cga.exercise.components.light.*
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import cga.framework.GameWindow
import cga.framework.ModelLoader
import cga.framework.OBJLoader
import org.joml.*
import org.joml.Math.*
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*

class Scene(private val window: GameWindow) {
    val s = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")
    val g: Renderable
    val m: Renderable
    val cam = TronCamera()

    var pl = PointLight(Vector3f(0f, 1.9f, 0.4f), Vector3f(1f, 1f, 1f))
    var sl = SpotLight(Vector3f(0f, 0.9f, -1.6f), Vector3f(2.6f, 2.6f, 2.2f), toRadians(11f), toRadians(21f))
    var e1 = PointLight(Vector3f(17f, 1.3f, 17f), Vector3f(0f, 5f, 7f))
    var e2 = PointLight(Vector3f(-17f, 1.3f, 17f), Vector3f(7f, 3f, 0f))
    var e3 = PointLight(Vector3f(17f, 1.3f, -17f), Vector3f(7f, 0f, 4f))
    var e4 = PointLight(Vector3f(-17f, 1.3f, -17f), Vector3f(2f, 1f, 8f))

    var mx = 0.0
    var mn = 0
    //var my = 0.0

    init {
        glClearColor(0f, 0f, 0f, 1f)
        glEnable(GL_CULL_FACE)
        glFrontFace(GL_CCW)
        glCullFace(GL_BACK)
        glEnable(GL_DEPTH_TEST)
        glDepthFunc(GL_LESS)

        val t1 = Texture2D("assets/textures/ground_diff.png", true)
        t1.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val t2 = Texture2D("assets/textures/ground_emit.png", true)
        t2.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val t3 = Texture2D("assets/textures/ground_spec.png", true)
        t3.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val o = OBJLoader.loadOBJ("assets/models/ground.obj")
        val va = arrayOf(VertexAttribute(3, 32, 0), VertexAttribute(2, 32, 12), VertexAttribute(3, 32, 20))
        g = Renderable(mutableListOf(Mesh(o.vertexData, o.indexData, va, Material(t1, t2, t3, 60f, Vector2f(64f, 64f)))))

        m = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0f, 0f, 0f)!!
        m.scaleLocal(Vector3f(0.8f))

        cam.parent = m
        cam.rotateLocal(-0.55f, 0f, 0f)
        cam.translateLocal(Vector3f(0f, 0.2f, 4.4f))

        pl.parent = m
        sl.parent = m
        sl.rotateLocal(-0.2f, 0f, 0f)
        //sl.rotateLocal(0.2f, 0f, 0f) // leuchtet in den himmel
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        s.use()

        val v = cam.getCalculateViewMatrix()
        cam.bind(s)

        // 4.4
        val a = sin(t * 0.6f)
        val b = sin(t * 0.9f + 1f)
        val c = sin(t * 0.4f + 2f)
        val f = Vector3f(a * a, b * b, c * c)
        //val f = Vector3f(sin(t), sin(t), sin(t)) // wird schwarz

        pl.c = f
        PointLight.v = v
        pl.bind(s, "pl")
        sl.bind(s, "sl", v)
        e1.bind(s, "e1")
        e2.bind(s, "e2")
        e3.bind(s, "e3")
        e4.bind(s, "e4")

        // boden
        s.setUniform("mv", Matrix4f(v).mul(g.getWorldModelMatrix()), false)
        s.setUniform("ec", Vector3f(0f, 1f, 0f))
        for (x in g.meshes) x.render(s)

        // motorrad
        s.setUniform("mv", Matrix4f(v).mul(m.getWorldModelMatrix()), false)
        s.setUniform("ec", f)
        for (x in m.meshes) x.render(s)
    }

    fun update(dt: Float, t: Float) {
        if (window.getKeyState(GLFW_KEY_W)) {
            m.translateLocal(Vector3f(0f, 0f, -7f * dt))
            if (window.getKeyState(GLFW_KEY_A)) m.rotateLocal(0f, 1.4f * dt, 0f)
            if (window.getKeyState(GLFW_KEY_D)) m.rotateLocal(0f, -1.4f * dt, 0f)
        }
        if (window.getKeyState(GLFW_KEY_S)) {
            m.translateLocal(Vector3f(0f, 0f, 3f * dt))
            if (window.getKeyState(GLFW_KEY_A)) m.rotateLocal(0f, -1.4f * dt, 0f)
            if (window.getKeyState(GLFW_KEY_D)) m.rotateLocal(0f, 1.4f * dt, 0f)
        }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        // beim ersten mal gibt es noch kein altes x
        if (mn > 0) {
            val n = (mx - xpos).toFloat() * 0.002f
            //cam.rotateLocal(0f, n, 0f)
            cam.rotateAroundPoint(0f, n, 0f, Vector3f(0f, 0f, 0f))
        }
        mx = xpos
        mn++
    }

    fun cleanup() {
        for (x in g.meshes) x.cleanup()
        for (x in m.meshes) x.cleanup()
        s.cleanup()
    }
}
